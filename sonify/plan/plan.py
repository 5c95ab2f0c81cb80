"""SCENE -> PLAN: what a run computes and what it leaves out, why, and how wrong that makes it; decided beforehand."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import pi

import numpy as np

from dynamics import Disk, Motion
from dynamics.numerics import HIGHEST_HEARD, LEVELS, integrator_of
from dynamics.steady import flat_square
from modal import Material, Modes
from sonify.plan.predictions import Prediction, predicted_end, predicted_frequencies, predicted_sound
from sonify.scene import Scene
from sonify.sound.force import STRIDE

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
    """Decisions in words, and as numbers: `tolerance` and `final_inclination` [rad] of the motion; `highest_mode` [Hz]
    that is sought; `calm` [rad] of the force; `sounding`, the indices of the modes that sound, None before
    they are known.

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

    def also(self, *decisions: Decision, modelled: Iterable[str] = (), left_out: Iterable[str] = ()) -> "Plan":
        """Return the plan with these besides."""
        modelled, left_out = (*self.modelled, *modelled), (*self.left_out, *left_out)
        return replace(self, decisions=(*self.decisions, *decisions), modelled=modelled, left_out=left_out)

    def error(self, name: str) -> float:
        """Return the predicted error of that name; of the reference 0, since what it lacks is not known from within."""
        return next((p.error for p in self.predictions if p.name == name), 0.0)


