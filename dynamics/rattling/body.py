"""Rigid body of a rattling disk: its state, free flight, rim, and the effect of forces.

The flight is exact: the centre falls, the disk rotates as a symmetric top, and its modes
vibrate freely.
"""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel
from dynamics.rattling.layout import (
    AXIS,
    CENTRE,
    DASHPOT,
    ELASTIC,
    FILM,
    FRICTION,
    MOMENTUM,
    RECORD,
    RESISTANCE,
    RIM_REFERENCE_VECTOR,
    VELOCITY,
)


class MotionState(NamedTuple):
    """State of a rattling disk.

    Attributes
    ----------
    disk : ndarray, shape (5, 3)
        Position, velocity, axis, reference vector of the rim, angular momentum.
    modes : ndarray, shape (2, m)
        Displacements [kg^1/2 m] and velocities of the modes of disk and table.
    record : ndarray, shape (RECORD_SIZE,)
        Sums since the start; see `RecordLayout`.
    mode_loss : ndarray, shape (d,)
        Energy lost by the damping of each mode of the disk since the last sample [J].
    table_place, table_speed : ndarray, shape (t,)
        Parts of `modes` for the table.
    """

    disk: np.ndarray
    modes: np.ndarray
    record: np.ndarray
    mode_loss: np.ndarray
    table_place: np.ndarray
    table_speed: np.ndarray


def motion_state(disk, modes, record, disk_modes) -> MotionState:
    """Return the `MotionState`; the first `disk_modes` modes are those of the disk."""
    of_table = modes[:, disk_modes:]
    return MotionState(disk, modes, record, np.zeros(disk_modes), *of_table)


class Velocities(NamedTuple):
    """Velocities, or their changes, of the disk and of m modes; t of these belong to the table.

    Attributes
    ----------
    all : ndarray, shape (6 + m,)
        All velocities in the order of the following views.
    linear, angular : ndarray, shape (3,)
        Velocity of the centre [m/s] and angular velocity [rad/s].
    modes : ndarray, shape (m,)
        Velocities of the modes of disk and table.
    table_modes : ndarray, shape (t,)
        Those of the table alone.
    """

    all: np.ndarray
    linear: np.ndarray
    angular: np.ndarray
    modes: np.ndarray
    table_modes: np.ndarray


@kernel
def zero_velocities(motion):
    """Return `Velocities` that are zero, for the modes of a `MotionState`."""
    velocities = np.zeros(6 + motion.modes.shape[1])
    modes = velocities[6:]
    table_modes = modes[motion.mode_loss.size :]
    return Velocities(velocities, velocities[:3], velocities[3:6], modes, table_modes)


