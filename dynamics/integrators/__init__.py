"""Integrators of the event-driven rigid motion."""
