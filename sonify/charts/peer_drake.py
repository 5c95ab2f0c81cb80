"""The disk in Drake: a sharp-edged cylinder on a half space, in discrete steps (TAMSI, SAP) or by RK3.

Point contact, as stiff as the method bears; `hydroelastic` is its contact by areas, with a modulus in place of a step.
The moments (3.3) act as external torques, which Drake has no law for. In discrete steps there is one coefficient of
friction, for which the static one is taken.
"""

import logging

import numpy as np

from sonify.charts.motion_case import Case
from sonify.charts.records import Answer
from sonify.charts.rigid_body import Pose, answer, at_start, gravity, inertia, quaternion, resistance

STIFFNESS = 1e8
"""Of a point of contact, over m g/R."""
SLIP = 1e-5
"""Slip speed up to which friction is smeared, over R/chi."""
HYDROELASTIC_STEP, FINENESS = 1e-3, 0.05
"""Step, and the length of the sides of the tetrahedra, of the contact by areas."""


def drake(case: Case, solver: str, step: float) -> Answer:
    """Solve a case by the discrete `solver`, 'Tamsi' or 'Sap', in steps of `step`."""
    plant, disk, diagram = _world(case, step, solver)
    simulator, context = _started(case, plant, disk, diagram)
    count = round(case.span / step)
    if case.law.k1 or case.law.k2 or case.law.k3:
        for i in range(1, count + 1):
            _resist(plant, disk, context, case.law)
            simulator.AdvanceTo(i * step)
    else:
        simulator.AdvanceTo(case.span)
    return _answer(case, plant, disk, context, count)


def continuous(case: Case, slip: float) -> Answer:
    """Solve a case without moments by RK3 with error control, friction smeared over the speed `slip`."""
    plant, disk, diagram = _world(case, 0.0, slip=slip)
    simulator, context = _started(case, plant, disk, diagram)
    integrator = simulator.get_mutable_integrator()
    integrator.set_target_accuracy(1e-3)
    simulator.AdvanceTo(case.span)
    return _answer(case, plant, disk, context, integrator.get_num_steps_taken())


def hydroelastic(case: Case, modulus: float) -> Answer:
    """Solve a case without moments by contact over areas of a `modulus`, over m g/R^2, in steps of TAMSI."""
    plant, disk, diagram = _world(case, HYDROELASTIC_STEP, "Tamsi", modulus=modulus)
    simulator, context = _started(case, plant, disk, diagram)
    simulator.AdvanceTo(case.span)
    return _answer(case, plant, disk, context, round(case.span / HYDROELASTIC_STEP))


def _world(case, step, solver=None, slip=SLIP, modulus=None):
    from pydrake.geometry import Cylinder, HalfSpace
    from pydrake.math import RigidTransform
    from pydrake.multibody.plant import (
        AddMultibodyPlantSceneGraph,
        ContactModel,
        DiscreteContactApproximation,
    )
    from pydrake.multibody.tree import SpatialInertia, UnitInertia
    from pydrake.systems.framework import DiagramBuilder

    logging.getLogger("drake").setLevel(logging.ERROR)
    builder, law = DiagramBuilder(), case.law
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=step)
    if solver:
        plant.set_discrete_contact_approximation(getattr(DiscreteContactApproximation, f"k{solver}"))
    plant.set_contact_model(ContactModel.kHydroelastic if modulus else ContactModel.kPoint)
    disk = plant.AddRigidBody("disk", SpatialInertia(1.0, [0, 0, 0], UnitInertia(*inertia(law))))
    for body, shape, soft in ((plant.world_body(), HalfSpace(), None), (disk, Cylinder(1.0, 2 * law.h), modulus)):
        matter = _matter(law, modulus is not None, soft)
        plant.RegisterCollisionGeometry(body, RigidTransform(), shape, body.name(), matter)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -gravity(law)])
    plant.Finalize()
    plant.set_stiction_tolerance(slip)
    return plant, disk, builder.Build()


def _matter(law, areas, modulus):
    from pydrake.geometry import (
        AddCompliantHydroelasticProperties,
        AddContactMaterial,
        AddRigidHydroelasticProperties,
        ProximityProperties,
    )
    from pydrake.multibody.plant import CoulombFriction

    matter, stiffness = ProximityProperties(), None if areas else STIFFNESS
    friction = CoulombFriction(law.mu_static, law.mu_static)
    AddContactMaterial(dissipation=0.0, point_stiffness=stiffness, friction=friction, properties=matter)
    if modulus:
        AddCompliantHydroelasticProperties(FINENESS, modulus, matter)
    elif areas:
        AddRigidHydroelasticProperties(matter)
    return matter


def _started(case, plant, disk, diagram):
    from pydrake.systems.analysis import Simulator

    simulator, start = Simulator(diagram), at_start(case)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetPositions(context, [*quaternion(case), *start.centre])
    plant.SetVelocities(context, [*start.angular, *start.velocity])
    simulator.Initialize()
    return simulator, context


def _resist(plant, disk, context, law):
    """Apply the moments under the normal force and the angular velocity of now."""
    from pydrake.multibody.math import SpatialForce
    from pydrake.multibody.plant import ExternallyAppliedSpatialForce

    contacts = plant.get_contact_results_output_port().Eval(context)
    found = range(contacts.num_point_pair_contacts())
    normal = abs(sum(contacts.point_pair_contact_info(i).contact_force()[2] for i in found))
    pose = _pose(plant, disk, context)
    moment = ExternallyAppliedSpatialForce()
    moment.body_index = disk.index()
    moment.F_Bq_W = SpatialForce(resistance(pose.rotation[:, 2], pose.angular, normal, law), np.zeros(3))
    plant.get_applied_spatial_force_input_port().FixValue(context, [moment])


def _pose(plant, disk, context):
    place, moving = plant.EvalBodyPoseInWorld(context, disk), plant.EvalBodySpatialVelocityInWorld(context, disk)
    return Pose(place.translation(), place.rotation().matrix(), moving.translational(), moving.rotational())


def _answer(case, plant, disk, context, steps):
    return answer(_pose(plant, disk, context), case.law, steps)
