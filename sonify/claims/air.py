"""AIR -> FINDINGS: onset of the air film, cause of the end, lift of the disk, and audibility."""

from math import log
from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid

from dynamics import Motion, Outcome
from dynamics.dissipation import resistance_of
from dynamics.equations import disk_constants
from dynamics.film.activation import MIN_FILM_SHARE
from dynamics.film.wedge import Film, closing_number, compressibility, film_powers, film_under
from dynamics.observables import precession_rate
from dynamics.quasi_steady import steady_power
from sonify.claims.finding import Finding, Measured, finding, register_judge
from sonify.hearing.loudness import THRESHOLD_DB, WINDOW, band_levels
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound

RECORDED_EXPONENT = 0.31
RECORDED_EXPONENT_ERROR = 0.03
"""Exponent of the precession rate in the time left and its error, from recordings of disks on
granite (2026).
"""
LOST_TO_AIR_CLAIM = "The contact is lost to the air"
LAST_ENERGY_SHARE = 0.1
"""Last share of the energy loss, over which the cause of the end is determined."""
CAUSE_IN_WORDS = {
    "contact": "impacts and compression of the contact",
    "creep": "creep of the contact",
    "slip": "sliding",
    "moments": "friction of rolling and pivoting",
    "table": "the table",
    "film": "the film of air",
    "body": "the modes of the disk",
}
"""The causes of energy loss, CAUSES, in words."""
COMPRESSIBILITY_PER_CLOSING = 100 / 3
"""Lam per closing number at the same error of the film law.

The error is 27 % both at a closing number of 3 and at Lam = 100.
"""
OUTCOMES_WITHOUT_END = {
    Outcome.TIME_LIMIT,
    Outcome.LIFTED_OFF,
    Outcome.UPRIGHT,
    Outcome.LEFT_TABLE,
    Outcome.STALLED,
    Outcome.CASCADE,
}
"""Outcomes that no loss of energy causes: the run was interrupted or another motion follows."""
EXPONENT_INCLINATIONS = (1e-3, 1e-2)
"""Inclinations [rad] between which the exponent of the friction power is determined."""


