"""Time loop of the compliant motion, with many steps per compiled call."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.stepping.contact_energy import update_law_interval
from dynamics.compliant.stepping.normal import step_normal
from dynamics.compliant.stepping.normal_with_modes import (
    step_normal_with_modes,
    step_tangential_with_modes,
    update_gap_stiffness,
)
from dynamics.compliant.stepping.state_layout import (
    STATE,
    CompiledModel,
)
from dynamics.compliant.stepping.table_modes import (
    CONTACT,
    ContactModes,
    mode_energies,
    table_rise,
)
from dynamics.compliant.stepping.tangential import apply_bowl_force, step_tangential
from dynamics.numba_kernels import kernel, outermost
from dynamics.stepping_core.end_reasons import EndReason

FLAT_INCLINATION = 1e-5
"""Inclination [rad] below which a disk on a table with modes is considered flat."""


class MotionSteps(NamedTuple):
    """Time steps of one call of `step_motion`."""

    before: int
    """Number of steps since the start of the motion."""
    duration: float
    """Length h of a step [s]."""
    per_row: int
    """Number of steps in each row."""
    final_sine: float
    """Sine of the inclination at which the motion ends."""


class MotionRecords(NamedTuple):
    """Output of `step_motion`.

    The first flight and the first slip may have started before the call; an event
    without an end (NaN) continues.
    """

    rows: np.ndarray
    """States (n, STATE_SIZE), one after every `MotionSteps.per_row` steps."""
    forces: np.ndarray
    """Mean forces (n p, 3) on the disk along t, d and the normal [N], p per row."""
    flights: np.ndarray
    """Start [s], end [s] and height [m] (f, 3) of each loss of contact."""
    slips: np.ndarray
    """Start and end [s] (g, 2)."""


@outermost
def step_motion(
    y: np.ndarray,
    steps: MotionSteps,
    model: CompiledModel,
    modes: ContactModes | None,
    records: MotionRecords,
) -> tuple[EndReason, int, int, int]:
    """Advance the state y and fill the rows of the records.

    Parameters
    ----------
    y : (STATE_SIZE,) array
        State, which is advanced.
    steps : MotionSteps
        Time steps.
    model : CompiledModel
        Constants and tabulated functions of the model.
    modes : ContactModes or None
        Modes of table and disk, which are advanced. A version without them is compiled for
        a rigid table.
    records : MotionRecords
        Output.

    Returns
    -------
    tuple of int
        Reason for the return, and the numbers of filled rows, ended flights and
        ended slips.
    """
    # Time [s] for which a disk on a table with modes must be flat at the end of its motion.
    # With several modes the contact is not unique, and the disk would rattle forever.
    rest_duration = 0.02
    # Ratio of sin(inclination) after and before a step below which the disk is flat, because
    # it would pass through the table in the next steps.
    min_inclination_ratio = 0.6
    constants = model.constants
    steps_before, h, steps_per_row, final_sine = steps
    rows, forces, flights, slips = records
    flying = flights[0, 0] == flights[0, 0]
    sliding = slips[0, 0] == slips[0, 0]
    flight = 0
    slip = 0
    forces[:] = 0.0
    steps_per_force = (
        steps_per_row * len(rows) // len(forces)
    )  # number of steps in each mean force
    previous_force = 0
    current_force = 0
    steps_left = steps_per_force
    half_weight = 1 / (2 * steps_per_force)
    for row in range(len(rows)):
        if row == 0 or modes is None:
            update_law_interval(y, model.law)
        for i in range(steps_per_row + 1):
            tangential_step = h / 2 if i in (0, steps_per_row) else h
            # outside the tangential parts, which balance the energy without gravity
            apply_bowl_force(y, constants, tangential_step / 2)
            if modes is None:
                sine = y[STATE.sin_inclination]
                step_tangential(
                    y, model, modes, y[6] / sine, y[7] / sine, tangential_step
                )
            else:
                step_tangential_with_modes(y, model, modes, tangential_step)
            apply_bowl_force(y, constants, tangential_step / 2)
            for k in range(
                2
            ):  # half of each tangential step counts for the previous force, half for the next
                if i > 0:
                    forces[previous_force, k] += (
                        half_weight * y[STATE.tangential_force + k]
                    )
                if i < steps_per_row:
                    forces[current_force, k] += (
                        half_weight * y[STATE.tangential_force + k]
                    )
            if (y[STATE.is_sliding] > 0) != sliding:
                slips[slip, 1 if sliding else 0] = steps_before * h
                slip += 1 if sliding else 0
                sliding = not sliding
            if i == steps_per_row:
                break
            gap_before = y[STATE.gap]
            if modes is None:
                sine = y[STATE.sin_inclination]
                solved = step_normal(y, model, h)
                flat = y[STATE.sin_inclination] < min_inclination_ratio * sine
            else:
                solved = step_normal_with_modes(y, model, modes, h)
                modes.contact[CONTACT.flat_steps] = (
                    modes.contact[CONTACT.flat_steps] + 1
                    if y[STATE.sin_inclination] < FLAT_INCLINATION
                    else 0
                )
                flat = (
                    modes.contact[CONTACT.flat_steps] * h > rest_duration
                    or y[STATE.energy_deficit] > 0
                )
            if not solved:
                return EndReason.UNSOLVED, row, flight, slip
            forces[current_force, 2] += 2 * half_weight * y[STATE.normal_force]
            previous_force = current_force
            steps_left -= 1
            if steps_left == 0:
                current_force += 1
                steps_left = steps_per_force
            flying, flight = record_flight(
                flights,
                flight,
                flying,
                gap_before,
                y[STATE.gap],
                steps_before * h,
                h,
            )
            steps_before += 1
            if flat:
                return EndReason.LIES_FLAT, row, flight, slip
            tilt = constants.radius * y[STATE.sin_inclination]
            if constants.film.turning > 0 and y[STATE.gap] > tilt:
                return EndReason.IS_AIRBORNE, row, flight, slip
        if modes is not None:
            update_gap_stiffness(y, model, modes)
            y[STATE.table_mode_energy], y[STATE.disk_mode_energy] = mode_energies(modes)
            y[STATE.table_rise] = table_rise(modes)
        for j in range(
            len(y)
        ):  # `rows[row] = y` would add seconds to the compilation time
            rows[row, j] = y[j]
        floats = constants.film.turning > 0 and y[STATE.gap] > 0
        is_final = y[STATE.sin_inclination] < final_sine and not floats
        if (is_final and modes is None) or y[8] <= 0:
            return (
                (EndReason.STANDS_UPRIGHT if y[8] <= 0 else EndReason.LIES_FLAT),
                row + 1,
                flight,
                slip,
            )
    return EndReason.CONTINUES, len(rows), flight, slip


@kernel
def record_flight(
    flights: np.ndarray,
    flight: int,
    flying: bool,
    gap_before: float,
    gap: float,
    t: float,
    h: float,
) -> tuple[bool, int]:
    """Record the opening or closing of the gap in a step that starts at time t.

    Returns True if the gap is open, and the index of the current flight.
    """
    if gap > 0 and not flying:
        flights[flight, 0] = t + h * max(0.0, -gap_before) / (
            gap - min(gap_before, 0.0)
        )
        flights[flight, 2] = 0.0
    if gap > 0:
        flights[flight, 2] = max(flights[flight, 2], gap)
    elif flying:
        flights[flight, 1] = t + h * gap_before / (gap_before - gap)
        return False, flight + 1
    return gap > 0, flight
