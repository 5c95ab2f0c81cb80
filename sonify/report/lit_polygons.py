"""Deformed body in an oblique view, as lit polygons sorted by distance."""

import numpy as np

from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.modes import Body

AZIMUTH, ELEVATION = np.deg2rad(-60), np.deg2rad(32)
"""View direction [rad].

The azimuth starts at the x axis, which points to the patch; the elevation is above the top face.
"""
LIGHT, DIM = np.array([0.3, -0.5, 0.81]), 0.6
"""Direction of the light, and brightness of a surface at grazing incidence."""


def square(axis, end):
    """Return the nodes (3, 3) of a 27-node hexahedron on the side where `axis` equals `end`."""
    lattice = np.array(VTK_HEXAHEDRON27)
    on = np.flatnonzero(lattice[:, axis] == end)
    return on[np.lexsort(np.delete(lattice[on], axis, axis=1).T)].reshape(3, 3)


SQUARES = np.array([square(axis, end) for axis in range(3) for end in (0, 2)])
TRIANGLES = np.array([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])


def skin(body: Body):
    """Return the surface of a body as polygons (k, 3 or 4) of node numbers.

    Four flat quadrilaterals represent each curved one.
    """
    if "tetra" in body.cell_type:
        return outer(body.cells[:, TRIANGLES].reshape(-1, 3), np.arange(3))
    if body.cell_type == "hexahedron":
        return outer(
            body.cells[:, SQUARES[:, ::2, ::2].reshape(6, 4)].reshape(-1, 4), np.arange(4)
        )[:, [0, 1, 3, 2]]
    sides = outer(body.cells[:, SQUARES].reshape(-1, 9), np.array([0, 2, 6, 8])).reshape(-1, 3, 3)
    parts = [sides[:, i : i + 2, j : j + 2].reshape(-1, 4) for i in (0, 1) for j in (0, 1)]
    return np.concatenate(parts)[:, [0, 1, 3, 2]]


def outer(sides, corners):
    """Return the sides (k, n) that belong to a single cell; their corner nodes identify them."""
    _, first, count = np.unique(
        np.sort(sides[:, corners], axis=1), axis=0, return_index=True, return_counts=True
    )
    return sides[first[count == 1]]


def seen(points):
    """Return the components (..., 3) of points (..., 3) to the right, up and towards the viewer.

    The projection is parallel.
    """
    (c, s), (ce, se) = [(np.cos(a), np.sin(a)) for a in (AZIMUTH, ELEVATION)]
    return points @ np.array([[-s, c, 0], [-se * c, -se * s, ce], [ce * c, ce * s, se]]).T


def view(body: Body, polygons, i, factor):
    """Project the polygons (k, n) of a body displaced by `factor` times mode i, farthest first.

    Returns places (k, n, 2), mean displacements relative to the greatest (k,), and brightnesses
    (k,).
    """
    moved = (body.points + factor * body.displacement[i])[polygons]
    far = np.linalg.norm(body.displacement[i], axis=1)[polygons].mean(axis=1)
    normal = np.cross(moved[:, 2] - moved[:, 0], moved[:, -1] - moved[:, 1])
    light = DIM + (1 - DIM) * np.abs(normal @ LIGHT) / np.linalg.norm(normal, axis=1)
    places = seen(moved)
    order = np.argsort(places[..., 2].mean(axis=1))
    return places[order, :, :2], far[order] / far.max(), light[order]
