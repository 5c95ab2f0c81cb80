"""AIR -> FINDINGS: from when it counts, what ends the motion, whether it carries the disk and lets it be heard."""

from functools import lru_cache
from math import log
from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid

from dynamics import Motion, Outcome
from dynamics.dissipation import resistance
from dynamics.equations import law_of
from dynamics.film.acting import MATTERS
from dynamics.film.law import Film, compressibility, falls_faster, film_in, film_under
from dynamics.rates import precession_rate
from dynamics.time_left import steady_power
from sonify.claims.motion import Finding, finding
from sonify.hearing.loudness import THRESHOLD_DB, WINDOW, band_levels
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound

MEASURED, SPREAD = 0.31, 0.03
"""Exponent of the precession rate in the time left, of recordings of disks on granite (2026), and its error."""
LOST_TO_AIR = "The contact is lost to the air"
LAST = 0.1
"""The end of a motion is what takes this last part of its energy."""
LOST_TO = (
    "impacts and compression of the contact",
    "creep of the contact",
    "sliding",
    "friction of rolling and pivoting",
    "the table",
    "the film of air",
    "the modes of the disk",
)
"""What a full motion knows the losses of, in the order of its causes."""
FALLS_AS = 100 / 3
"""A fall three times as fast as the air leaves is as far from the law of the film, 27 %, as it is held at Lam = 100."""
UNENDED = {
    Outcome.TIME_LIMIT,
    Outcome.LIFTED_OFF,
    Outcome.UPRIGHT,
    Outcome.LEFT_TABLE,
    Outcome.STALLED,
    Outcome.CASCADE,
}
"""Where a motion was broken off, or is another one from then on, no loss of energy has ended it."""
INCLINATIONS = (1e-3, 1e-2)
"""Between these the exponent of a friction is read [rad]."""


