"""Compute elastic modes by plain scikit-fem on uniform straight-sided meshes, and
scipy's shift-invert mode.

The mesh of a free disk is scikit-fem's mesh of a circle with a number of refinements. A
held disk is a polygon with SECTORS sides. The patch consists of whole sides, so that
its extent is exact; `refinements` is the number of rows next to the rim."""

import numpy as np
from scipy.sparse.linalg import eigsh
from skfem import (
    Basis,
    BilinearForm,
    ElementHex2,
    ElementTetP1,
    ElementTetP2,
    ElementVector,
    MeshHex,
    MeshHex2,
    MeshLine,
    MeshTri,
    condense,
    helpers,
)
from skfem.models.elasticity import lame_parameters, linear_elasticity

from benchmarks.cases.modes_case import ModesCase
from benchmarks.timed_runs import Answer, Failure
from modal.mesh.half_disk import core_blocks, make_right_handed, rim_blocks, sub_block
from modal.mesh.sector import extrude, hexahedra

ELEMENTS = {
    "P1 tetrahedra": ElementTetP1,
    "P2 tetrahedra": ElementTetP2,
    "Q2 hexahedra": ElementHex2,
}
"""Element by its name in the charts."""
NODE_COORDINATES = np.array([0.0, 0.5, 1.0])
"""Coordinates of the nodes of a quadratic element along one side."""

SECTORS = 72
"""Number of sides of a held disk."""

RING_DEPTH = 0.5
"""Depth of the ring of elements next to the rim, divided by the radius."""

FREE_SHIFT = -((2 * np.pi * 3000.0) ** 2)
"""Shift for a free body [1/s^2]; its stiffness is singular at shift 0."""


def plain_modes(case: ModesCase, element: str, refinements: int, layers: int) -> Answer:
    """Return the lowest frequencies [Hz] of a case. Raises Failure if the factorisation
    fails."""
    basis, segments = uniform(case, element, refinements, layers)
    stiffness, mass = matrices(basis, case)
    held = patch_unknowns(basis, case, segments)
    count = len(case.reference) + (6 if case.half_angle is None else 0)
    k, m = (
        condense(a, I=np.setdiff1d(np.arange(basis.N), held), expand=False)
        for a in (stiffness, mass)
    )
    sigma = 0.0 if len(held) else FREE_SHIFT
    try:
        values = eigsh(
            k.tocsc(), k=count, M=m.tocsc(), sigma=sigma, return_eigenvectors=False
        )
    except RuntimeError as error:
        raise Failure(f"the factorisation fails: {error}") from None
    elastic = np.sort(values)[-len(case.reference) :]
    return Answer(np.sqrt(np.maximum(elastic, 0)) / (2 * np.pi), basis.N)


def uniform(case: ModesCase, element: str, refinements: int, layers: int):
    """Return the basis on a uniform mesh of the disk, and the number of sides of its
    rim."""
    heights = np.linspace(
        -case.plate.thickness / 2, case.plate.thickness / 2, layers + 1
    )
    if case.half_angle is not None:
        segments = SECTORS
        plane = sectors(refinements) * case.plate.radius
        curved = hexahedra(extrude(plane, heights))
        solid = MeshHex(
            np.ascontiguousarray(curved.doflocs[:, : curved.t.max() + 1]), curved.t
        )
        solid = (
            MeshHex2.from_mesh(solid) if "hexahedra" in element else solid.to_meshtet()
        )
    else:
        circle = MeshTri.init_circle(refinements)
        segments = len(circle.boundary_nodes())
        circle = circle.scaled(case.plate.radius)
        solid = (circle * MeshLine(heights)).to_meshtet()
        if "hexahedra" in element:
            solid = hexahedra(extrude(quadrilaterals(circle), heights))
    return Basis(solid, ElementVector(ELEMENTS[element]()), intorder=4), segments


def sectors(rows: int) -> np.ndarray:
    """Return the nodes (q, 3, 3, 2) of the unit disk in SECTORS sectors with `rows`
    rows next to the rim."""
    angles = np.linspace(0, np.pi, SECTORS // 2 + 1)
    ring = [
        sub_block(b, 0, 1, i / rows, (i + 1) / rows)
        for b in rim_blocks(angles, RING_DEPTH)
        for i in range(rows)
    ]
    u, v = np.meshgrid(NODE_COORDINATES, NODE_COORDINATES, indexing="ij")
    cells = np.array([block(u, v) for block in ring + core_blocks(angles, RING_DEPTH)])
    return make_right_handed(np.concatenate([cells, cells * [1, -1]]))


def quadrilaterals(triangles: MeshTri) -> np.ndarray:
    """Return the nodes (q, 3, 3, 2) of three quadrilaterals per triangle, which meet at
    its centroid."""
    corners = triangles.p[:, triangles.t].transpose(2, 1, 0)
    first, second = (corners[:, i] - corners[:, 0] for i in (1, 2))
    clockwise = first[:, 0] * second[:, 1] < first[:, 1] * second[:, 0]
    corners[clockwise] = corners[clockwise, ::-1]
    centre = corners.mean(axis=1)
    middles = (corners + np.roll(corners, -1, axis=1)) / 2
    u, v = np.meshgrid(NODE_COORDINATES, NODE_COORDINATES, indexing="ij")
    weights = np.array([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])
    nodes = np.stack(
        [
            corners,
            middles,
            np.broadcast_to(centre[:, None], corners.shape),
            np.roll(middles, 1, axis=1),
        ]
    )
    return np.einsum("cuv,ctix->ituvx", weights, nodes).reshape(-1, 3, 3, 2)


def matrices(basis, case: ModesCase):
    """Return the stiffness and mass matrices of a basis."""
    stiffness = linear_elasticity(
        *lame_parameters(case.plate.material.young, case.plate.material.poisson)
    )

    @BilinearForm
    def inertia(u, v, w):
        return case.plate.density * helpers.dot(u, v)

    return stiffness.assemble(basis), inertia.assemble(basis)


def patch_unknowns(basis, case: ModesCase, segments: int):
    """Return the unknowns of the nodes on the patch, or none for a free disk.

    The rim nodes must be equally spaced."""
    if case.half_angle is None:
        return np.zeros(0, int)
    x, y, _ = basis.doflocs
    outside = np.hypot(x, y) > case.plate.radius * np.cos(np.pi / segments) * (1 - 1e-9)
    spacing = np.diff(np.unique(np.arctan2(y[outside], x[outside]).round(9))).min()
    reach = max(1, round(case.half_angle / spacing)) + 0.25
    return np.flatnonzero(outside & (np.abs(np.arctan2(y, x)) <= reach * spacing))


def strain_energy_error(case: ModesCase, element: str) -> float:
    """Return the relative error of the energy of a uniform stretch along x, which every
    element represents exactly."""
    basis, _ = uniform(case, element, 2, 1)
    stiffness, mass = matrices(basis, case)
    stretch = basis.project(lambda x: np.stack([x[0], 0 * x[0], 0 * x[0]]))
    shift = basis.project(lambda x: np.stack([1 + 0 * x[0], 0 * x[0], 0 * x[0]]))
    volume = shift @ mass @ shift / case.plate.density
    lam, mu = lame_parameters(case.plate.material.young, case.plate.material.poisson)
    return abs(stretch @ stiffness @ stretch / ((lam + 2 * mu) * volume) - 1)
