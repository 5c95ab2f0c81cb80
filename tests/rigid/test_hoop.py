"""Claim: a hoop moves, vibrates and sounds according to the mechanics of a hollow cylinder, from a
thick wall to a thin ring.

Source: Love, Treatise on the Mathematical Theory of Elasticity, sections 292, 293: in-plane and
out-of-plane modes of thin rings; Timoshenko & Goodier, section 109: torsion of bars; Leissa,
Vibration of Plates, chapter 2: annular plates. Oracle: the limits of these closed forms and the
order of convergence to them; the solid disk as the hole closes; Bessel functions; finite elements
on the same ring; moments of inertia of a hollow cylinder.
"""

from math import pi

import numpy as np
import pytest
from arithmetic import gamma
from scenes import roll, scene
from scipy.linalg import eigh, svdvals
from scipy.optimize import minimize_scalar
from scipy.special import iv, ivp, jv, jvp, kv, kvp, yv, yvp
from skfem import ElementHex2

from dynamics import plan_motion
from dynamics.disk import Disk
from modal import Material, Plate, eigenmodes, plate_modes
from modal.elements.elastic import assemble_solid, lowest_eigenpairs
from modal.mesh.half_disk import MeshSize, cells_of_blocks, rim_blocks
from modal.mesh.sector import extrude, hexahedra
from modal.spectral.basis import rigid_mode, rigid_mode_count, ritz_problem
from modal.spectral.p_refinement import solve_problem
from modal.spectral.ritz import graded_gauss, stiffness_and_mass
from sonify import SceneError, load_scene, run
from sonify.plan.plan import plan_of
from sonify.scene import from_document
from sonify.sound.modal_forcing import rigid_acceleration

STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)
DENSITY = 7737.27
WALLS = np.array([0.08, 0.04, 0.02])


def hollow(hole, thickness, radius=1.0):
    """Return a free hollow cylinder of steel; `hole` and `thickness` are relative to the radius."""
    return Plate(
        radius=radius,
        inner_radius=hole * radius,
        thickness=thickness * radius,
        material=STEEL,
        density=DENSITY,
    )


def thin_ring(wall):
    """Return a ring of mean radius 1 m and square section."""
    outer = 1 + wall / 2
    return Plate(
        radius=outer,
        inner_radius=1 - wall / 2,
        thickness=wall,
        material=STEEL,
        density=DENSITY,
    )


def lowest_of(plate, n, even, below, size=(6, 4)):
    return np.sqrt(
        solve_problem(plate, ritz_problem(plate, n, even), size, below).values[0]
    ) / (2 * pi)


def in_plane(n, wall):
    return (
        n
        * (n * n - 1)
        / np.sqrt(n * n + 1)
        * wall
        / np.sqrt(12)
        * np.sqrt(195e9 / DENSITY)
        / (2 * pi)
    )


def out_of_plane(n, wall):
    """Return the frequency [Hz] of bending and torsion of a ring of square section.

    The torsion constant is 0.1406 wall^4 by Saint-Venant's series.
    """
    odd = np.arange(1, 40, 2)
    torsion = (1 - 192 / pi**5 * np.sum(np.tanh(odd * pi / 2) / odd**5)) / 3
    ratio = (1 / 12) / (torsion / (2 * (1 + 0.28)))
    return (
        n
        * (n * n - 1)
        / np.sqrt(n * n + ratio)
        * wall
        / np.sqrt(12)
        * np.sqrt(195e9 / DENSITY)
        / (2 * pi)
    )


@pytest.mark.parametrize("n", [2, 3, 5])
@pytest.mark.parametrize(("formula", "even"), [(in_plane, 1), (out_of_plane, -1)])
def test_a_thin_ring_tends_to_loves_bending_modes_with_the_square_of_its_wall(
    n, formula, even
):
    error = [
        lowest_of(thin_ring(w), n, even, 1.2 * formula(n, w)) / formula(n, w) - 1
        for w in WALLS
    ]
    order = np.polyfit(np.log(WALLS), np.log(np.abs(error)), 1)[0]
    assert order == pytest.approx(2, abs=0.1)
    assert abs(error[-1]) < n * n * WALLS[-1] ** 2


def test_a_thin_ring_breathes_at_the_speed_of_bars_over_its_radius():
    breathing = np.sqrt(195e9 / DENSITY) / (2 * pi)
    error = [
        lowest_of(thin_ring(w), 0, 1, 1.2 * breathing) / breathing - 1 for w in WALLS
    ]
    assert np.polyfit(np.log(WALLS), np.log(np.abs(error)), 1)[0] == pytest.approx(
        2, abs=0.1
    )
    assert abs(error[-1]) < WALLS[-1] ** 2


@pytest.mark.parametrize(("n", "even"), [(0, -1), (2, -1), (2, 1)])
def test_a_closing_hole_leaves_the_solid_disk(n, even):
    solid = lowest_of(hollow(0.0, 0.34), n, even, 6000, (12, 6))
    holes = np.array([0.04, 0.02])
    error = [
        lowest_of(hollow(hole, 0.34), n, even, 6000, (24, 6)) / solid - 1
        for hole in holes
    ]
    assert np.log2(error[0] / error[1]) == pytest.approx(2, abs=0.1)
    assert abs(error[1]) < 0.003


