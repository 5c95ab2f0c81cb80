"""Compiled implicit collocation of high order that stops at a guard, for
slow_slides.py.

A flow (FLOW_SIGNATURE in codegen.py) computes the rates and the guards of a state. The
slip is given in polar coordinates: the signed speed divided by r at V1, and the
direction at V2. The rate at V2 is the rate of the direction times the speed.
"""

from typing import NamedTuple

import numpy as np
from numba import types
from numpy.polynomial.chebyshev import cheb2poly, chebint, chebpts1, chebvander

from dynamics.equations import DiskConstants
from dynamics.guards import STOP_SLIP_SPEED
from dynamics.integrators import slow_slide_criterion
from dynamics.integrators.codegen import ARRAY_TYPE, FLOW_SIGNATURE
from dynamics.integrators.runge_kutta import (
    BISECTION_COUNT,
    MAX_GUARDS,
    STATE_SIZE,
    Flow,
    convert_to_powers_of_time,
    copy_state,
    evaluate_polynomial,
    guard_crossing_between,
)
from dynamics.numba_kernels import cached
from dynamics.regime import V1, V2, W1, R

ORDER = 14
COLLOCATION_NODES = (1 + chebpts1(ORDER)) / 2
"""Gauss-Chebyshev nodes on [0, 1]. They exclude the start, where the slip may be zero."""
INTEGRAL_SERIES = np.ascontiguousarray(
    chebint(
        np.linalg.inv(chebvander(2 * COLLOCATION_NODES - 1, ORDER - 1)),
        lbnd=-1,
        scl=0.5,
    )
)
"""Matrix from values at the nodes to the Chebyshev coefficients of the integral of
their interpolant."""
INTEGRAL_WEIGHTS = chebvander(2 * COLLOCATION_NODES - 1, ORDER) @ INTEGRAL_SERIES
CHEBYSHEV_TO_POWERS = np.zeros((ORDER + 1, ORDER + 1))
for _k in range(ORDER + 1):
    CHEBYSHEV_TO_POWERS[: _k + 1, _k] = cheb2poly(np.eye(2 * _k + 1)[-1])[::2]
"""Matrix from Chebyshev coefficients on [0, 1] to powers of x; T_k(2 x - 1) = T_2k(sqrt
x)."""
MAX_STEP = 1.0
"""Greatest step length in units of r."""
MIN_STEP_LENGTH = 1e-12
"""Smallest step length in units of r."""
FIRST_STEP_FROM_REST = 0.4
"""Length of the first step of a slide that starts at rest, in units of r."""
SLOW_SLIDE_HYSTERESIS = 1.5
"""Factor on the limits of `is_slow_slide` for a slide in progress."""
STEP_TOLERANCE = 1e-12
DIFFERENCE_ANGLE = 1e-7
"""Step [rad] of the difference quotient in Newton's method; the iteration removes the
error of the quotient."""
NUTATION_SENSE_INDEX = len(DiskConstants._fields) - 1
"""Index of the sign of nutation among the constants of a flow (branch_formulas.py)."""
REST_SLIP_SPEED = 1e-13
"""Slip speed divided by r below which a slow slide is considered at rest."""


is_slow_slide = cached(slow_slide_criterion.is_slow_slide)


@cached
def slip_direction_jacobian(
    flow: Flow,
    p: np.ndarray,
    states: np.ndarray,
    rates: np.ndarray,
    guard_values: np.ndarray,
) -> np.ndarray:
    """Return d(rates)/d(direction) (ORDER, STATE_SIZE) from difference quotients."""
    out = np.empty((ORDER, STATE_SIZE))
    tilted = states.copy()
    for j in range(ORDER):
        tilted[j, V2] += DIFFERENCE_ANGLE
        flow(tilted[j], p, out[j], guard_values)
    return (out - rates) / DIFFERENCE_ANGLE


@cached
def inverse_newton_matrix(
    states: np.ndarray, dt: float, steer: np.ndarray
) -> np.ndarray:
    """Return the inverse (ORDER, ORDER) of Newton's matrix for the rates of the direction."""
    matrix = np.empty((ORDER, ORDER))
    for j in range(ORDER):
        for i in range(ORDER):
            matrix[j, i] = -dt * INTEGRAL_WEIGHTS[j, i] * steer[j, V2]
        matrix[j, j] += states[j, V1]
    return np.ascontiguousarray(np.linalg.inv(matrix))


