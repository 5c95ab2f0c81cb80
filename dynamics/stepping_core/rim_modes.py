"""Elastic modes of the free disk that displace its lower rim under the moving contact.

A mode with n waves raises the rim at an angle a on the disk by r (c A - s B) cos(n a -
phase). A and B are its displacements along axis and radius at unit modal mass, c and s
are cosine and sine of the inclination, and r'' = -k r - c' r' + N times this shape.
Such a mode is equivalent to a mode of the table with the opposite shape, and
table_modes.py advances both in the same way. The disk rotates about its axis at the
twist rate omega.(n + e3)/(1 + c), which is regular for a flat disk; the contact in the
direction phi is at a = phi - twist. The excitation of the modes by friction is
neglected.
"""

from typing import Any, NamedTuple, Protocol

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from dynamics.stepping_core.vectors import AnyVector, dot


class RotatingBody(Protocol):
    """Inertia of a disk, in the constants of a model."""

    @property
    def diametral_inertia(self) -> float: ...
    @property
    def inverse_inertia_excess(self) -> float: ...


MAX_MOVING_MODE_FREQUENCY = MAX_AUDIBLE_FREQUENCY
"""Frequency [Hz] below which modes are solved in time.

Modes above it are quasi-static, in series with the springs of the contact.
"""


class RimModes(NamedTuple):
    """Modes of a free disk, with one entry (d,) for each mode.

    Attributes
    ----------
    order : array
        Number n of waves around the rim.
    phase : array
        Phase [rad].
    axial, radial : arrays
        Displacements A along the axis and B along the radius [kg^-1/2].
    squared : array
        Squared angular frequency [1/s^2].
    decay : array
        Decay rate [1/s].
    """

    order: np.ndarray
    phase: np.ndarray
    axial: np.ndarray
    radial: np.ndarray
    squared: np.ndarray
    decay: np.ndarray


NO_RIM_MODES = RimModes(*np.zeros((6, 0)))
"""Rim modes of a rigid disk, which has none."""
RIM_COLUMNS = RimModes(*range(len(RimModes._fields)))
"""Column indices of the fields of `RimModes` in an array (d, 6)."""


def moving_rim_modes(edge: Any, loss_factor: float) -> RimModes:
    """Return the `RimModes` of an `Edge` below MAX_MOVING_MODE_FREQUENCY."""
    if edge is None:
        return NO_RIM_MODES
    moves = np.flatnonzero(
        (edge.squared < (2 * np.pi * MAX_MOVING_MODE_FREQUENCY) ** 2)
        & (edge.shapes[:, 2] != 0)
    )
    pairs = []
    for mode in moves:
        pairs.append((mode, 0.0))
        if edge.order[mode]:
            pairs.append((mode, np.pi / 2))
    members = [mode for mode, _ in pairs]
    squared = edge.squared[members]
    return RimModes(
        order=edge.order[members].astype(float),
        phase=np.array([phase for _, phase in pairs]),
        axial=edge.shapes[members, 2],
        radial=edge.shapes[members, 0],
        squared=squared,
        decay=loss_factor / 2 * np.sqrt(squared),
    )


def rim_shapes(body: RimModes, angle: np.ndarray, inclination: float) -> np.ndarray:
    """Return the lowering (k, d) [kg^-1/2] of the rim at angles (k,) [rad] on the disk."""
    lowering = np.sin(inclination) * body.radial - np.cos(inclination) * body.axial
    return np.cos(np.outer(angle, body.order) - body.phase) * lowering


@kernel
def disk_twist_rate(
    constants: RotatingBody, axis: AnyVector, angular_momentum: AnyVector
) -> float:
    """Return the twist rate [rad/s] of a disk with this axis and angular momentum."""
    J1 = constants.diametral_inertia
    spin = dot(axis, angular_momentum)
    turning = (spin + angular_momentum[2]) / (J1 * (1 + axis[2]))
    return turning + constants.inverse_inertia_excess * spin


@kernel
def store_rim_shapes(
    rim: np.ndarray, angle: float, down: float, up: float, shapes: np.ndarray
) -> None:
    """Store the lowering of the rim by each mode in the last entries of `shapes`.

    `down` and `up` are n.e and n_z of the axis n.
    """
    first = shapes.size - len(rim)
    for m in range(len(rim)):
        lowers = down * rim[m, RIM_COLUMNS.radial] - up * rim[m, RIM_COLUMNS.axial]
        shapes[first + m] = lowers * np.cos(
            rim[m, RIM_COLUMNS.order] * angle - rim[m, RIM_COLUMNS.phase]
        )


@kernel
def evaluate_rim_ripple(
    modes: Any, angle: float, down: float, up: float, out: np.ndarray
) -> None:
    """Write the rim lowering at the end of a step and two angular derivatives to `out`."""
    out[0:3] = 0.0
    rim = modes.rim
    first = len(modes.amplitude) - len(rim)
    for m in range(len(rim)):
        n = rim[m, RIM_COLUMNS.order]
        moved = modes.amplitude[first + m] + modes.free_change[first + m]
        lowers = moved * (
            down * rim[m, RIM_COLUMNS.radial] - up * rim[m, RIM_COLUMNS.axial]
        )
        turn = n * angle - rim[m, RIM_COLUMNS.phase]
        c = lowers * np.cos(turn)
        s = lowers * np.sin(turn)
        out[0] += c
        out[1] -= n * s
        out[2] -= n * n * c
