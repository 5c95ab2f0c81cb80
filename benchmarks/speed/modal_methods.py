"""Measure error and processor time of all methods for the nine modes of the disk held
on +-5 degrees.

    OPENBLAS_NUM_THREADS=1 python -m benchmarks.speed.modal_methods [FILE.csv]

The error is the largest of the nine; the references have converged to 3e-5. The time is
the smaller of two processor times from geometry to frequencies, with called programs
and without imports. Plain scikit-fem follows the examples of the library: the whole
disk on an equally divided straight-sided mesh, forms assembled by the library, eigsh at
shift 0 with scipy's factorisation; the patch ends at nodes. For the refined meshes the
library bisects the tetrahedra near the ends of the patch. CalculiX and NGSolve are
included if they are installed."""

import csv
import platform
import sys
from math import pi
from os import times

import numpy as np
import skfem
from skfem.helpers import ddot, dot, eye, sym_grad, trace

from benchmarks.cases.modes_case import modes_case
from benchmarks.peers.finite_element_programs import calculix, ngsolve_modes
from benchmarks.timed_runs import Failure
from modal import FreeDisk, Material, Plate, Support
from modal.accuracy import ACCURACY_LEVELS
from modal.elements.elastic import lame_constants
from modal.elements.patch import solve_symmetry_classes
from modal.elements.unfold import whole_mesh
from modal.mesh.half_disk import core_blocks, rim_blocks, sub_block
from modal.mesh.sector import extrude, hexahedra, sector
from modal.mesh.symmetry import patch_node_mask as held_there

STEEL = Material(young=195e9, poisson=0.28)
DISK = Plate(
    radius=0.03755,
    thickness=0.0128,
    material=STEEL,
    density=0.4387 / (pi * 0.03755**2 * 0.0128),
)
REFERENCE = np.array(modes_case("patch").reference)
NODE_GRID = np.meshgrid([0, 0.5, 1], [0, 0.5, 1], indexing="ij")
"""Node coordinates of a biquadratic quadrilateral."""


def even_hexahedra(sectors, rows, layers):
    """Return a straight-sided MeshHex of the whole disk; its sectors divide 5 degrees,
    so that sides form the patch."""
    angles = np.linspace(0, pi, sectors // 2 + 1)
    blocks = [
        sub_block(b, 0, 1, i / rows, (i + 1) / rows)
        for b in rim_blocks(angles, 0.5)
        for i in range(rows)
    ]
    inner = core_blocks(angles, 0.5)
    cells = np.array([block(*NODE_GRID) for block in blocks + inner])
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]]) * DISK.radius
    heights = np.linspace(-DISK.thickness / 2, DISK.thickness / 2, layers + 1)
    mesh = hexahedra(extrude(cells, heights))
    return skfem.MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)


def refined(levels):
    """Return straight-sided tetrahedra; those that touch an end of the patch are
    bisected `levels` times."""
    mesh = even_hexahedra(72, 1, 1).to_meshtet()
    ends = DISK.radius * np.exp(1j * np.deg2rad([-5.0, 5.0]))
    for _ in range(levels):
        place = mesh.p[0] + 1j * mesh.p[1]
        touching = (np.abs(place[:, None] - ends).min(axis=1) < 1e-9)[mesh.t].any(
            axis=0
        )
        mesh = mesh.refined(np.flatnonzero(touching))
    return mesh


def patch_node_mask(x):
    """Return True for the facet midpoints (3, f) of the whole disk that belong to the
    patch."""
    on_rim = (np.hypot(x[0], x[1]) > 0.99 * DISK.radius) & (
        np.abs(x[2]) < 0.499999 * DISK.thickness
    )
    return on_rim & (np.abs(np.arctan2(x[1], x[0])) < np.deg2rad(5))


def plain(mesh, element):
    """Return nine frequencies [Hz] computed as in the examples of the library, and the
    number of unknowns."""
    lam, mu = lame_constants(STEEL)

    @skfem.BilinearForm
    def stiffness(u, v, _):
        strain = sym_grad(u)
        return ddot(2 * mu * strain + lam * eye(trace(strain), 3), sym_grad(v))

    @skfem.BilinearForm
    def mass(u, v, _):
        return DISK.density * dot(u, v)

    basis = skfem.Basis(mesh, skfem.ElementVector(element))
    k = stiffness.assemble(basis)
    m = mass.assemble(basis)
    held = basis.get_dofs(mesh.facets_satisfying(patch_node_mask, boundaries_only=True))
    solver = skfem.solver_eigen_scipy_sym(k=9, sigma=0.0)
    values, _ = skfem.solve(*skfem.condense(k, m, D=held), solver=solver)
    return np.sqrt(np.sort(values)) / (2 * pi), k.shape[0]


def graded(accuracy):
    """Return nine frequencies [Hz] by the graded sector without error estimate, and the
    number of unknowns."""
    limit = (2 * pi * 20.5e3) ** 2
    _, solid, classes = solve_symmetry_classes(
        DISK, Support(), ACCURACY_LEVELS[accuracy].patch_meshes[0], {"below": limit}
    )
    values = np.sort(np.concatenate([c.values for c in classes]))
    return np.sqrt(values[:9]) / (2 * pi), 3 * len(solid.points)


