"""Outgoing multipoles above a baffle, symmetric about it.

Those of azimuthal order n vary as cos n theta and exp(i w t); they are normalised on a
hemisphere."""

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import gammaln, lpmv, spherical_jn, spherical_yn


def listener_pressure(
    n: int, wavenumbers: ArrayLike, far: float, distance: float, elevation: float
) -> np.ndarray:
    """Return the pressures (a, m) of unit multipoles of order n at a listener.

    The wavenumbers are k (a,). The multipoles are normalised on the hemisphere of
    radius `far`. The listener is at azimuth 0; `distance` is in units of the disk
    radius, and `elevation` in radians. The propagation phase from the centre of the
    disk is removed."""
    degree = multipole_degrees(n)
    k = np.asarray(wavenumbers)[:, None]
    wave = outgoing_hankel(degree, k * distance) / outgoing_hankel(degree, k * far)
    return wave * np.exp(1j * k * distance) * associated_legendre(n, np.sin(elevation))


def multipole_degrees(n: int) -> np.ndarray:
    """Return the degrees (m,) of the multipoles of azimuthal order n."""
    multipole_count = 8
    return n + 2 * np.arange(multipole_count)


def outgoing_hankel(
    order: ArrayLike, x: ArrayLike, derivative: bool = False
) -> np.ndarray:
    """Return the spherical Hankel function of the second kind, which is outgoing for
    exp(i w t)."""
    return spherical_jn(order, x, derivative) - 1j * spherical_yn(order, x, derivative)


def associated_legendre(n: int, cosine: ArrayLike) -> np.ndarray:
    """Return associated Legendre functions (m, ...) of order n and degrees n, n + 2,
    ..., normalised to unit mean square."""
    degree = multipole_degrees(n)
    size = np.sqrt(
        (2 * degree + 1) * np.exp(gammaln(degree - n + 1) - gammaln(degree + n + 1))
    )
    return np.array([c * lpmv(n, m, cosine) for c, m in zip(size, degree, strict=True)])
