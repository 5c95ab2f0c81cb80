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
from dynamics.regime import DISSIPATED, V1, V2, W1, W2, W3, R

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
STATE_SIZE = DISSIPATED + 1
"""Size of every state y and of its rates."""
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
def copy_state(y: np.ndarray, out: np.ndarray) -> None:
    """Copy a state into `out`."""
    for a in range(STATE_SIZE):
        out[a] = y[a]


@cached
def evaluate_polynomial(c: np.ndarray, x: float, y: np.ndarray) -> None:
    """Write the state at x on the curve c (order + 1, STATE_SIZE) into y."""
    copy_state(c[-1], y)
    for j in range(len(c) - 2, -1, -1):
        for a in range(STATE_SIZE):
            y[a] = y[a] * x + c[j, a]


@cached
def add_weighted_rates(
    h: float, weights: np.ndarray, count: int, rates: np.ndarray, out: np.ndarray
) -> None:
    """Add h times the weighted sum of the first `count` rates to `out`."""
    for j in range(count):
        weight = h * weights[j]
        if weight != 0:
            for a in range(STATE_SIZE):
                out[a] += weight * rates[j, a]


@cached
def step_and_error(
    flow: Flow,
    y: np.ndarray,
    p: np.ndarray,
    h: float,
    rates: np.ndarray,
    y_end: np.ndarray,
    state: np.ndarray,
    guards: np.ndarray,
) -> float:
    """Fill the rates (16, STATE_SIZE) and the end of a step of length h; return its error.

    The first row of the rates must be given; `state` and `guards` are overwritten. The
    error norm is that of SciPy for relative and absolute tolerances of 1.
    """
    for i in range(1, 16):
        copy_state(y, state)
        add_weighted_rates(h, STAGE_WEIGHTS[i], i, rates, state)
        flow(state, p, rates[i], guards)
        if i == 12:
            copy_state(state, y_end)
    fifth = 0.0
    third = 0.0
    for a in range(STATE_SIZE):
        scale = 1 + max(abs(y[a]), abs(y_end[a]))
        error5 = 0.0
        error3 = 0.0
        for j in range(13):
            error5 += ERROR_WEIGHTS[0, j] * rates[j, a]
            error3 += ERROR_WEIGHTS[1, j] * rates[j, a]
        fifth += (error5 / scale) ** 2
        third += (error3 / scale) ** 2
    if fifth == 0:
        return 0.0
    return h * fifth / np.sqrt((fifth + 0.01 * third) * STATE_SIZE)


@cached
def write_dense_output(
    y: np.ndarray, h: float, rates: np.ndarray, c: np.ndarray
) -> None:
    """Write the curve (8, STATE_SIZE) of a step from y, on [0, 1], into c."""
    copy_state(y, c[0])
    for j in range(1, 8):
        for a in range(STATE_SIZE):
            c[j, a] = 0.0
        add_weighted_rates(h, DENSE_OUTPUT[j], 16, rates, c[j])


@cached
def convert_to_powers_of_time(c: np.ndarray, h: float) -> None:
    """Convert a curve from powers of x in [0, 1] to powers of x h."""
    scale = 1.0
    for j in range(1, len(c)):
        scale /= h
        for a in range(STATE_SIZE):
            c[j, a] *= scale


@cached
def guard_root(
    flow: Flow, p: np.ndarray, c: np.ndarray, i: int, low: float, high: float
) -> float:
    """Return the position in [low, high] on the curve c at which guard i falls to zero.

    The result is rounded to the side on which the guard is not positive.
    """
    y = np.empty(STATE_SIZE)
    rates = np.empty(STATE_SIZE)
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
    y = np.empty(STATE_SIZE)
    rates = np.empty(STATE_SIZE)
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
        for i in range(count):
            before[i] = now[i]
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
    flow: Flow,
    start: np.ndarray,
    p: np.ndarray,
    count: int,
    span: float,
    tolerance: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Integrate from `start` until one of `count` guards falls through zero, for at most
    `span`.

    It takes at most MAX_STEPS_PER_ARC steps. Returns the end times of the steps (n,),
    their Taylor coefficients (n, 8, STATE_SIZE), the last state and the index of the guard
    (-1 if none). The integration also ends, possibly before the first step, if no step
    meets the tolerance.
    """
    # Length of the next step as a fraction of the length allowed by the error
    step_safety = 0.9
    min_step_ratio = 0.2
    max_step_ratio = 10.0
    times = np.empty(MAX_STEPS_PER_ARC)
    coefficients = np.empty((MAX_STEPS_PER_ARC, 8, STATE_SIZE))
    y = np.empty(STATE_SIZE)
    copy_state(start, y)
    rates = np.empty((16, STATE_SIZE))
    y_end = np.empty(STATE_SIZE)
    state = np.empty(STATE_SIZE)
    guards = np.empty(MAX_GUARDS)
    unused = np.empty(MAX_GUARDS)
    flow(y, p, rates[0], guards)
    t = 0.0
    h = max_step(y)
    n = 0
    fired = -1
    while n < MAX_STEPS_PER_ARC and t < span and fired < 0:
        h = min(h, max_step(y), span - t)
        if not h > 1e-13 * y[R]:  # too short
            break
        error = step_and_error(flow, y, p, h, rates, y_end, state, unused) / tolerance
        if not error < 1:  # NaN if the step leaves the domain of the formulas
            h *= (
                max(min_step_ratio, step_safety * error ** (-1 / 8))
                if error >= 1
                else min_step_ratio
            )
            continue
        c = coefficients[n]
        write_dense_output(y, h, rates, c)
        place, fired = first_guard_crossing(flow, p, c, count, guards)
        t = span if fired < 0 and h == span - t else t + place * h
        times[n] = t
        n += 1
        copy_state(y_end, y)
        copy_state(rates[12], rates[0])
        if fired >= 0:
            evaluate_polynomial(c, place, y)
        convert_to_powers_of_time(c, h)
        h *= (
            min(max_step_ratio, step_safety * error ** (-1 / 8))
            if error > 0
            else max_step_ratio
        )
    return times[:n].copy(), coefficients[:n].copy(), y, fired
