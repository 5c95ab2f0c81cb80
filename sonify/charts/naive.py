"""Naive sign(): the right-hand side jumps wherever a velocity changes sign, and the integrator is not told.

Below a slip speed TOLERANCE the contact rolls while the cone allows it, and is pushed along -F_f where it does not.
Here is also what all methods without events need: the equations of a state, and an integration that may be given up;
and the paper's Euler angles as a state, whose alpha loses its digits near pi/2.
"""

import math
import warnings

from scipy.integrate import solve_ivp

from dynamics.equations import Law, solve
from dynamics.regime import projections
from sonify.charts.motion_case import Case, answer_of
from sonify.charts.records import Answer, Failure

ROLLING, SLIDING = False, True
FREE = (False, False, False)
TOLERANCE = 1e-6
"""Slip speed, over R/chi, below which the contact is taken to roll."""
BUDGET = 60_000
"""Evaluations of the right-hand side after which a run is given up; the event-driven runs need a tenth of it."""
FIRST = 1e-4
"""First step over the span: what an integrator tries by itself may leap off the table."""


def sign(x: float) -> float:
    """Return the naive sign, for which sign(0) = 0."""
    return (x > 0) - (x < 0)


def turnings(state) -> tuple[float, float, float]:
    """Return omega.a_1, omega.a_2, omega.a_3 of a state."""
    return projections(*state[:4], math.sin, math.cos)


def contact(state, sliding: bool, direction, senses, law: Law):
    """Solve the balance laws (4.1), (4.2) with slip `direction` and the senses of the moments given, none sticking."""
    return solve(*state, *direction, sliding, *FREE, *senses, law)


def rates(state, solved) -> list[float]:
    """Return the rates of (inclination, omega_1..3, slip_1, slip_2)."""
    return [-state[1], solved.domega1, solved.domega2, solved.domega3, solved.du1, solved.du2]


def forces(state, law: Law):
    """Solve the contact as the naive right-hand side sees it."""
    senses = [sign(turning) for turning in turnings(state)]
    speed = math.hypot(state[4], state[5])
    if speed > TOLERANCE:
        return contact(state, SLIDING, (state[4] / speed, state[5] / speed), senses, law)
    rolling = contact(state, ROLLING, (0.0, 0.0), senses, law)
    demand = math.hypot(rolling.F1, rolling.F2)
    if demand <= law.mu_static * rolling.Phi:
        return rolling
    return contact(state, SLIDING, (-rolling.F1 / demand, -rolling.F2 / demand), senses, law)


def integrate(rhs, case: Case, method: str, tolerance: float, first=None) -> Answer:
    """Integrate `rhs(state)` over a case by solve_ivp, whose first step may be given.

    Raises Failure where it stops, or takes more than BUDGET evaluations.
    """
    spent, reached = 0, 0.0

    def counted(tau, state):
        nonlocal spent, reached
        spent, reached = spent + 1, max(reached, tau)
        if spent > BUDGET:
            raise Failure(f"chatters: {BUDGET} evaluations and only tau = {reached:.4g}")
        if not 0 < state[0] < math.pi / 2:
            raise Failure(f"left the table or the model at tau = {tau:.4g}")
        return rhs(state.tolist())

    options = {"rtol": tolerance, "atol": tolerance, "first_step": first}
    with warnings.catch_warnings(action="ignore"):  # what LSODA warns of ends in its status
        solution = solve_ivp(counted, (0.0, case.span), case.start, method, **options)
    if solution.status < 0:
        raise Failure(f"step underflow at tau = {solution.t[-1]:.4g}")
    return answer_of(solution.y[:, -1], case.law, len(solution.t) - 1)


def naive_sign(case: Case, method: str, tolerance: float) -> Answer:
    """Solve a case with sign() taken at its word."""
    first = FIRST * case.span
    return integrate(lambda state: rates(state, forces(state, case.law)), case, method, tolerance, first=first)


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
