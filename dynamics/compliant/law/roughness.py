"""Roughness of table and edge: spectra, and random height profiles.

Profiles are periodic: that of the table over at least 2^20 cells, that of the edge over
its circumference.
"""

from dataclasses import replace
from math import pi

import numpy as np
from scipy.fft import next_fast_len
from scipy.integrate import trapezoid

from dynamics.compliant.law.height_profile import (
    SMOOTH_PROFILE,
    Profile,
    mean_heights,
    profile_from_csv,
    spline_profile,
)
from dynamics.compliant.law.sections import Roughness


def profiles(roughness: Roughness | None, radius: float) -> tuple[Profile, Profile]:
    """Return the height profiles of table and edge for a disk of a radius [m].

    They are random or read from files. Raises ValueError if a file is not a valid
    profile, or if no wavelength of the spectrum fits the edge.
    """
    if roughness is None:
        return SMOOTH_PROFILE, SMOOTH_PROFILE
    table = (
        table_profile(roughness)
        if roughness.profile is None
        else profile_from_csv(roughness.profile)
    )
    if roughness.profile_edge is not None:
        return table, profile_from_csv(roughness.profile_edge, 2 * pi * radius)
    return table, edge_profile(
        roughness, radius
    ) if roughness.edge_rms > 0 else SMOOTH_PROFILE


def check_roughness(roughness: Roughness, radius: float) -> None:
    """Raise ValueError if a profile cannot be read, or if no wavelength fits the edge."""
    for key, file in (
        ("profile", roughness.profile),
        ("profile_edge", roughness.profile_edge),
    ):
        try:
            if file is not None:
                profile_from_csv(file)
        except OSError as error:
            raise ValueError(
                f"roughness.{key} = {file!r}: cannot be read: {error.strerror}"
            ) from None
    if roughness.edge_rms:
        wave_spectrum(roughness, 2 * pi * radius)


def table_profile(roughness: Roughness) -> Profile:
    """Return a random height profile of the table along the path of the contact."""
    min_cells = 2**20
    n = max(min_cells, 2 ** int(np.ceil(np.log2(roughness.needed_profile_cells))))
    return _random_profile(roughness, n * roughness.cell, n, 0)


def edge_profile(roughness: Roughness, radius: float) -> Profile:
    """Return a random height profile along the edge of a disk of a radius [m].

    Raises ValueError if no wavelength of the spectrum fits.
    """
    period = 2 * pi * radius
    n = next_fast_len(int(np.ceil(period / roughness.cell)), real=True)
    edge = replace(
        roughness,
        rms=roughness.edge_rms,
        rms_edge=None,
        profile=None,
        profile_edge=None,
    )
    return _random_profile(edge, period, n, 1)


def wave_spectrum(roughness: Roughness, period: float) -> tuple[np.ndarray, np.ndarray]:
    """Return wavenumbers (w,) [rad/m] that fit a period [m], and mean squares [m^2].

    Raises ValueError if none fits.
    """
    first = np.ceil(period / roughness.longest * (1 - 1e-12))
    last = np.floor(period / roughness.shortest * (1 + 1e-12))
    if last < max(first, 1):
        raise ValueError(
            f"roughness.shortest = {roughness.shortest:g}: no wavelength between shortest and "
            f"longest fits {period:g} m"
        )
    order = np.arange(max(first, 1), last + 1)
    power = (order / order[0]) ** -roughness.exponent
    return 2 * pi * order / period, (roughness.rms or 0.0) ** 2 * power / power.sum()


def ellipse_window(ka: np.ndarray) -> np.ndarray:
    """Return the transfer function 3 (sin ka - ka cos ka)/(ka)^3 of the mean height."""
    ka = np.asarray(ka, dtype=float)
    small = ka < 1e-2
    x = np.where(small, 1.0, ka)
    return np.where(small, 1 - ka * ka / 10, 3 * (np.sin(x) - x * np.cos(x)) / x**3)


