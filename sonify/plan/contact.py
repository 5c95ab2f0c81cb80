"""SCENE -> PLAN of its contact: which model solves it, why, how wrong that makes its sound, and what it leaves out."""

from dataclasses import replace

from dynamics.coupled.choice import Choice, choice
from dynamics.film.acting import film_of
from sonify.plan.plan import Decision, Plan
from sonify.plan.predictions import Prediction
from sonify.scene import Scene

CONTACT = "level of the sound of the contact"
ROLLS, SLIDES = 0.1, 0.9
"""What the filter misses of it against the full model, relative: where the disk rolls; at most, where it slides."""


def with_contact(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with how the contact of the edge is solved."""
    chosen = choice(scene)
    decision = Decision(subject="contact of the edge", choice=chosen.kind, reason=chosen.reason)
    predictions = plan.predictions + (() if plan.accuracy == "reference" else filtered(chosen))
    missing = (*LEFT_OUT[chosen.kind], *([NO_FILM] if chosen.kind == "full" and film_of(scene).film else []))
    return replace(
        plan,
        decisions=(*plan.decisions, decision),
        predictions=predictions,
        modelled=(*plan.modelled, *MODELLED[chosen.kind]),
        left_out=(*plan.left_out, *missing),
    )


def filtered(chosen: Choice) -> tuple[Prediction, ...]:
    """Return how far the filter is predicted to be from the full model; nothing where there is no filter."""
    if chosen.kind != "filter":
        return ()
    source = f"measured: {ROLLS:.0%} where the disk rolls, up to a factor of {1 + SLIDES:g} too low where it slides"
    return (Prediction(name=CONTACT, error=ROLLS, unit="relative", source=source),)


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
