"""Stiffness and mass of an axisymmetric solid in the basis of basis.py, by Gauss quadrature that is exact for it."""

from functools import cache
from math import atanh, ceil, log, pi

import numpy as np

from modal.elements.elastic import lame
from modal.spectral.basis import axial, radial

leggauss = cache(np.polynomial.legendre.leggauss)
DIGITS = 16
"""Decimal digits to which the pole on the axis is integrated: all there are."""


def strain_of(term, n):
    """Coefficients (6, 3, 2) of strains rr, theta theta, zz, twice rz, r theta, theta z in the products of
    (value, slope, value over r) in the radius with (value, slope) in z."""
    a, b, w = term.share
    strain = np.zeros((6, 3, 2))
    strain[0, 1, 0] = a
    strain[1, 2, 0] = a + n * b
    strain[2, 0, 1] = w
    strain[3, 0, 1], strain[3, 1, 0] = a, w
    strain[4, 1, 0], strain[4, 2, 0] = b, -(b + n * a)
    strain[5, 0, 1], strain[5, 2, 0] = b, -n * w
    return strain


def gauss(plate, n, size):
    """Gauss points rho in [hole, 1] and zeta in [-1, 1], weights [m^2] and [m]; exact for the basis.

    About the axis the integrands are polynomials in rho^2, of which the points are those of Gauss. About a hole they
    are polynomials over rho, integrated by `graded`.
    """
    zeta, wz = leggauss(2 * size[1] + 2)
    around = 2 * pi if n == 0 else pi
    if plate.hole:
        rho, wx = graded(plate.hole, size[0])
        wx = 4 * wx * rho
    else:
        x, wx = leggauss(size[0] + n // 2 + 4)
        rho = ((x + 1) / 2) ** 0.5
    return rho, zeta, around * wx / 4 * plate.radius**2, wz * plate.thickness / 2


def graded(hole, count):
    """Points and weights (k,) for int f drho over [hole, 1], f a polynomial of degree 2 count over rho.

    Gauss points in parts of equal ratio, each a decade at most. To a part that begins at the share s of its end the
    pole lies on the ellipse of log-radius e = 2 atanh(sqrt(s)); n points leave exp(-2 n e) of it (Trefethen,
    Approximation Theory and Approximation Practice, theorem 19.3), 10^-DIGITS with n = DIGITS ln(10)/(2 e).
    """
    parts = ceil(-log(hole) / log(10))
    share = hole ** (1 / parts)
    x, weight = leggauss(count + 2 + ceil(DIGITS * log(10) / (4 * atanh(share**0.5))))
    end = share ** np.arange(parts)[::-1, None]
    half = end * (1 - share) / 2
    return (end - half + half * x).ravel(), (half * weight).ravel()


def on_grid(plate, term, size, rho, zeta):
    """Value, slope, value over r (3, a, k) of the radial functions and value, slope (2, c, l) of the axial ones."""
    value, slope = radial(term, size[0], rho)
    height, tilt = axial(term, size[1], zeta)
    over = np.stack([value, slope / plate.radius, value / (rho * plate.radius)])
    return over, np.stack([height, tilt * 2 / plate.thickness])


def matrices(plate, p, size):
    """Stiffness and mass (N, N) of one problem: int lam tr(eps)^2 + 2 mu eps:eps, and int rho u.u.

    All pairs of terms s, t at once; i, j number what is taken of a function of the radius, x, y of one of z.
    """
    rho, zeta, weight, depth = gauss(plate, p.n, size)
    lam, mu = lame(plate.material)
    elasticity = np.diag([2 * mu] * 3 + [mu] * 3)
    elasticity[:3, :3] += lam
    r, z = (np.stack(parts) for parts in zip(*(on_grid(plate, t, size, rho, zeta) for t in p.terms), strict=True))
    along = np.einsum("siak,tjbk->stijab", r * weight, r)
    through = np.einsum("sxcl,tydl->stxycd", z * depth, z)
    strain, share = np.stack([strain_of(t, p.n) for t in p.terms]), np.array([t.share for t in p.terms], float)
    energy = np.einsum("IJ,sIix,tJjy->stxyij", elasticity, strain, strain, optimize=True)
    stiffness = product(np.einsum("stxyij,stijab->stxyab", energy, along), through)
    mass = product(along[:, :, 0, 0] * plate.density * (share @ share.T)[:, :, None, None], through[:, :, 0, 0])
    return stiffness + ring(plate, p, size), mass


def product(along, through):
    """The matrix (N, N) of unknowns (s a c), (t b d) from factors (s, t, ..., a, b) and (s, t, ..., c, d), summed."""
    s, t, *_, a, b = along.shape
    c, d = through.shape[-2:]
    flat = along.reshape(s, t, -1, a * b).swapaxes(2, 3) @ through.reshape(s, t, -1, c * d)
    return flat.reshape(s, t, a, b, c, d).transpose(0, 2, 4, 1, 3, 5).reshape(s * a * c, t * b * d)


def ring(plate, p, size):
    """Stiffness (N, N) of the elastic ring: ring_stiffness times the integral along it of u_z^2, averaged over z.

    Of Legendre's polynomials only the constant has an average.
    """
    if not plate.ring_stiffness or p.even > 0:
        return 0.0
    rho, constant = np.array([plate.ring_radius / plate.radius]), np.eye(size[1])[0]
    u_z = np.concatenate([t.share[2] * np.kron(radial(t, size[0], rho)[0][:, 0], constant) for t in p.terms])
    around = (2 * pi if p.n == 0 else pi) * plate.ring_radius
    return plate.ring_stiffness * around * np.outer(u_z, u_z)
