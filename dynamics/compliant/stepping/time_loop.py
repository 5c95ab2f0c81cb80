"""Time loop of the compliant motion: many steps in one compiled call, with a record of rows and
events.
"""

from enum import IntEnum, auto

import numpy as np

from dynamics.compliant.law import height_profile
from dynamics.compliant.law import tabulated as table
from dynamics.compliant.stepping import contact_energy as gap
from dynamics.compliant.stepping import (
    normal,
    normal_with_modes,
    rim_modes,
    state_layout,
    table_modes,
    tangential,
)
from dynamics.compliant.stepping.contact_energy import locate_in_law
from dynamics.compliant.stepping.normal import step_normal
from dynamics.compliant.stepping.normal_with_modes import (
    step_normal_with_modes,
    step_tangential_with_modes,
    update_gap_stiffness,
)
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.compliant.stepping.table_modes import CONTACT, mode_energies
from dynamics.compliant.stepping.tangential import step_tangential
from dynamics.film import forces
from dynamics.numba_kernels import fingerprint, kernel, outermost

MIN_INCLINATION_RATIO = 0.6
"""The disk is flat after a step that reduces sin(inclination) below this fraction.

The next steps would take the disk through the table.
"""
FLAT_INCLINATION = 1e-5
"""On a table with modes the disk is flat below this sine of its inclination [rad]."""
REST_DURATION = 0.02
"""On a table with modes the motion ends when the disk has been flat for this time [s].

With several waves the point of contact is not unique, and the disk would rattle forever.
"""
AIRBORNE_DURATION = 2e-3
"""Shortest loss of contact after which the air film may carry the disk [s]."""
AIRBORNE_LIFT_SHARE = 0.5
"""The air film carries the disk if its mean lift exceeds this fraction of the weight."""


class EndReason(IntEnum):
    """Reason for the end of a call of `step_motion`."""

    CONTINUES = auto()
    """The rows are full; the motion continues."""
    LIES_FLAT = auto()
    STANDS_UPRIGHT = auto()
    UNSOLVED = auto()
    """The equation for the normal force has no solution."""
    IS_AIRBORNE = auto()


@kernel
def _step_rows(
    y,
    steps_before,
    constants,
    powers,
    law,
    table,
    rim,
    modes,
    h,
    steps_per_row,
    final_sine,
    rows,
    forces,
    events,
):
    """Fill the rows step by step; see `step_motion`."""
    flights, slips = events
    flying = flights[0, 0] == flights[0, 0]
    sliding = slips[0, 0] == slips[0, 0]
    flight = 0
    slip = 0
    forces[:] = 0.0
    scratch = np.zeros((8, 6))
    has_modes = len(modes.state) > 0
    steps_per_force = steps_per_row * len(rows) // len(forces)  # steps averaged in each mean force
    previous_force = 0
    current_force = 0
    steps_left = steps_per_force
    half_weight = 1 / (2 * steps_per_force)
    for row in range(len(rows)):
        if row == 0 or not has_modes:
            locate_in_law(y, law)
        for i in range(steps_per_row + 1):
            tangential_step = h / 2 if i in (0, steps_per_row) else h
            if has_modes:
                step_tangential_with_modes(y, constants, powers, law, modes, tangential_step)
            else:
                step_tangential(y, constants, powers, law, tangential_step)
            for k in range(
                2
            ):  # half of each tangential step belongs to the force before, half to the next
                if i > 0:
                    forces[previous_force, k] += half_weight * y[STATE.tangential_force + k]
                if i < steps_per_row:
                    forces[current_force, k] += half_weight * y[STATE.tangential_force + k]
            if (y[STATE.is_sliding] > 0) != sliding:
                slips[slip, 1 if sliding else 0] = steps_before * h
                slip += 1 if sliding else 0
                sliding = not sliding
            if i == steps_per_row:
                break
            gap_before = y[STATE.gap]
            sine_before = y[STATE.sin_inclination]
            if has_modes:
                solved = step_normal_with_modes(
                    y,
                    constants,
                    law,
                    table,
                    rim,
                    modes,
                    scratch,
                    h,
                )
                modes.contact[CONTACT.flat_steps] = (
                    modes.contact[CONTACT.flat_steps] + 1
                    if y[STATE.sin_inclination] < FLAT_INCLINATION
                    else 0
                )
                flat = (
                    modes.contact[CONTACT.flat_steps] * h > REST_DURATION
                    or y[STATE.energy_deficit] > 0
                )
            else:
                solved = step_normal(y, constants, law, table, rim, h)
                flat = y[STATE.sin_inclination] < MIN_INCLINATION_RATIO * sine_before
            if not solved:
                return EndReason.UNSOLVED, row, flight, slip
            forces[current_force, 2] += 2 * half_weight * y[STATE.normal_force]
            previous_force = current_force
            steps_left = steps_left - 1
            if steps_left == 0:
                current_force = current_force + 1
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
            if constants.film_turning > 0 and update_airborne(y, constants, h):
                return EndReason.IS_AIRBORNE, row, flight, slip
        if has_modes:
            update_gap_stiffness(y, modes, law)
            y[STATE.table_mode_energy], y[STATE.disk_mode_energy] = mode_energies(modes)
        for j in range(
            len(y)
        ):  # `rows[row] = y` would compile an error message, which takes seconds
            rows[row, j] = y[j]
        if (y[STATE.sin_inclination] < final_sine and not has_modes) or y[8] <= 0:
            return (
                (EndReason.STANDS_UPRIGHT if y[8] <= 0 else EndReason.LIES_FLAT),
                row + 1,
                flight,
                slip,
            )
    return EndReason.CONTINUES, len(rows), flight, slip


