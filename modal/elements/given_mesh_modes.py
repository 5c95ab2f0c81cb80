"""The record of the modes of a body meshed elsewhere, sampled on the edge and the faces of the disk it stands for."""

from math import pi

import numpy as np
from scipy.interpolate import CloughTocher2DInterpolator, NearestNDInterpolator

from modal.elements import sample
from modal.elements.unfold import rigid_fields
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.modes import Body, Modes

VTK = {
    "tetra": [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)],
    "hexahedron": VTK_HEXAHEDRON27[:8],
    "hexahedron27": VTK_HEXAHEDRON27,
}
VTK["tetra10"] = [*VTK["tetra"], (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]
"""Twice the reference coordinates of the nodes in VTK's order."""


def body_of(element, solid, shapes):
    """The `Body` of the mesh, its nodes in VTK's order."""
    where = {tuple(row): i for i, row in enumerate(np.rint(2 * element.doflocs).astype(int))}
    kind = next(kind for kind, nodes in VTK.items() if set(nodes) == set(where))
    cells = solid.cells[:, [where[node] for node in VTK[kind]]]
    return Body(points=solid.points, cells=cells, cell_type=kind, displacement=shapes)


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
    angle, (r, _, theta) = sample.rim_angles(), sample.face_grid(radius)
    low, high = solid.points[:, 2].min(), solid.points[:, 2].max()
    rim = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    grid = np.stack([np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()], axis=1)
    rim_shape = sample.polar_components(on_face(solid, shapes, low, rim), angle)
    face = [on_face(solid, shapes, z, grid)[..., 2].reshape(-1, len(r), len(theta)) for z in (low, high)]
    flat = shapes.reshape(len(shapes), 3 * len(solid.points))
    axial = (shapes * [0, 0, 1]).reshape(flat.shape)
    share = np.einsum("kp,kp->k", axial, (solid.mass @ axial.T).T)
    frequency = np.sqrt(values) / (2 * pi)
    mirrored = rim_shape[:, -np.arange(len(angle))] * [1, -1, 1]
    odd = (rim_shape * mirrored).sum(axis=(1, 2)) < 0
    return Modes(
        frequency=frequency,
        decay_rate=pi * frequency * material.loss_factor,
        order=sample.strongest_order(rim_shape),
        family=tuple(np.where(share > 0.5, "flexural", "extensional").tolist()),
        parity=tuple(np.where(odd, "odd", "even").tolist()),
        partner=np.full(len(values), -1),
        participation=flat @ (solid.mass @ rigid_fields(solid.points).reshape(6, -1).T),
        **sample.grids(radius),
        rim_shape=rim_shape,
        face_shape=np.stack(face, axis=1),
        residual=residual,
        error=np.array(error),
        mass=solid.total,
        method="finite elements on the given mesh",
        unknowns=3 * len(solid.points),
        body=body_of(element, solid, shapes),
    )
