"""Make playback copies of a sound: the scaled pressure, and an A-weighted copy for
small loudspeakers."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf
from typing import Protocol

import numpy as np
from scipy.signal import freqz_zpk, resample_poly, sosfilt, zpk2sos

from dynamics.a_weighting import a_weighting_db
from sonify.hearing.audio_source import BLOCK_SIZE, AudioSource, overlapping_pieces
from sonify.hearing.loudness import loudness_lufs
from sonify.hearing.spectrogram import spectrogram

AUDIBLE_COPY_LOUDNESS_LUFS = -23.0
"""Loudness of audible.wav with natural dynamics, EBU R 128."""
AUDIBLE_COPY_PEAK_DBTP = -1.0
"""Highest true peak [dBTP] of audible.wav with natural dynamics; it takes precedence
over the loudness."""
MAX_TRUE_PEAK_RATIO = 2.5
"""Upper bound for the ratio of true peak to sample peak; it exceeds the sum of the
absolute weights of the resampling filter."""


class Channels(AudioSource, Protocol):
    """An audio source with `channels` columns."""

    @property
    def channels(self) -> int: ...


class HasLoudness(Protocol):
    """A copy of a sound that has a loudness."""

    @property
    def loudness(self) -> float:
        """Loudness [LUFS]; raises ValueError if it is undefined."""
        ...


@dataclass(frozen=True, kw_only=True)
class DerivedTrack:
    """A track computed from another `track`, with the same length, sample rate and
    channels."""

    track: Channels

    @property
    def sample_rate(self) -> int:
        """Sample rate [Hz]."""
        return self.track.sample_rate

    @property
    def frames(self) -> int:
        """Number of samples."""
        return self.track.frames

    @property
    def channels(self) -> int:
        """Number of listeners."""
        return self.track.channels

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Return a new iterator over blocks (k, channels), beginning at sample
        `start`."""
        raise NotImplementedError

    @cached_property
    def true_peak(self) -> float:
        """Largest magnitude, including values between the samples."""
        return true_peak(self)


@dataclass(frozen=True, kw_only=True)
class CachedTrack(DerivedTrack):
    """A track that is computed from its start, and cached if it has at most
    `max_cached` samples."""

    max_cached: int = 1 << 23

    def computed_blocks(self) -> Iterator[np.ndarray]:
        """Yield the blocks (k, channels) of the whole track."""
        raise NotImplementedError

    @cached_property
    def _cached_blocks(self) -> list[np.ndarray] | None:
        few = self.frames * self.channels <= self.max_cached
        return list(self.computed_blocks()) if few else None

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Return a new iterator over blocks (k, channels), beginning at sample
        `start`."""
        skipped = start
        for block in self._cached_blocks or self.computed_blocks():
            if skipped < len(block):  # an empty part would keep its block in memory
                yield block[skipped:]
            skipped = max(skipped - len(block), 0)


@dataclass(frozen=True, kw_only=True)
class WeightedTrack(CachedTrack):
    """A-weighted copy of a track [Pa]."""

    def computed_blocks(self) -> Iterator[np.ndarray]:
        """Yield the filtered blocks (k, channels)."""
        weighting = a_weighting(self.sample_rate)
        state = np.zeros((len(weighting), 2, self.channels))
        for block in self.track.blocks():
            out, state = sosfilt(weighting, block.astype(float), axis=0, zi=state)
            yield out


@dataclass(frozen=True, kw_only=True)
class ScaledTrack(DerivedTrack):
    """A track divided by `full_scale` [Pa], the pressure represented by 1.0."""

    full_scale: float = 1.0

    @cached_property
    def loudness(self) -> float:
        """Loudness [LUFS] by BS.1770; raises ValueError if the track is too short."""
        return loudness_lufs(self)

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Return a new iterator over blocks (k, channels), beginning at sample
        `start`."""
        yield from (
            block.astype(float) / self.full_scale for block in self.track.blocks(start)
        )


