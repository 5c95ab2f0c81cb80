"""Solve the benchmark problems with Drake: a sharp-edged cylinder on a half space, and
the rocking plate.

Drake solves them in discrete steps or by RK3. The contact is at points, as stiff as the
method allows, or over areas with an elastic modulus. Drake has no law for the moments
(3.3), which are external torques. In discrete steps it has a single coefficient of
friction, here the static one.
"""

import logging

import numpy as np
from pydrake import geometry
from pydrake.math import RigidTransform
from pydrake.multibody import tree
from pydrake.multibody.math import SpatialForce
from pydrake.multibody.plant import (
    AddMultibodyPlantSceneGraph,
    ContactModel,
    CoulombFriction,
    DiscreteContactApproximation,
    ExternallyAppliedSpatialForce,
)
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from benchmarks.cases import table_case as plate
from benchmarks.cases.motion_case import Case
from benchmarks.peers.rigid_body import (
    Pose,
    answer,
    at_start,
    gravity,
    inertia,
    quaternion,
    resistance,
)
from benchmarks.timed_runs import Answer

POINT_STIFFNESS = 1e8
"""Stiffness of a point contact, in units of m g/R."""

STICTION_SPEED = 1e-5
"""Slip speed below which friction is regularised, in units of R/chi."""

HYDROELASTIC_STEP = 1e-3
"""Dimensionless time step of the contact over areas."""

TETRAHEDRON_SIZE = 0.05
"""Edge length of the tetrahedra of the contact over areas, divided by R."""

BALL_MODULUS = 1e6
"""Hydroelastic modulus of the ball on the plate [Pa]."""

RELAXATION_TIME = 1e-4
"""Relaxation time of a contact of SAP [s], much shorter than the period of the mode."""


def disk(case: Case, solver: str, step: float) -> Answer:
    """Solve a case by Drake's discrete solver 'Tamsi' or 'Sap' in steps of `step`."""
    plant, body, simulator, context = _disk(case, step, solver)
    count = round(case.span / step)
    if case.law.k1 or case.law.k2 or case.law.k3:
        for i in range(1, count + 1):
            _resist(plant, body, context, case.law)
            simulator.AdvanceTo(i * step)
    else:
        simulator.AdvanceTo(case.span)
    return answer(_pose(plant, body, context), case.law, count)


def continuous(case: Case, slip: float) -> Answer:
    """Solve a case without moments by RK3 with error control; friction is regularised
    below the slip speed `slip`."""
    plant, body, simulator, context = _disk(case, 0.0, slip=slip)
    integrator = simulator.get_mutable_integrator()
    integrator.set_target_accuracy(1e-3)
    simulator.AdvanceTo(case.span)
    return answer(
        _pose(plant, body, context), case.law, integrator.get_num_steps_taken()
    )


def hydroelastic(case: Case, modulus: float) -> Answer:
    """Solve a case without moments by TAMSI with contact over areas; `modulus` is in
    units of m g/R^2."""
    plant, body, simulator, context = _disk(
        case, HYDROELASTIC_STEP, "Tamsi", modulus=modulus
    )
    simulator.AdvanceTo(case.span)
    return answer(
        _pose(plant, body, context), case.law, round(case.span / HYDROELASTIC_STEP)
    )


def table(solver: str, rate: float, modulus: float = 0.0) -> Answer:
    """Solve the rocking plate with `rate` steps per second, by point contact or, with a
    modulus [Pa], over areas."""
    plant, joints, diagram = _plate(solver, 1 / rate, modulus)
    angles, rates, _ = plate.initial_state()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    for joint, angle, speed in zip(
        joints, [*angles, 0.0], [*rates, plate.CONTACT_OMEGA], strict=True
    ):
        joint.set_angle(context, angle)
        joint.set_angular_rate(context, speed)
    simulator.AdvanceTo(plate.DURATION)
    return plate.answer_from_angles(
        [joint.get_angle(context) for joint in joints[:2]], round(plate.DURATION * rate)
    )


def areas(rate: float) -> Answer:
    """Solve the rocking plate by TAMSI with contact over areas."""
    return table("Tamsi", rate, BALL_MODULUS)


def _world(step, fall, solver, by_areas):
    """Return the builder and the plant of an empty world."""
    logging.getLogger("drake").setLevel(logging.ERROR)
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=step)
    if solver:
        plant.set_discrete_contact_approximation(
            getattr(DiscreteContactApproximation, f"k{solver}")
        )
    plant.set_contact_model(
        ContactModel.kHydroelastic if by_areas else ContactModel.kPoint
    )
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -fall])
    return builder, plant


def _matter(mu, dissipation, stiffness, size, modulus=None):
    """Return the contact properties of a body.

    With a modulus the body is compliant and meshed to `size`, with only a size rigid,
    and without both a point contact."""
    matter = geometry.ProximityProperties()
    friction = CoulombFriction(mu, mu)
    geometry.AddContactMaterial(
        dissipation=dissipation,
        point_stiffness=stiffness,
        friction=friction,
        properties=matter,
    )
    if modulus:
        geometry.AddCompliantHydroelasticProperties(size, modulus, matter)
    elif size:
        geometry.AddRigidHydroelasticProperties(size, matter)
    return matter


