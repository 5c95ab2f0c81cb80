"""Candidate windows with bursts that follow the law of a disk, scored against rival
laws."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sonify.hearing.settling.ends import drop_peaks, end_drops
from sonify.hearing.settling.onset_strength import FRAME_RATE, Frames, OnsetStrength
from sonify.hearing.settling.prediction_score import (
    independent_samples,
    predicted_gain,
    single_component_score,
)
from sonify.hearing.settling.rate_laws import Law, distance_to_end, families
from sonify.hearing.settling.refinement import refine
from sonify.hearing.settling.settings import SETTLING
from sonify.hearing.settling.warped_periodogram import (
    largest_likelihoods,
    strongest_laws,
)

STEADY_RIVALS = ("flat", "slowing")
RISING_RIVALS = ("linear", "exponential")


@dataclass(frozen=True)
class Window:
    """Frames from `first` up to `stop`, before a `drop` [dB] of the power at frame
    `end`; without a drop, the sound stops there."""

    first: int
    stop: int
    end: int
    drop: float | None

    @property
    def shows_end(self) -> bool:
        """True if the power drops after the window."""
        return self.drop is not None

    @property
    def min_ratio(self) -> float:
        """Minimum ratio of the last to the first rate of a disk."""
        if self.shows_end:
            return SETTLING.rate_ratios[0]
        return SETTLING.min_rate_ratio_without_end

    def overlaps(self, other: "Window", margin: float = 0.0) -> bool:
        """Return True if two windows, each extended to its fitted end, are less than a
        margin [frames] apart."""
        return self.first < other.end + margin and other.first < self.end + margin

    @property
    def frames(self) -> slice:
        """Slice of the frames of the window."""
        return slice(self.first, self.stop)

    @property
    def seconds(self) -> float:
        """Length of the window [s]."""
        return (self.stop - self.first) / FRAME_RATE


@dataclass(frozen=True)
class Candidate:
    """A window with the best channel and disk law for it, and the scores of rival laws.

    `scores` contains the prediction score of each family. `slope` is that of the pulse
    levels against the remaining time. `components` is the number of independent
    components of the channel."""

    window: Window
    channel: int
    law: Law
    scores: dict[str, float]
    slope: float
    components: float = 1.0

    @property
    def end_of_law(self) -> int:
        """Frame at which the rate of the law diverges."""
        window = self.window
        left = distance_to_end(self.law.shape.ratio, self.law.shape.exponent)
        return window.stop + round(left * window.seconds * FRAME_RATE)

    @property
    def score(self) -> float:
        """Score Q, by which candidates are ranked and detected."""
        return single_component_score(
            score_of(self.scores), self.components, self.law.harmonics
        )


def rising_margin(scores: dict[str, float]) -> float:
    """Return the margin of the score of a disk over those of linearly and exponentially
    rising rates."""
    return scores["disk"] - max(scores[name] for name in RISING_RIVALS)


def score_of(scores: dict[str, float]) -> float:
    """Return the smaller of the margins of a disk: over steady and slowing rates, and 20
    plus that over other rising rates, which resemble a disk more closely."""
    steady = max(0.0, *(scores[name] for name in STEADY_RIVALS))
    return min(scores["disk"] - steady, rising_margin(scores) + 20)


def settling_candidates(
    frames: Frames, onsets: OnsetStrength, span: tuple[float, float]
) -> list[Candidate]:
    """Return the refined candidates that end within a time span [s], the best first.

    In each block of the sound, the ends with the largest drops are tried, and in the
    last block the end of the sound.
    """
    min_drop = 8.0  # dB
    block_length = 5.0  # s
    ends_per_block = 6
    broadband = frames.power.sum(axis=1)
    drops = end_drops(frames)
    peaks = drop_peaks(drops, min_drop)
    peaks = peaks[(peaks >= span[0] * FRAME_RATE) & (peaks < span[1] * FRAME_RATE)]
    block = np.floor(peaks / (block_length * FRAME_RATE)).astype(int)
    ends: list[list[tuple[int, float | None]]] = [
        [(int(end), float(drops[end])) for end in peaks[block == number]]
        for number in np.unique(block)
    ]
    ends = [places[:ends_per_block] for places in ends]
    if np.isinf(span[1]):
        ends.append([(len(broadband), None)])
    search = partial(_best_candidates, onsets, broadband)
    # the compiled loops and transforms release the lock of Python
    with ThreadPoolExecutor() as pool:
        found = [
            candidate
            for channels in onsets.channels_by_components
            for block_found in pool.map(partial(search, channels), ends)
            for candidate in block_found
        ]
    return sorted(found, key=lambda candidate: -candidate.score)


def windows_before_end(end: int, drop: float | None) -> list[Window]:
    """Return the windows that stop at an end."""
    frames = [round(length * FRAME_RATE) for length in SETTLING.window_lengths]
    return [Window(end - count, end, end, drop) for count in frames if end >= count]


def _best_candidates(
    onsets: OnsetStrength,
    broadband: np.ndarray,
    every: np.ndarray,
    ends: list[tuple[int, float | None]],
) -> list[Candidate]:
    """Return the refined candidates of the best windows of a block in the channels
    `every`, before `ends`, each with its drop [dB].

    The best windows of a coarse search are searched again in their best channels, and
    those with a sufficient score also with earlier stops."""
    searched_window_count = 12
    searched_channel_count = 3
    refined_window_count = 6
    min_score = 6.0
    rough = []
    for end, drop in ends:
        for window in windows_before_end(end, drop):
            distance = SETTLING.coarse_distance
            channels, likelihood = _loudest_channels(onsets, window, distance, every)
            if likelihood[0] >= SETTLING.min_likelihood_for_rivals:
                best = _rough_likelihoods(onsets, window, channels[0])
                channels = channels[:searched_channel_count]
                rough.append((score_of(best), window, channels, best))
    rough.sort(key=lambda entry: -entry[0])
    promising = []
    for _, window, channels, best in rough[:searched_window_count]:
        distance = SETTLING.shape_distance
        ranked, likelihood = _loudest_channels(onsets, window, distance, channels)
        channel = ranked[0]
        if channel != channels[0]:
            best = _rough_likelihoods(onsets, window, channel)
        # the likelihoods of rivals only increase with the density of their shapes
        if score_of({**best, "disk": likelihood[0]}) < min_score:
            continue
        estimate = _estimate_window_score(onsets, window, channel)
        promising.append(estimate)
        if estimate[0] >= min_score:
            promising += [
                _estimate_window_score(onsets, earlier, channel)
                for earlier in _earlier_windows(window, len(onsets.values[channel]))
            ]
    promising.sort(key=lambda entry: -entry[0])
    return [
        _refined_candidate(onsets, broadband, window, channel, starts)
        for score, window, channel, starts in promising[:refined_window_count]
        if score >= min_score
    ]


def _earlier_windows(window: Window, component_count: int) -> list[Window]:
    """Return a window shifted to earlier times by 40 ms, and by 80 ms for channels of
    several components, in which a last knock may follow the end."""
    seconds = (0.04,) if component_count == 1 else (0.04, 0.08)
    shifts = [round(shift * FRAME_RATE) for shift in seconds]
    return [
        replace(window, first=window.first - frames, stop=window.stop - frames)
        for frames in shifts
        if window.first >= frames
    ]


def _loudest_channels(
    onsets: OnsetStrength, window: Window, distance: float, channels: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return channels (c,) in order of decreasing log likelihood of a disk, and these
    likelihoods (c,)."""
    disk = families(distance, "disk", window.min_ratio)
    best = np.array(
        [
            largest_likelihoods(
                onsets.values[one][:, window.frames], onsets.scales_ms[one], disk
            )[0]
            for one in channels
        ]
    )
    order = np.argsort(-best, kind="stable")
    return channels[order], best[order]


