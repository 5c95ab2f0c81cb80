"""Flexibility of a free disk as a body under a force on its edge, without the local flexibility
near the force.

Under a force spread over a strip of the edge, s long and s high, a disk yields F(s) = a/s + F0 +
small terms. The part a/s is that of the material near the force, which Hertz's springs include; F0
is that of the body. The effect of the shape of a fillet of radius s is of the order (1 - nu^2)/(2
pi E s), an eighth of F0 for the toy, and is neglected.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np
from scipy.special import eval_legendre

from modal.blas_threads import one_blas_thread
from modal.spectral.basis import Plate
from modal.synthesis.free_disk import FreeDisk

FINEST_STRIP_SHARE = 1 / 8
"""Smallest height of a strip that the polynomials resolve, divided by the thickness."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Edge:
    """Flexibility of a free elastic disk at its bottom edge.

    The three directions are those of radius, rim and axis of the disk.

    Attributes
    ----------
    flexibility : ndarray, shape (3, 3)
        Static flexibility of all elastic modes [m/N].
    squared : ndarray, shape (m,)
        Squared angular frequencies of the lowest elastic modes [1/s^2].
    shapes : ndarray, shape (m, 3)
        Displacement of the edge in these modes at unit modal mass [kg^-1/2].
    order : ndarray of int, shape (m,)
        Number of waves of these modes around the rim.
    """

    flexibility: np.ndarray
    squared: np.ndarray
    shapes: np.ndarray
    order: np.ndarray


def yielding_edge(plate: Plate) -> Edge:
    """Compute the flexibility of a free disk at its edge.

    Parameters
    ----------
    plate : Plate
        A solid plate with a free edge.

    Returns
    -------
    Edge
        Cached: the same object for equal plates.

    Raises
    ------
    ValueError
        If the plate has a hole, a ring or an edge that is not free.
    """
    return _edge_of(plate)


@lru_cache(maxsize=32)
@one_blas_thread
def _edge_of(plate):
    disk = FreeDisk(plate=plate)
    size = FINEST_STRIP_SHARE * plate.thickness
    orders = [(n, even, order) for (n, even, _), order in disk.kept.items()]
    squared = np.concatenate([order.values for _, _, order in orders])
    shapes = np.concatenate(
        [strip_means(disk, size, n, even, order.shapes) for n, even, order in orders],
    )
    in_pair = np.array(
        [[1, 0, 1], [0, 1, 0]],
    )  # one mode moves radius and axis, its partner the rim
    pair_shapes = shapes[:, None] * in_pair
    waves = np.concatenate([np.full(len(order.values), n) for n, _, order in orders])
    elastic = squared > 0
    return Edge(
        flexibility=regular_flexibility(disk, size)[0],
        squared=np.repeat(squared[elastic], 2),
        shapes=pair_shapes[elastic].reshape(-1, 3),
        order=np.repeat(waves[elastic], 2),
    )


def strip_means(disk, size, n, even, shapes):
    """Return the means (k, 3) of shapes (3 nz, k) of order n over a strip of the edge of a size
    [m]."""
    through = legendre_means(disk.axial_count, even, size / disk.plate.thickness * 2)
    return np.sinc(n * size / (2 * pi * disk.plate.radius)) * np.einsum(
        "ca,cak->kc",
        through,
        shapes.reshape(3, disk.axial_count, -1),
    )


def regular_flexibility(disk: FreeDisk, size: float, missing_factor: float = 2):
    """Return F0 (3, 3) [m/N] along radius, rim and axis of the bottom edge, and the uncertainty
    (3,) of its diagonal.

    F0 = 2 F(2 s) - F(s) with s = size [m]. The basis lacks at most `missing_factor` times what its
    highest polynomials contribute; tests/modal/test_spring_supported_modes.py checks this.
    """
    wide, wide_highest = strip_flexibility(disk, 2 * size)
    narrow, narrow_highest = strip_flexibility(disk, size)
    return 2 * wide - narrow, missing_factor * np.diag(2 * wide_highest + narrow_highest)


def strip_flexibility(disk: FreeDisk, size: float):
    """Return F(s) (3, 3) [m/N] and the contribution of the highest polynomials to it.

    F(s) is the mean displacement of a strip of the lateral surface, size [m] along the rim and up
    from the bottom edge, under a force spread evenly over it, with the rigid-body motion held.
    """
    half = size / (2 * disk.plate.radius)
    through = {
        even: legendre_means(disk.axial_count, even, 2 * size / disk.plate.thickness)
        for even in (1, -1)
    }
    result = np.zeros((2, 3, 3))
    for (n, even, _), order in disk.kept.items():
        elastic = order.values > 0
        kept = (order.shapes[:, elastic] / order.values[elastic]) @ order.shapes[:, elastic].T
        result += np.sinc(n * half / pi) ** 2 * flexibility_of_strip_means(
            through[even],
            order.rest[[0, 2]] + [kept, 0 * kept],
        )
    for even, (n, rest) in disk.high.items():
        far = np.arange(n[-1] + 1, n[-1] + 30 / half)
        local = flexibility_of_strip_means(through[even], rest[:, [0, 2]])
        share = np.sinc(n * half / pi) ** 2
        result += (
            np.tensordot(share, local, 1)
            + (np.sinc(far * half / pi) ** 2 * n[-1] / far).sum() * local[-1]
        )
    same_parity = np.array(
        [[1, 0, 1], [0, 1, 0], [1, 0, 1]],
    )  # radial, axial: cosine modes; tangential: sine partners
    return result * same_parity


def legendre_means(count, even, height):
    """Return the means (3, count) of the Legendre polynomials of u_r, u_theta, u_z over [-1, height
    - 1]."""
    degree = 2 * np.arange(count) + np.array([even < 0, even < 0, even > 0])[:, None]
    next_value = eval_legendre(degree + 1, height - 1.0) - (-1.0) ** (degree + 1)
    previous_degree = np.abs(degree - 1)
    previous_value = eval_legendre(previous_degree, height - 1.0) - (-1.0) ** previous_degree
    return (next_value - np.where(degree, previous_value, 0)) / (2 * degree + 1) / height


def flexibility_of_strip_means(through, nodal):
    """Return the flexibility (..., 3, 3) of mean strip displacements.

    `nodal` (..., 3 nz, 3 nz) is the flexibility of the polynomial coefficients, and `through` (3,
    nz)
    contains the strip means of the polynomials.
    """
    count = through.shape[1]
    parts = nodal.reshape(*nodal.shape[:-2], 3, count, 3, count)
    return np.einsum("ca,...cadb,db->...cd", through, parts, through)
