"""Claim: over a hole in the table, the film of air is that of the ring around the hole, with the
ambient pressure at both of its edges.

Source: Reynolds' equation, incompressible and quasi-steady; the hole stays under the centre of the
disk.
Oracle: the closed form of a level disk; finite volumes in polar coordinates, which share no code
with the finite elements; the logarithmic limit of a small hole.
"""

import numpy as np
import pytest
from scenes import energy_spread, smooth_toy
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import splu

from dynamics import Air, Disk, Outcome, simulate
from dynamics.film.annular_film import (
    about_low_point,
    annular_resistance,
    closed_film_polynomials,
    tabulated_ring,
)
from dynamics.film.film_kernels import film_loads
from dynamics.film.forces import (
    film_forces,
    film_moment_parts,
    moment_parts_over_hole,
)
from dynamics.film.tilted_film import tabulated_resistance
from dynamics.film.wedge import (
    ROTATION_POWER_COEFFICIENT,
    film_in_si_units,
    film_under,
)
from sonify import SceneError, load_scene

TOY = Disk(radius=0.03755, thickness=0.0128, mass=0.4387)
STIFF = Air(pressure=1e9)
"""Air that is neither compressed nor rarefied."""
FLAT_RADIUS = 0.03595
HOLES = (0.1, 0.3, 0.6, 0.83, 0.95)


def level_heave(hole):
    """Return a00 of a level disk: r h^3 p' = r^2/2 + C, with p = 0 at r = 1 and at r = `hole`.

    p = (r^2 - 1)/4 - (hole^2 - 1) ln(r)/(4 ln(hole)), and the force is -2 pi int p r dr."""
    return np.pi / 8 * (1 - hole**4 - (1 - hole**2) ** 2 / np.log(1 / hole))


@pytest.mark.parametrize("hole", HOLES)
def test_a_level_disk_has_the_closed_form_of_a_ring(hole):
    found = annular_resistance(hole, 0.0)
    assert found.heave == pytest.approx(level_heave(hole), rel=3e-3)
    assert found.coupling == pytest.approx(0, abs=1e-10)
    assert found.along == pytest.approx(found.across, rel=3e-3)


def finite_volume_matrix(hole, tilt, depth, shape):
    """Return the matrix of div(h^3 grad p) with p = 0 at both edges, in log(r) and the angle."""
    radii, angles = shape
    step, turn = -np.log(hole) / radii, 2 * np.pi / angles
    phi = turn * np.arange(angles)[None, :]

    def mobility(place, angle):
        radius = hole * np.exp(step * place[:, None])
        return (1 + tilt * radius * np.cos(angle) + depth * (1 - radius**2)) ** 3

    across = mobility(np.arange(radii + 1), phi) * turn / step
    across[[0, -1]] *= 2  # the edges are half a cell away
    along = mobility(np.arange(radii) + 0.5, phi + turn / 2) * step / turn
    number = np.arange(radii * angles).reshape(shape)
    one = np.concatenate([number[:-1].ravel(), number.ravel()])
    other = np.concatenate([number[1:].ravel(), np.roll(number, -1, axis=1).ravel()])
    flow = np.concatenate([across[1:-1].ravel(), along.ravel()])
    pairs = csr_array((flow, (one, other)), shape=(number.size,) * 2)
    pairs = pairs + pairs.T
    outflow = pairs.sum(axis=1)
    outflow[number[0]] += across[0]
    outflow[number[-1]] += across[-1]
    return (pairs - diags_array(outflow)).tocsc()


def by_finite_volumes(hole, tilt, depth, shape=(200, 120)):
    """Return `about_low_point` of the resistances from finite volumes."""
    step, turn = -np.log(hole) / shape[0], 2 * np.pi / shape[1]
    r = hole * np.exp(step * (np.arange(shape[0]) + 0.5))[:, None]
    phi = turn * np.arange(shape[1])[None, :]
    area = (r**2 * step * turn + 0 * phi).ravel()
    x, y = (r * np.cos(phi)).ravel(), (r * np.sin(phi)).ravel()
    solve = splu(finite_volume_matrix(hole, tilt, depth, shape)).solve
    heaving, tilting, rolling = (solve(area * f) for f in (1 + 0 * x, x, y))
    coupling = -(area @ (heaving * x))
    about = coupling - area @ heaving
    return (
        -(area @ heaving),
        about,
        about + coupling - area @ (tilting * x),
        -(area @ (rolling * y)),
    )


