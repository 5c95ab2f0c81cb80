"""Rotation of a disk in a time step, and its angular velocity.

The midpoint rule turns an axis by Cayley's formula; between impulses a disk turns exactly,
by the formula of Rodrigues.
"""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.stepping_core.vectors import AnyVector, Triple, cross, dot

if TYPE_CHECKING:
    from dynamics.stepping_core.rim_modes import RotatingBody


@kernel
def rotation_change(n: AnyVector, b: AnyVector) -> Triple:
    """Return the change m - n of the vector n that satisfies m - n = b x (m + n)."""
    k0, k1, k2 = cross(b, n)
    b0, b1, b2 = b
    q = 2 / (1 + b0 * b0 + b1 * b1 + b2 * b2)
    m0 = q * (k0 + b1 * k2 - b2 * k1)
    m1 = q * (k1 + b2 * k0 - b0 * k2)
    m2 = q * (k2 + b0 * k1 - b1 * k0)
    return m0, m1, m2


@kernel
def rotate(vector: np.ndarray, axis: AnyVector, angle: float) -> None:
    """Rotate a vector (3,) in place about a unit vector `axis` by an angle [rad]."""
    c = np.cos(angle)
    s = np.sin(angle)
    across = cross(axis, vector)
    along = (1 - c) * dot(vector, axis)
    for i in range(3):
        vector[i] = c * vector[i] + s * across[i] + along * axis[i]


@kernel
def angular_velocity(
    constants: "RotatingBody", axis: AnyVector, momentum: AnyVector
) -> Triple:
    """Return the angular velocity [rad/s] of a disk with an `axis` and an angular momentum.

    `constants` are those of `body_constants`.
    """
    J = constants.diametral_inertia
    spin = constants.inverse_inertia_excess * dot(momentum, axis)
    return (
        momentum[0] / J + spin * axis[0],
        momentum[1] / J + spin * axis[1],
        momentum[2] / J + spin * axis[2],
    )
