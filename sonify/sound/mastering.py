"""Master a sound for small loudspeakers: compress its dynamics, then set loudness and
true peak."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from scipy.ndimage import minimum_filter1d, uniform_filter1d

from sonify.hearing.audio_source import (
    BLOCK_SIZE,
    AudioSource,
    Excerpt,
    overlapping_pieces,
)
from sonify.hearing.loudness import loudness_lufs
from sonify.sound.playback import (
    AUDIBLE_COPY_LOUDNESS_LUFS,
    AUDIBLE_COPY_PEAK_DBTP,
    MAX_TRUE_PEAK_RATIO,
    CachedTrack,
    Channels,
    DerivedTrack,
    ScaledTrack,
    WeightedTrack,
    true_peak,
    true_peaks,
)


@dataclass(frozen=True, kw_only=True)
class Mastering:
    """Settings of the mastering chain of compressor, gain, limiter and trim."""

    loudness_lufs: float = -18.0
    """Integrated loudness [LUFS] by BS.1770."""
    limit_dbtp: float = -1.5
    """Largest true peak [dBTP] allowed by the limiter; its meter may read 0.5 dB lower
    than other meters."""
    ratio: float = 3.0
    """Compression ratio: a level 3 dB below the loudest window is raised to 1 dB below
    it."""
    max_boost_db: float = 24.0
    """Maximum gain of the compressor [dB]; the loudest window is not amplified."""
    window: float = 0.1
    """Length [s] of the windows in which the compressor measures the level."""
    limiter_reach: float = 0.005
    """Time [s] before and after a peak during which the limiter lowers the gain."""
    max_gain_db: float = 120.0
    """Maximum gain [dB], relative to the gain that brings the highest peak to the
    limit."""
    sparse_gain_db: float = 12.0
    """Gain [dB], with the same reference, for a sound too sparse to reach the loudness,
    such as a single click."""
    tolerance: float = 0.2
    """Maximum excess loudness [LU] that the trim may remove."""


@dataclass(frozen=True, kw_only=True)
class TrackWithLeadIn(DerivedTrack):
    """A track preceded by a number of zero samples."""

    track: Any
    zeros: int

    @property
    def frames(self) -> int:
        """Number of samples."""
        return self.zeros + self.track.frames

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield the zeros, then the blocks of the track; `start` must be 0."""
        yield np.zeros((self.zeros, self.channels))
        yield from self.track.blocks(start)


def padded_pieces(track: AudioSource, reach: int) -> Iterator[np.ndarray]:
    """Return successive pieces of a track, each with `reach` samples before and after
    it; zeros precede the track."""
    padded = TrackWithLeadIn(track=track, zeros=reach)
    return overlapping_pieces(padded, BLOCK_SIZE, 2 * reach)


@dataclass(frozen=True, kw_only=True)
class ProcessedTrack(CachedTrack):
    """A track processed in pieces.

    Each piece depends on `context_samples` samples on both sides.
    """

    track: Any
    settings: Mastering

    @property
    def context_samples(self) -> int:
        """Number of samples before and after a piece that affect it."""
        raise NotImplementedError

    def processed(self, samples: np.ndarray) -> np.ndarray:
        """Return the processed samples (k, channels)."""
        raise NotImplementedError

    def computed_blocks(self) -> Iterator[np.ndarray]:
        """Yield the processed pieces (k, channels)."""
        reach = self.context_samples  # shorter than a piece
        pieces = padded_pieces(self.track, reach)
        for first, samples in zip(
            range(0, self.frames, BLOCK_SIZE), pieces, strict=False
        ):
            yield self.processed(samples)[
                reach : reach + min(BLOCK_SIZE, self.frames - first)
            ]


