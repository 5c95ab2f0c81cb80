"""Claim: the compiled parts of a time step keep the identities of a rotation, of the angular
momentum, of a bounded resistance and of the contact energy.

Source: Cayley's and Rodrigues' formulas; L = J omega for an axisymmetric body; the energy
2/5 K (-G)^2.5 of a Hertz contact. Oracle: the defining equations, and SciPy's rotations.
"""

from typing import NamedTuple

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynamics.compliant.stepping.contact_energy import (
    mean_force,
    square_root_of_approach,
)
from dynamics.integrators.slow_slide_criterion import is_slow_slide
from dynamics.stepping_core.layout import Pair, Vector, first_indices
from dynamics.stepping_core.resistance import resistance_to, resisted_directions
from dynamics.stepping_core.rotation import angular_velocity, rotate, rotation_change

AXIS = np.array([0.48, -0.6, 0.64])  # of unit length


def test_cayleys_formula_solves_the_midpoint_rule():
    b = np.array([0.3, -1.2, 0.7])
    change = np.array(rotation_change(AXIS, b))
    turned = AXIS + change
    assert change == pytest.approx(np.cross(b, AXIS + turned), abs=1e-15)
    assert np.linalg.norm(turned) == pytest.approx(1, abs=1e-15)


def test_a_vector_turns_about_an_axis_as_in_scipy():
    vector = np.array([1.0, 2.0, -3.0])
    expected = Rotation.from_rotvec(0.7 * AXIS).apply(vector)
    rotate(vector, AXIS, 0.7)
    assert vector == pytest.approx(expected, rel=1e-14)


class Inertia(NamedTuple):
    diametral_inertia: float
    inverse_inertia_excess: float


def test_the_angular_velocity_belongs_to_the_angular_momentum():
    about_diameter, about_axis = 2.0, 3.5
    constants = Inertia(about_diameter, 1 / about_axis - 1 / about_diameter)
    momentum = np.array([0.2, 1.5, -0.4])
    omega = np.array(angular_velocity(constants, AXIS, momentum))
    along = (omega @ AXIS) * AXIS
    found = about_axis * along + about_diameter * (omega - along)
    assert found == pytest.approx(momentum, rel=1e-14)


@pytest.mark.parametrize(("rate", "moment"), [(2.0, 0.5), (-2.0, -0.5), (0.0, 0.0)])
def test_a_resistance_has_the_sign_of_its_rate(rate, moment):
    assert resistance_to(rate, 0.5, 1.0) == moment
    assert resistance_to(rate, 3.0, 0.5) == moment  # it stops the rotation at most


def test_the_resisted_rotations_are_perpendicular():
    directions = np.array(resisted_directions(0.6, 0.8))
    assert directions @ directions.T == pytest.approx(np.eye(3), abs=1e-15)


@pytest.mark.parametrize(
    "gaps", [(-1e-6, -3e-6), (-2e-6, 1e-6), (1e-6, -2e-6), (1e-6, 2e-6)]
)
def test_the_mean_force_does_the_work_that_the_contact_stores(gaps):
    def energy(gap):
        return 0.4 * max(-gap, 0.0) ** 2.5

    roots = [square_root_of_approach(gap) for gap in gaps]
    work = -mean_force(*roots, *gaps) * (gaps[1] - gaps[0])
    assert work == pytest.approx(energy(gaps[1]) - energy(gaps[0]), rel=1e-12, abs=0.0)


def test_the_mean_force_of_a_short_step_is_the_force():
    gap = -1e-6
    root = square_root_of_approach(gap)
    assert mean_force(root, root, gap, gap) == pytest.approx(1e-9, rel=1e-12, abs=0.0)


class Layout(NamedTuple):
    alone: int
    pair: Pair
    vector: Vector


def test_a_layout_counts_the_entries_before_each_quantity():
    assert first_indices(Layout) == (Layout(alone=0, pair=1, vector=3), 6)


def test_a_slide_is_slow_if_its_direction_follows_its_acceleration():
    """Friction turns a slow slide faster than the slide changes."""
    assert is_slow_slide(1e-9, 0.0, 0.3)
    assert not is_slow_slide(10.0, 0.0, 0.3)
