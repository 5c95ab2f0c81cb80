"""Selection of the next regime by (3.2), (3.3), and the first and last steps of slides.

At zero, the sign function may have any value in [-1, 1] (Filippov). The contact can
roll or slide, and each omega.a_i = 0 can stick or acquire either sign. A combination is
a valid continuation if its accelerations and loads are consistent with it.
"""

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np

from dynamics.equations import (
    NO_LOADS,
    ContactSolution,
    DiskConstants,
    separation_acceleration,
)
from dynamics.guards import Guard, GuardKind
from dynamics.hybrid import Arc, StalledError, Step
from dynamics.incipient_slip import slip_acceleration
from dynamics.regime import (
    FLOAT_FORMULAS,
    V1,
    V2,
    W1,
    W2,
    W3,
    Branch,
    R,
    Regime,
    StateVector,
    angular_velocity,
    describe_state,
    rotation_rates,
    slip_velocity,
)

AdvanceGrazing = Callable[[StateVector, float, Regime], "Arc | None"]
"""Function that integrates a slide from rest along a direction [rad], see
`slow_slides.advance_grazing_slide`."""

CONSISTENCY_TOLERANCE = 1e-12
"""Relative tolerance of the consistency conditions, for rounding errors."""
FIRST_SLIDE_STEP = 3e-6
"""Length of the first step of a slide in units of r, and limit of the relative change
of the state within it. The error, FIRST_SLIDE_STEP cubed, is below round-off."""

MAX_GRAZING_ACCELERATION = 0.05
"""Initial acceleration of a slide, divided by the friction, below which it starts with
the long steps of slow_slides.py."""


class ImpossibleContactError(ValueError):
    """No contact state satisfies the balance laws (Painleve paradox).

    It is also raised if the laws are undefined at the release. The message contains
    time and state.

    Examples
    --------
    >>> from dynamics import ImpossibleContactError
    >>> issubclass(ImpossibleContactError, ValueError)
    True
    """


class NoContactAtReleaseError(ImpossibleContactError):
    """The disk does not roll at its release: it leaves the table, or is too steep."""


def next_regime(
    y: StateVector,
    constants: DiskConstants,
    loads: Any,
    at_zero: frozenset[int],
    fired: frozenset[int],
    senses: tuple[float, float, float],
    advance_grazing: AdvanceGrazing,
) -> tuple[Regime | None, Step | Arc | None]:
    """Return the next regime at state y, and its first step or arc from rest.

    `at_zero` contains the quantities that are zero: 0 for the slip, i for omega.a_i.
    `fired` contains those that cannot remain zero. `advance_grazing(y, nu, regime)`
    integrates a slide that starts along nu with less than MAX_GRAZING_ACCELERATION, or
    returns None. Both results are None if the disk leaves the plane. Raises
    ImpossibleContactError if the disk presses on the plane, but no regime is
    consistent.
    """
    for leaving in (fired, frozenset()) if fired else (fired,):
        for regime in _candidate_regimes(y, constants, at_zero, leaving, senses):
            branch = Branch.of(regime, constants, loads)
            if regime.sliding and 0 in at_zero:
                step = _slide_from_rest(
                    y, regime, branch, constants, at_zero, advance_grazing
                )
                if step:
                    return regime, step
            elif _is_consistent(
                y,
                contact := FLOAT_FORMULAS.contact(y, branch, regime.senses, constants),
                regime,
                constants,
                at_zero,
            ):
                return regime, _heun_step(
                    y, contact, regime, branch, constants
                ) if leaving - {0} else None
    if _leaves_table_plane(y, constants, loads):
        return None, None
    raise ImpossibleContactError(
        f"{describe_state(y)}: no rolling, sliding or sticking contact with a compressive "
        f"force satisfies the balance laws"
    )


