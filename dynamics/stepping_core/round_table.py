"""Mode shapes of a round table, as waves around its centre.

A shape is g(s) Re z^n or g(s) Im z^n, where z = (x + iy)/radius and s = |z|^2. The
functions g are cubic within cells of equal width in |z|. No operation depends on the
direction of the axes, except through z^n, so that a round table is isotropic up to
rounding. Modes with the same n are summed before the waves are evaluated.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy.interpolate import PPoly

from dynamics.numba_kernels import kernel

if TYPE_CHECKING:
    from dynamics.stepping_core.vectors import Triple


class RoundTable(NamedTuple):
    """Shapes of t modes of a round table, sorted by order; t = 0 for other tables.

    Attributes
    ----------
    radius : float
        Radius of the table [m].
    starts : (c + 1,) array
        Values of s at the ends of the c cells.
    pieces : (c, 4, t) array
        Coefficients of g [kg^-1/2] in powers of s - starts, highest first.
    groups : (b, 4) array of int
        Modes of equal wave: order n, 1 for Im z^n (else 0), first mode, end.
    mode_index : (t,) array of int
        Index of each mode among the modes of the table.
    """

    radius: float
    starts: np.ndarray
    pieces: np.ndarray
    groups: np.ndarray
    mode_index: np.ndarray


def round_table(shapes: Any) -> RoundTable:
    """Return the `RoundTable` of `modal.RoundShapes`, or one without modes for None."""
    if shapes is None:
        return RoundTable(
            radius=1.0,
            starts=np.zeros(2),
            pieces=np.zeros((1, 4, 0)),
            groups=np.zeros((0, 4), dtype=np.int64),
            mode_index=np.zeros(0, dtype=np.int64),
        )
    wave = 2 * shapes.order + shapes.is_sine
    index = np.argsort(wave, kind="stable")
    waves, first, count = np.unique(wave[index], return_index=True, return_counts=True)
    groups = np.column_stack([waves // 2, waves % 2, first, first + count])
    return RoundTable(
        radius=float(shapes.radius),
        starts=np.array(shapes.starts),
        pieces=np.ascontiguousarray(shapes.pieces[:, :, index].transpose(1, 0, 2)),
        groups=groups.astype(np.int64),
        mode_index=index.astype(np.int64),
    )


def greatest_shape_norm(shapes: Any) -> float:
    """Return an upper bound of the norm of the m shapes at any point [kg^-1/2]."""
    between_samples = 1.01  # a maximum lies at most 1/64 of a wave from a sample
    rho = np.sqrt(shapes.starts)[:, None]
    profiles = PPoly(shapes.pieces, shapes.starts)(shapes.starts)
    squares = (profiles * rho**shapes.order) ** 2
    total = np.zeros(len(rho))
    for n in np.unique(shapes.order):
        cosines = squares[:, (shapes.order == n) & ~shapes.is_sine].sum(axis=1)
        sines = squares[:, (shapes.order == n) & shapes.is_sine].sum(axis=1)
        total += np.maximum(cosines, sines)
    return float(between_samples * np.sqrt(total.max(initial=0.0)))


@kernel
def point_on_round_table(
    table: RoundTable, x: float, y: float
) -> tuple[float, float, int, float]:
    """Return z as two numbers, the cell of a point (x, y) [m], and its s - starts.

    A point outside the table is moved to its rim.
    """
    u = x / table.radius
    v = y / table.radius
    distance = np.sqrt(u * u + v * v)
    if distance > 1.0:
        u /= distance
        v /= distance
        distance = 1.0
    cells = table.starts.size - 1
    cell = min(int(distance * cells), cells - 1)
    return u, v, cell, u * u + v * v - table.starts[cell]


@kernel
def store_round_shapes(
    table: RoundTable, x: float, y: float, shapes: np.ndarray
) -> None:
    """Store the mode shapes at (x, y) [m] in `shapes`."""
    u, v, cell, offset = point_on_round_table(table, x, y)
    row = table.pieces[cell]
    n = 0
    cosine = 1.0
    sine = 0.0
    for b in range(table.groups.shape[0]):
        while n < table.groups[b, 0]:
            cosine, sine = u * cosine - v * sine, u * sine + v * cosine
            n += 1
        wave = sine if table.groups[b, 1] else cosine
        for k in range(table.groups[b, 2], table.groups[b, 3]):
            g = row[2, k] + offset * (row[1, k] + offset * row[0, k])
            shapes[table.mode_index[k]] = wave * (row[3, k] + offset * g)


@kernel
def store_round_slopes(
    table: RoundTable, x: float, y: float, slopes: np.ndarray
) -> None:
    """Store the slopes (2, t) of the mode shapes along x and y at (x, y) [m]."""
    u, v, cell, offset = point_on_round_table(table, x, y)
    row = table.pieces[cell]
    n = 0
    cosine = 1.0
    sine = 0.0
    lower_cosine = 0.0
    lower_sine = 0.0
    for b in range(table.groups.shape[0]):
        while n < table.groups[b, 0]:
            lower_cosine = cosine
            lower_sine = sine
            cosine, sine = u * cosine - v * sine, u * sine + v * cosine
            n += 1
        wave = cosine
        along_x = n * lower_cosine
        along_y = -n * lower_sine
        if table.groups[b, 1]:
            wave = sine
            along_x = n * lower_sine
            along_y = n * lower_cosine
        for k in range(table.groups[b, 2], table.groups[b, 3]):
            cubic = offset * row[0, k]
            square = row[1, k] + cubic
            slope = row[2, k] + offset * (2 * square + cubic)
            g = row[3, k] + offset * (row[2, k] + offset * square)
            m = table.mode_index[k]
            slopes[0, m] = (2 * u * slope * wave + g * along_x) / table.radius
            slopes[1, m] = (2 * v * slope * wave + g * along_y) / table.radius


@kernel
def radial_sums(
    table: RoundTable,
    group: int,
    row: np.ndarray,
    offset: float,
    amplitude: np.ndarray,
    change: np.ndarray,
) -> "Triple":
    """Return the sums of g, g' and g'' over the modes of a group of one wave."""
    value = 0.0
    slope = 0.0
    bend = 0.0
    for k in range(table.groups[group, 2], table.groups[group, 3]):
        q = amplitude[table.mode_index[k]] + change[table.mode_index[k]]
        cubic = offset * row[0, k]
        square = row[1, k] + cubic
        value += q * (row[3, k] + offset * (row[2, k] + offset * square))
        slope += q * (row[2, k] + offset * (2 * square + cubic))
        bend += q * (2 * square + 4 * cubic)
    return value, slope, bend


