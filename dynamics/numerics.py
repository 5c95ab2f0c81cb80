"""How exactly to solve: the section of a scene, and the one table of what an accuracy means in numbers.

The meshes and tolerances of the modes stand under the same names in `modal/accuracy.py`.
"""

from dataclasses import dataclass
from importlib.util import find_spec
from math import inf, pi
from typing import Annotated, Literal, NamedTuple

from annotated_types import Ge, Gt, Le

from .disk import Disk
from .steady import flat_square

HIGHEST_HEARD = 20e3
"""The highest rate that is heard [Hz]."""
LAST_INCLINATION = 1e-10
"""Nothing is solved below this [rad]."""


class Level(NamedTuple):
    """What one of draft, standard, reference buys.

    taylor, dop853 -- relative tolerances of the two integrators.
    beyond         -- the motion stops where the contact turns at so many times the highest rate that is heard.
    calm           -- by how much [rad] the contact turns at most between two readings of a calm force; 0: every sample.
    range_db       -- modes further below the loudest do not sound.
    patch, free    -- how much of the estimated errors of the modes of a held, a free disk is true.
    contact_rate   -- steps a second of an elastic contact.
    """

    taylor: float
    dop853: float
    beyond: float
    calm: float
    range_db: float
    patch: float
    free: float
    contact_rate: float


LEVELS = {
    "draft": Level(1e-16, 1e-12, 1.0, 0.8, 40.0, 0.35, 0.35, 1e5),
    "standard": Level(1e-16, 1e-15, 10.0, 0.2, 60.0, 0.35, 0.55, 4e5),
    "reference": Level(1e-16, 1e-15, inf, 0.0, inf, 0.0, 0.0, 1.6e6),
}
"""By name; what the reference lacks is not known from within. The shares are measured, tests/test_plan.py."""


@dataclass(frozen=True, kw_only=True)
class Numerics:
    """How exactly to solve; what is not given follows from the accuracy."""

    accuracy: Literal["draft", "standard", "reference"] = "standard"
    """A draft to listen to, the standard for numbers, the reference for the phase of the ringing."""
    integrator: Literal["auto", "taylor", "dop853"] = "auto"
    """Taylor series by heyoka, or DOP853 by numba; auto takes the first where heyoka is installed."""
    tolerance: Annotated[float, Gt(0), Le(1e-9)] | None = None
    """Relative tolerance of the integrator."""
    final_inclination: Annotated[float, Gt(0), Le(0.1)] | None = None
    """Inclination at which the motion counts as settled [rad]."""
    contact: Literal["auto", "filter", "full"] = "auto"
    """An elastic contact is a filter along the rigid motion, or moves the disk in full; auto takes what it needs."""
    contact_rate: Annotated[float, Ge(1e3), Le(1e8)] | None = None
    """Steps a second of the full motion on an elastic contact [1/s]."""
    time_limit: Annotated[float, Gt(0), Le(1e6)] = 600.0
    """Time at which a motion that does not settle is ended [s]."""

    @property
    def level(self) -> Level:
        """What the accuracy buys."""
        return LEVELS[self.accuracy]

    @property
    def chosen_tolerance(self) -> float:
        """The relative tolerance of the integrator."""
        return self.tolerance or getattr(self.level, integrator_of(self.integrator))

    def stopping_inclination(self, disk: Disk) -> float:
        """Return the inclination [rad] at which the motion of a disk counts as settled."""
        return self.final_inclination or inclination_at(disk, HIGHEST_HEARD * self.level.beyond)


def integrator_of(name: str) -> str:
    """Return 'taylor' or 'dop853'; 'auto' takes heyoka's Taylor series where it is installed.

    Raises ValueError where 'taylor' is asked for and heyoka is missing.
    """
    installed = find_spec("heyoka")
    if name == "taylor" and not installed:
        raise ValueError("numerics.integrator = 'taylor' needs heyoka, which is not installed: use 'dop853'")
    return name if name != "auto" else "taylor" if installed else "dop853"


def inclination_at(disk: Disk, rate: float) -> float:
    """Return the inclination [rad] at which the contact of a steady disk turns `rate` times a second (steady.py,
    `flat_square`), but not below LAST_INCLINATION."""
    square = flat_square(disk.aspect, disk.gyration) / disk.time_unit**2
    return max(square / (2 * pi * rate) ** 2, LAST_INCLINATION)
