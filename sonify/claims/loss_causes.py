"""Findings on what breaks the contact: vibration of the disk on its contact, vibration of
the table, unevenness alone, and the air (`carried_by_air`).

Each cause has one finding, with the same key in runs and sweeps; a cause that a scene
excludes, such as unevenness on a plane table, has none. Vibration is elastic vibration,
whatever excites it."""

from collections.abc import Callable
from functools import cache, partial
from math import hypot

import numpy as np

from dynamics import Motion, Outcome
from dynamics.compliant.law.table_receptance import RIGID_TABLE, TableReceptance
from dynamics.compliant.law.unevenness import unevenness
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
)
from dynamics.contact_losses import ContactLoss
from sonify.claims.air import carried_by_air, lift_exceeds_contact_since
from sonify.claims.contact import (
    MIN_OPEN_SHARE,
    force_rms_along_motion,
    receptance_under_roughness,
)
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.limits import ALMOST_FLAT_INCLINATION, CERTAIN_LOSS_FORCE_RMS
from sonify.claims.rattling import open_share_without_modes
from sonify.claims.two_way import (
    losses_above_flat,
    table_breaks_contact,
    two_way_part,
    two_way_start,
)
from sonify.scene import Scene

ForceRmsPair = tuple[tuple[float, float], tuple[float, float]]
"""Greatest rms of the vibration of the normal force over the weight, with its error, on the
table of a scene and on a rigid table."""
FORCE_RMS_LIMIT = (LIFT_OFF_FORCE_RMS + CERTAIN_LOSS_FORCE_RMS) / 2
"""Rms of N'/weight at which a vibration breaks the contact, in the middle of its range."""
FORCE_RMS_MARGIN = (CERTAIN_LOSS_FORCE_RMS - LIFT_OFF_FORCE_RMS) / 2
"""Half the range of this limit."""
WAVE_LOSS_INCLINATION_RATIO = 1.05
"""Inclination at which waves of the order n break a damped contact, divided by (n^2 - 1)
amplitude/radius; 1.00 to 1.06 in simulations, 1.15 with little damping."""


