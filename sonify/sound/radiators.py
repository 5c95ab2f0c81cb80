"""ACCELERATION -> PRESSURE, block after block: what has not arrived yet is kept for the next block."""

import numpy as np

from sonify.sound.radiation import AZIMUTHS, Listener, heave_kernel, piston_strength, taps, tilt_kernel

TOGETHER = 8192
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
        """Return advance(force) -> pressure (k, 2) [Pa] of the blocks that follow on accelerations `first` (2,)."""
        past, late = np.tile(first, (2 * self.reach, 1)), np.zeros((0, 2))

        def advance(force):
            nonlocal past, late
            source = np.vstack([past, force.samples[:-1]])
            out = self._radiated(force, source)
            out[: len(late)] += late
            count = len(force.t) - 1
            past, late = source[count:], out[count:]
            return self._strength * out[:count]

        return advance

    def _radiated(self, force, source):
        """Samples through the kernels, plus what a jump between samples adds to that, (k + 2 reach + 1, 2)."""
        count, after = len(force.t) - 1, np.arange(2 * self.reach + 1)
        out = np.zeros((count + len(after), 2))
        interval, _, until = force.knots
        for i in (0, 1):
            out[:count, i] = np.convolve(source[:, i], self._taps[i], "valid")
            sharp = self._steps[i](until[:, None] + (after - self.reach) * self.h) - np.cumsum(self._taps[i])
            np.add.at(out[:, i], interval[:, None] + 1 + after, force.jump[:, [i]] * sharp)
        return out


class ElasticFace:
    """What modes radiate towards a listener whose azimuth turns, `reach` samples late."""

    def __init__(self, modes, listener: Listener, sample_rate: float, reach: int):
        self._table = taps(modes, listener, sample_rate)
        self._mean, self._reach = self._table.mean(axis=0), reach

    def from_rest(self, direction):
        """Return advance(accelerations (s, k, m), directions (k, 2)) -> pressure (k, s) [Pa] of the blocks that follow
        on stillness; `direction` is the cosine and sine of the azimuth before."""
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
            where = np.arctan2(sine, cosine) / (2 * np.pi) % 1.0 * AZIMUTHS
            return _three_taps(acceleration, where, np.minimum(np.hypot(cosine, sine), 1.0), self._table, self._mean)

        return advance


def _three_taps(ringing, where, sharpness, table, mean):
    """Sum over modes of three taps on samples n + 2, n + 1, n of ringing (s, k + reach + 1, m), at azimuths (k,).

    `sharpness` (k,) is 1 where the azimuth is well defined and falls to 0 where it turns too fast for the samples.
    """
    out, low = np.zeros((len(ringing), len(where))), where.astype(int)
    rows = np.ascontiguousarray(np.concatenate([table, table[:1]]).transpose(1, 2, 0))
    for first in range(0, len(where), TOGETHER):
        some = slice(first, first + TOGETHER)
        here, part, sharp, sums = low[some] % len(table), (where - low)[some], sharpness[some], out[:, some]
        for m, k in np.ndindex(rows.shape[:2]):
            tap = (1 - part) * rows[m, k].take(here) + part * rows[m, k].take(here + 1)
            tap = mean[m, k] + sharp * (tap - mean[m, k])
            late = first + 2 - k
            sums += tap * ringing[:, late : late + len(tap), m]
    return out.T