def state_after_reversal(
    y: StateVector,
    regime: Regime,
    branch: Branch,
    guard: Guard,
    constants: DiskConstants,
) -> tuple[list[Any], Regime] | None:
    """Return state and regime after a rotation of a rolling disk reverses.

    `next_regime` would try this regime first. Returns None if it is not consistent, or
    for any other guard.
    """
    if guard.kind is not GuardKind.REVERSES or regime.sliding or any(regime.stuck):
        return None
    y = with_rotation_zero(y, guard.axis)
    axis = guard.axis
    first, second, third = (
        -sense if i == axis else sense for i, sense in enumerate(regime.senses)
    )
    senses = (first, second, third)
    after = Regime(False, regime.stuck, senses)
    contact = FLOAT_FORMULAS.contact(y, branch, senses, constants)
    return (
        (y, after)
        if _is_consistent(y, contact, after, constants, (axis + 1,))
        else None
    )


def with_rotation_zero(y: StateVector, i: int) -> list[float]:
    """Return y with omega.a_(i+1) set to zero."""
    y = list(y)
    if i == 0:
        y[W1] = 0.0
        return y
    sin_a = math.cos(y[R] ** 2)
    cos_a = math.sin(y[R] ** 2)
    excess = rotation_rates(y)[i]
    along2, along3 = (cos_a, -sin_a) if i == 1 else (sin_a, cos_a)
    y[W2] = y[W2] - excess * along2
    y[W3] = y[W3] - excess * along3
    return y


def _leaves_table_plane(y: StateVector, constants: DiskConstants, loads: Any) -> bool:
    """Return True if a free disk would leave the plane, or just touch it."""
    beta = y[R] * y[R]
    omega = angular_velocity(y)
    applied = NO_LOADS
    if loads:
        applied = loads(beta, omega, slip_velocity(y), constants, FLOAT_FORMULAS)
    return (
        separation_acceleration(beta, *omega, constants, applied)
        > -CONSISTENCY_TOLERANCE
    )


def _candidate_regimes(
    y: StateVector,
    constants: DiskConstants,
    at_zero: frozenset[int],
    leaving: frozenset[int],
    senses: tuple[float, float, float],
) -> list[Regime]:
    """Return the regimes to try, in order.

    Rolling precedes sliding. For a rotation at zero, the order is reversed sign,
    sticking, old sign.
    """
    turn1, turn2, turn3 = rotation_rates(y)
    turning = (
        0.0 if 1 in at_zero else math.copysign(1.0, turn1),
        0.0 if 2 in at_zero else math.copysign(1.0, turn2),
        0.0 if 3 in at_zero else math.copysign(1.0, turn3),
    )
    resisted = tuple([arm > 0 for arm in constants.arms])
    return _regime_combinations(
        turning, senses, resisted, constants.mu_static < math.inf, 0 in at_zero, leaving
    )


@lru_cache(1024)
def _regime_combinations(
    turning: tuple[float, float, float],
    senses: tuple[float, float, float],
    resisted: tuple[bool, bool, bool],
    can_slip: bool,
    at_rest: bool,
    leaving: frozenset[int],
) -> list[Regime]:
    """Return the regimes to try for the new and old signs of the rotations."""
    contact = (
        [False]
        if not can_slip
        else [True]
        if not at_rest or 0 in leaving
        else [False, True]
    )
    surfaces: list[Any] = []
    for i, sign in enumerate(turning):
        if not resisted[i]:
            surfaces.append([(False, 1.0)])
        elif sign:
            surfaces.append([(False, sign)])
        else:
            stick = [] if i + 1 in leaving else [(True, 1.0)]
            surfaces.append([(False, -senses[i]), *stick, (False, senses[i])])
    regimes = []
    for sliding in contact:
        for choice in product(*surfaces):
            regimes.append(Regime(sliding, *zip(*choice, strict=True)))
    return regimes


def _is_consistent(
    y: StateVector,
    contact: ContactSolution,
    regime: Regime,
    constants: DiskConstants,
    at_zero: frozenset[int] | tuple[int],
) -> bool:
    """Return True if a contact presses and is consistent with its regime."""
    if not (contact.Phi > 0 and contact.inertia > 0):
        return False
    cone = constants.mu_static * contact.Phi
    if (
        not regime.sliding
        and cone * cone * (1 + CONSISTENCY_TOLERANCE) < contact.F1**2 + contact.F2**2
    ):
        return False
    for i in (axis - 1 for axis in at_zero if axis):
        arm = constants.arms[i]
        if regime.stuck[i]:
            if abs(contact.moments[i]) > arm * contact.Phi * (
                1 + CONSISTENCY_TOLERANCE
            ):
                return False
        elif (
            arm > 0
            and regime.senses[i] * rotation_accelerations(y, contact)[i]
            < -CONSISTENCY_TOLERANCE
        ):
            return False
    return True


