"""Frequencies of the table of the scene wood-table by NGSolve: hexahedra of degree 3 on a quarter
of it, flat towards the edges of the feet, in the four classes of its two mirrors; it prints
wood_table.json."""

import json
from itertools import pairwise, product

import ngsolve as ng
import numpy as np
from netgen.meshing import Element2D, Element3D, FaceDescriptor, Mesh, MeshPoint, Pnt
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import LinearOperator, eigsh

YOUNG, POISSON, DENSITY = 11e9, 0.3, 700.0
FOOT = (0.22, 0.26), (0.12, 0.16)
"""Extent of the foot of the quarter x > 0, y > 0 in x and y [m]."""
TOWARDS = 0.15
"""Fraction at which each level cuts a cell next to an edge."""
SIDES = {
    (-1, 0, 0): [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
    (1, 0, 0): [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
    (0, -1, 0): [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
    (0, 1, 0): [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
    (0, 0, -1): [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
    (0, 0, 1): [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
}
CORNERS = [
    (0, 0, 0),
    (1, 0, 0),
    (1, 1, 0),
    (0, 1, 0),
    (0, 0, 1),
    (1, 0, 1),
    (1, 1, 1),
    (0, 1, 1),
]
NAMES = ("free", "feet", "x", "y")


def lines(cells, edges, levels):
    """Return the boundaries of cells; the cells next to an edge are cut `levels` times."""
    for _ in range(levels):
        more = []
        for a, b in pairwise(cells):
            more += [a + (b - a) * TOWARDS] * (a in edges) + [b - (b - a) * TOWARDS] * (
                b in edges
            )
        cells = sorted([*cells, *more])
    return cells


def quarter(levels, split):
    """Return the mesh of x > 0, y > 0 with cells of 40 mm over `split`."""
    even = np.round(np.arange(0, 0.3001, 0.04 / split), 12)
    x = lines(
        sorted({0.0, *np.round(np.arange(0.02, 0.3001, 0.04 / split), 12)}),
        FOOT[0],
        levels,
    )
    y = lines([v for v in even if v < 0.2001], FOOT[1], levels)
    z = lines([-0.04, -0.02, 0.0], (-0.04, -0.02), levels)
    middle = [(np.array(v[1:]) + v[:-1]) / 2 for v in (x, y, z)]
    foot = [(a < m) & (m < b) for (a, b), m in zip(FOOT, middle, strict=False)]
    cells = {
        (i, j, k)
        for i, j, k in product(*(range(len(m)) for m in middle))
        if middle[2][k] > -0.02 or (foot[0][i] and foot[1][j])
    }
    mesh = Mesh(dim=3)
    number = {}
    mesh.SetMaterial(1, "wood")
    faces = {
        name: mesh.Add(FaceDescriptor(bc=i + 1, domin=1, surfnr=i + 1))
        for i, name in enumerate(NAMES)
    }
    for i, name in enumerate(NAMES):
        mesh.SetBCName(i, name)

    def corner(*at):
        if at not in number:
            number[at] = mesh.Add(
                MeshPoint(Pnt(*(v[i] for v, i in zip((x, y, z), at, strict=True))))
            )
        return number[at]

    for cell in cells:
        mesh.Add(Element3D(1, [corner(*np.add(cell, c)) for c in CORNERS]))
        for step, side in SIDES.items():
            if tuple(np.add(cell, step)) not in cells:
                low = [a == 0 and s < 0 for a, s in zip(cell, step, strict=True)]
                name = (
                    "x" if low[0] else "y" if low[1] else "feet" if low[2] else "free"
                )
                mesh.Add(
                    Element2D(faces[name], [corner(*np.add(cell, c)) for c in side])
                )
    return ng.Mesh(mesh)


def frequencies(mesh, order, even, count):
    """Return `count` frequencies [Hz] of the class even (True) or odd in x and y, and the number of
    unknowns."""
    held = {c: ["feet"] for c in "xyz"}
    for plane, same in zip("xy", even, strict=True):
        for c in "xyz":
            held[c] += [plane] * ((c == plane) == same)
    space = ng.VectorH1(
        mesh,
        order=order,
        **{f"dirichlet{c}": "|".join(names) for c, names in held.items()},
    )
    u, v = space.TnT()
    lam = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    mu = YOUNG / 2 / (1 + POISSON)
    a, b = (ng.Sym(ng.Grad(w)) for w in (u, v))
    stiffness = (
        ng.BilinearForm(
            (2 * mu * ng.InnerProduct(a, b) + lam * ng.div(u) * ng.div(v)) * ng.dx
        )
        .Assemble()
        .mat
    )
    mass = ng.BilinearForm(DENSITY * u * v * ng.dx).Assemble().mat
    inverse = stiffness.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    free = np.flatnonzero(list(space.FreeDofs()))
    right = stiffness.CreateColVector()
    left = stiffness.CreateColVector()

    def solve(load):
        right[:] = 0
        right.FV().NumPy()[free] = load.ravel()
        left.data = inverse * right
        return left.FV().NumPy()[free].copy()

    size = (len(free),) * 2
    m = csr_matrix(mass.CSR(), shape=(space.ndof,) * 2)[free][:, free]
    none = LinearOperator(size, matvec=lambda x: x, dtype=float)
    first = np.random.default_rng(0).standard_normal(len(free))
    values = eigsh(
        none,
        k=count,
        M=m,
        sigma=0.0,
        OPinv=LinearOperator(size, matvec=solve, dtype=float),
        v0=first,
        tol=1e-10,
    )[0]
    return np.sqrt(np.sort(values)) / (2 * np.pi), len(free)


def table(levels, split, order, count):
    """Return ascending frequencies [Hz] of all four classes, up to the lowest of their maxima."""
    mesh = quarter(levels, split)
    found = [
        frequencies(mesh, order, even, count)[0]
        for even in product((True, False), repeat=2)
    ]
    every = np.sort(np.concatenate(found))
    return every[every <= min(f[-1] for f in found)]


def limit(coarse, fine):
    """Return the extrapolated frequencies and their relative uncertainty.

    The error follows the singularity at edges of 270 degrees; `coarse` has one level less than
    `fine`.
    """
    share = TOWARDS ** (2 * 0.5445)
    rest = (coarse - fine) * share / (1 - share)
    return fine - rest, np.maximum(rest / fine, 2e-4)


if __name__ == "__main__":
    frequency, uncertainty = limit(*(table(levels, 1, 3, 12) for levels in (1, 2)))
    about = "the table of the scene wood-table, by wood_table.py"
    found = {
        "frequency": frequency.round(3).tolist(),
        "uncertainty": uncertainty.round(5).tolist(),
    }
    print(json.dumps({"about": about, **found}, indent=1))
