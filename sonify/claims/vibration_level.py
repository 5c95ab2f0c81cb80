"""Level of the vibrations in the last second of a motion, without rendering the whole sound.

The sound sources of a run are driven by the contact force of the last seconds only. The
absorption of the air on the way to the listener is neglected; it is below 0.3 dB at 0.5 m
in the audible range.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy.signal import sosfilt

from dynamics import Motion
from modal import Modes, SurfaceModes
from sonify.claims.finding import Measured, finding
from sonify.claims.sound import FINAL_INTERVAL_DURATION
from sonify.hearing.audio_source import BLOCK_SIZE
from sonify.hearing.loudness import level_db, levels_above_threshold
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.force import ForceSampler
from sonify.sound.playback import a_weighting
from sonify.sound.pressure import Sound, Track
from sonify.sound.radiation import listener_of
from sonify.sound.radiators import RigidFace
from sonify.sound.sources.contact import ContactVibration, vibrating_disk
from sonify.sound.sources.contact_vibration import VibratingDisk
from sonify.sound.sources.film import disk_sources
from sonify.sound.sources.infinite_plate import table_sources
from sonify.sound.sources.protocol import SoundSource, SourceGroup, ignore_energy

RIGID_STEMS = ("heave", "tilt", VibratingDisk.names[0])
"""Stems of the rigid motion of the disk; all others are vibrations."""
SETTLING_TIME = 0.5
"""Time [s] before the last second in which filters and modes forget their start."""

LEVEL_ERROR = 0.5
"""Bound on the error of the level [dB] against the rendered sound."""


class SoundingModes(NamedTuple):
    """Modes whose sound is computed.

    Attributes
    ----------
    disk : Modes
        Modes of the disk.
    chosen : array of int, shape (m,)
        Indices of the modes of the disk that may be heard.
    table : SurfaceModes or None
        Modes of the table that may be heard; None if the table has no modes.
    max_contact_turn : float
        Argument of `sonify.sound.force.ForceSampler` [rad].
    """

    disk: Modes
    chosen: np.ndarray
    table: SurfaceModes | None
    max_contact_turn: float


class FinalStems(NamedTuple):
    """Sound up to the end of the rolling motion.

    Attributes
    ----------
    stems : dict of str to ndarray, shape (k,)
        Stems [Pa] by name.
    rate : int
        Sample rate [Hz].
    last : int
        Number of final samples that are judged; the others are for filters to forget their start.
    """

    stems: dict[str, np.ndarray]
    rate: int
    last: int


@finding(needs=("scene", "motion", "modes"), at_least=0.0)
def vibrations_make_sound(final: FinalStems) -> Measured:
    """The smaller of two levels [dB] of the vibrations in the last second of rolling.

    One is their A-weighted level relative to the rigid motion of the disk, the other their
    greatest third-octave level above the threshold of hearing: the vibrations make the
    sound if they are louder than the rigid motion, and audible."""
    rigid, vibrating = (
        sum_of_stems(
            final, [name for name in final.stems if (name in RIGID_STEMS) is is_rigid]
        )
        for is_rigid in (True, False)
    )
    power = [
        float(np.mean(sosfilt(a_weighting(final.rate), pressure)[-final.last :] ** 2))
        for pressure in (vibrating, rigid)
    ]
    louder = float(np.subtract(*level_db(power)))
    audible = level_above_threshold(vibrating[-final.last :], final.rate)
    details = {"louder": louder, "audible": audible}
    return Measured(min(louder, audible), LEVEL_ERROR, details)


def sum_of_stems(final: FinalStems, names: list[str]) -> np.ndarray:
    """Return the sum (k,) [Pa] of some stems."""
    silence = np.zeros(len(next(iter(final.stems.values()))))
    return np.sum([silence, *(final.stems[name] for name in names)], axis=0)


def rendered_final_stems(sound: Sound) -> FinalStems:
    """Return the end of a rendered sound, without the tail after the rolling motion."""
    rate = sound.sample_rate
    end = int(sound.source_end * rate)
    last = min(round(FINAL_INTERVAL_DURATION * rate), end)
    begin = max(end - last - round(SETTLING_TIME * rate), 0)
    stems = {
        name: stem.read(begin, end).astype(float) for name, stem in sound.stems.items()
    }
    return FinalStems(stems, rate, last)


def level_above_threshold(pressure: np.ndarray, rate: int) -> float:
    """Return the greatest third-octave level [dB] of a pressure (k,) [Pa] above the threshold
    of hearing."""
    window = 0.2  # s
    track = Track(sample_rate=rate, columns=pressure[:, None], column=0)
    seen = spectrogram(track, window)
    return float(levels_above_threshold(seen).max())


def final_stems(scene: Scene, motion: Motion, sounding: SoundingModes) -> FinalStems:
    """Return the sound at the listener up to the end of the rolling motion.

    It begins SETTLING_TIME before the last second, or at the release."""
    sources = sources_of_motion(scene, motion, sounding)
    group = SourceGroup(sources)
    rate = scene.audio.sample_rate
    end = float(motion.rolling.t[-1])
    latency = group.latency / rate
    begin = max(end - FINAL_INTERVAL_DURATION - SETTLING_TIME, 0.0)
    rest, fade = group.channel_ends.T
    sampler = ForceSampler(
        motion,
        rate,
        begin,
        group.input_channels,
        rest,
        sounding.max_contact_turn,
        fade,
    )
    count = round((end + latency - begin) * rate)
    rows = np.vstack(list(_stem_blocks(group, sampler, count)))
    names = [name for source in sources for name in source.names]
    delay = min(group.latency, len(rows) - 1)
    defined = while_contact_bears(rows[delay:].astype(float), rate)
    undefined = len(rows) - delay - len(defined)
    stems = dict(zip(names, defined.T, strict=True))
    last = round(min(FINAL_INTERVAL_DURATION, end) * rate) - undefined
    return FinalStems(stems, rate, last)


def while_contact_bears(rows: np.ndarray, rate: int) -> np.ndarray:
    """Return the stems (k, s) up to the time at which the air carries the whole disk.

    There the contact has no stiffness, and the filter of a rough contact no value. A disk
    on a concave table may sink for a tenth of a second. Raises ArithmeticError if half of
    the last second is undefined."""
    max_unloaded_time = FINAL_INTERVAL_DURATION / 2
    undefined = np.flatnonzero(~np.isfinite(rows).all(axis=1))
    if not len(undefined):
        return rows
    unloaded = (len(rows) - undefined[0]) / rate
    if unloaded > max_unloaded_time:
        raise ArithmeticError(
            f"the sound of the rough contact is undefined {unloaded:.2g} s before the end"
        )
    return rows[: undefined[0]]


def _stem_blocks(
    group: SourceGroup, sampler: ForceSampler, count: int
) -> Iterator[np.ndarray]:
    """Yield the stems (k, s) [Pa] of `count` samples in blocks."""
    first = sampler.block(0, 1).samples[0]
    renderers = group.simultaneous_renderers(first, [ignore_energy] * len(group.parts))
    for n in range(0, count, BLOCK_SIZE):
        force = sampler.block(n, min(BLOCK_SIZE, count - n))
        yield np.hstack([advance(force) for advance in renderers])


def sources_of_motion(
    scene: Scene, motion: Motion, sounding: SoundingModes
) -> list[SoundSource]:
    """Return the sound sources of a motion.

    The vibration that a rough contact adds to a motion solved without its roughness is a
    source of its own. A disk that rattles moves faster than it rotates."""
    listener = listener_of(scene)
    face = RigidFace(scene.disk, listener, 1 / scene.audio.sample_rate)
    modes = sounding.disk.select(sounding.chosen)
    rigid, elastic = disk_sources(scene, motion, modes, sounding.chosen, listener, face)
    tables = table_sources(scene, sounding.table, listener)
    if motion.rim_modes is not None:
        return [vibrating_disk(scene, motion, listener, rigid), elastic, *tables]
    sources: list[SoundSource] = [rigid, elastic, *tables]
    if is_rough_contact(scene, motion):
        vibrating = vibrating_disk(scene, motion, listener, rigid)
        sources.append(ContactVibration(scene, motion, vibrating, elastic, *tables))
    return sources


def is_rough_contact(scene: Scene, motion: Motion) -> bool:
    """Return True if the roughness of a scene excites a single elastic contact."""
    return (
        scene.roughness is not None
        and scene.contact.law == "elastic"
        and "contact" in motion.rolling.finding_groups
    )
