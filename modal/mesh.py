"""Isoparametric Q2 hexahedra for the part of the disk that its symmetries leave, as a scikit-fem mesh."""

from dataclasses import dataclass, replace
from math import ceil

import numpy as np
from skfem import ElementHex2, MeshHex, MeshHex2

from .plane import half_disk

NODES = np.rint(ElementHex2.doflocs * 2).astype(int)
"""Positions (27, 3) in {0, 1, 2}^3 of the nodes of a hexahedron in scikit-fem's order; the first eight are corners."""


@dataclass(frozen=True, kw_only=True)
class Sector:
    """The modelled part of the disk: y >= 0, and z >= 0 too if `quarter`.

    mesh -- MeshHex2 [m]; cell q * layers + k stands over the plane cell q, layer k counted upwards.
    layers -- how many layers.  patch -- (low, high) heights of the patch [m], None if the disk is free.
    """

    mesh: MeshHex2
    layers: int
    quarter: bool
    patch: tuple[float, float] | None

    @property
    def copies(self):
        """How many mirror images make the whole disk."""
        return 4 if self.quarter else 2


def layer_heights(bottom, top, edges, size, radius):
    """Layer boundaries (k + 1,) from bottom to top, graded geometrically to the patch edges that lie between."""
    marks = [bottom, *sorted(e for e in edges if bottom < e < top), top]
    if len(marks) == 2:
        longest = 1.2 * size.width * radius / size.split
        return np.linspace(bottom, top, max(size.split, ceil((top - bottom) / longest)) + 1)
    shrink = np.append(size.ratio ** np.arange(1, size.strips + 1), 0.0)
    pieces = [marks]
    for edge in marks[1:-1]:
        pieces += [edge - (edge - max(m for m in marks if m < edge)) * shrink]
        pieces += [edge + (min(m for m in marks if m > edge) - edge) * shrink]
    return np.unique(np.round(np.concatenate(pieces) / radius, 12)) * radius


def extrude(cells, heights):
    """27 nodes (q * layers, 27, 3) in scikit-fem's order of the hexahedra over plane cells (q, 3, 3, 2)."""
    i, j, k = NODES.T
    nodes = np.empty((len(cells), len(heights) - 1, 27, 3))
    nodes[..., :2] = cells[:, None, i, j]
    low, high = heights[:-1, None], heights[1:, None]
    nodes[..., 2] = low + (high - low) * k / 2
    return nodes.reshape(-1, 27, 3)


def hexahedra(nodes):
    """The scikit-fem mesh (MeshHex2) of cells whose 27 nodes (c, 27, 3) are given; nodes that coincide become one."""
    corners = nodes[:, :8].reshape(-1, 3)
    keys = np.rint(corners / np.abs(nodes).max() * 1e10).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    vertices = np.ascontiguousarray(corners[first].T)
    mesh = MeshHex2.from_mesh(MeshHex(vertices, np.ascontiguousarray(inverse.reshape(-1, 8).T)))
    mesh.doflocs[:, mesh.dofs.element_dofs] = nodes.transpose(2, 1, 0)
    return mesh


def for_edges_inside(size):
    """The `Blocks` for a patch that ends within the thickness: fewer, steeper gradings, as each meets all others."""
    rings = max(1, size.rings - 1)
    return replace(size, rings=rings, ratio=0.15, split=1, strips=rings - 1)


def sector(radius, thickness, support, size):
    """The `Sector` of a disk [m] on a `Support`, graded to the patch edge as the `Blocks` size says."""
    half = thickness / 2
    height = support.height or thickness
    middle = support.position == "middle" or height == thickness
    patch = (-height / 2, height / 2) if middle else (-half, height - half)
    free = support.kind == "free"
    quarter = free or middle
    angle = np.pi if free else np.deg2rad(support.half_angle_deg)
    edges = () if free or height == thickness else patch
    size = for_edges_inside(size) if edges else size
    plane = half_disk(angle, size) * radius
    heights = layer_heights(0.0 if quarter else -half, half, edges, size, radius)
    mesh = hexahedra(extrude(plane, heights))
    return Sector(mesh=mesh, layers=len(heights) - 1, quarter=quarter, patch=None if free else patch)
