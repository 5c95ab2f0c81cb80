"""Claim: stiffness and mass matrices assembled over all cells at once equal those of scikit-fem's
own forms to rounding.

Source: the weak form of linear elasticity. Oracle: `skfem.models.elasticity.linear_elasticity`.
"""

import numpy as np
import pytest
from arithmetic import gamma
from skfem import (
    Basis,
    BilinearForm,
    ElementHex1,
    ElementHex2,
    ElementTetP1,
    ElementTetP2,
    ElementVector,
    MeshHex,
)
from skfem.helpers import dot
from skfem.models.elasticity import linear_elasticity

from modal import Material
from modal.accuracy import COARSE_DRAFT_MESH
from modal.elements.elastic import assemble_solid, lame_constants
from modal.mesh.half_disk import half_disk
from modal.mesh.sector import extrude, hexahedra

STEEL, DENSITY, ORDER = Material(young=195e9, poisson=0.28), 7737.27, 4
CURVED = hexahedra(
    extrude(half_disk(np.pi, COARSE_DRAFT_MESH)[:6] * 0.03755, np.array([0.0, 0.0128]))
)
STRAIGHT = MeshHex(CURVED.doflocs[:, : CURVED.t.max() + 1], CURVED.t)
MESHES = [
    (CURVED, ElementHex2),
    (STRAIGHT, ElementHex1),
    (STRAIGHT.to_meshtet(), ElementTetP1),
]
MESHES += [(STRAIGHT.to_meshtet(), ElementTetP2)]


@pytest.mark.parametrize(("mesh", "element"), MESHES)
def test_matrices_are_those_of_scikit_fem(mesh, element):
    """Rounding bound: each entry is a sum of products of slopes over quadrature points and cells.

    A term is at most the root of the product of the diagonal entries, and ten times that when
    Lame's first constant exceeds the second.
    """
    solid = assemble_solid(mesh, element(), STEEL, DENSITY, intorder=ORDER)
    basis = Basis(mesh, ElementVector(element()), intorder=ORDER)
    assert basis.doflocs.T.reshape(-1, 3, 3) == pytest.approx(
        np.repeat(solid.points[:, None], 3, axis=1), abs=1e-15
    )
    theirs = (
        linear_elasticity(*lame_constants(STEEL)).assemble(basis),
        BilinearForm(inertia).assemble(basis),
    )
    cells = np.bincount(solid.cells.ravel()).max()
    steps = 10 * cells * basis.dx.shape[1]
    for ours, known in zip((solid.stiffness, solid.mass), theirs, strict=True):
        size = np.sqrt(known.diagonal())
        difference = np.abs((ours - known).tocoo())
        bound = 10 * gamma(steps) * size[difference.row] * size[difference.col]
        assert (difference.data <= bound).all()
        assert ours.nnz >= known.count_nonzero() > 0


def inertia(u, v, w):
    """Return the integrand of the mass matrix."""
    return DENSITY * dot(u, v)
