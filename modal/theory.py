"""Closed forms that judge the solvers: thin circular plates (Leissa, Vibration of Plates, ch. 2), torsion."""

from math import pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import iv, ivp, jn_zeros, jv, jvp


def plate_determinant(x, n, poisson, edge):
    """The frequency determinant of w = A J_n(x r) + B I_n(x r) at r = 1, scaled by exp(-x).

    free: bending moment and Kirchhoff's shear force vanish; supported: deflection and moment; clamped: both slopes.
    """
    scale = np.exp(-x)
    columns = []
    for sign, f, slope in ((-1, jv(n, x), x * jvp(n, x)), (1, iv(n, x) * scale, x * ivp(n, x) * scale)):
        moment = sign * x**2 * f - (1 - poisson) * (slope - n**2 * f)
        shear = sign * x**2 * slope - (1 - poisson) * n**2 * (slope - f)
        columns.append({"free": (moment, shear), "supported": (f, moment), "clamped": (f, slope)}[edge])
    (a, b), (c, d) = columns
    return a * d - b * c


def plate_roots(n, count, poisson, edge):
    """The first `count` positive roots x of the determinant, bracketed on a fine grid; frequencies go as x^2."""
    x = np.linspace(0.3, 4.0 * count + n + 6, 4000)
    values = plate_determinant(x, n, poisson, edge)
    brackets = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))[:count]
    return np.array([brentq(plate_determinant, x[i], x[i + 1], args=(n, poisson, edge)) for i in brackets])


def thin_plate_frequencies(n, count, radius, thickness, young, poisson, density, edge="free"):
    """f = x^2/(2 pi R^2) sqrt(D/(rho h)) [Hz], D = E h^3/(12 (1 - nu^2)), the limit h << R."""
    stiffness = young * thickness**2 / (12 * (1 - poisson**2))
    return plate_roots(n, count, poisson, edge) ** 2 / (2 * pi * radius**2) * (stiffness / density) ** 0.5


def torsion_frequencies(count, radius, young, poisson, density):
    """f = x/(2 pi R) sqrt(mu/rho) [Hz] with J_2(x) = 0: torsion of a free cylinder of any length, uniform along it."""
    return jn_zeros(2, count) / (2 * pi * radius) * (young / (2 * (1 + poisson)) / density) ** 0.5
