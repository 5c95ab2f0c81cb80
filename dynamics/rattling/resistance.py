"""Moments that resist the rotation of a rattling disk."""

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.pivoting import (
    PIVOTING_COEFFICIENT_COUNT,
    SINE_ROOT_INDEX,
    friction_limited_arm,
)
from dynamics.rattling.layout import DASHPOT, ELASTIC, RESISTANCE

limited_arm_kernel = kernel(friction_limited_arm)


@kernel
def add_resistance(disk, weight, rim, velocity, energy, step, contacts):
    """Add the resisting moments, and the torque due to the variable spring stiffness.

    The stiffness varies as the fourth root of the inclination. The contour moment
    resists the rolling of the contact at the rate w_3/sin(beta). All moments are
    proportional to the normal force; those of the arms can stop a rotation within a
    step but not reverse it.
    """
    axis_x, axis_y, _ = rim.axis
    spin_x, spin_y, spin_z = velocity.angular
    lean = energy / (4 * rim.inclination * rim.sine)
    contacts.torque[ELASTIC, 0] += lean * axis_y
    contacts.torque[ELASTIC, 1] -= lean * axis_x
    normal = contacts.force[ELASTIC, 2] + contacts.force[DASHPOT, 2]
    against = spin_x * axis_x + spin_y * axis_y
    against = against * rim.upright - spin_z * rim.sine**2
    moment = disk.contour_moment * normal / weight / rim.sine**2 * np.sign(against)
    torque = contacts.torque[RESISTANCE]
    torque[0] = -moment * axis_x * rim.upright
    torque[1] = -moment * axis_y * rim.upright
    torque[2] = moment * rim.sine**2
    d1 = axis_x / rim.sine
    d2 = axis_y / rim.sine
    directions = ((d2, -d1, 0.0), (d1, d2, 0.0), (0.0, 0.0, 1.0))
    arms = disk.arms
    if disk.spin_friction[0] > 0:
        travel = np.hypot(spin_x, spin_y) / rim.sine
        root = rim.sine ** (1 / SINE_ROOT_INDEX)
        unit_arm = 0.0
        creep = 0.0
        for i in range(PIVOTING_COEFFICIENT_COUNT, 0, -1):
            unit_arm = unit_arm * root + disk.spin_friction[i]
            creep = creep * root + disk.spin_friction[PIVOTING_COEFFICIENT_COUNT + i]
        pivoting = limited_arm_kernel(
            unit_arm / root**4,
            creep / root**4,
            abs(spin_z),
            travel * travel,
            False,
            disk.friction,
        )
        arms = (arms[0], arms[1], disk.radius * pivoting)
    for arm, direction in zip(arms, directions):  # noqa: B905 - unknown to Numba
        rate = 0.0
        for i in range(3):
            rate += velocity.angular[i] * direction[i]
        most = abs(rate) * disk.diametral_inertia / step
        resistance = min(arm * max(normal, 0.0), most) * np.sign(rate)
        for i in range(3):
            torque[i] -= resistance * direction[i]
