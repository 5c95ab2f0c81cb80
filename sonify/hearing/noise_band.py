"""SOUND -> CARRIER: the band of noise that stands out, stretch after stretch, told by nothing but
the samples."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter

from sonify.hearing.audio_source import Source
from sonify.hearing.spectrogram import spectrogram

WINDOW, BAND = 0.04, (700.0, 20e3)
"""Window [s]; where a carrier is sought [Hz]."""
QUARTER = 25
"""Percentile of the stretches whose level at a frequency is what always sounds there."""
STEPS = 48
"""Steps an octave of the spectrum in which the highest peak is taken."""
LINE = 5
"""What is narrower than half of so many steps is a line, and no band."""
NEAR = 0.1
"""Half of what is left out around a line, relative: that of a mode which the air detunes is
broad."""
FAINTEST_DB = 10.0
"""A carrier stands out by as much above the median of the stretch."""


class NoiseBand(NamedTuple):
    """Of each stretch (s,): its middle [s], the frequency of the band [Hz], NaN if none stands out,
    and its level above the median of the stretch [dB], 0 at the ends of BAND."""

    time: np.ndarray
    frequency: np.ndarray
    above: np.ndarray


def noise_band(sound: Source, start: float, stop: float, length: float, lines=()) -> NoiseBand:
    """Return the band of noise that rises or falls, in stretches of `length` [s] from `start` to
    `stop` [s], if any.

    Around known steady `lines` [Hz] nothing is looked at. The highest peak is sought without lines,
    as modes are, and without what sounds in most stretches alike; a loud line within a third of the
    band still draws its frequency there."""
    edges = np.arange(start, stop - length * (1 - 1e-9), length)
    if not len(edges):
        return NoiseBand(*np.zeros((3, 0)))
    seen = spectrogram(sound, WINDOW, columns=1 << 20, span=(start, stop)).band(*BAND)
    which = [(seen.time >= t) & (seen.time < t + length) for t in edges]
    power = np.array([seen.power[:, here].mean(axis=1) for here in which])
    for line in lines:
        near = np.abs(seen.frequency / line - 1) < NEAR
        power[:, near] = power[:, near].min(axis=1, initial=np.inf, keepdims=True)
    f = np.geomspace(
        *seen.frequency[[0, -1]], int(STEPS * np.log2(seen.frequency[-1] / seen.frequency[0]))
    )
    level = np.array([median_filter(np.interp(f, seen.frequency, row), LINE) for row in power])
    peak = (level - np.percentile(level, QUARTER, axis=0)).argmax(axis=1)
    median_level = np.median(level, axis=1)
    heard = median_level > 0  # digital silence has no band
    highest = np.zeros(len(peak))
    highest[heard] = 10 * np.log10(level[heard, peak[heard]] / median_level[heard])
    highest[(peak < LINE) | (peak >= len(f) - LINE)] = 0.0  # the flank of what lies outside
    middles = np.full(len(peak), np.nan)
    for i in np.flatnonzero(highest > FAINTEST_DB):
        middles[i] = middle(seen.frequency, power[i], f[peak[i]])
    for line in lines:
        middles[np.abs(middles / line - 1) < NEAR] = np.nan
    return NoiseBand(edges + length / 2, middles, highest)


def middle(frequency, power, near: float) -> float:
    """Return the mean frequency [Hz], by power, of what is above a third of the highest within a
    third of `near`."""
    here = np.abs(frequency / near - 1) < 1 / 3
    here &= power > power[here].max() / 3
    return float(np.average(frequency[here], weights=power[here]))
