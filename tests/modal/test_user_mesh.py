"""Claim: a mesh from another program gives the same modes, and an unsuitable mesh is rejected with
a one-sentence explanation.

Oracle: the disk of the +-5 degree table, written to files by this test and read back.
"""

import sys
from contextlib import redirect_stdout
from threading import Thread

import meshio
import numpy as np
import pytest
import skfem

from modal import FreeDisk, Material, Plate, Support, mesh_modes, plate_modes, write_vtu
from modal.elements.patch import held_modes
from modal.elements.user_mesh import (
    discretise,
    elastic_eigenpairs,
    linear_and_quadratic_elements,
)
from modal.mesh.files import CapturedStream
from modal.mesh.half_disk import MeshSize, half_disk
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.read import patch_facets, read_mesh
from modal.mesh.sector import extrude, hexahedra

RADIUS, THICKNESS, MASS = 0.03755, 0.0128, 0.4387
DENSITY = MASS / (np.pi * RADIUS**2 * THICKNESS)
STEEL = Material(young=195e9, poisson=0.28)
SOLID = {
    "radius": RADIUS,
    "thickness": THICKNESS,
    "material": STEEL,
    "density": DENSITY,
}
REFERENCE = np.array([800.52, 1080.07, 2261.27, 7266.64])


def curved(rings=2):
    cells = (
        half_disk(
            np.deg2rad(5),
            MeshSize(width=np.pi / 8, depth=0.38, rings=rings, box_ratio=0.5),
        )
        * RADIUS
    )
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]])
    return hexahedra(extrude(cells, np.linspace(-THICKNESS / 2, THICKNESS / 2, 2)))


def straight():
    mesh = curved(rings=0)
    return skfem.MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)


def frequencies(path, support=None, **kwargs):
    return mesh_modes(path, STEEL, DENSITY, support or Support(), below=8e3, **kwargs)


@pytest.mark.slow
def test_curved_hexahedra_give_the_table(tmp_path):
    curved().save(str(tmp_path / "disk.vtu"))
    modes = frequencies(tmp_path / "disk.vtu")
    assert modes.frequency == pytest.approx(REFERENCE, rel=0.02)
    assert modes.mass == pytest.approx(MASS, rel=1e-3)
    assert modes.parity == ("odd", "even", "odd", "even")
    assert modes.residual.max() < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize(
    "support", [Support(), Support(height=THICKNESS / 2, held=("tangential", "axial"))]
)
def test_the_mesh_written_with_the_modes_gives_them_back(tmp_path, support):
    """Squared cells have sides that meet at a straight angle at the patch edge, but no fold."""
    given = held_modes(Plate(**SOLID), support, 8e3, "standard")
    write_vtu(given, tmp_path / "modes.vtu")
    again = frequencies(tmp_path / "modes.vtu", support, refine=False)
    assert again.frequency == pytest.approx(given.frequency, rel=1e-4)


def free_hexahedra(path, split, thickness=THICKNESS, layers=1):
    """Write curved hexahedra of the free disk, with split^2 cells per block in each layer."""
    cells = (
        half_disk(np.pi, MeshSize(width=np.pi / 4, depth=0.5, rings=0, split=split))
        * RADIUS
    )
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]])
    hexahedra(
        extrude(cells, np.linspace(-thickness / 2, thickness / 2, layers + 1))
    ).save(str(path))


@pytest.mark.parametrize("refine", [True, False])
def test_the_error_estimate_bounds_the_error_of_a_free_disk(tmp_path, refine):
    exact = plate_modes(Plate(**SOLID), 30e3).frequency
    free_hexahedra(tmp_path / "disk.vtu", 1)
    modes = mesh_modes(
        tmp_path / "disk.vtu",
        STEEL,
        DENSITY,
        Support(kind="free"),
        below=24e3,
        refine=refine,
    )
    error = modes.frequency / exact[: len(modes)] - 1
    assert len(modes) == np.count_nonzero(exact < 24e3)
    assert (error <= modes.error).mean() >= 0.9
    assert error.min() > -1e-4
    assert error.max() < (0.01 if refine else 0.1)


def test_a_pair_spans_the_plane_of_the_exact_pair(tmp_path):
    """The mesh rotates the shapes of a pair arbitrarily; only the plane they span is unique."""
    exact = plate_modes(Plate(**SOLID), 12e3)
    free_hexahedra(tmp_path / "disk.vtu", 1)
    modes = mesh_modes(
        tmp_path / "disk.vtu", STEEL, DENSITY, Support(kind="free"), below=12e3
    )
    ours, known = (
        np.linalg.qr(m.rim_shape[:2].reshape(2, -1).T)[0] for m in (modes, exact)
    )
    assert np.linalg.svd(ours.T @ known, compute_uv=False).min() > 0.9995
    whole = np.einsum("apx,bpx->ab", modes.body.displacement, modes.body.displacement)
    assert abs(whole[0, 1]) < 1e-3 * whole[0, 0]


