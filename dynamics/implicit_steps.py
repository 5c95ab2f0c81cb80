"""Implicit steps of high order in machine code, until a guard falls: the collocation that collocation.py speaks of.

A flow, of the type of trace.py, gives the rates and the guards of a state at once. Behind the state stands the
direction in which the slip ran at first, `FORWARD`: a slip that runs back counts as negative.
"""

import numpy as np
from numba import njit, types

from . import slow_slide
from .regime import DISSIPATED, PRECESSION, STOP_SPEED, V1, V2, W1, R
from .runge_kutta import GUARDS, at, fall_between
from .trace import FLOW, ROW

ORDER = 9
NODES = (1 - np.cos(np.pi * (np.arange(ORDER) + 0.5) / ORDER)) / 2
"""Gauss-Chebyshev points on [0, 1]; the start, where the direction may have no meaning, is not one of them."""
POWERS = np.arange(1, ORDER + 1)
TO_POWERS = np.linalg.inv(NODES[:, None] ** (POWERS - 1)) / POWERS[:, None]
"""The coefficients of x, x^2, ... in the integral of the polynomial through values at the nodes."""
INTEGRAL = NODES[:, None] ** POWERS @ TO_POWERS
LENGTH, LONGEST = 0.1, 0.5
"""First length of a step to try, in units of r, unless the direction relaxes in less; and the longest."""
GROWTH, SHRINK = 4.0, 0.4
"""Bounds on the ratio of a step to the last one."""
SHORTEST = 1e-12
ACCURACY = 1e-12
TILT = 1e-7
"""Of the difference quotients for Newton's method, which mends their error."""
MOST_STEPS, MOST_TRIES = 100, 12
FORWARD, SIZE = DISSIPATED + 1, DISSIPATED + 3

is_slow = njit(cache=True, error_model="numpy")(slow_slide.is_slow)


@njit(cache=True, error_model="numpy")
def slopes(flow, p, y, rates):
    """Return d(rates)/d(y) up to PRECESSION, (k, k), by difference quotients."""
    out, tilted, tilted_rates, guards = np.empty((PRECESSION, PRECESSION)), y.copy(), np.empty(SIZE), np.empty(GUARDS)
    speed = np.hypot(y[V1], y[V2])
    for j in range(PRECESSION):
        tilted[j] = y[j] + TILT * (speed if j >= V1 else y[R] if j == R else 1.0)
        flow(tilted, p, tilted_rates, guards)
        for i in range(PRECESSION):
            out[i, j] = (tilted_rates[i] - rates[i]) / (tilted[j] - y[j])
        tilted[j] = y[j]
    return out


@njit(cache=True, error_model="numpy")
def combined(weights, rates, y, dt, out):
    """Fill out (n, k) with y (k,) + dt weights (n, m) rates (m, k), in loops, which compile soonest."""
    for i in range(len(out)):
        out[i] = y
        for j in range(len(rates)):
            out[i] += dt * weights[i, j] * rates[j]


@njit(cache=True, error_model="numpy")
def largest(rows, k):
    """Return the largest size of the first k columns; not a number where one of them is not."""
    size = 0.0
    for row in rows:
        for value in row[:k]:
            size = abs(value) if not abs(value) <= size else size
    return size


@njit(cache=True, error_model="numpy")
def newton(flow, p, states, y, dt, rates, guards):
    """Solve states = y + dt INTEGRAL rates(states) by Newton's method; tell whether it converges.

    The states (ORDER, SIZE) are changed in place, their rates and guards filled. What is only integrated along, from
    PRECESSION on, follows when the rest is known; twice, for the path turns with the precession.
    """
    n, k, known = ORDER, PRECESSION, 0
    ahead, matrix, residual = np.empty((n, SIZE)), np.empty((n * k, n * k)), np.empty((n, k))
    for _ in range(MOST_TRIES + 3):
        for j in range(n):
            flow(states[j], p, rates[j], guards[j])
        combined(INTEGRAL, rates, y, dt, ahead)
        if known:
            if known == 3:
                return True
            for j in range(n):
                states[j, k:] = ahead[j, k:]
            known += 1
            continue
        matrix[:] = 0.0
        for j in range(n):
            slope = slopes(flow, p, states[j], rates[j])
            for b in range(k):
                residual[j, b] = states[j, b] - ahead[j, b]
                for i in range(n):
                    for a in range(k):
                        matrix[i * k + a, j * k + b] = -dt * INTEGRAL[i, j] * slope[a, b]
                matrix[j * k + b, j * k + b] += 1.0
        if not (np.isfinite(largest(residual, k)) and np.isfinite(largest(matrix, n * k))):
            return False
        change = np.linalg.solve(matrix, residual.reshape(n * k)).reshape(n, k)
        for j in range(n):
            states[j, :k] -= change[j]
        known = int(largest(change, k) < ACCURACY * max(1.0, largest(states, k)))
    return False


