"""Hexahedra under a patch that ends within the thickness: boxes nested at the rim about the middle of the patch.

In (angle, depth below the rim, height over the lower plane), lengths over the radius, a box is [0, angle] x [0, depth]
x [0, height], and the patch is the outer side of one of them. Along its two edges, where u ~ r^(1/2), the boxes next
to it give way to a tube whose cross-section shrinks geometrically to the edge, mitred at the corner of the patch.
"""

from dataclasses import dataclass
from itertools import product
from math import ceil, log, pi

import numpy as np

from .plane import LEAD, bilinear, half_squares


@dataclass(frozen=True, kw_only=True)
class Nest:
    """Boxes (b, 3) as (angle [rad], depth, height): one inside the patch, the patch's, one beyond it, and those that
    lead over to the size of the disk; `around` and `through`: counts of cells along the angle and the height."""

    boxes: np.ndarray
    around: int
    through: int


def longest(size):
    """Largest height of a layer over the radius."""
    return 1.2 * size.width


def nest(angle, height, top, size):
    """The `Nest` of a patch of a half-angle [rad] and a height below `top`; size is a `Blocks`."""
    width, rest = size.width, top - height
    last = np.array([min(pi, max(angle, width / 4) + width), size.depth, height + min(rest, longest(size))])
    if rest < 1.5 * longest(size):
        last[2] = top
    patch = np.array([angle, min(angle, height, size.depth / 3), height])
    inner = np.array([max(angle / 2, angle - width), patch[1] / 2, height / 2])
    outer = np.minimum([angle + min(angle, width), 2 * patch[1], 2 * height], last)
    count = max(1, round(log((last / outer).max()) / log(1 / LEAD)))
    leads = outer * (last / outer) ** (np.arange(1, count + 1)[:, None] / count)
    around = max(size.legs, ceil(last[0] / size.width - 1e-9))
    return Nest(
        boxes=np.vstack([inner, patch, outer, leads]),
        around=around + around % 2 if last[0] == pi else around,
        through=max(size.legs, ceil(last[2] / longest(size) - 1e-9)),
    )


def beside(boxes, s, e, t):
    """Places (..., 3) on the side of box s that faces along the rim, at e of its depth, t of its height.

    Box s (...) lies between the successive ones (b, 3), which are numbered 0, 1, ...
    """
    angle, depth, height = within(boxes, s)
    return np.stack([angle, e * depth, t * height], -1)


def above(boxes, s, e, t):
    """Places (..., 3) on the side of box s that faces along the axis, at e of its depth, t of its angle."""
    angle, depth, height = within(boxes, s)
    return np.stack([t * angle, e * depth, height], -1)


def below(boxes, s, t, w):
    """Places (..., 3) on the side of box s that faces inwards, at t of its angle, w of its height."""
    angle, depth, height = within(boxes, s)
    return np.stack([t * angle, depth, w * height], -1)


def within(boxes, s):
    """Angle, depth and height (...) of box s (...)."""
    return [np.interp(s, np.arange(len(boxes)), column) for column in boxes.T]


def cut(block, *counts):
    """Places (c, 3, 3, 3, 3) of the nodes of a block, a function of the unit cube, cut into counts of cells."""
    grid = block(*np.meshgrid(*[np.linspace(0, 1, 2 * n + 1) for n in counts], indexing="ij"))
    starts = product(*[range(0, 2 * n, 2) for n in counts])
    return np.array([grid[i : i + 3, j : j + 3, k : k + 3] for i, j, k in starts])


def filled(nested, size):
    """Places (c, 3, 3, 3, 3) of the nodes of all cells of the last box; the first index of nodes runs outwards."""
    boxes, n = nested.boxes, size.split
    around, through = n * nested.around, n * nested.through
    cells = [cut(lambda u, v, w: np.stack([v, u, w], -1) * boxes[0], n, around, through)]
    for i in range(len(boxes) - 1):
        cells.append(cut(lambda u, v, w, i=i: below(boxes, i + u, v, w), n, around, through))
    for side, along in ((beside, through), (above, around)):
        for i in range(2, len(boxes) - 1):
            cells.append(cut(lambda u, v, w, i=i, side=side: side(boxes, i + u, v, w), n, n, along))
        cells += [cut(tube(boxes, side, bilinear(quad)), n, n, along) for quad in half_squares(size)]
    return solid(np.concatenate(cells))


def tube(boxes, side, quad):
    """The block along an edge of the patch over a quadrilateral of its cross-section [-1, 1] x [0, 1]."""

    def block(u, v, w):
        s, e = np.moveaxis(quad(u, v), -1, 0)
        return side(boxes, 1 + s, e, w)

    return block


def solid(places):
    """The cells that have a volume: where boxes end on the same face there is none between them."""
    return places[(np.ptp(places.reshape(len(places), 27, 3), axis=1) > 1e-12).all(axis=1)]
