"""Equations of a nearly flat disk between an air film and the asperities of the table.

The centre of the lower face is at the height z above the asperities, and the horizontal
components w of the downward normal are the slopes of the face: |w| = sin(beta), and w
points to the high side. With c = cos(beta), the rates of w along and across this
direction have the kinetic energy I (w_along'^2/c^2 + w_across'^2)/2, and Lagrange's
equations are

    m z'' = F + N - W,
    w_along'' = c^2 Q_along/I - |w| (w_across'^2 + w_along'^2/c^2),    w_across'' = Q_across/I,
    Q = M + H (F + N) w/c - C n/c (w_y', -w_x'),

where z is the height of the centre of mass minus H, F and M are the loads of the film, N
that of the stop, and n is the angular velocity about the axis. The loads are those of a
nearly level face: terms of the order beta are dropped from them alone. The disk glides
and spins freely, except for the shear of the film.
"""

from collections.abc import Sequence
from math import hypot, pi, sqrt
from typing import NamedTuple

from dynamics.disk import GRAVITY, Disk
from dynamics.film.conformal_reynolds import FilmResistance
from dynamics.film.tilted_film import TiltedFilm
from dynamics.landing.stop import Stop, StopForces

MIN_FILM_GAP = 1e-9
"""Smallest gap [m] of the film, which compressed asperities keep open."""
NO_RESISTANCE = FilmResistance(0.0, 0.0, 0.0, 0.0)


class LandingState(NamedTuple):
    """State of the equations, in the fixed frame and in SI units.

    Attributes
    ----------
    height : float
        Height of the centre of mass minus half the thickness, above the asperities [m].
    slope_x, slope_y : float
        Components of w.
    rise, tip_x, tip_y : float
        Their rates.
    x, y : float
        Horizontal position of the centre [m].
    speed_x, speed_y : float
        Its velocity [m/s].
    turned, axial_rate : float
        Angle [rad] and angular velocity [rad/s] of the disk about its axis.
    squeezing, swirling, striking, shearing : float
        Energies [J] lost since the start by the film as it is squeezed and as the disk
        precesses, by the stop, and by the shear of the film.
    """

    height: float
    slope_x: float
    slope_y: float
    rise: float
    tip_x: float
    tip_y: float
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


class LandingLoads(NamedTuple):
    """Loads on the disk, with the moments along and across the direction of the high side.

    Attributes
    ----------
    film, film_along, film_across : float
        Force [N] and moments [N m] of the film.
    stop : StopForces
        Loads of the asperities.
    """

    film: float
    film_along: float
    film_across: float
    stop: StopForces


class Geometry(NamedTuple):
    """Slope and gap of a state, and their rates.

    Attributes
    ----------
    slope : float
        sin(beta).
    direction_x, direction_y : float
        Unit vector towards the high side.
    tip, turn : float
        Rates of the slope along and across this direction [1/s].
    gap, opening : float
        Height [m] of the centre of the face above the asperities, and its rate [m/s].
    """

    slope: float
    direction_x: float
    direction_y: float
    tip: float
    turn: float
    gap: float
    opening: float


