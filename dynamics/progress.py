"""Estimate the fraction of a motion that has been solved."""

from math import inf

from dynamics.film.activation import non_contact_loads
from dynamics.quasi_steady import time_to_flat
from dynamics.scene_constants import scene_constants
from dynamics.sections import MotionScene


class MotionProgress:
    """Solved fraction of a motion; it never decreases and remains below 1.

    The remaining time is predicted from the current inclination as for quasi-steady
    motion; it ends at the time limit at the latest. The transient after the release and
    the nutation are neglected, so early fractions are too low.
    """

    def __init__(self, scene: MotionScene) -> None:
        self._disk = scene.disk
        self._law = scene_constants(scene)
        self._loads = non_contact_loads(scene)
        self._time_limit = scene.numerics.time_limit
        self._share = 0.0

    def solved_fraction(self, t: float, inclination: float) -> float:
        """Return the solved fraction at time t [s] and inclination [rad]."""
        end = min(t + self._time_left(inclination), self._time_limit)
        last_shown = 0.999
        if end > 0:
            self._share = max(self._share, min(t / end, last_shown))
        return self._share

    def _time_left(self, inclination: float) -> float:
        if inclination <= 0:
            return 0.0
        try:
            return time_to_flat(inclination, self._disk, self._law, self._loads)
        except ValueError:  # the disk is too steep for a steady motion
            return inf
