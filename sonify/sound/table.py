"""FORCE -> TABLE -> PRESSURE: the table under the moving contact, as modes in a baffle."""

from math import ceil

import numpy as np
from numpy.lib.stride_tricks import as_strided

from modal.table import SurfaceModes
from sonify.hearing.loudness import a_weighting_db
from sonify.sound.audible_modes import LONGEST, RING_DOWN_DB
from sonify.sound.oscillators import Knots, OscillatorBank
from sonify.sound.radiation import Listener, listeners_of
from sonify.sound.sources import FADE_FALL, FADE_OUT, noted_energy

TAPER = 0.84
"""The share of half the sample rate up to which the kernels are exact; from there they fall to nothing."""
MARGIN = 12
"""Samples before the first and after the last arrival over which the kernels, so limited, ring out."""
TOGETHER = 4096
"""Samples that are radiated at once: few enough for the cache."""


def contact_place(state, disk) -> np.ndarray:
    """Return where the contact is, (k, 2) [m], from the place of the disk's centre at the release; states (k, 11).

    The contact lies R cos beta - H sin beta beyond the centre along a_2, a quarter turn ahead of the precession.
    """
    reach = disk.radius * np.cos(state[:, 1]) - disk.thickness / 2 * np.sin(state[:, 1])
    ahead = state[:, 0] + np.pi / 2
    return state[:, 3:5] + reach[:, None] * np.column_stack([np.cos(ahead), np.sin(ahead)])


def shapes_under(modes: SurfaceModes, state, scene) -> np.ndarray:
    """Return w (k, m) [kg^-1/2] of every mode of the table where the contact is, in states (k, 11)."""
    if scene.surface.kind == "modes":  # known on the contact circle, which goes with the disk
        ahead = state[:, 0] + np.pi / 2
        return modes.at(scene.disk.radius * np.cos(ahead), scene.disk.radius * np.sin(ahead))
    return modes.at(*(modes.place + contact_place(state, scene.disk)).T)


