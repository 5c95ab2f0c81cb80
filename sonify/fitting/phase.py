"""SOUND + DECLINE -> RATES: how much faster or slower than a decline says a tone turns, read from its phase.

In the time that the decline itself keeps, the tone is a constant: the sound times exp(-2 pi i turns) is steady, and a
slope of its phase within a block is a rate that the decline has missed. No window smears what rises.
"""

from typing import NamedTuple

import numpy as np

SIDES = np.array([-6, -5, -4, 4, 5, 6])
"""Where beside the tone the noise is read, in turns a block: a Hann window has nothing left of the tone there."""
BIN = 1 / 24
"""What a still tone is averaged over [turns]."""
FARTHEST = 0.15
"""A rate that is so far from what is expected, over that, is not told by the slope of a phase."""
CLEAR = 4.0
"""A block counts whose tone has so many times the power of the noise beside it."""
MOST_BLOCKS, OVERLAP = 300, 2
"""Blocks of a sound at most, each sharing half of itself with the next."""


class Rates(NamedTuple):
    """Middle of the blocks [s], turns a second there [Hz], their standard errors by noise [Hz], and power over that of
    the noise, all (k,)."""

    time: np.ndarray
    frequency: np.ndarray
    error: np.ndarray
    clear: np.ndarray

    @property
    def evidence(self) -> float:
        """How much speaks for the tone: the sum over the blocks of log(1 + power over noise)."""
        return float(np.log1p(self.clear).sum() / OVERLAP)


def rates(samples, rate: float, first: float, turns, length: float) -> Rates:
    """Return the rates of the tone in samples (n,) at `rate` [Hz], of which the first is at the time `first` [s].

    `turns(t) -> (turns, turns a second [Hz])` is what the tone is expected to do at times (k,) [s]; not finite where it
    is not expected. Blocks are `length` turns long, or longer where there would be more than MOST_BLOCKS.
    """
    t = first + np.arange(len(samples)) / rate
    turned, frequency = turns(t)
    here = np.flatnonzero(np.isfinite(turned) & (frequency < rate / 2.5))
    if len(here) < 16:
        return Rates(*np.zeros((4, 0)))
    here = slice(here[0], here[-1] + 1)
    turned, frequency, t = turned[here], frequency[here], t[here]
    still = samples[here] * np.exp(-2j * np.pi * turned)
    still, t, turned, frequency = _binned(still, t, turned, frequency)
    length = max(length, OVERLAP * (turned[-1] - turned[0]) / MOST_BLOCKS)
    edges = np.arange(turned[0], turned[-1] - length, length / OVERLAP)
    bounds = np.searchsorted(turned, np.stack([edges, edges + length]))
    found = [_block(still[a:b], t[a:b], turned[a:b], frequency[a:b]) for a, b in bounds.T if b - a >= 16]
    out = np.array([one for one in found if one is not None]).reshape(-1, 4)
    return Rates(*out[out[:, 3] > CLEAR].T)


def _binned(still, t, turned, frequency):
    """Means over every BIN of a turn: the still tone needs no more."""
    bins = np.floor(turned / BIN)
    starts = np.flatnonzero(np.diff(bins, prepend=bins[0] - 1))
    count = np.diff(starts, append=len(bins))
    return [np.add.reduceat(x, starts) / count for x in (still, t, turned, frequency)]


def _block(still, t, turned, frequency):
    """Middle, rate, error and clarity of a block; None for silence."""
    phase = (turned - turned[0]) / (turned[-1] - turned[0])
    window = np.sin(np.pi * phase) ** 2  # a Hann window over turns
    middle = np.average(t, weights=window)
    since = t - middle
    tone, slope = np.sum(window * still), np.sum(window * since * still)
    noise = np.mean(np.abs(np.exp(-2j * np.pi * np.outer(SIDES, phase)) @ (window * still)) ** 2)
    if not noise > 0:
        return None
    spread = np.sum(window * since**2) / np.sum(window)
    missed = (slope / tone).imag / (2 * np.pi * spread)
    share = np.sum(window**2 * since**2) / np.sum(window**2)
    clear = np.abs(tone) ** 2 / noise
    error = np.sqrt(share / 2 / clear) / (2 * np.pi * spread)
    expected = np.interp(middle, t, frequency)
    return None if abs(missed) > FARTHEST * expected else (middle, expected + missed, error, clear)
