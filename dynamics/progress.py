"""Estimate the fraction of a motion that has been solved."""

from math import inf, radians

from dynamics.motion_plan import MotionPlan
from dynamics.quasi_steady import time_to_flat


class MotionProgress:
    """Solved fraction of a motion; it never decreases and remains below 1.

    The remaining time is predicted from the current inclination as for quasi-steady
    motion; it ends at the time limit at the latest. The transient after the release and
    the nutation are neglected, so early fractions are too low. The impacts of a rattling
    disk reduce its inclination at a constant rate, which is that since the release.
    """

    def __init__(self, plan: MotionPlan) -> None:
        scene = plan.scene
        self._disk = scene.disk
        self._law = plan.constants
        self._loads = plan.loads
        self._time_limit = scene.numerics.time_limit
        self._rattles = plan.contact.kind == "many"
        self._released = radians(scene.release.inclination_deg)
        self._share = 0.0

    def solved_fraction(self, t: float, inclination: float) -> float:
        """Return the solved fraction at time t [s] and inclination [rad]."""
        end = min(t + self._time_left(t, inclination), self._time_limit)
        max_shown_fraction = 0.999
        if end > 0:
            self._share = max(self._share, min(t / end, max_shown_fraction))
        return self._share

    def _time_left(self, t: float, inclination: float) -> float:
        if inclination <= 0:
            return 0.0
        if self._rattles:
            decrease = self._released - inclination
            return t * inclination / decrease if decrease > 0 else inf
        try:
            return time_to_flat(inclination, self._disk, self._law, self._loads)
        except ValueError:  # the disk is too steep for a steady motion
            return inf
