"""The disk in PyBullet: a sharp-edged cylinder on a plane, without damping and without a collision margin.

Rolling and spinning friction of Bullet are the moments (3.3), but for one arm, that of rolling, in place of k1 and k2.
There is one coefficient of friction, for which the static one is taken.
"""

import numpy as np

from sonify.charts.motion_case import Case
from sonify.charts.records import Answer
from sonify.charts.rigid_body import Pose, answer, at_start, gravity, inertia, quaternion

WITHOUT_LIMIT = 1e9
"""Velocity up to which PyBullet does not interfere."""


def bullet(case: Case, step: float) -> Answer:
    """Solve a case in steps of `step`."""
    import pybullet

    world, count = pybullet.connect(pybullet.DIRECT), round(case.span / step)
    try:
        disk = _disk(pybullet, world, case, step)
        for _ in range(count):
            pybullet.stepSimulation(world)
        centre, turned = pybullet.getBasePositionAndOrientation(disk, world)
        velocity, angular = pybullet.getBaseVelocity(disk, world)
    finally:
        pybullet.disconnect(world)
    rotation = np.reshape(pybullet.getMatrixFromQuaternion(turned), (3, 3))
    return answer(Pose(*map(np.array, (centre, rotation, velocity, angular))), case.law, count)


def _disk(pybullet, world, case, step):
    """Set the world up and return the body at the start of the case."""
    law, start, here = case.law, at_start(case), {"physicsClientId": world}
    w, *axis = quaternion(case)
    pybullet.setGravity(0, 0, -gravity(law), **here)
    pybullet.setPhysicsEngineParameter(
        fixedTimeStep=step, solverResidualThreshold=0, restitutionVelocityThreshold=0, **here
    )
    plane = pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_PLANE, **here), **here)
    pybullet.changeDynamics(plane, -1, lateralFriction=1, rollingFriction=0, spinningFriction=0, restitution=0, **here)
    shape = pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=1, height=2 * law.h, **here)
    disk = pybullet.createMultiBody(1, shape, -1, start.centre.tolist(), [*axis, w], **here)
    pybullet.changeDynamics(
        disk,
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
    pybullet.resetBaseVelocity(disk, start.velocity.tolist(), start.angular.tolist(), **here)
    return disk
