"""Implicit high-order steps up to a guard, in machine code: collocation for slow_slides.py.

A flow, of the type FLOW of codegen.py, computes the rates and the guards of a state. The slip of a
state is polar: signed speed over r at V1, direction at V2. The rate at V2 is that of the direction
times the speed."""

import numpy as np
from numba import njit, types
from numpy.polynomial.chebyshev import cheb2poly, chebint, chebpts1, chebvander

from dynamics.equations import Law
from dynamics.integrators import slow_slide_criterion
from dynamics.integrators.codegen import FLOW, ROW
from dynamics.integrators.runge_kutta import GUARDS, HALVINGS, at, fall_between, write
from dynamics.regime import DISSIPATED, STOP_SPEED, V1, V2, W1, R

ORDER = 14
NODES = (1 + chebpts1(ORDER)) / 2
"""Gauss-Chebyshev points on [0, 1]; the start, where the slip may be at rest, is not among them."""
SERIES = np.ascontiguousarray(
    chebint(np.linalg.inv(chebvander(2 * NODES - 1, ORDER - 1)), lbnd=-1, scl=0.5)
)
"""Chebyshev coefficients (ORDER + 1, ORDER) of the integral of the polynomial through values at the
nodes."""
INTEGRAL = chebvander(2 * NODES - 1, ORDER) @ SERIES
TO_POWERS = np.zeros((ORDER + 1, ORDER + 1))
for _k in range(ORDER + 1):
    TO_POWERS[: _k + 1, _k] = cheb2poly(np.eye(2 * _k + 1)[-1])[::2]
"""Powers of x in the Chebyshev polynomials on [0, 1]: T_k(2 x - 1) = T_2k(sqrt x)."""
LENGTH, LONGEST = 0.4, 1.0
"""Length of the first step from rest, and of the longest step, in units of r."""
GROWTH, SHRINK = 2.5, 0.3
"""Least growth factor of a step, because transients decay within it, and reduction factor after a
failure to converge."""
RELAXED = 12.0
"""Number of relaxation times in the first step of a slide, the most that the nodes resolve."""
SHORTEST = 1e-12
ACCURACY = 1e-12
SETTLED, STEERED, MOST_TRIES = 1e-13, 3, 40
"""Tolerance of the iteration, the iteration in which the Jacobian is updated, and the maximum
number of iterations."""
STRAY = 1e-3
"""Change of the state above which the Jacobian is updated."""
TILT = 1e-7
"""Step [rad] of the difference quotient in Newton's method, which corrects its error."""
STAY = 1.5
"""Factor on the limits of SLOW and LAZY for a stiff slide in progress, as a hysteresis."""
MOST_STEPS, SIZE = 40, DISSIPATED + 1
SENSE = len(Law._fields)
"""Index of the sense of nutation among the constants of a flow (branch_formulas.py)."""
REST = 1e-13
"""Slip speed over r below which a slow slide is at rest; it is too slow for a last step along its
tangent."""
PLAIN = 1e-6
"""Least rate of change of omega_1/r for which a reversal of the nutation is decided here."""


is_slow = njit(cache=True, error_model="numpy")(slow_slide_criterion.is_slow)


@njit(cache=True, error_model="numpy")
def steering(flow, p, states, rates, spare):
    """Return the Jacobian d(rates)/d(direction) (ORDER, SIZE) at the nodes, by differences."""
    out = np.empty((ORDER, SIZE))
    tilted = states.copy()
    for j in range(ORDER):
        tilted[j, V2] += TILT
        flow(tilted[j], p, out[j], spare)
    return (out - rates) / TILT


@njit(cache=True, error_model="numpy")
def steered(states, dt, steer):
    """Return the inverse (ORDER, ORDER) of Newton's matrix for the rates of the direction."""
    matrix = np.empty((ORDER, ORDER))
    for j in range(ORDER):
        for i in range(ORDER):
            matrix[j, i] = -dt * INTEGRAL[j, i] * steer[j, V2]
        matrix[j, j] += states[j, V1]
    return np.ascontiguousarray(np.linalg.inv(matrix))


@njit(cache=True, error_model="numpy")
def settle(flow, p, y, dt, states, rates, guards):
    """Solve states = y + dt INTEGRAL rates(states) from guessed states (ORDER, SIZE); True if it
    converges.

    Only the direction is stiff. Newton's method solves for it, and Picard's method for the rest,
    corrected for the change of direction. At the end the rates at V2 are those of the direction
    itself."""
    last = SETTLED
    steer = rates
    solved = np.empty((ORDER, ORDER))
    ahead = np.empty((ORDER, SIZE))
    turning = np.zeros(ORDER)
    wrong = np.empty(ORDER)
    change = np.empty(ORDER)
    turned = np.empty(ORDER)
    for attempt in range(MOST_TRIES):
        for j in range(ORDER):
            flow(states[j], p, rates[j], guards[j])
        if attempt == 0 or (attempt == STEERED and last > STRAY):
            steer = steering(flow, p, states, rates, guards[ORDER])
            solved = steered(states, dt, steer)
        for j in range(ORDER):
            wrong[j] = rates[j, V2] - states[j, V1] * turning[j]
        np.dot(solved, wrong, change)
        np.dot(INTEGRAL, change, turned)
        for j in range(ORDER):
            turning[j] += change[j]
            for a in range(SIZE):
                rates[j, a] += steer[j, a] * (dt * turned[j])
            rates[j, V2] = turning[j]
        np.dot(INTEGRAL, rates, ahead)
        size = 0.0
        for j in range(ORDER):
            for a in range(SIZE):
                new = y[a] + dt * ahead[j, a]
                moved = abs(new - states[j, a])
                scale = max(1.0, abs(new))
                if not moved <= size * scale:
                    size = moved / scale
                states[j, a] = new
        if size * min(1.0, size / last) < SETTLED:
            return True
        if not (size < last or attempt < STEERED):
            return False
        last = size
    return False


