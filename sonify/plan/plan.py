"""SCENE -> PLAN: the models, omissions and predicted errors of a run, decided in advance."""

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
"""Number of modes listed with their decay."""
ENERGY_SHARE = 0.01
"""A mode with at least this share of the total energy is kept even if it is inaudible."""


@dataclass(frozen=True, kw_only=True)
class Decision:
    """The choice made on a `subject`, with its reason."""

    subject: str
    choice: str
    reason: str


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Decisions of a run, in words and as numbers.

    Parameters
    ----------
    accuracy : str
        "draft", "standard" or "reference".
    tolerance : float
        Relative tolerance of the motion.
    final_inclination : float
        Inclination at which the motion may stop [rad].
    highest_mode : float
        Upper frequency limit of the modes [Hz].
    calm : float
        Largest turn of the contact between two evaluations of a smooth force [rad].
    sounding : tuple of int, or None
        Indices of the modes that sound; None before the modes are known.
    decisions : tuple of Decision
        Choices and their reasons.
    predictions : tuple of Prediction
        Predicted errors relative to the accuracy "reference"; empty for the reference itself.
    modelled, left_out : tuple of str
        Sentences on the model and on its omissions.
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
        """Return a one-line summary; the fields hold the sentences."""
        count = "" if self.sounding is None else f", {len(self.sounding)} modes sound"
        motion = f"motion to {self.final_inclination:.2g} rad at tolerance {self.tolerance:g}"
        return f"Plan({self.accuracy}: {motion}, modes below {self.highest_mode:g} Hz{count})"

    def also(
        self, *decisions: Decision, modelled: Iterable[str] = (), left_out: Iterable[str] = ()
    ) -> "Plan":
        """Return the plan with these decisions and sentences added."""
        modelled = (*self.modelled, *modelled)
        left_out = (*self.left_out, *left_out)
        return replace(
            self, decisions=(*self.decisions, *decisions), modelled=modelled, left_out=left_out
        )

    def error(self, name: str) -> float:
        """Return the predicted error of that name; 0 if there is none, as for the reference."""
        return next((p.error for p in self.predictions if p.name == name), 0.0)


def plan_of(scene: Scene) -> Plan:
    """Return the plan of a scene before its modes are known.

    Settings of the scene take precedence.
    """
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
    """Return the plan with the selection of the modes that sound.

    `loudness` (m,) [Pa^2 s] and `energy` (m,) [J] come from `audible_modes.response_to_unit_jump`.
    A mode sounds if its loudness is within `range_db` of the loudest one, or if its energy is at
    least ENERGY_SHARE of the total.
    """
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
    """Return the indices (k,) of the modes that sound.

    They are within `range_db` [dB] of the loudest mode, or have at least ENERGY_SHARE of the total
    energy.
    """
    loud = loudness >= 10 ** (-range_db / 10) * loudness.max(initial=0.0)
    return np.flatnonzero((loud | (energy >= ENERGY_SHARE * energy.sum())) & (energy > 0))


def with_end(plan: Plan, motion: Motion, ringing: RingDown, silence: Sequence[str] = ()) -> Plan:
    """Return the plan with the end of the motion and the decay of the modes.

    `silence` lists the reasons why the sound permits no claim.
    """
    ending = f"The motion ends at t = {motion.t[-1]:.6g} s: {motion.outcome.sentence}."
    return plan.also(ring_down(ringing), modelled=[ending], left_out=[*unsettled(motion), *silence])


def ring_down(ringing: RingDown) -> Decision:
    """Return the decision on the decay of the modes after the motion, with rates and causes."""
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
    """Return sentences on the omissions of a motion that did not settle."""
    if motion.outcome.name == "SETTLED":
        return []
    missing = f"The end of the motion and its sound: {motion.outcome.sentence}."
    return [missing, *([AFTERWARDS[motion.outcome]] if motion.outcome in AFTERWARDS else [])]


def damping(material: Material) -> Decision:
    """Return the decision on the damping of the modes: measured decay rates or a loss factor."""
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
    """Return the precession frequency [Hz] of the steady motion at a small inclination [rad]."""
    return (
        (flat_square(disk.aspect, disk.gyration) / inclination) ** 0.5 / disk.time_unit / (2 * pi)
    )


def why_it_stops(scene: Scene, final: float) -> str:
    """Return the reason why the motion of a scene may stop at an inclination [rad]."""
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
"""Omitted events after the motion, by outcome."""
NOT_IN_A_DRAFT = (
    "The roughness of the sound, the picture of its causes, and the modes seen at a slant.",
)
