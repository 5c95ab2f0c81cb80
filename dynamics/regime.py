"""Contact regimes, the flow within each, and the guards that end it.

The state stays regular as the disk approaches the table: it contains r = sqrt(inclination), the
angular velocity omega/r and the slip velocity u/r, all of order one while the inclination falls by
ten decades. The last five entries are quadratures: precession, spin, centre of mass, dissipated
energy."""

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from dynamics.equations import NO_LOADS, Contact, DiskConstants, equations_of_motion
from dynamics.guards import ALL_GUARDS, AXES, STOP_SPEED, Guard, GuardArguments
from dynamics.guards import MAX_FALL_RATE as MAX_FALL_RATE
from dynamics.kinematics import centre_velocity, contact_arms, precession_rate

R, W1, W2, W3, V1, V2, PRECESSION, SPIN, X, Y, DISSIPATED = range(11)


class Regime(NamedTuple):
    """Active branches of the set-valued laws.

    They are rolling or sliding, and the sign or the sticking of each omega.a_i.
    """

    sliding: bool
    stuck: tuple[bool, bool, bool]
    senses: tuple[float, float, float]

    def __str__(self) -> str:
        """Return 'roll' or 'slide', and the rotations that stick: 'roll, nutation sticks'."""
        return _name(self.sliding, self.stuck)


@cache
def _name(sliding, stuck):
    sticking = [f"{axis} sticks" for axis, sticks in zip(AXES, stuck, strict=True) if sticks]
    return ", ".join(["slide" if sliding else "roll", *sticking])


class Branch(NamedTuple):
    """Properties of a regime and a scene that select the formulas of the flow.

    The constants of the scene are not included.
    """

    sliding: bool
    stuck: tuple[bool, bool, bool]
    resisted: tuple[bool, bool, bool]
    can_slip: bool
    can_grip: bool
    loads: Callable | None

    @classmethod
    def of(cls, regime: Regime, law: DiskConstants, loads: Callable | None) -> "Branch":
        """Return the branch of `regime` under `law`.

        A zero arm, infinite static friction or zero dynamic friction removes the corresponding
        guard."""
        arms = (law.k1 > 0, law.k2 > 0, law.k3 > 0)
        return cls(
            regime.sliding,
            regime.stuck,
            arms,
            law.mu_static < float("inf"),
            law.mu_dynamic > 0,
            loads,
        )


def projections(beta, w1, w2, w3, sin, cos):
    """Return omega.a_1, omega.a_2, omega.a_3 from the components along e_i (2.1)."""
    sin_a = cos(beta)
    cos_a = sin(beta)
    return w1, w2 * cos_a - w3 * sin_a, w2 * sin_a + w3 * cos_a


def rotation_rates(y) -> tuple[float, float, float]:
    """Return omega.a_i / r at a state y of floats."""
    return projections(y[R] * y[R], y[W1], y[W2], y[W3], math.sin, math.cos)


def describe_state(y) -> str:
    """Return a description of a state for messages."""
    r = y[R]
    omega = ", ".join(f"{r * y[i]:.6g}" for i in (W1, W2, W3))
    return f"inclination {r * r:.6g} rad, dimensionless omega ({omega}), slip ({r * y[V1]:.6g}, {r * y[V2]:.6g})"


class FlowFormulas:
    """The flow of every branch, for the scalar type of `sin`, `cos`, `sqrt` and `power`."""

    FUNCTIONS, SIZE = ("sin", "cos", "sqrt", "pow"), DISSIPATED + 1
    """Functions from which the flow is built, and the number of state components."""

    def __init__(self, sin, cos, sqrt, power):
        self.sin = sin
        self.cos = cos
        self.sqrt = sqrt
        self.power = power
        self.solve = equations_of_motion(sin, cos)

    def speed(self, y):
        """Return the slip speed divided by r."""
        return self.sqrt(y[V1] * y[V1] + y[V2] * y[V2])

    def grip(self, y):
        """Return the guard of a slide that comes to rest: slip speed divided by r, minus STOP_SPEED."""
        return self.speed(y) - STOP_SPEED

    def contact(self, y, branch: Branch, senses, law: DiskConstants) -> Contact:
        """Solve the balance laws at state y; the slip direction is that of y."""
        r = y[R]
        u1 = 0.0
        u2 = 0.0
        c = 0.0
        s = 0.0
        if branch.sliding:
            u1 = r * y[V1]
            u2 = r * y[V2]
            if branch.can_grip:  # without friction the direction has no meaning at rest
                speed = self.speed(y)
                c = y[V1] / speed
                s = y[V2] / speed
        return self.contact_along(y, (u1, u2), (c, s), branch, senses, law)

    def contact_along(
        self, y, slip, direction, branch: Branch, senses, law: DiskConstants
    ) -> Contact:
        """Solve the balance laws at state y with the slip direction given."""
        r = y[R]
        omega = (r * y[W1], r * y[W2], r * y[W3])
        loads = branch.loads(r * r, omega, slip, law, self) if branch.loads else NO_LOADS
        return self.solve(
            r * r, *omega, *slip, *direction, branch.sliding, *branch.stuck, *senses, law, loads
        )

    def rates(self, y, contact: Contact, branch: Branch, law: DiskConstants):
        """Return dy/dtau from the contact: (4.7) or (5.3), (2.3), (2.5) and the dissipated
        power."""
        r = y[R]
        w1 = y[W1]
        beta = r * r
        omega = (r * y[W1], r * y[W2], r * y[W3])
        sin_a = self.cos(beta)
        cos_a = self.sin(beta)
        slip = (r * y[V1], r * y[V2]) if branch.sliding else (0.0, 0.0)
        e, f = contact_arms(sin_a, cos_a, law.h)
        v1, v2 = centre_velocity(slip, omega, e, law.h)
        rate = precession_rate(omega[2], cos_a)
        ct = self.cos(y[PRECESSION])
        st = self.sin(y[PRECESSION])
        turns = projections(beta, w1, y[W2], y[W3], self.sin, self.cos)
        power = r * (contact.m1 * turns[0] + contact.m2 * turns[1] + contact.m3 * turns[2])
        if branch.sliding:
            power = power - contact.F1 * slip[0] - contact.F2 * slip[1]
        if branch.loads:
            loads = branch.loads(beta, omega, slip, law, self)
            power = power - loads.G1 * v1 - loads.G2 * v2 - loads.G3 * f * omega[0]
            power = power - loads.M1 * omega[0] - loads.M2 * omega[1] - loads.M3 * omega[2]
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
        self, y, contact: Contact, branch: Branch, senses, law: DiskConstants, r_end
    ) -> dict[Guard, Any]:
        """Return the guards of a branch with their values, positive while the regime is valid."""
        turns = projections(y[R] * y[R], y[W1], y[W2], y[W3], self.sin, self.cos)
        slip = self.grip(y) if branch.sliding and branch.can_grip else None
        where = GuardArguments(
            y[R], y[W1], y[W3], slip, turns, contact, senses, law, r_end, self.sqrt, self.cos
        )
        return {guard: guard.value(where) for guard in ALL_GUARDS if guard.acts(branch)}


FLOAT_FORMULAS = FlowFormulas(math.sin, math.cos, math.sqrt, math.pow)
ARRAY_FORMULAS = FlowFormulas(np.sin, np.cos, np.sqrt, np.power)
