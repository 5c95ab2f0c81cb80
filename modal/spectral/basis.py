"""Define the Ritz basis for axisymmetric solids of one order n and symmetry in z.

The displacement is u_r = a cos n theta, u_theta = b sin n theta, u_z = w cos n theta.
It is smooth on the axis if a + b, a - b and w are r^|n+1|, r^|n-1| and r^n times
polynomials in r^2. The basis functions are Jacobi polynomials in r times Legendre
polynomials in z. If there is a hole around the axis, this condition does not apply, and
Legendre polynomials in r are used.
"""

from dataclasses import dataclass
from itertools import product
from math import pi
from typing import Any

import numpy as np
from scipy.special import eval_jacobi, eval_legendre

EDGE_CONDITIONS = {
    "free": (),
    "supported": ("axial",),
    "clamped": ("radial", "tangential", "axial"),
}
"""Components of the displacement that vanish on the outer lateral surface for each edge
condition."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A cylindrical plate of any thickness.

    An elastic ring may resist the axial motion averaged over the thickness. The average
    is used because the displacement of a solid under a line load is infinite.

    Attributes
    ----------
    radius, thickness : float
        Size [m].
    material : Material
        Object with young [Pa], poisson and loss_factor.
    density : float
        Density [kg/m^3].
    edge : {"free", "supported", "clamped"}
        Boundary condition on the lateral surface.
    inner_radius : float
        Radius [m] of a hole along the axis, or 0 if there is none.
    ring_radius : float
        Radius [m] of the elastic ring.
    ring_stiffness : float
        Stiffness of the ring per length [N/m^2], or 0 if there is none.

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

    def __post_init__(self) -> None:
        if self.edge not in EDGE_CONDITIONS:
            raise ValueError(
                f"edge = {self.edge!r}: must be one of {', '.join(EDGE_CONDITIONS)}"
            )
        is_cylinder = 0 <= self.inner_radius < self.radius and self.thickness > 0
        if not is_cylinder or not self.density > 0:
            raise ValueError(
                "a plate must have 0 <= inner_radius < radius and thickness and density above 0",
            )

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return (
            self.density * pi * (self.radius**2 - self.inner_radius**2) * self.thickness
        )

    @property
    def hole(self) -> float:
        """Ratio of the inner to the outer radius."""
        return self.inner_radius / self.radius


@dataclass(frozen=True, kw_only=True)
class BasisFamily:
    """A family of basis functions of rho = r/R and z.

    The radial functions are rho^power times polynomials in rho^2, or polynomials in rho
    if there is a hole.
    """

    power: int
    """Exponent of rho near the axis."""
    component_factors: tuple[float, float, float]
    """Factors of the functions in (u_r, u_theta, u_z)."""
    even: int
    """Symmetry in z: 1 or -1."""
    held: bool = False
    """True if the functions vanish on the lateral surface."""
    hole: float = 0.0
    """Ratio of the inner to the outer radius."""


@dataclass(frozen=True, kw_only=True)
class RitzProblem:
    """Separate eigenvalue problem of an axisymmetric solid."""

    n: int
    """Circumferential order."""
    even: int
    """Symmetry of the in-plane motion in z: 1 or -1."""
    family: str
    """Components in motion: "meridional", or "torsional" (n = 0 only)."""
    terms: tuple[BasisFamily, ...]
    """Families of basis functions."""


def ritz_problem(
    plate: Plate, n: int, even: int, torsional: bool = False
) -> RitzProblem:
    """Return the `RitzProblem` of one order and symmetry.

    For n >= 1 both in-plane terms vanish on a lateral surface that is held radially."""

    def basis_family(
        power: int, factors: tuple[float, float, float], symmetry: int, component: str
    ) -> BasisFamily:
        return BasisFamily(
            power=power,
            component_factors=factors,
            even=symmetry,
            held=component in EDGE_CONDITIONS[plate.edge],
            hole=plate.hole,
        )

    if n == 0 and torsional:
        term = basis_family(1, (0, 1, 0), even, "tangential")
        return RitzProblem(n=n, even=even, family="torsional", terms=(term,))
    plane = [basis_family(1, (1, 0, 0), even, "radial")]
    if n > 0:
        plane = [
            basis_family(n + 1, (1, 1, 0), even, "radial"),
            basis_family(n - 1, (1, -1, 0), even, "radial"),
        ]
    axial = basis_family(n, (0, 0, 1), -even, "axial")
    return RitzProblem(n=n, even=even, family="meridional", terms=(*plane, axial))


def ritz_problems(plate: Plate, n: int) -> list[RitzProblem]:
    """Return the independent `RitzProblem` records of one order."""
    kinds = (False, True) if n == 0 else (False,)
    return [
        ritz_problem(plate, n, even, torsional)
        for torsional, even in product(kinds, (1, -1))
    ]


def legendre_values(order: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return values and slopes (j, k) of Legendre polynomials of orders (j, 1) at x
    (k,).

    Slopes are valid for |x| < 1."""
    value = eval_legendre(order, x)
    previous = eval_legendre(np.maximum(order - 1, 0), x)
    return value, order * (previous - x * value) / np.maximum(1 - x**2, 1e-300)


