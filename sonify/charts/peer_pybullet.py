"""PyBullet: the disk, a sharp-edged cylinder on a plane, and the plate that rocks; no damping, no collision margin.

Rolling and spinning friction of Bullet are the moments (3.3), but for one arm, that of rolling, in place of k1 and k2.
There is one coefficient of friction, for which the static one is taken. The springs of the plate are torques from its
angles at the beginning of each step.
"""

import math
from contextlib import contextmanager

import numpy as np
import pybullet

from sonify.charts import table_case as plate
from sonify.charts.motion_case import Case
from sonify.charts.records import Answer
from sonify.charts.rigid_body import Pose, answer, at_start, gravity, inertia, quaternion

WITHOUT_LIMIT = 1e9
"""Velocity up to which PyBullet does not interfere."""
HEAVY = 1e6
"""Mass of the arm [kg]."""


@contextmanager
def world(fall: float, step: float):
    """Open an empty world, in steps of `step`; yield the option that names it."""
    here = {"physicsClientId": pybullet.connect(pybullet.DIRECT)}
    try:
        pybullet.setGravity(0, 0, -fall, **here)
        exact = {"solverResidualThreshold": 0, "restitutionVelocityThreshold": 0}
        pybullet.setPhysicsEngineParameter(fixedTimeStep=step, **exact, **here)
        yield here
    finally:
        pybullet.disconnect(**here)


def disk(case: Case, step: float) -> Answer:
    """Solve a case in steps of `step`."""
    count = round(case.span / step)
    with world(gravity(case.law), step) as here:
        body = _disk(case, here)
        for _ in range(count):
            pybullet.stepSimulation(**here)
        centre, turned = pybullet.getBasePositionAndOrientation(body, **here)
        velocity, angular = pybullet.getBaseVelocity(body, **here)
    rotation = np.reshape(pybullet.getMatrixFromQuaternion(turned), (3, 3))
    return answer(Pose(*map(np.array, (centre, rotation, velocity, angular))), case.law, count)


def table(rate: float) -> Answer:
    """Solve the plate with `rate` steps a second."""
    count = round(plate.SPAN * rate)
    with world(plate.GRAVITY, 1 / rate) as here:
        body = _plate(here)
        for _ in range(count):
            for joint in (0, 1):
                angle, speed = pybullet.getJointState(body, joint, **here)[:2]
                torque = -plate.SPRING * angle - plate.DAMPER * speed
                pybullet.setJointMotorControl2(body, joint, pybullet.TORQUE_CONTROL, force=torque, **here)
            pybullet.stepSimulation(**here)
        angles = [pybullet.getJointState(body, joint, **here)[0] for joint in (0, 1)]
    return plate.tilted(angles, count)


def _disk(case, here):
    """Return the body at the start of the case, on a plane."""
    law, start = case.law, at_start(case)
    w, *axis = quaternion(case)
    plane = pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_PLANE, **here), **here)
    pybullet.changeDynamics(plane, -1, lateralFriction=1, rollingFriction=0, spinningFriction=0, restitution=0, **here)
    shape = pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=1, height=2 * law.h, **here)
    body = pybullet.createMultiBody(1, shape, -1, start.centre.tolist(), [*axis, w], **here)
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
        maxJointVelocity=WITHOUT_LIMIT,
        activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
        **here,
    )
    pybullet.resetBaseVelocity(body, start.velocity.tolist(), start.angular.tolist(), **here)
    return body


def _plate(here):
    """Return the plate at the start, under the ball on its arm."""
    angles, rates, height = plate.at_start()
    turns, slides = pybullet.JOINT_REVOLUTE, pybullet.JOINT_PRISMATIC
    half, below = [plate.HALF, plate.HALF, plate.DEEP], [0, 0, -plate.DEEP]
    box = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=half, collisionFramePosition=below, **here)
    sphere, hub = (pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=r, **here) for r in (plate.BALL, 1.0))
    links = (
        ([plate.SMALL, plate.MASS], [hub, box], [[0, 0, 0]] * 2, [turns] * 2, [[1, 0, 0], [0, 1, 0]]),
        ([HEAVY, plate.LOAD], [hub, sphere], [[0, 0, 0], [plate.RADIUS, 0, height]], [turns, slides], [[0, 0, 1]] * 2),
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
        pybullet.setCollisionFilterGroupMask(bodies[-1], 0, 0, 0, **here)  # the hubs touch nothing
        for link in (0, 1):
            pybullet.changeDynamics(
                bodies[-1], link, lateralFriction=0, restitution=0, linearDamping=0,
                angularDamping=0, jointDamping=0, maxJointVelocity=math.inf, collisionMargin=0, **here,
            )  # fmt: skip
            pybullet.setJointMotorControl2(bodies[-1], link, pybullet.VELOCITY_CONTROL, force=0, **here)
    for i, link, place, speed in ((0, 0, angles[0], rates[0]), (0, 1, angles[1], rates[1]), (1, 0, 0.0, plate.OMEGA)):
        pybullet.resetJointState(bodies[i], link, place, speed, **here)
    return bodies[0]
