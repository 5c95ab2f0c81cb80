"""Contact regimes, the equations of motion in each, and the guards that end it.

The state is scaled so that it remains regular as the disk approaches the table: r =
sqrt(inclination), the angular velocity omega/r and the slip velocity u/r remain of
order one while the inclination decreases by ten decades. The other five entries are
quadratures: precession, spin, position of the centre (two) and dissipated energy.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from dynamics.equations import (
    NO_LOADS,
    ContactSolution,
    ContactState,
    DiskConstants,
    Loads,
    NumberOrExpression,
    equations_of_motion,
)
from dynamics.guards import ALL_GUARDS, AXES, STOP_SLIP_SPEED, Guard, GuardArguments
from dynamics.kinematics import centre_velocity, contact_place, precession_rate
from dynamics.pivoting import pivoting_arm

StateVector = Sequence[Any] | np.ndarray
"""State of a disk: numbers or symbolic expressions."""

R, W1, W2, W3, V1, V2, PRECESSION, SPIN, X, Y, DISSIPATED = range(11)


class Regime(NamedTuple):
    """Active branches of the set-valued laws (3.2) and (3.3).

    The contact rolls or slides, and each omega.a_i is either stuck at zero or has a
    sign.
    """

    sliding: bool
    stuck: tuple[bool, bool, bool]
    senses: tuple[float, float, float]

    def __str__(self) -> str:
        """Return the name of the regime, such as 'roll, nutation sticks'."""
        return _name(self.sliding, self.stuck)


@cache
def _name(sliding: bool, stuck: tuple[bool, bool, bool]) -> str:
    sticking = [
        f"{axis} sticks" for axis, sticks in zip(AXES, stuck, strict=True) if sticks
    ]
    return ", ".join(["slide" if sliding else "roll", *sticking])


class Branch(NamedTuple):
    """Properties of a regime and a scene that select the equations of motion.

    Numerical constants of the scene are not included.
    """

    sliding: bool
    stuck: tuple[bool, bool, bool]
    resisted: tuple[bool, bool, bool]
    can_slip: bool
    can_grip: bool
    loads: Any
    has_fillet: bool = False
    has_bowl: bool = False
    has_spin_friction: bool = False

    @classmethod
    def of(cls, regime: Regime, constants: DiskConstants, loads: Any) -> "Branch":
        """Return the branch for a regime and the constants of a scene.

        A zero arm, infinite static friction or zero dynamic friction removes a guard.
        """
        arms = (constants.k1 > 0, constants.k2 > 0, constants.k3 > 0)
        return cls(
            regime.sliding,
            regime.stuck,
            arms,
            constants.mu_static < float("inf"),
            constants.mu_dynamic > 0,
            loads,
            constants.fillet > 0,
            constants.bowl > 0,
            bool(constants.pivoting),
        )


def contact_axis_rates(
    beta: NumberOrExpression,
    w1: NumberOrExpression,
    w2: NumberOrExpression,
    w3: NumberOrExpression,
    sin: Callable[[NumberOrExpression], NumberOrExpression],
    cos: Callable[[NumberOrExpression], NumberOrExpression],
) -> tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression]:
    """Return omega.a_i, i = 1 to 3, from the components along e_i (2.1)."""
    sin_a = cos(beta)
    cos_a = sin(beta)
    return w1, w2 * cos_a - w3 * sin_a, w2 * sin_a + w3 * cos_a


def angular_velocity(y: StateVector) -> tuple[Any, Any, Any]:
    """Return the angular velocity omega along e_1, e_2, e_3 at a state y."""
    r = y[R]
    return r * y[W1], r * y[W2], r * y[W3]


def slip_velocity(y: StateVector) -> tuple[Any, Any]:
    """Return the slip velocity u along a_1, a_2 at a state y."""
    r = y[R]
    return r * y[V1], r * y[V2]


def rotation_rates(y: StateVector) -> tuple[float, float, float]:
    """Return omega.a_i/r, i = 1 to 3, at a state y of floats."""
    return contact_axis_rates(y[R] * y[R], y[W1], y[W2], y[W3], math.sin, math.cos)


def describe_state(y: StateVector) -> str:
    """Return a description of a state for error messages."""
    omega = ", ".join(f"{w:.6g}" for w in angular_velocity(y))
    slip = ", ".join(f"{u:.6g}" for u in slip_velocity(y))
    inclination = y[R] * y[R]
    return f"inclination {inclination:.6g} rad, dimensionless omega ({omega}), slip ({slip})"


def restart_quadratures(
    y: StateVector, keep_position: bool
) -> tuple[list[float], list[float]]:
    """Return y with the quadratures reset, and the subtracted offset.

    The precession is reduced to [-pi, pi]. The position is kept on a concave table,
    where the force depends on it. The other quadratures are set to zero.
    """
    turned = math.remainder(y[PRECESSION], 2 * math.pi)
    lost = [*[0.0] * PRECESSION, y[PRECESSION] - turned, *y[SPIN:]]
    if keep_position:
        lost[X] = 0.0
        lost[Y] = 0.0
    return [a - b for a, b in zip(y, lost, strict=True)], lost


class FlowFormulas:
    """Equations of motion of all branches, evaluated with the given functions.

    The functions determine the type of scalars: floats, arrays or symbols.
    """

    FUNCTIONS = ("sin", "cos", "sqrt", "pow")
    """Names of the functions that the equations require."""
    SIZE = DISSIPATED + 1
    """Number of state components."""

    def __init__(
        self,
        sin: Callable[[NumberOrExpression], NumberOrExpression],
        cos: Callable[[NumberOrExpression], NumberOrExpression],
        sqrt: Callable[[NumberOrExpression], NumberOrExpression],
        power: Callable[[NumberOrExpression, NumberOrExpression], NumberOrExpression],
    ) -> None:
        self.sin = sin
        self.cos = cos
        self.sqrt = sqrt
        self.power = power
        self.solve = equations_of_motion(sin, cos)

    def slip_speed_over_r(self, y: StateVector) -> NumberOrExpression:
        """Return the slip speed divided by r, |u|/r."""
        return self.sqrt(y[V1] * y[V1] + y[V2] * y[V2])

    def excess_slip_speed(self, y: StateVector) -> NumberOrExpression:
        """Return slip speed/r minus STOP_SLIP_SPEED, the value of the guard GRIP."""
        return self.slip_speed_over_r(y) - STOP_SLIP_SPEED

    def contact(
        self, y: StateVector, branch: Branch, senses: Any, constants: DiskConstants
    ) -> ContactSolution:
        """Solve the balance laws at state y with the slip direction of y."""
        slip = (0.0, 0.0)
        direction = (0.0, 0.0)
        if branch.sliding:
            slip = slip_velocity(y)
            if branch.can_grip:
                # without friction the direction is not needed, and undefined at rest
                speed = self.slip_speed_over_r(y)
                direction = (y[V1] / speed, y[V2] / speed)
        return self.contact_with_friction_along(
            y, slip, direction, branch, senses, constants
        )

    def contact_with_friction_along(
        self,
        y: StateVector,
        slip: tuple[NumberOrExpression, NumberOrExpression],
        direction: tuple[NumberOrExpression, NumberOrExpression],
        branch: Branch,
        senses: Any,
        constants: DiskConstants,
    ) -> ContactSolution:
        """Solve the balance laws at state y with a given slip direction."""
        r = y[R]
        omega = angular_velocity(y)
        loads, constants = self.loads_and_arms(y, slip, branch, constants)
        state = ContactState(branch.sliding, direction, branch.stuck, senses)
        return self.solve(r * r, omega, slip, state, constants, loads)

    def loads_and_arms(
        self,
        y: StateVector,
        slip: tuple[NumberOrExpression, NumberOrExpression],
        branch: Branch,
        constants: DiskConstants,
    ) -> tuple[Loads, DiskConstants]:
        """Return the loads at state y, and the constants with k3 from spin friction."""
        r = y[R]
        omega = angular_velocity(y)
        loads = (
            branch.loads(r * r, omega, slip, constants, self)
            if branch.loads
            else NO_LOADS
        )
        if constants.bowl != 0:
            ct = self.cos(y[PRECESSION])
            st = self.sin(y[PRECESSION])
            pull = (constants.K + 4) / 4 * constants.bowl
            east = y[X] + constants.bowl_x
            north = y[Y] + constants.bowl_y
            loads = loads._replace(
                G1=loads.G1 - pull * (east * ct + north * st),
                G2=loads.G2 - pull * (north * ct - east * st),
            )
        if constants.pivoting:
            sin_a = self.cos(r * r)
            cos_a = self.sin(r * r)
            place = contact_place(sin_a, cos_a, constants.h, constants.fillet)
            travel = centre_velocity(slip, omega, place)[0]
            travel = travel + place.f * precession_rate(omega[2], cos_a)
            arm = pivoting_arm(
                cos_a,
                omega[1] * sin_a + omega[2] * cos_a,
                travel,
                slip[0] * slip[0] + slip[1] * slip[1],
                branch.sliding,
                constants.mu_dynamic,
                constants.pivoting,
            )
            constants = constants._replace(k3=arm, pivoting=())
        return loads, constants

    def rates(
        self,
        y: StateVector,
        contact: ContactSolution,
        branch: Branch,
        constants: DiskConstants,
    ) -> list[NumberOrExpression]:
        """Return dy/dtau by (4.7) or (5.3), (2.3), (2.5) and the dissipated power."""
        r = y[R]
        w1 = y[W1]
        beta = r * r
        omega = angular_velocity(y)
        sin_a = self.cos(beta)
        cos_a = self.sin(beta)
        slip = slip_velocity(y) if branch.sliding else (0.0, 0.0)
        place = contact_place(sin_a, cos_a, constants.h, constants.fillet)
        v1, v2 = centre_velocity(slip, omega, place)
        rate = precession_rate(omega[2], cos_a)
        ct = self.cos(y[PRECESSION])
        st = self.sin(y[PRECESSION])
        turns = contact_axis_rates(beta, w1, y[W2], y[W3], self.sin, self.cos)
        power = r * (
            contact.m1 * turns[0] + contact.m2 * turns[1] + contact.m3 * turns[2]
        )
        if branch.sliding:
            power = power - contact.F1 * slip[0] - contact.F2 * slip[1]
        if branch.loads:
            loads = branch.loads(beta, omega, slip, constants, self)
            power = (
                power - loads.G1 * v1 - loads.G2 * v2 - loads.G3 * place.f * omega[0]
            )
            power = (
                power - loads.M1 * omega[0] - loads.M2 * omega[1] - loads.M3 * omega[2]
            )
        half = 0.5 * w1  # r' = -w1/2, so (omega/r)' = (omega' + omega w1 / (2 r)) / r
        return [
            -half,
            (contact.domega1 + half * w1) / r,
            (contact.domega2 + half * y[W2]) / r,
            (contact.domega3 + half * y[W3]) / r,
            (contact.du1 + half * y[V1]) / r if branch.sliding else 0.0 * r,
            (contact.du2 + half * y[V2]) / r if branch.sliding else 0.0 * r,
            rate,
            omega[1] - rate * sin_a,
            v1 * ct - v2 * st,
            v1 * st + v2 * ct,
            power,
        ]

    def guards(
        self,
        y: StateVector,
        contact: ContactSolution,
        branch: Branch,
        senses: Sequence[NumberOrExpression],
        constants: DiskConstants,
        r_end: NumberOrExpression,
    ) -> dict[Guard, Any]:
        """Return the guards of a branch with their values."""
        turns = contact_axis_rates(y[R] * y[R], y[W1], y[W2], y[W3], self.sin, self.cos)
        slip = self.excess_slip_speed(y) if branch.sliding and branch.can_grip else None
        where = GuardArguments(
            y[R],
            y[W1],
            y[W3],
            slip,
            turns,
            contact,
            senses,
            constants,
            r_end,
            self.sqrt,
            self.cos,
        )
        return {
            guard: guard.value(where)
            for guard in ALL_GUARDS
            if guard.applies_to(branch)
        }


FLOAT_FORMULAS = FlowFormulas(math.sin, math.cos, math.sqrt, math.pow)
ARRAY_FORMULAS = FlowFormulas(np.sin, np.cos, np.sqrt, np.power)
