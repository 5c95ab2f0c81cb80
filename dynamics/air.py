"""The section `air` of a scene: properties of the air and of the film under the disk."""

from dataclasses import dataclass
from math import exp, log, pi, sqrt
from typing import TYPE_CHECKING, Annotated, Literal

from annotated_types import Ge, Gt, Le

if TYPE_CHECKING:
    import numpy as np

STANDARD_PRESSURE = 101325.0
"""Standard pressure [Pa]."""
STANDARD_TEMPERATURE = 293.15
"""Standard temperature [K]."""
HEAT_CAPACITY_RATIO = 1.4
"""Ratio of the specific heats of air."""
PRANDTL_NUMBER = 0.71
"""Prandtl number of air: ratio of kinematic viscosity to thermal diffusivity."""


@dataclass(frozen=True, kw_only=True)
class Air:
    """The air that transmits the sound, and the air film under the disk.

    Raises
    ------
    ValueError
        If a film is required in a vacuum.

    Examples
    --------
    >>> from dynamics import Air
    >>> f"{Air(temperature=273.15).sound_speed:.1f} m/s"
    '331.3 m/s'
    """

    film: Literal["auto", "none", "acts"] = "auto"
    """Air film under the disk: none, acts (included), or auto (included if it is
    predicted to dissipate at least 1 % of the power)."""
    viscosity: Annotated[float, Gt(0), Le(1e3)] = 1.82e-5
    """Viscosity [Pa s]."""
    density: Annotated[float, Ge(0), Le(1e3)] = None  # type: ignore[assignment]
    """Density [kg/m^3]; by default that of dry air at this pressure and temperature."""
    pressure: Annotated[float, Ge(0), Le(1e9)] = STANDARD_PRESSURE
    """Static pressure [Pa]."""
    temperature: Annotated[float, Ge(50), Le(3000)] = STANDARD_TEMPERATURE
    """Temperature [K]; it determines the speed of sound."""

    def __post_init__(self) -> None:
        if self.film == "acts" and not self.pressure:
            raise ValueError("film = 'acts': requires air, but pressure = 0 (vacuum)")
        if self.density is None:
            object.__setattr__(
                self, "density", dry_air_density(self.pressure, self.temperature)
            )

    @property
    def sound_speed(self) -> float:
        """Speed of sound [m/s]."""
        standard_sound_speed = 343.2  # m/s, in dry air at the standard temperature
        return standard_sound_speed * sqrt(self.temperature / STANDARD_TEMPERATURE)

    @property
    def mean_free_path(self) -> float:
        """Mean free path of the air molecules [m], mu/p sqrt(pi R T/2).

        In a film thinner than this length, the air does not behave as a continuum.
        """
        gas_constant = 287.05  # J/(kg K), of dry air
        return (
            self.viscosity
            / self.pressure
            * sqrt(pi * gas_constant * self.temperature / 2)
        )

    def absorption(
        self, frequency: "float | np.ndarray", humidity: float = 0.5
    ) -> "float | np.ndarray":
        """Return the absorption of sound by the air.

        The accuracy is 10 % for temperatures from -20 to 50 degrees Celsius and
        pressures from 0.05 to 2 atmospheres.

        Parameters
        ----------
        frequency : float or ndarray
            Frequency of the sound [Hz].
        humidity : float
            Relative humidity, 0 to 1.

        Returns
        -------
        float or ndarray
            Absorption [dB/m].

        References
        ----------
        .. [1] ISO 9613-1:1993, equations (3) to (5).
        """
        p = self.pressure / STANDARD_PRESSURE
        t = self.temperature / STANDARD_TEMPERATURE
        vapour = (
            100
            * humidity
            / p
            * 10 ** (4.6151 - 6.8346 * (273.16 / self.temperature) ** 1.261)
        )
        oxygen = p * (24 + 4.04e4 * vapour * (0.02 + vapour) / (0.391 + vapour))
        nitrogen = p / sqrt(t) * (9 + 280 * vapour * exp(-4.17 * (t ** (-1 / 3) - 1)))
        relaxing = (
            0.01275 * exp(-2239.1 / self.temperature) / (oxygen + frequency**2 / oxygen)
        )
        relaxing += (
            0.1068
            * exp(-3352.0 / self.temperature)
            / (nitrogen + frequency**2 / nitrogen)
        )
        return (
            20 / log(10) * frequency**2 * (1.84e-11 / p * sqrt(t) + t**-2.5 * relaxing)
        )


def dry_air_density(pressure: float, temperature: float) -> float:
    """Return the density [kg/m^3] of dry air at pressure [Pa] and temperature [K]."""
    standard_density = 1.204  # kg/m^3, at the standard pressure and temperature
    return (
        standard_density
        * (pressure / STANDARD_PRESSURE)
        * (STANDARD_TEMPERATURE / temperature)
    )


STANDARD_AIR = Air()
"""Air at 20 degrees Celsius and 101325 Pa."""
