"""Project a deformed body to shaded polygons in an oblique view, sorted by distance."""

import numpy as np

from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.modes import Body


def side_nodes(axis: int, end: int) -> np.ndarray:
    """Return the nodes (3, 3) of a 27-node hexahedron on the side where `axis` equals
    `end`."""
    lattice = np.array(VTK_HEXAHEDRON27)
    on = np.flatnonzero(lattice[:, axis] == end)
    return on[np.lexsort(np.delete(lattice[on], axis, axis=1).T)].reshape(3, 3)


HEXAHEDRON_SIDES = np.array(
    [side_nodes(axis, end) for axis in range(3) for end in (0, 2)]
)
TETRAHEDRON_SIDES = np.array([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])


def surface_polygons(body: Body) -> np.ndarray:
    """Return the surface of a body as polygons (k, 3 or 4) of node numbers.

    Each curved quadrilateral is divided into four flat ones.
    """
    if "tetra" in body.cell_type:
        return outer_sides(body.cells[:, TETRAHEDRON_SIDES].reshape(-1, 3), range(3))
    if body.cell_type == "hexahedron":
        corners = body.cells[:, HEXAHEDRON_SIDES[:, ::2, ::2]].reshape(-1, 4)
        return outer_sides(corners, range(4))[:, [0, 1, 3, 2]]
    sides = body.cells[:, HEXAHEDRON_SIDES].reshape(-1, 9)
    grids = outer_sides(sides, [0, 2, 6, 8]).reshape(-1, 3, 3)
    parts = [
        grids[:, i : i + 2, j : j + 2].reshape(-1, 4) for i in (0, 1) for j in (0, 1)
    ]
    return np.concatenate(parts)[:, [0, 1, 3, 2]]


def outer_sides(sides: np.ndarray, corners: list[int] | range) -> np.ndarray:
    """Return the sides (k, n) that belong to a single cell; sides are identified by
    their corner nodes."""
    _, first, count = np.unique(
        np.sort(sides[:, corners], axis=1),
        axis=0,
        return_index=True,
        return_counts=True,
    )
    return sides[first[count == 1]]


def view_coordinates(points: np.ndarray) -> np.ndarray:
    """Return coordinates (..., 3) to the right, up and towards the viewer in a parallel
    projection.

    The azimuth is measured from the x axis, which points to the contact, and the
    elevation from the top face.
    """
    azimuth = np.deg2rad(-60)
    elevation = np.deg2rad(32)
    c = np.cos(azimuth)
    s = np.sin(azimuth)
    ce = np.cos(elevation)
    se = np.sin(elevation)
    axes = np.array([[-s, c, 0], [-se * c, -se * s, ce], [ce * c, ce * s, se]])
    return points @ axes.T


def projected_mode_shape(
    body: Body, polygons: np.ndarray, i: int, factor: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the polygons (k, n) of a body displaced by `factor` times mode i, farthest
    first.

    The result consists of image positions (k, n, 2), mean displacements (k,) relative
    to the greatest, and brightnesses (k,).
    """
    moved = (body.points + factor * body.displacement[i])[polygons]
    far = np.linalg.norm(body.displacement[i], axis=1)[polygons].mean(axis=1)
    normal = np.cross(moved[:, 2] - moved[:, 0], moved[:, -1] - moved[:, 1])
    light_direction = np.array([0.3, -0.5, 0.81])
    incidence = np.abs(normal @ light_direction)
    least = 0.6  # brightness at grazing incidence
    light = least + (1 - least) * incidence / np.linalg.norm(normal, axis=1)
    places = view_coordinates(moved)
    order = np.argsort(places[..., 2].mean(axis=1))
    return places[order, :, :2], far[order] / far.max(), light[order]
