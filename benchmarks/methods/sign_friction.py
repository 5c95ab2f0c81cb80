"""Model friction by a plain sign(): the right-hand side jumps at every change of sign,
without events.

Below the slip speed ROLLING_SLIP_SPEED the contact rolls if the friction cone admits
the rolling force; otherwise it slides against that force. The module also contains
functions shared by all methods without events: the rates of a state, and an integration
that stops after MAX_EVALUATIONS. `euler_angles` uses the paper's Euler angles as the
state; the angle alpha loses precision near pi/2."""

import math
import warnings

from scipy.integrate import solve_ivp

from benchmarks.cases.motion_case import Case, answer_of
from benchmarks.timed_runs import Answer, Failure
from dynamics.equations import ContactState, DiskConstants
from dynamics.regime import FLOAT_FORMULAS, contact_axis_rates

ROLLING = False
SLIDING = True
NOTHING_STICKS = (False, False, False)

ROLLING_SLIP_SPEED = 1e-6
"""Slip speed, in units of R/chi, below which the contact counts as rolling."""

MAX_EVALUATIONS = 60_000
"""Largest number of evaluations of the right-hand side; event-driven runs require a
tenth of it."""

FIRST_STEP_FRACTION = 1e-4
"""Ratio of the first step to the time span; with the step chosen by an integrator the
disk may leave the table."""


def sign(x: float) -> float:
    """Return the sign of x, with sign(0) = 0."""
    return (x > 0) - (x < 0)


def angular_rates(state) -> tuple[float, float, float]:
    """Return omega.a_1, omega.a_2, omega.a_3 of a state."""
    return contact_axis_rates(*state[:4], math.sin, math.cos)


def solve_sign_contact(state, sliding: bool, direction, senses, law: DiskConstants):
    """Solve the balance laws (4.1), (4.2) for given slip direction and senses of the
    moments; nothing sticks."""
    beta, *velocities = state
    contact = ContactState(sliding, direction, NOTHING_STICKS, senses)
    return FLOAT_FORMULAS.solve(beta, velocities[:3], velocities[3:], contact, law)


def rates(state, solved) -> list[float]:
    """Return the rates of (inclination, omega_1..3, slip_1, slip_2)."""
    return [
        -state[1],
        solved.domega1,
        solved.domega2,
        solved.domega3,
        solved.du1,
        solved.du2,
    ]


def contact_by_sign(state, law: DiskConstants):
    """Solve the contact with sign() of the velocities of the state."""
    senses = [sign(rate) for rate in angular_rates(state)]
    speed = math.hypot(state[4], state[5])
    if speed > ROLLING_SLIP_SPEED:
        return solve_sign_contact(
            state, SLIDING, (state[4] / speed, state[5] / speed), senses, law
        )
    rolling = solve_sign_contact(state, ROLLING, (0.0, 0.0), senses, law)
    demand = math.hypot(rolling.F1, rolling.F2)
    if demand <= law.mu_static * rolling.Phi:
        return rolling
    return solve_sign_contact(
        state, SLIDING, (-rolling.F1 / demand, -rolling.F2 / demand), senses, law
    )


def integrate(rhs, case: Case, method: str, tolerance: float, first=None) -> Answer:
    """Integrate `rhs(state)` over the time span of a case by solve_ivp, optionally with
    a given first step.

    Raises Failure if the integrator stops or exceeds MAX_EVALUATIONS.
    """
    evaluations = 0
    reached = 0.0

    def counted_rhs(tau, state):
        nonlocal evaluations, reached
        evaluations += 1
        reached = max(reached, tau)
        if evaluations > MAX_EVALUATIONS:
            raise Failure(
                f"chatters: {MAX_EVALUATIONS} evaluations and only tau = {reached:.4g}"
            )
        if not 0 < state[0] < math.pi / 2:
            raise Failure(f"left the table or the model at tau = {tau:.4g}")
        return rhs(state.tolist())

    options = {"rtol": tolerance, "atol": tolerance, "first_step": first}
    with warnings.catch_warnings(
        action="ignore"
    ):  # the status of LSODA repeats its warnings
        solution = solve_ivp(
            counted_rhs, (0.0, case.span), case.start, method, **options
        )
    if solution.status < 0:
        raise Failure(f"step underflow at tau = {solution.t[-1]:.4g}")
    return answer_of(solution.y[:, -1], case.law, len(solution.t) - 1)


def naive_sign(case: Case, method: str, tolerance: float) -> Answer:
    """Solve a case with sign() in the right-hand side."""
    first = FIRST_STEP_FRACTION * case.span
    return integrate(
        lambda state: rates(state, contact_by_sign(state, case.law)),
        case,
        method,
        tolerance,
        first=first,
    )


def euler_angles(case: Case, tolerance: float) -> Answer:
    """Solve a case of pure rolling with the state (alpha, omega_1..3), by solve_ivp's
    DOP853."""
    evaluations = 0

    def rate(tau, state):
        nonlocal evaluations
        evaluations += 1
        if evaluations > MAX_EVALUATIONS:
            raise Failure(
                f"creeps: {MAX_EVALUATIONS} evaluations and only {100 * tau / case.span:.0f} % of "
                f"the time"
            )
        rolling = _inclined(state.tolist())
        if not 0 < rolling[0] < math.pi / 2:
            raise Failure("the inclination is lost in the last digits of alpha")
        senses = [sign(angular_rate) for angular_rate in angular_rates(rolling)]
        solved = solve_sign_contact(rolling, ROLLING, (0.0, 0.0), senses, case.law)
        falling, *others = rates(rolling, solved)
        return [-falling, *others[:3]]

    start = [math.pi / 2 - case.start[0], *case.start[1:4]]
    options = {
        "rtol": tolerance,
        "atol": 1e-3 * tolerance,
        "first_step": FIRST_STEP_FRACTION * case.span,
    }
    solution = solve_ivp(rate, (0.0, case.span), start, "DOP853", **options)
    if solution.status < 0:
        raise Failure(f"step underflow at tau = {solution.t[-1]:.4g}")
    end = _inclined(solution.y[:, -1].tolist())
    if not end[0] > 0:
        raise Failure("the inclination is lost in the last digits of alpha")
    return answer_of(end, case.law, len(solution.t) - 1)


def _inclined(state):
    """Convert a state with alpha to one with inclination and zero slip."""
    return [math.pi / 2 - state[0], *state[1:4], 0.0, 0.0]
