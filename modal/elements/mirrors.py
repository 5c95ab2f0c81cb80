"""The symmetry classes of a body meshed elsewhere whose mesh is its own image in x or in y, as found."""

import numpy as np
import scipy.sparse as sp
from scipy.spatial import cKDTree

SAME = 1e-9
"""Nodes and matrices are images of each other within this share of the size and of the greatest entry."""


def mirrors(level):
    """The mirrors of a `Level`: pairs of the images (p,) of its nodes and the swap (3p, 3p) of its displacements.

    Nodes, held ones and stiffness must be the same behind the mirror, which stands in the middle of x or y.
    """
    points, k, found = level.solid.points, level.solid.stiffness, []
    tree, size = cKDTree(points), np.ptp(points, axis=0).max()
    for axis in (0, 1):
        behind = points.copy()
        behind[:, axis] = points[:, axis].min() + points[:, axis].max() - points[:, axis]
        far, image = tree.query(behind)
        if far.max() > SAME * size or (level.held[image] != level.held).any():
            continue
        sign = np.tile(np.where(np.arange(3) == axis, -1.0, 1.0), len(points))
        swap = sp.csr_matrix((sign, (3 * image[:, None] + np.arange(3)).ravel(), np.arange(len(sign) + 1)))
        if abs(swap @ k @ swap.T - k).max() < SAME * abs(k).max():
            found.append((image, swap))
    return found


def classes(level, free):
    """Orthonormal bases of the symmetry classes that the columns of free (3p, n), each of one node, fall into."""
    bases, least = [free.tocsc()], np.arange(len(level.solid.points))
    for image, swap in mirrors(level):
        bases = [b[:, least[first_nodes(b)] <= least[image[first_nodes(b)]]] for b in bases]
        bases = [without_zeros(b + sign * (swap @ b)) for b in bases for sign in (1, -1)]
        least = np.minimum(least, least[image])
    return bases


def first_nodes(columns):
    """The first node (n,) of every column of a matrix (3p, n)."""
    columns.sort_indices()
    return columns.indices[columns.indptr[:-1]] // 3


def without_zeros(columns):
    """The columns that are not zero, with length 1."""
    columns = columns.tocsc()
    length = np.sqrt(np.asarray(columns.multiply(columns).sum(axis=0)).ravel())
    kept = (columns @ sp.diags(1 / np.maximum(length, SAME)))[:, length > SAME].tocsc()
    kept.eliminate_zeros()
    return kept
