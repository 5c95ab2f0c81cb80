"""Claim: the solver converges at the theoretical rates and reproduces static limits; quadratic
elements lock neither in thin disks nor near incompressibility.

Source: eigenvalues of smooth problems converge with twice the degree of the elements; u ~ r^(1/2)
at a patch edge gives order 1 on uniform meshes, and twice this order with squared cells around the
edge. Oracle: fitted slopes; the spectral solution; static deflections computed by another program.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse.linalg import spsolve
from skfem import ElementHex2

from benchmarks.charts.stability_modes import (
    bending_by_elements,
    bending_by_polynomials,
    bending_of_solid,
    free_disk,
)
from modal import FreeDisk, Material, Plate, Support
from modal.elements.elastic import assemble_solid
from modal.elements.patch import (
    held_modes,
    mesh_sizes,
    resolving_mesh_size,
    solve_symmetry_class,
    solve_symmetry_classes,
)
from modal.mesh.half_disk import MeshSize
from modal.mesh.sector import sector
from modal.mesh.symmetry import (
    Mirror,
    admissible_displacements,
    patch_node_mask,
    symmetry_classes,
)
from modal.spectral.p_refinement import all_eigenpairs, displacement_amplitudes

STEEL = Material(young=195e9, poisson=0.28)
DENSITY = 0.4387 / (np.pi * 0.03755**2 * 0.0128)
DISK = Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=DENSITY)


def slope(x, y):
    return np.polyfit(np.log(x), np.log(y), 1)[0]


SPLITS = np.array([1, 2, 3])
HELD, SWING = Support(half_angle_deg=45), Mirror(y=1, z=-1)


def order(errors):
    """Return the slopes between successive meshes, extrapolated linearly to zero cell size."""
    local = -np.diff(np.log(errors)) / np.diff(np.log(SPLITS))
    size = 1 / np.sqrt(SPLITS[1:] * SPLITS[:-1])
    return np.polyfit(size, local, 1)[1]


def swings(rings):
    """Return relative errors of the lowest swing of the held disk on successively finer meshes."""
    exact = (
        FreeDisk(plate=DISK)
        .held(HELD, 12e3)[symmetry_classes(True).index(SWING)]
        .frequency[0]
    )
    found = []
    for split in SPLITS:
        part = sector(
            DISK.radius,
            DISK.thickness,
            HELD,
            MeshSize(width=np.pi / 4, depth=0.5, rings=rings, split=split),
        )
        solid = assemble_solid(part.mesh, ElementHex2(), STEEL, DENSITY, 4)
        held = patch_node_mask(
            solid.points, DISK.radius, np.deg2rad(HELD.half_angle_deg), part.patch
        )
        values = solve_symmetry_class(
            solid, part, SWING, DISK, HELD, held, 0.0, below=np.inf, exact_count=1
        ).values
        found.append(np.sqrt(values[0]) / (2 * np.pi))
    return np.array(found) / exact - 1


def test_order_4_without_a_patch():
    """Quadratic elements without singularity converge as h^4."""
    found = np.array(
        [bending_of_solid(DISK, free_disk(DISK, "Q2", split)) for split in SPLITS]
    )
    assert order(found / bending_by_polynomials(DISK, (14, 8)) - 1) == pytest.approx(
        4, abs=0.1
    )


@pytest.mark.parametrize(("element", "slack"), [("P2", 0.05), ("Q2", 0.03)])
def test_quadratic_elements_lock_in_no_usual_disk(element, slack):
    """Their frequencies are upper bounds; linear elements fail on such disks."""
    rubber = replace(STEEL, poisson=0.4999)
    thin = [replace(DISK, thickness=t * DISK.radius) for t in (0.01, 0.1)]
    for plate in (DISK, *thin, replace(DISK, material=rubber)):
        ratio = bending_by_elements(element, plate) / bending_by_polynomials(plate)
        assert 1 < ratio < 1 + slack


def test_order_1_with_a_patch_on_meshes_that_are_not_graded():
    assert order(swings(rings=0)) == pytest.approx(1, abs=0.1)


@pytest.mark.slow
def test_squared_cells_about_the_edge_double_the_order():
    """Squared cells contain u ~ r^(1/2), which limits the order; one ring of cells is sufficient.

    On finer meshes the corners of the edge with the faces dominate the error.
    """
    plain = swings(rings=0)
    squared = swings(rings=1)
    assert slope(1 / SPLITS, squared) > 1.9
    assert squared[-1] < 0.1 * plain[-1]


def static_far_rim(component, mirror):
    """Return the static displacement [m] of the far rim under a base acceleration of 1 m/s^2.

    The mesh is that of the modes.
    """
    size = resolving_mesh_size(mesh_sizes("standard", DISK, Support())[0], DISK, 60e3)
    part, solid, _ = solve_symmetry_classes(
        DISK, Support(), size, {"below": 0.0, "exact_count": 1}
    )
    held = patch_node_mask(
        solid.points, DISK.radius, np.deg2rad(Support().half_angle_deg), part.patch
    )
    free = admissible_displacements(
        solid.points, held, Support().held, mirror, DISK.radius
    )
    load = np.zeros((len(solid.points), 3))
    load[:, component] = 1.0
    answer = spsolve(
        (free.T @ solid.stiffness @ free).tocsc(), free.T @ (solid.mass @ load.ravel())
    )
    far = np.argmin(
        np.linalg.norm(solid.points - [-DISK.radius, 0, DISK.thickness / 2], axis=1)
    )
    return (free @ answer).reshape(-1, 3)[far, component]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("component", "mirror", "expected"), [(1, (-1, 1), 5.19e-8), (2, (1, -1), 3.50e-8)]
)
def test_static_deflection_under_base_acceleration(component, mirror, expected):
    """sum_k phi_k Gamma_k / w_k^2 equals the static solution.

    Shapes, participation factors and frequencies are therefore consistent.
    """
    modes = held_modes(DISK, Support(), 60e3, "standard")
    far = modes.at_rim([np.pi])[:, 0, component] * (1 if component == 2 else -1)
    by_modes = (
        far * modes.participation[:, component] / (2 * np.pi * modes.frequency) ** 2
    ).sum()
    by_solve = static_far_rim(component, Mirror(y=mirror[0], z=mirror[1]))
    assert by_modes == pytest.approx(by_solve, rel=2e-3)
    assert by_solve == pytest.approx(expected, rel=0.02)


def test_static_deflection_of_the_free_disk():
    """1 N over the +-5 degree arc moves the far rim by 2.303e-9 m beyond rigid motion."""
    zeta, weight = np.polynomial.legendre.leggauss(10)
    moved = 0.0
    arc = np.deg2rad(5)
    for pairs in all_eigenpairs(DISK, 200e3, 1e-4):
        n = pairs.problem.n
        axial = displacement_amplitudes(pairs, np.ones(1), zeta)[2, :, 0] @ weight / 2
        moved += (-1) ** n * np.sinc(n * arc / np.pi) * (axial**2 / pairs.values).sum()
    assert moved == pytest.approx(2.3030e-9, rel=5e-3)