@njit(cache=True, error_model="numpy")
def collocate(flow, p, y, slope, dt, states, rates, guards):
    """Return one step from y (SIZE,) as powers (ORDER + 1, SIZE) of x in [0, 1], and its error over
    ACCURACY.

    The first guess follows the `slope` at y with a constant direction. The arguments `states` and
    `rates` (ORDER, SIZE) are filled with values at the nodes, `guards` (ORDER + 1, GUARDS) with
    values at the nodes and the end. The error is the last Chebyshev coefficient, or infinite if the
    iteration does not converge."""
    c = np.zeros((ORDER + 1, SIZE))
    end = np.empty(SIZE)
    for j in range(ORDER):
        for a in range(SIZE):
            states[j, a] = y[a] + dt * NODES[j] * slope[a]
        states[j, V2] = y[V2]
    if not settle(flow, p, y, dt, states, rates, guards):
        return c, np.inf
    series = np.dot(SERIES, rates)
    c = dt * np.dot(TO_POWERS, series)
    write(y, c[0])
    at(c, 1.0, end)
    flow(end, p, series[0], guards[ORDER])
    return c, dt * np.max(np.abs(series[ORDER])) / ACCURACY + 1e-30


@njit(cache=True, error_model="numpy")
def first_length(flow, p, y, slope):
    """Return the length, in units of r, of a first step that resolves the relaxation."""
    tilted = y.copy()
    rates = np.empty(SIZE)
    guards = np.empty(GUARDS)
    tilted[V2] += TILT
    flow(tilted, p, rates, guards)
    return min(LONGEST, RELAXED * TILT * y[V1] / (y[R] * abs(rates[V2] - slope[V2])))


@njit(cache=True, error_model="numpy")
def change_of_square(y, slope):
    """Return the speed over r times the rate of the slip, at a polar state (SIZE,) with its
    `slope`."""
    return (y[R] * slope[V1] - y[W1] * y[V1] / 2) * y[V1]


@njit(cache=True, error_model="numpy")
def cartesian(y):
    """Return a state (SIZE,) with its polar slip replaced by the components along a_1, a_2."""
    out = y.copy()
    out[V1], out[V2] = y[V1] * np.cos(y[V2]), y[V1] * np.sin(y[V2])
    return out


@njit(cache=True, error_model="numpy")
def in_plane(c, states, rates, dt, place, out):
    """Write the powers of time of a step c, with slip along a_1, a_2, into `out` (shape of c).

    The slip is exact at 0 and at `place`."""
    end = np.empty(SIZE)
    slip = np.empty((ORDER, 2))
    for j in range(ORDER):
        gain = rates[j, V1]
        turn = states[j, V1] * rates[j, V2]
        cos = np.cos(states[j, V2])
        sin = np.sin(states[j, V2])
        slip[j, 0], slip[j, 1] = gain * cos - turn * sin, gain * sin + turn * cos
    powers = np.dot(TO_POWERS, dt * np.dot(SERIES, slip))
    for j in range(ORDER + 1):
        write(c[j], out[j])
        write(powers[j], out[j, V1 : V2 + 1])
    write(cartesian(c[0]), out[0])
    at(c, place, end)
    wanted = cartesian(end)
    at(out, place, end)
    for a in (V1, V2):
        out[1, a] += (wanted[a] - end[a]) / place
    for j in range(ORDER + 1):
        write(out[j] / dt**j, out[j])


