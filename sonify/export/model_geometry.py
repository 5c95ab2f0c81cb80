"""Make the meshes of disk, contact and table and the poses of the disk for a model with
the y axis pointing upwards."""

from dataclasses import dataclass
from itertools import pairwise
from math import acos, ceil, pi

import numpy as np
from scipy.spatial.transform import Rotation

from dynamics import Disk
from dynamics.contact_geometry import centre_height, edge_profile
from dynamics.surface import PlateSurface
from sonify.export.disk_frame import patch_frame
from sonify.scene import Scene


@dataclass
class Mesh:
    """Triangles of one or more materials with shared vertices."""

    points: np.ndarray
    normals: np.ndarray
    triangles: dict[str, np.ndarray]


def to_y_upwards(points: np.ndarray) -> np.ndarray:
    """Convert points (..., 3) from axes with z upwards to the axes of glTF with y
    upwards."""
    x, y, z = np.moveaxis(points, -1, 0)
    return np.stack([x, z, -y], axis=-1)


def body_poses(
    state: np.ndarray, disk: Disk, fillet: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Return centres (k, 3) [m] and quaternions (k, 4) in the order x, y, z, w for
    states (k, 11).

    The quaternions rotate a body whose axis is along y; their signs are continuous in
    time.
    """
    inclination = state[:, 1]
    x, y, z = patch_frame(state, inclination).swapaxes(0, 1)
    c = np.cos(state[:, 2, None])
    s = np.sin(state[:, 2, None])
    height = centre_height(inclination, disk, fillet)
    centre = np.column_stack([state[:, 3:5], height])
    axes = np.stack(
        [to_y_upwards(axis) for axis in (c * x + s * y, z, s * x - c * y)], axis=2
    )
    quaternion = Rotation.from_matrix(axes).as_quat()
    reversals = np.einsum("ki,ki->k", quaternion[1:], quaternion[:-1]) < 0
    quaternion[1:][np.cumsum(reversals) % 2 == 1] *= -1
    return to_y_upwards(centre), quaternion


def rim_sides(radius: float) -> int:
    """Return the number of sides of the polygon that represents a rim of a radius
    [m]."""
    max_sagitta = 2e-7  # m, between the rim and the sides
    wanted = pi / acos(max(1 - max_sagitta / radius, 0.0))
    return min(max(ceil(wanted), 96), 4096)


Strip = tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]
"""Points (k, 3) [m] and normals (k, 3) or (3,) of the two rings that bound a strip."""


def _surface_strips(disk: Disk, fillet: float, sides: int) -> list[Strip]:
    """Return the strips of the surface, each bounded by two rings (sides + 1, 3).

    The first two are the cylindrical side and the upper face."""
    angle = np.arange(sides + 1) % sides * 2 * np.pi / sides
    outward = np.column_stack([np.cos(angle), 0 * angle, -np.sin(angle)])
    up = np.array([0.0, disk.thickness / 2, 0.0])
    axis = np.array([0.0, 1.0, 0.0])
    inner = disk.inner_radius * outward
    edge = edge_profile(disk, fillet, segments=8)
    steps = np.linspace(0.0, pi / 2, len(edge))
    rounded = [
        (r * outward + level * axis, np.sin(tilt) * outward + np.cos(tilt) * axis)
        for (r, level), tilt in zip(edge, steps, strict=True)
    ]
    face = (disk.radius - fillet) * outward
    below = [(ring * [1, -1, 1], normal * [1, -1, 1]) for ring, normal in rounded]
    strips = [
        ((below[-1][0], outward), (rounded[-1][0], outward)),
        ((face + up, axis), (inner + up, axis)),
        ((inner - up, -axis), (face - up, -axis)),
        *pairwise(below),
        *pairwise(rounded[::-1]),
    ]
    if disk.inner_radius > 0:
        strips.append(((inner + up, -outward), (inner - up, -outward)))
    return strips


def disk_mesh(disk: Disk, fillet: float = 0.0) -> Mesh:
    """Return a disk or hoop centred at the origin, with its axis along y and a mark on
    face and rim.

    The outer edges are rounded with the radius `fillet` [m]."""
    sides = rim_sides(disk.radius)
    strips = _surface_strips(disk, fillet, sides)
    count = sides + 1
    points = np.concatenate([ring for strip in strips for ring, _ in strip])
    normals = np.concatenate(
        [np.broadcast_to(normal, (count, 3)) for strip in strips for _, normal in strip]
    )
    first = np.arange(sides)
    halves = np.array([[0, 1, count + 1], [0, count + 1, count]])
    triangles = [
        2 * count * i + first[:, None, None] + halves for i in range(len(strips))
    ]
    rim_and_face = np.array(triangles[:2])
    is_marked = first < sides / 24  # a coloured mark makes the spin visible
    parts = {
        "metal": [*rim_and_face[:, ~is_marked], *triangles[2:]],
        "mark": [*rim_and_face[:, is_marked]],
    }
    return Mesh(
        points=points,
        normals=normals,
        triangles={
            name: _nondegenerate_triangles(points, np.concatenate(some).reshape(-1, 3))
            for name, some in parts.items()
        },
    )


def _nondegenerate_triangles(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the triangles (n, 3) of nonzero area."""
    a, b, c = points[triangles].swapaxes(0, 1)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return triangles[area > 0]


def marker_mesh(radius: float) -> Mesh:
    """Return a sphere of a radius [m] that marks the contact."""
    latitude_bands = 12
    latitude, longitude = np.meshgrid(
        np.linspace(-pi / 2, pi / 2, latitude_bands + 1),
        np.linspace(0, 2 * pi, 2 * latitude_bands + 1),
        indexing="ij",
    )
    normals = np.stack(
        [
            np.cos(latitude) * np.sin(longitude),
            np.sin(latitude),
            np.cos(latitude) * np.cos(longitude),
        ],
        axis=-1,
    ).reshape(-1, 3)
    width = 2 * latitude_bands + 1
    corner = np.add.outer(
        width * np.arange(latitude_bands), np.arange(2 * latitude_bands)
    ).reshape(-1, 1)
    halves = np.array([[0, 1, width + 1], [0, width + 1, width]])
    triangles = (corner + halves[:, None]).reshape(-1, 3)
    return Mesh(
        points=radius * normals, normals=normals, triangles={"contact": triangles}
    )


def table_mesh(scene: Scene, contact: np.ndarray) -> Mesh:
    """Return the table top at y = 0: the plate of the scene, or a rectangle below the
    motion."""
    radius = scene.disk.radius
    if isinstance(scene.surface, PlateSurface):
        angle = np.arange(240) * 2 * np.pi / 240
        x, y = scene.surface.place
        middle = np.array([-x, 0.0, y])  # the disk is released at the origin
        edge = scene.surface.radius * np.column_stack(
            [np.cos(angle), 0 * angle, -np.sin(angle)]
        )
    else:
        low = contact.min(axis=0) - 3 * radius
        high = contact.max(axis=0) + 3 * radius
        middle = (low + high) / 2 * [1.0, 0.0, 1.0]
        a, _, b = (high - low) / 2
        edge = np.array([[a, 0.0, b], [a, 0.0, -b], [-a, 0.0, -b], [-a, 0.0, b]])
    first = np.arange(1, len(edge) + 1)
    triangles = np.column_stack([0 * first, first, np.roll(first, -1)])
    points = np.vstack([middle, middle + edge])
    return Mesh(
        points=points,
        normals=np.tile([0.0, 1.0, 0.0], (len(points), 1)),
        triangles={"table": triangles},
    )
