"""Removal of steady tones, such as mains hum, from a sound."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

WINDOW, BELOW, STANDS_OUT_DB, NEIGHBOURS = 1.0, 1500.0, 15.0, 41
"""Window of the spectrum [s]; highest frequency of a hum [Hz]; its least level above
its neighbours [dB]; number of neighbouring bins. The level is a median over time, which
a rising tone hardly affects."""


def without_hum(samples: np.ndarray, rate: float) -> np.ndarray:
    """Return samples (n,) at `rate` [Hz] without their steady tones.

    The amplitude and phase of each tone are measured in Hann windows and interpolated
    linearly between their centres. Sounds shorter than four windows are returned
    unchanged."""
    size = int(WINDOW * rate)
    if len(samples) < 4 * size:
        return samples
    shape = np.hanning(size)
    starts = np.arange(0, len(samples) - size, size // 2)
    frames = sliding_window_view(samples, size)[starts] * (shape / shape.sum())
    time = np.arange(len(samples))
    for frequency in _steady(frames, int(BELOW * size / rate)) / size:
        turning = np.exp(2j * np.pi * frequency * time)
        amplitude = frames @ turning[:size].conj() * turning[starts].conj()
        samples = (
            samples - 2 * (np.interp(time, starts + size / 2, amplitude) * turning).real
        )
    return samples


def vertex(below, top, above):
    """Return the position of the vertex of the parabola through a peak and its
    neighbours.

    It is relative to the peak, from -0.5 to 0.5 bins.
    """
    return (below - above) / (2 * (below - 2 * top + above))


def _steady(frames, bins):
    """Return the fractional bin positions of steady tones below bin `bins` in frames
    (t, n)."""
    usual = 10 * np.log10(
        np.median(np.abs(rfft(frames)[:, :bins]) ** 2, axis=0) + 1e-30
    )
    peaks = find_peaks(usual - median_filter(usual, NEIGHBOURS), height=STANDS_OUT_DB)[
        0
    ]
    return peaks + vertex(*(usual[peaks + i] for i in (-1, 0, 1)))