@njit(cache=True, error_model="numpy")
def slowest(c, low, high):
    """Return the place in [low, high] of the least speed on the curve c; the speed falls at low and
    rises at high."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if slope_of_speed(c, middle) < 0 else (low, middle)
    return low


@njit(cache=True, error_model="numpy")
def slope_of_speed(c, x):
    """Return the derivative at x of the speed on the curve c."""
    slope = 0.0
    for j in range(ORDER, 0, -1):
        slope = slope * x + j * c[j, V1]
    return slope


@njit(cache=True, error_model="numpy")
def first_fall(flow, p, c, count, before, guards):
    """Return the place in [0, 1] of the first fall of one of `count` guards on the curve c, and its
    index.

    If none falls, return 1, -1. `before` contains the guards at 0, `guards` those at the nodes and
    the end. The guards are also evaluated at a minimum of the slip speed. A guard not positive at 0
    cannot fall."""
    place = 1.0
    fired = -1
    low = 0.0
    y = np.empty(SIZE)
    rates = np.empty(SIZE)
    now = np.empty(GUARDS)
    slope = slope_of_speed(c, low)
    for look in range(ORDER + 1):
        high = NODES[look] if look < ORDER else 1.0
        fell = slope < 0
        slope = slope_of_speed(c, high)
        if fell and slope > 0:
            dip = slowest(c, low, high)
            at(c, dip, y)
            flow(y, p, rates, now)
            place, fired = fall_between(flow, p, c, count, before, now, low, dip)
            if fired >= 0:
                break
            low = dip
            before = now
        place, fired = fall_between(flow, p, c, count, before, guards[look], low, high)
        if fired >= 0:
            break
        low = high
        before = guards[look]
    return place, fired


@njit(cache=True, error_model="numpy")
def reverses(flow, p, y, slope, before, count, turn):
    """Reverse the nutation, at rest in y; return True if it clearly continues and no other guard is
    at zero.

    The sense of nutation in p changes. `slope` and the guards `before` are filled; `turn` is the
    index of the guard of this reversal."""
    y[W1] = 0.0
    p[SENSE] = -p[SENSE]
    flow(y, p, slope, before)
    for i in range(count):
        if i != turn and not before[i] > 0:
            return False
    return p[SENSE] * slope[W1] > PLAIN


@njit(cache=True, error_model="numpy")
def starts(before, guards, count, grip):
    """Return True if a step from rest leads into the slide: each guard at zero `before` it is
    positive at its first node."""
    leads = True
    for i in range(count):
        leads &= before[i] > 0 or guards[0, i] > (-REST if i == grip else 0.0)
    return leads


CALL, INDEX, NUMBER = types.FunctionType(FLOW), types.int64, types.float64
FOUND = types.Tuple((ROW, types.float64[:, :, ::1], ROW, INDEX, INDEX[::1]))
STEPS = FOUND(CALL, ROW, ROW, *[INDEX] * 4, NUMBER, NUMBER, INDEX)
"""Signature of `integrate`."""


def integrate(flow, y, p, count, grip, load, turn, mu, span, most):
    """Integrate a slow slide from y (SIZE,) until a guard falls, for `span`, while it is slow, or
    for `most` steps.

    `grip`, `load` and `turn` are the indices of slip speed, normal force and reversal of nutation
    among the `count` guards. After a clear reversal the slide continues with the other sense.

    Returns the ends of the steps (n,), their Taylor coefficients (n, ORDER + 1, SIZE), the last
    state (SIZE,) with the slip along a_1, a_2, the index of the guard (-1 if none), and the number
    of steps before each reversal. If no step is short enough, it returns the steps before this
    point, possibly none. There are also none if the slide is not slow, or if it starts at rest and
    never exceeds STOP_SPEED; in the latter case the guard is `grip`."""
    times = np.empty(most)
    coefficients = np.empty((most, ORDER + 1, SIZE))
    slope = np.empty(SIZE)
    states = np.empty((ORDER, SIZE))
    rates = np.empty((ORDER, SIZE))
    before = np.empty(GUARDS)
    guards = np.empty((ORDER + 1, GUARDS))
    turns = np.empty(most, np.int64)
    t = 0.0
    n = 0
    fired = -1
    turned = 0
    p = p.copy()
    flow(y, p, slope, before)
    rests = y[V1] == 0
    slow = rests or is_slow(y[V1], change_of_square(y, slope), mu * before[load])
    length = LENGTH if rests else first_length(flow, p, y, slope)
    while n < most and t < span and fired < 0 and slow and length >= SHORTEST:
        dt = min(length * y[R], span - t)
        c, error = collocate(flow, p, y, slope, dt, states, rates, guards)
        if not error < 1 or (rests and not starts(before, guards, count, grip)):
            length *= 0.8 * error ** (-1 / ORDER) if 1 <= error < np.inf else SHRINK
            continue
        place, fired = first_fall(flow, p, c, count, before, guards)
        if rests and not np.max(guards[:, grip]) > STOP_SPEED:
            fired = grip
            break
        in_plane(c, states, rates, dt, place, coefficients[n])
        t = span if fired < 0 and dt == span - t else t + place * dt
        times[n], n, rests = t, n + 1, False
        length = min(max(GROWTH, error ** (-1 / 3)) * length, LONGEST)
        stay = STAY
        at(c, place, y)
        if fired == turn >= 0 and reverses(flow, p, y, slope, before, count, turn):
            turns[turned], turned, fired = n, turned + 1, -1
            length = first_length(flow, p, y, slope)
            stay = 1.0
        flow(y, p, slope, before)
        slow = is_slow(y[V1] / stay, change_of_square(y, slope) / stay**2, mu * before[load])
        if (
            fired < 0 and not slow and before[grip] < STOP_SPEED
        ):  # it stops too fast to count as slow, and no guard can fall any more
            fired = grip
    return times[:n].copy(), coefficients[:n].copy(), cartesian(y), fired, turns[:turned].copy()