@dataclass(frozen=True, kw_only=True)
class CompressedTrack(ProcessedTrack):
    """A track with compressed dynamics.

    Quiet windows are amplified, by the same gain in all channels.

    `loudest` is the largest mean square of a window.
    """

    loudest: float

    @property
    def context_samples(self) -> int:
        """Half the length of a window [samples]."""
        return window_reach(self.sample_rate, self.settings)

    def processed(self, samples: np.ndarray) -> np.ndarray:
        """Return the samples multiplied by the gain of the compressor."""
        power = windowed_power(samples, self.context_samples)
        below = 10 * np.log10(self.loudest / np.maximum(power, 1e-30 * self.loudest))
        boost = np.clip(
            below * (1 - 1 / self.settings.ratio), 0.0, self.settings.max_boost_db
        )
        return samples * 10 ** (boost[:, None] / 20)


@dataclass(frozen=True, kw_only=True)
class MasteredTrack(ProcessedTrack):
    """A compressed track after gain, limiter and trim; 1.0 is full scale."""

    gain: float
    """Gain before the limiter [1/Pa]."""
    trim: float = 1.0
    """Gain after the limiter, at most 1."""

    @property
    def full_scale(self) -> float:
        """Pressure [Pa] represented by 1.0 where neither compressor nor limiter
        acts."""
        return 1 / (self.gain * self.trim)

    @property
    def context_samples(self) -> int:
        """Reach of the limiter and of its meter [samples]."""
        filter_reach = 32  # samples
        return 2 * limiter_reach_samples(self.sample_rate, self.settings) + filter_reach

    def processed(self, samples: np.ndarray) -> np.ndarray:
        """Return the samples after gain, limiter and trim.

        The gain is a moving average of local minima of the allowed gain and therefore
        never exceeds the allowed gain at a peak.
        """
        around = limiter_reach_samples(self.sample_rate, self.settings)
        loud = samples * self.gain
        limit = 10 ** (self.settings.limit_dbtp / 20)
        if np.abs(loud).max() * MAX_TRUE_PEAK_RATIO <= limit:
            return loud * self.trim
        allowed = limit / np.maximum(true_peaks(loud), limit)
        lowest = minimum_filter1d(allowed, 2 * around + 1)
        smooth = uniform_filter1d(uniform_filter1d(lowest, around), around)
        return loud * (np.minimum(smooth, allowed) * self.trim)[:, None]

    @cached_property
    def loudness(self) -> float:
        """Loudness [LUFS] of the complete gating blocks by BS.1770.

        Raises ValueError if the track is too short to have a loudness.
        """
        return loudness_lufs(Excerpt(self, 0, complete_gating_length(self)))


def complete_gating_length(track: AudioSource) -> int:
    """Return the length [samples] covered by complete gating blocks of 0.4 s that
    overlap by 75 %."""
    block = round(0.4 * track.sample_rate)
    if track.frames < block:
        return track.frames
    count = (10 * (track.frames - block)) // track.sample_rate
    return block + round(0.1 * count * track.sample_rate)


def window_reach(sample_rate: int, settings: Mastering) -> int:
    """Return half the length of a window of the compressor [samples]."""
    return max(round(settings.window * sample_rate / 2), 1)


def limiter_reach_samples(sample_rate: int, settings: Mastering) -> int:
    """Return the time before a peak during which the limiter lowers the gain
    [samples]."""
    return max(round(settings.limiter_reach * sample_rate), 1)


def windowed_power(samples: np.ndarray, reach: int) -> np.ndarray:
    """Return the mean square (k,) of samples (k, channels) in triangular windows."""
    power = np.square(samples).mean(axis=1)
    return uniform_filter1d(
        uniform_filter1d(power, reach, mode="constant"), reach, mode="constant"
    )


def loudest_window(track: Channels, settings: Mastering) -> float:
    """Return the largest mean square [Pa^2] of the windows of a track."""
    reach = window_reach(track.sample_rate, settings)
    return max(
        float(windowed_power(piece, reach)[reach:-reach].max())
        for piece in padded_pieces(track, reach)
    )


