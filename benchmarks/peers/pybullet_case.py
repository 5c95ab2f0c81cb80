"""Solve the benchmark problems with PyBullet: a sharp-edged cylinder on a plane, and
the rocking plate.

Damping and collision margin are 0. The rolling and spinning friction of Bullet are the
moments (3.3), but with one rolling arm in place of k1 and k2. Bullet has a single
coefficient of friction, here the static one. The springs of the plate are torques,
which depend on its angles at the start of each step."""

import math
from contextlib import contextmanager

import numpy as np
import pybullet

from benchmarks.cases import table_case as plate
from benchmarks.cases.motion_case import Case
from benchmarks.peers.rigid_body import (
    Pose,
    answer,
    at_start,
    gravity,
    inertia,
    quaternion,
)
from benchmarks.timed_runs import Answer

MAX_JOINT_VELOCITY = 1e9
"""Velocity limit of PyBullet, far above all velocities of the disk."""

ARM_MASS = 1e6
"""Mass of the arm [kg]."""


@contextmanager
def world(fall: float, step: float):
    """Open an empty world with steps of `step`, and yield the keyword arguments that
    select it."""
    here = {"physicsClientId": pybullet.connect(pybullet.DIRECT)}
    try:
        pybullet.setGravity(0, 0, -fall, **here)
        exact = {"solverResidualThreshold": 0, "restitutionVelocityThreshold": 0}
        pybullet.setPhysicsEngineParameter(fixedTimeStep=step, **exact, **here)
        yield here
    finally:
        pybullet.disconnect(**here)


def disk(case: Case, step: float) -> Answer:
    """Solve a case by dimensionless steps of length `step`."""
    count = round(case.span / step)
    with world(gravity(case.law), step) as here:
        body = _disk(case, here)
        for _ in range(count):
            pybullet.stepSimulation(**here)
        centre, turned = pybullet.getBasePositionAndOrientation(body, **here)
        velocity, angular = pybullet.getBaseVelocity(body, **here)
    rotation = np.reshape(pybullet.getMatrixFromQuaternion(turned), (3, 3))
    return answer(
        Pose(*map(np.array, (centre, rotation, velocity, angular))), case.law, count
    )


def table(rate: float) -> Answer:
    """Solve the rocking plate with `rate` steps per second."""
    count = round(plate.DURATION * rate)
    with world(plate.GRAVITY, 1 / rate) as here:
        body = _plate(here)
        for _ in range(count):
            for joint in (0, 1):
                angle, speed = pybullet.getJointState(body, joint, **here)[:2]
                torque = -plate.SPRING * angle - plate.DAMPER * speed
                pybullet.setJointMotorControl2(
                    body, joint, pybullet.TORQUE_CONTROL, force=torque, **here
                )
            pybullet.stepSimulation(**here)
        angles = [pybullet.getJointState(body, joint, **here)[0] for joint in (0, 1)]
    return plate.answer_from_angles(angles, count)


def _disk(case, here):
    """Return the disk at the start of the case, on a plane."""
    law = case.law
    start = at_start(case)
    w, *axis = quaternion(case)
    plane = pybullet.createMultiBody(
        0, pybullet.createCollisionShape(pybullet.GEOM_PLANE, **here), **here
    )
    pybullet.changeDynamics(
        plane,
        -1,
        lateralFriction=1,
        rollingFriction=0,
        spinningFriction=0,
        restitution=0,
        **here,
    )
    shape = pybullet.createCollisionShape(
        pybullet.GEOM_CYLINDER, radius=1, height=2 * law.h, **here
    )
    body = pybullet.createMultiBody(
        1, shape, -1, start.centre.tolist(), [*axis, w], **here
    )
    pybullet.changeDynamics(
        body,
        -1,
        localInertiaDiagonal=inertia(law),
        lateralFriction=law.mu_static,
        rollingFriction=law.k2,
        spinningFriction=law.k3,
        restitution=0,
        linearDamping=0,
        angularDamping=0,
        collisionMargin=0,
        maxJointVelocity=MAX_JOINT_VELOCITY,
        activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
        **here,
    )
    pybullet.resetBaseVelocity(
        body, start.velocity.tolist(), start.angular.tolist(), **here
    )
    return body


def _plate(here):
    """Return the plate at the start, under the ball on its arm."""
    angles, rates, height = plate.initial_state()
    turns = pybullet.JOINT_REVOLUTE
    slides = pybullet.JOINT_PRISMATIC
    half_size = [
        plate.PLATE_HALF_WIDTH,
        plate.PLATE_HALF_WIDTH,
        plate.PLATE_HALF_THICKNESS,
    ]
    below = [0, 0, -plate.PLATE_HALF_THICKNESS]
    box = pybullet.createCollisionShape(
        pybullet.GEOM_BOX, halfExtents=half_size, collisionFramePosition=below, **here
    )
    sphere = pybullet.createCollisionShape(
        pybullet.GEOM_SPHERE, radius=plate.BALL_RADIUS, **here
    )
    hub = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=1.0, **here)
    links = (
        (
            [plate.NEGLIGIBLE_INERTIA, plate.MASS],
            [hub, box],
            [[0, 0, 0]] * 2,
            [turns] * 2,
            [[1, 0, 0], [0, 1, 0]],
        ),
        (
            [ARM_MASS, plate.LOAD],
            [hub, sphere],
            [[0, 0, 0], [plate.RADIUS, 0, height]],
            [turns, slides],
            [[0, 0, 1]] * 2,
        ),
    )
    bodies = []
    for masses, shapes, places, joints, axes in links:
        bodies.append(
            pybullet.createMultiBody(
                0.0, -1, -1, [0, 0, 0], [0, 0, 0, 1], linkMasses=masses, linkCollisionShapeIndices=shapes,
                linkVisualShapeIndices=[-1, -1], linkPositions=places, linkOrientations=[[0, 0, 0, 1]] * 2,
                linkInertialFramePositions=[[0, 0, 0]] * 2, linkInertialFrameOrientations=[[0, 0, 0, 1]] * 2,
                linkParentIndices=[0, 1], linkJointTypes=joints, linkJointAxis=axes, **here,
            )
        )  # fmt: skip
        pybullet.setCollisionFilterGroupMask(
            bodies[-1], 0, 0, 0, **here
        )  # no collisions of the hubs
        for link in (0, 1):
            pybullet.changeDynamics(
                bodies[-1], link, lateralFriction=0, restitution=0, linearDamping=0,
                angularDamping=0, jointDamping=0, maxJointVelocity=math.inf, collisionMargin=0, **here,
            )  # fmt: skip
            pybullet.setJointMotorControl2(
                bodies[-1], link, pybullet.VELOCITY_CONTROL, force=0, **here
            )
    plate_body, arm_body = bodies
    pybullet.resetJointState(plate_body, 0, angles[0], rates[0], **here)
    pybullet.resetJointState(plate_body, 1, angles[1], rates[1], **here)
    pybullet.resetJointState(arm_body, 0, 0.0, plate.CONTACT_OMEGA, **here)
    return plate_body
