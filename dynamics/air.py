"""The air: one section of a scene for what slows the disk and for what carries its sound."""

from dataclasses import dataclass
from math import pi, sqrt
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le

PRESSURE, TEMPERATURE = 101325.0, 293.15
"""Of the standard air [Pa, K]."""
DENSITY, SOUND_SPEED, GAS_CONSTANT = 1.204, 343.2, 287.05
"""Of dry air, the first two under these [kg/m^3, m/s, J/(kg K)]."""


@dataclass(frozen=True, kw_only=True)
class Air:
    """The air around the disk, which carries its sound, and between disk and table, which slows and lifts it."""

    film: Literal["auto", "none", "acts"] = "auto"
    """Whether the film under the disk acts on its motion and sound; auto: where it ever takes 1 % of the power."""
    viscosity: Annotated[float, Gt(0), Le(1e3)] = 1.82e-5
    """Viscosity [Pa s]."""
    density: Annotated[float, Ge(0), Le(1e3)] = None  # type: ignore[assignment]
    """Density [kg/m^3]; that of dry air of this pressure and temperature unless given."""
    pressure: Annotated[float, Ge(0), Le(1e9)] = PRESSURE
    """Pressure at rest [Pa]."""
    temperature: Annotated[float, Ge(50), Le(3000)] = TEMPERATURE
    """Temperature [K], which the speed of sound follows."""

    def __post_init__(self):
        if self.film == "acts" and not self.pressure:
            raise ValueError("film = 'acts': a vacuum, pressure = 0, has no film")
        if self.density is None:
            object.__setattr__(self, "density", dry(self.pressure, self.temperature))

    @property
    def sound_speed(self) -> float:
        """Speed of sound [m/s]."""
        return SOUND_SPEED * sqrt(self.temperature / TEMPERATURE)

    @property
    def mean_free_path(self) -> float:
        """How far a molecule flies [m]: mu/p sqrt(pi R T/2). A gap below that is not filled by a continuum."""
        return self.viscosity / self.pressure * sqrt(pi * GAS_CONSTANT * self.temperature / 2)


def dry(pressure: float, temperature: float) -> float:
    """Return the density [kg/m^3] of dry air, an ideal gas."""
    return DENSITY * (pressure / PRESSURE) * (TEMPERATURE / temperature)


STANDARD = Air()
"""Dry air at 20 degrees and 101325 Pa."""
