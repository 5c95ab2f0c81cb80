"""Implicit high-order collocation steps up to a guard, in machine code, for slow_slides.py.

A flow (FLOW_SIGNATURE in codegen.py) computes the rates and the guards of a state. The slip of a
state is polar: signed speed divided by r at V1, direction at V2. The rate at V2 is the rate of the
direction times the speed.
"""

import numpy as np
from numba import njit, types
from numpy.polynomial.chebyshev import cheb2poly, chebint, chebpts1, chebvander

from dynamics.equations import DiskConstants
from dynamics.integrators import slow_slide_criterion
from dynamics.integrators.codegen import ARRAY_TYPE, FLOW_SIGNATURE
from dynamics.integrators.runge_kutta import (
    BISECTIONS,
    MAX_GUARDS,
    copy_into,
    evaluate_polynomial,
    guard_crossing_between,
)
from dynamics.regime import DISSIPATED, STOP_SPEED, V1, V2, W1, R

ORDER = 14
COLLOCATION_NODES = (1 + chebpts1(ORDER)) / 2
"""Gauss-Chebyshev points on [0, 1]. They exclude the start, where the slip may be at rest."""
INTEGRAL_SERIES = np.ascontiguousarray(
    chebint(np.linalg.inv(chebvander(2 * COLLOCATION_NODES - 1, ORDER - 1)), lbnd=-1, scl=0.5)
)
"""Chebyshev coefficients (ORDER + 1, ORDER) of the integral of the polynomial through values at the
nodes."""
INTEGRAL_WEIGHTS = chebvander(2 * COLLOCATION_NODES - 1, ORDER) @ INTEGRAL_SERIES
CHEBYSHEV_TO_POWERS = np.zeros((ORDER + 1, ORDER + 1))
for _k in range(ORDER + 1):
    CHEBYSHEV_TO_POWERS[: _k + 1, _k] = cheb2poly(np.eye(2 * _k + 1)[-1])[::2]
"""Powers of x in the Chebyshev polynomials on [0, 1]: T_k(2 x - 1) = T_2k(sqrt x)."""
FIRST_STEP_FROM_REST = 0.4  # in units of r, as all lengths of steps
MAX_STEP = 1.0
MIN_STEP_GROWTH = 2.5
"""Smallest growth factor of a step, because transients decay within it."""
STEP_REDUCTION = 0.3
"""Factor on the length of a step that does not converge."""
RELAXATION_TIMES_PER_STEP = 12.0
"""Number of relaxation times in the first step of a slide, the most that the nodes resolve."""
MIN_STEP = 1e-12
STEP_TOLERANCE = 1e-12
ITERATION_TOLERANCE = 1e-13
MAX_ITERATIONS = 40
JACOBIAN_UPDATE_ITERATION = 3
"""Number of the iteration in which the Jacobian is updated."""
JACOBIAN_UPDATE_CHANGE = 1e-3
"""Change of the state above which the Jacobian is updated."""
DIFFERENCE_ANGLE = 1e-7
"""Step [rad] of the difference quotient in Newton's method, which corrects its error."""
SLOW_SLIDE_HYSTERESIS = 1.5
"""Hysteresis: factor on the limits of `is_slow` for a stiff slide in progress."""
MAX_STEPS_PER_CALL = 40
STATE_SIZE = DISSIPATED + 1
NUTATION_SENSE_INDEX = len(DiskConstants._fields)
"""Index of the sense of nutation among the constants of a flow (branch_formulas.py)."""
REST_SLIP_SPEED = 1e-13
"""Slip speed divided by r below which a slow slide is at rest.

It is too small for a last step along the tangent.
"""
MIN_REVERSAL_ACCELERATION = 1e-6
"""Smallest rate of change of omega_1/r at which a reversal of the nutation is treated here."""


is_slow = njit(cache=True, error_model="numpy")(slow_slide_criterion.is_slow)


@njit(cache=True, error_model="numpy")
def direction_jacobian(flow, p, states, rates, spare):
    """Return the Jacobian d(rates)/d(direction) (ORDER, STATE_SIZE) at the nodes, by differences."""
    out = np.empty((ORDER, STATE_SIZE))
    tilted = states.copy()
    for j in range(ORDER):
        tilted[j, V2] += DIFFERENCE_ANGLE
        flow(tilted[j], p, out[j], spare)
    return (out - rates) / DIFFERENCE_ANGLE


