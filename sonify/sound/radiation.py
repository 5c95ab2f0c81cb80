"""ACCELERATION -> PRESSURE: a face of the disk as a baffled radiator, the table being the baffle.

Rayleigh's integral p(t) = rho/(2 pi) * integral of w(t - R/c)/R over the face, w its normal acceleration. Valid while
the face lies nearly in the plane of the table and the film of air below it is closed; where the film is open, early in
a motion, air flows round the rim and the true pressure is lower.
"""

from dataclasses import dataclass
from math import lcm
from typing import Any

import numpy as np

from modal import Modes
from modal.radiation import AIR_DENSITY, STANDARD_AIR, Air
from modal.radiation import SOUND_SPEED as SOUND_SPEED

AZIMUTHS = 512
"""Directions at which the radiation of a mode is tabulated; between them it is taken linear."""
LEAST_SINE = 0.06
"""Sine of the turn in a sample, near half a turn, below which the taps turn the phase no further: what they differ by
goes as its inverse, and at half the sample rate it would be infinite. 0.06 is reached 2 % below that."""


@dataclass(frozen=True, kw_only=True)
class Listener:
    """Distance [m] from the centre of the disk and elevation [rad] above the table, in air; azimuth 0 is the table's x
    axis."""

    distance: float
    elevation: float
    azimuth: float = 0.0
    air: Air = STANDARD_AIR

    @property
    def delay(self) -> float:
        """Time from the centre of the disk to the listener [s]."""
        return self.distance / self.air.sound_speed

    @property
    def position(self) -> np.ndarray:
        """The place (3,) [m], the disk's centre at the origin."""
        return position(self, self.azimuth)

    def transit(self, radius: float) -> float:
        """Half the time that a plane wave to the listener needs across the disk [s]."""
        return radius * np.cos(self.elevation) / self.air.sound_speed


def listeners_of(scene: Any) -> list[Listener]:
    """Return the listeners of a scene, in its air: the one of its audio section, or the several that it names."""
    return [
        Listener(
            distance=ear.distance,
            elevation=np.radians(ear.elevation_deg),
            azimuth=np.radians(getattr(ear, "azimuth_deg", 0.0)),
            air=scene.air,
        )
        for ear in scene.audio.listeners or [scene.audio]
    ]


def listener_of(scene: Any) -> Listener:
    """Return the first listener of a scene."""
    return listeners_of(scene)[0]


def rayleigh(face, points, weights, wavenumber, listener_at, density=AIR_DENSITY) -> np.ndarray:
    """Return the pressure [Pa] per unit modal acceleration, at `listener_at` (3,) [m], retarded to the disk's centre.

    `face` (m, p) is the normal shape, `points` (p, 2) [m] and `weights` (p,) [m^2] integrate over it, `wavenumber` (m,)
    [1/m] is that of each shape. Complex (m,): the factor exp(-i k distance) is taken out. Exact for a plane baffle.
    """
    way = np.linalg.norm(listener_at - np.column_stack([points, np.zeros(len(points))]), axis=1)
    wave = np.exp(-1j * np.outer(wavenumber, way - np.linalg.norm(listener_at))) / way
    return density / (2 * np.pi) * np.sum(face * wave * weights, axis=1)


