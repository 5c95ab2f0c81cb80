"""Assemble stiffness and mass of an axisymmetric solid in the Ritz basis by exact
quadrature."""

from dataclasses import replace
from functools import cache
from math import atanh, ceil, log, pi
from typing import TYPE_CHECKING

import numpy as np

from modal.elements.elastic import lame_constants
from modal.spectral.basis import (
    BasisFamily,
    Plate,
    RitzProblem,
    axial_functions,
    radial_functions,
    rigid_mode,
    ritz_problem,
)

if TYPE_CHECKING:
    from modal.modes import Material

leggauss = cache(np.polynomial.legendre.leggauss)


def strain_coefficients(term: BasisFamily, n: int) -> np.ndarray:
    """Return the coefficients (6, 3, 2) of strains in products of radial and axial
    factors of a `BasisFamily`.

    The strains are rr, theta theta, zz, and twice rz, r theta, theta z. The radial
    factors are value, slope and value/r; the axial factors are value and slope.
    """
    a, b, w = term.component_factors
    strain = np.zeros((6, 3, 2))
    strain[0, 1, 0] = a
    strain[1, 2, 0] = a + n * b
    strain[2, 0, 1] = w
    strain[3, 0, 1] = a
    strain[3, 1, 0] = w
    strain[4, 1, 0] = b
    strain[4, 2, 0] = -(b + n * a)
    strain[5, 0, 1] = b
    strain[5, 2, 0] = -n * w
    return strain


