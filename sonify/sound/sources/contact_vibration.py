"""Compute the sound of a disk vibrating as a rigid body above its air film."""

from math import pi
from typing import TYPE_CHECKING

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft
from scipy.interpolate import CubicSpline

from sonify.sound.film_radiation import (
    MAX_RIM_ORDER,
    TABULATED_MEAN_GAPS,
    TABULATED_WAVENUMBERS,
    radiated_multipoles,
)
from sonify.sound.modal_forcing import (
    in_patch_frame,
    listener_azimuth,
    rigid_acceleration,
)
from sonify.sound.radiation import Listener
from sonify.sound.sources.protocol import Advance, Note, SoundSource

if TYPE_CHECKING:
    from sonify.scene import Scene
    from sonify.sound.force import ContactForce

COSINE_ORDERS = np.arange(MAX_RIM_ORDER + 1)
SINE_ORDERS = np.arange(1, MAX_RIM_ORDER + 1)


class VibratingDisk(SoundSource):
    """Sound source for forces that vary faster than the disk rotates.

    Its filters are computed from `radiated_multipoles` at the current gap.

    Successive filters are cross-faded with Hann windows that add up to 1, so that at a
    constant gap the output is that of a single filter."""

    names = ("vibration",)
    channel_ends = np.array([[0.0, 0.0]] * 3 + [[np.nan, 0.0]] * 3)

    def __init__(self, scene: "Scene", listener: Listener) -> None:
        disk = scene.disk
        air = scene.air
        rate = scene.audio.sample_rate
        self._disk = disk
        self._azimuth = listener.azimuth + pi  # azimuth 0 is where the gap is widest
        hop_time = 0.02  # s; interval between successive filters
        self._hop = round(hop_time * rate)
        self.tail_duration = 0.01  # s; length of the impulse response of each filter
        self._response_length = round(self.tail_duration * rate)
        pre_arrival_time = (
            1.3e-3  # s; some sound arrives before that from the disk's centre
        )
        self._pre_arrival = round(pre_arrival_time * rate)
        self._size = next_fast_len(2 * self._hop + self._response_length, real=True)
        self._hann = (
            np.sin(pi * (np.arange(2 * self._hop) + 0.5) / (2 * self._hop)) ** 2
        )
        self.latency = 2 * self._hop + self._pre_arrival
        multipoles = radiated_multipoles(disk, air)
        scale = air.density * disk.radius
        pressure = scale * (
            multipoles.near_pressure_at(listener, disk)
            if listener.distance < multipoles.far * disk.radius
            else multipoles.pressure_at(
                listener.distance / disk.radius, listener.elevation
            )
        )
        self._time_unit = disk.radius / air.sound_speed
        self._pressure = CubicSpline(np.log(TABULATED_MEAN_GAPS), pressure)
        heaved = pressure[:, :, COSINE_ORDERS, 0]
        tilted = pressure[:, :, COSINE_ORDERS, 1]
        rolled = pressure[:, :, MAX_RIM_ORDER + SINE_ORDERS, 2]
        turn = 2 * pi * np.arange(self._size // 2 + 1) / self._size
        inside = np.clip(turn * rate * self._time_unit, *TABULATED_WAVENUMBERS[[0, -1]])
        by_wavenumber = CubicSpline(
            TABULATED_WAVENUMBERS,
            np.concatenate([heaved, tilted, rolled], axis=2),
            axis=1,
        )
        delay = np.exp(-1j * turn * self._pre_arrival)[:, None]
        self._spectrum_by_gap = CubicSpline(
            np.log(TABULATED_MEAN_GAPS), by_wavenumber(inside) * delay
        )
        self._filters: dict[int, np.ndarray] = {}

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels (k, 6); the first three are linear in the force.

        The columns are the acceleration of the centre along the axis of the disk, the
        accelerations of the rim due to tilting about two diameters [m/s^2], cosine and
        sine of the listener's azimuth relative to the widest gap, and the logarithm of
        the ratio of mean gap to radius."""
        azimuth = self._azimuth + listener_azimuth(state)
        gap = np.log(film[:, 0] / self._disk.radius)
        return np.column_stack(
            [
                self._accelerations(force, state[:, 1]),
                np.cos(azimuth),
                np.sin(azimuth),
                gap,
            ]
        )

    def _accelerations(self, force: np.ndarray, inclination: np.ndarray) -> np.ndarray:
        moved = in_patch_frame(force, inclination) @ rigid_acceleration(
            np.eye(3), self._disk
        )
        return np.column_stack(
            [moved[:, 2], self._disk.radius * moved[:, 4:2:-1] * [1, -1]]
        )

    def mean_square_pressure(
        self, inclination: float, frequency: np.ndarray, mean_gap: float | None = None
    ) -> np.ndarray:
        """Return the mean-square pressure (k,) [Pa^2/N^2] per squared normal force at
        frequencies (k,) [Hz].

        The result is averaged over the azimuth of the listener. The ratio of mean gap to
        radius is that of the inclination unless `mean_gap` replaces it; beyond the
        tabulated range the nearest value applies."""
        wide = np.sin(inclination) if mean_gap is None else mean_gap
        gap = np.log(np.clip(wide, *TABULATED_MEAN_GAPS[[0, -1]]))
        normal_force = np.array([[0.0, 0.0, 1.0]])
        waves = (
            self._pressure(gap)
            @ self._accelerations(normal_force, np.array([inclination]))[0]
        )
        inside = np.clip(
            2 * pi * np.asarray(frequency) * self._time_unit,
            *TABULATED_WAVENUMBERS[[0, -1]],
        )
        mean_of_wave = np.where(np.arange(2 * MAX_RIM_ORDER + 1) == 0, 1.0, 0.5)
        return (
            np.abs(CubicSpline(TABULATED_WAVENUMBERS, waves)(inside)) ** 2
            @ mean_of_wave
        )

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the pressure (k, 1) [Pa] of successive
        blocks.

        The disk is at rest before the first block."""
        hop = self._hop
        waiting = np.zeros((hop, 3 * MAX_RIM_ORDER + 3))
        ready = np.zeros(hop)
        tail = np.zeros(self._size)

        def advance(force: "ContactForce") -> np.ndarray:
            nonlocal waiting, ready, tail
            samples = force.samples[:-1]
            waiting = np.vstack([waiting, self._wave_amplitudes(samples)])
            finished = [ready]
            while len(waiting) >= 2 * hop:
                spectrum = rfft(
                    waiting[: 2 * hop, :-1] * self._hann[:, None], self._size, axis=0
                )
                tail = tail + irfft(
                    (spectrum * self._filter_spectra(waiting[hop, -1])).sum(axis=1),
                    self._size,
                )
                finished.append(tail[:hop])
                waiting = waiting[hop:]
                tail = np.append(tail[hop:], np.zeros(hop))
            out, ready = np.split(np.concatenate(finished), [len(samples)])
            return out[:, None]

        return advance

    def _wave_amplitudes(self, samples: np.ndarray) -> np.ndarray:
        """Return the products of accelerations and azimuthal waves, and the log gap.

        The log gap is the last column."""
        heave, tilt, roll, cosine, sine, gap = samples.T[:, :, None]
        wave = (cosine + 1j * sine) ** COSINE_ORDERS
        return np.hstack(
            [heave * wave.real, tilt * wave.real, roll * wave.imag[:, 1:], gap]
        )

    def _filter_spectra(self, gap: float) -> np.ndarray:
        """Return the filter spectra (bins, channels) at a log gap, rounded to a grid."""
        log_gap_step = 0.05
        inside = np.log(TABULATED_MEAN_GAPS[[0, -1]])
        level = round(float(np.clip(gap, *inside)) / log_gap_step)
        if level not in self._filters:
            length = self._response_length
            spectrum = self._spectrum_by_gap(np.clip(level * log_gap_step, *inside))
            response = irfft(spectrum, self._size, axis=0)[:length]
            edge = np.minimum(np.arange(length) + 1, np.arange(length, 0, -1)) / (
                self._pre_arrival / 2
            )
            self._filters[level] = rfft(
                response * np.minimum(edge, 1.0)[:, None], self._size, axis=0
            )
        return self._filters[level]
