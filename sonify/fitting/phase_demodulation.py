"""SOUND + DECLINE -> RATES: deviation of a tone from the rate of a decline, measured from its
phase.

In the phase coordinate of the decline the tone is constant: the sound times exp(-2 pi i turns) is
steady, and the slope of its phase within a block is the deviation from the expected rate. The rise
of the pitch does not smear it.
"""

from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import CubicHermiteSpline

NOISE_OFFSETS = np.array([-6, -5, -4, 4, 5, 6])
"""Frequencies beside the tone at which the noise is measured, in cycles per block; a Hann window
has no leakage there."""
BINS_PER_TURN = 24
"""Number of means per turn."""
MAX_RATE_DEVIATION = 0.15
"""Largest relative deviation from the expected rate that the phase slope can measure."""
MIN_TONE_TO_NOISE = 4.0
"""Least ratio of the power of the tone to that of the noise."""
MAX_BLOCKS = 300
"""Largest number of blocks of a sound."""
BLOCK_OVERLAP = 2
"""Number of blocks that cover each instant."""
TINY_POWER = 1e-300
MIN_CLEAR_SHARE = 0.5
"""Least share of clear blocks in a tone; in noise and speech a tenth of the blocks are clear."""


class Rates(NamedTuple):
    """Measured rates, arrays (k,): middle of the blocks [s], rate [Hz] and its error by noise [Hz].

    `clear` is the power relative to the noise, and `missed` the deviation relative to the expected
    rate.
    """

    time: np.ndarray
    frequency: np.ndarray
    error: np.ndarray
    clear: np.ndarray
    missed: np.ndarray


def rates(
    samples, rate: float, first: float, course, length: float, noise_of=np.mean, integral=None
) -> Rates:
    """Return the rates of the tone in samples (n,) at `rate` [Hz] that begin at the time `first`
    [s].

    `course` (3, k) holds times [s], turns and rates [Hz] of the expected tone, ascending; it is
    interpolated by a cubic. Blocks before the beginning of the tone are left out. A block has
    `length` turns, or more if there would be more than MAX_BLOCKS. The noise is `noise_of` the
    powers beside the tone. `integral` (n + 1,) is the cumulative sum of the samples, for repeated
    calls.
    """
    integral = np.append(0.0, np.cumsum(samples)) if integral is None else integral
    heard = _demodulated_bins(samples, integral, rate, first, course)
    begin = _first_clear_block(_clear_blocks(heard, length, noise_of)[0]) * _bins_per_step(length)
    heard = [x[begin:] for x in heard]
    length = max(length, BLOCK_OVERLAP * len(heard[0]) / BINS_PER_TURN / MAX_BLOCKS)
    told, *found = _clear_blocks(heard, length, noise_of)
    return Rates(*(x[told] for x in found))


def _first_clear_block(told):
    """Return the index of the first of the blocks (b,) from which on most are clear."""
    return len(told) - 1 - np.argmax(np.cumsum(told[::-1] - MIN_CLEAR_SHARE)) if len(told) else 0


def _bins_per_step(length):
    """Return the number of bins between the beginnings of two blocks."""
    return round(length * BINS_PER_TURN) // BLOCK_OVERLAP


def _clear_blocks(heard, length, noise_of):
    """Return which blocks (b,) have a clear tone, and the fields of Rates (b,) there."""
    still, t, frequency = heard
    size = round(length * BINS_PER_TURN)
    if len(t) < size:
        return np.zeros(0, bool), *np.zeros((5, 0))
    blocks = (sliding_window_view(x, size)[:: _bins_per_step(length)] for x in (still, t))
    middle, mean, missed, error, clear = _block_rates(*blocks, noise_of)
    expected = np.interp(middle, t, frequency)
    told = (clear > MIN_TONE_TO_NOISE) & (np.abs(missed) < MAX_RATE_DEVIATION * expected)
    return told, middle, expected + missed, error, clear, missed / mean


def _demodulated_bins(samples, integral, rate, first, course):
    """Return the demodulated tone averaged over every bin (b,), the times [s] and the expected
    rates."""
    time, turned, frequency = course[:, course[2] < rate / 2.5]
    last = first + (len(samples) - 1) / rate
    if len(time) < 2 or time[-1] < first or time[0] > last:
        return [np.zeros(0)] * 3
    begin, stop = CubicHermiteSpline(time, turned, frequency)(
        np.clip([first, last], time[0], time[-1])
    )
    edge = np.arange(np.ceil(BINS_PER_TURN * begin), BINS_PER_TURN * stop)
    t = CubicHermiteSpline(turned, time, 1 / frequency)(edge / BINS_PER_TURN)
    place = (t - first) * rate + 0.5
    sample = np.clip(place.astype(int), 0, len(samples) - 1)
    mean = np.diff(integral[sample] + (place - sample) * samples[sample]) / np.diff(place)
    still = mean * np.exp(-2j * np.pi * ((edge[:-1] + 0.5) % BINS_PER_TURN) / BINS_PER_TURN)
    return still, (t[1:] + t[:-1]) / 2, 1 / (BINS_PER_TURN * np.diff(t))


def _block_rates(still, t, noise_of):
    """Return middle, expected rate, deviation, error and clarity (b,) of blocks (b, bins).

    Silence has zero clarity.
    """
    phase = (np.arange(still.shape[1]) + 0.5) / still.shape[1]
    window = np.sin(np.pi * phase) ** 2  # a Hann window over turns
    middle = t @ window / window.sum()
    since = t - middle[:, None]
    seen = window * still
    tone = seen.sum(axis=1)
    slope = np.sum(since * seen, axis=1)
    beside = np.abs(seen @ np.exp(-2j * np.pi * np.outer(phase, NOISE_OFFSETS))) ** 2
    noise = np.maximum(noise_of(beside, axis=1), TINY_POWER)
    spread = since**2 @ window / window.sum()
    mean = (
        since
        @ (window * (np.arange(len(phase)) - len(phase) / 2))
        / (BINS_PER_TURN * window.sum() * spread)
    )
    share = since**2 @ window**2 / np.sum(window**2)
    clear = np.abs(tone) ** 2 / noise
    missed = (slope / np.where(tone == 0, 1, tone)).imag / (2 * np.pi * spread)
    error = np.sqrt(share / 2 / np.maximum(clear, TINY_POWER)) / (2 * np.pi * spread)
    return middle, mean, missed, error, clear
