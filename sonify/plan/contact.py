"""SCENE -> PLAN of its contact: which model solves it, why, how wrong that makes its sound, and what it leaves out."""

from dataclasses import replace

from dynamics.coupled.choice import choice
from dynamics.film.acting import film_of
from sonify.plan.plan import Decision, Plan
from sonify.plan.predictions import SOUND, Prediction
from sonify.scene import Scene

MODES = 0.25
"""The part of the modes in the sound of a rough contact along a rigid motion, in amplitude: the toy's, measured in
tests/test_plan.py."""
ERROR = "its level is within 10 % of the full model's where the disk rolls, up to 1.9 times too low where it slides"
"""What the filter misses."""


def with_contact(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with how the contact of the edge is solved, and how far its sound will be from the reference."""
    chosen = choice(scene)
    reason = f"{chosen.reason}; {ERROR}" if chosen.kind == "filter" else chosen.reason
    missing = (*LEFT_OUT[chosen.kind], *([NO_FILM] if chosen.kind == "full" and film_of(scene).film else []))
    return replace(
        plan,
        predictions=tuple(rough_sound(p, chosen.kind) if p.name == SOUND else p for p in plan.predictions)
        if scene.roughness
        else plan.predictions,
        decisions=(*plan.decisions, Decision(subject="contact of the edge", choice=chosen.kind, reason=reason)),
        modelled=(*plan.modelled, *MODELLED[chosen.kind]),
        left_out=(*plan.left_out, *missing),
    )


def rough_sound(predicted: Prediction, kind: str) -> Prediction:
    """Return the error of samples of which most are the contact's: a filter gives the same ones at every accuracy, the
    full model a motion that parts from others by more than a wave of the surface, two noises of equal power."""
    if kind == "rigid":
        return predicted
    if kind == "full":
        return replace(predicted, error=2**0.5, source="the noise of a rough contact is another one at every step")
    return replace(predicted, error=MODES * predicted.error, source=f"{predicted.source}; most is the contact's")


BENDS = (
    "That the disk bends at its contact, which lowers the resonance: that of the toy by 3.5 % at 0.1 rad, by 5.6 % at "
    "0.01 rad (support.kind = 'contact')."
)
NO_FILM = "The film of air under the disk in its motion: the full model of the contact is without it."
MODELLED = {
    "rigid": (),
    "filter": (
        "The edge and the table yield (Hertz, Mindlin, Kalker): along the rigid motion a linear filter adds to the "
        "force what heights and jumps of the force excite.",
    ),
    "full": (
        "The edge and the table yield (Hertz, Mindlin, Kalker): the disk moves on this contact, with creep, slip and "
        "losses of contact. Of the sound, what is above half its first resonance is the stem of the contact.",
    ),
}
LEFT_OUT = {
    "rigid": ("Sound of roughness, and the resonance of the contact that it rings.",),
    "filter": (
        "The action of that vibration on the motion: the friction of the scene is meant to hold what roughness takes; "
        "losses of contact; friction that vibrates while the disk slides.",
        BENDS,
    ),
    "full": (
        "Friction that holds the loss by roughness already, as measured friction does, would count it twice: here "
        "roughness takes its energy besides.",
        BENDS,
    ),
}