def master_copy(
    track: Channels, settings: Mastering | None = None
) -> MasteredTrack | ScaledTrack:
    """Return an A-weighted, compressed copy of a track [Pa] at the specified loudness.

    If a sound is too short to have a loudness, its highest peak is set to the limit. If
    it is too sparse to reach the loudness, it is amplified by `sparse_gain_db` before
    the limiter. A silent track is returned unchanged.
    """
    settings = settings or Mastering()
    weighted = WeightedTrack(track=track)
    loudest = loudest_window(weighted, settings)
    if not loudest:
        return ScaledTrack(track=weighted, full_scale=1.0)
    compressed = CompressedTrack(track=weighted, loudest=loudest, settings=settings)
    gain_to_limit = 10 ** (settings.limit_dbtp / 20) / true_peak(compressed)
    at_limit = MasteredTrack(track=compressed, gain=gain_to_limit, settings=settings)
    try:
        found = at_stated_loudness(at_limit)
    except ValueError:  # too short for a loudness
        found = at_limit
    return trimmed_below_limit(found)


def at_stated_loudness(at_limit: MasteredTrack) -> MasteredTrack:
    """Return the track at the specified loudness, or a quieter one if it cannot be
    reached.

    The gain before the limiter is increased until the loudness is reached; the trim
    then removes the excess. Raises ValueError if the track is too short.
    """
    settings = at_limit.settings
    raised_db = initial_gain_step(at_limit)
    low: float | None = None
    found: MasteredTrack | None = None
    found_db = 0.0
    max_trials = 24
    for _ in range(max_trials):
        trial = with_gain(at_limit, raised_db)
        excess = trial.loudness - settings.loudness_lufs
        max_loudness_error = 0.05  # LU
        if excess >= -max_loudness_error:
            found, found_db = trial, raised_db
            if excess <= settings.tolerance:
                break
            raised_db = raised_db - excess if low is None else (low + raised_db) / 2
        else:
            low = raised_db
            step = min(max(-1.5 * excess, 0.3), 20.0)
            raised_db = (
                raised_db + step if found is None else (raised_db + found_db) / 2
            )
        if raised_db > settings.max_gain_db:
            break
    if found is None:
        return with_gain(at_limit, settings.sparse_gain_db)
    excess = found.loudness - settings.loudness_lufs
    return found if excess <= 1e-6 else replace(found, trim=10 ** (-excess / 20))


def initial_gain_step(at_limit: MasteredTrack) -> float:
    """Return the additional gain [dB] that reaches the specified loudness without
    limiting."""
    unlimited = ScaledTrack(track=at_limit.track, full_scale=1 / at_limit.gain)
    missing = at_limit.settings.loudness_lufs - unlimited.loudness
    return missing if np.isfinite(missing) else 0.0


def with_gain(track: MasteredTrack, gain_db: float) -> MasteredTrack:
    return replace(track, gain=track.gain * 10 ** (gain_db / 20), trim=1.0)


def true_peak_dbtp(track: DerivedTrack) -> float | str:
    """Return the true peak [dBTP] of a track, or "silence"."""
    peak = track.true_peak
    return float(20 * np.log10(peak)) if peak else "silence"


def mastering_record(track: MasteredTrack | ScaledTrack) -> dict[str, Any]:
    """Return settings and gains of a copy for small loudspeakers, as written to
    run.json."""
    if isinstance(track, MasteredTrack):
        return {
            "dynamics": "compressed",
            "weighting": "A",
            **asdict(track.settings),
            "gain_db": float(20 * np.log10(track.gain)),
            "trim_db": float(20 * np.log10(track.trim)),
        }
    return {
        "dynamics": "natural",
        "weighting": "A",
        "loudness_lufs": AUDIBLE_COPY_LOUDNESS_LUFS,
        "limit_dbtp": AUDIBLE_COPY_PEAK_DBTP,
        "gain_db": float(-20 * np.log10(track.full_scale)),
    }


def trimmed_below_limit(track: MasteredTrack) -> MasteredTrack:
    """Return the track with a trim that limits its true peak to -1.1 dBTP."""
    excess = track.true_peak / 10 ** (-1.1 / 20)
    return track if excess <= 1 else replace(track, trim=track.trim / excess)
