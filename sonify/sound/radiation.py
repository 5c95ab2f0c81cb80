"""ACCELERATION -> PRESSURE: a face of the disk as a baffled radiator; the table is the baffle.

Rayleigh's integral: p(t) = rho/(2 pi) * integral of w(t - R/c)/R over the face, with w its normal
acceleration. It holds while the face is nearly in the plane of the table and the air film below it
is closed. Early in a motion the film is open, air flows round the rim, and the true pressure is
lower."""

from dataclasses import dataclass
from math import lcm
from typing import Any

import numpy as np

from modal import Modes
from modal.radiation import AIR_DENSITY, STANDARD_AIR, Air
from modal.radiation import SOUND_SPEED as SOUND_SPEED
from sonify.scene import Ear

AZIMUTH_COUNT = 512
"""Number of azimuths at which the radiation of a mode is tabulated; it is interpolated linearly
between them."""


@dataclass(frozen=True, kw_only=True)
class Listener:
    """Position of a listener: distance [m] from the disk's centre, elevation [rad] above the table,
    azimuth [rad].

    Azimuth 0 is the table's x axis.
    """

    distance: float
    elevation: float
    azimuth: float = 0.0
    air: Air = STANDARD_AIR

    @property
    def delay(self) -> float:
        """Travel time of sound from the centre of the disk to the listener [s]."""
        return self.distance / self.air.sound_speed

    @property
    def position(self) -> np.ndarray:
        """Cartesian coordinates (3,) [m]; the centre of the disk is the origin."""
        return listener_position(self, self.azimuth)

    def transit(self, radius: float) -> float:
        """Return half the time [s] of a plane wave to the listener across a disk of `radius`
        [m]."""
        return radius * np.cos(self.elevation) / self.air.sound_speed


def listeners_of(scene: Any) -> list[Listener]:
    """Return the listeners of a scene: `audio.listeners`, or the one of its audio section."""
    alone = Ear(distance=scene.audio.distance, elevation_deg=scene.audio.elevation_deg)
    return [
        Listener(
            distance=ear.distance,
            elevation=np.radians(ear.elevation_deg),
            azimuth=np.radians(ear.azimuth_deg),
            air=scene.air,
        )
        for ear in scene.audio.listeners or [alone]
    ]


def listener_of(scene: Any) -> Listener:
    """Return the first listener of a scene."""
    return listeners_of(scene)[0]


def rayleigh(face, points, weights, wavenumber, listener_at, density=AIR_DENSITY) -> np.ndarray:
    """Evaluate Rayleigh's integral over a plane face; exact for a plane baffle.

    Parameters
    ----------
    face : ndarray, shape (m, p)
        Normal shape of each mode at the quadrature points.
    points, weights : ndarray, shapes (p, 2) and (p,)
        Quadrature points [m] and weights [m^2].
    wavenumber : ndarray, shape (m,)
        Wavenumber of each mode [1/m].
    listener_at : ndarray, shape (3,)
        Position of the listener [m].
    density : float
        Density of the air [kg/m^3].

    Returns
    -------
    ndarray, shape (m,), complex
        Pressure [Pa] per unit modal acceleration, without the factor exp(-i k distance).
    """
    path = np.linalg.norm(listener_at - np.column_stack([points, np.zeros(len(points))]), axis=1)
    wave = np.exp(-1j * np.outer(wavenumber, path - np.linalg.norm(listener_at))) / path
    return density / (2 * np.pi) * np.sum(face * wave * weights, axis=1)