def directions(modes: Modes, listener: Listener, still: bool = False, count: int = AZIMUTHS) -> np.ndarray:
    """Return `rayleigh` of the top face of every mode at `count` even azimuths of the listener, (count, m), complex.

    At the frequency of each mode; at frequency 0 if `still`. Azimuths are in the frame of the modes. The way from a
    point depends on its angle to the listener alone: of each ring the sums for all azimuths are a convolution.
    """
    k = 0 * modes.frequency if still else 2 * np.pi * modes.frequency / listener.air.sound_speed
    around, there = len(modes.face_angle), position(listener, 0.0)
    fine = lcm(around, count)
    radius, angle = modes.face_radius[:, None], 2 * np.pi * np.arange(fine) / fine
    way = np.hypot(np.hypot(there[0] - radius * np.cos(angle), radius * np.sin(angle)), there[2])
    wave = np.exp(-1j * np.multiply.outer(k, way - np.linalg.norm(there))) / way
    face = modes.face_shape[:, 1] * modes.face_weight[:, None] / around
    spectrum = np.tile(np.fft.fft(face), fine // around) * np.fft.fft(wave)  # zeros between the angles of the face
    return listener.air.density * np.fft.ifft(spectrum.sum(axis=1))[:, :: fine // count].T


def taps(modes: Modes, listener: Listener, sample_rate: float) -> np.ndarray:
    """Return three-tap filters (AZIMUTHS, m, 3) on samples n + 1, n, n - 1 that radiate the modes.

    Their response is exactly Rayleigh's integral at the frequency of the mode and at 0. In the last 2 % below half the
    sample rate, where three taps cannot turn the phase, the phase is approximate.
    """
    turn = 2 * np.pi * modes.frequency / sample_rate
    at_mode, at_rest = directions(modes, listener), directions(modes, listener, still=True).real
    both = (at_rest - at_mode.real) / (1 - np.cos(turn))
    square = np.sin(turn) ** 2
    apart = at_mode.imag * np.sin(turn) / np.where(turn > np.pi / 2, np.maximum(square, LEAST_SINE**2), square)
    return np.stack([(both + apart) / 2, at_rest - both, (both - apart) / 2], axis=2)


def heave_kernel(listener: Listener, radius: float, h: float, hole: float = 0.0):
    """Return `step`, `taps` of a disk of `radius` [m] that heaves with unit acceleration: the low-pass by its own size.

    step(t) is the response at t [s] to a step, taps (2 w + 1,) that to samples joined by straight lines, h [s] apart.
    In units of `piston_strength`; to the first order in radius/distance. A disk with a `hole` of that radius [m] is the
    disk without the part that is missing.
    """
    return _without(lambda r: _kernel(listener.transit(r), h, _heave), radius, hole, (hole / radius) ** 2)


def tilt_kernel(listener: Listener, radius: float, h: float, hole: float = 0.0):
    """The same for a disk that rocks: its rim towards the listener has unit acceleration, the opposite rim the reverse.

    Far away the two halves cancel but for their difference in time; nearby also by their difference in distance. The
    rim of the hole has (hole / radius) of the acceleration.
    """

    def whole(r):
        transit = listener.transit(r)
        far_step, far_taps = _kernel(transit, h, _tilt_far)
        near_step, near_taps = _kernel(transit, h, _tilt_near)
        late, close = transit / max(transit, h), transit * listener.air.sound_speed / listener.distance
        return lambda t: late * far_step(t) + close * near_step(t), late * far_taps + close * near_taps

    return _without(whole, radius, hole, (hole / radius) ** 3)


def _without(kernel, radius, hole, share):
    """Step response and taps of kernel(radius) less `share` times those of kernel(hole)."""
    step, taps = kernel(radius)
    if not hole:
        return step, taps
    inner_step, inner_taps = kernel(hole)
    margin = (len(taps) - len(inner_taps)) // 2
    return lambda t: step(t) - share * inner_step(t), taps - share * np.pad(inner_taps, margin)


def _kernel(transit, h, shape):
    """Step response and taps of a `shape` that gives its step response and the integral of it at s = time / transit."""
    width = max(transit, h)  # never sharper than a sample: a step shows in more than one
    reach = int(np.ceil(width / h)) + 1
    t = np.arange(-reach - 1, reach + 2) * h / width
    inside = np.clip(t, -1, 1)
    ramp = shape(inside)[1] + shape(1.0)[0] * np.maximum(t - 1, 0)
    return (lambda t: shape(np.clip(t / width, -1, 1))[0]), np.diff(width * ramp, 2) / h


def _heave(s):
    """(2/pi) sqrt(1 - s^2), the chords of a disk of unit area, integrated once and twice."""
    root, arc = np.sqrt(1 - s * s), np.arcsin(s)
    return 0.5 + (s * root + arc) / np.pi, s / 2 + (s * arc + root - root**3 / 3) / np.pi


def _tilt_far(s):
    """(2/pi) s sqrt(1 - s^2), earlier first."""
    root, arc = np.sqrt(1 - s * s), np.arcsin(s)
    twice = s * (5 - 2 * s * s) * root / 8 + 3 / 8 * (arc + np.pi / 2)
    return 2 / (3 * np.pi) * root**3, 2 / (3 * np.pi) * twice


def _tilt_near(s):
    """(2/pi) s^2 sqrt(1 - s^2)."""
    root, arc = np.sqrt(1 - s * s), np.arcsin(s)
    once = (s * (2 * s * s - 1) * root + arc) / 8 + np.pi / 16
    twice = (s * arc + root - root**3 / 3 + 2 / 5 * root**5) / 8 + np.pi / 16 * s
    return 2 / np.pi * once, 2 / np.pi * twice


def piston_strength(radius: float, distance: float, density: float = AIR_DENSITY) -> float:
    """Pressure [Pa] of a small disk per unit acceleration [m/s^2], rho R^2/(2 r): the monopole on a baffle."""
    return density * radius**2 / (2 * distance)


def position(listener: Listener, azimuth: float) -> np.ndarray:
    """Return where the listener is (3,) [m], from an azimuth [rad]."""
    across = listener.distance * np.cos(listener.elevation)
    return np.array(
        [across * np.cos(azimuth), across * np.sin(azimuth), listener.distance * np.sin(listener.elevation)]
    )
