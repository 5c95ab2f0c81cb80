"""Errors of the modes of a divided mesh, estimated part by part from the difference to the mesh as
given.

The eigenvalue of a mesh exceeds the true one by the elastic energy of the error of its shape
(Strang & Fix, An Analysis of the Finite Element Method, 6.3). Division of the cells divides that
energy by four (thin cells) to sixteen where the body is smooth. Near the edge where a held face
ends, or near a re-entrant edge, it divides it by two to three (Williams 1952: u ~ r^s, s from 0.54
to 0.75).
"""

import numpy as np
import scipy.sparse as sp

from modal.elements.elastic import inverse_at

CORNER_ERROR_RATIO = 0.7
"""Remaining over removed error energy near the edge of a held face at a corner: division divides it
by 2.4."""
FLAT_FACE_ERROR_RATIO = 1.0
"""The same if the held facets end within a flat face, where u ~ r^(1/2): division divides it by
2."""


def relative_errors(
    mesh,
    facets,
    fine,
    coarse,
    part_nodes,
    values,
    shapes,
    shift,
    edge_error_ratio,
    smooth_error_ratio=1 / 4,
    safety=1.5,
):
    """Return estimated relative errors (k,) of the frequencies of pairs values (k,), shapes (k, p,
    3).

    The pairs are those of the `DiscreteBody` fine; coarse is the `DiscreteBody` of the mesh as
    given, or of linear elements on it. part_nodes (q, 3, n) are the nodes of the fine cells in
    their coarse cell. `edge_error_ratio` is CORNER_ERROR_RATIO or FLAT_FACE_ERROR_RATIO,
    `smooth_error_ratio` the same ratio elsewhere, where division divides the error energy by 5.
    `safety` multiplies the estimate.
    """
    from_coarse = prolongation(fine.solid, coarse, part_nodes)[:, np.repeat(~coarse.held, 3)]
    node_count = len(fine.solid.points)
    fine_shapes = shapes.reshape(len(values), 3 * node_count).T
    stiffness = fine.solid.stiffness - shift * fine.solid.mass
    coarse_inverse = inverse_at(from_coarse.T @ stiffness @ from_coarse, None, 0.0)
    on_coarse = coarse_inverse.matmat(from_coarse.T @ (stiffness @ fine_shapes))
    error = fine_shapes - from_coarse @ on_coarse
    energy = (error * (stiffness @ error)).reshape(node_count, 3, len(values)).sum(axis=1)
    cells = fine.solid.cells.reshape(len(part_nodes), mesh.nelements, -1)
    near_edges = np.unique(cells[:, singular_cells(mesh, facets)])
    singular_energy = np.abs(energy[near_edges].sum(axis=0))
    smooth_energy = np.abs(energy.sum(axis=0) - energy[near_edges].sum(axis=0))
    remaining_energy = edge_error_ratio * singular_energy + smooth_error_ratio * smooth_energy
    return safety * remaining_energy / (2 * values)


def prolongation(fine_solid, coarse, part_nodes):
    """Return P (3p, 3c), which interpolates displacements of the `DiscreteBody` coarse at the nodes
    of a fine `Solid`.

    part_nodes (q, 3, n) are the nodes of the fine cells in their coarse cell.
    """
    element = coarse.element
    nodes = coarse.solid.cells
    count = nodes.shape[1]
    cells = fine_solid.cells.reshape(len(part_nodes), len(nodes), -1)
    weights = [[element.lbasis(x, i)[0] for i in range(count)] for x in part_nodes]
    weights = np.array(weights).transpose(0, 2, 1)
    shape = (*cells.shape, count)
    row = np.broadcast_to(cells[..., None], shape)
    column = np.broadcast_to(nodes[:, None], shape)
    cells_at_node = np.bincount(fine_solid.cells.ravel())[row]
    value = np.broadcast_to(weights[:, None], shape) / cells_at_node  # cells agree at shared nodes
    size = len(fine_solid.points), len(coarse.solid.points)
    scalar = sp.csr_matrix((value.ravel(), (row.ravel(), column.ravel())), shape=size)
    return sp.kron(scalar, sp.identity(3)).tocsr()


def singular_cells(mesh, facets, max_convex_angle_deg=225):
    """Return the mask (c,) of the cells that touch an edge of the held facets or a re-entrant edge.

    An edge is re-entrant if the body fills more than `max_convex_angle_deg` around it; less may be
    a facet of a round surface.
    """
    outside = mesh.boundary_facets()
    held_edges = mesh.f2e[:, np.intersect1d(outside, facets)]
    other_edges = mesh.f2e[:, np.setdiff1d(outside, facets)]
    ends = np.intersect1d(held_edges, other_edges)
    wide_edges = np.flatnonzero(angles_about_edges(mesh) > np.deg2rad(max_convex_angle_deg))
    re_entrant = np.intersect1d(wide_edges, mesh.f2e[:, outside])
    touched = np.unique(mesh.edges[:, np.concatenate([ends, re_entrant]).astype(int)])
    return np.isin(mesh.t, touched).any(axis=0)


def angles_about_edges(mesh):
    """Return the angles (e,) [rad] that the cells fill around the edges of a mesh."""
    cell = mesh.elem.refdom
    total = np.zeros(mesh.edges.shape[1])
    for number, (a, b) in enumerate(cell.edges):
        origin = mesh.p[:, mesh.t[a]]
        along = mesh.p[:, mesh.t[b]] - origin
        along /= np.linalg.norm(along, axis=0)
        across = []
        for side in cell.facets:
            if {a, b} <= set(side):
                vector = mesh.p[:, mesh.t[neighbouring_corner(cell, side, a, b)]] - origin
                across.append(vector - along * (vector * along).sum(axis=0))
        sine = np.linalg.norm(np.cross(*across, axis=0), axis=0)
        cosine = (across[0] * across[1]).sum(axis=0)
        total += np.bincount(mesh.t2e[number], np.arctan2(sine, cosine), len(total))
    return total


def neighbouring_corner(cell, side, a, b):
    """Return the corner of a side of the cell, other than b, that an edge joins to its corner a."""
    return next(c for c in side if c != b and ([a, c] in cell.edges or [c, a] in cell.edges))