@njit(cache=True, error_model="numpy")
def collocate(flow, p, states, y, dt, guards):
    """Return one step from y as powers (ORDER + 1, SIZE) of x in [0, 1], and its error over ACCURACY, inf for none.

    `states` (ORDER, SIZE) are guessed; the guards (ORDER + 1, GUARDS) at the nodes and the end are filled. The error is
    the last coefficient in Chebyshev's polynomials.
    """
    c, rates, end = np.zeros((ORDER + 1, SIZE)), np.zeros((ORDER, SIZE)), np.zeros(SIZE)
    if not newton(flow, p, states, y, dt, rates, guards):
        return c, np.inf
    combined(TO_POWERS, rates, end, dt, c[1:])
    c[0] = y
    at(c, 1.0, end)
    flow(end, p, rates[0], guards[ORDER])
    last = largest(c[ORDER:], SIZE) / 2.0 ** (2 * ORDER - 1)
    return c, last / (ACCURACY * max(1.0, largest(c[:1], SIZE))) + 1e-30


@njit(cache=True, error_model="numpy")
def first_fall(flow, p, c, count, before, guards):
    """Return the place in [0, 1] of the first fall of one of `count` guards on the powers c, and which; 1, -1 for none.

    `before` are the guards at 0, `guards` those at the nodes and the end. A guard not positive at 0 cannot fall.
    """
    place, fired, low = 1.0, -1, 0.0
    for look in range(ORDER + 1):
        high = NODES[look] if look < ORDER else 1.0
        place, fired = fall_between(flow, p, c, count, before, guards[look], low, high)
        if fired >= 0:
            break
        low, before = high, guards[look]
    return place, fired


CALL, ROWS, INDEX, NUMBER = types.FunctionType(FLOW), types.float64[:, ::1], types.int64, types.float64
STEP = types.Tuple((ROWS, NUMBER))(CALL, ROW, ROWS, ROW, NUMBER, ROWS)
STEPS = types.Tuple((ROW, types.float64[:, :, ::1], ROW, INDEX))(CALL, ROW, ROW, *[INDEX] * 3, NUMBER, NUMBER)
"""The types of `collocate` and of `integrate`."""


def integrate(flow, y, p, count, grip, load, mu, span):
    """Integrate a slow slide from y (SIZE,) until a guard falls, for `span`, while it is slow, or for MOST_STEPS steps.

    `grip` and `load` are the numbers of these among the `count` guards, the load being Phi. Returns the ends of the
    steps (n,), their Taylor coefficients (n, ORDER + 1, SIZE), the last state (SIZE,) and the number of the guard, -1
    for none. Where no step is short enough, the steps before it; there may be none.
    """
    times, coefficients = np.empty(MOST_STEPS), np.empty((MOST_STEPS, ORDER + 1, SIZE))
    slope, states = np.zeros(SIZE), np.empty((ORDER, SIZE))
    before, guards = np.empty(GUARDS), np.empty((ORDER + 1, GUARDS))
    t, n, fired, slow, length = 0.0, 0, -1, True, min(LENGTH, 2 * np.hypot(y[V1], y[V2]))
    while n < MOST_STEPS and t < span and fired < 0 and slow and length >= SHORTEST:
        y[FORWARD:] = y[V1 : V2 + 1]
        flow(y, p, slope, before)
        dt = min(length * y[R], span - t)
        along = (slope[V1] * y[V1] + slope[V2] * y[V2]) / (y[V1] ** 2 + y[V2] ** 2)
        slope[V1 : V2 + 1] = along * y[V1 : V2 + 1]  # the slip is guessed to keep its direction
        for j in range(ORDER):
            states[j] = y + dt * NODES[j] * slope
        c, error = collocate(flow, p, states, y, dt, guards)
        if not error < 1:
            length *= SHRINK
            continue
        place, fired = first_fall(flow, p, c, count, before, guards)
        for j in range(ORDER + 1):
            coefficients[n, j] = c[j] / dt**j
        t = span if fired < 0 and dt == span - t else t + place * dt
        times[n], n = t, n + 1
        length = min(min(GROWTH, 0.8 * error ** (-1 / ORDER)) * length, LONGEST)
        at(c, place, y)
        flow(y, p, slope, before)
        speed = np.hypot(y[V1], y[V2])
        product = y[R] * (slope[V1] * y[V1] + slope[V2] * y[V2]) - y[W1] * speed**2 / 2
        slow = is_slow(speed, product, mu * before[load])
        if fired < 0 and not slow and before[grip] < STOP_SPEED:  # it stops too fast to be slow, and has no guard left
            fired = grip
    return times[:n].copy(), coefficients[:n].copy(), y, fired
