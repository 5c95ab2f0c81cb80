"""SCENE -> PLAN: what a run computes and what it leaves out, why, and how wrong that makes it;
decided beforehand."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import pi

import numpy as np

from dynamics import Disk, Motion, Outcome
from dynamics.film.activation import MAX_KNUDSEN, final_inclination
from dynamics.solver_settings import ACCURACY_LEVELS, MAX_AUDIBLE_FREQUENCY, integrator_of
from dynamics.steady_motion import flat_square
from modal import Material, Modes
from sonify.plan.predictions import (
    Prediction,
    predicted_end,
    predicted_frequencies,
    predicted_sound,
)
from sonify.scene import Scene
from sonify.sound.audible_modes import MAX_RING_TIME, RING_DOWN_DB, RingDown
from sonify.sound.force import CALM_STRIDE

MODES_NAMED = 6
"""Modes whose decay is written out."""
ENERGY_SHARE = 0.01
"""A mode that takes this share of the energy of all counts, even where it cannot be heard."""


@dataclass(frozen=True, kw_only=True)
class Decision:
    """What was decided on a `subject`, and why."""

    subject: str
    choice: str
    reason: str


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Decisions in words, and as numbers: `tolerance` and `final_inclination` [rad] of the motion;
    `highest_mode` [Hz] that is sought; `calm` [rad] of the force; `sounding`, the indices of the
    modes that sound, None before they are known.

    `modelled` and `left_out` are sentences on the model; `predictions` are empty for the reference.
    """

    accuracy: str
    tolerance: float
    final_inclination: float
    highest_mode: float
    calm: float
    sounding: tuple[int, ...] | None = None
    decisions: tuple[Decision, ...]
    predictions: tuple[Prediction, ...] = ()
    modelled: tuple[str, ...]
    left_out: tuple[str, ...]

    def __repr__(self):
        """In one line; the sentences are in the fields."""
        count = "" if self.sounding is None else f", {len(self.sounding)} modes sound"
        motion = f"motion to {self.final_inclination:.2g} rad at tolerance {self.tolerance:g}"
        return f"Plan({self.accuracy}: {motion}, modes below {self.highest_mode:g} Hz{count})"

    def also(
        self, *decisions: Decision, modelled: Iterable[str] = (), left_out: Iterable[str] = ()
    ) -> "Plan":
        """Return the plan with these besides."""
        modelled = (*self.modelled, *modelled)
        left_out = (*self.left_out, *left_out)
        return replace(
            self, decisions=(*self.decisions, *decisions), modelled=modelled, left_out=left_out
        )

    def error(self, name: str) -> float:
        """Return the predicted error of that name; of the reference 0, since what it lacks is not
        known from within."""
        return next((p.error for p in self.predictions if p.name == name), 0.0)


def plan_of(scene: Scene) -> Plan:
    """Return the plan of a scene as far as it can be made before its modes are known. What the
    scene sets, stands."""
    numerics = scene.numerics
    heard = min(MAX_AUDIBLE_FREQUENCY, scene.audio.sample_rate / 2)
    integrator = integrator_of(numerics.integrator)
    level = numerics.level
    tolerance = numerics.chosen_tolerance
    final = final_inclination(scene)
    return Plan(
        accuracy=numerics.accuracy,
        tolerance=tolerance,
        final_inclination=final,
        highest_mode=heard,
        calm=level.max_contact_turn,
        decisions=(
            Decision(
                subject="tolerance of the motion",
                choice=f"{tolerance:g}, {integrator}",
                reason=WHY[integrator],
            ),
            Decision(
                subject="where the motion may stop",
                choice=f"at an inclination of {final:.2g} rad",
                reason=why_it_stops(scene, final),
            ),
            Decision(
                subject="instants at which the force is read",
                choice=CALMLY.format(CALM_STRIDE, level.max_contact_turn)
                * bool(level.max_contact_turn)
                + EVERY,
                reason="the solution is smooth between its jumps, and these are known exactly",
            ),
            Decision(
                subject="radiation",
                choice="the upper face in a baffle, at the frequency of every mode",
                reason="the disk is not small against the wavelengths of its modes",
            ),
            damping(scene.material),
        ),
        predictions=() if numerics.accuracy == "reference" else (predicted_end(scene, final),),
        modelled=(CONTACT[scene.support.kind], *HEARD),
        left_out=(
            *LEFT_OUT,
            *WALL[scene.disk.shape],
            f"The sound of modes above {heard:g} Hz.",
            *(NOT_IN_A_DRAFT if numerics.accuracy == "draft" else []),
        ),
    )


