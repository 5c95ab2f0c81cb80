"""Beats of a disk that rolls: the modulation of its sound once or a few times per turn.

The turns of the disk are known, as in a simulation. In each window of the sound, the
detector of settling disks scores how well its onset strength follows them, as it scores
the laws that it finds itself in recordings."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from sonify.hearing.audio_source import AudioSource, loudest_channel, read_samples
from sonify.hearing.loudness import a_weighting_db
from sonify.hearing.settling.candidates import settling_candidates
from sonify.hearing.settling.detector import is_bouncing, is_heard
from sonify.hearing.settling.onset_strength import (
    FRAME_RATE,
    Frames,
    OnsetStrength,
    onset_strength,
)
from sonify.hearing.settling.prediction_score import (
    independent_samples,
    part_gains,
    single_component_score,
)
from sonify.hearing.settling.rate_laws import Law, Shape
from sonify.hearing.settling.settings import SETTLING

BEATS_PER_TURN = (1, 2, 3, 4)
"""Numbers of beats per turn that are sought."""
AVERAGED_BURSTS = 2.0
"""Number of bursts over which a rate of bursts is averaged."""


class Beats(NamedTuple):
    """Beats of one number per turn, from the first to the last window with them.

    Attributes
    ----------
    per_turn : int
        Number of beats per turn of the contact.
    first, last : float
        Rates [Hz] at the beginning and at the end.
    relative_margin : float
        Relative error of the ratio of the rates: half a beat in each of both windows.
    begin, end : float
        Time [s] of the beginning and of the end.
    depth : float
        Smallest modulation depth, relative to the threshold of its detection.
    score : float
        Smallest score of the windows.
    """

    per_turn: int
    first: float
    last: float
    relative_margin: float
    begin: float
    end: float
    depth: float
    score: float

    @property
    def factor(self) -> float:
        """Ratio of the last to the first rate."""
        return self.last / self.first


class BeatWindow(NamedTuple):
    """Audible beats in one window: rates [Hz] at its beginning and end, times [s] of
    both, number of beats, relative modulation depth and score."""

    first: float
    last: float
    begin: float
    end: float
    beat_count: float
    depth: float
    score: float


@dataclass(frozen=True, eq=False)
class KnownShape(Shape):
    """Phase of known turns, from 0 to 1, at equally spaced times of a window."""

    known: np.ndarray = field(default_factory=lambda: np.array([0.0, 1.0]))

    def phase(self, x: float | np.ndarray) -> np.ndarray:
        """Return the phase (n,) at relative times x (n,)."""
        return np.interp(x, np.linspace(0.0, 1.0, len(self.known)), self.known)


def detectable_depth(rate: float) -> float:
    """Return the smallest modulation depth that is heard at a rate [Hz].

    Thresholds for broadband noise are about -25 dB up to 50 Hz and rise like those of a
    low-pass filter of first order (Viemeister, J. Acoust. Soc. Am. 66, 1979, 1364).

    Examples
    --------
    >>> round(detectable_depth(10.0), 3), round(detectable_depth(500.0), 2)
    (0.057, 0.51)
    """
    threshold_of_slow_modulation = 10 ** (-25 / 20)
    cutoff = 55.0  # Hz
    return float(threshold_of_slow_modulation * np.hypot(1.0, rate / cutoff))


def find_beats(
    sound: AudioSource,
    turns: Callable[[np.ndarray], np.ndarray],
    end: float,
    audible: Callable[[float, float], bool],
) -> Beats | None:
    """Return the audible beats that rise most, or None if there are none.

    Parameters
    ----------
    sound : AudioSource
        The sound of a disk that is known to come to rest.
    turns : callable
        Number of turns (n,) of the contact at times (n,) [s] of the sound.
    end : float
        End of the motion in the sound [s].
    audible : callable
        Returns True if the sound is audible between two times [s].
    """
    found: dict[int, list[BeatWindow]] = {count: [] for count in BEATS_PER_TURN}
    for begin, length in beat_windows(end):
        if not audible(begin, begin + length):
            continue
        for count, window in beats_in_window(sound, turns, begin, length).items():
            found[count].append(window)
    rises = [joined(count, windows) for count, windows in found.items() if windows]
    return max(rises, key=lambda beats: abs(np.log(beats.factor)), default=None)


def find_bursts(sound: AudioSource, end: float) -> Beats | None:
    """Return the audible bursts of a disk that rattles, or None if there are none.

    They do not keep the phase of its turns. The detector searches their law before the
    end of the motion [s], as in a recording; the number per turn is not known and 0. The
    rates are those of two bursts, the last ones 50 ms before the end of the window, where
    levels are lost."""
    searched = 5.0  # s
    unresolved = 0.05  # s
    last_end = 0.1  # s, before the end of the motion, in which the bursts may end
    rate = sound.sample_rate
    begin = max(end - searched, 0.0)
    samples = loudest_channel(read_samples(sound, int(begin * rate), int(end * rate)))
    frames = Frames(samples, rate)
    onsets = onset_strength(frames)
    candidates = settling_candidates(frames, onsets, (end - begin - last_end, np.inf))
    heard = [one for one in candidates if is_heard(one) and not is_bouncing(one)]
    if not heard:
        return None
    best = heard[0]
    inside = best.window.frames
    law = best.law
    edges = np.arange(inside.start, inside.stop + 1)
    beats = law.turns * law.shape.phase(np.linspace(0.0, 1.0, len(edges)))
    power = a_weighted_power(frames)[inside]
    depth = relative_depth(power, beats, best.window.seconds)
    if depth < 1:
        return None
    time = begin + edges / FRAME_RATE
    last = len(edges) - 1 - round(unresolved * FRAME_RATE)
    relative_margin = float(np.hypot(0.5, 0.5) / law.turns)
    return Beats(
        0,
        rate_of_bursts(time, beats, AVERAGED_BURSTS),
        rate_of_bursts(time, beats, float(beats[last])),
        relative_margin,
        float(time[0]),
        float(time[last]),
        depth,
        float(best.score),
    )


def rate_of_bursts(time: np.ndarray, beats: np.ndarray, last: float) -> float:
    """Return the rate [Hz] of the bursts up to the number `last` of `beats` (n,) at
    times (n,) [s]."""
    begin, end = np.interp([last - AVERAGED_BURSTS, last], beats, time)
    return float(AVERAGED_BURSTS / (end - begin))


def beat_windows(end: float) -> list[tuple[float, float]]:
    """Return beginning and length [s] of the windows: equally spaced ones of the
    greatest length, and shorter ones before the end."""
    spaced_count = 7
    longest = max(SETTLING.window_lengths)
    length = min(longest, end)
    last = end - length
    starts = np.linspace(0.0, last, spaced_count) if last > length else [last]
    shorter = [other for other in SETTLING.window_lengths[1::2] if other < length]
    return [
        *((float(start), length) for start in starts),
        *((end - other, other) for other in shorter),
    ]


def beats_in_window(
    sound: AudioSource,
    turns: Callable[[np.ndarray], np.ndarray],
    begin: float,
    length: float,
) -> dict[int, BeatWindow]:
    """Return the audible beats in a window of the sound, by their number per turn."""
    rate = sound.sample_rate
    first = int(begin * rate)
    samples = loudest_channel(read_samples(sound, first, first + int(length * rate)))
    if not np.any(samples):
        return {}
    frames = Frames(samples / np.abs(samples).max(), rate)
    power = a_weighted_power(frames)
    time = begin + (np.arange(len(power) + 1)) / FRAME_RATE
    turned = turns(time)
    turned = np.abs(turned - turned[0])
    depths = {
        count: relative_depth(power, count * turned, length)
        for count in BEATS_PER_TURN
        if law_of_turns(count * turned).turns >= SETTLING.min_turns
    }
    audible = {count: depth for count, depth in depths.items() if depth >= 1}
    if not audible:
        return {}
    onsets = onset_strength(frames)
    found = {}
    for count, depth in audible.items():
        beats = count * turned
        score, heard = score_of_known_law(onsets, law_of_turns(beats))
        if score > SETTLING.min_detected_score and heard.any():
            found[count] = window_of_parts(time, beats, heard, depth, score)
    return found


def law_of_turns(beats: np.ndarray) -> Law:
    """Return the law of known beats (n + 1,) at the edges of the frames of a window."""
    total = float(beats[-1])
    shape = KnownShape("known", 1.0, known=beats / max(total, 1e-12))
    return Law(shape, total, 1, 0.0)


def a_weighted_power(frames: Frames) -> np.ndarray:
    """Return the A-weighted power (n,) of the frames of a sound."""
    middle = np.sqrt(frames.edges[1:] * frames.edges[:-1])
    return frames.power @ 10 ** (a_weighting_db(middle) / 10)


def relative_depth(power: np.ndarray, beats: np.ndarray, length: float) -> float:
    """Return the modulation depth of a power (n,), relative to the threshold of its
    detection at the mean rate.

    A small depth m modulates the power by 2 m."""
    phase = np.exp(-2j * np.pi * (beats[1:] + beats[:-1]) / 2)
    depth = abs(np.mean((power - power.mean()) * phase)) / power.mean()
    return float(depth / detectable_depth(beats[-1] / length))


def score_of_known_law(onsets: OnsetStrength, law: Law) -> tuple[float, np.ndarray]:
    """Return the score of a known law in the channel that it predicts best, and a mask
    (parts,) of the parts of the window that it predicts better than a constant."""
    gains = [part_gains(values, law) for values in onsets.values]
    best = int(np.argmax([gain.sum() for gain in gains]))
    samples, components = independent_samples(
        onsets.values[best], onsets.scales_ms[best], law
    )
    score = float(samples * components * gains[best].sum())
    return single_component_score(score, components, law.harmonics), gains[best] > 0


def window_of_parts(
    time: np.ndarray, beats: np.ndarray, heard: np.ndarray, depth: float, score: float
) -> BeatWindow:
    """Return the beats from the first to the last part (parts,) in which they are
    heard; times (n,) [s] and beats (n,) are those at the edges of the frames."""
    cuts = np.round(np.linspace(0, len(time) - 1, len(heard) + 1)).astype(int)
    rates = np.diff(beats[cuts]) / np.diff(time[cuts])
    first, last = np.flatnonzero(heard)[[0, -1]]
    return BeatWindow(
        float(rates[first]),
        float(rates[last]),
        float(time[cuts[first]]),
        float(time[cuts[last + 1]]),
        float(beats[-1]),
        depth,
        score,
    )


def joined(per_turn: int, windows: list[BeatWindow]) -> Beats:
    """Return the beats from the first to the last of several windows."""
    first = min(windows, key=lambda window: window.begin)
    last = max(windows, key=lambda window: (window.end, window.last))
    return Beats(
        per_turn,
        first.first,
        last.last,
        float(np.hypot(0.5 / first.beat_count, 0.5 / last.beat_count)),
        first.begin,
        last.end,
        min(window.depth for window in windows),
        min(window.score for window in windows),
    )