def plan_of(scene: Scene) -> Plan:
    """Return the plan of a scene as far as it can be made before its modes are known. What the scene sets, stands."""
    numerics, heard = scene.numerics, min(HIGHEST_HEARD, scene.audio.sample_rate / 2)
    integrator, level = integrator_of(numerics.integrator), numerics.level
    tolerance, final = numerics.chosen_tolerance, numerics.stopping_inclination(scene.disk)
    return Plan(
        accuracy=numerics.accuracy,
        tolerance=tolerance,
        final_inclination=final,
        highest_mode=heard,
        calm=level.calm,
        decisions=(
            Decision(subject="tolerance of the motion", choice=f"{tolerance:g}, {integrator}", reason=WHY[integrator]),
            Decision(
                subject="where the motion may stop",
                choice=f"at an inclination of {final:.2g} rad",
                reason=f"the contact turns there {contact_rate(scene.disk, final):.3g} times a second; "
                f"{HIGHEST_HEARD:g} Hz is the highest rate that is heard",
            ),
            Decision(
                subject="disk and table" if scene.surface.kind == "rigid" else "disk",
                choice="rigid in the motion",
                reason=f"surface.kind = {scene.surface.kind!r}; the elastic modes of a disk only sound",
            ),
            Decision(
                subject="instants at which the force is read",
                choice=CALMLY.format(STRIDE, level.calm) * bool(level.calm) + EVERY,
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
        modelled=(ON_A_PLANE, CONTACT[scene.support.kind], *HEARD),
        left_out=(
            *LEFT_OUT,
            *WALL[scene.disk.shape],
            f"The sound of modes above {heard:g} Hz.",
            *(NOT_IN_A_DRAFT if numerics.accuracy == "draft" else []),
        ),
    )


def with_sounding(plan: Plan, scene: Scene, modes: Modes, loudness, energy) -> Plan:
    """Return the plan completed by the modes that sound, of those found.

    `loudness` (m,) is what each radiates after a unit jump of the force, A-weighted [Pa^2 s]; `energy` (m,) what the
    jump leaves in it [J]: see `audible_modes.after_a_jump`. A mode sounds if it is within the range of the level of the
    loudest, or holds ENERGY_SHARE of the energy.
    """
    level = LEVELS[plan.accuracy]
    heard = counted(loudness, energy, level.range_db)
    solver = Decision(
        subject="solver of the modes",
        choice=f"{modes.method}, {modes.unknowns} unknowns for accuracy '{plan.accuracy}'",
        reason=SOLVER[scene.support.kind],
    )
    which = Decision(
        subject="modes that sound",
        choice=f"{len(heard)} of {len(modes.frequency)} below {plan.highest_mode:g} Hz",
        reason=f"the others are predicted more than {level.range_db:g} dB(A) below the loudest, in either stem of "
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
    """Return which modes (k,) count: within the range of the loudest, or with ENERGY_SHARE of the energy of all."""
    loud = loudness >= 10 ** (-range_db / 10) * loudness.max(initial=0.0)
    return np.flatnonzero((loud | (energy >= ENERGY_SHARE * energy.sum())) & (energy > 0))


def with_end(plan: Plan, motion: Motion, silence: Sequence[str] = ()) -> Plan:
    """Return the plan with how the motion ended, and why a sound tells nothing."""
    ending = f"The motion ends at t = {motion.t[-1]:.6g} s: {motion.outcome.sentence}."
    return plan.also(modelled=[ending], left_out=[*unsettled(motion), *silence])


def unsettled(motion: Motion) -> list[str]:
    """Return what is missing after a motion that did not reach its end, whose modes ring out freely."""
    if motion.outcome.name == "SETTLED":
        return []
    missing = f"The end of the motion and its sound: {motion.outcome.sentence}."
    return [missing, *([IMPACT] if motion.outcome.name == "FELL" else [])]


def damping(material: Material) -> Decision:
    """Return how the modes decay."""
    given = len(material.decay_rates)
    return Decision(
        subject="decay of the modes",
        choice=f"the first {given} as measured, the others " * bool(given) + "by loss factor and radiation upwards",
        reason="material.decay_rates" if given else "some modes lose a third as much to the air as in the material",
    )


def contact_rate(disk: Disk, inclination: float) -> float:
    """Return how often a second the contact of a steady disk goes round at a small inclination [rad]."""
    return (flat_square(disk.aspect, disk.gyration) / inclination) ** 0.5 / disk.time_unit / (2 * pi)


WHY = {
    "taylor": "the order of a Taylor series grows with the digits: all of double precision costs a third more than "
    "half of it, and slips late in the motion amplify what is wrong",
    "dop853": "every digit costs a third more steps; slips late in the motion amplify what is wrong",
}
CONTACT = {
    "patch": "The elastic modes are those of the disk held at a patch of its rim, which travels with the contact; the "
    "contact force drives them through the rigid acceleration that it causes.",
    "free": "The elastic modes are those of the free disk; the contact force drives them where the contact is.",
    "contact": "The elastic modes are those of the disk on the springs of its contact under its weight, at one "
    "inclination; what keeps the contact point at rest drives them. Where the contact is elastic, the vibration of the "
    "rigid disk on it is a stem of its own, and only the modes above sound as modes.",
}
SOLVER = {
    "patch": "support.kind = 'patch': the stress is singular at the edge of the patch, which the mesh follows",
    "free": "support.kind = 'free': the disk has an axis, and shapes without singularities",
    "contact": "support.kind = 'contact': a few springs couple the modes of the free disk, at any inclination at once",
}
CALMLY = "every {}th sample where the contact turns by less than {:g} rad in between and no jump is near, else "
EVERY = "every sample, and more often where the contact turns faster than samples can hold"
HEARD = (
    "The upper face radiates into the half space above the table (Rayleigh's integral with the table as baffle): heave "
    "and tilt of the rigid disk, and the elastic modes at their own frequency.",
    "The listener hears the source one travel time of sound later, from a fixed place.",
)
WALL = {
    "solid": (),
    "shell": (
        "The sound of a hoop's cylindrical wall, which its modes in the plane move, and of the air in its hole: the "
        "upper edge of the wall alone radiates.",
    ),
}
ON_A_PLANE = "A rigid disk rolls and slides on a rigid plane."
NO_ACTION = "Sound of impacts; the action of the elastic modes on the motion."
LEFT_OUT = (
    NO_ACTION,
    "The resisting moments and the centrifugal loads as drivers of the modes.",
)
IMPACT = "The impact of the face on the table that ends the fall, and all that it would ring."
NOT_IN_A_DRAFT = ("The roughness of the sound, the picture of its causes, and the modes seen at a slant.",)
