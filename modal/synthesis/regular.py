"""What a free disk yields as a body where a force acts on its edge, less what it yields next to the force.

Under a force that is spread over a strip of the edge, s long and s high, a disk yields F(s) = a/s + F0 + small terms.
The part a/s is that of the material next to the force, which Hertz's springs have; F0 is that of the body. What the
shape of a fillet of radius s adds is of the order (1 - nu^2)/(2 pi E s), an eighth of F0 for the toy, and is left out.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np
from scipy.special import eval_legendre

from modal.one_thread import one_blas_thread
from modal.spectral.basis import Plate
from modal.synthesis.patches import FreeDisk

DOUBT = 2
"""What a basis lacks over what its highest polynomials contribute, at most: tests/test_modal_contact.py."""
RESOLVED = 1 / 8
"""Least height of a strip that the polynomials through the thickness resolve, over the thickness: F0 is found there."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Edge:
    """What a free disk yields as a body at its bottom edge, in its own frame: along radius, rim and axis.

    `flexibility` (3, 3) [m/N] of all its elastic modes at rest; of the lowest m of them `squared` (m,) [1/s^2], their
    angular frequencies, `shapes` (m, 3) [kg^-1/2], their motion there at unit modal mass, and `order` (m,), their waves
    round the rim.
    """

    flexibility: np.ndarray
    squared: np.ndarray
    shapes: np.ndarray
    order: np.ndarray


def yielding_edge(plate: Plate) -> Edge:
    """Return the `Edge` of a solid free disk, the same one whenever asked; tests/test_contact_edge.py."""
    return _edge_of(plate)


@lru_cache(maxsize=32)
@one_blas_thread
def _edge_of(plate):
    disk, size = FreeDisk(plate=plate), RESOLVED * plate.thickness
    orders = [(n, even, order) for (n, even, _), order in disk.kept.items()]
    squared = np.concatenate([order.values for _, _, order in orders])
    shapes = np.concatenate([at_edge(disk, size, n, even, order.shapes) for n, even, order in orders])
    apart = shapes[:, None] * np.array([[1, 0, 1], [0, 1, 0]])  # of a pair one moves radius and axis, one the rim
    around = np.concatenate([np.full(len(order.values), n) for n, _, order in orders])
    elastic = squared > 0
    return Edge(
        flexibility=regular_flexibility(disk, size)[0],
        squared=np.repeat(squared[elastic], 2),
        shapes=apart[elastic].reshape(-1, 3),
        order=np.repeat(around[elastic], 2),
    )


def at_edge(disk, size, n, even, shapes):
    """Means (k, 3) over a strip of the shapes (3 nz, k) of an order n."""
    through = through_strip(disk.nz, even, size / disk.plate.thickness * 2)
    return np.sinc(n * size / (2 * pi * disk.plate.radius)) * np.einsum(
        "ca,cak->kc", through, shapes.reshape(3, disk.nz, -1)
    )


def regular_flexibility(disk: FreeDisk, size: float):
    """F0 (3, 3) [m/N] along radius, rim and axis of the bottom edge, and how much of its
    diagonal is in doubt (3,) [m/N].

    It is 2 F(2 s) - F(s) for s = size [m].
    """
    (wide, more), (narrow, less) = flexibility(disk, 2 * size), flexibility(disk, size)
    return 2 * wide - narrow, DOUBT * np.diag(2 * more + less)


def flexibility(disk: FreeDisk, size: float):
    """F(s) (3, 3) [m/N]: mean displacement of a strip of the lateral surface, size [m] along the rim and up from the
    bottom edge, under a force spread evenly over it, the rigid disk held; and what the highest polynomials contribute.
    """
    half, result = size / (2 * disk.plate.radius), np.zeros((2, 3, 3))
    along = {even: through_strip(disk.nz, even, 2 * size / disk.plate.thickness) for even in (1, -1)}
    for (n, even, _), order in disk.kept.items():
        elastic = order.values > 0
        kept = (order.shapes[:, elastic] / order.values[elastic]) @ order.shapes[:, elastic].T
        result += np.sinc(n * half / pi) ** 2 * at_strip(along[even], order.rest[[0, 2]] + [kept, 0 * kept])
    for even, (n, rest) in disk.high.items():
        far = np.arange(n[-1] + 1, n[-1] + 30 / half)
        local, share = at_strip(along[even], rest[:, [0, 2]]), np.sinc(n * half / pi) ** 2
        result += np.tensordot(share, local, 1) + (np.sinc(far * half / pi) ** 2 * n[-1] / far).sum() * local[-1]
    return result * TOGETHER


TOGETHER = np.array([[1, 0, 1], [0, 1, 0], [1, 0, 1]])
"""Radial and axial forces move cosines, tangential ones their sine partners."""


def through_strip(nz, even, part):
    """Means (3, nz) of the Legendre polynomials of radial, tangential, axial displacement over [-1, part - 1]."""
    degree = 2 * np.arange(nz) + np.array([even < 0, even < 0, even > 0])[:, None]
    above, below = (eval_legendre(k, part - 1.0) - (-1.0) ** k for k in (degree + 1, np.abs(degree - 1)))
    return (above - np.where(degree, below, 0)) / (2 * degree + 1) / part


def at_strip(through, nodal):
    """Flexibilities (..., 3, 3) between the means of a strip, from those (..., 3 nz, 3 nz) between coefficients."""
    parts = nodal.reshape(*nodal.shape[:-2], 3, through.shape[1], 3, through.shape[1])
    return np.einsum("ca,...cadb,db->...cd", through, parts, through)
