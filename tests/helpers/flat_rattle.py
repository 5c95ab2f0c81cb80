"""The flat limit: a nearly horizontal disk with contact anywhere on its rim.

The rim rests on a ring of springs, linear in the depth, whose sum is Hertz's force of the smooth
contact. Neighbouring points in contact form a patch. A patch is damped by its own mean approach
speed, weighted by the depth, because damping of each point would resist rolling.
"""

from math import pi, sqrt
from typing import NamedTuple

import numpy as np
from rim_unevenness import contact_depth, damping_ratio

from dynamics.numba_kernels import kernel, outermost

GRAVITY = 9.81


class FlatDisk(NamedTuple):
    """A flat disk on its ring of springs, SI units."""

    radius: float
    mass: float
    gyration: float
    """Moment of inertia about a diameter over m R^2."""
    modulus: float
    """Contact modulus E* [Pa]."""
    fillet: float
    ratio: float
    """Damping ratio of the contact."""


class FreeModes(NamedTuple):
    """Free modes of the disk: orders, angular frequencies [rad/s], decays [1/s], shapes at the rim
    [kg^-1/2], each (k,)."""

    order: np.ndarray
    frequency: np.ndarray
    decay: np.ndarray
    shape: np.ndarray


class FlatMotion(NamedTuple):
    """Samples of a motion in the flat limit.

    Attributes
    ----------
    t : ndarray, (n,)
        Times [s].
    state : ndarray, (n, 6)
        Height [m], tilt along x and y [m], and their rates.
    """

    t: np.ndarray
    state: np.ndarray

    def inclination(self, radius):
        """Return the inclination (n,) [rad]."""
        return np.hypot(self.state[:, 1], self.state[:, 2]) / radius


def flat_disk(radius, thickness, mass, modulus, fillet, restitution):
    """Return the FlatDisk of a cylinder whose contact has this restitution."""
    gyration = 0.25 + thickness**2 / (12 * radius**2)
    return FlatDisk(radius, mass, gyration, modulus, fillet, damping_ratio(restitution))


NO_MODES = FreeModes(np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0))


def rolling_start(disk, inclination):
    """Return the state (6,) of steady rolling on a smooth table at an inclination [rad]."""
    rate = sqrt(GRAVITY / (disk.gyration * disk.radius * inclination))
    tilt = disk.radius * inclination
    depth = contact_depth(
        disk.mass * GRAVITY, disk.modulus, disk.radius, disk.fillet, inclination
    )
    return np.array([tilt - depth, -tilt, 0.0, 0.0, 0.0, -tilt * rate])


class FlatCase(NamedTuple):
    """A disk on a rim profile.

    Attributes
    ----------
    disk : FlatDisk
        The disk.
    heights : ndarray, (p,)
        Heights [m] of table minus edge at equidistant angles.
    modes : FreeModes
        Modes of the disk that act back on the gap.
    gravity : float
        Acceleration of gravity [m/s^2].
    """

    disk: FlatDisk
    heights: np.ndarray
    modes: FreeModes = NO_MODES
    gravity: float = GRAVITY


def simulate_flat(case, start, duration, step, every, last=0.0):
    """Return the FlatMotion of a disk on a rim profile.

    Parameters
    ----------
    case : FlatCase
        The disk and the profile.
    start : ndarray, (6,)
        Height, tilts and their rates.
    duration, step : float
        Length and time step [s].
    every : int
        Steps between two samples.
    last : float
        Inclination [rad] at which the motion ends.
    """
    steps = round(duration / step)
    rows = steps // every + 1
    out = np.zeros((rows, 7))
    done = run_flat(case, start, steps, step, every, last, out)
    return FlatMotion(out[:done, 0], out[:done, 1:])


@kernel
def drift(y, q, turn, g, h):
    """Advance free flight, exact for the rigid disk and for its modes, by a time h."""
    y[0] += h * y[3] - 0.5 * g * h * h
    y[1] += h * y[4]
    y[2] += h * y[5]
    y[3] -= g * h
    for j in range(q.shape[0]):
        for a in (0, 1):
            place = q[j, a]
            speed = q[j, a + 2]
            q[j, a] = turn[j, 0] * place + turn[j, 1] * speed
            q[j, a + 2] = turn[j, 2] * place + turn[j, 3] * speed


