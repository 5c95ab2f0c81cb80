"""Sound sources: objects that convert the contact force to sound-pressure signals,
block by block."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from copy import copy
from functools import cached_property, partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics import Outcome
from sonify.sound.audible_modes import RingDown, ring_down_time
from sonify.sound.block_overlap import overlapping_blocks
from sonify.sound.modal_forcing import (
    arc_shares,
    heave_and_tilt_accelerations,
    listener_azimuth,
    modal_forcing_function,
)
from sonify.sound.radiation import Listener
from sonify.sound.radiators import ElasticFace, RigidFace
from sonify.sound.response import DrivenModes

if TYPE_CHECKING:
    from dynamics.motion import Motion
    from modal.modes import Modes
    from modal.tabletop.record import SurfaceModes
    from sonify.scene import Scene
    from sonify.sound.force import ContactForce

Note = Callable[[np.ndarray, np.ndarray], None]
"""Function that receives the modal energy (e,) [J] at times (e,) [s]."""

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

Advance = Callable[["ContactForce"], np.ndarray]
"""Function that converts a ContactForce of a source's channels to its stems (k, s)
[Pa]."""


class SoundSource(ABC):
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
    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels (k, c) for forces (k, 3) [N], states (k, 11) and the
        columns (k, 5) of `Motion.film_loads`."""

    @abstractmethod
    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks of
        a ContactForce.

        Before the first block the channels have the values `first` (c,). The source may
        report its modal energy by `note(t (e,) [s], energy (e,) [J])`."""

    def with_second_ear(self, other: "SoundSource", turn: float) -> "SoundSource":
        """Return a source with an additional column, the sum of its stems at a second
        ear.

        The second ear is rotated by `turn` [rad] around the disk; `other` is the same
        source for a listener there.
        """
        return SourcePair(self, other)


class TwoEarSource(SoundSource):
    """Source that computes the sound at both ears together, faster than a SourcePair."""

    _second_ear: float | None = None
    """Azimuth [rad] from the first ear to the second, if there is one."""

    def with_second_ear(self, other: SoundSource, turn: float) -> SoundSource:
        """Return the source with an additional column for a second ear, rotated by
        `turn` [rad]."""
        source = copy(self)
        source._second_ear = turn
        return source


class RigidDisk(TwoEarSource):
    """Heave and tilt of the disk as a rigid body."""

    names = ("heave", "tilt")
    tail_duration = 2 * FADE_OUT

    def __init__(
        self, scene: "Scene", face: RigidFace, azimuth: float, comes_to_rest: bool
    ) -> None:
        self._fade = MODAL_FORCE_FADE if comes_to_rest else FADE_OUT
        self._disk = scene.disk
        self._face = face
        self._azimuth = azimuth
        self.latency = face.reach

    @property
    def channel_ends(self) -> np.ndarray:
        """Rest values and fade times: every channel fades to zero."""
        return np.array([[0.0, self._fade]] * (2 if self._second_ear is None else 3))

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return (k, 2 or 3) [m/s^2]: the heave and the tilt towards each ear."""
        ears = [self._azimuth]
        if self._second_ear is not None:
            ears.append(self._azimuth + self._second_ear)
        return heave_and_tilt_accelerations(force, state, film, self._disk, *ears)

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the accelerations have the values `first` (c,)."""
        radiate = self._face.make_block_radiator(first)

        def advance(force: "ContactForce") -> np.ndarray:
            pressure = radiate(force.samples, force.knots, force.jump)
            pressure[:, 2:] += pressure[
                :, :1
            ]  # the heave is the same at the second ear
            return pressure

        return advance


class ElasticDisk(TwoEarSource):
    """Elastic modes of the disk, driven by the contact force or solved together with
    the motion."""

    names = ("ringing_smooth", "ringing_jumps")

    def __init__(
        self,
        scene: "Scene",
        motion: "Motion",
        modes: "Modes",
        chosen: np.ndarray,
        listener: Listener,
        latency: int,
    ) -> None:
        self._scene = scene
        self._motion = motion
        self._modes = modes
        self._chosen = chosen
        self._listener = listener
        self._face = ElasticFace(modes, listener, scene.audio.sample_rate, latency)
        self._forcing = modal_forcing_function(modes, scene)
        # If the contact is lost, the force is already zero at the end and remains zero.
        contact_lost = motion.outcome in (Outcome.AIRBORNE, Outcome.LIFTED_OFF)
        forcing_end = [0.0, 0.0] if contact_lost else [np.nan, MODAL_FORCE_FADE]
        self.channel_ends = np.array([[np.nan, 0.0]] * 2 + [forcing_end] * len(modes))
        self.latency = latency

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

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return (k, 2 + m): cosine and sine of the listener's azimuth, and modal
        forces."""
        turning_with_body = self._scene.support.kind == "free"
        azimuth = self._listener.azimuth + listener_azimuth(state, turning_with_body)
        return np.column_stack(
            [
                np.cos(azimuth),
                np.sin(azimuth),
                self._forcing(force, state) * arc_shares(film[:, 4], self._modes.order),
            ]
        )

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (2 + m,). The
        function reports the modal energy."""
        rate = self._scene.audio.sample_rate
        radiate = self._face.make_block_radiator(first[:2], self._second_ear)
        respond = self._response(first)

        def advance(force: "ContactForce") -> np.ndarray:
            ringing = respond(force)
            note(
                *windowed_energy_peaks(force.t, ringing.sum(axis=0), self._modes, rate)
            )
            direction = force.channels(slice(2)).samples[:-1]
            return radiate(self._radiating(ringing, force), direction)

        return advance

    def _response(self, first: np.ndarray) -> Advance:
        """Return a function that computes the modal accelerations (s, k, m) due to
        successive blocks of the channels."""
        driven = DrivenModes(
            self._modes.frequency,
            self._modes.decay_rate,
            self._scene.audio.sample_rate,
            first[2:],
        )
        return lambda force: driven.advance(force.channels(slice(2, None)))

    def _radiating(self, ringing: np.ndarray, force: "ContactForce") -> np.ndarray:
        """Return the accelerations (s, k, m) that radiate the same pressure above a
        closed film."""
        return ringing


class SourceGroup:
    """Several sources with their channels side by side.

    Attributes
    ----------
    channel_ends : ndarray, shape (c, 2)
        Ends of all channels, in the form required by ForceSampler.
    parts : list of slice
        Channels of each source.
    latency, tail_duration : int, float
        Largest latency [samples] and longest tail [s].
    """

    def __init__(self, sources: Sequence[SoundSource]) -> None:
        self._sources = sources
        self.channel_ends = np.vstack([source.channel_ends for source in sources])
        bounds = np.cumsum([0, *(len(source.channel_ends) for source in sources)])
        self.parts = [slice(*pair) for pair in pairwise(bounds)]
        self.latency = max(source.latency for source in sources)
        self.tail_duration = max(source.tail_duration for source in sources)

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels (k, c) of all sources."""
        return np.hstack(
            [source.input_channels(force, state, film) for source in self._sources]
        )

    def simultaneous_renderers(
        self, first: np.ndarray, notes: Sequence[Note]
    ) -> list[Advance]:
        """Return for each source a function that computes its stems from the force of
        all channels, delayed so that all sources have the same latency.

        `first` (c,) and `notes` are those of `make_block_renderer`."""

        def render_part(
            part: slice, advance: Advance, force: "ContactForce"
        ) -> np.ndarray:
            return advance(force.channels(part))

        return [
            delay_output(
                partial(
                    render_part, part, source.make_block_renderer(first[part], note)
                ),
                self.latency - source.latency,
            )
            for source, part, note in zip(self._sources, self.parts, notes, strict=True)
        ]


