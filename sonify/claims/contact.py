"""ELASTIC CONTACT -> FINDINGS: whether a carrier rises, whether it is the contact's, and whether
contact is lost."""

from typing import NamedTuple

import numpy as np
from scipy.signal import welch
from scipy.special import ndtr

from dynamics import Motion
from dynamics.compliant.law.hertz_mindlin import LEAST_INCLINATION
from dynamics.compliant.law.linear_response import (
    predicted_power,
    predicted_rms,
    predicted_spectrum,
)
from dynamics.compliant.law.roughness import shift_of_contact
from dynamics.compliant.law.statistical_linearisation import effective_load_factor
from dynamics.compliant.law.tabulated import LawTable, SeriesLawTable
from dynamics.compliant.model_inputs import law_table
from dynamics.compliant.model_selection import CONTACT_LOSS_RMS
from dynamics.film.activation import decide_film
from sonify.claims.finding import Finding, Measured, finding, median, registered
from sonify.hearing.noise_band import NoiseBand, middle, noise_band
from sonify.hearing.recording import Heard
from sonify.scene import Scene
from sonify.sound.pressure import Sound
from sonify.sound.radiation import listener_of
from sonify.sound.sources.contact_vibration import VibratingDisk

PLACES = 96
"""Instants of the motion at which its vibration is predicted."""
SOFTENED = 12
"""Instants at which it is asked how much softer the contact is than a linear one."""
FINE = 800
"""Instants of the line in a picture: early in a motion it swings with the nutation."""
STRETCH, READINGS = 0.5, 12
"""The carrier is heard in stretches of so many seconds, and expected at so many instants in
each."""

RATE, WELCH = 96e3, 4096
"""The force of a solved contact is read so often [1/s], its spectrum taken of so many readings."""
MOVED = 1.1
"""A band that is heard so much above that of the force is not the contact's any more."""

STEADY = 5.0
"""Spread of a steady carrier [cents]."""
LASTING = 0.2
"""Part of the sound through which a steady carrier is heard."""
RECORDED, CONSTANT = (1840.0, 2280.0), (5040.0, 8230.0)
"""Peaks recorded of the toy on granite [Hz]: those between which the carrier passes, and two that
stay."""
TOO_LOW = 1.1, 1.9
"""By what factor the rms of the filter may be too low where the disk rolls, and where it slides."""
CERTAIN = 0.4
"""Above this rms of N' over the weight contact is lost in any case, between SHAKEN and it in some
motions."""
SCATTER = 0.2
"""Of the power that roughness takes, relative: of its prediction, and from one surface to
another."""
LEAST_LOSS = 1e-4
"""Contact that is lost for a smaller part of the time is not broken by vibrations: a slip may do
that."""


class Vibration(NamedTuple):
    """What the linear contact lets expect along a motion, at even times t (k,) [s].

    Inclination [rad], normal force without the vibration [N], speed of the contact [m/s], whether
    it rolls; the `rms` of N' [N], the power [W] that roughness takes, and rms(z'') R/beta of the
    several contacts; and the factor on the load that makes the linear contact as soft as one that
    vibrates so, 1 along a rigid motion."""

    table: LawTable
    t: np.ndarray
    inclination: np.ndarray
    load: np.ndarray
    speed: np.ndarray
    rolls: np.ndarray
    rms: np.ndarray
    power: np.ndarray
    shift: np.ndarray
    softer: np.ndarray


def vibration(scene: Scene, motion: Motion) -> Vibration:
    """Return what the heights and the law of a scene let expect along its motion, while one ellipse
    is the contact."""
    table = table_of(scene, motion)
    t = last_ellipse(motion) * (np.arange(PLACES) + 0.5) / PLACES
    inclination, load, speed, rolls = course(motion, t)
    rms, power, shift = np.zeros((3, PLACES))
    if scene.roughness is not None:
        rms = predicted_rms(table, scene.roughness, inclination, load, speed)
        power = predicted_power(table, scene.roughness, inclination, load, speed)
        half = table.law.semi_axes(inclination, load)[0]
        shift = shift_of_contact(scene.roughness, inclination, half, scene.disk.radius)
    softer = softness(scene, motion, t)
    return Vibration(table, t, inclination, load, speed, rolls, rms, power, shift, softer)


def table_of(scene: Scene, motion: Motion) -> LawTable:
    """Return the law of the contact as the motion has it, or the filter along it."""
    return law_table(scene, SeriesLawTable if motion.solves_contact else LawTable)


