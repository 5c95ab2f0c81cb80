"""Convert accelerations to radiated pressure block by block."""

from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from dynamics.numba_kernels import njit
from sonify.sound.block_overlap import overlapping_blocks
from sonify.sound.radiation import (
    Kernel,
    Listener,
    heave_kernel,
    mode_taps,
    piston_strength,
    tilt_kernel,
)

if TYPE_CHECKING:
    from dynamics.disk import Disk
    from modal.modes import Modes

KnotTimes = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Intervals of jumps, and the times since the previous and to the next sample, see
`ContactForce.knots`."""


class RigidFace:
    """Radiator of heave and tilt of a disk.

    `reach` is the half-width of its kernels [samples]."""

    columns: tuple[slice, ...] = (slice(1), slice(1, None))
    """Groups of acceleration columns that share a kernel."""

    def __init__(self, disk: "Disk", listener: Listener, h: float) -> None:
        self._steps, self._taps = zip(*self._kernels(disk, listener, h), strict=True)
        self.h = h
        self.reach = len(self._taps[0]) // 2
        self._strength = piston_strength(
            disk.radius, listener.distance, listener.air.density
        )

    def _kernels(self, disk: "Disk", listener: Listener, h: float) -> list[Kernel]:
        if listener.is_in_near_field:
            from sonify.sound.near_field import near_face_kernels

            return near_face_kernels(listener, disk, h)
        return [
            kernel(listener, disk.radius, h, disk.inner_radius)
            for kernel in (heave_kernel, tilt_kernel)
        ]

    def make_block_radiator(
        self, first: np.ndarray
    ) -> Callable[[np.ndarray, KnotTimes, np.ndarray], np.ndarray]:
        """Return a function that converts successive blocks of accelerations to
        pressure.

        The function is advance(accelerations (k + 1, c), knots, jump (j, c)) ->
        pressure (k, c) [Pa]. The first column is the heave, the others are tilts;
        before the first block their values are `first` (c,)."""
        extend = overlapping_blocks(2 * self.reach, first)
        in_flight = np.zeros((0, len(first)))

        def advance(
            samples: np.ndarray, knots: KnotTimes, jump: np.ndarray
        ) -> np.ndarray:
            nonlocal in_flight
            count = len(samples) - 1
            out = self._convolve_with_kernels(extend(samples[:-1]), knots, jump)
            out[: len(in_flight)] += in_flight
            in_flight = out[count:]
            return self._strength * out[:count]

        return advance

    def _convolve_with_kernels(
        self, source: np.ndarray, knots: KnotTimes, jump: np.ndarray
    ) -> np.ndarray:
        """Return the convolution (k + 2 reach + 1, c) with the kernels, corrected for
        jumps between samples."""
        count = len(source) - 2 * self.reach
        after = np.arange(2 * self.reach + 1)
        out = np.zeros((count + len(after), source.shape[1]))
        interval, _, until = knots
        for kind, columns in enumerate(self.columns):
            since = until[:, None] + (after - self.reach) * self.h
            correction = self._steps[kind](since) - np.cumsum(self._taps[kind])
            for samples, sizes, column in zip(
                source.T[columns], jump.T[columns], out.T[columns], strict=True
            ):
                column[:count] = np.convolve(samples, self._taps[kind], "valid")
                np.add.at(
                    column, interval[:, None] + 1 + after, sizes[:, None] * correction
                )
        return out


class NearRim(RigidFace):
    """Radiator of the flow out of the rim, for a listener near the disk.

    The columns are flows of azimuthal harmonics 0, 1, 1 and 2."""

    columns = (slice(0, 1), slice(1, 3), slice(3, 4))

    def _kernels(self, disk: "Disk", listener: Listener, h: float) -> list[Kernel]:
        from sonify.sound.near_field import near_rim_kernels

        return near_rim_kernels(listener, disk, h)


class ElasticFace:
    """Radiator of elastic modes towards a listener at a variable azimuth.

    The output is delayed by `latency` samples."""

    def __init__(
        self, modes: "Modes", listener: Listener, sample_rate: float, latency: int
    ) -> None:
        self._tabulate = partial(mode_taps, modes, listener, sample_rate)
        self._latency = latency

    @cached_property
    def _taps(self) -> np.ndarray:
        return self._tabulate()

    def make_block_radiator(
        self, direction: np.ndarray, second_ear: float | None = None
    ) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
        """Return a function that converts successive blocks of modal accelerations to
        pressure.

        The function is advance(accelerations (s, k, m), directions (k, 2)) -> pressure
        (k, s) [Pa]. `direction` contains cosine and sine of the listener's azimuth
        before the first block. If `second_ear` [rad] is given, an additional column
        contains the sum of the stems at an ear rotated by this angle from the
        listener."""
        past = None
        extend = overlapping_blocks(self._latency, direction)

        def advance(acceleration: np.ndarray, direction: np.ndarray) -> np.ndarray:
            nonlocal past
            count = len(direction)
            if past is None:
                past = np.zeros(
                    (len(acceleration), self._latency + 1, acceleration.shape[2])
                )
            acceleration = np.concatenate([past, acceleration], axis=1)
            past = acceleration[:, count:]
            cosine, sine = extend(direction)[:count].T
            turns = np.arctan2(sine, cosine) / (2 * np.pi)
            sharpness = np.minimum(np.hypot(cosine, sine), 1.0)
            stems = _radiate_modes(acceleration, turns, sharpness, self._taps)
            if second_ear is None:
                return stems
            second = _radiate_modes(
                acceleration.sum(axis=0, keepdims=True),
                turns + second_ear / (2 * np.pi),
                sharpness,
                self._taps,
            )
            return np.hstack([stems, second])

        return advance


def _radiate_modes(
    ringing: np.ndarray, turns: np.ndarray, sharpness: np.ndarray, taps: np.ndarray
) -> np.ndarray:
    """Return the pressure (k, s), summed over modes, of modal accelerations (s, k + 2,
    m).

    The taps apply to samples n + 2, n + 1, n.

    `taps` (a, m, 3) are interpolated linearly at azimuths `turns` (k,) [turns].
    `sharpness` (k,) is 1 where the azimuth is well defined and falls to 0 where it
    rotates too fast; the taps are then averaged over all azimuths."""
    rows = (
        taps[:, :, ::-1].swapaxes(1, 2).reshape(len(taps), -1)
    )  # (a, 3 m), ordered n, n + 1, n + 2 as in memory
    mean = rows.mean(axis=0)
    out = np.empty((len(turns), len(ringing)))
    slopes = np.roll(rows, -1, axis=0) - rows
    where = (turns - np.floor(turns)) * len(taps)
    samples = ringing.reshape(len(ringing), -1)
    _apply_taps(
        samples, ringing.shape[2], where, sharpness, mean, rows - mean, slopes, out
    )
    return out


def compile_radiators() -> None:
    """Compile the kernels of ElasticFace; intended for a background thread."""
    _radiate_modes(np.zeros((1, 3, 1)), np.zeros(1), np.zeros(1), np.zeros((1, 1, 3)))


@njit(cache=True, nogil=True)
def _apply_taps(
    samples: np.ndarray,
    modes: int,
    where: np.ndarray,
    sharpness: np.ndarray,
    mean: np.ndarray,
    deviation: np.ndarray,
    slopes: np.ndarray,
    out: np.ndarray,
) -> None:
    """Write the products of interpolated taps with samples into `out` (k, s).

    The samples (s, ...) contain `modes` values per instant. The taps at a fractional
    row of the table are mean + sharpness * (deviation + share * slope), where share is
    the fractional part of the row.
    """
    for n in range(len(where)):
        row = int(where[n])
        share = where[n] - row
        row %= len(deviation)
        for s in range(len(samples)):
            pressure = 0.0
            for c in range(len(mean)):
                varying = deviation[row, c] + share * slopes[row, c]
                tap = mean[c] + sharpness[n] * varying
                pressure += tap * samples[s, n * modes + c]
            out[n, s] = pressure
