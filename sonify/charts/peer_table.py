"""The plate that rocks under a weight that goes round, in MuJoCo, Drake and PyBullet.

The plate stands on two hinges in the plane of its face, each with a spring and a damper; a ball without friction slides
up and down on an arm of great inertia that turns steadily. Each engine finds the contact by itself.
"""

import logging
import math

import numpy as np

from sonify.charts.records import Answer, Failure
from sonify.charts.table_case import GRAVITY, LOAD, MASS, OMEGA, RADIUS, SPAN, ZETA, W, amplitude, answer

INERTIA = MASS * RADIUS**2
SPRING, DAMPER = INERTIA * W**2, 2 * ZETA * W * INERTIA
BALL, DEEP, GREAT, HEAVY, SMALL = 0.02, 0.05, 10.0, 1e6, 1e-6
"""Radius of the ball, half thickness of the plate [m]; inertia of the arm [kg m^2], which drag slows by 1e-5, its mass
in PyBullet [kg]; inertia or mass of what has none. The tolerance of SAP is relative to the momentum of all there is."""
HALF = (3 * RADIUS**2 - DEEP**2) ** 0.5
"""Half width of a plate of that mass whose inertia [m] is that of the mode: PyBullet takes it from the shape."""
MODULUS = 1e6
"""Hydroelastic modulus of the ball [Pa]."""
RELAXES = 1e-4
"""Time [s] in which a contact of Drake's SAP gives way: far less than a period of the mode."""
MODEL = """<mujoco>
  <option timestep="{step}" integrator="{integrator}" gravity="0 0 -{gravity}"/>
  <default><geom condim="1" solref="{time} 1" solimp="0.9 0.99 1e-4"/></default>
  <worldbody>
    <body>
      <joint type="hinge" axis="1 0 0" stiffness="{spring}" damping="{damper}"/>
      <joint type="hinge" axis="0 1 0" stiffness="{spring}" damping="{damper}"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>
      <geom type="box" size="{half} {half} {deep}" pos="0 0 -{deep}"/>
    </body>
    <body>
      <joint type="hinge" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{great} {great} {great}"/>
      <body pos="{radius} 0 {height}">
        <joint type="slide" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="{load}" diaginertia="{small} {small} {small}"/>
        <geom type="sphere" size="{ball}"/>
      </body>
    </body>
  </worldbody>
</mujoco>"""


FLEXES = """<mujoco>
  <option timestep="{step}" gravity="0 0 0" integrator="discrete"><flag contact="disable"/></option>
  <worldbody>
    <flexcomp name="plate" type="grid" dim="2" count="{count} {count} 1" spacing="{apart} {apart} 1" mass="{mass}">
      <elasticity young="{young}" poisson="{poisson}" thickness="{thickness}" elastic2d="bend"/>
      <contact selfcollide="none"/>
      <pin grid="{edge}"/>
    </flexcomp>
  </worldbody>
</mujoco>"""


def start() -> tuple[np.ndarray, np.ndarray, float]:
    """Return the angles of the plate about x and y [rad], their rates [1/s], and how high the ball is [m]."""
    A = amplitude()
    angles, rates = (np.array([z.imag, -z.real]) / RADIUS for z in (A, 1j * OMEGA * A))
    return angles, rates, A.real + BALL


def found(angles, steps: int) -> Answer:
    """Return the answer of the angles about x and y at the end."""
    return answer(complex(-angles[1], angles[0]) * RADIUS, steps)


def mujoco(integrator: str, step: float) -> Answer:
    """Solve with MuJoCo's `integrator` and its contact, as stiff as the step allows."""
    import mujoco

    (angles, rates, height), count = start(), round(SPAN / step)
    text = MODEL.format(
        step=step, time=2 * step, integrator=integrator, gravity=GRAVITY, spring=SPRING, damper=DAMPER,
        inertia=INERTIA, half=HALF, deep=DEEP, great=GREAT, radius=RADIUS, height=height, load=LOAD, small=SMALL,
        ball=BALL,
    )  # fmt: skip
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    data.qpos[:2], data.qvel[:3] = angles, [*rates, OMEGA]
    mujoco.mj_step(model, data, nstep=count)
    return found(data.qpos[:2], count)


