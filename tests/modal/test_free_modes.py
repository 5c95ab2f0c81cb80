"""Claim: the modes of a free axisymmetric solid are accurate to 1e-6 and come in exact pairs; none
is missing or spurious.

Source: Ritz's method with a basis that is smooth on the axis. Oracle: three frequencies known to
1e-8; Bessel roots of torsion and of thin plates; finite elements on the same disk.
"""

from math import pi

import numpy as np
import pytest
from plate_theory import thin_plate_frequencies, torsion_frequencies

from modal import Material, Support, eigenmodes
from modal.elements import patch as held
from modal.elements.elastic import estimated_mode_count
from modal.spectral.axisymmetric import plate_modes
from modal.spectral.basis import Plate, ritz_problem
from modal.spectral.p_refinement import solve_problem
from sonify import load_scene

RADIUS, THICKNESS, DENSITY = 0.03755, 0.0128, 7737.27
STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)
DISK = Plate(radius=RADIUS, thickness=THICKNESS, material=STEEL, density=DENSITY)
KNOWN = [(2, 10602.6917), (0, 16997.7117), (3, 22210.5353)]


FREE = load_scene("published").replace("support.kind=free")


@pytest.fixture(scope="module")
def modes():
    return eigenmodes(FREE, below=40e3)


@pytest.mark.parametrize(("order", "frequency"), KNOWN)
def test_known_frequencies(modes, order, frequency):
    (first, *_) = np.flatnonzero(
        (modes.order == order) & (np.array(modes.family) == "flexural")
    )
    assert modes.frequency[first] == pytest.approx(frequency, rel=1e-6)
    assert modes.error[first] < 1e-5


def test_a_held_disk_has_its_free_modes_for_the_asking(modes):
    held = load_scene("published")
    assert (
        eigenmodes(held, 40e3, FREE.support).frequency.tolist()
        == modes.frequency.tolist()
    )


def test_below_40_khz_every_mode_is_within_1e_6_of_a_larger_basis(modes):
    exact = eigenmodes(FREE.replace("numerics.accuracy=reference"), below=40e3)
    assert modes.order.tolist() == exact.order.tolist()
    assert modes.frequency == pytest.approx(exact.frequency, rel=1e-6)


def test_pairs_are_exact_and_partners_are_a_quarter_wave_apart(modes):
    for i, j in enumerate(modes.partner):
        if j >= 0:
            assert modes.partner[j] == i
            assert modes.frequency[i] == modes.frequency[j]
    even, odd = (modes.parity[0] == p for p in ("even", "odd"))
    assert even
    assert not odd
    n = modes.order[0]
    assert modes.at_rim(modes.rim_angle - pi / (2 * n))[0] == pytest.approx(
        modes.rim_shape[1], abs=1e-9
    )


def test_a_choice_of_modes_is_those_modes_in_that_order_and_keeps_what_is_left_of_a_pair(
    modes,
):
    chosen = modes.select([3, 1, 0])
    assert chosen.partner.tolist() == [-1, 2, 1]
    assert modes.partner[[3, 1, 0]].tolist() == [4, 0, 1]
    for name in ("frequency", "face_shape", "rim_shape", "participation", "error"):
        assert (getattr(chosen, name) == getattr(modes, name)[[3, 1, 0]]).all()
    assert chosen.family == tuple(modes.family[i] for i in (3, 1, 0))
    assert (chosen.body.displacement == modes.body.displacement[[3, 1, 0]]).all()
    assert (modes.select(modes.frequency < 20e3).frequency == modes.frequency[:3]).all()
    assert len(modes.select([])) == 0


def test_a_face_meets_the_rim_and_the_nodes_of_the_body(modes):
    """Oracle: independent values of the same amplitudes, on the rim and at the nodes of the body.

    Chebyshev's coefficients of cos(x s) at degree 16 are 2 J_16(x) < 5e-9 up to x = 4. Below 40 kHz
    the phase of bending changes by at most 4 rad on either side of the middle of the radius.
    """
    assert modes.at_face(RADIUS, modes.rim_angle)[:, 0] == pytest.approx(
        modes.rim_shape[..., 2], abs=1e-6
    )
    x, y, z = modes.body.points.T
    for face, height in enumerate((-THICKNESS / 2, THICKNESS / 2)):
        there = np.abs(z - height) < 1e-12
        shape = modes.at_face(np.hypot(x, y)[there], np.arctan2(y, x)[there])[:, face]
        assert shape == pytest.approx(modes.body.displacement[:, there, 2], abs=1e-6)