def air_findings(scene: Scene, motion: Motion, sound: Sound) -> list[Finding]:
    """Return the findings on the air of a run.

    For a motion without a film they evaluate the film that the air of the scene would form.
    """
    heard = [heard_through_film(sound)] if motion.film else []
    return motion_findings(scene, motion) + heard


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings on the air that the motion alone can judge."""
    exponent = (
        [friction_exponent(scene)] if steady_friction(scene, EXPONENT_INCLINATIONS[0]) > 0 else []
    )
    if scene.disk.shape != "solid" or not scene.air.pressure or not scene.air.density:
        return exponent
    acts = motion.film
    film = acts or film_under(scene.disk, scene.air)
    ended = [] if motion.outcome in OUTCOMES_WITHOUT_END else [what_ends(motion)]
    return [air_negligible(motion, film), *ended, carried_by_air(motion, film), *exponent]


def air_scalars(scene: Scene, motion: Motion) -> dict[str, Any]:
    """Return the cause that ends the motion, in words, and the compression of its film at the end.

    The compression `film_squeezed` is the greater of Lam, reduced by wall slip, and COMPRESSIBILITY_PER_CLOSING times
    the closing number. The film law is compared with solutions up to 100.
    """
    film = motion.film
    parts = shares_of_the_end(motion)
    squeezed = {}
    if film:
        (beta, nutation) = motion.state[-1, [1, 5]]
        rate = precession_rate(motion.state[-1:])[0]
        turns = compressibility(beta, rate, scene.air) / (1 + film.slip / np.sin(beta))
        falls = COMPRESSIBILITY_PER_CLOSING * closing_number(
            beta, nutation, scene.disk.radius, scene.air
        )
        squeezed = {"film_squeezed": float(max(turns, falls))}
    return {"ended_by": CAUSE_IN_WORDS[max(parts, key=lambda name: parts[name])]} | squeezed


@finding(
    "The film of air under the disk may be neglected",
    "part of the motion that is over when the film takes 1 % of the power",
    "Reynolds' equation on the film; Moffatt (2000)",
    needs=("motion", "film law"),
    at_least=1.0,
)
def air_negligible(motion: Motion, film: Film) -> Measured:
    """The share of the motion before the film first takes, or would take, 1 % of the power."""
    film_power = film_powers(motion.disk, film, motion.state).sum(axis=0)
    work = motion.state[:, 10] + (0.0 if motion.film else _time_integral(film_power, motion))
    windows = np.linspace(0, motion.t[-1], 201)
    middle = (windows[1:] + windows[:-1]) / 2
    share = np.diff(np.interp(windows, motion.t, _time_integral(film_power, motion))) / np.maximum(
        np.diff(np.interp(windows, motion.t, work)), 1e-300
    )
    late = np.flatnonzero(share >= MIN_FILM_SHARE)
    if not len(late):
        return Measured(1.0)
    return Measured(float(middle[late[0]] / motion.t[-1]), float(middle[1] / motion.t[-1]))


def shares_of_the_end(motion: Motion) -> dict[str, float]:
    """Return the share of each cause in the last tenth of the energy loss."""
    energy = motion.energy(motion.t)
    last = energy - energy[-1] <= LAST_ENERGY_SHARE * (energy[0] - energy[-1])
    lost = motion.energy_lost(np.array([motion.t[last][0], motion.t[-1]]))
    taken = {cause: float(until - since) for cause, (since, until) in lost.items()}
    whole = sum(taken.values()) or 1.0
    return {cause: energy / whole for cause, energy in taken.items()}


@register_judge(needs=("motion",))
def what_ends(motion: Motion) -> Finding:
    """The largest share of a single cause in the last tenth of the energy loss."""
    shares = shares_of_the_end(motion)
    cause = max(shares, key=lambda name: shares[name])
    return Finding(
        key="what_ends",
        claim=f"What ends the motion is {CAUSE_IN_WORDS[cause]}",
        value=float(shares[cause]),
        unit=f"of the last {LAST_ENERGY_SHARE:.0%} of the energy",
        at_least=0.5,
        details={name: share for name, share in shares.items() if share},
        cause=cause,
        needs=("motion",),
        source="work of each cause along the motion",
    )


@register_judge(needs=("motion", "film law"))
def carried_by_air(motion: Motion, film: Film) -> Finding:
    """The greatest lift of the film over the vertical force of film and contact.

    For a motion without a film the reference is the contact force.
    """
    lift = film_lift(motion, film)
    contact = motion.steady_load(motion.t)
    borne = contact + lift if motion.film else contact
    share = float(np.max(lift / np.maximum(borne, 1e-9 * motion.disk.weight)))
    carried = motion.outcome is Outcome.AIRBORNE
    turns = abs(precession_rate(motion.state[-1:])[0]) / (2 * np.pi)
    end = {
        "time": float(motion.t[-1]),
        "inclination": float(motion.state[-1, 1]),
        "precession_frequency": turns,
    }
    return Finding(
        key="carried_by_air",
        claim=LOST_TO_AIR_CLAIM
        if motion.film
        else "In its air, which is left out, the disk would become airborne",
        value=1.0 if carried else share,
        unit="greatest lift of the film / vertical force",
        at_least=1.0,
        tolerance=1e-6,
        details=end if carried else {},
        cause="film" if motion.film else "",
        needs=("motion", "film law"),
        source="Reynolds' equation on the falling film",
    )


@finding(
    "The motion of the rigid disk is audible through the open film",
    "dB above the threshold of hearing",
    "ISO 226; the air at the rim gives back what the face takes",
    needs=("sound",),
    at_least=0.0,
)
def heard_through_film(sound: Sound) -> float:
    """The greatest level of heave or tilt of the rigid disk above the threshold of hearing, in any
    third octave [dB].
    """
    seen = [band_levels(spectrogram(sound.track(name), WINDOW)) for name in ("heave", "tilt")]
    return float(max((levels - THRESHOLD_DB[:, None]).max() for levels in seen))


@finding(
    "The friction of the scene lets the precession rate grow as measured",
    "exponent of the precession rate in the time left",
    "recordings of disks on granite, 2026: 0.31(3)",
    needs=("scene",),
    at_least=RECORDED_EXPONENT,
    at_most=RECORDED_EXPONENT,
    tolerance=RECORDED_EXPONENT_ERROR,
)
def friction_exponent(scene: Scene):
    """The exponent of the precession rate in the time left, for a steady disk with the friction of
    the scene.

    For a power P ~ beta^p it is 1/(2 (1 - p)): 1/3 for contour friction and 1 for the arm k_2. The
    film is not included.
    """
    low, high = EXPONENT_INCLINATIONS
    slope = log(steady_friction(scene, high) / steady_friction(scene, low)) / log(high / low)
    return 1 / (2 * (1 - slope)) if slope < 1 else float("inf")


def steady_friction(scene: Scene, beta: float) -> float:
    """Return the dimensionless power lost by a steady disk at inclination `beta` [rad] without a
    film.
    """
    return steady_power(
        beta,
        disk_constants(scene.disk, scene.friction),
        resistance_of(scene.dissipation, scene.disk),
    )


def film_lift(motion: Motion, film: Film):
    """Return the lift (n,) [N] of the film along the motion, without contact vibration."""
    disk = motion.disk
    omega = motion.state[:, 5:8].T.copy()
    omega[0] = motion.steady_nutation(motion.t)
    lift = film.at(motion.state[:, 1], omega * disk.time_unit)[2]
    return lift * disk.mass * disk.radius / disk.time_unit**2


def _time_integral(power, motion):
    return cumulative_trapezoid(power, x=motion.t, initial=0)