@cached
def solve_collocation(
    flow: Flow,
    p: np.ndarray,
    y: np.ndarray,
    dt: float,
    states: np.ndarray,
    rates: np.ndarray,
    guards: np.ndarray,
) -> bool:
    """Solve the collocation equations from guessed states; return True if converged.

    The equations are states = y + dt INTEGRAL_WEIGHTS rates(states) for states (ORDER,
    STATE_SIZE). Newton's method solves for the direction, which is stiff. Picard's
    method solves for the other components, with a correction for the change of
    direction. On return, the rates at V2 are those of the direction itself.
    """
    iteration_tolerance = 1e-13
    max_iterations = 40
    # Index of the iteration in which the Jacobian is updated
    jacobian_update_iteration = 3
    jacobian_update_change = (
        1e-3  # change of the state above which the Jacobian is updated
    )
    last = iteration_tolerance
    steer = rates
    solved = np.empty((ORDER, ORDER))
    ahead = np.empty((ORDER, STATE_SIZE))
    turning = np.zeros(ORDER)
    wrong = np.empty(ORDER)
    change = np.empty(ORDER)
    turned = np.empty(ORDER)
    for attempt in range(max_iterations):
        for j in range(ORDER):
            flow(states[j], p, rates[j], guards[j])
        if attempt == 0 or (
            attempt == jacobian_update_iteration and last > jacobian_update_change
        ):
            steer = slip_direction_jacobian(flow, p, states, rates, guards[ORDER])
            if not np.isfinite(steer).all():  # a state is too far ahead
                return False
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
        if size * min(1.0, size / last) < iteration_tolerance:
            return True
        if not (size < last or attempt < jacobian_update_iteration):
            return False
        last = size
    return False


@cached
def collocation_step(
    flow: Flow,
    p: np.ndarray,
    y: np.ndarray,
    slope: np.ndarray,
    dt: float,
    states: np.ndarray,
    rates: np.ndarray,
    guards: np.ndarray,
) -> tuple[np.ndarray, float]:
    """Return the powers of a step from y, and its error divided by STEP_TOLERANCE.

    The powers (ORDER + 1, STATE_SIZE) are those of x in [0, 1]. The initial guess
    follows the `slope` at y with a constant direction. `states` and `rates` (ORDER,
    STATE_SIZE) are filled with values at the nodes, `guards` (ORDER + 1, MAX_GUARDS)
    with those at the nodes and the end. The error is the last Chebyshev coefficient, or
    infinite if the iteration does not converge.
    """
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
    copy_state(y, c[0])
    evaluate_polynomial(c, 1.0, end)
    flow(end, p, series[0], guards[ORDER])
    return c, dt * np.max(np.abs(series[ORDER])) / STEP_TOLERANCE + 1e-30


@cached
def first_step_length(
    flow: Flow, p: np.ndarray, y: np.ndarray, slope: np.ndarray
) -> float:
    """Return the length, in units of r, of a first step that resolves the relaxation."""
    # largest number of relaxation times in a step that the nodes resolve
    relaxation_times_per_step = 12.0
    tilted = y.copy()
    rates = np.empty(STATE_SIZE)
    guards = np.empty(MAX_GUARDS)
    tilted[V2] += DIFFERENCE_ANGLE
    flow(tilted, p, rates, guards)
    return min(
        MAX_STEP,
        relaxation_times_per_step
        * DIFFERENCE_ANGLE
        * y[V1]
        / (y[R] * abs(rates[V2] - slope[V2])),
    )


@cached
def slip_times_acceleration(y: np.ndarray, slope: np.ndarray) -> float:
    """Return slip speed times slip acceleration at a polar state (STATE_SIZE,).

    The speed is divided by r; `slope` contains the rates at the state.
    """
    return (y[R] * slope[V1] - y[W1] * y[V1] / 2) * y[V1]


@cached
def cartesian_slip(y: np.ndarray) -> np.ndarray:
    """Return a polar state (STATE_SIZE,) with its slip components along a_1, a_2."""
    out = y.copy()
    out[V1] = y[V1] * np.cos(y[V2])
    out[V2] = y[V1] * np.sin(y[V2])
    return out


