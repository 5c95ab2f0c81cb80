"""RESULT -> SENTENCES: descriptions of its pictures, and the limits of its model.

A limit is the time from which an effect that the model omits becomes significant.
"""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.film.activation import decide_film
from dynamics.observables import nutation_frequency, precession_rate
from sonify.claims.details import unit_and_details
from sonify.claims.two_way import energy_budget, two_way_part
from sonify.hearing.loudness import level_db

if TYPE_CHECKING:
    from sonify.result import Result

OMITTED_EFFECTS = {
    "modes_take_little": "The modes of the disk act back on its motion",
    "table_takes_a_hundredth": "The table acts back on the motion",
}
"""Key of a finding (a time before the end [s]) -> effect that is significant from then on."""


def spectrogram(result: "Result") -> str:
    """Return a description of the spectrogram."""
    tone = None if result.heard is None else result.heard.tone
    rising = (
        f", a tone that rises {tone.factor:.2g} times over the ridge that is heard" if tone else ""
    )
    carriers = [f"{c.frequency:.0f} Hz" for c in (result.heard.lines if result.heard else [])]
    steady = f", steady tones at {', '.join(carriers)}" if carriers else ""
    return (
        f"Spectrogram of {result.scene.name}, 10 Hz to {result.sound.sample_rate / 2000:g} kHz "
        f"over "
        f"{result.sound.duration:.1f} s{rising}{steady}; the motion ends at "
        f"{result.sound.source_end:.2f} s."
    )


def stems(result: "Result") -> str:
    """Return a description of the picture of the causes of sound."""
    peaks = sorted(result.sound.stem_peak.items(), key=lambda item: -item[1])
    items = [f"{name.replace('_', ' ')} {level_db(peak**2):.0f} dB" for name, peak in peaks]
    return (
        "Level of each cause over time, and how far it is above the threshold of hearing. "
        f"Peaks: {', '.join(items)}."
    )


def motion(result: "Result") -> str:
    """Return a description of the curves of the motion, with initial and final values."""
    solved = result.motion
    state = solved.at(solved.t[[0, -1]])
    first, last = np.degrees(state[:, 1])
    load = solved.force(solved.t)[:, 2]
    turns = np.abs(precession_rate(state)) / (2 * np.pi)
    reach = 1e3 * np.abs(solved.state[:, 3:5]).max()
    nutation = nutation_frequency(solved)[1]
    rises = (
        f"; the nutation goes from {nutation[0]:.2g} to {nutation[-1]:.3g} Hz"
        if len(nutation)
        else ""
    )
    return (
        f"Six curves over {solved.t[-1]:.4g} s: the inclination goes from {first:.3g} to "
        f"{last:.2g} degrees; "
        f"the energy falls to {solved.energy(solved.t[-1:])[0]:.2g} J; the normal force stays "
        f"between {load.min():.2g} "
        f"and {load.max():.2g} N, the weight is {solved.disk.weight:.3g} N; the centre stays "
        f"within {reach:.2g} mm; "
        f"the precession goes from {turns[0]:.3g} to {turns[1]:.3g} Hz{rises}."
    )


def energy(result: "Result") -> str:
    """Return a description of the energy picture: the losses, the greatest first."""
    begin = two_way_part(result.motion)[1]
    end = result.motion.t[-1]
    lost = energy_budget(result.motion, np.array([begin, end])).lost
    items = [
        f"{name} {energy[-1]:.2g} J"
        for name, energy in sorted(lost.items(), key=lambda item: -item[1][-1])
    ]
    return f"Energies of disk and table over the last {end - begin:.2g} s, and what was lost to {', '.join(items)}."


def modes(result: "Result") -> str:
    """Return a description of the picture of the modes."""
    found = result.modes
    items = [
        f"{f:.0f} Hz {kind} of order {n}"
        for f, kind, n in zip(found.frequency, found.family, found.order, strict=True)
    ]
    table = f", and of the table from {result.table.frequency[0]:.0f} Hz on" if result.table else ""
    return f"Shapes of {len(items)} modes of the disk: {', '.join(items[:12])}{', ...' if items[12:] else ''}{table}."


def omitted_effects(result: "Result") -> list[str]:
    """Return one sentence for each omitted effect, with the time from which it is significant."""
    end = result.motion.t[-1]
    found = {finding.key: finding for finding in result.findings}
    items = [
        f"{what} from t = {end - found[key].value:.3f} s on, {found[key].measured} "
        f"{unit_and_details(found[key])}."
        for key, what in OMITTED_EFFECTS.items()
        if key in found and found[key].value > 0
    ]
    air = found.get("air_negligible")
    if air and air.value < 1 and not decide_film(result.scene).film:
        items.append(f"The film of air takes 1 % of the power from t = {air.value * end:.3g} s on.")
    return items or ["Nothing that is left out reaches its bar in this run."]


PICTURES = {
    "spectrogram.png": (
        spectrogram,
        "The pressure at the listener in two bands; the solved rates drawn over.",
    ),
    "stems.png": (
        stems,
        "What can be heard: each cause of sound against the threshold of hearing.",
    ),
    "motion.png": (
        motion,
        "The motion. Light blue: the range of what oscillates; for the scene of the paper, its "
        "figures 3 to 6 below.",
    ),
    "energy.png": (energy, "Where the energy is and goes while the table acts back."),
    "modes.png": (
        modes,
        "The modes: the whole body exaggerated, and the axial motion of its upper face with the "
        "nodal lines; below, "
        "those of the table, if it has any.",
    ),
}
"""File name -> function from result to description, and caption."""