def audible_copy(track: Channels) -> ScaledTrack:
    """Return an A-weighted copy of a track [Pa] at AUDIBLE_COPY_LOUDNESS_LUFS.

    The copy is quieter if its true peak would exceed AUDIBLE_COPY_PEAK_DBTP.
    """
    weighted = WeightedTrack(track=track)
    full_scale_at_peak = (
        true_peak(weighted) / 10 ** (AUDIBLE_COPY_PEAK_DBTP / 20) or 1.0
    )
    at_peak = ScaledTrack(
        track=weighted, full_scale=full_scale_at_peak
    )  # scaled first, because the loudness gate is at -70 LUFS
    try:
        attenuation = 10 ** ((at_peak.loudness - AUDIBLE_COPY_LOUDNESS_LUFS) / 20)
    except ValueError:  # too short for a loudness
        attenuation = 1.0
    return (
        at_peak
        if attenuation <= 1
        else replace(at_peak, full_scale=full_scale_at_peak * attenuation)
    )


def loudness(copy: "HasLoudness") -> float | str:
    """Return the loudness of a copy [LUFS], or the reason why it is undefined."""
    try:
        return copy.loudness
    except ValueError as error:
        return str(error)


def true_peak(source: AudioSource) -> float:
    """Return the largest magnitude of a source, including values between the
    samples."""
    tops = [np.abs(part).max() for part in _overlapping_parts(source)]
    loudest = max(tops)
    peak = 0.0
    for part, top in zip(_overlapping_parts(source), tops, strict=True):
        if top * MAX_TRUE_PEAK_RATIO >= loudest:
            peak = max(peak, true_peaks(part).max())
    return float(peak)


def true_peaks(samples: np.ndarray) -> np.ndarray:
    """Return the largest magnitude (k,) at and after each of samples (k, channels),
    including values between the samples."""
    oversampling = 4  # BS.1770-4, annex 2
    between = np.abs(resample_poly(samples, oversampling, 1, axis=0))
    return between.reshape(len(samples), -1).max(axis=1)


def _overlapping_parts(source: AudioSource) -> Iterator[np.ndarray]:
    """Return parts of a source, extended on both sides by the reach of the resampling
    filter [samples]."""
    filter_reach = 32
    return overlapping_pieces(source, BLOCK_SIZE, 2 * filter_reach)


def energy_below(track: AudioSource, *limits: float) -> tuple[float, ...]:
    """Return the fractions of the energy of a track below each frequency limit [Hz]."""
    spectrum = spectrogram(track, 0.2)
    total = spectrum.power.sum(axis=1, dtype=float)
    return tuple(
        float(total[spectrum.frequency < limit].sum() / (total.sum() or inf))
        for limit in limits
    )


def a_weighting(rate: float) -> np.ndarray:
    """Return a causal A-weighting filter at a sample rate [Hz], as second-order
    sections (3, 6).

    The poles and zeros of the standard are mapped by z = exp(s / rate). Two additional
    zeros correct the gain at a quarter of the sample rate. See
    tests/sound/test_audible_copy.py."""
    zeros = np.ones(4)
    # IEC 61672-1, annex E; the four zeros are at 0
    standard_poles = (
        20.598997,
        20.598997,
        107.65265,
        737.86223,
        12194.217,
        12194.217,
    )  # Hz
    poles = np.exp(-2 * np.pi * np.array(standard_poles) / rate)
    at = np.array([1.0, rate / 4])
    gain = np.abs(freqz_zpk(zeros, poles, 1.0, worN=at, fs=rate)[1])
    wanted = 10 ** ((a_weighting_db(at[1]) - a_weighting_db(at[0])) / 20)
    share = (gain[0] / gain[1]) * wanted
    zero = (np.sqrt(2 * share - 1) - share) / (
        1 - share
    )  # solves (1 + zero^2) / (1 - zero)^2 = share
    zeros = np.append(zeros, [zero, zero])
    return zpk2sos(
        zeros,
        poles,
        1 / np.abs(freqz_zpk(zeros, poles, 1.0, worN=[1000.0], fs=rate)[1][0]),
    )