@pytest.mark.slow
@pytest.mark.parametrize("half_angle_deg", [5, 22.5])
def test_the_error_estimate_bounds_the_error_on_a_patch(tmp_path, half_angle_deg):
    """Oracle: synthesis, which has no mesh. Cells are 5 or 22.5 degrees wide and not graded."""
    support = Support(half_angle_deg=half_angle_deg)
    disk = Plate(**SOLID)
    exact = FreeDisk(plate=disk).frequencies(support, 20e3)
    cells = (
        half_disk(
            np.deg2rad(half_angle_deg), MeshSize(width=np.pi / 8, depth=0.38, rings=0)
        )
        * RADIUS
    )
    cells = np.concatenate([cells, cells[:, ::-1] * [1, -1]])
    hexahedra(extrude(cells, np.linspace(-THICKNESS / 2, THICKNESS / 2, 2))).save(
        str(tmp_path / "disk.vtu")
    )
    modes = mesh_modes(tmp_path / "disk.vtu", STEEL, DENSITY, support, below=20e3)
    error = modes.frequency / exact[: len(modes)] - 1
    assert (error <= modes.error).mean() >= 0.9
    assert 0.005 < error.max() < 0.08


@pytest.mark.parametrize("suffix", [".vtu", ".msh", ".inp"])
def test_linear_tetrahedra_are_promoted_because_they_lock(tmp_path, suffix):
    path = tmp_path / f"disk{suffix}"
    tets = straight().to_meshtet()
    options = {"file_format": "gmsh"} if suffix == ".msh" else {}
    meshio.Mesh(tets.p.T, [("tetra", tets.t.T)]).write(path, **options)
    assert frequencies(path, refine=False).frequency == pytest.approx(
        REFERENCE, rel=0.1
    )
    mesh = read_mesh(path)
    linear, quadratic = linear_and_quadratic_elements(mesh)
    as_given = discretise(
        mesh,
        patch_facets(mesh, Support()),
        linear,
        [quadratic.doflocs.T],
        STEEL,
        DENSITY,
    )
    assert (
        np.sqrt(elastic_eigenpairs(as_given, Support().held, 8e3, 0.0)[0][0])
        > 1.15 * 2 * np.pi * REFERENCE[0]
    )


def test_a_named_surface_holds_the_body(tmp_path):
    mesh = straight()
    rim = mesh.facets_satisfying(
        lambda x: np.hypot(x[0], x[1]) > 0.9 * RADIUS, boundaries_only=True
    )
    middle = mesh.p[:, mesh.facets[:, rim]].mean(axis=1)
    held = rim[
        (np.abs(np.arctan2(middle[1], middle[0])) < np.deg2rad(5))
        & (np.hypot(*middle[:2]) > 0.98 * RADIUS)
    ]
    held = held[np.ptp(mesh.p[2, mesh.facets[:, held]], axis=0) > 0]
    mesh.with_boundaries({"clamp": held}).save(str(tmp_path / "disk.vtu"))
    named = frequencies(tmp_path / "disk.vtu", patch="clamp", refine=False)
    assert named.frequency == pytest.approx(
        frequencies(tmp_path / "disk.vtu", refine=False).frequency, rel=1e-9
    )
    with pytest.raises(ValueError, match="no surface 'grip', only \\['clamp'\\]"):
        frequencies(tmp_path / "disk.vtu", patch="grip")


@pytest.mark.slow
def test_a_free_mesh_has_six_rigid_modes_left_out(tmp_path):
    curved().save(str(tmp_path / "disk.vtu"))
    modes = mesh_modes(
        tmp_path / "disk.vtu", STEEL, DENSITY, Support(kind="free"), below=20e3
    )
    assert modes.order.tolist() == [2, 2, 0]
    assert modes.frequency == pytest.approx([10602.7, 10602.7, 16997.7], rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["patch", "free"])
@pytest.mark.parametrize("refine", [True, False])
def test_a_body_without_modes_below_the_limit_gives_none(tmp_path, kind, refine):
    curved().save(str(tmp_path / "disk.vtu"))
    modes = mesh_modes(
        tmp_path / "disk.vtu",
        STEEL,
        DENSITY,
        Support(kind=kind),
        below=100,
        refine=refine,
    )
    assert len(modes) == len(modes.error) == 0
    assert modes.rim_shape.shape == (0, 128, 3)
    assert modes.face_shape.shape == (0, 2, 16, 64)


@pytest.mark.parametrize("aspect", [2, 3])
def test_a_free_cylinder_thicker_than_its_radius_has_six_rigid_modes_too(
    tmp_path, aspect
):
    """Oracle: the spectral solution."""
    thick = Plate(**SOLID | {"thickness": aspect * RADIUS})
    free_hexahedra(tmp_path / "thick.vtu", 1, thick.thickness, layers=2 * aspect)
    modes = mesh_modes(
        tmp_path / "thick.vtu",
        STEEL,
        DENSITY,
        Support(kind="free"),
        below=28e3,
        refine=False,
    )
    exact = plate_modes(thick, 30e3).frequency[: len(modes)]
    assert len(modes) >= 3
    assert modes.frequency == pytest.approx(exact, rel=0.02)


