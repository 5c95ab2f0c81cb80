"""Integrators for the event-driven motion of a rigid disk."""