class LandingModel(NamedTuple):
    """A disk above a film and a stop.

    Attributes
    ----------
    disk : Disk
        The disk.
    film : TiltedFilm or None
        The film; None in a vacuum.
    stop : Stop
        The asperities.
    """

    disk: Disk
    film: TiltedFilm | None
    stop: Stop

    @property
    def diametral_inertia(self) -> float:
        """Moment of inertia about a diameter [kg m^2]."""
        disk = self.disk
        return disk.mass * (disk.gyration * disk.radius**2 / 4 + disk.thickness**2 / 12)

    @property
    def axial_inertia(self) -> float:
        """Moment of inertia about the axis [kg m^2]."""
        return self.disk.mass * self.disk.gyration * self.disk.radius**2 / 2

    def geometry(self, y: Sequence[float]) -> Geometry:
        """Return slope and gap of a state (16,), whose order is that of `LandingState`."""
        height, wx, wy, rise, tx, ty = y[:6]
        slope = hypot(wx, wy)
        ux, uy = (wx / slope, wy / slope) if slope > 0 else (1.0, 0.0)
        tip = ux * tx + uy * ty
        half = self.disk.thickness / 2
        cosine = sqrt(1 - slope * slope)
        gap = height + half * slope * slope / (1 + cosine)
        opening = rise + half * slope * tip / cosine
        return Geometry(slope, ux, uy, tip, ux * ty - uy * tx, gap, opening)

    def loads(self, at: Geometry) -> LandingLoads:
        """Return the loads of the film and of the stop."""
        stop = self.stop.forces(at.gap, at.slope, at.opening, at.tip, at.turn)
        heave, coupling, along, across = self._film_resistance(at)
        return LandingLoads(
            -heave * at.opening - coupling * at.tip,
            -coupling * at.opening - along * at.tip,
            -across * at.turn,
            stop,
        )

    def _film_resistance(self, at: Geometry) -> FilmResistance:
        if self.film is None:
            return NO_RESISTANCE
        return self.film.resistance(self.film_gap(at), at.slope)

    def film_gap(self, at: Geometry) -> float:
        """Return the gap [m] below the centre of the face, to the mean surface of the table."""
        return max(at.gap + self.stop.height, MIN_FILM_GAP)

    def rates(self, t: float, y: Sequence[float]) -> list[float]:
        """Return the rates (16,) of a state (16,) at the time t [s]."""
        at = self.geometry(y)
        film, along, across, stop = self.loads(at)
        disk = self.disk
        lift = film + stop.force
        squeezing = -film * at.opening - along * at.tip
        swirling = -across * at.turn
        ux, uy = at.direction_x, at.direction_y
        cosine = sqrt(1 - at.slope * at.slope)
        spun = self.axial_inertia * y[11] / cosine
        raising = disk.thickness / 2 * lift * at.slope / cosine
        along += stop.along + raising - spun * at.turn
        across += stop.across + spun * at.tip
        inertia = self.diametral_inertia
        inertial = at.slope * (at.turn**2 + (at.tip / cosine) ** 2)
        along = cosine**2 * along / inertia - inertial
        across /= inertia
        drag, spin_drag = self._shear(at)
        vx, vy = y[8:10]
        n = y[11]
        return [
            y[3],
            y[4],
            y[5],
            lift / disk.mass - GRAVITY,
            along * ux - across * uy,
            along * uy + across * ux,
            vx,
            vy,
            -drag / disk.mass * vx,
            -drag / disk.mass * vy,
            n,
            -spin_drag / self.axial_inertia * n,
            squeezing,
            swirling,
            stop.dissipated,
            drag * (vx * vx + vy * vy) + spin_drag * n * n,
        ]

    def _shear(self, at: Geometry) -> tuple[float, float]:
        """Return the drag coefficients [N s/m, N m s] of gliding and of spinning.

        They are those of Couette flow under a level disk.
        """
        if self.film is None:
            return 0.0, 0.0
        R = self.film.radius
        drag = (
            pi * self.film.viscosity * R**2 / (self.film_gap(at) + self.film.depth / 2)
        )
        return drag, drag * R**2 / 2

    def energy(self, y: Sequence[float]) -> float:
        """Return kinetic, potential and stored energy [J]; zero at rest on rigid asperities."""
        at = self.geometry(y)
        disk = self.disk
        stored = self.stop.forces(at.gap, at.slope, 0.0, 0.0, 0.0).stored
        moving = disk.mass * (y[3] ** 2 + y[8] ** 2 + y[9] ** 2)
        nutating = at.tip**2 / (1 - at.slope**2)
        turning = self.diametral_inertia * (nutating + at.turn**2)
        spinning = self.axial_inertia * y[11] ** 2
        return (moving + turning + spinning) / 2 + disk.weight * y[0] + stored