def flexes(count: int, step: float = 1e-3, side: float = 1.0, thickness: float = 0.01) -> Answer:
    """Raise the Failure of MuJoCo's plate of flexes, which has no modes to be given: at what part of its frequency the
    first mode of a supported square plate of `count` vertices a side rings; f = pi/a^2 (B/m'')^0.5."""
    import mujoco

    young, poisson, density = 1e9, 0.3, 1e3
    edge = " ".join(f"{i} {j}" for i in range(count) for j in range(count) if {i, j} & {0, count - 1})
    model = mujoco.MjModel.from_xml_string(
        FLEXES.format(
            step=step, count=count, apart=side / (count - 1), mass=density * thickness * side**2, young=young,
            poisson=poisson, thickness=thickness, edge=edge,
        )
    )  # fmt: skip
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    middle = np.abs(data.flexvert_xpos).sum(axis=1).argmin()
    for joint in np.flatnonzero(model.jnt_axis[:, 2] > 0.5):
        place = data.xpos[model.jnt_bodyid[joint], :2]
        data.qvel[model.jnt_dofadr[joint]] = 1e-3 * np.cos(np.pi * place / side).prod()
    height = []
    for _ in range(round(0.3 / step)):
        mujoco.mj_step(model, data)
        height.append(data.flexvert_xpos[middle, 2])
    crossings = np.flatnonzero(np.diff(np.sign(height)))
    rings = 0.5 / step / np.diff(crossings).mean()
    frequency = np.pi / side**2 * (young * thickness**2 / (12 * (1 - poisson**2) * density)) ** 0.5
    raise Failure(f"no modes to be given; its own plate rings at {rings / frequency:.2f} of the frequency")


def drake(solver: str, step: float, modulus: float = 0.0) -> Answer:
    """Solve with Drake in discrete steps; with a `modulus` [Pa] by its contact over areas, else at a point."""
    from pydrake.systems.analysis import Simulator

    plant, joints, diagram = _drake_world(solver, step, modulus)
    (angles, rates, _), simulator = start(), Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    for joint, angle, rate in zip(joints, [*angles, 0.0], [*rates, OMEGA], strict=True):
        joint.set_angle(context, angle)
        joint.set_angular_rate(context, rate)
    simulator.AdvanceTo(SPAN)
    return found([joint.get_angle(context) for joint in joints[:2]], round(SPAN / step))


def areas(step: float) -> Answer:
    """Solve with Drake's contact over areas, in steps of TAMSI."""
    return drake("Tamsi", step, MODULUS)


def _drake_world(solver, step, modulus):
    from pydrake.geometry import Box, Sphere
    from pydrake.math import RigidTransform
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, ContactModel, DiscreteContactApproximation
    from pydrake.multibody.tree import (
        FixedOffsetFrame,
        PrismaticJoint,
        RevoluteJoint,
        RevoluteSpring,
        SpatialInertia,
        UnitInertia,
    )
    from pydrake.systems.framework import DiagramBuilder

    logging.getLogger("drake").setLevel(logging.ERROR)
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=step)
    plant.set_discrete_contact_approximation(getattr(DiscreteContactApproximation, f"k{solver}"))
    plant.set_contact_model(ContactModel.kHydroelastic if modulus else ContactModel.kPoint)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -GRAVITY])

    def body(name, mass, inertia):
        return plant.AddRigidBody(name, SpatialInertia(mass, [0, 0, 0], UnitInertia(*[inertia / mass] * 3)))

    between, plate = body("between", SMALL, SMALL), body("plate", 1.0, INERTIA)
    arm, ball = body("arm", 1.0, GREAT), body("ball", LOAD, SMALL)
    still, here = RigidTransform(), RigidTransform([RADIUS, 0, start()[2]])
    joints = [
        plant.AddJoint(RevoluteJoint(f"{i}", parent.body_frame(), child.body_frame(), axis, damping))
        for i, (parent, child, axis, damping) in enumerate(
            (
                (plant.world_body(), between, [1, 0, 0], DAMPER),
                (between, plate, [0, 1, 0], DAMPER),
                (plant.world_body(), arm, [0, 0, 1], 0.0),
            )
        )
    ]
    for joint in joints[:2]:
        plant.AddForceElement(RevoluteSpring(joint, 0.0, SPRING))
    plant.AddJoint(
        PrismaticJoint("slide", plant.AddFrame(FixedOffsetFrame("rail", arm, here)), ball.body_frame(), [0, 0, 1])
    )
    box, sphere = Box(2 * HALF, 2 * HALF, 2 * DEEP), Sphere(BALL)
    plant.RegisterCollisionGeometry(plate, RigidTransform([0, 0, -DEEP]), box, "plate", _drake_matter(modulus, False))
    plant.RegisterCollisionGeometry(ball, still, sphere, "ball", _drake_matter(modulus, True))
    plant.Finalize()
    return plant, joints, builder.Build()


