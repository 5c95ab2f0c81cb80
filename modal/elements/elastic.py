"""Assemble matrices of linear elasticity for scalar Lagrange elements, and solve for
the lowest eigenpairs."""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, pi
from typing import TYPE_CHECKING

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem import CellBasis, Element, Mesh

if TYPE_CHECKING:
    from modal.modes import Material
    from modal.spectral.basis import Plate


@dataclass(frozen=True, kw_only=True)
class Solid:
    """Discretised elastic solid; unknown 3 node + component is a displacement component
    of a node."""

    points: np.ndarray
    """Nodes (p, 3) [m]."""
    cells: np.ndarray
    """Node numbers (c, nodes) of each cell in scikit-fem's order."""
    stiffness: sp.csr_matrix
    """Stiffness matrix (3p, 3p) [N/m]."""
    mass: sp.csr_matrix
    """Mass matrix (3p, 3p) [kg]."""
    total_mass: float
    """Mass of the meshed volume [kg]."""


def lame_constants(material: "Material") -> tuple[float, float]:
    """Return Lame's first and second constants [Pa]."""
    young = material.young
    poisson = material.poisson
    first = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    second = young / (2 * (1 + poisson))
    return first, second


def bending_wave_number(
    material: "Material", thickness: float, density: float, frequency: float
) -> float:
    """Return the bending wavenumber k [1/m] of a thin plate at a frequency [Hz].

    k^4 = w^2 rho 12 (1 - nu^2)/(E h^2)."""
    stiffness = material.young * thickness**2 / (12 * (1 - material.poisson**2))
    return ((2 * np.pi * frequency) ** 2 * density / stiffness) ** 0.25


def estimated_mode_count(plate: "Plate", below: float) -> float:
    """Return a conservative estimate of the number of modes of a disk below a frequency
    [Hz].

    A plate has (k R)^2/4 bending modes. A body has (4 pi/3) (f/c)^3 modes per wave type
    and unit volume (Weyl 1912, Debye 1912). The contribution of surfaces and edges,
    which may double the number, is neglected.
    """
    lam, mu = lame_constants(plate.material)
    wave_number = bending_wave_number(
        plate.material, plate.thickness, plate.density, below
    )
    bending = (wave_number * plate.radius) ** 2 / 4
    shear_speed = (mu / plate.density) ** 0.5
    pressure_speed = ((lam + 2 * mu) / plate.density) ** 0.5
    volume = pi * plate.radius**2 * plate.thickness
    slowness = 2 / shear_speed**3 + 1 / pressure_speed**3
    return bending + volume * 4 * pi / 3 * below**3 * slowness


def assemble_solid(
    mesh: Mesh, element: Element, material: "Material", density: float, intorder: int
) -> Solid:
    """Return the `Solid` of a scikit-fem mesh with its stiffness and mass matrices.

    K = int lam div u div v + 2 mu eps(u):eps(v), M = int rho u.v, assembled for all
    cells at once. With S[a i, b j] = int d_i phi_a d_j phi_b the stiffness is lam S[a
    i, b j] + mu S[a j, b i] + mu delta_ij S[a k, b k].
    """
    basis = CellBasis(mesh, element, intorder=intorder)
    cells = basis.element_dofs.T
    nodes = basis.N
    count = cells.shape[1]
    c = len(cells)
    q = basis.dx.shape[1]
    grad = np.stack([np.broadcast_to(f[0].grad, (3, c, q)) for f in basis.basis])
    value = np.stack(
        [np.broadcast_to(np.asarray(f[0]), (c, q)) for f in basis.basis], axis=1
    )
    grad = grad.transpose(2, 0, 1, 3).reshape(c, 3 * count, q)
    s = ((grad * basis.dx[:, None]) @ grad.transpose(0, 2, 1)).reshape(
        c, count, 3, count, 3
    )
    lam, mu = lame_constants(material)
    k = lam * s + mu * s.transpose(0, 1, 4, 3, 2)
    k[:, :, range(3), :, range(3)] += mu * np.einsum("eakbk->eab", s)
    m = density * (value * basis.dx[:, None]) @ value.transpose(0, 2, 1)
    dofs = (3 * cells[:, :, None] + np.arange(3)).reshape(c, -1)
    return Solid(
        points=basis.doflocs.T.copy(),
        cells=cells,
        stiffness=sum_cell_matrices(
            k.reshape(c, 3 * count, 3 * count), dofs, 3 * nodes
        ),
        mass=sp.kron(sum_cell_matrices(m, cells, nodes), sp.identity(3)).tocsr(),
        total_mass=float(density * basis.dx.sum()),
    )


