"""Plan of the air: the film under the disk, the limits of its law, and sound
absorption."""

import numpy as np

from dynamics import Motion, Outcome
from dynamics.disk import Friction
from dynamics.dissipation import Dissipation, resistance_of
from dynamics.equations import disk_constants
from dynamics.film.activation import END_KNUDSEN_NUMBER
from dynamics.film.wedge import (
    boundary_layer_ratio,
    compressibility_number,
    film_under,
    hole_share,
    squeeze_number,
)
from dynamics.landing.lift_off import predict_lift_off
from dynamics.landing.stop import DEFAULT_STOP_HEIGHT
from dynamics.observables import precession_rate
from dynamics.quasi_steady import steady_power
from dynamics.steady_motion import max_steady_inclination, steady_precession
from sonify.claims.loss_causes import wave_inclination
from sonify.plan import sentences
from sonify.plan.plan import Decision, Plan
from sonify.scene import Scene
from sonify.sound.absorption import absorbed_db, absorption_latency
from sonify.sound.radiation import listeners_of


def with_air(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with the decision on the air film and with models and omissions
    of the air."""
    decided = plan.motion.film_decision
    published = published_law_notes(scene)
    if decided.film:
        choice = sentences.FILM_ACTS_CHOICE
        modelled, neglected = film_sentences(scene)
        if published:
            neglected.append(sentences.AIR_COUNTED_TWICE)
    else:
        choice = sentences.FILM_OMITTED_CHOICE
        modelled = []
        neglected = [*sentences.VACUUM_NEGLECTED]
    neglected += published
    for known, unknown in (absorption_sentences(scene), listener_sentences(scene)):
        modelled += known
        neglected += unknown
    decision = Decision(
        subject="air film under the disk", choice=choice, reason=decided.reason
    )
    plan = plan.with_additions(decision, modelled=modelled, left_out=neglected)
    return plan.with_additions(lift_off(scene)) if decided.film else plan


def film_sentences(scene: Scene) -> tuple[list[str], list[str]]:
    """Return sentences on what the film under a disk models and neglects."""
    hole = scene.surface.hole
    bore = 2 * scene.disk.inner_radius
    motion, sound = sentences.FILM_MODELLED
    modelled = [motion] if bore else [motion, sound]
    neglected = [sentences.RING_NEGLECTED] if bore else [*sentences.FILM_NEGLECTED]
    if hole > bore:
        modelled.append(sentences.HOLE_MODELLED.format(hole=hole))
        neglected.append(sentences.HOLE_NEGLECTED)
    elif bore:
        modelled.append(sentences.RING_MODELLED.format(hole=bore))
    return modelled, neglected


def lift_off(scene: Scene) -> Decision:
    """Return the prediction whether the film lifts the disk off the table."""
    depth = scene.surface.curvature * scene.disk.radius**2 / 2
    found = predict_lift_off(scene.disk, scene.air, depth, hole_share(scene))
    heights, first_flight = obstacles_to_lift_off(scene)
    lifts = found.happens(heights, first_flight)
    if lifts:
        choice = sentences.FILM_LIFTS_DISK.format(
            inclination=found.inclination, turns=found.precession_rate / (2 * np.pi)
        )
    elif heights >= found.max_stop_height:
        choice = sentences.HEIGHTS_PREVENT_LIFT_OFF.format(
            height=heights * 1e6, limit=found.max_stop_height * 1e6
        )
    else:
        choice = sentences.WAVES_BREAK_CONTACT_FIRST.format(
            inclination=first_flight, lower=found.inclination
        )
    reason = sentences.LIFT_OFF_OF_PLANE_FILM
    if scene.surface.curvature:
        reason = sentences.LIFT_OFF_FROM_BOWL
    elif scene.imperfection or heights >= found.inclination * scene.disk.radius:
        reason = sentences.LIFT_OFF_FROM_WAVES
    return Decision(subject="lift-off on the air film", choice=choice, reason=reason)


def obstacles_to_lift_off(scene: Scene) -> tuple[float, float]:
    """Return the height [m] that holds the film open, and the inclination [rad] at which
    waves first break the contact."""
    heights = DEFAULT_STOP_HEIGHT
    if scene.roughness:
        heights += np.hypot(scene.roughness.rms or 0.0, scene.roughness.edge_rms)
    if scene.imperfection:
        heights += scene.imperfection.amplitude
    return heights, wave_inclination(scene)


def absorption_sentences(scene: Scene) -> tuple[list[str], list[str]]:
    """Return sentences on modelled and on neglected absorption between disk and
    listeners."""
    modelled = []
    neglected = []
    for distance in sorted({ear.distance for ear in listeners_of(scene)}):
        sentence = sentences.ABSORPTION_SENTENCE.format(
            distance=distance,
            at_8_khz=absorbed_db(scene.air, distance, 8e3),
            at_20_khz=absorbed_db(scene.air, distance),
        )
        if absorption_latency(scene.air, distance):
            modelled.append(f"{sentence}.")
        else:
            neglected.append(f"{sentence}, which is inaudible.")
    return modelled, neglected


def listener_sentences(scene: Scene) -> tuple[list[str], list[str]]:
    """Return sentences on the modelled and the neglected sound at heads and at
    listeners near the disk."""
    modelled = []
    neglected = []
    ears = listeners_of(scene)
    for radius in sorted({ear.ear.head_radius for ear in ears if ear.ear}):
        modelled.append(sentences.HEAD_MODELLED.format(radius=radius))
        neglected.append(sentences.HEAD_NEGLECTED)
    for distance in sorted({ear.distance for ear in ears if ear.is_in_near_field}):
        modelled.append(sentences.NEAR_MODELLED.format(distance=distance))
        neglected.append(sentences.NEAR_NEGLECTED.format(distance=distance))
        if scene.surface.kind != "rigid":
            neglected.append(sentences.NEAR_TABLE_NEGLECTED.format(distance=distance))
    return modelled, neglected


def published_law_notes(scene: Scene) -> list[str]:
    """Return a sentence that compares a published law of air drag with the solved film.

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
    steepest = max_steady_inclination(disk.aspect, disk.gyration)
    inclinations = (0.1, 0.01, 0.001)  # rad
    for beta in (beta for beta in inclinations if beta < steepest):
        turning = steady_precession(beta, disk.aspect, disk.gyration) * np.sin(beta)
        solved = film.rotation_and_fall_powers(beta, (0.0, 0.0, turning))[0]
        ratios.append(f"{steady_power(beta, none, paper) / solved:.2g} at {beta:g} rad")
    return [
        "The scene uses a published law of air drag. The ratio of its power to that of the solved "
        f"film is {', '.join(ratios)}."
    ]


def limits_of_film_law(scene: Scene, motion: Motion) -> list[str]:
    """Return sentences that compare a motion with the limits of the film law.

    The limits concern the inertia, compressibility and rarefaction of the air.
    """
    if not motion.film:
        return []
    air = scene.air
    radius = scene.disk.radius
    beta = motion.state[:, 1]
    rate = np.abs(precession_rate(motion.state))
    thick = boundary_layer_ratio(beta, rate, radius, air)
    squeezed = compressibility_number(beta, rate, air)
    fast = squeeze_number(beta[-1], motion.state[-1, 5], radius, air)
    limits = [
        sentences.FILM_LIMITS.format(
            first=thick[0], last=thick[-1], squeezed=squeezed[-1], closing=fast
        )
    ]
    gap = radius * np.sin(beta)
    path = air.mean_free_path
    for ratio, error in sentences.RAREFACTION_LIMITS:
        times = motion.t[gap < ratio * path]
        if len(times):
            limits.append(
                sentences.RAREFIED_AIR_FROM_TIME.format(
                    time=times[0], ratio=ratio, path=path, error=error
                )
            )
    final = motion.plan.final_inclination
    stops_early = final > scene.numerics.stopping_inclination(scene.disk)
    if motion.rolling_outcome is Outcome.SETTLED and stops_early:
        limits.append(
            sentences.RAREFIED_MOTION_NOT_SOLVED.format(
                inclination=final,
                gap=radius * np.sin(final),
                knudsen=END_KNUDSEN_NUMBER,
            )
        )
    return limits
