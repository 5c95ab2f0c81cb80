"""Compiled DOP853 integration with dense output, up to the first crossing of a guard.

See Hairer, Norsett & Wanner (1993), II.5 and II.6; the coefficients are those of SciPy.
A flow (FLOW_SIGNATURE in codegen.py) computes the rates and the guards of a state.
"""

from collections.abc import Callable

import numpy as np
from numba import types
from scipy.integrate import DOP853

from dynamics.hybrid import MAX_STEPS_PER_ARC
from dynamics.integrators.codegen import ARRAY_TYPE, FLOW_SIGNATURE
from dynamics.numba_kernels import cached
from dynamics.regime import V1, V2, W1, W2, W3, R

Flow = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], None]
"""Compiled flow (state, constants, output for rates, output for guards)."""

STAGE_WEIGHTS = np.zeros((16, 16))
"""Weights of the preceding rates for 12 stages, the end of the step, and three stages
of the dense output."""
STAGE_WEIGHTS[:12, :12] = DOP853.A
STAGE_WEIGHTS[12, :12] = DOP853.B
STAGE_WEIGHTS[13:] = DOP853.A_EXTRA
ERROR_WEIGHTS = np.zeros((2, 13))
ERROR_WEIGHTS[:] = DOP853.E5, DOP853.E3
BISECTION_COUNT = 54  # for the location of a guard crossing
MAX_GUARDS = 16
"""Array size that is sufficient for the guards of any branch."""


def dense_output_coefficients() -> np.ndarray:
    """Return the matrix (8, 16) from stage rates to the powers of the dense output.

    On [0, 1] the dense output is F_0 x + F_1 x (1 - x) + F_2 x^2 (1 - x) + F_3 x^2 (1 -
    x)^2 + ...
    """
    start = np.eye(16)[0]
    mean = STAGE_WEIGHTS[12]
    end = np.eye(16)[12]
    x = np.polynomial.Polynomial([0, 1])
    powers = np.zeros((8, 16))
    shape = x
    for i, weights in enumerate(
        (mean, start - mean, 2 * mean - end - start, *DOP853.D)
    ):
        powers[: len(shape.coef)] += np.outer(shape.coef, weights)
        shape = shape * (x if i % 2 else 1 - x)
    return powers


DENSE_OUTPUT = dense_output_coefficients()


@cached
def max_step(y: np.ndarray) -> float:
    """Return the step of 1/4 rad of rotation, in which no guard has two roots."""
    turning = max(abs(y[W1]), abs(y[W2]), abs(y[W3]))
    slipping = max(abs(y[V1]), abs(y[V2]))
    return 0.25 * y[R] / (1e-3 + max(turning, slipping))


@cached
def copy_into(values: np.ndarray, out: np.ndarray) -> None:
    """Copy values (k,) into out (k,).

    The statement `out[:] = values` would add seconds to the compilation time of numba.
    """
    for a in range(len(out)):
        out[a] = values[a]


@cached
def evaluate_polynomial(c: np.ndarray, x: float, y: np.ndarray) -> None:
    """Write the values of polynomials c (order + 1, k) at x into y (k,)."""
    copy_into(c[-1], y)
    for j in range(len(c) - 2, -1, -1):
        for a in range(len(y)):
            y[a] = y[a] * x + c[j, a]


@cached
def step_and_error(
    flow: Flow,
    y: np.ndarray,
    p: np.ndarray,
    h: float,
    rates: np.ndarray,
    y_end: np.ndarray,
    guards: np.ndarray,
) -> float:
    """Fill the rates (16, k) and the end (k,) of a step of length h; return its error.

    The first row of the rates must be given. The error norm is that of SciPy for
    relative and absolute tolerances of 1.
    """
    for i in range(1, 16):
        state = y + h * (STAGE_WEIGHTS[i, :i] @ rates[:i])
        flow(state, p, rates[i], guards)
        if i == 12:
            copy_into(state, y_end)
    scale = 1 + np.maximum(np.abs(y), np.abs(y_end))
    fifth = np.sum(((ERROR_WEIGHTS[0] @ rates[:13]) / scale) ** 2)
    third = np.sum(((ERROR_WEIGHTS[1] @ rates[:13]) / scale) ** 2)
    return h * fifth / np.sqrt((fifth + 0.01 * third) * len(y)) if fifth > 0 else fifth


@cached
def guard_root(
    flow: Flow, p: np.ndarray, c: np.ndarray, i: int, low: float, high: float
) -> float:
    """Return the position in [low, high] on the curve c at which guard i falls to zero.

    The result is rounded to the side on which the guard is not positive.
    """
    y = np.empty(c.shape[1])
    rates = np.empty(c.shape[1])
    guards = np.empty(MAX_GUARDS)
    for _ in range(BISECTION_COUNT):
        middle = (low + high) / 2
        evaluate_polynomial(c, middle, y)
        flow(y, p, rates, guards)
        if guards[i] > 0:
            low = middle
        else:
            high = middle
    return high


