"""Plan of the contact: its model with reasons and omissions, and the predicted error of
the sound."""

from collections.abc import Callable
from dataclasses import replace
from math import radians

import numpy as np

from dynamics import MotionPlan
from dynamics.compliant.law.unevenness import unevenness
from dynamics.compliant.model_selection import steady_precession_rate
from sonify.plan import sentences
from sonify.plan.plan import Decision, Plan
from sonify.plan.predictions import Prediction
from sonify.scene import Scene


def with_contact(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with the model of the contact at the edge and the predicted error
    of its sound."""
    motion = plan.motion
    kind, reason = motion.contact
    film = motion.film is not None
    rough = scene.roughness
    if kind == "filter":
        reason += f"; {sentences.FILTER_ERROR_REASON}"
    if kind != "rigid" and rough:
        reason += unevenness_clause(motion)
    contact = Decision(subject="contact at the edge", choice=kind, reason=reason)
    modelled = [*sentences.CONTACT_MODELLED[kind]]
    neglected = [*sentences.CONTACT_NEGLECTED[kind]]
    if kind != "rigid":
        if kind == "filter" and rough and (share := motion.roughness_energy_share):
            neglected.append(sentences.ROUGHNESS_LOSS_NEGLECTED.format(share=share))
        bends = scene.contact.body == "elastic" and scene.elastic_edge is not None
        (modelled if bends else neglected).append(bending_sentence(motion))
        if rough:
            modelled.append(sentences.ROUGHNESS_LOSS_MODELLED[rough.loss])
        if not film:
            neglected.append(sentences.HEIGHT_SOUND_NEGLECTED)
        elif kind == "many":
            modelled.append(sentences.RATTLING_FILM_MODELLED)
            neglected.append(sentences.RATTLING_FILM_NEGLECTED)
        else:
            if kind == "full":
                neglected.append(sentences.OPEN_FILM_NEGLECTED)
            modelled.append(sentences.HEIGHT_SOUND_MODELLED)
            neglected.append(sentences.FILM_ACTION_NEGLECTED)
    if rough:
        plan = with_prediction(
            plan, "sound", lambda p: roughness_sound_prediction(p, kind, film)
        )
    return plan.with_additions(contact, modelled=modelled, left_out=neglected)


def with_prediction(
    plan: Plan, key: str, changed: Callable[[Prediction], Prediction]
) -> Plan:
    """Return the plan with `changed` applied to its prediction of a quantity."""
    predictions = (changed(p) if p.key == key else p for p in plan.predictions)
    return replace(plan, predictions=tuple(predictions))


def unevenness_clause(motion: MotionPlan) -> str:
    """Return a clause on the unevenness of table and edge at the release and near the
    end."""
    scene = motion.scene
    assert motion.tabulated_law is not None  # the contact is elastic
    law = motion.tabulated_law.law
    release = radians(scene.release.inclination_deg)
    late = release / 10
    first = unevenness(scene.disk, law, scene.roughness, release)
    last = unevenness(scene.disk, law, scene.roughness, late)
    return (
        f"; the rms height is {first.rms_over_depth:.2g} times the indentation of the contact, and "
        f"the curvature of the heights is {first.curvature_number:.2g} times that of the rim at {release:.2g} rad and "
        f"{last.curvature_number:.2g} times at {late:.2g} rad (contact is lost above a ratio of 0.25 to 0.5)"
    )


def roughness_sound_prediction(
    predicted: Prediction, kind: str, film: bool
) -> Prediction:
    """Return the predicted error of sound samples that are dominated by a rough
    contact.

    The filter yields the same contact sound at every accuracy; only the modes differ.
    In the full model, motions at two accuracies diverge by more than a wavelength of
    the surface. Their sounds are independent noise of equal power, so the relative
    error is sqrt(2)."""
    if kind == "rigid":
        return predicted
    if kind in ("full", "many"):
        return replace(
            predicted,
            error=2**0.5,
            source="the noise of a rough contact depends on the time step",
        )
    # Relative amplitudes of the modes in the scene toy, from tests/plan/test_plan.py; the sound of
    # a disk vibrating on its contact is louder above a film.
    modes = 0.05 if film else 0.25
    return replace(
        predicted,
        error=modes * predicted.error,
        source=f"{predicted.source}; most of the sound comes from the contact",
    )


def bending_sentence(motion: MotionPlan) -> str:
    """Return a sentence on the reduction of the contact resonance by bending of the
    disk.

    The reduction is stated at the release and at a small inclination.
    """
    late_inclination = 0.01  # rad
    scene = motion.scene
    law = motion.tabulated_law
    assert law is not None  # the contact is elastic
    if scene.elastic_edge is None:
        return sentences.SHELL_BENDING_NEGLECTED
    steep = np.radians(scene.release.inclination_deg)
    disk = scene.disk
    beta = np.array([steep, min(late_inclination, steep / 2)])
    speed = disk.radius * np.array([steady_precession_rate(scene, b) for b in beta])
    with_edge, without = (
        (law if edge is law.edge else replace(law, edge=edge))
        .contact_resonance(beta, disk.weight, speed)
        .frequency
        for edge in (scene.elastic_edge, None)
    )
    first, late = 1 - with_edge / without
    return sentences.BENDING_SENTENCE.format(
        first=first, late=late, inclination=beta[1]
    )


RADIATION_ERROR_BOUND_DB = 2.0
"""Maximum error [dB] of the mean-square pressure around a disk that vibrates above a
film.

It applies up to 0.35 rad and for thicknesses of 0.1 to 0.8 radii;
tests/sound/test_open_film_sound.py measures it."""
STEEP_RADIATION_ERROR_RANGE_DB = (-4.0, 6.0)
"""Range of the error [dB] of the mean-square pressure at inclinations from 0.35 to 0.6
rad."""
MAX_SHORT_WAVE_UNDERESTIMATE_DB = 5.0
"""Maximum underestimate [dB] of the mean-square pressure at wavenumbers k R from 4 to
5."""
