"""Unevenness of table and edge along one turn of the rim, and its curvature number.

In the last seconds of its motion a disk hardly rotates about its axis, so that the same
points of edge and table meet repeatedly. Their heights are therefore combined in one
profile of the rim.
"""

from functools import lru_cache
from math import acos, acosh, ceil, exp, pi, sqrt
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import brentq

from dynamics.compliant.law.hertz_mindlin import ContactLaw
from dynamics.compliant.law.profile_files import profile_columns
from dynamics.compliant.law.sections import (
    LOWEST_WAVINESS_ORDER,
    Imperfection,
    Roughness,
)
from dynamics.disk import Disk


def rim_amplitudes(roughness: Roughness | None, radius: float) -> np.ndarray:
    """Return the complex amplitudes (n,) [m] of the heights around the rim, by order.

    The height at an angle a is the real part of the sum of amplitude[n] exp(i n a),
    from n = 0. Raises ValueError if no wavelength fits the rim, or if a measured
    profile is shorter than one turn.
    """
    if roughness is None:
        return np.zeros(LOWEST_WAVINESS_ORDER, complex)
    measured = roughness.profile is not None
    rms = 0.0 if measured or roughness.grain else roughness.rms or 0.0
    parts = [spectral_amplitudes(roughness, np.hypot(rms, roughness.edge_rms), radius)]
    if roughness.profile is not None:
        parts.append(measured_amplitudes(roughness.profile, radius))
    elif roughness.grain:
        parts.append(grain_amplitudes(roughness, radius))
    if roughness.profile_edge is not None:
        parts.append(measured_amplitudes(roughness.profile_edge, radius))
    total = np.zeros(max(map(len, parts)), complex)
    for part in parts:
        total[: len(part)] += part
    total[:LOWEST_WAVINESS_ORDER] = 0.0
    return total


def spectral_amplitudes(roughness: Roughness, rms: float, radius: float) -> np.ndarray:
    """Return the amplitudes (n,) [m] of random heights with a root mean square [m].

    The squared amplitudes vary as n^-p with the exponent p of the roughness. The phases
    are random, and the root mean square is exact.
    """
    if rms == 0.0:
        return np.zeros(LOWEST_WAVINESS_ORDER, complex)
    rim = 2 * pi * radius
    first = max(int(np.ceil(rim / roughness.longest)), LOWEST_WAVINESS_ORDER)
    highest_order = int(rim / roughness.shortest)
    if highest_order < first:
        raise ValueError(
            f"roughness.shortest = {roughness.shortest:g}: no wavelength between shortest and "
            f"longest fits {rim:g} m"
        )
    order = np.arange(first, highest_order + 1)
    size, phase = random_waves(roughness, rms, order)
    return np.concatenate([np.zeros(first), size * np.exp(1j * phase)])


