"""The basis of Ritz's method for axisymmetric solids: one family of functions per component, order
n and z symmetry.

u_r = a cos n theta, u_theta = b sin n theta, u_z = w cos n theta. A displacement is smooth on the
axis if a + b, a - b and w are r^|n+1|, r^|n-1| and r^n times polynomials in r^2. The basis
functions are Jacobi polynomials in r times Legendre polynomials in z. With a hole about the axis
there is no such condition, and the polynomials in r are Legendre polynomials, too.
"""

from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from scipy.special import eval_jacobi, eval_legendre

EDGE_CONDITIONS = {
    "free": (),
    "supported": ("axial",),
    "clamped": ("radial", "tangential", "axial"),
}
"""Components of the displacement that vanish on the whole outer lateral surface, by edge."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A cylindrical plate of any thickness.

    An elastic ring may resist the axial motion averaged over the thickness. The average is needed
    because the displacement of a solid under a line load is infinite.

    Attributes
    ----------
    radius, thickness : float
        Size [m].
    material : Material
        Its young [Pa], poisson and loss_factor are used.
    density : float
        Density [kg/m^3].
    edge : {"free", "supported", "clamped"}
        Condition on the lateral surface.
    inner_radius : float
        Radius [m] of a hole along the axis; 0 without one.
    ring_radius : float
        Radius [m] of the elastic ring.
    ring_stiffness : float
        Stiffness of the ring per length [N/m^2]; 0 without a ring.

    Raises
    ------
    ValueError
        If the edge is unknown or a size or the density is not positive.

    Examples
    --------
    >>> from modal import Material
    >>> steel = Material(young=195e9, poisson=0.28)
    >>> plate = Plate(radius=0.05, thickness=0.002, material=steel, density=7800.0)
    >>> round(plate.mass, 4)
    0.1225
    """

    radius: float
    thickness: float
    material: Any
    density: float
    edge: str = "free"
    inner_radius: float = 0.0
    ring_radius: float = 0.0
    ring_stiffness: float = 0.0

    def __post_init__(self):
        if self.edge not in EDGE_CONDITIONS:
            raise ValueError(f"edge = {self.edge!r}: one of {', '.join(EDGE_CONDITIONS)}")
        is_cylinder = 0 <= self.inner_radius < self.radius and self.thickness > 0
        if not is_cylinder or not self.density > 0:
            raise ValueError(
                "a plate has 0 <= inner_radius < radius, and thickness and density above 0",
            )

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.density * pi * (self.radius**2 - self.inner_radius**2) * self.thickness

    @property
    def hole(self) -> float:
        """Ratio of the inner to the outer radius."""
        return self.inner_radius / self.radius


@dataclass(frozen=True, kw_only=True)
class Term:
    """A family of basis functions of rho = r/R and of z.

    In the radius they are rho^power times polynomials in rho^2, or polynomials in rho where there
    is a hole.
    """

    power: int
    """Power of rho on the axis."""
    share: tuple[float, float, float]
    """Factors of the functions in (u_r, u_theta, u_z)."""
    even: int
    """Symmetry in z: 1 or -1."""
    held: bool = False
    """True if the functions vanish on the lateral surface."""
    hole: float = 0.0
    """Inner over outer radius."""


@dataclass(frozen=True, kw_only=True)
class Problem:
    """One separate eigenvalue problem of an axisymmetric solid."""

    n: int
    """Order around the axis."""
    even: int
    """Symmetry of the in-plane motion in z: 1 or -1."""
    family: str
    """Components that move: "meridional", or "torsional" (n = 0 only)."""
    terms: tuple[Term, ...]
    """Families of basis functions."""