@pytest.mark.parametrize("hole", [1e-8, 2.7e-6, 1e-3, 0.05, 0.1, 0.5, 0.9, 0.99])
@pytest.mark.parametrize("count", [4, 27])
def test_polynomials_over_the_radius_are_integrated_to_round_off_with_few_points(
    hole, count
):
    rho, weight = graded_gauss(hole, count)
    assert len(rho) < 500
    power = np.arange(1, 2 * count)
    assert weight @ (1 / rho) == pytest.approx(-np.log(hole), rel=gamma(len(rho) + 60))
    exact = (1 - hole**power) / power
    # All terms are positive. Gauss nodes have an error of one unit u of the interval. Their
    # weights, pi sin(theta)/n, have an error of pi u cot(theta)/n, which sums to u log(n).
    bar = gamma(len(rho) + 60 + 8 * power) * exact + gamma(40)
    assert (np.abs(weight @ rho[:, None] ** (power - 1) - exact) <= bar).all()


def test_a_pinhole_leaves_the_solid_disk():
    """The pinhole changes frequencies by its area, 1e-11; the tolerance covers the two bases."""
    solid, pierced = (
        plate_modes(hollow(hole, 0.34, 0.03755), 40e3) for hole in (0.0, 2.7e-6)
    )
    assert pierced.order.tolist() == solid.order.tolist()
    assert pierced.frequency == pytest.approx(solid.frequency, rel=3e-6)


def annular_plate(x, n, hole, poisson):
    """Return the least singular value of the edge conditions; it is zero at an eigenfrequency.

    The conditions are zero moment and zero Kirchhoff shear force of J, Y, I, K at both rims.
    """
    rows = []
    for rho in (1.0, hole):
        k = x * rho
        for kind in ("moment", "shear"):
            row = []
            for sign, f, slope in (
                (-1, jv, jvp),
                (-1, yv, yvp),
                (1, iv, ivp),
                (1, kv, kvp),
            ):
                value = f(n, k)
                first = k * slope(n, k)
                bent = sign * k**2 * value - (1 - poisson) * (first - n**2 * value)
                cut = sign * k**2 * first - (1 - poisson) * n**2 * (first - value)
                row.append(bent if kind == "moment" else cut)
            rows.append(row)
    matrix = np.array(rows)
    return svdvals(matrix / np.linalg.norm(matrix, axis=0))[-1]


@pytest.mark.parametrize(("n", "hole"), [(0, 0.5), (2, 0.5), (3, 0.3)])
def test_a_thin_annular_plate_has_the_roots_of_bessel_functions(n, hole):
    """At free edges convergence is of first order: Saint-Venant's torsion lacks 0.63 thickness."""
    thickness = 2e-3
    plate = hollow(hole, thickness)
    stiffness = 195e9 * thickness**2 / (12 * (1 - 0.28**2) * DENSITY)
    pairs = solve_problem(plate, ritz_problem(plate, n, -1), (18, 2), 60.0)
    roots = np.sqrt(np.sqrt(pairs.values / stiffness))
    assert len(roots) >= 2
    for root in roots[:2]:
        span = (0.98 * root, 1.02 * root)
        exact = minimize_scalar(
            lambda x: annular_plate(x, n, hole, 0.28),
            bounds=span,
            options={"xatol": 1e-10},
        )
        assert exact.fun < 1e-7
        assert root == pytest.approx(exact.x, rel=0.2 * thickness)


def test_six_rigid_motions_and_no_more_cost_nothing():
    plate = hollow(0.9, 0.34)
    count = 0
    for n in range(4):
        for even, torsional in ((1, False), (-1, False), (1, True), (-1, True))[
            : 2 if n else 4
        ]:
            p = ritz_problem(plate, n, even, torsional)
            k, m = stiffness_and_mass(plate, p, (6, 4))
            values = eigh(k, m, eigvals_only=True)
            mode = rigid_mode(plate, p, (6, 4))
            here = np.count_nonzero(values < 1.0)
            assert here == rigid_mode_count(plate, p)
            size = np.sqrt(np.diag(k))[
                :, None
            ]  # bound on the terms by Schwarz' inequality
            assert (
                np.abs(k @ mode) <= gamma(100 + len(k)) * size * (size.T @ np.abs(mode))
            ).all()
            count += here * (2 if n else 1)
            if n == 0 and here and not torsional:
                assert mode[:, 0] @ m @ mode[:, 0] == pytest.approx(
                    plate.mass, rel=gamma(3 * len(m))
                )
    assert count == 6


