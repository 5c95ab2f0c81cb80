"""Compute the sound of a disk that vibrates on its compliant, rough contact."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from itertools import chain, repeat
from math import ceil, pi
from typing import TYPE_CHECKING

import numpy as np
from scipy.signal import oaconvolve, upfirdn

from dynamics import Motion
from dynamics.compliant.law.height_profile import Profile
from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION
from dynamics.compliant.law.linear_response import (
    MAX_PHASE_PER_STEP,
    linear_contact_force_blocks,
    motion_blocks,
)
from dynamics.compliant.law.linearised import required_step_rate
from dynamics.compliant.law.roughness import profiles
from dynamics.compliant.law.tabulated import TabulatedLaw
from modal import SurfaceModes
from sonify.scene import Scene
from sonify.sound.block_overlap import overlapping_blocks
from sonify.sound.fades import raised_cosine
from sonify.sound.force import INTERPOLATION_STRIDE, LOW_PASS_HALF_WIDTH, ContactForce
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sound.sources.film import radiates_above_film
from sonify.sound.sources.protocol import (
    Advance,
    CompositeSource,
    ElasticDisk,
    Note,
    RigidDisk,
    SoundSource,
    SourceGroup,
    ignore_energy,
)

if TYPE_CHECKING:
    from sonify.sound.radiation import Listener


@dataclass(frozen=True, eq=False)
class ContactFilter:
    """Force that a compliant, rough contact adds to the force of a rigid motion.

    The force is sampled at start + n/sample_rate [s], like the contact force; it is
    zero before and after the motion.

    Attributes
    ----------
    motion : Motion
    tabulated_law : TabulatedLaw
        Tabulated law of the contact.
    profiles : tuple of Profile
        Height profiles of edge and table.
    sample_rate : int
        [Hz]
    start : float
        Time of sample 0 [s].
    table_modes : modal.SurfaceModes, optional
        Modes of a table that yields to the force.
    plate_mobility : float, optional
        Mobility of an infinite plate that yields to it [s/kg].
    """

    motion: Motion
    tabulated_law: TabulatedLaw
    profiles: tuple[Profile, Profile]
    sample_rate: int
    start: float
    table_modes: SurfaceModes | None = None
    plate_mobility: float = 0.0

    @classmethod
    def along(
        cls, motion: Motion, scene: Scene, sample_rate: int, start: float
    ) -> "ContactFilter":
        """Return the filter of the rough contact of a motion, with its table.

        Under a motion that was solved without the roughness of the scene, the table
        yields unless surface.action = 'sound'."""
        plan = motion.plan
        assert plan.tabulated_law is not None  # the contact is elastic
        yields = plan.filter_is_two_way
        if plan.scene.roughness != scene.roughness:
            yields = scene.surface.action != "sound"
        heights = profiles(scene.roughness, scene.disk.radius)
        return cls(
            motion,
            plan.tabulated_law,
            heights,
            sample_rate,
            start,
            plan.surface_modes if yields else None,
            plan.plate_mobility if yields else 0.0,
        )

    @property
    def oversampling(self) -> int:
        """Number of steps per sample required by the stiffest contact and by the height
        profiles."""
        # The contact ellipse averages out faster variations.
        min_profile_rate = 96e3  # 1/s
        needed = (
            required_step_rate(
                self.tabulated_law.law, np.array([MIN_CONTACT_INCLINATION])
            )[0]
            / MAX_PHASE_PER_STEP
        )
        return ceil(max(needed, min_profile_rate) / self.sample_rate)

    @property
    def first(self) -> int:
        """Index of the first sample within the motion."""
        return max(ceil(-self.start * self.sample_rate), 0)

    @property
    def end(self) -> float:
        """Last time [s] at which the contact area is still elliptical."""
        return float(
            self.motion.t[
                np.flatnonzero(self.motion.state[:, 1] >= MIN_CONTACT_INCLINATION)[-1]
            ]
        )

    def blocks(self) -> Iterator[np.ndarray]:
        """Yield blocks of the force (k, 2) [N] along a_2 and the normal, beginning at
        sample `first`.

        The force fades out at the end."""
        fade = 0.002  # s, a few periods of the contact resonance
        oversampling = self.oversampling
        rate = oversampling * self.sample_rate
        begin = self.start + self.first / self.sample_rate
        knots = motion_blocks(self.motion, rate, begin, self.end)
        if self.motion.plan.scene.surface.kind == "modes":  # they move with the disk
            knots = (block._replace(centre=np.zeros(2)) for block in knots)
        weight = windowed_sinc_taps(oversampling)
        past = np.zeros((len(weight) // 2 + 1, 2))
        count = 0
        for force in linear_contact_force_blocks(
            self.tabulated_law,
            knots,
            rate,
            self.profiles,
            self.table_modes,
            self.plate_mobility,
        ):
            t = begin + (count + 1 + np.arange(len(force))) / rate
            count += len(force)
            fading = raised_cosine((self.end - t) / fade)
            past = np.vstack([past, force * fading[:, None]])
            ready = decimate(past, weight, oversampling)
            yield ready
            past = past[len(ready) * oversampling :]
        yield decimate(
            np.vstack([past, np.zeros((len(weight), 2))]), weight, oversampling
        )


def windowed_sinc_taps(factor: int) -> np.ndarray:
    """Return the taps (2 factor LOW_PASS_HALF_WIDTH + 1,) of a windowed sinc for
    decimation by `factor`."""
    width = LOW_PASS_HALF_WIDTH
    distance = np.arange(-factor * width, factor * width + 1) / factor
    weight = np.sinc(distance) * np.cos(pi / 2 * distance / width) ** 2
    return weight / weight.sum()


def decimate(samples: np.ndarray, weight: np.ndarray, factor: int) -> np.ndarray:
    """Return every `factor`-th sample after filtering samples (n, c) by the taps
    `weight`.

    Samples with incomplete filter windows are dropped."""
    skipped = (len(weight) - 1) // factor
    complete = (len(samples) - len(weight)) // factor + 1
    return upfirdn(weight, samples, 1, factor, axis=0)[skipped : skipped + complete]


def superposed_part(scene: Scene, motion: Motion) -> Motion | None:
    """Return the part of a motion on which the vibration of its contact is superposed.

    It is the rolling motion, or its part before a rough contact is handed over to time
    steps; None if the whole motion includes the vibration."""
    rolling = motion.rolling
    if motion.vibration_crossover is None:
        return rolling
    first = rolling.parts[0].motion
    is_handed_over = scene.roughness is not None and first.vibration_crossover is None
    return first if is_handed_over else None


class ContactVibration(SoundSource):
    """Vibration superposed on a rigid motion.

    A ContactFilter drives the rigid disk, its modes and the table. The internal blocks
    are those of the filter, so the result is bit-identical for all block sizes."""

    names = ("contact",)
    channel_ends = np.zeros((0, 2))
    tail_duration = 0.0

    def __init__(self, scene: Scene, motion: Motion, *moved: SoundSource) -> None:
        part = superposed_part(scene, motion) or motion.rolling
        self._motion = motion
        self._filter_from = partial(
            ContactFilter.along, part, scene, scene.audio.sample_rate
        )
        self._group = SourceGroup(moved)
        self._vibrating = moved[0]
        self.latency = self._group.latency

    def input_channels(
        self, force: np.ndarray, state: np.ndarray, film: np.ndarray
    ) -> np.ndarray:
        """Return an empty array (k, 0), because the filter provides the force."""
        return np.zeros((len(force), 0))

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the pressure (k, 1) [Pa] of successive
        blocks."""
        pressure = None
        held = np.zeros((0, 1))

        def advance(force: ContactForce) -> np.ndarray:
            nonlocal pressure, held
            if pressure is None:
                added = self._filter_from(float(force.t[0]))
                pressure = self._pressure(added)
                held = np.zeros((added.first, 1))
            while len(held) < len(force.t) - 1:
                held = np.vstack([held, next(pressure)])
            out, held = np.split(held, [len(force.t) - 1])
            return out

        return advance

    def _pressure(self, added: ContactFilter) -> Iterator[np.ndarray]:
        """Yield the pressure (k, 1) [Pa] in the blocks of a ContactFilter."""
        renderers = self._group.simultaneous_renderers(
            np.zeros(len(self._group.channel_ends)),
            [ignore_energy] * len(self._group.parts),
        )
        for t, force in _added_force_blocks(added):
            state, film = self._states_and_film(t)
            channels = self._group.input_channels(force, state, film)
            # The channels are affine in the force: subtract their values at zero force.
            unforced = self._vibrating.input_channels(0 * force, state, film)[:, :3]
            channels[:, : unforced.shape[1]] -= unforced
            driven = ContactForce.without_jumps(t, channels, np.zeros_like(channels))
            stems = [render(driven) for render in renderers]
            yield np.hstack(stems).sum(axis=1, keepdims=True)

    def _states_and_film(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the states (k, 11) and `Motion.film_loads` (k, 5) at t (k,) [s],
        interpolated from every INTERPOLATION_STRIDE-th time."""
        inside = np.clip(t, 0.0, self._motion.t[-1])
        nodes = np.append(inside[:-1:INTERPOLATION_STRIDE], inside[-1])
        state = self._motion.at(nodes)
        at_nodes = state, self._motion.film_loads(nodes, state)
        state, film = (
            np.column_stack([np.interp(inside, nodes, column) for column in rows.T])
            for rows in at_nodes
        )
        return state, film


def _added_force_blocks(
    added: ContactFilter,
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield times (k + 1,) [s] and additional contact forces (k + 1, 3) [N]
    indefinitely.

    The forces are zero after the motion."""
    silent_block = 1 << 14
    n = added.first
    last = np.zeros((0, 2))
    for block in chain(added.blocks(), repeat(np.zeros((silent_block, 2)))):
        force = np.vstack([last, block])
        t = added.start + (n + np.arange(len(force))) / added.sample_rate
        yield t, np.column_stack([np.zeros(len(force)), force])
        n += len(force) - 1
        last = force[-1:]


class SolvedContactVibration(CompositeSource):
    """Sound of a disk whose motion already includes the contact vibration.

    The part of each stem above `crossover` [Hz] is moved to the contact stem. If
    `vibrating` differs from `rigid`, it replaces `rigid` in that stem."""

    def __init__(
        self,
        rigid: SoundSource,
        elastic: SoundSource,
        vibrating: SoundSource,
        crossover: float,
        sample_rate: int,
    ) -> None:
        self._is_replaced = vibrating is not rigid
        replacing = [vibrating] if self._is_replaced else []
        names = (*rigid.names, *elastic.names, "contact")
        super().__init__(names, rigid, elastic, *replacing)
        self._rigid_stems = len(rigid.names)
        self._weight = windowed_sinc_taps(max(round(sample_rate / (2 * crossover)), 1))
        self.tail_duration = max(rigid.tail_duration, elastic.tail_duration)
        self.latency += len(self._weight) // 2

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, 5) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (c,)."""
        renderers = self._group.simultaneous_renderers(
            first, [note] * len(self._group.parts)
        )
        half = len(self._weight) // 2
        extend = overlapping_blocks(2 * half)

        def advance(force: ContactForce) -> np.ndarray:
            stems = extend(np.hstack([render(force) for render in renderers]))
            slow = oaconvolve(stems, self._weight[:, None], "valid", axes=0)
            fast = stems[half : len(stems) - half] - slow
            if self._is_replaced:
                slow = slow[:, :-1]
                fast = fast[:, self._rigid_stems :]
            return np.column_stack([slow, fast.sum(axis=1)])

        return advance


class HandedOverContactVibration(CompositeSource):
    """Sound of a disk whose contact vibration is superposed on the first part of the
    motion and solved in the rest.

    The superposed force ends with a fade at the hand-over; the table is at rest there
    under the weight, and the solved vibration rises within some periods."""

    def __init__(
        self, solved: SolvedContactVibration, superposed: ContactVibration
    ) -> None:
        super().__init__(solved.names, solved, superposed)

    def make_block_renderer(self, first: np.ndarray, note: Note) -> Advance:
        """Return a function that computes the stems (k, 5) [Pa] of successive blocks.

        Before the first block the channels have the values `first` (c,)."""
        notes = [note, ignore_energy]
        solved, superposed = self._group.simultaneous_renderers(first, notes)

        def advance(force: ContactForce) -> np.ndarray:
            stems = solved(force)
            stems[:, -1:] += superposed(force)
            return stems

        return advance


def vibrating_disk(
    scene: Scene, motion: Motion, listener: "Listener", rigid: RigidDisk
) -> VibratingDisk | RigidDisk:
    """Return the sound source of the vibration of the disk as a rigid body.

    It is `rigid` itself where no film of air, closed or open, is under the disk."""
    is_over_film = radiates_above_film(motion)
    if motion.rim_modes is not None:  # the open film under a rattling disk
        is_over_film = scene.air.pressure > 0
    return VibratingDisk(scene, listener) if is_over_film else rigid


def contact_sources(
    scene: Scene,
    motion: Motion,
    listener: "Listener",
    rigid: RigidDisk,
    elastic: ElasticDisk,
    *below: SoundSource,
) -> list[SoundSource]:
    """Return the sound sources of a disk, including its vibration on an elastic
    contact.

    The vibration is superposed on a rigid motion, extracted from a motion that includes
    it, or both in turn. If superposed, it also drives the table sources `below`."""
    if scene.contact.law == "rigid":
        return [rigid, elastic]
    vibrating = vibrating_disk(scene, motion, listener, rigid)
    sources: list[SoundSource] = [rigid, elastic]
    crossover = motion.vibration_crossover
    superposed = None
    if superposed_part(scene, motion) is not None:
        superposed = ContactVibration(scene, motion, vibrating, elastic, *below)
        if crossover is None:
            return [*sources, superposed]
    assert crossover is not None
    solved = SolvedContactVibration(
        rigid, elastic, vibrating, crossover, scene.audio.sample_rate
    )
    return [HandedOverContactVibration(solved, superposed) if superposed else solved]
