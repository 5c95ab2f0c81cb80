"""Models, omissions and predicted errors of a run, determined in advance."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace
from math import pi
from typing import Any

import numpy as np

from dynamics import Disk, Motion, MotionPlan, plan_motion
from dynamics.film.activation import END_KNUDSEN_NUMBER
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY, resolved_integrator_name
from dynamics.steady_motion import squared_rate_times_inclination
from modal import Material, Modes, SurfaceModes
from sonify.plan import sentences
from sonify.plan.predictions import (
    Prediction,
    predicted_end_error,
    predicted_frequency_error,
    predicted_sound_error,
)
from sonify.scene import Scene
from sonify.sound.audible_modes import MAX_RING_TIME, RING_DOWN_DB, RingDown
from sonify.sound.force import INTERPOLATION_STRIDE

MIN_MODE_ENERGY_SHARE = 0.01
"""Minimum share of the total energy for which an inaudible mode is kept."""


@dataclass(frozen=True, kw_only=True)
class Decision:
    """Choice for a `subject` of the model, with its reason."""

    subject: str
    choice: str
    reason: str


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Decisions on a run, as numbers and sentences.

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
    max_contact_turn : float
        Largest rotation of the contact between two evaluations of a smooth force [rad].
    sounding : tuple of int, or None
        Indices of the rendered modes; None before the modes are known.
    sounding_table : tuple of int
        Indices of the rendered modes of the table.
    decisions : tuple of Decision
        Choices and their reasons.
    predictions : tuple of Prediction
        Predicted errors relative to the accuracy "reference"; empty for the reference
        itself.
    modelled, left_out : tuple of str
        Sentences on the model and on its omissions.
    motion : MotionPlan
        The decisions of the motion, which the sentences describe.
    """

    accuracy: str
    tolerance: float
    final_inclination: float
    highest_mode: float
    max_contact_turn: float
    sounding: tuple[int, ...] | None = None
    sounding_table: tuple[int, ...] = ()
    decisions: tuple[Decision, ...]
    predictions: tuple[Prediction, ...] = ()
    modelled: tuple[str, ...]
    left_out: tuple[str, ...]
    motion: MotionPlan

    def __repr__(self) -> str:
        """Return a one-line summary without the sentences."""
        count = "" if self.sounding is None else f", {len(self.sounding)} modes sound"
        motion = f"motion to {self.final_inclination:.2g} rad at tolerance {self.tolerance:g}"
        return f"Plan({self.accuracy}: {motion}, modes below {self.highest_mode:g} Hz{count})"

    def with_additions(
        self,
        *decisions: Decision,
        modelled: Iterable[str] = (),
        left_out: Iterable[str] = (),
    ) -> "Plan":
        """Return the plan with these decisions and sentences added."""
        return replace(
            self,
            decisions=self.decisions + decisions,
            modelled=(*self.modelled, *modelled),
            left_out=(*self.left_out, *left_out),
        )

    def rendered_table(self, table: SurfaceModes | None) -> SurfaceModes | None:
        """Return the rendered modes of a table, or None without a table."""
        return None if table is None else table.select(self.sounding_table)

    def record(self) -> dict[str, Any]:
        """Return the plan for run.json, without the decisions of the motion."""
        texts = {"decisions": [vars(decision) for decision in self.decisions]}
        texts["predictions"] = [vars(prediction) for prediction in self.predictions]
        names = [field.name for field in fields(self) if field.name != "motion"]
        return {name: texts.get(name, vars(self)[name]) for name in names}

    def error(self, key: str) -> float:
        """Return the predicted error of a quantity, or 0 without a prediction."""
        return next((p.error for p in self.predictions if p.key == key), 0.0)


def highest_mode_of(scene: Scene) -> float:
    """Return the upper frequency limit [Hz] of the modes of disk and table."""
    return min(MAX_AUDIBLE_FREQUENCY, scene.audio.sample_rate / 2)


