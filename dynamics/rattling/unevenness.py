"""Unevenness of table and edge along one turn of the rim, and the numbers that follow from it.

In the last seconds of its motion a disk hardly turns about its axis, so that the same points of
edge and table meet again and again: their heights act as one profile of the rim.
"""

from math import exp, log, pi, sqrt

import numpy as np

from dynamics.compliant.law.sections import Imperfection, Roughness

LOWEST_ORDER = 2
"""Waves round the rim of the first order are a tilt of the table."""
POINTS_PER_WAVE = 13
"""Points of the rim per shortest wave."""
MIN_RIM_POINTS = 4096
"""Smallest number of points of the rim; they resolve the contact of a coin."""


def rim_amplitudes(roughness: Roughness | None, radius: float) -> np.ndarray:
    """Return the complex amplitudes (n,) [m] of the heights round the rim, by order from 0 on.

    The height at an angle a is the real part of the sum of amplitude[n] exp(i n a). The squared
    amplitudes of table and edge vary as n^-p with the exponent p of the roughness. The phases are
    random, and the root mean square is exact. Raises ValueError if no wave fits the rim.
    """
    if roughness is None:
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
    mean_square = (roughness.rms or 0.0) ** 2 + roughness.edge_rms**2
    size *= sqrt(2 * mean_square / np.sum(size**2))
    phase = np.random.default_rng(roughness.seed).uniform(0, 2 * pi, len(order))
    return np.concatenate([np.zeros(first), size * np.exp(1j * phase)])


def rim_heights(
    roughness: Roughness | None, imperfection: Imperfection | None, radius: float
) -> np.ndarray:
    """Return the heights (p,) [m] of the rim's profile at equidistant angles."""
    amplitudes = rim_amplitudes(roughness, radius)
    if imperfection is not None:
        missing = max(imperfection.order + 1 - len(amplitudes), 0)
        amplitudes = np.pad(amplitudes, (0, missing))
        amplitudes[imperfection.order] += imperfection.amplitude
    needed = max(MIN_RIM_POINTS, POINTS_PER_WAVE * len(amplitudes))
    count = 2 ** int(np.ceil(np.log2(needed)))
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
