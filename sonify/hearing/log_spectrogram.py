"""Levels over time and log frequency, suited to a tone that rises as 1/(t_end - t)."""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.ndimage import map_coordinates, maximum_filter1d, uniform_filter1d
from scipy.signal import resample_poly

from sonify.hearing.mains_hum import without_hum

HOP = 0.005
"""Spacing of the frames [s]."""
STEPS_PER_OCTAVE = 48
"""Number of bins per octave."""
BANDS = (
    (8.0, 40.0, 0.5),
    (40.0, 120.0, 0.2),
    (120.0, 400.0, 0.07),
    (400.0, 1500.0, 0.025),
    (1500.0, 8000.0, 0.01),
)
"""Lower and upper frequency of each band [Hz] and its window [s]; within a window, a
tone that rises as 1/(t_end - t) stays within one bin."""
HUM_FROM = 0.025
"""Least window [s] of the bands in which hum is removed."""
OCTAVE = STEPS_PER_OCTAVE + 1
"""Number of bins from half an octave below to half an octave above."""
DEEPEST_DB, LEAST_DB, MOST_DB = 60.0, -6.0, 20.0
"""Level below the loudest at the same frequency at which levels are cut off; limits of
the contrast [dB]."""
GROUP = 1024
"""Number of frames transformed at a time."""


@dataclass(frozen=True, kw_only=True)
class LogMap:
    """Level (t, f) [dB] at `time` (t,) [s] and at log-spaced `frequency` (f,) [Hz].

    `contrast` (t, f) [dB] is the level above its median over time and its mean over an
    octave. It is limited to LEAST_DB and MOST_DB, so that no single frame dominates.
    """

    time: np.ndarray
    frequency: np.ndarray
    level: np.ndarray
    contrast: np.ndarray

    def read(self, t, frequency) -> np.ndarray:
        """Return the interpolated contrast at times t [s] and frequencies [Hz]; 0
        outside the map."""
        row = (t - self.time[0]) / HOP
        column = np.log2(frequency / self.frequency[0]) * STEPS_PER_OCTAVE
        return map_coordinates(
            self.contrast, [row, column], order=1, mode="constant", cval=0.0
        )


def log_map(samples: np.ndarray, rate: float) -> LogMap:
    """Return the log map of samples (n,) at `rate` [Hz], with a window for each
    band."""
    time = np.arange(0, len(samples) / rate, HOP)
    frequency = BANDS[0][0] * 2 ** (
        np.arange(0, np.log2(BANDS[-1][1] / BANDS[0][0]), 1 / STEPS_PER_OCTAVE)
    )
    frequency = frequency[frequency < 0.45 * rate]
    level = np.zeros((len(time), len(frequency)), np.float32)
    samples = np.asarray(samples, np.float32)
    for low, high, window in reversed(BANDS):
        here = (frequency >= low) & (frequency < high)
        if not here.any():  # above the range of the samples
            continue
        down = max(
            int(rate / (4 * frequency[here][-1])), 1
        )  # the sample rate required for this band and lower ones
        samples = resample_poly(samples, 1, down) if down > 1 else samples
        rate = rate / down
        samples = without_hum(samples, rate) if window == HUM_FROM else samples
        level[:, here] = _levels(samples, rate, time, frequency[here], window)
    return LogMap(
        time=time, frequency=frequency, level=level, contrast=_contrast(level)
    )


def _contrast(level):
    level = np.maximum(level, level.max(axis=0) - DEEPEST_DB)
    level -= np.median(level, axis=0)
    level += np.minimum(MOST_DB - maximum_filter1d(level, OCTAVE, axis=1), 0)
    level = np.clip(level, LEAST_DB, MOST_DB)
    return np.maximum(level - uniform_filter1d(level, OCTAVE, axis=1), LEAST_DB)


def _levels(samples, rate, time, frequency, window):
    """Return levels (t, f) [dB] at frequencies (f,) in Hann windows around times
    (t,)."""
    size = 2 * max(int(window * rate / 2), 8) + 1
    turning = (
        np.exp(-2j * np.pi / rate * np.outer(np.arange(size), frequency))
        * (np.hanning(size) / size)[:, None]
    )
    kernel = np.hstack([turning.real, turning.imag]).astype(np.float32)
    frames = sliding_window_view(np.pad(samples, size), size)
    start = np.minimum(
        np.round(time * rate).astype(int) + size - size // 2, len(frames) - 1
    )
    power = np.empty((len(time), len(frequency)), np.float32)
    for first in range(0, len(time), GROUP):
        some = slice(first, first + GROUP)
        part = frames[start[some]] @ kernel
        power[some] = part[:, : len(frequency)] ** 2 + part[:, len(frequency) :] ** 2
    return 10 * np.log10(power + max(1e-12 * power.max(), 1e-30))