@kernel
def wave_derivatives(
    n: int,
    is_sine: int,
    power: tuple[float, float],
    lower: tuple[float, float],
    lowest: tuple[float, float],
) -> tuple[float, float, float, float, float]:
    """Return a wave and its derivatives along x, along y, xx and xy; yy is -xx.

    The wave is the real part of (u + i v)^n, or the imaginary part if `is_sine`. The
    `power` is this power as a pair of both parts, and `lower` and `lowest` are those of
    n - 1 and n - 2.
    """
    twice = n * (n - 1)
    if is_sine:
        return (
            power[1],
            n * lower[1],
            n * lower[0],
            twice * lowest[1],
            twice * lowest[0],
        )
    return (
        power[0],
        n * lower[0],
        -n * lower[1],
        twice * lowest[0],
        -twice * lowest[1],
    )


@kernel
def round_deflection(
    table: RoundTable,
    amplitude: np.ndarray,
    change: np.ndarray,
    x: float,
    y: float,
    out: np.ndarray,
) -> None:
    """Write W at (x, y), its gradient and its derivatives xx, xy, yy to `out` (6,).

    W is the sum of the shapes multiplied by amplitude + change.
    """
    u, v, cell, offset = point_on_round_table(table, x, y)
    row = table.pieces[cell]
    out[:] = 0.0
    n = 0
    power = (1.0, 0.0)
    lower = (0.0, 0.0)
    lowest = (0.0, 0.0)
    for group in range(table.groups.shape[0]):
        while n < table.groups[group, 0]:
            lowest = lower
            lower = power
            power = (u * power[0] - v * power[1], u * power[1] + v * power[0])
            n += 1
        value, slope, bend = radial_sums(table, group, row, offset, amplitude, change)
        wave, wave_x, wave_y, wave_xx, wave_xy = wave_derivatives(
            n, table.groups[group, 1], power, lower, lowest
        )
        out[0] += value * wave
        out[1] += 2 * u * slope * wave + value * wave_x
        out[2] += 2 * v * slope * wave + value * wave_y
        out[3] += (2 * slope + 4 * u * u * bend) * wave
        out[3] += 4 * u * slope * wave_x + value * wave_xx
        out[4] += 4 * u * v * bend * wave + value * wave_xy
        out[4] += 2 * slope * (u * wave_y + v * wave_x)
        out[5] += (2 * slope + 4 * v * v * bend) * wave
        out[5] += 4 * v * slope * wave_y - value * wave_xx
    scale = 1 / table.radius
    for i in range(1, 3):
        out[i] *= scale
    for i in range(3, 6):
        out[i] *= scale * scale
