"""The free elastic modes of the disk, which move its bottom rim while the contact runs round it (compiled).

A mode of n waves lifts the rim at an angle a on the disk by r (c A - s B) cos(n a - phase), A and B being its motion
along axis and radius at modal mass 1, c and s cosine and sine of the inclination; r'' = -k r - c' r' + N times that.
So it is to the contact what a mode of the table with the opposite shape is, and waves.py steps both alike. The disk
turns about its axis by a twist omega.(n + e3)/(1 + c) a second, which is regular where it lies flat: the contact in the
direction phi is at a = phi - twist. What friction drives is left out.
"""

from typing import NamedTuple

import numpy as np

from .compiled import kernel
from .state import FREE, J1, J2, Q

MOVES = 20e3
"""The modes below it [Hz] move, and yield no longer in series with the springs of the contact."""
ORDER, PHASE, AXIAL, RADIAL = range(4)


class Bending(NamedTuple):
    """d modes of a free disk: `shapes` (d, 4) with order, phase [rad], A and B [kg^-1/2]; w^2 [1/s^2] and decay rates
    [1/s], each (d,)."""

    shapes: np.ndarray
    squared: np.ndarray
    decay: np.ndarray


RIGID = Bending(np.zeros((0, 4)), np.zeros(0), np.zeros(0))


def bending_of(edge, loss_factor: float) -> Bending:
    """Return the `Bending` of the modes of an `Edge` below MOVES, of a material that loses `loss_factor`."""
    if edge is None:
        return RIGID
    moves = np.flatnonzero((edge.squared < (2 * np.pi * MOVES) ** 2) & (edge.shapes[:, 2] != 0))
    pairs = [(i, phase) for i in moves for phase in ((0.0, np.pi / 2) if edge.order[i] else (0.0,))]
    shapes = np.array([(edge.order[i], phase, edge.shapes[i, 2], edge.shapes[i, 0]) for i, phase in pairs])
    squared = edge.squared[[i for i, _ in pairs]]
    return Bending(shapes.reshape(-1, 4), squared, loss_factor / 2 * np.sqrt(squared))


def rim_shapes(body: Bending, angle, inclination: float) -> np.ndarray:
    """Return by how much the modes lower the rim at angles (k,) on the disk, (k, d) [kg^-1/2]."""
    order, phase, axial, radial = body.shapes.T
    return np.cos(np.outer(angle, order) - phase) * (np.sin(inclination) * radial - np.cos(inclination) * axial)


@kernel
def twist_rate(law, n0, n1, n2, L0, L1, L2):
    """Return the twist of the disk in a second."""
    spin = n0 * L0 + n1 * L1 + n2 * L2
    return (spin + L2) / (law[J1] * (1 + n2)) + (1 / law[J2] - 1 / law[J1]) * spin


@kernel
def read_rim(shapes, state, angle, down, up, into):
    """Write by how much the modes lower the rim into a column of the last rows of `state`; `down` and `up` are n.e and
    n_z of the axis."""
    first = len(state) - len(shapes)
    for m in range(len(shapes)):
        lowers = down * shapes[m, RADIAL] - up * shapes[m, AXIAL]
        state[first + m, into] = lowers * np.cos(shapes[m, ORDER] * angle - shapes[m, PHASE])


@kernel
def ripple(shapes, state, angle, down, up, out):
    """Write by how much the modes lower the rim at the end of the step, and its slope and bend by the angle, to out."""
    out[0:3] = 0.0
    first = len(state) - len(shapes)
    for m in range(len(shapes)):
        n, moved = shapes[m, ORDER], state[first + m, Q] + state[first + m, FREE]
        lowers = moved * (down * shapes[m, RADIAL] - up * shapes[m, AXIAL])
        turn = n * angle - shapes[m, PHASE]
        c, s = lowers * np.cos(turn), lowers * np.sin(turn)
        out[0], out[1], out[2] = out[0] + c, out[1] - n * s, out[2] - n * n * c
