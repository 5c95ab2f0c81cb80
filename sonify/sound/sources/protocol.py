"""SOURCES: objects that turn the contact force into stems of pressure, block by block."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from dynamics import Outcome
from sonify.sound.audible_modes import RingDown, ring_down
from sonify.sound.modal_forcing import listener_azimuth, modal_drive, rigid_sources
from sonify.sound.radiation import Listener
from sonify.sound.radiators import ElasticFace, RigidFace
from sonify.sound.response import CarriedModes, DrivenModes, VibrationPart

FADE_IN = 0.02  # s
"""Raised cosine at the start of a sound, because the support before the release is not modelled."""
FADE_OUT = 0.05  # s
"""Raised cosine at the end of a sound, and the fade of a rigid disk after a motion that breaks
off."""
DRIVE_FADE = 0.005  # s
"""Fade of the modal forces to their mean at the end of a motion that breaks off.

A fall ends with a force of many times the weight within microseconds: the start of an impact that
is not modelled. """

Advance = Callable[[Any], np.ndarray]
"""Function from a ContactForce of a source's channels to its stems (k, s) [Pa]."""


class Source(ABC):
    """One or more causes of sound; each cause is a stem.

    Attributes
    ----------
    names : tuple of str
        Names of the stems.
    channel_ends : ndarray, shape (c, 2)
        Value at rest and fade time [s] of each channel, as the ForceSampler takes them.
    tail_duration : float
        Time [s] for which the source sounds after the motion.
    latency : int
        Samples by which the pressure lags behind the force.
    """

    names: Any
    channel_ends: Any
    tail_duration: Any
    latency: Any

    @abstractmethod
    def channels(self, force: np.ndarray, state: np.ndarray) -> np.ndarray:
        """Return the input channels (k, c) for forces (k, 3) [N] and states (k, 11)."""

    @abstractmethod
    def start_rendering(self, first: np.ndarray, note) -> Advance:
        """Return advance(ContactForce) -> stems (k, s) [Pa], to be called once per block.

        Before the first block the channels had the values `first` (c,). The source may report the
        energy of its modes by `note(t (e,) [s], energy (e,) [J])`."""

    def with_second_ear(self, other: "Source", turn: float) -> "Source":
        """Return a source with one more column: the sum of its stems at a second ear, `turn` [rad]
        further round.

        `other` is the same source for a listener at that ear.
        """
        return SourcePair(self, other)


