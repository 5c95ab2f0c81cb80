"""FORCE + MODES -> SOUND: the pressure at the listener, as separate causes that add up to it."""

from math import ceil

import numpy as np

from sonify.sound.audible_modes import ring_down, sounding
from sonify.sound.drive import listener_azimuth, modal_drive, rigid_sources
from sonify.sound.force import ForceSampler
from sonify.sound.pressure import Sound, kept, with_sum
from sonify.sound.radiation import Listener
from sonify.sound.radiators import ElasticFace, RigidFace
from sonify.sound.response import Carried, Driven, Vibrating

BLOCK = 1 << 16
"""Samples computed at once; the samples depend on it by rounding only."""
FADE_IN, FADE_OUT = 0.02, 0.05
"""Raised cosines [s] at the ends: what held the disk before the release is not modelled, nor what follows the last
sample, nor how a rigid disk comes to rest from a motion that breaks off."""
FADE_FALL = 0.005
"""What drives the modes goes to its mean over the last of this time [s] of a motion that breaks off: a fall ends with
many times the weight within microseconds, with which the impact begins that is left out."""
ENERGY_WINDOW = 0.002
"""The energy of the modes is noted so often [s]: a swing of the lowest of them."""
RIGID, DIRECTION, MODAL = slice(0, 2), slice(2, 4), slice(4, None)
"""The channels of the sampler: heave and tilt, cosine and sine of the listener's azimuth, the force on each mode."""


class Renderer:
    """Turns a motion and the modes of its disk into blocks of pressure at the listener [Pa], one column per stem.

    The force drives the modes, or the motion carries them, if it is Vibrating: see `response`. Of the modes those
    of the indices `wanted` sound, all if None, but none at or above half the sample rate. `calm` is that of the
    ForceSampler. The clock of the samples is the listener's: the source is heard distance / c later. However the motion
    ends, its modes ring out. Nothing but the sampler's count of readings changes by use. tests/test_sound.py.
    """

    def __init__(self, scene, motion, modes, wanted=None, calm: float = 0.0):
        self.scene, self.motion, self.sample_rate = scene, motion, scene.audio.sample_rate
        self.listener = Listener(distance=scene.audio.distance, elevation=np.radians(scene.audio.elevation_deg))
        self.chosen = sounding(modes, self.sample_rate, wanted)
        self.modes = modes.select(self.chosen)
        self._rigid = RigidFace(scene.disk, self.listener, 1 / self.sample_rate)
        self._elastic = ElasticFace(self.modes, self.listener, self.sample_rate, self._rigid.reach)
        self._drive = modal_drive(self.modes, scene)
        start = self._rigid.reach / self.sample_rate - self.listener.delay
        ends = np.array([[0.0, FADE_OUT]] * 2 + [[np.nan, 0.0]] * 2 + [[np.nan, FADE_FALL]] * len(self.modes))
        self.sampler = ForceSampler(motion, self.sample_rate, start, self._channels, ends[:, 0], calm, ends[:, 1])
        self.source_end = self.sampler.end + self.listener.delay
        ringing = max(ring_down(self.modes, scene), 2 * FADE_OUT)
        self.samples = ceil((self.source_end + ringing) * self.sample_rate)

    def blocks(self, size: int = BLOCK, note=lambda t, energy: None):
        """Yield (k, 4) [Pa]: the STEMS at the next k <= size samples, from the first to the last; every call anew.

        `note(t (e,) [s], energy (e,) [J])` is called with the energy of the modes, in the time of the motion.
        """
        first = self.sampler.block(0, 1).samples[0]
        rigid, elastic = self._rigid.from_rest(first[RIGID]), self._elastic.from_rest(first[DIRECTION])
        response = self._response(first[MODAL])
        for n in range(0, self.samples, size):
            force = self.sampler.block(n, min(size, self.samples - n))
            heard = rigid(force.channels(RIGID))
            ringing = response.advance(force.channels(MODAL))
            note(*self._energy(force.t, ringing.sum(axis=0)))
            yield self._enveloped(np.hstack([heard, elastic(ringing, force.samples[:-1, DIRECTION])]), n)

    def sound(self, watch=lambda share: None) -> Sound:
        """Return the whole sound; `watch(share)` is called with the share done."""
        noted = []

        def rows():
            for i, stems in enumerate(self.blocks(note=lambda *energy: noted.append(energy))):
                watch(min((i + 1) * BLOCK / self.samples, 1.0))
                yield with_sum(stems)

        columns = kept(rows(), self.samples)
        time, energy = (np.concatenate(parts) for parts in zip(*noted, strict=True))
        return Sound(
            name=self.scene.name,
            sample_rate=self.sample_rate,
            columns=columns,
            modes_heard=len(self.modes),
            source_end=self.source_end,
            energy_time=time,
            energy=energy,
        )

    def _channels(self, force, attitude):
        azimuth = listener_azimuth(attitude, turning_with_body=self.scene.support.kind == "free")
        rigid = rigid_sources(force, attitude, self.scene.disk)
        return np.column_stack([rigid, np.cos(azimuth), np.sin(azimuth), self._drive(force, attitude)])

    def _response(self, settled):
        if isinstance(self.motion, Vibrating):
            return Carried(self.modes, self.motion, self.chosen)
        return Driven(self.modes, self.sample_rate, settled)

    def _energy(self, t, acceleration):
        """The greatest energy of the modes in each ENERGY_WINDOW: q''^2/(2 w^2) at the turn of a swing, mass 1."""
        energy = np.square(acceleration / (2 * np.pi * self.modes.frequency)).sum(axis=1) / 2
        starts = np.arange(0, len(energy), max(int(ENERGY_WINDOW * self.sample_rate), 1))
        return t[starts], np.maximum.reduceat(energy, starts)

    def _enveloped(self, stems, first):
        """The stems (k, 4) of the samples from `first` on, under the raised cosines at both ends."""
        edges = FADE_IN * self.sample_rate, self.samples - FADE_OUT * self.sample_rate
        if edges[0] < first and first + len(stems) < edges[1]:
            return stems
        n = first + np.arange(len(stems)) + 0.5
        rise = np.clip(n / edges[0], 0, 1)
        fall = np.clip((self.samples - n) / (self.samples - edges[1]), 0, 1)
        return stems * (np.sin(np.pi / 2 * rise) ** 2 * np.sin(np.pi / 2 * fall) ** 2)[:, None]
