"""The half disk y >= 0 in quadrilaterals that shrink geometrically towards the edge of an arc held on its rim.

Everything is in units of the radius. A block is a function from the unit square, (u, v) arrays, to points (..., 2).
The rim ring is laid out in (angle, depth below the rim); boxes nested about the edge of the arc carry the singularity
u ~ r^(1/2), boxes nested about the middle of a short arc lead over to the size of the disk.
"""

from dataclasses import dataclass
from itertools import pairwise
from math import ceil, pi

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Blocks:
    """How coarse: angular `width` [rad] of a block, `depth` of the rim ring over the radius, `rings` about the patch
    edge (see `about_edge`), each `ratio` times as wide as the last, boxes of ratio `lead` that lead over to the size of
    the disk, at least `legs` blocks along the upper edge of a patch that ends within the thickness; every block is
    `split` cells wide."""

    width: float
    depth: float
    rings: int
    ratio: float = 0.3
    lead: float = 0.6
    legs: int = 2
    split: int = 1

    @property
    def layers(self):
        """Layers of blocks between the rim ring and the square inside it, about as wide as the others."""
        return max(1, round((1 - self.depth) / 2 / self.width))


def bilinear(corners):
    """The block with four corners (4, 2), counter-clockwise in (u, v)."""
    a, b, c, d = np.asarray(corners, float)

    def block(u, v):
        u, v = u[..., None], v[..., None]
        return a * (1 - u) * (1 - v) + b * u * (1 - v) + c * u * v + d * (1 - u) * v

    return block


def polar(corners):
    """The block whose four corners are given as (angle, depth)."""
    return around_rim(bilinear(corners))


def around_rim(flat, edge=0.0, scale=1.0):
    """The block at the rim whose angle about `edge` and depth are `scale`, one for both or (2,), times a flat one's."""

    def block(u, v):
        angle, depth = np.moveaxis([edge, 0] + scale * flat(u, v), -1, 0)
        return np.stack([(1 - depth) * np.cos(angle), (1 - depth) * np.sin(angle)], -1)

    return block


REACH, WIDEST = 0.6, 0.3
"""Width of the squared cells over that of the box about the edge that they are linked to, and at most [rad]: quadratic
cells of the plane w cannot follow a longer arc of the rim."""
QUARTER = np.array([1, 1 + 1j, 1.3j, -1 + 1j, -1]) ** 0.5
"""Corners (5,) of the outer sides of four cells of the plane w, convex; their squares are those of half a square, but
for its top."""


def about_edge(size, aspect=1.0, reach=REACH):
    """Blocks of [-1, 1] x [0, 1], `aspect` times as deep as half its width, about the origin, where u ~ r^(1/2).

    Squared, z = w^2, a quarter turn becomes the half turn about the origin, and linear functions of w become
    r^(1/2) cos(theta/2), r^(1/2) sin(theta/2): quadratic cells of the plane w hold both the map and the field, as
    quarter-point elements do along their sides (Henshell & Shaw 1975, Barsoum 1976). Rings of four cells lead to the
    origin, geometrically; the outermost one is the link to the box. Without any ring two plain cells are left.
    """
    corners = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0)], float)
    if not size.rings:
        return [bilinear([corners[i], corners[i + 1], corners[i + 2], (0, 0)]) for i in (0, 2)]
    scale = reach * np.array([min(1, aspect), min(1, 1 / aspect)])
    widths = size.ratio ** np.arange(float(size.rings))
    first, last = QUARTER, widths[-1] * QUARTER
    blocks = [link(corners[i : i + 2], squared([first[i], first[i + 1]] * 2, scale)) for i in range(4)]
    for w, s in pairwise(widths):
        rings = [[w * first[i], w * first[i + 1], s * first[i + 1], s * first[i]] for i in range(4)]
        blocks += [squared(quad, scale) for quad in rings]
    right, middle, left = last[::2] / 2
    inner = [[0, right, middle, left], [right, last[0], last[1], middle], [middle, *last[1:4]]]
    return blocks + [squared(quad, scale) for quad in [*inner, [left, middle, *last[3:]]]]


def squared(corners, scale):
    """The image under z = w^2, times scale (2,), of the straight block with corners (4,) in the plane w."""
    flat = bilinear([(w.real, w.imag) for w in np.array(corners, complex)])

    def block(u, v):
        x, y = np.moveaxis(flat(u, v), -1, 0)
        return scale * np.stack([x**2 - y**2, 2 * x * y], -1)

    return block


def link(line, curve):
    """The block between a straight line, two points (2, 2), and the lower side of another block."""
    start, stop = line

    def block(u, v):
        return (1 - v[..., None]) * (start + u[..., None] * (stop - start)) + v[..., None] * curve(u, 0 * v)

    return block


DEEP = 1.1
"""Depth over half-width of the box about the edge of a short arc, which gives nearly incompressible disks room."""


def depth_about_edge(half_angle, size):
    """Depth of the box about the edge of an arc; that of the rim ring where it is as wide as a block or wider."""
    if half_angle >= size.width:
        return size.depth
    return min(DEEP * half_angle, size.depth * (half_angle / size.width) ** 0.5)


