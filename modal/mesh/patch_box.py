"""Hexahedra under a patch that ends within the thickness: boxes nested at the rim about the middle of the patch.

In (angle, depth below the rim, height over the lower plane), lengths over the radius, a box is [0, angle] x [0, depth]
x [0, height], and the patch is the outer side of one of them. Along its two edges, where u ~ r^(1/2), the boxes next
to it give way to a tube whose cross-section is that of `about_edge`, mitred at the corner of the patch.
"""

from dataclasses import dataclass
from itertools import product
from math import ceil, log, pi

import numpy as np

from modal.mesh.half_disk import about_edge, bilinear

STRIP = 4
"""Width of the tubes over that of the strip left free beyond the patch, at most: a wider one would hold the face."""
LONGEST = 3
"""Most cells along the upper edge of a long patch over `legs`; a short one has `legs`."""


@dataclass(frozen=True, kw_only=True)
class Nest:
    """Boxes (b, 3) as (angle [rad], depth, height), of which number `patch` is that of the patch; `around` and
    `through`: counts of cells along the angle and the height."""

    boxes: np.ndarray
    patch: int
    around: int
    through: int


def longest(size):
    """Largest height of a layer over the radius."""
    return 1.2 * size.width


def steps(first, last, lead):
    """Distances (k, n) from first (n,) to last (n,), k >= 2, that shrink by about `lead`; 0 remains 0."""
    growth = np.divide(last, first, out=np.ones(len(first)), where=first > 0)
    count = max(1, ceil(log(growth.max()) / log(1 / lead) - 0.5))
    return first * growth ** (np.arange(count + 1)[:, None] / count)


def nest(angle, height, top, size):
    """The `Nest` of a patch of a half-angle [rad] and a height below `top`; size is a `Blocks`.

    A patch that goes all around has boxes that do.
    """
    width, rest = size.width, top - height
    beyond = min(pi - angle, max(angle, width / 4) + width - angle)
    above = rest if rest < 1.5 * longest(size) else longest(size)
    near = min(angle, height, size.depth / 3, STRIP * above)
    inwards = steps(np.full(2, near / 2), np.minimum([0.75 * angle, 0.75 * height], width), size.lead)[::-1]
    depths = near * 0.5 ** np.arange(len(inwards), 0.0, -1.0)
    inside = np.column_stack([angle - inwards[:, 0] * (beyond > 0), depths, height - inwards[:, 1]])
    first = np.array([min(near, beyond), 2 * near, min(near, above)])
    outside = np.array([angle, 0.0, height]) + steps(first, np.array([beyond, size.depth, above]), size.lead)
    legs = ceil(size.legs * min(LONGEST, max(1, angle / (3 * height))) - 1e-9)
    around = max(legs, ceil((angle + beyond) / width - 1e-9))
    return Nest(
        boxes=np.vstack([inside, [angle, near, height], outside]),
        patch=len(inside),
        around=around + around % 2 if angle + beyond > pi - 1e-9 else around,
        through=max(1 + (height > 3 * near), ceil((height + above) / (longest(size) / 2) - 1e-9)),
    )


def within(nested, s, *shares):
    """Places (..., 3) in box s at shares of its angle, depth and height: on one of its sides where a share is 1."""
    return np.stack([part * share for part, share in zip(between(nested, s), shares, strict=True)], -1)


def between(nested, s):
    """Angle, depth and height (...) of box s (...), which lies between the successive ones, numbered 0, 1, ...

    In proportion, but next to the box of the patch by a parabola, as the tubes about its edges ask for smoothness; not
    where the patch goes all around.
    """
    numbers, t = np.arange(len(nested.boxes)), s - nested.patch
    share = np.array([t * (t - 1), 2 - 2 * t**2, t * (t + 1)]) / 2
    smooth = (np.abs(t) <= 1) & (nested.boxes[nested.patch + 1] > nested.boxes[nested.patch])[:, *[None] * np.ndim(t)]
    parabola = np.tensordot(nested.boxes[nested.patch - 1 : nested.patch + 2], share, (0, 0))
    return np.where(smooth, parabola, [np.interp(s, numbers, column) for column in nested.boxes.T])


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
        cells.append(cut(lambda u, v, w, i=i: within(nested, i + u, v, 1, w), n, around, through))
    plain = [i for i in range(len(boxes) - 1) if i not in (nested.patch - 1, nested.patch)]
    sections = [bilinear([(i, 0), (i + 1, 0), (i + 1, 1), (i, 1)]) for i in plain]
    sections += [lambda u, v, flat=flat: np.add(flat(u, v), (nested.patch, 0)) for flat in about_edge(size)]
    for beside, along in ((True, through), (False, around)):
        cells += [cut(tube(nested, section, beside), n, n, along) for section in sections]
    cells = np.concatenate(cells)
    return cells[(np.ptp(cells.reshape(len(cells), 27, 3), axis=1) > 1e-12).all(axis=1)]  # none where boxes end alike


def tube(nested, section, beside):
    """The block along an edge of the patch, beside or above it, over a block of (box, share of its depth)."""

    def block(u, v, w):
        s, e = np.moveaxis(section(u, v), -1, 0)
        return within(nested, s, *((1, e, w) if beside else (w, e, 1)))

    return block