def spectral_density(
    roughness: Roughness, radius: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return wavenumbers (w,) [rad/m] and spectral densities (w,) [m^3] of heights.

    The densities are the sum for table and edge, as mean square per wavenumber, at
    logarithmically spaced wavenumbers. The rms of the edge of a disk of a radius [m]
    is that of the waves that fit its circumference. Raises ValueError if a file is not
    a valid profile.
    """
    count = 8192  # wavenumbers
    files = [
        profile_from_csv(file)
        for file in (roughness.profile, roughness.profile_edge)
        if file is not None
    ]
    edge_gain = circumference_gain(roughness, 2 * pi * radius, count)
    drawn = (roughness.rms or 0.0) ** 2 + roughness.edge_rms**2 * edge_gain
    longest = max([p.period for p in files] + [roughness.longest] * (drawn > 0))
    shortest = min(
        [2 / p.cells_per_metre for p in files] + [roughness.shortest] * (drawn > 0)
    )
    k = np.geomspace(2 * pi / longest, 2 * pi / shortest, count)
    power = k**-roughness.exponent * (2 * pi <= k * roughness.longest * (1 + 1e-9))
    power *= k * roughness.shortest <= 2 * pi * (1 + 1e-9)
    power *= drawn / trapezoid(power, k) if drawn else 0.0
    return k, power + sum(_measured_spectrum(profile, k) for profile in files)


def circumference_gain(roughness: Roughness, period: float, count: int) -> float:
    """Return the gain of the waves that fit a period [m]; 1 if none fits.

    It is relative to an infinite profile of the same rms, whose spectrum is integrated
    over `count` wavenumbers.
    """
    low = period / roughness.longest
    high = period / roughness.shortest
    p = roughness.exponent
    order = np.arange(max(np.ceil(low * (1 - 1e-12)), 1), high * (1 + 1e-12))
    if not len(order):
        return 1.0
    n = np.geomspace(low, high, count)
    return float(trapezoid((n / low) ** -p, n) / np.sum((order / low) ** -p))


def shift_of_contact(
    roughness: Roughness,
    inclination: np.ndarray,
    half_length: np.ndarray,
    radius: float,
) -> np.ndarray:
    """Return the relative shift rms(z'') R/beta (n,) of the contact along the edge.

    It is the shift in radians per radian, at inclinations (n,) [rad]. Table and edge
    are averaged over ellipses of half-lengths (n,) [m]. If the result exceeds 1, the
    disk touches at several points, and a single ellipse is only an approximation.
    """
    k, power = spectral_density(roughness, radius)
    curvature = [
        trapezoid(
            power * k**4 * ellipse_window(k * a) ** 2,
            k,
        )
        for a in np.atleast_1d(half_length)
    ]
    return np.sqrt(curvature) * radius / np.sin(inclination)


def _measured_spectrum(profile: Profile, k: np.ndarray) -> np.ndarray:
    """Return the spectral density (w,) [m^3] of a measured profile in bins of k (w,)."""
    n = len(profile.coefficients) - 5
    cell = 1 / profile.cells_per_metre
    waves = (
        np.fft.rfft(mean_heights(profile, cell * np.arange(n), np.full(n, cell)))[1:]
        / n
    )
    own = 2 * pi / profile.period * np.arange(1, len(waves) + 1)
    below = np.append(
        0.0, np.cumsum(2 * np.abs(waves / ellipse_window(own * cell)) ** 2)
    )
    edges = np.concatenate([[0.0], np.sqrt(k[1:] * k[:-1]), [own[-1]]])
    return np.diff(np.interp(edges, np.append(0.0, own), below)) / np.diff(edges)


def _random_profile(roughness: Roughness, period: float, n: int, which: int) -> Profile:
    """Return a random Gaussian profile with the spectrum of the roughness."""
    k, power = wave_spectrum(roughness, period)
    order = np.rint(k * period / (2 * pi)).astype(int)
    waves = np.zeros(n // 2 + 1, complex)
    draw = np.random.default_rng([roughness.seed, which]).normal(size=(len(k), 2))
    waves[order] = n / 2 * np.sqrt(power) * (draw[:, 0] - 1j * draw[:, 1])
    return spline_profile(waves, period, n)
