"""The basis of Ritz's method for axisymmetric solids: one family of functions per component, order n and symmetry in z.

u_r = a cos n theta, u_theta = b sin n theta, u_z = w cos n theta. A displacement is smooth on the axis if a + b,
a - b and w are r^|n+1|, r^|n-1| and r^n times polynomials in r^2: Jacobi polynomials, times Legendre polynomials in z.
Where there is a hole about the axis nothing of the kind is asked: Legendre polynomials in r as well.
"""

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.special import eval_jacobi, eval_legendre

EDGES = {"free": (), "supported": ("axial",), "clamped": ("radial", "tangential", "axial")}
"""Which components of the displacement vanish all over the outer lateral surface."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A cylinder: radius, thickness [m], `Material`, density [kg/m^3], edge "free", "supported" or "clamped",
    inner_radius [m] of the hole along its axis, 0 for none,
    ring_stiffness [N/m^2]: an elastic ring of radius ring_radius [m] resists the axial motion averaged over the
    thickness, because on a line of a solid the displacement under a load is infinite."""

    radius: float
    thickness: float
    material: object
    density: float
    edge: str = "free"
    inner_radius: float = 0.0
    ring_radius: float = 0.0
    ring_stiffness: float = 0.0

    def __post_init__(self):
        if self.edge not in EDGES:
            raise ValueError(f"edge = {self.edge!r}: one of {', '.join(EDGES)}")
        if not 0 <= self.inner_radius < self.radius or not self.thickness > 0 or not self.density > 0:
            raise ValueError("a plate has 0 <= inner_radius < radius, a thickness and a density above 0")

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.density * pi * (self.radius**2 - self.inner_radius**2) * self.thickness

    @property
    def hole(self) -> float:
        """Inner over outer radius."""
        return self.inner_radius / self.radius


@dataclass(frozen=True, kw_only=True)
class Term:
    """A family of basis functions of rho = r/R and of z: its share of (u_r, u_theta, u_z), its symmetry in z (1 or -1),
    and whether it vanishes on the lateral surface. In the radius rho^power times polynomials in rho^2, or, where the
    radius of the hole is not 0, polynomials in rho from there to 1."""

    power: int
    share: tuple[float, float, float]
    even: int
    held: bool = False
    hole: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Problem:
    """Order n, symmetry of the in-plane motion in z, family "meridional" or "torsional" (only for n = 0), terms."""

    n: int
    even: int
    family: str
    terms: tuple[Term, ...]


def problem(plate, n, even, torsional=False):
    """The `Problem` of one order and symmetry; the in-plane terms of n >= 1 are held together."""
    held, hole = EDGES[plate.edge], plate.hole
    if n == 0 and torsional:
        terms = (Term(power=1, share=(0, 1, 0), even=even, held="tangential" in held, hole=hole),)
        return Problem(n=n, even=even, family="torsional", terms=terms)
    axial = Term(power=n, share=(0, 0, 1), even=-even, held="axial" in held, hole=hole)
    powers = [(1, (1, 0, 0))] if n == 0 else [(n + 1, (1, 1, 0)), (n - 1, (1, -1, 0))]
    plane = [Term(power=k, share=share, even=even, held="radial" in held, hole=hole) for k, share in powers]
    return Problem(n=n, even=even, family="meridional", terms=(*plane, axial))


def legendre(order, x):
    """Values and slopes (j, k) of Legendre's polynomials of orders (j, 1) at x (k,), slopes inside (-1, 1) only."""
    value = eval_legendre(order, x)
    below = eval_legendre(np.maximum(order - 1, 0), x)
    return value, order * (below - x * value) / np.maximum(1 - x**2, 1e-300)


def radial(term, count, rho):
    """Values and slopes (count, k) at rho (k,) from the radius of the hole to 1."""
    j = np.arange(count)[:, None]
    if term.hole:
        value, slope = legendre(j, np.clip((2 * rho - 1 - term.hole) / (1 - term.hole), -1, 1))
        slope = slope * 2 / (1 - term.hole)
    else:
        value, slope = about_axis(j, term.power, rho)
    if not term.held:
        return value, slope
    return (1 - rho**2) * value, (1 - rho**2) * slope - 2 * rho * value


def about_axis(j, power, rho):
    """rho^power times Jacobi's polynomials of orders j (count, 1) in rho^2, and their slopes."""
    k, x = power, 2 * rho**2 - 1
    poly = eval_jacobi(j, 0, k, x)
    slope = 2 * rho * (j + k + 1) * np.where(j > 0, eval_jacobi(np.maximum(j - 1, 0), 1, k + 1, x), 0.0)
    return rho**k * poly, rho**k * slope + (k * rho ** max(k - 1, 0)) * poly


def axial(term, count, zeta):
    """Values and slopes (count, k) at zeta (k,) in [-1, 1]."""
    return legendre(np.arange(0 if term.even > 0 else 1, 2 * count, 2)[:, None], zeta)


def rigid_count(plate, p):
    """How many rigid-body modes a problem has, 0 or 1: the translation or rotation that neither edge nor ring
    resists."""
    held, n = EDGES[plate.edge], p.n
    if p.family == "torsional":
        return int(p.even > 0 and "tangential" not in held)
    if p.even > 0:
        return int(n == 1 and "radial" not in held)
    return int(n <= 1 and "axial" not in held and not plate.ring_stiffness)


def rigid(plate, p, size):
    """The rigid-body mode (N, rigid_count) of a problem in the basis of `size`, (radial, axial) counts.

    Its parts are rho^power in the radius, power 0 or 1, and go with the lowest polynomial in z.
    """
    tilt = p.n == 1 and p.even < 0
    weights = {1: (1.0,), 2: (0.0, 1.0), 3: (0.0, -plate.thickness / (2 * plate.radius), 1.0) if tilt else (0, 1.0, 0)}
    lowest = np.eye(size[1])[0]
    parts = [w * np.kron(plain(t, size[0]), lowest) for w, t in zip(weights[len(p.terms)], p.terms, strict=True)]
    return np.concatenate(parts)[:, None][:, : rigid_count(plate, p)]


def plain(term, count):
    """Coefficients (count,) of rho^power, power 0 or 1 where there is a hole."""
    first = [(1 + term.hole) / 2, (1 - term.hole) / 2] if term.hole and term.power else [1.0]
    return np.array(first + [0.0] * (count - len(first)))
