"""Mesh the half disk y >= 0 with quadrilaterals, graded towards the ends of a held arc
of its rim.

Lengths are divided by the radius. A block is a function that maps arrays (u, v) in the
unit square to points (..., 2). The rim ring is meshed in the coordinates (angle, depth
below the rim). Nested boxes around the end of the arc resolve the singularity u ~
r^(1/2). Nested boxes around the middle of a short arc grow to the size of the disk.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, inf, pi

import numpy as np
from numpy.typing import ArrayLike

Block = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Map from arrays (u, v) in the unit square to points (..., 2)."""


@dataclass(frozen=True, kw_only=True)
class MeshSize:
    """Resolution of the mesh of a disk."""

    width: float
    """Angular width of a block [rad]."""
    depth: float
    """Depth of the rim ring divided by the radius."""
    rings: int
    """Number of rings of cells around the edge of the patch, see
    `singular_edge_blocks`."""
    ring_ratio: float = 0.3
    """Width ratio of successive rings, smaller to larger."""
    box_ratio: float = 0.6
    """Size ratio of successive nested boxes between patch and disk, smaller to
    larger."""
    upper_edge_blocks: int = 2
    """Minimum number of blocks along the upper edge of a partial-height patch."""
    split: int = 1
    """Number of cells per block in each direction."""

    @property
    def layers(self) -> int:
        """Number of layers of blocks between the rim ring and the central square, about
        as wide as other blocks."""
        return max(1, round((1 - self.depth) / 2 / self.width))


