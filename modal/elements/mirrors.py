"""Find the symmetry classes of a body on a mirror-symmetric user mesh."""

from typing import TYPE_CHECKING

import numpy as np
import scipy.sparse as sp
from scipy.spatial import cKDTree

if TYPE_CHECKING:
    from modal.elements.user_mesh import DiscreteBody

MIRROR_TOLERANCE = 1e-9
"""Tolerance of mirror symmetry.

It applies to differences between mirrored nodes, relative to the size of the body, and
between mirrored matrices, relative to the largest entry.
"""


def mirror_symmetries(body: "DiscreteBody") -> list[tuple[np.ndarray, sp.csr_matrix]]:
    """Return the mirror symmetries of a `DiscreteBody` about its mid-planes in x and y.

    Each symmetry is a pair of the image (p,) of every node and the matrix (3p, 3p) that
    mirrors displacements. The nodes, the held nodes and the stiffness must be
    symmetric.
    """
    points = body.solid.points
    k = body.solid.stiffness
    tree = cKDTree(points)
    size = np.ptp(points, axis=0).max()
    found = []
    for axis in (0, 1):
        mirrored = points.copy()
        mirrored[:, axis] = (
            points[:, axis].min() + points[:, axis].max() - points[:, axis]
        )
        distance, image = tree.query(mirrored)
        if (
            distance.max() > MIRROR_TOLERANCE * size
            or (body.held[image] != body.held).any()
        ):
            continue
        sign = np.tile(np.where(np.arange(3) == axis, -1.0, 1.0), len(points))
        columns = (3 * image[:, None] + np.arange(3)).ravel()
        mirror = sp.csr_matrix((sign, columns, np.arange(len(sign) + 1)))
        if abs(mirror @ k @ mirror.T - k).max() < MIRROR_TOLERANCE * abs(k).max():
            found.append((image, mirror))
    return found


def symmetry_bases(body: "DiscreteBody", free: sp.spmatrix) -> list[sp.csc_matrix]:
    """Return orthonormal bases of the symmetry classes of the space spanned by the
    columns of `free`.

    Each column of `free` (3p, n) belongs to one node."""
    bases = [free.tocsc()]
    representative = np.arange(len(body.solid.points))
    for image, mirror in mirror_symmetries(body):
        halves = []
        for basis in bases:
            node = node_of_each_column(basis)
            halves.append(basis[:, representative[node] <= representative[image[node]]])
        bases = []
        for half in halves:
            for sign in (1, -1):
                bases.append(normalised_columns(half + sign * (mirror @ half)))
        representative = np.minimum(representative, representative[image])
    return bases


def node_of_each_column(columns: sp.csc_matrix) -> np.ndarray:
    """Return the node (n,) of the first nonzero row in each column of a matrix
    (3p, n)."""
    columns.sort_indices()
    return columns.indices[columns.indptr[:-1]] // 3


def normalised_columns(columns: sp.spmatrix) -> sp.csc_matrix:
    """Return the nonzero columns, normalised to unit length."""
    columns = columns.tocsc()
    length = np.sqrt(np.asarray(columns.multiply(columns).sum(axis=0)).ravel())
    scale = sp.diags(1 / np.maximum(length, MIRROR_TOLERANCE))
    kept = (columns @ scale)[:, length > MIRROR_TOLERANCE].tocsc()
    kept.eliminate_zeros()
    return kept
