"""The air: one section of a scene for what slows the disk and for what carries its sound."""

from dataclasses import dataclass
from math import exp, log, pi, sqrt
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

    def absorption(self, frequency: float, humidity: float = 0.5) -> float:
        """Return how much of a sound of `frequency` [Hz] air of a relative humidity takes [dB/m], ISO 9613-1.

        Within 10 % from -20 to 50 degrees and 0.05 to 2 atmospheres.
        """
        p, t = self.pressure / PRESSURE, self.temperature / TEMPERATURE
        vapour = 100 * humidity / p * 10 ** (4.6151 - 6.8346 * (273.16 / self.temperature) ** 1.261)
        oxygen = p * (24 + 4.04e4 * vapour * (0.02 + vapour) / (0.391 + vapour))
        nitrogen = p / sqrt(t) * (9 + 280 * vapour * exp(-4.17 * (t ** (-1 / 3) - 1)))
        relaxing = 0.01275 * exp(-2239.1 / self.temperature) / (oxygen + frequency**2 / oxygen)
        relaxing += 0.1068 * exp(-3352.0 / self.temperature) / (nitrogen + frequency**2 / nitrogen)
        return 20 / log(10) * frequency**2 * (1.84e-11 / p * sqrt(t) + t**-2.5 * relaxing)


def dry(pressure: float, temperature: float) -> float:
    """Return the density [kg/m^3] of dry air, an ideal gas."""
    return DENSITY * (pressure / PRESSURE) * (TEMPERATURE / temperature)


STANDARD = Air()
"""Dry air at 20 degrees and 101325 Pa."""
