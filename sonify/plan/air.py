"""SCENE -> PLAN of the air: the film under the disk, the limits of its law, and absorption."""

import numpy as np

from dynamics import Motion, Outcome
from dynamics.disk import Friction
from dynamics.dissipation import Dissipation, resistance_of
from dynamics.equations import disk_constants
from dynamics.film.activation import MAX_KNUDSEN, decide_film, final_inclination
from dynamics.film.wedge import closing_number, compressibility, film_under, layer_thickness
from dynamics.observables import precession_rate
from dynamics.quasi_steady import steady_power
from dynamics.steady_motion import steady_precession, steepest_steady
from sonify.plan import sentences
from sonify.plan.plan import Decision, Plan
from sonify.scene import Scene
from sonify.sound.absorption import HIGHEST_FREQUENCY, absorbed_db, absorption_latency
from sonify.sound.radiation import listeners_of

FILM_COMPARISON_INCLINATIONS = (0.1, 0.01, 0.001)
"""Inclinations [rad] at which the air law of a paper is compared with the solved film."""


def with_air(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with its decision, models and omissions on the air."""
    decided = decide_film(scene)
    acts = sentences.FILM_ACTS_CHOICE if decided.film else sentences.FILM_OMITTED_CHOICE
    decision = Decision(subject="film of air under the disk", choice=acts, reason=decided.reason)
    published = published_law_notes(scene)
    absorbed, not_absorbed = absorption_sentences(scene)
    if not decided.film:
        neglected = [*sentences.VACUUM_NEGLECTED, *published, *not_absorbed]
        return plan.also(decision, modelled=absorbed, left_out=neglected)
    twice = [sentences.AIR_COUNTED_TWICE] if published else []
    modelled = [*sentences.FILM_MODELLED, *absorbed]
    neglected = [*sentences.FILM_NEGLECTED, *twice, *published, *not_absorbed]
    return plan.also(decision, modelled=modelled, left_out=neglected)


def absorption_sentences(scene: Scene) -> tuple[list[str], list[str]]:
    """Return sentences on the absorption between disk and listeners: (modelled, left out)."""
    modelled = []
    neglected = []
    for distance in sorted({ear.distance for ear in listeners_of(scene)}):
        sentence = sentences.ABSORPTION.format(
            distance=distance,
            at_8_khz=absorbed_db(scene.air, distance, 8e3),
            at_20_khz=absorbed_db(scene.air, distance, HIGHEST_FREQUENCY),
        )
        if absorption_latency(scene.air, distance):
            modelled.append(f"{sentence}.")
        else:
            neglected.append(f"{sentence}, which is inaudible.")
    return modelled, neglected


def published_law_notes(scene: Scene) -> list[str]:
    """Return a sentence that compares the air law of a paper with the solved film.

    The list is empty if the scene has no such law, no solid disk or no air.
    """
    disk = scene.disk
    air = scene.air
    given = scene.dissipation
    law = Dissipation(
        air_viscosity=given.air_viscosity,
        boundary_layer_viscosity=given.boundary_layer_viscosity,
        air_density=given.air_density,
    )
    paper = resistance_of(law, disk)
    if not paper or disk.shape != "solid" or not air.pressure or not air.density:
        return []
    none = disk_constants(disk, Friction(mu_static=1.0, mu_dynamic=1.0))
    film = film_under(disk, air)
    ratios = []
    steepest = steepest_steady(disk.aspect, disk.gyration)
    for beta in (beta for beta in FILM_COMPARISON_INCLINATIONS if beta < steepest):
        turning = steady_precession(beta, disk.aspect, disk.gyration) * np.sin(beta)
        solved = film.powers(beta, (0.0, 0.0, turning))[0]
        ratios.append(f"{steady_power(beta, none, paper) / solved:.2g} at {beta:g} rad")
    return [
        "The air law of the scene is a published one; relative to the power of the solved film it "
        f"takes {', '.join(ratios)}."
    ]


def limits_of_film_law(scene: Scene, motion: Motion) -> list[str]:
    """Return sentences on how far a motion exceeds the limits of the film's law.

    The limits concern the inertia of the air, its compressibility and its rarefaction.
    """
    if not decide_film(scene).film:
        return []
    air = scene.air
    radius = scene.disk.radius
    beta = motion.state[:, 1]
    rate = np.abs(precession_rate(motion.state))
    thick = layer_thickness(beta, rate, radius, air)
    squeezed = compressibility(beta, rate, air)
    fast = closing_number(beta[-1], motion.state[-1, 5], radius, air)
    limits = [
        sentences.FILM_LIMITS.format(
            first=thick[0], last=thick[-1], squeezed=squeezed[-1], closing=fast
        )
    ]
    gap = radius * np.sin(beta)
    for ratio, error in sentences.RAREFACTION_LIMITS:
        beyond = np.flatnonzero(gap < ratio * air.mean_free_path)
        if len(beyond):
            time = motion.t[beyond[0]]
            path = air.mean_free_path
            limits.append(
                sentences.RAREFIED_AIR_FROM_TIME.format(
                    time=time, ratio=ratio, path=path, error=error
                )
            )
    final = final_inclination(scene)
    is_last = motion.outcome is Outcome.SETTLED and final > scene.numerics.stopping_inclination(
        scene.disk
    )
    if is_last:
        limits.append(
            sentences.RAREFIED_MOTION_NOT_SOLVED.format(
                inclination=final, gap=radius * np.sin(final), knudsen=MAX_KNUDSEN
            )
        )
    return limits
