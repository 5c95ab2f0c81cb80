"""A disk without its rolling contact lands, tumbles, and comes to rest or rolls again."""

MAX_BOUNCE_ENERGY_ERROR = 2e-5
"""Largest relative error of the energy balance of a disk that bounces many times."""
