"""Arm of the moment by which the contact ellipse resists pivoting.

The weight and the inclination determine the ellipse. `compliant/law/spin_friction.py`
derives its two coefficients and fits the polynomials that are evaluated here.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dynamics.equations import NumberOrExpression

SINE_ROOT_INDEX = 12
"""The polynomials are functions of sin(beta)^(1/SINE_ROOT_INDEX), in which
the ellipse is smooth."""
PIVOTING_COEFFICIENT_COUNT = 7
"""Number of coefficients in each polynomial."""


def pivoting_arm(
    sine: float,
    pivoting: float,
    travel: float,
    slip_square: float,
    sliding: bool,
    mu: float,
    coefficients: "Sequence[NumberOrExpression]",
) -> float:
    """Return the signed arm of the moment that opposes the pivoting of a contact.

    Parameters
    ----------
    sine : scalar
        sin(beta).
    pivoting : scalar
        omega.a_3.
    travel : scalar
        Speed at which the contact of a rolling disk moves over table and edge.
    slip_square : scalar
        Square of the slip speed of a sliding disk.
    sliding : bool
        True if the contact slides.
    mu : scalar
        Coefficient of dynamic friction.
    coefficients : sequence of scalar, (2 PIVOTING_COEFFICIENT_COUNT,)
        Polynomials for `unit_arm` and `creep` of `friction_limited_arm`, both times
        sin(beta)^(1/3), lowest power first.
    """
    root = sine ** (1 / SINE_ROOT_INDEX)
    scale = 1.0 / (root * root * root * root)
    unit_arm = polynomial(coefficients[:PIVOTING_COEFFICIENT_COUNT], root) * scale
    creep = polynomial(coefficients[PIVOTING_COEFFICIENT_COUNT:], root) * scale
    speed_square = slip_square if sliding else travel * travel
    return friction_limited_arm(unit_arm, creep, pivoting, speed_square, sliding, mu)


def friction_limited_arm(
    unit_arm: float,
    creep: float,
    pivoting: float,
    speed_square: float,
    sliding: bool,
    mu: float,
) -> float:
    """Return the signed arm of the moment that opposes the rate `pivoting`.

    Spin creep causes the moment of Kalker's linear theory. It is limited to the moment
    of full slip, which is reached if the disk spins without rolling.

    Parameters
    ----------
    unit_arm : scalar
        Arm of the moment of full slip at mu = 1.
    creep : scalar
        Moment of spin creep divided by the normal force and by the creepage
        `pivoting`/speed.
    pivoting : scalar
        Rate of rotation about the vertical.
    speed_square : scalar
        Square of the slip speed of a sliding contact, or of the travel speed of a
        rolling one.
    sliding : bool
        True if the contact slides.
    mu : scalar
        Coefficient of dynamic friction.
    """
    # Ratio <y^2>/arm^2 in the moment of fast slip, with the arm at mu = 1. If the
    # slip u is much faster than the spin w, Hertz's pressure causes the moment mu N
    # <y^2> w/u, with y measured across the slip. Averaged over the slip direction,
    # <y^2> is (a^2 + b^2)/10: 0.71 arm^2 for a long ellipse, 0.58 arm^2 for a circle.
    fast_slip_moment_ratio = 0.7
    arm = mu * unit_arm
    if sliding:
        creep = fast_slip_moment_ratio * unit_arm * arm
    moment = creep * pivoting
    return (
        arm
        * moment
        / (arm * arm * speed_square + moment * moment + 1e-30) ** 0.5  # not 0/0 at rest
    )


def polynomial(coefficients: Sequence[Any], x: float) -> float:
    """Return the value at x of a polynomial with `coefficients`, lowest power first."""
    value = coefficients[-1]
    for i in range(len(coefficients) - 2, -1, -1):
        value = value * x + coefficients[i]
    return value
