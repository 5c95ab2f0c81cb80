"""RESULT -> SENTENCES: what its pictures show, and from when on what is left out would count."""

from typing import TYPE_CHECKING

import numpy as np

from dynamics.film.acting import film_of
from dynamics.rates import nutation_frequency, precession_rate
from sonify.claims.two_ways import energy_budget, two_way
from sonify.hearing.loudness import level_db

if TYPE_CHECKING:
    from sonify.result import Result

BEFORE_THE_END = {
    "modes_take_little": "The modes of the disk act back on its motion",
    "table_takes_a_hundredth": "The table acts back on the motion",
}
"""Finding [s before the end] -> what is left out before and may not be from then on."""


def spectrogram(result: "Result") -> str:
    """Return what the spectrogram shows."""
    tone = None if result.heard is None else result.heard.tone
    rising = f", a tone that rises {tone.factor:.2g} times over the ridge that is heard" if tone else ""
    carriers = [f"{c.frequency:.0f} Hz" for c in (result.heard.lines if result.heard else [])]
    steady = f", steady tones at {', '.join(carriers)}" if carriers else ""
    return (
        f"Spectrogram of {result.scene.name}, 10 Hz to {result.sound.sample_rate / 2000:g} kHz over "
        f"{result.sound.duration:.1f} s{rising}{steady}; the motion ends at {result.sound.source_end:.2f} s."
    )


def stems(result: "Result") -> str:
    """Return what the picture of the causes shows."""
    peaks = sorted(result.sound.stem_peak.items(), key=lambda item: -item[1])
    told = [f"{name.replace('_', ' ')} {level_db(peak**2):.0f} dB" for name, peak in peaks]
    return f"Level of each cause over time, and how far it is above the threshold of hearing. Peaks: {', '.join(told)}."


def motion(result: "Result") -> str:
    """Return what the six curves of the motion show, from the first instant to the last."""
    solved, disk = result.motion, result.motion.disk
    state, load = solved.at(solved.t[[0, -1]]), solved.force(solved.t)[:, 2] / disk.weight
    (alpha, end), frequency = np.pi / 2 - state[:, 1], nutation_frequency(solved)[1] * disk.time_unit
    rate, reach = precession_rate(state) * disk.time_unit, np.abs(solved.state[:, 3:5]).max() / disk.radius
    rises = f"its frequency goes from {frequency[0]:.2g} to {frequency[-1]:.3g}; " if len(frequency) else ""
    return (
        f"Six curves over {solved.t[-1] / disk.time_unit:.0f} units of time: the angle to the upright goes from "
        f"{alpha:.3g} to {end:.3g} rad, flat is 1.571; the energy falls to {solved.energy(solved.t[-1:])[0]:.2g} J; "
        f"the normal force stays between {load.min():.2g} and {load.max():.2g} times the weight; {rises}the centre "
        f"stays within {reach:.2g} radii; the rate of precession goes from {rate[0]:.3g} to {rate[1]:.3g}."
    )


def energy(result: "Result") -> str:
    """Return what the picture of the energies shows: what the greatest losses are, and what sounds."""
    begin, end = two_way(result.motion)[1], result.motion.t[-1]
    lost = energy_budget(result.motion, np.array([begin, end])).lost
    told = [f"{name} {energy[-1]:.2g} J" for name, energy in sorted(lost.items(), key=lambda item: -item[1][-1])]
    return f"Energies of disk and table over the last {end - begin:.2g} s, and what was lost to {', '.join(told)}."


def modes(result: "Result") -> str:
    """Return what the picture of the modes shows."""
    found = result.modes
    told = [
        f"{f:.0f} Hz {kind} of order {n}" for f, kind, n in zip(found.frequency, found.family, found.order, strict=True)
    ]
    table = f", and of the table from {result.table.frequency[0]:.0f} Hz on" if result.table else ""
    return f"Shapes of {len(told)} modes of the disk: {', '.join(told[:12])}{', ...' if told[12:] else ''}{table}."


def not_from(result: "Result") -> list[str]:
    """Return from when on what the model leaves out may not be left out."""
    end, found = result.motion.t[-1], {finding.key: finding for finding in result.findings}
    told = [
        f"{what} from t = {end - found[key].value:.3f} s on, {found[key].measured} {found[key].unit}."
        for key, what in BEFORE_THE_END.items()
        if key in found and found[key].value > 0
    ]
    air = found.get("air_negligible")
    if air and air.value < 1 and not film_of(result.scene).film:
        told.append(f"The film of air takes 1 % of the power from t = {air.value * end:.3g} s on.")
    return told or ["Nothing that is left out reaches its bar in this run."]


PICTURES = {
    "spectrogram.png": (spectrogram, "The pressure at the listener in two bands; the solved rates drawn over."),
    "stems.png": (stems, "What can be heard: each cause of sound against the threshold of hearing."),
    "motion.png": (motion, "Figures 3 to 6 of the paper."),
    "energy.png": (energy, "Where the energy is and goes while the table acts back."),
    "modes.png": (
        modes,
        "The modes: the whole body exaggerated, and the axial motion of its upper face with the nodal lines; below, "
        "those of the table, if it has any.",
    ),
}
"""File -> what it shows, a function of the result, and its caption."""
