"""Implement the method of the paper (section 6.2) with a prescribed slip speed and a
tolerance.

A slide starts with the slip speed and ends at the tolerance. "At each stage the static
friction criterion is examined"; a slide starts along -F_f; "in the event that the
magnitude of the slip speed becomes lower than a prescribed tolerance, the body is
assumed to be rolling". The moments use sign()."""

import math

import numpy as np
from scipy.integrate import DOP853

from benchmarks.cases.motion_case import Case, answer_of
from benchmarks.methods.sign_friction import (
    ROLLING,
    angular_rates,
    rates,
    sign,
    solve_sign_contact,
)
from benchmarks.timed_runs import Answer, Failure

MAX_EVALUATIONS = 250_000
"""Largest number of evaluations of the right-hand side in a run."""


def slip_tolerance(
    case: Case, start: float, stop: float, longest: float, tolerance: float
) -> Answer:
    """Solve a case with slides that start at the slip speed `start` and end below
    `stop`.

    `longest` is the largest step."""
    tau = 0.0
    state = np.array(case.start)
    sliding = ROLLING
    steps = 0
    slide_duration = 0.0
    evaluations = 0

    def flow(_, y):
        y = y.tolist()
        return rates(y, _forces(y, sliding, case.law))

    while tau < case.span:
        solver = DOP853(
            flow,
            tau,
            state,
            case.span,
            max_step=longest,
            rtol=tolerance,
            atol=tolerance,
        )
        regime_start = tau
        switched = False
        while solver.status == "running" and not switched:
            if solver.step():
                raise Failure(f"step underflow at tau = {solver.t:.4g}")
            steps += 1
            if evaluations + solver.nfev > MAX_EVALUATIONS:
                raise Failure(
                    f"chatters: {MAX_EVALUATIONS} evaluations and only tau = {solver.t:.4g}"
                )
            switched = _has_ended(solver.y, sliding, case.law, stop)
        tau = solver.t
        state = solver.y
        evaluations += solver.nfev
        slide_duration = tau - regime_start if sliding else 0.0
        if switched:
            state = _state_after_switch(state, sliding, case.law, start)
            sliding = not sliding
    if slide_duration > case.span / 4:
        raise Failure(f"stays in sliding from tau = {case.span - slide_duration:.4g}")
    return answer_of(state, case.law, steps)


def _forces(state, sliding, law):
    senses = [sign(rate) for rate in angular_rates(state)]
    speed = math.hypot(state[4], state[5]) if sliding else 0.0
    direction = (state[4] / speed, state[5] / speed) if speed else (0.0, 0.0)
    return solve_sign_contact(state, sliding, direction, senses, law)


def _has_ended(state, sliding, law, stop) -> bool:
    """Return True if the slide has stopped or if rolling would exceed static
    friction."""
    if sliding:
        return math.hypot(state[4], state[5]) < stop
    solved = _forces(state.tolist(), ROLLING, law)
    return math.hypot(solved.F1, solved.F2) > law.mu_static * solved.Phi


def _state_after_switch(state, sliding, law, start):
    state = state.copy()
    if sliding:
        state[4:] = 0.0
        return state
    solved = _forces(state.tolist(), ROLLING, law)
    state[4:] = (
        -start * np.array([solved.F1, solved.F2]) / math.hypot(solved.F1, solved.F2)
    )
    return state
