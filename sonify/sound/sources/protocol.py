"""Sound sources: objects that convert the contact force to sound-pressure signals,
block by block."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from dynamics import Outcome
from sonify.sound.audible_modes import RingDown, ring_down_time
from sonify.sound.modal_forcing import (
    heave_and_tilt_accelerations,
    listener_azimuth,
    modal_forcing_function,
)
from sonify.sound.radiation import Listener
from sonify.sound.radiators import ElasticFace, RigidFace
from sonify.sound.response import DrivenModes, SolvedModes, VibrationPart

FADE_IN = 0.02  # s
"""Length of the raised-cosine fade at the start of a sound; the support of the disk
before the release is not modelled."""
FADE_OUT = 0.05  # s
"""Length of the raised-cosine fade at the end of a sound, and of the fade of the rigid
disk after a motion that does not settle."""
MODAL_FORCE_FADE = 0.005  # s
"""Time over which the modal forces fade to their mean at the end of a motion that does
not settle.

A fall ends in an impact that is not modelled, with a force that grows to many times the
weight within microseconds."""

Advance = Callable[[Any], np.ndarray]
"""Function that converts a ContactForce of a source's channels to its stems (k, s)
[Pa]."""


class Source(ABC):
    """Sound source with one or more stems.

    Attributes
    ----------
    names : tuple of str
        Names of the stems.
    channel_ends : ndarray, shape (c, 2)
        Value at rest and fade time [s] of each channel, in the form required by
        ForceSampler.
    tail_duration : float
        Time [s] for which the source continues to sound after the motion.
    latency : int
        Samples by which the pressure lags behind the force.
    """

    names: Any
    channel_ends: Any
    tail_duration: Any
    latency: Any

    @abstractmethod
    def input_channels(self, force: np.ndarray, state: np.ndarray) -> np.ndarray:
        """Return the input channels (k, c) for forces (k, 3) [N] and states (k, 11)."""

    @abstractmethod
    def make_block_renderer(self, first: np.ndarray, note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks of
        a ContactForce.

        Before the first block the channels have the values `first` (c,). The source may
        report its modal energy by `note(t (e,) [s], energy (e,) [J])`."""

    def with_second_ear(self, other: "Source", turn: float) -> "Source":
        """Return a source with an additional column, the sum of its stems at a second
        ear.

        The second ear is rotated by `turn` [rad] around the disk; `other` is the same
        source for a listener there.
        """
        return SourcePair(self, other)


