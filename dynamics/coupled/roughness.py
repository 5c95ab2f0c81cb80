"""Roughness of table and edge: profiles of height against path length, read through the ellipse of the contact.

A profile is periodic and known at any path length without storing a path: the table's over at least 2^20 cells, the
edge's over its circumference.
"""

from dataclasses import dataclass
from math import inf, pi
from typing import Annotated

import numpy as np
from annotated_types import Ge, Gt, Lt
from scipy.fft import next_fast_len
from scipy.integrate import trapezoid

from .profile import MOST_CELLS, Profile, spline_profile

CELLS = 8
"""Cells per shortest wavelength: where a is a cell or more, every wave is then read to 3e-4 of itself."""
TABLE_CELLS = 2**20
WAVES = 64
"""The table's period holds at least so many of the longest waves."""
MOST_EXPONENT = 16.0


@dataclass(frozen=True, kw_only=True)
class Roughness:
    """Gaussian heights with a power spectrum k^-exponent between two wavelengths, of table and edge each.

    rms [m] of the heights before the contact averages them; shortest and longest wavelength [m].
    """

    rms: Annotated[float, Gt(0)]
    shortest: Annotated[float, Gt(0)] = 1e-4
    longest: Annotated[float, Gt(0), Lt(inf)] = 0.1
    exponent: Annotated[float, Ge(0)] = 0.0
    seed: Annotated[int, Ge(0)] = 0

    def __post_init__(self):
        for name in ("rms", "shortest"):
            if not 0 < getattr(self, name) < inf:
                raise ValueError(f"roughness.{name} = {getattr(self, name):g}: must be positive and finite")
        if not self.shortest < self.longest < inf:
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must exceed shortest = {self.shortest:g} and be finite"
            )
        if not 0 <= self.exponent <= MOST_EXPONENT:
            raise ValueError(f"roughness.exponent = {self.exponent:g}: must lie in 0 to {MOST_EXPONENT:g}")
        if CELLS * WAVES * self.longest > MOST_CELLS * self.shortest:
            most = MOST_CELLS / (CELLS * WAVES)
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must be at most {most:g} times shortest = {self.shortest:g}"
            )


def table_profile(roughness: Roughness) -> Profile:
    """Return the heights of the table along the path of the contact."""
    cell = roughness.shortest / CELLS
    n = max(TABLE_CELLS, 2 ** int(np.ceil(np.log2(WAVES * roughness.longest / cell))))
    return _gaussian(roughness, n * cell, n, 0)


def edge_profile(roughness: Roughness, radius: float) -> Profile:
    """Return the heights of the edge of a disk of that radius [m] along its circumference.

    Raises ValueError where no wave of the spectrum fits.
    """
    period = 2 * pi * radius
    return _gaussian(roughness, period, next_fast_len(int(np.ceil(CELLS * period / roughness.shortest)), real=True), 1)


def spectrum(roughness: Roughness, period: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the wave numbers (w,) [rad/m] that fit a period [m] and the mean square (w,) [m^2] of each wave.

    Raises ValueError where none fits.
    """
    first, last = np.ceil(period / roughness.longest * (1 - 1e-12)), np.floor(period / roughness.shortest * (1 + 1e-12))
    if last < max(first, 1):
        raise ValueError(
            f"roughness.shortest = {roughness.shortest:g}: no wave between it and longest fits {period:g} m"
        )
    order = np.arange(max(first, 1), last + 1)
    power = (order / order[0]) ** -roughness.exponent
    return 2 * pi * order / period, roughness.rms**2 * power / power.sum()


def window(ka):
    """Return what the ellipse of half-length a leaves of waves k: 3 (sin ka - ka cos ka)/(ka)^3."""
    ka = np.asarray(ka, dtype=float)
    small = ka < 1e-2
    x = np.where(small, 1.0, ka)
    return np.where(small, 1 - ka * ka / 10, 3 * (np.sin(x) - x * np.cos(x)) / x**3)


def require_seen(roughness: Roughness, half_length: float) -> None:
    """Raise ValueError where every wave is shorter than the ellipse of half-length a [m] and so averaged away."""
    if roughness.longest <= 2 * half_length:
        raise ValueError(
            f"roughness.longest = {roughness.longest:g}: must exceed the contact, {2 * half_length:.3g} m long"
        )


def density(roughness: Roughness, waves: int = 8192) -> tuple[np.ndarray, np.ndarray]:
    """Return wave numbers (w,) [rad/m], evenly spaced in their logarithm, and the mean square per wave number [m^3]."""
    k = np.geomspace(2 * pi / roughness.longest, 2 * pi / roughness.shortest, waves)
    power = k**-roughness.exponent
    return k, power * roughness.rms**2 / trapezoid(power, k)


def shift_of_contact(roughness: Roughness, inclination, half_length, radius: float):
    """Return rms(z'') R/beta (n,): how far, in radians per radian, the true contact runs along the edge.

    Table and edge, each averaged over the ellipse of half-length a (n,) [m] at inclinations (n,). Where it exceeds 1
    the disk touches at several places at once, and one ellipse is no more than an approximation.
    """
    k, power = density(roughness)
    curvature = [2 * trapezoid(power * k**4 * window(k * a) ** 2, k) for a in np.atleast_1d(half_length)]
    return np.sqrt(curvature) * radius / np.sin(inclination)


def _gaussian(roughness, period, n, which):
    k, power = spectrum(roughness, period)
    order = np.rint(k * period / (2 * pi)).astype(int)
    waves = np.zeros(n // 2 + 1, complex)
    draw = np.random.default_rng([roughness.seed, which]).normal(size=(len(k), 2))
    waves[order] = n / 2 * np.sqrt(power) * (draw[:, 0] - 1j * draw[:, 1])
    return spline_profile(waves, period, n)
