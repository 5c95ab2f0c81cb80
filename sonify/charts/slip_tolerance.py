"""The paper's own recipe, section 6.2: a prescribed speed to start a slide with, a tolerance to end it.

"At each stage the static friction criterion is examined"; a slide starts along -F_f; "in the event that the magnitude
of the slip speed becomes lower than a prescribed tolerance, the body is assumed to be rolling". sign() is naive.
"""

import math

import numpy as np
from scipy.integrate import DOP853

from sonify.charts.motion_case import Case, answer_of
from sonify.charts.naive import ROLLING, contact, rates, sign, turnings
from sonify.charts.records import Answer, Failure

MOST_EVALUATIONS = 250_000
"""Evaluations of the right-hand side after which a run is given up."""


def slip_tolerance(case: Case, start: float, stop: float, longest: float, tolerance: float) -> Answer:
    """Solve a case with slides started at the speed `start` and ended below `stop`, in steps of at most `longest`."""
    tau, state, sliding, steps, slid, spent = 0.0, np.array(case.start), ROLLING, 0, 0.0, 0

    def flow(_, y):
        y = y.tolist()
        return rates(y, _forces(y, sliding, case.law))

    while tau < case.span:
        solver = DOP853(flow, tau, state, case.span, max_step=longest, rtol=tolerance, atol=tolerance)
        began, switched = tau, False
        while solver.status == "running" and not switched:
            if solver.step():
                raise Failure(f"step underflow at tau = {solver.t:.4g}")
            steps += 1
            if spent + solver.nfev > MOST_EVALUATIONS:
                raise Failure(f"chatters: {MOST_EVALUATIONS} evaluations and only tau = {solver.t:.4g}")
            switched = _is_over(solver.y, sliding, case.law, stop)
        tau, state, spent = solver.t, solver.y, spent + solver.nfev
        slid = tau - began if sliding else 0.0
        if switched:
            state, sliding = _switched(state, sliding, case.law, start), not sliding
    if slid > case.span / 4:
        raise Failure(f"stays in sliding from tau = {case.span - slid:.4g}")
    return answer_of(state, case.law, steps)


def _forces(state, sliding, law):
    senses = [sign(turning) for turning in turnings(state)]
    speed = math.hypot(state[4], state[5]) if sliding else 0.0
    direction = (state[4] / speed, state[5] / speed) if speed else (0.0, 0.0)
    return contact(state, sliding, direction, senses, law)


def _is_over(state, sliding, law, stop) -> bool:
    if sliding:
        return math.hypot(state[4], state[5]) < stop
    solved = _forces(state.tolist(), ROLLING, law)
    return math.hypot(solved.F1, solved.F2) > law.mu_static * solved.Phi


def _switched(state, sliding, law, start):
    state = state.copy()
    if sliding:
        state[4:] = 0.0
        return state
    solved = _forces(state.tolist(), ROLLING, law)
    state[4:] = -start * np.array([solved.F1, solved.F2]) / math.hypot(solved.F1, solved.F2)
    return state
