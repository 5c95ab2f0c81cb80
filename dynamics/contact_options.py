"""Predicted errors and processor seconds of each model of an elastic contact.

The processor time is the number of steps times the time of one step, which was measured on
shipped scenes and for the chart `contact-models`. The duration is that of quasi-steady rolling with the energy at the
release, or that of rattling. The errors are those of the same chart, interpolated at the
predicted rms of N' and at the curvature number, and that of one-way coupling.
"""

from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from dynamics.compliant.model_errors import motion_error
from dynamics.disk import GRAVITY, inertias
from dynamics.quasi_steady import steady_power

if TYPE_CHECKING:
    from dynamics.motion_plan import MotionPlan
    from dynamics.sections import MotionScene

OptionName = Literal["filter", "two-way filter", "full", "many"]
"""A model of an elastic contact, with the coupling of its table."""

FILTER_SAMPLE_RATE = 96_000.0
"""Rate [Hz] at which the filter is assumed to be evaluated."""

RIGID_MOTION_SECONDS = 0.9
"""Processor time [s] of the rigid motion to which the filter is applied."""


class StepCost(NamedTuple):
    """Processor time of one step [s] of a model.

    Attributes
    ----------
    rigid : float
        On a rigid table.
    modal : float
        On a table with modes, without the time for each of them.
    per_mode : float
        Additional time for each mode.
    """

    rigid: float
    modal: float
    per_mode: float

    def at(self, mode_count: int) -> float:
        """Return the time of a step with `mode_count` modes."""
        return self.modal + self.per_mode * mode_count if mode_count else self.rigid


STEP_SECONDS = {
    "filter": StepCost(3.5e-7, 3.5e-7, 1.2e-9),
    "full": StepCost(0.35e-6, 4.5e-6, 0.0),
    "many": StepCost(3.4e-6, 1.0e-5, 1.0e-7),
    "rattling": StepCost(1.3e-6, 1.0e-5, 1.0e-7),
}
"""Time of a step of each model; a disk that rattles is in flight in most steps of "many"."""


class ContactOption(NamedTuple):
    """What a model of the contact costs, and by how much its answer is off.

    Attributes
    ----------
    name : str
        "filter", "two-way filter", "full" or "many".
    motion_error : float
        Predicted relative error of inclination, end and lost energy; 0 for the reference
        "many".
    level_error : float
        Predicted error of the A-weighted level of the table [dB] by its coupling; 0 for
        models with two-way coupling.
    seconds : float
        Predicted processor time [s] of motion and contact force.
    """

    name: OptionName
    motion_error: float
    level_error: float
    seconds: float


def contact_options(plan: "MotionPlan") -> tuple[ContactOption, ...]:
    """Return the models that can solve the elastic contact of a plan; see `ContactOption`.

    There are none for a rigid contact. "two-way filter" requires a rough contact on a
    table of known receptance.
    """
    if plan.tabulated_law is None:
        return ()
    from dynamics.compliant.model_inputs import step_rate
    from dynamics.rattling.rattling_motion import rattling_step_rate

    scene = plan.scene
    rolling = rolling_duration(plan)
    modes = len(plan.surface_modes.frequency) if plan.surface_modes is not None else 0
    samples = FILTER_SAMPLE_RATE * rolling
    one_way_rms, two_way_rms, kappa = _vibration(plan)
    table = plan.rough_table
    options = [
        ContactOption(
            "filter",
            motion_error("filter", one_way_rms, kappa),
            table.level_error if table is not None else 0.0,
            RIGID_MOTION_SECONDS + samples * STEP_SECONDS["filter"].at(0),
        )
    ]
    if table is not None:
        options.append(
            ContactOption(
                "two-way filter",
                motion_error("filter", two_way_rms, kappa),
                0.0,
                RIGID_MOTION_SECONDS + samples * STEP_SECONDS["filter"].at(modes),
            )
        )
    coupled = rolling if table is not None else _coupled_duration(plan, rolling)
    steps = step_rate(scene, plan.final_inclination)
    full = STEP_SECONDS["full"]
    seconds = (rolling - coupled) * full.at(0) + coupled * full.at(modes)
    options.append(
        ContactOption(
            "full", motion_error("full", two_way_rms, kappa), 0.0, steps * seconds
        )
    )
    rattles = plan.contact.kind == "many" and scene.roughness is not None
    duration = rattling_duration(scene) if rattles else rolling
    moving = modes if plan.moving_modes is not None or table is not None else 0
    per_step = STEP_SECONDS["rattling" if rattles else "many"].at(moving)
    seconds = duration * rattling_step_rate(scene) * per_step
    options.append(ContactOption("many", 0.0, 0.0, seconds))
    return tuple(options)


