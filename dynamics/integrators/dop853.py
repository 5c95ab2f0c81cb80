"""The flow by DOP853, for machines without heyoka: the same equations and guards, compiled by
numba."""

import numpy as np

from dynamics.equations import DiskConstants
from dynamics.hybrid import Arc, StalledError
from dynamics.integrators.branch_formulas import compiled_flow
from dynamics.integrators.codegen import compile_branch, machine_code
from dynamics.integrators.runge_kutta import INTEGRATE_SIGNATURE, integrate
from dynamics.regime import Regime, describe_state

MIN_TOLERANCE = 1e-15


def advance(
    y, regime: Regime, law: DiskConstants, loads, r_end: float, span: float, tolerance: float
) -> Arc:
    """Integrate from y within `regime` until a guard falls through zero, for `span`, or for 1000
    steps.

    Safe to call from several threads at once. Raises StalledError if no step is short enough."""
    (flow, names), parameters = compiled_flow(compile_branch, regime, law, loads, r_end)
    times, coefficients, end, fired = machine_code(integrate, INTEGRATE_SIGNATURE)(
        flow, np.array(y, float), parameters, len(names), span, max(tolerance, MIN_TOLERANCE)
    )
    if not len(times):
        raise StalledError(f"{describe_state(y)}: no step is short enough in {regime}")
    return Arc(times, coefficients, end.tolist(), names[fired] if fired >= 0 else None)
