"""Claim: the modes of a table are those of its plate or its mesh, for every method of solution.

Source: Leissa, Vibration of Plates, ch. 2; Timoshenko & Woinowsky-Krieger, Theory of Plates and
Shells, section 16. Oracle: thin plates in closed form, the static deflection under a point load,
the spectral method against finite elements on a mesh, modal mass and shapes by quadrature.
"""

from pathlib import Path
from types import SimpleNamespace

import meshio
import numpy as np
import pytest
from plate_theory import thin_plate_frequencies
from skfem import MeshHex

from dynamics import (
    MeshSurface,
    ModesSurface,
    PlateSurface,
    Surface,
    SurfaceMode,
    plan_motion,
)
from dynamics.contact_geometry import contact_position
from modal import UnsolvableError, surface_modes
from modal.tabletop.meshed import table_on_mesh
from sonify import load_scene
from sonify.examples import own_mesh, table_mesh
from sonify.plan.motion import planned_scene
from sonify.plan.preflight import solve_motion
from sonify.plan.table import (
    deflection_limits,
    solve_table,
    table_exit_time,
)
from sonify.report.write import copy_table_mesh
from sonify.runtime.json_values import write_json
from sonify.scene import scene_record
from sonify.scene_errors import SceneError

GLASS = {"young": 70e9, "poisson": 0.22, "density": 2500.0}
WOOD = {"young": 11e9, "poisson": 0.3, "density": 700.0}


def modes_of(surface, below, accuracy="standard"):
    scene = SimpleNamespace(surface=surface, disk=SimpleNamespace(radius=0.03755))
    scene.numerics = SimpleNamespace(accuracy=accuracy)
    return surface_modes(scene, below)


def test_a_stiff_ring_under_the_edge_supports_it():
    """The plate is free; the ring is soft compared with the shear through the thickness of 1/100 of
    the radius."""
    size = {"radius": 0.2, "thickness": 0.002}
    ring = PlateSurface(
        **size, **GLASS, edge="free", ring_radius=0.2, ring_stiffness=1e12
    )
    held, supported = (
        modes_of(plate, 400.0) for plate in (ring, PlateSurface(**size, **GLASS))
    )
    assert held.frequency == pytest.approx(supported.frequency, rel=5e-3)


@pytest.mark.parametrize(
    ("radius", "poisson", "edge"),
    [
        (0.2, 0.22, "free"),
        (0.05, 0.0, "free"),
        (0.3, 0.45, "free"),
        (0.2, 0.22, "supported"),
        (1.0, 0.33, "supported"),
        (0.05, 0.1, "supported"),
        (0.2, 0.22, "clamped"),
        (0.4, 0.3, "clamped"),
    ],
)
def test_thin_plates_are_those_of_the_closed_forms(radius, poisson, edge):
    """For R/h = 200, shear and rotary inertia change a frequency by about (n pi h/R)^2, below 1e-3.

    A clamped edge converges slowest.
    """
    size = {"radius": radius, "thickness": radius / 200}
    matter = GLASS | {"poisson": poisson}
    thin = [thin_plate_frequencies(n, 4, **size, **matter, edge=edge) for n in range(4)]
    found = modes_of(PlateSurface(**size, **matter, edge=edge), 1.01 * thin[0][2])
    for n in range(4):
        frequency = np.unique(found.frequency[found.order == n].round(6))
        assert len(frequency) >= 1
        assert frequency == pytest.approx(thin[n][: len(frequency)], rel=2e-3)
    assert found.residual.max() < 1e-6
    assert found.mass == pytest.approx(2500 * np.pi * radius**3 / 200)
    assert (found.frequency > 1).all()  # excludes rigid-body modes


def test_shapes_have_modal_mass_1_and_are_the_same_on_the_face_and_between_its_points():
    found = modes_of(PlateSurface(radius=0.2, thickness=0.002, **GLASS), 1500.0)
    mass = 2500 * 0.002 * (found.face**2 @ found.weights)
    assert mass == pytest.approx(
        1, abs=2e-3
    )  # the remainder, (h k)^2/6, moves in the plane
    inside = (
        np.hypot(*found.points.T) < 0.165
    )  # five steps of the splines from the edge
    assert (
        np.abs(found.at(*found.points[inside].T).T - found.face[:, inside]).max()
        < 1e-3 * np.abs(found.face).max()
    )
    x = np.linspace(-0.1, 0.1, 20)
    step = 1e-6
    quotient = (found.at(x + step, x) - found.at(x - step, x)) / (2 * step)
    assert (
        np.abs(found.at(x, x, (1, 0)) - quotient).max() < 1e-6 * np.abs(quotient).max()
    )


