"""Linear elasticity by finite elements: batched matrices of any scalar Lagrange element, and the lowest eigenpairs."""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem import CellBasis


@dataclass(frozen=True, kw_only=True)
class Solid:
    """A meshed elastic solid: unknown 3 node + component, nodes at points (p, 3) [m].

    stiffness (3p, 3p) [N/m] and mass (3p, 3p) [kg] are scipy.sparse CSR; cells (c, nodes) numbers the nodes of each
    cell in scikit-fem's order; total [kg] is the mass of the meshed volume.
    """

    points: np.ndarray
    cells: np.ndarray
    stiffness: sp.csr_matrix
    mass: sp.csr_matrix
    total: float


def lame(material):
    """Lame's first and second constant [Pa]."""
    young, poisson = material.young, material.poisson
    return young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))


def bending_number(plate, below):
    """Wave number [1/m] of bending in a thin plate at `below` [Hz]: k^4 = w^2 rho 12 (1 - nu^2)/(E h^2)."""
    stiffness = plate.material.young * plate.thickness**2 / (12 * (1 - plate.material.poisson**2))
    return ((2 * np.pi * below) ** 2 * plate.density / stiffness) ** 0.25


def mode_count(plate, below):
    """At least how many modes a disk has below `below` [Hz], from the area of a plate and the volume of a body.

    A plate bends in (k R)^2/4 modes; a body has (4 pi/3) (f/c)^3 of each kind of wave in every unit of its volume
    (Weyl 1912, Debye 1912). What surfaces and edges add, up to as many again, is left out.
    """
    lam, mu = lame(plate.material)
    bending = (bending_number(plate, below) * plate.radius) ** 2 / 4
    slow, fast = (mu / plate.density) ** 0.5, ((lam + 2 * mu) / plate.density) ** 0.5
    volume = pi * plate.radius**2 * plate.thickness
    return bending + volume * 4 * pi / 3 * below**3 * (2 / slow**3 + 1 / fast**3)


def assemble(mesh, element, material, density, intorder):
    """The `Solid` of a scikit-fem mesh: K = int lam div u div v + 2 mu eps(u):eps(v), M = int rho u.v.

    All cells at once: with S[a i, b j] = int d_i phi_a d_j phi_b the stiffness is
    lam S[a i, b j] + mu S[a j, b i] + mu delta_ij S[a k, b k].
    """
    basis = CellBasis(mesh, element, intorder=intorder)
    cells, nodes = basis.element_dofs.T, basis.N
    count, c, q = cells.shape[1], len(cells), basis.dx.shape[1]
    grad = np.stack([np.broadcast_to(f[0].grad, (3, c, q)) for f in basis.basis])
    value = np.stack([np.broadcast_to(np.asarray(f[0]), (c, q)) for f in basis.basis], axis=1)
    grad = grad.transpose(2, 0, 1, 3).reshape(c, 3 * count, q)
    s = ((grad * basis.dx[:, None]) @ grad.transpose(0, 2, 1)).reshape(c, count, 3, count, 3)
    lam, mu = lame(material)
    k = lam * s + mu * s.transpose(0, 1, 4, 3, 2)
    k[:, :, range(3), :, range(3)] += mu * np.einsum("eakbk->eab", s)
    m = density * (value * basis.dx[:, None]) @ value.transpose(0, 2, 1)
    dofs = (3 * cells[:, :, None] + np.arange(3)).reshape(c, -1)
    return Solid(
        points=basis.doflocs.T.copy(),
        cells=cells,
        stiffness=gather(k.reshape(c, 3 * count, 3 * count), dofs, 3 * nodes),
        mass=sp.kron(gather(m, cells, nodes), sp.identity(3)).tocsr(),
        total=float(density * basis.dx.sum()),
    )


def gather(blocks, dofs, size):
    """The sparse sum (size, size) of cell matrices (c, n, n) whose unknowns are numbered by dofs (c, n)."""
    n = dofs.shape[1]
    rows, columns = np.repeat(dofs, n, axis=1).ravel(), np.tile(dofs, (1, n)).ravel()
    return sp.csr_matrix((blocks.ravel(), (rows, columns)), shape=(size, size))


def inverse_at(stiffness, mass, shift):
    """(K - shift M)^-1 as an operator: SuperLU in symmetric mode, pivots from the diagonal, ordering MMD_AT_PLUS_A."""
    matrix = (stiffness - shift * mass).tocsc() if shift else stiffness.tocsc()
    factor = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return LinearOperator(matrix.shape, matvec=factor.solve, matmat=factor.solve, dtype=float)


TOLERANCE = 1e-9
"""Of an eigenvalue, relative; the error is that of the residual squared, and lies at round-off."""


def lowest(stiffness, mass, below, shift=0.0, start=8, exactly=None):
    """All eigenpairs with eigenvalue <= below [1/s^2], or exactly so many.

    Returns values (k,), M-orthonormal columns (n, k), residuals (k,). Shift-invert Lanczos about `shift`, which must
    not be an eigenvalue: 0 for a held body, negative for a free one.
    """
    size = stiffness.shape[0]
    inverse = inverse_at(stiffness, mass, shift)
    first = np.random.default_rng(0).standard_normal(size)
    count = exactly or start
    while True:
        count = min(count, size - 2)
        values, vectors = eigsh(stiffness, k=count, M=mass, sigma=shift, OPinv=inverse, v0=first, tol=TOLERANCE)
        if exactly or values[-1] > below or count == size - 2:
            break
        count = ceil(count * min(4.0, max(1.5, 1.2 * (below / values.max()) ** 0.5)))  # a plate's are evenly spaced
    keep = np.argsort(values)[: np.count_nonzero(values <= below)] if not exactly else np.argsort(values)
    values, vectors = values[keep], vectors[:, keep]
    return values, vectors, residuals(inverse.matmat, mass, values, vectors, shift)


def residuals(solve, mass, values, vectors, shift=0.0):
    """|phi - (value - shift) (K - shift M)^-1 M phi| / |phi| (k,) of each pair; solve(load) applies the inverse.

    The residual of the inverse problem, because K phi of a slow mode is the round-off of much larger terms.
    """
    if not len(values):
        return np.zeros(0)
    error = vectors - solve(mass @ vectors) * (values - shift)
    return np.linalg.norm(error, axis=0) / np.linalg.norm(vectors, axis=0)
