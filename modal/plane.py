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
    """How coarse: angular `width` [rad] of a block, `depth` of the rim ring over the radius, `rings` boxes of ratio
    `ratio` nested about the patch edge, further ones of ratio `lead` that lead over to the size of the disk, at least
    `legs` blocks along the upper edge of a patch that ends within the thickness; every block is `split` cells wide."""

    width: float
    depth: float
    rings: int
    ratio: float = 0.25
    lead: float = 0.5
    legs: int = 2
    split: int = 1


def bilinear(corners):
    """The block with four corners (4, 2), counter-clockwise in (u, v)."""
    a, b, c, d = np.asarray(corners, float)

    def block(u, v):
        u, v = u[..., None], v[..., None]
        return a * (1 - u) * (1 - v) + b * u * (1 - v) + c * u * v + d * (1 - u) * v

    return block


def polar(corners):
    """The block whose four corners are given as (angle, depth)."""
    flat = bilinear(corners)

    def block(u, v):
        angle, depth = np.moveaxis(flat(u, v), -1, 0)
        return np.stack([(1 - depth) * np.cos(angle), (1 - depth) * np.sin(angle)], -1)

    return block


def between(inner, angles, depth):
    """The block between a straight line, two points (2, 2), and an arc at some depth, two angles."""
    arc = polar([(angles[0], depth), (angles[1], depth)] * 2)
    start, stop = np.asarray(inner, float)

    def block(u, v):
        line = start + u[..., None] * (stop - start)
        return (1 - v[..., None]) * arc(u, 0 * v) + v[..., None] * line

    return block


def half_squares(size):
    """Corners (n, 4, 2) of the cells of [-1, 1] x [0, 1] about its origin: half-square rings, two cells inside them."""
    corners = []
    widths = size.ratio ** np.arange(size.rings + 1.0)
    for w, s in pairwise(widths):
        corners += [[(-w, 0), (-s, 0), (-s, s), (-w, w)], [(-w, w), (-s, s), (0, s), (0, w)]]
        corners += [[(0, w), (0, s), (s, s), (w, w)], [(s, 0), (w, 0), (w, w), (s, s)]]
    w = widths[-1]
    corners += [[(-w, 0), (0, 0), (0, w), (-w, w)], [(0, 0), (w, 0), (w, w), (0, w)]]
    return np.array(corners)


def nested_about_edge(edge, width, size):
    """Blocks in the box of half-width `width` about the angle `edge`."""
    return [polar([edge, 0] + [width, width * size.depth / size.width] * corners) for corners in half_squares(size)]


def nested_about_middle(half_angle, size):
    """Blocks between the box [0, 2 width] and the box [0, 2 half_angle] at the rim, both split at their middles."""
    count = max(1, round(np.log(half_angle / size.width) / np.log(size.lead)))
    widths = size.width * (half_angle / size.width) ** (np.arange(count + 1) / count)
    depths = widths * size.depth / size.width
    corners = []
    for w, s, d, e in zip(widths, widths[1:], depths, depths[1:], strict=False):
        corners += [[(2 * s, 0), (2 * w, 0), (2 * w, d), (2 * s, e)]]
        corners += [[(0, d), (0, e), (s, e), (w, d)], [(w, d), (s, e), (2 * s, e), (2 * w, d)]]
    return [polar(c) for c in corners]


def rim_ring(edge, size):
    """Blocks of the rim ring for an arc of half-angle `edge` <= pi/2, and the angles (k + 1,) of its columns."""
    width = size.width
    blocks = nested_about_edge(edge, min(edge, width), size)
    if edge < width:
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


def core(angles, depth):
    """Blocks inside the rim ring: a ring between its columns and a square of two macro cells, and the square."""
    half = (len(angles) - 1) // 2
    m, n = ceil(half / 2), half // 2
    side, corner = 0.5 * (1 - depth), 0.42 * (1 - depth)
    outline = [(side, 0), (corner, corner), (0, side), (-corner, corner), (-side, 0)]
    steps = [np.linspace(a, b, k + 1)[1:] for a, b, k in zip(outline, outline[1:], (m, n, n, m), strict=False)]
    points = np.vstack([outline[:1], *steps])
    blocks = [between(points[i : i + 2], angles[i : i + 2], depth) for i in range(2 * half)]
    for sign in (1, -1):
        macro = bilinear([(0, 0), (sign * side, 0), (sign * corner, corner), (0, side)])
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
    cells = divided(ring + core(angles, size.depth), size)
    return positive(cells * [-1, 1]) if reflect else cells


def positive(cells):
    """The cells (q, 3, 3, 2) with u and v exchanged where they were left-handed."""
    du, dv = cells[:, 2, 1] - cells[:, 0, 1], cells[:, 1, 2] - cells[:, 1, 0]
    left = du[:, 0] * dv[:, 1] < du[:, 1] * dv[:, 0]
    cells[left] = np.swapaxes(cells[left], 1, 2)
    return cells
