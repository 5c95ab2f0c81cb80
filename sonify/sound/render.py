"""FORCE + MODES -> SOUND: the pressure at the listener, as separate causes that add up to it."""

from dataclasses import dataclass
from math import ceil
from pathlib import Path

import numpy as np
from numba import njit

from sonify.sound.audible_modes import ring_down, voices
from sonify.sound.drive import listener_azimuth, modal_drive, rigid_sources
from sonify.sound.force import ForceSampler
from sonify.sound.oscillators import Knots, OscillatorBank
from sonify.sound.radiation import AZIMUTHS, Listener, heave_kernel, piston_strength, taps, tilt_kernel

STEMS = ("heave", "tilt", "ringing_smooth", "ringing_jumps")
"""The disk moves up and down as a whole; it tilts; its modes follow the smooth force; they ring after its jumps."""
BLOCK = 1 << 16
"""Samples computed at once; the samples depend on it by rounding only."""
FADE_IN, FADE_OUT = 0.02, 0.05
"""Raised cosines [s] at the ends: what held the disk before the release is not modelled, nor what follows the file."""
ENERGY_WINDOW = 0.002
"""The energy of the modes is noted so often [s]: a swing of the lowest of them."""


@dataclass(frozen=True, kw_only=True)
class Sound:
    """What was written: files, `samples` at `sample_rate`, the `peak` [Pa] and the `full_scale` [Pa] of 1.0 in
    sound.wav.

    pressure.wav and the stems hold pascal. `stem_peak` [Pa] by name; `modes_heard` is the number of modes below half
    the sample rate; `source_end` [s] is when the end of the motion reaches the listener. `energy` (e,) [J] is that of
    the modes at `energy_time` (e,) [s], in the time of the motion.
    """

    sample_rate: int
    samples: int
    peak: float
    full_scale: float
    finite: bool
    stem_peak: dict[str, float]
    modes_heard: int
    source_end: float
    energy_time: np.ndarray
    energy: np.ndarray
    folder: Path

    @property
    def gain_db(self) -> float:
        """Gain from pascal in pressure.wav to sound.wav [dB]."""
        return -20 * np.log10(self.full_scale)

    @property
    def duration(self) -> float:
        """Length of the files [s]."""
        return self.samples / self.sample_rate


