"""Whether the air lifts a rolling disk off the table: scales and criterion."""

from math import pi, sqrt
from typing import NamedTuple

from dynamics.air import Air
from dynamics.disk import GRAVITY, Disk, inertias
from dynamics.film.forces import film_moment_parts
from dynamics.film.tilted_film import tabulated_resistance
from dynamics.film.wedge import Film

SCALED_LIFT_OFF_INCLINATION = 0.470
"""Inclination at lift-off over the scale of the film, for a film-only motion on a plane."""
PRECESSION_FACTOR = 0.367
"""Square of the precession rate at lift-off times kappa R beta/g, for such a motion."""
ASPERITY_HEIGHT_LIMIT_RATIO = 0.18
"""Height of asperities, over the radius and the scale of the film, that prevents lift-off."""


class LiftOff(NamedTuple):
    """Prediction whether the film lifts the disk off the table.

    Attributes
    ----------
    inclination : float
        Inclination [rad] at which the film lifts a disk off the table.
    precession_rate : float
        Precession rate [rad/s] at that moment.
    max_stop_height : float
        Height [m] of asperities or waves above which the disk stays in contact.
    """

    inclination: float
    precession_rate: float
    max_stop_height: float

    def happens(self, stop_height: float, rattle_inclination: float = 0.0) -> bool:
        """Return whether the disk lifts off.

        Parameters
        ----------
        stop_height : float
            Height [m] of the asperities or waves that hold the film open.
        rattle_inclination : float, optional
            Inclination [rad] at which waves or vibration first break the contact.

        Returns
        -------
        bool
            True if the film lifts the disk before waves or vibration do.
        """
        is_low = stop_height < self.max_stop_height
        return is_low and rattle_inclination < self.inclination


def film_inclination_scale(disk: Disk, viscosity: float) -> float:
    """Return the inclination scale beta* = (144 mu^2 R^5/(I m g))^(1/5) [rad].

    Parameters
    ----------
    disk : Disk
        The disk.
    viscosity : float
        Viscosity of the air [Pa s].

    Returns
    -------
    float
        The inclination. A motion that only the film resists depends on the ratio of
        moment of inertia I to m R^2 alone if inclinations are divided by it.
    """
    R = disk.radius
    inertia, _ = inertias(disk)
    return (144 * viscosity**2 * R**5 / (inertia * disk.mass * GRAVITY)) ** 0.2


def predict_lift_off(
    disk: Disk, air: Air, depth: float = 0.0, hole: float = 0.0
) -> LiftOff:
    """Predict the lift-off of a disk from a plane or concave table.

    Contour friction of 4.5 times the torque of the film raises both results by 10 to
    12 %. The compression of the air raises the inclination by about 6 W/(pi R^2 p), as it
    does here. A concave table lowers all results by `concave_lift_off_ratio`. Over a hole, the air
    is not compressed. The torque of the film there makes the disk fall, and the fall makes
    the lift, so that the square of the viscosity is multiplied by the factors of both.

    Parameters
    ----------
    disk : Disk
        The disk.
    air : Air
        The air.
    depth : float, optional
        Depth [m] of the middle of the table below the circle on which the disk rolls.
    hole : float, optional
        Radius of a hole in table or disk over that of the flat face, below 1.

    Returns
    -------
    LiftOff
        The prediction.
    """
    R = disk.radius
    scale = film_inclination_scale(disk, air.viscosity * _viscosity_factor(hole))
    compression = 0.0 if hole else 6 * disk.weight / (pi * R**2 * air.pressure)
    inclination = SCALED_LIFT_OFF_INCLINATION * scale * (1 + compression)
    share = concave_lift_off_ratio(depth / (R * inclination))
    inclination *= share
    scale *= share
    kappa = disk.gyration / 4 + (disk.thickness / R) ** 2 / 12
    rate = sqrt(PRECESSION_FACTOR * GRAVITY / (kappa * R * inclination))
    return LiftOff(inclination, rate, ASPERITY_HEIGHT_LIMIT_RATIO * R * scale)


def concave_lift_off_ratio(depth: float) -> float:
    """Return the inclination of lift-off from a concave table over that from a plane one.

    The lift of a film that alone makes the disk fall is the product of its drag, which
    causes the fall, of its resistance to the fall and of the lever of this resistance. On
    a plane it rises as the inverse fifth power of the inclination; the wider gap in the
    middle of the table reduces it.

    Parameters
    ----------
    depth : float
        Depth of the table divided by the radius of the disk and the inclination of
        lift-off from a plane table.

    Returns
    -------
    float
        The ratio, from 0 to 1.
    """
    if depth == 0:
        return 1.0
    from scipy.optimize import brentq

    def excess(share: float) -> float:
        return share**5 - _lift(depth / share) / _lift(0.0)

    return float(brentq(excess, 1e-6, 1.0))


def _lift(depth: float) -> float:
    """Return the lift of a film over a table whose depth [R sin(beta)] widens its gap."""
    film = Film(
        turning=1.0,
        falling=1.0,
        inertia=0.0,
        number=0.0,
        ambient=0.0,
        slip=0.0,
        bowl=depth,
    )
    drag, fall, lever, _, _ = film_moment_parts(1.0, 1.0, film)
    return drag * fall * lever


def _viscosity_factor(hole: float) -> float:
    """Return the viscosity without a hole that has the effect of the film over a hole, in
    units of the viscosity."""
    if not hole:
        return 1.0
    from dynamics.film.annular_film import (  # imports scikit-fem
        closed_film_polynomials,
    )

    turning, _, lifting = closed_film_polynomials(hole).sum(axis=1)
    whole = tabulated_resistance(1.0)
    lift = whole.heave + whole.coupling
    return float(sqrt(turning * lifting / (whole.across * lift)))
