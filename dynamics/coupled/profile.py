"""Profiles of height against path length, read through the ellipse of the contact at any place, however far.

The pressure of the ellipse weighs heights by 1 - x^2/a^2 along the path. By parts, that mean is a difference of the
second and third integrals of the heights; a periodic quintic spline of the third gives it for every half-length a.
"""

from math import pi
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.fft import irfft, rfft

from .compiled import kernel, outermost
from .sections import MOST_CELLS


class Profile(NamedTuple):
    """Coefficients (n + 5,) of the quintic spline of the third integral of the heights, and cells per metre."""

    coefficients: np.ndarray
    cells_per_metre: float

    @property
    def period(self) -> float:
        """Path length [m] after which the profile repeats."""
        return (len(self.coefficients) - 5) / self.cells_per_metre


SMOOTH = Profile(np.zeros(6), 1.0)
FINE = 1 / 32
"""Slopes are differences of heights that are so much of the half-length of the ellipse apart: right to 1 %."""


def spline_profile(waves, period, n=None):
    """Return the profile with the Fourier transform `waves` (n/2 + 1,) of its heights; their mean is left out."""
    n = n or 2 * (len(waves) - 1)
    order = np.arange(len(waves))
    angle, k = 2 * pi * order / n, 2 * pi * np.maximum(order, 1) / period
    knot = (66 + 52 * np.cos(angle) + 2 * np.cos(2 * angle)) / 120  # a lone coefficient at the knots
    third = np.where(order == 0, 0.0, waves / (1j * k) ** 3) / knot
    coefficients = irfft(third, n, workers=1)
    return Profile(np.concatenate([coefficients[-2:], coefficients, coefficients[:3]]), n / period)


@kernel
def integrals(profile, s):
    """Return the third and the second integral of the heights at path length s [m]."""
    c, x = profile.coefficients, s * profile.cells_per_metre
    whole = np.floor(x)
    u = x - whole
    i = int(whole) % (c.size - 5)
    c0, c1, c2 = c[i], c[i + 1], c[i + 2]
    c3, c4, c5 = c[i + 3], c[i + 4], c[i + 5]
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
def height(profile, s, a):
    """Return the height [m] at path length s [m] under an ellipse of half-length a [m].

    The mean of z weighed by 3 (1 - x^2/a^2)/4a over (s - a, s + a), by parts. SMOOTH, of one cell, has none.
    """
    if profile.coefficients.size == 6:
        return 0.0
    third1, second1 = integrals(profile, s + a)
    third0, second0 = integrals(profile, s - a)
    return 1.5 * (second1 + second0 - (third1 - third0) / a) / (a * a)


@kernel
def rim_heights(table, rim, path, edge, half, reach, radius, turn, out):
    """Add to out (3,) how high table and edge are where the contact has turned by `turn` [rad] from the places `path`,
    `edge` [m] on them, and slope and bend of that by the angle."""
    if table.coefficients.size == 6 and rim.coefficients.size == 6:
        return
    fine = FINE * half / radius
    low, here, high = 0.0, 0.0, 0.0
    for profile, place, arm in ((table, path, reach), (rim, edge, radius)):
        start = place + arm * turn
        low += height(profile, start - arm * fine, half)
        here += height(profile, start, half)
        high += height(profile, start + arm * fine, half)
    out[0] += here
    out[1] += (high - low) / (2 * fine)
    out[2] += (high - 2 * here + low) / fine**2


@outermost
def heights(profile, s, a):
    """Return `height` at path lengths s (k,) under half-lengths a (k,) [m], as (k,) [m]."""
    out = np.empty(s.size)
    for i in range(s.size):
        out[i] = height(profile, s[i], a[i])
    return out


def profile_from_csv(file, period: float | None = None) -> Profile:
    """Read heights [m] (second column) against length [m] (first), as stylus instruments write; a header is skipped.

    The best straight line is taken off, and the profile continued by its mirror image, which makes it periodic. For an
    edge give its circumference as `period` [m]: the length is stretched so that a whole number of repeats fits.
    Raises ValueError where the file is no such profile.
    """
    length, height = _columns(Path(file))
    height = height - np.polynomial.Polynomial.fit(length, height, 1)(length)
    span = length[-1] - length[0]
    n = max(8, int(np.ceil(span / np.diff(length).min() * (1 - 1e-9))))
    if n > MOST_CELLS // 2:
        raise ValueError(
            f"{file}: lengths differ by as little as {np.diff(length).min():.3g} m; at most {MOST_CELLS // 2} steps"
        )
    even = np.interp(np.linspace(length[0], length[-1], n + 1), length, height)
    double = 2 * span if period is None else period / max(1, round(period / (2 * span)))
    return spline_profile(rfft(np.append(even, even[-2:0:-1])), double)


def _columns(file):
    rows = file.read_text("utf-8-sig").replace(";", ",").splitlines()
    first = next((i for i, row in enumerate(rows) if _is_number(row.split(",")[0])), len(rows))
    try:
        if first == len(rows):
            raise ValueError("no numbers")
        length, height = np.loadtxt(rows[first:], delimiter=",", ndmin=2, usecols=(0, 1)).T
    except ValueError as error:
        raise ValueError(f"{file}: must have rows of length, height in metres ({error})") from None
    if len(length) < 8 or not np.isfinite(height).all() or not (np.diff(length) > 0).all():
        raise ValueError(f"{file}: must have at least 8 rows of increasing length and finite height")
    return length, height


def _is_number(text):
    try:
        return np.isfinite(float(text))
    except ValueError:
        return False