@pytest.mark.parametrize("hole", [0.3, 0.83])
@pytest.mark.parametrize(("tilt", "depth"), [(0.5, 0.0), (0.8, 0.0), (0.8, 3.0)])
def test_a_tilted_disk_has_the_resistances_of_finite_volumes(hole, tilt, depth):
    found = about_low_point(annular_resistance(hole, tilt, depth))
    assert found == pytest.approx(by_finite_volumes(hole, tilt, depth), rel=5e-3)


def test_a_small_hole_tends_to_no_hole_with_the_logarithm_of_its_size():
    """The resistance to heave lacks 1/ln(1/hole), so that a pinhole still matters."""
    for hole in (1e-2, 1e-4, 1e-6):
        missing = 1 - annular_resistance(hole, 0.0, cells=32).heave / (np.pi / 8)
        assert missing * np.log(1 / hole) == pytest.approx(1, rel=0.01)
    turning = closed_film_polynomials(1e-3)[0].sum()  # zero pressure in the middle
    assert turning == pytest.approx(ROTATION_POWER_COEFFICIENT, rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("hole", HOLES)
def test_the_law_of_the_rolling_film_is_the_closed_ring(hole):
    """On a plane and over bowls, for drag, resistance to a fall, and lever of the lift."""
    s = 0.01
    for depth in (0.0, 0.3, 2.0, 9.0):
        film = film_under(TOY, STIFF, 2 * depth * s / TOY.radius, hole)
        whole = film_under(TOY, STIFF)
        parts = moment_parts_over_hole(film_moment_parts(s, 1e-6, film), s, film)
        flat = film_moment_parts(s, 1e-6, whole)
        _, about, fall, across = about_low_point(annular_resistance(hole, 1.0, depth))
        _, _, flat_fall, flat_across = about_low_point(tabulated_resistance(1.0))
        assert parts[0] / flat[0] == pytest.approx(across / flat_across, rel=0.03)
        assert parts[1] / flat[1] == pytest.approx(fall / flat_fall, rel=0.05)
        assert parts[2] == pytest.approx(about / fall, rel=0.05)


@pytest.mark.slow
def test_the_table_of_the_landing_is_the_ring_between_its_nodes():
    generator = np.random.default_rng(5)
    for hole in (0.3, 0.83):
        for opening, share in generator.uniform([0.1, 0.0], [1.0, 0.9], (6, 2)):
            tilt, depth = 1 - opening**2, share / (1 - share)
            solved = about_low_point(annular_resistance(hole, tilt, depth))
            found = tabulated_ring(hole, tilt, depth)
            assert found == pytest.approx(solved, rel=5e-3)


def test_the_compiled_film_is_that_of_the_formulas():
    film = film_in_si_units(film_under(TOY, Air(), 0.1, 0.83), TOY)
    sine, rate, nutation = 3e-3, 300.0, 0.2
    drag, fall, lever, tip, lift = film_loads(film, sine, rate)
    found = drag, fall * nutation + tip, lever * fall * nutation + lift
    assert found == pytest.approx(film_forces(sine, nutation, rate, film), rel=1e-12)


@pytest.mark.slow
def test_the_disk_turns_faster_over_a_hole_before_the_film_carries_it():
    """The film over the hole takes less power and lifts less, so the disk lasts longer and falls
    further; the energy is balanced."""
    scene = smooth_toy("release.inclination_deg=2", "release.omega=[0.0,0.7,4.9]")
    whole, open_ = (
        simulate(scene.replace(f"surface={{hole={hole}}}")).rolling
        for hole in (0.0, 0.06)
    )
    for motion in (whole, open_):
        assert motion.rolling_outcome is Outcome.AIRBORNE
        assert energy_spread(motion) < 1e-9
    assert open_.t[-1] > whole.t[-1]
    assert open_.state[-1, 1] < 0.8 * whole.state[-1, 1]


@pytest.mark.parametrize(
    ("name", "changes", "message"),
    [
        ("toy", ["surface.hole=0.0719"], "surface.hole = 0.0719: must not reach"),
        ("toy", ["surface.hole=-0.01"], "surface.hole = -0.01: must be greater than"),
        ("coin", ["surface.hole=0.01"], "hole"),
    ],
)
def test_an_impossible_hole_is_one_line(name, changes, message):
    with pytest.raises(SceneError) as caught:
        load_scene(name).replace(*changes)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)
