"""ACCELERATION -> PRESSURE, block after block: what has not arrived yet is kept for the next block."""

from functools import cached_property

import numpy as np
from numba import njit
from numpy.lib.stride_tricks import as_strided

from sonify.sound.radiation import AZIMUTHS, Listener, heave_kernel, piston_strength, taps, tilt_kernel

TOGETHER = 2048
"""Samples radiated together: few enough for the cache."""


class RigidFace:
    """What the heave and the tilt of a disk radiate; `reach` is how many samples before and after each other they
    count."""

    def __init__(self, disk, listener: Listener, h: float):
        kernels = [kernel(listener, disk.radius, h, disk.inner_radius) for kernel in (heave_kernel, tilt_kernel)]
        self._steps, self._taps = zip(*kernels, strict=True)
        self.h, self.reach = h, len(self._taps[0]) // 2
        self._strength = piston_strength(disk.radius, listener.distance, listener.air.density)

    def from_rest(self, first):
        """Return advance(accelerations (k + 1, 2), knots, jump (j, 2)) -> pressure (k, 2) [Pa] of the blocks of a
        ContactForce that follow on accelerations `first` (2,)."""
        past, late = np.tile(first, (2 * self.reach, 1)), np.zeros((0, 2))

        def advance(samples, knots, jump):
            nonlocal past, late
            count = len(samples) - 1
            source = np.vstack([past, samples[:-1]])
            out = self._radiated(source, knots, jump)
            out[: len(late)] += late
            past, late = source[count:], out[count:]
            return self._strength * out[:count]

        return advance

    def _radiated(self, source, knots, jump):
        """Samples through the kernels, plus what a jump between samples adds to that, (k + 2 reach + 1, 2)."""
        count, after = len(source) - 2 * self.reach, np.arange(2 * self.reach + 1)
        out = np.zeros((count + len(after), 2))
        interval, _, until = knots
        for i in (0, 1):
            out[:count, i] = np.convolve(source[:, i], self._taps[i], "valid")
            sharp = self._steps[i](until[:, None] + (after - self.reach) * self.h) - np.cumsum(self._taps[i])
            np.add.at(out[:, i], interval[:, None] + 1 + after, jump[:, [i]] * sharp)
        return out


class ElasticFace:
    """What modes radiate towards a listener whose azimuth turns, `reach` samples late."""

    def __init__(self, modes, listener: Listener, sample_rate: float, reach: int):
        self._modes, self._listener, self._rate, self._reach = modes, listener, sample_rate, reach

    @cached_property
    def _table(self):
        return taps(self._modes, self._listener, self._rate)

    def from_rest(self, direction, beside: float | None = None):
        """Return advance(accelerations (s, k, m), directions (k, 2)) -> pressure (k, s) [Pa] of the blocks that follow
        on stillness; `direction` is the cosine and sine of the azimuth before.

        One more column is the sum of them at an ear that is so much further round, `beside` [rad], where it is given.
        """
        late, turned = None, np.tile(direction, (self._reach, 1))

        def advance(acceleration, direction):
            nonlocal late, turned
            count = len(direction)
            if late is None:
                late = np.zeros((len(acceleration), self._reach + 1, acceleration.shape[2]))
            acceleration = np.concatenate([late, acceleration], axis=1)
            direction = np.concatenate([turned, direction])
            late, turned = acceleration[:, count:], direction[count:]
            cosine, sine = direction[:count].T
            turns, sharpness = np.arctan2(sine, cosine) / (2 * np.pi), np.minimum(np.hypot(cosine, sine), 1.0)
            stems = _three_taps(acceleration, turns, sharpness, self._table)
            if beside is None:
                return stems
            both = acceleration.sum(axis=0, keepdims=True)
            return np.hstack([stems, _three_taps(both, turns + beside / (2 * np.pi), sharpness, self._table)])

        return advance


def _three_taps(ringing, turns, sharpness, table):
    """Sum over modes of three taps on samples n + 2, n + 1, n of ringing (s, k + reach + 1, m), at azimuths (k,)
    [turns], between those of the table on the line.

    `sharpness` (k,) is 1 where the azimuth is well defined and falls to 0 where it turns too fast for the samples.
    """
    where, out = turns % 1.0 * AZIMUTHS, np.empty((len(turns), len(ringing)))
    rows = table[:, :, ::-1].swapaxes(1, 2).reshape(AZIMUTHS, -1)  # (a, 3 m): as n, n + 1, n + 2 lie in memory
    mean, slopes, tap = rows.mean(axis=0), np.roll(rows, -1, axis=0) - rows, np.empty((TOGETHER, rows.shape[1]))
    away, size = rows - mean, ringing.itemsize
    for first in range(0, len(where), TOGETHER):
        some = slice(first, first + TOGETHER)
        now = tap[: len(where[some])]
        _between(mean, away, slopes, where[some], sharpness[some], now)
        for one, samples in zip(out.T, ringing, strict=True):
            three = as_strided(samples[first:], now.shape, (samples.shape[1] * size, size))
            np.einsum("nc,nc->n", now, three, out=one[some])
    return out


def compile_radiators() -> None:
    """Compile what an ElasticFace needs, beside other work."""
    _three_taps(np.zeros((1, 3, 1)), np.zeros(1), np.zeros(1), np.zeros((AZIMUTHS, 1, 3)))


@njit(cache=True, nogil=True)
def _between(mean, away, slopes, where, sharpness, tap):
    """The rows of a table, mean + away, with these slopes at places (k,) between them, into tap (k, c)."""
    for n in range(len(where)):
        row, share = int(where[n]) % len(away), where[n] % 1.0
        for c in range(len(mean)):
            tap[n, c] = (slopes[row, c] * share + away[row, c]) * sharpness[n] + mean[c]