def gauss_grid(
    plate: Plate, n: int, size: tuple[int, int]
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return Gauss points rho and zeta and their weights [m^2] and [m], exact for the
    basis.

    The ranges are [hole, 1] for rho and [-1, 1] for zeta. For a solid plate the
    integrands are polynomials in rho^2, and Gauss points in rho^2 are used. Around a
    hole they are polynomials divided by rho, integrated by `graded_gauss`.
    """
    zeta, axial_weight = leggauss(2 * size[1] + 2)
    around = 2 * pi if n == 0 else pi
    if plate.hole:
        rho, weight = graded_gauss(plate.hole, size[0])
        weight = 4 * weight * rho
    else:
        x, weight = leggauss(size[0] + n // 2 + 4)
        rho = ((x + 1) / 2) ** 0.5
    return (
        rho,
        zeta,
        around * weight / 4 * plate.radius**2,
        axial_weight * plate.thickness / 2,
    )


def graded_gauss(hole: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return points and weights (k,) for integrals over [hole, 1] of polynomials
    divided by rho.

    The degree of the polynomials is at most 2 `count`. Gauss points are used in
    geometrically graded intervals of at most a decade. For an interval with the ratio s
    of its ends, the pole at rho = 0 lies on the ellipse of log-radius e = 2
    atanh(sqrt(s)), and the relative error with n points is exp(-2 n e) (Trefethen,
    Approximation Theory and Approximation Practice, theorem 19.3), which is 10^-d for n
    = d ln(10)/(2 e).
    """
    accurate_digits = 16
    intervals = ceil(-log(hole) / log(10))
    share = hole ** (1 / intervals)
    x, weight = leggauss(
        count + 2 + ceil(accurate_digits * log(10) / (4 * atanh(share**0.5)))
    )
    end = share ** np.arange(intervals)[::-1, None]
    half = end * (1 - share) / 2
    return (end - half + half * x).ravel(), (half * weight).ravel()


def functions_on_grid(
    plate: Plate,
    term: BasisFamily,
    size: tuple[int, int],
    rho: np.ndarray,
    zeta: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Return radial factors (3, a, k) and axial factors (2, c, l) on the grid, see
    `strain_coefficients`."""
    value, slope = radial_functions(term, size[0], rho)
    axial_value, axial_slope = axial_functions(term, size[1], zeta)
    radial = np.stack([value, slope / plate.radius, value / (rho * plate.radius)])
    return radial, np.stack([axial_value, axial_slope * 2 / plate.thickness])


def elasticity_matrix(material: "Material") -> np.ndarray:
    """Return the stresses (6, 6) [Pa] due to unit strains, shear strains not doubled."""
    lam, mu = lame_constants(material)
    elasticity = np.diag([2 * mu] * 3 + [mu] * 3)
    elasticity[:3, :3] += lam
    return elasticity


def products_of_functions(
    plate: Plate, p: RitzProblem, size: tuple[int, int]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the integrals of products of two radial and of two axial functions."""
    rho, zeta, radial_weight, axial_weight = gauss_grid(plate, p.n, size)
    on_grid = [functions_on_grid(plate, t, size, rho, zeta) for t in p.terms]
    r = np.stack([radial for radial, _ in on_grid])
    z = np.stack([axial for _, axial in on_grid])
    return (
        np.einsum("siak,tjbk->stijab", r * radial_weight, r),
        np.einsum("sxcl,tydl->stxycd", z * axial_weight, z),
    )


def stiffness_and_mass(
    plate: Plate, p: RitzProblem, size: tuple[int, int]
) -> tuple[np.ndarray, np.ndarray]:
    """Return stiffness and mass (N, N) of one `RitzProblem`.

    They are int lam tr(eps)^2 + 2 mu eps:eps and int rho u.u. In the sums, s and t are
    the indices of terms, i and j those of radial factors, x and y those of axial
    factors of `functions_on_grid`.
    """
    elasticity = elasticity_matrix(plate.material)
    radial_products, axial_products = products_of_functions(plate, p, size)
    strain = np.stack([strain_coefficients(t, p.n) for t in p.terms])
    share = np.array([t.component_factors for t in p.terms], float)
    energy = np.einsum(
        "IJ,sIix,tJjy->stxyij", elasticity, strain, strain, optimize=True
    )
    radial_energy = np.einsum("stxyij,stijab->stxyab", energy, radial_products)
    stiffness = tensor_product(radial_energy, axial_products)
    radial_inertia = (
        radial_products[:, :, 0, 0]
        * plate.density
        * (share @ share.T)[:, :, None, None]
    )
    mass = tensor_product(radial_inertia, axial_products[:, :, 0, 0])
    return stiffness + ring_matrix(plate, p, size), mass


def translation_mass(plate: Plate, size: tuple[int, int]) -> float:
    """Return the mass [kg] of the Ritz model, from its kinetic energy in an axial
    translation.

    `size` is that of the basis. The edge is free, so that the plate can move as a
    rigid body.
    """
    free = replace(plate, edge="free", ring_stiffness=0.0)
    p = ritz_problem(free, 0, even=-1)
    translation = rigid_mode(free, p, size)[:, 0]
    return float(translation @ stiffness_and_mass(free, p, size)[1] @ translation)


def tensor_product(radial: np.ndarray, axial: np.ndarray) -> np.ndarray:
    """Return the matrix (N, N) with rows (s a c) and columns (t b d) from its radial
    and axial factors.

    The shapes of the factors are (s, t, ..., a, b) and (s, t, ..., c, d); the remaining
    indices are summed.
    """
    s, t, *_, a, b = radial.shape
    c, d = axial.shape[-2:]
    flat = radial.reshape(s, t, -1, a * b).swapaxes(2, 3) @ axial.reshape(
        s, t, -1, c * d
    )
    return (
        flat.reshape(s, t, a, b, c, d)
        .transpose(0, 2, 4, 1, 3, 5)
        .reshape(s * a * c, t * b * d)
    )


def ring_matrix(
    plate: Plate, p: RitzProblem, size: tuple[int, int]
) -> float | np.ndarray:
    """Return the stiffness (N, N) of the elastic ring, ring_stiffness times the
    integral of u_z^2 along it.

    u_z is averaged over z, so only the constant Legendre polynomial contributes.
    """
    if not plate.ring_stiffness or p.even > 0:
        return 0.0
    rho = np.array([plate.ring_radius / plate.radius])
    constant = np.eye(size[1])[0]
    at_ring = [radial_functions(t, size[0], rho)[0][:, 0] for t in p.terms]
    u_z = np.concatenate(
        [
            t.component_factors[2] * np.kron(r, constant)
            for t, r in zip(p.terms, at_ring, strict=True)
        ],
    )
    around = (2 * pi if p.n == 0 else pi) * plate.ring_radius
    return plate.ring_stiffness * around * np.outer(u_z, u_z)