def peers():
    """Yield CalculiX on the mirrored standard mesh and NGSolve on its own meshes, as in
    `methods`."""
    case = modes_case("patch")
    part = sector(
        case.plate.radius,
        case.plate.thickness,
        Support(),
        ACCURACY_LEVELS["standard"].patch_meshes[0],
    )
    points, cells, _ = whole_mesh(
        part.mesh.doflocs.T, part.mesh.dofs.element_dofs.T, part.quarter
    )
    held = np.intersect1d(
        np.flatnonzero(
            held_there(points, case.plate.radius, case.half_angle, part.patch)
        ),
        cells[:, :20],
    )
    yield (
        "CalculiX C3D20, graded mesh",
        lambda: calculix(case, points, cells[:, :20], held),
    )
    for degree, levels in ((2, 4), (2, 6), (3, 4), (3, 6)):
        element = f"P{degree} tetrahedra"
        name = f"NGSolve P{degree}, edge halved {levels} times"
        yield (
            name,
            lambda element=element, levels=levels: ngsolve_modes(
                case, element, levels, 1
            ),
        )


def methods():
    """Yield (name, function without arguments that returns frequencies [Hz] and the
    number of unknowns)."""
    for accuracy in ACCURACY_LEVELS:
        yield f"graded sector, {accuracy}", lambda accuracy=accuracy: graded(accuracy)
    yield (
        "synthesis, first patch",
        lambda: (FreeDisk(plate=DISK).frequencies(Support(), 20e3), 0),
    )
    disk = FreeDisk(plate=DISK)
    disk.frequencies(Support(), 20e3)
    yield "synthesis, next patch", lambda: (disk.frequencies(Support(), 20e3), 0)
    yield from peers()
    for sectors, rows, layers in ((72, 1, 1), (72, 2, 2), (72, 4, 4)):
        mesh = even_hexahedra(sectors, rows, layers)
        size = f"{sectors} x {rows} x {layers}"
        yield f"plain Q1, {size}", lambda mesh=mesh: plain(mesh, skfem.ElementHex1())
        yield (
            f"plain P1, {size}",
            lambda mesh=mesh: plain(mesh.to_meshtet(), skfem.ElementTetP1()),
        )
    for sectors, rows, layers in ((72, 1, 1), (72, 2, 1), (144, 2, 1)):
        mesh = even_hexahedra(sectors, rows, layers)
        size = f"{sectors} x {rows} x {layers}"
        yield (
            f"plain P2, {size}",
            lambda mesh=mesh: plain(mesh.to_meshtet(), skfem.ElementTetP2()),
        )
        if sectors == 72:
            yield (
                f"plain Q2, {size}",
                lambda mesh=mesh: plain(mesh, skfem.ElementHex2()),
            )
    for levels in (3, 6, 9, 12):
        yield (
            f"refined P2, bisected {levels} times",
            lambda levels=levels: plain(refined(levels), skfem.ElementTetP2()),
        )


def seconds():
    """Return the processor time [s] of this process and its child processes."""
    return sum(times()[:4])


def timed(method, repeats=2):
    """Return the result of a method and its smallest processor time [s]."""
    best = np.inf
    for _ in range(repeats):
        start = seconds()
        result = method()
        best = min(best, seconds() - start)
        if best > 5:
            break
    return result, best


def main(path=None):
    """Print the table and the conclusion, and write the table to `path` if it is
    given."""
    rows = []
    for name, method in methods():
        try:
            (frequency, unknowns), taken = timed(method)
        except Failure as reason:
            print(f"{name:32} left out: {reason}")
            continue
        frequency = np.array(frequency)
        error = np.abs(frequency[:9] / REFERENCE - 1)
        rows.append(
            (
                name,
                unknowns,
                f"{100 * error.max():.3f}",
                f"{100 * np.median(error):.3f}",
                f"{taken:.3f}",
            )
        )
        print(
            f"{name:32} {unknowns:8} unknowns  {rows[-1][2]:>8} % at worst {rows[-1][3]:>8} % "
            f"median {taken:8.3f} s"
        )
    if path:
        with open(path, "w", newline="") as file:
            csv.writer(file).writerows(
                [
                    (
                        "method",
                        "unknowns",
                        "worst_percent",
                        "median_percent",
                        "seconds",
                    ),
                    *rows,
                ]
            )
    machine = platform.processor() or platform.machine()
    print(
        f"\n{machine}, Python {platform.python_version()}, scikit-fem {skfem.__version__}"
    )
    ours = next(row for row in rows if row[0] == "graded sector, standard")
    print(
        at_our_error(
            "refined P2", [row for row in rows if row[0].startswith("refined P2")], ours
        )
    )


def at_our_error(family, rows, ours):
    """Return the time of a family at our error, by its regression line in logarithms,
    and the time of its best run."""
    error, taken = np.array([[float(row[2]), float(row[4])] for row in rows]).T
    order, _ = np.polyfit(np.log(taken), np.log(error), 1)
    best = error.argmin()
    our_error = float(ours[2])
    reach = taken[best] * (error[best] / our_error) ** (-1 / order)
    times_best, times_equal = np.array([taken[best], reach]) / float(ours[4])
    return (
        f"{family}: at best {error[best]:.2f} % in {taken[best]:.1f} s, {times_best:.0f} times as "
        f"long as the standard "
        f"level for {our_error:.2f} %;\nerror ~ seconds^{order:.2f}, so {times_equal:.0f} times "
        f"as long for that error."
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
