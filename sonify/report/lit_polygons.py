"""The deformed body seen at a slant, as lit polygons in the order of their distance."""

import numpy as np

from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.modes import Body

AZIMUTH, ELEVATION = np.deg2rad(-60), np.deg2rad(32)
"""Where the eye is: below the x axis, which points to the patch, and above the top face."""
LIGHT, DIM = np.array([0.3, -0.5, 0.81]), 0.6
"""Where the light comes from, and how bright a surface is that it grazes."""


def square(axis, end):
    """The nodes (3, 3) of the side of a 27-node hexahedron where a coordinate has the value 0 or
    2."""
    lattice = np.array(VTK_HEXAHEDRON27)
    on = np.flatnonzero(lattice[:, axis] == end)
    return on[np.lexsort(np.delete(lattice[on], axis, axis=1).T)].reshape(3, 3)


SQUARES = np.array([square(axis, end) for axis in range(3) for end in (0, 2)])
TRIANGLES = np.array([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])


def skin(body: Body):
    """Polygons (k, 3 or 4) of node numbers on the surface of a body; a curved quadrilateral is four
    flat ones."""
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
    """The sides (k, n) that only one cell has, told by their corners."""
    _, first, count = np.unique(
        np.sort(sides[:, corners], axis=1), axis=0, return_index=True, return_counts=True
    )
    return sides[first[count == 1]]


def seen(points):
    """Right, up and towards the eye (..., 3) of points (..., 3), from afar."""
    (c, s), (ce, se) = [(np.cos(a), np.sin(a)) for a in (AZIMUTH, ELEVATION)]
    return points @ np.array([[-s, c, 0], [-se * c, -se * s, ce], [ce * c, ce * s, se]]).T


def view(body: Body, polygons, i, factor):
    """The polygons (k, n) of the body moved by factor times mode i, the farthest first, as they are
    seen.

    Returns places (k, n, 2), how far each moves over the farthest (k,), and how brightly it is lit
    from above (k,)."""
    moved = (body.points + factor * body.displacement[i])[polygons]
    far = np.linalg.norm(body.displacement[i], axis=1)[polygons].mean(axis=1)
    normal = np.cross(moved[:, 2] - moved[:, 0], moved[:, -1] - moved[:, 1])
    light = DIM + (1 - DIM) * np.abs(normal @ LIGHT) / np.linalg.norm(normal, axis=1)
    places = seen(moved)
    order = np.argsort(places[..., 2].mean(axis=1))
    return places[order, :, :2], far[order] / far.max(), light[order]