def plan_of(scene: Scene, motion: MotionPlan | None = None) -> Plan:
    """Return the plan of a scene before its modes are known.

    Explicit settings of the scene take precedence over those of the accuracy level. The
    decisions of the motion are made here if they are not given.
    """
    motion = motion or plan_motion(scene)
    numerics = scene.numerics
    heard = highest_mode_of(scene)
    integrator = resolved_integrator_name(numerics.integrator)
    level = numerics.level
    tolerance = numerics.chosen_tolerance
    final = motion.final_inclination
    sampling = sentences.DENSE_SAMPLING
    if level.max_contact_turn:
        sampling = sentences.SPARSE_SAMPLING.format(
            stride=INTERPOLATION_STRIDE, turn=level.max_contact_turn
        )
    return Plan(
        accuracy=numerics.accuracy,
        tolerance=tolerance,
        final_inclination=final,
        highest_mode=heard,
        max_contact_turn=level.max_contact_turn,
        decisions=(
            Decision(
                subject="tolerance of the motion",
                choice=f"{tolerance:g}, {integrator}",
                reason=sentences.INTEGRATOR_REASONS[integrator],
            ),
            Decision(
                subject="stopping condition of the motion",
                choice=f"at an inclination of {final:.2g} rad",
                reason=end_condition_reason(scene, final),
            ),
            Decision(
                subject="sampling of the force",
                choice=sampling,
                reason=sentences.SAMPLING_REASON,
            ),
            Decision(
                subject="radiation",
                choice=sentences.RADIATION_CHOICE,
                reason=sentences.RADIATION_REASON,
            ),
            damping_decision(scene.material),
        ),
        predictions=()
        if numerics.accuracy == "reference"
        else (predicted_end_error(motion),),
        modelled=(
            sentences.SUPPORT_MODELLED[scene.support.kind],
            *sentences.RADIATION_MODELLED,
        ),
        left_out=(
            *sentences.ALWAYS_NEGLECTED,
            *sentences.WALL_SOUND_NEGLECTED[scene.disk.shape],
            sentences.MODES_ABOVE_NEGLECTED.format(frequency=heard),
            *(sentences.NEGLECTED_IN_DRAFT if numerics.accuracy == "draft" else []),
        ),
        motion=motion,
    )


def with_sounding_modes(
    plan: Plan,
    scene: Scene,
    modes: Modes,
    loudness: np.ndarray,
    energy: np.ndarray,
) -> Plan:
    """Return the plan with the selection of the rendered modes.

    `loudness` (m,) [Pa^2 s] and `energy` (m,) [J] come from
    `audible_modes.response_to_unit_jump`. A mode is rendered if its loudness is within
    `range_db` of the loudest one, or if its energy is at least MIN_MODE_ENERGY_SHARE of
    the total."""
    level = scene.numerics.level
    heard = audible_mode_indices(loudness, energy, level.range_db)
    solver = Decision(
        subject="solver of the modes",
        choice=f"{modes.method}, {modes.unknowns} unknowns for accuracy '{plan.accuracy}'",
        reason=sentences.SOLVER_REASONS[scene.support.kind],
    )
    which = Decision(
        subject="rendered modes",
        choice=f"{len(heard)} of {len(modes.frequency)} below {plan.highest_mode:g} Hz",
        reason=f"the others are predicted to be more than {level.range_db:g} dB(A) below the "
        f"loudest in both stems of the modes, and have less than {MIN_MODE_ENERGY_SHARE:.0%} of the energy"
        if len(heard) < len(modes.frequency)
        else sentences.ALL_MODES_SOUND_REASON,
    )
    plan = replace(plan, sounding=tuple(heard.tolist())).with_additions(solver, which)
    if plan.accuracy == "reference":
        return plan
    further = (
        predicted_frequency_error(scene, modes),
        predicted_sound_error(scene, modes, loudness),
    )
    return replace(plan, predictions=plan.predictions + further)


def audible_mode_indices(
    loudness: np.ndarray, energy: np.ndarray, range_db: float
) -> np.ndarray:
    """Return the indices (k,) of the modes to render.

    These modes are within `range_db` [dB] of the loudest mode or have at least
    MIN_MODE_ENERGY_SHARE of the total energy."""
    loud = loudness >= 10 ** (-range_db / 10) * loudness.max(initial=0.0)
    strong = energy >= MIN_MODE_ENERGY_SHARE * energy.sum()
    return np.flatnonzero((loud | strong) & (energy > 0))


