"""Find the axis of a disk on a user's mesh and turn it to z."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from skfem import CellBasis, Mesh

Z_AXIS = np.array([0.0, 0.0, 1.0])
FACE_TOLERANCE = 1e-3
"""Largest distance of the nodes of a face from its plane, as a fraction of the
thickness."""


def turned_to_z(mesh: Mesh, name: str | Path) -> Mesh:
    """Return the mesh of a disk, centred at the origin, with the axis of the disk along
    z.

    The mesh is turned by the smallest angle. A disk whose faces are not flat is not
    turned if its axis is within 5 degrees of z. Raises ValueError if the axis cannot be
    determined, or if there is no flat area at the lowest or the greatest z.
    """
    axis = normal_of_faces(mesh, axis_of_body(mesh, name))
    is_flat = flat_area_ratio(mesh, axis) > 0.5
    least_angle = np.deg2rad(1e-5 if is_flat else 5.0)
    if axis[2] < np.cos(least_angle):
        points = rotation_to_z(axis) @ mesh.doflocs
        mesh = replace(mesh, doflocs=np.ascontiguousarray(points))
    check_faces(mesh, name)
    return mesh


def boundary_area_vectors(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners (f, n, 3) of the boundary facets and their area vectors
    (f, 3) [m^2], whose signs are arbitrary."""
    corners = mesh.p.T[mesh.facets[:, mesh.boundary_facets()].T]
    if corners.shape[1] == 3:
        corners = corners[:, [0, 1, 2, 0]]
    diagonals = corners[:, 2:] - corners[:, :2]
    return corners, np.cross(diagonals[:, 0], diagonals[:, 1]) / 2


def flat_area_ratio(mesh: Mesh, axis: np.ndarray) -> float:
    """Return the area of the smaller one of the outermost flat faces normal to a unit
    vector, divided by the projected area of the body."""
    corners, areas = boundary_area_vectors(mesh)
    projected = np.abs(areas @ axis)
    height = corners @ axis
    size = np.ptp(corners, axis=(0, 1)).max()
    tolerance = min(FACE_TOLERANCE * np.ptp(height), 1e-5 * size)
    is_top = (height > height.max() - tolerance).all(axis=1)
    is_bottom = (height < height.min() + tolerance).all(axis=1)
    smaller = min(projected[is_top].sum(), projected[is_bottom].sum())
    return 2 * smaller / projected.sum()


def axis_of_body(mesh: Mesh, name: str | Path) -> np.ndarray:
    """Return the principal axis of inertia that is the axis of a disk, or z.

    It is the axis along which a body is flat. If there is none, it is z if two flat
    faces are normal to z, or else the axis whose moment differs from two similar ones.
    Raises ValueError if there is no such axis.
    """
    max_flatness = 0.25  # variance of the mass along the axis, relative to the next one
    max_similarity = 0.3  # difference of similar moments, relative to the other one
    min_difference = 0.05  # of variances, relative to the largest one
    basis = CellBasis(mesh, mesh.elem())
    x = np.asarray(basis.global_coordinates())
    covariance = np.einsum("icq,jcq,cq->ij", x, x, basis.dx) / basis.dx.sum()
    variance, axes = np.linalg.eigh(covariance)
    if variance[0] < max_flatness * variance[1]:
        return axes[:, 0]
    if flat_area_ratio(mesh, Z_AXIS) > 0.5:
        return Z_AXIS
    low, high = np.diff(variance)
    similar, different = sorted((low, high))
    is_round = similar < max_similarity * different
    if not is_round or different < min_difference * variance[2]:
        raise ValueError(
            f"{name}: its moments of inertia do not determine the axis of the disk; turn "
            "the mesh so that its axis is z"
        )
    return axes[:, 0] if low > high else axes[:, 2]


def normal_of_faces(mesh: Mesh, axis: np.ndarray) -> np.ndarray:
    """Return the mean normal of the facets that are almost normal to an axis.

    Its largest component is positive. An axis without such facets is returned
    unchanged.
    """
    _, areas = boundary_area_vectors(mesh)
    for max_angle in (20.0, 1.0):  # degrees
        along = areas @ axis
        is_face = np.abs(along) > np.cos(np.deg2rad(max_angle)) * np.linalg.norm(
            areas, axis=1
        )
        if is_face.any():
            total = (np.sign(along) * is_face) @ areas
            axis = total / np.linalg.norm(total)
    return axis * np.sign(axis[np.abs(axis).argmax()])


def rotation_to_z(axis: np.ndarray) -> np.ndarray:
    """Return the matrix of the smallest rotation that turns a unit vector to z."""
    x, y, z = axis
    turn = np.array([[0.0, 0.0, -x], [0.0, 0.0, -y], [x, y, 0.0]])
    return np.eye(3) + turn + turn @ turn / (1 + z)


def check_faces(mesh: Mesh, name: str | Path) -> None:
    """Raise ValueError if the corners at the lowest or the greatest z lie on a line."""
    for which, height in (("lowest", -mesh.p[2]), ("greatest", mesh.p[2])):
        on_face = height > height.max() - FACE_TOLERANCE * np.ptp(height)
        nodes = mesh.p[:2, on_face]
        centred = nodes - nodes.mean(axis=1, keepdims=True)
        widths = np.sqrt(np.abs(np.linalg.eigvalsh(centred @ centred.T)))
        if widths[0] < 1e-3 * widths[1] or not widths[1]:
            raise ValueError(
                f"{name}: the disk has no flat face at its {which} z; its axis must be z, "
                "and its faces must be flat"
            )