def _vibration(plan: "MotionPlan") -> tuple[float, float, float]:
    """Return the largest rms of N'/weight, one-way and two-way, and curvature number."""
    from dynamics.compliant.model_selection import (
        greatest_curvature_number,
        predicted_force_rms,
    )

    if plan.scene.roughness is None:
        return 0.0, 0.0, 0.0
    kappa, _ = greatest_curvature_number(plan)
    if plan.rough_table is not None:
        one_way = max(error.one_way_rms for error in plan.rough_table.errors)
        return one_way, plan.rough_table.two_way_rms, kappa
    assert plan.tabulated_law is not None  # the contact is elastic
    _, share = predicted_force_rms(plan, plan.tabulated_law)
    rms = float(share.max(initial=0.0))
    return rms, rms, kappa


def rolling_duration(plan: "MotionPlan", from_inclination: float = np.inf) -> float:
    """Return the predicted duration [s] of rolling, at most the time limit of the scene.

    Parameters
    ----------
    plan : MotionPlan
        Plan of the motion.
    from_inclination : float
        Inclination [rad] from which the duration is counted.

    Returns
    -------
    float
        Time in which quasi-steady rolling loses the energy at the release, until the
        disk is flat or carried by the air film.
    """
    sample_count = 60
    min_inclination = 1e-6  # the remaining time is negligible
    max_inclination = 0.6  # for which steady power is evaluated
    scene = plan.scene
    disk = scene.disk
    first = min(
        release_energy(scene) / (1.5 * disk.weight * disk.radius), max_inclination
    )
    last = max(plan.final_inclination, min_inclination)
    if plan.film is not None:
        last = max(last, plan.film_decision.airborne_inclination)
    first = max(min(first, from_inclination), 2 * last)
    beta = np.geomspace(first, last, sample_count)
    power = np.array([steady_power(b, plan.constants, plan.loads) for b in beta])
    if not power.min() > 0:
        return float(scene.numerics.time_limit)
    held = 1.5 * (plan.constants.K + 4) / 4  # energy over inclination
    time = float(np.trapezoid(held / power, -beta)) * disk.time_unit
    return min(time, float(scene.numerics.time_limit))


def release_energy(scene: "MotionScene") -> float:
    """Return the energy [J] of the rigid disk at the release, which rolls without slip."""
    disk = scene.disk
    omega = np.asarray(scene.release.omega, dtype=float)
    lever = np.array([0.0, disk.thickness / 2, disk.radius])
    velocity = np.cross(omega, lever)
    diametral, axial = inertias(disk)
    turning = diametral * (omega[0] ** 2 + omega[2] ** 2) + axial * omega[1] ** 2
    beta = np.radians(scene.release.inclination_deg)
    height = disk.radius * np.sin(beta) - disk.thickness * np.sin(beta / 2) ** 2
    moving = disk.mass * float(velocity @ velocity) + turning
    return float(moving / 2 + disk.weight * height)


def rattling_duration(scene: "MotionScene") -> float:
    """Return the predicted duration [s] of a motion that rattles on a rough table.

    The inclination decreases at the rate k sqrt(g s)/R, with k near 1 - 0.66 e for a
    coefficient of restitution e and an rms height s.
    """
    assert scene.roughness is not None
    disk = scene.disk
    rms = np.hypot(scene.roughness.rms or 0.0, scene.roughness.edge_rms)
    fall = (1 - 0.66 * (scene.contact.restitution or 1.0)) * np.sqrt(GRAVITY * rms)
    return float(disk.radius * np.radians(scene.release.inclination_deg) / fall)


def _coupled_duration(plan: "MotionPlan", rolling: float) -> float:
    """Return the part [s] of `rolling` in which the table is coupled in time steps."""
    if plan.is_two_way_from_release:
        return rolling
    if not plan.switches_to_two_way:
        return 0.0
    return min(rolling, rolling_duration(plan, plan.two_way.inclination))
