"""FRAMES -> CANDIDATES: windows whose bursts follow the law of a disk, scored against rival
laws."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from sonify.hearing.settling.ends import drop_peaks, end_drops
from sonify.hearing.settling.onset_strength import FRAME_RATE, Frames, OnsetStrength
from sonify.hearing.settling.prediction_score import correlation_length, law_phases, predicted_gain
from sonify.hearing.settling.rate_laws import Law, distance_to_end, families
from sonify.hearing.settling.refinement import refine
from sonify.hearing.settling.settings import SettlingSettings
from sonify.hearing.settling.warped_periodogram import likelihoods, strongest_laws

STEADY_RIVALS = ("flat", "slowing")
RISING_RIVALS = ("linear", "exponential")


@dataclass(frozen=True)
class Window:
    """Frames `first` up to `stop` before the end at frame `end`, where the power drops by `drop`
    [dB]."""

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
    """A window, the channel and the law of a disk that fit it best, and how well rival laws predict
    it.

    `scores` holds the prediction score of every family, `slope` that of the pulse levels against
    the time left."""

    window: Window
    channel: int
    law: Law
    scores: dict[str, float]
    slope: float

    @property
    def steady_margin(self):
        """T: how much better the disk predicts than steady or slowing rates."""
        return self.scores["disk"] - max(0.0, *(self.scores[name] for name in STEADY_RIVALS))

    @property
    def rising_margin(self):
        """W: how much better the disk predicts than linearly or exponentially rising rates."""
        return self.scores["disk"] - max(self.scores[name] for name in RISING_RIVALS)

    @property
    def score(self):
        """Q, by which candidates are ranked and heard."""
        return min(self.steady_margin, self.rising_margin + 20)

    @property
    def first_rate(self):
        """Rate at the beginning of the window [Hz]."""
        return self.law.turns * self.law.shape.first_rate / self.window.seconds

    @property
    def t_end(self):
        """Time of the end of the law [s]."""
        left = distance_to_end(self.law.shape.ratio, self.law.shape.exponent)
        return self.window.stop / FRAME_RATE + left * self.window.seconds

    @property
    def exponent(self):
        """Exponent n of the rate."""
        return self.law.shape.exponent


def candidates_of(
    frames: Frames, onsets: OnsetStrength, settings: SettlingSettings, span: tuple[float, float]
) -> list[Candidate]:
    """Return the refined candidates of a sound whose power drops within a span of time [s], the
    best first."""
    broadband = frames.power.sum(axis=1)
    drops = end_drops(frames)
    peaks = drop_peaks(drops, settings.heard_drop_db)
    peaks = peaks[(peaks >= span[0] * FRAME_RATE) & (peaks < span[1] * FRAME_RATE)]
    block = np.floor(peaks / (settings.block * FRAME_RATE)).astype(int)
    ends = [peaks[block == number][: settings.ends_per_block] for number in np.unique(block)]
    with ThreadPoolExecutor() as pool:  # the compiled loops and transforms release Python's lock
        parts = pool.map(
            lambda some: _best_candidates(onsets, broadband, some, drops, settings), ends
        )
        found = [candidate for part in parts for candidate in part]
    return sorted(found, key=lambda candidate: -candidate.score)


def windows_of(end: int, drop: float, settings: SettlingSettings) -> list[Window]:
    """Return the windows that stop at an end."""
    frames = [round(length * FRAME_RATE) for length in settings.window_lengths]
    return [Window(end - count, end, end, drop) for count in frames if end >= count]


def _best_candidates(onsets: OnsetStrength, broadband, ends, drops, settings):
    """The refined candidates of the best windows of a block."""
    rough = []
    for end in ends:
        for window in windows_of(int(end), float(drops[end]), settings):
            every = range(len(onsets.values))
            distance = settings.coarse_distance
            found = _loudest_channels(onsets, window, settings, distance, every)
            if found[0][1] >= settings.rivals_from:
                estimate = _estimate(onsets, window, found[0][0], settings, distance)
                channels = [channel for channel, _ in found[: settings.searched_channels]]
                rough.append((estimate[0], window, channels))
    rough.sort(key=lambda entry: -entry[0])
    promising = []
    for _, late, channels in rough[: settings.searched_windows]:
        distance = settings.shape_distance
        channel = _loudest_channels(onsets, late, settings, distance, channels)[0][0]
        estimate = _estimate(onsets, late, channel, settings, distance)
        early = _earlier(late, settings)
        promising.append(estimate)
        if estimate[0] >= settings.refined_from and early.first >= 0:
            promising.append(_estimate(onsets, early, channel, settings, distance))
    promising.sort(key=lambda entry: -entry[0])
    return [
        _refined(onsets, broadband, window, channel, starts, settings)
        for score, window, channel, starts in promising[: settings.refined_windows]
        if score >= settings.refined_from
    ]


def _earlier(window, settings):
    """The same window, `early_stop` earlier."""
    frames = round(settings.early_stop * FRAME_RATE)
    return replace(window, first=window.first - frames, stop=window.stop - frames)


def _loudest_channels(onsets, window, settings, distance, channels):
    """Channels and the log likelihood of a disk in each, in a window, the most likely first."""
    family = families(settings, distance)["disk"]
    channels = np.array(channels)
    values = onsets.values[channels, window.first : window.stop]
    best = likelihoods(values, onsets.scales_ms[channels], family, settings)
    order = np.argsort(-best, kind="stable")
    return list(zip(channels[order].tolist(), best[order].tolist(), strict=True))


def _estimate(onsets, window, channel, settings, distance):
    """A first estimate of the score of a window, the window, its channel and the best laws of every
    family."""
    values = onsets.values[channel, window.first : window.stop]
    starts = {
        name: strongest_laws(values, onsets.scales_ms[channel], family, settings)
        for name, family in families(settings, distance).items()
    }
    best = {name: laws[0].likelihood for name, laws in starts.items()}
    steady = max(0.0, *(best[name] for name in STEADY_RIVALS))
    rising = max(best[name] for name in RISING_RIVALS)
    return min(best["disk"] - steady, best["disk"] - rising + 20), window, channel, starts


def _refined(onsets, broadband, window, channel, starts, settings):
    """A candidate with all its laws refined."""
    values = onsets.values[channel, window.first : window.stop]
    scale = onsets.scales_ms[channel]
    laws = {family: refine(values, scale, laws, settings) for family, laws in starts.items()}
    disk = laws["disk"]
    memory = correlation_length(values, law_phases(len(values), disk), disk.harmonics)
    independent = len(values) / max(scale, memory)
    scores = {family: independent * predicted_gain(values, law) for family, law in laws.items()}
    levels = onsets.values[channel] ** 2 if onsets.kinds[channel] == "tone" else broadband
    after = levels[window.end + 30 : window.end + 130].mean()
    slope = pulse_slope(levels[window.first : window.stop], laws["disk"], window, 4 * after)
    return Candidate(window, channel, laws["disk"], scores, slope)


def pulse_slope(power: np.ndarray, law: Law, window: Window, least: float = 0.0) -> float:
    """Return the slope of the highest level of every turn [dB] against 20 log10 of the time left to
    the end, where it exceeds the `least` power."""
    count = len(power)
    places = (np.arange(count) + 0.5) / count
    turn = np.floor(law.turns * law.shape.phase(places)).astype(int)
    left = (1 + distance_to_end(law.shape.ratio, law.shape.exponent) - places) * window.seconds
    begins = np.flatnonzero(np.diff(turn, prepend=-1))
    level = 10 * np.log10(np.maximum.reduceat(power, begins) + 1e-14)
    ends = np.append(begins[1:], count) - 1
    kept = (left[ends] >= 0.05) & (level > 10 * np.log10(least + 1e-14))
    if np.count_nonzero(kept) < 4:
        return 0.0
    middle = 20 * np.log10(left[(begins + ends) // 2])
    return float(np.polyfit(middle[kept], level[kept], 1)[0])
