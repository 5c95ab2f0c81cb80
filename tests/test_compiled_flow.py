"""Claim: the machine code of the portable integrator computes what the formulas say, in steps of DOP853, to its events.

Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, sections II.5, II.6.
Oracle: the same formulas on Python floats; scipy's DOP853 and its dense output; the order of the method.
"""

import numpy as np
import pytest
from scipy.integrate import DOP853
from scipy.optimize import brentq

from dynamics.dissipation import Resistance
from dynamics.equations import Law
from dynamics.regime import FLOAT, Branch, Regime
from dynamics.runge_kutta import at, integrate
from dynamics.symbolic import constants, shape
from dynamics.trace import compiled

LAW = Law(0.17, 1.0, 0.5, 0.3, 1e-4, 8e-4, 8e-3)
STATE = np.array([0.7, 0.1, 0.2, -1.2, 0.3, -0.2, 0.4, 0.5, 0.0, 0.0, 0.0])
LOADS = [None, Resistance(((1e-3, 0.25), (1e-3, 1.0)), 1e-3, 2e-3, False)]
SENSES, END = (1.0, -1.0, 1.0), 1e-5


def flow_of(sliding, stuck=(False,) * 3, loads=None):
    """Return a compiled flow, the names of its guards, and its constants."""
    regime = Regime(sliding, stuck, SENSES)
    return *compiled(shape(regime, LAW, loads)), np.array(constants(regime, LAW, loads, END))


def by_formula(y, sliding, stuck=(False,) * 3, loads=None):
    branch = Branch.of(Regime(sliding, stuck, SENSES), LAW, loads)
    contact = FLOAT.contact(y.tolist(), branch, SENSES, LAW)
    rates = FLOAT.rates(y.tolist(), contact, branch, LAW)
    return np.array(rates), FLOAT.guards(y.tolist(), contact, branch, SENSES, LAW, END)


def by_code(y, *case):
    flow, names, numbers = flow_of(*case)
    rates, guards = np.empty(11), np.empty(16)
    flow(y, numbers, rates, guards)
    return rates, dict(zip(names, guards, strict=False))


@pytest.mark.parametrize("loads", LOADS, ids=["no loads", "loads"])
@pytest.mark.parametrize("stuck", [(False,) * 3, (True, False, False), (False, True, True)], ids=str)
def test_rates_and_guards_are_those_of_the_formulas(stuck, loads):
    for sliding in (False, True):
        rates, guards = by_formula(STATE, sliding, stuck, loads)
        found, named = by_code(STATE, sliding, stuck, loads)
        np.testing.assert_allclose(found, rates, rtol=1e-13, atol=1e-14)
        assert named == pytest.approx(guards, rel=1e-12, abs=1e-14)


def test_a_step_and_its_dense_output_are_those_of_scipy():
    flow, _, numbers = flow_of(sliding=True)
    times, c, end, fired = integrate(flow, STATE, numbers, 0, 0.1, 1.0)
    assert (times.tolist(), fired) == ([0.1], -1)
    scipys = DOP853(lambda _, y: by_formula(y, True)[0], 0.0, STATE, 0.1, rtol=1.0, atol=1.0, first_step=0.1)
    scipys.step()
    curve, y = scipys.dense_output(), np.empty(11)
    np.testing.assert_allclose(end, scipys.y, rtol=1e-14, atol=1e-15)
    for t in np.linspace(0, 0.1, 9):
        at(c[0], t, y)
        np.testing.assert_allclose(y, curve(t), rtol=1e-13, atol=1e-14)


def test_the_error_falls_with_the_eighth_power_of_the_step():
    flow, _, numbers = flow_of(sliding=False)

    def end(steps):
        y = STATE
        for _ in range(steps):
            y = integrate(flow, y, numbers, 0, 0.64 / steps, 1.0)[2]
        return y

    exact = end(128)
    errors = [np.abs(end(n) - exact).max() for n in (6, 9, 12)]
    assert np.polyfit(np.log([6, 9, 12]), np.log(errors), 1)[0] == pytest.approx(-8, abs=0.6)


def test_it_stops_where_a_guard_falls_through_zero():
    """The nutation reverses: omega_1 is a guard, and zero where the integration stops."""
    flow, names, numbers = flow_of(sliding=False)
    times, _, end, fired = integrate(flow, STATE, numbers, len(names), 10.0, 1e-13)
    assert names[fired] == "nutation reverses"
    assert end[1] == pytest.approx(0, abs=1e-15)
    free = integrate(flow, STATE, numbers, 0, 10.0, 1e-13)
    piece = np.searchsorted(free[0], times[-1])
    start, y = free[0][piece - 1], np.empty(11)

    def swing(t):
        at(free[1][piece], t - start, y)
        return y[1]

    assert times[-1] == pytest.approx(brentq(swing, start, free[0][piece], xtol=1e-15), abs=1e-12)
