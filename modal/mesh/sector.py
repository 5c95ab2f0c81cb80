"""Isoparametric Q2 hexahedra for the part of the disk that its symmetries leave, as a scikit-fem mesh."""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from skfem import ElementHex2, MeshHex, MeshHex2

from modal.mesh.half_disk import columns, core, divided, half_disk
from modal.mesh.patch_box import filled, longest, nest

NODES = np.rint(ElementHex2.doflocs * 2).astype(int)
"""Positions (27, 3) in {0, 1, 2}^3 of the nodes of a hexahedron in scikit-fem's order; the first eight are corners."""


@dataclass(frozen=True, kw_only=True)
class Sector:
    """The modelled part of the disk: y >= 0, and z >= 0 too if `quarter`.

    mesh -- MeshHex2 [m].  patch -- (low, high) heights of the patch [m], None if the disk is free.
    """

    mesh: MeshHex2
    quarter: bool
    patch: tuple[float, float] | None

    @property
    def copies(self):
        """How many mirror images make the whole disk."""
        return 4 if self.quarter else 2


def layers(bottom, top, size, radius):
    """Boundaries (k + 1,) [m] of even layers from bottom to top, none thicker than the plane cells are wide."""
    count = ceil((top - bottom) / (longest(size) * radius) - 1e-9)
    return np.linspace(bottom, top, size.split * max(1, count) + 1)


def extrude(cells, heights):
    """27 nodes (q * layers, 27, 3) in scikit-fem's order of the hexahedra over plane cells (q, 3, 3, 2)."""
    i, j, k = NODES.T
    nodes = np.empty((len(cells), len(heights) - 1, 27, 3))
    nodes[..., :2] = cells[:, None, i, j]
    low, high = heights[:-1, None], heights[1:, None]
    nodes[..., 2] = low + (high - low) * k / 2
    return nodes.reshape(-1, 27, 3)


def hexahedra(nodes, linear=MeshHex, quadratic=MeshHex2):
    """The scikit-fem mesh of class `quadratic`, made from class `linear`, of cells whose nodes (c, n, 3) are given;
    nodes that coincide become one."""
    count = linear.elem.refdom.nnodes
    corners = nodes[:, :count].reshape(-1, 3)
    near = cKDTree(corners).query_pairs(1e-10 * np.abs(nodes).max(), output_type="ndarray")
    same = coo_matrix((np.ones(len(near)), near.T), shape=(len(corners),) * 2)
    inverse = connected_components(same, directed=False)[1]
    vertices = np.ascontiguousarray(corners[np.unique(inverse, return_index=True)[1]].T)
    mesh = quadratic.from_mesh(linear(vertices, np.ascontiguousarray(inverse.reshape(-1, count).T)))
    mesh.doflocs[:, mesh.dofs.element_dofs] = nodes.transpose(2, 1, 0)
    return mesh


def placed(places, radius, bottom):
    """Nodes (c, 27, 3) [m] in scikit-fem's order of cells at places (c, 3, 3, 3, 3), see `box`, made right-handed."""
    angle, depth, height = np.moveaxis(places, -1, 0)
    across = (1 - depth) * radius
    points = np.stack([across * np.cos(angle), across * np.sin(angle), height * radius + bottom], -1)
    sides = [np.take(points, 2, axis)[:, 1, 1] - np.take(points, 0, axis)[:, 1, 1] for axis in (1, 2, 3)]
    left = np.linalg.det(np.stack(sides, -1)) < 0
    points[left] = np.swapaxes(points[left], 1, 2)
    i, j, k = NODES.T
    return points[:, i, j, k]


def over_part(radius, bottom, top, angle, height, size):
    """Cell nodes (c, 27, 3) [m] of a disk held on an arc [rad] from the bottom of what is meshed to a height [m]."""
    nested = nest(angle, height / radius, (top - bottom) / radius, size)
    last, n = nested.boxes[-1], nested.around
    rest = round((pi - last[0]) / size.width)
    rest += (n + rest) % 2
    angles = np.append(np.linspace(0, last[0], n + 1), np.linspace(last[0], pi, rest + 1)[1:])
    ring, inner = columns(angles, size.depth), core(angles, size.depth, size.layers)
    middle = bottom + last[2] * radius
    lower = np.linspace(bottom, middle, size.split * nested.through + 1)
    cells = [placed(filled(nested, size), radius, bottom), extrude(divided(ring[n:] + inner, size) * radius, lower)]
    if top - middle > 1e-9 * radius:
        cells.append(extrude(divided(ring + inner, size) * radius, layers(middle, top, size, radius)))
    return np.concatenate(cells)


WHOLE = 0.985
"""Share of the thickness from which a patch is taken to cover all of it: the strip left free would change no frequency
by more than 0.4 %, and is so thin that cells about it err by more."""


def held_height(thickness, support):
    """The height [m] over which the patch of a `Support` is modelled; without one the thickness."""
    height = support.height if support.kind == "patch" and support.height else thickness
    return height if height < WHOLE * thickness else thickness


def patch_edge(radius, thickness, support):
    """Points (6, 3) [m] of the lower and the upper edge of the patch."""
    angle = np.deg2rad(support.half_angle_deg) * np.array([-1, 0, 1])
    height = held_height(thickness, support)
    bottom = -thickness / 2 if support.position == "bottom" else -height / 2
    x, y = radius * np.cos(angle), radius * np.sin(angle)
    return np.concatenate([np.stack([x, y, np.full(3, z)], axis=1) for z in (bottom, bottom + height)])


def sector(radius, thickness, support, size):
    """The `Sector` of a disk [m] on a `Support`, graded to the patch edge as the `Blocks` size says."""
    half, free = thickness / 2, support.kind == "free"
    height = held_height(thickness, support)
    whole = free or height == thickness
    middle = whole or support.position == "middle"
    bottom = 0.0 if middle else -half
    reach = height / 2 if middle else height
    angle = pi if free else np.deg2rad(support.half_angle_deg)
    if whole:
        nodes = extrude(half_disk(angle, size) * radius, layers(bottom, half, size, radius))
    else:
        nodes = over_part(radius, bottom, half, angle, reach, size)
    patch = None if free else (-reach if middle else bottom, bottom + reach)
    return Sector(mesh=hexahedra(nodes), quarter=middle, patch=patch)
