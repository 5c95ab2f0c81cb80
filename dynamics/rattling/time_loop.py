"""Time steps of a disk with contact springs along its whole rim.

A step consists of free flight for half its duration, the impulse of contacts, resisting
moments and film, and free flight for the other half. High above the table, all steps
except the last one before the next sample are merged into one.
"""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel, outermost
from dynamics.rattling.air_impulses import add_film
from dynamics.rattling.body import (
    MotionState,
    PressedDisk,
    RimGeometry,
    clear,
    energy_of_change,
    falling_energy,
    fly,
    kick,
    rim_geometry,
    scalar_product,
    write_velocity,
    write_velocity_change,
    zero_velocities,
)
from dynamics.rattling.layout import (
    DASHPOT,
    ELASTIC,
    RECORD,
    RIM_BLOCK_POINTS,
    Contacts,
    LowerEdge,
    RattlingDisk,
)
from dynamics.rattling.resistance import add_resistance
from dynamics.rattling.rim_contacts import press_rim, stays_clear
from dynamics.rattling.samples import accumulate_half_weight, record_mode_losses
from dynamics.rattling.vibration import (
    MovingTable,
    fly_table,
    table_deflection_bound,
    table_energy,
    work_lost_to_damping,
)
from dynamics.stepping_core.end_reasons import EndReason
from dynamics.stepping_core.oscillators import write_propagator


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
        `RimGeometry.tilt` [m] below which the disk may lie flat.
    rest_energy : float
        `falling_energy` [J] below which it then does.
    """

    duration: float
    per_sample: int
    gravity: float
    final_tilt: float
    rest_energy: float


@kernel
def record_contact(
    pressed: PressedDisk,
    rim: RimGeometry,
    flights: np.ndarray,
    losses: int,
    weight: float,
    now: float,
    duration: float,
) -> int:
    """Record contact or flight in a step; return the number of losses of contact that ended."""
    record = pressed.motion.record
    spring = pressed.contacts.force[ELASTIC, 2]
    if spring > 0 and spring + pressed.contacts.force[DASHPOT, 2] > 1e-6 * weight:
        if record[RECORD.flight_start] >= 0:
            flights[losses, 0] = record[RECORD.flight_start]
            flights[losses, 1] = now - record[RECORD.flight_start]
            flights[losses, 2] = record[RECORD.max_flight_height]
            record[RECORD.flight_start] = -1.0
            return losses + 1
        return losses
    if record[RECORD.flight_start] < 0:
        record[RECORD.flight_start] = now
        record[RECORD.max_flight_height] = 0.0
    record[RECORD.open_time] += duration
    record[RECORD.max_flight_height] = max(
        record[RECORD.max_flight_height], rim.height - rim.tilt
    )
    return losses


@outermost
def step_rattling_disk(
    disk: RattlingDisk,
    edge: LowerEdge,
    table: MovingTable | None,
    steps: TimeSteps,
    motion: MotionState,
    begin: float,
    samples: np.ndarray,
    flights: np.ndarray,
) -> tuple[int, int, EndReason]:
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
    step, per_sample, gravity, final_tilt, rest_energy = steps
    upright_cosine_limit = 0.05  # cosine of the inclination of an upright disk
    mode_count = motion.modes.shape[1]
    disk_modes = motion.mode_loss.size
    propagators = np.empty((per_sample, 4, disk_modes))
    for i in range(per_sample):
        write_propagator(edge.modes, (i + 1) * step / 2, propagators[i])
    stored = 0.0
    if table is not None:
        table_propagators = np.empty((2 * per_sample, 4, mode_count - disk_modes))
        for i in range(2 * per_sample):
            write_propagator(table.modes, (i + 1) * step / 2, table_propagators[i])
        stored = table_energy(table, motion)
    count = edge.heights.size
    load = np.zeros((5, 6))
    contacts = Contacts(
        load,
        load[:, :3],
        load[:, 3:],
        np.zeros((2, mode_count)),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        np.zeros(RIM_BLOCK_POINTS),
        np.zeros(RIM_BLOCK_POINTS),
        np.zeros(RIM_BLOCK_POINTS),
    )
    pressed = PressedDisk(disk, edge, motion, contacts)
    before = zero_velocities(motion)
    mean = zero_velocities(motion)
    change = zero_velocities(motion)
    record = motion.record
    highest = edge.highest[0]
    weight = disk.mass * gravity
    has_film = disk.film.turning > 0
    received = 0.0
    max_deflection = -1.0
    waiting = 0
    losses = 0
    for sample in range(samples.shape[0]):
        done = 0
        while done < per_sample:
            merged = 1
            left = per_sample - 1 - done
            if record[RECORD.flight_start] >= 0 and left > 1:
                rim = rim_geometry(pressed)
                if max_deflection < 0:
                    max_deflection = 0.0
                    if table is not None:
                        max_deflection = table_deflection_bound(table, motion)
                if stays_clear(
                    pressed,
                    rim,
                    max_deflection,
                    gravity,
                    left * step,
                ):
                    merged = left
            done += merged
            duration = merged * step
            propagator = propagators[merged - 1]
            fly(pressed, gravity, propagator, duration / 2)
            waiting += merged
            if table is not None and merged == 1:
                fly_table(table, motion, table_propagators[waiting - 1])
                waiting = 0
            now = begin + (sample * per_sample + done) * step
            rim = rim_geometry(pressed)
            write_velocity(pressed, before)
            change.all[:] = 0.0
            clear(contacts)
            record[RECORD.spring_energy] = 0.0
            mean.all[:] = before.all
            for is_changed in (False, True):
                if merged > 1:
                    break
                if is_changed:
                    # forces at the mean velocity and mean depth of the step conserve energy
                    write_velocity_change(pressed, step, change)
                    for i in range(before.all.size):
                        mean.all[i] = before.all[i] + change.all[i] / 2
                    clear(contacts)
                energy = press_rim(
                    table, pressed, rim, mean, change, is_changed, now, step
                )
                if is_changed:
                    springs = record[RECORD.spring_energy]
                    add_resistance(pressed, rim, mean, springs, weight, step)
                record[RECORD.spring_energy] = energy
                if contacts.force[ELASTIC, 2] <= 0:
                    break
            touches = contacts.force[ELASTIC, 2] > 0
            if has_film:
                add_film(pressed, rim, before, duration)
            losses = record_contact(
                pressed, rim, flights, losses, weight, now, duration
            )
            if done == per_sample:
                record_mode_losses(motion)
                samples[sample] = 0.0
                if table is not None:
                    energy = table_energy(table, motion)
                    record[RECORD.table_loss] += stored + received - energy
                    samples[sample, -1] = energy
                    stored = energy
                    received = 0.0
                accumulate_half_weight(motion, samples[sample])
            if touches or has_film:
                write_velocity_change(pressed, duration, change)
                if done == per_sample:
                    gain = energy_of_change(pressed, change, duration)
                    samples[sample, motion.disk.size + RECORD.spring_energy] += gain / 4
                kick(pressed, before, change, duration)
            if table is not None and touches:
                max_deflection = -1.0
                faster = change.table_modes
                by_old = scalar_product(before.table_modes, faster)
                by_gain = scalar_product(faster, faster)
                received += by_old + by_gain / 2
                received -= work_lost_to_damping(table, motion, faster, step)
                if done == per_sample:  # the mean energy before and after the impulse
                    samples[sample, -1] += by_old / 2 + by_gain / 4
            if done == per_sample:
                accumulate_half_weight(motion, samples[sample])
            fly(pressed, gravity, propagator, duration / 2)
            waiting += merged
            if rim.tilt < final_tilt and falling_energy(disk, before) < rest_energy:
                return sample, losses, EndReason.IS_AT_REST
            if rim.upright < upright_cosine_limit:
                return sample, losses, EndReason.STANDS_UPRIGHT
            flies = record[RECORD.flight_start] >= 0 and not has_film
            limit = max(rim.tilt, 10 * highest)
            if flies and record[RECORD.max_flight_height] > limit:
                return sample, losses, EndReason.LIFTS_OFF
    if table is not None:
        fly_table(table, motion, table_propagators[waiting - 1])
        energy = table_energy(table, motion)
        record[RECORD.table_loss] += stored + received - energy
    return samples.shape[0], losses, EndReason.CONTINUES
