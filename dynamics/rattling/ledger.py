"""Samples and energy losses of a rattling disk, and its flights."""

from dynamics.numba_kernels import kernel
from dynamics.rattling.body import energy_of_change, scalar_product
from dynamics.rattling.layout import DASHPOT, ELASTIC, FILM, RECORD, RECORD_SIZE
from dynamics.rattling.vibration import table_energy, work_lost_to_damping


@kernel
def record_mode_losses(motion):
    """Move the energies lost by the modes of the disk since the last sample to the record."""
    for j in range(motion.mode_loss.size):
        motion.record[RECORD.disk_mode_loss] += motion.mode_loss[j]
        motion.mode_loss[j] = 0.0


@kernel
def add_half_sample(motion, row):
    """Add half of state, record and modes of the disk to a row of the samples."""
    disk = motion.disk.ravel()
    modes = disk.size + RECORD_SIZE
    for i in range(disk.size):
        row[i] += 0.5 * disk[i]
    for i in range(RECORD_SIZE):
        row[disk.size + i] += 0.5 * motion.record[i]
    for j in range(motion.mode_loss.size):
        row[modes + 2 * j] += 0.5 * motion.modes[0, j]
        row[modes + 2 * j + 1] += 0.5 * motion.modes[1, j]


@kernel
def begin_sample(table, motion, row):
    """Write a row of the samples: energy of the table, half of the rest before the impulse."""
    record_mode_losses(motion)
    row[:] = 0.0
    if table is not None:
        update_table_account(table, motion)
        row[-1] = motion.record[RECORD.table_energy]
    add_half_sample(motion, row)


@kernel
def add_impulse_to_sample(motion, contacts, change, h, row):
    """Add the energy by which the mean velocity of a step is too slow to a row of the samples."""
    gain = energy_of_change(contacts, change, motion.mode_loss.size, h)
    row[motion.disk.size + RECORD.spring_energy] += gain / 4


@kernel
def start_table_account(table, motion):
    """Write the energy of the table modes to the record."""
    if table is not None:
        motion.record[RECORD.table_energy] = table_energy(table, motion)
        motion.record[RECORD.table_work] = 0.0


@kernel
def update_table_account(table, motion):
    """Record the energy that the table modes lost since the last call, and their energy."""
    if table is not None:
        record = motion.record
        energy = table_energy(table, motion)
        received = record[RECORD.table_energy] + record[RECORD.table_work]
        record[RECORD.table_mode_loss] += received - energy
        record[RECORD.table_energy] = energy
        record[RECORD.table_work] = 0.0


@kernel
def record_table_work(table, motion, before, change, step):
    """Record the work of an impulse on the table modes.

    Returns the mean of their kinetic energy [J] before and after the impulse less that
    before it.
    """
    gain = change.table_modes
    by_old = scalar_product(before.table_modes, gain)
    by_gain = scalar_product(gain, gain)
    motion.record[RECORD.table_work] += by_old + by_gain / 2
    motion.record[RECORD.table_work] -= work_lost_to_damping(table, motion, gain, step)
    return by_old / 2 + by_gain / 4


@kernel
def record_flight(motion, rim, contacts, weight, now, duration, flights, count):
    """Record the loss of contact that starts, continues or ends in a step.

    A flight that ends is written to row `count` of the `flights`. Returns the number of
    flights written.
    """
    record = motion.record
    force = contacts.force[ELASTIC, 2] + contacts.force[DASHPOT, 2]
    if force > 1e-6 * weight:
        if record[RECORD.flight_start] >= 0:
            flights[count, 0] = record[RECORD.flight_start]
            flights[count, 1] = now - record[RECORD.flight_start]
            flights[count, 2] = record[RECORD.max_flight_height]
            record[RECORD.flight_start] = -1.0
            return count + 1
        return count
    if record[RECORD.flight_start] < 0:
        record[RECORD.flight_start] = now
        record[RECORD.max_flight_height] = 0.0
        record[RECORD.flight_film_impulse] = 0.0
    record[RECORD.open_time] += duration
    record[RECORD.flight_film_impulse] += duration * contacts.force[FILM, 2]
    height = rim.height - rim.tilt
    record[RECORD.max_flight_height] = max(record[RECORD.max_flight_height], height)
    return count


@kernel
def is_carried_by_film(record, now, weight):
    """Return True if the air film has supported the disk since the loss of contact."""
    min_duration = 2e-3  # s
    min_lift = 0.5  # mean force of the film divided by the weight
    duration = now - record[RECORD.flight_start]
    if record[RECORD.flight_start] < 0 or duration < min_duration:
        return False
    return record[RECORD.flight_film_impulse] > min_lift * weight * duration
