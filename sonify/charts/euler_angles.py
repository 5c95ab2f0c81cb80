"""The rolling disk in Euler angles as the paper has them: the state is alpha, which loses its digits near pi/2."""

import math

from scipy.integrate import solve_ivp

from sonify.charts.motion_case import Case, answer_of
from sonify.charts.naive import BUDGET, FIRST, ROLLING, contact, rates, sign, turnings
from sonify.charts.records import Answer, Failure


def euler_angles(case: Case, tolerance: float) -> Answer:
    """Solve a case that only rolls with (alpha, omega_1..3) as the state, by solve_ivp's DOP853."""

    spent = 0

    def rate(tau, state):
        nonlocal spent
        spent += 1
        if spent > BUDGET:
            raise Failure(f"creeps: {BUDGET} evaluations and only {100 * tau / case.span:.0f} % of the time")
        rolling = _inclined(state.tolist())
        if not 0 < rolling[0] < math.pi / 2:
            raise Failure("the inclination is lost in the last digits of alpha")
        solved = contact(rolling, ROLLING, (0.0, 0.0), [sign(turning) for turning in turnings(rolling)], case.law)
        falling, *others = rates(rolling, solved)
        return [-falling, *others[:3]]

    start = [math.pi / 2 - case.start[0], *case.start[1:4]]
    options = {"rtol": tolerance, "atol": 1e-3 * tolerance, "first_step": FIRST * case.span}
    solution = solve_ivp(rate, (0.0, case.span), start, "DOP853", **options)
    if solution.status < 0:
        raise Failure(f"step underflow at tau = {solution.t[-1]:.4g}")
    end = _inclined(solution.y[:, -1].tolist())
    if not end[0] > 0:
        raise Failure("the inclination is lost in the last digits of alpha")
    return answer_of(end, case.law, len(solution.t) - 1)


def _inclined(state):
    return [math.pi / 2 - state[0], *state[1:4], 0.0, 0.0]