def random_waves(
    roughness: Roughness, rms: float, order: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the amplitudes (n,) [m] and random phases (n,) [rad] of waves (n,) by order."""
    size = order ** (-roughness.exponent / 2)
    size *= sqrt(2) * rms / sqrt(np.sum(size**2))
    phase = np.random.default_rng(roughness.seed).uniform(0, 2 * pi, len(order))
    return size, phase


@lru_cache(8)
def grain_amplitudes(roughness: Roughness, radius: float) -> np.ndarray:
    """Return the read-only amplitudes (n,) [m] along the contact circle on a ruled table.

    The height depends only on x = R cos(a). The waves along x have the spectrum of the
    roughness. The plan, the checks and the models of a scene share the result.
    """
    # period of a ruled table, divided by its longest wave or the diameter of the disk
    min_grain_periods = 16
    period = min_grain_periods * max(roughness.longest, 2 * radius)
    along = np.arange(
        ceil(period / roughness.longest), int(period / roughness.shortest) + 1
    )
    size, phase = random_waves(roughness, roughness.rms or 0.0, along)
    highest_order = int(2 * pi * radius / roughness.shortest)
    count = rim_point_count(highest_order)
    x = radius * np.cos(2 * pi * np.arange(count) / count)
    heights = np.zeros(count)
    for number, amplitude, shift in zip(along, size, phase, strict=True):
        heights += amplitude * np.cos(2 * pi * number / period * x + shift)
    amplitudes = fourier_amplitudes(heights, highest_order)
    amplitudes.flags.writeable = False
    return amplitudes


def measured_amplitudes(file: str, radius: float) -> np.ndarray:
    """Return the amplitudes (n,) [m] of the first turn of a measured profile.

    The straight line between both ends is subtracted, which makes the turn periodic.
    Raises ValueError if the profile is shorter than one turn.
    """
    length, height = profile_columns(Path(file))
    length = length - length[0]
    rim = 2 * pi * radius
    if length[-1] < rim:
        raise ValueError(
            f"{file}: is {length[-1]:g} m long, but must be at least one turn of the rim, {rim:g} m"
        )
    highest_order = int(rim / (2 * np.diff(length).min()))
    count = rim_point_count(highest_order)
    path = rim * np.arange(count) / count
    start, end = np.interp([0.0, rim], length, height)
    return fourier_amplitudes(
        np.interp(path, length, height) - (end - start) * path / rim, highest_order
    )


def fourier_amplitudes(heights: np.ndarray, highest_order: int) -> np.ndarray:
    """Return the complex amplitudes (n,) [m] of heights (p,) [m] at equidistant angles.

    The orders are 0 to `highest_order`.
    """
    return np.fft.rfft(heights)[: highest_order + 1] * 2 / len(heights)


def rim_point_count(highest_order: int) -> int:
    """Return a number of rim points, a power of two, that resolves `highest_order`."""
    # smallest number of points of the rim, which resolves the contact of a coin
    min_rim_points = 4096
    points_per_wave = 13  # points of the rim per shortest wave
    needed = max(min_rim_points, points_per_wave * (highest_order + 1))
    return 2 ** int(np.ceil(np.log2(needed)))


def rim_heights(
    roughness: Roughness | None, imperfection: Imperfection | None, radius: float
) -> np.ndarray:
    """Return the heights (p,) [m] of table and edge at equidistant angles."""
    amplitudes = rim_amplitudes(roughness, radius)
    if imperfection is not None:
        missing = max(imperfection.order + 1 - len(amplitudes), 0)
        amplitudes = np.pad(amplitudes, (0, missing))
        amplitudes[imperfection.order] += imperfection.amplitude
    count = rim_point_count(len(amplitudes) - 1)
    waves = np.zeros(count // 2 + 1, complex)
    waves[: len(amplitudes)] = amplitudes
    return np.fft.irfft(waves, count) * count / 2


def static_depth(
    weight: float,
    modulus: float,
    radius: float,
    fillet: float,
    inclination: float | np.ndarray,
) -> Any:
    """Return the static approach [m] of the elastic edge to a smooth table.

    Examples
    --------
    >>> round(1e6 * static_depth(0.0834, 40e9, 12.875e-3, 0.5e-3, 0.1), 3)
    0.067
    """
    stiffness = 4 / 3 * modulus * (radius * fillet / inclination) ** 0.25
    return (weight / stiffness) ** (2 / 3)


def curvature_number(
    amplitudes: np.ndarray, radius: float, inclination: float, depth: float
) -> float:
    """Return kappa, the rms curvature of the unevenness over that of the tilted rim.

    Waves shorter than the contact, which has the static `depth` [m], are excluded.
    Contact is first lost at values from 0.25 to 0.5; above about 0.6 the disk is off
    the table for a third of the time.
    """
    order = np.arange(len(amplitudes))
    felt = order < sqrt(radius * inclination / (2 * depth))
    curvature = ((order**2 - 1) * np.abs(amplitudes))[felt]
    return sqrt(np.sum(curvature**2) / 2) / (radius * inclination)


class Unevenness(NamedTuple):
    """Unevenness of table and edge relative to the tilted rim and to its contact.

    Attributes
    ----------
    curvature_number : float
        kappa, as returned by the function `curvature_number`.
    rms_over_depth : float
        Root mean square of the heights divided by the static depth of the contact.
    """

    curvature_number: float
    rms_over_depth: float


@lru_cache(32)
def _amplitudes(roughness: Roughness, radius: float) -> np.ndarray:
    return rim_amplitudes(roughness, radius)


def unevenness(
    disk: Disk, law: ContactLaw, roughness: Roughness | None, inclination: float
) -> Unevenness:
    """Return the unevenness of table and edge for a disk at an inclination [rad].

    Raises ValueError if no wavelength fits the rim.
    """
    if roughness is None:
        return Unevenness(0.0, 0.0)
    amplitudes = _amplitudes(roughness, disk.radius)
    depth = static_depth(disk.weight, law.modulus, disk.radius, law.fillet, inclination)
    rms = sqrt(np.sum(np.abs(amplitudes) ** 2) / 2)
    kappa = curvature_number(amplitudes, disk.radius, inclination, depth)
    return Unevenness(kappa, rms / depth)


def restitution_of_patch(damping_ratio: float) -> float:
    """Return the coefficient of restitution of a patch with a damping ratio zeta.

    The patch is Hertzian and pushes only: its force is K x^1.5 plus that of a dashpot
    2 zeta sqrt(m k) with the local stiffness k = 1.5 K x^0.5, and never negative. With
    y = x^1.25 and ds = x^0.25 dt the impact is that of a linear oscillator with the
    damping ratio z = sqrt(6/5) zeta, which ends where its acceleration vanishes
    (Antypov & Elliott 2011; Schwager & Poeschel 2007):
    exp(-2 z arccos(z)/sqrt(1 - z^2)).

    Examples
    --------
    >>> round(restitution_of_patch(0.233), 3)
    0.5
    """
    z = sqrt(6 / 5) * damping_ratio
    if z == 1:
        return exp(-2.0)
    angle = acos(z) if z < 1 else acosh(z)
    return exp(-2 * z * angle / sqrt(abs(1 - z * z)))


def damping_ratio(restitution: float) -> float:
    """Return the damping ratio of a patch with a coefficient of restitution.

    It is the inverse of `restitution_of_patch`.

    Examples
    --------
    >>> round(damping_ratio(0.5), 3)
    0.233
    """
    largest = 1 / restitution  # restitution_of_patch falls faster than this
    return brentq(
        lambda ratio: restitution_of_patch(ratio) - restitution,
        0.0,
        largest,
        xtol=1e-15,
    )


def precession_rate_exponent(spectrum_exponent: float) -> float:
    """Return n in the rate ~ (t_end - t)^-n of the precession, slowed only by impacts.

    For unevenness with the power spectrum k^-p, p = 1 + 2 H, it is n = (2 - H)/(4 - H).

    Examples
    --------
    >>> precession_rate_exponent(1.0)
    0.5
    """
    slope = (spectrum_exponent - 1) / 2
    return (2 - slope) / (4 - slope)
