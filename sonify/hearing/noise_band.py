"""Detection of the dominant noise band in each time interval of a sound."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter

from sonify.hearing.audio_source import Source
from sonify.hearing.spectrogram import spectrogram

WINDOW, BAND = 0.04, (700.0, 20e3)
"""Window of the spectrogram [s], and frequency range that is searched [Hz]."""
QUARTER = 25
"""Percentile over the intervals that estimates the constant background."""
STEPS = 48
"""Number of steps per octave of the smoothed spectrum."""
LINE = 5
"""Twice the greatest width of a spectral line, in steps; wider peaks are noise
bands."""
NEAR = 0.1
"""Relative half-width of the range excluded around a line; a mode in air is broad."""
FAINTEST_DB = 10.0
"""Least level of a noise band above the median of the interval [dB]."""


class NoiseBand(NamedTuple):
    """Noise band in intervals (s,) with centres `time` [s].

    `frequency` [Hz] is NaN if no band stands out. `above` is the level above the median
    of the interval [dB], or 0 if the peak is at a limit of BAND."""

    time: np.ndarray
    frequency: np.ndarray
    above: np.ndarray


def noise_band(
    sound: Source, start: float, stop: float, length: float, lines=()
) -> NoiseBand:
    """Return the noise band in intervals of `length` [s] from `start` to `stop` [s].

    The neighbourhoods of known steady `lines` [Hz] are excluded. Steady background and
    lines are removed before the highest peak is determined. A loud line within a third
    of the frequency of the band still shifts it."""
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
        *seen.frequency[[0, -1]],
        int(STEPS * np.log2(seen.frequency[-1] / seen.frequency[0])),
    )
    level = np.array(
        [median_filter(np.interp(f, seen.frequency, row), LINE) for row in power]
    )
    peak = (level - np.percentile(level, QUARTER, axis=0)).argmax(axis=1)
    median_level = np.median(level, axis=1)
    heard = median_level > 0  # digital silence has no noise band
    highest = np.zeros(len(peak))
    highest[heard] = 10 * np.log10(level[heard, peak[heard]] / median_level[heard])
    highest[(peak < LINE) | (peak >= len(f) - LINE)] = (
        0.0  # the flank of a peak outside BAND
    )
    middles = np.full(len(peak), np.nan)
    for i in np.flatnonzero(highest > FAINTEST_DB):
        middles[i] = middle(seen.frequency, power[i], f[peak[i]])
    for line in lines:
        middles[np.abs(middles / line - 1) < NEAR] = np.nan
    return NoiseBand(edges + length / 2, middles, highest)


def middle(frequency, power, near: float) -> float:
    """Return the power-weighted mean frequency [Hz] of the band around `near` [Hz].

    The band consists of the bins within a third of `near` that have more than a third
    of the highest power."""
    here = np.abs(frequency / near - 1) < 1 / 3
    here &= power > power[here].max() / 3
    return float(np.average(frequency[here], weights=power[here]))
