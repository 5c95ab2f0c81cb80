"""Sample the modes of a user's mesh on the edge and the faces of the disk."""

from math import pi
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import CloughTocher2DInterpolator, NearestNDInterpolator

from modal.elements import sample
from modal.elements.unfold import axial_share
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.symmetry import rigid_fields
from modal.modes import Material, Modes

if TYPE_CHECKING:
    from skfem import Element

    from modal.elements.elastic import Solid
    from modal.elements.user_mesh import SolvedBody

CELL_TYPES = {4: "tetra", 10: "tetra10", 8: "hexahedron", 27: "hexahedron27"}
"""meshio's name of each cell type by its number of nodes."""


def cells_in_vtk_order(element: "Element", solid: "Solid") -> tuple[np.ndarray, str]:
    """Return the cells (c, nodes) of a `Solid` in VTK's order, and their meshio type.

    The nodes of tetrahedra have the same order in scikit-fem.
    """
    lattice = np.rint(2 * element.doflocs).astype(int)
    cell_type = CELL_TYPES[len(lattice)]
    if cell_type.startswith("tetra"):
        return solid.cells, cell_type
    index = {tuple(node): i for i, node in enumerate(lattice)}
    order = [index[node] for node in VTK_HEXAHEDRON27[: len(lattice)]]
    return solid.cells[:, order], cell_type


def interpolate_on_face(
    solid: "Solid", shapes: np.ndarray, height: float, points: np.ndarray
) -> np.ndarray:
    """Return the values (m, n, c) of nodal shapes (m, p, c) at points (n, 2) of a face
    at a height [m].

    Interpolation between nodes is cubic. A point outside the polygonal face is moved
    inside, towards the axis, by the smallest sufficient fraction of its radius out of a
    few; if none suffices, it has the value of the nearest node.
    """
    if not len(shapes):
        return np.zeros((0, len(points), shapes.shape[2]))
    nodes = np.flatnonzero(
        np.abs(solid.points[:, 2] - height) < 1e-3 * np.ptp(solid.points[:, 2])
    )
    known = shapes[:, nodes].transpose(1, 0, 2).reshape(len(nodes), -1)
    cubic = CloughTocher2DInterpolator(solid.points[nodes, :2], known)
    values = NearestNDInterpolator(solid.points[nodes, :2], known)(points)
    outside = np.ones(len(points), bool)
    for share in (0.0, 1e-6, 1e-3, 3e-3, 0.01, 0.03):
        found = cubic(points[outside] * (1 - share))
        is_inside = ~np.isnan(found[:, 0])
        inside = np.flatnonzero(outside)[is_inside]
        values[inside] = found[is_inside]
        outside[inside] = False
    return values.reshape(len(points), len(shapes), -1).transpose(1, 0, 2)


def mesh_modes_record(solved: "SolvedBody", material: Material) -> Modes:
    """Return the `Modes` of a `SolvedBody`, sampled on the bottom edge and both faces
    of the disk.

    The faces are sampled from the axis to the rim. Inside a hole, `face_shape` is
    interpolated from the nodes around it, so the hole counts as part of the face.
    """
    solid = solved.body.solid
    shapes = solved.shapes
    radius = np.hypot(*solid.points[:, :2].T).max()
    low = solid.points[:, 2].min()
    high = solid.points[:, 2].max()
    rim, grid = sample.sample_points(radius)
    rim_shape = sample.polar_components(
        interpolate_on_face(solid, shapes, low, rim),
        sample.rim_angles(),
    )
    face = np.stack(
        [interpolate_on_face(solid, shapes, z, grid)[..., 2] for z in (low, high)],
        axis=1,
    )
    flat = shapes.reshape(len(shapes), 3 * len(solid.points))
    mirrored = rim_shape[:, -np.arange(rim_shape.shape[1])] * [1, -1, 1]
    odd = (rim_shape * mirrored).sum(axis=(1, 2)) < 0
    columns = {
        "frequency": np.sqrt(solved.values) / (2 * pi),
        "order": sample.strongest_order(rim_shape),
        "family": np.where(axial_share(solid, shapes) > 0.5, "flexural", "extensional"),
        "parity": np.where(odd, "odd", "even"),
        "participation": flat
        @ (solid.mass @ rigid_fields(solid.points).reshape(6, -1).T),
        "rim_shape": rim_shape,
        "face_shape": face,
        "residual": solved.residual,
        "error": solved.error,
        "displacement": shapes,
    }
    cells, cell_type = cells_in_vtk_order(solved.body.element, solid)
    return sample.sorted_modes(
        columns,
        material,
        radius,
        solid.points,
        cells,
        cell_type=cell_type,
        mass=solid.total_mass,
        method="finite elements on the given mesh",
        unknowns=3 * len(solid.points),
    )
