"""Equations of a disk that has lost its rolling contact, above a table.

The disk is a rigid body in space. Either rim may touch the table, at a point, along an arc
or all around, and a film of air acts on the lower face. The axis D of the disk points
upwards, and E is its rate. With the inclination beta, u is the horizontal direction of the
high side, q = e_z x u the direction across it, and p = cos(beta) u + sin(beta) e_z the
direction of the high side in the plane of the disk. In the frame (p, q, D)

    omega = -E_q p + E_p q + n D,          m v' = F - W e_z,
    E' = p (M_q - C n E_q)/I - q (M_p - C n E_p)/I - |E|^2 D,          C n' = M_D,

where F and M are forces and their moments about the centre of mass, and I and C are the
moments of inertia about a diameter and about the axis. Film and asperities act on the slope
sin(beta) through the powers of its rates along and across the direction u. They do not
turn the disk about its axis.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi, sqrt
from typing import NamedTuple

from dynamics.disk import GRAVITY, Disk, inertias
from dynamics.film.conformal_reynolds import FilmResistance
from dynamics.film.tilted_film import TiltedFilm
from dynamics.landing.rim_friction import NO_FRICTION, RimFriction, RimLoads
from dynamics.landing.stop import NO_STOP_FORCES, Stop, StopForces

MIN_FILM_GAP = 1e-9
"""Smallest gap [m] of the film, which compressed asperities keep open."""
MAX_FILM_SLOPE = 0.3
"""Slope above which the film is neglected: its forces are below 1e-3 of the weight."""
OTHER_FACE_COSINE = -1e-3
"""Cosine of the inclination below which the other face is the lower one. It is not 0, so that
the frame of a disk that rolls upright does not turn round in each step."""
NO_RESISTANCE = FilmResistance(0.0, 0.0, 0.0, 0.0)


class LandingState(NamedTuple):
    """State of the equations, in the fixed frame and in SI units.

    Attributes
    ----------
    height : float
        Height of the centre of mass minus half the thickness, above the asperities [m].
    axis_x, axis_y, axis_z : float
        The axis of the disk, a unit vector that points upwards at first.
    rise : float
        Rate of the height [m/s].
    turn_x, turn_y, turn_z : float
        Rate of the axis [1/s].
    x, y : float
        Horizontal position of the centre [m].
    speed_x, speed_y : float
        Its velocity [m/s].
    turned : float
        Spin plus precession since the start [rad]; minus the precession while the disk is
        turned over.
    axial_rate : float
        Angular velocity about the axis [rad/s].
    squeezing, swirling, striking, shearing : float
        Energies [J] lost since the start by the film as it is squeezed and as the disk
        precesses, by the stop, and by the shear of the film.
    rubbing, resisting : float
        Energies [J] lost since the start by friction and by the resisting moments.
    """

    height: float
    axis_x: float
    axis_y: float
    axis_z: float
    rise: float
    turn_x: float
    turn_y: float
    turn_z: float
    x: float
    y: float
    speed_x: float
    speed_y: float
    turned: float
    axial_rate: float
    squeezing: float = 0.0
    swirling: float = 0.0
    striking: float = 0.0
    shearing: float = 0.0
    rubbing: float = 0.0
    resisting: float = 0.0


LOSSES = slice(LandingState._fields.index("squeezing"), None)
"""Place of the dissipated energies in a state."""


class Geometry(NamedTuple):
    """Inclination and gaps of a state, and their rates.

    Attributes
    ----------
    slope, cosine : float
        sin(beta) and cos(beta) of the inclination of the lower face. It is at most pi/2, or
        slightly more, see OTHER_FACE_COSINE.
    side : float
        1 if the lower face is that of the start, -1 if it is the other one.
    direction_x, direction_y : float
        Unit vector u towards the high side.
    tip, turn : float
        Rates of the slope along and across this direction [1/s].
    E_p, E_q : float
        Rate [1/s] of the axis of the lower face along p and q.
    spin : float
        Angular velocity [rad/s] about this axis.
    gap, opening : float
        Height [m] of the centre of the lower face above the asperities, and its rate [m/s].
    upper_gap, upper_opening : float
        The same of the upper face.
    """

    slope: float
    cosine: float
    side: float
    direction_x: float
    direction_y: float
    tip: float
    turn: float
    E_p: float
    E_q: float
    spin: float
    gap: float
    opening: float
    upper_gap: float
    upper_opening: float


class LandingLoads(NamedTuple):
    """Loads on the disk, with the moments along and across the direction of the high side.

    Attributes
    ----------
    film, film_along, film_across : float
        Force [N] and moments [N m] of the film.
    stop, upper_stop : StopForces
        Loads of the asperities on the lower and the upper rim.
    """

    film: float
    film_along: float
    film_across: float
    stop: StopForces
    upper_stop: StopForces


@dataclass(frozen=True)
class LandingModel:
    """A disk above a film and a stop.

    Parameters
    ----------
    disk : Disk
        The disk.
    film : TiltedFilm or None
        The film; None in a vacuum.
    stop : Stop
        The asperities.
    friction : RimFriction
        Friction and resisting moments of the rims.
    """

    disk: Disk
    film: TiltedFilm | None
    stop: Stop
    friction: RimFriction = NO_FRICTION

    @cached_property
    def diametral_inertia(self) -> float:
        """Moment of inertia about a diameter [kg m^2]."""
        return inertias(self.disk)[0]

    @cached_property
    def radius_of_gyration(self) -> float:
        """Radius of gyration [m] about a diameter."""
        return sqrt(self.diametral_inertia / self.disk.mass)

    @cached_property
    def axial_inertia(self) -> float:
        """Moment of inertia about the axis [kg m^2]."""
        return inertias(self.disk)[1]

    @cached_property
    def fillet(self) -> float:
        """Radius [m] of the rounded edge."""
        return self.disk.radius - self.stop.radius

    @cached_property
    def lever(self) -> float:
        """Distance [m] of the circles on which the disk rolls from its middle plane."""
        return self.disk.thickness / 2 - self.fillet

    def geometry(self, y: Sequence[float]) -> Geometry:
        """Return inclination and gaps of a state (20,), whose order is that of `LandingState`."""
        height, dx, dy, dz, rise, ex, ey, ez = y[:8]
        side = 1.0 if dz >= OTHER_FACE_COSINE else -1.0
        lean = sqrt(dx * dx + dy * dy)
        ux, uy = (-side * dx / lean, -side * dy / lean) if lean > 0 else (1.0, 0.0)
        length = sqrt(
            lean * lean + dz * dz
        )  # 1 except for the error of the integration
        slope, cosine = lean / length, side * dz / length
        E_u = side * (ux * ex + uy * ey)
        E_q = side * (ux * ey - uy * ex)
        E_z = side * ez
        E_p = cosine * E_u + slope * E_z
        lever = self.lever
        gap = height + lever * slope * slope / (1 + cosine)
        return Geometry(
            slope=slope,
            cosine=cosine,
            side=side,
            direction_x=ux,
            direction_y=uy,
            tip=-E_u,
            turn=-cosine * E_q,
            E_p=E_p,
            E_q=E_q,
            spin=side * y[13],
            gap=gap,
            opening=rise - lever * E_z,
            upper_gap=height + lever * (1 + cosine),
            upper_opening=rise + lever * E_z,
        )

    def loads(self, at: Geometry) -> LandingLoads:
        """Return the loads of the film and of the stop."""
        R = self.stop.radius
        gyration = self.radius_of_gyration
        outwards, inwards = R * at.cosine, self.lever * at.slope
        lever = (outwards - inwards) / gyration
        stop = self.stop.forces(at.gap, at.slope, at.opening, at.tip, at.turn, lever)
        upper = NO_STOP_FORCES
        if at.upper_gap < R * at.slope:
            lever = (outwards + inwards) / gyration
            upper = self.stop.forces(
                at.upper_gap, at.slope, at.upper_opening, at.tip, at.turn, lever
            )
        heave, coupling, along, across = self._film_resistance(at)
        return LandingLoads(
            -heave * at.opening - coupling * at.tip,
            -coupling * at.opening - along * at.tip,
            -across * at.turn,
            stop,
            upper,
        )

    def _film_resistance(self, at: Geometry) -> FilmResistance:
        if self.film is None or at.slope > MAX_FILM_SLOPE:
            return NO_RESISTANCE
        return self.film.resistance(self.film_gap(at), at.slope)

    def film_gap(self, at: Geometry) -> float:
        """Return the gap [m] below the centre of the face, to the mean surface of the table."""
        return max(at.gap + self.stop.height, MIN_FILM_GAP)

    def rim_loads(
        self, y: Sequence[float], at: Geometry, loads: LandingLoads
    ) -> RimLoads:
        """Return friction and resisting moments of both rims in a state (20,)."""
        return self.friction.loads(y[10:12], at, loads, self)

    def rates(self, t: float, y: Sequence[float]) -> list[float]:
        """Return the rates (20,) of a state (20,) at the time t [s]."""
        at = self.geometry(y)
        loads = self.loads(at)
        film, film_along, film_across, stop, upper = loads
        rim = self.rim_loads(y, at, loads)
        mass = self.disk.mass
        lift = film + stop.force + upper.force
        along = film_along + stop.along + upper.along
        across = film_across + stop.across + upper.across
        raising = self.lever * at.slope * (film + stop.force - upper.force)
        moment_p = at.cosine * across + rim.moment_p
        moment_q = -at.cosine * along - raising + rim.moment_q
        inertia = self.diametral_inertia
        spun = self.axial_inertia * at.spin
        rate_p = (moment_q - spun * at.E_q) / inertia
        rate_q = -(moment_p - spun * at.E_p) / inertia
        rate_D = -(at.E_p**2 + at.E_q**2)
        ux, uy, side = at.direction_x, at.direction_y, at.side
        rate_u = at.cosine * rate_p - at.slope * rate_D
        rate_z = at.slope * rate_p + at.cosine * rate_D
        drag, spin_drag = self._shear(at)
        vx, vy = y[10:12]
        push_x = rim.force_u * ux - rim.force_q * uy - drag * vx
        push_y = rim.force_u * uy + rim.force_q * ux - drag * vy
        turning = rim.moment_D - spin_drag * at.spin
        return [
            y[4],
            *y[5:8],
            lift / mass - GRAVITY,
            side * (rate_u * ux - rate_q * uy),
            side * (rate_u * uy + rate_q * ux),
            side * rate_z,
            vx,
            vy,
            push_x / mass,
            push_y / mass,
            side * (at.spin - at.E_q * at.slope / (1 + at.cosine)),
            side * turning / self.axial_inertia,
            -film * at.opening - film_along * at.tip,
            -film_across * at.turn,
            stop.dissipated + upper.dissipated,
            drag * (vx * vx + vy * vy) + spin_drag * at.spin**2,
            rim.rubbing,
            rim.resisting,
        ]

    def _shear(self, at: Geometry) -> tuple[float, float]:
        """Return the drag coefficients [N s/m, N m s] of gliding and of spinning.

        They are those of Couette flow between a level disk and the table around a hole.
        """
        if self.film is None or at.slope > MAX_FILM_SLOPE:
            return 0.0, 0.0
        film = self.film
        outer, inner = film.radius**2, film.hole**2 / 4
        mean_gap = self.film_gap(at) + film.depth / 2
        drag = pi * film.viscosity * (outer - inner) / mean_gap
        return drag, drag * (outer + inner) / 2

    def energy(self, y: Sequence[float]) -> float:
        """Return kinetic, potential and stored energy [J]; zero at rest on rigid asperities."""
        at = self.geometry(y)
        loads = self.loads(at)
        disk = self.disk
        stored = loads.stop.stored + loads.upper_stop.stored
        moving = disk.mass * (y[4] ** 2 + y[10] ** 2 + y[11] ** 2)
        turning = self.diametral_inertia * (at.E_p**2 + at.E_q**2)
        spinning = self.axial_inertia * at.spin**2
        return (moving + turning + spinning) / 2 + disk.weight * y[0] + stored