def _drake_matter(modulus, soft):
    from pydrake.geometry import (
        AddCompliantHydroelasticProperties,
        AddContactMaterial,
        AddRigidHydroelasticProperties,
        ProximityProperties,
    )
    from pydrake.multibody.plant import CoulombFriction

    matter = ProximityProperties()
    matter.AddProperty("material", "relaxation_time", RELAXES)
    AddContactMaterial(dissipation=1.0, point_stiffness=1e6, friction=CoulombFriction(0.0, 0.0), properties=matter)
    if modulus and soft:
        AddCompliantHydroelasticProperties(BALL / 4, modulus, matter)
    elif modulus:
        AddRigidHydroelasticProperties(2 * HALF, matter)
    return matter


def bullet(step: float) -> Answer:
    """Solve with PyBullet, whose springs are torques from the angles at the beginning of each step."""
    import pybullet

    world, count = pybullet.connect(pybullet.DIRECT), round(SPAN / step)
    try:
        plate = _bullet_world(pybullet, world, step)
        for _ in range(count):
            for joint in (0, 1):
                angle, rate = pybullet.getJointState(plate, joint, world)[:2]
                torque = -SPRING * angle - DAMPER * rate
                pybullet.setJointMotorControl2(
                    plate, joint, pybullet.TORQUE_CONTROL, force=torque, physicsClientId=world
                )
            pybullet.stepSimulation(world)
        angles = [pybullet.getJointState(plate, joint, world)[0] for joint in (0, 1)]
    finally:
        pybullet.disconnect(world)
    return found(angles, count)


def _bullet_world(pybullet, world, step):
    """Set the world up at the start and return the plate."""
    here, (angles, rates, height) = {"physicsClientId": world}, start()
    pybullet.setGravity(0, 0, -GRAVITY, **here)
    pybullet.setPhysicsEngineParameter(
        fixedTimeStep=step, solverResidualThreshold=0, restitutionVelocityThreshold=0, **here
    )
    turns, slides = pybullet.JOINT_REVOLUTE, pybullet.JOINT_PRISMATIC
    box = pybullet.createCollisionShape(
        pybullet.GEOM_BOX, halfExtents=[HALF, HALF, DEEP], collisionFramePosition=[0, 0, -DEEP], **here
    )
    sphere, hub = (pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=r, **here) for r in (BALL, 1.0))
    links = (
        ([SMALL, MASS], [hub, box], [[0, 0, 0]] * 2, [turns] * 2, [[1, 0, 0], [0, 1, 0]]),
        ([HEAVY, LOAD], [hub, sphere], [[0, 0, 0], [RADIUS, 0, height]], [turns, slides], [[0, 0, 1]] * 2),
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
    for body, link, place, rate in ((0, 0, angles[0], rates[0]), (0, 1, angles[1], rates[1]), (1, 0, 0.0, OMEGA)):
        pybullet.resetJointState(bodies[body], link, place, rate, **here)
    return bodies[0]