@njit(cache=True, error_model="numpy")
def inverse_newton_matrix(states, dt, steer):
    """Return the inverse (ORDER, ORDER) of Newton's matrix for the rates of the direction."""
    matrix = np.empty((ORDER, ORDER))
    for j in range(ORDER):
        for i in range(ORDER):
            matrix[j, i] = -dt * INTEGRAL_WEIGHTS[j, i] * steer[j, V2]
        matrix[j, j] += states[j, V1]
    return np.ascontiguousarray(np.linalg.inv(matrix))


@njit(cache=True, error_model="numpy")
def solve_collocation(flow, p, y, dt, states, rates, guards):
    """Solve the collocation equations from guessed states; return True if the iteration converges.

    The equations are states = y + dt INTEGRAL_WEIGHTS rates(states) for states (ORDER, STATE_SIZE).
    Only the direction is stiff. Newton's method solves for the direction. Picard's method solves
    for
    the other components, with a correction for the change of direction. On return, the rates at V2
    are
    those of the direction itself.
    """
    last = ITERATION_TOLERANCE
    steer = rates
    solved = np.empty((ORDER, ORDER))
    ahead = np.empty((ORDER, STATE_SIZE))
    turning = np.zeros(ORDER)
    wrong = np.empty(ORDER)
    change = np.empty(ORDER)
    turned = np.empty(ORDER)
    for attempt in range(MAX_ITERATIONS):
        for j in range(ORDER):
            flow(states[j], p, rates[j], guards[j])
        if attempt == 0 or (attempt == JACOBIAN_UPDATE_ITERATION and last > JACOBIAN_UPDATE_CHANGE):
            steer = direction_jacobian(flow, p, states, rates, guards[ORDER])
            solved = inverse_newton_matrix(states, dt, steer)
        for j in range(ORDER):
            wrong[j] = rates[j, V2] - states[j, V1] * turning[j]
        np.dot(solved, wrong, change)
        np.dot(INTEGRAL_WEIGHTS, change, turned)
        for j in range(ORDER):
            turning[j] += change[j]
            for a in range(STATE_SIZE):
                rates[j, a] += steer[j, a] * (dt * turned[j])
            rates[j, V2] = turning[j]
        np.dot(INTEGRAL_WEIGHTS, rates, ahead)
        size = 0.0
        for j in range(ORDER):
            for a in range(STATE_SIZE):
                new = y[a] + dt * ahead[j, a]
                moved = abs(new - states[j, a])
                scale = max(1.0, abs(new))
                if not moved <= size * scale:
                    size = moved / scale
                states[j, a] = new
        if size * min(1.0, size / last) < ITERATION_TOLERANCE:
            return True
        if not (size < last or attempt < JACOBIAN_UPDATE_ITERATION):
            return False
        last = size
    return False


@njit(cache=True, error_model="numpy")
def collocation_step(flow, p, y, slope, dt, states, rates, guards):
    """Return one step from y (STATE_SIZE,) as powers (ORDER + 1, STATE_SIZE) of x in [0, 1], and its error over
    STEP_TOLERANCE.

    The first guess follows the `slope` at y with a constant direction. The arguments `states` and
    `rates` (ORDER, STATE_SIZE) are filled with values at the nodes, `guards` (ORDER + 1, GUARDS) with
    values at the nodes and the end. The error is the last Chebyshev coefficient, or infinite if the
    iteration does not converge."""
    c = np.zeros((ORDER + 1, STATE_SIZE))
    end = np.empty(STATE_SIZE)
    for j in range(ORDER):
        for a in range(STATE_SIZE):
            states[j, a] = y[a] + dt * COLLOCATION_NODES[j] * slope[a]
        states[j, V2] = y[V2]
    if not solve_collocation(flow, p, y, dt, states, rates, guards):
        return c, np.inf
    series = np.dot(INTEGRAL_SERIES, rates)
    c = dt * np.dot(CHEBYSHEV_TO_POWERS, series)
    copy_into(y, c[0])
    evaluate_polynomial(c, 1.0, end)
    flow(end, p, series[0], guards[ORDER])
    return c, dt * np.max(np.abs(series[ORDER])) / STEP_TOLERANCE + 1e-30


@njit(cache=True, error_model="numpy")
def first_step_length(flow, p, y, slope):
    """Return the length, in units of r, of a first step that resolves the relaxation."""
    tilted = y.copy()
    rates = np.empty(STATE_SIZE)
    guards = np.empty(MAX_GUARDS)
    tilted[V2] += DIFFERENCE_ANGLE
    flow(tilted, p, rates, guards)
    return min(
        MAX_STEP,
        RELAXATION_TIMES_PER_STEP * DIFFERENCE_ANGLE * y[V1] / (y[R] * abs(rates[V2] - slope[V2])),
    )


