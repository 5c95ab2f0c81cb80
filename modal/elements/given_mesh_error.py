"""How wrong the modes of a mesh are that was cut in eight: what the mesh as given could not do, part by part.

The eigenvalue of a mesh exceeds the true one by the elastic energy of the error of its shape (Strang & Fix, An
Analysis of the Finite Element Method, 6.3). A cut divides that energy by four (thin cells) to sixteen where the
body is smooth; beside an edge where a held face ends, or which is re-entrant, by two to three (Williams 1952: u ~ r^s,
s from 0.54 to 0.75).
"""

import numpy as np
import scipy.sparse as sp

from modal.elements.elastic import inverse_at

SMOOTH, CORNER, LEVEL = 1 / 4, 0.7, 1.0
"""Of the energy that a cut has taken, what is still to be taken: it divides it by 5, beside the edge of a corner by
2.4, and where what is held ends on a level face, u ~ r^(1/2), by 2."""
SAFETY = 1.5
"""Errors are estimated as so many times what is left."""
FLAT = np.deg2rad(225)
"""Angle of the body about an edge from which it is re-entrant, and not a facet of something round."""


def relative_errors(mesh, facets, finer, coarse, places, values, shapes, shift, ends):
    """Estimated relative errors (k,) of the frequencies of pairs values (k,), shapes (k, p, 3) on the `Level` finer.

    coarse is the `Level` of the mesh as given, or of linear elements on it; places (q, 3, n) are those of the nodes of
    finer cells in its cells. Held facets end at a CORNER or on a LEVEL face: `ends` says which.
    """
    taken = prolongation(finer.solid, coarse, places)[:, np.repeat(~coarse.held, 3)]
    fine = shapes.reshape(len(values), 3 * len(finer.solid.points)).T
    stiffness = finer.solid.stiffness - shift * finer.solid.mass
    on_coarse = inverse_at(taken.T @ stiffness @ taken, None, 0.0).matmat(taken.T @ (stiffness @ fine))
    error = fine - taken @ on_coarse
    energy = (error * (stiffness @ error)).reshape(len(finer.solid.points), 3, len(values)).sum(axis=1)
    cells = finer.solid.cells.reshape(len(places), mesh.nelements, -1)
    beside = np.unique(cells[:, singular_cells(mesh, facets)])
    edges = np.abs(energy[beside].sum(axis=0))
    smooth = np.abs(energy.sum(axis=0) - energy[beside].sum(axis=0))
    return SAFETY * (ends * edges + SMOOTH * smooth) / (2 * values)


def prolongation(finer, coarse, places):
    """P (3p, 3c): the values at the nodes of the `Solid` finer of what is given at those of the `Level` coarse."""
    element, nodes = coarse.element, coarse.solid.cells
    cells = finer.cells.reshape(len(places), len(nodes), -1)
    share = np.array([[element.lbasis(x, i)[0] for i in range(nodes.shape[1])] for x in places]).transpose(0, 2, 1)
    shape = (*cells.shape, nodes.shape[1])
    row, column = np.broadcast_to(cells[..., None], shape), np.broadcast_to(nodes[:, None], shape)
    value = np.broadcast_to(share[:, None], shape) / np.bincount(finer.cells.ravel())[row]  # cells agree on their nodes
    size = len(finer.points), len(coarse.solid.points)
    summed = sp.csr_matrix((value.ravel(), (row.ravel(), column.ravel())), shape=size)
    return sp.kron(summed, sp.identity(3)).tocsr()


def singular_cells(mesh, facets):
    """Which cells (c,) touch an edge where held facets end, or about which the body takes more than FLAT."""
    outside = mesh.boundary_facets()
    ends = np.intersect1d(mesh.f2e[:, np.intersect1d(outside, facets)], mesh.f2e[:, np.setdiff1d(outside, facets)])
    inwards = np.intersect1d(np.flatnonzero(angles_about_edges(mesh) > FLAT), mesh.f2e[:, outside])
    touched = np.unique(mesh.edges[:, np.concatenate([ends, inwards]).astype(int)])
    return np.isin(mesh.t, touched).any(axis=0)


def angles_about_edges(mesh):
    """The angle [rad] that the cells about every edge (e,) of the mesh take together."""
    cell, total = mesh.elem.refdom, np.zeros(mesh.edges.shape[1])
    for number, (a, b) in enumerate(cell.edges):
        origin = mesh.p[:, mesh.t[a]]
        along = mesh.p[:, mesh.t[b]] - origin
        along /= np.linalg.norm(along, axis=0)
        thirds = [next(third_corners(cell, side, a, b)) for side in cell.facets if {a, b} <= set(side)]
        across = [mesh.p[:, mesh.t[c]] - origin for c in thirds]
        across = [v - along * (v * along).sum(axis=0) for v in across]
        sine, cosine = np.linalg.norm(np.cross(*across, axis=0), axis=0), (across[0] * across[1]).sum(axis=0)
        total += np.bincount(mesh.t2e[number], np.arctan2(sine, cosine), len(total))
    return total


def third_corners(cell, side, a, b):
    """The corners of a side of the cell that an edge joins to its corner a, but b."""
    return (c for c in side if c != b and ([a, c] in cell.edges or [c, a] in cell.edges))