def directivity_table(
    modes: Modes, listener: Listener, still: bool = False, count: int = AZIMUTH_COUNT
) -> np.ndarray:
    """Return `rayleigh` of the top face of each mode at `count` equidistant azimuths of the
    listener, (count, m).

    Each mode is evaluated at its own frequency, or at frequency 0 if `still`. Azimuths are in the
    frame of the modes. The path from a point depends only on its angle to the listener, so the sums
    over each ring are a convolution."""
    k = 0 * modes.frequency if still else 2 * np.pi * modes.frequency / listener.air.sound_speed
    face_angles = len(modes.face_angle)
    place = listener_position(listener, 0.0)
    fine = lcm(face_angles, count)
    radius = modes.face_radius[:, None]
    angle = 2 * np.pi * np.arange(fine) / fine
    path = np.hypot(np.hypot(place[0] - radius * np.cos(angle), radius * np.sin(angle)), place[2])
    wave = np.exp(-1j * np.multiply.outer(k, path - np.linalg.norm(place))) / path
    face = modes.face_shape[:, 1] * modes.face_weight[:, None] / face_angles
    # Tiling the spectrum puts zeros between the angles of the face.
    spectrum = np.tile(np.fft.fft(face), fine // face_angles) * np.fft.fft(wave)
    return listener.air.density * np.fft.ifft(spectrum.sum(axis=1))[:, :: fine // count].T


def mode_taps(modes: Modes, listener: Listener, sample_rate: float) -> np.ndarray:
    """Return three-tap filters (AZIMUTH_COUNT, m, 3) on samples n + 1, n, n - 1 that radiate the modes.

    Their response equals Rayleigh's integral at the frequency of the mode and at 0. In the last 2 %
    below half the sample rate three taps cannot turn the phase, and the phase is approximate."""
    min_sine = 0.06  # reached 2 % below half the sample rate, where the taps would be infinite
    turn = 2 * np.pi * modes.frequency / sample_rate
    at_mode = directivity_table(modes, listener)
    at_rest = directivity_table(modes, listener, still=True).real
    even = (at_rest - at_mode.real) / (1 - np.cos(turn))
    square = np.sin(turn) ** 2
    bounded_square = np.where(turn > np.pi / 2, np.maximum(square, min_sine**2), square)
    odd = at_mode.imag * np.sin(turn) / bounded_square
    return np.stack([(even + odd) / 2, at_rest - even, (even - odd) / 2], axis=2)


def heave_kernel(listener: Listener, radius: float, h: float, hole: float = 0.0):
    """Return (step, taps): the pressure of a disk that heaves, in units of `piston_strength`.

    step(t) is the response at t [s] to a unit step of the acceleration; `taps` (2 w + 1,) filter
    samples h [s] apart, joined by straight lines. The finite `radius` [m] of the disk acts as a
    low-pass filter. The kernel is accurate to first order in radius/distance. The radiation of a
    hole of radius `hole` [m] is subtracted."""
    return _subtract_hole(
        lambda r: _kernel(listener.transit(r), h, heave_impulse_integral),
        radius,
        hole,
        (hole / radius) ** 2,
    )


def tilt_kernel(listener: Listener, radius: float, h: float, hole: float = 0.0):
    """Return (step, taps) as `heave_kernel` does, for a disk that tilts.

    The rim towards the listener has unit acceleration, the opposite rim the reverse. In the far
    field the two halves differ only in their travel time; in the near field also in their distance.
    The rim of the hole has (hole / radius) of the acceleration."""

    def solid_kernel(r):
        transit = listener.transit(r)
        far_step, far_taps = _kernel(transit, h, tilt_far_integral)
        near_step, near_taps = _kernel(transit, h, tilt_near_integral)
        far = transit / max(transit, h)
        near = transit * listener.air.sound_speed / listener.distance
        return lambda t: far * far_step(t) + near * near_step(t), far * far_taps + near * near_taps

    return _subtract_hole(solid_kernel, radius, hole, (hole / radius) ** 3)


def _subtract_hole(kernel, radius, hole, share):
    """Return step response and taps of kernel(radius) minus `share` times those of kernel(hole)."""
    step, taps = kernel(radius)
    if not hole:
        return step, taps
    inner_step, inner_taps = kernel(hole)
    margin = (len(taps) - len(inner_taps)) // 2
    return lambda t: step(t) - share * inner_step(t), taps - share * np.pad(inner_taps, margin)


def _kernel(transit, h, shape):
    """Return step response and taps of a pulse of half width `transit` [s].

    shape(s) returns the step response of the pulse and its integral at s = time / transit."""
    width = max(transit, h)  # at least one sample, so that a step spreads over more than one
    reach = int(np.ceil(width / h)) + 1
    t = np.arange(-reach - 1, reach + 2) * h / width
    inside = np.clip(t, -1, 1)
    ramp = shape(inside)[1] + shape(1.0)[0] * np.maximum(t - 1, 0)
    return (lambda t: shape(np.clip(t / width, -1, 1))[0]), np.diff(width * ramp, 2) / h


def heave_impulse_integral(s):
    """Integrate (2/pi) sqrt(1 - s^2), the chords of a disk of unit area, once and twice."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    return 0.5 + (s * root + arc) / np.pi, s / 2 + (s * arc + root - root**3 / 3) / np.pi


def tilt_far_integral(s):
    """Integrate (2/pi) s sqrt(1 - s^2), the far field of a tilting disk, once and twice."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    twice = s * (5 - 2 * s * s) * root / 8 + 3 / 8 * (arc + np.pi / 2)
    return 2 / (3 * np.pi) * root**3, 2 / (3 * np.pi) * twice


def tilt_near_integral(s):
    """Integrate (2/pi) s^2 sqrt(1 - s^2), the near field of a tilting disk, once and twice."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    once = (s * (2 * s * s - 1) * root + arc) / 8 + np.pi / 16
    twice = (s * arc + root - root**3 / 3 + 2 / 5 * root**5) / 8 + np.pi / 16 * s
    return 2 / np.pi * once, 2 / np.pi * twice


def piston_strength(radius: float, distance: float, density: float = AIR_DENSITY) -> float:
    """Return rho R^2/(2 r), the pressure of a small baffled disk per acceleration [kg/m^2]."""
    return density * radius**2 / (2 * distance)


def listener_position(listener: Listener, azimuth: float) -> np.ndarray:
    """Return the coordinates (3,) [m] of the listener, moved to an azimuth [rad]."""
    across = listener.distance * np.cos(listener.elevation)
    return np.array(
        [
            across * np.cos(azimuth),
            across * np.sin(azimuth),
            listener.distance * np.sin(listener.elevation),
        ]
    )
