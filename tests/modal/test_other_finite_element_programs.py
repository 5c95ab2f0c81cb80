"""Claim: other finite-element programs find the same modes of the same disk, held on a patch and
free.

Source: CalculiX's elements C3D10 and C3D20; NGSolve's curved tetrahedra. Oracle: both programs,
which share at most the mesh with ours; frequencies from another method for the disk on its patch,
and from Ritz's method for the free one.
"""

import shutil

import numpy as np
import pytest

from benchmarks.cases.modes_case import modes_case
from benchmarks.methods.plain_finite_elements import plain_modes
from benchmarks.peers.finite_element_programs import (
    calculix,
    calculix_modes,
    ngsolve_modes,
)
from benchmarks.timed_runs import Failure
from modal import Support, eigenmodes
from modal.accuracy import REFERENCE_COARSE_MESH
from modal.elements.patch import held_modes
from modal.elements.unfold import whole_mesh
from modal.mesh.sector import sector
from modal.mesh.symmetry import patch_node_mask

needs_calculix = pytest.mark.skipif(
    not shutil.which("ccx"), reason="CalculiX (ccx) is not installed"
)


def graded(case, support):
    """Return frequencies [Hz] from CalculiX's 20-node hexahedra on the whole disk.

    The mesh is that of the standard accuracy level.
    """
    part = sector(
        case.plate.radius, case.plate.thickness, support, REFERENCE_COARSE_MESH
    )
    points, cells, _ = whole_mesh(
        part.mesh.doflocs.T, part.mesh.dofs.element_dofs.T, part.quarter
    )
    held = np.zeros(0, int)
    if part.patch:
        held = np.flatnonzero(
            patch_node_mask(
                points,
                case.plate.radius,
                np.deg2rad(support.half_angle_deg),
                part.patch,
            )
        )
    return np.array(
        calculix(
            case, points, cells[:, :20], np.intersect1d(held, cells[:, :20])
        ).values
    )


@needs_calculix
@pytest.mark.parametrize("kind", ["patch", "free"])
def test_calculix_is_within_a_percent_on_graded_hexahedra(kind):
    case = modes_case(kind)
    assert graded(case, Support(kind=kind)) == pytest.approx(case.reference, rel=0.012)


@needs_calculix
@pytest.mark.parametrize("position", ["middle", "bottom"])
def test_calculix_agrees_on_a_patch_over_part_of_the_thickness(position):
    case = modes_case("patch")
    support = Support(height=0.0064, position=position)
    ours = held_modes(case.plate, support, 20.5e3, "standard").frequency
    assert graded(case, support) == pytest.approx(ours[:9], rel=0.01)


@needs_calculix
@pytest.mark.parametrize("kind", ["patch", "free"])
def test_calculix_and_scikit_fem_agree_on_the_same_tetrahedra(kind):
    case = modes_case(kind)
    mesh = ("P2 tetrahedra", 3, 1)
    assert calculix_modes(case, *mesh).values == pytest.approx(
        plain_modes(case, *mesh).values, rel=2e-3
    )


@pytest.mark.parametrize(
    ("kind", "refinements", "tolerance"), [("patch", 4, 0.02), ("free", 0, 0.003)]
)
def test_ngsolve_is_as_near_as_its_mesh_allows(kind, refinements, tolerance):
    """Higher accuracy would need far smaller tetrahedra at the edge of the patch."""
    pytest.importorskip("ngsolve", reason="NGSolve is not installed")
    case = modes_case(kind)
    theirs = np.array(ngsolve_modes(case, "P3 tetrahedra", refinements, 1).values)
    assert theirs == pytest.approx(case.reference, rel=tolerance)
    ours = eigenmodes(case.scene, below=1.1 * case.reference[-1]).frequency[
        : len(theirs)
    ]
    assert theirs == pytest.approx(ours, rel=0.02)


def test_a_program_that_is_missing_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(Failure, match="CalculiX"):
        calculix_modes(modes_case("free"), "P2 tetrahedra", 1, 1)
