"""Steps of DOP853 with dense output, in machine code, up to a guard: Hairer, Norsett & Wanner
(1993), II.5, II.6.

The coefficients are scipy's. A flow, of the type FLOW of codegen.py, computes the rates and the
guards of a state."""

import numpy as np
from numba import njit, types
from scipy.integrate import DOP853

from dynamics.integrators.codegen import FLOW, ROW
from dynamics.regime import V1, V2, W1, W2, W3, R

STAGES = np.zeros((16, 16))
"""Weights of the preceding rates: 12 stages, the end of the step, and three stages for the dense
output."""
STAGES[:12, :12], STAGES[12, :12], STAGES[13:] = DOP853.A, DOP853.B, DOP853.A_EXTRA
ERRORS = np.zeros((2, 13))
ERRORS[:] = DOP853.E5, DOP853.E3
LOOKS, HALVINGS = 4, 54
"""Number of places in a step at which the guards are evaluated, and number of bisections to locate
a fall."""
SAFETY, SHRINK, GROW = 0.9, 0.2, 10.0
"""Length of the next step: fraction of the length that the error allows, and bounds of the ratio to
the last step."""
MOST_STEPS, SHORTEST = 1000, 1e-13
"""Maximum number of steps per call, and length in units of r below which a step is abandoned."""
GUARDS = 16
"""Array size that suffices for the guards of any branch."""


def powers_of_stages():
    """Return the Taylor coefficients (8, 16) of the dense output, of degree 7 on [0, 1], from the
    rates of the stages.

    It is F_0 x + F_1 x (1 - x) + F_2 x^2 (1 - x) + F_3 x^2 (1 - x)^2 + ...
    """
    start = np.eye(16)[0]
    mean = STAGES[12]
    end = np.eye(16)[12]
    x = np.polynomial.Polynomial([0, 1])
    powers = np.zeros((8, 16))
    shape = x
    for i, weights in enumerate((mean, start - mean, 2 * mean - end - start, *DOP853.D)):
        powers[: len(shape.coef)] += np.outer(shape.coef, weights)
        shape = shape * (x if i % 2 else 1 - x)
    return powers


POWERS = powers_of_stages()


@njit(cache=True, error_model="numpy")
def fastest_clock(y):
    """Return the longest step that cannot hide two roots of a guard: 1/4 radian of rotation."""
    return 0.25 * y[R] / (1e-3 + max(abs(y[W1]), abs(y[W2]), abs(y[W3]), abs(y[V1]), abs(y[V2])))


@njit(cache=True, error_model="numpy")
def write(values, out):
    """Write values (k,) into out (k,). For `out[:] = values`, numba spends seconds on compiling an
    error message."""
    for a in range(len(out)):
        out[a] = values[a]


@njit(cache=True, error_model="numpy")
def at(c, x, y):
    """Evaluate the polynomials c (order + 1, k) at x into y (k,)."""
    write(c[-1], y)
    for j in range(len(c) - 2, -1, -1):
        for a in range(len(y)):
            y[a] = y[a] * x + c[j, a]


@njit(cache=True, error_model="numpy")
def error_of_step(flow, y, p, h, rates, y_end, guards):
    """Fill the rates (16, k) of a step of length h from y, and y_end (k,); return its error.

    The first row of the rates must be given. The error is that of scipy's DOP853 for relative and
    absolute tolerances of 1."""
    for i in range(1, 16):
        state = y + h * (STAGES[i, :i] @ rates[:i])
        flow(state, p, rates[i], guards)
        if i == 12:
            write(state, y_end)
    scale = 1 + np.maximum(np.abs(y), np.abs(y_end))
    fifth = np.sum(((ERRORS[0] @ rates[:13]) / scale) ** 2)
    third = np.sum(((ERRORS[1] @ rates[:13]) / scale) ** 2)
    return h * fifth / np.sqrt((fifth + 0.01 * third) * len(y)) if fifth > 0 else fifth