def softness(scene: Scene, motion: Motion, t) -> np.ndarray:
    """Return the factors (k,) on the load at times t (k,) [s], even and ascending, with which the
    linear contact is as soft as that of a motion that vibrates: 1 along a rigid one."""
    if scene.roughness is None or not motion.solves_contact:
        return np.ones(len(t))
    some = np.linspace(t[0], t[-1], SOFTENED)
    inclination, load, speed, _ = course(motion, some)
    return np.interp(
        t,
        some,
        effective_load_factor(table_of(scene, motion), scene.roughness, inclination, load, speed),
    )


def course(motion: Motion, t):
    """Return inclination [rad], normal force [N], speed of the contact on the table [m/s], whether
    it rolls, (k,)."""
    state = motion.at(t)
    load = motion.steady_load(t)
    turning = state[:, 6] - state[:, 7] / np.tan(state[:, 1])
    speed = np.abs(motion.disk.radius * turning + state[:, 8])
    return (
        state[:, 1],
        np.maximum(load, 0.01 * motion.disk.weight),
        speed,
        np.char.startswith(motion.regime(t), "roll"),
    )


def contact_findings(
    scene: Scene, motion: Motion, sound: Sound, known: Heard | None = None
) -> tuple[list[Finding], list[str]]:
    """The claims on an elastic contact that this run can judge, on a carrier where there is
    roughness to ring it; and from when on one ellipse is not the contact. Of what is `known` of the
    sound, its steady carriers are no band."""
    if scene.contact.law == "rigid":
        return [], []
    expected = vibration(scene, motion)
    marked = several_contacts(expected.t, expected.shift)
    broken = [
        contact_is_lost(motion, expected),
        *([micro_flights(motion)] if motion.contact_losses else []),
    ]
    if scene.roughness is None:
        return broken, marked
    lasting = (
        [c for c in known.lines if c.end - c.begin > LASTING * known.duration] if known else []
    )
    lines = [c.frequency for c in lasting if c.spread < STEADY]
    heard = carrier_heard(sound, motion, expected, lines)
    found = (
        carrier_findings(scene, motion, expected, heard)
        if np.isfinite(heard.frequency).sum() >= 3
        else []
    )
    rms = np.hypot(scene.roughness.rms or 0.0, scene.roughness.edge_rms) / 2**0.5
    rough = [loss_begins_at(float(rms), expected)] if rms and not scene.roughness.profile else []
    return [
        *found,
        *broken,
        *rough,
        roughness_ends_it(scene.roughness.loss, motion, expected),
    ], marked


def carrier_findings(scene, motion, expected: Vibration, heard: NoiseBand) -> list[Finding]:
    """The claims on the carrier that is heard."""
    recorded = [carrier_passes_recorded_peaks(expected), constant_peaks_are_the_contact(expected)]
    found = bands(scene, motion, expected, heard)
    by_air = [air_moves_carrier(found)] if decide_film(scene).film else []
    return [carrier_rises(heard), carrier_is_contact(found), *by_air, *recorded]


def carrier_heard(sound: Sound, motion: Motion, expected: Vibration, lines=()) -> NoiseBand:
    """Return the band of noise in the pressure, in the time of the motion, while the contact is one
    ellipse."""
    delay = sound.source_end - motion.t[-1]
    heard = noise_band(sound.pressure, delay, delay + expected.t[-1], STRETCH, lines)
    return heard._replace(time=heard.time - delay)


