"""SOUND -> SOUND WITHOUT HUM: steady tones, such as those of the mains, are measured and taken
away."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

WINDOW, BELOW, STANDS_OUT_DB, NEIGHBOURS = 1.0, 1500.0, 15.0, 41
"""A tone below this [Hz] is a hum where its median over time, in windows of so many seconds, is so
far above that of so many bins around it. A tone that rises or falls is in none of them for half of
the time."""


def without_hum(samples: np.ndarray, rate: float) -> np.ndarray:
    """Return samples (n,) without their steady tones: each is taken away with the amplitude and
    phase that it has in Hann windows, and between their centres on the straight line. Less than
    four windows stay as they are."""
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
        samples = samples - 2 * (np.interp(time, starts + size / 2, amplitude) * turning).real
    return samples


def vertex(below, top, above):
    """Return where between bins (-0.5 to 0.5) the parabola through a peak and its neighbours is
    highest."""
    return (below - above) / (2 * (below - 2 * top + above))


def _steady(frames, bins):
    """Places of the lowest `bins` [bins, between them too] that stand out in the median over frames
    (t, n)."""
    usual = 10 * np.log10(np.median(np.abs(rfft(frames)[:, :bins]) ** 2, axis=0) + 1e-30)
    peaks = find_peaks(usual - median_filter(usual, NEIGHBOURS), height=STANDS_OUT_DB)[0]
    return peaks + vertex(*(usual[peaks + i] for i in (-1, 0, 1)))
