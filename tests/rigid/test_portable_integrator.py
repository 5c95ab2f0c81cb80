"""Claim: the compiled portable integrator evaluates the given formulas, takes DOP853 steps and
locates events.

Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, sections II.5, II.6.
Oracle: the same formulas in 30 digits; SciPy's DOP853 and its dense output; the order of the
method. The formulas themselves give the bounds on rounding errors (arithmetic.py).
"""

import arithmetic
import numpy as np
import pytest
from arithmetic import UNIT, Rounded, errors, gamma, rounded
from mpmath import mp
from numba.types import FunctionType
from numba.types import void as VOID
from scipy.integrate import DOP853
from scipy.optimize import brentq

from dynamics.dissipation import Resistance
from dynamics.equations import DiskConstants
from dynamics.integrators.branch_formulas import branch_to_compile, flow_constants
from dynamics.integrators.codegen import (
    ARRAY_TYPE,
    FLOW_SIGNATURE,
    compile_branch,
    compiled_function,
)
from dynamics.integrators.runge_kutta import (
    DENSE_OUTPUT,
    INTEGRATE_SIGNATURE,
    STAGE_WEIGHTS,
    evaluate_polynomial,
    integrate_dop853,
)
from dynamics.regime import FLOAT_FORMULAS, Branch, FlowFormulas, Regime

LAW = DiskConstants(0.17, 1.0, 0.5, 0.3, 1e-4, 8e-4, 8e-3)
STATE = np.array([0.7, 0.1, 0.2, -1.2, 0.3, -0.2, 0.4, 0.5, 0.0, 0.0, 0.0])
LOADS = [None, Resistance(((1e-3, 0.25), (1e-3, 1.0)), 1e-3, 2e-3, False)]
SENSES, END = (1.0, -1.0, 1.0), 1e-5
EXACT = {"flow": FlowFormulas(mp.sin, mp.cos, mp.sqrt, mp.power), "number": mp.mpf}
BOUNDED = {
    "flow": FlowFormulas(
        arithmetic.sin, arithmetic.cos, arithmetic.sqrt, Rounded.__pow__
    ),
    "number": rounded,
}


def flow_of(sliding, stuck=(False,) * 3, loads=None):
    """Return a compiled flow, the names of its guards, and its constants."""
    regime = Regime(sliding, stuck, SENSES)
    return *compile_branch(branch_to_compile(regime, LAW, loads)), np.array(
        flow_constants(regime, LAW, loads, END)
    )


def by_formula(
    y, sliding, stuck=(False,) * 3, loads=None, flow=FLOAT_FORMULAS, number=float
):
    """Return rates (11,) and guards by name at y (11,), for a number type and its flow."""
    y = [number(x) for x in y]
    law = DiskConstants(*map(number, LAW[:-1]), LAW.pivoting)
    senses = [number(sense) for sense in SENSES]
    branch = Branch.of(Regime(sliding, stuck, SENSES), LAW, loads)
    contact = flow.contact(y, branch, senses, law)
    return np.array(flow.rates(y, contact, branch, law)), flow.guards(
        y, contact, branch, senses, law, number(END)
    )


def bounded_step(y, h, sliding):
    """Return the end (k,) of a step and its Taylor coefficients (8, k), in bounded arithmetic.

    The interval of the coefficients is [0, 1].
    """
    states = [rounded(y)]
    rates = np.empty((16, len(y)), dtype=object)
    for i in range(16):
        rates[i] = by_formula(states[i], sliding, **BOUNDED)[0]
        states.append(
            states[0] + h * (STAGE_WEIGHTS[min(i + 1, 15), : i + 1] @ rates[: i + 1])
        )
    c = h * (DENSE_OUTPUT @ rates)
    c[0] = states[0]
    return states[12], c


def ask(flow, y, numbers, rates, guards):
    """Call a flow from machine code, as Python cannot call it directly."""
    flow(y, numbers, rates, guards)


