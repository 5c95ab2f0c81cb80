"""Claims of the paper on the motion alone, judged with the simplest sufficient model of
a scene.

Sweeps evaluate them for many draws of uncertain quantities, without rendering sound.
"""

from dataclasses import replace

import numpy as np

from dynamics import Motion, Outcome
from dynamics.compliant.law.linear_response import predicted_rms
from dynamics.compliant.model_inputs import reason_against_rattling
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
    greatest_curvature_number,
)
from dynamics.motion_plan import motion_basis
from sonify.claims.contact import (
    contact_conditions,
    last_single_ellipse_time,
    tabulated_law_of,
    vibration_times,
)
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.two_way import (
    ALMOST_FLAT_INCLINATION,
    air_carries_earlier,
    halt_comes_earlier,
    two_way_part,
)
from sonify.scene import Scene


def simplest_scene(scene: Scene) -> Scene:
    """Return the scene with the simplest model that can judge the claims.

    A rattling disk needs the unevenness. Any other disk moves as on a smooth table, with
    the creep of its contact if that is elastic, and the vibration excited by the heights
    is predicted from this motion.
    """
    even = replace(scene, imperfection=None)
    if even.numerics.contact == "many":
        return even
    curvature = greatest_curvature_number(motion_basis(even))[0]
    if curvature > MAX_RELATIVE_CURVATURE_FOR_ROLLING and not reason_against_rattling(
        even
    ):
        return replace(even, numerics=replace(even.numerics, contact="many"))
    return replace(
        scene,
        roughness=None,
        imperfection=None,
        numerics=replace(scene.numerics, contact="full"),
    )


def verdict_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings that follow from the motion of `simplest_scene`."""
    has_single_contact = "contact" in motion.finding_groups
    found = [contact_breaks_before_end(scene, motion), air_carries_disk(motion)]
    if scene.surface.kind != "rigid" and (has_single_contact or not motion.moves_table):
        found.append(table_brings_end_forward(scene, motion))
    found.append(precession_rises(motion))
    if scene.contact.law == "elastic" and has_single_contact:
        found.append(resonance_rises(scene, motion))
    return found


@finding(needs=("scene", "motion", "contact law"), at_least=1.0)
def contact_breaks_before_end(scene: Scene, motion: Motion):
    """The ratio of the greatest inclination at which contact is lost to the final
    inclination.

    Roughness, waves of the surface and vibration of the table may break the contact;
    the ratio is 0 if none does."""
    # Ratio of the inclination at which waves break a damped contact to (n^2 - 1)
    # amplitude/radius
    wavy_loss_ratio = 1.05
    end = max(float(motion.state[-1, 1]), ALMOST_FLAT_INCLINATION)
    vibrates = 0.0
    if motion.contact_losses:
        first = motion.contact_losses[0].t
        is_final = first >= motion.t[-1] - 2e-3
        lifted_by_film = is_final and motion.rolling_outcome is Outcome.AIRBORNE
        if not lifted_by_film:
            vibrates = float(motion.at([max(first, 0.0)])[0, 1])
    waves = scene.imperfection
    wavy = 0.0
    if waves is not None:
        wavy = (
            wavy_loss_ratio * (waves.order**2 - 1) * waves.amplitude / scene.disk.radius
        )
    rough = rough_loss_inclination(scene, motion)
    details = {"rough": rough / end, "wavy": wavy / end, "vibrates": vibrates / end}
    return Measured(max(details.values()), details=details)


def rough_loss_inclination(scene: Scene, motion: Motion) -> float:
    """Return the greatest inclination [rad] at which predicted vibration breaks the
    contact, or 0."""
    predicts = "contact" in motion.finding_groups and scene.contact.law == "elastic"
    if scene.roughness is None or not predicts:
        return 0.0
    inclination, load, speed, _ = contact_conditions(motion, vibration_times(motion))
    tabulated = tabulated_law_of(scene, motion)
    rms = predicted_rms(
        tabulated,
        scene.roughness,
        inclination,
        load,
        speed,
        receptance=motion.plan.contact_receptance,
    )
    return float(inclination[rms > LIFT_OFF_FORCE_RMS * load].max(initial=0.0))


@finding(needs=("motion",), at_least=1.0)
def air_carries_disk(motion: Motion):
    """1 if the motion ends with the disk carried by the air film, otherwise 0."""
    return float(motion.rolling_outcome is Outcome.AIRBORNE)


@finding(needs=("scene", "motion"), at_least=0.05)
def table_brings_end_forward(scene: Scene, motion: Motion):
    """The time [s] by which the vibration of the table brings forward the end of the
    motion."""
    if motion.rolling_outcome is Outcome.AIRBORNE or two_way_part(motion) is None:
        return air_carries_earlier(scene, motion).value
    return halt_comes_earlier(scene, motion).value


@finding(needs=("motion",), at_least=2.0)
def precession_rises(motion: Motion):
    """The ratio of the mean precession rates in the last fiftieth and just before half
    of the duration."""
    end = motion.t[-1]
    turned = motion.at(end * np.array([0.48, 0.5, 0.98, 1.0]))[:, 0]
    return float(abs(turned[3] - turned[2]) / max(abs(turned[1] - turned[0]), 1e-9))


@finding(needs=("scene", "motion", "contact law"), at_least=1.2)
def resonance_rises(scene: Scene, motion: Motion):
    """The ratio of the final to the initial frequency of the contact resonance."""
    last = last_single_ellipse_time(motion)
    inclination, load, speed, _ = contact_conditions(motion, np.array([0.0, last]))
    weight = np.full_like(load, scene.disk.weight)
    tabulated = tabulated_law_of(scene, motion)
    frequency = tabulated.contact_resonance(inclination, weight, speed).frequency
    return float(frequency[1] / frequency[0])