def with_motion_end(
    plan: Plan, motion: Motion, ringing: RingDown, silence: Sequence[str]
) -> Plan:
    """Return the plan with the end of the motion and the decay of the modes added.

    `silence` lists the reasons why claims about the sound cannot be judged.
    """
    ending = f"The motion ends at t = {motion.t[-1]:.6g} s: {motion.outcome.sentence}."
    events = [
        sentences.MOTION_EVENT.format(
            t=event.t,
            kind=event.kind,
            speed=1e3 * event.speed,
            energy=event.energy,
            share=event.energy / float(motion.energy(0.0)[0]),
        )
        for event in motion.events
    ]
    return plan.with_additions(
        decay_decision(ringing),
        modelled=[ending, *events],
        left_out=[*omissions_after_end(motion), *silence],
    )


def decay_decision(ringing: RingDown) -> Decision:
    """Return the decision on the decay of the modes after the motion, with rates and
    causes."""
    # Maximum number of modes listed with their decay rates
    max_named_modes = 6
    rows = zip(ringing.frequency, ringing.decay_rate, ringing.decay_time, strict=True)
    named = [f"{f:.0f} Hz: {d:.3g} 1/s (T60 {t:.2g} s)" for f, d, t in rows]
    if len(named) > max_named_modes:
        named = [*named[:max_named_modes], f"{len(named) - max_named_modes} more modes"]
    own = "by material and radiation"
    if ringing.gap is not None and len(named):
        rates = ringing.decay_rate_without_film
        ends = dict.fromkeys(f"{rate:.3g}" for rate in (rates.min(), rates.max()))
        own += f", {' to '.join(ends)} 1/s, and by the air film at its final mean gap, {1e6 * ringing.gap:.3g} um"
    return Decision(
        subject="decay of the modes after the motion",
        choice="; ".join(named) or "no audible mode",
        reason=f"{own}; the sound continues until they have decayed by {RING_DOWN_DB:g} dB, for at most "
        f"{MAX_RING_TIME:g} s",
    )


def omissions_after_end(motion: Motion) -> list[str]:
    """Return sentences on what is neglected after the end of a motion.

    It is about the landing of a disk that lands, and empty if the disk settled or sank.
    """
    if motion.landing is not None:
        return [sentences.NEGLECTED_LANDING]
    if motion.outcome.is_rest:
        return []
    omitted = [f"The end of the motion and its sound: {motion.outcome.sentence}."]
    if motion.outcome in sentences.NEGLECTED_AFTER_END:
        omitted.append(sentences.NEGLECTED_AFTER_END[motion.outcome])
    return omitted


def damping_decision(material: Material) -> Decision:
    """Return the decision on the damping of the modes by measured decay rates or a loss
    factor."""
    given = len(material.decay_rates)
    return Decision(
        subject="decay of the modes",
        choice=f"the first {given} as measured, the others " * bool(given)
        + "from the loss factor and upward radiation",
        reason=sentences.MEASURED_DECAY_REASON
        if given
        else sentences.LOSS_FACTOR_REASON,
    )


def steady_precession_frequency(disk: Disk, inclination: float) -> float:
    """Return the precession frequency [Hz] of the steady motion at a small inclination
    [rad]."""
    squared = squared_rate_times_inclination(disk.aspect, disk.gyration) / inclination
    return squared**0.5 / disk.time_unit / (2 * pi)


def end_condition_reason(scene: Scene, final: float) -> str:
    """Return the reason for stopping the motion of a scene at an inclination [rad]."""
    turns = f"the contact point completes {steady_precession_frequency(scene.disk, final):.3g} turns per second there"
    if final > scene.numerics.stopping_inclination(scene.disk):
        gap = scene.disk.radius * np.sin(final)
        return (
            f"{turns}; the mean free path of the air, {scene.air.mean_free_path:.2g} m, is "
            f"{END_KNUDSEN_NUMBER:g} times the mean gap there, {gap:.2g} m, and no film law is known for "
            "smaller gaps"
        )
    return f"{turns}; the highest audible rate is {MAX_AUDIBLE_FREQUENCY:g} Hz"