def with_sounding(plan: Plan, scene: Scene, modes: Modes, loudness, energy) -> Plan:
    """Return the plan completed by the modes that sound, of those found.

    `loudness` (m,) [Pa^2 s] and `energy` (m,) [J] come from `audible_modes.response_to_unit_jump`.
    A mode sounds if it is within the level's range of the loudest, or holds ENERGY_SHARE of the
    energy."""
    level = ACCURACY_LEVELS[plan.accuracy]
    heard = counted(loudness, energy, level.range_db)
    solver = Decision(
        subject="solver of the modes",
        choice=f"{modes.method}, {modes.unknowns} unknowns for accuracy '{plan.accuracy}'",
        reason=SOLVER[scene.support.kind],
    )
    which = Decision(
        subject="modes that sound",
        choice=f"{len(heard)} of {len(modes.frequency)} below {plan.highest_mode:g} Hz",
        reason=f"the others are predicted more than {level.range_db:g} dB(A) below the loudest, "
        f"in either stem of "
        f"ringing, and hold less than {ENERGY_SHARE:.0%} of the energy"
        if len(heard) < len(modes.frequency)
        else "none is left out",
    )
    plan = replace(plan, sounding=tuple(heard.tolist())).also(solver, which)
    if plan.accuracy == "reference":
        return plan
    further = predicted_frequencies(scene, modes), predicted_sound(scene, modes, loudness)
    return replace(plan, predictions=plan.predictions + further)


def counted(loudness, energy, range_db: float) -> np.ndarray:
    """Return which modes (k,) count: within the range of the loudest, or with ENERGY_SHARE of the
    energy of all."""
    loud = loudness >= 10 ** (-range_db / 10) * loudness.max(initial=0.0)
    return np.flatnonzero((loud | (energy >= ENERGY_SHARE * energy.sum())) & (energy > 0))


def with_end(plan: Plan, motion: Motion, ringing: RingDown, silence: Sequence[str] = ()) -> Plan:
    """Return the plan with how the motion ended, how the modes ring afterwards, and why a sound
    tells nothing."""
    ending = f"The motion ends at t = {motion.t[-1]:.6g} s: {motion.outcome.sentence}."
    return plan.also(ring_down(ringing), modelled=[ending], left_out=[*unsettled(motion), *silence])


def ring_down(ringing: RingDown) -> Decision:
    """Return how fast the modes decay after the end of the motion, and what damps them."""
    rows = zip(ringing.frequency, ringing.decay_rate, ringing.decay_time, strict=True)
    named = [f"{f:.0f} Hz: {d:.3g} 1/s (T60 {t:.2g} s)" for f, d, t in rows]
    if len(named) > MODES_NAMED:
        named = [*named[:MODES_NAMED], f"{len(named) - MODES_NAMED} modes more"]
    own = "by material and radiation"
    if ringing.gap is not None and len(named):
        rates = sorted(
            {f"{rate:.3g}" for rate in (ringing.without_film.min(), ringing.without_film.max())},
            key=float,
        )
        own += f", {' to '.join(rates)} 1/s, and by the film of air at its last mean gap, {1e6 * ringing.gap:.3g} um"
    return Decision(
        subject="decay of the modes after the motion",
        choice="; ".join(named) or "no mode sounds",
        reason=f"{own}; the sound continues until they are {RING_DOWN_DB:g} dB down, at most "
        f"{MAX_RING_TIME:g} s",
    )


