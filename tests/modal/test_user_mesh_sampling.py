"""Claim: modes of a user's mesh keep their nodes and their values when they are sampled.

Source: modal/elements/user_mesh_modes.py. Oracle: VTK's corners of a hexahedron; a linear field,
which every interpolation of at least first order returns.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from skfem import ElementHex1, ElementHex2, ElementTetP2

from modal.elements.user_mesh_modes import cells_in_vtk_order, interpolate_on_face

HEXAHEDRON_CORNERS = [
    [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
    [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
]
"""Corners of VTK_HEXAHEDRON: counterclockwise below, then above."""


@pytest.mark.parametrize(
    ("element", "cell_type"),
    [(ElementHex1(), "hexahedron"), (ElementHex2(), "hexahedron27")],
)
def test_the_nodes_of_hexahedra_are_in_the_order_of_vtk(element, cell_type):
    count = len(element.doflocs)
    solid = SimpleNamespace(cells=np.arange(count)[None])
    cells, found = cells_in_vtk_order(element, solid)
    assert found == cell_type
    assert sorted(cells[0]) == list(range(count))
    corners = element.doflocs[cells[0, :8]]
    assert corners.tolist() == np.concatenate(HEXAHEDRON_CORNERS).tolist()
    # the first nodes on edges are on those from 0 to 1, 1 to 2, 2 to 3 and 3 to 0
    edges = element.doflocs[cells[0, 8:12]]
    if len(edges):
        assert edges.tolist() == ((corners[:4] + corners[[1, 2, 3, 0]]) / 2).tolist()


def test_tetrahedra_keep_their_order():
    solid = SimpleNamespace(cells=np.arange(10)[None])
    assert cells_in_vtk_order(ElementTetP2(), solid) == (solid.cells, "tetra10")


def octagon():
    """Return a body with an octagonal bottom and top of radius 1."""
    angle = np.arange(8) * np.pi / 4
    face = [(0.0, 0.0), *np.transpose([np.cos(angle), np.sin(angle)])]
    return SimpleNamespace(points=np.array([(*p, z) for z in (0.0, 0.1) for p in face]))


def linear(points):
    """Return two components of a linear field at points (k, 3), as one mode (1, k, 2)."""
    x, y, z = points.T
    return np.transpose([2 + 3 * x - y + 40 * z, x + y])[None]


@pytest.mark.parametrize("height", [0.0, 0.1])
def test_a_linear_shape_is_sampled_exactly_on_its_face(height):
    body = octagon()
    points = np.array([(0.1, 0.2), (-0.5, 0.3), (0.0, -0.8)])
    found = interpolate_on_face(body, linear(body.points), height, points)
    expected = linear(np.column_stack([points, np.full(3, height)]))
    assert found == pytest.approx(expected, abs=1e-6)  # of its estimated gradients


def test_a_point_outside_takes_the_value_at_the_edge_or_at_the_nearest_node():
    body = octagon()
    shapes = linear(body.points)
    near, far = np.array([(1.0005, 0.0), (0.0, 3.0)])
    found = interpolate_on_face(body, shapes, 0.0, np.array([near, far]))[0]
    assert found[0] == pytest.approx(shapes[0, 1], rel=1e-3)
    assert found[1] == pytest.approx(shapes[0, 3])


def test_without_modes_there_are_no_values():
    body = octagon()
    found = interpolate_on_face(body, np.zeros((0, 18, 3)), 0.0, np.zeros((4, 2)))
    assert found.shape == (0, 4, 3)
