"""Implement Moreau's time-stepping: fixed steps without events, with set-valued laws at
the end of each step.

The unknowns of a step are the friction, in units of mu_dynamic Phi, and the moments
s_i, in units of k_i Phi. The friction is a vector in the unit disk and s_i is in [-1,
1]; each opposes its velocity at the end of the step unless that velocity is zero (Jean
1999). They are found by projected iteration, which is compiled."""

import functools
import math

from numba import njit
from numba.extending import register_jitable

from benchmarks.cases.motion_case import Case, answer_of
from benchmarks.timed_runs import Answer, Failure
from dynamics import equations
from dynamics.equations import ContactState, equations_of_motion
from dynamics.kinematics import (
    centre_velocity,
    contact_arms,
    contact_place,
    precession_rate,
)

MAX_PROJECTIONS = 300
"""Largest number of projections in one step."""

PROJECTION_TOLERANCE = 1e-10
"""Largest change of friction and moments, in their units, for which projections count
as converged."""


def moreau(case: Case, step: float) -> Answer:
    """Solve a case by dimensionless time steps of length `step`."""
    count = max(1, round(case.span / step))
    state, unconverged = stepper()(case.start, case.law, case.span / count, count)
    if not 0 < state[0] < math.pi / 2:
        raise Failure("left the table or the model")
    if unconverged > count // 100:
        raise Failure(
            f"the projections did not converge in {unconverged} of {count} steps"
        )
    return answer_of(state, case.law, count)


@njit
def clip(x):
    return min(1.0, max(-1.0, x))


@njit
def projected_friction(c, s, u1, u2, step, law, rolls):
    """Return the friction after a projection; `step` is Phi h."""
    if not law.mu_dynamic > 0:
        return c, s
    push = 0.25 / (law.mu_dynamic * step)
    c = c + push * u1
    s = s + push * u2
    size = math.hypot(c, s)
    limit = law.mu_static / law.mu_dynamic if rolls else 1.0
    if size > limit:
        c /= size
        s /= size
    return c, s


@njit
def projected_moment(moment, inertia, arm, step, rate):
    return clip(moment + 0.25 * inertia / (arm * step) * rate) if arm else 0.0


@njit
def projected(forces, new, step, law, rolls):
    """Return friction and moments after a projection with the velocities at the end
    of the step; `step` is Phi h."""
    beta, w1, w2, w3, u1, u2 = new
    c, s = projected_friction(forces[0], forces[1], u1, u2, step, law, rolls)
    inertia = law.K / 4 + law.h**2 / 3
    turn2 = w2 * math.sin(beta) - w3 * math.cos(beta)
    turn3 = w2 * math.cos(beta) + w3 * math.sin(beta)
    return (
        c,
        s,
        projected_moment(forces[2], inertia, law.k1, step, w1),
        projected_moment(forces[3], inertia, law.k2, step, turn2),
        projected_moment(forces[4], inertia, law.k3, step, turn3),
    )


@njit
def largest_change(before, after):
    return max(
        abs(after[0] - before[0]),
        abs(after[1] - before[1]),
        abs(after[2] - before[2]),
        abs(after[3] - before[3]),
        abs(after[4] - before[4]),
    )


@functools.cache
def stepper():
    """Return the time-stepping function, compiled once per process."""
    # `solve` calls them
    for function in (
        contact_arms,
        contact_place,
        centre_velocity,
        precession_rate,
        equations.disk_motion,
        equations.solve_nutation,
        equations.slip_drift,
        equations.rotation_balance,
        equations.solve_rotation,
    ):
        register_jitable(function)
    solve = njit(equations_of_motion(math.sin, math.cos))

    @njit
    def end(state, middle, h, forces, law):
        """Return the velocities at the end of a step and the normal force from
        accelerations at mid-step."""
        beta, w1, w2, w3, u1, u2 = middle
        c, s, s1, s2, s3 = forces
        contact = ContactState(True, (c, s), (False, False, False), (s1, s2, s3))
        a = solve(beta, (w1, w2, w3), (u1, u2), contact, law)
        return (
            state[1] + h * a.domega1,
            state[2] + h * a.domega2,
            state[3] + h * a.domega3,
            state[4] + h * a.du1,
            state[5] + h * a.du2,
            a.Phi,
        )

    @njit
    def run(state, law, h, count):
        forces = (0.0, 0.0, 0.0, 0.0, 0.0)
        rolls = True
        unconverged = 0
        for _ in range(count):
            new = state
            for _projection in range(MAX_PROJECTIONS):
                middle = (
                    state[0] - h / 4 * (state[1] + new[1]),
                    (state[1] + new[1]) / 2,
                    (state[2] + new[2]) / 2,
                    (state[3] + new[3]) / 2,
                    (state[4] + new[4]) / 2,
                    (state[5] + new[5]) / 2,
                )
                w1, w2, w3, u1, u2, Phi = end(state, middle, h, forces, law)
                new = (state[0] - h / 2 * (state[1] + w1), w1, w2, w3, u1, u2)
                before = forces
                forces = projected(forces, new, Phi * h, law, rolls)
                if largest_change(before, forces) < PROJECTION_TOLERANCE:
                    break
            else:
                unconverged += 1
            rolls = math.hypot(new[4], new[5]) < 1e-6 * h
            state = new
        return state, unconverged

    return run