def bilinear_block(corners: ArrayLike) -> Block:
    """Return the block with straight sides between four corners (4, 2),
    counter-clockwise in (u, v)."""
    a, b, c, d = np.asarray(corners, float)

    def block(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        u = u[..., None]
        v = v[..., None]
        lower = a * (1 - u) * (1 - v) + b * u * (1 - v)
        return lower + c * u * v + d * (1 - u) * v

    return block


def polar_block(corners: ArrayLike) -> Block:
    """Return the block with four corners (4, 2) in (angle, depth)."""
    return rim_mapped_block(bilinear_block(corners))


def rim_mapped_block(
    flat: Block, edge: float = 0.0, scale: float | np.ndarray = 1.0
) -> Block:
    """Return the block with the coordinates (angle, depth) = (edge, 0) + scale * (point
    of a flat block)."""

    def block(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        angle, depth = np.moveaxis([edge, 0] + scale * flat(u, v), -1, 0)
        distance = 1 - depth
        return np.stack([distance * np.cos(angle), distance * np.sin(angle)], -1)

    return block


def singular_edge_blocks(
    size: MeshSize, aspect: float = 1.0, max_squared_share: float = inf
) -> list[Block]:
    """Return blocks of the box [-1, 1] x [0, 1] that resolve u ~ r^(1/2) at the origin.

    The box is later stretched to `aspect` times the depth. The map z = w^2 transforms a
    quarter turn to a half turn about the origin, and linear functions of w to r^(1/2)
    cos(theta/2) and r^(1/2) sin(theta/2). Quadratic cells in the w plane represent both
    the map and the field, as quarter-point elements do along their sides (Henshell &
    Shaw 1975, Barsoum 1976). Rings of four cells shrink geometrically towards the
    origin, and the outermost ring connects them to the box. The squared cells cover a
    share of the box of at most `max_squared_share`. If the number of rings is 0, there
    are two plain cells.
    """
    corners = np.array(
        [
            (1, 0),
            (1, 1),
            (0, 1),
            (-1, 1),
            (-1, 0),
        ],
        float,
    )
    if not size.rings:
        return [bilinear_block([*corners[i : i + 3], (0, 0)]) for i in (0, 2)]
    squared_share = min(0.6, max_squared_share)
    scale = squared_share * np.array([min(1, aspect), min(1, 1 / aspect)])
    widths = size.ring_ratio ** np.arange(float(size.rings))
    # corners in the w plane of the outer sides of four convex cells; their squares are
    # the corners of half a square, except at its top
    first = np.array([1, 1 + 1j, 1.3j, -1 + 1j, -1]) ** 0.5
    last = widths[-1] * first
    blocks = []
    for i in range(4):
        curve = squared_block([first[i], first[i + 1]] * 2, scale)
        blocks.append(joining_block(corners[i : i + 2], curve))
    for w, s in pairwise(widths):
        for i in range(4):
            quad = [w * first[i], w * first[i + 1], s * first[i + 1], s * first[i]]
            blocks.append(squared_block(quad, scale))
    right, middle, left = last[::2] / 2
    innermost = [
        [0, right, middle, left],
        [right, last[0], last[1], middle],
        [middle, *last[1:4]],
        [left, middle, *last[3:]],
    ]
    return blocks + [squared_block(quad, scale) for quad in innermost]


def squared_block(corners: ArrayLike, scale: np.ndarray) -> Block:
    """Return the image under z = w^2, times `scale` (2,), of the straight block with
    corners (4,) in the w plane."""
    flat = bilinear_block([(w.real, w.imag) for w in np.array(corners, complex)])

    def block(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        x, y = np.moveaxis(flat(u, v), -1, 0)
        return scale * np.stack([x**2 - y**2, 2 * x * y], -1)

    return block


def joining_block(
    line: np.ndarray | tuple[np.ndarray, np.ndarray], curve: Block
) -> Block:
    """Return the block between a straight line through two points (2, 2) and the lower
    side of another block."""
    start, stop = line

    def block(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return (1 - v[..., None]) * (start + u[..., None] * (stop - start)) + v[
            ..., None
        ] * curve(
            u,
            0 * v,
        )

    return block


def edge_box_depth(half_angle: float, size: MeshSize) -> float:
    """Return the depth of the box around the end of an arc of a half angle [rad].

    It equals the depth of the rim ring if the arc is at least as wide as a block. For a
    shorter arc it hardly exceeds the half angle, a limit with a margin for nearly
    incompressible disks.
    """
    max_aspect = 1.1  # ratio of depth to half angle
    if half_angle >= size.width:
        return size.depth
    return min(max_aspect * half_angle, size.depth * (half_angle / size.width) ** 0.5)


def short_arc_blocks(half_angle: float, size: MeshSize) -> list[Block]:
    """Return the rim blocks that coarsen the mesh from a short arc to one block of the
    rim.

    They lead from the angles [0, 2 `half_angle`] to the angles [0, 2 width]; both
    ranges are split in the middle."""
    count = max(1, round(np.log(half_angle / size.width) / np.log(size.box_ratio)))
    share = np.arange(count + 1) / count
    widths = size.width * (half_angle / size.width) ** share
    depths = size.depth * (edge_box_depth(half_angle, size) / size.depth) ** share
    corners = []
    for (w, s), (d, e) in zip(pairwise(widths), pairwise(depths), strict=True):
        outer = [(2 * s, 0), (2 * w, 0), (2 * w, d), (2 * s, e)]
        inner = [(0, d), (0, e), (s, e), (w, d)]
        middle = [(w, d), (s, e), (2 * s, e), (2 * w, d)]
        corners += [outer, inner, middle]
    return [polar_block(c) for c in corners]


def rim_ring(edge: float, size: MeshSize) -> tuple[list[Block], np.ndarray]:
    """Return the blocks of the rim ring for an arc of half angle `edge` <= pi/2, and
    the angles of its columns.

    The width of the squared cells is limited, because quadratic
    cells in the w plane cannot represent a longer arc of the rim.
    """
    max_squared_width = 0.3  # rad
    width = size.width
    half = min(edge, size.width)
    depth = edge_box_depth(half, size)
    about_edge = singular_edge_blocks(size, depth / half, max_squared_width / half)
    blocks = [
        rim_mapped_block(flat, edge, np.array([half, depth])) for flat in about_edge
    ]
    if edge < (1 - 1e-9) * width:
        blocks += short_arc_blocks(edge, size)
    middle = max(edge, width)
    first = middle - width
    last = middle + width
    before = ceil(first / width - 1e-9)
    after = ceil((pi - last) / width - 1e-9)
    after += (before + after) % 2
    left = np.linspace(0, first, before + 1)
    right = np.linspace(last, pi, after + 1)
    for angles in (left, right):
        blocks += rim_blocks(angles, size.depth)
    return blocks, np.concatenate([left, [middle], right])


def rim_blocks(angles: np.ndarray, depth: float) -> list[Block]:
    """Return plain blocks of a rim ring of a given depth between successive angles (k +
    1,) [rad]."""
    return [
        polar_block([(a, 0), (b, 0), (b, depth), (a, depth)])
        for a, b in pairwise(angles)
    ]


def square_outline(directions: np.ndarray, depth: float) -> np.ndarray:
    """Return the corners and the middles of the sides (5, 2) of half the central square.

    They are within pi/4 of equally spaced directions, towards `directions` (5,) [rad].
    """
    even = np.linspace(0, pi, 5)
    directions = np.clip(directions, even - pi / 4, even + pi / 4)
    distance = np.array([0.5, 0.6, 0.5, 0.6, 0.5])[:, None] * (1 - depth)
    return distance * np.stack([np.cos(directions), np.sin(directions)], axis=1)


def core_blocks(angles: np.ndarray, depth: float, layers: int = 1) -> list[Block]:
    """Return the blocks inside the rim ring: layers around a central square of two
    macro cells.

    The corners of the square point towards the columns that end there, within pi/4 of
    equally spaced directions.
    """
    half = (len(angles) - 1) // 2
    m = ceil(half / 2)
    n = half // 2
    outline = square_outline(angles[[0, m, half, half + n, 2 * half]], depth)
    sides = zip(pairwise(outline), (m, n, n, m), strict=True)
    points = np.vstack(
        [outline[:1], *[np.linspace(a, b, k + 1)[1:] for (a, b), k in sides]]
    )
    arcs = [polar_block([(a, depth), (b, depth)] * 2) for a, b in pairwise(angles)]
    blocks = []
    for line, arc in zip(pairwise(points), arcs, strict=True):
        ring = joining_block(line, arc)
        for j in range(layers):
            blocks.append(sub_block(ring, 0, 1, 1 - j / layers, 1 - (j + 1) / layers))
    for corner in (1, 3):
        macro = bilinear_block(
            [(0, 0), outline[2 * corner - 2], outline[corner], outline[2]]
        )
        for i in range(n):
            for j in range(m):
                blocks.append(sub_block(macro, i / n, (i + 1) / n, j / m, (j + 1) / m))
    return blocks


def sub_block(block: Block, u0: float, u1: float, v0: float, v1: float) -> Block:
    """Return the block restricted to a rectangle of its unit square."""
    return lambda u, v: block(u0 + u * (u1 - u0), v0 + v * (v1 - v0))


def cells_of_blocks(blocks: list[Block], size: MeshSize) -> np.ndarray:
    """Return the nodes (q, 3, 3, 2) of the biquadratic cells of blocks, with
    `size.split`^2 cells per block."""
    u, v = np.meshgrid(*[np.linspace(0, 1, 2 * size.split + 1)] * 2, indexing="ij")
    grids = np.array([block(u, v) for block in blocks])
    cells = []
    for i in range(0, 2 * size.split, 2):
        for j in range(0, 2 * size.split, 2):
            cells.append(grids[:, i : i + 3, j : j + 3])
    return make_right_handed(np.concatenate(cells))


def half_disk(half_angle: float, size: MeshSize) -> np.ndarray:
    """Return the nodes (q, 3, 3, 2) of the biquadratic cells of the half disk for a
    `MeshSize`.

    Cell sides cover exactly the arc [0, half_angle] [rad] of the rim. For an arc longer
    than pi/2 the mesh for the remaining free arc is mirrored.
    """
    mirrored = half_angle > pi / 2
    edge = pi - half_angle if mirrored else half_angle
    if edge < 1e-12:
        angles = np.linspace(0, pi, 2 * ceil(pi / (2 * size.width) - 1e-9) + 1)
        ring = rim_blocks(angles, size.depth)
    else:
        ring, angles = rim_ring(edge, size)
    cells = cells_of_blocks(ring + core_blocks(angles, size.depth, size.layers), size)
    return make_right_handed(cells * [-1, 1]) if mirrored else cells


def make_right_handed(cells: np.ndarray) -> np.ndarray:
    """Exchange u and v of left-handed cells (q, 3, 3, 2) in place and return all
    cells."""
    du = cells[:, 2, 1] - cells[:, 0, 1]
    dv = cells[:, 1, 2] - cells[:, 1, 0]
    left_handed = du[:, 0] * dv[:, 1] < du[:, 1] * dv[:, 0]
    cells[left_handed] = np.swapaxes(cells[left_handed], 1, 2)
    return cells