def test_a_patch_all_around_holds_the_facet_opposite_its_middle():
    """One of a cube's four lateral sides has its centre at 180 degrees."""
    cube = skfem.MeshHex().translated((-0.5, -0.5, -0.5))
    assert len(patch_facets(cube, Support(half_angle_deg=180))) == 4
    assert len(patch_facets(cube, Support(half_angle_deg=179))) == 3


def corners_and_edges(mesh):
    """Return the cells (c, 20) of a MeshHex2 in VTK's order."""
    lattice = {
        tuple(node): i
        for i, node in enumerate(np.rint(2 * mesh.elem.doflocs).astype(int))
    }
    return mesh.dofs.element_dofs[[lattice[node] for node in VTK_HEXAHEDRON27[:20]]].T


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".vtu", ".inp"])
def test_hexahedra_of_20_nodes_are_the_curved_ones(tmp_path, suffix):
    mesh = curved()
    mesh.save(str(tmp_path / "disk27.vtu"))
    meshio.Mesh(mesh.doflocs.T, [("hexahedron20", corners_and_edges(mesh))]).write(
        tmp_path / f"disk20{suffix}"
    )
    both = [
        frequencies(tmp_path / name, refine=False)
        for name in ("disk27.vtu", f"disk20{suffix}")
    ]
    assert both[1].frequency == pytest.approx(both[0].frequency, rel=2e-4)
    assert both[1].mass == pytest.approx(MASS, rel=1e-3)


@pytest.mark.slow
def test_curved_tetrahedra_are_cut_along_their_curves(tmp_path):
    """Eight tetrahedra form the same body: equal mass to rounding, and lower frequencies."""
    mesh = skfem.MeshTet2.from_mesh(straight().to_meshtet())
    mesh.doflocs[2] *= 1 + 0.3 * (mesh.doflocs[0] / RADIUS) ** 2
    mesh.save(str(tmp_path / "disk.vtu"))
    given, cut = (
        frequencies(tmp_path / "disk.vtu", refine=refine) for refine in (False, True)
    )
    assert cut.mass == pytest.approx(given.mass, rel=1e-9)
    few = min(len(cut), len(given))
    assert (cut.frequency[:few] < given.frequency[:few]).all()
    assert (given.frequency[:few] / cut.frequency[:few] - 1 < cut.error[:few]).all()


def write(path, points, cells):
    meshio.Mesh(points, cells).write(path)
    return path


def refused(tmp_path, points, cells, match, **kwargs):
    with pytest.raises(ValueError, match=match):
        frequencies(write(tmp_path / "bad.vtu", points, cells), **kwargs)


def test_while_a_mesh_is_read_other_threads_still_write(capsys):
    with redirect_stdout(CapturedStream(sys.stdout)):
        print("of the reader")
        other = Thread(target=print, args=["of another"])
        other.start()
        other.join()
    assert capsys.readouterr().out == "of another\n"


def test_a_cell_with_a_node_that_is_none_is_refused(tmp_path):
    mesh = straight()
    cells = mesh.to_meshtet().t.T.copy()
    cells[7, 3] = mesh.p.shape[1]
    path = tmp_path / "bad.mesh"
    write(path, mesh.p.T, [("tetra", cells)])
    with pytest.raises(ValueError, match="a cell has a node number outside 0 to"):
        read_mesh(path)


def test_meshes_that_will_not_do(tmp_path):
    mesh = straight()
    points = mesh.p.T
    cells = mesh.to_meshtet().t.T
    refused(tmp_path, 1e3 * points, [("tetra", cells)], "millimetres")
    refused(tmp_path, points, [("triangle", cells[:, :3])], "no volume cells")
    refused(tmp_path, points * [1, 1, 0], [("tetra", cells)], "flat or folded")
    two = np.concatenate([points, points + np.array([0.09, 0, 0])])
    refused(
        tmp_path,
        two,
        [("tetra", np.concatenate([cells, cells + len(points)]))],
        "2 bodies",
    )
    flat = cells.copy()
    flat[7, 3] = flat[7, 2]
    refused(tmp_path, points, [("tetra", flat)], "flat or folded")
    mesh.save(str(tmp_path / "good.vtu"))
    bricks = meshio.read(tmp_path / "good.vtu").cells[0].data.copy()
    bricks[7] = bricks[7][[4, 5, 6, 7, 0, 1, 2, 3]]
    refused(
        tmp_path,
        points,
        [("hexahedron", bricks)],
        "1 of 60 cells are numbered inside out; the first one is 7",
    )
    narrow = Support(half_angle_deg=0.01)
    refused(tmp_path, points, [("tetra", cells)], "no facet", support=narrow)
