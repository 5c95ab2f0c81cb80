"""Describe the pictures of a result and the limits of its model in sentences.

A limit is the time after which an effect omitted by the model becomes significant.
"""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.motion import force_at_ends_and_middles
from dynamics.observables import nutation_frequency, precession_rate
from sonify.claims.details import unit_and_details
from sonify.claims.energy_causes import CAUSE_IN_WORDS
from sonify.claims.finding_texts import texts_with
from sonify.claims.two_way import energy_budget, two_way_part
from sonify.hearing.loudness import level_db

if TYPE_CHECKING:
    from sonify.result import Result


def describe_spectrogram(result: "Result") -> str:
    """Return a description of the spectrogram."""
    heard = result.heard
    tones = ""
    if heard and heard.tone and heard.tone.ridge:
        tones += f", a tone that rises by a factor of {heard.tone.ridge.factor:.2g}"
    if heard and heard.lines:
        frequencies = ", ".join(f"{line.frequency:.0f} Hz" for line in heard.lines)
        tones += f", steady tones at {frequencies}"
    sound = result.sound
    return (
        f"Spectrogram of {result.scene.name}, 10 Hz to {sound.sample_rate / 2000:g} kHz over "
        f"{sound.duration:.1f} s{tones}; the motion ends at {sound.source_end:.2f} s."
    )


def describe_stems(result: "Result") -> str:
    """Return a description of the picture of the stem levels."""
    peaks = sorted(result.sound.stem_peaks.items(), key=lambda item: -item[1])
    items = [
        f"{name.replace('_', ' ')} {level_db(peak**2):.0f} dB" for name, peak in peaks
    ]
    return (
        "Level of each cause of sound over time, and its level above the threshold of hearing. "
        f"Peaks: {', '.join(items)}."
    )


def describe_motion(result: "Result") -> str:
    """Return a description of the curves of the motion with their initial and final
    values."""
    solved = result.motion.rolling
    state = solved.at(solved.t[[0, -1]])
    first, last = np.degrees(state[:, 1])
    load = force_at_ends_and_middles(solved)[::2, 2]
    turns = np.abs(precession_rate(state)) / (2 * np.pi)
    reach = 1e3 * np.abs(solved.state[:, 3:5]).max()
    nutation = nutation_frequency(solved)[1]
    rises = ""
    if len(nutation):
        rises = f"; the nutation goes from {nutation[0]:.2g} to {nutation[-1]:.3g} Hz"
    return (
        f"Six curves over {solved.t[-1]:.4g} s: the inclination goes from {first:.3g} to "
        f"{last:.2g} degrees; the energy falls to {solved.energy(solved.t[-1:])[0]:.2g} J; the "
        f"normal force stays between {load.min():.2g} and {load.max():.2g} N, the weight is "
        f"{solved.disk.weight:.3g} N; the centre stays within {reach:.2g} mm; the precession goes "
        f"from {turns[0]:.3g} to {turns[1]:.3g} Hz{rises}."
    )


def describe_energy(result: "Result") -> str:
    """Return a description of the energy picture with the losses in descending
    order."""
    motion = result.motion.rolling
    begin = two_way_part(motion)[1]
    end = motion.t[-1]
    lost = energy_budget(motion, np.array([begin, end])).lost
    items = [
        f"{CAUSE_IN_WORDS[cause]} {energy[-1]:.2g} J"
        for cause, energy in sorted(lost.items(), key=lambda item: -item[1][-1])
    ]
    return f"Energies of disk and table over the last {end - begin:.2g} s, and losses to {', '.join(items)}."


def describe_modes(result: "Result") -> str:
    """Return a description of the figure of the modes."""
    found = result.modes
    items = [
        f"{f:.0f} Hz {kind} of order {n}"
        for f, kind, n in zip(found.frequency, found.family, found.order, strict=True)
    ]
    rendered = result.plan.rendered_table(result.table)
    table = (
        f", and of the table from {rendered.frequency[0]:.0f} Hz on" if rendered else ""
    )
    return f"Shapes of {len(items)} modes of the disk: {', '.join(items[:12])}{', ...' if items[12:] else ''}{table}."


def omitted_effects(result: "Result") -> list[str]:
    """Return one sentence for each omitted effect, with the time after which it is
    significant."""
    end = result.motion.rolling.t[-1]
    found = {finding.key: finding for finding in result.findings}
    items = [
        f"{what} from t = {end - found[key].value:.3f} s on, {found[key].measured} "
        f"{unit_and_details(found[key])}."
        for key, what in texts_with("omitted_effect").items()
        if key in found and found[key].value > 0
    ]
    air = found.get("air_negligible")
    if air and air.value < 1 and not result.motion.film:
        items.append(
            f"The air film dissipates 1 % of the power from t = {air.value * end:.3g} s on."
        )
    return items or ["No omitted effect is significant in this run."]


PICTURE_CAPTIONS = {
    "spectrogram.png": (
        describe_spectrogram,
        "The sound pressure at the listener in two frequency bands, with the computed frequencies.",
    ),
    "stems.png": (
        describe_stems,
        "The level of each cause of sound, and its level above the threshold of hearing.",
    ),
    "motion.png": (
        describe_motion,
        "The motion; light blue marks the range of oscillations. For the scene of the paper, its "
        "figures 3 to 6 are shown below.",
    ),
    "energy.png": (
        describe_energy,
        "Stored energies and losses during two-way coupling with the table.",
    ),
    "modes.png": (
        describe_modes,
        "The mode shapes: the whole body, exaggerated, and the axial motion of its upper face with "
        "nodal lines. Modes of the table, if any, are shown below.",
    ),
}
"""Description function and caption of each picture, by file name."""
