"""Detection of the dominant noise band in each time interval of a sound."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter

from sonify.hearing.audio_source import AudioSource
from sonify.hearing.spectrogram import spectrogram


class NoiseBand(NamedTuple):
    """Noise band in intervals (s,) with centres `time` [s].

    `frequency` [Hz] is NaN if no band is prominent. `prominence_db` is the level above
    the median of the spectrum; it is 0 if the peak is at a limit of the range."""

    time: np.ndarray
    frequency: np.ndarray
    prominence_db: np.ndarray


def noise_band(
    sound: AudioSource, start: float, stop: float, length: float, lines=()
) -> NoiseBand:
    """Return the noise band in intervals of `length` [s] from `start` to `stop` [s].

    The range from 700 Hz to 20 kHz is searched without the neighbourhoods of known
    steady `lines` [Hz]. The steady background and spectral lines are removed before the
    highest peak is determined. A loud line within a third of the frequency of the band
    still shifts it."""
    band = (700.0, 20e3)  # Hz
    window_length = 0.04  # s
    max_line_distance = 0.1  # relative; a mode in air is broad
    steps_per_octave = 48
    median_filter_size = 5  # steps; twice the width of the broadest spectral line
    background_percentile = 25  # over the intervals
    min_prominence = 10.0  # dB
    edges = np.arange(start, stop - length * (1 - 1e-9), length)
    if not len(edges):
        return NoiseBand(*np.zeros((3, 0)))
    spectrum = spectrogram(sound, window_length, columns=1 << 20, span=(start, stop))
    spectrum = spectrum.band(*band)
    intervals = [(spectrum.time >= t) & (spectrum.time < t + length) for t in edges]
    power = np.array([spectrum.power[:, part].mean(axis=1) for part in intervals])
    for line in lines:
        near = np.abs(spectrum.frequency / line - 1) < max_line_distance
        power[:, near] = power[:, near].min(axis=1, initial=np.inf, keepdims=True)
    grid = np.geomspace(
        *spectrum.frequency[[0, -1]],
        int(steps_per_octave * np.log2(spectrum.frequency[-1] / spectrum.frequency[0])),
    )
    level = np.array(
        [
            median_filter(np.interp(grid, spectrum.frequency, row), median_filter_size)
            for row in power
        ]
    )
    peak = (level - np.percentile(level, background_percentile, axis=0)).argmax(axis=1)
    prominence = peak_prominence_db(level, peak, median_filter_size)
    centroids = np.full(len(peak), np.nan)
    for i in np.flatnonzero(prominence > min_prominence):
        centroids[i] = band_centroid(spectrum.frequency, power[i], grid[peak[i]])
    for line in lines:
        centroids[np.abs(centroids / line - 1) < max_line_distance] = np.nan
    return NoiseBand(edges + length / 2, centroids, prominence)


def peak_prominence_db(level, peak, margin: int):
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


def band_centroid(frequency, power, near: float) -> float:
    """Return the power-weighted mean frequency [Hz] of the band around `near` [Hz].

    The band consists of the bins within a third of `near` that have more than a third
    of the highest power."""
    inside = np.abs(frequency / near - 1) < 1 / 3
    inside &= power > power[inside].max() / 3
    return float(np.average(frequency[inside], weights=power[inside]))
