"""Candidate windows with bursts that follow the law of a disk, scored against rival
laws."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from sonify.hearing.settling.ends import drop_peaks, end_drops
from sonify.hearing.settling.onset_strength import FRAME_RATE, Frames, OnsetStrength
from sonify.hearing.settling.prediction_score import (
    independent_samples,
    predicted_gain,
)
from sonify.hearing.settling.rate_laws import Law, distance_to_end, families
from sonify.hearing.settling.refinement import refine
from sonify.hearing.settling.settings import SettlingSettings
from sonify.hearing.settling.warped_periodogram import likelihoods, strongest_laws

STEADY_RIVALS = ("flat", "slowing")
RISING_RIVALS = ("linear", "exponential")


@dataclass(frozen=True)
class Window:
    """Frames from `first` up to `stop`, before a `drop` [dB] of the power at frame
    `end`."""

    first: int
    stop: int
    end: int
    drop: float

    @property
    def seconds(self):
        """Length of the window [s]."""
        return (self.stop - self.first) / FRAME_RATE


@dataclass(frozen=True)
class Candidate:
    """A window with the best channel and disk law for it, and the scores of rival laws.

    `scores` contains the prediction score of each family. `slope` is that of the pulse
    levels against the remaining time."""

    window: Window
    channel: int
    law: Law
    scores: dict[str, float]
    slope: float

    @property
    def steady_margin(self):
        """Margin T of the prediction score of the disk over those of steady and slowing
        rates."""
        return self.scores["disk"] - max(
            0.0, *(self.scores[name] for name in STEADY_RIVALS)
        )

    @property
    def rising_margin(self):
        """Margin W of the prediction score of the disk over those of linearly and
        exponentially rising rates."""
        return self.scores["disk"] - max(self.scores[name] for name in RISING_RIVALS)

    @property
    def score(self):
        """Score Q, by which candidates are ranked and detected."""
        return min(self.steady_margin, self.rising_margin + 20)

    @property
    def first_rate(self):
        """Rate at the beginning of the window [Hz]."""
        return self.law.turns * self.law.shape.first_rate / self.window.seconds

    @property
    def exponent(self):
        """Exponent n of the rate."""
        return self.law.shape.exponent


def candidates_of(
    frames: Frames,
    onsets: OnsetStrength,
    settings: SettlingSettings,
    span: tuple[float, float],
) -> list[Candidate]:
    """Return the refined candidates that end within a time span [s], the best first."""
    broadband = frames.power.sum(axis=1)
    drops = end_drops(frames)
    peaks = drop_peaks(drops, settings.min_drop_db)
    peaks = peaks[(peaks >= span[0] * FRAME_RATE) & (peaks < span[1] * FRAME_RATE)]
    block = np.floor(peaks / (settings.block_length * FRAME_RATE)).astype(int)
    ends = [
        peaks[block == number][: settings.ends_per_block] for number in np.unique(block)
    ]
    with (
        ThreadPoolExecutor() as pool
    ):  # the compiled loops and transforms release the lock of Python
        parts = pool.map(
            lambda block_ends: _best_candidates(
                onsets, broadband, block_ends, drops, settings
            ),
            ends,
        )
        found = [candidate for part in parts for candidate in part]
    return sorted(found, key=lambda candidate: -candidate.score)


def windows_of(end: int, drop: float, settings: SettlingSettings) -> list[Window]:
    """Return the windows that stop at an end."""
    frames = [round(length * FRAME_RATE) for length in settings.window_lengths]
    return [Window(end - count, end, end, drop) for count in frames if end >= count]


def _best_candidates(onsets: OnsetStrength, broadband, ends, drops, settings):
    """Return the refined candidates of the best windows of a block."""
    rough = []
    for end in ends:
        for window in windows_of(int(end), float(drops[end]), settings):
            every = range(len(onsets.values))
            distance = settings.coarse_distance
            found = _loudest_channels(onsets, window, settings, distance, every)
            if found[0][1] >= settings.min_likelihood_for_rivals:
                channels = [
                    channel for channel, _ in found[: settings.searched_channel_count]
                ]
                rough.append(
                    (
                        _rough_score(onsets, window, channels[:1], settings),
                        window,
                        channels,
                    )
                )
    rough.sort(key=lambda entry: -entry[0])
    promising = []
    for _, window, channels in rough[: settings.searched_window_count]:
        distance = settings.shape_distance
        channel = _loudest_channels(onsets, window, settings, distance, channels)[0][0]
        estimate = _estimate(onsets, window, channel, settings)
        earlier = _earlier(window, settings)
        promising.append(estimate)
        if estimate[0] >= settings.min_score_for_refinement and earlier.first >= 0:
            promising.append(_estimate(onsets, earlier, channel, settings))
    promising.sort(key=lambda entry: -entry[0])
    return [
        _refined(onsets, broadband, window, channel, starts, settings)
        for score, window, channel, starts in promising[: settings.refined_window_count]
        if score >= settings.min_score_for_refinement
    ]


def _earlier(window, settings):
    """Return a window shifted to earlier times by `early_stop_time`."""
    frames = round(settings.early_stop_time * FRAME_RATE)
    return replace(window, first=window.first - frames, stop=window.stop - frames)


def _loudest_channels(onsets, window, settings, distance, channels):
    """Return pairs of a channel and the log likelihood of a disk in it, the most likely
    first."""
    disk = families(settings, distance, "disk")
    channels = np.array(channels)
    values = onsets.values[channels, window.first : window.stop]
    best = likelihoods(values, onsets.scales_ms[channels], disk, settings)[:, 0]
    order = np.argsort(-best, kind="stable")
    return list(zip(channels[order].tolist(), best[order].tolist(), strict=True))


def _rough_score(onsets, window, channels, settings):
    """Return a coarse estimate of the score of a window in the first of `channels`."""
    shapes = families(settings, settings.coarse_distance)
    values = onsets.values[channels, window.first : window.stop]
    best = likelihoods(values, onsets.scales_ms[channels], shapes, settings)[0]
    return _likelihood_margin(dict(zip(shapes.names, best.tolist(), strict=True)))


def _estimate(onsets, window, channel, settings):
    """Return a first estimate of the score of a window, with the window, the channel
    and the best laws."""
    values = onsets.values[channel, window.first : window.stop]
    shapes = families(settings, settings.shape_distance)
    starts = strongest_laws(values, onsets.scales_ms[channel], shapes, settings)
    best = {name: laws[0].likelihood for name, laws in starts.items()}
    return _likelihood_margin(best), window, channel, starts


def _likelihood_margin(best):
    """Return the difference of the log likelihood of a disk from that of its rivals."""
    steady = max(0.0, *(best[name] for name in STEADY_RIVALS))
    rising = max(best[name] for name in RISING_RIVALS)
    return min(best["disk"] - steady, best["disk"] - rising + 20)


def tone_candidates(
    waveform: np.ndarray, onsets: OnsetStrength, stop: int, settings: SettlingSettings
) -> list[Candidate]:
    """Return the refined candidates of a tone in all windows of a waveform (frames,)
    that end at the frame `stop`, the best first."""
    power = np.square(waveform)

    def refined(window):
        estimate = _estimate(onsets, window, 0, settings)
        return _refined(onsets, power, *estimate[1:], settings)

    with ThreadPoolExecutor() as pool:  # the compiled loops release the lock of Python
        found = list(pool.map(refined, windows_of(stop, 0.0, settings)))
    return sorted(found, key=lambda candidate: -candidate.score)


def _refined(onsets, power, window, channel, starts, settings):
    """Return the candidate of a window after refinement of its laws.

    The pulse levels are those of a power (frames,)."""
    values = onsets.values[channel, window.first : window.stop]
    scale = onsets.scales_ms[channel]
    laws = {
        family: refine(values, scale, laws, settings) for family, laws in starts.items()
    }
    independent = independent_samples(values, scale, laws["disk"])
    scores = {
        family: independent * predicted_gain(values, law)
        for family, law in laws.items()
    }
    after = power[window.end + 30 : window.end + 130].mean() if window.drop else 0.0
    slope = pulse_slope(
        power[window.first : window.stop], laws["disk"], window, 4 * after
    )
    return Candidate(window, channel, laws["disk"], scores, slope)


def pulse_slope(
    power: np.ndarray, law: Law, window: Window, min_power: float = 0.0
) -> float:
    """Return the slope of the peak level of each turn [dB] against 20 log10 of the
    remaining time, for peaks above the power `min_power`."""
    count = len(power)
    places = (np.arange(count) + 0.5) / count
    turn = np.floor(law.turns * law.shape.phase(places)).astype(int)
    left = (
        1 + distance_to_end(law.shape.ratio, law.shape.exponent) - places
    ) * window.seconds
    begins = np.flatnonzero(np.diff(turn, prepend=-1))
    level = 10 * np.log10(np.maximum.reduceat(power, begins) + 1e-14)
    ends = np.append(begins[1:], count) - 1
    kept = (left[ends] >= 0.05) & (level > 10 * np.log10(min_power + 1e-14))
    if np.count_nonzero(kept) < 4:
        return 0.0
    middle = 20 * np.log10(left[(begins + ends) // 2])
    return float(np.polyfit(middle[kept], level[kept], 1)[0])
