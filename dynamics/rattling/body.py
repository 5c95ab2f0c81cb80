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
    Contacts,
    LowerEdge,
    RattlingDisk,
)
from dynamics.stepping_core.rotation import angular_velocity, rotate
from dynamics.stepping_core.vectors import AnyVector, Triple, cross, dot


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


def motion_state(
    disk: np.ndarray, modes: np.ndarray, record: np.ndarray, disk_modes: int
) -> MotionState:
    """Return the `MotionState`; the first `disk_modes` modes are those of the disk."""
    of_table = modes[:, disk_modes:]
    return MotionState(disk, modes, record, np.zeros(disk_modes), *of_table)


class PressedDisk(NamedTuple):
    """A disk, its edge, their motion, and the forces on the rim.

    Attributes
    ----------
    disk : RattlingDisk
        Disk and contact.
    edge : LowerEdge
        Lower edge of the disk.
    motion : MotionState
        State of disk and modes.
    contacts : Contacts
        Forces, which are written.
    """

    disk: RattlingDisk
    edge: LowerEdge
    motion: MotionState
    contacts: Contacts


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
def zero_velocities(motion: MotionState) -> Velocities:
    """Return `Velocities` that are zero, for the modes of a `MotionState`."""
    velocities = np.zeros(6 + motion.modes.shape[1])
    modes = velocities[6:]
    table_modes = modes[motion.mode_loss.size :]
    return Velocities(velocities, velocities[:3], velocities[3:6], modes, table_modes)


@kernel
def write_velocity(pressed: PressedDisk, out: Velocities) -> None:
    """Write the velocities of disk and modes to `out`."""
    motion = pressed.motion
    state = motion.disk
    spin = angular_velocity(pressed.disk, state[AXIS], state[MOMENTUM])
    for i in range(3):
        out.linear[i] = state[VELOCITY, i]
        out.angular[i] = spin[i]
    for j in range(motion.modes.shape[1]):
        out.modes[j] = motion.modes[1, j]


@kernel
def falling_energy(disk: RattlingDisk, velocity: Velocities) -> float:
    """Return the kinetic energy [J] of heave and tilt, without gliding and spinning."""
    linear = velocity.linear
    angular = velocity.angular
    tilting = disk.diametral_inertia * (angular[0] ** 2 + angular[1] ** 2)
    return (disk.mass * linear[2] ** 2 + tilting) / 2


@kernel
def fly(pressed: PressedDisk, gravity: float, propagator: np.ndarray, h: float) -> None:
    """Advance the disk and its modes exactly by a time h without contact.

    `propagator` (4, d) is that of the modes.
    """
    disk, edge, motion, _ = pressed
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
    size = np.sqrt(dot(momentum, momentum))
    if size > 0:
        own = disk.inverse_inertia_excess * dot(momentum, axis) * h
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
        squared = edge.modes.frequency[j] ** 2
        lost[j] += (squared * (place**2 - later**2) + speed**2 - faster**2) / 2
        ring[0, j] = later
        ring[1, j] = faster


class RimGeometry(NamedTuple):
    """Position of the rim in space.

    Attributes
    ----------
    axis, reference : ndarray, shape (3,)
        Axis of the disk and unit vector towards the point of the rim at angle zero.
    quarter_turn : tuple of float
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
    quarter_turn: Triple
    upright: float
    sine: float
    inclination: float
    height: float
    tilt: float


@kernel
def rim_geometry(pressed: PressedDisk) -> RimGeometry:
    """Return the present `RimGeometry`."""
    disk = pressed.disk
    state = pressed.motion.disk
    axis = state[AXIS]
    reference = state[RIM_REFERENCE_VECTOR]
    quarter_turn = cross(axis, reference)
    sine = np.hypot(reference[2], quarter_turn[2])
    upright = axis[2]
    return RimGeometry(
        axis,
        reference,
        quarter_turn,
        upright,
        max(sine, 1e-6),
        max(np.arctan2(sine, upright), 1e-6),
        state[CENTRE, 2] - disk.core_depth * upright - disk.fillet,
        disk.core_radius * sine,
    )


@kernel
def point_in_space(
    rim: RimGeometry, cosine: float, sine: float, below: float
) -> Triple:
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
def add_force(contacts: Contacts, cause: int, force: AnyVector, arm: AnyVector) -> None:
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
def clear(contacts: Contacts) -> None:
    """Set all forces to zero."""
    contacts.load[:] = 0.0
    contacts.pull[:] = 0.0


@kernel
def scalar_product(a: np.ndarray, b: np.ndarray) -> float:
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
def write_velocity_change(pressed: PressedDisk, h: float, out: Velocities) -> None:
    """Write the velocity changes caused by the forces within a time h to `out`."""
    disk, _, motion, contacts = pressed
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
    extra = disk.inverse_inertia_excess * axial
    for i in range(3):
        out.angular[i] += extra * axis[i]
    for j in range(motion.modes.shape[1]):
        out.modes[j] = h * (contacts.pull[ELASTIC, j] + contacts.pull[DASHPOT, j])


@kernel
def energy_of_change(pressed: PressedDisk, change: Velocities, h: float) -> float:
    """Return the kinetic energy [J] of the velocity changes of the disk and its modes.

    A quarter of it is the mean kinetic energy before and after the change less that of the
    mean velocity.
    """
    contacts = pressed.contacts
    energy = 0.0
    for i in range(contacts.load.shape[1]):
        for origin in range(contacts.load.shape[0]):
            energy += h / 2 * contacts.load[origin, i] * change.all[i]
    for j in range(pressed.motion.mode_loss.size):
        energy += change.modes[j] ** 2 / 2
    return energy


@kernel
def kick(
    pressed: PressedDisk, before: Velocities, change: Velocities, h: float
) -> None:
    """Apply the forces for a time h, and record impulse and losses.

    `before` and `change` are the velocities before the forces and their change.
    """
    disk, _, motion, contacts = pressed
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
