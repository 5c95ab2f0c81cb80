"""ELASTIC CONTACT -> SOUND: what a contact that yields and is rough adds to the force, radiated by the same disk."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, repeat
from math import ceil, pi

import numpy as np
from scipy.signal import upfirdn

from dynamics import Motion
from dynamics.coupled.contact import LEAST_INCLINATION
from dynamics.coupled.filter import LARGEST, along, respond
from dynamics.coupled.from_scene import contact_law
from dynamics.coupled.profile import SMOOTH, Profile
from dynamics.coupled.resonance import rate_needed
from dynamics.coupled.roughness import profiles
from dynamics.coupled.table import LawTable
from sonify.sound.force import HALF_WIDTH, STRIDE, ContactForce

FINEST = 96e3
"""The heights are read at least so often [1/s]: what the ellipse leaves of them is slower."""
SILENCE = 1 << 14
"""Samples that follow at once on those of the motion."""
FADE = 0.002
"""The force of the contact fades over the last of this time [s], some swings of its resonance."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Filter:
    """The force that the contact of a `table` of its law, rough by `profiles`, adds along a rigid `motion`.

    It is sampled at start + n/sample_rate [s], as the contact force is; 0 before and after the motion.
    """

    motion: Motion
    table: LawTable
    sample_rate: int
    start: float
    profiles: tuple[Profile, Profile] = (SMOOTH, SMOOTH)

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


class ElasticContact:
    """The vibration of the disk on its contact: the rigid disk and its modes, moved by what a Filter adds to the force.

    Its blocks are those of the filter, so that its bits do not depend on how many samples are asked for at once.
    """

    names = ("contact",)
    ends = np.zeros((0, 2))
    lasting = 0.0

    def __init__(self, added: Filter, rigid, elastic):
        self._added, self._rigid, self._elastic = added, rigid, elastic

    def channels(self, force, state):
        """Return none: the force is that of the filter."""
        return np.zeros((len(force), 0))

    def from_rest(self, first, note):
        """Return what radiates the samples that are asked for one block after the other, (k, 1) [Pa]."""
        pressure, held = self._pressure(), np.zeros((self._added.first, 1))

        def advance(force):
            nonlocal held
            while len(held) < len(force.t) - 1:
                held = np.vstack([held, next(pressure)])
            out, held = np.split(held, [len(force.t) - 1])
            return out

        return advance

    def _pressure(self):
        still, unheard = [np.zeros(len(source.ends)) for source in (self._rigid, self._elastic)], lambda t, energy: None
        tilting, ringing = self._rigid.from_rest(still[0], unheard), self._elastic.from_rest(still[1], unheard)
        for t, force in self._forces():
            state = self._states(t)
            weightless = self._rigid.channels(force, state) - self._rigid.channels(0 * force, state)
            stems = tilting(smooth(t, weightless)), ringing(smooth(t, self._elastic.channels(force, state)))
            yield np.hstack(stems).sum(axis=1, keepdims=True)

    def _forces(self):
        """Yield times (k + 1,) [s] and what is added to the contact force (k + 1, 3) [N]; nothing, for ever, after."""
        n, left = self._added.first, np.zeros((0, 2))
        for block in chain(self._added.blocks(), repeat(np.zeros((SILENCE, 2)))):
            force = np.vstack([left, block])
            t = self._added.start + (n + np.arange(len(force))) / self._added.sample_rate
            yield t, np.column_stack([np.zeros(len(force)), force])
            n, left = n + len(force) - 1, force[-1:]

    def _states(self, t):
        """The states (k, 11) of the motion, read at every STRIDE-th of the times t (k,) [s] and straight between."""
        inside = np.clip(t, 0.0, self._added.motion.t[-1])
        nodes = np.append(inside[:-1:STRIDE], inside[-1])
        return np.column_stack([np.interp(inside, nodes, column) for column in self._added.motion.at(nodes).T])


def smooth(t, channels) -> ContactForce:
    """Return the block of a force without jumps."""
    none, width = np.zeros(0), channels.shape[1]
    jumps = {"jump_time": none, "jump": np.zeros((0, width)), "bend": np.zeros((0, width))}
    return ContactForce(t=t, smooth=channels, steps=np.zeros_like(channels), **jumps)


def contact_of(scene, motion, start: float, rigid, elastic) -> ElasticContact:
    """Return the source of the elastic contact of a scene along its motion."""
    added = Filter(
        motion=motion,
        table=LawTable(law=contact_law(scene)),
        sample_rate=scene.audio.sample_rate,
        start=start,
        profiles=profiles(scene.roughness, scene.disk.radius),
    )
    return ElasticContact(added, rigid, elastic)
