"""Mode shapes of a table, and their sums, at a point under the rim."""

from typing import Any, NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.stepping_core.round_table import (
    RoundTable,
    round_deflection,
    round_table,
    store_round_shapes,
    store_round_slopes,
)


class TableShapes(NamedTuple):
    """Upward shapes of t modes of a table, of unit modal mass.

    Attributes
    ----------
    coefficients : (a, b, t) array
        Spline coefficients of the shapes.
    knots_x, knots_y : arrays
        Knots of the splines [m].
    round_shapes : RoundTable
        Shapes of the modes of a round table, in place of the splines.
    place : (2,) array
        Position [m] in the frame of the shapes of the origin (`is_fixed` = 1) or of the
        centre of the disk (`is_fixed` = 0).
    is_fixed : float
        0 if the shapes move with the disk, like those of modes given by numbers; else 1.
    """

    coefficients: np.ndarray
    knots_x: np.ndarray
    knots_y: np.ndarray
    round_shapes: RoundTable
    place: np.ndarray
    is_fixed: float


def table_shapes(modes: Any) -> TableShapes:
    """Return the `TableShapes` of `modal.SurfaceModes`."""
    # copies, because read-only arrays have a different Numba type
    coefficients, knots_x, knots_y = (
        np.array(part, order="C") for part in (modes.coefficients, *modes.knots)
    )
    return TableShapes(
        coefficients,
        knots_x,
        knots_y,
        round_table(modes.round_shapes),
        np.array(modes.place, dtype=float),
        float(modes.mass > 0),  # modes given by numbers have no mass
    )


def spline_shapes(
    coefficients: np.ndarray, knots: np.ndarray, is_fixed: float
) -> TableShapes:
    """Return shapes with spline coefficients (a, a, t) and equal knots along x and y [m]."""
    return TableShapes(
        coefficients, knots, knots, round_table(None), np.zeros(2), is_fixed
    )


@kernel
def cubic_basis(knots: np.ndarray, x: float, out: np.ndarray) -> int:
    """Write four cubic B-splines at x and two derivatives to `out` (3, 4).

    Returns the index of the first spline.
    """
    n = knots.size - 4
    x = min(max(x, knots[3]), knots[n])
    i = min(max(int((x - knots[3]) / (knots[n] - knots[3]) * (n - 3)) + 3, 3), n - 1)
    while x < knots[i]:
        i -= 1
    while i < n - 1 and x >= knots[i + 1]:
        i += 1
    a = 1 / (knots[i + 1] - knots[i])
    b0 = 1 / (knots[i + 1] - knots[i - 1])
    b1 = 1 / (knots[i + 2] - knots[i])
    c0 = 1 / (knots[i + 1] - knots[i - 2])
    c1 = 1 / (knots[i + 2] - knots[i - 1])
    c2 = 1 / (knots[i + 3] - knots[i])
    l0 = (knots[i + 1] - x) * a
    l1 = (x - knots[i]) * a
    q0 = (knots[i + 1] - x) * b0 * l0
    q2 = (x - knots[i]) * b1 * l1
    q1 = 1 - q0 - q2
    out[0, 0] = (knots[i + 1] - x) * c0 * q0
    out[0, 3] = (x - knots[i]) * c2 * q2
    out[0, 1] = (x - knots[i - 2]) * c0 * q0 + (knots[i + 2] - x) * c1 * q1
    out[0, 2] = 1 - out[0, 0] - out[0, 1] - out[0, 3]
    out[1, 0] = -3 * c0 * q0
    out[1, 3] = 3 * c2 * q2
    out[1, 1] = 3 * (c0 * q0 - c1 * q1)
    out[1, 2] = 3 * (c1 * q1 - c2 * q2)
    d0 = -2 * b0 * l0
    d1 = 2 * (b0 * l0 - b1 * l1)
    d2 = 2 * b1 * l1
    out[2, 0] = -3 * c0 * d0
    out[2, 3] = 3 * c2 * d2
    out[2, 1] = 3 * (c0 * d0 - c1 * d1)
    out[2, 2] = 3 * (c1 * d1 - c2 * d2)
    return i - 3


@kernel
def store_table_shapes(
    table: TableShapes,
    x: float,
    y: float,
    bx: np.ndarray,
    by: np.ndarray,
    shapes: np.ndarray,
) -> None:
    """Store the table mode shapes at (x, y) [m] in `shapes`."""
    if table.round_shapes.mode_index.size > 0:
        store_round_shapes(
            table.round_shapes, x + table.place[0], y + table.place[1], shapes
        )
        return
    i = cubic_basis(table.knots_x, x + table.place[0], bx)
    j = cubic_basis(table.knots_y, y + table.place[1], by)
    count = table.coefficients.shape[2]
    for m in range(count):
        shapes[m] = 0.0
    for a in range(4):
        for b in range(4):
            share = bx[0, a] * by[0, b]
            row = table.coefficients[i + a, j + b]
            for m in range(count):
                shapes[m] += share * row[m]


@kernel
def store_table_slopes(
    table: TableShapes,
    x: float,
    y: float,
    bx: np.ndarray,
    by: np.ndarray,
    slopes: np.ndarray,
) -> None:
    """Store the slopes (2, t) of the table mode shapes along x and y at (x, y) [m]."""
    if table.round_shapes.mode_index.size > 0:
        store_round_slopes(
            table.round_shapes, x + table.place[0], y + table.place[1], slopes
        )
        return
    i = cubic_basis(table.knots_x, x + table.place[0], bx)
    j = cubic_basis(table.knots_y, y + table.place[1], by)
    slopes[:] = 0.0
    for a in range(4):
        for b in range(4):
            row = table.coefficients[i + a, j + b]
            for m in range(row.size):
                slopes[0, m] += bx[1, a] * by[0, b] * row[m]
                slopes[1, m] += bx[0, a] * by[1, b] * row[m]


@kernel
def table_deflection(
    table: TableShapes,
    amplitude: np.ndarray,
    change: np.ndarray,
    x: float,
    y: float,
    basis: tuple[np.ndarray, np.ndarray],
    out: np.ndarray,
) -> None:
    """Write W at (x, y), its gradient and its derivatives xx, xy, yy to `out` (6,).

    W is the sum of the shapes multiplied by amplitude + change. `basis` is a pair of
    arrays (3, 4) that are reused.
    """
    if table.round_shapes.mode_index.size > 0:
        round_deflection(
            table.round_shapes,
            amplitude,
            change,
            x + table.place[0],
            y + table.place[1],
            out,
        )
        return
    bx, by = basis
    i = cubic_basis(table.knots_x, x + table.place[0], bx)
    j = cubic_basis(table.knots_y, y + table.place[1], by)
    out[:] = 0.0
    for a in range(4):
        for b in range(4):
            row = table.coefficients[i + a, j + b]
            value = 0.0
            for m in range(row.size):
                value += row[m] * (amplitude[m] + change[m])
            out[0] += bx[0, a] * by[0, b] * value
            out[1] += bx[1, a] * by[0, b] * value
            out[2] += bx[0, a] * by[1, b] * value
            out[3] += bx[2, a] * by[0, b] * value
            out[4] += bx[1, a] * by[1, b] * value
            out[5] += bx[0, a] * by[2, b] * value
