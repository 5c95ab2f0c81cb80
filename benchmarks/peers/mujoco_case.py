"""Solve the benchmark problems with MuJoCo: a sharp-edged cylinder on a plane, and the
rocking plate.

The contact is as stiff as the step allows: its time constant is twice the step, the
shortest one accepted by MuJoCo. MuJoCo computes the contact of plane and cylinder in
closed form. The moments (3.3) are external torques, because MuJoCo's rolling friction
(condim 6) and the sliding share one friction cone, which is another law. MuJoCo has a
single coefficient of friction, here the static one."""

import mujoco
import numpy as np

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
from benchmarks.timed_runs import Answer, Failure

DISK = """<mujoco>
  <option timestep="{step}" integrator="{integrator}" cone="elliptic" gravity="0 0 -{fall}"/>
  <default><geom condim="3" friction="{law.mu_static} 0 0" solref="{time} 1" solimp="0.9 0.99 1e-4"/></default>
  <worldbody>
    <geom type="plane" size="100 100 1"/>
    <body pos="{centre}" quat="{quaternion}">
      <freejoint/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/>
      <geom type="cylinder" size="1 {law.h}"/>
    </body>
  </worldbody>
</mujoco>"""
PLATE = """<mujoco>
  <option timestep="{step}" integrator="{integrator}" gravity="0 0 -{plate.GRAVITY}"/>
  <default><geom condim="1" solref="{time} 1" solimp="0.9 0.99 1e-4"/></default>
  <worldbody>
    <body>
      <joint type="hinge" axis="1 0 0" stiffness="{plate.SPRING}" damping="{plate.DAMPER}"/>
      <joint type="hinge" axis="0 1 0" stiffness="{plate.SPRING}" damping="{plate.DAMPER}"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{plate_inertia}"/>
      <geom type="box" size="{plate_half_size}" pos="0 0 -{plate.PLATE_HALF_THICKNESS}"/>
    </body>
    <body>
      <joint type="hinge" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{arm_inertia}"/>
      <body pos="{plate.RADIUS} 0 {height}">
        <joint type="slide" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="{plate.LOAD}" diaginertia="{ball_inertia}"/>
        <geom type="sphere" size="{plate.BALL_RADIUS}"/>
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


def model_and_data(text: str, **values):
    """Return model and state of an XML description after inserting the values."""
    model = mujoco.MjModel.from_xml_string(text.format(**values))
    return model, mujoco.MjData(model)


def disk(case: Case, integrator: str, step: float) -> Answer:
    """Solve a case by MuJoCo's integrator 'Euler' (semi-implicit) or 'RK4' in steps of
    `step`."""
    start = at_start(case)
    count = round(case.span / step)
    model, data = model_and_data(
        DISK,
        step=step,
        time=2 * step,
        integrator=integrator,
        law=case.law,
        fall=gravity(case.law),
        centre=_numbers(start.centre),
        quaternion=_numbers(quaternion(case)),
        inertia=_numbers(inertia(case.law)),
    )
    data.qvel[:3] = start.velocity
    data.qvel[3:] = start.rotation.T @ start.angular
    if case.law.k1 or case.law.k2 or case.law.k3:
        mujoco.mj_forward(model, data)
        for _ in range(count):
            axle = data.xmat[1, 2::3]
            normal = data.efc_force[data.contact.efc_address].sum()
            angular = data.xmat[1].reshape(3, 3) @ data.qvel[3:]
            data.xfrc_applied[1, 3:] = resistance(axle, angular, normal, case.law)
            mujoco.mj_step(model, data)
    else:
        mujoco.mj_step(model, data, nstep=count)
    mujoco.mj_kinematics(model, data)
    rotation = data.xmat[1].reshape(3, 3)
    return answer(
        Pose(data.qpos[:3], rotation, data.qvel[:3], rotation @ data.qvel[3:]),
        case.law,
        count,
    )


def _numbers(values):
    return " ".join(map(repr, np.asarray(values, float).tolist()))


def table(integrator: str, rate: float) -> Answer:
    """Solve the rocking plate by MuJoCo's integrator with `rate` steps per second."""
    angles, rates, height = plate.initial_state()
    step = 1 / rate
    count = round(plate.DURATION * rate)
    model, data = model_and_data(
        PLATE,
        step=step,
        time=2 * step,
        integrator=integrator,
        height=height,
        plate=plate,
        plate_inertia=_numbers([plate.PLATE_INERTIA] * 3),
        plate_half_size=_numbers(
            [plate.PLATE_HALF_WIDTH, plate.PLATE_HALF_WIDTH, plate.PLATE_HALF_THICKNESS]
        ),
        arm_inertia=_numbers([plate.ARM_INERTIA] * 3),
        ball_inertia=_numbers([plate.NEGLIGIBLE_INERTIA] * 3),
    )
    data.qpos[:2] = angles
    data.qvel[:3] = [*rates, plate.CONTACT_OMEGA]
    mujoco.mj_step(model, data, nstep=count)
    return plate.answer_from_angles(data.qpos[:2], count)


def flexes(count: int) -> Answer:
    """Raise a Failure, because modes cannot be given to MuJoCo's plate of flexes and
    its first frequency is wrong.

    The message states the ratio of the frequency of the first mode of a simply
    supported square plate with `count` vertices per side to the exact one, f = pi/a^2
    (B/m'')^0.5."""
    young = 1e9
    poisson = 0.3
    density = 1e3
    step = 1e-3
    side = 1.0
    thickness = 0.01
    edge = " ".join(
        f"{i} {j}"
        for i in range(count)
        for j in range(count)
        if {i, j} & {0, count - 1}
    )
    solid = {
        "young": young,
        "poisson": poisson,
        "thickness": thickness,
        "mass": density * thickness * side**2,
    }
    model, data = model_and_data(
        FLEXES, step=step, count=count, apart=side / (count - 1), edge=edge, **solid
    )
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
    measured = 0.5 / step / np.diff(crossings).mean()
    exact = (
        np.pi
        / side**2
        * (young * thickness**2 / (12 * (1 - poisson**2) * density)) ** 0.5
    )
    raise Failure(
        f"no modes to be given; its own plate rings at {measured / exact:.2f} of the frequency"
    )
