"""Findings on the table: its sound, and the onset of its reaction on the disk."""

import numpy as np

from dynamics import Motion
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from modal import SurfaceModes
from sonify.claims.coupling_level import coupling_error_is_predicted
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.sound import FINAL_INTERVAL_DURATION, rise_of, time_of_energy_share
from sonify.claims.table_power import disk_supplies_table, one_way_end
from sonify.claims.two_way import energy_budget, two_way_part
from sonify.hearing.loudness import (
    HANN_NOISE_BANDWIDTH_BINS,
    LEVEL_WINDOW_S,
    a_weighting_db,
    level_db,
)
from sonify.hearing.settling.detector import strongest_tone
from sonify.hearing.settling.settling_law import SettlingLaw
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound
from sonify.sound.radiation import Listener


def table_findings(
    scene: Scene,
    motion: Motion,
    sound: Sound,
    listener: Listener,
    tone: SettlingLaw | None,
    error: float = 0.0,
    table: SurfaceModes | None = None,
) -> list[Finding]:
    """Return the findings on a wavy table and on the sound of an elastic table.

    Claims about the energy of the table require one-way coupling, and claims about the
    end a disk that finally lies flat. `tone` is the rising tone of the whole sound, or
    None; `error` is the relative rms error of the sound; `table` has all modes of a table
    that is not infinite."""
    found = motion_findings(scene, motion)
    if "table" not in sound.names:
        return found
    # The contact stem of a rough elastic contact includes sound of the table.
    has_pure_table_stem = scene.roughness is None or scene.contact.law == "rigid"
    if has_pure_table_stem:
        found.append(table_is_louder(motion, sound, error))
    if one_way_end(motion) > 0:
        found.append(disk_supplies_table(scene, motion, table, listener))
    if motion.plan.filter_is_two_way:
        found.append(coupling_error_is_predicted(scene, motion))
    if two_way_part(motion):
        found.append(waves_become_heat(motion, sound, listener))
    elif sound.table_energy is not None:  # an infinite plate stores no energy
        found += [
            table_takes_little(motion, sound, error),
            table_takes_a_hundredth(motion, sound, error),
        ]
    if motion.rolling_outcome.lies_flat:
        tone_of_table = strongest_tone(sound.track("table"))
        if tone_of_table is not None:
            found.append(table_tone_rises(tone_of_table))
        if tone is not None and has_pure_table_stem:
            found.append(table_carries_the_tone(sound, tone, error))
    return found


def motion_findings(scene: Scene, motion: Motion) -> list[Finding]:
    """Return the findings that follow from the motion alone: none on a plane table."""
    return [waves_break_contact(scene, motion)] if scene.imperfection else []


@finding(needs=("scene", "motion"), at_least=0.7, at_most=1.8)
def waves_break_contact(scene: Scene, motion: Motion) -> float:
    """The ratio of the inclination at the first loss of contact to (n^2 - 1) delta/R,
    or 0.

    Below the inclination (n^2 - 1) delta/R a plane rim no longer fits into a trough:
    relative to a tilted plane, a wave h has the upward curvature h + h'' = (n^2 - 1)
    delta along the rim, and the rim of a disk at inclination beta has the curvature
    beta R."""
    lost = motion.contact_losses
    waves = scene.imperfection
    if not (lost and waves):
        return 0.0
    scale = (waves.order**2 - 1) * waves.amplitude / scene.disk.radius
    return float(motion.at([lost[0].t])[0, 1]) / scale