def nested_about_middle(half_angle, size):
    """Blocks between the box [0, 2 width] and the box [0, 2 half_angle] at the rim, both split at their middles."""
    count = max(1, round(np.log(half_angle / size.width) / np.log(size.lead)))
    widths = size.width * (half_angle / size.width) ** (np.arange(count + 1) / count)
    depths = size.depth * (depth_about_edge(half_angle, size) / size.depth) ** (np.arange(count + 1) / count)
    corners = []
    for w, s, d, e in zip(widths, widths[1:], depths, depths[1:], strict=False):
        corners += [[(2 * s, 0), (2 * w, 0), (2 * w, d), (2 * s, e)]]
        corners += [[(0, d), (0, e), (s, e), (w, d)], [(w, d), (s, e), (2 * s, e), (2 * w, d)]]
    return [polar(c) for c in corners]


def rim_ring(edge, size):
    """Blocks of the rim ring for an arc of half-angle `edge` <= pi/2, and the angles (k + 1,) of its columns."""
    width, half = size.width, min(edge, size.width)
    depth = depth_about_edge(half, size)
    about = about_edge(size, depth / half, min(REACH, WIDEST / half))
    blocks = [around_rim(flat, edge, np.array([half, depth])) for flat in about]
    if edge < (1 - 1e-9) * width:
        blocks += nested_about_middle(edge, size)
    middle = max(edge, width)
    first, last = middle - width, middle + width
    before, after = ceil(first / width - 1e-9), ceil((pi - last) / width - 1e-9)
    after += (before + after) % 2
    left, right = np.linspace(0, first, before + 1), np.linspace(last, pi, after + 1)
    for angles in (left, right):
        blocks += columns(angles, size.depth)
    return blocks, np.concatenate([left, [middle], right])


def columns(angles, depth):
    """Plain blocks of the rim ring between successive angles (k + 1,)."""
    return [polar([(a, 0), (b, 0), (b, depth), (a, depth)]) for a, b in pairwise(angles)]


def core(angles, depth, layers=1):
    """Blocks inside the rim ring: a ring of layers between its columns and a square of two macro cells, and the square.

    The corners of the square lie where the columns that end there point to, within half a right angle of even ones.
    """
    half = (len(angles) - 1) // 2
    m, n = ceil(half / 2), half // 2
    even = np.linspace(0, pi, 5)
    turned = np.clip(angles[[0, m, half, half + n, 2 * half]], even - pi / 4, even + pi / 4)
    reach = np.array([0.5, 0.6, 0.5, 0.6, 0.5])[:, None] * (1 - depth)
    outline = reach * np.stack([np.cos(turned), np.sin(turned)], axis=1)
    steps = [np.linspace(a, b, k + 1)[1:] for a, b, k in zip(outline, outline[1:], (m, n, n, m), strict=False)]
    points = np.vstack([outline[:1], *steps])
    arcs = [polar([(a, depth), (b, depth)] * 2) for a, b in pairwise(angles)]
    ring = [link(line, arc) for line, arc in zip(pairwise(points), arcs, strict=True)]
    blocks = [part(block, 0, 1, 1 - j / layers, 1 - (j + 1) / layers) for block in ring for j in range(layers)]
    for corner in (1, 3):
        macro = bilinear([(0, 0), outline[2 * corner - 2], outline[corner], outline[2]])
        for i in range(n):
            for j in range(m):
                blocks.append(part(macro, i / n, (i + 1) / n, j / m, (j + 1) / m))
    return blocks


def part(block, u0, u1, v0, v1):
    """The block restricted to a rectangle of its unit square."""
    return lambda u, v: block(u0 + u * (u1 - u0), v0 + v * (v1 - v0))


def divided(blocks, size):
    """Nine points (q, 3, 3, 2) of each biquadratic cell of the blocks."""
    u, v = np.meshgrid(*[np.linspace(0, 1, 2 * size.split + 1)] * 2, indexing="ij")
    grids = np.array([block(u, v) for block in blocks])
    starts = range(0, 2 * size.split, 2)
    return positive(np.concatenate([grids[:, i : i + 3, j : j + 3] for i in starts for j in starts]))


def half_disk(half_angle, size):
    """Nine points (q, 3, 3, 2) of each biquadratic cell of the half disk; `size` is a `Blocks`.

    The arc [0, half_angle] [rad] of the rim is a union of cell sides. An arc beyond pi/2 is meshed from its free end.
    """
    reflect = half_angle > pi / 2
    edge = pi - half_angle if reflect else half_angle
    if edge < 1e-12:
        angles = np.linspace(0, pi, 2 * ceil(pi / (2 * size.width) - 1e-9) + 1)
        ring = columns(angles, size.depth)
    else:
        ring, angles = rim_ring(edge, size)
    cells = divided(ring + core(angles, size.depth, size.layers), size)
    return positive(cells * [-1, 1]) if reflect else cells


def positive(cells):
    """The cells (q, 3, 3, 2) with u and v exchanged where they were left-handed."""
    du, dv = cells[:, 2, 1] - cells[:, 0, 1], cells[:, 1, 2] - cells[:, 1, 0]
    left = du[:, 0] * dv[:, 1] < du[:, 1] * dv[:, 0]
    cells[left] = np.swapaxes(cells[left], 1, 2)
    return cells
