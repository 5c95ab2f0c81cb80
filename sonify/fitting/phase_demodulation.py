"""SOUND + DECLINE -> RATES: how much faster or slower than a decline says a tone turns, read from
its phase.

In the time that the decline itself keeps, the tone is a constant: the sound times exp(-2 pi i
turns) is steady, and a slope of its phase within a block is a rate that the decline has missed. No
window smears what rises."""

from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.interpolate import CubicHermiteSpline

SIDES = np.array([-6, -5, -4, 4, 5, 6])
"""Where beside the tone the noise is read, in turns a block: a Hann window has nothing left of the
tone there."""
BINS = 24
"""Means of the still tone in a turn."""
FARTHEST = 0.15
"""A rate that is so far from what is expected, over that, is not told by the slope of a phase."""
CLEAR = 4.0
"""A block counts whose tone has so many times the power of the noise beside it."""
MOST_BLOCKS, OVERLAP = 300, 2
"""Blocks of a sound at most, each sharing half of itself with the next."""
TINY = 1e-300
USUALLY = 0.5
"""A tone that is there is told by so large a share of the blocks at least: noise and speech tell
one in a tenth."""


class Rates(NamedTuple):
    """Middle of the blocks [s], turns a second there [Hz], their standard errors by noise [Hz],
    power over that of the noise, and by how much these are more than was expected, over that, all
    (k,)."""

    time: np.ndarray
    frequency: np.ndarray
    error: np.ndarray
    clear: np.ndarray
    missed: np.ndarray


def rates(
    samples, rate: float, first: float, course, length: float, noise_of=np.mean, integral=None
) -> Rates:
    """Return the rates of the tone in samples (n,) at `rate` [Hz], of which the first is at the
    time `first` [s].

    `course`, times [s], turns and turns a second [Hz] (3, k), rising, is what the tone is expected
    to do; between these it is a cubic. What was heard before the tone began is left out. Blocks are
    `length` turns long, or longer where there would be more than MOST_BLOCKS. The noise is
    `noise_of` the powers beside the tone. Who asks often hands over the `integral` (n + 1,) of the
    samples."""
    integral = np.append(0.0, np.cumsum(samples)) if integral is None else integral
    heard = _binned(samples, integral, rate, first, course)
    begin = _beginning(_told(heard, length, noise_of)[0]) * _step(length)
    heard = [x[begin:] for x in heard]
    length = max(length, OVERLAP * len(heard[0]) / BINS / MOST_BLOCKS)
    told, *found = _told(heard, length, noise_of)
    return Rates(*(x[told] for x in found))


def _beginning(told):
    """The first of the blocks (b,) from which on most are told: their surplus from there to the end
    is the greatest."""
    return len(told) - 1 - np.argmax(np.cumsum(told[::-1] - USUALLY)) if len(told) else 0


def _step(length):
    """Bins from one block of `length` turns to the next."""
    return round(length * BINS) // OVERLAP


def _told(heard, length, noise_of):
    """Whether each block (b,) tells a tone, and the Rates (b,) there."""
    still, t, frequency = heard
    size = round(length * BINS)
    if len(t) < size:
        return np.zeros(0, bool), *np.zeros((5, 0))
    blocks = (sliding_window_view(x, size)[:: _step(length)] for x in (still, t))
    middle, mean, missed, error, clear = _blocks(*blocks, noise_of)
    expected = np.interp(middle, t, frequency)
    told = (clear > CLEAR) & (np.abs(missed) < FARTHEST * expected)
    return told, middle, expected + missed, error, clear, missed / mean


def _binned(samples, integral, rate, first, course):
    """Means (b,) of the still tone over every bin of a turn, their times [s], and the turns a
    second expected there."""
    time, turned, frequency = course[:, course[2] < rate / 2.5]
    last = first + (len(samples) - 1) / rate
    if len(time) < 2 or time[-1] < first or time[0] > last:
        return [np.zeros(0)] * 3
    begin, stop = CubicHermiteSpline(time, turned, frequency)(
        np.clip([first, last], time[0], time[-1])
    )
    edge = np.arange(np.ceil(BINS * begin), BINS * stop)
    t = CubicHermiteSpline(turned, time, 1 / frequency)(edge / BINS)
    place = (t - first) * rate + 0.5
    sample = np.clip(place.astype(int), 0, len(samples) - 1)
    mean = np.diff(integral[sample] + (place - sample) * samples[sample]) / np.diff(place)
    still = mean * np.exp(-2j * np.pi * ((edge[:-1] + 0.5) % BINS) / BINS)
    return still, (t[1:] + t[:-1]) / 2, 1 / (BINS * np.diff(t))


def _blocks(still, t, noise_of):
    """Middle, mean rate expected, missed rate, error and clarity (b,) of blocks (b, bins); silence
    has none."""
    phase = (np.arange(still.shape[1]) + 0.5) / still.shape[1]
    window = np.sin(np.pi * phase) ** 2  # a Hann window over turns
    middle = t @ window / window.sum()
    since = t - middle[:, None]
    seen = window * still
    tone = seen.sum(axis=1)
    slope = np.sum(since * seen, axis=1)
    beside = np.abs(seen @ np.exp(-2j * np.pi * np.outer(phase, SIDES))) ** 2
    noise = np.maximum(noise_of(beside, axis=1), TINY)
    spread = since**2 @ window / window.sum()
    mean = (
        since @ (window * (np.arange(len(phase)) - len(phase) / 2)) / (BINS * window.sum() * spread)
    )
    share = since**2 @ window**2 / np.sum(window**2)
    clear = np.abs(tone) ** 2 / noise
    missed = (slope / np.where(tone == 0, 1, tone)).imag / (2 * np.pi * spread)
    error = np.sqrt(share / 2 / np.maximum(clear, TINY)) / (2 * np.pi * spread)
    return middle, mean, missed, error, clear
