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
from sonify.plan.plan import Decision, Plan
from sonify.scene import Scene
from sonify.sound.absorption import HIGHEST_FREQUENCY, absorbed_db, absorption_latency
from sonify.sound.radiation import listeners_of

JUDGED = (0.1, 0.01, 0.001)
"""Inclinations [rad] at which the air law of a paper is compared with the solved film."""
RAREFIED = (
    (
        60,
        "slip at the walls lets a tenth more air through, and more later, which the film's law "
        "has within 10 %",
    ),
    (
        10,
        "9 % more air passes than slip lets through, by kinetic theory (Fukui & Kaneko 1990), and "
        "more later",
    ),
    (
        1,
        "the film is no continuum: 1.5 times as much air passes, and its law holds by its order "
        "alone",
    ),
)
"""(Mean gap over mean free path, error of the film's law below this ratio)."""


def with_air(plan: Plan, scene: Scene) -> Plan:
    """Return the plan with its decision, models and omissions on the air."""
    told = decide_film(scene)
    acts = "acts on the motion and on the sound" if told.film else "does not act"
    decision = Decision(subject="film of air under the disk", choice=acts, reason=told.reason)
    own = papers_law(scene)
    (filtered, left) = on_the_way(scene)
    twice = [TWICE] if told.film and own else []
    modelled, left_out = (MODELLED, LEFT_OUT) if told.film else ((), VACUUM)
    return plan.also(
        decision, modelled=[*modelled, *filtered], left_out=[*left_out, *twice, *own, *left]
    )


def on_the_way(scene: Scene) -> tuple[list[str], list[str]]:
    """Return sentences on the absorption between disk and listeners: (modelled, left out)."""
    told: tuple[list[str], list[str]] = [], []
    for distance in sorted({ear.distance for ear in listeners_of(scene)}):
        near, far = (absorbed_db(scene.air, distance, f) for f in (8e3, HIGHEST_FREQUENCY))
        size = f"on the way to {distance:g} m air of 50 % humidity takes {near:.2g} dB at 8 kHz, {far:.2g} dB at 20 kHz"
        if absorption_latency(scene.air, distance):
            told[0].append(f"Absorption: {size}.")
        else:
            told[1].append(f"Absorption: {size}, less than is heard.")
    return told


def papers_law(scene: Scene) -> list[str]:
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
    told = []
    steepest = steepest_steady(disk.aspect, disk.gyration)
    for beta in (beta for beta in JUDGED if beta < steepest):
        turning = steady_precession(beta, disk.aspect, disk.gyration) * np.sin(beta)
        solved = film.powers(beta, (0.0, 0.0, turning))[0]
        told.append(f"{steady_power(beta, none, paper) / solved:.2g} at {beta:g} rad")
    return [
        f"The law of the air is its paper's; it takes of the power of the solved film "
        f"{', '.join(told)}."
    ]


def beyond_the_film(scene: Scene, motion: Motion) -> list[str]:
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
    told = [
        f"Inertia of the air in the film is a fit, within 5 % below S = 3: S goes {thick[0]:.2g} "
        f"to {thick[-1]:.2g}. "
        f"Its air is isothermal and squeezed, by fits to the solved film within 5 % below Lam = "
        f"12 mu Omega/(p beta^2) "
        f"of 100: at the end Lam is {squeezed[-1]:.2g}. Its pressure is taken to follow the "
        f"instant: at the end the "
        f"disk falls {fast:.2g} times as fast as the film lets air out, and at 1 the film resists "
        f"12 % too little."
    ]
    gap = radius * np.sin(beta)
    for times, what in RAREFIED:
        beyond = np.flatnonzero(gap < times * air.mean_free_path)
        if len(beyond):
            told.append(
                f"From t = {motion.t[beyond[0]]:.6g} s on the mean gap is less than {times:g} "
                f"mean free paths of the "
                f"air, {air.mean_free_path:.2g} m: {what}."
            )
    final = final_inclination(scene)
    is_last = motion.outcome is Outcome.SETTLED and final > scene.numerics.stopping_inclination(
        scene.disk
    )
    if is_last:
        told.append(
            f"The motion below {final:.2g} rad, a mean gap of {radius * np.sin(final):.2g} m: the "
            f"mean free path of "
            f"the air is {MAX_KNUDSEN:g} times as long there, and slip lets 3.4 times too little "
            f"air through."
        )
    return told


MODELLED = (
    "The film of air between disk and table (Reynolds' equation on the wedge): it slows the "
    "precession, damps the "
    "fall, and lifts the disk; friction acts on what it leaves of the contact force.",
    "Heave and tilt of the rigid disk radiate through the film as it is at each instant: open, "
    "its rim gives back what "
    "the face takes, and its second harmonic, 17 dB below an open tilt and nearer where the film "
    "half closes; closed, "
    "the face alone sounds. The modes are damped, detuned and muffled by it, whose air has "
    "inertia and gives heat "
    "to both faces.",
)
LEFT_OUT = (
    "In the decay of the modes by the film, the sound that leaves it at its rim: the air there "
    "gives way. Twice the "
    "elements change that decay by up to 5 %.",
    "Memory of the film's air from one instant to the next; pressure of the film as a direct "
    "driver of the modes.",
    "Inertia of the air in the second harmonic of the rim: 3 dB less of it at S = 3. Higher "
    "harmonics, 50 dB down.",
    "The phase at which a mode radiates through the film, and the azimuth: a mean is taken. Modes "
    "above k R = 1.5, 2.2 "
    "kHz for a disk of 75 mm, sound as above a closed film, of which the film only damps and "
    "detunes them.",
    "The film in a steep position, where the disk is no baffle: above 0.3 rad its sound is wrong "
    "by several dB; later "
    "heave and tilt are within 1.5 dB of a solution of the film.",
)
VACUUM = (
    "Air under the disk: it would slow and lift it, and flow round the rim while the film is "
    "open: until late in the "
    "motion the true pressure of heave and tilt is lower.",
)
TWICE = "The scene has a paper's law of the air beside the film: the same air acts twice."
