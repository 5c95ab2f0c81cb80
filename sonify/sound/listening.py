"""SOUND -> LISTENING COPIES: the pressure as it is, scaled, and what small loudspeakers can play of it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np
from scipy.signal import freqz_zpk, resample_poly, sosfilt, zpk2sos

from sonify.hearing.loudness import a_weighting_db, loudness_lufs
from sonify.hearing.source import pieces
from sonify.hearing.spectrogram import spectrogram

POLES = (20.598997, 20.598997, 107.65265, 737.86223, 12194.217, 12194.217)
"""Of the A-weighting [Hz], IEC 61672-1, annex E; its four zeros lie at 0."""
LOUDNESS_LUFS, TRUE_PEAK_DB = -23.0, -1.0
"""What audible.wav is brought to by its gain, EBU R 128, unless its true peak [dBTP] would be higher than that."""
FINER, EDGE = 4, 32
"""A true peak is sought on so many times the samples, BS.1770-4, annex 2; samples that its filter reaches."""
MOST_KEPT = 1 << 23
"""A weighted track of no more samples stays in memory: a minute and a half for two ears at 48 kHz."""
OVERSHOOT = 2.5
"""No value between samples is so many times the greatest of them: the absolute weights of that filter add to less."""


@dataclass(frozen=True, kw_only=True)
class Beside:
    """A source that goes along with a `track`."""

    track: object

    @property
    def sample_rate(self) -> int:
        """Samples a second [Hz]."""
        return self.track.sample_rate

    @property
    def frames(self) -> int:
        """Number of samples."""
        return self.track.frames

    @property
    def channels(self) -> int:
        """Number of listeners."""
        return self.track.channels


@dataclass(frozen=True, kw_only=True)
class Weighted(Beside):
    """A track [Pa], A-weighted: once, where that is no longer than MOST_KEPT."""

    @cached_property
    def _kept(self):
        return list(self._filtered()) if self.frames * self.channels <= MOST_KEPT else None

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield (k, channels): the samples from number `start` on; every call begins anew."""
        done = 0
        for block in self._kept or self._filtered():
            yield block[max(start - done, 0) :]
            done += len(block)

    def _filtered(self):
        weighting = a_weighting(self.sample_rate)
        state = np.zeros((len(weighting), 2, self.channels))
        for block in self.track.blocks():
            out, state = sosfilt(weighting, block.astype(float), axis=0, zi=state)
            yield out


@dataclass(frozen=True, kw_only=True)
class Copy(Beside):
    """A track over the `full_scale` [Pa] that 1.0 stands for; a source like the track."""

    full_scale: float = 1.0

    @cached_property
    def loudness(self) -> float:
        """Its loudness by BS.1770 [LUFS]; ValueError where it is shorter than that is defined for."""
        return loudness_lufs(self)

    def blocks(self, start: int = 0) -> Iterator[np.ndarray]:
        """Yield (k, channels): the samples from number `start` on; every call begins anew."""
        yield from (block.astype(float) / self.full_scale for block in self.track.blocks(start))


def audible(track) -> Copy:
    """Return the A-weighted copy of a track [Pa], brought to LOUDNESS_LUFS or TRUE_PEAK_DB by its gain alone."""
    weighted = Weighted(track=track)
    over_peak = true_peak(weighted) / 10 ** (TRUE_PEAK_DB / 20) or 1.0
    near = Copy(track=weighted, full_scale=over_peak)  # loudness has a gate at -70 LUFS
    try:
        louder = 10 ** ((near.loudness - LOUDNESS_LUFS) / 20)
    except ValueError:  # shorter than loudness is defined for
        louder = 1.0
    return near if louder <= 1 else replace(near, full_scale=over_peak * louder)


def loudness(copy: Copy) -> float | str:
    """Return the loudness of a copy [LUFS], or why there is none."""
    try:
        return copy.loudness
    except ValueError as error:
        return str(error)


def true_peak(source) -> float:
    """Return the greatest value between the samples, too, of either sign."""
    tops = [np.abs(part).max() for part in _parts(source)]
    loud = (part for part, top in zip(_parts(source), tops, strict=True) if top * OVERSHOOT >= max(tops))
    return float(max((np.abs(resample_poly(part, FINER, 1, axis=0)).max() for part in loud), default=0.0))


def _parts(source):
    return pieces(source, 1 << 16, 2 * EDGE)


def energy_below(track, *limits) -> tuple[float, ...]:
    """Return the shares of the energy of a track below frequencies [Hz]."""
    seen = spectrogram(track, 0.2)
    total = seen.power.sum(axis=1, dtype=float)
    return tuple(float(total[seen.frequency < limit].sum() / (total.sum() or inf)) for limit in limits)


def a_weighting(rate: float) -> np.ndarray:
    """Return the A-weighting at a sample rate [Hz] as a causal filter (3, 6) of second-order sections.

    The poles and zeros of the standard, z = exp(s / rate), and two zeros that make it right at a quarter of the sample
    rate, too. tests/test_sound_audible.py.
    """
    zeros, poles = np.ones(4), np.exp(-2 * np.pi * np.array(POLES) / rate)
    at = np.array([1.0, rate / 4])
    found = np.abs(freqz_zpk(zeros, poles, 1.0, worN=at, fs=rate)[1])
    share = (found[0] / found[1]) * 10 ** ((a_weighting_db(at[1]) - a_weighting_db(at[0])) / 20)
    more = (np.sqrt(2 * share - 1) - share) / (1 - share)  # (1 + more^2) / (1 - more)^2 = share
    zeros = np.append(zeros, [more, more])
    return zpk2sos(zeros, poles, 1 / np.abs(freqz_zpk(zeros, poles, 1.0, worN=[1000.0], fs=rate)[1][0]))
