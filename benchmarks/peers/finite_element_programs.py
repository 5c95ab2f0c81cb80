"""Compute elastic modes by CalculiX on the meshes of `plain_finite_elements`, and by
NGSolve on its own meshes.

NGSolve comes with the extra `peers`; CalculiX is the program `ccx`. A call raises
Failure if the program is missing."""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import LinearOperator, eigsh
from scipy.spatial import cKDTree
from skfem import MeshTet2

from benchmarks.cases.modes_case import ModesCase
from benchmarks.methods.plain_finite_elements import FREE_SHIFT, patch_unknowns, uniform
from benchmarks.timed_runs import Answer, Failure
from modal.elements.elastic import lame_constants
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.sector import HEXAHEDRON_NODES

SERENDIPITY = [
    int(np.flatnonzero((node == HEXAHEDRON_NODES).all(axis=1))[0])
    for node in VTK_HEXAHEDRON27[:20]
]
"""Nodes of a 27-node hexahedron that belong to the 20-node hexahedron, in the order of
CalculiX."""

MIRRORED_TETRAHEDRON = [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]
"""Node order that makes a left-handed 10-node tetrahedron right-handed."""

MAX_RIGID_FREQUENCY = 1e-3
"""Largest accepted frequency of a rigid-body mode, divided by the first elastic
frequency."""


def calculix_modes(
    case: ModesCase, element: str, refinements: int, layers: int
) -> Answer:
    """Return the lowest frequencies [Hz] by CalculiX's C3D20 ("Q2 hexahedra") or C3D10
    ("P2 tetrahedra")."""
    basis, segments = uniform(case, element, refinements, layers)
    points, cells = nodes_of(basis.mesh)
    places = basis.doflocs[:, patch_unknowns(basis, case, segments)].T
    held = (
        np.unique(cKDTree(points).query(places)[1]) if len(places) else np.zeros(0, int)
    )
    used = np.unique(cells)
    return calculix(case, points, cells, np.intersect1d(held, used))


def nodes_of(mesh):
    """Return points (p, 3) and right-handed cells (c, 20 or 10) of a scikit-fem mesh,
    in the order of CalculiX."""
    if mesh.t.shape[0] == 8:
        return mesh.doflocs.T, mesh.dofs.element_dofs[SERENDIPITY].T
    mesh = MeshTet2.from_mesh(mesh)
    cells = mesh.dofs.element_dofs.T.copy()
    a, b, c, d = mesh.doflocs.T[cells[:, :4]].transpose(1, 0, 2)
    left = np.einsum("ki,ki->k", np.cross(b - a, c - a), d - a) < 0
    cells[left] = cells[left][:, MIRRORED_TETRAHEDRON]
    return mesh.doflocs.T, cells


def calculix(case: ModesCase, points, cells, held) -> Answer:
    """Return the lowest frequencies [Hz] of a mesh: points (p, 3) [m], cells (c, 20 or
    10), held nodes (h,)."""
    if not shutil.which("ccx"):
        raise Failure("CalculiX (ccx) is not installed")
    count = len(case.reference) + (0 if len(held) else 6)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "disk.inp").write_text(
            calculix_input(case, points, cells, held, count)
        )
        done = subprocess.run(
            ["ccx", "-i", "disk"], cwd=folder, capture_output=True, text=True
        )
        answer = Path(folder) / "disk.dat"
        if done.returncode or not answer.exists():
            raise Failure(f"CalculiX stops: {done.stdout.strip().splitlines()[-1:]}")
        return Answer(
            elastic_frequencies(eigenvalues(answer.read_text()), len(case.reference)),
            3 * len(np.unique(cells)),
        )


def calculix_input(case: ModesCase, points, cells, held, count: int) -> str:
    """Return the input file of CalculiX for the lowest `count` modes."""
    used = np.unique(cells)
    nodes = "\n".join(
        f"{i + 1},{x:.12e},{y:.12e},{z:.12e}"
        for i, (x, y, z) in zip(used, points[used], strict=True)
    )
    rows = ([i, *nodes] for i, nodes in enumerate(cells + 1, 1))
    elements = "\n".join(
        ",\n".join(",".join(map(str, row[a : a + 10])) for a in range(0, len(row), 10))
        for row in rows
    )
    solid = case.plate.material
    material = f"*ELASTIC\n{solid.young:.12e},{solid.poisson:.12e}\n*DENSITY\n{case.plate.density:.12e}"
    support = (
        "*BOUNDARY\n" + "\n".join(f"{i + 1},1,3" for i in held) + "\n"
        if len(held)
        else ""
    )
    return (
        f"*NODE,NSET=ALL\n{nodes}\n*ELEMENT,TYPE=C3D{cells.shape[1]},ELSET=DISK\n{elements}\n"
        f"*MATERIAL,NAME=SOLID\n{material}\n*SOLID SECTION,ELSET=DISK,MATERIAL=SOLID\n"
        f"{support}*STEP\n*FREQUENCY\n{count}\n*END STEP\n"
    )


