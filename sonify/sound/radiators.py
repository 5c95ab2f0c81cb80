"""ACCELERATION -> PRESSURE, block after block: what has not arrived yet is kept for the next block."""

from functools import cached_property

import numpy as np
from numba import njit

from sonify.sound.radiation import AZIMUTHS, Listener, heave_kernel, piston_strength, taps, tilt_kernel


class RigidFace:
    """What the heave and the tilt of a disk radiate; `reach` is how many samples before and after each other they
    count."""

    def __init__(self, disk, listener: Listener, h: float):
        kernels = [kernel(listener, disk.radius, h, disk.inner_radius) for kernel in (heave_kernel, tilt_kernel)]
        self._steps, self._taps = zip(*kernels, strict=True)
        self.h, self.reach = h, len(self._taps[0]) // 2
        self._strength = piston_strength(disk.radius, listener.distance, listener.air.density)

    def from_rest(self, first):
        """Return advance(accelerations (k + 1, c), knots, jump (j, c)) -> pressure (k, c) [Pa] of the blocks of a
        ContactForce that follow on accelerations `first` (c,): one of heave, the others of tilt."""
        past, late = np.tile(first, (2 * self.reach, 1)), np.zeros((0, len(first)))

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
        """Samples through the kernels, plus what a jump between samples adds to that, (k + 2 reach + 1, c)."""
        count, after = len(source) - 2 * self.reach, np.arange(2 * self.reach + 1)
        out = np.zeros((count + len(after), source.shape[1]))
        interval, _, until = knots
        for kind, columns in enumerate((slice(1), slice(1, None))):
            since = until[:, None] + (after - self.reach) * self.h
            sharp = self._steps[kind](since) - np.cumsum(self._taps[kind])
            for samples, sizes, heard in zip(source.T[columns], jump.T[columns], out.T[columns], strict=True):
                heard[:count] = np.convolve(samples, self._taps[kind], "valid")
                np.add.at(heard, interval[:, None] + 1 + after, sizes[:, None] * sharp)
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
            there = _three_taps(acceleration, turns + beside / (2 * np.pi), sharpness, self._table)
            return np.hstack([stems, there.sum(axis=1, keepdims=True)])

        return advance


def _three_taps(ringing, turns, sharpness, table):
    """Sum over modes of three taps on samples n + 2, n + 1, n of ringing (s, k + 2, m), at azimuths (k,) [turns],
    between those of the table on the line.

    `sharpness` (k,) is 1 where the azimuth is well defined and falls to 0 where it turns too fast for the samples.
    """
    rows = table[:, :, ::-1].swapaxes(1, 2).reshape(AZIMUTHS, -1)  # (a, 3 m): as n, n + 1, n + 2 lie in memory
    mean, out = rows.mean(axis=0), np.empty((len(turns), len(ringing)))
    slopes, where = np.roll(rows, -1, axis=0) - rows, (turns - np.floor(turns)) * AZIMUTHS
    samples, modes = ringing.reshape(len(ringing), -1), ringing.shape[2]
    _filtered(samples, modes, where, sharpness, mean, rows - mean, slopes, out)
    return out


def compile_radiators() -> None:
    """Compile what an ElasticFace needs, beside other work."""
    _three_taps(np.zeros((1, 3, 1)), np.zeros(1), np.zeros(1), np.zeros((AZIMUTHS, 1, 3)))


@njit(cache=True, nogil=True, fastmath={"reassoc"})
def _filtered(samples, modes, where, sharpness, mean, away, slopes, out):
    """What the rows of a table, mean + away, with these slopes at places (k,) between them, make of samples (s, ...),
    so many modes after each other, into out (k, s)."""
    tap = np.empty(len(mean))
    for n in range(len(where)):
        row, weight = int(where[n]), sharpness[n]
        share, slope, middle = where[n] - row, slopes[row % len(away)], away[row % len(away)]
        for c in range(len(tap)):
            tap[c] = (slope[c] * share + middle[c]) * weight + mean[c]
        for s in range(len(samples)):
            three, total = samples[s, n * modes : n * modes + len(tap)], 0.0
            for c in range(len(tap)):
                total += tap[c] * three[c]
            out[n, s] = total