def air_findings(scene: Scene, motion: Motion, sound: Sound) -> list[Finding]:
    """Return what a run says about its air; of a motion in a vacuum, what a film of its air would do along it."""
    heard = [heard_through_film(sound)] if film_in(getattr(motion, "loads", None)) else []
    return motion_findings(scene, motion) + heard


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return those of them that the motion alone can judge."""
    exponent = [friction_exponent(scene)] if steady_friction(scene, INCLINATIONS[0]) > 0 else []
    if scene.disk.shape != "solid" or not scene.air.pressure or not scene.air.density:
        return exponent
    acts = film_in(getattr(motion, "loads", None))
    film = acts or film_under(scene.disk, scene.air)
    ended = [] if motion.outcome in UNENDED else [what_ends(motion, film if acts else None)]
    return [air_negligible(motion, film), *ended, carried_by_air(motion, film), *exponent]


def air_scalars(scene: Scene, motion: Motion) -> dict[str, Any]:
    """Return what ends the motion, in words, and of its film Lam at the end, over what slip lets through more, or
    FALLS_AS times how much faster it falls than its air leaves: it is held against solutions up to 100 of either."""
    film = film_in(getattr(motion, "loads", None))
    parts, squeezed = shares_of_the_end(motion, film), {}
    if film:
        (beta, nutation), rate = motion.state[-1, [1, 5]], precession_rate(motion.state[-1:])[0]
        turns = compressibility(beta, rate, scene.air) / (1 + film.slip / np.sin(beta))
        falls = FALLS_AS * falls_faster(beta, nutation, scene.disk.radius, scene.air)
        squeezed = {"film_squeezed": float(max(turns, falls))}
    return {"ended_by": max(parts, key=lambda name: parts[name])} | squeezed


@finding(
    "The film of air under the disk may be neglected",
    "part of the motion that is over when the film takes 1 % of the power",
    "Reynolds' equation on the film; Moffatt (2000)",
    at_least=1.0,
)
def air_negligible(motion: Motion, film: Film) -> tuple[float, float]:
    """The share of the motion that is over when the film first takes 1 % of the power, or would."""
    film_power = np.sum(film_powers(motion, film), axis=0)
    work = motion.state[:, 10] + (0.0 if film_in(getattr(motion, "loads", None)) else _integral(film_power, motion))
    windows = np.linspace(0, motion.t[-1], 201)
    middle = (windows[1:] + windows[:-1]) / 2
    share = np.diff(np.interp(windows, motion.t, _integral(film_power, motion))) / np.maximum(
        np.diff(np.interp(windows, motion.t, work)), 1e-300
    )
    late = np.flatnonzero(share >= MATTERS)
    return float(middle[late[0]] / motion.t[-1]) if len(late) else 1.0, float(middle[1] / motion.t[-1])


@lru_cache(maxsize=1)
def shares_of_the_end(motion: Motion, film: Film | None) -> dict[str, float]:
    """Return the shares in which film, sliding and the moments at the contact take the LAST of the energy; where the
    contact is solved in full also its compression, its creep and the table."""
    energy = motion.energy(motion.t)
    last = energy - energy[-1] <= LAST * (energy[0] - energy[-1])
    taken = taken_by(motion, film, motion.t[last][0], motion.t[-1])
    return {name: share / (sum(taken.values()) or 1.0) for name, share in taken.items()}


def taken_by(motion: Any, film: Film | None, since: float, until: float) -> dict[str, float]:
    """Return what each cause takes of the energy [J] between two times [s]."""
    if hasattr(motion, "handed_over"):
        begin = motion.handed_over
        late = taken_by(motion.then, film, max(since - begin, 0.0), min(until - begin, motion.then.t[-1]))
        early = taken_by(motion.first, film, since, begin) if since < begin else {}
        return {name: early.get(name, 0.0) + taken for name, taken in late.items()}
    times = np.array([since, until])
    if hasattr(motion, "lost"):
        return dict(zip(LOST_TO, np.ptp(motion.lost(times), axis=0).tolist(), strict=True))
    force, state = motion.force(motion.t), motion.state
    parts = {"sliding": _integral(-(force[:, 0] * state[:, 8] + force[:, 1] * state[:, 9]), motion)}
    if film:
        parts["the film of air"] = _integral(np.sum(film_powers(motion, film), axis=0), motion)
    parts["friction of rolling and pivoting"] = state[:, 10] - sum(parts.values())
    return {name: float(np.diff(np.interp(times, motion.t, work))[0]) for name, work in parts.items()}


def what_ends(motion: Motion, film: Film | None) -> Finding:
    """The largest of the `shares_of_the_end`."""
    parts = shares_of_the_end(motion, film)
    cause = max(parts, key=lambda name: parts[name])
    return Finding(
        key="what_ends",
        claim=f"What ends the motion is {cause}",
        value=float(parts[cause]),
        unit=f"of the last {LAST:.0%} of the energy; " + ", ".join(f"{k} {v:.3f}" for k, v in parts.items() if v),
        at_least=0.5,
        source="work of each cause along the motion",
    )


def carried_by_air(motion: Motion, film: Film) -> Finding:
    """The greatest lift of the film over what film and contact bear together; in a vacuum over the contact force."""
    acts, lift = film_in(getattr(motion, "loads", None)), lifts(motion, film)
    if hasattr(motion, "steady_load"):  # a contact that vibrates: what it does not bear in the mean the air does
        contact = motion.steady_load(motion.t)
        lift = np.maximum(motion.disk.weight - contact, 0.0) if acts else lift
    else:
        contact = motion.force(motion.t)[:, 2]
    borne = contact + lift if acts else contact
    share = np.max(lift / np.maximum(borne, 1e-9 * motion.disk.weight))
    carried, turns = motion.outcome is Outcome.AIRBORNE, abs(precession_rate(motion.state[-1:])[0]) / (2 * np.pi)
    when = f", lost at {motion.t[-1]:.5g} s, {motion.state[-1, 1]:.3g} rad, {turns:.3g} turns a second"
    return Finding(
        key="carried_by_air",
        claim=LOST_TO_AIR if acts else "In its air, which is left out, the contact would be lost to it",
        value=1.0 if carried else float(share),
        unit="greatest lift of the film / vertical force" + (when if carried else ""),
        at_least=1.0,
        tolerance=1e-6,
        source="Reynolds' equation on the falling film",
    )


@finding(
    "The motion of the rigid disk is audible through the open film",
    "dB above the threshold of hearing",
    "ISO 226; the air at the rim gives back what the face takes",
    at_least=0.0,
)
def heard_through_film(sound: Sound) -> float:
    """By how much heave and tilt of the rigid disk rise above the threshold of hearing, in the loudest third octave."""
    seen = [band_levels(spectrogram(sound.track(name), WINDOW)) for name in ("heave", "tilt")]
    return float(max((levels - THRESHOLD_DB[:, None]).max() for levels in seen))


@finding(
    "The friction of the scene lets the precession rate grow as measured",
    "exponent of the precession rate in the time left",
    "recordings of disks on granite, 2026: 0.31(3)",
    at_least=MEASURED,
    at_most=MEASURED,
    tolerance=SPREAD,
)
def friction_exponent(scene: Scene):
    """The exponent of the precession rate in the time left that the friction of the scene gives a steady disk.

    Of a power P ~ beta^p it is 1/(2 (1 - p)): 1/3 of contour friction, 1 of the arm k_2. The film is not in it.
    """
    low, high = INCLINATIONS
    slope = log(steady_friction(scene, high) / steady_friction(scene, low)) / log(high / low)
    return 1 / (2 * (1 - slope)) if slope < 1 else float("inf")


def steady_friction(scene: Scene, beta: float) -> float:
    """Return the power that all but the film takes of a steady disk at inclination `beta` [rad], dimensionless."""
    return steady_power(beta, law_of(scene.disk, scene.friction), resistance(scene.dissipation, scene.disk))


def film_powers(motion: Motion, film: Film):
    """Return what the turning and the falling film take [W], (2, n), at the times of the motion."""
    chi, unit = motion.disk.time_unit, motion.disk.mass * motion.disk.radius**2 / motion.disk.time_unit**3
    return np.array(film.powers(motion.state[:, 1], motion.state[:, 5:8].T * chi)) * unit


def lifts(motion: Motion, film: Film):
    """Return the lift of the film [N], (n,), at the times of the motion."""
    disk, state = motion.disk, motion.state
    push = film.at(state[:, 1], state[:, 5:8].T * disk.time_unit)[2]
    return push * disk.mass * disk.radius / disk.time_unit**2


def _integral(power, motion):
    return cumulative_trapezoid(power, x=motion.t, initial=0)
