"""Compute the sound radiated by a face of the disk, with the table as a baffle.

Rayleigh's integral is p(t) = rho/(2 pi) * integral of w(t - R/c)/R over the face, with
its normal acceleration w. It is valid if the face lies nearly in the plane of the table
and the air film below it is closed. Early in a motion the film is open, air flows
around the rim, and the true pressure is lower."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynamics.air import STANDARD_AIR, Air
from modal import Modes
from modal.radiation import AIR_DENSITY
from modal.radiation import SOUND_SPEED as SOUND_SPEED
from sonify.scene import ListenerPosition
from sonify.sound.head import Ear

Kernel = tuple[Callable[[np.ndarray], np.ndarray], np.ndarray]
"""Step response, a function of the time [s], and taps."""
Integrals = Callable[[float | np.ndarray], tuple[np.ndarray, np.ndarray]]
"""Function that returns the first and second integrals of a pulse."""


@dataclass(frozen=True, kw_only=True)
class Listener:
    """Position of a listener and properties of the air.

    The distance [m] is measured from the centre of the disk, the elevation [rad] from
    the table, and the azimuth [rad] from the table's x axis. The upper face of the disk
    is `face_height` [m] above its centre; for a distant listener the height is
    irrelevant and set to 0. An `ear` belongs to a head that scatters the sound.
    """

    distance: float
    elevation: float
    azimuth: float = 0.0
    air: Air = STANDARD_AIR
    face_height: float = 0.0
    ear: Ear | None = None

    @property
    def is_in_near_field(self) -> bool:
        """True if the listener is in the near field of the disk."""
        return self.face_height > 0

    @property
    def delay(self) -> float:
        """Travel time of sound from the centre of the disk to the listener [s]."""
        return self.distance / self.air.sound_speed

    @property
    def position(self) -> np.ndarray:
        """Cartesian coordinates (3,) [m]; the centre of the disk is the origin."""
        return listener_position(self, self.azimuth)

    def half_crossing_time(self, radius: float) -> float:
        """Return half the time [s] in which the direct sound crosses a disk of `radius`
        [m]."""
        return radius * np.cos(self.elevation) / self.air.sound_speed


def listeners_of(scene: Any) -> list[Listener]:
    """Return `audio.listeners` of a scene, or the single listener of its audio section.

    A head yields two listeners, its left and its right ear."""
    positions = scene.audio.listeners or [scene.audio.single_listener]
    return [ear for position in positions for ear in _ears_of(position, scene)]


def _ears_of(position: ListenerPosition, scene: Any) -> list[Listener]:
    """Return the listener at a position, or the two ears of a head there."""
    # Ratio of distance to disk radius below which the near field is computed
    near_field_distance_ratio = 4.0
    is_in_near_field = position.distance < near_field_distance_ratio * scene.disk.radius
    listener = Listener(
        distance=position.distance,
        elevation=np.radians(position.elevation_deg),
        azimuth=np.radians(position.azimuth_deg),
        air=scene.air,
        face_height=scene.disk.thickness / 2 if is_in_near_field else 0.0,
    )
    if position.kind == "point":
        return [listener]
    centre = listener.position
    nose = listener.azimuth + np.pi + np.radians(position.facing_deg)
    ears = []
    for side in (1, -1):
        angle = nose + side * np.radians(position.ear_angle_deg)
        out = np.array([np.cos(angle), np.sin(angle), 0.0])
        place = centre + position.head_radius * out
        distance = float(np.linalg.norm(place))
        ear = Ear(
            head_radius=position.head_radius,
            source_distance=position.distance,
            cosine=float(-centre @ out / position.distance),
        )
        ears.append(
            replace(
                listener,
                distance=distance,
                elevation=np.arcsin(place[2] / distance),
                azimuth=np.arctan2(place[1], place[0]),
                ear=ear,
            )
        )
    return ears


def listener_of(scene: Any) -> Listener:
    """Return the first listener of a scene."""
    return listeners_of(scene)[0]


def rayleigh(
    face: np.ndarray,
    points: np.ndarray,
    weights: np.ndarray,
    wavenumber: float | np.ndarray,
    listener_at: ArrayLike,
    density: float = AIR_DENSITY,
) -> np.ndarray:
    """Evaluate Rayleigh's integral over a plane face, which is exact in a plane baffle.

    Parameters
    ----------
    face : ndarray, shape (..., p)
        Normal shapes at the quadrature points.
    points, weights : ndarray, shapes (p, 2) and (p,)
        Quadrature points [m] and weights [m^2].
    wavenumber : ndarray, shape (...)
        Wavenumber of each shape [1/m]; it broadcasts with the shapes.
    listener_at : ndarray, shape (3,)
        Position of the listener [m].
    density : float
        Density of the air [kg/m^3].

    Returns
    -------
    ndarray, shape (...), complex
        Pressure [Pa] per unit acceleration of each shape, without the factor exp(-i k
        distance).
    """
    path = np.linalg.norm(
        listener_at - np.column_stack([points, np.zeros(len(points))]), axis=1
    )
    phase = np.multiply.outer(wavenumber, path - np.linalg.norm(listener_at))
    wave = np.exp(-1j * phase) / path
    return density / (2 * np.pi) * np.sum(face * wave * weights, axis=-1)


def tabulated_directivity(
    modes: Modes, listener: Listener, count: int, at_zero_frequency: bool = False
) -> np.ndarray:
    """Return Rayleigh's integral (count, m) over the top face of each mode.

    The listener is at `count` equally spaced azimuths in the frame of the modes. Each
    mode is evaluated at its own frequency, unless `at_zero_frequency` is True. The path
    from a point depends only on its angle to the listener, so the sum over each ring is
    a convolution."""
    k = (
        0 * modes.frequency
        if at_zero_frequency
        else 2 * np.pi * modes.frequency / listener.air.sound_speed
    )
    face_angles = len(modes.face_angle)
    place = listener_position(listener, 0.0)
    place[2] -= listener.face_height
    fine = lcm(face_angles, count)
    radius = modes.face_radius[:, None]
    angle = 2 * np.pi * np.arange(fine) / fine
    path = np.hypot(
        np.hypot(place[0] - radius * np.cos(angle), radius * np.sin(angle)), place[2]
    )
    wave = np.exp(-1j * np.multiply.outer(k, path - listener.distance)) / path
    face = modes.face_shape[:, 1] * modes.face_weight[:, None] / face_angles
    # Tiling the spectrum inserts zeros between the angles of the face.
    spectrum = np.tile(np.fft.fft(face), fine // face_angles) * np.fft.fft(wave)
    return (
        listener.air.density * np.fft.ifft(spectrum.sum(axis=1))[:, :: fine // count].T
    )


def mode_taps(modes: Modes, listener: Listener, sample_rate: float) -> np.ndarray:
    """Return three-tap filters (a, m, 3) from modal accelerations to pressure.

    They are tabulated at a equally spaced azimuths for linear interpolation.
    The taps apply to samples n + 1, n, n - 1. The response equals Rayleigh's integral
    at the frequency of the mode and at 0. The phase is only approximate less than 2 %
    below the Nyquist frequency."""
    azimuth_count = 512
    min_sine = (
        0.06  # sine at 2 % below the Nyquist frequency, where the taps would diverge
    )
    turn = 2 * np.pi * modes.frequency / sample_rate
    at_mode = tabulated_directivity(modes, listener, azimuth_count)
    at_rest = tabulated_directivity(
        modes, listener, azimuth_count, at_zero_frequency=True
    ).real
    even = (at_rest - at_mode.real) / (1 - np.cos(turn))
    square = np.sin(turn) ** 2
    bounded_square = np.where(turn > np.pi / 2, np.maximum(square, min_sine**2), square)
    odd = at_mode.imag * np.sin(turn) / bounded_square
    return np.stack([(even + odd) / 2, at_rest - even, (even - odd) / 2], axis=2)


def heave_kernel(
    listener: Listener, radius: float, h: float, hole: float = 0.0
) -> Kernel:
    """Return step response and taps for the pressure of a heaving disk.

    The unit of pressure is `piston_strength`. The function step(t) is the response at t
    [s] to a unit step of the acceleration; the taps (2 w + 1,) apply to linearly
    interpolated samples with a spacing of h [s]. The finite `radius` [m] of the disk
    acts as a low-pass filter. The kernel is accurate to first order in radius/distance.
    The radiation of a hole of radius `hole` [m] is subtracted."""
    return _subtract_hole(
        lambda r: pulse_kernel(
            listener.half_crossing_time(r), h, heave_pulse_integrals
        ),
        radius,
        hole,
        (hole / radius) ** 2,
    )


def tilt_kernel(
    listener: Listener, radius: float, h: float, hole: float = 0.0
) -> Kernel:
    """Return step response and taps for a tilting disk, in the form of `heave_kernel`.

    The acceleration of the rim is 1 at the point nearest to the listener and -1 at the
    farthest point. In the far field the two halves differ only in travel time; in the
    near field they also differ in distance. The acceleration at the rim of the hole is
    smaller by the factor hole / radius."""

    def solid_kernel(r: float) -> Kernel:
        transit = listener.half_crossing_time(r)
        far_step, far_taps = pulse_kernel(transit, h, tilt_far_field_integrals)
        near_step, near_taps = pulse_kernel(transit, h, tilt_near_field_integrals)
        far = transit / max(transit, h)
        near = transit * listener.air.sound_speed / listener.distance
        return (
            lambda t: far * far_step(t) + near * near_step(t),
            far * far_taps + near * near_taps,
        )

    return _subtract_hole(solid_kernel, radius, hole, (hole / radius) ** 3)


def _subtract_hole(
    kernel: Callable[[float], Kernel], radius: float, hole: float, share: float
) -> Kernel:
    """Return step response and taps of kernel(radius) minus `share` times those of
    kernel(hole)."""
    step, taps = kernel(radius)
    if not hole:
        return step, taps
    inner_step, inner_taps = kernel(hole)
    margin = (len(taps) - len(inner_taps)) // 2
    return lambda t: step(t) - share * inner_step(t), taps - share * np.pad(
        inner_taps, margin
    )


def pulse_kernel(transit: float, h: float, shape: Integrals) -> Kernel:
    """Return step response and taps of a pulse of half width `transit` [s].

    The function shape(s) returns the step response of the pulse and its integral at s =
    time / transit."""
    width = max(
        transit, h
    )  # at least one sample, so that a step spreads over several samples
    reach = int(np.ceil(width / h)) + 1
    t = np.arange(-reach - 1, reach + 2) * h / width
    inside = np.clip(t, -1, 1)
    ramp = shape(inside)[1] + shape(1.0)[0] * np.maximum(t - 1, 0)
    return (lambda t: shape(np.clip(t / width, -1, 1))[0]), np.diff(width * ramp, 2) / h


def heave_pulse_integrals(s: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the first and second integrals of (2/pi) sqrt(1 - s^2), the chord lengths
    of a disk of unit area."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    return 0.5 + (s * root + arc) / np.pi, s / 2 + (
        s * arc + root - root**3 / 3
    ) / np.pi


def tilt_far_field_integrals(s: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the first and second integrals of (2/pi) s sqrt(1 - s^2), the far field of
    a tilting disk."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    twice = s * (5 - 2 * s * s) * root / 8 + 3 / 8 * (arc + np.pi / 2)
    return 2 / (3 * np.pi) * root**3, 2 / (3 * np.pi) * twice


def tilt_near_field_integrals(s: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the first and second integrals of (2/pi) s^2 sqrt(1 - s^2), the near field
    of a tilting disk."""
    root = np.sqrt(1 - s * s)
    arc = np.arcsin(s)
    once = (s * (2 * s * s - 1) * root + arc) / 8 + np.pi / 16
    twice = (s * arc + root - root**3 / 3 + 2 / 5 * root**5) / 8 + np.pi / 16 * s
    return 2 / np.pi * once, 2 / np.pi * twice


def piston_strength(
    radius: float, distance: float, density: float = AIR_DENSITY
) -> float:
    """Return rho R^2/(2 r) [kg/m^2], the pressure of a small baffled disk per unit
    acceleration."""
    return density * radius**2 / (2 * distance)


def listener_position(listener: Listener, azimuth: float) -> np.ndarray:
    """Return the coordinates (3,) [m] of the listener rotated to an azimuth [rad]."""
    across = listener.distance * np.cos(listener.elevation)
    return np.array(
        [
            across * np.cos(azimuth),
            across * np.sin(azimuth),
            listener.distance * np.sin(listener.elevation),
        ]
    )
