"""Compute the flexibility of a free disk at its edge, excluding the local flexibility
near the force.

The flexibility under a force spread over a strip of the edge of length and height s is
F(s) = a/s + F0 + small terms. The part a/s is due to the material near the force and is
included in Hertz's springs; F0 is that of the whole body. The effect of the shape of a
fillet of radius s, of the order (1 - nu^2)/(2 pi E s), is neglected; for the toy it is
an eighth of F0.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np
from scipy.special import eval_legendre

from modal.blas_threads import one_blas_thread
from modal.spectral.basis import Plate
from modal.synthesis.free_disk import FreeDisk

FINEST_STRIP_THICKNESS_RATIO = 1 / 8
"""Smallest height of a strip resolved by the polynomials, divided by the thickness."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Edge:
    """Flexibility of a free elastic disk at its bottom edge.

    The three directions are radial, tangential and axial.

    Attributes
    ----------
    flexibility : ndarray, shape (3, 3)
        Static flexibility of all elastic modes [m/N].
    squared : ndarray, shape (m,)
        Squared angular frequencies of the lowest elastic modes [1/s^2].
    shapes : ndarray, shape (m, 3)
        Displacement of the edge in these modes of unit modal mass [kg^-1/2].
    order : ndarray of int, shape (m,)
        Circumferential order of these modes.

    Examples
    --------
    >>> from modal import Material, Plate, edge_flexibility
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> edge = edge_flexibility(plate)
    >>> len(edge.squared) == len(edge.shapes)
    True
    """

    flexibility: np.ndarray
    squared: np.ndarray
    shapes: np.ndarray
    order: np.ndarray


def edge_flexibility(plate: Plate) -> Edge:
    """Compute the flexibility of a free disk at its edge.

    Parameters
    ----------
    plate : Plate
        A solid plate with a free edge.

    Returns
    -------
    Edge
        Flexibility of the edge; the same cached object for equal plates.

    Raises
    ------
    ValueError
        If the plate has a hole, a ring or an edge that is not free.

    Examples
    --------
    >>> from modal import Material, Plate, edge_flexibility
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> edge = edge_flexibility(plate)
    >>> f"{edge.flexibility[2, 2]:.2g} m/N"
    '2.8e-07 m/N'
    """
    return _cached_edge_flexibility(plate)


yielding_edge = edge_flexibility
"""Former name of `edge_flexibility`."""


@lru_cache(maxsize=32)
@one_blas_thread
def _cached_edge_flexibility(plate: Plate) -> Edge:
    disk = FreeDisk(plate=plate)
    size = FINEST_STRIP_THICKNESS_RATIO * plate.thickness
    orders = [(n, even, order) for (n, even, _), order in disk.solved_orders.items()]
    squared = np.concatenate([order.values for _, _, order in orders])
    shapes = np.concatenate(
        [strip_means(disk, size, n, even, order.shapes) for n, even, order in orders],
    )
    # one mode has radial and axial motion, its partner tangential motion
    in_pair = np.array([[1, 0, 1], [0, 1, 0]])
    pair_shapes = shapes[:, None] * in_pair
    waves = np.concatenate([np.full(len(order.values), n) for n, _, order in orders])
    elastic = squared > 0
    return Edge(
        flexibility=nonlocal_flexibility(disk, size)[0],
        squared=np.repeat(squared[elastic], 2),
        shapes=pair_shapes[elastic].reshape(-1, 3),
        order=np.repeat(waves[elastic], 2),
    )


def strip_means(
    disk: FreeDisk, size: float, n: int, even: int, shapes: np.ndarray
) -> np.ndarray:
    """Return the means (k, 3) of shapes (3 nz, k) of order n over a strip of a size [m]
    at the edge."""
    through = legendre_means(disk.axial_count, even, size / disk.plate.thickness * 2)
    return np.sinc(n * size / (2 * pi * disk.plate.radius)) * np.einsum(
        "ca,cak->kc",
        through,
        shapes.reshape(3, disk.axial_count, -1),
    )


def nonlocal_flexibility(disk: FreeDisk, size: float) -> tuple[np.ndarray, np.ndarray]:
    """Return F0 (3, 3) [m/N] of the bottom edge and the uncertainty (3,) of its
    diagonal.

    The directions are radial, tangential and axial. F0 = 2 F(2 s) - F(s) with s = size
    [m]. The contribution of polynomials beyond the basis is bounded by a multiple of
    that of its highest polynomials, see tests/modal/test_spring_supported_modes.py.
    """
    max_omitted_ratio = 2  # bound on this ratio
    wide, wide_highest = strip_flexibility(disk, 2 * size)
    narrow, narrow_highest = strip_flexibility(disk, size)
    return 2 * wide - narrow, max_omitted_ratio * np.diag(
        2 * wide_highest + narrow_highest
    )


def strip_flexibility(disk: FreeDisk, size: float) -> np.ndarray:
    """Return F(s) (3, 3) [m/N] and the contribution of the highest polynomials to it.

    F(s) is the mean displacement of a strip of the lateral surface, with length and
    height `size` [m] from the bottom edge, under a unit force spread evenly over it,
    without rigid-body motion.
    """
    half = size / (2 * disk.plate.radius)
    through = {
        even: legendre_means(disk.axial_count, even, 2 * size / disk.plate.thickness)
        for even in (1, -1)
    }
    result = np.zeros((2, 3, 3))
    for (n, even, _), order in disk.solved_orders.items():
        elastic = order.values > 0
        kept = (order.shapes[:, elastic] / order.values[elastic]) @ order.shapes[
            :, elastic
        ].T
        result += np.sinc(n * half / pi) ** 2 * flexibility_of_strip_means(
            through[even],
            order.omitted_flexibility[[0, 2]] + [kept, 0 * kept],
        )
    for even, (orders, rest) in disk.interpolated_orders.items():
        last = orders[-1]
        far = np.arange(last + 1, last + 30 / half)
        local = flexibility_of_strip_means(through[even], rest[:, [0, 2]])
        share = np.sinc(orders * half / pi) ** 2
        far_share = (np.sinc(far * half / pi) ** 2 * last / far).sum()
        result += np.tensordot(share, local, 1) + far_share * local[-1]
    # radial and axial motion: cosine modes; tangential motion: sine partners
    same_parity = np.array([[1, 0, 1], [0, 1, 0], [1, 0, 1]])
    return result * same_parity


def legendre_means(count: int, even: int, height: float) -> np.ndarray:
    """Return the means (3, count) over [-1, height - 1] of the Legendre polynomials of
    u_r, u_theta, u_z."""
    is_odd = np.array([even < 0, even < 0, even > 0])
    degree = 2 * np.arange(count) + is_odd[:, None]
    next_value = eval_legendre(degree + 1, height - 1.0) - (-1.0) ** (degree + 1)
    previous_degree = np.abs(degree - 1)
    previous_value = (
        eval_legendre(previous_degree, height - 1.0) - (-1.0) ** previous_degree
    )
    return (
        (next_value - np.where(degree, previous_value, 0)) / (2 * degree + 1) / height
    )


def flexibility_of_strip_means(through: np.ndarray, nodal: np.ndarray) -> np.ndarray:
    """Return the flexibility (..., 3, 3) of mean strip displacements.

    `nodal` (..., 3 nz, 3 nz) is the flexibility of the polynomial coefficients, and
    `through` (3, nz) contains the strip means of the polynomials.
    """
    count = through.shape[1]
    parts = nodal.reshape(*nodal.shape[:-2], 3, count, 3, count)
    return np.einsum("ca,...cadb,db->...cd", through, parts, through)
