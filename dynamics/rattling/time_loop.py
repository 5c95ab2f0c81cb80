"""Time steps of a disk with contact springs along its whole rim.

A step consists of free flight for half its duration, the impulse of the contacts, and
free flight for the other half. High above the table, all steps except the last one before
the next sample are merged into one.
"""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel, outermost
from dynamics.rattling.air_impulses import add_film
from dynamics.rattling.body import (
    Velocities,
    clear,
    fly,
    kick,
    rim_geometry,
    write_velocity,
    write_velocity_change,
    zero_velocities,
)
from dynamics.rattling.layout import (
    ELASTIC,
    RECORD,
    RIM_BLOCK_POINTS,
    Contacts,
)
from dynamics.rattling.ledger import (
    add_half_sample,
    add_impulse_to_sample,
    begin_sample,
    is_carried_by_film,
    record_flight,
    record_table_work,
    start_table_account,
    update_table_account,
)
from dynamics.rattling.resistance import add_resistance
from dynamics.rattling.rim_contacts import StepMotion, press_rim, stays_clear
from dynamics.rattling.vibration import (
    fly_table,
    propagators_over_half_steps,
    table_deflection_bound,
)

CONTINUES, LIES_FLAT, STANDS_UPRIGHT, LIFTS_OFF, IS_AIRBORNE = range(5)
"""Reasons for ending the time steps."""


class TimeSteps(NamedTuple):
    """Constants of the time steps.

    Attributes
    ----------
    duration : float
        Time step [s].
    per_sample : int
        Steps between two samples.
    gravity : float
        Acceleration of gravity [m/s^2].
    final_tilt : float
        `RimGeometry.tilt` [m] below which the disk lies flat.
    """

    duration: float
    per_sample: int
    gravity: float
    final_tilt: float


class StepArrays(NamedTuple):
    """Arrays that the time steps reuse.

    Attributes
    ----------
    contacts : Contacts
        Forces of a step.
    before, mean, change : Velocities
        Velocities before the forces of a step, their mean in the step and their change.
    quarter_turn : ndarray, shape (3,)
        `RimGeometry.quarter_turn`.
    disk_propagators : ndarray, shape (n, 4, d)
        Propagators of the modes of the disk over 1 to n half steps, as many as there are
        steps between two samples.
    table_propagators : ndarray, shape (2 n, 4, t)
        Those of the table over 1 to 2 n half steps.
    """

    contacts: Contacts
    before: Velocities
    mean: Velocities
    change: Velocities
    quarter_turn: np.ndarray
    disk_propagators: np.ndarray
    table_propagators: np.ndarray


@kernel
def new_step_arrays(edge, table, steps, motion):
    """Return new `StepArrays` for `TimeSteps`."""
    count = edge.heights.size
    load = np.zeros((5, 6))
    contacts = Contacts(
        load,
        load[:, :3],
        load[:, 3:],
        np.zeros((2, motion.modes.shape[1])),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(RIM_BLOCK_POINTS),
        np.zeros(RIM_BLOCK_POINTS),
        np.zeros(RIM_BLOCK_POINTS),
    )
    return StepArrays(
        contacts,
        zero_velocities(motion),
        zero_velocities(motion),
        zero_velocities(motion),
        np.empty(3),
        propagators_over_half_steps(edge, steps.per_sample, steps.duration),
        propagators_over_half_steps(table, 2 * steps.per_sample, steps.duration),
    )


@kernel
def count_merged_steps(disk, edge, table, steps, motion, arrays, max_deflection, left):
    """Return the number of steps that can be merged into the next one, at most `left`.

    The second result is the greatest deflection of the table [m] until the next contact,
    if it is known; otherwise, it and `max_deflection` are negative.
    """
    if motion.record[RECORD.flight_start] < 0 or left <= 1:
        return 1, max_deflection
    rim = rim_geometry(disk, motion.disk, arrays.quarter_turn)
    if max_deflection < 0:
        max_deflection = 0.0
        if table is not None:
            max_deflection = table_deflection_bound(table, motion)
    if stays_clear(
        disk,
        edge,
        max_deflection,
        steps.gravity,
        motion,
        rim,
        arrays.contacts,
        left * steps.duration,
    ):
        return left, max_deflection
    return 1, max_deflection


@kernel
def write_contact_forces(disk, edge, table, steps, motion, rim, arrays, now):
    """Write the forces of contacts and resisting moments in a step to the contacts.

    Forces at the mean velocity and mean depth of the step conserve energy. They are
    found from those at the velocity before the step.
    """
    contacts = arrays.contacts
    for is_changed in (False, True):
        if is_changed:
            write_velocity_change(disk, motion, contacts, steps.duration, arrays.change)
            for i in range(arrays.before.all.size):
                arrays.mean.all[i] = arrays.before.all[i] + arrays.change.all[i] / 2
            clear(contacts)
        moving = StepMotion(arrays.mean, arrays.change, is_changed, now, steps.duration)
        energy = press_rim(disk, edge, table, motion, rim, moving, contacts)
        if is_changed:
            add_resistance(
                disk,
                disk.mass * steps.gravity,
                rim,
                arrays.mean,
                motion.record[RECORD.spring_energy],
                steps.duration,
                contacts,
            )
        motion.record[RECORD.spring_energy] = energy
        if contacts.force[ELASTIC, 2] <= 0:
            break


