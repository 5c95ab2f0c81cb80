"""Mesh a symmetry sector of the disk with isoparametric quadratic hexahedra for
scikit-fem."""

from dataclasses import dataclass
from math import ceil, pi
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from skfem import ElementHex2, Mesh, MeshHex, MeshHex2

from modal.mesh.half_disk import (
    MeshSize,
    cells_of_blocks,
    core_blocks,
    half_disk,
    rim_blocks,
)
from modal.mesh.patch_box import max_layer_height, nested_boxes, nodes_of_boxes

if TYPE_CHECKING:
    from modal.modes import Support

HEXAHEDRON_NODES = np.rint(ElementHex2.doflocs * 2).astype(int)
"""Twice the reference coordinates (27, 3) of the nodes in scikit-fem's order, beginning
with the eight corners."""


@dataclass(frozen=True, kw_only=True)
class Sector:
    """Modelled part of the disk: y >= 0, for a quarter disk also z >= 0."""

    mesh: MeshHex2
    """Mesh [m]."""
    quarter: bool
    """True if the disk is also symmetric in z."""
    patch: tuple[float, float] | None
    """Lowest and highest z of the patch [m], or None for a free disk."""

    @property
    def mirror_image_count(self) -> int:
        """Number of mirror images in the whole disk."""
        return 4 if self.quarter else 2


def layer_heights(
    bottom: float, top: float, size: MeshSize, radius: float
) -> np.ndarray:
    """Return the boundaries (k + 1,) [m] of layers of equal thickness.

    The thickness of a layer does not exceed the width of the plane cells.
    """
    count = ceil((top - bottom) / (max_layer_height(size) * radius) - 1e-9)
    return np.linspace(bottom, top, size.split * max(1, count) + 1)


def extrude(cells: np.ndarray, heights: np.ndarray) -> np.ndarray:
    """Return the nodes (q * layers, 27, 3) of hexahedra extruded from plane cells (q,
    3, 3, 2).

    The nodes are in scikit-fem's order."""
    i, j, k = HEXAHEDRON_NODES.T
    nodes = np.empty((len(cells), len(heights) - 1, 27, 3))
    nodes[..., :2] = cells[:, None, i, j]
    low = heights[:-1, None]
    high = heights[1:, None]
    nodes[..., 2] = low + (high - low) * k / 2
    return nodes.reshape(-1, 27, 3)


def hexahedra(
    nodes: np.ndarray, linear: type[Mesh] = MeshHex, quadratic: type[Mesh] = MeshHex2
) -> Mesh:
    """Return the scikit-fem mesh of cells with nodes (c, n, 3), with coincident nodes
    merged.

    The mesh is an instance of `quadratic`, created from one of `linear` (default:
    hexahedra).
    """
    count = linear.elem.refdom.nnodes
    corners = nodes[:, :count].reshape(-1, 3)
    close_pairs = cKDTree(corners).query_pairs(
        1e-10 * np.abs(nodes).max(), output_type="ndarray"
    )
    graph = coo_matrix(
        (np.ones(len(close_pairs)), close_pairs.T), shape=(len(corners),) * 2
    )
    inverse = connected_components(graph, directed=False)[1]
    vertices = np.ascontiguousarray(corners[np.unique(inverse, return_index=True)[1]].T)
    mesh = quadratic.from_mesh(
        linear(vertices, np.ascontiguousarray(inverse.reshape(-1, count).T))
    )
    mesh.doflocs[:, mesh.dofs.element_dofs] = nodes.transpose(2, 1, 0)
    return mesh


