"""The record of modes on fixed grids of the rim and the faces, and finite-element fields there as sparse matrices."""

import numpy as np
import scipy.sparse as sp

from modal.modes import Body, Modes

RIM_ANGLES = 128
FACE_RADII, FACE_ANGLES = 16, 64


def rim_angles():
    """Even angles (k,) [rad] of `Modes.rim_shape`."""
    return np.arange(RIM_ANGLES) * 2 * np.pi / RIM_ANGLES


def face_grid(radius, inner=0.0):
    """Gauss radii [m] and weights [m^2] for int f r dr, and even angles: the grid of `Modes.face_shape`."""
    node, weight = np.polynomial.legendre.leggauss(FACE_RADII)
    r = (radius + inner) / 2 + node * (radius - inner) / 2
    return r, weight * (radius - inner) / 2 * r, np.arange(FACE_ANGLES) * 2 * np.pi / FACE_ANGLES


def places(radius):
    """Points (n, 2) [m] of these grids: of the rim, and (a b, 2) of a face without a hole."""
    angle, (r, _, theta) = rim_angles(), face_grid(radius)
    face = np.stack([np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))], axis=-1)
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1), face.reshape(-1, 2)


def partners(pair):
    """Index (m,) of the mode with the same entry of pair (m,), -1 if there is none."""
    same = pair[:, None] == pair[None, :]
    np.fill_diagonal(same, False)
    return np.where(same.any(axis=1), same @ np.arange(len(pair)), -1)


def recorded(columns, material, radius, points, cells, inner=0.0, cell_type="hexahedron27", **about) -> Modes:
    """The `Modes` of columns (m, ...) by name, ascending, sampled on the grids of a disk of a radius and a hole [m].

    The columns are the fields of `Modes` but for the decay rate, with `displacement` (m, p, 3) of the nodes, and in
    place of `partner`, where there are degenerate pairs, the number `pair` of each.
    """
    ascending = np.lexsort((columns["parity"] == "odd", columns["frequency"]))
    columns = {name: np.asarray(value)[ascending] for name, value in columns.items()}
    words = {name: tuple(columns.pop(name).tolist()) for name in ("family", "parity")}
    displacement, (r, weight, angle) = columns.pop("displacement"), face_grid(radius, inner)
    return Modes(
        partner=partners(columns.pop("pair", np.arange(len(ascending)))),
        **columns,
        **words,
        decay_rate=np.pi * columns["frequency"] * material.loss_factor,
        rim_angle=rim_angles(),
        face_radius=r,
        face_weight=weight,
        face_angle=angle,
        body=Body(points=points, cells=cells, cell_type=cell_type, displacement=displacement),
        **about,
    )


def quadratic(x):
    """The three Lagrange polynomials (..., 3) of the nodes 0, 1/2, 1."""
    return np.stack([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)], axis=-1)


def slope(x):
    """Their derivatives (..., 3)."""
    return np.stack([4 * x - 3, 4 - 8 * x, 4 * x - 1], axis=-1)


NEAR, ASTRAY = 6, 1e-9
"""Cells in which a point is first sought, those whose middles are nearest; and how far from it, over the size of the
cell, it may be found there before it is sought in every cell."""


def locate(points, cells):
    """The biquadratic cell (q, 3, 3, 2) that holds each point (n, 2), and the point's place (u, v) in its unit square.

    A point outside every cell, beyond an approximated arc, is moved to the nearest place of one.
    """
    gap = np.linalg.norm(points[:, None] - cells[None, :, 1, 1], axis=2)
    size = np.linalg.norm(cells[:, 2, 2] - cells[:, 0, 0], axis=1)
    order = np.argsort(gap / size, axis=1)
    cell, place, miss = nearest(points, cells, order[:, :NEAR])
    astray = miss > ASTRAY * size[cell]
    cell[astray], place[astray], _ = nearest(points[astray], cells, order[astray])
    return cell, place


def nearest(points, cells, candidates):
    """Of the candidates (n, c) the cell (n,) with the place (n, 2) nearest to each point (n, 2), and its distance (n,).

    Newton's method in every candidate, its answer taken back into the unit square.
    """
    nodes = cells[candidates]
    place = np.full((*candidates.shape, 2), 0.5)
    for _ in range(7):
        image, jacobian = mapped(nodes, place)
        step = np.linalg.solve(jacobian + 1e-300 * np.eye(2), (points[:, None] - image)[..., None])[..., 0]
        place = np.clip(place + step, -0.5, 1.5)
    place = np.clip(place, 0, 1)
    miss = np.linalg.norm(mapped(nodes, place)[0] - points[:, None], axis=2)
    rows, best = np.arange(len(points)), miss.argmin(axis=1)
    return candidates[rows, best], place[rows, best], miss[rows, best]


def mapped(nodes, place):
    """Images (n, c, 2) of places (n, c, 2) in cells of nodes (n, c, 3, 3, 2), and the Jacobians (n, c, 2, 2)."""
    u, v = place[..., 0], place[..., 1]
    image = np.einsum("nci,ncj,ncijx->ncx", quadratic(u), quadratic(v), nodes)
    along = np.einsum("nci,ncj,ncijx->ncx", slope(u), quadratic(v), nodes)
    across = np.einsum("nci,ncj,ncijx->ncx", quadratic(u), slope(v), nodes)
    return image, np.stack([along, across], axis=-1)


def interpolation(points, cells, numbers, count):
    """Sparse (n, count): values at points (n, 2) from nodal values; numbers (q, 3, 3) are the nodes of the cells."""
    cell, place = locate(points, cells)
    weight = quadratic(place[:, 0])[:, :, None] * quadratic(place[:, 1])[:, None, :]
    rows = np.repeat(np.arange(len(points)), 9)
    return sp.csr_matrix((weight.ravel(), (rows, numbers[cell].ravel())), shape=(len(points), count))


def polar_components(shape, angle):
    """Radial, tangential, axial (..., k, 3) from Cartesian displacements at angles (k,)."""
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = np.moveaxis(shape, -1, 0)
    return np.stack([c * x + s * y, c * y - s * x, z], axis=-1)


def strongest_order(rim_shape):
    """The circumferential order (m,) with the largest share of the rim's motion (m, k, 3)."""
    power = (np.abs(np.fft.rfft(rim_shape, axis=1)) ** 2).sum(axis=2)
    power[:, 0] /= 2
    return power.argmax(axis=1)
