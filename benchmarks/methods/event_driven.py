"""Solve cases event by event with the regimes of `dynamics`, by our integrators and by
scipy's solve_ivp."""

from importlib.util import find_spec

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.cases.motion_case import Case, answer_of_scaled, scaled
from benchmarks.methods.sign_friction import MAX_EVALUATIONS
from benchmarks.timed_runs import LEFT_OUT, Answer, Failure
from dynamics.hybrid import Arc, run_events
from dynamics.regime import FLOAT_FORMULAS, V2, W1, Branch, R
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator

FINAL_SQRT_INCLINATION = 1e-9
"""Value of sqrt(inclination) at which a motion ends; no case reaches it."""

MAX_STEPS_PER_REGIME = 3000
"""Largest number of steps within one regime; successful runs require a tenth of it."""


def follow_events(case: Case, integrate, tolerance: float) -> Answer:
    """Solve a case; `integrate` solves each regime up to its event."""
    last_state = []
    steps = 0
    regime_steps = 0

    def keep_state(_, y):
        last_state[:] = y

    def integrate_and_count(*arguments):
        nonlocal steps, regime_steps
        arc = integrate(*arguments)
        steps += len(arc.times)
        regime_steps += len(arc.times)
        if regime_steps > MAX_STEPS_PER_REGIME:
            raise Failure(
                f"never grips again: {regime_steps} steps within one {arguments[1]}"
            )
        if arc.guard is not None:
            regime_steps = 0
        return arc

    system = RollingDisk(
        case.law, None, FINAL_SQRT_INCLINATION, integrate_and_count, tolerance
    )
    path, ended = run_events(system, scaled(case.start), case.span, keep_state)
    if ended:
        raise Failure(f"ended at tau = {path.t:.4g}: {ended}")
    return answer_of_scaled(last_state, case.law, steps)


def ours(case: Case, name: str, tolerance: float) -> Answer:
    """Solve a case with the integrator 'taylor' or 'dop853' of `dynamics`."""
    if name == "taylor" and not find_spec("heyoka"):
        raise Failure(f"{LEFT_OUT}: heyoka is not installed")
    return follow_events(case, chosen_integrator(name)[1], tolerance)


def with_solve_ivp(case: Case, method: str, tolerance: float) -> Answer:
    """Solve a case with a method of scipy.integrate.solve_ivp; its terminal events are
    the guards."""
    counter = [0]
    return follow_events(
        case, resolved_integrator_name(method, counter), tolerance
    )._replace(steps=counter[0])


def resolved_integrator_name(method: str, counter=None):
    """Return a flow for `dynamics.hybrid` that uses solve_ivp and adds its steps to
    counter[0]."""
    counter = counter if counter is not None else [0]

    def integrate(y, regime, law, loads, r_end, span, tolerance):
        solution, names = _solve_until_event(
            y, regime, law, r_end, span, method, tolerance
        )
        counter[0] += len(solution.t) - 1
        fired = [
            name
            for name, times in zip(names, solution.t_events, strict=True)
            if len(times)
        ]
        end = solution.y[:, -1]
        return Arc(
            solution.t[-1:],
            end[None, None].copy(),
            end.tolist(),
            fired[0] if fired else None,
        )

    return integrate


def _solve_until_event(y, regime, law, r_end, span, method, tolerance):
    branch = Branch.of(regime, law, None)
    last_state = None
    last_guards = None
    evaluations = 0

    def guards(y):
        """Return all guards, evaluated once per state although solve_ivp evaluates each
        event separately."""
        nonlocal last_state, last_guards
        if last_state is not y:
            values = y.tolist()
            contact = FLOAT_FORMULAS.contact(values, branch, regime.senses, law)
            last_state = y
            last_guards = FLOAT_FORMULAS.guards(
                values, contact, branch, regime.senses, law, r_end
            )
        return last_guards

    def rates(_, y):
        nonlocal evaluations
        evaluations += 1
        if evaluations > MAX_EVALUATIONS:
            raise Failure(
                f"never grips again: {MAX_EVALUATIONS} evaluations within one {regime}"
            )
        y = y.tolist()
        return FLOAT_FORMULAS.rates(
            y, FLOAT_FORMULAS.contact(y, branch, regime.senses, law), branch, law
        )

    def event(name):
        def value(_, y):
            return guards(y)[name]

        value.terminal = True
        value.direction = -1
        return value

    y = np.array(y)
    names = tuple(guards(y))
    # at most half the time of one radian of rotation, so that no step contains two roots of a guard
    options = {
        "rtol": tolerance,
        "atol": tolerance,
        "max_step": 0.5 * y[R] / (1e-3 + np.abs(y[W1 : V2 + 1]).max()),
    }
    solution = solve_ivp(
        rates, (0.0, span), y, method, events=[event(name) for name in names], **options
    )
    if solution.status < 0:
        raise Failure(f"{method} stopped: {solution.message}")
    return solution, names
