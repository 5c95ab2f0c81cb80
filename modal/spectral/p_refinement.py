"""The elastic modes of an axisymmetric solid: Ritz problem by Ritz problem, with a basis grown to
convergence."""

from dataclasses import dataclass
from math import ceil, inf, pi

import numpy as np
from scipy.linalg import eigh

from modal.elements.elastic import bending_wave_number, eigenpair_residuals
from modal.progress import report
from modal.spectral.basis import Problem, axial_functions, problem, radial_functions, rigid_mode
from modal.spectral.ritz import matrices


@dataclass(frozen=True, kw_only=True)
class Eigenpairs:
    """Eigenpairs of one `Problem`."""

    problem: Problem
    size: tuple[int, int]
    """Counts of radial and axial polynomials per term."""
    values: np.ndarray
    """Eigenvalues (k,) [1/s^2]."""
    vectors: np.ndarray
    """Coefficients (N, k) of modal mass 1."""
    residual: np.ndarray
    """Residuals (k,)."""
    error: np.ndarray
    """Estimated relative errors (2, k) of the frequencies, in the radius and in z."""


def solve_problem(plate, p, size, below) -> Eigenpairs:
    """Return the elastic `Eigenpairs` of one `Problem` below `below` [Hz].

    The two errors of a frequency are its changes from the nested bases with one radial and one
    axial degree less.
    """
    limit = (2 * pi * below) ** 2
    k, m, scale = scaled_matrices(plate, p, size, 4 * limit)
    inverse, vectors = eigh(m, k, subset_by_value=(1 / limit, inf))
    values = 1 / inverse[::-1]
    vectors = (vectors / np.sqrt(inverse))[:, ::-1]
    smaller_sizes = ((size[0] - 1, size[1]), (size[0], size[1] - 1))
    coarse = []
    for smaller in smaller_sizes:
        coarse.append(lowest_eigenvalues(k, m, nested_indices(p, size, smaller), len(values)))
    return Eigenpairs(
        problem=p,
        size=size,
        values=values,
        vectors=scale[:, None] * vectors,
        residual=eigenpair_residuals(lambda load: np.linalg.solve(k, load), m, values, vectors),
        error=np.abs(np.sqrt(np.array(coarse) / values) - 1),
    )


def scaled_matrices(plate, p, size, rigid_value):
    """Return stiffness and mass (N, N) of the unknowns over scale (N,), and the scale, with a
    stiffness diagonal of 1.

    The rigid-body mode gets the eigenvalue `rigid_value` [1/s^2]. Bending is softer than shear by
    the square of the thickness over the radius, and its eigenvalues are smaller by the fourth
    power. The problem m v = v^-2 k v, solved with a Cholesky factor of the stiffness so scaled,
    loses as many digits as the square, the usual form as many as the fourth power (Demmel & Veselic
    1992).
    """
    k, m = matrices(plate, p, size)
    mode = rigid_mode(plate, p, size)
    momentum = m @ mode
    if mode.size:
        k = k + rigid_value * momentum @ momentum.T / np.sum(mode * momentum)
    scale = np.diag(k) ** -0.5
    return k * np.outer(scale, scale), m * np.outer(scale, scale), scale


def nested_indices(p, size, smaller):
    """Return the indices of the basis of size `smaller` in that of `size`, both (radial, axial)
    counts."""
    grid = np.arange(len(p.terms) * size[0] * size[1]).reshape(len(p.terms), *size)
    return grid[:, : smaller[0], : smaller[1]].ravel()


def lowest_eigenvalues(k, m, index, count):
    """Return the `count` lowest eigenvalues of the problem restricted to some unknowns; inf if it
    has fewer."""
    size = len(index)
    if not count or count > size:
        return np.full(count, inf)
    part = np.ix_(index, index)
    inverse = eigh(m[part], k[part], eigvals_only=True, subset_by_index=(size - count, size - 1))
    return 1 / inverse[::-1]


def first_basis_size(plate, below):
    """Return the first numbers of radial and axial polynomials.

    They are half of wave number times radius, plus 3, and 2. Waves at `below` [Hz] are at least as
    long
    as in a thin plate.
    """
    wave_number = bending_wave_number(plate.material, plate.thickness, plate.density, below)
    return 3 + ceil(wave_number * plate.radius / 2), 2


def solve_to_tolerance(plate, p, size, below, tolerance, max_radial_count=27):
    """Return the `Eigenpairs` of a basis that is large enough for the tolerance.

    The basis starts at `size` and grows in the direction with the larger error, until the sum of
    both
    errors is below the tolerance. It is limited to `max_radial_count` radial polynomials, because a
    clamped edge is singular and converges slowly. In this case the errors are those of the largest
    basis.
    """
    while True:
        pairs = solve_problem(plate, p, size, below)
        radial_error, axial_error = pairs.error.max(axis=1, initial=0.0)
        if radial_error + axial_error < tolerance or size[0] >= max_radial_count:
            return pairs
        size = (size[0] + 2, size[1]) if radial_error > axial_error else (size[0], size[1] + 1)


def all_eigenpairs(plate, below, tolerance) -> list[Eigenpairs]:
    """Return the elastic `Eigenpairs` of every order below `below` [Hz].

    The search ends after two orders without a mode: from order 2 on the lowest frequency rises with
    the order. Each order starts with the basis that sufficed for the previous one.
    """
    start = first_basis_size(plate, below)
    sizes = {}
    found = []
    empty = 0
    n = 0
    wave_number = bending_wave_number(plate.material, plate.thickness, plate.density, below)
    expected_orders = wave_number * plate.radius + 2
    while n < 3 or empty < 2:
        problems = [problem(plate, n, even) for even in (1, -1)]
        if n == 0:
            problems += [problem(plate, 0, even, torsional=True) for even in (1, -1)]
        solved = []
        for p in problems:
            size = sizes.get((p.even, p.family), start)
            solved.append(solve_to_tolerance(plate, p, size, below, tolerance))
        sizes |= {(pairs.problem.even, pairs.problem.family): pairs.size for pairs in solved}
        found += [pairs for pairs in solved if len(pairs.values)]
        empty = 0 if any(len(pairs.values) for pairs in solved) else empty + 1
        n += 1
        report(min(n / expected_orders, 1.0))
    return found


def displacement_amplitudes(plate, pairs, rho, zeta):
    """Return the amplitudes (3, k, r, z) of u_r, u_theta, u_z at rho (r,) in [0, 1] and zeta (z,)
    in [-1, 1]."""
    result = 0.0
    start = 0
    for term in pairs.problem.terms:
        radial = radial_functions(term, pairs.size[0], rho)[0]
        axial = axial_functions(term, pairs.size[1], zeta)[0]
        count = len(radial) * len(axial)
        vectors = pairs.vectors[start : start + count].reshape(len(radial), len(axial), -1)
        u = np.einsum("ar,cz,ack->krz", radial, axial, vectors, optimize=True)
        result = result + np.multiply.outer(np.array(term.share, float), u)
        start += count
    return result
