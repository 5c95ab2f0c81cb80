"""Deviation of a tone from an expected frequency law, measured from its phase.

In the phase coordinate of the expected law the tone has a constant frequency: after
multiplication by exp(-2 pi i turns), the slope of the phase within a block is the
deviation from the expected rate. The rising pitch therefore causes no spectral
smearing."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import CubicHermiteSpline

from sonify.fitting.settings import FIT

Noise = Callable[..., np.ndarray]
"""Function of powers (..., f) and `axis` that returns the noise."""


class Rates(NamedTuple):
    """Measured rates (k,) [Hz] at the centres of blocks [s], with errors due to noise
    [Hz].

    `clear` is the ratio of tone power to noise power, and `missed` the relative
    deviation from the expected rate."""

    time: np.ndarray
    frequency: np.ndarray
    error: np.ndarray
    clear: np.ndarray
    missed: np.ndarray


def rates(
    samples: np.ndarray,
    rate: float,
    first: float,
    course: np.ndarray,
    length: float,
    noise_of: Noise = np.mean,
) -> Rates:
    """Return the rates of the tone in samples (n,) at `rate` [Hz] from the time `first`
    [s] on.

    `course` (3, k) contains ascending times [s], turns and rates [Hz] of the expected
    tone, which are interpolated by a cubic spline. Blocks before the beginning of the
    tone are omitted. A block has `length` turns, or more if there would be more than
    300 blocks. `noise_of` computes the noise from the powers at several frequency
    offsets from the tone."""
    max_block_count = 300
    heard = _demodulated_bins(samples, rate, first, course)
    is_clear, *_ = _clear_blocks(heard, length, noise_of)
    begin = _first_clear_block(is_clear) * _bins_per_step(length)
    later = [x[begin:] for x in heard]
    min_length = FIT.block_overlap * len(later[0]) / FIT.bins_per_turn / max_block_count
    is_clear, *found = _clear_blocks(later, max(length, min_length), noise_of)
    return Rates(*(x[is_clear] for x in found))


def _first_clear_block(is_clear: np.ndarray) -> int:
    """Return the index of the first of the blocks (b,) after the unclear beginning.

    In noise and speech, a tenth of the blocks are clear.
    """
    min_clear_share = 0.5
    if not len(is_clear):
        return 0
    return (
        len(is_clear) - 1 - int(np.argmax(np.cumsum(is_clear[::-1] - min_clear_share)))
    )


def _bins_per_step(length: float) -> int:
    """Return the number of bins between the starts of successive blocks."""
    return round(length * FIT.bins_per_turn) // FIT.block_overlap


def _clear_blocks(
    heard: Sequence[np.ndarray], length: float, noise_of: Noise
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return a mask of the blocks (b,) with a clear tone, and the fields of Rates
    (b,)."""
    min_tone_to_noise = 4.0  # power
    demodulated, t, frequency = heard
    size = round(length * FIT.bins_per_turn)
    if len(t) < size:
        return np.zeros(0, bool), *np.zeros((5, 0))
    step = _bins_per_step(length)
    blocks = sliding_window_view(demodulated, size)[::step]
    times = sliding_window_view(t, size)[::step]
    middle, mean, missed, error, clear = _block_rates(blocks, times, noise_of)
    expected = np.interp(middle, t, frequency)
    is_clear = (clear > min_tone_to_noise) & (
        np.abs(missed) < FIT.max_rate_deviation * expected
    )
    return is_clear, middle, expected + missed, error, clear, missed / mean


def _demodulated_bins(
    samples: np.ndarray, rate: float, first: float, course: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the demodulated tone averaged over each bin, times [s] and expected rates,
    each (b,)."""
    time, turned, frequency = course[:, course[2] < rate / 2.5]
    last = first + (len(samples) - 1) / rate
    if len(time) < 2 or time[-1] < first or time[0] > last:
        return np.zeros(0), np.zeros(0), np.zeros(0)
    begin, stop = CubicHermiteSpline(time, turned, frequency)(
        np.clip([first, last], time[0], time[-1])
    )
    edge = np.arange(np.ceil(FIT.bins_per_turn * begin), FIT.bins_per_turn * stop)
    t = CubicHermiteSpline(turned, time, 1 / frequency)(edge / FIT.bins_per_turn)
    place = (t - first) * rate + 0.5
    sample = np.clip(place.astype(int), 0, len(samples) - 1)
    cumulative_sum = np.append(0.0, np.cumsum(samples))
    mean = np.diff(
        cumulative_sum[sample] + (place - sample) * samples[sample]
    ) / np.diff(place)
    demodulated = mean * np.exp(
        -2j * np.pi * ((edge[:-1] + 0.5) % FIT.bins_per_turn) / FIT.bins_per_turn
    )
    return demodulated, (t[1:] + t[:-1]) / 2, 1 / (FIT.bins_per_turn * np.diff(t))


def _block_rates(
    demodulated: np.ndarray, t: np.ndarray, noise_of: Noise
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return centre, mean rate, deviation, error and signal-to-noise ratio (b,) of
    blocks (b, bins).

    The signal-to-noise ratio of silence is 0.
    """
    tiny_power = 1e-300
    phase = (np.arange(demodulated.shape[1]) + 0.5) / demodulated.shape[1]
    window = np.sin(np.pi * phase) ** 2  # a Hann window over turns
    middle = t @ window / window.sum()
    since = t - middle[:, None]
    seen = window * demodulated
    tone = seen.sum(axis=1)
    slope = np.sum(since * seen, axis=1)
    # cycles per block; a Hann window has no leakage there
    noise_offsets = np.array([-6, -5, -4, 4, 5, 6])
    shifts = np.exp(-2j * np.pi * np.outer(phase, noise_offsets))
    noise_power = np.abs(seen @ shifts) ** 2
    noise = np.maximum(noise_of(noise_power, axis=1), tiny_power)
    spread = since**2 @ window / window.sum()
    mean = (
        since
        @ (window * (np.arange(len(phase)) - len(phase) / 2))
        / (FIT.bins_per_turn * window.sum() * spread)
    )
    share = since**2 @ window**2 / np.sum(window**2)
    clear = np.abs(tone) ** 2 / noise
    missed = (slope / np.where(tone == 0, 1, tone)).imag / (2 * np.pi * spread)
    error = np.sqrt(share / 2 / np.maximum(clear, tiny_power)) / (2 * np.pi * spread)
    return middle, mean, missed, error, clear
