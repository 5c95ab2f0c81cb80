"""Matching of spectral lines to the resonances of disk, contact and table."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import tabulated_contact_law
from dynamics.compliant.model_selection import steady_precession_rate
from modal import eigenmodes
from modal.tabletop.solve import surface_modes
from sonify.hearing.spectral_lines import SpectralLine
from sonify.scene import Scene


class Match(NamedTuple):
    """Resonance nearest to a spectral line.

    It belongs to `of` ("disk", "table" or "contact") and has a `frequency` [Hz];
    `cents` is the interval from it up to the line."""

    of: str
    frequency: float
    cents: float


def resonances(scene: Scene) -> list[tuple[str, float]]:
    """Return "disk", "table" or "contact" and the frequency [Hz] of each resonance of a
    scene.

    The contact resonance under the weight is computed for inclinations from the release
    downwards."""
    frequencies = {"disk": eigenmodes(scene).frequency}
    table = surface_modes(scene)
    if table is not None:
        frequencies["table"] = table.frequency
    if scene.contact.law == "elastic":
        frequencies["contact"] = _contact_resonances(scene)
    return [(of, f) for of, values in frequencies.items() for f in values]


def nearest_resonance(
    line: SpectralLine, known: list[tuple[str, float]]
) -> Match | None:
    """Return the resonance nearest to a spectral line; None if it is too far away."""
    max_match_distance = 50.0  # cents
    matches = [
        Match(of, float(f), float(1200 * np.log2(line.frequency / f)))
        for of, f in known
    ]
    near = [match for match in matches if abs(match.cents) < max_match_distance]
    return min(near, key=lambda match: abs(match.cents), default=None)


def _contact_resonances(scene: Scene) -> np.ndarray:
    min_inclination = 0.003  # rad
    inclination_count = 40
    disk = scene.disk
    release = np.radians(scene.release.inclination_deg)
    beta = np.geomspace(
        min_inclination, max(release, 2 * min_inclination), inclination_count
    )
    speed = np.array([steady_precession_rate(scene, b) for b in beta]) * disk.radius
    weight = np.full(inclination_count, disk.weight)
    return tabulated_contact_law(scene).contact_resonance(beta, weight, speed).frequency
