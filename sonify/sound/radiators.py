"""ACCELERATION -> PRESSURE, block by block: sound still in flight is kept for the next block."""

from functools import cached_property

import numpy as np
from numba import njit

from sonify.sound.radiation import (
    AZIMUTH_COUNT,
    Listener,
    heave_kernel,
    mode_taps,
    piston_strength,
    tilt_kernel,
)


class RigidFace:
    """Radiates heave and tilt of a disk; `reach` is the half width of its kernels [samples]."""

    def __init__(self, disk, listener: Listener, h: float):
        kernels = [
            kernel(listener, disk.radius, h, disk.inner_radius)
            for kernel in (heave_kernel, tilt_kernel)
        ]
        self._steps, self._taps = zip(*kernels, strict=True)
        self.h = h
        self.reach = len(self._taps[0]) // 2
        self._strength = piston_strength(disk.radius, listener.distance, listener.air.density)

    def start_radiating(self, first):
        """Return advance(accelerations (k + 1, c), knots, jump (j, c)) -> pressure (k, c) [Pa],
        called once per block.

        The first column is the heave, the others are tilts; before the first block they are `first`
        (c,)."""
        past = np.tile(first, (2 * self.reach, 1))
        in_flight = np.zeros((0, len(first)))

        def advance(samples, knots, jump):
            nonlocal past, in_flight
            count = len(samples) - 1
            source = np.vstack([past, samples[:-1]])
            out = self._convolved(source, knots, jump)
            out[: len(in_flight)] += in_flight
            past = source[count:]
            in_flight = out[count:]
            return self._strength * out[:count]

        return advance

    def _convolved(self, source, knots, jump):
        """Return the samples through the kernels plus corrections for jumps between samples, (k + 2
        reach + 1, c)."""
        count = len(source) - 2 * self.reach
        after = np.arange(2 * self.reach + 1)
        out = np.zeros((count + len(after), source.shape[1]))
        interval, _, until = knots
        for kind, columns in enumerate((slice(1), slice(1, None))):
            since = until[:, None] + (after - self.reach) * self.h
            correction = self._steps[kind](since) - np.cumsum(self._taps[kind])
            for samples, sizes, column in zip(
                source.T[columns], jump.T[columns], out.T[columns], strict=True
            ):
                column[:count] = np.convolve(samples, self._taps[kind], "valid")
                np.add.at(column, interval[:, None] + 1 + after, sizes[:, None] * correction)
        return out


class ElasticFace:
    """Radiates elastic modes towards a moving azimuth; the output is `latency` samples late."""

    def __init__(self, modes, listener: Listener, sample_rate: float, latency: int):
        self._modes = modes
        self._listener = listener
        self._rate = sample_rate
        self._latency = latency

    @cached_property
    def _taps(self):
        return mode_taps(self._modes, self._listener, self._rate)

    def start_radiating(self, direction, second_ear: float | None = None):
        """Return advance(accelerations (s, k, m), directions (k, 2)) -> pressure (k, s) [Pa],
        called once per block.

        `direction` is cosine and sine of the listener's azimuth before the first block. With a
        `second_ear` [rad], one more column is the sum of the stems at an ear turned by this angle
        from the listener."""
        past = None
        past_direction = np.tile(direction, (self._latency, 1))

        def advance(acceleration, direction):
            nonlocal past, past_direction
            count = len(direction)
            if past is None:
                past = np.zeros((len(acceleration), self._latency + 1, acceleration.shape[2]))
            acceleration = np.concatenate([past, acceleration], axis=1)
            direction = np.concatenate([past_direction, direction])
            past = acceleration[:, count:]
            past_direction = direction[count:]
            cosine, sine = direction[:count].T
            turns = np.arctan2(sine, cosine) / (2 * np.pi)
            sharpness = np.minimum(np.hypot(cosine, sine), 1.0)
            stems = _radiate_modes(acceleration, turns, sharpness, self._taps)
            if second_ear is None:
                return stems
            second = _radiate_modes(
                acceleration, turns + second_ear / (2 * np.pi), sharpness, self._taps
            )
            return np.hstack([stems, second.sum(axis=1, keepdims=True)])

        return advance


def _radiate_modes(ringing, turns, sharpness, taps):
    """Return the pressure (k, s): three taps on samples n + 2, n + 1, n of `ringing` (s, k + 2, m),
    summed over modes.

    `taps` (AZIMUTHS, m, 3) are interpolated linearly at azimuths `turns` (k,) [turns]. `sharpness`
    (k,) is 1 where the azimuth is well defined. It falls to 0 where the azimuth turns too fast; the
    taps are then the mean over all azimuths."""
    rows = (
        taps[:, :, ::-1].swapaxes(1, 2).reshape(AZIMUTH_COUNT, -1)
    )  # (a, 3 m), ordered n, n + 1, n + 2 as in memory
    mean = rows.mean(axis=0)
    out = np.empty((len(turns), len(ringing)))
    slopes = np.roll(rows, -1, axis=0) - rows
    where = (turns - np.floor(turns)) * AZIMUTH_COUNT
    samples = ringing.reshape(len(ringing), -1)
    _apply_taps(samples, ringing.shape[2], where, sharpness, mean, rows - mean, slopes, out)
    return out


def compile_radiators() -> None:
    """Compile the kernels of ElasticFace; call it in a background thread."""
    _radiate_modes(np.zeros((1, 3, 1)), np.zeros(1), np.zeros(1), np.zeros((AZIMUTH_COUNT, 1, 3)))


@njit(cache=True, nogil=True)
def _apply_taps(samples, modes, where, sharpness, mean, deviation, slopes, out):
    """Write into `out` (k, s) the products of interpolated taps with samples (s, ...), stored
    `modes` per instant.

    The taps at a fractional row of the table are mean + sharpness (deviation + part slope).
    """
    tap = np.empty(len(mean))
    for n in range(len(where)):
        row = int(where[n])
        weight = sharpness[n]
        share = where[n] - row
        slope = slopes[row % len(deviation)]
        middle = deviation[row % len(deviation)]
        for c in range(len(tap)):
            tap[c] = (slope[c] * share + middle[c]) * weight + mean[c]
        for s in range(len(samples)):
            out[n, s] = np.dot(tap, samples[s, n * modes : n * modes + len(tap)])
