"""SCENE -> PLAN of the contact: the model with its reason, its error in the sound and its
omissions."""

from dataclasses import replace

import numpy as np

from dynamics.compliant.model_inputs import law_table
from dynamics.compliant.model_selection import (
    choose_contact_model,
    roughness_energy_share,
    steady_rate,
)
from dynamics.film.activation import decide_film
from sonify.plan.plan import Decision, Plan
from sonify.plan.predictions import SOUND, Prediction
from sonify.scene import Scene

MODES, OVER_FILM = 0.25, 0.05
"""Share of the modes in the sound of a rough contact, in amplitude, without and with an air film.

The contact is solved along the rigid motion. The film makes the vibration of the disk louder, which
reduces the share. tests/plan/test_plan.py measures both values on the toy scene."""
ERROR = "its level is within 10 % of the full model's where the disk rolls, up to 1.9 times too low where it slides"
"""Error of the filter against the full contact model."""


def with_contact(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with the model of the edge contact and the predicted error of its sound."""
    chosen = choose_contact_model(scene)
    reason = f"{chosen.reason}; {ERROR}" if chosen.kind == "filter" else chosen.reason
    elastic = chosen.kind != "rigid"
    film = decide_film(scene).film is not None
    bends = [bending(scene)] if elastic else []
    takes = roughness_energy_share(scene) if elastic and scene.roughness else 0.0
    counted = scene.contact.body == "elastic" and scene.edge is not None
    missing = (
        *LEFT_OUT[chosen.kind],
        *([BESIDES.format(takes)] if chosen.kind == "filter" and takes else []),
        *bends[counted:],
        *([BARELY_A_WEDGE] if chosen.kind == "full" and film else []),
        *([ON_THE_CONTACT if film else NO_FILM] if elastic else []),
    )
    counted_once = [TAKES[scene.roughness.loss]] if elastic and scene.roughness else []
    modelled = (
        *MODELLED[chosen.kind],
        *bends[:counted],
        *counted_once,
        *([OVER_A_FILM] if elastic and film else []),
    )
    if scene.roughness:
        rough = (
            rough_sound(p, chosen.kind, film) if p.name == SOUND else p for p in plan.predictions
        )
        plan = replace(plan, predictions=tuple(rough))
    contact = Decision(subject="contact of the edge", choice=chosen.kind, reason=reason)
    return plan.also(contact, modelled=modelled, left_out=missing)


def rough_sound(predicted: Prediction, kind: str, film: bool) -> Prediction:
    """Return the predicted error of the sound samples for a rough contact, which dominates them.

    The filter yields the same contact sound at every accuracy, so that only the modes differ. With
    the full model, motions at two accuracies diverge by more than a wavelength of the surface.
    Their sounds are independent noises of equal power, and the relative error is sqrt(2).
    """
    if kind == "rigid":
        return predicted
    if kind == "full":
        return replace(
            predicted,
            error=2**0.5,
            source="the noise of a rough contact is another one at every step",
        )
    modes = OVER_FILM if film else MODES
    return replace(
        predicted,
        error=modes * predicted.error,
        source=f"{predicted.source}; most is the contact's",
    )


LOW = 0.01
"""Inclination [rad] that represents the late motion."""


def bending(scene: Scene) -> str:
    """Return a sentence on how much bending of the disk lowers the contact resonance."""
    if scene.edge is None:
        return "That the disk bends at its contact, which lowers the resonance: of a shell it is not known."
    steep = np.radians(scene.release.inclination_deg)
    disk = scene.disk
    beta = np.array([steep, min(LOW, steep / 2)])
    speed = disk.radius * np.array([steady_rate(disk, b) for b in beta])
    with_edge, without = (
        law_table(scene.replace(f"contact.body={body}")).carrier(beta, disk.weight, speed).frequency
        for body in ("elastic", "rigid")
    )
    first, late = 1 - with_edge / without
    return (
        f"The disk bends at its contact, in series with the springs, which lowers the resonance "
        f"by {first:.1%} at the "
        f"release and by {late:.1%} at {beta[1]:.2g} rad."
    )


BARELY_A_WEDGE = (
    "That the film is open where the contact is lost for an instant: it acts as a wedge that "
    "closes there, at the "
    "velocity of the face where its pressure has its resultant."
)
MODELLED = {
    "rigid": (),
    "filter": (
        "The edge and the table yield (Hertz, Mindlin, Kalker): along the rigid motion a linear "
        "filter adds to the "
        "force what heights and jumps of the force excite.",
    ),
    "full": (
        "The edge and the table yield (Hertz, Mindlin, Kalker): the disk moves on this contact, "
        "with creep, slip and "
        "losses of contact. Of the sound, what is above half its first resonance is the stem of "
        "the contact.",
    ),
}
LEANING, STEEP, THICK = 2.0, (-4.0, 6.0), 5.0
"""Errors [dB] of the radiation of a vibrating disk over a film, in mean square around the disk.

LEANING is the largest error up to 0.35 rad and STEEP the range of errors up to 0.6 rad, both for
thicknesses of 0.1 to 0.8 radii. THICK is the largest underestimate between k R = 4 and 5. The
values come from test_sound_open_film.py."""
OVER_A_FILM = (
    "The disk that vibrates on its contact radiates with its height, over the film and what flows "
    "out of it: within "
    "0.5 dB of an even gap and the air outside solved as one; where the disk leans, and is 0.1 to "
    "0.8 radii thick, "
    f"within {LEANING:g} dB up to 0.35 rad and k R = 4, 5.8 kHz for a disk of 75 mm; at 0.6 rad "
    f"off by {STEEP[0]:g} to "
    f"{STEEP[1]:+g} dB, too loud above k R = 2; from k R = 4 to 5 a thick disk is up to {THICK:g} "
    f"dB too quiet. Above "
    "k R = 6 it is as there."
)
NO_FILM = "In the stem of the contact, the height of the disk: it sounds as a face in the plane of the table."
ON_THE_CONTACT = (
    "The action of the film on the vibration of the disk on its contact, but for its sound."
)
LEFT_OUT = {
    "rigid": ("Sound of roughness, and the resonance of the contact that it rings.",),
    "filter": (
        "The action of that vibration on the motion; losses of contact; friction that vibrates "
        "while the disk slides.",
    ),
    "full": (),
}
BESIDES = "What roughness takes besides friction, {:.1%} of the energy: the motion is that of a smooth contact."
TAKES = {
    "own": "Roughness takes its energy besides the friction of the scene (roughness.loss = 'own').",
    "fitted": "The friction of the scene, measured on such a surface, holds what roughness takes: "
    "it is counted once "
    "(roughness.loss = 'fitted').",
}
