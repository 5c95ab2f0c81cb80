"""MuJoCo: the disk, a sharp-edged cylinder on a plane, and the plate that rocks; contact as stiff as a step allows.

The time constant of the contact, twice the step, is the shortest that MuJoCo takes; the plane meets a cylinder in
closed form. The moments (3.3) act as external torques: MuJoCo's own rolling friction (condim 6) shares one cone with
the sliding, which is another law. There is one coefficient of friction, for which the static one is taken.
"""

import mujoco
import numpy as np

from sonify.charts import table_case as plate
from sonify.charts.motion_case import Case
from sonify.charts.records import Answer, Failure
from sonify.charts.rigid_body import Pose, answer, at_start, gravity, inertia, quaternion, resistance

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
      <inertial pos="0 0 0" mass="1" diaginertia="{plate.INERTIA} {plate.INERTIA} {plate.INERTIA}"/>
      <geom type="box" size="{plate.HALF} {plate.HALF} {plate.DEEP}" pos="0 0 -{plate.DEEP}"/>
    </body>
    <body>
      <joint type="hinge" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{plate.GREAT} {plate.GREAT} {plate.GREAT}"/>
      <body pos="{plate.RADIUS} 0 {height}">
        <joint type="slide" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="{plate.LOAD}" diaginertia="{plate.SMALL} {plate.SMALL} {plate.SMALL}"/>
        <geom type="sphere" size="{plate.BALL}"/>
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


def made(text: str, **values):
    """Return model and state of a description with these values in it."""
    model = mujoco.MjModel.from_xml_string(text.format(**values))
    return model, mujoco.MjData(model)


def disk(case: Case, integrator: str, step: float) -> Answer:
    """Solve a case by the `integrator`, 'Euler' (semi-implicit) or 'RK4', in steps of `step`."""
    start, count = at_start(case), round(case.span / step)
    model, data = made(
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
    data.qvel[:3], data.qvel[3:] = start.velocity, start.rotation.T @ start.angular
    if case.law.k1 or case.law.k2 or case.law.k3:
        mujoco.mj_forward(model, data)
        for _ in range(count):
            axle, normal = data.xmat[1, 2::3], data.efc_force[data.contact.efc_address].sum()
            angular = data.xmat[1].reshape(3, 3) @ data.qvel[3:]
            data.xfrc_applied[1, 3:] = resistance(axle, angular, normal, case.law)
            mujoco.mj_step(model, data)
    else:
        mujoco.mj_step(model, data, nstep=count)
    mujoco.mj_kinematics(model, data)
    rotation = data.xmat[1].reshape(3, 3)
    return answer(Pose(data.qpos[:3], rotation, data.qvel[:3], rotation @ data.qvel[3:]), case.law, count)


def _numbers(values):
    return " ".join(map(repr, np.asarray(values, float).tolist()))


def table(integrator: str, rate: float) -> Answer:
    """Solve the plate by the `integrator`, with `rate` steps a second."""
    (angles, rates, height), step, count = plate.at_start(), 1 / rate, round(plate.SPAN * rate)
    model, data = made(PLATE, step=step, time=2 * step, integrator=integrator, height=height, plate=plate)
    data.qpos[:2], data.qvel[:3] = angles, [*rates, plate.OMEGA]
    mujoco.mj_step(model, data, nstep=count)
    return plate.tilted(data.qpos[:2], count)


def flexes(count: int) -> Answer:
    """Raise the Failure of MuJoCo's plate of flexes, which has no modes to be given: at what part of its frequency the
    first mode of a supported square plate of `count` vertices a side rings; f = pi/a^2 (B/m'')^0.5."""
    young, poisson, density, step, side, thickness = 1e9, 0.3, 1e3, 1e-3, 1.0, 0.01
    edge = " ".join(f"{i} {j}" for i in range(count) for j in range(count) if {i, j} & {0, count - 1})
    solid = {"young": young, "poisson": poisson, "thickness": thickness, "mass": density * thickness * side**2}
    model, data = made(FLEXES, step=step, count=count, apart=side / (count - 1), edge=edge, **solid)
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