def test_nowhere_has_no_values():
    """A motion without slides has no jumps, so the shapes are evaluated at no points."""
    found = modes_of(PlateSurface(radius=0.2, thickness=0.002, **GLASS), 300.0)
    assert found.at(np.zeros(0), np.zeros(0)).shape == (0, len(found))


def test_the_modes_add_up_to_the_static_deflection():
    """w(0) = P R^2 (3 + nu)/(16 pi B (1 + nu)).

    The truncated modes contribute less than the tolerance.
    """
    plate = PlateSurface(radius=0.15, thickness=0.003, **GLASS)
    stiffness = plate.young * plate.thickness**3 / (12 * (1 - plate.poisson**2))
    exact = (
        plate.radius**2
        * (3 + plate.poisson)
        / (16 * np.pi * stiffness * (1 + plate.poisson))
    )
    assert modes_of(plate, 12000.0).compliance() == pytest.approx(exact, rel=5e-3)


def test_an_elastic_ring_carries_a_free_plate():
    """On a ring much softer than itself a plate heaves as a rigid body: w^2 = 2 pi r k/m."""
    plate = PlateSurface(
        radius=0.1,
        thickness=0.01,
        **GLASS,
        edge="free",
        ring_radius=0.08,
        ring_stiffness=1e4,
    )
    found = modes_of(plate, 200.0)
    heave = found.frequency[found.order == 0]
    assert heave == pytest.approx(
        [np.sqrt(2 * np.pi * 0.08 * 1e4 / found.mass) / (2 * np.pi)], rel=1e-3
    )


@pytest.mark.slow
def test_a_mesh_and_the_spectral_method_agree(tmp_path):
    """A free disk of 72 straight cells is too stiff by up to 5 %.

    The sums of squares over pairs do not depend on their orientation.
    """
    path = own_mesh.write_disk_mesh(tmp_path / "disk.vtu", radius=0.1, thickness=0.01)
    meshed = modes_of(MeshSurface(file=str(path), **GLASS), 8000.0)
    round_ = modes_of(
        PlateSurface(radius=0.1, thickness=0.01, **GLASS, edge="free"), 8000.0
    )
    assert len(meshed) == len(round_)
    assert meshed.frequency == pytest.approx(round_.frequency, rel=0.05)
    assert meshed.mass == pytest.approx(round_.mass, rel=0.05)
    assert meshed.residual.max() < 1e-6
    x = np.array([0.0, 0.02, 0.03, 0.05])
    y = np.array([0.0, 0.01, -0.03, 0.04])
    square = [(found.at(x, y)[:, :7] ** 2).sum(axis=1) for found in (meshed, round_)]
    assert square[0] == pytest.approx(square[1], rel=0.05)


@pytest.mark.slow
def test_the_table_that_comes_with_the_program_stands_on_its_feet(tmp_path):
    """The shipped file equals the output of its script.

    Holding a surface and holding the same nodes give the same modes; without a support the table
    floats.
    """
    shipped = load_scene("wood-table").surface
    made = table_mesh.write_table_mesh(tmp_path / "table.msh")
    assert made.read_bytes() == Path(shipped.file).read_bytes()
    mesh = meshio.read(made)
    mesh.point_sets = {
        "low": np.flatnonzero(mesh.points[:, 2] < -0.039),
        "one": np.array([0]),
    }
    mesh.write(tmp_path / "sets.inp")
    surfaces = [
        MeshSurface(file=shipped.file, **WOOD, held=("feet",)),
        MeshSurface(file=shipped.file, **WOOD),
    ]
    surfaces += [MeshSurface(file=str(tmp_path / "sets.inp"), **WOOD, held=("low",))]
    held, free, again = (
        table_on_mesh(surface, 0.03755, 800.0, max_unknowns=0) for surface in surfaces
    )  # as given
    assert again.frequency == pytest.approx(held.frequency, rel=1e-9)
    assert free.frequency[0] != pytest.approx(held.frequency[0], rel=0.05)
    assert held.mass == pytest.approx(700 * (0.6 * 0.4 * 0.02 + 4 * 0.04**2 * 0.02))
    assert held.weights.sum() == pytest.approx(0.6 * 0.4)
    for change, message in [
        ({"held": ("legs",)}, "has no 'legs', only"),
        ({"held": ("one",)}, "single nodes cannot hold a solid"),
        ({"place": (0.28, 0.0)}, "is not on the top face"),
    ]:
        with pytest.raises(ValueError, match=message):
            modes_of(
                MeshSurface(**{"file": str(tmp_path / "sets.inp"), **WOOD} | change),
                1500.0,
            )


