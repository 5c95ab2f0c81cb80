"""Moments that resist the rotation of a rattling disk."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.pivoting import PIVOTING_COEFFICIENT_COUNT, SINE_ROOT_INDEX
from dynamics.rattling.layout import (
    DASHPOT,
    ELASTIC,
    RESISTANCE,
    RattlingDisk,
)
from dynamics.stepping_core.resistance import (
    limited_arm_kernel,
    resistance_to,
    resisted_directions,
)
from dynamics.stepping_core.vectors import dot

if TYPE_CHECKING:
    from dynamics.rattling.body import PressedDisk, RimGeometry, Velocities


@kernel
def add_resistance(
    pressed: "PressedDisk",
    rim: "RimGeometry",
    velocity: "Velocities",
    energy: float,
    weight: float,
    step: float,
) -> None:
    """Add the resisting moments, and the torque due to the variable spring stiffness.

    The stiffness varies as the fourth root of the inclination. The contour moment
    resists the rolling of the contact at the rate w_3/sin(beta). All moments are
    proportional to the normal force; they can stop a rotation within a step but not
    reverse it.
    """
    disk = pressed.disk
    contacts = pressed.contacts
    axis_x, axis_y, _ = rim.axis
    spin_x, spin_y, spin_z = velocity.angular
    lean = energy / (4 * rim.inclination * rim.sine)
    contacts.torque[ELASTIC, 0] += lean * axis_y
    contacts.torque[ELASTIC, 1] -= lean * axis_x
    normal = contacts.force[ELASTIC, 2] + contacts.force[DASHPOT, 2]
    against = spin_x * axis_x + spin_y * axis_y
    against = against * rim.upright - spin_z * rim.sine**2
    size = disk.contour_moment * max(normal, 0.0) / weight / rim.sine**2
    most = abs(against) * disk.diametral_inertia / (step * rim.sine**2)
    moment = resistance_to(against, size, most)
    torque = contacts.torque[RESISTANCE]
    torque[0] = -moment * axis_x * rim.upright
    torque[1] = -moment * axis_y * rim.upright
    torque[2] = moment * rim.sine**2
    directions = resisted_directions(axis_x / rim.sine, axis_y / rim.sine)
    arms = disk.arms
    if disk.spin_friction[0] > 0:
        arms = (arms[0], arms[1], spin_friction_arm(disk, rim, velocity.angular))
    for arm, direction in zip(arms, directions):  # noqa: B905 - unknown to Numba
        rate = dot(velocity.angular, direction)
        most = abs(rate) * disk.diametral_inertia / step
        moment = resistance_to(rate, arm * max(normal, 0.0), most)
        for i in range(3):
            torque[i] -= moment * direction[i]


@kernel
def spin_friction_arm(
    disk: RattlingDisk, rim: "RimGeometry", spin: np.ndarray
) -> float:
    """Return the arm [m] of the moment by which the contact ellipse resists pivoting."""
    travel = np.hypot(spin[0], spin[1]) / rim.sine
    root = rim.sine ** (1 / SINE_ROOT_INDEX)
    unit_arm = 0.0
    creep = 0.0
    for i in range(PIVOTING_COEFFICIENT_COUNT, 0, -1):
        unit_arm = unit_arm * root + disk.spin_friction[i]
        creep = creep * root + disk.spin_friction[PIVOTING_COEFFICIENT_COUNT + i]
    return disk.radius * limited_arm_kernel(
        unit_arm / root**4,
        creep / root**4,
        abs(spin[2]),
        travel * travel,
        False,
        disk.friction,
    )
