"""Compute the sound near a disk by direct evaluation of Rayleigh's integral.

The upper face is assumed to radiate as in a baffle, and the flow out of the rim as on
an empty table. For a thickness of a third of the radius, the result differs from a
finite-element solution by 1 to 4 dB. See tests/sound/test_head_and_near_field.py."""

from typing import TYPE_CHECKING

import numpy as np

from sonify.sound.radiation import Kernel, Listener, listener_position, pulse_kernel

if TYPE_CHECKING:
    from dynamics.disk import Disk


def face_points(disk: "Disk", rings: int, spokes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the points (p, 2) [m] and weights (p,) [m^2] of a circular or annular
    face."""
    radius = disk.radius
    hole = disk.inner_radius
    ring = hole + (radius - hole) * (np.arange(rings) + 0.5) / rings
    turn = 2 * np.pi * (np.arange(spokes) + 0.5) / spokes
    points = np.multiply.outer(ring, np.column_stack([np.cos(turn), np.sin(turn)]))
    weight = ring * (radius - hole) / rings * 2 * np.pi / spokes
    return points.reshape(-1, 2), np.repeat(weight, spokes)


def rim_points(radius: float, spokes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the points (p, 2) [m] of the rim and their weights (p,) [m]."""
    turn = 2 * np.pi * (np.arange(spokes) + 0.5) / spokes
    points = radius * np.column_stack([np.cos(turn), np.sin(turn)])
    return points, np.full(spokes, 2 * np.pi * radius / spokes)


def path_lengths(listener: Listener, points: np.ndarray, height: float) -> np.ndarray:
    """Return the distances (p,) [m] from points at a height above the centre of the
    disk to a listener on the x axis."""
    across, _, above = listener_position(listener, 0.0)
    return np.sqrt(
        (points[:, 0] - across) ** 2 + points[:, 1] ** 2 + (above - height) ** 2
    )


def near_face_kernels(listener: Listener, disk: "Disk", h: float) -> list[Kernel]:
    """Return step response and taps of heave and tilt, in the form of
    `radiation.heave_kernel`."""
    points, weights = face_points(disk, rings=200, spokes=720)
    return [
        _rayleigh_kernel(
            listener, disk, h, points, weights * shape, listener.face_height
        )
        for shape in (1.0, points[:, 0] / disk.radius)
    ]


def near_rim_kernels(listener: Listener, disk: "Disk", h: float) -> list[Kernel]:
    """Return the step responses and their taps for a flow out of the rim that varies
    around it as harmonic 0, 1 and 2.

    The amplitude of each flow is one unit: the volume flow of unit heave, the dipole of
    unit tilt and, for harmonic 2, the flow amplitude of unit heave."""
    points, weights = rim_points(disk.radius, spokes=7200)
    x, y = points.T / disk.radius
    flows = (disk.radius / 2, disk.radius / 4 * x, disk.radius / 2 * (x * x - y * y))
    return [
        _rayleigh_kernel(
            listener, disk, h, points, weights * flow, -listener.face_height
        )
        for flow in flows
    ]


def _rayleigh_kernel(
    listener: Listener,
    disk: "Disk",
    h: float,
    points: np.ndarray,
    weights: np.ndarray,
    height: float,
) -> Kernel:
    """Return step response and taps of sources (p,) [m^2] at points (p, 2), in units of
    `piston_strength`."""
    path = path_lengths(listener, points, height)
    half_width = (disk.radius + listener.face_height) / listener.air.sound_speed
    arrival = (path - listener.distance) / listener.air.sound_speed / half_width
    order = np.argsort(arrival)
    strength = weights * listener.distance / (np.pi * disk.radius**2 * path)
    arrival = arrival[order]
    strength = strength[order]
    steps = np.append(0.0, np.cumsum(strength))
    moments = np.append(0.0, np.cumsum(strength * arrival))

    def integrals(s: float | np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        count = np.searchsorted(arrival, s, "right")
        return steps[count], s * steps[count] - moments[count]

    return pulse_kernel(half_width, h, integrals)


def rayleigh_waves(
    listener: Listener, disk: "Disk", wavenumbers: np.ndarray, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the pressures of face and rim at a listener, divided by density and
    radius.

    The propagation phase from the centre of the disk is removed.

    Parameters
    ----------
    listener : Listener
    disk : Disk
    wavenumbers : ndarray, shape (a,)
        Wavenumbers times radius.
    count : int
        Number of harmonics.

    Returns
    -------
    face : ndarray, shape (a, 2)
        Pressures due to the face accelerations 1 and x.
    rim : ndarray, shape (a, count)
        Pressures due to the rim flows cos n theta per unit length, for n < count.
    """
    points, weights = face_points(disk, rings=50, spokes=180)
    around, lengths = rim_points(disk.radius, spokes=180)
    turn = np.arctan2(around[:, 1], around[:, 0])
    face_shapes = [np.ones(len(points)), points[:, 0] / disk.radius]
    rim_shapes = [np.cos(n * turn) for n in range(count)]
    waves = []
    for places, sources, shapes, height in (
        (points, weights / disk.radius**2, face_shapes, listener.face_height),
        (around, lengths / disk.radius, rim_shapes, -listener.face_height),
    ):
        path = path_lengths(listener, places, height) / disk.radius
        phase = np.multiply.outer(wavenumbers, path - listener.distance / disk.radius)
        green = np.exp(-1j * phase) * (sources / (2 * np.pi * path))
        waves.append(green @ np.transpose(shapes))
    return waves[0], waves[1]