class ElasticTable:
    """A table whose modes the contact force drives where it is, and which radiates upwards from all of its top face.

    The part under the disk radiates like the rest: what the disk hides of it is left in. The friction on the table is
    left out: it bends a plate by its thickness over the length of a wave less than the normal force does.
    """

    names = ("table",)

    def __init__(self, scene, modes: SurfaceModes, listener: Listener):
        self._scene, self._modes, self._rate = scene, modes, scene.audio.sample_rate
        self.late = reach_of(modes, listener, self._rate)
        self._kernels = kernels(modes, listener, self._rate, self.late)
        self.ends = np.tile([np.nan, FADE_FALL], (len(modes), 1))
        slowest = modes.decay_rate.min(initial=np.inf)
        self.lasting = max(2 * FADE_OUT, min(np.log(10) / 20 * RING_DOWN_DB / max(slowest, 1e-9), LONGEST))

    def channels(self, force, state):
        """Return the force on each mode, (k, m) [N kg^-1/2]: the normal force, downwards, on its shape."""
        return -force[:, 2:] * shapes_under(self._modes, state, self._scene)

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on the forces `first` (m,) that have long been there."""
        bank = OscillatorBank(self._modes.frequency, self._modes.decay_rate, self._rate)
        bank.settle(first)
        past = len(self._kernels) - 1
        moved = np.zeros((past, len(self._modes)))

        def advance(force):
            nonlocal moved
            count = len(force.t) - 1
            if len(moved) < past + count:  # memory that is fresh for every block would take longer than the steps
                moved = np.vstack([moved[:past], np.empty((count, len(self._modes)))])
            knots = Knots(*force.knots, force.jump, force.bend)
            new = bank.advance(force.samples, knots, out=moved[past : past + count])
            note(*noted_energy(force.t, new, self._modes, self._rate))
            pressure = radiated(moved[: past + count], self._kernels)[:, None]
            moved[:past] = moved[count : past + count].copy()
            return pressure

        return advance


def reach_of(modes: SurfaceModes, listener: Listener, sample_rate: float) -> int:
    """Return how many samples before the way from the disk the first sound of the table arrives, and the MARGIN."""
    way = np.linalg.norm(listener.position - _rows(modes), axis=1)
    return ceil((listener.distance - way.min()) / listener.air.sound_speed * sample_rate) + MARGIN


def kernels(modes: SurfaceModes, listener: Listener, sample_rate: float, reach: int) -> np.ndarray:
    """Return kernels (j, m): the pressure [Pa] at sample n is the sum of kernels[i] times the accelerations at n - i.

    Rayleigh's integral over the top face at every frequency up to TAPER of half the sample rate, `reach` samples late.
    """
    points = _rows(modes)
    last = (np.linalg.norm(listener.position - points, axis=1).max() - listener.distance) / listener.air.sound_speed
    count = reach + ceil(last * sample_rate) + MARGIN
    size = 2 << (2 * count).bit_length()
    frequency = np.fft.rfftfreq(size, 1 / sample_rate)
    taper = np.cos(np.pi / 2 * np.clip((2 * frequency / sample_rate - TAPER) / (1 - TAPER), 0, 1)) ** 2
    spectrum = radiation(modes, listener, frequency)
    late = np.exp(-2j * np.pi * frequency / sample_rate * reach)
    return np.fft.irfft(spectrum * (taper * late)[:, None], size, axis=0)[:count]


def radiation(modes: SurfaceModes, listener: Listener, frequency) -> np.ndarray:
    """Return Rayleigh's integral (f, m) [Pa] of the top face per unit modal acceleration at frequencies (f,) [Hz].

    The factor exp(-i k distance) is taken out. Exact for a plane baffle, above coincidence and below.
    """
    way = np.linalg.norm(listener.position - _rows(modes), axis=1)
    late = (way - listener.distance) / listener.air.sound_speed
    share = listener.air.density / (2 * np.pi) * modes.weights / way
    return np.array([(share * np.exp(-2j * np.pi * f * late)) @ modes.face.T for f in frequency])


def radiated(moved, kernels) -> np.ndarray:
    """Return the pressure (k,) of accelerations (j - 1 + k, m), the first j - 1 of them past; kernels (j, m)."""
    count, backwards = len(kernels), np.ascontiguousarray(kernels[::-1].T)
    out = np.empty(len(moved) - count + 1)
    for n in range(0, len(out), TOGETHER):
        parts = moved[n : n + TOGETHER + count - 1] @ backwards
        size, step = len(parts) - count + 1, parts.itemsize
        out[n : n + size] = as_strided(parts, (size, count), (count * step, (count + 1) * step)).sum(axis=1)
    return out


def _rows(modes):
    """The points of the top face in space, (p, 3) [m], from where the disk is at the release."""
    return np.column_stack([modes.points - modes.place, np.zeros(len(modes.points))])


def after_a_newton(modes: SurfaceModes, scene) -> tuple[np.ndarray, np.ndarray]:
    """Return what a jump of 1 N leaves in the modes: loudness (m,) [Pa^2 s] where it is loudest and energy (m,) [J].

    See `audible_modes.after_a_jump`; the shape is its root mean square over the circle that the disk covers.
    """
    r, angle = (
        part.ravel() for part in np.meshgrid(scene.disk.radius * np.arange(1, 9) / 8, np.arange(64) * np.pi / 32)
    )
    points = modes.place[:, None] + r * np.array([np.cos(angle), np.sin(angle)])
    g2 = r @ modes.at(*points) ** 2 / r.sum()
    heard = np.zeros(len(modes))
    for ear in listeners_of(scene):
        each = [radiation(modes.select([i]), ear, [f])[0, 0] for i, f in enumerate(modes.frequency)]
        heard = np.maximum(heard, np.abs(each))
    weight = 10 ** (a_weighting_db(modes.frequency) / 10)
    decay = np.maximum(modes.decay_rate, 1 / LONGEST)
    return weight * g2 * heard**2 / (4 * decay), g2 / (2 * (2 * np.pi * modes.frequency) ** 2)
