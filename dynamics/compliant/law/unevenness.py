"""Unevenness of table and edge along one turn of the rim, and the numbers that follow from it.

In the last seconds of its motion a disk hardly turns about its axis, so that the same points of
edge and table meet again and again: their heights act as one profile of the rim.
"""

from functools import lru_cache
from math import ceil, exp, log, pi, sqrt
from pathlib import Path
from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.hertz_mindlin import ContactLaw
from dynamics.compliant.law.profile_files import profile_columns
from dynamics.compliant.law.sections import Imperfection, Roughness
from dynamics.disk import Disk

LOWEST_ORDER = 2
"""Waves round the rim of the first order are a tilt of the table."""
POINTS_PER_WAVE = 13
"""Points of the rim per shortest wave."""
MIN_GRAIN_PERIODS = 16
"""Period of a ruled table over its longest wave or the diameter of the disk."""
MIN_RIM_POINTS = 4096
"""Smallest number of points of the rim; they resolve the contact of a coin."""


def rim_amplitudes(roughness: Roughness | None, radius: float) -> np.ndarray:
    """Return the complex amplitudes (n,) [m] of the heights round the rim, by order from 0 on.

    The height at an angle a is the real part of the sum of amplitude[n] exp(i n a). Raises
    ValueError if no wave fits the rim, or if a measured profile is shorter than one turn.
    """
    if roughness is None:
        return np.zeros(LOWEST_ORDER, complex)
    measured = roughness.profile is not None
    rms = 0.0 if measured or roughness.grain else roughness.rms or 0.0
    parts = [spectral_amplitudes(roughness, np.hypot(rms, roughness.edge_rms), radius)]
    if measured:
        parts.append(measured_amplitudes(roughness.profile, radius))
    elif roughness.grain:
        parts.append(grain_amplitudes(roughness, radius))
    if roughness.profile_edge is not None:
        parts.append(measured_amplitudes(roughness.profile_edge, radius))
    total = np.zeros(max(map(len, parts)), complex)
    for part in parts:
        total[: len(part)] += part
    total[:LOWEST_ORDER] = 0.0
    return total


def spectral_amplitudes(roughness: Roughness, rms: float, radius: float) -> np.ndarray:
    """Return the amplitudes (n,) [m] of random heights with this root mean square [m].

    The squared amplitudes vary as n^-p with the exponent p of the roughness. The phases are random,
    and the root mean square is exact.
    """
    if rms == 0.0:
        return np.zeros(LOWEST_ORDER, complex)
    rim = 2 * pi * radius
    first = max(int(np.ceil(rim / roughness.longest)), LOWEST_ORDER)
    last = int(rim / roughness.shortest)
    if last < first:
        raise ValueError(
            f"roughness.shortest = {roughness.shortest:g}: no wave between it and longest fits "
            f"{rim:g} m"
        )
    order = np.arange(first, last + 1)
    size = order ** (-roughness.exponent / 2)
    size *= sqrt(2) * rms / sqrt(np.sum(size**2))
    phase = np.random.default_rng(roughness.seed).uniform(0, 2 * pi, len(order))
    return np.concatenate([np.zeros(first), size * np.exp(1j * phase)])


def grain_amplitudes(roughness: Roughness, radius: float) -> np.ndarray:
    """Return the amplitudes (n,) [m] along the circle of the contact on a ruled table.

    Its height depends on x = R cos(a) only. The waves along x have the spectrum of the roughness.
    """
    period = MIN_GRAIN_PERIODS * max(roughness.longest, 2 * radius)
    along = np.arange(ceil(period / roughness.longest), int(period / roughness.shortest) + 1)
    size = along ** (-roughness.exponent / 2)
    size *= sqrt(2) * (roughness.rms or 0.0) / sqrt(np.sum(size**2))
    phase = np.random.default_rng(roughness.seed).uniform(0, 2 * pi, len(along))
    count = rim_point_count(int(2 * pi * radius / roughness.shortest))
    x = radius * np.cos(2 * pi * np.arange(count) / count)
    heights = np.zeros(count)
    for number, amplitude, shift in zip(along, size, phase, strict=True):
        heights += amplitude * np.cos(2 * pi * number / period * x + shift)
    return amplitudes_of(heights, int(2 * pi * radius / roughness.shortest))


def measured_amplitudes(file: str, radius: float) -> np.ndarray:
    """Return the amplitudes (n,) [m] of the first turn of a measured profile.

    The straight line between its ends is subtracted, which closes the turn. Raises ValueError if
    the profile is shorter than one turn.
    """
    length, height = profile_columns(Path(file))
    length = length - length[0]
    rim = 2 * pi * radius
    if length[-1] < rim:
        raise ValueError(
            f"{file}: is {length[-1]:g} m long, and must be at least one turn of the rim, {rim:g} m"
        )
    last = int(rim / (2 * np.diff(length).min()))
    count = rim_point_count(last)
    path = rim * np.arange(count) / count
    start, end = np.interp([0.0, rim], length, height)
    return amplitudes_of(np.interp(path, length, height) - (end - start) * path / rim, last)


