"""Render the sound pressure at the listener as a sum of stems."""

from collections import defaultdict, deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import copy
from dataclasses import replace
from functools import partial
from itertools import islice
from math import ceil

import numpy as np

from dynamics import Motion
from modal import Modes, SurfaceModes
from sonify.hearing.audio_source import BLOCK_SIZE
from sonify.runtime.progress import Watch, ignore_progress
from sonify.scene import Scene
from sonify.sound.absorption import propagation_filter, propagation_latency
from sonify.sound.audible_modes import modes_below_nyquist
from sonify.sound.fades import raised_cosine
from sonify.sound.force import ForceSampler
from sonify.sound.pressure import Sound, collect_rows, pressure_and_stems
from sonify.sound.radiation import Listener, listener_of, listeners_of
from sonify.sound.radiators import RigidFace
from sonify.sound.sources.contact import contact_sources
from sonify.sound.sources.film import disk_sources
from sonify.sound.sources.infinite_plate import table_sources
from sonify.sound.sources.protocol import (
    FADE_IN,
    FADE_OUT,
    ElasticDisk,
    SoundSource,
    SourceGroup,
)

Listen = Callable[[np.ndarray, int, int], None]
"""Function that receives a block (k,) of the pressure [Pa], the sample rate [Hz] and
the length [samples] of the sound."""
NoteOfSource = Callable[[str, np.ndarray, np.ndarray], None]
"""Function that receives the name of a source, times [s] and modal energies [J]."""


