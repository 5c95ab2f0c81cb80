"""Log-frequency spectrogram, suited to a tone that rises as 1/(t_end - t)."""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.ndimage import maximum_filter1d, uniform_filter1d
from scipy.signal import resample_poly

from sonify.hearing.mains_hum import without_hum
from sonify.hearing.time_frequency import local_maxima

FRAME_SPACING_S = 0.005
"""Spacing of the frames."""
BINS_PER_OCTAVE = 48
"""Number of frequency bins per octave."""


@dataclass(frozen=True, kw_only=True)
class LogSpectrogram:
    """Contrast (t, f) [dB] at `time` (t,) [s] and at log-spaced `frequency` (f,) [Hz],
    and its peaks.

    The contrast is the level minus its median over time, minus the mean of the result
    over an octave. It is limited to the range from -6 to 20 dB, so that no single frame
    dominates. `peaks` (3, n) are the times [s] in ascending order, log2 frequencies and
    contrasts [dB] of the local maxima of the level in a frame, where the contrast
    exceeds 6 dB.
    """

    time: np.ndarray
    frequency: np.ndarray
    contrast: np.ndarray
    peaks: np.ndarray


def log_spectrogram(samples: np.ndarray, rate: float) -> LogSpectrogram:
    """Return the log-frequency spectrogram of samples (n,) at `rate` [Hz].

    The windows are so short that a tone that rises as 1/(t_end - t) stays within one
    bin."""
    bands = (  # lower and upper frequency [Hz] and window length [s]
        (8.0, 40.0, 0.5),
        (40.0, 120.0, 0.2),
        (120.0, 400.0, 0.07),
        (400.0, 1500.0, 0.025),
        (1500.0, 8000.0, 0.01),
    )
    max_hum_frequency = 1500.0  # Hz
    min_peak_contrast = 6.0  # dB
    time = np.arange(0, len(samples) / rate, FRAME_SPACING_S)
    frequency = bands[0][0] * 2 ** (
        np.arange(0, np.log2(bands[-1][1] / bands[0][0]), 1 / BINS_PER_OCTAVE)
    )
    frequency = frequency[frequency < 0.45 * rate]
    level = np.zeros((len(time), len(frequency)), np.float32)
    samples = np.asarray(samples, np.float32)
    for low, high, window in reversed(bands):
        here = (frequency >= low) & (frequency < high)
        if not here.any():  # above the range of the samples
            continue
        # The lower bands need no higher sample rate than this band.
        down = max(int(rate / (4 * frequency[here][-1])), 1)
        samples = resample_poly(samples, 1, down)
        rate = rate / down
        samples = without_hum(samples, rate) if high == max_hum_frequency else samples
        level[:, here] = _levels(samples, rate, time, frequency[here], window)
    row, column, offset = local_maxima(level)
    pitch = np.log2(frequency[0]) + (column + offset) / BINS_PER_OCTAVE
    contrast = _replace_by_contrast(level)
    height = contrast[row, column]
    high = height > min_peak_contrast
    peaks = np.array([time[row[high]], pitch[high], height[high]])
    return LogSpectrogram(
        time=time, frequency=frequency, contrast=contrast, peaks=peaks
    )


def _replace_by_contrast(level: np.ndarray) -> np.ndarray:
    """Replace levels (t, f) [dB] by their contrast [dB] and return it."""
    dynamic_range = 60.0  # dB below the maximum at the same frequency
    min_contrast = -6.0  # dB
    max_contrast = 20.0  # dB
    octave = BINS_PER_OCTAVE + 1  # bins, centred
    level = np.maximum(level, level.max(axis=0) - dynamic_range)
    level -= np.array([np.median(column) for column in level.T])
    excess = maximum_filter1d(level, octave, axis=1)
    excess -= max_contrast
    level -= np.maximum(excess, 0, out=excess)
    np.clip(level, min_contrast, max_contrast, out=level)
    level -= uniform_filter1d(level, octave, axis=1)
    return np.maximum(level, min_contrast, out=level)


def _levels(
    samples: np.ndarray,
    rate: float,
    time: np.ndarray,
    frequency: np.ndarray,
    window: float,
) -> np.ndarray:
    """Return levels (t, f) [dB] at frequencies (f,) in Hann windows around times
    (t,)."""
    frames_per_block = 1024
    size = 2 * max(int(window * rate / 2), 8) + 1
    kernel = (
        np.exp(-2j * np.pi / rate * np.outer(np.arange(size), frequency))
        * (np.hanning(size) / size)[:, None]
    )
    kernel = np.hstack([kernel.real, kernel.imag]).astype(np.float32)
    frames = sliding_window_view(np.pad(samples, size), size)
    start = np.minimum(
        np.round(time * rate).astype(int) + size - size // 2, len(frames) - 1
    )
    power = np.empty((len(time), len(frequency)), np.float32)
    for first in range(0, len(time), frames_per_block):
        block = slice(first, first + frames_per_block)
        part = frames[start[block]] @ kernel
        power[block] = part[:, : len(frequency)] ** 2 + part[:, len(frequency) :] ** 2
    return 10 * np.log10(power + max(1e-12 * power.max(), 1e-30))