@kernel
def begin_forces(disk, motion, arrays):
    """Write the velocities before the forces of a step, and clear the forces."""
    write_velocity(disk, motion, arrays.before)
    arrays.change.all[:] = 0.0
    arrays.mean.all[:] = arrays.before.all
    clear(arrays.contacts)
    motion.record[RECORD.spring_energy] = 0.0


@kernel
def reason_for_end(edge, steps, motion, rim, now, weight):
    """Return the reason for ending the time steps after a step, or CONTINUES."""
    upright_cosine_limit = 0.05  # cosine of the inclination of an upright disk
    record = motion.record
    if rim.tilt < steps.final_tilt:
        return LIES_FLAT
    if rim.upright < upright_cosine_limit:
        return STANDS_UPRIGHT
    max_height = max(rim.tilt, 10 * edge.highest[0])
    if record[RECORD.flight_start] >= 0 and (
        record[RECORD.max_flight_height] > max_height
    ):
        return LIFTS_OFF
    if is_carried_by_film(record, now, weight):
        return IS_AIRBORNE
    return CONTINUES


@outermost
def step_rattling_disk(disk, edge, table, steps, motion, begin, samples, flights):
    """Advance a rattling disk and write a sample after every `steps.per_sample` steps.

    Parameters
    ----------
    disk : RattlingDisk
        Disk and contact.
    edge : LowerEdge
        Lower edge of the disk, with the unevenness.
    table : MovingTable or None
        Modes of the table; None compiles a separate version without them.
    steps : TimeSteps
        Constants of the time steps.
    motion : MotionState
        State of the disk and of its modes, and the sums since the start, updated in
        place.
    begin : float
        Time [s] of the first step.
    samples : ndarray, shape (n, 16 + RECORD_SIZE + 2 d)
        Receives state, record, modes of the disk and energy of those of the table.
    flights : ndarray, shape (f, 3)
        Output: start [s], duration [s] and height [m] of each loss of contact that
        ended; f is at least half the number of steps.

    Returns
    -------
    tuple of int
        Number of samples and of flights written, and the reason for the end.
    """
    arrays = new_step_arrays(edge, table, steps, motion)
    contacts = arrays.contacts
    weight = disk.mass * steps.gravity
    start_table_account(table, motion)
    max_deflection = -1.0
    waiting = 0  # half steps since the last flight of the table
    losses = 0
    for sample in range(samples.shape[0]):
        row = samples[sample]
        done = 0
        while done < steps.per_sample:
            merged, max_deflection = count_merged_steps(
                disk,
                edge,
                table,
                steps,
                motion,
                arrays,
                max_deflection,
                steps.per_sample - 1 - done,
            )
            done += merged
            waiting += merged
            duration = merged * steps.duration
            propagator = arrays.disk_propagators[merged - 1]
            fly(disk, steps.gravity, edge, motion, propagator, duration / 2)
            if merged == 1:
                waiting = fly_table(table, motion, arrays.table_propagators, waiting)
            now = begin + (sample * steps.per_sample + done) * steps.duration
            rim = rim_geometry(disk, motion.disk, arrays.quarter_turn)
            begin_forces(disk, motion, arrays)
            if merged == 1:
                write_contact_forces(disk, edge, table, steps, motion, rim, arrays, now)
            touches = contacts.force[ELASTIC, 2] > 0
            if disk.film.turning > 0:
                add_film(disk, motion, rim, arrays.before, duration, contacts)
            losses = record_flight(
                motion, rim, contacts, weight, now, duration, flights, losses
            )
            if done == steps.per_sample:
                begin_sample(table, motion, row)
            if touches or disk.film.turning > 0:
                write_velocity_change(disk, motion, contacts, duration, arrays.change)
                if done == steps.per_sample:
                    add_impulse_to_sample(
                        motion, contacts, arrays.change, duration, row
                    )
                kick(disk, motion, contacts, arrays.before, arrays.change, duration)
            if table is not None and touches:
                max_deflection = -1.0
                kinetic = record_table_work(
                    table, motion, arrays.before, arrays.change, steps.duration
                )
                if done == steps.per_sample:
                    row[-1] += kinetic
            if done == steps.per_sample:
                add_half_sample(motion, row)
            fly(disk, steps.gravity, edge, motion, propagator, duration / 2)
            waiting += merged
            reason = reason_for_end(edge, steps, motion, rim, now, weight)
            if reason != CONTINUES:
                return sample, losses, reason
    fly_table(table, motion, arrays.table_propagators, waiting)
    update_table_account(table, motion)
    return samples.shape[0], losses, CONTINUES