@cached
def write_cartesian_powers(
    c: np.ndarray,
    states: np.ndarray,
    rates: np.ndarray,
    dt: float,
    place: float,
    out: np.ndarray,
) -> None:
    """Write the powers of time of a step c, with slip along a_1, a_2, into `out`.

    The slip is exact at 0 and at `place`.
    """
    end = np.empty(STATE_SIZE)
    slip = np.empty((ORDER, 2))
    for j in range(ORDER):
        gain = rates[j, V1]
        turn = states[j, V1] * rates[j, V2]
        cos = np.cos(states[j, V2])
        sin = np.sin(states[j, V2])
        slip[j, 0] = gain * cos - turn * sin
        slip[j, 1] = gain * sin + turn * cos
    powers = np.dot(CHEBYSHEV_TO_POWERS, dt * np.dot(INTEGRAL_SERIES, slip))
    for j in range(ORDER + 1):
        copy_state(c[j], out[j])
        out[j, V1] = powers[j, 0]
        out[j, V2] = powers[j, 1]
    copy_state(cartesian_slip(c[0]), out[0])
    evaluate_polynomial(c, place, end)
    wanted = cartesian_slip(end)
    evaluate_polynomial(out, place, end)
    for a in (V1, V2):
        out[1, a] += (wanted[a] - end[a]) / place
    convert_to_powers_of_time(out, dt)


@cached
def min_slip_speed_position(c: np.ndarray, low: float, high: float) -> float:
    """Return the position in [low, high] of the minimum speed on the curve c.

    The speed falls at `low` and rises at `high`.
    """
    for _ in range(BISECTION_COUNT):
        middle = (low + high) / 2
        if speed_derivative(c, middle) < 0:
            low = middle
        else:
            high = middle
    return low


@cached
def speed_derivative(c: np.ndarray, x: float) -> float:
    """Return the derivative at x of the speed on the curve c."""
    slope = 0.0
    for j in range(ORDER, 0, -1):
        slope = slope * x + j * c[j, V1]
    return slope


@cached
def first_guard_crossing(
    flow: Flow,
    p: np.ndarray,
    c: np.ndarray,
    count: int,
    before: np.ndarray,
    guards: np.ndarray,
) -> tuple[float, int]:
    """Return position and index of the first guard that falls in [0, 1] on the curve c.

    If none of the `count` guards falls, return 1, -1. `before` contains the guards at
    0, `guards` those at the nodes and the end. They are also evaluated at minima of the
    slip speed. A guard that is not positive at 0 cannot fall.
    """
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
            dip = min_slip_speed_position(c, low, high)
            evaluate_polynomial(c, dip, y)
            flow(y, p, rates, now)
            place, fired = guard_crossing_between(
                flow, p, c, count, before, now, low, dip
            )
            if fired >= 0:
                break
            low = dip
            before = now
        place, fired = guard_crossing_between(
            flow, p, c, count, before, guards[look], low, high
        )
        if fired >= 0:
            break
        low = high
        before = guards[look]
    return place, fired


@cached
def reverse_nutation(
    flow: Flow,
    p: np.ndarray,
    y: np.ndarray,
    slope: np.ndarray,
    before: np.ndarray,
    count: int,
    turn: int,
) -> bool:
    """Reverse the nutation; return True if it clearly continues without another event.

    The sign of nutation in p changes, and its rate in y is set to zero. `slope` and the
    guards `before` are filled; `turn` is the index of the guard of this reversal.
    """
    # smallest rate of change of omega_1/r for which the reversal is clear
    min_reversal_acceleration = 1e-6
    y[W1] = 0.0
    p[NUTATION_SENSE_INDEX] = -p[NUTATION_SENSE_INDEX]
    flow(y, p, slope, before)
    for i in range(count):
        if i != turn and not before[i] > 0:
            return False
    return p[NUTATION_SENSE_INDEX] * slope[W1] > min_reversal_acceleration


@cached
def step_enters_slide(
    before: np.ndarray, guards: np.ndarray, count: int, grip: int
) -> bool:
    """Return True if a step from rest enters the slide.

    Each guard must be positive `before` the step or at its first node.
    """
    leads = True
    for i in range(count):
        leads &= before[i] > 0 or guards[0, i] > (
            -REST_SLIP_SPEED if i == grip else 0.0
        )
    return leads


@cached
def reduced_length(length: float, error: float) -> float:
    """Return the length of the next attempt after a step that does not converge."""
    reduction = 0.3  # if the error is unknown
    return length * (0.8 * error ** (-1 / ORDER) if 1 <= error < np.inf else reduction)


@cached
def next_length(length: float, error: float) -> float:
    """Return the length of the step after a successful one."""
    min_growth = 2.5  # factor within which transients decay
    return min(max(min_growth, error ** (-1 / 3)) * length, MAX_STEP)