def test_finite_elements_on_the_same_ring_agree_from_above():
    """The error of quadratic elements falls with the fourth power of their size."""
    plate = hollow(0.9, 0.34, 0.03755)
    exact = plate_modes(plate, 11e3).frequency
    error = []
    for split in (1, 2):
        size = MeshSize(width=np.pi / 12, depth=1 - plate.hole, rings=0, split=split)
        half = (
            cells_of_blocks(rim_blocks(np.linspace(0, np.pi, 13), size.depth), size)
            * plate.radius
        )
        cells = np.concatenate([half, half[:, ::-1] * [1, -1]])
        mesh = hexahedra(
            extrude(cells, np.linspace(-0.5, 0.5, 2 * split + 1) * plate.thickness)
        )
        solid = assemble_solid(mesh, ElementHex2(), STEEL, DENSITY, 4)
        values, *_ = lowest_eigenpairs(
            solid.stiffness,
            solid.mass,
            np.inf,
            shift=-((2 * pi * 1000) ** 2),
            exact_count=6 + len(exact),
        )
        error.append(np.sqrt(values[6:]) / (2 * pi) / exact - 1)
    assert error[1].min() > -2e-6
    assert error[1].max() < 0.003
    assert error[0].max() / error[1].max() == pytest.approx(16, rel=0.2)


@pytest.fixture(scope="module")
def hoop():
    return load_scene("hoop")


def test_the_shipped_hoop_has_all_its_modes_to_1e_6_in_exact_pairs_and_its_mass(hoop):
    modes = eigenmodes(hoop, below=40e3)
    exact = eigenmodes(hoop.replace("numerics.accuracy=reference"), below=40e3)
    assert modes.order.tolist() == exact.order.tolist()
    assert modes.frequency == pytest.approx(exact.frequency, rel=1e-6)
    assert modes.mass == pytest.approx(hoop.disk.mass, rel=gamma(20))
    assert np.abs(modes.participation).max() < 1e-9
    for i, j in enumerate(modes.partner):
        assert (j >= 0) == (modes.order[i] > 0)
        assert j < 0 or modes.frequency[i] == modes.frequency[j]
    r = np.hypot(*modes.body.points.T[:2])
    assert (r.min(), r.max()) == pytest.approx(
        (hoop.disk.inner_radius, hoop.disk.radius)
    )
    area = modes.face_weight.sum() * 2 * pi
    assert area == pytest.approx(pi * (hoop.disk.radius**2 - hoop.disk.inner_radius**2))


def test_moments_of_inertia_are_those_of_a_hollow_cylinder():
    disk = Disk(shape="shell", radius=0.04, wall=0.01, thickness=0.02, density=8000.0)
    mass = 8000 * pi * (0.04**2 - 0.03**2) * 0.02
    diameter = mass * (3 * (0.04**2 + 0.03**2) + 0.02**2) / 12
    axis = mass * (0.04**2 + 0.03**2) / 2
    assert disk.mass == pytest.approx(mass)
    turn = rigid_acceleration(np.eye(3), disk)[:, 3:] * [diameter, diameter, axis]
    assert turn == pytest.approx(np.cross([0.04, 0.0, -0.01], np.eye(3)))


def test_a_thinning_wall_leaves_the_motion_of_the_shell():
    span = {"time_limit": 0.5}
    shell = {"shape": "shell", "radius": 0.03755, "thickness": 0.0128, "mass": 0.1}
    release = {"omega": (0.0, 0.0, -13.0)}
    limit = roll(scene(span, disk=shell, release=release)).at(0.4)
    gaps = []
    for wall in (1e-5, 1e-6):
        gaps.append(
            np.abs(
                roll(scene(span, disk=shell | {"wall": wall}, release=release)).at(0.4)
                - limit
            ).max()
        )
    assert gaps[0] / gaps[1] == pytest.approx(10, rel=0.05)


def test_the_plan_of_a_hoop_says_what_of_its_sound_is_left_out(hoop):
    left_out = plan_of(hoop, plan_motion(hoop)).left_out
    assert any("cylindrical wall" in sentence for sentence in left_out)


FAULTS = [
    ("disk.wall=0.04", "disk: wall = 0.04: must be less than radius = 0.03755"),
    ("disk.wall=0", "disk.wall = 0: must be greater than or equal to 1e-09"),
    ("disk.shape=solid", "disk: wall = 0.003: only allowed if shape = 'shell'"),
]


@pytest.mark.parametrize(("assignment", "message"), FAULTS)
def test_a_wall_that_cannot_be_is_one_line(hoop, assignment, message):
    with pytest.raises(SceneError) as caught:
        hoop.replace(assignment)
    assert str(caught.value) == message


def test_a_hoop_on_a_patch_or_without_a_wall_is_refused_before_any_work(hoop, tmp_path):
    bare = hoop.document
    bare["disk"] = {
        "shape": "shell",
        "radius": 0.03755,
        "thickness": 0.0128,
        "mass": 0.07,
    }
    wrong = {
        "support.kind = 'patch'": hoop.replace("support.kind=patch"),
        "disk.wall": from_document(bare),
    }
    for message, refused in wrong.items():
        with pytest.raises(SceneError, match=message):
            run(refused, tmp_path / "out")
        assert not (tmp_path / "out").exists()
