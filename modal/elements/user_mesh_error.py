"""Estimate the errors of modes on a refined user mesh by comparison with the original
mesh.

A computed eigenvalue exceeds the exact one by the elastic energy of the error of its
shape (Strang & Fix, An Analysis of the Finite Element Method, 6.3). Refinement reduces
this energy by a factor of four (thin cells) to sixteen in smooth regions, but only by
two to three near the boundary of a held face and near a re-entrant edge (Williams 1952:
u ~ r^s, s from 0.54 to 0.75).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import scipy.sparse as sp

from modal.elements.elastic import Solid, inverse_at

if TYPE_CHECKING:
    from skfem import Mesh
    from skfem.refdom import Refdom

    from modal.elements.user_mesh import DiscreteBody

CORNER_EXTRAPOLATION_FACTOR = 0.7
"""Ratio of remaining to removed error energy where a held face ends at a corner of the
body.

Refinement reduces the energy by a factor of 2.4.
"""
FLAT_FACE_EXTRAPOLATION_FACTOR = 1.0
"""Ratio of remaining to removed error energy where the held facets end within a flat
face.

There the displacement is u ~ r^(1/2), and refinement reduces the energy by a factor of
2.
"""


def relative_errors(
    mesh: "Mesh",
    facets: np.ndarray,
    fine: "DiscreteBody",
    coarse: "DiscreteBody",
    part_nodes: Sequence[np.ndarray],
    eigenpairs: tuple[np.ndarray, np.ndarray],
    shift: float,
    edge_error_ratio: float,
) -> np.ndarray:
    """Estimate the relative errors (k,) of the frequencies of a `DiscreteBody`.

    Parameters
    ----------
    mesh : skfem.Mesh
        The original mesh.
    facets : ndarray of int, shape (f,)
        Held facets.
    fine, coarse : DiscreteBody
        The solved body, and the body on the coarser mesh or with linear elements.
    part_nodes : ndarray, shape (q, 3, n)
        Nodes of the fine cells in reference coordinates of their coarse cell.
    eigenpairs : pair of ndarrays, shapes (k,) and (k, p, 3)
        Eigenvalues [1/s^2] and shapes of the fine body.
    shift : float
        Shift of the eigenvalue problem [1/s^2].
    edge_error_ratio : float
        Ratio of remaining to removed error energy at singular edges
        (CORNER_EXTRAPOLATION_FACTOR or FLAT_FACE_EXTRAPOLATION_FACTOR).
    """
    smooth_error_ratio = (
        1 / 4
    )  # elsewhere; refinement reduces the energy by a factor of 5
    safety = 1.5
    values, shapes = eigenpairs
    from_coarse = prolongation(fine.solid, coarse, part_nodes)[
        :, np.repeat(~coarse.held, 3)
    ]
    node_count = len(fine.solid.points)
    fine_shapes = shapes.reshape(len(values), 3 * node_count).T
    stiffness = fine.solid.stiffness - shift * fine.solid.mass
    coarse_inverse = inverse_at(from_coarse.T @ stiffness @ from_coarse, None, 0.0)
    on_coarse = coarse_inverse.matmat(from_coarse.T @ (stiffness @ fine_shapes))
    error = fine_shapes - from_coarse @ on_coarse
    energy = (
        (error * (stiffness @ error)).reshape(node_count, 3, len(values)).sum(axis=1)
    )
    cells = fine.solid.cells.reshape(len(part_nodes), mesh.nelements, -1)
    near_edges = np.unique(cells[:, singular_cells(mesh, facets)])
    singular_energy = np.abs(energy[near_edges].sum(axis=0))
    smooth_energy = np.abs(energy.sum(axis=0) - energy[near_edges].sum(axis=0))
    remaining_energy = (
        edge_error_ratio * singular_energy + smooth_error_ratio * smooth_energy
    )
    return safety * remaining_energy / (2 * values)


def prolongation(
    fine_solid: Solid, coarse: "DiscreteBody", part_nodes: Sequence[np.ndarray]
) -> sp.csr_matrix:
    """Return the matrix (3p, 3c) that interpolates displacements of a coarse body at
    the nodes of a fine solid.

    `part_nodes` (q, 3, n) are the nodes of the fine cells in reference coordinates of
    their coarse cell.
    """
    element = coarse.element
    nodes = coarse.solid.cells
    count = nodes.shape[1]
    cells = fine_solid.cells.reshape(len(part_nodes), len(nodes), -1)
    values = [[element.lbasis(x, i)[0] for i in range(count)] for x in part_nodes]
    weights = np.array(values).transpose(0, 2, 1)
    shape = (*cells.shape, count)
    row = np.broadcast_to(cells[..., None], shape)
    column = np.broadcast_to(nodes[:, None], shape)
    cells_at_node = np.bincount(fine_solid.cells.ravel())[row]
    # the values of all cells at a node agree, so their mean is the value
    value = np.broadcast_to(weights[:, None], shape) / cells_at_node
    size = len(fine_solid.points), len(coarse.solid.points)
    scalar = sp.csr_matrix((value.ravel(), (row.ravel(), column.ravel())), shape=size)
    return sp.kron(scalar, sp.identity(3)).tocsr()


def singular_cells(mesh: "Mesh", facets: np.ndarray) -> np.ndarray:
    """Return the mask (c,) of cells that touch the boundary of the held facets or a
    re-entrant edge.

    An edge is re-entrant if the angle of the body around it is well above 180 degrees;
    smaller angles also occur on the facets of a round surface.
    """
    max_convex_angle_deg = 225
    outside = mesh.boundary_facets()
    held_edges = mesh.f2e[:, np.intersect1d(outside, facets)]
    other_edges = mesh.f2e[:, np.setdiff1d(outside, facets)]
    ends = np.intersect1d(held_edges, other_edges)
    wide_edges = np.flatnonzero(
        angles_about_edges(mesh) > np.deg2rad(max_convex_angle_deg)
    )
    re_entrant = np.intersect1d(wide_edges, mesh.f2e[:, outside])
    touched = np.unique(mesh.edges[:, np.concatenate([ends, re_entrant]).astype(int)])
    return np.asarray(np.isin(mesh.t, touched).any(axis=0))


def angles_about_edges(mesh: "Mesh") -> np.ndarray:
    """Return the angles (e,) [rad] occupied by cells around the edges of a mesh."""
    cell = mesh.elem.refdom
    total = np.zeros(mesh.edges.shape[1])
    for number, (a, b) in enumerate(cell.edges):
        origin = mesh.p[:, mesh.t[a]]
        along = mesh.p[:, mesh.t[b]] - origin
        along /= np.linalg.norm(along, axis=0)
        across = []
        for side in cell.facets:
            if {a, b} <= set(side):
                vector = (
                    mesh.p[:, mesh.t[other_adjacent_corner(cell, side, a, b)]] - origin
                )
                across.append(vector - along * (vector * along).sum(axis=0))
        sine = np.linalg.norm(np.cross(across[0], across[1], axis=0), axis=0)
        cosine = (across[0] * across[1]).sum(axis=0)
        total += np.bincount(mesh.t2e[number], np.arctan2(sine, cosine), len(total))
    return total


def other_adjacent_corner(
    cell: "type[Refdom]", side: Sequence[int], a: int, b: int
) -> int:
    """Return the corner of a side of the cell, other than b, that shares an edge with
    corner a."""
    return next(
        c for c in side if c != b and ([a, c] in cell.edges or [c, a] in cell.edges)
    )