class GuardIndices(NamedTuple):
    """Number of guards of a slow slide, and indices of three of them.

    They are those of slip speed, normal force and reversal of nutation (-1 if absent).
    """

    guard_count: int
    grip: int
    load: int
    turn: int


FLOW_TYPE = types.FunctionType(FLOW_SIGNATURE)
INDEX_TYPE = types.int64
NUMBER_TYPE = types.float64
RESULT_TYPE = types.Tuple(
    (ARRAY_TYPE, types.float64[:, :, ::1], ARRAY_TYPE, INDEX_TYPE, INDEX_TYPE[::1])
)
INTEGRATE_SIGNATURE = RESULT_TYPE(
    FLOW_TYPE,
    ARRAY_TYPE,
    ARRAY_TYPE,
    types.NamedUniTuple(INDEX_TYPE, len(GuardIndices._fields), GuardIndices),
    NUMBER_TYPE,
    NUMBER_TYPE,
    INDEX_TYPE,
)
"""Signature of `integrate_slow_slide`."""


def integrate_slow_slide(
    flow: Flow,
    y: np.ndarray,
    p: np.ndarray,
    indices: GuardIndices,
    mu: float,
    span: float,
    max_steps: int,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int, np.ndarray]:
    """Integrate a slow slide from y (STATE_SIZE,) until a guard falls, or for `span`.

    It takes at most `max_steps` steps and ends early if the slide is no longer slow or
    no step is short enough. The `indices` are `GuardIndices`. After a clear reversal the
    slide continues with the other sign of nutation.

    Returns the end times of the steps (n,), their Taylor coefficients (n, ORDER + 1,
    STATE_SIZE), the last state (STATE_SIZE,) with the slip along a_1, a_2, the index of
    the guard (-1 if none), and the number of steps before each reversal. There are no
    steps if the slide is not slow, or if it starts at rest and never exceeds
    STOP_SLIP_SPEED; in the latter case the guard is `grip`.
    """
    times = np.empty(max_steps)
    coefficients = np.empty((max_steps, ORDER + 1, STATE_SIZE))
    slope = np.empty(STATE_SIZE)
    stages = np.empty((2, ORDER, STATE_SIZE))  # states and rates
    before = np.empty(MAX_GUARDS)
    guards = np.empty((ORDER + 1, MAX_GUARDS))
    turns = np.empty(max_steps, np.int64)
    t = 0.0
    n = 0
    fired = -1
    turned = 0
    p = p.copy()
    flow(y, p, slope, before)
    rests = y[V1] == 0
    slow = rests or is_slow_slide(
        y[V1], slip_times_acceleration(y, slope), mu * before[indices.load]
    )
    length = FIRST_STEP_FROM_REST if rests else first_step_length(flow, p, y, slope)
    while (
        n < max_steps and t < span and fired < 0 and slow and length >= MIN_STEP_LENGTH
    ):
        dt = min(length * y[R], span - t)
        c, error = collocation_step(flow, p, y, slope, dt, stages[0], stages[1], guards)
        if not error < 1 or (
            rests
            and not step_enters_slide(before, guards, indices.guard_count, indices.grip)
        ):
            length = reduced_length(length, error)
            continue
        place, fired = first_guard_crossing(
            flow, p, c, indices.guard_count, before, guards
        )
        if rests and not np.max(guards[:, indices.grip]) > STOP_SLIP_SPEED:
            fired = indices.grip
            break
        write_cartesian_powers(c, stages[0], stages[1], dt, place, coefficients[n])
        t = span if fired < 0 and dt == span - t else t + place * dt
        times[n] = t
        n += 1
        rests = False
        length = next_length(length, error)
        stay = SLOW_SLIDE_HYSTERESIS
        evaluate_polynomial(c, place, y)
        if fired == indices.turn >= 0 and reverse_nutation(
            flow, p, y, slope, before, indices.guard_count, indices.turn
        ):
            turns[turned] = n
            turned += 1
            fired = -1
            length = first_step_length(flow, p, y, slope)
            stay = 1.0
        flow(y, p, slope, before)
        slow = is_slow_slide(
            y[V1] / stay,
            slip_times_acceleration(y, slope) / stay**2,
            mu * before[indices.load],
        )
        if (
            fired < 0 and not slow and before[indices.grip] < STOP_SLIP_SPEED
        ):  # it stops too fast to be slow, and its guards can no longer fall
            fired = indices.grip
    return (
        times[:n].copy(),
        coefficients[:n].copy(),
        cartesian_slip(y),
        fired,
        turns[:turned].copy(),
    )
