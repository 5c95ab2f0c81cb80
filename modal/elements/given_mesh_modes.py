"""The record of the modes of a body meshed elsewhere, sampled on the edge and the faces of the disk it stands for."""

from math import pi

import numpy as np
from scipy.interpolate import CloughTocher2DInterpolator, NearestNDInterpolator

from modal.elements import sample
from modal.elements.unfold import axial_share, rigid_fields
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.modes import Modes

VTK = {
    "tetra": [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)],
    "hexahedron": VTK_HEXAHEDRON27[:8],
    "hexahedron27": VTK_HEXAHEDRON27,
}
VTK["tetra10"] = [*VTK["tetra"], (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
"""Twice the reference coordinates of the nodes in VTK's order."""


def in_vtk_order(element, solid):
    """The cells (c, nodes) of the mesh in VTK's order, and their meshio type."""
    where = {tuple(row): i for i, row in enumerate(np.rint(2 * element.doflocs).astype(int))}
    kind = next(kind for kind, nodes in VTK.items() if set(nodes) == set(where))
    return solid.cells[:, [where[node] for node in VTK[kind]]], kind


INWARDS = (0.0, 1e-6, 1e-3, 3e-3, 0.01, 0.03)
"""Shares of the radius by which a point beyond the sides of a face is taken further in, until it lies within them."""


def on_face(solid, shapes, height, points):
    """Displacement (m, n, c) at points (n, 2) of the face at a height, of shapes (m, p, c): cubic between nodes, the
    nearest's beyond."""
    if not len(shapes):
        return np.zeros((0, len(points), shapes.shape[2]))
    nodes = np.flatnonzero(np.abs(solid.points[:, 2] - height) < 1e-3 * np.ptp(solid.points[:, 2]))
    known = shapes[:, nodes].transpose(1, 0, 2).reshape(len(nodes), -1)
    between = CloughTocher2DInterpolator(solid.points[nodes, :2], known)
    values = NearestNDInterpolator(solid.points[nodes, :2], known)(points)
    outside = np.ones(len(points), bool)
    for share in INWARDS:
        found = between(points[outside] * (1 - share))
        within = ~np.isnan(found[:, 0])
        inside = np.flatnonzero(outside)[within]
        values[inside], outside[inside] = found[within], False
    return values.reshape(len(points), len(shapes), -1).transpose(1, 0, 2)


def record(element, solid, material, values, shapes, residual, error, radius) -> Modes:
    """The `Modes` of solved pairs: sampled on the bottom edge and the two faces of the disk the mesh stands for.

    values (m,) [1/s^2], shapes (m, p, 3), residual, error (m,), radius [m] of the rim. The faces are sampled from the
    axis to the rim, as if they were whole: across a hole `face_shape` is interpolated from the nodes about it, and its
    area counts as part of the face.
    """
    low, high = solid.points[:, 2].min(), solid.points[:, 2].max()
    rim, grid = sample.places(radius)
    rim_shape = sample.polar_components(on_face(solid, shapes, low, rim), sample.rim_angles())
    face = np.stack([on_face(solid, shapes, z, grid)[..., 2] for z in (low, high)], axis=1)
    flat = shapes.reshape(len(shapes), 3 * len(solid.points))
    mirrored = rim_shape[:, -np.arange(sample.RIM_ANGLES)] * [1, -1, 1]
    odd = (rim_shape * mirrored).sum(axis=(1, 2)) < 0
    columns = {
        "frequency": np.sqrt(values) / (2 * pi),
        "order": sample.strongest_order(rim_shape),
        "family": np.where(axial_share(solid, shapes) > 0.5, "flexural", "extensional"),
        "parity": np.where(odd, "odd", "even"),
        "participation": flat @ (solid.mass @ rigid_fields(solid.points).reshape(6, -1).T),
        "rim_shape": rim_shape,
        "face_shape": face.reshape(-1, 2, sample.FACE_RADII, sample.FACE_ANGLES),
        "residual": residual,
        "error": error,
        "displacement": shapes,
    }
    cells, kind = in_vtk_order(element, solid)
    about = {"mass": solid.total, "method": "finite elements on the given mesh", "unknowns": 3 * len(solid.points)}
    return sample.recorded(columns, material, radius, solid.points, cells, cell_type=kind, **about)
