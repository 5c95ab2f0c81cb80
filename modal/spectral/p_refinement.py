"""Solve the Ritz problems of an axisymmetric solid with bases enlarged until
convergence."""

from dataclasses import dataclass
from math import ceil, inf, pi

import numpy as np
from scipy.linalg import eigh

from modal.elements.elastic import bending_wave_number, eigenpair_residuals
from modal.progress import report_progress
from modal.spectral.basis import (
    Plate,
    RitzProblem,
    axial_functions,
    radial_functions,
    rigid_mode,
    ritz_problems,
)
from modal.spectral.ritz import stiffness_and_mass


@dataclass(frozen=True, kw_only=True)
class Eigenpairs:
    """Eigenpairs of one `RitzProblem`."""

    problem: RitzProblem
    size: tuple[int, int]
    """Numbers of radial and axial polynomials per term."""
    values: np.ndarray
    """Eigenvalues (k,) [1/s^2]."""
    vectors: np.ndarray
    """Coefficients (N, k) of shapes of unit modal mass."""
    residual: np.ndarray
    """Residuals (k,)."""
    error: np.ndarray
    """Estimated relative errors (2, k) of the frequencies due to the radial and the
    axial basis."""


def solve_problem(
    plate: Plate, p: RitzProblem, size: tuple[int, int], below: float
) -> Eigenpairs:
    """Return the elastic `Eigenpairs` of one `RitzProblem` below a frequency [Hz].

    The two errors of a frequency are its differences from the frequencies in nested
    bases with one radial or one axial polynomial fewer.
    """
    limit = (2 * pi * below) ** 2
    k, m, scale = scaled_matrices(plate, p, size, 4 * limit)
    inverse, vectors = eigh(m, k, subset_by_value=(1 / limit, inf))
    values = 1 / inverse[::-1]
    vectors = (vectors / np.sqrt(inverse))[:, ::-1]
    coarse = [
        lowest_eigenvalues(k, m, nested_indices(p, size, smaller), len(values))
        for smaller in ((size[0] - 1, size[1]), (size[0], size[1] - 1))
    ]
    return Eigenpairs(
        problem=p,
        size=size,
        values=values,
        vectors=scale[:, None] * vectors,
        residual=eigenpair_residuals(
            lambda load: np.linalg.solve(k, load), m, values, vectors
        ),
        error=np.abs(np.sqrt(np.array(coarse) / values) - 1),
    )