def unsettled(motion: Motion) -> list[str]:
    """Return what is missing after a motion that did not reach its end, whose modes ring out
    freely."""
    if motion.outcome.name == "SETTLED":
        return []
    missing = f"The end of the motion and its sound: {motion.outcome.sentence}."
    return [missing, *([AFTERWARDS[motion.outcome]] if motion.outcome in AFTERWARDS else [])]


def damping(material: Material) -> Decision:
    """Return how the modes decay."""
    given = len(material.decay_rates)
    return Decision(
        subject="decay of the modes",
        choice=f"the first {given} as measured, the others " * bool(given)
        + "by loss factor and radiation upwards",
        reason="material.decay_rates"
        if given
        else "some modes lose a third as much to the air as in the material",
    )


def contact_rate(disk: Disk, inclination: float) -> float:
    """Return how often a second the contact of a steady disk goes round at a small inclination
    [rad]."""
    return (
        (flat_square(disk.aspect, disk.gyration) / inclination) ** 0.5 / disk.time_unit / (2 * pi)
    )


def why_it_stops(scene: Scene, final: float) -> str:
    """Return why the motion of a scene may stop at an inclination [rad]."""
    turns = f"the contact turns there {contact_rate(scene.disk, final):.3g} times a second"
    if final > scene.numerics.stopping_inclination(scene.disk):
        gap = scene.disk.radius * np.sin(final)
        return (
            f"{turns}; the mean gap is {gap:.2g} m there, the mean free path of the air "
            f"{scene.air.mean_free_path:.2g} "
            f"m, {MAX_KNUDSEN:g} times as long: no law of the film is known below"
        )
    return f"{turns}; {MAX_AUDIBLE_FREQUENCY:g} Hz is the highest rate that is heard"


WHY = {
    "taylor": "the order of a Taylor series grows with the digits: all of double precision costs "
    "a third more than "
    "half of it, and slips late in the motion amplify what is wrong",
    "dop853": "every digit costs a third more steps; slips late in the motion amplify what is "
    "wrong",
}
CONTACT = {
    "patch": "The elastic modes are those of the disk held at a patch of its rim, which travels "
    "with the contact; the "
    "contact force drives them through the rigid acceleration that it causes.",
    "free": "The elastic modes are those of the free disk; the contact force drives them where "
    "the contact is.",
    "contact": "The elastic modes are those of the disk on the springs of its contact under its "
    "weight, at one "
    "inclination; what keeps the contact point at rest drives them. Where the contact is elastic, "
    "the vibration of the "
    "rigid disk on it is a stem of its own, and only the modes above sound as modes.",
}
SOLVER = {
    "patch": "support.kind = 'patch': the stress is singular at the edge of the patch, which the "
    "mesh follows",
    "free": "support.kind = 'free': the disk has an axis, and shapes without singularities",
    "contact": "support.kind = 'contact': a few springs couple the modes of the free disk, at any "
    "inclination at once",
}
CALMLY = "every {}th sample where the contact turns by less than {:g} rad in between and no jump is near, else "
EVERY = "every sample, and more often where the contact turns faster than samples can hold"
HEARD = (
    "The upper face radiates into the half space above the table (Rayleigh's integral with the "
    "table as baffle): heave "
    "and tilt of the rigid disk, and the elastic modes at their own frequency.",
    "The listener hears the source one travel time of sound later, from a fixed place.",
)
WALL = {
    "solid": (),
    "shell": (
        "The sound of a hoop's cylindrical wall, which its modes in the plane move, and of the "
        "air in its hole: the "
        "upper edge of the wall alone radiates.",
    ),
}
LEFT_OUT = ("The resisting moments and the centrifugal loads as drivers of the modes.",)
AFTERWARDS = {
    Outcome.FELL: "The impact of the face on the table that ends the fall, and all that it would "
    "ring.",
    Outcome.AIRBORNE: "The landing: how the disk that the air carries settles onto the table. The "
    "modes ring out over "
    "the film as it is when the contact is lost. As the disk settles the film closes, which "
    "changes their damping.",
}
"""What follows the motion and is left out, by its outcome."""
NOT_IN_A_DRAFT = (
    "The roughness of the sound, the picture of its causes, and the modes seen at a slant.",
)