def test_the_record_of_a_run_on_a_mesh_is_a_scene_wherever_it_is(tmp_path):
    """The mesh is stored next to run.json, which contains no path of this machine and reproduces
    the scene."""
    scene = load_scene("wood-table")
    there = tmp_path / "there"
    (tmp_path / "here").mkdir()
    copy_table_mesh(Path(scene.surface.file), tmp_path / "here")
    write_json({"scene": scene_record(scene)}, tmp_path / "here" / "run.json")
    (tmp_path / "here").rename(there)
    assert str(Path(scene.surface.file).parent) not in (there / "run.json").read_text(
        "utf-8"
    )
    again = load_scene(there / "run.json")
    assert again.replace(f"surface.file={scene.surface.file}") == scene
    assert (
        Path(again.surface.file).read_bytes() == Path(scene.surface.file).read_bytes()
    )
    copy_table_mesh(Path(again.surface.file), there)  # copies the mesh onto itself


def test_a_mesh_without_a_top_face_is_refused(tmp_path):
    mesh = meshio.read(own_mesh.write_disk_mesh(tmp_path / "disk.vtu"))
    tilted = meshio.Mesh(
        mesh.points @ np.array([[1, 0, 0], [0, 0.8, 0.6], [0, -0.6, 0.8]]), mesh.cells
    )
    tilted.write(tmp_path / "tilted.vtu")
    with pytest.raises(ValueError, match="no level face at its greatest height"):
        modes_of(MeshSurface(file=str(tmp_path / "tilted.vtu"), **GLASS), 5000.0)


@pytest.mark.slow
def test_a_mesh_of_a_dining_table_is_in_metres(tmp_path):
    """Oracle: the lowest bending mode of a free beam."""
    size = np.array([2.2, 0.9, 0.03])
    box = MeshHex.init_tensor(
        *(np.linspace(0, d, n) for d, n in zip(size, (23, 10, 2), strict=True))
    )
    box.save(str(tmp_path / "table.vtu"))
    surface = MeshSurface(file=str(tmp_path / "table.vtu"), **WOOD, place=(1.1, 0.45))
    found = modes_of(surface, 40.0, "draft")
    bending = (WOOD["young"] * size[2] ** 2 / 12 / WOOD["density"]) ** 0.5
    assert found.frequency[0] == pytest.approx(
        4.73004**2 / (2 * np.pi) * bending / size[0] ** 2, rel=0.03
    )
    assert found.mass == pytest.approx(WOOD["density"] * size.prod())


def test_modes_by_number_are_what_they_say():
    given = (
        SurfaceMode(order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0),
        SurfaceMode(order=0, frequency=500.0, damping_ratio=0.1, modal_mass=4.0),
    )
    found = modes_of(ModesSurface(modes=given), 20000.0)
    assert found.frequency.tolist() == [500, 600, 600]
    assert found.decay_rate == pytest.approx(2 * np.pi * np.array([50, 12, 12]))
    angle = np.linspace(0, 2 * np.pi, 7)
    w = found.at(0.03755 * np.cos(angle), 0.03755 * np.sin(angle))
    assert w == pytest.approx(
        np.column_stack([0.5 + 0 * angle, np.cos(2 * angle), np.sin(2 * angle)]),
        abs=1e-4,
    )


def test_a_mode_given_twice_is_two_pairs():
    """Each pair has a cosine and a sine mode; order 0 has no sine mode, since it would not move."""
    one, other = (
        SurfaceMode(order=n, frequency=600.0, damping_ratio=0.0, modal_mass=1.0)
        for n in (0, 2)
    )
    angle = np.linspace(0, 2 * np.pi, 9)[:-1]
    modes = modes_of(ModesSurface(modes=(one, one, other, other)), 24e3)
    around = modes.at(0.03755 * np.cos(angle), 0.03755 * np.sin(angle)) ** 2
    assert len(modes) == 6
    assert around.sum(axis=1) == pytest.approx(4.0, abs=1e-3)


def test_a_rigid_table_has_no_modes_and_a_soft_one_too_many():
    assert len(modes_of(Surface(), 20000.0)) == 0
    with pytest.raises(UnsolvableError, match="at most 600 can be computed"):
        modes_of(PlateSurface(radius=2.0, thickness=0.001, **GLASS), 20000.0)