@outermost
def run_flat(case, start, steps, step, every, last, out):
    """Advance the disk, write every so-manyth state to `out`, and return their number.

    A step is half a flight, the impulse of the contacts, and half a flight.
    """
    disk, heights, modes, g = case
    count = heights.size
    cell = 2 * pi / count
    top = heights.max()
    k = modes.order.size
    y = start.copy()
    q = np.zeros((k, 4))
    turn = np.zeros((k, 4))
    for j in range(k):
        d = modes.decay[j]
        w = sqrt(modes.frequency[j] ** 2 - d * d)
        h = step / 2
        c = np.cos(w * h)
        s = np.sin(w * h)
        fade = np.exp(-d * h)
        turn[j, 0] = fade * (c + d / w * s)
        turn[j, 1] = fade * s / w
        turn[j, 2] = -fade * s * (w * w + d * d) / w
        turn[j, 3] = fade * (c - d / w * s)
    cosine = np.cos(cell * np.arange(count))
    sine = np.sin(cell * np.arange(count))
    phase = np.zeros((k, count, 2))
    for j in range(k):
        for i in range(count):
            phase[j, i, 0] = modes.shape[j] * np.cos(modes.order[j] * cell * i)
            phase[j, i, 1] = modes.shape[j] * np.sin(modes.order[j] * cell * i)
    patch_mass = disk.mass / (1 + 1 / disk.gyration)
    pull = np.zeros((k, 2))
    rows = 0
    for n in range(steps + 1):
        drift(y, q, turn, g, step / 2)
        tilt = np.hypot(y[1], y[2])
        bend = 0.0
        for j in range(k):
            bend += modes.shape[j] * np.hypot(q[j, 0], q[j, 1])
        room = top + bend - y[0] + tilt
        total = 0.0
        torque_x = 0.0
        torque_y = 0.0
        pull[:] = 0.0
        if room > 0:
            beta = max(tilt / disk.radius, 1e-6)
            per_cell = (
                disk.modulus
                * (disk.radius * disk.fillet / beta) ** 0.25
                / sqrt(2 * disk.radius / beta)
                * cell
                * disk.radius
            )
            half = pi if room > 2 * tilt else 2 * np.arcsin(sqrt(room / (2 * tilt)))
            middle = np.arctan2(-y[2], -y[1])
            first = int(np.floor((middle - half) / cell)) - 1
            number = min(int(2 * half / cell) + 4, count)
            depth_sum = 0.0
            speed_sum = 0.0
            points = 0
            left = first
            for m in range(number + 1):
                i = (first + m) % count
                depth = 0.0
                if m < number:
                    depth = heights[i] - y[0] - y[1] * cosine[i] - y[2] * sine[i]
                    for j in range(k):
                        depth -= phase[j, i, 0] * q[j, 0] + phase[j, i, 1] * q[j, 1]
                if depth > 0:
                    if points == 0:
                        left = first + m
                    points += 1
                    speed = -y[3] - y[4] * cosine[i] - y[5] * sine[i]
                    for j in range(k):
                        speed -= phase[j, i, 0] * q[j, 2] + phase[j, i, 1] * q[j, 3]
                    depth_sum += depth
                    speed_sum += depth * speed
                elif points:
                    stiffness = per_cell * points
                    dashpot = 2 * disk.ratio * sqrt(patch_mass * stiffness)
                    speed = speed_sum / depth_sum
                    push = max(per_cell * depth_sum + dashpot * speed, 0.0)
                    total += push
                    for l in range(left, left + points):
                        i = l % count
                        depth = heights[i] - y[0] - y[1] * cosine[i] - y[2] * sine[i]
                        for j in range(k):
                            depth -= phase[j, i, 0] * q[j, 0] + phase[j, i, 1] * q[j, 1]
                        share = push * depth / depth_sum
                        torque_x += share * cosine[i]
                        torque_y += share * sine[i]
                        for j in range(k):
                            pull[j, 0] += share * phase[j, i, 0]
                            pull[j, 1] += share * phase[j, i, 1]
                    depth_sum = 0.0
                    speed_sum = 0.0
                    points = 0
        if n % every == 0:
            out[rows, 0] = n * step
            out[rows, 1:7] = y
            out[rows, 4] += step * total / (2 * disk.mass)
            out[rows, 5] += step * torque_x / (2 * disk.gyration * disk.mass)
            out[rows, 6] += step * torque_y / (2 * disk.gyration * disk.mass)
            rows += 1
            if tilt < last * disk.radius:
                break
        y[3] += step * total / disk.mass
        y[4] += step * torque_x / (disk.gyration * disk.mass)
        y[5] += step * torque_y / (disk.gyration * disk.mass)
        for j in range(k):
            q[j, 2] += step * pull[j, 0]
            q[j, 3] += step * pull[j, 1]
        drift(y, q, turn, g, step / 2)
    return rows
