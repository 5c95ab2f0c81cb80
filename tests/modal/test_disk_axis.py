"""Claim: a disk on a mesh is turned until its axis is z, whatever its orientation and position; a body
whose axis cannot be told is refused in one line.

Source: the moments of inertia of a cylinder. Oracle: the rotation by which the mesh was turned; the
modes of the mesh with its axis along z.
"""

import numpy as np
import pytest
import skfem
from scipy.spatial.transform import Rotation

from modal import Material, Plate, Support, mesh_modes, plate_modes
from modal.mesh.disk_axis import rotation_to_z
from modal.mesh.half_disk import MeshSize, half_disk
from modal.mesh.read import read_mesh
from modal.mesh.sector import extrude, hexahedra

RADIUS = 0.03755
STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)
FREE = Support(kind="free")
ORIENTATIONS = {
    "as it is": np.eye(3),
    "y upwards": [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    "y downwards": [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    "x upwards": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
    "upside down": [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
    "oblique": Rotation.from_rotvec([0.7, -0.4, 1.9]).as_matrix(),
    "nearly x": Rotation.from_euler("xyz", [0.02, 1.5, 0.3]).as_matrix(),
    "tilted by 2 degrees": Rotation.from_euler("x", 2, degrees=True).as_matrix(),
    "tilted by 0.1 degrees": Rotation.from_euler("y", 0.1, degrees=True).as_matrix(),
}
PLACE = np.array([0.3, -0.2, 0.11])


def disk(thickness=0.0128, cells="hexahedra"):
    """Return a mesh of the disk with curved hexahedra, or with straight tetrahedra."""
    plane = half_disk(np.pi, MeshSize(width=np.pi / 4, depth=0.5, rings=0)) * RADIUS
    return extruded(np.concatenate([plane, plane[:, ::-1] * [1, -1]]), thickness, cells)


def ring(thickness):
    """Return a mesh of a ring of curved hexahedra."""
    angle = np.linspace(0, 2 * np.pi, 25)
    angles = np.array([angle[2 * i : 2 * i + 3] for i in range(12)])[:, :, None]
    radii = RADIUS * np.array([0.8, 0.9, 1.0])
    plane = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=-1)
    return extruded(plane, thickness, "hexahedra")


def extruded(plane, thickness, cells):
    """Return the mesh of plane cells (q, 3, 3, 2) in layers."""
    layers = max(1, round(thickness / RADIUS))
    mesh = hexahedra(
        extrude(plane, np.linspace(-thickness / 2, thickness / 2, layers + 1))
    )
    if cells == "tetrahedra":
        mesh = skfem.MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t).to_meshtet()
    return mesh


def moved(mesh, rotation, path):
    """Write a mesh after a rotation and a translation."""
    mesh.doflocs[:] = np.asarray(rotation) @ mesh.doflocs + PLACE[:, None]
    mesh.save(str(path))
    return path


def is_upright(mesh, thickness, radius=RADIUS):
    """Return True if a mesh is a centred disk with its axis along z."""
    x, y, z = mesh.p
    return (
        z.min() == pytest.approx(-thickness / 2, rel=1e-6)
        and z.max() == pytest.approx(thickness / 2, rel=1e-6)
        and np.hypot(x, y).max() == pytest.approx(radius, rel=1e-6)
        and np.abs(mesh.p[:, np.hypot(x, y) > 0.999 * radius].mean(axis=1)).max()
        < 1e-6 * radius
    )


@pytest.mark.slow
@pytest.mark.parametrize("cells", ["hexahedra", "tetrahedra"])
@pytest.mark.parametrize("orientation", ORIENTATIONS)
def test_a_disk_is_turned_from_any_orientation(tmp_path, orientation, cells):
    """Thin, thick and long cylinders; their moments are equal at a thickness of sqrt(3) R."""
    for thickness in (0.002, 0.0128, 1.2 * RADIUS, 2.5 * RADIUS):
        path = moved(
            disk(thickness, cells=cells),
            ORIENTATIONS[orientation],
            tmp_path / "disk.vtu",
        )
        assert is_upright(read_mesh(path), thickness)


def test_a_disk_along_z_is_only_centred(tmp_path):
    mesh = disk()
    given = mesh.doflocs.copy()
    read = read_mesh(moved(mesh, np.eye(3), tmp_path / "disk.vtu"))
    order = np.lexsort(given.round(9))
    assert read.doflocs[:, np.lexsort(read.doflocs.round(9))] == pytest.approx(
        given[:, order], abs=1e-15
    )


@pytest.mark.parametrize("orientation", ["y upwards", "oblique", "tilted by 2 degrees"])
def test_the_orders_of_a_turned_disk_are_right(tmp_path, orientation):
    exact = plate_modes(
        Plate(radius=RADIUS, thickness=0.0128, material=STEEL, density=7737.0), 20e3
    )
    straight, turned = (
        mesh_modes(
            moved(disk(), ORIENTATIONS[how], tmp_path / f"{i}.vtu"),
            STEEL,
            7737.0,
            FREE,
            below=20e3,
            refine=False,
        )
        for i, how in enumerate(["as it is", orientation])
    )
    assert turned.order.tolist() == straight.order.tolist() == exact.order.tolist()
    assert turned.family == straight.family
    assert turned.frequency == pytest.approx(straight.frequency, rel=1e-9)
    shapes = [np.abs(modes.face_shape[2]).mean(axis=2) for modes in (turned, straight)]
    assert shapes[0] == pytest.approx(shapes[1], rel=0.02, abs=0.05)


@pytest.mark.parametrize("orientation", ["y upwards", "oblique"])
def test_a_plate_that_is_not_round_is_turned_by_its_flat_faces(tmp_path, orientation):
    """The rod-like axis of a long plate is not that of a disk; nor is that of a disk with a notch."""
    bar = (
        skfem.MeshHex()
        .refined(2)
        .translated((-0.5, -0.5, -0.5))
        .scaled((0.12, 0.05, 0.004))
    )
    read = read_mesh(moved(bar, ORIENTATIONS[orientation], tmp_path / "bar.vtu"))
    assert np.ptp(read.p[2]) == pytest.approx(0.004, rel=1e-6)
    notched = disk(cells="tetrahedra")
    middle = notched.p[:, notched.t].mean(axis=1)
    notched = notched.restrict(np.flatnonzero((middle[0] < 0.02) | (middle[2] < 0)))
    height = np.ptp(notched.p[2])
    read = read_mesh(
        moved(notched, ORIENTATIONS[orientation], tmp_path / "notched.vtu")
    )
    assert np.ptp(read.p[2]) == pytest.approx(height, rel=1e-6)


@pytest.mark.parametrize("orientation", ["y upwards", "oblique"])
def test_a_ring_is_turned(tmp_path, orientation):
    path = moved(ring(0.0128), ORIENTATIONS[orientation], tmp_path / "ring.vtu")
    assert is_upright(read_mesh(path), 0.0128)


def round_body(profile):
    """Return the mesh of a disk whose faces are at the heights +-profile(r)."""
    mesh = disk(0.0128, cells="tetrahedra").refined(1)
    mesh.doflocs[2] *= profile(np.hypot(*mesh.doflocs[:2]) / RADIUS)
    return mesh


def test_a_coin_with_a_raised_rim_is_turned(tmp_path):
    """Its outermost flat faces are a narrow ring, and its inner faces are slightly hollow."""
    coin = round_body(lambda r: np.where(r > 0.8, 1.0, 0.7 + 0.02 * r))
    size = np.ptp(coin.doflocs, axis=1)
    upright = read_mesh(moved(coin, np.eye(3), tmp_path / "coin.vtu"))
    assert np.ptp(upright.p, axis=1) == pytest.approx(size, rel=1e-12)
    turned = read_mesh(moved(coin, ORIENTATIONS["oblique"], tmp_path / "coin.vtu"))
    assert np.ptp(turned.p[2]) == pytest.approx(0.0128, rel=1e-3)


def cylinder_of_equal_moments():
    """Return a cylinder whose moments of inertia are all equal."""
    mesh = disk(RADIUS, cells="tetrahedra").refined(1)
    basis = skfem.CellBasis(mesh, mesh.elem())
    variance = (np.asarray(basis.global_coordinates()) ** 2 * basis.dx).sum(axis=(1, 2))
    mesh.doflocs[2] *= np.sqrt(variance[0] / variance[2])
    return mesh


REFUSED = {
    "equal moments": (
        cylinder_of_equal_moments,
        "y upwards",
        "its moments of inertia do not determine the axis of the disk; turn the mesh so",
    ),
    "lens": (
        lambda: round_body(lambda r: 1.3 - r**2),
        "as it is",
        "the disk has no flat face at its lowest z; its axis must be z",
    ),
    "ball": (
        lambda: skfem.MeshTet.init_ball(2).scaled(0.03),
        "as it is",
        "its moments of inertia do not determine the axis",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_body_without_an_axis_or_faces_is_refused(tmp_path, name):
    make, orientation, message = REFUSED[name]
    path = moved(make(), ORIENTATIONS[orientation], tmp_path / "body.vtu")
    with pytest.raises(ValueError, match=message) as error:
        read_mesh(path)
    assert "\n" not in str(error.value)


def test_a_body_of_equal_moments_is_kept_if_its_faces_are_normal_to_z(tmp_path):
    mesh = cylinder_of_equal_moments()
    thickness = np.ptp(mesh.p[2])
    assert is_upright(read_mesh(moved(mesh, np.eye(3), tmp_path / "c.vtu")), thickness)


@pytest.mark.parametrize("seed", range(5))
def test_the_smallest_rotation_turns_an_axis_to_z(seed):
    axis = np.random.default_rng(seed).standard_normal(3)
    axis *= np.sign(axis[2]) / np.linalg.norm(axis)
    turn = Rotation.from_matrix(rotation_to_z(axis))
    assert turn.apply(axis) == pytest.approx([0, 0, 1], abs=1e-15)
    assert turn.magnitude() == pytest.approx(np.arccos(axis[2]), rel=1e-9)
