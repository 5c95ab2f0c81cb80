"""Mesh the region of a partial-height patch with nested boxes at the rim.

The coordinates are angle, depth below the rim and height above the lower plane, with
lengths divided by the radius. A box is [0, angle] x [0, depth] x [0, height], and the
patch is the outer side of one box. Along the two edges of the patch, where u ~ r^(1/2),
the adjacent boxes are replaced by a tube with the cross-section of
`singular_edge_blocks`, mitred at the corner of the patch.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product
from math import ceil, log, pi

import numpy as np

from modal.mesh.half_disk import Block, MeshSize, bilinear_block, singular_edge_blocks

SolidBlock = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]
"""Map from arrays (u, v, w) in the unit cube to points (..., 3)."""


@dataclass(frozen=True, kw_only=True)
class NestedBoxes:
    """Nested boxes around the middle of a patch."""

    corners: np.ndarray
    """Angle [rad], depth and height (b, 3) of the outer corner of every box."""
    patch: int
    """Index of the box of the patch."""
    cells_around: int
    """Number of cells in the direction of the angle."""
    cells_up: int
    """Number of cells in the direction of the height."""


def max_layer_height(size: MeshSize) -> float:
    """Return the largest layer height of a `MeshSize`, divided by the radius."""
    return 1.2 * size.width


def graded_distances(first: np.ndarray, last: np.ndarray, ratio: float) -> np.ndarray:
    """Return distances (k, n) from `first` (n,) to `last` (n,) in geometric steps of
    about `ratio`.

    k is at least 2, and distances of 0 remain 0."""
    growth = np.divide(last, first, out=np.ones(len(first)), where=first > 0)
    count = max(1, ceil(log(growth.max()) / log(1 / ratio) - 0.5))
    return first * growth ** (np.arange(count + 1)[:, None] / count)


def nested_boxes(
    angle: float, height: float, top: float, size: MeshSize
) -> NestedBoxes:
    """Return the `NestedBoxes` of a patch with a half angle [rad] and a height below
    `top`.

    If the patch covers the whole circumference, so do the boxes. The width of the tubes
    at the edges is limited by that of the free strip above the patch; wider ones would
    reach the face. A long patch has more cells along its upper edge than a short one.
    """
    max_tube_strip_ratio = 4  # ratio of the width of a tube to that of the strip
    # factor on `upper_edge_blocks` for a patch that is long compared with its height
    max_upper_edge_factor = 3
    width = size.width
    rest = top - height
    beyond = min(pi - angle, max(angle, width / 4) + width - angle)
    above = rest if rest < 1.5 * max_layer_height(size) else max_layer_height(size)
    tube = min(angle, height, size.depth / 3, max_tube_strip_ratio * above)
    innermost = np.minimum([0.75 * angle, 0.75 * height], width)
    inwards = graded_distances(np.full(2, tube / 2), innermost, size.box_ratio)[::-1]
    depths = tube * 0.5 ** np.arange(len(inwards), 0.0, -1.0)
    inside = np.column_stack(
        [angle - inwards[:, 0] * (beyond > 0), depths, height - inwards[:, 1]]
    )
    first = np.array([min(tube, beyond), 2 * tube, min(tube, above)])
    outwards = graded_distances(
        first, np.array([beyond, size.depth, above]), size.box_ratio
    )
    outside = np.array([angle, 0.0, height]) + outwards
    upper_edge_cells = ceil(
        size.upper_edge_blocks
        * min(max_upper_edge_factor, max(1, angle / (3 * height)))
        - 1e-9
    )
    around = max(upper_edge_cells, ceil((angle + beyond) / width - 1e-9))
    covers_circumference = angle + beyond > pi - 1e-9
    return NestedBoxes(
        corners=np.vstack([inside, [angle, tube, height], outside]),
        patch=len(inside),
        cells_around=around + around % 2 if covers_circumference else around,
        cells_up=max(
            1 + (height > 3 * tube),
            ceil((height + above) / (max_layer_height(size) / 2) - 1e-9),
        ),
    )


def points_in_box(
    boxes: NestedBoxes, s: float | np.ndarray, *shares: float | np.ndarray
) -> np.ndarray:
    """Return points (..., 3) in box s at fractions of its angle, depth and height."""
    corner = corner_of_box(boxes, s)
    return np.stack(
        [part * share for part, share in zip(corner, shares, strict=True)], -1
    )


def corner_of_box(boxes: NestedBoxes, s: float | np.ndarray) -> np.ndarray:
    """Return angle, depth and height (3, ...) of box s (...), interpolated between the
    numbered boxes.

    The interpolation is linear, except next to the box of the patch, where it is
    parabolic because the size of the tubes must vary smoothly. It is linear everywhere
    if the patch covers the whole circumference.
    """
    numbers = np.arange(len(boxes.corners))
    t = s - boxes.patch
    weights = np.array([t * (t - 1), 2 - 2 * t**2, t * (t + 1)]) / 2
    is_next_larger = boxes.corners[boxes.patch + 1] > boxes.corners[boxes.patch]
    smooth = (np.abs(t) <= 1) & is_next_larger[:, *[None] * np.ndim(t)]
    parabola = np.tensordot(
        boxes.corners[boxes.patch - 1 : boxes.patch + 2], weights, (0, 0)
    )
    linear = [np.interp(s, numbers, column) for column in boxes.corners.T]
    return np.where(smooth, parabola, linear)


def node_coordinates_of_cells(block: SolidBlock, *counts: int) -> np.ndarray:
    """Return the nodes (c, 3, 3, 3, 3) of the cells of a block, which is a function on
    the unit cube."""
    grid = block(
        *np.meshgrid(*[np.linspace(0, 1, 2 * n + 1) for n in counts], indexing="ij")
    )
    starts = product(*[range(0, 2 * n, 2) for n in counts])
    return np.array([grid[i : i + 3, j : j + 3, k : k + 3] for i, j, k in starts])


def nodes_of_boxes(boxes: NestedBoxes, size: MeshSize) -> np.ndarray:
    """Return the nodes (c, 3, 3, 3, 3) of all cells inside the last box; the first node
    index increases outwards."""
    corners = boxes.corners
    patch = boxes.patch
    n = size.split
    around = n * boxes.cells_around
    up = n * boxes.cells_up
    cells = [
        node_coordinates_of_cells(
            lambda u, v, w: np.stack([v, u, w], -1) * corners[0], n, around, up
        )
    ]
    for i in range(len(corners) - 1):
        cells.append(node_coordinates_of_cells(box_block(boxes, i), n, around, up))
    sections = []
    for i in range(len(corners) - 1):
        if i not in (patch - 1, patch):
            sections.append(bilinear_block([(i, 0), (i + 1, 0), (i + 1, 1), (i, 1)]))
    for flat in singular_edge_blocks(size):
        sections.append(shifted_block(flat, patch))
    for is_beside, count in ((True, up), (False, around)):
        for section in sections:
            cells.append(
                node_coordinates_of_cells(
                    tube_block(boxes, section, is_beside), n, n, count
                )
            )
    nodes = np.concatenate(cells)
    extents = np.ptp(nodes.reshape(len(nodes), 27, 3), axis=1)
    return nodes[
        (extents > 1e-12).all(axis=1)
    ]  # cells are flat where boxes share a side


def box_block(boxes: NestedBoxes, i: int) -> SolidBlock:
    """Return the block between the boxes i and i + 1, below the patch."""
    return lambda u, v, w: points_in_box(boxes, i + u, v, 1, w)


def shifted_block(flat: Block, box: int) -> Block:
    """Return a block of the cross-section, shifted to a box."""
    return lambda u, v: np.add(flat(u, v), (box, 0))


def tube_block(boxes: NestedBoxes, section: Block, is_beside: bool) -> SolidBlock:
    """Return the block along an edge of the patch, beside or above it.

    Its cross-section has the coordinates (box, fraction of its depth)."""

    def block(u: np.ndarray, v: np.ndarray, w: np.ndarray) -> np.ndarray:
        s, share = np.moveaxis(section(u, v), -1, 0)
        shares = (1, share, w) if is_beside else (w, share, 1)
        return points_in_box(boxes, s, *shares)

    return block
