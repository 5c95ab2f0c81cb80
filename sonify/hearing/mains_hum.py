"""Removal of steady tones, such as mains hum, from a sound."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

from sonify.hearing.time_frequency import vertex

MIN_PROMINENCE_DB = 15.0
"""Minimum level of a spectral peak above its neighbours."""


def without_hum(samples: np.ndarray, rate: float) -> np.ndarray:
    """Return samples (n,) at `rate` [Hz] without their steady tones below 1.5 kHz.

    The amplitude and phase of each tone are measured in Hann windows and interpolated
    linearly between the centres of the windows. Sounds shorter than four windows are
    returned unchanged."""
    window_length = 1.0  # s
    max_frequency = 1500.0  # Hz
    size = int(window_length * rate)
    if len(samples) < 4 * size:
        return samples
    window = np.hanning(size)
    starts = np.arange(0, len(samples) - size, size // 2)
    frames = sliding_window_view(samples, size)[starts] * (window / window.sum())
    time = np.arange(len(samples))
    bin_count = int(max_frequency * size / rate)
    for frequency in _steady_tones(frames, bin_count) / size:  # cycles per sample
        phasor = np.exp(2j * np.pi * frequency * time)
        amplitude = frames @ phasor[:size].conj() * phasor[starts].conj()
        samples = (
            samples - 2 * (np.interp(time, starts + size / 2, amplitude) * phasor).real
        )
    return samples


def _steady_tones(frames: np.ndarray, bin_count: int) -> np.ndarray:
    """Return the interpolated bins of the steady tones in the lowest `bin_count` bins
    of the spectra of frames (t, n).

    The tones are peaks of the median over time, which a rising tone hardly affects."""
    neighbours = 41  # bins
    power = np.abs(rfft(frames)[:, :bin_count]) ** 2
    level = 10 * np.log10(np.median(power, axis=0) + 1e-30)
    prominence = level - median_filter(level, neighbours)
    peaks = find_peaks(prominence, height=MIN_PROMINENCE_DB)[0]
    return peaks + vertex(*(level[peaks + i] for i in (-1, 0, 1)))
