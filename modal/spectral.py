"""Axisymmetric solids spectrally: one Ritz problem per circumferential order n and symmetry in z.

u_r = a cos n theta, u_theta = b sin n theta, u_z = w cos n theta. A displacement is smooth on the axis if a + b,
a - b and w are r^|n+1|, r^|n-1| and r^n times polynomials in r^2: Jacobi polynomials, times Legendre polynomials in z.
"""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from scipy.linalg import eigh
from scipy.special import eval_jacobi, eval_legendre

from .elastic import lame, residuals

EDGES = {"free": (), "supported": ("axial",), "clamped": ("radial", "tangential", "axial")}
"""Which components of the displacement vanish all over the lateral surface."""
LARGEST = 27
"""Count of radial polynomials beyond which none is grown: a clamped edge is singular and converges slowly."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A solid cylinder: radius, thickness [m], `Material`, density [kg/m^3], edge "free", "supported" or "clamped",
    ring_stiffness [N/m^2]: an elastic ring of radius ring_radius [m] resists the axial motion averaged over the
    thickness, because on a line of a solid the displacement under a load is infinite."""

    radius: float
    thickness: float
    material: object
    density: float
    edge: str = "free"
    ring_radius: float = 0.0
    ring_stiffness: float = 0.0

    @property
    def mass(self):
        """Mass [kg]."""
        return self.density * pi * self.radius**2 * self.thickness


@dataclass(frozen=True, kw_only=True)
class Term:
    """A family of basis functions rho^power (polynomials in rho^2) (polynomials in z): its share of (u_r, u_theta,
    u_z), its symmetry in z (1 or -1), and whether it vanishes on the lateral surface."""

    power: int
    share: tuple[float, float, float]
    even: int
    held: bool = False


@dataclass(frozen=True, kw_only=True)
class Problem:
    """Order n, symmetry of the in-plane motion in z, family "meridional" or "torsional" (only for n = 0), terms."""

    n: int
    even: int
    family: str
    terms: tuple[Term, ...]


def problem(plate, n, even, torsional=False):
    """The `Problem` of one order and symmetry; the in-plane terms of n >= 1 are held together."""
    held = EDGES[plate.edge]
    if n == 0 and torsional:
        terms = (Term(power=1, share=(0, 1, 0), even=even, held="tangential" in held),)
        return Problem(n=n, even=even, family="torsional", terms=terms)
    axial = Term(power=n, share=(0, 0, 1), even=-even, held="axial" in held)
    powers = [(1, (1, 0, 0))] if n == 0 else [(n + 1, (1, 1, 0)), (n - 1, (1, -1, 0))]
    plane = [Term(power=k, share=share, even=even, held="radial" in held) for k, share in powers]
    return Problem(n=n, even=even, family="meridional", terms=(*plane, axial))


def radial(term, count, rho):
    """Values and slopes (count, k) at rho (k,) in [0, 1]."""
    j, k, x = np.arange(count)[:, None], term.power, 2 * rho**2 - 1
    poly = eval_jacobi(j, 0, k, x)
    slope = 2 * rho * (j + k + 1) * np.where(j > 0, eval_jacobi(np.maximum(j - 1, 0), 1, k + 1, x), 0.0)
    value = rho**k * poly
    slope = rho**k * slope + (k * rho ** max(k - 1, 0)) * poly
    if not term.held:
        return value, slope
    return (1 - rho**2) * value, (1 - rho**2) * slope - 2 * rho * value


