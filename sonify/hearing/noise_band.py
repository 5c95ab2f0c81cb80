"""Detection of the dominant noise band in each time interval of a sound."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter

from sonify.hearing.audio_source import AudioSource
from sonify.hearing.spectrogram import spectrogram


class NoiseBand(NamedTuple):
    """Noise band in intervals (s,) with centres `time` [s].

    `frequency` [Hz] is NaN if no band is prominent."""

    time: np.ndarray
    frequency: np.ndarray


def noise_band(
    sound: AudioSource,
    start: float,
    stop: float,
    length: float,
    lines: Sequence[float] = (),
) -> NoiseBand:
    """Return the noise band in intervals of `length` [s] from `start` to `stop` [s].

    The range from 700 Hz to 20 kHz is searched without the neighbourhoods of known
    steady `lines` [Hz]. The steady background and spectral lines are removed before the
    highest peak is determined. A loud line within a third of the frequency of the band
    still shifts it."""
    begins = np.arange(start, stop - length * (1 - 1e-9), length)
    if not len(begins):
        return NoiseBand(*np.zeros((2, 0)))
    return noise_band_between(sound, np.append(begins, begins[-1] + length), lines)


def noise_band_to_end(
    sound: AudioSource,
    start: float,
    stop: float,
    length: float,
    lines: Sequence[float] = (),
) -> NoiseBand:
    """Return the noise band from `start` to `stop` [s], as `noise_band` does, in
    intervals that are five times shorter from two lengths before the end on."""
    intervals_per_length = 5
    fine_lengths = 2
    min_length_count = 12
    length = min(length, (stop - start) / min_length_count)
    fine_start = stop - fine_lengths * length
    whole = int((fine_start - start) / length)
    coarse = fine_start - length * np.arange(whole, 0, -1)
    fine_count = fine_lengths * intervals_per_length
    fine = np.linspace(fine_start, stop, fine_count + 1)
    return noise_band_between(sound, np.concatenate([coarse, fine]), lines)


def noise_band_between(
    sound: AudioSource, edges: np.ndarray, lines: Sequence[float] = ()
) -> NoiseBand:
    """Return the noise band in the intervals between successive edges (s + 1,) [s].

    Intervals that are too short to contain the middle of a window are left out."""
    band = (700.0, 20e3)  # Hz
    window_length = 0.04  # s
    max_line_distance = 0.1  # relative; a mode in air is broad
    median_filter_size = 5  # steps; twice the width of the broadest spectral line
    background_percentile = 25  # over the intervals
    min_prominence = 10.0  # dB
    begins, ends = edges[:-1], edges[1:]
    spectrum = spectrogram(
        sound, window_length, columns=1 << 20, span=(edges[0], edges[-1])
    )
    spectrum = spectrum.band(*band)
    inside = (spectrum.time >= begins[:, None]) & (spectrum.time < ends[:, None])
    known = inside.any(axis=1)
    if not known.any():
        return NoiseBand(*np.zeros((2, 0)))
    power = np.array([spectrum.power[:, part].mean(axis=1) for part in inside[known]])
    for line in lines:
        near = np.abs(spectrum.frequency / line - 1) < max_line_distance
        power[:, near] = power[:, near].min(axis=1, initial=np.inf, keepdims=True)
    grid, level = _smoothed_power(spectrum.frequency, power, median_filter_size)
    peak = (level - np.percentile(level, background_percentile, axis=0)).argmax(axis=1)
    prominence = peak_prominence_db(level, peak, median_filter_size)
    centroids = np.full(len(peak), np.nan)
    for i in np.flatnonzero(prominence > min_prominence):
        centroids[i] = band_centroid(spectrum.frequency, power[i], grid[peak[i]])
    for line in lines:
        centroids[np.abs(centroids / line - 1) < max_line_distance] = np.nan
    return NoiseBand((begins + ends)[known] / 2, centroids)


def _smoothed_power(
    frequency: np.ndarray, power: np.ndarray, size: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies (g,) [Hz] in equal ratios, and the running medians over `size` of
    them (k, g) of the powers (k, f)."""
    steps_per_octave = 48
    octaves = np.log2(frequency[-1] / frequency[0])
    grid = np.geomspace(frequency[0], frequency[-1], int(steps_per_octave * octaves))
    rows = [median_filter(np.interp(grid, frequency, row), size) for row in power]
    return grid, np.array(rows)


def peak_prominence_db(level: np.ndarray, peak: np.ndarray, margin: int) -> np.ndarray:
    """Return the levels (k,) [dB] of peaks above the median of the spectra (k, n).

    The prominence of a peak less than `margin` from a limit of the range is 0.
    """
    median_level = np.median(level, axis=1)
    audible = median_level > 0  # digital silence has no noise band
    prominence = np.zeros(len(peak))
    peak_level = level[audible, peak[audible]]
    prominence[audible] = 10 * np.log10(peak_level / median_level[audible])
    at_lower_limit = peak < margin  # flank of a peak outside the range
    at_upper_limit = peak >= level.shape[1] - margin
    prominence[at_lower_limit | at_upper_limit] = 0.0
    return prominence


def band_centroid(frequency: np.ndarray, power: np.ndarray, near: float) -> float:
    """Return the power-weighted mean frequency [Hz] of the band around `near` [Hz].

    The band consists of the bins within a third of `near` that have more than a third
    of the highest power."""
    inside = np.abs(frequency / near - 1) < 1 / 3
    inside &= power > power[inside].max() / 3
    return float(np.average(frequency[inside], weights=power[inside]))
