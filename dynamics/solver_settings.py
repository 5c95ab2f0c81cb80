"""Accuracy of the solution: the section `numerics` of a scene, and the settings of each accuracy.

`modal/accuracy.py` holds the meshes and tolerances of the modes under the same names.
"""

from dataclasses import dataclass
from importlib.util import find_spec
from math import inf, pi
from typing import Annotated, Literal, NamedTuple

from annotated_types import Ge, Gt, Le

from dynamics.disk import Disk
from dynamics.steady_motion import flat_square

MAX_AUDIBLE_FREQUENCY = 20e3
"""Upper limit of hearing [Hz]."""
MIN_SOLVED_INCLINATION = 1e-10
"""No motion is solved below this inclination [rad]."""


class AccuracyLevel(NamedTuple):
    """Settings of one of the accuracies draft, standard and reference.

    Parameters
    ----------
    taylor_tolerance, dop853_tolerance : float
        Relative tolerances of the two integrators.
    final_rate_factor : float
        The motion ends where the precession frequency is this many times MAX_AUDIBLE_FREQUENCY.
    max_contact_turn : float
        Largest turn of the contact [rad] between two evaluations of a smooth force; 0 evaluates
        the force at every sample.
    range_db : float
        Modes this far below the loudest one are left out of the sound [dB].
    held_error_share, free_error_share : float
        True error of the modes of a held and a free disk over its estimate.
    contact_rate : float
        Time steps per second of an elastic contact [1/s].
    """

    taylor_tolerance: float
    dop853_tolerance: float
    final_rate_factor: float
    max_contact_turn: float
    range_db: float
    held_error_share: float
    free_error_share: float
    contact_rate: float


ACCURACY_LEVELS = {
    "draft": AccuracyLevel(1e-16, 1e-12, 1.0, 0.8, 40.0, 0.35, 0.35, 1e5),
    "standard": AccuracyLevel(1e-16, 1e-15, 10.0, 0.2, 60.0, 0.35, 0.55, 4e5),
    "reference": AccuracyLevel(1e-16, 1e-15, inf, 0.0, inf, 0.0, 0.0, 1.6e6),
}
"""Settings by accuracy. The error shares are measured (tests/plan/test_plan.py); those of the reference
are unknown, as nothing more accurate exists."""


@dataclass(frozen=True, kw_only=True)
class Numerics:
    """Accuracy of the solution: the section `numerics` of a scene.

    Keys that are not given follow from `accuracy`.

    Examples
    --------
    >>> from dynamics import Numerics
    >>> Numerics(accuracy="draft", integrator="dop853").chosen_tolerance
    1e-12
    """

    accuracy: Literal["draft", "standard", "reference"] = "standard"
    """Accuracy: draft to listen, standard for numbers, reference for the phase of the ringing."""
    integrator: Literal["auto", "taylor", "dop853"] = "auto"
    """Integrator: Taylor series (heyoka) or DOP853 (numba); auto prefers heyoka if installed."""
    tolerance: Annotated[float, Gt(0), Le(1e-9)] | None = None
    """Relative tolerance of the integrator."""
    final_inclination: Annotated[float, Gt(0), Le(0.1)] | None = None
    """Inclination at which the motion counts as settled [rad]."""
    contact: Literal["auto", "filter", "full", "many"] = "auto"
    """Elastic contact: a linear filter along the rigid motion, one contact solved in full, or many
    contacts anywhere on the rim of a disk that rattles; auto chooses one of the first two."""
    contact_rate: Annotated[float, Ge(1e3), Le(1e8)] | None = None
    """Time steps per second of an elastic contact that is solved in full [1/s]."""
    time_limit: Annotated[float, Gt(0), Le(1e6)] = 600.0
    """Time at which a motion ends that has not settled [s]."""

    @property
    def level(self) -> AccuracyLevel:
        """The settings of the accuracy."""
        return ACCURACY_LEVELS[self.accuracy]

    @property
    def chosen_tolerance(self) -> float:
        """Relative tolerance of the integrator."""
        if self.tolerance:
            return self.tolerance
        if integrator_of(self.integrator) == "taylor":
            return self.level.taylor_tolerance
        return self.level.dop853_tolerance

    def stopping_inclination(self, disk: Disk) -> float:
        """Return the inclination [rad] at which the motion of a disk counts as settled."""
        if self.final_inclination:
            return self.final_inclination
        return inclination_at(disk, MAX_AUDIBLE_FREQUENCY * self.level.final_rate_factor)


def integrator_of(name: str) -> str:
    """Return 'taylor' or 'dop853'; 'auto' is 'taylor' where heyoka is installed.

    Raises ValueError if `name` is 'taylor' and heyoka is missing.
    """
    installed = find_spec("heyoka")
    if name == "auto":
        return "taylor" if installed else "dop853"
    if name == "taylor" and not installed:
        missing = "needs heyoka, which is not installed: use 'dop853'"
        raise ValueError(f"numerics.integrator = 'taylor' {missing}")
    return name


def inclination_at(disk: Disk, rate: float) -> float:
    """Return the inclination [rad] at which a steady disk precesses at `rate` [Hz].

    It is the limit of small inclinations (`steady_motion.flat_square`) and at least
    MIN_SOLVED_INCLINATION.
    """
    square = flat_square(disk.aspect, disk.gyration) / disk.time_unit**2
    return max(square / (2 * pi * rate) ** 2, MIN_SOLVED_INCLINATION)