def ignore_energy(t: np.ndarray, energy: np.ndarray) -> None:
    """Do not report the modal energy."""


class CompositeSource(SoundSource):
    """Source with the channels of several others side by side."""

    def __init__(self, names: tuple[str, ...], *sources: SoundSource) -> None:
        self._group = SourceGroup(sources)
        self.names = names
        self.channel_ends = self._group.channel_ends
        self.tail_duration = self._group.tail_duration
        self.latency = self._group.latency

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return the input channels (k, c) of all sources."""
        return self._group.input_channels(force, state, film)


class SourcePair(CompositeSource):
    """One source at two ears; the stems at the second ear are summed into an additional
    column."""

    def __init__(self, source: SoundSource, other: SoundSource) -> None:
        super().__init__(source.names, source, other)

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, s + 1) [Pa] of successive
        blocks.

        Before the first block the channels have the values `first` (c,). Only the first
        source reports its energy."""
        own, other = self._group.simultaneous_renderers(first, [note, ignore_energy])

        def advance(force: "ContactForce") -> np.ndarray:
            second = other(force).sum(axis=1, keepdims=True)
            return np.hstack([own(force), second])

        return advance


def delay_output(advance: Advance, samples: int) -> Advance:
    """Return `advance` with its output delayed by `samples` samples, initially
    silent."""
    extend = overlapping_blocks(samples, first=0.0)

    def delayed(force: "ContactForce") -> np.ndarray:
        out = advance(force)
        return extend(out)[: len(out)]

    return delayed


def windowed_energy_peaks(
    t: np.ndarray,
    acceleration: np.ndarray,
    modes: "Modes | SurfaceModes",
    sample_rate: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the times (e,) [s] of windows and the maximum modal energy (e,) [J] in
    each window.

    The energy of an oscillator of unit modal mass at a turning point is q''^2/(2 w^2).
    The window is one period of the lowest modes."""
    window = 0.002  # s
    energy = np.square(acceleration) @ ((2 * np.pi * modes.frequency) ** -2.0 / 2)
    starts = np.arange(0, len(energy), max(int(window * sample_rate), 1))
    return t[starts], np.maximum.reduceat(energy, starts)
