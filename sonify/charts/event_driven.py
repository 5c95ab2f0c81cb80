"""Event by event with the regimes of `dynamics`: our own integrators, and scipy's solve_ivp with terminal events."""

from importlib.util import find_spec

import numpy as np
from scipy.integrate import solve_ivp

from dynamics.hybrid import Arc, drive
from dynamics.regime import FLOAT, V2, W1, Branch, R
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator
from sonify.charts.motion_case import Case, answer_of_scaled, scaled
from sonify.charts.naive import BUDGET
from sonify.charts.records import LEFT_OUT, Answer, Failure

SMALLEST = 1e-9
"""sqrt(inclination) at which a motion counts as over, which none of the cases reaches."""
MOST_STEPS = 3000
"""Steps within one regime after which a run is given up; those that succeed need a tenth of it."""


def follow_events(case: Case, integrate, tolerance: float) -> Answer:
    """Solve a case with the flow `integrate` between events."""
    last, steps, lasting = [], 0, 0

    def watch(_, y):
        last[:] = y

    def counted(*arguments):
        nonlocal steps, lasting
        arc = integrate(*arguments)
        steps, lasting = steps + len(arc.times), lasting + len(arc.times)
        if lasting > MOST_STEPS:
            raise Failure(f"never grips again: {lasting} steps within one {arguments[1]}")
        lasting = lasting if arc.guard is None else 0
        return arc

    path, ended = drive(RollingDisk(case.law, None, SMALLEST, counted, tolerance), scaled(case.start), case.span, watch)
    if ended:
        raise Failure(f"ended at tau = {path.t:.4g}: {ended}")
    return answer_of_scaled(last, case.law, steps)


def ours(case: Case, name: str, tolerance: float) -> Answer:
    """Solve a case with the integrator 'taylor' or 'dop853' of `dynamics`."""
    if name == "taylor" and not find_spec("heyoka"):
        raise Failure(f"{LEFT_OUT}: heyoka is not installed")
    return follow_events(case, chosen_integrator(name)[1], tolerance)


def with_solve_ivp(case: Case, method: str, tolerance: float) -> Answer:
    """Solve a case with `method` of scipy.integrate.solve_ivp, whose terminal events are the guards."""
    counter = [0]
    return follow_events(case, integrator_of(method, counter), tolerance)._replace(steps=counter[0])


def integrator_of(method: str, counter=None):
    """Return the flow of `dynamics.hybrid` by solve_ivp; it adds its steps to counter[0]."""
    counter = counter if counter is not None else [0]

    def integrate(y, regime, law, loads, r_end, span, tolerance):
        solution, names = _until_an_event(y, regime, law, r_end, span, method, tolerance)
        counter[0] += len(solution.t) - 1
        fired = [name for name, times in zip(names, solution.t_events, strict=True) if len(times)]
        end = solution.y[:, -1]
        return Arc(solution.t[-1:], end[None, None].copy(), end.tolist(), fired[0] if fired else None)

    return integrate


def _until_an_event(y, regime, law, r_end, span, method, tolerance):
    branch = Branch.of(regime, law, None)
    known, spent = [None, None], [0]

    def guards(y):
        """Return all guards, which solve_ivp asks for one at a time, but solve them once a state."""
        if known[0] is not y:
            values = y.tolist()
            contact = FLOAT.contact(values, branch, regime.senses, law)
            known[:] = y, FLOAT.guards(values, contact, branch, regime.senses, law, r_end)
        return known[1]

    def rates(_, y):
        spent[0] += 1
        if spent[0] > BUDGET:
            raise Failure(f"never grips again: {BUDGET} evaluations within one {regime}")
        y = y.tolist()
        return FLOAT.rates(y, FLOAT.contact(y, branch, regime.senses, law), branch, law)

    def event(name):
        def value(_, y):
            return guards(y)[name]

        value.terminal, value.direction = True, -1
        return value

    y = np.array(y)
    names = tuple(guards(y))
    # half the time of a radian of turning, so that no step hides two roots of a guard
    options = {"rtol": tolerance, "atol": tolerance, "max_step": 0.5 * y[R] / (1e-3 + np.abs(y[W1 : V2 + 1]).max())}
    solution = solve_ivp(rates, (0.0, span), y, method, events=[event(name) for name in names], **options)
    if solution.status < 0:
        raise Failure(f"{method} stopped: {solution.message}")
    return solution, names
