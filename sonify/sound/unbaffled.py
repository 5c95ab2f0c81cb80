"""Compute the sound radiated by a plate without a baffle, where air flows around its
edge.

By reciprocity, the pressure at a listener per unit acceleration of a point of the plate
is the pressure difference between the faces of the rigid plate at this point, caused by
a source at the listener. In a baffle it is twice the incident pressure. For a rigid
disk it is computed by Galerkin's method with the basis rho^m sqrt(1 - rho^2) P_j(1 - 2
rho^2) (Bouwkamp 1941). Any other outline is mapped to a disk through the ellipse with
the same second moments, which preserves the dipole at low frequency.
"""

from functools import lru_cache
from math import ceil, pi

import numpy as np
from scipy.special import ellipe, eval_jacobi, gammaln, spherical_jn

MAX_UNBAFFLED_KA = 12.0
"""Wavenumber times radius above which the plate radiates as in a baffle."""
KA_STEP = 0.4
"""Step of wavenumber times radius between solutions of the disk."""


class UnbaffledRatio:
    """Ratio of the pressure radiated by each point of an unbaffled plate to that of the
    same point of a plate in a baffle.

    Parameters
    ----------
    points, weights : ndarray, shapes (p, 2) and (p,)
        Points of the plate [m] and their weights [m^2].
    direction : ndarray, shape (3,)
        Unit vector to the listener.
    sound_speed : float
        [m/s]
    """

    def __init__(
        self,
        points: np.ndarray,
        weights: np.ndarray,
        direction: np.ndarray,
        sound_speed: float,
    ) -> None:
        centre = weights @ points / weights.sum()
        moments = np.einsum("p,pi,pj->ij", weights, points - centre, points - centre)
        squared, axes = np.linalg.eigh(moments / weights.sum())
        semi_axes = 2 * np.sqrt(squared)  # of the ellipse, in ascending order
        place = (points - centre) @ axes / semi_axes
        radius = pi / 2 * semi_axes[0] / ellipe(1 - squared[0] / squared[1])
        self._size_per_frequency = 2 * pi * radius / sound_speed
        towards = direction[:2] @ axes
        azimuth = np.arctan2(place[:, 1], place[:, 0]) - np.arctan2(
            towards[1], towards[0]
        )
        rho = np.minimum(np.hypot(*place.T), 1.0)
        sizes = np.arange(ceil(MAX_UNBAFFLED_KA / KA_STEP) + 1) * KA_STEP
        sizes[0] = 1e-3  # at small sizes the factor is proportional to the size
        factors = unbaffled_disk_ratios(sizes, direction[2], rho, azimuth)
        self._factors_per_size = factors / sizes[:, None]

    def ratio_at(self, frequency: float) -> np.ndarray:
        """Return the factor (p,) at a frequency [Hz]; 1 above MAX_UNBAFFLED_KA."""
        # Range of wavenumber times radius below MAX_UNBAFFLED_KA over which both
        # solutions are blended
        ka_blend_range = 2.0
        size = frequency * self._size_per_frequency
        if size >= MAX_UNBAFFLED_KA:
            return np.ones(self._factors_per_size.shape[1], complex)
        step = int(size / KA_STEP)
        share = size / KA_STEP - step
        below, above = self._factors_per_size[step : step + 2]
        factor = size * ((1 - share) * below + share * above)
        baffled = max(1 - (MAX_UNBAFFLED_KA - size) / ka_blend_range, 0.0)
        return factor + baffled * (1 - factor)


def unbaffled_disk_ratios(
    sizes: np.ndarray, cosine: float, rho: np.ndarray, azimuth: np.ndarray
) -> np.ndarray:
    """Return half the pressure difference (s, p) across a rigid disk in a plane wave.

    The result is divided by the incident pressure.

    Parameters
    ----------
    sizes : ndarray, shape (s,)
        Wavenumbers times radius.
    cosine : float
        Cosine of the angle between the wave and the normal.
    rho, azimuth : ndarray, shape (p,)
        Radial positions divided by the radius, and angles from the wave direction
        [rad].
    """
    along = np.asarray(sizes) * np.sqrt(max(1 - cosine**2, 0.0))
    radial_functions = 12  # of each azimuthal order
    j = np.arange(radial_functions)
    norm = np.exp(gammaln(j + 1) - gammaln(j + 1.5)) / np.sqrt(2)
    total = np.zeros((len(sizes), len(rho)), complex)
    for m in range(ceil(along.max()) + 5):
        n = (
            m + 2 * j + 1
        )  # J_(n + 1/2)(k)/k^(3/2) = sqrt(2/pi) j_n(k)/k is the Hankel transform of the basis function
        polynomials = np.array([eval_jacobi(k, m, 0.5, 1 - 2 * rho**2) for k in j])
        radial = rho**m * np.sqrt(1 - rho**2) * norm[:, None] * polynomials
        around = (1 if m == 0 else 2) * radial * np.cos(m * azimuth)
        for i, size in enumerate(sizes):
            wave = j_n_over_x(n, along[i]) * np.sqrt(2 / pi)
            source = 1j ** (m + 1) * size * cosine * wave
            total[i] += (
                inverse_galerkin_matrix(float(size), m, radial_functions)
                @ source
                @ around
            )
    return total / np.exp(1j * np.multiply.outer(along, rho * np.cos(azimuth)))


@lru_cache(4096)
def inverse_galerkin_matrix(size: float, m: int, count: int) -> np.ndarray:
    """Return the inverse (count, count) of the Galerkin matrix of azimuthal order m.

    `size` is the wavenumber times the radius."""
    n = m + 2 * np.arange(count) + 1
    kappa, weight, extra = spectral_quadrature(size)
    rows = spherical_jn(n[:, None], kappa) * np.sqrt(2 / pi)
    return np.linalg.inv(
        (rows * (weight * extra / kappa)) @ rows.T + np.diag(1 / (2 * n + 1))
    )


def spectral_quadrature(size: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return in-plane wavenumbers kappa, quadrature weights, and gamma - kappa, all
    (q,).

    The rate of decay away from the plane is gamma = sqrt(kappa^2 - size^2); the
    substitutions remove its singular slope at kappa = size.
    """
    node, share = np.polynomial.legendre.leggauss(40)
    angle = (node + 1) * pi / 4
    inner = size * np.sin(angle)
    inner_weight = size * np.cos(angle) * share * pi / 4
    edges = np.linspace(0.0, 80.0, 11)
    half = np.diff(edges)[:, None] / 2
    decay = ((edges[:-1, None] + half) + half * node).ravel()
    outer = np.hypot(decay, size)
    outer_weight = (half * share).ravel() * decay / outer
    kappa = np.concatenate([inner, outer])
    gamma = np.concatenate([1j * size * np.cos(angle), decay])
    return kappa, np.concatenate([inner_weight, outer_weight]), gamma - kappa


def j_n_over_x(n: np.ndarray, x: float) -> np.ndarray:
    """Return j_n(x)/x for orders n (j,) of at least 1, continuous at x = 0."""
    if x < 1e-8:
        return np.where(n == 1, 1 / 3, 0.0)
    return spherical_jn(n, x) / x