class RigidDisk(Source):
    """The disk as a rigid body: it heaves, and it tilts."""

    names = ("heave", "tilt")
    tail_duration = 2 * FADE_OUT

    def __init__(
        self, scene, face: RigidFace, azimuth: float = 0.0, second_ear: float | None = None
    ):
        self._scene = scene
        self._disk = scene.disk
        self._face = face
        self._azimuth = azimuth
        self._second_ear = second_ear
        self.latency = face.reach

    def with_second_ear(self, other, turn):
        """Return the rigid disk with the pressure at a second ear, `turn` [rad] further round, as
        one more column."""
        return RigidDisk(self._scene, self._face, self._azimuth, turn)

    @property
    def channel_ends(self):
        """Every channel fades to zero."""
        return np.array([[0.0, FADE_OUT]] * (2 if self._second_ear is None else 3))

    def channels(self, force, state):
        """Return the heave and the tilt towards each ear, (k, 2 or 3) [m/s^2]."""
        ears = [self._azimuth]
        if self._second_ear is not None:
            ears.append(self._azimuth + self._second_ear)
        return rigid_sources(force, state, self._disk, *ears)

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks after accelerations `first` (2 or 3,)."""
        radiate = self._face.start_radiating(first)

        def advance(force):
            pressure = radiate(force.samples, force.knots, force.jump)
            pressure[:, 2:] += pressure[:, :1]  # the second ear hears the same heave
            return pressure

        return advance


class ElasticDisk(Source):
    """The elastic modes of the disk: driven by the smooth force and by its jumps, or part of a
    Vibrating motion."""

    names = ("ringing_smooth", "ringing_jumps")

    def __init__(
        self,
        scene,
        motion,
        modes,
        chosen,
        listener: Listener,
        latency: int,
        second_ear: float | None = None,
    ):
        self._scene = scene
        self._motion = motion
        self._modes = modes
        self._chosen = chosen
        self._listener = listener
        self._second_ear = second_ear
        self._face = ElasticFace(modes, listener, scene.audio.sample_rate, latency)
        self._forcing = modal_drive(modes, scene)
        # Where the contact is lost the force reaches zero by itself, and stays zero.
        contact_lost = motion.outcome in (Outcome.AIRBORNE, Outcome.LIFTED_OFF)
        forcing_end = [0.0, 0.0] if contact_lost else [np.nan, DRIVE_FADE]
        self.channel_ends = np.array([[np.nan, 0.0]] * 2 + [forcing_end] * len(modes))
        self.latency = latency

    def with_second_ear(self, other, turn):
        """Return the modes with the pressure at a second ear, `turn` [rad] further round, as one
        more column."""
        return type(self)(
            self._scene,
            self._motion,
            self._modes,
            self._chosen,
            self._listener,
            self.latency,
            second_ear=turn,
        )

    @cached_property
    def ringing(self) -> RingDown:
        """Frequencies and decay rates of the modes after the end of the motion."""
        rate = self._modes.decay_rate
        return RingDown(frequency=self._modes.frequency, decay_rate=rate, without_film=rate)

    @cached_property
    def tail_duration(self) -> float:
        """Time [s] from the end of the motion to inaudible modes, plus the final fade."""
        return ring_down(self._modes, self._scene, self.ringing.decay_rate) + FADE_OUT

    def channels(self, force, state):
        """Return cosine and sine of the listener's azimuth, and modal forces: (k, 2 + m)."""
        turning_with_body = self._scene.support.kind == "free"
        azimuth = self._listener.azimuth + listener_azimuth(
            state, turning_with_body=turning_with_body
        )
        return np.column_stack([np.cos(azimuth), np.sin(azimuth), self._forcing(force, state)])

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks after `first` (2 + m,); it notes the energy
        of the modes."""
        radiate = self._face.start_radiating(first[:2], self._second_ear)
        response = self._response(first[2:])

        def advance(force):
            ringing = response.advance(force.channels(slice(2, None)))
            note(
                *energy_peaks(
                    force.t, ringing.sum(axis=0), self._modes, self._scene.audio.sample_rate
                )
            )
            return radiate(ringing, force.channels(slice(2)).samples[:-1])

        return advance

    def _response(self, settled):
        if isinstance(self._motion, VibrationPart):
            return CarriedModes(self._motion, self._chosen, self.ringing)
        return DrivenModes(self._modes, self._scene.audio.sample_rate, settled)


class SourcePair(Source):
    """A source at one ear and at a second ear; the stems of the second are summed into one more
    column."""

    def __init__(self, source: Source, other: Source):
        self._pair = (source, other)
        count = len(source.channel_ends)
        self._parts = (slice(count), slice(count, None))
        self.names = source.names
        self.tail_duration = source.tail_duration
        self.latency = source.latency
        self.channel_ends = np.vstack([source.channel_ends, other.channel_ends])

    def channels(self, force, state):
        """Return the input channels of the first ear, then those of the second."""
        return np.hstack([source.channels(force, state) for source in self._pair])

    def start_rendering(self, first, note):
        """Return the function that renders the blocks after `first`; only the first source notes
        its energy."""
        notes = (note, lambda t, energy: None)
        own, other = (
            source.start_rendering(first[part], report)
            for source, part, report in zip(self._pair, self._parts, notes, strict=True)
        )

        def advance(force):
            second = other(force.channels(self._parts[1])).sum(axis=1, keepdims=True)
            return np.hstack([own(force.channels(self._parts[0])), second])

        return advance


def delay_output(advance: Advance, samples: int) -> Advance:
    """Return `advance` with its output delayed by a number of samples; silence comes first."""
    held = None

    def delayed(force):
        nonlocal held
        out = advance(force)
        out = np.vstack([np.zeros((samples, out.shape[1])) if held is None else held, out])
        out, held = np.split(out, [len(out) - samples])
        return out

    return delayed if samples else advance


def energy_peaks(t, acceleration, modes, sample_rate, window=0.002):
    """Return times (e,) [s] and the greatest energy (e,) [J] of the modes in each window [s].

    The energy of an oscillator of modal mass 1 at a turning point is q''^2/(2 w^2). The window is
    one period of the lowest modes."""
    energy = np.square(acceleration) @ ((2 * np.pi * modes.frequency) ** -2.0 / 2)
    starts = np.arange(0, len(energy), max(int(window * sample_rate), 1))
    return t[starts], np.maximum.reduceat(energy, starts)
