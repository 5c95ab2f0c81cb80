"""Claim: the rigid body that both time-steppers share has the moments, energies and velocities of a
rigid body, and its columns are those from which its state was made.

Source: dynamics/stepping_core/body.py, vectors.py, ledger.py and dynamics/rattling/samples.py.
Oracle: sums over the points of a solid disk; NumPy's products of vectors; the inverse computation.
"""

from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

from dynamics.disk import Disk
from dynamics.kinematics import ContactPlace
from dynamics.motion import CAUSES, COLUMNS
from dynamics.rattling.layout import RECORD, RECORD_SIZE
from dynamics.rattling.samples import accumulate_half_weight, record_mode_losses
from dynamics.stepping_core import ledger, vectors
from dynamics.stepping_core.body import (
    angular_momentum,
    body_axes,
    body_constants,
    kinetic_and_bowl_energy,
    relative_columns,
    rolling_velocity,
)

DISK = Disk(radius=0.04, thickness=0.012, mass=0.4)
FILLET = 1.5e-3
THETA, BETA = 0.7, 0.3
OMEGA = np.array([0.4, 2.0, -13.0])


class Sampled(NamedTuple):
    """The fields of a `MotionState` that a sample reads."""

    disk: np.ndarray
    record: np.ndarray
    modes: np.ndarray
    mode_loss: np.ndarray


def constants(curvature=0.0, place=(0.0, 0.0)):
    return SimpleNamespace(**body_constants(DISK, FILLET, curvature, place))


def points_of_disk(axes):
    """Return the points (n, 3) of a grid in the disk, relative to its centre, by the midpoint rule."""
    a1, _, axis, e3 = axes
    x, y, z = np.meshgrid(*[(np.arange(80) + 0.5) / 40 - 1] * 2, [-1, 1], indexing="ij")
    inside = x**2 + y**2 < 1
    height = z[inside] * DISK.thickness / np.sqrt(12)  # same second moment as the solid
    along, across = DISK.radius * x[inside], DISK.radius * y[inside]
    return np.outer(along, a1) + np.outer(across, e3) + np.outer(height, axis)


def test_axes_are_orthonormal_and_lean_by_the_inclination():
    a1, a2, axis, e3 = body_axes(THETA, BETA)
    frame = np.array([a1, axis, e3])
    assert frame @ frame.T == pytest.approx(np.eye(3), abs=1e-15)
    assert np.linalg.det(frame) == pytest.approx(1.0)
    assert axis @ [0, 0, 1] == pytest.approx(np.cos(BETA))
    assert axis @ a2 == pytest.approx(np.sin(BETA))


def test_angular_momentum_and_energy_are_sums_over_the_points_of_the_disk():
    axes = body_axes(THETA, BETA)
    a1, _, axis, e3 = axes
    spin = OMEGA[0] * a1 + OMEGA[1] * axis + OMEGA[2] * e3
    points = points_of_disk(axes)
    mass = DISK.mass / len(points)
    velocity = np.array([0.1, -0.2, 0.05])
    moving = np.cross(spin, points)
    momentum = angular_momentum(constants(), OMEGA, axes)
    assert momentum == pytest.approx(
        mass * np.cross(points, moving).sum(axis=0), rel=2e-3
    )
    energy = kinetic_and_bowl_energy(
        constants(),
        np.zeros((3, 1)),
        velocity[:, None],
        axis[:, None],
        momentum[:, None],
    )
    assert energy[0] == pytest.approx(
        0.5 * mass * np.square(moving + velocity).sum(), rel=2e-3
    )


def test_the_energy_in_a_bowl_is_that_of_its_depth():
    """A concave table of curvature c is c r^2/2 high at the distance r from its middle."""
    curvature, centre = 0.5, np.array([[0.03], [-0.01], [0.0]])
    bowl = constants(curvature, (0.002, 0.001))
    still = np.zeros((3, 1))
    height = curvature * ((0.03 + 0.002) ** 2 + (-0.01 + 0.001) ** 2) / 2
    energy = kinetic_and_bowl_energy(bowl, centre, still, still, still)
    assert energy[0] == pytest.approx(DISK.weight * height, rel=1e-12)


def test_columns_of_a_rolling_disk_are_its_angular_velocity_without_slip():
    core_radius, core_depth = DISK.radius - FILLET, DISK.thickness / 2 - FILLET
    s, c = np.sin(BETA), np.cos(BETA)
    radius, depth = core_radius + FILLET * s, core_depth + FILLET * c
    place = ContactPlace(radius, depth, radius * s + depth * c, radius * c - depth * s)
    axes = body_axes(THETA, BETA)
    lever = depth * axes[2] + radius * axes[3]
    velocity = rolling_velocity(OMEGA, axes, lever)
    momentum = angular_momentum(constants(), OMEGA, axes)
    columns = relative_columns(
        constants(), place, velocity[:, None], axes[2][:, None], momentum[:, None]
    )
    assert np.ravel(columns) == pytest.approx([*OMEGA, 0.0, 0.0], abs=1e-13)


@pytest.mark.parametrize("seed", range(3))
def test_compiled_vectors_are_those_of_numpy(seed):
    a, b = np.random.default_rng(seed).normal(size=(2, 3))
    assert vectors.dot(a, b) == pytest.approx(a @ b)
    assert vectors.cross(a, b) == pytest.approx(np.cross(a, b))
    assert vectors.plus(a, b) == pytest.approx(a + b)
    assert vectors.times(2.5, a) == pytest.approx(2.5 * a)
    assert vectors.vector(np.array([0.0, *a]), 1) == tuple(a)


def test_a_row_has_columns_energy_losses_and_energies_of_the_modes():
    k = 2
    columns, lost = np.ones((k, len(COLUMNS))), np.full((k, len(CAUSES)), 3.0)
    rows = ledger.motion_rows(
        columns, np.full(k, 2.0), lost, np.full(k, 4.0), np.full(k, 5.0)
    )
    assert (rows[:, : len(COLUMNS)] == 1).all()
    assert (rows[:, ledger.ENERGY_COLUMN] == 2).all()
    assert (rows[:, ledger.LOSS_COLUMNS] == 3).all()
    assert (rows[:, ledger.TABLE_ENERGY_COLUMN] == 4).all()
    assert (rows[:, ledger.DISK_ENERGY_COLUMN] == 5).all()
    assert rows.shape[1] == ledger.DISK_ENERGY_COLUMN + 1


def test_two_half_samples_are_one_and_losses_of_modes_are_counted_once():
    random = np.random.default_rng(1)
    motion = Sampled(
        disk=random.normal(size=(3, 4)),
        record=random.normal(size=RECORD_SIZE),
        modes=random.normal(size=(2, 5)),
        mode_loss=random.uniform(size=5),
    )
    before, lost = motion.record[RECORD.body_loss], motion.mode_loss.sum()
    record_mode_losses(motion)
    assert motion.record[RECORD.body_loss] == pytest.approx(before + lost)
    assert not motion.mode_loss.any()
    row = np.zeros(12 + RECORD_SIZE + 10)
    for _ in range(2):
        accumulate_half_weight(motion, row)
    assert row == pytest.approx(
        np.concatenate([motion.disk.ravel(), motion.record, motion.modes.T.ravel()])
    )