def rotation_accelerations(
    y: StateVector, contact: ContactSolution
) -> tuple[float, float, float]:
    """Return d(omega.a_i)/dtau, including the rotation of a_2 and a_3 about a_1."""
    r = y[R]
    sin_a = math.cos(r * r)
    cos_a = math.sin(r * r)
    turn1, turn2, turn3 = rotation_rates(y)
    w1 = r * turn1
    along2 = r * turn2
    along3 = r * turn3
    return (
        contact.domega1,
        contact.domega2 * cos_a - contact.domega3 * sin_a - w1 * along3,
        contact.domega2 * sin_a + contact.domega3 * cos_a + w1 * along2,
    )


def contact_at_release(
    y: list[float], regime: Regime, branch: Branch, constants: DiskConstants
) -> ContactSolution:
    """Solve the balance laws at the first state of a motion.

    A slide from rest has the first of its possible directions.
    """
    if branch.sliding and branch.can_grip and FLOAT_FORMULAS.slip_speed_over_r(y) == 0:
        return _contact_sliding_along(
            y,
            next(_slip_directions(y, regime, branch, constants)),
            regime,
            branch,
            constants,
        )
    return FLOAT_FORMULAS.contact(y, branch, regime.senses, constants)


def _contact_sliding_along(
    y: StateVector,
    angle: float,
    regime: Regime,
    branch: Branch,
    constants: DiskConstants,
) -> ContactSolution:
    """Solve the balance laws for a contact that starts to slide along `angle` [rad]."""
    direction = (math.cos(angle), math.sin(angle))
    return FLOAT_FORMULAS.contact_with_friction_along(
        y, slip_velocity(y), direction, branch, regime.senses, constants
    )


def _slip_directions(
    y: StateVector, regime: Regime, branch: Branch, constants: DiskConstants
) -> Iterator[float]:
    """Yield slip directions nu [rad] that are parallel to their own slip acceleration.

    The first is close to the direction in which static friction fails, if possible. All
    directions follow in descending order of acceleration.
    """
    push = slip_acceleration(y, branch, regime.senses, constants)
    if push.is_solvable:
        held = FLOAT_FORMULAS.contact(
            y, branch._replace(sliding=False), regime.senses, constants
        )
        near = push.aligned_direction_near(math.atan2(-held.F2, -held.F1))
        if (
            near is not None
            and push.acceleration_along(near, near) > -CONSISTENCY_TOLERANCE
        ):
            yield near
    speeds = sorted(
        ((push.acceleration_along(nu, nu), nu) for nu in push.aligned_directions()),
        reverse=True,
    )
    yield from (nu for speed, nu in speeds if speed > -CONSISTENCY_TOLERANCE)


def _slide_from_rest(
    y: StateVector,
    regime: Regime,
    branch: Branch,
    constants: DiskConstants,
    at_zero: frozenset[int],
    advance_grazing: AdvanceGrazing,
) -> Step | Arc | None:
    """Take the first step of a slide from rest; return None if it is inconsistent."""
    for nu in _slip_directions(y, regime, branch, constants):
        first = _contact_sliding_along(y, nu, regime, branch, constants)
        if _is_consistent(y, first, regime, constants, at_zero):
            push = math.hypot(first.du1, first.du2)
            if push < MAX_GRAZING_ACCELERATION * constants.mu_dynamic * first.Phi:
                step: Step | Arc | None = advance_grazing(y, nu, regime)
            else:
                step = _trapezoidal_step(y, nu, first, regime, branch, constants)
            if step:
                return step
    return None


