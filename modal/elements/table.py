"""Modes of a table meshed elsewhere: held on named surfaces or sets of nodes, its top face found and checked."""

from math import ceil, pi
from types import SimpleNamespace

import numpy as np
from skfem.quadrature import get_quadrature
from skfem.refdom import RefTri

from modal.elements.elastic import bending_number
from modal.elements.given_mesh import solved
from modal.elements.given_mesh_error import CORNER
from modal.elements.given_mesh_modes import on_face
from modal.mesh.read import read_checked
from modal.mesh.symmetry import COMPONENTS
from modal.radiation import SOUND_SPEED
from modal.table import SurfaceModes, spline_values, splined

LEVEL = 1e-6
"""Facets of the top face lie at the greatest height within this share of the size of the mesh."""
HIGHEST_ORDER, SPARE_ORDERS = 19, 6
"""Of the polynomials that are integrated exactly on a triangle; beyond the phase of a sound wave across it [rad]."""


def table_on_mesh(surface, reach, below, most) -> SurfaceModes:
    """The `SurfaceModes` below `below` [Hz] of the mesh in `surface.file`; the contact circle has the radius `reach`.

    It is `solved` with at most `most` unknowns in a symmetry class, its `error` far too large where cells are not cut.
    ValueError, with a sentence, for a mesh without a top face, for a place of the disk that is not on it, and for sets
    that it has not or that hold single nodes alone.
    """
    mesh, sets = read_checked(surface.file)
    top = top_triangles(mesh, surface.file)
    check_place(top, np.array(surface.place), reach, surface.file)
    facets = held_facets(mesh, sets, surface.held, surface.file)
    finer, *found = solved(mesh, facets, COMPONENTS, surface, surface.density, below, most, CORNER)
    values, shapes, residual, error = found
    frequency, height, cut = np.sqrt(values) / (2 * pi), mesh.p[2].max(), len(finer.solid.cells) > mesh.nelements
    plate = SimpleNamespace(thickness=np.ptp(mesh.p[2]), material=surface, density=surface.density)

    def shape(x, y):
        return on_face(finer.solid, shapes[..., 2:], height, np.column_stack([x, y]))[..., 0]

    return SurfaceModes(
        frequency=frequency,
        decay_rate=pi * frequency * surface.loss_factor,
        order=np.full(len(values), -1),
        **sampled(shape, top, 2 * pi / bending_number(plate, below), below),
        radius=0.0,
        place=np.array(surface.place),
        residual=residual,
        error=error,
        mass=finer.solid.total,
        method="finite elements on the given mesh" + ", each cell cut in eight" * cut,
        unknowns=3 * len(finer.solid.points),
    )


def top_triangles(mesh, name):
    """The top face as triangles (k, 3, 2) [m]; ValueError if the mesh has none."""
    facets = mesh.facets[:, mesh.boundary_facets()]
    height = mesh.p[2]
    high = height[facets] > height.max() - LEVEL * np.ptp(mesh.p, axis=1).max()
    found = facets[:, high.all(axis=0)]
    if not found.size:
        raise ValueError(
            f"surface.file = {name!r}: no level face at its greatest height, {height.max():g} m: z is upwards"
        )
    corners = mesh.p[:2, found].T
    return np.concatenate([corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)])


def check_place(top, place, reach, name):
    """ValueError unless the middle and the contact circle of the disk lie on the top face at the release."""
    angle = np.linspace(0, 2 * pi, 33)
    points = place + reach * np.column_stack([np.append(np.cos(angle), 0), np.append(np.sin(angle), 0)])
    if not on_top(top, points).all():
        low, high = top.min(axis=(0, 1)), top.max(axis=(0, 1))
        raise ValueError(
            f"surface.place = {place.tolist()}: a disk of radius {reach:g} m there is not on the top face of {name!r}, "
            f"which is {low[0]:g} to {high[0]:g} m wide in x, {low[1]:g} to {high[1]:g} m in y"
        )


def on_top(top, points):
    """Whether points (k, 2) [m] are on the triangles of a top face, (k,)."""
    sides = [cross(top[:, i] - top[:, i - 1], points[:, None] - top[:, i - 1]) for i in range(3)]
    turn = np.sign(cross(top[:, 1] - top[:, 0], top[:, 2] - top[:, 0]))
    return (np.array(sides) * turn > -1e-12).all(axis=0).any(axis=1)


def cross(a, b):
    """The component of a x b across the plane, (...,)."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def held_facets(mesh, sets, names, file):
    """The facets (k,) of the surfaces, or of the sets of nodes, of these names."""
    known = (mesh.boundaries or {}) | {name: facets_between(mesh, points) for name, points in sets.items()}
    for name in names:
        if name not in known:
            raise ValueError(f"surface.held = {list(names)}: {file!r} has no {name!r}, only {sorted(known)}")
        if not len(known[name]):
            raise ValueError(f"surface.held: {name!r} of {file!r} has no whole face: single nodes hold no solid")
    return np.unique(np.concatenate([known[name] for name in names] or [np.zeros(0)])).astype(int)


def facets_between(mesh, points):
    """The boundary facets (k,) all of whose corners are among the points (n, 3)."""
    facets = mesh.boundary_facets()
    near = 1e-9 * np.ptp(mesh.p, axis=1).max()
    corners = np.unique(mesh.facets[:, facets])
    apart = np.abs(mesh.p[:, corners].T[:, None] - points).max(axis=2).min(axis=1)
    return facets[np.isin(mesh.facets[:, facets], corners[apart < near]).all(axis=0)]


def sampled(shape, top, length, below):
    """The fields points, weights, face, knots and coefficients of shape(x (k,), y (k,)) -> (m, k) on the triangles.

    The face is read off the splines: between the nodes they are as near as what goes through the nodes.
    """
    longest = np.linalg.norm(top - np.roll(top, 1, axis=1), axis=2).max()
    order = min(HIGHEST_ORDER, SPARE_ORDERS + ceil(2 * pi * below / SOUND_SPEED * longest))
    (u, v), share = get_quadrature(RefTri, order)
    along, across = top[:, 1] - top[:, 0], top[:, 2] - top[:, 0]
    points = (top[:, :1] + u[:, None] * along[:, None] + v[:, None] * across[:, None]).reshape(-1, 2)
    weights = np.abs(cross(along, across))[:, None] * share
    knots, coefficients = splined(shape, top.min(axis=(0, 1)), top.max(axis=(0, 1)), length)
    return {
        "points": points,
        "weights": weights.ravel(),
        "face": spline_values(knots, coefficients, *points.T).T,
        "knots": knots,
        "coefficients": coefficients,
    }