def cartesian_nodes(nodes: np.ndarray, radius: float, bottom: float) -> np.ndarray:
    """Return Cartesian nodes (c, 27, 3) [m] of right-handed cells for nodes (c, 3, 3,
    3, 3) of `patch_box`.

    The input coordinates are angle, depth below the rim, and height above `bottom` [m],
    with depth and height divided by the radius. The result is in scikit-fem's order.
    """
    angle, depth, height = np.moveaxis(nodes, -1, 0)
    distance = (1 - depth) * radius
    x = distance * np.cos(angle)
    y = distance * np.sin(angle)
    points = np.stack([x, y, height * radius + bottom], -1)
    sides = [
        np.take(points, 2, axis)[:, 1, 1] - np.take(points, 0, axis)[:, 1, 1]
        for axis in (1, 2, 3)
    ]
    left_handed = np.linalg.det(np.stack(sides, -1)) < 0
    points[left_handed] = np.swapaxes(points[left_handed], 1, 2)
    i, j, k = HEXAHEDRON_NODES.T
    return points[:, i, j, k]


def disk_cells_with_low_patch(
    radius: float,
    bottom: float,
    top: float,
    angle: float,
    height: float,
    size: MeshSize,
) -> np.ndarray:
    """Return the cell nodes (c, 27, 3) [m] of a disk held on an arc of its rim that covers
    only part of the thickness.

    The disk extends between two heights [m].

    The arc has a half angle [rad] and a height [m] above `bottom`.
    """
    boxes = nested_boxes(angle, height / radius, (top - bottom) / radius, size)
    last = boxes.corners[-1]
    n = boxes.cells_around
    rest = round((pi - last[0]) / size.width)
    rest += (n + rest) % 2
    angles = np.append(
        np.linspace(0, last[0], n + 1), np.linspace(last[0], pi, rest + 1)[1:]
    )
    ring = rim_blocks(angles, size.depth)
    core = core_blocks(angles, size.depth, size.layers)
    middle = bottom + last[2] * radius
    lower = np.linspace(bottom, middle, size.split * boxes.cells_up + 1)
    cells = [
        cartesian_nodes(nodes_of_boxes(boxes, size), radius, bottom),
        extrude(cells_of_blocks(ring[n:] + core, size) * radius, lower),
    ]
    if top - middle > 1e-9 * radius:
        upper = layer_heights(middle, top, size, radius)
        cells.append(extrude(cells_of_blocks(ring + core, size) * radius, upper))
    return np.concatenate(cells)


def patch_height(thickness: float, support: "Support") -> float:
    """Return the modelled height [m] of the patch of a `Support` (default: the
    thickness).

    A patch over almost the whole thickness is treated as a patch over all of it. The
    free strip would change the frequencies by at most 0.4 %, less than the error of the
    cells around such a thin strip.
    """
    full_height_share = 0.985
    height = support.height if support.kind == "patch" and support.height else thickness
    return height if height < full_height_share * thickness else thickness


def patch_edge(radius: float, thickness: float, support: "Support") -> np.ndarray:
    """Return points (6, 3) [m] on the lower and upper edges of the patch."""
    angle = np.deg2rad(support.half_angle_deg) * np.array([-1, 0, 1])
    height = patch_height(thickness, support)
    bottom = -thickness / 2 if support.position == "bottom" else -height / 2
    x = radius * np.cos(angle)
    y = radius * np.sin(angle)
    return np.concatenate(
        [np.stack([x, y, np.full(3, z)], axis=1) for z in (bottom, bottom + height)],
    )


def sector(
    radius: float, thickness: float, support: "Support", size: MeshSize
) -> Sector:
    """Return the `Sector` of a disk [m] on a `Support`, graded towards the edge of the
    patch."""
    half = thickness / 2
    is_free = support.kind == "free"
    height = patch_height(thickness, support)
    full_height = is_free or height == thickness
    quarter = full_height or support.position == "middle"
    bottom = 0.0 if quarter else -half
    meshed_height = height / 2 if quarter else height
    angle = pi if is_free else np.deg2rad(support.half_angle_deg)
    if full_height:
        plane_cells = half_disk(angle, size) * radius
        nodes = extrude(plane_cells, layer_heights(bottom, half, size, radius))
    else:
        nodes = disk_cells_with_low_patch(
            radius, bottom, half, angle, meshed_height, size
        )
    patch = (
        None
        if is_free
        else (-meshed_height if quarter else bottom, bottom + meshed_height)
    )
    return Sector(mesh=hexahedra(nodes), quarter=quarter, patch=patch)
