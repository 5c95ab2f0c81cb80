"""Findings on the air: onset of the film, cause of the end, lift of the disk, and
audibility."""

from math import inf, log
from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid

from dynamics import Motion, Outcome
from dynamics.compliant.law.spin_friction import slip_arm
from dynamics.dissipation import resistance_of
from dynamics.film.wedge import (
    Film,
    compressibility_number,
    film_of_scene,
    film_powers,
    squeeze_number,
)
from dynamics.observables import precession_rate
from dynamics.quasi_steady import steady_power
from dynamics.scene_constants import scene_constants
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from sonify.claims.energy_causes import CAUSE_IN_WORDS
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.limits import FINAL_ENERGY_SHARE
from sonify.claims.reference_scenes import may_lie_on_granite
from sonify.hearing.loudness import LEVEL_WINDOW_S, levels_above_threshold
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound


def air_findings(scene: Scene, motion: Motion, sound: Sound) -> list[Finding]:
    """Return the findings on the air of a run.

    For a motion without a film, they apply to the film that the air of the scene would
    form."""
    if "air" not in motion.finding_groups:
        return []
    heard = [heard_through_film(sound)] if motion.film else []
    return motion_findings(scene, motion) + heard


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings on the air that follow from the motion alone."""
    friction = []
    _, powers = steady_friction_powers(scene)
    solid = scene.disk.shape == "solid"
    if solid and powers[0] > 0 and may_lie_on_granite(scene):
        friction.append(friction_exponent(scene))
    arm = scene.friction.arm_pivoting
    if arm != "contact" and arm > 0:
        friction.append(pivoting_within_contact(scene))
    has_film = bool(motion.film) or solid
    if not has_film or not scene.air.pressure or not scene.air.density:
        return friction
    film = motion.film or film_of_scene(scene)
    return [
        air_negligible(motion, film),
        carried_by_air(motion, film),
        *friction,
    ]


def end_cause_scalars(scene: Scene, motion: Motion) -> dict[str, Any]:
    """Return the cause that ends the motion, and the compression of the air film at the
    end.

    The compression `film_squeezed` is the greater of Lam, reduced by wall slip, and the
    squeeze number, multiplied by the ratio of both at equal errors of the film law. The
    law was compared with solutions up to a compression of 100."""
    shares = final_loss_shares(motion)
    scalars: dict[str, Any] = {
        "ended_by": CAUSE_IN_WORDS[max(shares, key=shares.__getitem__)]
    }
    film = motion.film
    if film:
        beta, nutation = motion.state[-1, [1, 5]]
        rate = precession_rate(motion.state[-1:])[0]
        turns = compressibility_number(beta, rate, scene.air) / (
            1 + film.slip / np.sin(beta)
        )
        # The error of the film law is 27 % at Lam = 100 and at a squeeze number of 3.
        equal_error_ratio = 100 / 3
        falls = equal_error_ratio * squeeze_number(
            beta, nutation, scene.disk.radius, scene.air
        )
        scalars["film_squeezed"] = float(max(turns, falls))
    return scalars


@finding(needs=("motion", "film law"), at_least=1.0)
def air_negligible(motion: Motion, film: Film) -> Measured:
    """The share of the duration before the film first dissipates, or would dissipate, 1
    % of the power."""
    film_power = film_powers(motion.disk, film, motion.state).sum(axis=0)
    film_work = cumulative_trapezoid(film_power, x=motion.t, initial=0)
    work = motion.state[:, 10] + (0.0 if motion.film else film_work)
    windows = np.linspace(0, motion.t[-1], 201)
    middle = (windows[1:] + windows[:-1]) / 2
    share = np.diff(np.interp(windows, motion.t, film_work)) / np.maximum(
        np.diff(np.interp(windows, motion.t, work)), 1e-300
    )
    late = np.flatnonzero(share >= MIN_RELEVANT_SHARE)
    if not len(late):
        return Measured(1.0)
    return Measured(middle[late[0]] / motion.t[-1], middle[1] / motion.t[-1])


def final_loss_shares(motion: Motion) -> dict[str, float]:
    """Return the share of each cause in the final tenth of the energy loss."""
    energy = motion.energy(motion.t)
    held = (1 - FINAL_ENERGY_SHARE) * energy[-1] + FINAL_ENERGY_SHARE * energy[0]
    first = int(np.argmax(energy <= held))
    around = [first, max(first - 1, 0)]
    begin = np.interp(held, energy[around], motion.t[around])
    lost = motion.energy_lost(np.array([begin, motion.t[-1]]))
    taken = {cause: float(until - since) for cause, (since, until) in lost.items()}
    whole = sum(taken.values()) or 1.0
    return {cause: energy / whole for cause, energy in taken.items()}


@finding(needs=("motion",), at_least=0.5)
def what_ends(motion: Motion) -> Measured:
    """The largest share of a single cause in the final tenth of the energy loss.

    The claim names this cause."""
    shares = final_loss_shares(motion)
    cause = max(shares, key=shares.__getitem__)
    return Measured(
        shares[cause],
        details={name: share for name, share in shares.items() if share},
        words={"cause": CAUSE_IN_WORDS[cause]},
        fields={"cause": cause},
    )


@finding(needs=("motion", "film law"), at_least=1.0, tolerance=1e-6)
def carried_by_air(motion: Motion, film: Film) -> Measured:
    """The greatest ratio of the lift of the film to the vertical force of film and
    contact.

    For a motion without a film, it is the ratio to the contact force alone. For a
    rattling disk, whose force vanishes in every flight, it is 1 if the film finally
    carries the disk, otherwise 0.
    """
    if "rattling" in motion.finding_groups:
        carried = float(motion.rolling_outcome is Outcome.AIRBORNE)
        return Measured(
            carried,
            details={"airborne": carried},
            variant="rattling",
            fields={"cause": "film"},
        )
    lift = film_lift(motion, film)
    contact = motion.steady_load(motion.t)
    borne = contact + lift if motion.film else contact
    share = np.max(lift / np.maximum(borne, 1e-9 * motion.disk.weight))
    if motion.film is None:
        return Measured(share, variant="no film")
    fields = {"cause": "film"}
    if motion.rolling_outcome is not Outcome.AIRBORNE:
        return Measured(share, fields=fields)
    turns = abs(precession_rate(motion.state[-1:])[0]) / (2 * np.pi)
    end = {
        "time": motion.t[-1],
        "inclination": motion.state[-1, 1],
        "precession_frequency": turns,
    }
    return Measured(1.0, details=end, fields=fields)


@finding(needs=("sound",), at_least=0.0)
def heard_through_film(sound: Sound) -> float:
    """The greatest level of heave or tilt of the rigid disk above the threshold of
    hearing in any third-octave band [dB]."""
    return max(
        levels_above_threshold(spectrogram(sound.track(name), LEVEL_WINDOW_S)).max()
        for name in ("heave", "tilt")
    )


@finding(needs=("scene",), at_least=0.31, at_most=0.31, tolerance=0.03)
def friction_exponent(scene: Scene) -> float:
    """The exponent of the precession rate of a steady disk as a power of the remaining
    time.

    For a friction power P ~ beta^p the exponent is 1/(2 (1 - p)), which is 1/3 for
    contour friction and 1 for the arm k_2. The film is excluded."""
    (flat, steep), (power_when_flat, power_when_steep) = steady_friction_powers(scene)
    slope = log(power_when_steep / power_when_flat) / log(steep / flat)
    return 1 / (2 * (1 - slope)) if slope < 1 else inf


@finding(needs=("scene",), at_most=1.0)
def pivoting_within_contact(scene: Scene) -> Measured:
    """The ratio of the arm k_3 of the scene to the greatest arm of a Hertzian contact.

    The greatest arm is that of a contact ellipse under the weight in full spin slip. A
    rolling contact has a much smaller arm, which `friction.arm_pivoting = "contact"`
    computes."""
    law = scene.contact.contact_law(scene.disk, scene.material)
    most = scene.friction.mu_dynamic * slip_arm(
        law, np.array([0.1, 0.01]), scene.disk.weight
    )
    steep, flat = scene.friction.arm_pivoting / np.maximum(most, np.finfo(float).tiny)
    return Measured(steep, details={"at_0.01_rad": flat})


def steady_friction_powers(scene: Scene) -> tuple[tuple[float, ...], list[float]]:
    """Return two small inclinations [rad], and the dimensionless power that a steady
    disk without a film loses at each."""
    inclinations = (1e-3, 1e-2)
    constants = scene_constants(scene)
    loads = resistance_of(scene.dissipation, scene.disk)
    return inclinations, [steady_power(beta, constants, loads) for beta in inclinations]


def film_lift(motion: Motion, film: Film) -> np.ndarray:
    """Return the lift (n,) [N] of the film along the motion, without contact
    vibration."""
    disk = motion.disk
    omega = motion.state[:, 5:8].T.copy()
    omega[0] = motion.steady_nutation(motion.t)
    lift = film.moments_at(motion.state[:, 1], omega * disk.time_unit)[2]
    return lift * disk.mass * disk.radius / disk.time_unit**2


def lift_exceeds_contact_since(motion: Motion, film: Film) -> float:
    """Return the time [s] since which the film lifts the disk more than the contact does;
    the end of the motion if it never does."""
    contact = motion.steady_load(motion.t)
    contact_bears = np.flatnonzero(film_lift(motion, film) <= contact)
    return float(motion.t[contact_bears[-1]]) if len(contact_bears) else 0.0