def test_what_cannot_be_solved_is_one_line_and_what_is_doubtful_is_said(
    tmp_path, capfd
):
    scene = load_scene("glass-plate")
    with pytest.raises(SceneError, match=r"surface.file = 'none.msh': no such file"):
        planned_scene(
            scene.replace(
                "surface={kind='mesh', file='none.msh', young=1e9, poisson=0.3, density=600.0}"
            )
        )
    for name, content in (
        ("broken.msh", "no mesh"),
        ("empty.msh", ""),
        ("broken.vtu", "<VTKFile"),
    ):
        broken = tmp_path / name
        broken.write_text(content)
        text = f"surface={{kind='mesh', file='{broken.as_posix()}', young=1e9, poisson=0.3, density=600.0}}"
        on_mesh = scene.replace(text, "audio.sample_rate=8000")
        planned = plan_motion(on_mesh)
        with pytest.raises(
            SceneError, match=rf"^surface: [^\n]*{name}: not a readable mesh[^\n]*$"
        ):
            solve_table(on_mesh, planned)
    assert capfd.readouterr() == ("", "")  # nor a line of the reader
    thin = scene.replace("surface.thickness=0.0003")
    assert deflection_limits(modes_of(scene.surface, 5000.0), scene) == []
    assert (
        "linear theory does not apply"
        in deflection_limits(modes_of(thin.surface, 500.0), thin)[0]
    )


def drifting_on(scene, axis, end):
    """Return a motion up to a time [s] on the table of a scene, in which the contact circle turns
    at 50 rad/s about a centre that drifts by 1 cm/s along x (axis 0) or y (axis 1)."""

    def at(t):
        state = np.zeros((len(t), 11))
        state[:, 0] = 50 * t
        state[:, 3 + axis] = 0.01 * t
        return state

    motion = {"t": np.array([0.0, end]), "at": at, "plan": SimpleNamespace(scene=scene)}
    return SimpleNamespace(**motion, disk=scene.disk, rolling_fillet=0.0)


def test_a_disk_that_goes_over_the_edge_is_said_to():
    """The contact circle of a flat disk turns about a centre that drifts by 1 cm/s."""
    scene = load_scene("glass-plate").replace("surface.radius=0.05")
    assert table_exit_time(drifting_on(scene, 0, 2.0)) == pytest.approx(
        1.245, abs=0.13
    )  # one turn: 0.126 s
    assert table_exit_time(drifting_on(load_scene("glass-plate"), 0, 2.0)) is None


def test_a_disk_that_goes_over_the_edge_of_a_mesh_is_said_to():
    """The wooden table is 0.4 m wide in y, and the motion starts 0.14 m from the middle.

    The contact circle reaches the edge when its centre has moved by 0.06 m less the radius.
    """
    scene = load_scene("wood-table").replace("surface.place=[0.0, 0.14]")
    assert table_exit_time(drifting_on(scene, 1, 4.0)) == pytest.approx(
        (0.06 - scene.disk.radius) / 0.01, abs=0.13
    )
    assert table_exit_time(drifting_on(load_scene("wood-table"), 1, 4.0)) is None


def test_the_edge_of_a_plate_ends_the_motion():
    """The disk is too slow to roll in a circle and runs outwards.

    Up to the edge its motion equals that on a wide plate.
    """
    wide = load_scene("glass-plate").replace(
        "numerics.time_limit=1.0", "surface.action=sound", "contact.law=rigid"
    )
    narrow = wide.replace("surface.radius=0.045")
    motion = solve_motion(plan_motion(narrow))
    further = solve_motion(plan_motion(wide))
    assert motion.outcome.name == "LEFT_TABLE"
    place = contact_position(motion.at(motion.t[-1:]), wide.disk)[0]
    assert np.hypot(*place) == pytest.approx(0.045, rel=0.02)
    t = np.linspace(0, motion.t[-1], 20)
    assert motion.at(t) == pytest.approx(further.at(t), rel=1e-9, abs=1e-12)
    with pytest.raises(
        SceneError, match=r"surface.place = \[0.1, 0.06\]: must not be more than 0.1124"
    ):
        wide.replace("surface.place=[0.1, 0.06]")


@pytest.mark.parametrize(
    ("mode", "key"),
    [
        ({"frequency": 0.0}, "frequency"),
        ({"frequency": -5.0}, "frequency"),
        ({"damping_ratio": 1.0}, "damping_ratio"),
        ({"damping_ratio": -0.1}, "damping_ratio"),
        ({"modal_mass": 0.0}, "modal_mass"),
        ({"modal_mass": -1.0}, "modal_mass"),
        ({"order": -1}, "order"),
    ],
)
def test_a_mode_that_is_none_is_refused_by_its_key(mode, key):
    values = {
        "order": 2,
        "frequency": 600.0,
        "damping_ratio": 0.02,
        "modal_mass": 1.0,
    } | mode
    text = ", ".join(f"{name}={value}" for name, value in values.items())
    with pytest.raises(
        SceneError, match=rf"^surface\.modes\.1\.{key} = {mode[key]}: must be [^\n]*$"
    ):
        load_scene("published").replace(
            "surface={kind='modes', modes=[{order=0, frequency=5.0, damping_ratio=0.1, "
            "modal_mass=1.0}, {" + text + "}]}"
        )