@njit(cache=True, error_model="numpy")
def slip_times_acceleration(y, slope):
    """Return the speed over r times the rate of the slip, at a polar state (STATE_SIZE,) with its
    `slope`."""
    return (y[R] * slope[V1] - y[W1] * y[V1] / 2) * y[V1]


@njit(cache=True, error_model="numpy")
def cartesian_slip(y):
    """Return a state (STATE_SIZE,) with its polar slip replaced by the components along a_1, a_2."""
    out = y.copy()
    out[V1], out[V2] = y[V1] * np.cos(y[V2]), y[V1] * np.sin(y[V2])
    return out


@njit(cache=True, error_model="numpy")
def write_cartesian_powers(c, states, rates, dt, place, out):
    """Write the powers of time of a step c, with slip along a_1, a_2, into `out` (shape of c).

    The slip is exact at 0 and at `place`."""
    end = np.empty(STATE_SIZE)
    slip = np.empty((ORDER, 2))
    for j in range(ORDER):
        gain = rates[j, V1]
        turn = states[j, V1] * rates[j, V2]
        cos = np.cos(states[j, V2])
        sin = np.sin(states[j, V2])
        slip[j, 0], slip[j, 1] = gain * cos - turn * sin, gain * sin + turn * cos
    powers = np.dot(CHEBYSHEV_TO_POWERS, dt * np.dot(INTEGRAL_SERIES, slip))
    for j in range(ORDER + 1):
        copy_into(c[j], out[j])
        copy_into(powers[j], out[j, V1 : V2 + 1])
    copy_into(cartesian_slip(c[0]), out[0])
    evaluate_polynomial(c, place, end)
    wanted = cartesian_slip(end)
    evaluate_polynomial(out, place, end)
    for a in (V1, V2):
        out[1, a] += (wanted[a] - end[a]) / place
    for j in range(ORDER + 1):
        copy_into(out[j] / dt**j, out[j])


@njit(cache=True, error_model="numpy")
def slowest_time(c, low, high):
    """Return the place in [low, high] of the least speed on the curve c; the speed falls at low and
    rises at high."""
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if speed_derivative(c, middle) < 0 else (low, middle)
    return low


@njit(cache=True, error_model="numpy")
def speed_derivative(c, x):
    """Return the derivative at x of the speed on the curve c."""
    slope = 0.0
    for j in range(ORDER, 0, -1):
        slope = slope * x + j * c[j, V1]
    return slope


@njit(cache=True, error_model="numpy")
def first_guard_crossing(flow, p, c, count, before, guards):
    """Return the place in [0, 1] of the first fall of one of `count` guards on the curve c, and its
    index.

    If none falls, return 1, -1. `before` contains the guards at 0, `guards` those at the nodes and
    the end. The guards are also evaluated at a minimum of the slip speed. A guard not positive at 0
    cannot fall."""
    place = 1.0
    fired = -1
    low = 0.0
    y = np.empty(STATE_SIZE)
    rates = np.empty(STATE_SIZE)
    now = np.empty(MAX_GUARDS)
    slope = speed_derivative(c, low)
    for look in range(ORDER + 1):
        high = COLLOCATION_NODES[look] if look < ORDER else 1.0
        fell = slope < 0
        slope = speed_derivative(c, high)
        if fell and slope > 0:
            dip = slowest_time(c, low, high)
            evaluate_polynomial(c, dip, y)
            flow(y, p, rates, now)
            place, fired = guard_crossing_between(flow, p, c, count, before, now, low, dip)
            if fired >= 0:
                break
            low = dip
            before = now
        place, fired = guard_crossing_between(flow, p, c, count, before, guards[look], low, high)
        if fired >= 0:
            break
        low = high
        before = guards[look]
    return place, fired


@njit(cache=True, error_model="numpy")
def reverse_nutation(flow, p, y, slope, before, count, turn):
    """Reverse the nutation, at rest in y; return True if it clearly continues and no other guard is
    at zero.

    The sense of nutation in p changes. `slope` and the guards `before` are filled; `turn` is the
    index of the guard of this reversal."""
    y[W1] = 0.0
    p[NUTATION_SENSE_INDEX] = -p[NUTATION_SENSE_INDEX]
    flow(y, p, slope, before)
    for i in range(count):
        if i != turn and not before[i] > 0:
            return False
    return p[NUTATION_SENSE_INDEX] * slope[W1] > MIN_REVERSAL_ACCELERATION


