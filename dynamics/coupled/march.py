"""Many steps of the disk on its compliant contact, with what is written down of them (compiled)."""

import numpy as np

from ..film import forces
from . import bending, gap, normal, profile, state, table, tangential, waves, waving
from .compiled import fingerprint, kernel, outermost
from .gap import locate
from .normal import step_normal
from .state import ALOFT, BODY, BORNE, FORCE, GAP, LIFT, OWED, SINE, SLIDES, SURFACE, TANGENTIAL, TURNING, WEIGHT
from .tangential import step_tangential
from .waves import FLAT_FOR, energy_of
from .waving import hold_waving, soften, step_waving

FALLS = 0.6
"""A disk is flat where a step takes as much of its inclination: it would soon pass through the table."""
LIES, RESTS = 1e-5, 0.02
"""On a table that waves a disk is flat that has been below so many rad for so long [s], or that a change to another
wave brings to rest (OWED): on several waves at once one contact has no law, and would rattle without end."""
LONG, HALF = 2e-3, 0.5
"""The air carries a disk that has been without contact for so long [s], while it bore that part of the weight."""
GOES, FLAT, UPRIGHT, UNSOLVED, CARRIED = range(5)
"""Why a march stopped: not at all, at its last inclination, upright, the equation for N had no solution, by the air."""


@kernel
def _march(y, count, law, powers, start, per_unit, spline, table, rim, waves, h, every, last, rows, forces, events):
    flights, slips = events
    flying, sliding, flight, slip = flights[0, 0] == flights[0, 0], slips[0, 0] == slips[0, 0], 0, 0
    forces[:], scratch, waving = 0.0, np.zeros((8, 6)), waves.state.shape[0] > 0
    part = every * len(rows) // len(forces)  # steps over which a force is meant
    behind, now, left, share = 0, 0, part, 1 / (2 * part)
    for row in range(len(rows)):
        if row == 0 or not waving:
            locate(y, start, per_unit, spline)
        for i in range(every + 1):
            span = h / 2 if i in (0, every) else h
            if waving:
                hold_waving(y, law, powers, spline, waves, span)
            else:
                step_tangential(y, law, powers, spline, span)
            for k in range(2):  # a whole step lies half before and half after
                if i > 0:
                    forces[behind, k] += share * y[TANGENTIAL + k]
                if i < every:
                    forces[now, k] += share * y[TANGENTIAL + k]
            if (y[SLIDES] > 0) != sliding:
                slips[slip, 1 if sliding else 0] = count * h
                sliding, slip = not sliding, slip + (1 if sliding else 0)
            if i == every:
                break
            before, sine = y[GAP], y[SINE]
            if waving:
                solved = step_waving(y, law, start, per_unit, spline, table, rim, waves, scratch, h)
                waves.contact[FLAT_FOR] = waves.contact[FLAT_FOR] + 1 if y[SINE] < LIES else 0
                flat = waves.contact[FLAT_FOR] * h > RESTS or y[OWED] > 0
            else:
                solved = step_normal(y, law, start, per_unit, spline, table, rim, h)
                flat = y[SINE] < FALLS * sine
            if not solved:
                return UNSOLVED, row, flight, slip
            forces[now, 2] += 2 * share * y[FORCE]
            behind, left = now, left - 1
            if left == 0:
                now, left = now + 1, part
            flying, flight = note_flight(flights, flight, flying, before, y[GAP], count * h, h)
            count += 1
            if flat:
                return FLAT, row, flight, slip
            if law[TURNING] > 0 and is_carried(y, law, h):
                return CARRIED, row, flight, slip
        if waving:
            soften(y, waves, spline)
            y[SURFACE], y[BODY] = energy_of(waves)
        for j in range(len(y)):  # of `rows[row] = y` the message of its failure would be compiled, for seconds
            rows[row, j] = y[j]
        if (y[SINE] < last and not waving) or y[8] <= 0:
            return (UPRIGHT if y[8] <= 0 else FLAT), row + 1, flight, slip
    return GOES, len(rows), flight, slip


@kernel
def is_carried(y, law, h):
    """Note the lift of the film in a flight; return whether the air carries the disk."""
    flies = 1.0 if y[GAP] > 0 else 0.0
    y[ALOFT], y[BORNE] = flies * (y[ALOFT] + h), flies * (y[BORNE] + h * y[LIFT])
    return y[ALOFT] > LONG and y[BORNE] > HALF * law[WEIGHT] * y[ALOFT]


@kernel
def note_flight(flights, flight, flying, before, gap, t, h):
    """Note where the gap opens and closes within the step from t, by straight lines; return whether it is open."""
    if gap > 0 and not flying:
        flights[flight, 0] = t + h * max(0.0, -before) / (gap - min(before, 0.0))
        flights[flight, 2] = 0.0
    if gap > 0:
        flights[flight, 2] = max(flights[flight, 2], gap)
    elif flying:
        flights[flight, 1] = t + h * before / (before - gap)
        return False, flight + 1
    return gap > 0, flight


def _compiled(version):
    @outermost
    def march(y, count, law, powers, start, per_unit, spline, table, rim, waves, h, every, last, rows, forces, events):
        """Take `every` steps h for each of the `rows` (n, SIZE); return why it stopped, rows filled, events ended.

        `forces` (n p, 3), p to a row, are means of the force on the disk along t, d and of the normal force. `count`
        steps were taken before. `events` are flights (f, 3): begin, end [s] and height [m] of each loss of contact, and
        slips (g, 2): begin and end. One with a begin but no end (NaN) goes on: the first from before, the last after.
        """
        version  # noqa: B018 -- a part of the key under which the machine code is kept
        return _march(
            y, count, law, powers, start, per_unit, spline, table, rim, waves, h, every, last, rows, forces, events
        )

    return march


march = _compiled(fingerprint(bending, forces, gap, normal, profile, state, table, tangential, waves, waving))