def test_free_modes_do_not_move_the_centre_of_mass_nor_turn_the_disk(modes):
    assert np.abs(modes.participation).max() < 1e-9


def test_first_torsion_is_the_root_of_j2():
    pairs = solve_problem(DISK, ritz_problem(DISK, 0, 1, torsional=True), (9, 5), 70e3)
    exact = torsion_frequencies(1, RADIUS, STEEL.young, STEEL.poisson, DENSITY)
    assert np.sqrt(pairs.values) / (2 * pi) == pytest.approx(exact, rel=1e-10)
    assert exact == pytest.approx(68297.79982, rel=1e-9)


def test_disks_down_to_a_thousandth_as_thick_tend_to_kirchhoffs_with_the_square_of_the_thickness():
    """Bending eigenvalues are 1e-12 of the shear ones; careless arithmetic would lose them."""
    error = []
    for thickness in (1e-2, 1e-3):
        thin = Plate(radius=1.0, thickness=thickness, material=STEEL, density=DENSITY)
        pairs = solve_problem(
            thin, ritz_problem(thin, 2, -1), (10, 3), 8000 * thickness
        )
        exact = thin_plate_frequencies(2, 1, 1.0, thickness, 195e9, 0.28, DENSITY)
        error.append(1 - np.sqrt(pairs.values[0]) / (2 * pi) / exact[0])
        assert pairs.residual.max() < 1e-8
    assert 0 < error[1] < 1e-5
    assert np.log10(error[0] / error[1]) == pytest.approx(2, abs=0.15)


def test_finite_elements_agree_from_above():
    below = 23e3
    spectral = eigenmodes(FREE, below=below)
    elements = held.held_modes(DISK, Support(kind="free"), below, "reference")
    ratio = elements.frequency / spectral.frequency
    assert ratio.min() > 1 - 1e-6
    assert ratio.max() < 1.002
    assert (elements.order == spectral.order).all()


def test_modal_mass_is_one_on_the_face_grid_of_a_thin_plate():
    """The mean square deflection of the faces gives the whole modal mass of a thin plate."""
    thin = Plate(radius=0.1, thickness=1e-3, material=STEEL, density=DENSITY)
    modes = plate_modes(thin, 1500.0, "draft")
    mean_square = (modes.face_shape**2).mean(axis=(1, 3))
    mass = DENSITY * thin.thickness * 2 * pi * mean_square @ modes.face_weight
    assert mass == pytest.approx(np.ones(len(modes)), rel=2e-3)


def test_a_disk_too_small_to_be_heard_has_no_modes_and_that_is_no_error():
    small = Plate(
        radius=RADIUS / 10, thickness=THICKNESS / 10, material=STEEL, density=DENSITY
    )
    assert len(plate_modes(small, 24e3)) == 0
    held_disk = eigenmodes(
        load_scene("published").replace(
            f"disk.radius={RADIUS / 40}",
            f"disk.thickness={THICKNESS / 40}",
            f"disk.mass={FREE.disk.mass / 64000}",
        )
    )
    assert held_disk.rim_shape.shape == (0, 128, 3)


@pytest.mark.parametrize(("thickness", "below"), [(THICKNESS, 150e3), (0.001, 50e3)])
def test_the_count_of_modes_is_foreseen_from_below_within_a_factor_of_two(
    thickness, below
):
    """Oracle: the number of modes of a thick body with short waves, and of a plate."""
    disk = Plate(radius=RADIUS, thickness=thickness, material=STEEL, density=DENSITY)
    count = len(plate_modes(disk, below, "draft"))
    assert count / 2 < estimated_mode_count(disk, below) < count
