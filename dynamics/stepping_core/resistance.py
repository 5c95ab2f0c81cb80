"""Moments that resist the rotation of a disk, in both time-steppers."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.pivoting import friction_limited_arm

if TYPE_CHECKING:
    from dynamics.stepping_core.vectors import Triple

limited_arm_kernel = kernel(friction_limited_arm)


@kernel
def resisted_directions(d0: float, d1: float) -> "tuple[Triple, Triple, Triple]":
    """Return the unit vectors of the rotations that the arms k1, k2 and k3 resist.

    They are the horizontal diameter, the horizontal direction (d0, d1) towards the
    contact, and the vertical.
    """
    return (-d1, d0, 0.0), (d0, d1, 0.0), (0.0, 0.0, 1.0)


@kernel
def resistance_to(rate: float, size: float, greatest: float) -> float:
    """Return a moment of `size`, at most `greatest`, with the sign of the rate it opposes."""
    return min(size, greatest) * np.sign(rate)
