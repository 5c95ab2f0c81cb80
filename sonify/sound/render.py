"""FORCE + MODES -> SOUND: the pressure at the listener, as separate causes that add up to it."""

from collections import defaultdict, deque
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import copy
from dataclasses import replace
from functools import partial
from itertools import islice, pairwise
from math import ceil

import numpy as np

from dynamics import Motion
from modal import Modes, SurfaceModes
from sonify.scene import Scene
from sonify.sound.absorption import absorbing, reach
from sonify.sound.audible_modes import sounding
from sonify.sound.contact import with_contact
from sonify.sound.film import with_film
from sonify.sound.force import ForceSampler
from sonify.sound.infinite import table_sources
from sonify.sound.pressure import Sound, kept, with_sum
from sonify.sound.radiation import listener_of, listeners_of
from sonify.sound.radiators import RigidFace
from sonify.sound.sources import FADE_IN, FADE_OUT, ElasticDisk, RigidDisk, at_both_ears, held_back

BLOCK = 1 << 16
"""Samples computed at once; the samples depend on it by rounding only."""
AHEAD = 3
"""Blocks read before they sound: some take longer to read, and others to sound."""


class Renderer:
    """Turns a motion and the modes of its disk into blocks of pressure at the listener [Pa], one column per stem.

    The stems are those of its `sources`, in turn. Of the modes those of the indices `wanted` sound, all if None, but
    none at or above half the sample rate; of an elastic table the modes `table`. `calm` is that of the ForceSampler.
    The `listener` is the scene's first, unless another is given. With a `turn` [rad] one more column is the pressure at
    an ear that is so much further round.
    The clock of the samples is the listener's: the source is heard distance / c later. However the motion ends, its
    modes ring out. Nothing but the sampler's count of readings changes by use. tests/test_sound.py.
    """

    def __init__(self, scene, motion, modes, wanted=None, calm: float = 0.0, table=None, listener=None, turn=None):
        self.scene, self.motion, self.sample_rate = scene, motion, scene.audio.sample_rate
        self.listener = listener or listener_of(scene)
        self.chosen = sounding(modes, self.sample_rate, wanted)
        self.modes = modes.select(self.chosen)
        self.table = table
        self._rigid = RigidFace(scene.disk, self.listener, 1 / self.sample_rate)
        self._turned = turn is not None
        self.sources = self._at_both_ears(turn) if self._turned else self._sources()
        self.late = max(source.late for source in self.sources)
        self.names = tuple(name for source in self.sources for name in source.names)
        bounds = np.cumsum([0, *(len(source.ends) for source in self.sources)])
        self._parts = [slice(*pair) for pair in pairwise(bounds)]
        late = self.late + reach(scene.air, self.listener.distance)
        start = late / self.sample_rate - self.listener.delay
        self._early = max(ceil(start * self.sample_rate), 0)  # samples that are read before the first one is heard
        start -= self._early / self.sample_rate
        rest, fade = np.vstack([source.ends for source in self.sources]).T
        self.sampler = ForceSampler(motion, self.sample_rate, start, self._channels, rest, calm, fade)
        self.source_end = self.sampler.end + self.listener.delay
        self.samples = ceil((self.source_end + max(s.lasting for s in self.sources)) * self.sample_rate)

    def _sources(self):
        """What sounds in this scene; every cause of sound has its line."""
        rigid = RigidDisk(self.scene, self._rigid, self.listener.azimuth)
        elastic = ElasticDisk(self.scene, self.motion, self.modes, self.chosen, self.listener, self._rigid.reach)
        tables = table_sources(self.scene, self.table, self.listener)
        rigid, elastic = with_film(self.scene, self.motion, rigid, elastic, self.listener)
        return with_contact(self.scene, self.motion, self.listener, rigid, elastic, *tables) + tables

    def _at_both_ears(self, turn):
        other = copy(self)
        other.listener = replace(self.listener, azimuth=self.listener.azimuth + turn)
        return [at_both_ears(*pair, turn) for pair in zip(self._sources(), other._sources(), strict=True)]

    def blocks(self, size: int = BLOCK, note=lambda name, t, energy: None):
        """Yield (k, s) [Pa]: the stems at the next k <= size samples, from the first to the last; every call anew.

        `note(name, t (e,) [s], energy (e,) [J])` is called with the energy of the modes of the source whose first stem
        has that name, in the time of the motion.
        """
        first = self.sampler.block(0, 1).samples[0]
        sounding = [
            (held_back(source.from_rest(first[part], partial(note, source.names[0])), self.late - source.late), part)
            for source, part in zip(self.sources, self._parts, strict=True)
        ]
        absorbed = absorbing(self.scene.air, self.listener.distance, self.sample_rate)
        early, past = self._early, self.samples + self._early
        counts = {n: min(size, past - n) for n in range(0, past, size)}
        with ThreadPoolExecutor(1) as reader:  # the next blocks are read while this one sounds
            asked = (reader.submit(self.sampler.block, *block) for block in counts.items())
            coming = deque(islice(asked, AHEAD))
            for n in counts:
                force = coming.popleft().result()
                coming.extend(islice(asked, 1))
                stems = absorbed(self._joined([advance(force.channels(part)) for advance, part in sounding]))
                yield self._enveloped(stems[max(early - n, 0) :], max(n - early, 0))

    def sound(self, watch=lambda share: None) -> Sound:
        """Return the whole sound; `watch(share)` is called with the share done."""
        noted, own = defaultdict(list), len(self.names)

        def rows():
            for i, stems in enumerate(self.blocks(note=lambda name, *energy: noted[name].append(energy))):
                watch(min((i + 1) * BLOCK / self.samples, 1.0))
                yield np.hstack([with_sum(stems[:, :own]), stems[:, own:].astype(np.float32)])

        columns = kept(rows(), self.samples)
        energies = {name: np.concatenate(parts, axis=1) for name, parts in noted.items()}
        table_energy = energies.pop("table", (None, None))[1]
        ((time, energy),) = energies.values()  # the disk's
        return Sound(
            name=self.scene.name,
            sample_rate=self.sample_rate,
            columns=columns,
            names=self.names,
            turned=self._turned,
            modes_heard=len(self.modes),
            source_end=self.source_end,
            energy_time=time,
            energy=energy,
            table_energy=table_energy,
        )

    def _channels(self, force, state):
        return np.column_stack([source.channels(force, state) for source in self.sources])

    def _joined(self, parts):
        """The stems (k, s) of all sources, and what the other ear hears of them as one more column."""
        if not self._turned:
            return np.hstack(parts)
        return np.hstack([part[:, :-1] for part in parts] + [sum(part[:, -1:] for part in parts)])

    def _enveloped(self, stems, first):
        """The stems (k, s) of the samples from `first` on, under the raised cosines at both ends."""
        edges = FADE_IN * self.sample_rate, self.samples - FADE_OUT * self.sample_rate
        if edges[0] < first and first + len(stems) < edges[1]:
            return stems
        n = first + np.arange(len(stems)) + 0.5
        rise = np.clip(n / edges[0], 0, 1)
        fall = np.clip((self.samples - n) / (self.samples - edges[1]), 0, 1)
        return stems * (np.sin(np.pi / 2 * rise) ** 2 * np.sin(np.pi / 2 * fall) ** 2)[:, None]


def sound_of(
    scene: Scene,
    motion: Motion,
    modes: Modes,
    wanted: Sequence[int] | None,
    calm: float,
    table: SurfaceModes | None,
    watch: Callable[[float], None] = lambda share: None,
) -> Sound:
    """Return the whole sound at every listener of the scene; the arguments are those of the Renderer.

    `watch(share)` is called with the share done.
    """
    ears = listeners_of(scene)

    turn = np.pi / 2 if len(ears) == 1 else None  # audible.wav is for two ears at least

    def heard(i):
        renderer = Renderer(scene, motion, modes, wanted, calm, table, ears[i], turn)
        return renderer.sound(lambda share: watch((i + share) / len(ears)))

    first, *others = map(heard, range(len(ears)))
    return replace(first, others=tuple(others))