@njit(cache=True, error_model="numpy")
def root(flow, p, c, i, low, high):
    """Return the place in [low, high] on the curve c (8, k) at which guard i falls, rounded to the
    far side."""
    y = np.empty(c.shape[1])
    rates = np.empty(c.shape[1])
    guards = np.empty(GUARDS)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        at(c, middle, y)
        flow(y, p, rates, guards)
        low, high = (middle, high) if guards[i] > 0 else (low, middle)
    return high


@njit(cache=True, error_model="numpy")
def fall_between(flow, p, c, count, before, now, low, high):
    """Return the place of the first fall of one of `count` guards in [low, high] on the curve c,
    and its index.

    If none falls, return 1, -1. `before` and `now` are the guards at both ends."""
    place = 1.0
    fired = -1
    for i in range(count):
        if before[i] > 0 >= now[i]:
            fall = root(flow, p, c, i, low, high)
            if fired < 0 or fall < place:
                place = fall
                fired = i
    return place, fired


@njit(cache=True, error_model="numpy")
def first_fall(flow, p, c, count, before):
    """Return the place in [0, 1] of the first fall of one of `count` guards on the curve c (8, k),
    and its index.

    If none falls, return 1, -1. `before` contains the guards at 0, and is overwritten by their last
    values. A guard that is not positive at 0 cannot fall."""
    y = np.empty(c.shape[1])
    rates = np.empty(c.shape[1])
    now = np.empty(GUARDS)
    place = 1.0
    fired = -1
    for look in range(1, LOOKS + 1):
        at(c, look / LOOKS, y)
        flow(y, p, rates, now)
        place, fired = fall_between(
            flow, p, c, count, before, now, (look - 1) / LOOKS, look / LOOKS
        )
        write(now, before)
        if fired >= 0:
            break
    return place, fired


FOUND = types.Tuple((ROW, types.float64[:, :, ::1], ROW, types.int64))
STEPS = FOUND(types.FunctionType(FLOW), ROW, ROW, types.int64, types.float64, types.float64)
"""Signature of `integrate`."""


def integrate(flow, y, p, count, span, tolerance):
    """Integrate from y (k,) for `span`, for MOST_STEPS steps or until one of `count` guards falls.

    Returns the ends of the steps (n,), their Taylor coefficients (n, 8, k), the last state (k,) and
    the index of the guard (-1 if none). If no step is short enough, it returns the steps before
    this point, possibly none."""
    times = np.empty(MOST_STEPS)
    coefficients = np.empty((MOST_STEPS, 8, len(y)))
    rates = np.empty((16, len(y)))
    y_end = np.empty(len(y))
    guards = np.empty(GUARDS)
    spare = np.empty(GUARDS)
    flow(y, p, rates[0], guards)
    t = 0.0
    h = fastest_clock(y)
    n = 0
    fired = -1
    while n < MOST_STEPS and t < span and fired < 0:
        h = min(h, fastest_clock(y), span - t)
        if not h > SHORTEST * y[R]:
            break
        error = error_of_step(flow, y, p, h, rates, y_end, spare) / tolerance
        if not error < 1:  # NaN if the step leaves the domain of the formulas
            h *= max(SHRINK, SAFETY * error ** (-1 / 8)) if error >= 1 else SHRINK
            continue
        c = h * (POWERS @ rates)
        write(y, c[0])
        place, fired = first_fall(flow, p, c, count, guards)
        for j in range(8):
            write(c[j] / h**j, coefficients[n, j])
        t = span if fired < 0 and h == span - t else t + place * h
        times[n] = t
        n += 1
        y = y_end.copy()
        write(rates[12], rates[0])
        if fired >= 0:
            at(c, place, y)
        h *= min(GROW, SAFETY * error ** (-1 / 8)) if error > 0 else GROW
    return times[:n].copy(), coefficients[:n].copy(), y, fired
