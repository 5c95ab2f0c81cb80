"""Claim: the cells round a patch of partial height fill their box exactly once.

Source: modal/mesh/patch_box.py. Oracle: the volume of the box; the limits of its boxes.
"""

import numpy as np
import pytest

from modal.accuracy import ACCURACY_LEVELS
from modal.mesh.patch_box import corner_of_box, nested_boxes, nodes_of_boxes

SIZE = ACCURACY_LEVELS["draft"].patch_meshes[0]
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)


def lagrange(x):
    """Return values and derivatives (3,) of the parabolas through 0, 1/2 and 1."""
    return (
        np.array([2 * (x - 0.5) * (x - 1), 4 * x * (1 - x), 2 * x * (x - 0.5)]),
        np.array([4 * x - 3, 4 - 8 * x, 4 * x - 1]),
    )


def volume(cell):
    """Return the volume of a triquadratic cell (3, 3, 3, 3) by Gauss quadrature."""
    total = 0.0
    values = [lagrange((p + 1) / 2) for p in POINTS]
    for (a, da), wa in zip(values, WEIGHTS, strict=True):
        for (b, db), wb in zip(values, WEIGHTS, strict=True):
            for (c, dc), wc in zip(values, WEIGHTS, strict=True):
                jacobian = [
                    np.einsum("i,j,k,ijkx", *shape, cell)
                    for shape in ((da, b, c), (a, db, c), (a, b, dc))
                ]
                total += wa * wb * wc / 8 * abs(np.linalg.det(jacobian))
    return total


@pytest.mark.parametrize(
    ("angle", "height", "top"), [(0.09, 0.17, 0.34), (0.5, 0.1, 0.34)]
)
def test_the_cells_fill_the_box(angle, height, top):
    boxes = nested_boxes(angle, height, top, SIZE)
    cells = nodes_of_boxes(boxes, SIZE)
    assert sum(map(volume, cells)) == pytest.approx(
        np.prod(boxes.corners[-1]), rel=1e-3
    )
    assert cells.reshape(-1, 3).min(axis=0) == pytest.approx(0.0, abs=1e-12)
    assert cells.reshape(-1, 3).max(axis=0) == pytest.approx(boxes.corners[-1])


def test_boxes_grow_and_the_patch_is_one_of_them():
    boxes = nested_boxes(0.09, 0.17, 0.34, SIZE)
    assert (np.diff(boxes.corners, axis=0) >= 0).all()
    assert boxes.corners[boxes.patch, [0, 2]] == pytest.approx([0.09, 0.17])
    for number, corner in enumerate(boxes.corners):
        assert corner_of_box(boxes, float(number)) == pytest.approx(corner)
