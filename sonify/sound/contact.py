"""ELASTIC CONTACT -> SOUND: what a contact that yields and is rough adds to the force, radiated by the same disk."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, pairwise, repeat
from math import ceil, pi

import numpy as np
from scipy.signal import oaconvolve, upfirdn

from dynamics import Motion
from dynamics.coupled.contact import LEAST_INCLINATION
from dynamics.coupled.filter import LARGEST, along, respond
from dynamics.coupled.from_scene import law_table
from dynamics.coupled.profile import Profile
from dynamics.coupled.resonance import rate_needed
from dynamics.coupled.roughness import profiles
from dynamics.coupled.table import LawTable
from dynamics.film.acting import film_of
from dynamics.rigid_motion import RigidMotion
from sonify.sound.force import HALF_WIDTH, STRIDE, ContactForce
from sonify.sound.sources import held_back
from sonify.sound.vibrating import VibratingDisk

FINEST = 96e3
"""The heights are read at least so often [1/s]: what the ellipse leaves of them is slower."""
SILENCE = 1 << 14
"""Samples that follow at once on those of the motion."""
FADE = 0.002
"""The force of the contact fades over the last of this time [s], some swings of its resonance."""


@dataclass(frozen=True, eq=False)
class Filter:
    """The force that the contact of a `table` of its law, rough by `profiles`, adds along a rigid `motion`.

    It is sampled at start + n/sample_rate [s], as the contact force is; 0 before and after the motion.
    """

    motion: Motion
    table: LawTable
    profiles: tuple[Profile, Profile]
    sample_rate: int
    start: float

    @property
    def over(self) -> int:
        """So many steps are taken to a sample: what the stiffest contact needs, or FINEST."""
        needed = rate_needed(self.table.law, np.array([LEAST_INCLINATION]))[0] / LARGEST
        return ceil(max(needed, FINEST) / self.sample_rate)

    @property
    def first(self) -> int:
        """The first sample in the motion."""
        return max(ceil(-self.start * self.sample_rate), 0)

    @property
    def end(self) -> float:
        """When the contact ceases to be an ellipse, or the motion ends [s]."""
        return float(self.motion.t[np.flatnonzero(self.motion.state[:, 1] >= LEAST_INCLINATION)[-1]])

    def blocks(self) -> Iterator[np.ndarray]:
        """Yield (k, 2) [N], along a_2 and the normal, from sample `first` on; the blocks are always the same."""
        rate, begin = self.over * self.sample_rate, self.start + self.first / self.sample_rate
        knots = along(self.motion, rate, begin, self.end)
        weight = low_pass(self.over)
        past, count = np.zeros((len(weight) // 2 + 1, 2)), 0
        for force in respond(self.table, knots, rate, self.profiles):
            t = begin + (count + 1 + np.arange(len(force))) / rate
            count += len(force)
            past = np.vstack([past, force * np.sin(pi / 2 * np.clip((self.end - t) / FADE, 0, 1))[:, None] ** 2])
            ready = thinned(past, weight, self.over)
            yield ready
            past = past[len(ready) * self.over :]
        yield thinned(np.vstack([past, np.zeros((len(weight), 2))]), weight, self.over)


def low_pass(over: int) -> np.ndarray:
    """Return the windowed sinc (2 over HALF_WIDTH + 1,) before a sampling of every `over`-th."""
    away = np.arange(-over * HALF_WIDTH, over * HALF_WIDTH + 1) / over
    weight = np.sinc(away) * np.cos(pi / 2 * away / HALF_WIDTH) ** 2
    return weight / weight.sum()


def thinned(samples, weight, over) -> np.ndarray:
    """Return every `over`-th of the weighted means of the samples (n, c) that lie wholly within them."""
    skipped = (len(weight) - 1) // over
    return upfirdn(weight, samples, 1, over, axis=0)[skipped : skipped + (len(samples) - len(weight)) // over + 1]


class AddedByContact:
    """The vibration of the disk on its contact: the rigid disk, its modes and an elastic table below, moved by what a
    Filter adds to the force.

    Its blocks are those of the filter, so that its bits do not depend on how many samples are asked for at once.
    """

    names = ("contact",)
    ends = np.zeros((0, 2))
    lasting = 0.0

    def __init__(self, scene, motion, *moved):
        self._table, self._profiles = law_table(scene), profiles(scene.roughness, scene.disk.radius)
        self._motion, self._rate, self._moved = motion, scene.audio.sample_rate, moved
        self.late = max(source.late for source in moved)

    def channels(self, force, state):
        """Return none: the force is that of the filter."""
        return np.zeros((len(force), 0))

    def from_rest(self, first, note):
        """Return what radiates the samples that are asked for one block after the other, (k, 1) [Pa]."""
        pressure = held = None

        def advance(force):
            nonlocal pressure, held
            if pressure is None:
                added = Filter(self._motion, self._table, self._profiles, self._rate, float(force.t[0]))
                pressure, held = self._pressure(added), np.zeros((added.first, 1))
            while len(held) < len(force.t) - 1:
                held = np.vstack([held, next(pressure)])
            out, held = np.split(held, [len(force.t) - 1])
            return out

        return advance

    def _pressure(self, added):
        radiated = [
            held_back(source.from_rest(np.zeros(len(source.ends)), lambda t, energy: None), self.late - source.late)
            for source in self._moved
        ]
        for t, force in _forces(added):
            state = self._states(t)
            driven = [source.channels(force, state) for source in self._moved]
            driven[0][:, :3] -= self._moved[0].channels(0 * force, state)[:, :3]  # the rigid disk without a force
            stems = [radiate(_smooth(t, channels)) for radiate, channels in zip(radiated, driven, strict=True)]
            yield np.hstack(stems).sum(axis=1, keepdims=True)

    def _states(self, t):
        """The states (k, 11) of the motion, read at every STRIDE-th of the times t (k,) [s] and straight between."""
        inside = np.clip(t, 0.0, self._motion.t[-1])
        nodes = np.append(inside[:-1:STRIDE], inside[-1])
        return np.column_stack([np.interp(inside, nodes, column) for column in self._motion.at(nodes).T])


def _forces(added):
    """Yield times (k + 1,) [s] and what is added to the contact force (k + 1, 3) [N]; nothing, for ever, after."""
    n, left = added.first, np.zeros((0, 2))
    for block in chain(added.blocks(), repeat(np.zeros((SILENCE, 2)))):
        force = np.vstack([left, block])
        t = added.start + (n + np.arange(len(force))) / added.sample_rate
        yield t, np.column_stack([np.zeros(len(force)), force])
        n, left = n + len(force) - 1, force[-1:]


def _smooth(t, channels):
    none, width = np.zeros(0), channels.shape[1]
    jumps = {"jump_time": none, "jump": np.zeros((0, width)), "bend": np.zeros((0, width))}
    return ContactForce(t=t, smooth=channels, steps=np.zeros_like(channels), **jumps)


class WithContact:
    """The disk in a motion that holds the vibration on its contact already: of each stem what is above `crossover` [Hz]
    is the contact's; of the rigid disk it is heard as `vibrating` radiates it, where that is another source."""

    def __init__(self, rigid, elastic, vibrating, crossover: float, sample_rate: int):
        self._disk = rigid, elastic, *([] if vibrating is rigid else [vibrating])
        self._own, cuts = len(rigid.names), np.cumsum([0, *(len(source.ends) for source in self._disk)])
        self._parts = [slice(*pair) for pair in pairwise(cuts)]
        self.names, self.ends = (*rigid.names, *elastic.names, "contact"), np.vstack([s.ends for s in self._disk])
        self._weight = low_pass(max(round(sample_rate / (2 * crossover)), 1))
        self.lasting = max(rigid.lasting, elastic.lasting)
        self._ahead = max(source.late for source in self._disk)
        self.late = self._ahead + len(self._weight) // 2

    def channels(self, force, state):
        """Return what drives the disk, (k, c)."""
        return np.hstack([source.channels(force, state) for source in self._disk])

    def from_rest(self, first, note):
        """Return what radiates the blocks that follow on `first` (c,): stems (k, 5) [Pa]."""
        radiate = [
            held_back(source.from_rest(first[part], note), self._ahead - source.late)
            for source, part in zip(self._disk, self._parts, strict=True)
        ]
        half, past = len(self._weight) // 2, None

        def advance(force):
            nonlocal past
            new = np.hstack([one(force.channels(part)) for one, part in zip(radiate, self._parts, strict=True)])
            past = np.vstack([np.repeat(new[:1], 2 * half, axis=0) if past is None else past, new])
            slow = oaconvolve(past, self._weight[:, None], "valid", axes=0)
            middle, past = past[half : len(past) - half], past[len(new) :]
            fast = middle - slow
            if len(self._disk) > 2:
                slow, fast = slow[:, :-1], fast[:, self._own :]
            return np.column_stack([slow, fast.sum(axis=1)])

        return advance


def with_contact(scene, motion, listener, rigid, elastic, *below) -> list:
    """Return the sources of a disk: with its contact, where that is elastic, added to a rigid motion or already in it.

    What the contact adds to the force of a rigid motion moves the tables `below`, too.
    """
    if scene.contact.law == "rigid":
        return [rigid, elastic]
    vibrating = VibratingDisk(scene, listener) if film_of(scene).film else rigid
    if isinstance(motion, RigidMotion):
        return [rigid, elastic, AddedByContact(scene, motion, vibrating, elastic, *below)]
    lowest = float(law_table(scene).carrier(motion.state[:1, 1], scene.disk.weight, 0.0).frequency[0])
    return [WithContact(rigid, elastic, vibrating, lowest / 2, scene.audio.sample_rate)]
