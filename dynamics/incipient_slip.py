"""Closed-form slip directions at the start and at the end of a slide.

By (4.6) and (5.3), the normal force during slip along (c, s) is P/(a + b s), and the
slip acceleration is linear in this force and in the friction. In complex notation, with
z = c + i s, the slip acceleration is du = (k + p z + q/z)/(a + b s).
"""

import cmath
import math
from typing import NamedTuple

import numpy as np

from dynamics.equations import ContactState, DiskConstants
from dynamics.kinematics import contact_arms
from dynamics.regime import (
    FLOAT_FORMULAS,
    Branch,
    R,
    StateVector,
    angular_velocity,
    slip_velocity,
)


class SlipAcceleration(NamedTuple):
    """Slip acceleration at one state as a function of the slip direction.

    The fields are the constants of the formula in the module docstring.
    """

    a: float
    b: float
    k: complex
    p: complex
    q: complex

    def with_added_rate(self, rate: complex) -> "SlipAcceleration":
        """Return the slip acceleration with the constant `rate` added."""
        turn = 0.5j * self.b * rate
        return SlipAcceleration(
            self.a, self.b, self.k + self.a * rate, self.p - turn, self.q + turn
        )

    @property
    def is_solvable(self) -> bool:
        """True if the balance laws determine a normal force for every slip direction."""
        return self.a > abs(self.b)

    def acceleration_along(self, angle: float, axis: float) -> float:
        """Return the acceleration along `axis` [rad] for slip along `angle` [rad]."""
        z = cmath.rect(1.0, angle)
        return ((self.k + self.p * z + self.q / z) * cmath.rect(1.0, -axis)).real / (
            self.a + self.b * z.imag
        )

    def aligned_direction_near(self, angle: float) -> float | None:
        """Return one of `aligned_directions` within 1 rad of `angle` [rad], or None."""
        found = self._slip_direction_near_angle(angle)
        if found is not None and abs(found - angle) <= 1:
            return found

        def distance(other: float) -> float:
            return abs(_wrapped_angle(other - angle))

        near = (other for other in self.aligned_directions() if distance(other) <= 1)
        return min(near, key=distance, default=None)

    def aligned_directions(self) -> list[float]:
        """Return the slip directions [rad] that are parallel to their acceleration."""
        k = self.k
        p = self.p
        q = self.q
        circle_tolerance = 1e-6  # exceeds the rounding error of a double root
        powers = np.array([-q.conjugate(), -k.conjugate(), p - p.conjugate(), k, q])
        roots = np.roots(powers)
        angles = map(
            self._slip_direction_near_angle,
            np.angle(roots[np.abs(np.abs(roots) - 1) < circle_tolerance]).tolist(),
        )
        return [
            nu for nu in angles if nu is not None and self.a + self.b * math.sin(nu) > 0
        ]

    def _slip_direction_near_angle(self, angle: float) -> float | None:
        """Return the aligned direction found by Newton's method, or None."""
        max_iterations = 12
        tolerance = 4e-15
        for _ in range(max_iterations):
            back = cmath.rect(1.0, -angle)
            once = self.k * back
            twice = self.q * back * back
            slope = (once + 2 * twice).real
            if slope == 0:
                return None
            move = (once + self.p + twice).imag / slope
            angle += move
            if abs(move) < tolerance:
                return angle
        return None

    def directions_parallel_to(self, axis: float) -> list[float]:
        """Return the slip directions [rad] that accelerate parallel to `axis` [rad]."""
        back = cmath.rect(1.0, -axis)
        turning = self.p * back - (self.q * back).conjugate()
        size, phase = cmath.polar(turning)
        share = (self.k * back).imag
        if not abs(share) <= size or size == 0:
            return []
        turn = math.asin(share / size)
        angles = (
            _wrapped_angle(-phase - turn - axis) + axis,
            _wrapped_angle(-phase + turn + math.pi - axis) + axis,
        )
        return [nu for nu in angles if self.a + self.b * math.sin(nu) > 0]


def _wrapped_angle(angle: float) -> float:
    """Return an angle reduced to [-pi, pi]."""
    return math.remainder(angle, 2 * math.pi)


def slip_acceleration(
    y: StateVector,
    branch: Branch,
    senses: tuple[float, float, float],
    constants: DiskConstants,
) -> SlipAcceleration:
    """Return the slip acceleration of a sliding branch at state y."""
    beta = y[R] * y[R]
    omega = angular_velocity(y)
    slip = slip_velocity(y)
    loads, constants = FLOAT_FORMULAS.loads_and_arms(y, slip, branch, constants)
    lever = contact_arms(math.cos(beta), math.sin(beta), constants.h, constants.fillet)[
        1
    ]
    side = math.copysign(1.0, lever)  # the sign for which the inertia is positive

    def pushed(c: float, s: float) -> tuple[float, complex]:
        state = ContactState(True, (c, s), branch.stuck, senses)
        contact = FLOAT_FORMULAS.solve(beta, omega, slip, state, constants, loads)
        return contact.inertia, contact.inertia * complex(contact.du1, contact.du2)

    a, k = pushed(0.0, 0.0)
    _, across = pushed(1.0, 0.0)
    inertia, along = pushed(0.0, side)
    across = across - k
    along = side * (along - k)
    return SlipAcceleration(
        a, side * (inertia - a), k, (across - 1j * along) / 2, (across + 1j * along) / 2
    )
