"""RESULT -> FINDINGS: what others than the paper said of the sound and of the end of the motion."""

import numpy as np
from scipy.ndimage import median_filter

from dynamics import Motion
from dynamics.coupled.state import CAUSES
from modal import Modes
from sonify.claims.motion import Finding, finding
from sonify.claims.sound import weighted_power
from sonify.hearing.loudness import level_db
from sonify.hearing.spectrogram import spectrogram
from sonify.scene import Scene
from sonify.sound.pressure import Sound

ENVELOPE, FROM = 0.01, 700.0
"""Window of the envelope of the sound [s], and above which frequency [Hz] it is taken."""
SLIP = CAUSES.index("slip")
SLOW = 101
"""Readings of the envelope over which its slow course is taken out."""


def literature_findings(scene: Scene, motion: Motion, modes: Modes, sound: Sound) -> list[Finding]:
    """The claims of other authors that this run can judge: on impacts where contact is lost, on peaks of the force
    where roughness sounds, on modes where they are those of the free disk."""
    found = motion_findings(motion)
    found += [force_peaks_sound(motion, sound)] if scene.contact.law == "elastic" and scene.roughness else []
    found += [deformation_makes_the_tone(sound)] if motion.outcome.name == "SETTLED" else []
    return found + ([mode_ratio(modes)] if scene.support.kind == "free" and len(set(modes.order)) > 1 else [])


def motion_findings(motion: Motion) -> list[Finding]:
    """Those of them that the motion alone can judge."""
    lossy = motion.contact_losses and hasattr(motion, "lost")
    slips = [slip_is_the_loss(motion)] if motion.state[-1, 10] > 0 else []
    return slips + ([impacts_are_not_the_loss(motion)] if lossy else [])


@finding("Slip is the main loss", "of the energy lost, while the disk slides", "Caps et al. (2004)", at_least=0.5)
def slip_is_the_loss(motion: Motion):
    """The share of the energy lost that is lost while the disk slides: at least what friction takes."""
    middle = (motion.t[1:] + motion.t[:-1]) / 2
    lost = np.diff(motion.state[:, 10])
    share = lost[np.char.startswith(motion.regime(middle), "slide")].sum() / lost.sum()
    margin = 0.0
    if hasattr(motion, "lost"):  # slips shorter than the pieces: what slip itself took is told apart
        causes = motion.lost(motion.t[-1:])[0]
        margin = abs(causes[SLIP] / causes.sum() - share)
    return share, margin


@finding(
    "Impacts are not what ends the motion",
    "of the energy lost, in the compression of the contact",
    "Baranyai & Varkonyi (2017)",
    at_most=0.5,
)
def impacts_are_not_the_loss(motion):
    """The share of the energy lost that the compressed contact takes, in impacts and without."""
    lost = motion.lost(motion.t[-1:])[0]
    return lost[0] / lost.sum()


@finding(
    "The peaks of the normal force are the peaks of the sound",
    "correlation of level and normal force",
    "Saje & Zupan (2006)",
    at_least=0.5,
)
def force_peaks_sound(motion: Motion, sound: Sound):
    """The correlation of the level of the sound with the normal force, both without their slow course."""
    delay = sound.source_end - motion.t[-1]
    seen = spectrogram(sound.pressure, ENVELOPE, columns=1 << 20, span=(delay, sound.source_end))
    power = seen.power[seen.frequency > FROM].sum(axis=0)
    sounds = power > 0
    level, t = np.log(power[sounds]), np.clip(seen.time[sounds] - delay, 0.0, motion.t[-1])
    load = motion.steady_load(t) if hasattr(motion, "steady_load") else motion.force(t)[:, 2]
    swings = [row - median_filter(row, SLOW) for row in (level, load)]
    return np.corrcoef(swings)[0, 1], 2 / np.sqrt(len(t) / SLOW)


@finding(
    "The disk that deforms transversely makes the rising tone by itself",
    "dB(A), modes moved by the smooth force over all other causes",
    "Villanueva & Epstein (2005)",
    at_least=0.0,
)
def deformation_makes_the_tone(sound: Sound):
    """The level of the modes that the smooth force moves over that of everything else, in the last second [dB(A)]."""
    power = {name: weighted_power(sound, stem) for name, stem in sound.stems.items()}
    bending = power.pop("ringing_smooth")
    return level_db(bending) - level_db(sum(power.values()))


@finding(
    "The highest recorded peaks, 10.945 and 17.438 kHz, are the first two modes of the free disk",
    "ratio of the first two free modes",
    "recordings of the toy on granite, 2026",
    at_least=17438 / 10945,
    at_most=17438 / 10945,
    tolerance=0.03,
)
def mode_ratio(modes: Modes):
    """The ratio of the frequencies of the first two modes of the free disk that differ in their order."""
    first = modes.frequency[0]
    second = modes.frequency[modes.order != modes.order[0]][0]
    return second / first