def loss_cause_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings on the causes that may break the contact of a motion.

    The vibration of a disk on a rigid contact is not part of the motion. That of the air
    belongs to `sonify.claims.air`, except for a rattling disk."""
    found = []
    predicted = cache(partial(force_rms_with_errors, scene, motion))
    if scene.contact.law == "elastic" and motion.finding_groups:
        if "contact" in motion.finding_groups or "rattling" in motion.finding_groups:
            found.append(vibration_opens_contact(scene, motion, predicted))
        if scene.roughness is not None or scene.imperfection is not None:
            found.append(unevenness_breaks_contact(scene, motion))
    if scene.surface.kind != "rigid" and not is_judged_by_reruns(motion):
        vibration = table_vibration(scene, motion, predicted)
        found.append(table_breaks_contact(motion, vibration))
    if motion.film and "air" not in motion.finding_groups:
        found.append(carried_by_air(motion, motion.film))
    return found


def is_judged_by_reruns(motion: Motion) -> bool:
    """Return True if the motion is repeated with other time steps, so that
    `sonify.claims.two_way` judges what the table does to the contact."""
    is_two_way = two_way_part(motion) is not None
    return (
        is_two_way
        and motion.rolling_outcome.lies_flat
        and "two-way" in motion.finding_groups
    )


@finding(needs=("scene", "motion", "contact law"), at_least=0.5)
def vibration_opens_contact(
    scene: Scene, motion: Motion, predicted: Callable[[], ForceRmsPair] | None = None
) -> Measured:
    """The greatest rms of the predicted vibration of the normal force over the weight,
    without what the table adds to it.

    For a solved contact, it is the share of the time without contact where neither the
    geometry nor the table breaks it; for a rattling disk, the share of the open time
    that vanishes in a motion without the modes of the disk. `predicted` returns
    `force_rms_with_errors`, which it may have computed for another finding."""
    if "rattling" in motion.finding_groups:
        return open_share_without_modes(scene, motion)
    if solves_heights(scene, motion):
        return open_share_by_vibration(scene, motion)
    if scene.roughness is None:
        return measured_force_rms(0.0, 0.0)
    predicted = predicted or partial(force_rms_with_errors, scene, motion)
    return measured_force_rms(*min(predicted()))


def force_rms_with_errors(scene: Scene, motion: Motion) -> ForceRmsPair:
    """Return `greatest_force_rms` on the table of a scene and on a rigid table."""
    receptance = receptance_under_roughness(scene, motion)
    of_both = greatest_force_rms(scene, motion, receptance)
    if receptance is RIGID_TABLE:
        return of_both, of_both
    return of_both, greatest_force_rms(scene, motion, RIGID_TABLE)


def measured_force_rms(rms: float, error: float) -> Measured:
    """Return the rms of a vibration of the normal force over the weight, with its
    error."""
    return Measured(
        rms,
        hypot(FORCE_RMS_MARGIN, error),
        {"force_rms": rms},
        variant="predicted",
        fields={"at_least": FORCE_RMS_LIMIT},
    )


def solves_heights(scene: Scene, motion: Motion) -> bool:
    """Return True if the motion solves its contact on the heights of the scene."""
    solved = motion.plan.scene
    return motion.solves_contact and (
        (solved.roughness, solved.imperfection) == (scene.roughness, scene.imperfection)
    )


def greatest_force_rms(
    scene: Scene, motion: Motion, receptance: TableReceptance
) -> tuple[float, float]:
    """Return the greatest rms of the predicted vibration of the normal force over the
    weight, and its error."""
    relative_errors = {True: 0.1, False: 0.9}  # for rolling and for sliding
    _, _, rms, rolls = force_rms_along_motion(scene, motion, receptance)
    most = int(np.argmax(rms))
    ratio = float(rms[most]) / scene.disk.weight
    return ratio, relative_errors[bool(rolls[most])] * ratio


def open_share_by_vibration(scene: Scene, motion: Motion) -> Measured:
    """Return the share of the time without contact above the inclinations at which the
    geometry breaks it, before the table acts and before the air lifts the disk.

    The margin assumes that the losses are independent events."""
    end = float(motion.t[-1])
    lasts = np.array([loss.duration for loss in losses_of_disk(scene, motion)])
    share = float(lasts.sum()) / end
    margin = 2 * float(np.sqrt(np.sum(lasts**2))) / end
    return Measured(
        share,
        margin,
        {"open_by_vibration": share},
        variant="solved",
        fields={"at_least": MIN_OPEN_SHARE},
    )


def losses_of_disk(scene: Scene, motion: Motion) -> list[ContactLoss]:
    """Return the losses of contact that neither unevenness nor table nor air explains.

    The air explains those of a disk that it lifts more than the contact does."""
    losses = list(motion.contact_losses)
    if not losses:
        return []
    until = float(motion.t[-1])
    if motion.rolling_outcome is Outcome.AIRBORNE and motion.film is not None:
        until = lift_exceeds_contact_since(motion, motion.film)
    coupled = two_way_part(motion)
    if coupled is not None:
        part, begin = coupled
        until = min(until, begin + two_way_start(part))
    inclination = motion.at(np.array([max(loss.t, 0.0) for loss in losses]))[:, 1]
    lowest = max(wave_inclination(scene), ALMOST_FLAT_INCLINATION)
    return [
        loss
        for loss, beta in zip(losses, inclination, strict=True)
        if loss.t < until and beta > lowest
    ]


def wave_inclination(scene: Scene) -> float:
    """Return the inclination [rad] below which waves of the table break the contact of a
    disk without vibration, or 0.

    There the rim no longer fits into a trough."""
    waves = scene.imperfection
    if waves is None:
        return 0.0
    slope = (waves.order**2 - 1) * waves.amplitude / scene.disk.radius
    return float(WAVE_LOSS_INCLINATION_RATIO * slope)


@finding(needs=("scene", "motion", "contact law"), at_least=1.0)
def unevenness_breaks_contact(scene: Scene, motion: Motion) -> Measured:
    """The greatest curvature of the heights under the tilted rim, over that at which a
    disk without vibration leaves them.

    For waves it is the ratio of `wave_inclination` to the final inclination, for
    roughness that of the curvature number, in which the contact under the weight covers
    the short waves, to the middle of the range at which contact is first lost."""
    greatest_first_loss = 0.5  # curvature number
    first_loss = (MAX_RELATIVE_CURVATURE_FOR_ROLLING + greatest_first_loss) / 2
    relative_margins = {
        "waves": 0.1,
        "roughness": greatest_first_loss / first_loss - 1,
    }
    first = float(motion.state[0, 1])
    last = max(float(motion.state[-1, 1]), ALMOST_FLAT_INCLINATION)
    ratios = {
        "waves": wave_inclination(scene) / last,
        "roughness": curvature_of_roughness(scene, first, last) / first_loss,
    }
    largest = max(ratios, key=lambda name: ratios[name])
    value = ratios[largest]
    return Measured(value, relative_margins[largest] * value, ratios)


def curvature_of_roughness(scene: Scene, first: float, last: float) -> float:
    """Return the greatest curvature number of the roughness between two inclinations
    [rad]."""
    inclination_count = 16
    if scene.roughness is None:
        return 0.0
    law = contact_law(scene)
    return max(
        unevenness(scene.disk, law, scene.roughness, float(beta)).curvature_number
        for beta in np.geomspace(first, last, inclination_count)
    )


def table_vibration(
    scene: Scene, motion: Motion, predicted: Callable[[], ForceRmsPair]
) -> Measured:
    """Return what the vibration of the table does to the contact in a motion that is not
    repeated.

    With a two-way filter, it is the part of the predicted vibration of the force that
    the table adds; in time steps, the number of losses of contact while the table acts.
    """
    coupled = two_way_part(motion)
    if coupled is not None:
        part, begin = coupled
        since = begin + two_way_start(part)
        count = losses_above_flat(motion, since)
        doubt = "not repeated with other time steps" if count else ""
        return Measured(count, undecided_because=doubt)
    is_rigid = receptance_under_roughness(scene, motion) is RIGID_TABLE
    is_rough = scene.roughness is not None and scene.contact.law == "elastic"
    if is_rough and not is_rigid and "contact" in motion.finding_groups:
        (of_both, error), (of_disk, _) = predicted()
        added = max(of_both**2 - of_disk**2, 0.0) ** 0.5
        return measured_force_rms(added, error)
    if scene.surface.action == "sound":
        return Measured(0.0, undecided_because="the table does not act on this motion")
    return Measured(0.0)