def by_code(y, *case):
    flow, names, numbers = flow_of(*case)
    rates = np.empty(11)
    guards = np.empty(16)
    compiled_function(ask, VOID(FunctionType(FLOW_SIGNATURE), *[ARRAY_TYPE] * 4))(
        flow, y, numbers, rates, guards
    )
    return rates, dict(zip(names, guards, strict=False))


@pytest.mark.slow
@pytest.mark.parametrize("loads", LOADS, ids=["no loads", "loads"])
@pytest.mark.parametrize(
    "stuck", [(False,) * 3, (True, False, False), (False, True, True)], ids=str
)
def test_rates_and_guards_are_those_of_the_formulas(stuck, loads):
    for sliding in (False, True):
        case = sliding, stuck, loads
        with mp.workdps(30):
            exact, guards = by_formula(STATE, *case, **EXACT)
        bounds, guard_bounds = by_formula(STATE, *case, **BOUNDED)
        for rates, named in (by_code(STATE, *case), by_formula(STATE, *case)):
            assert (np.abs(rates - exact) <= errors(bounds)).all()
            assert named.keys() == guards.keys()
            for name, guard in guards.items():
                assert abs(named[name] - guard) <= guard_bounds[name].error
        assert errors(bounds).max() < 100 * UNIT * max(abs(rate) for rate in exact)


def test_a_step_and_its_dense_output_are_those_of_scipy():
    flow, _, numbers = flow_of(sliding=True)
    times, c, end, fired = compiled_function(integrate_dop853, INTEGRATE_SIGNATURE)(
        flow, STATE, numbers, 0, 0.1, 1.0
    )
    assert (times.tolist(), fired) == ([0.1], -1)
    scipys = DOP853(
        lambda _, y: by_formula(y, True)[0],
        0.0,
        STATE,
        0.1,
        rtol=1.0,
        atol=1.0,
        first_step=0.1,
    )
    scipys.step()
    curve = scipys.dense_output()
    y = np.empty(11)
    (bounded_end, bounded) = bounded_step(STATE, 0.1, sliding=True)
    assert (np.abs(end - scipys.y) <= 2 * errors(bounded_end)).all()
    for t in np.linspace(0, 0.1, 9):
        evaluate_polynomial(c[0], t, y)
        bar = 2 * errors(np.polynomial.polynomial.polyval(t / 0.1, bounded))
        assert (np.abs(y - curve(t)) <= bar).all()
        assert bar.max() < 1e-8, (
            "powers of x cancel, but what rounding does is far below what a wrong weight does"
        )


def test_the_error_falls_with_the_eighth_power_of_the_step():
    (flow, _, numbers) = flow_of(sliding=False)
    span = 1.0

    def end(steps):
        y = STATE
        for _ in range(steps):
            y = compiled_function(integrate_dop853, INTEGRATE_SIGNATURE)(
                flow, y, numbers, 0, span / steps, 1.0
            )[2]
        return y

    exact = end(64)  # more steps would add more rounding than they remove error
    steps = [12, 14, 16, 18]
    errors = [np.abs(end(n) - exact).max() for n in steps]
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(-8, abs=0.1)


def test_it_stops_where_a_guard_falls_through_zero():
    """The nutation reverses: its guard is omega_1, which is zero where the integration stops."""
    flow, names, numbers = flow_of(sliding=False)
    times, coefficients, end, fired = compiled_function(
        integrate_dop853, INTEGRATE_SIGNATURE
    )(flow, STATE, numbers, len(names), 10.0, 1e-13)
    assert names[fired] == "nutation reverses"
    assert abs(end[1]) <= gamma(20) * np.abs(coefficients[-1][:, 1]).max()
    free = compiled_function(integrate_dop853, INTEGRATE_SIGNATURE)(
        flow, STATE, numbers, 0, 10.0, 1e-13
    )
    piece = np.searchsorted(free[0], times[-1])
    start = free[0][piece - 1]
    y = np.empty(11)

    def swing(t):
        evaluate_polynomial(free[1][piece], t - start, y)
        return y[1]

    assert times[-1] == pytest.approx(
        brentq(swing, start, free[0][piece], xtol=1e-15), abs=1e-12
    )
