"""Findings on the rendered sound, compared with the solved motion and modes."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from scipy.signal import sosfilt

from dynamics import Motion
from dynamics.observables import nutation_frequency, precession_frequency
from modal import Modes
from sonify.claims.finding import Finding, Measured, finding, median_with_margin
from sonify.hearing.loudness import (
    ISO_226_THRESHOLD_DB,
    LEVEL_WINDOW_S,
    level_db,
    levels_above_threshold,
)
from sonify.hearing.recording import Heard, listen_to_known_disk
from sonify.hearing.recording_errors import RecordingError
from sonify.hearing.spectrogram import spectrogram
from sonify.sound.playback import a_weighting
from sonify.sound.pressure import STEMS, Sound, Track

if TYPE_CHECKING:
    from sonify.hearing.settling.settling_law import SettlingLaw
    from sonify.hearing.settling.tone_ridge import ToneRidge

FINAL_INTERVAL_DURATION = 1.0
"""Length of the final interval [s] in which the paper claims a sharp rise of the
pitch."""


def analyse_sound(
    sound: Sound, listen: Callable[[Track, float], Heard] = listen_to_known_disk
) -> tuple[Heard | None, list[str]]:
    """Return the analysis of the rendered sound, or None, and notes on claims that were
    not judged.

    `listen` analyses the pressure up to the end of the motion."""
    try:
        heard = listen(sound.pressure, sound.source_end)
    except RecordingError as error:
        return None, [f"Verdicts on the sound: {error}."]
    if heard.tone is None:
        return heard, ["Claims on the rising tone, because no rising tone stands out."]
    return heard, []


def sound_findings(
    heard: Heard | None, motion: Motion, modes: Modes, sound: Sound, error: float
) -> list[Finding]:
    """Return the findings on the sound of a run.

    The claim on the energy of the modes requires a motion without them. Claims about
    the end require a disk that settles. `error` is the predicted relative rms deviation
    of the sound from that at accuracy "reference"."""
    found = []
    if heard is not None and heard.lines:
        found.append(carriers_are_steady(heard))
        if len(modes.frequency):
            found.append(carriers_are_modes(heard, modes))
    if not motion.energy_lost(motion.t[-1:])["body"][0] > 0:  # one-way coupling
        found.append(modes_take_little(motion, sound, error))
    found.append(sound_is_audible(sound))
    if motion.rolling_outcome.name != "SETTLED":
        return found
    found = [modes_carry_the_end(sound, error), *found]
    tone = None if heard is None else heard.tone
    if tone is None:
        return found
    return [
        *tone_rate_findings(tone, motion, sound),
        tone_is_heard(tone, sound),
        tone_ends_with_the_motion(tone, sound),
        *found,
    ]


def tone_rate_findings(
    tone: "SettlingLaw", motion: Motion, sound: Sound
) -> list[Finding]:
    """Return the findings that compare the tone with solved rates; empty without
    nutation.

    The tone is compared with the precession in the last second, and with the nutation
    until four seconds before the end."""
    nutates = nutation_frequency(motion)[0]
    if not len(nutates):
        return []
    time = _ridge_of(tone).time
    last = time > sound.source_end - FINAL_INTERVAL_DURATION
    delay = sound.source_end - motion.t[-1]
    early = (time < sound.source_end - 4 * FINAL_INTERVAL_DURATION) & (
        time - delay <= nutates[-1]
    )
    found = []
    if last.any():
        found.append(tone_is_precession(tone, last, motion, sound))
    if early.any():
        found.append(tone_was_nutation(tone, early, motion, sound))
    return found


def rise_of(tone: "SettlingLaw") -> Measured:
    """Return the ratio of the final to the initial frequency of a tone."""
    assert tone.exponent.value is not None, "only an end can be missing"
    factor = _ridge_of(tone).factor
    margin = factor * np.log(factor) * tone.exponent.half_width / tone.exponent.value
    return Measured(factor, margin)


@finding(needs=("tone", "motion", "sound"), at_least=0.97, at_most=1.03)
def tone_is_precession(
    tone: "SettlingLaw", last: np.ndarray, motion: Motion, sound: Sound
) -> Measured:
    """The median ratio of the tone frequency to the solved precession in the frames
    `last` (r,)."""
    return _tone_ratio(tone, last, motion, sound, precession_frequency(motion))


@finding(needs=("tone", "motion", "sound"), at_least=0.97, at_most=1.03)
def tone_was_nutation(
    tone: "SettlingLaw", early: np.ndarray, motion: Motion, sound: Sound
) -> Measured:
    """The median ratio of the tone frequency to the solved nutation in the frames
    `early` (r,)."""
    return _tone_ratio(tone, early, motion, sound, nutation_frequency(motion))


@finding(needs=("tone", "sound"), at_least=-0.1, at_most=0.1)
def tone_ends_with_the_motion(tone: "SettlingLaw", sound: Sound) -> Measured:
    """The time [s] from the end of the motion, at the listener, to the fitted end of
    the tone."""
    assert tone.t_end.value is not None, "the sound of a run is not cut"
    return Measured(tone.t_end.value - sound.source_end, tone.t_end.half_width)


@finding(needs=("tone", "sound"), at_least=0.5)
def tone_is_heard(tone: "SettlingLaw", sound: Sound) -> Measured:
    """The time before the end [s] from which the third-octave band of the tone stays
    above the threshold of hearing."""
    window = LEVEL_WINDOW_S / 4
    seen = spectrogram(sound.pressure, window)
    assert tone.t_end.value is not None, "the sound of a run is not cut"
    end = min(tone.t_end.value, sound.source_end) - window / 2
    inside = (seen.time < end) & (seen.time > 0.1)
    time = seen.time[inside]
    bands = np.array(list(ISO_226_THRESHOLD_DB))
    above = levels_above_threshold(seen)[:, inside]
    band = np.abs(np.log(tone.rate(time)[:, None] / bands)).argmin(axis=1)
    silent = np.flatnonzero(~(above[band, np.arange(len(band))] > 0))
    first_heard = silent[-1] + 1 if len(silent) else 0
    begin = time[first_heard] if first_heard < len(time) else sound.source_end
    return Measured(sound.source_end - begin, window)


@finding(needs=("sound",), at_least=0.0)
def sound_is_audible(sound: Sound) -> Measured:
    """The greatest third-octave level above the threshold of hearing [dB] in short
    windows.

    The details include the share of the windows with a level above the threshold.
    """
    window = 0.2  # s
    seen = spectrogram(sound.pressure, window, span=(0.0, sound.source_end))
    loudest = levels_above_threshold(seen).max(axis=0)
    details = {"audible_share": float((loudest > 0).mean())}
    return Measured(float(loudest.max()), details=details)


@finding(needs=("sound",), at_least=0.0)
def modes_carry_the_end(sound: Sound, error: float) -> Measured:
    """The level of the modes relative to the rigid motion of the disk in the last
    second [dB(A)].

    The energy of a sound with the relative rms error `error` is accurate to a factor (1
    + error)^2."""
    heave, tilt, smooth, jumps = (sound.track(name) for name in STEMS)
    modes = weighted_power(sound, [smooth, jumps])
    rigid = weighted_power(sound, [heave, tilt])
    return Measured(level_db(modes) - level_db(rigid), 20 * np.log10(1 + error))


@finding(needs=("motion", "sound"), at_most=0.0)
def modes_take_little(motion: Motion, sound: Sound, error: float = 0.0) -> Measured:
    """The time before the end [s] at which the energy of the modes first exceeds that
    of the disk.

    Until then one-way coupling is valid. The energy of the modes is accurate to a
    factor (1 + error)^2, as in `modes_carry_the_end`."""
    return time_of_energy_share(motion, sound.energy_time, sound.energy, error)


def time_of_energy_share(
    motion: Motion, t: np.ndarray, energy: np.ndarray, error: float, share: float = 1.0
) -> Measured:
    """Return the time before the end [s] at which an energy first exceeds a share of
    that of the disk.

    The energy (e,) [J] at times t (e,) [s] is accurate to a factor (1 + error)^2. The
    time is 0 if the energy never exceeds the share. The margin is the change of a
    positive time for the lowest possible energy, or of a zero time for the highest."""
    inside = (t >= 0) & (t <= motion.t[-1])
    t = t[inside]
    energy = energy[inside]
    whole = share * motion.energy(t)

    def since(factor: float) -> float:
        more = np.flatnonzero(factor * energy > whole)
        return float(motion.t[-1] - t[more[0]]) if len(more) else 0.0

    value = since(1.0)
    margin = value - since((1 + error) ** -2) if value else since((1 + error) ** 2)
    return Measured(value, margin)


@finding(needs=("sound",), at_most=5.0)
def carriers_are_steady(heard: Heard) -> Measured:
    """The greater of the spread and the drift of the strongest spectral line [cents].

    The spread of five frames is accurate to one half of its value.
    """
    one = heard.lines[0]
    drift, error = (
        x * (one.end - one.begin) for x in (abs(one.drift), one.drift_error)
    )
    return Measured(max(one.spread, drift), max(one.spread / 2, 2 * error))


@finding(needs=("sound", "modes"), at_most=5.0)
def carriers_are_modes(heard: Heard, modes: Modes) -> Measured:
    """The distance of the strongest spectral line from the nearest mode [cents]."""
    one = heard.lines[0]
    distance = np.abs(1200 * np.log2(one.frequency / modes.frequency)).min()
    return Measured(distance, 2 * 1200 / np.log(2) * one.error / one.frequency)


def _ridge_of(tone: "SettlingLaw") -> "ToneRidge":
    """Return the ridge of a run that was detected as a tone."""
    assert tone.ridge is not None, "the run was detected by its bursts"
    return tone.ridge


def _tone_ratio(
    tone: "SettlingLaw",
    frames: np.ndarray,
    motion: Motion,
    sound: Sound,
    solved: tuple[np.ndarray, np.ndarray],
) -> Measured:
    """Return the median ratio of the tone frequency to a solved rate in the frames
    `frames` (r,)."""
    delay = sound.source_end - motion.t[-1]
    ridge = _ridge_of(tone)
    rate = np.interp(ridge.time[frames] - delay, *solved)
    independent_share = 0.05  # of the frames, which overlap
    return median_with_margin(ridge.frequency[frames] / rate, independent_share)


def weighted_power(sound: Sound, stems: list[Track]) -> float:
    """Return the A-weighted mean square [Pa^2] of a sum of stems over the last second of
    the motion."""
    rate = sound.sample_rate
    end = int(sound.source_end * rate)
    begin = max(end - int(FINAL_INTERVAL_DURATION * rate), 0)
    settled = max(begin - rate // 2, 0)  # leaves time for the filter transient to decay
    pressure = sum(stem.read(settled, end).astype(float) for stem in stems)
    weighted = sosfilt(a_weighting(rate), pressure)
    return float(np.mean(weighted[begin - settled :] ** 2))
