"""Provide methods for comparison: textbook schemes and the event-driven model with
other integrators."""
