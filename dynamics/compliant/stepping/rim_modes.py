"""Free elastic modes of the disk that move its lower rim while the contact runs round it.

A mode with n waves lifts the rim at an angle a on the disk by r (c A - s B) cos(n a - phase). A and
B are its motion along axis and radius at unit modal mass, c and s the cosine and sine of the
inclination, and r'' = -k r - c' r' + N times this shape. To the contact it is a mode of the table
with the opposite shape, and waves.py advances both in the same way. The disk turns about its axis
by the twist rate omega.(n + e3)/(1 + c), which is regular where the disk lies flat; the contact in
the direction phi is at a = phi - twist. The model neglects the excitation of the modes by friction.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.stepping.state_layout import FREE_CHANGE, J1, J2, MODE_AMPLITUDE
from dynamics.numba_kernels import kernel

MAX_MOVING_FREQUENCY = 20e3
"""Modes below this frequency move; modes above it yield in series with the springs of the contact
[Hz].
"""

# Columns of the shapes of `RimModes`.
SHAPE_ORDER = 0
SHAPE_PHASE = 1
"""[rad]"""
AXIAL_MOTION = 2
"""A [kg^-1/2]"""
RADIAL_MOTION = 3
"""B [kg^-1/2]"""


class RimModes(NamedTuple):
    """d modes of a free disk: `shapes` (d, 4) with order, phase [rad], A and B [kg^-1/2]; `squared`
    (d,), the squared angular frequencies [1/s^2]; `decay` (d,), the decay rates [1/s].
    """

    shapes: np.ndarray
    squared: np.ndarray
    decay: np.ndarray


NO_RIM_MODES = RimModes(np.zeros((0, 4)), np.zeros(0), np.zeros(0))
"""Modes of a rigid disk."""


def moving_rim_modes(edge, loss_factor: float) -> RimModes:
    """Return the `RimModes` of an `Edge` below MAX_MOVING_FREQUENCY, for a material with this loss
    factor.
    """
    if edge is None:
        return NO_RIM_MODES
    moves = np.flatnonzero(
        (edge.squared < (2 * np.pi * MAX_MOVING_FREQUENCY) ** 2) & (edge.shapes[:, 2] != 0)
    )
    pairs = [(i, phase) for i in moves for phase in ((0.0, np.pi / 2) if edge.order[i] else (0.0,))]
    shapes = np.array(
        [(edge.order[i], phase, edge.shapes[i, 2], edge.shapes[i, 0]) for i, phase in pairs]
    )
    squared = edge.squared[[i for i, _ in pairs]]
    return RimModes(shapes.reshape(-1, 4), squared, loss_factor / 2 * np.sqrt(squared))


def rim_shapes(body: RimModes, angle, inclination: float) -> np.ndarray:
    """Return the lowering (k, d) [kg^-1/2] of the rim by the modes at angles (k,) [rad] on the
    disk.
    """
    order, phase, axial, radial = body.shapes.T
    return np.cos(np.outer(angle, order) - phase) * (
        np.sin(inclination) * radial - np.cos(inclination) * axial
    )


@kernel
def twist_rate(law, n0, n1, n2, L0, L1, L2):
    """Return the twist rate of the disk about its axis [rad/s]."""
    spin = n0 * L0 + n1 * L1 + n2 * L2
    return (spin + L2) / (law[J1] * (1 + n2)) + (1 / law[J2] - 1 / law[J1]) * spin


@kernel
def store_rim_shapes(shapes, state, angle, down, up, into):
    """Store the lowering of the rim by the modes in the column `into` of the last rows of `state`.

    `down` and `up` are n.e and n_z of the axis.
    """
    first = len(state) - len(shapes)
    for m in range(len(shapes)):
        lowers = down * shapes[m, RADIAL_MOTION] - up * shapes[m, AXIAL_MOTION]
        state[first + m, into] = lowers * np.cos(
            shapes[m, SHAPE_ORDER] * angle - shapes[m, SHAPE_PHASE]
        )


@kernel
def evaluate_rim_ripple(shapes, state, angle, down, up, out):
    """Write the lowering of the rim at the end of the step and its first two derivatives by the
    angle to `out`.
    """
    out[0:3] = 0.0
    first = len(state) - len(shapes)
    for m in range(len(shapes)):
        n = shapes[m, SHAPE_ORDER]
        moved = state[first + m, MODE_AMPLITUDE] + state[first + m, FREE_CHANGE]
        lowers = moved * (down * shapes[m, RADIAL_MOTION] - up * shapes[m, AXIAL_MOTION])
        turn = n * angle - shapes[m, SHAPE_PHASE]
        c = lowers * np.cos(turn)
        s = lowers * np.sin(turn)
        out[0] = out[0] + c
        out[1] = out[1] - n * s
        out[2] = out[2] - n * n * c
