"""SOUND + DECLINE -> RATES: how much faster or slower than a decline says a tone turns, read from its phase.

In the time that the decline itself keeps, the tone is a constant: the sound times exp(-2 pi i turns) is steady, and a
slope of its phase within a block is a rate that the decline has missed. No window smears what rises.
"""

from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

SIDES = np.array([-6, -5, -4, 4, 5, 6])
"""Where beside the tone the noise is read, in turns a block: a Hann window has nothing left of the tone there."""
BINS = 24
"""Means of the still tone in a turn."""
FARTHEST = 0.15
"""A rate that is so far from what is expected, over that, is not told by the slope of a phase."""
CLEAR = 4.0
"""A block counts whose tone has so many times the power of the noise beside it."""
MOST_BLOCKS, OVERLAP = 300, 2
"""Blocks of a sound at most, each sharing half of itself with the next."""
TINY = 1e-300
FEWEST = 16
"""Bins of a block that must hold samples."""
USUALLY = 0.5
"""A tone that is there is told by so large a share of the blocks at least: noise and speech tell one in a tenth."""


class Rates(NamedTuple):
    """Middle of the blocks [s], turns a second there [Hz], their standard errors by noise [Hz], and power over that of
    the noise, all (k,)."""

    time: np.ndarray
    frequency: np.ndarray
    error: np.ndarray
    clear: np.ndarray


def rates(samples, rate: float, first: float, turns, length: float, noise_of=np.mean) -> Rates:
    """Return the rates of the tone in samples (n,) at `rate` [Hz], of which the first is at the time `first` [s].

    `turns(t) -> (turns, turns a second [Hz])` is what the tone is expected to do at times (k,) [s]; not finite where it
    is not expected. What was heard before the tone began is left out. Blocks are `length` turns long, or longer where
    there would be more than MOST_BLOCKS. The noise is `noise_of` the powers beside the tone.
    """
    t = first + np.arange(len(samples)) / rate
    turned, frequency = turns(t)
    here = np.flatnonzero(np.isfinite(turned) & (frequency < rate / 2.5))
    if len(here) < FEWEST:
        return Rates(*np.zeros((4, 0)))
    here = slice(here[0], here[-1] + 1)
    still = samples[here] * np.exp(-2j * np.pi * turned[here])
    return rates_of_still(still, t[here], turned[here], frequency[here], length, noise_of)


def rates_of_still(still, t, turned, frequency, length: float, noise_of=np.mean) -> Rates:
    """Return the rates of a tone that was expected to have `turned` (n,) at times t (n,) [s], `frequency` (n,) times a
    second, and is `still` (n,) in that time."""
    heard = _binned(still, t, turned, frequency)
    first = _beginning(_told(heard, length, noise_of)[0]) * _step(length)
    heard = [x[first:] for x in heard]
    length = max(length, OVERLAP * len(heard[0]) / BINS / MOST_BLOCKS)
    told, *found = _told(heard, length, noise_of)
    return Rates(*(x[told] for x in found))


def _beginning(told):
    """The first of the blocks (b,) from which on most are told: their surplus from there to the end is the greatest."""
    return len(told) - 1 - np.argmax(np.cumsum(told[::-1] - USUALLY)) if len(told) else 0


def _step(length):
    """Bins from one block of `length` turns to the next."""
    return round(length * BINS) // OVERLAP


def _told(heard, length, noise_of):
    """Whether each block (b,) tells a tone, and the Rates (b,) there."""
    count, still, t, frequency = heard
    size = round(length * BINS)
    if len(count) < size:
        return np.zeros(0, bool), *np.zeros((4, 0))
    blocks = (sliding_window_view(x, size)[:: _step(length)] for x in (count > 0, still, t))
    middle, missed, error, clear = _blocks(*blocks, noise_of)
    expected = np.interp(middle, t[count > 0], frequency[count > 0])
    told = (clear > CLEAR) & (np.abs(missed) < FARTHEST * expected)
    return told, middle, expected + missed, error, clear


def _binned(still, t, turned, frequency):
    """How many samples there are in every bin of a turn, and means over them: the still tone needs no more."""
    bins = (BINS * (turned - turned[0])).astype(int)
    count = np.bincount(bins)
    mean = [np.bincount(bins, x) / np.maximum(count, 1) for x in (still.real, still.imag, t, frequency)]
    return count, mean[0] + 1j * mean[1], mean[2], mean[3]


def _blocks(there, still, t, noise_of):
    """Middle, missed rate, error and clarity (b,) of blocks (b, bins); the clarity of silence is 0."""
    phase = (np.arange(still.shape[1]) + 0.5) / still.shape[1]
    window = np.sin(np.pi * phase) ** 2 * there  # a Hann window over turns
    total = np.maximum(window.sum(axis=1), TINY)
    middle = np.sum(window * t, axis=1) / total
    since = (t - middle[:, None]) * there
    seen = window * still
    tone, slope = seen.sum(axis=1), np.sum(since * seen, axis=1)
    beside = np.abs(seen @ np.exp(-2j * np.pi * np.outer(phase, SIDES))) ** 2
    noise = noise_of(beside, axis=1)
    spread = np.maximum(np.sum(window * since**2, axis=1) / total, TINY)
    share = np.sum((window * since) ** 2, axis=1) / np.maximum(np.sum(window**2, axis=1), TINY)
    clear = np.where(there.sum(axis=1) < FEWEST, 0.0, np.abs(tone) ** 2 / np.maximum(noise, TINY))
    missed = (slope / np.where(tone == 0, 1, tone)).imag / (2 * np.pi * spread)
    error = np.sqrt(share / 2 / np.maximum(clear, TINY)) / (2 * np.pi * spread)
    return middle, missed, error, clear