@finding(
    "A carrier rises",
    "times",
    "abstract: the rising pitch; from the sound alone",
    needs=("sound",),
    at_least=1.2,
)
def carrier_rises(heard: NoiseBand):
    """The frequency of the carrier at the end over that at the beginning, each the median of a
    tenth of the run."""
    found = heard.frequency[np.isfinite(heard.frequency)]
    tenth = max(len(found) // 10, 1)
    first = median(found[:tenth])
    last = median(found[-tenth:])
    ratio = last.value / first.value
    margin = ratio * np.hypot(first.margin / first.value, last.margin / last.value)
    return Measured(ratio, margin, {"from": first.value, "to": last.value})


class Bands(NamedTuple):
    """The middles (s,) [Hz] of bands in some stretches: heard; expected of the contact along the
    motion, as the air radiates it; of its force N' alone, solved where the motion has it; and of
    that as the air radiates it."""

    heard: np.ndarray
    expected: np.ndarray
    force: np.ndarray
    radiated: np.ndarray


def bands(scene, motion, expected: Vibration, heard: NoiseBand) -> Bands:
    """Return where a band was heard, and where contact and air let it be expected."""
    f = np.arange(500.0, 20e3, 10.0)
    disk = VibratingDisk(scene, listener_of(scene)) if decide_film(scene).film else None
    shown = np.flatnonzero(np.isfinite(heard.frequency))[
        :: max(np.isfinite(heard.frequency).sum() // READINGS, 1)
    ]
    found = []
    for i in shown:
        t = heard.time[i] + STRETCH * ((np.arange(READINGS) + 0.5) / READINGS - 0.5)
        inclination, load, *rest = course(motion, np.minimum(t, expected.t[-1]))
        places = zip(
            inclination, load * np.interp(t, expected.t, expected.softer), *rest, strict=True
        )
        force = [
            predicted_spectrum(expected.table, scene.roughness, b, N, V, f, rolls=r)
            for b, N, V, r in places
        ]
        louder = np.array(
            [disk.mean_square_pressure(b, f) if disk else np.ones_like(f) for b in inclination]
        )
        solved = (
            solved_spectrum(motion, t[[0, -1]], f)
            if motion.solves_contact
            else np.mean(force, axis=0)
        )
        powers = np.mean(louder * force, axis=0), solved, louder.mean(axis=0) * solved
        found.append(
            [heard.frequency[i], *(middle(f, power, f[power.argmax()]) for power in powers)]
        )
    return Bands(*np.array(found).T)


def solved_spectrum(motion: Motion, span, f) -> np.ndarray:
    """Return the power spectral density (f,) [N^2/Hz] of the normal force of a motion in a span of
    time [s]."""
    t = np.arange(span[0], min(span[1], motion.t[-1]), 1 / RATE)
    return np.interp(f, *welch(motion.force(t)[:, 2], RATE, nperseg=min(WELCH, len(t))))


@finding(
    "The carrier is the resonance of the disk on its elastic contact",
    "heard / expected of the contact along the motion, median",
    "Hertz, Mindlin and Kalker; the carrier from the sound alone",
    needs=("motion", "contact law", "sound"),
    at_least=0.98,
    at_most=1.02,
)
def carrier_is_contact(found: Bands):
    """The frequency of the carrier heard over the middle of the spectrum that is expected of N', as
    it is radiated where a film is under the disk, median."""
    ratio = median(found.heard / found.expected)
    return ratio._replace(details={"force_alone": np.median(found.force / found.expected)})


@finding(
    "The resonance of film and air, not the contact's, sets the band that is heard",
    "heard / that of the force alone, median",
    "the force of the contact, and what a disk over its film radiates; the carrier from the sound "
    "alone",
    needs=("motion", "contact law", "sound"),
    at_least=MOVED,
)
def air_moves_carrier(found: Bands):
    """The frequency of the carrier heard over that of the force of the contact, which no air has
    changed, median."""
    ratio = median(found.heard / found.force)
    return ratio._replace(details={"force_as_radiated": np.median(found.heard / found.radiated)})


@finding(
    "The carrier passes the peaks recorded on granite, 1.84 to 2.28 kHz",
    "s between them",
    "recordings of the toy on granite, 2026",
    needs=("motion", "contact law"),
    at_least=1.0,
)
def carrier_passes_recorded_peaks(expected: Vibration):
    """For how long the resonance of the contact lies where peaks were recorded."""
    when = expected.t[(frequency(expected) > RECORDED[0]) & (frequency(expected) < RECORDED[1])]
    span = {"from": when[0], "to": when[-1]} if len(when) else {}
    return Measured(len(when) * expected.t[-1] / PLACES, 2 * expected.t[-1] / PLACES, span)


@finding(
    "The constant peaks of recordings, 5.04 and 8.23 kHz, are the contact's",
    "of the motion, within 2 % of either",
    "recordings of the toy on granite, 2026; what stays as the disk falls is of the table or the "
    "air",
    needs=("motion", "contact law"),
    at_least=0.5,
)
def constant_peaks_are_the_contact(expected: Vibration):
    """For how long, at most, the resonance of the contact stays within 2 % of a peak that
    recordings keep."""
    step = expected.t[1] - expected.t[0]
    stays = [
        float(np.sum(np.abs(frequency(expected) / peak - 1) < 0.02) * step) for peak in CONSTANT
    ]
    return Measured(max(stays) / expected.t[-1], 2 / PLACES)


@finding(
    "Vibrations finally break the contact",
    "of the time without contact",
    "abstract: the vibrations will result in a loss of contact",
    needs=("motion", "contact law"),
    at_least=LEAST_LOSS,
)
def contact_is_lost(motion: Motion, expected: Vibration):
    """The share of the time without contact: as solved, or, where the motion keeps it, of a
    Gaussian vibration."""
    flights = motion.contact_losses
    solved = bool(motion.contact_losses) or motion.solves_contact
    if solved:
        lasts = np.array([f.duration for f in flights])
        share = lasts.sum() / motion.t[-1]
        first = flights[0].t if flights else np.inf
        margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]  # flights as independent events
    else:
        lost = without_contact(expected, 1.0)
        share = lost.mean()
        first = expected.t[lost > LEAST_LOSS].min(initial=np.inf)
        margin = without_contact(expected, np.where(expected.rolls, *TOO_LOW)).mean() - share
    details = {"solved": float(solved)} | ({"first": first} if np.isfinite(first) else {})
    return Measured(share, margin, details)


def without_contact(expected: Vibration, factor) -> np.ndarray:
    """Return the part of the time (k,) in which a Gaussian vibration of `factor` times the rms has
    no contact."""
    return np.where(
        expected.rms > 0, ndtr(-expected.load / np.maximum(factor * expected.rms, 1e-300)), 0.0
    )


@finding(
    "Contact is lost in micro-flights, too short to be seen",
    "s, the longest",
    "Borisov et al. (2015)",
    needs=("motion", "contact law"),
    at_most=1e-3,
)
def micro_flights(motion: Motion):
    """The longest loss of contact of a motion that has any."""
    flights = motion.contact_losses
    longest = np.sort([f.duration for f in flights])[::-1]
    details = {"number": len(flights), "height": max(f.height for f in flights)}
    return Measured(longest[0], longest[0] - longest[: len(longest) // 10 + 1][-1], details)


@finding(
    "The roughness of an ordinary surface, 0.1 um, breaks the contact",
    "m, the rms of table and edge each from which on contact is lost",
    "abstract; N' is proportional to the heights",
    needs=("motion", "contact law"),
    at_most=1e-7,
)
def loss_begins_at(rms: float, expected: Vibration):
    """The rms of heights at which N' would reach SHAKEN of the weight at some time, by
    proportion."""
    most = expected.rms.max() / expected.table.law.disk.weight
    return Measured(rms * CONTACT_LOSS_RMS / most, rms * (CERTAIN - CONTACT_LOSS_RMS) / most)


@registered(needs=("motion", "contact law"))
def roughness_ends_it(loss: str, motion: Motion, expected: Vibration) -> Finding:
    """The share of the energy lost that goes to roughness: what the contact and its creep took, or
    would take; `loss` is that of the roughness, "own" or "fitted"."""
    fitted = loss == "fitted"
    if motion.solves_contact:
        lost = {
            cause: float(energy[0]) for cause, energy in motion.energy_lost(motion.t[-1:]).items()
        }
        where = "a part of the friction" if fitted else "in addition to friction"
        share = (lost["contact"] + lost["creep"]) / sum(lost.values())
    else:
        took = expected.power.mean() * expected.t[-1]
        lost = motion.state[-1, 10]
        share = took / (lost if fitted else lost + took)
        where = "held by friction" if fitted else "in addition to friction, and not in this motion"
    return Finding(
        key="roughness_ends_it",
        claim="Roughness is what ends the motion",
        value=float(share),
        unit=f"of the energy lost, {where}",
        at_least=0.5,
        margin=float(SCATTER * share),
        needs=("motion", "contact law"),
        source=f"the power of N' at the rate at which the heights rise; roughness.loss = '{loss}'",
    )


def several_contacts(t, shift) -> list[str]:
    """Return from when on one ellipse is an approximation: rms(z'') R/beta (k,) at times (k,) [s]
    is above 1."""
    late = np.flatnonzero(np.asarray(shift) > 1)
    if not len(late):
        return []
    return [
        f"From t = {t[late[0]]:.4g} s on the disk touches at several places at once: one ellipse "
        f"stands for them."
    ]


def carrier_line(
    scene: Scene, motion: Motion, delay: float
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return times (k,) [s], `delay` after those of the motion, and the resonance of an elastic
    contact (k,) [Hz]."""
    if scene.contact.law == "rigid":
        return None
    t = last_ellipse(motion) * (np.arange(FINE) + 0.5) / FINE
    inclination, load, speed, _ = course(motion, t)
    soft = softness(scene, motion, t) * load
    return t + delay, table_of(scene, motion).carrier(inclination, soft, speed).frequency


def frequency(expected: Vibration) -> np.ndarray:
    """Return the resonance of the contact (k,) [Hz] along a motion."""
    return expected.table.carrier(
        expected.inclination, expected.softer * expected.load, expected.speed
    ).frequency


def last_ellipse(motion: Motion) -> float:
    """Return until when [s] the contact of a motion is one ellipse."""
    return float(motion.t[np.flatnonzero(motion.state[:, 1] >= LEAST_INCLINATION)[-1]])
