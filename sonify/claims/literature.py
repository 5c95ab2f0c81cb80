"""Findings on claims of other authors about the sound and the end of the motion."""

import numpy as np
from scipy.ndimage import median_filter

from dynamics import Motion
from modal import Modes
from sonify.claims.finding import Finding, Measured, finding
from sonify.claims.reference_scenes import is_toy_disk
from sonify.claims.rigid_motion import nutates_while_declining, stays_in_contact
from sonify.claims.sound import weighted_power
from sonify.hearing.loudness import level_db
from sonify.hearing.settling.settling_law import SettlingLaw
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound


def literature_findings(
    scene: Scene,
    motion: Motion,
    modes: Modes,
    sound: Sound,
    tone: SettlingLaw | None,
) -> list[Finding]:
    """Return the findings on claims of other authors that apply to this run.

    The claim on impacts needs losses of contact. The claim on force peaks needs
    roughness on an elastic contact and a force with peaks, that of a disk that stays in
    contact and nutates. The claim on the rising `tone` needs this tone, and the claim
    on recorded modes needs the recorded disk without a support."""
    found = motion_findings(motion)
    rough = scene.contact.law == "elastic" and scene.roughness is not None
    if rough and stays_in_contact(motion) and nutates_while_declining(motion):
        found.append(force_peaks_sound(motion, sound))
    if tone is not None and motion.rolling_outcome.name == "SETTLED":
        found.append(deformation_makes_the_tone(sound))
    is_recorded = scene.support.kind == "free" and is_toy_disk(scene.disk)
    if is_recorded and len(set(modes.order)) > 1:
        found.append(mode_ratio(modes))
    return found


def motion_findings(motion: Motion) -> list[Finding]:
    """Return the findings on claims of other authors that follow from the motion
    alone."""
    if not motion.state[-1, 10] > 0:
        return []
    impacts = [impacts_are_not_the_loss(motion)] if motion.contact_losses else []
    return [slip_is_the_loss(motion), *impacts]


@finding(needs=("motion",), at_least=0.5)
def slip_is_the_loss(motion: Motion) -> float | Measured:
    """The share of the energy lost while the disk slides, an upper bound on that of
    sliding friction.

    A motion that solves the contact gives the work of sliding friction itself, also in
    slips shorter than a piece."""
    if motion.solves_contact:
        taken = energy_lost_by_cause(motion)
        return Measured(taken["slip"] / sum(taken.values()), variant="solved")
    middle = (motion.t[1:] + motion.t[:-1]) / 2
    lost = np.diff(motion.state[:, 10])
    return lost[np.char.startswith(motion.regime(middle), "slide")].sum() / lost.sum()


@finding(needs=("motion",), at_most=0.5)
def impacts_are_not_the_loss(motion: Motion) -> Measured:
    """The share of the energy loss due to compression of the contact, with or without
    impacts.

    A motion that starts with a rigid contact loses no energy by compression before the
    switch to an elastic contact. The energy change at this switch has no assigned
    cause; its share is the margin."""
    lost = motion.state[-1, 10]
    taken = energy_lost_by_cause(motion)
    return Measured(taken["contact"] / lost, abs(sum(taken.values()) - lost) / lost)


def energy_lost_by_cause(motion: Motion) -> dict[str, float]:
    """Return the energy [J] lost in the whole motion, by cause."""
    return {
        cause: float(taken[0])
        for cause, taken in motion.energy_lost(motion.t[-1:]).items()
    }


@finding(needs=("motion", "sound"), at_least=0.5)
def force_peaks_sound(motion: Motion, sound: Sound) -> Measured:
    """The correlation of sound level and normal force after removal of slow
    variations."""
    smoothing_samples = 101  # of the median filter that removes slow variations
    window_duration = 0.01  # s
    lowest_frequency = 700.0  # Hz
    delay = sound.source_end - motion.t[-1]
    seen = spectrogram(
        sound.pressure, window_duration, columns=1 << 20, span=(delay, sound.source_end)
    )
    power = seen.power[seen.frequency > lowest_frequency].sum(axis=0)
    sounds = power > 0
    level = np.log(power[sounds])
    t = np.clip(seen.time[sounds] - delay, 0.0, motion.t[-1])
    load = motion.steady_load(t)
    if len(t) < smoothing_samples:
        return Measured(0.0, 1.0, undecided_because="the sound is too short")
    swings = [row - median_filter(row, smoothing_samples) for row in (level, load)]
    if min(map(np.ptp, swings)) == 0:
        return Measured(
            0.0, 1.0, undecided_because="the level or the force does not vary"
        )
    return Measured(np.corrcoef(swings)[0, 1], 2 / np.sqrt(len(t) / smoothing_samples))


@finding(needs=("sound",), at_least=0.0)
def deformation_makes_the_tone(sound: Sound) -> float:
    """The level of the modes driven by the smooth force relative to all other sound in
    the last second [dB(A)]."""
    power = {name: weighted_power(sound, [stem]) for name, stem in sound.stems.items()}
    bending = power.pop("ringing_smooth")
    return level_db(bending) - level_db(sum(power.values()))


@finding(
    needs=("modes",), at_least=17438 / 10945, at_most=17438 / 10945, tolerance=0.03
)
def mode_ratio(modes: Modes) -> float:
    """The frequency ratio of the first two modes of the free disk with different
    orders."""
    second = modes.frequency[modes.order != modes.order[0]][0]
    return second / modes.frequency[0]
