"""Claim: the modal frequencies of a meshed table are accurate upper bounds, and their error
estimates are 1.2 to 5 times the true errors.

Source: Strang & Fix, An Analysis of the Finite Element Method, 6.3; Williams (1952) for singular
stress. Oracle: hexahedra of degree 3 from another program, graded towards the edges of the feet,
with their uncertainty (tests/references/wood_table.json); the same mesh with finer cells; the whole
mesh without symmetry.
"""

import json

import numpy as np
import pytest
from paths import REFERENCES
from skfem import MeshHex, MeshTet

from modal.accuracy import ACCURACY_LEVELS
from modal.elements.elastic import lowest_eigenpairs
from modal.elements.mirrors import mirror_symmetries, symmetry_bases
from modal.elements.user_mesh import (
    discretise,
    elastic_eigenpairs,
    linear_and_quadratic_elements,
    nodes_of_subcells,
)
from modal.elements.user_mesh_error import (
    CORNER_EXTRAPOLATION_FACTOR,
    angles_about_edges,
    prolongation,
    relative_errors,
    singular_cells,
)
from modal.mesh.symmetry import admissible_displacements
from modal.modes import Material, Support
from modal.tabletop.meshed import table_on_mesh
from sonify import load_scene

KNOWN = json.loads((REFERENCES / "wood_table.json").read_text("utf-8"))
WOOD, HELD = Material(young=11e9, poisson=0.3, loss_factor=0.02), Support().held


def board(x, y, z, clamped):
    """Return a mesh of a board with the given sizes [m] and cell counts, and its clamped facets at
    the minimum x, if any."""
    mesh = MeshHex.init_tensor(*(np.linspace(0, size, n + 1) for size, n in (x, y, z)))
    return mesh, mesh.facets_satisfying(lambda p: p[0] < 1e-9) if clamped else np.zeros(
        0, int
    )


def levels(mesh, facets):
    """Return the `DiscreteBody` of the given mesh and of its cells divided into eight."""
    whole = linear_and_quadratic_elements(mesh)[1]
    return [
        discretise(mesh, facets, whole, places, WOOD, 700.0)
        for places in ([whole.doflocs.T], nodes_of_subcells(whole))
    ]


@pytest.mark.parametrize("kind", [MeshHex, MeshTet])
def test_what_the_mesh_can_do_its_parts_can(kind):
    """Positions are displacements too: dividing cells moves no point."""
    mesh = kind.init_tensor(*[np.array([0.0, 0.4, 1.0])] * 3)
    coarse, fine = levels(mesh, np.zeros(0, int))
    taken = prolongation(
        fine.solid, coarse, nodes_of_subcells(linear_and_quadratic_elements(mesh)[1])
    )
    assert taken @ coarse.solid.points.ravel() == pytest.approx(
        fine.solid.points.ravel(), abs=1e-14
    )


@pytest.mark.parametrize("clamped", [True, False])
def test_mirrors_leave_the_modes_as_they_are(clamped):
    """A clamped board is symmetric in y only; a free board is symmetric in x and y."""
    mesh, facets = board((0.3, 3), (0.2, 2), (0.02, 1), clamped)
    given = levels(mesh, facets)[0]
    assert len(mirror_symmetries(given)) == (1 if clamped else 2)
    free = admissible_displacements(given.solid.points, given.held, HELD)
    bases = symmetry_bases(given, free)
    assert sum(b.shape[1] for b in bases) == free.shape[1]
    assert (
        abs(bases[0].T @ given.solid.stiffness @ bases[-1]).max()
        < 1e-9 * abs(given.solid.stiffness).max()
    )
    shift = 0.0 if clamped else -1e4
    found = elastic_eigenpairs(given, HELD, 2000.0, shift)[0]
    rigid = 0 if clamped else 6
    k, m = (
        free.T @ matrix @ free for matrix in (given.solid.stiffness, given.solid.mass)
    )
    whole = lowest_eigenpairs(k, m, np.inf, shift, exact_count=16)[0][rigid:]
    assert 2 < len(found) <= 10
    assert found == pytest.approx(whole[: len(found)], rel=1e-8)
    mesh.p[:, np.argmax(mesh.p.sum(axis=0))] += 0.01
    assert not mirror_symmetries(levels(mesh, facets)[0])


def test_cells_beside_an_edge_where_stress_is_endless_are_found():
    """The reentrant edge of an L has an angle of 270 degrees; a clamp ends at the sides of the
    clamped face."""
    mesh, facets = board((0.4, 4), (0.2, 2), (0.02, 1), True)
    assert angles_about_edges(mesh).max() == pytest.approx(2 * np.pi)
    assert singular_cells(mesh, facets).sum() == 2
    assert not singular_cells(mesh, np.zeros(0, int)).any()
    corner = mesh.remove_elements(
        mesh.elements_satisfying(lambda p: (p[0] > 0.2) & (p[1] > 0.1))
    )
    assert singular_cells(corner, np.zeros(0, int)).sum() == 3


@pytest.mark.slow
@pytest.mark.parametrize(("clamped", "share"), [(True, 1 / 2.4), (False, 1 / 4)])
def test_the_error_is_right_within_a_factor_of_five(clamped, share):
    """Cells of half the width leave at most `share` of the error, and at least a sixteenth."""
    cells = (6, 4, 1)
    size = (0.3, 0.2, 0.02)
    mesh, facets = board(*zip(size, cells, strict=True), clamped)
    coarse, fine = levels(mesh, facets)
    shift = 0.0 if clamped else -1e4
    whole = linear_and_quadratic_elements(mesh)[1]
    values, shapes, _ = elastic_eigenpairs(fine, HELD, 2000.0, shift)
    stated = relative_errors(
        mesh,
        facets,
        fine,
        coarse,
        nodes_of_subcells(whole),
        (values, shapes),
        shift,
        CORNER_EXTRAPOLATION_FACTOR,
    )
    finest = levels(*board(*zip(size, (2 * n for n in cells), strict=True), clamped))[1]
    nearer = (
        np.sqrt(
            values / elastic_eigenpairs(finest, HELD, 2000.0, shift)[0][: len(values)]
        )
        - 1
    )
    assert (nearer > 0).all()
    assert (stated > 1.2 * nearer / (1 - share)).all()
    assert (stated < 5 * nearer / (1 - 1 / 16)).all()


@pytest.mark.slow
def test_the_wooden_table_is_right_to_a_percent_from_above():
    surface = load_scene("wood-table").surface
    found = table_on_mesh(
        surface, 0.03755, 3500.0, ACCURACY_LEVELS["standard"].max_table_unknowns
    )
    frequency, uncertainty = (
        np.array(KNOWN[name]) for name in ("frequency", "uncertainty")
    )
    frequency = frequency[: len(found)]
    uncertainty = uncertainty[: len(found)]
    error = found.frequency / frequency - 1
    assert len(found) == 28
    assert error.min() > 0
    assert error.max() < 0.01
    assert (found.error > 1.2 * (error - uncertainty)).all()
    assert (found.error < 5 * (error + uncertainty)).all()
    assert found.residual.max() < 1e-8
