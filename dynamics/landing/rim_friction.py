"""Friction and resisting moments of the rims of a disk that lands or tumbles.

Coulomb's friction acts at the centre of pressure of each rim, and on the rotation about
it where a long arc touches the table. Both are regularised at low speeds, so that a
rolling disk creeps slightly.
"""

from collections.abc import Sequence
from math import sqrt
from typing import TYPE_CHECKING, NamedTuple

from dynamics.pivoting import pivoting_arm

if TYPE_CHECKING:
    from dynamics.landing.equations import Geometry, LandingLoads, LandingModel
    from dynamics.landing.stop import StopForces

MIN_POWER_LAW_SLOPE = 1e-4
"""Sine of the inclination below which the power laws no longer grow: the rim touches the
table along an arc."""


class RimLoads(NamedTuple):
    """Friction and resisting moments, in the directions of the equations.

    Attributes
    ----------
    force_u, force_q : float
        Friction [N] towards the high side and across it.
    moment_p, moment_q, moment_D : float
        Moments about the centre of mass [N m].
    rubbing, resisting : float
        Powers [W] dissipated by friction and by the moments.
    """

    force_u: float = 0.0
    force_q: float = 0.0
    moment_p: float = 0.0
    moment_q: float = 0.0
    moment_D: float = 0.0
    rubbing: float = 0.0
    resisting: float = 0.0


class RimFriction(NamedTuple):
    """Laws of friction of a rim.

    Attributes
    ----------
    coefficient : float
        Coefficient of sliding friction.
    arms : tuple of float
        Arms [m] of the moments that resist nutation, rolling and pivoting.
    laws : tuple of (float, float)
        Coefficient c [W s^b] and exponent b of each power c |Omega|^b that the rolling disk
        loses under its weight at the precession rate Omega.
    creep_speed : float
        Speed [m/s], above 0, at which friction reaches 1/sqrt(2) of its limit.
    pivoting : tuple of float
        Polynomials of `dynamics.pivoting` for the pivoting of the contact ellipse under the
        weight, or () if the arm is constant.
    """

    coefficient: float = 0.0
    arms: tuple[float, float, float] = (0.0, 0.0, 0.0)
    laws: tuple[tuple[float, float], ...] = ()
    creep_speed: float = 1e-3
    pivoting: tuple[float, ...] = ()

    def loads(
        self,
        speed: Sequence[float],
        at: "Geometry",
        loads: "LandingLoads",
        model: "LandingModel",
    ) -> RimLoads:
        """Return the loads of both rims.

        Parameters
        ----------
        speed : sequence of float
            Horizontal velocity (2,) of the centre of mass [m/s].
        at : Geometry
            Inclination and gaps.
        loads : LandingLoads
            Loads of the asperities.
        model : LandingModel
            The disk.

        Returns
        -------
        RimLoads
            The loads; zero of a rim that does not touch the table.
        """
        vx, vy = speed
        ux, uy = at.direction_x, at.direction_y
        velocity = ux * vx + uy * vy, ux * vy - uy * vx
        lower = self._of_rim(velocity, at, loads.stop, model.lever, model)
        if loads.upper_stop.force <= 0:
            return lower
        upper = self._of_rim(velocity, at, loads.upper_stop, -model.lever, model)
        return RimLoads(*(a + b for a, b in zip(lower, upper, strict=True)))

    def _of_rim(
        self,
        velocity: tuple[float, float],
        at: "Geometry",
        stop: "StopForces",
        lever: float,
        model: "LandingModel",
    ) -> RimLoads:
        """Return the loads of the rim at the distance `lever` [m] below the middle plane."""
        load = stop.force
        if load <= 0:
            return NO_RIM_LOADS
        s, c = at.slope, at.cosine
        R = model.stop.radius
        omega_p, omega_q, n = -at.E_q, at.E_p, at.spin
        share = min(max(-stop.along / (R * load), 0.0), 1.0)
        below = lever * c + share * R * s + model.fillet
        out = lever * s - share * R * c
        slip_u = velocity[0] - omega_q * below
        slip_q = (
            velocity[1]
            + lever * omega_p
            - share * R * n
            - model.fillet * (s * n - c * omega_p)
        )
        pivoting = s * omega_p + c * n
        rolling = c * omega_p - s * n
        creep = self.creep_speed
        limit = self.coefficient * load
        push = limit / sqrt(slip_u * slip_u + slip_q * slip_q + creep * creep)
        force_u, force_q = -push * slip_u, -push * slip_q
        spread = R * (1 - share)  # the arms of the scene are those of a point
        swivel = -limit * spread * _smooth_sign(spread * pivoting, creep)
        still = creep / R
        steep = max(s, MIN_POWER_LAW_SLOPE)
        nutation_arm, rolling_arm, pivoting_arm = self.arms
        twist = -pivoting_arm * load * _smooth_sign(pivoting, still)
        if self.pivoting:
            travel = sqrt(rolling * rolling + omega_q * omega_q) / steep
            twist -= R * load * self._ellipse_arm(steep, pivoting, travel)
        lean = -rolling_arm * load * _smooth_sign(rolling, still)
        nod = -nutation_arm * load * _smooth_sign(omega_q, still)
        rate = abs(omega_p) / steep
        moment = sum(c * rate ** (exponent - 1) for c, exponent in self.laws) / steep
        contour_arm = min(share * moment / model.disk.weight, R)  # pressed at the rim
        contour = -contour_arm * load * _smooth_sign(omega_p, still)
        about_z = out * force_q + swivel
        return RimLoads(
            force_u,
            force_q,
            s * (about_z + twist) + c * (below * force_q + lean) + contour,
            nod - below * force_u,
            c * (about_z + twist) - s * (below * force_q + lean),
            -force_u * slip_u - force_q * slip_q - swivel * pivoting,
            -twist * pivoting - lean * rolling - nod * omega_q - contour * omega_p,
        )

    def _ellipse_arm(self, sine: float, pivoting: float, travel: float) -> float:
        """Return the signed arm, over the radius, that opposes the pivoting of the ellipse."""
        return pivoting_arm(
            sine, pivoting, travel, 0.0, False, self.coefficient, self.pivoting
        )


NO_FRICTION = RimFriction()
NO_RIM_LOADS = RimLoads()


def _smooth_sign(rate: float, still: float) -> float:
    """Return the sign of a rate, with a transition of the width `still`, which is not 0."""
    return rate / sqrt(rate * rate + still * still)
