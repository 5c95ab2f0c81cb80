"""Claims of the paper on a motion, judged with the simplest sufficient model of a scene.

Sweeps evaluate them for many draws of uncertain quantities. Only the last seconds of the
sound are computed, for its level.
"""

from dataclasses import replace

import numpy as np

from dynamics import Motion, Outcome
from dynamics.compliant.model_inputs import reason_against_rattling
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
    greatest_curvature_number,
)
from dynamics.motion_plan import motion_basis
from sonify.claims.air import carried_by_air, lift_exceeds_contact_since
from sonify.claims.contact import (
    contact_conditions,
    force_rms_along_motion,
    last_single_ellipse_time,
    receptance_under_roughness,
    tabulated_law_of,
)
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.landing import one_impact_ends_it
from sonify.claims.limits import ALMOST_FLAT_INCLINATION
from sonify.claims.loss_causes import loss_cause_findings, wave_inclination
from sonify.claims.rattling import impacts_end_it
from sonify.claims.two_way import (
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
    """Return the findings that follow from the motion of `simplest_scene`.

    `motion` is the whole motion, with its landing. A disk that rattles until it lies flat
    has no rolling contact that the air could lift."""
    rolling = motion.rolling
    has_single_contact = "contact" in rolling.finding_groups
    rattles = "rattling" in rolling.finding_groups
    found = [
        contact_breaks_before_end(scene, rolling),
        *loss_cause_findings(scene, rolling),
    ]
    if not rattles:
        found.append(air_carries_disk(rolling))
    if rolling.film and "air" in rolling.finding_groups:
        found.append(carried_by_air(rolling, rolling.film))
    if scene.surface.kind != "rigid" and (
        has_single_contact or not rolling.moves_table
    ):
        found.append(table_brings_end_forward(scene, rolling))
    found.append(precession_rises(rolling))
    if scene.contact.law == "elastic" and has_single_contact:
        found.append(resonance_rises(scene, rolling))
    if rattles:
        found.append(impacts_end_it(rolling))
    if motion.outcome is Outcome.AT_REST:
        found.append(one_impact_ends_it(motion))
    return found


@finding(needs=("scene", "motion", "contact law"), at_least=1.0)
def contact_breaks_before_end(scene: Scene, motion: Motion) -> Measured:
    """The ratio of the greatest inclination at which contact is lost to the final
    inclination.

    Roughness, waves of the surface and vibration of the table may break the contact;
    the ratio is 0 if none does."""
    end = max(float(motion.state[-1, 1]), ALMOST_FLAT_INCLINATION)
    vibrates = 0.0
    if motion.contact_losses:
        first = motion.contact_losses[0].t
        lifted_by_film = (
            motion.rolling_outcome is Outcome.AIRBORNE
            and motion.film is not None
            and first >= lift_exceeds_contact_since(motion, motion.film)
        )
        if not lifted_by_film:
            vibrates = float(motion.at([max(first, 0.0)])[0, 1])
    wavy = wave_inclination(scene)
    rough = contact_loss_inclination(scene, motion)
    details = {"rough": rough / end, "wavy": wavy / end, "vibrates": vibrates / end}
    return Measured(max(details.values()), details=details)


def contact_loss_inclination(scene: Scene, motion: Motion) -> float:
    """Return the greatest inclination [rad] at which predicted vibration breaks the
    contact on the yielding table, or 0."""
    predicts = "contact" in motion.finding_groups and scene.contact.law == "elastic"
    if scene.roughness is None or not predicts:
        return 0.0
    receptance = receptance_under_roughness(scene, motion)
    inclination, load, rms, _ = force_rms_along_motion(scene, motion, receptance)
    return float(inclination[rms > LIFT_OFF_FORCE_RMS * load].max(initial=0.0))


@finding(needs=("motion",), at_least=1.0)
def air_carries_disk(motion: Motion) -> float:
    """1 if the motion ends with the disk carried by the air film, otherwise 0."""
    return float(motion.rolling_outcome is Outcome.AIRBORNE)


@finding(needs=("scene", "motion"), at_least=0.05)
def table_brings_end_forward(scene: Scene, motion: Motion) -> float:
    """The time [s] by which the vibration of the table brings forward the end of the
    motion."""
    if motion.rolling_outcome is Outcome.AIRBORNE or two_way_part(motion) is None:
        return air_carries_earlier(scene, motion).value
    return halt_comes_earlier(scene, motion).value


@finding(needs=("motion",), at_least=2.0)
def precession_rises(motion: Motion) -> float:
    """The ratio of the greatest mean precession rate in a fiftieth of the duration, after
    half of it, to that just before.

    The greatest rate is that at the end, unless the disk comes to rest within the motion."""
    turned = motion.at(motion.t[-1] * np.linspace(0.48, 1.0, 27))[:, 0]
    turns = np.abs(np.diff(turned))
    return float(turns[1:].max() / max(turns[0], 1e-9))


@finding(needs=("scene", "motion", "contact law"), at_least=1.2)
def resonance_rises(scene: Scene, motion: Motion) -> float:
    """The ratio of the final to the initial frequency of the contact resonance."""
    last = last_single_ellipse_time(motion)
    inclination, load, speed, _ = contact_conditions(motion, np.array([0.0, last]))
    weight = np.full_like(load, scene.disk.weight)
    tabulated = tabulated_law_of(scene, motion)
    frequency = tabulated.contact_resonance(inclination, weight, speed).frequency
    return float(frequency[1] / frequency[0])