class Renderer:
    """Renderer of the pressure [Pa] at a listener in blocks, with one column per stem.

    Times are measured at the listener, who hears the source with a delay of distance /
    c. The modes ring down after the motion, regardless of its outcome. The only side
    effect of rendering is the evaluation count of the sampler.

    Parameters
    ----------
    scene : Scene
    motion : Motion
    modes : Modes
        Elastic modes of the disk.
    wanted : sequence of int, optional
        Indices of the modes to render (default: all). Modes at or above the Nyquist
        frequency are omitted.
    max_contact_turn : float
        Argument of the ForceSampler [rad].
    table : SurfaceModes, optional
        Modes of an elastic table.
    listener : Listener, optional
        By default the first listener of the scene.
    turn : float, optional
        Azimuth [rad] from the listener to a second ear; its pressure is an additional
        column.

    Attributes
    ----------
    sources : list of SoundSource
    names : tuple of str
        Names of the stems.
    samples : int
        Length of the sound [samples].
    source_end : float
        Time [s] at which the sound of the end of the rolling motion reaches the listener.
    rest : float
        Time [s] at which the sound of the end of the whole motion reaches the listener.
    ringing : RingDown
        Frequencies and decay rates of the modes after the motion.
    """

    def __init__(
        self,
        scene: Scene,
        motion: Motion,
        modes: Modes,
        wanted: Sequence[int] | None = None,
        max_contact_turn: float = 0.0,
        table: SurfaceModes | None = None,
        listener: Listener | None = None,
        turn: float | None = None,
    ) -> None:
        self.scene = scene
        self.motion = motion
        self.sample_rate = scene.audio.sample_rate
        self.chosen = modes_below_nyquist(modes, self.sample_rate, wanted)
        self.modes = modes.select(self.chosen)
        self.table = table
        self._max_contact_turn = max_contact_turn
        self._set_listener(listener or listener_of(scene), turn)

    def for_listener(self, listener: Listener) -> "Renderer":
        """Return a renderer for another listener that reuses the modes and their film."""
        other = copy(self)
        other._set_listener(listener, None)
        return other

    def _set_listener(self, listener: Listener, turn: float | None) -> None:
        """Prepare the sources and the sampler of the force for a listener."""
        self.listener = listener
        self._has_second_ear = turn is not None
        elastic, self.sources = self._sources_at(self.listener)
        if turn is not None:
            second = replace(self.listener, azimuth=self.listener.azimuth + turn)
            _, others = self._sources_at(second)
            pairs = zip(self.sources, others, strict=True)
            self.sources = [
                source.with_second_ear(other, turn) for source, other in pairs
            ]
        self.names = tuple(name for source in self.sources for name in source.names)
        self._group = SourceGroup(self.sources)
        latency = self._group.latency + propagation_latency(self.listener)
        start = latency / self.sample_rate - self.listener.delay
        self._lead = max(
            ceil(start * self.sample_rate), 0
        )  # samples rendered before time 0 of the listener
        start -= self._lead / self.sample_rate
        rest, fade = self._group.channel_ends.T
        self.sampler = ForceSampler(
            self.motion,
            self.sample_rate,
            start,
            self._group.input_channels,
            rest,
            self._max_contact_turn,
            fade,
        )
        self.ringing = elastic.ringing
        self.source_end = float(self.motion.rolling.t[-1]) + self.listener.delay
        self.rest = self.sampler.end + self.listener.delay
        duration = self.rest + self._group.tail_duration
        self.samples = ceil(duration * self.sample_rate)

    def _sources_at(self, listener: Listener) -> tuple[ElasticDisk, list[SoundSource]]:
        """Return the elastic disk and the list of all sources for one listener."""
        face = RigidFace(self.scene.disk, listener, 1 / self.sample_rate)
        rigid, elastic = disk_sources(
            self.scene, self.motion, self.modes, self.chosen, listener, face
        )
        tables = table_sources(self.scene, self.table, listener)
        return elastic, contact_sources(
            self.scene, self.motion, listener, rigid, elastic, *tables
        ) + tables

    def blocks(
        self, size: int = BLOCK_SIZE, note: NoteOfSource = lambda name, t, energy: None
    ) -> Iterator[np.ndarray]:
        """Yield the stems (k, s) [Pa] in blocks of k <= size samples.

        `note(name, t (e,) [s], energy (e,) [J])` receives the modal energy of each
        source at times of the motion; `name` is that of its first stem."""
        first = self.sampler.block(0, 1).samples[0]
        notes = [partial(note, source.names[0]) for source in self.sources]
        renderers = self._group.simultaneous_renderers(first, notes)
        propagate = propagation_filter(self.listener, self.sample_rate)
        lead = self._lead
        total = self.samples + lead
        counts = {n: min(size, total - n) for n in range(0, total, size)}
        with ThreadPoolExecutor(
            1
        ) as reader:  # evaluates the next blocks of the force during rendering
            requests = (
                reader.submit(self.sampler.block, *block) for block in counts.items()
            )
            pending = deque(islice(requests, 3))
            for n in counts:
                force = pending.popleft().result()
                pending.extend(islice(requests, 1))
                stems = propagate(
                    self._join_stems([advance(force) for advance in renderers])
                )
                yield self._apply_end_fades(stems[max(lead - n, 0) :], max(n - lead, 0))

    def sound(
        self,
        watch: Watch = ignore_progress,
        listen: Listen = lambda block, sample_rate, samples: None,
        samples: int | None = None,
    ) -> Sound:
        """Render and return the whole sound.

        `listen(block, sample_rate, samples)` receives each block (k,) of the pressure
        [Pa]. The sound ends with silence if `samples` exceeds its own length."""
        noted = defaultdict(list)
        own = len(self.names)
        samples = samples or self.samples

        def rows() -> Iterator[np.ndarray]:
            for i, stems in enumerate(
                self.blocks(note=lambda name, *energy: noted[name].append(energy))
            ):
                watch(min((i + 1) * BLOCK_SIZE / self.samples, 1.0))
                summed = pressure_and_stems(stems[:, :own])
                listen(summed[:, 0], self.sample_rate, samples)
                yield np.hstack([summed, stems[:, own:].astype(np.float32)])
            if samples > self.samples:
                width = 1 + own + self._has_second_ear
                silence = np.zeros((samples - self.samples, width), np.float32)
                listen(silence[:, 0], self.sample_rate, samples)
                yield silence

        columns = collect_rows(rows(), samples)
        energies = {
            name: np.concatenate(parts, axis=1) for name, parts in noted.items()
        }
        table_energy = energies.pop("table", (None, None))[1]
        ((time, energy),) = energies.values()  # of the disk
        return Sound(
            name=self.scene.name,
            sample_rate=self.sample_rate,
            columns=columns,
            names=self.names,
            has_second_ear=self._has_second_ear,
            source_end=self.source_end,
            outcome=self.motion.outcome,
            ringing=self.ringing,
            energy_time=time,
            energy=energy,
            table_energy=table_energy,
        )

    def _join_stems(self, parts: list[np.ndarray]) -> np.ndarray:
        """Return the stems (k, s) of all sources, with their sum at a second ear as the
        last column."""
        if not self._has_second_ear:
            return np.hstack(parts)
        return np.hstack(
            [part[:, :-1] for part in parts] + [sum(part[:, -1:] for part in parts)]
        )

    def _apply_end_fades(self, stems: np.ndarray, first: int) -> np.ndarray:
        """Apply the fades at both ends to stems (k, s) that start at sample `first`."""
        fade_in_end = FADE_IN * self.sample_rate
        fade_out_start = self.samples - FADE_OUT * self.sample_rate
        if fade_in_end < first and first + len(stems) < fade_out_start:
            return stems
        n = first + np.arange(len(stems)) + 0.5
        rise = raised_cosine(n / fade_in_end)
        fall = raised_cosine((self.samples - n) / (self.samples - fade_out_start))
        return stems * (rise * fall)[:, None]


def render_sound(
    scene: Scene,
    motion: Motion,
    modes: Modes,
    wanted: Sequence[int] | None,
    max_contact_turn: float,
    table: SurfaceModes | None,
    watch: Watch = ignore_progress,
    listen: Listen = lambda block, sample_rate, samples: None,
) -> Sound:
    """Render the sound at every listener of the scene with the arguments of Renderer.

    All listeners have the same time axis: the sound of a nearer listener ends with
    silence. `listen(block, sample_rate, samples)` is called with each block of the
    pressure at the first listener. A single listener has a second ear for audible.wav."""
    listeners = listeners_of(scene)
    turn = np.pi / 2 if len(listeners) == 1 else None
    first, *others = listeners
    renderer = Renderer(
        scene, motion, modes, wanted, max_contact_turn, table, first, turn
    )
    renderers = [renderer, *(renderer.for_listener(other) for other in others)]
    samples = max(renderer.samples for renderer in renderers)

    def ignore(block: np.ndarray, sample_rate: int, samples: int) -> None:
        """Discard the blocks of the other listeners."""

    sounds = []
    for i, renderer in enumerate(renderers):

        def share_done(share: float, note: str = "", i: int = i) -> None:
            watch((i + share) / len(renderers), note)

        sounds.append(renderer.sound(share_done, ignore if i else listen, samples))
    return replace(sounds[0], others=tuple(sounds[1:]))
