"""The depth of the contact of a rim, and the restitution of an impact."""

from functools import cache
from math import sqrt

from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def contact_depth(weight, modulus, radius, fillet, inclination):
    """Return the depth [m] of the static elastic contact of the rim."""
    stiffness = 4 / 3 * modulus * (radius * fillet / inclination) ** 0.25
    return (weight / stiffness) ** (2 / 3)


def damping_ratio(restitution):
    """Return the damping ratio of a patch with this restitution; see `restitution_from`.

    Examples
    --------
    >>> round(damping_ratio(0.5), 3)
    0.233
    """
    return brentq(lambda ratio: restitution_from(ratio) - restitution, 1e-12, 4.0)


@cache
def restitution_from(ratio):
    """Return the restitution of a patch of this damping ratio by integrating an impact.

    The patch pushes with max(0, x^1.5 + 2 ratio sqrt(1.5 x^0.5) x'), the force of Hertz and of a
    dashpot for its local stiffness.
    """

    def force(x, speed):
        spring = max(x, 0.0) ** 0.5
        return max(0.0, x * spring + 2 * ratio * sqrt(1.5 * spring) * speed)

    def rates(t, y):
        return [y[1], -force(*y)]

    def leaves(t, y):
        return y[0]

    leaves.terminal = True
    leaves.direction = -1
    end = solve_ivp(
        rates, (0, 1e3), [1e-12, 1.0], "LSODA", events=leaves, rtol=1e-10, atol=1e-13
    )
    return -end.y[1, -1]
