"""ELASTIC CONTACT -> FINDINGS: rising noise band, contact resonance, and losses of contact."""

from typing import NamedTuple

import numpy as np
from scipy.signal import welch
from scipy.special import ndtr

from dynamics import Motion
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
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
from dynamics.rattling.rattling_motion import RattlingMotion
from sonify.claims.finding import Finding, Measured, finding, median_with_margin, register_judge
from sonify.hearing.noise_band import NoiseBand, middle, noise_band
from sonify.hearing.recording import Heard
from sonify.scene import Scene
from sonify.sound.pressure import Sound
from sonify.sound.radiation import listener_of
from sonify.sound.sources.contact_vibration import VibratingDisk

VIBRATION_TIMES = 96
"""Number of instants at which the vibration of a motion is predicted."""
LOAD_FACTOR_TIMES = 12
"""Number of instants at which the effective load factor of the contact is computed."""
SPECTRUM_FREQUENCIES = 800
"""Number of points of the plotted resonance, which oscillates with the nutation early on."""
NOISE_BAND_INTERVAL = 0.5
"""Length of the intervals in which the noise band is measured [s]."""
PREDICTIONS_PER_INTERVAL = 12

FORCE_SAMPLE_RATE = 96e3
"""Sample rate of the spectrum of a solved contact force [1/s]."""
WELCH_SEGMENT = 4096
"""Length of the segments of this spectrum [samples]."""
MIN_RADIATION_FREQUENCY_RATIO = 1.1
"""Ratio of measured to contact-force frequency above which the air sets the noise band."""

MAX_STEADY_LINE_SPREAD = 5.0
"""Greatest spread of a steady spectral line [cents]."""
MIN_STEADY_LINE_DURATION = 0.2
"""Least duration of a steady spectral line, as a share of the sound."""
RECORDED_RISING_PEAK = (1840.0, 2280.0)
"""Recorded limits of the rising peak of the toy on granite [Hz]."""
RECORDED_CONSTANT_PEAKS = (5040.0, 8230.0)  # Hz
RMS_ERROR_FACTORS = 1.1, 1.9
"""Factor by which the linear filter may underestimate the rms of N', in rolling and in sliding."""
CERTAIN_LOSS_RMS = 0.4
"""Rms of N' over the weight above which every motion loses contact.

Between CONTACT_LOSS_RMS and this value some motions lose it.
"""
LOSS_RMS_SCATTER = 0.2
"""Relative uncertainty of the power lost to roughness, from its prediction and between surfaces."""
MIN_OPEN_SHARE = 1e-4
"""Least share of time without contact that is attributed to vibrations instead of a slip."""


class Vibration(NamedTuple):
    """Predicted contact vibration along a motion, at equally spaced times t (k,) [s].

    Attributes
    ----------
    table : LawTable
        Tabulated law of the contact.
    t : array (k,)
        Times [s].
    inclination, load, speed : array (k,)
        Inclination [rad], normal force without vibration [N] and speed of the contact [m/s].
    rolls : array (k,)
        True while the disk rolls.
    rms : array (k,)
        Rms of the vibration N' of the normal force [N].
    power : array (k,)
        Power lost to roughness [W].
    shift : array (k,)
        rms(z'') R/beta; above 1 the disk touches at several points.
    softer : array (k,)
        Load factor that gives the linear contact the mean stiffness of the vibrating one; 1 along a
        rigid motion.
    """

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
    """Return the vibration predicted along a motion while the contact is one ellipse."""
    table = table_of(scene, motion)
    t = last_elliptic_inclination(motion) * (np.arange(VIBRATION_TIMES) + 0.5) / VIBRATION_TIMES
    inclination, load, speed, rolls = nominal_motion(motion, t)
    rms, power, shift = np.zeros((3, VIBRATION_TIMES))
    if scene.roughness is not None:
        rms = predicted_rms(table, scene.roughness, inclination, load, speed)
        power = predicted_power(table, scene.roughness, inclination, load, speed)
        half = table.law.semi_axes(inclination, load)[0]
        shift = shift_of_contact(scene.roughness, inclination, half, scene.disk.radius)
    softer = softening(scene, motion, t)
    return Vibration(table, t, inclination, load, speed, rolls, rms, power, shift, softer)