@kernel
def write_velocity(disk, motion, out):
    """Write the velocities of disk and modes to `out`."""
    state = motion.disk
    axial = 0.0
    for i in range(3):
        out.linear[i] = state[VELOCITY, i]
        axial += state[MOMENTUM, i] * state[AXIS, i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out.angular[i] = (
            state[MOMENTUM, i] / disk.diametral_inertia + extra * state[AXIS, i]
        )
    for j in range(motion.modes.shape[1]):
        out.modes[j] = motion.modes[1, j]


@kernel
def falling_energy(disk, velocity):
    """Return the kinetic energy [J] of heave and tilt, without gliding and spinning."""
    linear = velocity.linear
    angular = velocity.angular
    tilting = disk.diametral_inertia * (angular[0] ** 2 + angular[1] ** 2)
    return (disk.mass * linear[2] ** 2 + tilting) / 2


@kernel
def rotate(vector, axis, angle):
    """Rotate a vector (3,) in place about a unit vector `axis` by an angle [rad]."""
    x, y, z = axis
    c = np.cos(angle)
    s = np.sin(angle)
    a = vector[0]
    b = vector[1]
    d = vector[2]
    along = (1 - c) * (a * x + b * y + d * z)
    vector[0] = c * a + s * (y * d - z * b) + along * x
    vector[1] = c * b + s * (z * a - x * d) + along * y
    vector[2] = c * d + s * (x * b - y * a) + along * z


@kernel
def fly(disk, gravity, edge, motion, propagator, h):
    """Advance the disk and its modes exactly by a time h without contact.

    `propagator` (4, d) is that of the modes.
    """
    state = motion.disk
    ring = motion.modes
    for i in range(3):
        state[CENTRE, i] += h * state[VELOCITY, i]
    state[CENTRE, 2] -= 0.5 * gravity * h * h
    state[VELOCITY, 2] -= gravity * h
    if disk.bowl[0] > 0:
        for i in range(2):
            state[VELOCITY, i] -= (
                h * disk.bowl[0] * (state[CENTRE, i] + disk.bowl[1 + i])
            )
    momentum = state[MOMENTUM]
    axis = state[AXIS]
    size = np.sqrt(momentum[0] ** 2 + momentum[1] ** 2 + momentum[2] ** 2)
    if size > 0:
        axial = momentum[0] * axis[0] + momentum[1] * axis[1] + momentum[2] * axis[2]
        own = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial * h
        rotate(state[RIM_REFERENCE_VECTOR], axis, own)
        turn = size / disk.diametral_inertia * h
        direction = (momentum[0] / size, momentum[1] / size, momentum[2] / size)
        rotate(state[RIM_REFERENCE_VECTOR], direction, turn)
        rotate(axis, direction, turn)
    lost = motion.mode_loss
    for j in range(edge.axial.shape[0]):
        place = ring[0, j]
        speed = ring[1, j]
        later = propagator[0, j] * place + propagator[1, j] * speed
        faster = propagator[2, j] * place + propagator[3, j] * speed
        squared = edge.frequency[j] ** 2
        lost[j] += (squared * (place**2 - later**2) + speed**2 - faster**2) / 2
        ring[0, j] = later
        ring[1, j] = faster


class RimGeometry(NamedTuple):
    """Position of the rim in space.

    Attributes
    ----------
    axis, reference : ndarray, shape (3,)
        Axis of the disk and unit vector towards the point of the rim at angle zero.
    quarter_turn : ndarray, shape (3,)
        Unit vector from the centre to the point of the rim at the angle pi/2.
    upright : float
        Cosine of the inclination.
    sine : float
        Sine of the inclination, at least 1e-6.
    inclination : float
        Inclination [rad], at least 1e-6.
    height : float
        Height [m] above the table of the point of the axis in the plane of the edge.
    tilt : float
        Height of that point above the lowest point of the edge [m].
    """

    axis: np.ndarray
    reference: np.ndarray
    quarter_turn: np.ndarray
    upright: float
    sine: float
    inclination: float
    height: float
    tilt: float


@kernel
def rim_geometry(disk, state, quarter_turn_vector):
    """Return the RimGeometry of a state; the array `quarter_turn_vector` is reused."""
    axis = state[AXIS]
    reference = state[RIM_REFERENCE_VECTOR]
    quarter_turn_vector[0] = axis[1] * reference[2] - axis[2] * reference[1]
    quarter_turn_vector[1] = axis[2] * reference[0] - axis[0] * reference[2]
    quarter_turn_vector[2] = axis[0] * reference[1] - axis[1] * reference[0]
    sine = np.hypot(reference[2], quarter_turn_vector[2])
    upright = axis[2]
    return RimGeometry(
        axis,
        reference,
        quarter_turn_vector,
        upright,
        max(sine, 1e-6),
        max(np.arctan2(sine, upright), 1e-6),
        state[CENTRE, 2] - (disk.half_thickness - disk.fillet) * upright - disk.fillet,
        (disk.radius - disk.fillet) * sine,
    )


@kernel
def point_in_space(rim, cosine, sine, below):
    """Return the vector (x, y, z) [m] from the centre of the disk to a point of it.

    `cosine` and `sine` [m] are its coordinates along the reference vector of the rim and a
    quarter turn ahead; `below` [m] is its distance below the middle plane.
    """
    axis = rim.axis
    reference = rim.reference
    turned = rim.quarter_turn
    x = cosine * reference[0] + sine * turned[0] - below * axis[0]
    y = cosine * reference[1] + sine * turned[1] - below * axis[1]
    z = cosine * reference[2] + sine * turned[2] - below * axis[2]
    return x, y, z


@kernel
def add_force(contacts, cause, force, arm):
    """Add a force [N] by `cause` with an arm [m] from the centre to forces and torques."""
    x, y, z = force
    arm_x, arm_y, arm_z = arm
    contacts.force[cause, 0] += x
    contacts.force[cause, 1] += y
    contacts.force[cause, 2] += z
    contacts.torque[cause, 0] += arm_y * z - arm_z * y
    contacts.torque[cause, 1] += arm_z * x - arm_x * z
    contacts.torque[cause, 2] += arm_x * y - arm_y * x


@kernel
def clear(contacts):
    """Set all forces to zero."""
    contacts.load[:] = 0.0
    contacts.pull[:] = 0.0


@kernel
def scalar_product(a, b):
    """Return the scalar product of two arrays, as four partial sums that a processor
    evaluates in parallel."""
    s0 = 0.0
    s1 = 0.0
    s2 = 0.0
    s3 = 0.0
    whole = a.size - a.size % 4
    for i in range(0, whole, 4):
        s0 += a[i] * b[i]
        s1 += a[i + 1] * b[i + 1]
        s2 += a[i + 2] * b[i + 2]
        s3 += a[i + 3] * b[i + 3]
    for i in range(whole, a.size):
        s0 += a[i] * b[i]
    return (s0 + s1) + (s2 + s3)


@kernel
def write_velocity_change(disk, motion, contacts, h, out):
    """Write the velocity changes caused by the forces within a time h to `out`."""
    axis = motion.disk[AXIS]
    axial = 0.0
    for i in range(3):
        out.linear[i] = 0.0
        out.angular[i] = 0.0
        for origin in range(contacts.load.shape[0]):
            torque = contacts.torque[origin, i]
            out.linear[i] += h / disk.mass * contacts.force[origin, i]
            out.angular[i] += h / disk.diametral_inertia * torque
            axial += h * torque * axis[i]
    extra = (1 / disk.axial_inertia - 1 / disk.diametral_inertia) * axial
    for i in range(3):
        out.angular[i] += extra * axis[i]
    for j in range(motion.modes.shape[1]):
        out.modes[j] = h * (contacts.pull[ELASTIC, j] + contacts.pull[DASHPOT, j])


@kernel
def energy_of_change(contacts, change, disk_modes, h):
    """Return the kinetic energy [J] of the velocity changes of the disk and its modes.

    A quarter of it is the mean kinetic energy before and after the change less that of the
    mean velocity.
    """
    energy = 0.0
    for i in range(contacts.load.shape[1]):
        for origin in range(contacts.load.shape[0]):
            energy += h / 2 * contacts.load[origin, i] * change.all[i]
    for j in range(disk_modes):
        energy += change.modes[j] ** 2 / 2
    return energy


@kernel
def kick(disk, motion, contacts, before, change, h):
    """Apply the forces for a time h, and record impulse and losses.

    `before` and `change` are the velocities before the forces and their change.
    """
    state = motion.disk
    record = motion.record
    load = contacts.load
    for i in range(load.shape[1]):
        mean = before.all[i] + change.all[i] / 2
        record[RECORD.contact_loss] -= h * load[DASHPOT, i] * mean
        record[RECORD.slip_loss] -= h * load[FRICTION, i] * mean
        record[RECORD.moment_loss] -= h * load[RESISTANCE, i] * mean
        record[RECORD.film_loss] -= h * load[FILM, i] * mean
    for i in range(3):
        for origin in range(load.shape[0]):
            state[VELOCITY, i] += h / disk.mass * contacts.force[origin, i]
            state[MOMENTUM, i] += h * contacts.torque[origin, i]
            record[RECORD.impulse + i] += h * contacts.force[origin, i]
    record[RECORD.film_impulse] += h * contacts.force[FILM, 2]
    for i in range(2):
        record[RECORD.friction_impulse + i] += h * contacts.force[FRICTION, i]
    pull = contacts.pull[DASHPOT]
    record[RECORD.contact_loss] -= h * (
        scalar_product(pull, before.modes) + scalar_product(pull, change.modes) / 2
    )
    for j in range(motion.modes.shape[1]):
        motion.modes[1, j] += change.modes[j]