def radial_functions(
    term: BasisFamily, count: int, rho: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return values and slopes (count, k) of the radial functions of a `BasisFamily` at
    rho (k,)."""
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


def jacobi_values(
    j: np.ndarray, power: int, rho: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return values and slopes of rho^power times Jacobi polynomials of orders j
    (count, 1) in rho^2."""
    k = power
    x = 2 * rho**2 - 1
    poly = eval_jacobi(j, 0, k, x)
    slope = (
        2
        * rho
        * (j + k + 1)
        * np.where(j > 0, eval_jacobi(np.maximum(j - 1, 0), 1, k + 1, x), 0.0)
    )
    return rho**k * poly, rho**k * slope + (k * rho ** max(k - 1, 0)) * poly


def axial_functions(
    term: BasisFamily, count: int, zeta: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return values and slopes (count, k) of the axial functions of a `BasisFamily` at
    zeta (k,) in [-1, 1]."""
    return legendre_values(
        np.arange(0 if term.even > 0 else 1, 2 * count, 2)[:, None], zeta
    )


def rigid_mode_count(plate: Plate, p: RitzProblem) -> int:
    """Return the number (0 or 1) of rigid-body modes of a `RitzProblem` not prevented
    by edge or ring."""
    held = EDGE_CONDITIONS[plate.edge]
    n = p.n
    if p.family == "torsional":
        return int(p.even > 0 and "tangential" not in held)
    if p.even > 0:
        return int(n == 1 and "radial" not in held)
    return int(n <= 1 and "axial" not in held and not plate.ring_stiffness)


def rigid_mode(plate: Plate, p: RitzProblem, size: tuple[int, int]) -> np.ndarray:
    """Return the rigid-body mode (N, rigid_mode_count) of a `RitzProblem` in the basis
    of `size` (radial, axial).

    Its parts are rho^power with power 0 or 1 times the lowest polynomial in z.
    """
    if len(p.terms) == 1:
        weights: tuple[float, ...] = (1.0,)
    elif len(p.terms) == 2:
        weights = (0.0, 1.0)
    elif p.n == 1 and p.even < 0:
        # rotation about a diameter
        weights = (0.0, -plate.thickness / (2 * plate.radius), 1.0)
    else:
        weights = (0, 1.0, 0)
    lowest = np.eye(size[1])[0]
    parts = [
        weight * np.kron(power_coefficients(term, size[0]), lowest)
        for weight, term in zip(weights, p.terms, strict=True)
    ]
    return np.concatenate(parts)[:, None][:, : rigid_mode_count(plate, p)]


def power_coefficients(term: BasisFamily, count: int) -> np.ndarray:
    """Return the coefficients (count,) of rho^power in the radial functions.

    If there is a hole, the power must be 0 or 1."""
    first = [1.0]
    if term.hole and term.power:
        first = [(1 + term.hole) / 2, (1 - term.hole) / 2]
    return np.array(first + [0.0] * (count - len(first)))
