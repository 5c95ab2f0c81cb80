"""RESULT -> FINDINGS: what others than the paper said of the sound and of the end of the motion."""

import numpy as np
from scipy.ndimage import median_filter

from dynamics import Motion
from dynamics.coupled.state import CAUSES
from modal import Modes
from sonify.claims.motion import Finding
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
    return [slip_is_the_loss(motion), *([impacts_are_not_the_loss(motion)] if lossy else [])]


def slip_is_the_loss(motion: Motion) -> Finding:
    """The share of the energy lost that is lost while the disk slides: at least what friction takes."""
    middle = (motion.t[1:] + motion.t[:-1]) / 2
    lost = np.diff(motion.state[:, 10])
    share = lost[np.char.startswith(motion.regime(middle), "slide")].sum() / lost.sum()
    margin = 0.0
    if hasattr(motion, "lost"):  # slips shorter than the pieces: what slip itself took is told apart
        causes = motion.lost(motion.t[-1:])[0]
        margin = abs(causes[SLIP] / causes.sum() - share)
    return Finding(
        key="slip_is_the_loss",
        claim="Slip is the main loss",
        value=float(share),
        unit="of the energy lost, while the disk slides",
        at_least=0.5,
        margin=float(margin),
        source="Caps et al. (2004)",
    )


def impacts_are_not_the_loss(motion) -> Finding:
    """The share of the energy lost that the compressed contact takes, in impacts and without."""
    lost = motion.lost(motion.t[-1:])[0]
    return Finding(
        key="impacts_are_not_the_loss",
        claim="Impacts are not what ends the motion",
        value=float(lost[0] / lost.sum()),
        unit="of the energy lost, in the compression of the contact",
        at_most=0.5,
        source="Baranyai & Varkonyi (2017)",
    )


def force_peaks_sound(motion: Motion, sound: Sound) -> Finding:
    """The correlation of the level of the sound with the normal force, both without their slow course."""
    delay = sound.source_end - motion.t[-1]
    seen = spectrogram(sound.pressure, ENVELOPE, columns=1 << 20, span=(delay, sound.source_end))
    level = np.log(seen.power[seen.frequency > FROM].sum(axis=0))
    t = np.clip(seen.time - delay, 0.0, motion.t[-1])
    load = motion.steady_load(t) if hasattr(motion, "steady_load") else motion.force(t)[:, 2]
    swings = [row - median_filter(row, SLOW) for row in (level, load)]
    return Finding(
        key="force_peaks_sound",
        claim="The peaks of the normal force are the peaks of the sound",
        value=float(np.corrcoef(swings)[0, 1]),
        unit="correlation of level and normal force",
        at_least=0.5,
        margin=2 / np.sqrt(len(t) / SLOW),
        source="Saje & Zupan (2006)",
    )


def deformation_makes_the_tone(sound: Sound) -> Finding:
    """The level of the modes that the smooth force moves over that of everything else, in the last second [dB(A)]."""
    power = {name: weighted_power(sound, stem) for name, stem in sound.stems.items()}
    bending = power.pop("ringing_smooth")
    return Finding(
        key="deformation_makes_the_tone",
        claim="The disk that deforms transversely makes the rising tone by itself",
        value=float(level_db(bending) - level_db(sum(power.values()))),
        unit="dB(A), modes moved by the smooth force over all other causes",
        at_least=0.0,
        source="Villanueva & Epstein (2005)",
    )


def mode_ratio(modes: Modes) -> Finding:
    """The ratio of the frequencies of the first two modes of the free disk that differ in their order."""
    first = modes.frequency[0]
    second = modes.frequency[modes.order != modes.order[0]][0]
    return Finding(
        key="mode_ratio",
        claim="The highest recorded peaks, 10.945 and 17.438 kHz, are the first two modes of the free disk",
        value=float(second / first),
        unit="ratio of the first two free modes",
        at_least=17438 / 10945,
        at_most=17438 / 10945,
        tolerance=0.03,
        source="recordings of the toy on granite, 2026",
    )
