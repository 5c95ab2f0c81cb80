"""Progress of a solution: the solved share of the duration of a motion."""

from math import inf

from dynamics.equations import disk_constants
from dynamics.film.activation import non_contact_loads
from dynamics.quasi_steady import decline_time
from dynamics.sections import MotionScene


class MotionProgress:
    """Solved share of the duration of a motion; it never decreases and remains below 1.

    The remaining time is predicted from the current inclination by `decline_time`, as if the motion
    were steady. The true end differs by the transient after the release and by nutation, so early
    shares are too low. A time limit ends every motion.
    """

    def __init__(self, scene: MotionScene):
        self._disk = scene.disk
        self._law = disk_constants(scene.disk, scene.friction)
        self._loads = non_contact_loads(scene)
        self._time_limit = scene.numerics.time_limit
        self._share = 0.0

    def share(self, t: float, inclination: float) -> float:
        """Return the solved share at time t [s] and an inclination [rad]."""
        end = min(t + self._time_left(inclination), self._time_limit)
        last_shown = 0.999
        if end > 0:
            self._share = max(self._share, min(t / end, last_shown))
        return self._share

    def _time_left(self, inclination):
        if inclination <= 0:
            return 0.0
        try:
            return decline_time(inclination, self._disk, self._law, self._loads)
        except ValueError:  # so steep a disk has no steady motion, and no predicted end
            return inf