class Renderer:
    """Turns a motion and the modes of its disk into blocks of pressure at the listener [Pa], one column per stem.

    Of the modes those of the indices `wanted` sound, all if None, but none at or above half the sample rate. `calm` is
    that of the ForceSampler. The clock of the samples is the listener's: the source is heard distance / c later.
    tests/test_sound.py.
    """

    def __init__(self, scene, motion, modes, wanted=None, calm: float = 0.0):
        self.scene, self.sample_rate, self.h = scene, scene.audio.sample_rate, 1 / scene.audio.sample_rate
        self.listener = Listener(distance=scene.audio.distance, elevation=np.radians(scene.audio.elevation_deg))
        self.modes = voices(modes, self.sample_rate, wanted)
        self.energy_time, self.energy = [], []
        self._prepare_rigid(scene.disk)
        self._drive = modal_drive(self.modes, scene)
        start = self.reach * self.h - self.listener.delay
        rest = [0.0, 0.0] + [np.nan] * (2 + len(self.modes.frequency))
        self.sampler = ForceSampler(motion, self.sample_rate, start, self._channels, rest, calm)
        self._prepare_modes(self.sampler.block(0, 1))
        self.source_end = self.sampler.end + self.listener.delay
        ringing = max(ring_down(self.modes, scene), 2 * FADE_OUT) if motion.outcome.name == "SETTLED" else 0.0
        self.samples = ceil((self.source_end + ringing) * self.sample_rate)

    def blocks(self, size: int = BLOCK):
        """Yield (k, 4) [Pa]: the STEMS at the next k <= size samples, from the first to the last."""
        for first in range(0, self.samples, size):
            count = min(size, self.samples - first)
            force = self.sampler.block(first, count)
            stems = np.hstack([self._rigid(force), self._ringing(force)])
            yield self._enveloped(stems, first)

    def _channels(self, force, attitude):
        """Heave, tilt, the direction of the listener as cosine and sine, and the force on each mode, (k, 4 + m)."""
        azimuth = listener_azimuth(attitude, turning_with_body=self.scene.support.kind == "free")
        rigid = rigid_sources(force, attitude, self.scene.disk)
        return np.column_stack([rigid, np.cos(azimuth), np.sin(azimuth), self._drive(force, attitude)])

    def _prepare_rigid(self, disk):
        face = disk.radius, self.h, disk.inner_radius
        kernels = [kernel(self.listener, *face) for kernel in (heave_kernel, tilt_kernel)]
        self._steps, self._taps = zip(*kernels, strict=True)
        self.reach = len(self._taps[0]) // 2
        self._strength = piston_strength(disk.radius, self.listener.distance)
        self._late = np.zeros((0, 2))

    def _prepare_modes(self, force):
        m = len(self.modes.frequency)
        self._table = taps(self.modes, self.listener, self.sample_rate)
        self._banks = [OscillatorBank(self.modes.frequency, self.modes.decay_rate, self.sample_rate) for _ in range(2)]
        self._banks[0].settle(force.samples[0, 4:])
        self._past = force.samples[[0] * 2 * self.reach, :2]
        self._past_direction = force.samples[[0] * self.reach, 2:4]
        self._past_ringing = np.zeros((2, self.reach + 1, m))

    def _rigid(self, force):
        """Heave and tilt (k, 2): samples through the kernels, plus what a jump between samples adds to that."""
        count, after = len(force.t) - 1, np.arange(2 * self.reach + 1)
        source = np.vstack([self._past, force.samples[:-1, :2]])
        self._past = source[count:]
        out = np.zeros((count + len(after), 2))
        out[:count] = np.column_stack([np.convolve(source[:, i], self._taps[i], "valid") for i in (0, 1)])
        out[: len(self._late)] += self._late
        interval, _, until = force.knots
        for i in (0, 1):
            sharp = self._steps[i](until[:, None] + (after - self.reach) * self.h) - np.cumsum(self._taps[i])
            np.add.at(out[:, i], interval[:, None] + 1 + after, force.jump[:, [i]] * sharp)
        self._late = out[count:]
        return self._strength * out[:count]

    def _ringing(self, force):
        """The modes (k, 2): driven by the smooth part of the force, and by its jumps."""
        smooth, steps, jump, bend = (part[:, 4:] for part in (force.smooth, force.steps, force.jump, force.bend))
        ringing = [
            self._banks[0].advance(smooth, Knots(*force.knots, 0 * bend, bend)),
            self._banks[1].advance(steps, Knots(*force.knots, jump, 0 * bend)),
        ]
        self._note_energy(force.t, ringing[0] + ringing[1])
        return self._radiate(np.array(ringing), force.samples[:-1, 2:4])

    def _note_energy(self, t, acceleration):
        """Keep the greatest energy of the modes in each ENERGY_WINDOW: q''^2/(2 w^2) at the turn of a swing, mass 1."""
        energy = np.square(acceleration / (2 * np.pi * self.modes.frequency)).sum(axis=1) / 2
        starts = np.arange(0, len(energy), max(int(ENERGY_WINDOW * self.sample_rate), 1))
        self.energy_time.append(t[starts])
        self.energy.append(np.maximum.reduceat(energy, starts))

    def _radiate(self, ringing, direction):
        count = len(direction)
        ringing = np.concatenate([self._past_ringing, ringing], axis=1)
        direction = np.concatenate([self._past_direction, direction])
        self._past_ringing, self._past_direction = ringing[:, count:], direction[count:]
        cosine, sine = direction[:count].T
        where = np.arctan2(sine, cosine) / (2 * np.pi) % 1.0 * AZIMUTHS
        return _three_taps(
            ringing, where, np.minimum(np.hypot(cosine, sine), 1.0), self._table, self._table.mean(axis=0)
        )

    def _enveloped(self, stems, first):
        """The stems (k, 4) of the samples from `first` on, under the raised cosines at both ends of the file."""
        edges = FADE_IN * self.sample_rate, self.samples - FADE_OUT * self.sample_rate
        if edges[0] < first and first + len(stems) < edges[1]:
            return stems
        n = first + np.arange(len(stems)) + 0.5
        rise = np.clip(n / edges[0], 0, 1)
        fall = np.clip((self.samples - n) / (self.samples - edges[1]), 0, 1)
        return stems * (np.sin(np.pi / 2 * rise) ** 2 * np.sin(np.pi / 2 * fall) ** 2)[:, None]


@njit(cache=True)
def _three_taps(ringing, where, sharpness, table, mean):
    """Sum over modes of three taps on samples n + 2, n + 1, n of ringing (s, k + reach + 1, m), at azimuths (k,).

    `sharpness` (k,) is 1 where the azimuth is well defined and falls to 0 where it turns too fast for the samples.
    """
    out = np.zeros((where.shape[0], ringing.shape[0]))
    for n in range(where.shape[0]):
        low = int(where[n])
        part = where[n] - low
        here, there = table[low % table.shape[0]], table[(low + 1) % table.shape[0]]
        for m in range(ringing.shape[2]):
            for k in range(3):
                tap = (1 - part) * here[m, k] + part * there[m, k]
                tap = mean[m, k] + sharpness[n] * (tap - mean[m, k])
                for s in range(ringing.shape[0]):
                    out[n, s] += tap * ringing[s, n + 2 - k, m]
    return out
