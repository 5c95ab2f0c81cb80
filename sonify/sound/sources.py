"""SOURCES: what turns the contact force into stems of pressure, block after block."""

from copy import copy
from functools import cached_property
from typing import Protocol

import numpy as np

from sonify.sound.audible_modes import ring_down
from sonify.sound.drive import listener_azimuth, modal_drive, rigid_sources
from sonify.sound.radiation import Listener
from sonify.sound.radiators import ElasticFace, RigidFace
from sonify.sound.response import Carried, Driven, Vibrating

FADE_IN, FADE_OUT = 0.02, 0.05
"""Raised cosines [s] at the ends: what held the disk before the release is not modelled, nor what follows the last
sample, nor how a rigid disk comes to rest from a motion that breaks off."""
FADE_FALL = 0.005
"""What drives the modes goes to its mean over the last of this time [s] of a motion that breaks off: a fall ends with
many times the weight within microseconds, with which the impact begins that is left out."""
ENERGY_WINDOW = 0.002
"""The energy of the modes is noted so often [s]: a swing of the lowest of them."""


class Source(Protocol):
    """A cause of sound, or several, each a stem of its `names`.

    It asks the ForceSampler for channels, whose rest and fade are `ends` (c, 2); it is heard for `lasting` [s] after
    the motion. What it returns it radiates `late` samples after the force that it was given.
    """

    names: tuple[str, ...]
    ends: np.ndarray
    lasting: float
    late: int

    def channels(self, force: np.ndarray, state: np.ndarray) -> np.ndarray:
        """Return what drives the source, (k, c), of contact forces (k, 3) [N] and states (k, 11) of the motion."""
        ...

    def from_rest(self, first: np.ndarray, note):
        """Return advance(ContactForce of these channels) -> stems (k, s) [Pa] of the blocks that follow on channels
        `first` (c,); `note(t (e,) [s], energy (e,) [J])` may be told the energy that it holds."""
        ...


class RigidDisk:
    """The disk moves up and down as a whole, and it tilts."""

    names = ("heave", "tilt")
    lasting = 2 * FADE_OUT
    beside: float | None = None

    def __init__(self, scene, face: RigidFace, azimuth: float = 0.0):
        self._disk, self._face, self.late = scene.disk, face, face.reach
        self._azimuth = azimuth

    @property
    def ends(self):
        """All that sounds fades."""
        return np.array([[0.0, FADE_OUT]] * (2 if self.beside is None else 3))

    def channels(self, force, state):
        """Return the heave and the tilt towards the listener, and also towards the other ear, (k, 2 or 3) [m/s^2]."""
        ears = [self._azimuth] if self.beside is None else [self._azimuth, self._azimuth + self.beside]
        return rigid_sources(force, state, self._disk, *ears)

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on accelerations `first` (2 or 3,)."""
        radiate = self._face.from_rest(first)

        def advance(force):
            heard = radiate(force.samples, force.knots, force.jump)
            heard[:, 2:] += heard[:, :1]  # the other ear hears the same heave
            return heard

        return advance


class ElasticDisk:
    """The modes follow the smooth force, and ring after its jumps; or the motion carries them, if it is Vibrating."""

    names = ("ringing_smooth", "ringing_jumps")
    beside: float | None = None

    def __init__(self, scene, motion, modes, chosen, listener: Listener, reach: int):
        self._scene, self._motion, self._modes, self._chosen = scene, motion, modes, chosen
        self._azimuth = listener.azimuth
        self._face = ElasticFace(modes, listener, scene.audio.sample_rate, reach)
        self._drive = modal_drive(modes, scene)
        self.ends = np.array([[np.nan, 0.0]] * 2 + [[np.nan, FADE_FALL]] * len(modes))
        self.late = reach

    @cached_property
    def lasting(self) -> float:
        """For how long [s] the modes are still heard."""
        return ring_down(self._modes, self._scene)

    def channels(self, force, state):
        """Return cosine and sine of the listener's azimuth, and the force on each mode: (k, 2 + m)."""
        azimuth = self._azimuth + listener_azimuth(state, turning_with_body=self._scene.support.kind == "free")
        return np.column_stack([np.cos(azimuth), np.sin(azimuth), self._drive(force, state)])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on `first` (2 + m,), and notes the energy of the modes."""
        radiated, response = self._face.from_rest(first[:2], self.beside), self._response(first[2:])

        def advance(force):
            ringing = response.advance(force.channels(slice(2, None)))
            note(*noted_energy(force.t, ringing.sum(axis=0), self._modes, self._scene.audio.sample_rate))
            return radiated(ringing, force.channels(slice(2)).samples[:-1])

        return advance

    def _response(self, settled):
        if isinstance(self._motion, Vibrating):
            return Carried(self._modes, self._motion, self._chosen)
        return Driven(self._modes, self._scene.audio.sample_rate, settled)


class Both:
    """A source, and what the `other` ear hears of it: the sum of its stems there is one more column."""

    def __init__(self, source: Source, other: Source):
        self._each, self._count = (source, other), len(source.ends)
        self.names, self.lasting, self.late = source.names, source.lasting, source.late
        self.ends = np.vstack([source.ends, other.ends])

    def channels(self, force, state):
        """Return what drives the source for one ear and for the other."""
        return np.hstack([source.channels(force, state) for source in self._each])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on `first`; only one of the two notes its energy."""
        parts, notes = (slice(self._count), slice(self._count, None)), (note, lambda t, energy: None)
        own, other = (s.from_rest(first[part], n) for s, part, n in zip(self._each, parts, notes, strict=True))

        def advance(force):
            there = other(force.channels(parts[1])).sum(axis=1, keepdims=True)
            return np.hstack([own(force.channels(parts[0])), there])

        return advance


def at_both_ears(source: Source, other: Source, turn: float) -> Source:
    """Return a source with one more column: the sum of its stems for the `other` ear, `turn` [rad] further on."""
    if not hasattr(source, "beside"):
        return Both(source, other)
    both = copy(source)  # what takes longest, as the response of the modes, is the same
    both.beside = turn
    return both


def held_back(advance, samples: int):
    """Return an advance whose stems come so many samples later."""
    held = None

    def later(force):
        nonlocal held
        out = advance(force)
        out = np.vstack([np.zeros((samples, out.shape[1])) if held is None else held, out])
        out, held = np.split(out, [len(out) - samples])
        return out

    return later if samples else advance


def noted_energy(t, acceleration, modes, sample_rate):
    """The greatest energy of modes in each ENERGY_WINDOW: q''^2/(2 w^2) at the turn of a swing, modal mass 1."""
    energy = np.square(acceleration) @ ((2 * np.pi * modes.frequency) ** -2.0 / 2)
    starts = np.arange(0, len(energy), max(int(ENERGY_WINDOW * sample_rate), 1))
    return t[starts], np.maximum.reduceat(energy, starts)
