"""The section `numerics` of a scene, and the settings of its accuracy levels.

The meshes and tolerances of the modes at the same levels are in `modal/accuracy.py`.
"""

from dataclasses import dataclass
from importlib.util import find_spec
from math import inf, pi
from typing import Annotated, Literal, NamedTuple

from annotated_types import Ge, Gt, Le

from dynamics.disk import Disk
from dynamics.steady_motion import squared_rate_times_inclination

MAX_AUDIBLE_FREQUENCY = 20e3
"""Upper limit of hearing [Hz]."""
MIN_SOLVED_INCLINATION = 1e-10
"""Smallest inclination at which a motion is solved [rad]."""
MIN_RELEVANT_SHARE = 0.01
"""Fraction of the dissipated power from which the motion includes an air film or a table.

The motion also includes a table whose modes store this fraction of the energy of the
disk.
"""


INTEGRATOR_TOLERANCES = {"taylor": 1e-16, "dop853": 1e-15}
"""Relative tolerance of each integrator, at every level of accuracy: with larger ones,
the direction of friction at the end of a slide is wrong."""


class MotionAccuracyLevel(NamedTuple):
    """Settings of one of the accuracy levels draft, standard and reference.

    Parameters
    ----------
    final_rate_factor : float
        The motion ends where the precession frequency reaches this multiple of
        MAX_AUDIBLE_FREQUENCY.
    max_contact_turn : float
        Largest rotation of the contact [rad] between two evaluations of a smooth force;
        if 0, the force is evaluated at every sample.
    range_db : float
        Range of levels [dB] below the loudest mode; quieter modes are omitted from the
        sound.
    held_error_share, free_error_share, sprung_error_share : float
        True error of the modes divided by its estimate, for a disk held on a patch, a
        free disk and a disk on its elastic contact.
    contact_rate : float
        Rate of the time steps of an elastic contact [1/s].
    """

    final_rate_factor: float
    max_contact_turn: float
    range_db: float
    held_error_share: float
    free_error_share: float
    sprung_error_share: float
    contact_rate: float


ACCURACY_LEVELS = {
    "draft": MotionAccuracyLevel(
        final_rate_factor=1.0,
        max_contact_turn=0.8,
        range_db=40.0,
        held_error_share=0.35,
        free_error_share=0.35,
        sprung_error_share=0.065,
        contact_rate=1e5,
    ),
    "standard": MotionAccuracyLevel(
        final_rate_factor=10.0,
        max_contact_turn=0.2,
        range_db=60.0,
        held_error_share=0.35,
        free_error_share=0.55,
        sprung_error_share=0.75,
        contact_rate=4e5,
    ),
    "reference": MotionAccuracyLevel(
        final_rate_factor=inf,
        max_contact_turn=0.0,
        range_db=inf,
        held_error_share=0.0,
        free_error_share=0.0,
        sprung_error_share=0.0,
        contact_rate=1.6e6,
    ),
}
"""Settings of each accuracy level. The error shares are measured
(tests/plan/test_plan.py), except those of the reference, for which no more accurate
solution exists."""


@dataclass(frozen=True, kw_only=True)
class Numerics:
    """Accuracy of the solution: the section `numerics` of a scene.

    The value of `accuracy` determines the keys that are not given.

    Examples
    --------
    >>> from dynamics import Numerics
    >>> Numerics(accuracy="draft", integrator="dop853").chosen_tolerance
    1e-15
    """

    accuracy: Literal["draft", "standard", "reference"] = "standard"
    """Accuracy: draft for listening, standard for numbers, reference for the phase of
    the ringing."""
    integrator: Literal["auto", "taylor", "dop853"] = "auto"
    """Integrator: Taylor series (heyoka) or DOP853 (numba); auto selects heyoka if it
    is installed."""
    tolerance: Annotated[float, Gt(0), Le(1e-9)] | None = None
    """Relative tolerance of the integrator."""
    final_inclination: Annotated[float, Gt(0), Le(0.1)] | None = None
    """Inclination at which the motion counts as settled [rad]."""
    contact: Literal["auto", "filter", "full", "many"] = "auto"
    """Model of an elastic contact: a linear filter applied to the rigid motion, one
    contact solved in full, or many contacts along the rim of a rattling disk; auto
    selects one of the three, by the unevenness of table and edge."""
    contact_rate: Annotated[float, Ge(1e3), Le(1e8)] | None = None
    """Rate of the time steps of an elastic contact that is solved in full [1/s]. If it is
    not given, it follows from the accuracy and the stiffness of the contact, and is
    doubled while a step cannot be solved."""
    time_limit: Annotated[float, Gt(0), Le(1e6)] = 600.0
    """Time [s] at which the solution ends if the disk has not settled."""

    @property
    def level(self) -> MotionAccuracyLevel:
        """The settings of the accuracy level."""
        return ACCURACY_LEVELS[self.accuracy]

    @property
    def chosen_tolerance(self) -> float:
        """Relative tolerance of the integrator."""
        if self.tolerance:
            return self.tolerance
        return INTEGRATOR_TOLERANCES[resolved_integrator_name(self.integrator)]

    def stopping_inclination(self, disk: Disk) -> float:
        """Return the inclination at which the motion of a disk counts as settled.

        Parameters
        ----------
        disk : Disk
            The disk.

        Returns
        -------
        float
            Inclination [rad].
        """
        if self.final_inclination:
            return self.final_inclination
        return inclination_at_rate(
            disk, MAX_AUDIBLE_FREQUENCY * self.level.final_rate_factor
        )


def resolved_integrator_name(name: str) -> str:
    """Return 'taylor' or 'dop853'; 'auto' selects 'taylor' if heyoka is installed.

    Raises ValueError if `name` is 'taylor' and heyoka is missing.
    """
    installed = find_spec("heyoka")
    if name == "auto":
        return "taylor" if installed else "dop853"
    if name == "taylor" and not installed:
        missing = "requires heyoka, which is not installed (extra fast): use 'dop853'"
        raise ValueError(f"numerics.integrator = 'taylor' {missing}")
    return name


def inclination_at_rate(disk: Disk, rate: float) -> float:
    """Return the inclination [rad] at which a steady disk precesses at `rate` [Hz].

    The formula is the limit for small inclinations; the result is at least
    MIN_SOLVED_INCLINATION.
    """
    square = (
        squared_rate_times_inclination(disk.aspect, disk.gyration) / disk.time_unit**2
    )
    return max(square / (2 * pi * rate) ** 2, MIN_SOLVED_INCLINATION)
