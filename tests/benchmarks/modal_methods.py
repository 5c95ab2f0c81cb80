"""Error against seconds of every way to the nine modes of the disk held on +-5 degrees, side by side in one run.

    OPENBLAS_NUM_THREADS=1 python tests/benchmarks/modal_methods.py [FILE.csv]

Errors are the largest of the nine, against frequencies converged to 3e-5. Seconds are the best of two, everything from
geometry to frequencies included, imports excluded. Plain scikit-fem is the library's own way: the whole disk on a mesh
evenly divided around, with straight sides, forms assembled by the library, eigsh about 0 with scipy's factorisation.
"""

import csv
import platform
import sys
from math import pi
from time import perf_counter

import numpy as np
import skfem
from skfem.helpers import ddot, dot, eye, sym_grad, trace

from modal import FreeDisk, Material, Plate, Support
from modal.elastic import lame
from modal.held import LEVELS, solve
from modal.mesh import extrude, hexahedra
from modal.plane import columns, core, part

STEEL = Material(young=195e9, poisson=0.28)
DISK = Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=0.4387 / (pi * 0.03755**2 * 0.0128))
REFERENCE = np.array([800.52, 1080.07, 2261.27, 7266.64, 9654.68, 11629.46, 14611.68, 15235.32, 18788.95])
GRID = np.meshgrid([0, 0.5, 1], [0, 0.5, 1], indexing="ij")


def even_hexahedra(sectors, rows, layers):
    """Straight-sided MeshHex of the whole disk in `sectors` of 5 degrees or a fraction; the patch is made of sides."""
    angles = np.linspace(0, pi, sectors // 2 + 1)
    blocks = [part(b, 0, 1, i / rows, (i + 1) / rows) for b in columns(angles, 0.5) for i in range(rows)]
    inner = core(angles, 0.5)
    cells = np.array([block(*GRID) for block in blocks + inner])
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]]) * DISK.radius
    heights = np.linspace(-DISK.thickness / 2, DISK.thickness / 2, layers + 1)
    mesh = hexahedra(extrude(cells, heights))
    return skfem.MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)


def plain(mesh, element):
    """Nine frequencies [Hz] the way the library's examples go, and the count of unknowns."""
    lam, mu = lame(STEEL)

    @skfem.BilinearForm
    def stiffness(u, v, _):
        strain = sym_grad(u)
        return ddot(2 * mu * strain + lam * eye(trace(strain), 3), sym_grad(v))

    @skfem.BilinearForm
    def mass(u, v, _):
        return DISK.density * dot(u, v)

    basis = skfem.Basis(mesh, skfem.ElementVector(element))
    k, m = stiffness.assemble(basis), mass.assemble(basis)
    x, y, _ = basis.doflocs
    held = (np.hypot(x, y) > 0.99 * DISK.radius) & (np.abs(np.arctan2(y, x)) < np.deg2rad(5) + 1e-6)
    solver = skfem.solver_eigen_scipy_sym(k=9, sigma=0.0)
    values, _ = skfem.solve(*skfem.condense(k, m, D=np.flatnonzero(held)), solver=solver)
    return np.sqrt(np.sort(values)) / (2 * pi), k.shape[0]


def graded(accuracy):
    """Nine frequencies [Hz] by the graded sector at a level, without its error estimate, and the count of unknowns."""
    limit = (2 * pi * 20.5e3) ** 2
    _, solid, classes = solve(DISK, STEEL, Support(), DISK.density, LEVELS[accuracy][0], {"below": limit})
    values = np.sort(np.concatenate([c.values for c in classes]))
    return np.sqrt(values[:9]) / (2 * pi), 3 * len(solid.points)


def methods():
    """(name, function of no argument that returns frequencies [Hz] and the count of unknowns), one after another."""
    for accuracy in LEVELS:
        yield f"graded sector, {accuracy}", lambda accuracy=accuracy: graded(accuracy)
    yield "synthesis, first patch", lambda: (FreeDisk(plate=DISK).frequencies(Support(), 20e3), 0)
    disk = FreeDisk(plate=DISK)
    disk.frequencies(Support(), 20e3)
    yield "synthesis, next patch", lambda: (disk.frequencies(Support(), 20e3), 0)
    for sectors, rows, layers in ((72, 1, 1), (72, 2, 2), (72, 4, 4)):
        mesh = even_hexahedra(sectors, rows, layers)
        size = f"{sectors} x {rows} x {layers}"
        yield f"plain Q1, {size}", lambda mesh=mesh: plain(mesh, skfem.ElementHex1())
        yield f"plain P1, {size}", lambda mesh=mesh: plain(mesh.to_meshtet(), skfem.ElementTetP1())
    for sectors, rows, layers in ((72, 1, 1), (72, 2, 1)):
        mesh = even_hexahedra(sectors, rows, layers)
        size = f"{sectors} x {rows} x {layers}"
        yield f"plain P2, {size}", lambda mesh=mesh: plain(mesh.to_meshtet(), skfem.ElementTetP2())
        yield f"plain Q2, {size}", lambda mesh=mesh: plain(mesh, skfem.ElementHex2())


def timed(method, repeats=2):
    """Result and best time [s]."""
    best = np.inf
    for _ in range(repeats):
        start = perf_counter()
        result = method()
        best = min(best, perf_counter() - start)
        if best > 5:
            break
    return result, best


def main(path=None):
    """Print the table, write it to path, and end with the conclusion."""
    rows = []
    for name, method in methods():
        (frequency, unknowns), seconds = timed(method)
        error = np.abs(frequency[:9] / REFERENCE - 1)
        rows.append((name, unknowns, f"{100 * error.max():.3f}", f"{100 * np.median(error):.3f}", f"{seconds:.3f}"))
        print(
            f"{name:32} {unknowns:8} unknowns  {rows[-1][2]:>8} % at worst {rows[-1][3]:>8} % median {seconds:8.3f} s"
        )
    if path:
        with open(path, "w", newline="") as file:
            csv.writer(file).writerows([("method", "unknowns", "worst_percent", "median_percent", "seconds"), *rows])
    ours = next(float(row[4]) for row in rows if row[0] == "graded sector, standard")
    best = min((row for row in rows if row[0].startswith("plain")), key=lambda row: float(row[2]))
    ratio = float(best[4]) / ours
    machine = platform.processor() or platform.machine()
    print(f"\n{machine}, Python {platform.python_version()}, scikit-fem {skfem.__version__}")
    print(f"The most accurate plain run, {best[0]}, is {best[2]} % wrong and takes {ratio:.0f} times as long as")
    print("the standard level of the graded sector.")


if __name__ == "__main__":
    main(*sys.argv[1:])