class RigidDisk(Source):
    """Heave and tilt of the disk as a rigid body."""

    names = ("heave", "tilt")
    tail_duration = 2 * FADE_OUT

    def __init__(
        self,
        scene,
        face: RigidFace,
        azimuth: float = 0.0,
        second_ear: float | None = None,
    ):
        self._scene = scene
        self._disk = scene.disk
        self._face = face
        self._azimuth = azimuth
        self._second_ear = second_ear
        self.latency = face.reach

    def with_second_ear(self, other, turn):
        """Return the source with an additional column for a second ear, rotated by
        `turn` [rad]."""
        return RigidDisk(self._scene, self._face, self._azimuth, turn)

    @property
    def channel_ends(self):
        """Rest values and fade times: every channel fades to zero."""
        return np.array([[0.0, FADE_OUT]] * (2 if self._second_ear is None else 3))

    def input_channels(self, force, state):
        """Return (k, 2 or 3) [m/s^2]: the heave and the tilt towards each ear."""
        ears = [self._azimuth]
        if self._second_ear is not None:
            ears.append(self._azimuth + self._second_ear)
        return heave_and_tilt_accelerations(force, state, self._disk, *ears)

    def make_block_renderer(self, first, note):
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the accelerations have the values `first` (c,)."""
        radiate = self._face.make_block_radiator(first)

        def advance(force):
            pressure = radiate(force.samples, force.knots, force.jump)
            pressure[:, 2:] += pressure[
                :, :1
            ]  # the heave is the same at the second ear
            return pressure

        return advance


class ElasticDisk(Source):
    """Elastic modes of the disk, driven by the contact force or solved together with
    the motion."""

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
        self._forcing = modal_forcing_function(modes, scene)
        # If the contact is lost, the force is already zero at the end and remains zero.
        contact_lost = motion.outcome in (Outcome.AIRBORNE, Outcome.LIFTED_OFF)
        forcing_end = [0.0, 0.0] if contact_lost else [np.nan, MODAL_FORCE_FADE]
        self.channel_ends = np.array([[np.nan, 0.0]] * 2 + [forcing_end] * len(modes))
        self.latency = latency

    def with_second_ear(self, other, turn):
        """Return the source with an additional column for a second ear, rotated by
        `turn` [rad]."""
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
        return RingDown(
            frequency=self._modes.frequency,
            decay_rate=rate,
            decay_rate_without_film=rate,
        )

    @cached_property
    def tail_duration(self) -> float:
        """Time [s] from the end of the motion until the modes are inaudible, plus the
        final fade."""
        return (
            ring_down_time(self._modes, self._scene, self.ringing.decay_rate) + FADE_OUT
        )

    def input_channels(self, force, state):
        """Return (k, 2 + m): cosine and sine of the listener's azimuth, and modal
        forces."""
        turning_with_body = self._scene.support.kind == "free"
        azimuth = self._listener.azimuth + listener_azimuth(
            state, turning_with_body=turning_with_body
        )
        return np.column_stack(
            [np.cos(azimuth), np.sin(azimuth), self._forcing(force, state)]
        )

    def make_block_renderer(self, first, note):
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (2 + m,). The
        function reports the modal energy."""
        radiate = self._face.make_block_radiator(first[:2], self._second_ear)
        response = self._response(first[2:])

        def advance(force):
            ringing = response.advance(force.channels(slice(2, None)))
            note(
                *windowed_energy_peaks(
                    force.t,
                    ringing.sum(axis=0),
                    self._modes,
                    self._scene.audio.sample_rate,
                )
            )
            return radiate(ringing, force.channels(slice(2)).samples[:-1])

        return advance

    def _response(self, settled):
        if isinstance(self._motion, VibrationPart):
            return SolvedModes(self._motion, self._chosen, self.ringing)
        return DrivenModes(self._modes, self._scene.audio.sample_rate, settled)


class SourcePair(Source):
    """One source at two ears; the stems at the second ear are summed into an additional
    column."""

    def __init__(self, source: Source, other: Source):
        self._pair = (source, other)
        count = len(source.channel_ends)
        self._parts = (slice(count), slice(count, None))
        self.names = source.names
        self.tail_duration = source.tail_duration
        self.latency = source.latency
        self.channel_ends = np.vstack([source.channel_ends, other.channel_ends])

    def input_channels(self, force, state):
        """Return the input channels of the first ear, then those of the second."""
        return np.hstack([source.input_channels(force, state) for source in self._pair])

    def make_block_renderer(self, first, note):
        """Return a function that computes the stems (k, s + 1) [Pa] of successive
        blocks.

        Before the first block the channels have the values `first` (c,). Only the first
        source reports its energy."""
        notes = (note, lambda t, energy: None)
        own, other = (
            source.make_block_renderer(first[part], report)
            for source, part, report in zip(self._pair, self._parts, notes, strict=True)
        )

        def advance(force):
            second = other(force.channels(self._parts[1])).sum(axis=1, keepdims=True)
            return np.hstack([own(force.channels(self._parts[0])), second])

        return advance


def delay_output(advance: Advance, samples: int) -> Advance:
    """Return `advance` with its output delayed by `samples` samples, initially
    silent."""
    held = None

    def delayed(force):
        nonlocal held
        out = advance(force)
        out = np.vstack(
            [np.zeros((samples, out.shape[1])) if held is None else held, out]
        )
        out, held = np.split(out, [len(out) - samples])
        return out

    return delayed if samples else advance


def windowed_energy_peaks(t, acceleration, modes, sample_rate):
    """Return the times (e,) [s] of windows and the maximum modal energy (e,) [J] in
    each window.

    The energy of an oscillator of unit modal mass at a turning point is q''^2/(2 w^2).
    The window is one period of the lowest modes."""
    window = 0.002  # s
    energy = np.square(acceleration) @ ((2 * np.pi * modes.frequency) ** -2.0 / 2)
    starts = np.arange(0, len(energy), max(int(window * sample_rate), 1))
    return t[starts], np.maximum.reduceat(energy, starts)
