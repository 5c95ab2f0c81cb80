"""Integration by DOP853, compiled by numba, as the portable alternative to heyoka."""

from typing import Any

import numpy as np

from dynamics.equations import DiskConstants
from dynamics.hybrid import Arc, StalledError
from dynamics.integrators.branch_formulas import compiled_flow_and_constants
from dynamics.integrators.codegen import compile_branch, compiled_function
from dynamics.integrators.runge_kutta import INTEGRATE_SIGNATURE, integrate_dop853
from dynamics.regime import Regime, StateVector, describe_state


def advance(
    y: StateVector,
    regime: Regime,
    constants: DiskConstants,
    loads: Any,
    r_end: float,
    span: float,
    tolerance: float,
) -> Arc:
    """Integrate from y within `regime` until a guard falls, for at most `span`.

    It takes at most MAX_STEPS_PER_ARC steps and is thread-safe. Raises StalledError if
    no step is short enough.
    """
    (flow, names), parameters = compiled_flow_and_constants(
        compile_branch, regime, constants, loads, r_end
    )
    times, coefficients, end, fired = compiled_function(
        integrate_dop853, INTEGRATE_SIGNATURE
    )(
        flow,
        np.array(y, float),
        parameters,
        len(names),
        span,
        max(tolerance, 1e-15),
    )
    if not len(times):
        raise StalledError(
            f"{describe_state(y)}: even the shortest step fails in the regime {regime}"
        )
    return Arc(times, coefficients, end.tolist(), names[fired] if fired >= 0 else None)