def sum_cell_matrices(blocks: np.ndarray, dofs: np.ndarray, size: int) -> sp.csr_matrix:
    """Return the sparse sum (size, size) of cell matrices (c, n, n) for unknowns `dofs`
    (c, n)."""
    n = dofs.shape[1]
    rows = np.repeat(dofs, n, axis=1).ravel()
    columns = np.tile(dofs, (1, n)).ravel()
    return sp.csr_matrix((blocks.ravel(), (rows, columns)), shape=(size, size))


def inverse_at(
    stiffness: sp.spmatrix, mass: sp.spmatrix, shift: float
) -> LinearOperator:
    """Return (K - shift M)^-1 as a linear operator.

    SuperLU factorises the matrix in symmetric mode with diagonal pivots and the
    ordering MMD_AT_PLUS_A.
    """
    matrix = (stiffness - shift * mass).tocsc() if shift else stiffness.tocsc()
    factor = splu(
        matrix,
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    return LinearOperator(
        matrix.shape, matvec=factor.solve, matmat=factor.solve, dtype=float
    )


def lowest_eigenpairs(
    stiffness: sp.spmatrix,
    mass: sp.spmatrix,
    below: float,
    shift: float = 0.0,
    first_count: int = 8,
    exact_count: int | None = None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return all eigenpairs up to the eigenvalue `below` [1/s^2], or the `exact_count`
    lowest ones.

    The result consists of eigenvalues (k,), M-orthonormal columns (n, k) and residuals
    (k,). The Lanczos method is used in shift-invert mode about `shift`, which must not
    be an eigenvalue: 0 for a held body, negative for a free one. The number of pairs
    starts at `first_count` and grows until the eigenvalues exceed `below`.
    """
    size = stiffness.shape[0]
    inverse = inverse_at(stiffness, mass, shift)
    first = np.random.default_rng(0).standard_normal(size)
    # of the residual; the eigenvalue error is its square, comparable to round-off
    tolerance = 1e-9
    count = exact_count or first_count
    while True:
        count = min(count, size - 2)
        values, vectors = eigsh(
            stiffness,
            k=count,
            M=mass,
            sigma=shift,
            OPinv=inverse,
            v0=first,
            tol=tolerance,
        )
        if exact_count or values[-1] > below or count == size - 2:
            break
        # the mode frequencies of a plate are evenly spaced
        growth = 1.2 * (below / values.max()) ** 0.5
        count = ceil(count * min(4.0, max(1.5, growth)))
    keep = np.argsort(values)
    if not exact_count:
        keep = keep[: np.count_nonzero(values <= below)]
    values = values[keep]
    vectors = vectors[:, keep]
    return (
        values,
        vectors,
        eigenpair_residuals(inverse.matmat, mass, values, vectors, shift),
    )


def eigenpair_residuals(
    solve: Callable[[np.ndarray], np.ndarray],
    mass: sp.spmatrix,
    values: np.ndarray,
    vectors: np.ndarray,
    shift: float = 0.0,
) -> np.ndarray:
    """Return the residuals (k,) of the inverse eigenvalue problem.

    They are |phi - (value - shift) (K - shift M)^-1 M phi| / |phi|, where `solve(load)`
    applies the inverse. For slow modes the residual of the direct problem would be
    dominated by the round-off of K phi.
    """
    if not len(values):
        return np.zeros(0)
    error = vectors - solve(mass @ vectors) * (values - shift)
    return np.linalg.norm(error, axis=0) / np.linalg.norm(vectors, axis=0)
