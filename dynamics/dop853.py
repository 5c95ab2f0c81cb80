"""The flow by scipy's DOP853, for machines without heyoka: the same equations and guards on Python floats."""

import numpy as np
from scipy.integrate import DOP853

from .equations import Law
from .falls import first_fall
from .hybrid import Arc, StalledError
from .regime import FLOAT, V1, V2, W1, W2, W3, Branch, R, Regime, describe

MOST_STEPS = 1000
NODES = np.sin(np.pi / 4 * (1 - np.cos(np.pi * np.arange(8) / 7))) ** 2
TO_POWERS = np.linalg.inv(np.vander(NODES, increasing=True))
"""From the values of the interpolant, a polynomial of degree 7 on [0, 1], to its powers."""
FINEST = 1e-13


def advance(y, regime: Regime, law: Law, loads, r_end: float, span: float, tolerance: float) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for MOST_STEPS steps."""
    branch = Branch.of(regime, law, loads)

    def contact(y):
        return FLOAT.contact(y, branch, regime.senses, law)

    def rates(_, y):
        y = y.tolist()
        return FLOAT.rates(y, contact(y), branch, law)

    def guards(y):
        y = y.tolist()
        return FLOAT.guards(y, contact(y), branch, regime.senses, law, r_end)

    tolerance = max(tolerance, FINEST)
    solver = DOP853(rates, 0.0, np.array(y), span, rtol=tolerance, atol=tolerance)
    times, coefficients, fired, values = [], [], None, guards(solver.y)
    while solver.status == "running" and len(times) < MOST_STEPS and fired is None:
        solver.max_step = fastest_clock(solver.y)
        if message := solver.step():
            raise StalledError(f"{describe(solver.y)}: DOP853 stopped: {message}")
        curve = solver.dense_output()
        end, fired, values = first_fall(curve, solver.t_old, solver.t, guards, values)
        coefficients.append(_powers(curve, solver.t_old, solver.t))
        times.append(end)
    state = curve(end) if fired else solver.y
    return Arc(np.array(times), np.array(coefficients), state.tolist(), fired)


def fastest_clock(y) -> float:
    """Return the longest step that cannot hide two roots of a guard: a part of the time of a radian of turning."""
    return 0.25 * y[R] / (1e-3 + max(abs(y[W1]), abs(y[W2]), abs(y[W3]), abs(y[V1]), abs(y[V2])))


def _powers(curve, start, stop):
    """Return the Taylor coefficients (8, k) of the interpolant of one step."""
    width = stop - start
    values = curve(start + NODES * width).T
    powers = TO_POWERS @ (values - values[0])
    powers[0] = values[0]
    return powers / width ** np.arange(8)[:, None]
