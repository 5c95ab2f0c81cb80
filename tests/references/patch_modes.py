"""Makes patch_modes.json: python tests/references/patch_modes.py (NGSolve; up to half an hour, 4
GB).

The modes of the published disk on its patch by elements of degrees 4, 5, 6 of NGSolve on a quarter
of the disk, a few hundred curved cells that shrink by the factor 0.3, ten times over, towards the
edge of the patch. Each frequency is an upper bound that converges geometrically with the degree;
given is Aitken's limit, its uncertainty is the step from the last degree to the limit."""

import json
from pathlib import Path

import ngsolve
import numpy as np
from netgen.occ import Cylinder, Dir, Glue, HalfSpace, OCCGeometry, Pnt, Y, Z
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import LinearOperator, eigsh

RADIUS, THICKNESS, MASS, YOUNG, POISSON, HALF_ANGLE = (
    0.03755,
    0.0128,
    0.4387,
    195e9,
    0.28,
    np.deg2rad(5.0),
)
HEIGHT, DENSITY = THICKNESS / RADIUS / 2, MASS / (np.pi * RADIUS**2 * THICKNESS)
DEGREES, LEVELS, FACTOR, SIZE, NEAR, COUNT = (4, 5, 6), 10, 0.3, 0.35, 0.08, 9


def quarter():
    """Return the mesh of the quarter y, z > 0 of a disk of radius 1.

    The symmetry planes and the patch are named; the cells are small at the edge of the patch.
    """
    body = Cylinder(Pnt(0, 0, 0), Z, r=1, h=HEIGHT) * HalfSpace(Pnt(0, 0, 0), -Y)
    sector = body * HalfSpace(
        Pnt(0, 0, 0), Dir(-np.sin(HALF_ANGLE), np.cos(HALF_ANGLE), 0)
    )
    shape = Glue([body - sector, sector])
    for face in shape.faces:
        x, y, z = face.center
        on_patch = (
            x > 0.98 and 0 < np.arctan2(y, x) < HALF_ANGLE and 0 < z < HEIGHT - 1e-9
        )
        face.name = (
            "z"
            if z < 1e-9
            else "y"
            if abs(y) < 1e-9
            else "patch"
            if on_patch
            else "free"
        )
        if on_patch:
            face.maxh = NEAR
            for part in [*face.edges, *face.vertices]:
                x, y, z = part.center if hasattr(part, "center") else part.p
                at_side = abs(np.arctan2(y, x) - HALF_ANGLE) < 1e-6
                at_top = abs(z - HEIGHT) < 1e-9
                part.hpref = float(
                    at_side and at_top if hasattr(part, "p") else at_side or at_top
                )
    mesh = ngsolve.Mesh(OCCGeometry(shape).GenerateMesh(maxh=SIZE, grading=0.6))
    mesh.RefineHP(LEVELS, factor=FACTOR)
    return mesh


def frequencies(mesh, degree):
    """Return the lowest frequencies (COUNT,) [Hz] of all four symmetry classes, with elements of a
    degree."""
    mesh.Curve(degree + 1)
    space = ngsolve.VectorH1(mesh, order=degree)
    u, v = space.TnT()
    strain, virtual = (ngsolve.Sym(ngsolve.Grad(field)) for field in (u, v))
    lam = POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    mu = 1 / (2 * (1 + POISSON))
    energy = lam * ngsolve.div(u) * ngsolve.div(v) + 2 * mu * ngsolve.InnerProduct(
        strain, virtual
    )
    k, m = (
        ngsolve.BilinearForm(form * ngsolve.dx).Assemble().mat
        for form in (energy, u * v)
    )
    return np.sort(
        [
            f
            for y in (1, -1)
            for z in (1, -1)
            for f in of_class(mesh, degree, k, m, y, z)
        ]
    )[:COUNT]


def of_class(mesh, degree, k, m, y, z):
    """Return four frequencies [Hz] of the class that is even (1) or odd (-1) under y -> -y and z ->
    -z."""
    zero = {
        "x": ["y"] * (y < 0) + ["z"] * (z < 0),
        "y": ["y"] * (y > 0) + ["z"] * (z < 0),
    }
    zero["z"] = ["y"] * (y < 0) + ["z"] * (z > 0)
    held = {
        f"dirichlet{axis}": "|".join(["patch", *names]) for axis, names in zero.items()
    }
    factor = k.Inverse(
        ngsolve.VectorH1(mesh, order=degree, **held).FreeDofs(),
        inverse="sparsecholesky",
    )
    load = k.CreateColVector()
    answer = k.CreateColVector()

    def solve(right):
        load.FV().NumPy()[:] = right
        answer.data = factor * load
        return answer.FV().NumPy().copy()

    size = k.height
    stiffness, mass = (
        csr_matrix((a, i, p), shape=(size, size))
        for a, i, p in (x.CSR() for x in (k, m))
    )
    inverse = LinearOperator(stiffness.shape, matvec=solve, dtype=float)
    values = eigsh(
        stiffness,
        4,
        M=mass,
        sigma=0.0,
        OPinv=inverse,
        v0=solve(np.ones(size)),
        return_eigenvectors=False,
    )
    return np.sqrt(values * YOUNG / DENSITY) / (2 * np.pi * RADIUS)


def limit(a, b, c):
    """Return Aitken's limit of a geometrically convergent sequence and its relative distance from
    the last term."""
    step = (c - b) ** 2 / ((c - b) - (b - a))
    return c - step, step / c


def main():
    """Compute, print and write the frequencies."""
    mesh = quarter()
    found = []
    for degree in DEGREES:
        found.append(frequencies(mesh, degree))
        print(degree, found[-1], flush=True)
    best, uncertainty = limit(*found)
    document = {"about": " ".join(__doc__.split("\n\n")[1].split()), "degrees": DEGREES}
    document["published"] = {
        "frequency": best.round(4).tolist(),
        "uncertainty": uncertainty.round(8).tolist(),
    }
    document["found"] = [f.round(4).tolist() for f in found]
    Path(__file__).with_suffix(".json").write_text(
        json.dumps(document, indent=1) + "\n", "utf-8"
    )


if __name__ == "__main__":
    main()
