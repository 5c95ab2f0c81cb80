"""The flow by DOP853, for machines without heyoka: the same equations and guards, compiled by
numba."""

import numpy as np

from dynamics.equations import Law
from dynamics.hybrid import Arc, StalledError
from dynamics.integrators.branch_formulas import prepared
from dynamics.integrators.codegen import compiled, machine
from dynamics.integrators.runge_kutta import STEPS, integrate
from dynamics.regime import Regime, describe

FINEST = 1e-15


def advance(y, regime: Regime, law: Law, loads, r_end: float, span: float, tolerance: float) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for 1000
    steps.

    Safe to call from several threads at once. Raises StalledError if no step is short enough."""
    (flow, names), parameters = prepared(compiled, regime, law, loads, r_end)
    times, coefficients, end, fired = machine(integrate, STEPS)(
        flow, np.array(y, float), parameters, len(names), span, max(tolerance, FINEST)
    )
    if not len(times):
        raise StalledError(f"{describe(y)}: no step is short enough in {regime}")
    return Arc(times, coefficients, end.tolist(), names[fired] if fired >= 0 else None)