def _rough_likelihoods(
    onsets: OnsetStrength, window: Window, channel: int
) -> dict[str, float]:
    """Return the largest log likelihoods of each family in a coarse search of a window
    in a channel."""
    shapes = families(SETTLING.coarse_distance, None, window.min_ratio)
    values = onsets.values[channel][:, window.frames]
    best = largest_likelihoods(values, onsets.scales_ms[channel], shapes)
    return dict(zip(shapes.names, best.tolist(), strict=True))


def _estimate_window_score(
    onsets: OnsetStrength, window: Window, channel: int
) -> tuple[float, Window, int, dict[str, list[Law]]]:
    """Return a first estimate of the score of a window, with the window, the channel
    and the best laws."""
    values = onsets.values[channel][:, window.frames]
    shapes = families(SETTLING.shape_distance, None, window.min_ratio)
    starts = strongest_laws(values, onsets.scales_ms[channel], shapes)
    best = {name: laws[0].likelihood for name, laws in starts.items()}
    return score_of(best), window, channel, starts


def tone_candidates(
    waveform: np.ndarray, onsets: OnsetStrength, stop: int
) -> list[Candidate]:
    """Return the refined candidates of a tone in all windows of a waveform (frames,)
    that end at the frame `stop`, the best first."""
    power = np.square(waveform)

    def refined(window: Window) -> Candidate:
        _, searched, channel, starts = _estimate_window_score(onsets, window, 0)
        return _refined_candidate(onsets, power, searched, channel, starts)

    with ThreadPoolExecutor() as pool:  # the compiled loops release the lock of Python
        found = pool.map(refined, windows_before_end(stop, 0.0))
    return sorted(found, key=lambda candidate: -candidate.score)


def _refined_candidate(
    onsets: OnsetStrength,
    power: np.ndarray,
    window: Window,
    channel: int,
    starts: dict[str, list[Law]],
) -> Candidate:
    """Return the candidate of a window after refinement of its laws.

    The pulse levels are those of a power (frames,)."""
    values = onsets.values[channel][:, window.frames]
    scale = onsets.scales_ms[channel]
    laws = {
        family: refine(values, scale, laws, window.min_ratio)
        for family, laws in starts.items()
    }
    samples, components = independent_samples(values, scale, laws["disk"])
    scores = {
        family: samples * components * predicted_gain(values, law)
        for family, law in laws.items()
    }
    after = 0.0
    if window.drop:
        after = power[window.end + 30 : window.end + 130].mean()
    pulses = power[window.frames]
    slope = peak_level_exponent(pulses, laws["disk"], window, 4 * after)
    return Candidate(window, channel, laws["disk"], scores, slope, components)


def peak_level_exponent(
    power: np.ndarray, law: Law, window: Window, min_power: float
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
