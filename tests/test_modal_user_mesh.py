"""Claim: a mesh made elsewhere gives the same modes, and one that will not do is refused with a sentence that says why.

Oracle: the disk of the +-5 degree table, written to files by this test and read back.
"""

import meshio
import numpy as np
import pytest
import skfem

from modal import Material, Plate, Support, mesh_modes, plate_modes
from modal.mesh import extrude, hexahedra
from modal.plane import Blocks, half_disk

RADIUS, THICKNESS, MASS = 0.03755, 0.0128, 0.4387
DENSITY = MASS / (np.pi * RADIUS**2 * THICKNESS)
STEEL = Material(young=195e9, poisson=0.28)
REFERENCE = np.array([800.52, 1080.07, 2261.27, 7266.64])


def curved():
    cells = half_disk(np.deg2rad(5), Blocks(width=np.pi / 8, depth=0.38, rings=2)) * RADIUS
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]])
    return hexahedra(extrude(cells, np.linspace(-THICKNESS / 2, THICKNESS / 2, 2)))


def straight():
    mesh = curved()
    return skfem.MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)


def frequencies(path, support=None, **kwargs):
    return mesh_modes(path, STEEL, DENSITY, support or Support(), below=8e3, **kwargs)


def test_curved_hexahedra_give_the_table(tmp_path):
    curved().save(str(tmp_path / "disk.vtu"))
    modes = frequencies(tmp_path / "disk.vtu")
    assert modes.frequency == pytest.approx(REFERENCE, rel=0.02)
    assert modes.mass == pytest.approx(MASS, rel=1e-3)
    assert modes.parity == ("odd", "even", "odd", "even")
    assert modes.residual.max() < 1e-8


def test_the_error_indicator_falls_with_refinement_as_the_error_does(tmp_path):
    plate = Plate(radius=RADIUS, thickness=THICKNESS, material=STEEL, density=DENSITY)
    exact = plate_modes(plate, 12e3).frequency[0]
    error, indicated = [], []
    for split in (1, 2):
        cells = half_disk(np.pi, Blocks(width=np.pi / 4, depth=0.5, rings=0, split=split)) * RADIUS
        cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]])
        mesh = hexahedra(extrude(cells, np.linspace(-THICKNESS / 2, THICKNESS / 2, split + 1)))
        mesh.save(str(tmp_path / "disk.vtu"))
        modes = mesh_modes(tmp_path / "disk.vtu", STEEL, DENSITY, Support(kind="free"), below=12.5e3)
        error.append(modes.frequency[0] / exact - 1)
        indicated.append(modes.error[0])
    assert error[0] / error[1] == pytest.approx(16, rel=0.4)
    assert indicated[0] / indicated[1] > 8
    assert 0.1 < indicated[1] / error[1] < 10


@pytest.mark.parametrize("suffix", [".vtu", ".msh", ".inp"])
def test_linear_tetrahedra_are_promoted_because_they_lock(tmp_path, suffix):
    path = tmp_path / f"disk{suffix}"
    tets = straight().to_meshtet()
    options = {"file_format": "gmsh"} if suffix == ".msh" else {}
    meshio.Mesh(tets.p.T, [("tetra", tets.t.T)]).write(path, **options)
    promoted, linear = frequencies(path), frequencies(path, promote=False)
    assert promoted.frequency == pytest.approx(REFERENCE, rel=0.08)
    assert linear.frequency[0] > 1.15 * REFERENCE[0]


def test_a_named_surface_holds_the_body(tmp_path):
    mesh = straight()
    rim = mesh.facets_satisfying(lambda x: np.hypot(x[0], x[1]) > 0.9 * RADIUS, boundaries_only=True)
    middle = mesh.p[:, mesh.facets[:, rim]].mean(axis=1)
    held = rim[(np.abs(np.arctan2(middle[1], middle[0])) < np.deg2rad(5)) & (np.hypot(*middle[:2]) > 0.98 * RADIUS)]
    held = held[np.ptp(mesh.p[2, mesh.facets[:, held]], axis=0) > 0]
    mesh.with_boundaries({"clamp": held}).save(str(tmp_path / "disk.vtu"))
    named = frequencies(tmp_path / "disk.vtu", patch="clamp")
    assert named.frequency == pytest.approx(frequencies(tmp_path / "disk.vtu").frequency, rel=1e-9)
    with pytest.raises(ValueError, match="no surface 'grip', only \\['clamp'\\]"):
        frequencies(tmp_path / "disk.vtu", patch="grip")


def test_a_free_mesh_has_six_rigid_modes_left_out(tmp_path):
    curved().save(str(tmp_path / "disk.vtu"))
    modes = mesh_modes(tmp_path / "disk.vtu", STEEL, DENSITY, Support(kind="free"), below=20e3)
    assert modes.order.tolist() == [2, 2, 0]
    assert modes.frequency == pytest.approx([10602.7, 10602.7, 16997.7], rel=0.01)


def write(path, points, cells):
    meshio.Mesh(points, cells).write(path)
    return path


def refused(tmp_path, points, cells, match, **kwargs):
    with pytest.raises(ValueError, match=match):
        frequencies(write(tmp_path / "bad.vtu", points, cells), **kwargs)


def test_meshes_that_will_not_do(tmp_path):
    mesh = straight()
    points, cells = mesh.p.T, mesh.to_meshtet().t.T
    refused(tmp_path, 1e3 * points, [("tetra", cells)], "millimetres")
    refused(tmp_path, points, [("triangle", cells[:, :3])], "no volume cells")
    refused(tmp_path, points * [1, 1, 0], [("tetra", cells)], "flat or folded")
    two = np.concatenate([points, points + np.array([0.09, 0, 0])])
    refused(tmp_path, two, [("tetra", np.concatenate([cells, cells + len(points)]))], "2 bodies")
    flat = cells.copy()
    flat[7, 3] = flat[7, 2]
    refused(tmp_path, points, [("tetra", flat)], "flat or folded")
    narrow = Support(half_angle_deg=0.01)
    refused(tmp_path, points, [("tetra", cells)], "no facet", support=narrow)