def amplitudes_of(heights: np.ndarray, last: int) -> np.ndarray:
    """Return the complex amplitudes (last + 1,) [m] of heights (p,) [m] at equidistant angles."""
    return np.fft.rfft(heights)[: last + 1] * 2 / len(heights)


def rim_point_count(last: int) -> int:
    """Return the number of points of the rim for waves up to the order `last`: a power of two."""
    needed = max(MIN_RIM_POINTS, POINTS_PER_WAVE * (last + 1))
    return 2 ** int(np.ceil(np.log2(needed)))


def rim_heights(
    roughness: Roughness | None, imperfection: Imperfection | None, radius: float
) -> np.ndarray:
    """Return the heights (p,) [m] of the rim's profile at equidistant angles."""
    amplitudes = rim_amplitudes(roughness, radius)
    if imperfection is not None:
        missing = max(imperfection.order + 1 - len(amplitudes), 0)
        amplitudes = np.pad(amplitudes, (0, missing))
        amplitudes[imperfection.order] += imperfection.amplitude
    count = rim_point_count(len(amplitudes) - 1)
    waves = np.zeros(count // 2 + 1, complex)
    waves[: len(amplitudes)] = amplitudes
    return np.fft.irfft(waves, count) * count / 2


def static_depth(weight, modulus, radius, fillet, inclination):
    """Return the depth [m] of the static elastic contact of the edge on a smooth table.

    Examples
    --------
    >>> round(1e6 * static_depth(0.0834, 40e9, 12.875e-3, 0.5e-3, 0.1), 3)
    0.067
    """
    stiffness = 4 / 3 * modulus * (radius * fillet / inclination) ** 0.25
    return (weight / stiffness) ** (2 / 3)


def curvature_number(amplitudes, radius: float, inclination: float, depth: float) -> float:
    """Return kappa, the rms curvature of the unevenness over the curvature of the tilted rim.

    Waves shorter than the contact, which has this static depth [m], are not felt. Contact is first
    lost at a value of 0.25 to 0.5; from about 0.6 on the disk is off the table for a third of the
    time.
    """
    order = np.arange(len(amplitudes))
    felt = order < sqrt(radius * inclination / (2 * depth))
    curvature = ((order**2 - 1) * np.abs(amplitudes))[felt]
    return sqrt(np.sum(curvature**2) / 2) / (radius * inclination)


class Unevenness(NamedTuple):
    """Unevenness of table and edge relative to the tilted rim and to its contact.

    Attributes
    ----------
    curvature : float
        kappa, as `curvature_number` returns it.
    depths : float
        Root mean square of the heights over the depth of the static contact.
    """

    curvature: float
    depths: float


@lru_cache(32)
def _amplitudes(roughness: Roughness, radius: float) -> np.ndarray:
    return rim_amplitudes(roughness, radius)


def unevenness(
    disk: Disk, law: ContactLaw, roughness: Roughness | None, inclination: float
) -> Unevenness:
    """Return how uneven table and edge are for a disk at an inclination [rad].

    Raises ValueError if no wave fits the rim.
    """
    if roughness is None:
        return Unevenness(0.0, 0.0)
    amplitudes = _amplitudes(roughness, disk.radius)
    depth = static_depth(disk.weight, law.modulus, disk.radius, law.fillet, inclination)
    rms = sqrt(np.sum(np.abs(amplitudes) ** 2) / 2)
    kappa = curvature_number(amplitudes, disk.radius, inclination, depth)
    return Unevenness(kappa, rms / depth)


def damping_ratio(restitution: float) -> float:
    """Return the damping ratio of a linear contact with this restitution.

    The restitution is exp(-pi zeta/sqrt(1 - zeta^2)).

    Examples
    --------
    >>> round(damping_ratio(0.5), 4)
    0.2155
    """
    logarithm = -log(restitution) / pi
    return logarithm / sqrt(1 + logarithm**2)


def restitution_of(ratio: float) -> float:
    """Return the restitution of a linear contact of this damping ratio.

    Examples
    --------
    >>> round(restitution_of(damping_ratio(0.5)), 12)
    0.5
    """
    return exp(-pi * ratio / sqrt(1 - ratio**2))


def rate_exponent(spectrum_exponent: float) -> float:
    """Return n of the precession rate ~ (t_end - t)^-n of a disk that impacts alone slow down.

    The unevenness has the power spectrum k^-p with p = 1 + 2 H, and n = (2 - H)/(4 - H).

    Examples
    --------
    >>> rate_exponent(1.0)
    0.5
    """
    slope = (spectrum_exponent - 1) / 2
    return (2 - slope) / (4 - slope)