def table_of(scene: Scene, motion: Motion) -> LawTable:
    """Return the tabulated contact law of a scene, in the form that its motion uses."""
    return law_table(scene, SeriesLawTable if motion.solves_contact else LawTable)


def softening(scene: Scene, motion: Motion, t) -> np.ndarray:
    """Return the load factors (k,) at ascending times t (k,) [s] that give the linear contact the
    mean stiffness of the vibrating one; 1 along a rigid motion.
    """
    if scene.roughness is None or not motion.solves_contact:
        return np.ones(len(t))
    some = np.linspace(t[0], t[-1], LOAD_FACTOR_TIMES)
    inclination, load, speed, _ = nominal_motion(motion, some)
    return np.interp(
        t,
        some,
        effective_load_factor(table_of(scene, motion), scene.roughness, inclination, load, speed),
    )


def nominal_motion(motion: Motion, t):
    """Return inclination [rad], normal force [N], speed of the contact on the table [m/s], and True
    for rolling, each (k,), at times t (k,) [s].
    """
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
    """Return the findings on an elastic contact, and a note on the time with several contacts.

    Claims on the noise band need roughness. Steady spectral lines in `known`, the analysis of the
    sound, are excluded from the noise band.
    """
    if scene.contact.law == "rigid":
        return [], []
    expected = vibration(scene, motion)
    marked = second_contact_times(expected.t, expected.shift)
    broken = [
        contact_is_lost(motion, expected),
        *([micro_flights(motion)] if motion.contact_losses else []),
    ]
    if scene.roughness is None:
        return broken, marked
    lasting = (
        [c for c in known.lines if c.end - c.begin > MIN_STEADY_LINE_DURATION * known.duration]
        if known
        else []
    )
    lines = [c.frequency for c in lasting if c.spread < MAX_STEADY_LINE_SPREAD]
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
    """Return the findings on the noise band."""
    recorded = [carrier_passes_recorded_peaks(expected), constant_peaks_are_the_contact(expected)]
    found = radiated_bands(scene, motion, expected, heard)
    by_air = [air_moves_carrier(found)] if decide_film(scene).film else []
    return [carrier_rises(heard), carrier_is_contact(found), *by_air, *recorded]


def carrier_heard(sound: Sound, motion: Motion, expected: Vibration, lines=()) -> NoiseBand:
    """Return the noise band of the pressure, at times of the motion, while the contact is one
    ellipse.
    """
    delay = sound.source_end - motion.t[-1]
    heard = noise_band(sound.pressure, delay, delay + expected.t[-1], NOISE_BAND_INTERVAL, lines)
    return heard._replace(time=heard.time - delay)