def _trapezoidal_step(
    y: StateVector,
    nu: float,
    first: ContactSolution,
    regime: Regime,
    branch: Branch,
    constants: DiskConstants,
) -> Step:
    """Take one implicit trapezoidal step; the unknown is the slip direction at its end.

    This direction is that of the mean slip acceleration. Raises StalledError if there
    is none within 1 rad of nu.
    """
    slope = FLOAT_FORMULAS.rates(y, first, branch, constants)
    dt = _first_step_length(y, slope)
    ahead = [a + dt * b for a, b in zip(y, slope, strict=True)]

    ahead_push = slip_acceleration(ahead, branch, regime.senses, constants)
    direction = ahead_push.with_added_rate(
        complex(first.du1, first.du2)
    ).aligned_direction_near(nu)
    if direction is None:
        raise StalledError(
            f"{describe_state(y)}: the direction of the slide that starts here cannot be "
            "determined"
        )
    last = _contact_sliding_along(ahead, direction, regime, branch, constants)
    return _quadratic_step(
        regime, dt, y, slope, FLOAT_FORMULAS.rates(ahead, last, branch, constants)
    )


def _first_step_length(y: StateVector, slope: StateVector) -> float:
    """Return the step length, FIRST_SLIDE_STEP r, or less if y changes fast."""
    return FIRST_SLIDE_STEP / max(
        1 / y[R], *(abs(b) / (1 + abs(a)) for a, b in zip(y, slope, strict=True))
    )


def _heun_step(
    y: StateVector,
    first: ContactSolution,
    regime: Regime,
    branch: Branch,
    constants: DiskConstants,
    length: float | None = None,
) -> Step:
    """Take one step of Heun's method, in which a rotation that unsticks leaves zero."""
    slope = FLOAT_FORMULAS.rates(y, first, branch, constants)
    dt = length or _first_step_length(y, slope)
    ahead = [a + dt * b for a, b in zip(y, slope, strict=True)]
    after = FLOAT_FORMULAS.rates(
        ahead,
        FLOAT_FORMULAS.contact(ahead, branch, regime.senses, constants),
        branch,
        constants,
    )
    return _quadratic_step(regime, dt, y, slope, after)


def _quadratic_step(
    regime: Regime, dt: float, y: StateVector, slope: StateVector, after: StateVector
) -> Step:
    return Step(
        regime,
        dt,
        np.array(
            [y, slope, [(b - a) / (2 * dt) for a, b in zip(slope, after, strict=True)]]
        ),
    )


def slide_to_rest(
    y: StateVector, regime: Regime, constants: DiskConstants, loads: Any
) -> tuple[Step, bool]:
    """Return the last step of a slide, and True if it ends at rest.

    The direction of friction is chosen such that the slip vanishes at the end of the
    step; the error is of second order in the slip speed. If no direction decelerates
    the slip, a small step continues the slide, and the second result is False.
    """
    # length of the step beyond the guard, as a fraction of the time in which friction could
    # stop the slip
    guard_overshoot_fraction = 0.01
    branch = Branch.of(regime, constants, loads)
    speed = math.hypot(y[V1], y[V2])
    along = math.atan2(y[V2], y[V1])
    push = slip_acceleration(y, branch, regime.senses, constants).with_added_rate(
        y[W1] / 2 * complex(y[V1], y[V2])
    )
    stopping = [
        angle
        for angle in push.directions_parallel_to(along)
        if push.acceleration_along(angle, along) < 0
    ]
    if stopping:
        angle = min(stopping, key=lambda a: abs(a - along))
        slope = FLOAT_FORMULAS.rates(
            y,
            _contact_sliding_along(y, angle, regime, branch, constants),
            branch,
            constants,
        )
        return Step(
            regime,
            -speed * y[R] / push.acceleration_along(angle, along),
            np.array([y, slope]),
        ), True
    here = FLOAT_FORMULAS.contact(y, branch, regime.senses, constants)
    return _heun_step(
        y,
        here,
        regime,
        branch,
        constants,
        guard_overshoot_fraction * speed * y[R] / (constants.mu_dynamic * here.Phi),
    ), False
