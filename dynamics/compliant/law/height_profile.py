"""Height profiles along a path, averaged over the contact ellipse.

The contact pressure weights the heights by 1 - x^2/a^2 along the path. Integration by
parts expresses this mean by differences of the second and third integrals of the
heights. A periodic quintic spline of the third integral provides both for every
half-length a.
"""

from math import pi
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.fft import irfft, rfft

from dynamics.compliant.law.profile_files import profile_columns
from dynamics.compliant.law.sections import MAX_PROFILE_CELLS
from dynamics.numba_kernels import kernel, outermost


class Profile(NamedTuple):
    """Periodic quintic spline of the third integral of the heights along a path.

    It consists of the coefficients (n + 5,) and the number of cells per metre.
    """

    coefficients: np.ndarray
    cells_per_metre: float

    @property
    def period(self) -> float:
        """Period of the profile [m]."""
        return (len(self.coefficients) - 5) / self.cells_per_metre


SMOOTH_PROFILE = Profile(np.zeros(6), 1.0)
"""Profile of a smooth surface."""


def spline_profile(waves: np.ndarray, period: float, n: int | None = None) -> Profile:
    """Return the zero-mean profile with the Fourier transform `waves` (n/2 + 1,) of its heights."""
    n = n or 2 * (len(waves) - 1)
    order = np.arange(len(waves))
    angle = 2 * pi * order / n
    k = 2 * pi * np.maximum(order, 1) / period
    knot = (
        66 + 52 * np.cos(angle) + 2 * np.cos(2 * angle)
    ) / 120  # value of a unit spline at the knots
    third = np.where(order == 0, 0.0, waves / (1j * k) ** 3) / knot
    coefficients = irfft(third, n, workers=1)
    return Profile(
        np.concatenate([coefficients[-2:], coefficients, coefficients[:3]]), n / period
    )


@kernel
def height_integrals(profile: Profile, s: float) -> tuple[float, float]:
    """Return the third and the second integrals of the heights at path length s [m]."""
    c = profile.coefficients
    x = s * profile.cells_per_metre
    whole = np.floor(x)
    u = x - whole
    i = int(whole) % (c.size - 5)
    c0 = c[i]
    c1 = c[i + 1]
    c2 = c[i + 2]
    c3 = c[i + 3]
    c4 = c[i + 4]
    c5 = c[i + 5]
    p0 = c0 + 26 * c1 + 66 * c2 + 26 * c3 + c4
    p1 = 5 * (-c0 - 10 * c1 + 10 * c3 + c4)
    p2 = 10 * (c0 + 2 * c1 - 6 * c2 + 2 * c3 + c4)
    p3 = 10 * (-c0 + 2 * c1 - 2 * c3 + c4)
    p4 = 5 * (c0 - 4 * c1 + 6 * c2 - 4 * c3 + c4)
    p5 = -c0 + 5 * c1 - 10 * c2 + 10 * c3 - 5 * c4 + c5
    third = p0 + u * (p1 + u * (p2 + u * (p3 + u * (p4 + u * p5))))
    second = p1 + u * (2 * p2 + u * (3 * p3 + u * (4 * p4 + u * 5 * p5)))
    return third / 120, second * profile.cells_per_metre / 120


@kernel
def mean_height(profile: Profile, s: float, a: float) -> float:
    """Return the mean height [m] over an ellipse of half-length a [m] at path s [m].

    The weight is 3 (1 - x^2/a^2)/4a over (s - a, s + a). The result for SMOOTH_PROFILE,
    which has one cell, is 0.
    """
    if profile.coefficients.size == 6:
        return 0.0
    third1, second1 = height_integrals(profile, s + a)
    third0, second0 = height_integrals(profile, s - a)
    return 1.5 * (second1 + second0 - (third1 - third0) / a) / (a * a)


@kernel
def mean_rim_height(
    rough: tuple[Profile, Profile, float, float, float],
    reach: float,
    radius: float,
    turn: float,
) -> float:
    """Return the sum [m] of the mean heights of table and edge at the contact.

    `rough` contains the profiles of table and edge, the path lengths [m] on both, and the
    half-length of the ellipse [m]. Since these path lengths the contact has turned by
    `turn` [rad], at the distances `reach` and `radius` [m] from the centre.
    """
    table, rim, path, edge, half = rough
    return mean_height(table, path + reach * turn, half) + mean_height(
        rim, edge + radius * turn, half
    )


@outermost
def mean_heights(profile: Profile, s: np.ndarray, a: np.ndarray) -> np.ndarray:
    """Return the `mean_height` (k,) [m] at paths s (k,) and half-lengths a (k,) [m]."""
    out = np.empty(s.size)
    for i in range(s.size):
        out[i] = mean_height(profile, s[i], a[i])
    return out


def height_at(profile: Profile, s: float, a: float) -> float:
    """Return the `mean_height` [m], from machine code that is cached."""
    return float(mean_heights(profile, np.array([s]), np.array([a]))[0])


def profile_from_csv(file: str | Path, period: float | None = None) -> Profile:
    """Read a profile from a CSV file with lengths [m] and heights [m].

    A header is skipped. The best straight line is subtracted, and the profile is made
    periodic by appending its mirror image. For an edge, `period` is its circumference
    [m], and the profile is stretched so that a whole number of profiles fits. Raises
    ValueError if the file is not a valid profile.
    """
    length, height = profile_columns(Path(file))
    height = height - np.polynomial.Polynomial.fit(length, height, 1)(length)
    span = length[-1] - length[0]
    n = max(8, int(np.ceil(span / np.diff(length).min() * (1 - 1e-9))))
    if n > MAX_PROFILE_CELLS // 2:
        raise ValueError(
            f"{file}: the smallest spacing is {np.diff(length).min():.3g} m; the profile must "
            f"not exceed {MAX_PROFILE_CELLS // 2} times this length"
        )
    even = np.interp(np.linspace(length[0], length[-1], n + 1), length, height)
    double = 2 * span if period is None else period / max(1, round(period / (2 * span)))
    return spline_profile(rfft(np.append(even, even[-2:0:-1])), double)