@njit(cache=True, error_model="numpy")
def starts_sliding(before, guards, count, grip):
    """Return True if a step from rest leads into the slide: each guard at zero `before` it is
    positive at its first node."""
    leads = True
    for i in range(count):
        leads &= before[i] > 0 or guards[0, i] > (-REST_SLIP_SPEED if i == grip else 0.0)
    return leads


FLOW_TYPE = types.FunctionType(FLOW_SIGNATURE)
INDEX_TYPE = types.int64
NUMBER_TYPE = types.float64
RESULT_TYPE = types.Tuple(
    (ARRAY_TYPE, types.float64[:, :, ::1], ARRAY_TYPE, INDEX_TYPE, INDEX_TYPE[::1])
)
INTEGRATE_SIGNATURE = RESULT_TYPE(
    FLOW_TYPE, ARRAY_TYPE, ARRAY_TYPE, *[INDEX_TYPE] * 4, NUMBER_TYPE, NUMBER_TYPE, INDEX_TYPE
)
"""Signature of `integrate`."""


def integrate(flow, y, p, count, grip, load, turn, mu, span, most):
    """Integrate a slow slide from y (STATE_SIZE,) until a guard falls, for `span`, while it is slow, or
    for `most` steps.

    `grip`, `load` and `turn` are the indices of slip speed, normal force and reversal of nutation
    among the `count` guards. After a clear reversal the slide continues with the other sense.

    Returns the ends of the steps (n,), their Taylor coefficients (n, ORDER + 1, STATE_SIZE), the last
    state (STATE_SIZE,) with the slip along a_1, a_2, the index of the guard (-1 if none), and the number
    of steps before each reversal. If no step is short enough, it returns the steps before this
    point, possibly none. There are also none if the slide is not slow, or if it starts at rest and
    never exceeds STOP_SPEED; in the latter case the guard is `grip`."""
    times = np.empty(most)
    coefficients = np.empty((most, ORDER + 1, STATE_SIZE))
    slope = np.empty(STATE_SIZE)
    states = np.empty((ORDER, STATE_SIZE))
    rates = np.empty((ORDER, STATE_SIZE))
    before = np.empty(MAX_GUARDS)
    guards = np.empty((ORDER + 1, MAX_GUARDS))
    turns = np.empty(most, np.int64)
    t = 0.0
    n = 0
    fired = -1
    turned = 0
    p = p.copy()
    flow(y, p, slope, before)
    rests = y[V1] == 0
    slow = rests or is_slow(y[V1], slip_times_acceleration(y, slope), mu * before[load])
    length = FIRST_STEP_FROM_REST if rests else first_step_length(flow, p, y, slope)
    while n < most and t < span and fired < 0 and slow and length >= MIN_STEP:
        dt = min(length * y[R], span - t)
        c, error = collocation_step(flow, p, y, slope, dt, states, rates, guards)
        if not error < 1 or (rests and not starts_sliding(before, guards, count, grip)):
            length *= 0.8 * error ** (-1 / ORDER) if 1 <= error < np.inf else STEP_REDUCTION
            continue
        place, fired = first_guard_crossing(flow, p, c, count, before, guards)
        if rests and not np.max(guards[:, grip]) > STOP_SPEED:
            fired = grip
            break
        write_cartesian_powers(c, states, rates, dt, place, coefficients[n])
        t = span if fired < 0 and dt == span - t else t + place * dt
        times[n], n, rests = t, n + 1, False
        length = min(max(MIN_STEP_GROWTH, error ** (-1 / 3)) * length, MAX_STEP)
        stay = SLOW_SLIDE_HYSTERESIS
        evaluate_polynomial(c, place, y)
        if fired == turn >= 0 and reverse_nutation(flow, p, y, slope, before, count, turn):
            turns[turned], turned, fired = n, turned + 1, -1
            length = first_step_length(flow, p, y, slope)
            stay = 1.0
        flow(y, p, slope, before)
        slow = is_slow(y[V1] / stay, slip_times_acceleration(y, slope) / stay**2, mu * before[load])
        if (
            fired < 0 and not slow and before[grip] < STOP_SPEED
        ):  # it stops too fast to count as slow, and no guard can fall any more
            fired = grip
    return (
        times[:n].copy(),
        coefficients[:n].copy(),
        cartesian_slip(y),
        fired,
        turns[:turned].copy(),
    )
