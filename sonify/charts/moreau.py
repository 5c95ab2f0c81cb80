"""Moreau's time-stepping: fixed steps, no events; the set-valued laws hold for the velocities at the end of each step.

In one step the friction, as a share p of mu_dynamic Phi, and the moments, as shares s_i of k_i Phi, are sought such
that the end velocities satisfy p in the disk, s_i in [-1, 1], each in the direction of its velocity unless that is
zero (Jean 1999). They are found by projection; compiled, since there are many steps.
"""

import functools
import math

from numba import njit
from numba.extending import register_jitable

from dynamics.equations import balance
from dynamics.kinematics import arms, centre_velocity, precession_rate
from sonify.charts.motion_case import Case, answer_of
from sonify.charts.records import Answer, Failure

ITERATIONS, ACCURACY = 300, 1e-10
"""Most projections in a step, and the change of a share at which they stop."""


def moreau(case: Case, step: float) -> Answer:
    """Solve a case by time steps of `step`."""
    count = max(1, round(case.span / step))
    state, unconverged = stepper()(case.start, case.law, case.span / count, count)
    if not 0 < state[0] < math.pi / 2:
        raise Failure("left the table or the model")
    if unconverged > count // 100:
        raise Failure(f"the projections did not converge in {unconverged} of {count} steps")
    return answer_of(state, case.law, count)


@functools.cache
def stepper():
    """Compile the time-stepping once a process."""
    for function in (arms, centre_velocity, precession_rate):  # which `solve` calls
        register_jitable(function)
    solve = njit(balance(math.sin, math.cos))

    @njit
    def clip(x):
        return min(1.0, max(-1.0, x))

    @njit
    def end(state, middle, h, c, s, s1, s2, s3, law):
        """Return the velocities at the end of a step of accelerations taken at its middle."""
        beta, w1, w2, w3, u1, u2 = middle
        a = solve(beta, w1, w2, w3, u1, u2, c, s, True, False, False, False, s1, s2, s3, law)
        w1, w2, w3 = state[1] + h * a.domega1, state[2] + h * a.domega2, state[3] + h * a.domega3
        return w1, w2, w3, state[4] + h * a.du1, state[5] + h * a.du2, a.Phi

    @njit
    def run(state, law, h, count):
        c, s, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0, 0.0
        rolls, unconverged = True, 0
        inertia = law.K / 4 + law.h**2 / 3
        for _ in range(count):
            new = state
            for _n in range(ITERATIONS):
                middle = (
                    state[0] - h / 4 * (state[1] + new[1]),
                    (state[1] + new[1]) / 2,
                    (state[2] + new[2]) / 2,
                    (state[3] + new[3]) / 2,
                    (state[4] + new[4]) / 2,
                    (state[5] + new[5]) / 2,
                )
                w1, w2, w3, u1, u2, Phi = end(state, middle, h, c, s, s1, s2, s3, law)
                beta = state[0] - h / 2 * (state[1] + w1)
                new = (beta, w1, w2, w3, u1, u2)
                if law.mu_dynamic > 0:
                    push = 0.25 / (law.mu_dynamic * Phi * h)
                    C, S = c + push * u1, s + push * u2
                    size, most = math.hypot(C, S), law.mu_static / law.mu_dynamic
                    if size > (most if rolls else 1.0):
                        C, S = C / size, S / size
                else:
                    C, S = c, s
                turn2, turn3 = w2 * math.sin(beta) - w3 * math.cos(beta), w2 * math.cos(beta) + w3 * math.sin(beta)
                S1 = clip(s1 + 0.25 * inertia / (law.k1 * Phi * h) * w1) if law.k1 else 0.0
                S2 = clip(s2 + 0.25 * inertia / (law.k2 * Phi * h) * turn2) if law.k2 else 0.0
                S3 = clip(s3 + 0.25 * inertia / (law.k3 * Phi * h) * turn3) if law.k3 else 0.0
                change = max(abs(C - c), abs(S - s), abs(S1 - s1), abs(S2 - s2), abs(S3 - s3))
                c, s, s1, s2, s3 = C, S, S1, S2, S3
                if change < ACCURACY:
                    break
            else:
                unconverged += 1
            rolls = math.hypot(new[4], new[5]) < 1e-6 * h
            state = new
        return state, unconverged

    return run