@finding(
    "A carrier rises",
    "times",
    "abstract: the rising pitch; from the sound alone",
    needs=("sound",),
    at_least=1.2,
)
def carrier_rises(heard: NoiseBand):
    """The frequency of the noise band at the end over that at the start, each the median of a tenth
    of its intervals.
    """
    found = heard.frequency[np.isfinite(heard.frequency)]
    tenth = max(len(found) // 10, 1)
    first = median_with_margin(found[:tenth])
    last = median_with_margin(found[-tenth:])
    ratio = last.value / first.value
    margin = ratio * np.hypot(first.margin / first.value, last.margin / last.value)
    return Measured(ratio, margin, {"from": first.value, "to": last.value})


class RadiatedBands(NamedTuple):
    """Centre frequencies (s,) [Hz] of the noise band in selected intervals.

    Attributes
    ----------
    heard
        Measured in the sound.
    expected
        Predicted by the linear contact along the motion, including radiation into the air.
    force
        Of the force N' alone, solved if the motion includes it, otherwise predicted.
    radiated
        Of the same force, including radiation into the air.
    """

    heard: np.ndarray
    expected: np.ndarray
    force: np.ndarray
    radiated: np.ndarray


def radiated_bands(scene, motion, expected: Vibration, heard: NoiseBand) -> RadiatedBands:
    """Return the measured and predicted centre frequencies of the noise band."""
    f = np.arange(500.0, 20e3, 10.0)
    disk = VibratingDisk(scene, listener_of(scene)) if decide_film(scene).film else None
    shown = np.flatnonzero(np.isfinite(heard.frequency))[
        :: max(np.isfinite(heard.frequency).sum() // PREDICTIONS_PER_INTERVAL, 1)
    ]
    found = []
    for i in shown:
        t = heard.time[i] + NOISE_BAND_INTERVAL * (
            (np.arange(PREDICTIONS_PER_INTERVAL) + 0.5) / PREDICTIONS_PER_INTERVAL - 0.5
        )
        inclination, load, *rest = nominal_motion(motion, np.minimum(t, expected.t[-1]))
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
    return RadiatedBands(*np.array(found).T)


def solved_spectrum(motion: Motion, span, f) -> np.ndarray:
    """Return the power spectral density (f,) [N^2/Hz] of the normal force in a time span [s], at
    frequencies f (f,) [Hz].
    """
    t = np.arange(span[0], min(span[1], motion.t[-1]), 1 / FORCE_SAMPLE_RATE)
    return np.interp(
        f, *welch(motion.force(t)[:, 2], FORCE_SAMPLE_RATE, nperseg=min(WELCH_SEGMENT, len(t)))
    )


@finding(
    "The carrier is the resonance of the disk on its elastic contact",
    "heard / expected of the contact along the motion, median",
    "Hertz, Mindlin and Kalker; the carrier from the sound alone",
    needs=("motion", "contact law", "sound"),
    at_least=0.98,
    at_most=1.02,
)
def carrier_is_contact(found: RadiatedBands):
    """The median of the measured over the predicted frequency of the noise band.

    With a film under the disk, the prediction includes its effect on the radiation.
    """
    ratio = median_with_margin(found.heard / found.expected)
    return ratio._replace(details={"force_alone": np.median(found.force / found.expected)})


@finding(
    "The resonance of film and air, not the contact's, sets the band that is heard",
    "heard / that of the force alone, median",
    "the force of the contact, and what a disk over its film radiates; the carrier from the sound "
    "alone",
    needs=("motion", "contact law", "sound"),
    at_least=MIN_RADIATION_FREQUENCY_RATIO,
)
def air_moves_carrier(found: RadiatedBands):
    """The median of the measured frequency of the noise band over that of the contact force."""
    ratio = median_with_margin(found.heard / found.force)
    return ratio._replace(details={"force_as_radiated": np.median(found.heard / found.radiated)})


@finding(
    "The carrier passes the peaks recorded on granite, 1.84 to 2.28 kHz",
    "s between them",
    "recordings of the toy on granite, 2026",
    needs=("motion", "contact law"),
    at_least=1.0,
)
def carrier_passes_recorded_peaks(expected: Vibration):
    """The time [s] during which the contact resonance is between the recorded peaks."""
    when = expected.t[
        (contact_frequency(expected) > RECORDED_RISING_PEAK[0])
        & (contact_frequency(expected) < RECORDED_RISING_PEAK[1])
    ]
    span = {"from": when[0], "to": when[-1]} if len(when) else {}
    return Measured(
        len(when) * expected.t[-1] / VIBRATION_TIMES, 2 * expected.t[-1] / VIBRATION_TIMES, span
    )


@finding(
    "The constant peaks of recordings, 5.04 and 8.23 kHz, are the contact's",
    "of the motion, within 2 % of either",
    "recordings of the toy on granite, 2026; what stays as the disk falls is of the table or the "
    "air",
    needs=("motion", "contact law"),
    at_least=0.5,
)
def constant_peaks_are_the_contact(expected: Vibration):
    """The share of the motion in which the contact resonance is within 2 % of a constant peak.

    The greater share of the two peaks counts.
    """
    step = expected.t[1] - expected.t[0]
    stays = [
        float(np.sum(np.abs(contact_frequency(expected) / peak - 1) < 0.02) * step)
        for peak in RECORDED_CONSTANT_PEAKS
    ]
    return Measured(max(stays) / expected.t[-1], 2 / VIBRATION_TIMES)


@finding(
    "Vibrations finally break the contact",
    "of the time without contact",
    "abstract: the vibrations will result in a loss of contact",
    needs=("motion", "contact law"),
    at_least=MIN_OPEN_SHARE,
)
def contact_is_lost(motion: Motion, expected: Vibration):
    """The share of the time without contact.

    It is solved for an elastic contact or a motion with losses of contact. Otherwise it is
    predicted for a Gaussian vibration.
    """
    flights = motion.contact_losses
    solved = bool(motion.contact_losses) or motion.solves_contact
    if solved:
        lasts = np.array([f.duration for f in flights])
        share = lasts.sum() / motion.t[-1]
        first = flights[0].t if flights else np.inf
        margin = 2 * np.sqrt(np.sum(lasts**2)) / motion.t[-1]  # flights as independent events
    else:
        lost = open_contact_share(expected, 1.0)
        share = lost.mean()
        first = expected.t[lost > MIN_OPEN_SHARE].min(initial=np.inf)
        margin = (
            open_contact_share(expected, np.where(expected.rolls, *RMS_ERROR_FACTORS)).mean()
            - share
        )
    details = {"solved": float(solved)} | ({"first": first} if np.isfinite(first) else {})
    return Measured(share, margin, details)


def open_contact_share(expected: Vibration, factor) -> np.ndarray:
    """Return the share of the time (k,) without contact, for a Gaussian vibration with `factor`
    times the predicted rms.
    """
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
    """The duration [s] of the longest loss of contact."""
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
    """The rms of the heights [m] at which N' reaches CONTACT_LOSS_RMS of the weight, by
    proportion.
    """
    most = expected.rms.max() / expected.table.law.disk.weight
    return Measured(
        rms * CONTACT_LOSS_RMS / most, rms * (CERTAIN_LOSS_RMS - CONTACT_LOSS_RMS) / most
    )


@register_judge(needs=("motion", "contact law"))
def roughness_ends_it(loss: str, motion: Motion, expected: Vibration) -> Finding:
    """The share of roughness in the energy loss: the solved losses in contact and creep, or the
    predicted power.

    `loss` is that of the roughness, "own" or "fitted".
    """
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
        margin=float(LOSS_RMS_SCATTER * share),
        needs=("motion", "contact law"),
        source=f"the power of N' at the rate at which the heights rise; roughness.loss = '{loss}'",
    )


def second_contact_times(t, shift) -> list[str]:
    """Return a note on the time from which the disk touches at several points, or an empty list.

    The criterion is a `shift` rms(z'') R/beta (k,) above 1 at times t (k,) [s].
    """
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
    """Return times (k,) [s], delayed by `delay` [s], and the resonance of an elastic contact (k,)
    [Hz]; None for a rigid contact, and for several contacts at once.
    """
    if scene.contact.law == "rigid" or isinstance(motion, RattlingMotion):
        return None
    t = (
        last_elliptic_inclination(motion)
        * (np.arange(SPECTRUM_FREQUENCIES) + 0.5)
        / SPECTRUM_FREQUENCIES
    )
    inclination, load, speed, _ = nominal_motion(motion, t)
    soft = softening(scene, motion, t) * load
    return t + delay, table_of(scene, motion).carrier(inclination, soft, speed).frequency


def contact_frequency(expected: Vibration) -> np.ndarray:
    """Return the frequency of the contact resonance (k,) [Hz] along a motion."""
    return expected.table.carrier(
        expected.inclination, expected.softer * expected.load, expected.speed
    ).frequency


def last_elliptic_inclination(motion: Motion) -> float:
    """Return the last time [s] at which the contact of a motion is one ellipse."""
    return float(motion.t[np.flatnonzero(motion.state[:, 1] >= MIN_CONTACT_INCLINATION)[-1]])
