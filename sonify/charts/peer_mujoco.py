"""The disk in MuJoCo: a sharp-edged cylinder on a plane, contact as stiff as a step allows.

The time constant of the contact, twice the step, is the shortest that MuJoCo takes; the plane meets a cylinder in
closed form. The moments (3.3) act as external torques: MuJoCo's own rolling friction (condim 6) shares one cone with
the sliding, which is another law. There is one coefficient of friction, for which the static one is taken.
"""

import numpy as np

from sonify.charts.motion_case import Case
from sonify.charts.records import Answer
from sonify.charts.rigid_body import Pose, answer, at_start, gravity, inertia, quaternion, resistance

MODEL = """<mujoco>
  <option timestep="{step}" integrator="{integrator}" cone="elliptic" gravity="0 0 {gravity}"/>
  <default><geom condim="3" friction="{mu} 0 0" solref="{time} 1" solimp="0.9 0.99 1e-4"/></default>
  <worldbody>
    <geom type="plane" size="100 100 1"/>
    <body pos="{centre}" quat="{quaternion}">
      <freejoint/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia}"/>
      <geom type="cylinder" size="1 {h}"/>
    </body>
  </worldbody>
</mujoco>"""


def mujoco(case: Case, integrator: str, step: float) -> Answer:
    """Solve a case with MuJoCo's `integrator`, 'Euler' (semi-implicit) or 'RK4', in steps of `step`."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(_model(case, integrator, step))
    data = mujoco.MjData(model)
    start, count = at_start(case), round(case.span / step)
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


def _model(case, integrator, step):
    def numbers(values):
        return " ".join(map(repr, np.asarray(values, float).tolist()))

    return MODEL.format(
        step=step,
        time=2 * step,
        integrator=integrator,
        gravity=-gravity(case.law),
        mu=case.law.mu_static,
        centre=numbers(at_start(case).centre),
        quaternion=numbers(quaternion(case)),
        inertia=numbers(inertia(case.law)),
        h=case.law.h,
    )
