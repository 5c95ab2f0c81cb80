"""Describe the disk as a general rigid body with position, rotation and velocities in a
fixed frame, for physics engines.

The units are those of the paper, m = R = 1 and gravity (K + 4)/4, which suit the
default settings of the engines. At the start a_1, a_2, a_3 are the axes x, y, z of the
table. The frame of the disk is e_1, -e_3, e_2; its third axis is the axis of the
disk."""

import math
from typing import NamedTuple

import numpy as np

from benchmarks.cases.motion_case import Case
from benchmarks.timed_runs import Answer, Failure
from dynamics.equations import DiskConstants
from dynamics.kinematics import centre_velocity, contact_place

MAX_CENTRE_HEIGHT = 1.2
"""Height of the centre, divided by R, that a disk with its rim on the table cannot
reach."""


class Pose(NamedTuple):
    """Centre (3,), rotation (3, 3) from the frame of the disk, velocity (3,) of the
    centre, angular velocity (3,)."""

    centre: np.ndarray
    rotation: np.ndarray
    velocity: np.ndarray
    angular: np.ndarray


def gravity(law: DiskConstants) -> float:
    """Return the dimensionless gravity."""
    return (law.K + 4) / 4


def inertia(law: DiskConstants) -> tuple[float, float, float]:
    """Return the principal moments of inertia in the frame of the disk."""
    return law.K / 4 + law.h**2 / 3, law.K / 4 + law.h**2 / 3, law.K / 2


def at_start(case: Case) -> Pose:
    """Return the pose at the start of a case, with the contact point at rest (2.5)."""
    beta, w1, w2, w3 = case.start[:4]
    h = case.law.h
    sin_a = math.cos(beta)
    cos_a = math.sin(beta)
    place = contact_place(sin_a, cos_a, h)
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, sin_a, cos_a], [0.0, -cos_a, sin_a]])
    return Pose(
        centre=np.array([0.0, 0.0, place.e]),
        rotation=rotation,
        velocity=np.array(
            [*centre_velocity((0.0, 0.0), (w1, w2, w3), place), place.f * w1]
        ),
        angular=rotation @ [w1, -w3, w2],
    )


def quaternion(case: Case) -> tuple[float, float, float, float]:
    """Return the quaternion (w, x, y, z) of the initial rotation, about x by minus the
    inclination."""
    return math.cos(case.start[0] / 2), -math.sin(case.start[0] / 2), 0.0, 0.0


def answer(pose: Pose, law: DiskConstants, steps: int) -> Answer:
    """Return inclination and energy (6.1) of a pose. Raises Failure if the disk has
    left the table."""
    height = float(pose.centre[2])
    if not -law.h < height < MAX_CENTRE_HEIGHT:  # also rejects NaN
        raise Failure(
            "falls through the table" if height <= -law.h else "is thrown off the table"
        )
    axle = pose.rotation[:, 2]
    own = pose.rotation.T @ pose.angular
    turning = sum(i * w * w for i, w in zip(inertia(law), own, strict=True))
    energy = (pose.velocity @ pose.velocity + turning) / 2 + gravity(law) * (
        height - law.h
    )
    return Answer(
        (math.atan2(math.hypot(axle[0], axle[1]), axle[2]), float(energy)), steps
    )


def resistance(axle, angular, normal: float, law: DiskConstants) -> np.ndarray:
    """Return the moment (3,) of (3.3) with sign() of the angular velocities, for
    engines without such a law.

    `axle` and `angular` are the axis of the disk and its angular velocity, (3,).
    """
    across = math.hypot(axle[0], axle[1])
    a2 = np.array([axle[0] / across, axle[1] / across, 0.0])
    a1 = np.array([a2[1], -a2[0], 0.0])
    rolling = (
        law.k1 * math.copysign(1, angular @ a1) * a1
        + law.k2 * math.copysign(1, angular @ a2) * a2
    )
    return -normal * (
        rolling + np.array([0.0, 0.0, law.k3 * math.copysign(1, angular[2])])
    )
