"""Many steps of the disk on its compliant contact, with what is written down of them (compiled)."""

from . import gap, normal, profile, state, table, tangential
from .compiled import fingerprint, kernel, outermost
from .gap import locate
from .normal import step_normal
from .state import FORCE, GAP, SINE, SLIDES, TANGENTIAL
from .tangential import step_tangential

FALLS = 0.6
"""A disk is flat where a step takes as much of its inclination: it would soon pass through the table."""
GOES, FLAT, UPRIGHT, UNSOLVED = range(4)
"""Why a march stopped: not at all, at its last inclination, upright, the equation for N had no solution."""


@kernel
def _march(y, count, law, powers, start, per_unit, spline, table, rim, h, every, last, rows, forces, events):
    flights, slips = events
    flying, sliding, flight, slip = flights[0, 0] == flights[0, 0], slips[0, 0] == slips[0, 0], 0, 0
    locate(y, start, per_unit, spline)
    forces[:] = 0.0
    part = every * len(rows) // len(forces)  # steps over which a force is meant
    for row in range(len(rows)):
        for i in range(every + 1):
            step_tangential(y, law, powers, spline, h / 2 if i in (0, every) else h)
            now = (row * every + i) // part
            for k in range(2):  # a whole step lies half before and half after
                if i > 0:
                    forces[(row * every + i - 1) // part, k] += y[TANGENTIAL + k] / (2 * part)
                if i < every:
                    forces[now, k] += y[TANGENTIAL + k] / (2 * part)
            if (y[SLIDES] > 0) != sliding:
                slips[slip, 1 if sliding else 0] = count * h
                sliding, slip = not sliding, slip + (1 if sliding else 0)
            if i == every:
                break
            before, sine = y[GAP], y[SINE]
            if not step_normal(y, law, start, per_unit, spline, table, rim, h):
                return UNSOLVED, row, flight, slip
            forces[now, 2] += y[FORCE] / part
            flying, flight = note_flight(flights, flight, flying, before, y[GAP], count * h, h)
            count += 1
            if y[SINE] < FALLS * sine:
                return FLAT, row, flight, slip
        rows[row] = y
        if y[SINE] < last or y[8] <= 0:
            return (FLAT if y[SINE] < last else UPRIGHT), row + 1, flight, slip
    return GOES, len(rows), flight, slip


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
    def march(y, count, law, powers, start, per_unit, spline, table, rim, h, every, last, rows, forces, events):
        """Take `every` steps h for each of the `rows` (n, SIZE); return why it stopped, rows filled, events ended.

        `forces` (n p, 3), p to a row, are means of the force on the disk along t, d and of the normal force. `count`
        steps were taken before. `events` are flights (f, 3): begin, end [s] and height [m] of each loss of contact, and
        slips (g, 2): begin and end. One with a begin but no end (NaN) goes on: the first from before, the last after.
        """
        version  # noqa: B018 -- a part of the key under which the machine code is kept
        return _march(y, count, law, powers, start, per_unit, spline, table, rim, h, every, last, rows, forces, events)

    return march


march = _compiled(fingerprint(gap, normal, profile, state, table, tangential))
