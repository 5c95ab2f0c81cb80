"""ELASTIC CONTACT -> SOUND: vibration of the disk on its compliant, rough contact, radiated by the
disk itself."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, pairwise, repeat
from math import ceil, pi

import numpy as np
from scipy.signal import oaconvolve, upfirdn

from dynamics import Motion
from dynamics.compliant.law.height_profile import Profile
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linear_response import MAX_STEP_TURN, contact_response, motion_blocks
from dynamics.compliant.law.linearised import required_step_rate
from dynamics.compliant.law.roughness import profiles
from dynamics.compliant.law.tabulated import LawTable
from dynamics.compliant.model_inputs import law_table
from dynamics.film.activation import decide_film
from dynamics.rattling.rattling_motion import RattlingMotion
from dynamics.rigid_motion import RigidMotion
from sonify.sound.force import CALM_STRIDE, LOW_PASS_HALF_WIDTH, ContactForce
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sound.sources.protocol import Source, delay_output

RATTLE_CROSSOVER = 200.0
"""Frequency above which a rattling disk pumps the air out of the gap under it [Hz]; the precession
is slower."""
MIN_PROFILE_RATE = 96e3  # 1/s
"""Least sample rate of the height profiles; the contact ellipse smooths faster variations."""


@dataclass(frozen=True, eq=False)
class ContactFilter:
    """The force that a compliant, rough contact adds along a rigid motion.

    The force is sampled at start + n/sample_rate [s], like the contact force; it is zero before and
    after the motion.

    Attributes
    ----------
    motion : Motion
    table : LawTable
        Tabulated law of the contact.
    profiles : tuple of Profile
        Height profiles of edge and table.
    sample_rate : int
        [Hz]
    start : float
        Time of sample 0 [s].
    """

    motion: Motion
    table: LawTable
    profiles: tuple[Profile, Profile]
    sample_rate: int
    start: float

    @property
    def oversampling(self) -> int:
        """Number of steps per sample: enough for the stiffest contact, and for MIN_PROFILE_RATE."""
        needed = (
            required_step_rate(self.table.law, np.array([MIN_CONTACT_INCLINATION]))[0]
            / MAX_STEP_TURN
        )
        return ceil(max(needed, MIN_PROFILE_RATE) / self.sample_rate)

    @property
    def first(self) -> int:
        """Number of the first sample within the motion."""
        return max(ceil(-self.start * self.sample_rate), 0)

    @property
    def end(self) -> float:
        """Time [s] at which the contact ceases to be an ellipse, or the motion ends."""
        return float(
            self.motion.t[np.flatnonzero(self.motion.state[:, 1] >= MIN_CONTACT_INCLINATION)[-1]]
        )

    def blocks(self, fade=0.002) -> Iterator[np.ndarray]:
        """Yield the force (k, 2) [N] along a_2 and the normal from sample `first` on.

        The force fades over the last `fade` [s], some periods of the contact resonance."""
        over = self.oversampling
        rate = over * self.sample_rate
        begin = self.start + self.first / self.sample_rate
        knots = motion_blocks(self.motion, rate, begin, self.end)
        weight = low_pass(over)
        past = np.zeros((len(weight) // 2 + 1, 2))
        count = 0
        for force in contact_response(self.table, knots, rate, self.profiles):
            t = begin + (count + 1 + np.arange(len(force))) / rate
            count += len(force)
            fading = np.sin(pi / 2 * np.clip((self.end - t) / fade, 0, 1))[:, None] ** 2
            past = np.vstack([past, force * fading])
            ready = decimate(past, weight, over)
            yield ready
            past = past[len(ready) * over :]
        yield decimate(np.vstack([past, np.zeros((len(weight), 2))]), weight, over)


def low_pass(factor: int) -> np.ndarray:
    """Return a windowed sinc of 2 factor LOW_PASS_HALF_WIDTH + 1 taps, for decimation by
    `factor`."""
    width = LOW_PASS_HALF_WIDTH
    distance = np.arange(-factor * width, factor * width + 1) / factor
    weight = np.sinc(distance) * np.cos(pi / 2 * distance / width) ** 2
    return weight / weight.sum()


def decimate(samples, weight, factor) -> np.ndarray:
    """Filter samples (n, c) with the taps `weight`, keep every `factor`-th; drop incomplete
    windows."""
    skipped = (len(weight) - 1) // factor
    complete = (len(samples) - len(weight)) // factor + 1
    return upfirdn(weight, samples, 1, factor, axis=0)[skipped : skipped + complete]


class ContactVibration(Source):
    """Vibration along a rigid motion: a ContactFilter drives the rigid disk, its modes and an
    elastic table.

    Its blocks are those of the filter, so the result is bit-identical for all sizes of requested
    blocks."""

    names = ("contact",)
    channel_ends = np.zeros((0, 2))
    tail_duration = 0.0

    def __init__(self, scene, motion, *moved: Source):
        self._table = law_table(scene)
        self._profiles = profiles(scene.roughness, scene.disk.radius)
        self._motion = motion
        self._rate = scene.audio.sample_rate
        self._moved = moved
        self.latency = max(source.latency for source in moved)

    def channels(self, force, state):
        """Return no channels: the force is that of the filter."""
        return np.zeros((len(force), 0))

    def start_rendering(self, first, note):
        """Return the function that radiates the next samples, (k, 1) [Pa], once per block."""
        pressure = None
        held = np.zeros((0, 1))

        def advance(force):
            nonlocal pressure, held
            if pressure is None:
                added = ContactFilter(
                    self._motion, self._table, self._profiles, self._rate, float(force.t[0])
                )
                pressure = self._pressure(added)
                held = np.zeros((added.first, 1))
            while len(held) < len(force.t) - 1:
                held = np.vstack([held, next(pressure)])
            out, held = np.split(held, [len(force.t) - 1])
            return out

        return advance

    def _pressure(self, added):
        """Yield the pressure (k, 1) [Pa] in the blocks of a ContactFilter."""
        renderers = [
            delay_output(
                source.start_rendering(np.zeros(len(source.channel_ends)), lambda t, energy: None),
                self.latency - source.latency,
            )
            for source in self._moved
        ]
        for t, force in _added_force(added):
            state = self._states(t)
            driven = [source.channels(force, state) for source in self._moved]
            # Subtract the rigid disk without a force: its channels are affine in the force.
            driven[0][:, :3] -= self._moved[0].channels(0 * force, state)[:, :3]
            stems = [
                render(_smooth_force(t, channels))
                for render, channels in zip(renderers, driven, strict=True)
            ]
            yield np.hstack(stems).sum(axis=1, keepdims=True)

    def _states(self, t):
        """Return the states (k, 11) of the motion at t (k,) [s], interpolated between every
        CALM_STRIDE-th of them."""
        inside = np.clip(t, 0.0, self._motion.t[-1])
        nodes = np.append(inside[:-1:CALM_STRIDE], inside[-1])
        return np.column_stack(
            [np.interp(inside, nodes, column) for column in self._motion.at(nodes).T]
        )


def _added_force(added, silent_block=1 << 14):
    """Yield times (k + 1,) [s] and added contact forces (k + 1, 3) [N]; after the motion, endless
    blocks of zeros."""
    n = added.first
    last = np.zeros((0, 2))
    for block in chain(added.blocks(), repeat(np.zeros((silent_block, 2)))):
        force = np.vstack([last, block])
        t = added.start + (n + np.arange(len(force))) / added.sample_rate
        yield t, np.column_stack([np.zeros(len(force)), force])
        n += len(force) - 1
        last = force[-1:]


def _smooth_force(t, channels):
    """Return a ContactForce without jumps."""
    none = np.zeros((0, channels.shape[1]))
    return ContactForce(
        t=t,
        smooth=channels,
        steps=np.zeros_like(channels),
        jump_time=np.zeros(0),
        jump=none,
        bend=none,
    )


class SolvedContactVibration(Source):
    """The disk in a motion that already contains its vibration on the contact.

    The part of each stem above `crossover` [Hz] becomes the stem of the contact. If `vibrating`
    differs from `rigid`, it radiates the rigid disk in that stem."""

    def __init__(
        self, rigid: Source, elastic: Source, vibrating: Source, crossover: float, sample_rate: int
    ):
        self._disk = [rigid, elastic]
        if vibrating is not rigid:
            self._disk.append(vibrating)
        self._rigid_stems = len(rigid.names)
        bounds = np.cumsum([0, *(len(source.channel_ends) for source in self._disk)])
        self._parts = [slice(*pair) for pair in pairwise(bounds)]
        self.names = (*rigid.names, *elastic.names, "contact")
        self.channel_ends = np.vstack([source.channel_ends for source in self._disk])
        self._weight = low_pass(max(round(sample_rate / (2 * crossover)), 1))
        self.tail_duration = max(rigid.tail_duration, elastic.tail_duration)
        self._disk_latency = max(source.latency for source in self._disk)
        self.latency = self._disk_latency + len(self._weight) // 2

    def channels(self, force, state):
        """Return the input channels (k, c) of the disk."""
        return np.hstack([source.channels(force, state) for source in self._disk])

    def start_rendering(self, first, note):
        """Return the function that radiates the blocks after `first` (c,): stems (k, 5) [Pa]."""
        renderers = [
            delay_output(
                source.start_rendering(first[part], note), self._disk_latency - source.latency
            )
            for source, part in zip(self._disk, self._parts, strict=True)
        ]
        half = len(self._weight) // 2
        past = None

        def advance(force):
            nonlocal past
            new = np.hstack(
                [
                    render(force.channels(part))
                    for render, part in zip(renderers, self._parts, strict=True)
                ]
            )
            past = np.vstack([np.repeat(new[:1], 2 * half, axis=0) if past is None else past, new])
            slow = oaconvolve(past, self._weight[:, None], "valid", axes=0)
            fast = past[half : len(past) - half] - slow
            past = past[len(new) :]
            if len(self._disk) > 2:
                slow = slow[:, :-1]
                fast = fast[:, self._rigid_stems :]
            return np.column_stack([slow, fast.sum(axis=1)])

        return advance


def contact_sources(scene, motion, listener, rigid, elastic, *below) -> list[Source]:
    """Return the sources of a disk, including its vibration on an elastic contact.

    The vibration is added to a rigid motion, or extracted from a motion that contains it. The force
    added to a rigid motion also drives the tables `below`."""
    if scene.contact.law == "rigid":
        return [rigid, elastic]
    if isinstance(motion, RattlingMotion):
        rate = scene.audio.sample_rate
        open_disk = VibratingDisk(scene, listener) if scene.air.pressure else rigid
        return [SolvedContactVibration(rigid, elastic, open_disk, RATTLE_CROSSOVER, rate)]
    vibrating = VibratingDisk(scene, listener) if decide_film(scene).film else rigid
    if isinstance(motion, RigidMotion):
        return [rigid, elastic, ContactVibration(scene, motion, vibrating, elastic, *below)]
    resonance = law_table(scene).carrier(motion.state[:1, 1], scene.disk.weight, 0.0).frequency
    lowest = float(resonance[0])
    return [SolvedContactVibration(rigid, elastic, vibrating, lowest / 2, scene.audio.sample_rate)]
