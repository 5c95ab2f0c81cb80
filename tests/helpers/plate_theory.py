"""Closed forms against which the solvers are tested: thin circular plates (Leissa 1969, chapter 2),
torsion."""

from math import pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import iv, ivp, jn_zeros, jv, jvp


def plate_determinant(x, n, poisson, edge):
    """Return the frequency determinant of w = A J_n(x r) + B I_n(x r) at the edge r = 1, scaled by
    exp(-x).

    The edge is free (bending moment and Kirchhoff shear force vanish), supported (deflection and
    moment), or clamped (deflection and slope).
    """
    scale = np.exp(-x)
    columns = []
    bessel_j = (-1, jv(n, x), x * jvp(n, x))
    bessel_i = (1, iv(n, x) * scale, x * ivp(n, x) * scale)
    for sign, f, slope in (bessel_j, bessel_i):
        moment = sign * x**2 * f - (1 - poisson) * (slope - n**2 * f)
        shear = sign * x**2 * slope - (1 - poisson) * n**2 * (slope - f)
        columns.append(
            {"free": (moment, shear), "supported": (f, moment), "clamped": (f, slope)}[
                edge
            ],
        )
    (a, b), (c, d) = columns
    return a * d - b * c


def plate_roots(n, count, poisson, edge):
    """Return the first `count` positive roots x of the determinant of order n; frequencies scale as
    x^2."""
    x = np.linspace(0.3, 4.0 * count + n + 6, 4000)
    values = plate_determinant(x, n, poisson, edge)
    brackets = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))[:count]
    return np.array(
        [
            brentq(plate_determinant, x[i], x[i + 1], args=(n, poisson, edge))
            for i in brackets
        ],
    )


def thin_plate_frequencies(
    n, count, radius, thickness, young, poisson, density, edge="free"
):
    """Return the first frequencies [Hz] of order n of a plate with h << R: f = x^2/(2 pi R^2)
    sqrt(D/(rho h)), D = E h^3/(12 (1 - nu^2))."""
    stiffness = young * thickness**2 / (12 * (1 - poisson**2))
    return (
        plate_roots(n, count, poisson, edge) ** 2
        / (2 * pi * radius**2)
        * (stiffness / density) ** 0.5
    )


def torsion_frequencies(count, radius, young, poisson, density):
    """Return the first frequencies [Hz] of torsion, uniform along the axis, of a free cylinder of
    any length: f = x/(2 pi R) sqrt(mu/rho), J_2(x) = 0."""
    return (
        jn_zeros(2, count)
        / (2 * pi * radius)
        * (young / (2 * (1 + poisson)) / density) ** 0.5
    )
