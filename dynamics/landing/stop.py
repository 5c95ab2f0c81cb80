"""The asperities that stop a falling disk: a ring of springs and dashpots below its rim."""

from math import acos, exp, pi, sin, sqrt, tan
from typing import NamedTuple

DEFAULT_STOP_HEIGHT = 1e-7
"""Height [m] of the asperities above the plane that bounds the film: polished surfaces."""
DEFAULT_STOP_STIFFNESS = 4e8
"""Stiffness of the ring per radian of the rim [N/m]."""


class StopForces(NamedTuple):
    """Forces of the ring on the disk.

    Attributes
    ----------
    force : float
        Upward force [N].
    along, across : float
        Moments [N m] that raise the high side, and that turn the low point forwards.
    stored : float
        Energy [J] of the springs.
    dissipated : float
        Power [W] of the dashpots.
    """

    force: float
    along: float
    across: float
    stored: float
    dissipated: float


NO_STOP_FORCES = StopForces(0.0, 0.0, 0.0, 0.0, 0.0)


class Stop(NamedTuple):
    """A unilateral ring of linear springs and dashpots.

    Attributes
    ----------
    height : float
        Height [m] of the asperities above the mean surface that bounds the film.
    stiffness : float
        Stiffness per radian of the rim [N/m].
    relaxation_time : float
        Ratio [s] of damping to stiffness for a level disk.
    radius : float
        Radius [m] of the ring.
    """

    height: float
    stiffness: float
    relaxation_time: float
    radius: float

    def forces(
        self,
        height: float,
        slope: float,
        rise: float,
        tip: float,
        turn: float,
        lever: float = 0.0,
    ) -> StopForces:
        """Return the forces on a disk with the depth d(phi) = R slope cos(phi) - height.

        Parameters
        ----------
        height, slope : float
            Height [m] of the centre of the face above the asperities; slope [rad].
        rise, tip, turn : float
            Rates of the height [m/s], of the slope, and across it [rad/s].
        lever : float, optional
            Distance of the low point from the vertical through the centre of mass, over the
            radius of gyration about a diameter. It determines the damping of an arc, whose
            coefficient of restitution is that of a level disk.

        Returns
        -------
        StopForces
            The forces; zero above the ring.
        """
        reach = self.radius * slope
        if height >= reach:
            return NO_STOP_FORCES
        half_arc = contact_half_arc(height, reach)
        sine = sin(half_arc)
        # integrals of 1, cos, cos^2 and sin^2 over the arc
        one = 2 * half_arc
        first = 2 * sine
        cosine = height / reach if reach > -height else -1.0
        square = half_arc + sine * cosine
        # dashpots of a short arc would resist rolling
        other = (half_arc - sine * cosine) * half_arc / pi
        R = self.radius
        k = self.stiffness
        mobility = 1 + (lever * sine / half_arc) ** 2
        c = k * self.relaxation_time * sqrt(pi / half_arc / mobility)
        spring = k * (reach * first - height * one)
        approach = R * tip * first - rise * one
        if spring + c * approach < 0:
            c = -spring / approach  # the table does not pull
        tipping = k * (reach * square - height * first) + c * (
            R * tip * square - rise * first
        )
        stored = (
            k / 2 * (reach**2 * square - 2 * reach * height * first + height**2 * one)
        )
        closing = rise**2 * one - 2 * rise * R * tip * first + (R * tip) ** 2 * square
        lost = c * (closing + (R * turn) ** 2 * other)
        return StopForces(
            max(spring + c * approach, 0.0),
            -R * tipping,
            -R * c * R * turn * other,
            stored,
            lost,
        )


def contact_half_arc(height: float, reach: float) -> float:
    """Return half the arc [rad] of the ring that is in contact: 0 above it, pi all around.

    The centre of the face is at a height [m] above the asperities, and its low point
    `reach` [m] deeper.
    """
    if height >= reach:
        return 0.0
    return acos(height / reach) if reach > -height else pi


def stop_below(
    radius: float,
    mass: float,
    restitution: float,
    height: float = DEFAULT_STOP_HEIGHT,
    stiffness: float = DEFAULT_STOP_STIFFNESS,
) -> Stop:
    """Return the ring on which a level disk of this mass has this restitution.

    Parameters
    ----------
    radius : float
        Radius of the ring [m].
    mass : float
        Mass of the disk [kg].
    restitution : float
        Coefficient of restitution of a level disk, in (0, 1].
    height, stiffness : float
        As in `Stop`.

    Returns
    -------
    Stop
        The ring. Its damping ratio sin(x) is that of e = exp((2 x - pi) tan(x)), since the
        contact ends where spring and dashpot are in equilibrium [1]_.

    References
    ----------
    .. [1] Schwager & Poeschel (2007), Granular Matter 9, 465, equation (20).
    """
    damping_ratio = sin(_damping_angle(restitution))
    frequency = (2 * pi * stiffness / mass) ** 0.5
    return Stop(height, stiffness, 2 * damping_ratio / frequency, radius)


def _damping_angle(restitution: float) -> float:
    """Return the angle x [rad] in e = exp((2 x - pi) tan(x)), by bisection."""
    low, high = 0.0, pi / 2
    for _ in range(60):
        middle = (low + high) / 2
        if exp((2 * middle - pi) * tan(middle)) > restitution:
            low = middle
        else:
            high = middle
    return low