@cached
def guard_crossing_between(
    flow: Flow,
    p: np.ndarray,
    c: np.ndarray,
    count: int,
    before: np.ndarray,
    now: np.ndarray,
    low: float,
    high: float,
) -> tuple[float, int]:
    """Return position and index of the first guard that falls in [low, high].

    If none of the `count` guards falls on the curve c, return 1, -1. `before` and `now`
    are the guards at both ends.
    """
    place = 1.0
    fired = -1
    for i in range(count):
        if before[i] > 0 >= now[i]:
            fall = guard_root(flow, p, c, i, low, high)
            if fired < 0 or fall < place:
                place = fall
                fired = i
    return place, fired


@cached
def first_guard_crossing(
    flow: Flow, p: np.ndarray, c: np.ndarray, count: int, before: np.ndarray
) -> tuple[float, int]:
    """Return position and index of the first guard that falls in [0, 1] on the curve c.

    If none of the `count` guards falls, return 1, -1. `before` contains the guards at 0
    and is overwritten by their last values. A guard that is not positive at 0 cannot
    fall.
    """
    guard_evaluations_per_step = 4
    y = np.empty(c.shape[1])
    rates = np.empty(c.shape[1])
    now = np.empty(MAX_GUARDS)
    place = 1.0
    fired = -1
    for look in range(1, guard_evaluations_per_step + 1):
        evaluate_polynomial(c, look / guard_evaluations_per_step, y)
        flow(y, p, rates, now)
        place, fired = guard_crossing_between(
            flow,
            p,
            c,
            count,
            before,
            now,
            (look - 1) / guard_evaluations_per_step,
            look / guard_evaluations_per_step,
        )
        copy_into(now, before)
        if fired >= 0:
            break
    return place, fired


RESULT_TYPE = types.Tuple(
    (ARRAY_TYPE, types.float64[:, :, ::1], ARRAY_TYPE, types.int64)
)
INTEGRATE_SIGNATURE = RESULT_TYPE(
    types.FunctionType(FLOW_SIGNATURE),
    ARRAY_TYPE,
    ARRAY_TYPE,
    types.int64,
    types.float64,
    types.float64,
)
"""Signature of `integrate_dop853`."""


def integrate_dop853(
    flow: Flow, y: np.ndarray, p: np.ndarray, count: int, span: float, tolerance: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Integrate from y (k,) until one of `count` guards falls through zero, for at most
    `span`.

    It takes at most MAX_STEPS_PER_ARC steps. Returns the end times of the steps (n,),
    their Taylor coefficients (n, 8, k), the last state (k,) and the index of the guard
    (-1 if none). The integration also ends, possibly before the first step, if no step
    meets the tolerance.
    """
    # Length of the next step as a fraction of the length allowed by the error
    step_safety = 0.9
    min_step_ratio = 0.2
    max_step_ratio = 10.0
    times = np.empty(MAX_STEPS_PER_ARC)
    coefficients = np.empty((MAX_STEPS_PER_ARC, 8, len(y)))
    rates = np.empty((16, len(y)))
    y_end = np.empty(len(y))
    guards = np.empty(MAX_GUARDS)
    guard_values = np.empty(MAX_GUARDS)
    flow(y, p, rates[0], guards)
    t = 0.0
    h = max_step(y)
    n = 0
    fired = -1
    while n < MAX_STEPS_PER_ARC and t < span and fired < 0:
        h = min(h, max_step(y), span - t)
        if not h > 1e-13 * y[R]:  # too short
            break
        error = step_and_error(flow, y, p, h, rates, y_end, guard_values) / tolerance
        if not error < 1:  # NaN if the step leaves the domain of the formulas
            h *= (
                max(min_step_ratio, step_safety * error ** (-1 / 8))
                if error >= 1
                else min_step_ratio
            )
            continue
        c = h * (DENSE_OUTPUT @ rates)
        copy_into(y, c[0])
        place, fired = first_guard_crossing(flow, p, c, count, guards)
        for j in range(8):
            copy_into(c[j] / h**j, coefficients[n, j])
        t = span if fired < 0 and h == span - t else t + place * h
        times[n] = t
        n += 1
        y = y_end.copy()
        copy_into(rates[12], rates[0])
        if fired >= 0:
            evaluate_polynomial(c, place, y)
        h *= (
            min(max_step_ratio, step_safety * error ** (-1 / 8))
            if error > 0
            else max_step_ratio
        )
    return times[:n].copy(), coefficients[:n].copy(), y, fired
