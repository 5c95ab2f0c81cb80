"""The rigid disk that vibrates on its contact, over its film of air: pressure by filters that follow the gap."""

from math import pi

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft
from scipy.interpolate import CubicSpline

from sonify.sound.drive import in_patch_frame, listener_azimuth, rigid_acceleration
from sonify.sound.film import log_gap
from sonify.sound.open_film import GAPS, NUMBERS, ORDERS, radiated
from sonify.sound.radiation import Listener

HOP, RING, AHEAD = 0.02, 0.01, 1.3e-3
"""Times [s]: from one filter to the next, of its response, and of that part of it which comes before the centre's."""
STEP = 0.05
"""The filter changes where the logarithm of the gap has changed by so much."""
EVEN, ODD = np.arange(ORDERS + 1), np.arange(1, ORDERS + 1)


class VibratingDisk:
    """A source that is heard as `open_film.radiated` says: for forces that swing faster than the disk turns.

    Between filters it goes over by Hann's windows, which add up to 1: while the gap stays it is exactly one filter.
    """

    names = ("vibration",)
    ends = np.array([[0.0, 0.0]] * 3 + [[np.nan, 0.0]] * 3)
    lasting = RING

    def __init__(self, scene, listener: Listener):
        self._disk, rate = scene.disk, scene.audio.sample_rate
        self._azimuth = listener.azimuth + pi  # from where the gap is widest
        self._hop, self._ring, self._ahead = (round(part * rate) for part in (HOP, RING, AHEAD))
        self._size = next_fast_len(2 * self._hop + self._ring, real=True)
        self._hann = np.sin(pi * (np.arange(2 * self._hop) + 0.5) / (2 * self._hop)) ** 2
        self.late = 2 * self._hop + self._ahead
        scale = scene.air.density * self._disk.radius
        pressure = scale * radiated(self._disk, scene.air).at(listener.distance / self._disk.radius, listener.elevation)
        self._number, self._pressure = self._disk.radius / scene.air.sound_speed, CubicSpline(np.log(GAPS), pressure)
        heaved, tilted, rolled = (pressure[:, :, some, i] for i, some in enumerate((EVEN, EVEN, ORDERS + ODD)))
        turn = 2 * pi * np.arange(self._size // 2 + 1) / self._size
        inside = np.clip(turn * rate * self._number, *NUMBERS[[0, -1]])
        heard = CubicSpline(NUMBERS, np.concatenate([heaved, tilted, rolled], axis=2), axis=1)(inside)
        self._by_gap, self._filters = CubicSpline(np.log(GAPS), heard * np.exp(-1j * turn * self._ahead)[:, None]), {}

    def channels(self, force, state):
        """Return the acceleration of the centre along the axis of the disk, and of the rim by tilting about either
        diameter [m/s^2]; cosine and sine of the listener's azimuth, from where the gap is widest; the logarithm of the
        mean gap over the radius: (k, 6), the first three linear in the force."""
        azimuth = self._azimuth + listener_azimuth(state, turning_with_body=False)
        gap = log_gap(state, self._disk) - np.log(self._disk.radius)
        return np.column_stack([self._moved(force, state[:, 1]), np.cos(azimuth), np.sin(azimuth), gap])

    def _moved(self, force, inclination):
        moved = in_patch_frame(force, inclination) @ rigid_acceleration(np.eye(3), self._disk)
        return np.column_stack([moved[:, 2], self._disk.radius * moved[:, 4:2:-1] * [1, -1]])

    def loudness(self, inclination: float, frequency) -> np.ndarray:
        """Return the mean square (k,) [Pa^2/N^2] round the disk of what a vibration of the normal force radiates at
        frequencies (k,) [Hz]."""
        gap = np.log(np.clip(np.sin(inclination), *GAPS[[0, -1]]))
        waves = self._pressure(gap) @ self._moved(np.array([[0.0, 0.0, 1.0]]), np.array([inclination]))[0]
        inside = np.clip(2 * pi * np.asarray(frequency) * self._number, *NUMBERS[[0, -1]])
        return np.abs(CubicSpline(NUMBERS, waves)(inside)) ** 2 @ np.where(np.arange(2 * ORDERS + 1) == 0, 1.0, 0.5)

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on stillness, (k, 1) [Pa]."""
        hop, waiting = self._hop, np.zeros((self._hop, 3 * ORDERS + 3))
        ready, tail = np.zeros(hop), np.zeros(self._size)

        def advance(force):
            nonlocal waiting, ready, tail
            samples = force.samples[:-1]
            waiting, pieces = np.vstack([waiting, self._driven(samples)]), [ready]
            while len(waiting) >= 2 * hop:
                spectrum = rfft(waiting[: 2 * hop, :-1] * self._hann[:, None], self._size, axis=0)
                tail = tail + irfft((spectrum * self._filter(waiting[hop, -1])).sum(axis=1), self._size)
                pieces.append(tail[:hop])
                waiting, tail = waiting[hop:], np.append(tail[hop:], np.zeros(hop))
            out, ready = np.split(np.concatenate(pieces), [len(samples)])
            return out[:, None]

        return advance

    def _driven(self, samples):
        """Each acceleration times the waves that it radiates in the direction of the listener, and the gap."""
        heave, tilt, roll, cosine, sine, gap = samples.T[:, :, None]
        wave = (cosine + 1j * sine) ** EVEN
        return np.hstack([heave * wave.real, tilt * wave.real, roll * wave.imag[:, 1:], gap])

    def _filter(self, gap):
        """The filters (bins, channels) at the logarithm of a gap, of a response that ends."""
        inside = np.log(GAPS[[0, -1]])
        level = round(float(np.clip(gap, *inside)) / STEP)
        if level not in self._filters:
            response = irfft(self._by_gap(np.clip(level * STEP, *inside)), self._size, axis=0)[: self._ring]
            edge = np.minimum(np.arange(self._ring) + 1, np.arange(self._ring, 0, -1)) / (self._ahead / 2)
            self._filters[level] = rfft(response * np.minimum(edge, 1.0)[:, None], self._size, axis=0)
        return self._filters[level]
