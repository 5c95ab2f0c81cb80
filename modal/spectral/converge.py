"""The elastic modes of an axisymmetric solid, one Ritz problem after the other, each grown until it has converged."""

from dataclasses import dataclass
from math import ceil, inf, pi

import numpy as np
from scipy.linalg import eigh

from modal.elements.elastic import bending_number, residuals
from modal.spectral.basis import Problem, axial, problem, radial, rigid
from modal.spectral.ritz import matrices

LARGEST = 27
"""Count of radial polynomials beyond which none is grown: a clamped edge is singular and converges slowly."""


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

    The two errors of a frequency (2, k) are its changes from the nested bases with one radial, one axial degree less.
    """
    limit = (2 * pi * below) ** 2
    k, m, scale = scaled(plate, p, size, 4 * limit)
    inverse, vectors = eigh(m, k, subset_by_value=(1 / limit, inf))
    values, vectors = 1 / inverse[::-1], (vectors / np.sqrt(inverse))[:, ::-1]
    smaller = ((size[0] - 1, size[1]), (size[0], size[1] - 1))
    rough = [spectrum(k, m, nested(p, size, s), len(values)) for s in smaller]
    return Pairs(
        problem=p,
        size=size,
        values=values,
        vectors=scale[:, None] * vectors,
        residual=residuals(lambda load: np.linalg.solve(k, load), m, values, vectors),
        error=np.abs(np.sqrt(np.array(rough) / values) - 1),
    )


def scaled(plate, p, size, lifted):
    """Stiffness and mass (N, N) of the unknowns over `scale` (N,), which makes the diagonal of the stiffness 1.

    The rigid-body mode is given the eigenvalue `lifted` [1/s^2]. Bending is soft against shear as the square of the
    thickness over the radius, and its eigenvalues as the fourth power: m v = v^-2 k v, solved with a Cholesky factor of
    the stiffness so scaled, loses as many digits as the square costs, the usual form as many as the fourth (Demmel &
    Veselic 1992).
    """
    k, m = matrices(plate, p, size)
    mode = rigid(plate, p, size)
    momentum = m @ mode
    k = k + lifted * momentum @ momentum.T / np.sum(mode * momentum) if mode.size else k
    scale = np.diag(k) ** -0.5
    return k * np.outer(scale, scale), m * np.outer(scale, scale), scale


def nested(p, size, smaller):
    """Indices of the basis of size `smaller` in that of `size`, both (radial, axial) counts."""
    grid = np.arange(len(p.terms) * size[0] * size[1]).reshape(len(p.terms), *size)
    return grid[:, : smaller[0], : smaller[1]].ravel()


def spectrum(k, m, index, count):
    """The `count` lowest eigenvalues of the sub-problem of the given unknowns; inf if it has fewer."""
    size = len(index)
    if not count or count > size:
        return np.full(count, inf)
    part = np.ix_(index, index)
    return 1 / eigh(m[part], k[part], eigvals_only=True, subset_by_index=(size - count, size - 1))[::-1]


def first_size(plate, below):
    """Counts of radial and axial polynomials to start with: half the bending waves' number times the radius, plus 3.

    Waves at `below` [Hz] are as long as in a thin plate, or longer.
    """
    return 3 + ceil(bending_number(plate, below) * plate.radius / 2), 2


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

    Orders are taken up until two in a row have no mode: from order 2 on the lowest frequency rises with the order. Each
    starts with the basis that sufficed for the one before.
    """
    start, sizes = first_size(plate, below), {}
    found, empty, n = [], 0, 0
    while n < 3 or empty < 2:
        several = [problem(plate, n, even) for even in (1, -1)]
        if n == 0:
            several += [problem(plate, 0, even, torsional=True) for even in (1, -1)]
        solved = [converged(plate, p, sizes.get((p.even, p.family), start), below, tolerance) for p in several]
        sizes |= {(pairs.problem.even, pairs.problem.family): pairs.size for pairs in solved}
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