def problem(plate, n, even, torsional=False):
    """Return the `Problem` of one order and symmetry; the in-plane terms of n >= 1 are held
    together."""
    held = EDGE_CONDITIONS[plate.edge]
    hole = plate.hole
    if n == 0 and torsional:
        term = Term(power=1, share=(0, 1, 0), even=even, held="tangential" in held, hole=hole)
        return Problem(n=n, even=even, family="torsional", terms=(term,))
    axial = Term(power=n, share=(0, 0, 1), even=-even, held="axial" in held, hole=hole)
    powers = [(1, (1, 0, 0))] if n == 0 else [(n + 1, (1, 1, 0)), (n - 1, (1, -1, 0))]
    plane = []
    for k, share in powers:
        plane.append(Term(power=k, share=share, even=even, held="radial" in held, hole=hole))
    return Problem(n=n, even=even, family="meridional", terms=(*plane, axial))


def legendre_values(order, x):
    """Return values and slopes (j, k) of Legendre polynomials of orders (j, 1) at x (k,); slopes
    need |x| < 1."""
    value = eval_legendre(order, x)
    previous = eval_legendre(np.maximum(order - 1, 0), x)
    return value, order * (previous - x * value) / np.maximum(1 - x**2, 1e-300)


def radial_functions(term, count, rho):
    """Return values and slopes (count, k) of the radial functions of a `Term` at rho (k,)."""
    j = np.arange(count)[:, None]
    if term.hole:
        value, slope = legendre_values(
            j,
            np.clip((2 * rho - 1 - term.hole) / (1 - term.hole), -1, 1),
        )
        slope = slope * 2 / (1 - term.hole)
    else:
        value, slope = jacobi_values(j, term.power, rho)
    if not term.held:
        return value, slope
    return (1 - rho**2) * value, (1 - rho**2) * slope - 2 * rho * value


def jacobi_values(j, power, rho):
    """Return values and slopes of rho^power times Jacobi polynomials of orders j (count, 1) in
    rho^2."""
    k = power
    x = 2 * rho**2 - 1
    poly = eval_jacobi(j, 0, k, x)
    slope = (
        2 * rho * (j + k + 1) * np.where(j > 0, eval_jacobi(np.maximum(j - 1, 0), 1, k + 1, x), 0.0)
    )
    return rho**k * poly, rho**k * slope + (k * rho ** max(k - 1, 0)) * poly


def axial_functions(term, count, zeta):
    """Return values and slopes (count, k) of the axial functions of a `Term` at zeta (k,) in [-1,
    1]."""
    return legendre_values(np.arange(0 if term.even > 0 else 1, 2 * count, 2)[:, None], zeta)


def rigid_mode_count(plate, p):
    """Return how many rigid-body modes (0 or 1) a `Problem` has: those that neither edge nor ring
    resists."""
    held = EDGE_CONDITIONS[plate.edge]
    n = p.n
    if p.family == "torsional":
        return int(p.even > 0 and "tangential" not in held)
    if p.even > 0:
        return int(n == 1 and "radial" not in held)
    return int(n <= 1 and "axial" not in held and not plate.ring_stiffness)


def rigid_mode(plate, p, size):
    """Return the rigid-body mode (N, rigid_mode_count) of a `Problem` in the basis of `size`
    (radial, axial).

    Its parts are rho^power in the radius, with power 0 or 1, and the lowest polynomial in z.
    """
    if len(p.terms) == 1:
        weights = (1.0,)
    elif len(p.terms) == 2:
        weights = (0.0, 1.0)
    elif p.n == 1 and p.even < 0:
        weights = (0.0, -plate.thickness / (2 * plate.radius), 1.0)  # a rotation about a diameter
    else:
        weights = (0, 1.0, 0)
    lowest = np.eye(size[1])[0]
    parts = []
    for weight, term in zip(weights, p.terms, strict=True):
        parts.append(weight * np.kron(power_coefficients(term, size[0]), lowest))
    return np.concatenate(parts)[:, None][:, : rigid_mode_count(plate, p)]


def power_coefficients(term, count):
    """Return the coefficients (count,) of rho^power in the radial functions; with a hole for power
    0 or 1 only."""
    first = [1.0]
    if term.hole and term.power:
        first = [(1 + term.hole) / 2, (1 - term.hole) / 2]
    return np.array(first + [0.0] * (count - len(first)))