def scaled_matrices(
    plate: Plate, p: RitzProblem, size: tuple[int, int], rigid_value: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return stiffness and mass (N, N), scaled to a unit stiffness diagonal, and the
    scale (N,).

    The eigenvalue of the rigid-body mode is raised to `rigid_value` [1/s^2]. The
    stiffness of bending is smaller than that of shear by the square of the ratio of
    thickness to radius, and its eigenvalues are smaller by the fourth power. With a
    Cholesky factor of the scaled stiffness, solving m v = v^-2 k v amplifies round-off
    only by the square of this ratio, whereas the usual form amplifies it by the fourth
    power (Demmel & Veselic 1992).
    """
    k, m = stiffness_and_mass(plate, p, size)
    mode = rigid_mode(plate, p, size)
    momentum = m @ mode
    if mode.size:
        k = k + rigid_value * momentum @ momentum.T / np.sum(mode * momentum)
    scale = np.diag(k) ** -0.5
    return k * np.outer(scale, scale), m * np.outer(scale, scale), scale


def nested_indices(
    p: RitzProblem, size: tuple[int, int], smaller: tuple[int, int]
) -> np.ndarray:
    """Return the indices of a smaller basis in one of `size`, both given as (radial,
    axial) counts."""
    terms = len(p.terms)
    grid = np.arange(terms * size[0] * size[1]).reshape(terms, *size)
    return grid[:, : smaller[0], : smaller[1]].ravel()


def lowest_eigenvalues(
    k: np.ndarray, m: np.ndarray, index: np.ndarray, count: int
) -> np.ndarray:
    """Return the `count` lowest eigenvalues of the problem restricted to the unknowns
    `index`.

    They are infinite if the restricted problem has fewer unknowns."""
    size = len(index)
    if not count or count > size:
        return np.full(count, inf)
    part = np.ix_(index, index)
    inverse = eigh(
        m[part], k[part], eigvals_only=True, subset_by_index=(size - count, size - 1)
    )
    return 1 / inverse[::-1]


def first_basis_size(plate: Plate, below: float) -> tuple[int, int]:
    """Return the initial numbers of radial and axial polynomials.

    They are 3 plus half of wavenumber times radius, and 2. Waves at `below` [Hz] are
    at least as long as in a thin plate.
    """
    wave_number = bending_wave_number(
        plate.material, plate.thickness, plate.density, below
    )
    return 3 + ceil(wave_number * plate.radius / 2), 2


def solve_to_tolerance(
    plate: Plate, p: RitzProblem, size: tuple[int, int], below: float, tolerance: float
) -> Eigenpairs:
    """Return the `Eigenpairs` of a basis large enough for the tolerance.

    The basis starts at `size` and is enlarged in the direction of the larger error
    until the sum of both errors is below the tolerance. The number of radial
    polynomials is limited, because convergence at a clamped, hence singular, edge is
    slow; the errors are then those of the largest basis.
    """
    max_radial_count = 27
    while True:
        pairs = solve_problem(plate, p, size, below)
        radial_error, axial_error = pairs.error.max(axis=1, initial=0.0)
        if radial_error + axial_error < tolerance or size[0] >= max_radial_count:
            return pairs
        size = (
            (size[0] + 2, size[1])
            if radial_error > axial_error
            else (size[0], size[1] + 1)
        )


def all_eigenpairs(plate: Plate, below: float, tolerance: float) -> list[Eigenpairs]:
    """Return the elastic `Eigenpairs` of all orders below a frequency [Hz].

    The search ends after two orders without modes, because the lowest frequency
    increases with the order from order 2 on. Each order starts with the final basis of
    the previous one.
    """
    start = first_basis_size(plate, below)
    sizes: dict[tuple[int, str], tuple[int, int]] = {}
    found: list[Eigenpairs] = []
    empty = 0
    n = 0
    wave_number = bending_wave_number(
        plate.material, plate.thickness, plate.density, below
    )
    expected_orders = wave_number * plate.radius + 2
    while n < 3 or empty < 2:
        before = len(found)
        for p in ritz_problems(plate, n):
            kind = (p.even, p.family)
            size = sizes.get(kind, start)
            pairs = solve_to_tolerance(plate, p, size, below, tolerance)
            sizes[kind] = pairs.size
            if len(pairs.values):
                found.append(pairs)
        empty = 0 if len(found) > before else empty + 1
        n += 1
        report_progress(min(n / expected_orders, 1.0))
    return found


def displacement_amplitudes(
    pairs: Eigenpairs, rho: np.ndarray, zeta: np.ndarray
) -> np.ndarray:
    """Return the amplitudes (3, k, r, z) of u_r, u_theta, u_z at rho (r,) and zeta
    (z,).

    The ranges are [0, 1] for rho and [-1, 1] for zeta."""
    result = np.zeros(())
    start = 0
    for term in pairs.problem.terms:
        radial = radial_functions(term, pairs.size[0], rho)[0]
        axial = axial_functions(term, pairs.size[1], zeta)[0]
        count = len(radial) * len(axial)
        vectors = pairs.vectors[start : start + count].reshape(
            len(radial), len(axial), -1
        )
        u = np.einsum("ar,cz,ack->krz", radial, axial, vectors, optimize=True)
        result = result + np.multiply.outer(np.array(term.component_factors, float), u)
        start += count
    return result
