"""Whether the air lifts a rolling disk off the table: scales and criterion."""

from typing import NamedTuple

from dynamics.disk import GRAVITY, Disk

LIFT_OFF_INCLINATION_SHARE = 0.470
"""Inclination at lift-off over the scale of the film, for a film-only motion on a plane."""
MAX_STOP_HEIGHT_SHARE = 0.18
"""Height of asperities, over the radius and the scale of the film, that prevents lift-off."""


class LiftOff(NamedTuple):
    """Prediction whether the film lifts the disk off the table.

    Attributes
    ----------
    inclination : float
        Inclination [rad] at which an incompressible film lifts a disk off a plane table.
    max_stop_height : float
        Height [m] of asperities or waves above which the disk stays in contact.
    """

    inclination: float
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
    inertia = disk.mass * (disk.gyration * R**2 / 4 + disk.thickness**2 / 12)
    return (144 * viscosity**2 * R**5 / (inertia * disk.mass * GRAVITY)) ** 0.2


def predict_lift_off(disk: Disk, viscosity: float) -> LiftOff:
    """Predict the lift-off of a disk from a plane table.

    Contour friction of 4.5 times the torque of the film raises both results by 10 to
    12 %, and the compression of the air by up to 5 %.

    Parameters
    ----------
    disk : Disk
        The disk.
    viscosity : float
        Viscosity of the air [Pa s].

    Returns
    -------
    LiftOff
        The prediction.
    """
    scale = film_inclination_scale(disk, viscosity)
    return LiftOff(
        LIFT_OFF_INCLINATION_SHARE * scale, MAX_STOP_HEIGHT_SHARE * disk.radius * scale
    )