def axial(term, count, zeta):
    """Values and slopes (count, k) at zeta (k,) in [-1, 1]."""
    order = np.arange(0 if term.even > 0 else 1, 2 * count, 2)[:, None]
    value = eval_legendre(order, zeta)
    below = eval_legendre(np.maximum(order - 1, 0), zeta)
    inside = np.maximum(1 - zeta**2, 1e-300)
    return value, order * (below - zeta * value) / inside


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
    """Gauss points rho in [0, 1] and zeta in [-1, 1], weights [m^2] and [m]; exact for the basis.

    In the radius they are Gauss points of rho^2, of which the integrands are polynomials.
    """
    x, wx = np.polynomial.legendre.leggauss(size[0] + n // 2 + 4)
    zeta, wz = np.polynomial.legendre.leggauss(2 * size[1] + 2)
    rho, around = ((x + 1) / 2) ** 0.5, 2 * pi if n == 0 else pi
    return rho, zeta, around * wx / 4 * plate.radius**2, wz * plate.thickness / 2


def on_grid(plate, term, size, rho, zeta):
    """Value, slope, value over r (3, a, k) of the radial functions and value, slope (2, c, l) of the axial ones."""
    value, slope = radial(term, size[0], rho)
    height, tilt = axial(term, size[1], zeta)
    over = np.stack([value, slope / plate.radius, value / (rho * plate.radius)])
    return over, np.stack([height, tilt * 2 / plate.thickness])


def matrices(plate, p, size):
    """Stiffness and mass (N, N) of one problem: int lam tr(eps)^2 + 2 mu eps:eps, and int rho u.u."""
    rho, zeta, weight, depth = gauss(plate, p.n, size)
    lam, mu = lame(plate.material)
    elasticity = np.diag([2 * mu] * 3 + [mu] * 3)
    elasticity[:3, :3] += lam
    grids = [on_grid(plate, term, size, rho, zeta) for term in p.terms]
    stiffness, mass = [], []
    for s, (r, z) in zip(p.terms, grids, strict=True):
        rows = []
        for t, (q, y) in zip(p.terms, grids, strict=True):
            along, through = np.einsum("iak,jbk,k->ijab", r, q, weight), np.einsum("icl,jdl,l->ijcd", z, y, depth)
            energy = np.einsum("IJ,Irz,Jsy->rzsy", elasticity, strain_of(s, p.n), strain_of(t, p.n))
            shared = plate.density * np.dot(s.share, t.share)
            shape = along.shape[2] * through.shape[2], along.shape[3] * through.shape[3]
            k = np.einsum("rzsy,rsab,zycd->acbd", energy, along, through, optimize=True)
            rows.append((k.reshape(shape), shared * np.kron(along[0, 0], through[0, 0])))
        stiffness.append([k for k, _ in rows])
        mass.append([m for _, m in rows])
    return np.block(stiffness) + ring(plate, p, size), np.block(mass)


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


def nested(p, size, smaller):
    """Indices of the basis of size `smaller` in that of `size`, both (radial, axial) counts."""
    grid = np.arange(len(p.terms) * size[0] * size[1]).reshape(len(p.terms), *size)
    return grid[:, : smaller[0], : smaller[1]].ravel()


def rigid_count(plate, p):
    """How many rigid-body modes a problem has: translations and rotations that neither edge nor ring resists."""
    held, n = EDGES[plate.edge], p.n
    if p.family == "torsional":
        return int(p.even > 0 and "tangential" not in held)
    if p.even > 0:
        return int(n == 1 and "radial" not in held)
    return int(n <= 1 and "axial" not in held and not plate.ring_stiffness)


@dataclass(frozen=True, kw_only=True)
class Pairs:
    """Solved pairs of one problem: values (k,) [1/s^2], coefficients (N, k), residual (k,), error (2, k)."""

    problem: Problem
    size: tuple[int, int]
    values: np.ndarray
    vectors: np.ndarray
    residual: np.ndarray
    error: np.ndarray


def solve(plate, p, size, below) -> Pairs:
    """The elastic pairs of one problem below `below` [Hz], of modal mass 1.

    ArithmeticError if its rigid-body modes are not null vectors; they drown in round-off below a thickness of 0.005 R.
    The two errors of a frequency (2, k) are its changes from the nested bases with one radial, one axial degree less.
    """
    k, m = matrices(plate, p, size)
    values, vectors = eigh(k, m, subset_by_value=(-np.inf, (2 * pi * below) ** 2))
    rigid = rigid_count(plate, p)
    values, vectors, null = values[rigid:], vectors[:, rigid:], values[:rigid]
    if len(values) and (np.abs(null) > 1e-4 * values[0]).any():
        raise ArithmeticError(f"order {p.n}: the eigenvalues of rigid-body modes are {null} 1/s^2, not 0: too thin?")
    smaller = ((size[0] - 1, size[1]), (size[0], size[1] - 1))
    rough = [spectrum(k, m, nested(p, size, s), rigid, len(values)) for s in smaller]
    return Pairs(
        problem=p,
        size=size,
        values=values,
        vectors=vectors,
        residual=residuals(k, m, values, vectors),
        error=np.abs(np.sqrt(np.array(rough) / values) - 1),
    )


def spectrum(k, m, index, skip, count):
    """The `count` eigenvalues after the first `skip` of the sub-problem of the given unknowns; inf if it has fewer."""
    if not count or skip + count > len(index):
        return np.full(count, np.inf)
    part = np.ix_(index, index)
    return eigh(k[part], m[part], eigvals_only=True, subset_by_index=(skip, skip + count - 1))


def first_size(plate, below):
    """Counts of radial and axial polynomials to start with: half the bending waves' number times the radius, plus 3.

    Thin-plate waves at `below` [Hz]: k^4 = w^2 rho 12 (1 - nu^2)/(E h^2); thick plates have longer ones.
    """
    stiffness = plate.material.young * plate.thickness**2 / (12 * (1 - plate.material.poisson**2))
    number = ((2 * pi * below) ** 2 * plate.density / stiffness) ** 0.25
    return 3 + ceil(number * plate.radius / 2), 2


def converged(plate, p, size, below, tolerance):
    """`solve` with a basis grown in the direction whose estimated error is larger, until their sum is below tolerance.

    The basis stops growing at LARGEST; the errors then say how far it came.
    """
    while True:
        pairs = solve(plate, p, size, below)
        along, through = pairs.error.max(axis=1, initial=0.0)
        if along + through < tolerance or size[0] >= LARGEST:
            return pairs
        size = (size[0] + 2, size[1]) if along > through else (size[0], size[1] + 1)


def all_pairs(plate, below, tolerance) -> list[Pairs]:
    """The elastic pairs of every order below `below` [Hz].

    Orders are taken up until two in a row have no mode: from order 2 on the lowest frequency rises with the order.
    """
    size = first_size(plate, below)
    found, empty, n = [], 0, 0
    while n < 3 or empty < 2:
        several = [problem(plate, n, even) for even in (1, -1)]
        if n == 0:
            several += [problem(plate, 0, even, torsional=True) for even in (1, -1)]
        solved = [converged(plate, p, size, below, tolerance) for p in several]
        found += [pairs for pairs in solved if len(pairs.values)]
        empty = 0 if any(len(pairs.values) for pairs in solved) else empty + 1
        n += 1
    return found


def amplitudes(plate, pairs, rho, zeta):
    """Amplitudes (3, k, r, z) of u_r, u_theta, u_z of each pair at rho (r,) in [0, 1] and zeta (z,) in [-1, 1]."""
    result, start = 0.0, 0
    for term in pairs.problem.terms:
        value, height = radial(term, pairs.size[0], rho)[0], axial(term, pairs.size[1], zeta)[0]
        count = len(value) * len(height)
        vectors = pairs.vectors[start : start + count].reshape(len(value), len(height), -1)
        u = np.einsum("ar,cz,ack->krz", value, height, vectors, optimize=True)
        result = result + np.multiply.outer(np.array(term.share, float), u)
        start += count
    return result