def stem_levels(sound: Sound, begin: float, end: float) -> dict[str, np.ndarray]:
    """Return the A-weighted mean square [Pa^2] of every stem in each second from
    `begin` to `end` [s]."""
    levels_per_second = 10
    found = {}
    for name, stem in sound.stems.items():
        # Shorter windows spread low tones to frequencies that A-weighting attenuates less.
        seen = spectrogram(stem, LEVEL_WINDOW_S, span=(begin, end))
        weights = 10 ** (a_weighting_db(seen.frequency) / 10)
        power = weights @ seen.power / HANN_NOISE_BANDWIDTH_BINS
        seconds = np.array_split(power, max(len(power) // levels_per_second, 1))
        found[name] = np.array([part.mean() for part in seconds])
    return found


@finding(needs=("motion", "sound"), at_least=0.0)
def table_is_louder(motion: Motion, sound: Sound, error: float = 0.0) -> Measured:
    """The median over the seconds of the motion of the table level relative to all
    other sound [dB(A)]."""
    levels = stem_levels(sound, sound.source_end - motion.t[-1], sound.source_end)
    table = levels.pop("table")
    louder = np.median(level_db(table) - level_db(sum(levels.values())))
    return Measured(louder, 20 * np.log10(1 + error))


@finding(needs=("sound",), at_least=2.0)
def table_tone_rises(tone: SettlingLaw) -> Measured:
    """The ratio of the final to the initial frequency of the rising tone in the stem of
    the table."""
    return rise_of(tone)


@finding(needs=("tone", "sound"), at_least=0.0)
def table_carries_the_tone(sound: Sound, tone: SettlingLaw, error: float) -> Measured:
    """The level of the table relative to all other sound, in the third-octave band of
    the tone during the last second [dB]."""
    window = LEVEL_WINDOW_S / 4
    begin = max(sound.source_end - FINAL_INTERVAL_DURATION, 0.0)
    third_octave_edge = 2 ** (1 / 6)  # over the centre
    power = {}
    for name, stem in sound.stems.items():
        seen = spectrogram(stem, window, span=(begin, sound.source_end))
        assert tone.t_end.value is not None, "the sound of a run is not cut"
        pitch = tone.rate(np.minimum(seen.time, tone.t_end.value - window / 2))
        distance = np.log(np.maximum(seen.frequency[:, None], 1e-9) / pitch)
        near = np.abs(distance) < np.log(third_octave_edge)
        power[name] = float((seen.power * near).sum())
    table = power.pop("table")
    louder = level_db(table) - level_db(sum(power.values()))
    return Measured(louder, 20 * np.log10(1 + error))


@finding(needs=("motion", "sound"), at_most=0.0)
def table_takes_little(motion: Motion, sound: Sound, error: float) -> Measured:
    """The time before the end [s] at which the energy of the table modes first exceeds
    that of the disk, for one-way coupling."""
    assert sound.table_energy is not None, "the table has modes"
    return time_of_energy_share(motion, sound.energy_time, sound.table_energy, error)


@finding(needs=("motion", "sound"), at_most=0.5)
def table_takes_a_hundredth(motion: Motion, sound: Sound, error: float) -> Measured:
    """The time before the end [s] at which the table modes first have MIN_RELEVANT_SHARE
    of the energy of the disk."""
    assert sound.table_energy is not None, "the table has modes"
    return time_of_energy_share(
        motion, sound.energy_time, sound.table_energy, error, MIN_RELEVANT_SHARE
    )


def radiated_power(sound: Sound, listener: Listener) -> tuple[np.ndarray, np.ndarray]:
    """Return times (e,) [s] and the power (e,) [W] radiated by the table.

    They cover the final seconds of the motion. The power is 2 pi r^2 p^2/(rho c), which
    assumes the pressure at the listener in all directions."""
    duration = 10.0  # s
    air = listener.air
    rate = sound.sample_rate
    first = int(max(sound.source_end - duration, 0.0) * rate)
    pressure = sound.track("table").read(first).astype(float)
    impedance = air.density * air.sound_speed
    per_square = 0.0  # nothing radiates in a vacuum
    if impedance:
        per_square = 2 * np.pi * listener.distance**2 / impedance
    power = per_square * pressure**2
    return (first + np.arange(len(power))) / rate - listener.delay, power


@finding(needs=("motion", "sound"), at_most=0.5)
def waves_become_heat(motion: Motion, sound: Sound, listener: Listener) -> Measured:
    """The ratio of radiated energy to energy lost by the table modes, with two-way
    coupling.

    The radiation is assumed equal in all directions, which is accurate to a factor of
    two."""
    heard = radiated_power(sound, listener)
    begin = max(heard[0][0], two_way_part(motion)[1])
    budget = energy_budget(motion, np.array([begin, motion.t[-1]]), heard)
    lost = budget.lost["table"][-1]
    share = budget.sound[-1] / lost if lost > 0 else 0.0
    return Measured(share, share)