def eigenvalues(text: str):
    """Return the eigenvalues [1/s^2] from the output file of CalculiX."""
    return np.array(
        [
            float(row)
            for row in re.findall(
                r"^ +\d+ +(-?\d\.\d+E[+-]\d+) +-?\d\.\d+E", text, re.MULTILINE
            )
        ]
    )


def elastic_frequencies(values, count: int):
    """Return the frequencies [Hz] of the `count` highest eigenvalues.

    Raises Failure if another eigenvalue does not belong to a rigid-body mode.
    """
    values = np.sort(values)
    if (
        len(values) < count
        or (np.abs(values[:-count]) > MAX_RIGID_FREQUENCY**2 * values[-count]).any()
    ):
        raise Failure("rigid-body modes are lost or invented")
    return np.sqrt(values[-count:]) / (2 * np.pi)


def ngsolve_modes(
    case: ModesCase, element: str, refinements: int, layers: int
) -> Answer:
    """Return the lowest frequencies [Hz] by NGSolve: curved tetrahedra of degree 2 or 3
    ("P2 tetrahedra", "P3 ...").

    The element size is the thickness divided by `layers`; it is halved `refinements`
    times at the edge of the patch."""
    try:
        import ngsolve
    except ImportError:
        raise Failure("NGSolve is not installed") from None
    degree = int(element[1])
    size = case.plate.thickness / layers
    mesh = ngsolve.Mesh(
        cylinder(case, size, refinements).GenerateMesh(maxh=size, grading=0.5)
    )
    mesh.Curve(degree)
    space = ngsolve.VectorH1(mesh, order=degree, dirichlet="patch")
    u, v = space.TnT()
    lam, mu = lame_constants(case.plate.material)
    strain, virtual = (ngsolve.Sym(ngsolve.Grad(field)) for field in (u, v))
    energy = lam * ngsolve.div(u) * ngsolve.div(v) + 2 * mu * ngsolve.InnerProduct(
        strain, virtual
    )
    stiffness = ngsolve.BilinearForm(energy * ngsolve.dx).Assemble()
    mass = ngsolve.BilinearForm(case.plate.density * u * v * ngsolve.dx).Assemble()
    values = eigenvalues_at_shift(stiffness.mat, mass.mat, space.FreeDofs(), case)
    return Answer(elastic_frequencies(values, len(case.reference)), space.ndof)


def eigenvalues_at_shift(stiffness, mass, free, case: ModesCase):
    """Return the lowest eigenvalues [1/s^2] of NGSolve's matrices by scipy's eigsh and
    NGSolve's factorisation."""
    count = len(case.reference)
    shift = 0.0
    shifted = stiffness.CreateMatrix()
    shifted.AsVector().data = stiffness.AsVector()
    if case.half_angle is None:
        count += 6
        shift = FREE_SHIFT
        shifted.AsVector().data -= shift * mass.AsVector()
    factor = shifted.Inverse(free, inverse="sparsecholesky")
    load = shifted.CreateColVector()
    answer = shifted.CreateColVector()

    def solve(right):
        load.FV().NumPy()[:] = right
        answer.data = factor * load
        return answer.FV().NumPy().copy()

    size = len(free)
    k, m = (
        csr_matrix((a, i, p), shape=(size, size))
        for a, i, p in (x.CSR() for x in (stiffness, mass))
    )
    inverse = LinearOperator(k.shape, matvec=solve, dtype=float)
    start = solve(np.ones(size))
    return eigsh(
        k, count, M=m, sigma=shift, OPinv=inverse, v0=start, return_eigenvectors=False
    )


def cylinder(case: ModesCase, size: float, refinements: int):
    """Return NGSolve's geometry of the disk for elements of `size` [m]; the face of the
    support is called "patch"."""
    from netgen.occ import Cylinder, Dir, Glue, HalfSpace, OCCGeometry, Pnt, Z

    disk = Cylinder(
        Pnt(0, 0, -case.plate.thickness / 2),
        Z,
        r=case.plate.radius,
        h=case.plate.thickness,
    )
    if case.half_angle is None:
        return OCCGeometry(disk)
    sine = np.sin(case.half_angle)
    cosine = np.cos(case.half_angle)
    sides = [HalfSpace(Pnt(0, 0, 0), Dir(-sine, sign * cosine, 0)) for sign in (1, -1)]
    sector = disk * sides[0] * sides[1]
    for face in sector.faces:
        if face.center.x > 0.9 * case.plate.radius:
            face.name = "patch"
            for edge in face.edges:
                if abs(edge.center.z) < case.plate.thickness / 4:
                    edge.maxh = size / 2**refinements
    return OCCGeometry(Glue([disk - sector, sector]))