def _disk(case, step, solver=None, slip=STICTION_SPEED, modulus=None):
    """Return plant, body, simulator and context at the start of the case."""
    law = case.law
    start = at_start(case)
    builder, plant = _world(step, gravity(law), solver, modulus)
    body = plant.AddRigidBody(
        "disk", tree.SpatialInertia(1.0, [0, 0, 0], tree.UnitInertia(*inertia(law)))
    )
    about = (
        (law.mu_static, 0.0, None, TETRAHEDRON_SIZE)
        if modulus
        else (law.mu_static, 0.0, POINT_STIFFNESS, None)
    )
    for on, shape, soft in (
        (plant.world_body(), geometry.HalfSpace(), None),
        (body, geometry.Cylinder(1.0, 2 * law.h), modulus),
    ):
        plant.RegisterCollisionGeometry(
            on, RigidTransform(), shape, on.name(), _matter(*about, soft)
        )
    plant.Finalize()
    plant.set_stiction_tolerance(slip)
    simulator = Simulator(builder.Build())
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetPositions(context, [*quaternion(case), *start.centre])
    plant.SetVelocities(context, [*start.angular, *start.velocity])
    simulator.Initialize()
    return plant, body, simulator, context


def _resist(plant, body, context, law):
    """Apply the moments for the current normal force and angular velocity."""
    contacts = plant.get_contact_results_output_port().Eval(context)
    found = range(contacts.num_point_pair_contacts())
    normal = abs(
        sum(contacts.point_pair_contact_info(i).contact_force()[2] for i in found)
    )
    pose = _pose(plant, body, context)
    moment = ExternallyAppliedSpatialForce()
    moment.body_index = body.index()
    moment.F_Bq_W = SpatialForce(
        resistance(pose.rotation[:, 2], pose.angular, normal, law), np.zeros(3)
    )
    plant.get_applied_spatial_force_input_port().FixValue(context, [moment])


def _pose(plant, body, context):
    pose = plant.EvalBodyPoseInWorld(context, body)
    velocity = plant.EvalBodySpatialVelocityInWorld(context, body)
    return Pose(
        pose.translation(),
        pose.rotation().matrix(),
        velocity.translational(),
        velocity.rotational(),
    )


def _plate(solver, step, modulus):
    """Return the plant, its three hinges and the diagram."""
    builder, plant = _world(step, plate.GRAVITY, solver, modulus)

    def body(name, mass, inertia):
        unit = tree.UnitInertia(*[inertia / mass] * 3)
        return plant.AddRigidBody(name, tree.SpatialInertia(mass, [0, 0, 0], unit))

    between = body("between", plate.NEGLIGIBLE_INERTIA, plate.NEGLIGIBLE_INERTIA)
    top = body("plate", 1.0, plate.PLATE_INERTIA)
    arm = body("arm", 1.0, plate.ARM_INERTIA)
    ball = body("ball", plate.LOAD, plate.NEGLIGIBLE_INERTIA)
    joints = [
        plant.AddJoint(
            tree.RevoluteJoint(
                f"{i}", parent.body_frame(), child.body_frame(), axis, damping
            )
        )
        for i, (parent, child, axis, damping) in enumerate(
            (
                (plant.world_body(), between, [1, 0, 0], plate.DAMPER),
                (between, top, [0, 1, 0], plate.DAMPER),
                (plant.world_body(), arm, [0, 0, 1], 0.0),
            )
        )
    ]
    for joint in joints[:2]:
        plant.AddForceElement(tree.RevoluteSpring(joint, 0.0, plate.SPRING))
    end = RigidTransform([plate.RADIUS, 0, plate.initial_state()[2]])
    rail = plant.AddFrame(tree.FixedOffsetFrame("rail", arm, end))
    plant.AddJoint(tree.PrismaticJoint("slide", rail, ball.body_frame(), [0, 0, 1]))
    box = geometry.Box(
        2 * plate.PLATE_HALF_WIDTH,
        2 * plate.PLATE_HALF_WIDTH,
        2 * plate.PLATE_HALF_THICKNESS,
    )
    for on, depth, shape, size, soft in (
        (top, plate.PLATE_HALF_THICKNESS, box, 2 * plate.PLATE_HALF_WIDTH, None),
        (ball, 0.0, geometry.Sphere(plate.BALL_RADIUS), plate.BALL_RADIUS / 4, modulus),
    ):
        matter = _matter(0.0, 1.0, 1e6, size if modulus else None, soft)
        matter.AddProperty("material", "relaxation_time", RELAXATION_TIME)
        plant.RegisterCollisionGeometry(
            on, RigidTransform([0, 0, -depth]), shape, on.name(), matter
        )
    plant.Finalize()
    return plant, joints, builder.Build()