@kernel
def update_airborne(y, constants, h):
    """Update duration and lift impulse of a flight; return True if the air film carries the
    disk."""
    in_flight = 1.0 if y[STATE.gap] > 0 else 0.0
    y[STATE.flight_duration] = in_flight * (y[STATE.flight_duration] + h)
    y[STATE.flight_lift_impulse] = in_flight * (
        y[STATE.flight_lift_impulse] + h * y[STATE.film_lift]
    )
    return (
        y[STATE.flight_duration] > AIRBORNE_DURATION
        and y[STATE.flight_lift_impulse]
        > AIRBORNE_LIFT_SHARE * constants.weight * y[STATE.flight_duration]
    )


@kernel
def record_flight(flights, flight, flying, gap_before, gap, t, h):
    """Record the opening and closing of the gap in the step from t, by linear interpolation.

    Returns whether the gap is open, and the index of the current flight.
    """
    if gap > 0 and not flying:
        flights[flight, 0] = t + h * max(0.0, -gap_before) / (gap - min(gap_before, 0.0))
        flights[flight, 2] = 0.0
    if gap > 0:
        flights[flight, 2] = max(flights[flight, 2], gap)
    elif flying:
        flights[flight, 1] = t + h * gap_before / (gap_before - gap)
        return False, flight + 1
    return gap > 0, flight


def _compiled(version):
    """Compile `step_motion` with the fingerprint of its sources as a part of the cache key."""

    @outermost
    def step_motion(
        y,
        steps_before,
        constants,
        powers,
        law,
        table,
        rim,
        modes,
        h,
        steps_per_row,
        final_sine,
        rows,
        forces,
        events,
    ):
        """Advance the state y and fill `rows` (n, STATE_SIZE), one row after every `steps_per_row`
        steps h [s].

        Parameters
        ----------
        y : (STATE_SIZE,) array
            State, which is advanced.
        steps_before : int
            Number of steps since the start of the motion.
        constants : ModelConstants
            Constants of the model.
        powers : (n, 2) array
            Power laws (c [W s^b], b) of the precession rate.
        law : LawCubics
            Tabulated contact law.
        table, rim : Profile
            Height profiles of table and edge.
        modes : ContactModes
            Modes of table and disk, which are advanced.
        h : float
            Length of a step [s].
        final_sine : float
            Sine of the inclination at which the motion ends.
        rows : (n, STATE_SIZE) array
            Receives the states.
        forces : (n p, 3) array
            Receives the mean forces on the disk along t and d and the mean normal force [N], p per
            row.
        events : tuple
            Receives flights (f, 3), begin, end [s] and height [m] of each loss of contact, and
            slips (g, 2), begin
            and end [s]. The first event may have begun before the call; an event without an end
            (NaN) continues.

        Returns
        -------
        tuple of int
            Reason of the return, rows filled, flights ended, slips ended.
        """
        version  # noqa: B018 -- part of the key of the cached machine code
        return _step_rows(
            y,
            steps_before,
            constants,
            powers,
            law,
            table,
            rim,
            modes,
            h,
            steps_per_row,
            final_sine,
            rows,
            forces,
            events,
        )

    return step_motion


step_motion = _compiled(
    fingerprint(
        rim_modes,
        forces,
        gap,
        normal,
        height_profile,
        state_layout,
        table,
        tangential,
        table_modes,
        normal_with_modes,
    )
)
