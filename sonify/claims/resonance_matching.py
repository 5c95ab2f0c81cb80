"""Matching of spectral lines to the resonances of disk, contact and table."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import law_table
from dynamics.compliant.model_selection import steady_precession_rate
from modal import eigenmodes
from modal.tabletop.solve import surface_modes
from sonify.hearing.spectral_lines import SpectralLine
from sonify.scene import Scene

MAX_MATCH_DISTANCE = 50.0
"""Distance [cents] below which a spectral line matches a resonance."""
MIN_RESONANCE_INCLINATION = 0.003
"""Smallest inclination at which the contact resonance is computed [rad]."""


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
    down to MIN_RESONANCE_INCLINATION."""
    found = [("disk", f) for f in eigenmodes(scene).frequency]
    table = surface_modes(scene)
    found += [("table", f) for f in table.frequency] if table is not None else []
    return found + [
        ("contact", f)
        for f in (_contact_resonances(scene) if scene.contact.law == "elastic" else ())
    ]


def nearest_resonance(
    line: SpectralLine, known: list[tuple[str, float]]
) -> Match | None:
    """Return the resonance nearest to a spectral line; None if it is beyond
    MAX_MATCH_DISTANCE."""
    matches = [
        Match(of, float(f), float(1200 * np.log2(line.frequency / f)))
        for of, f in known
    ]
    best = min(matches, key=lambda match: abs(match.cents), default=None)
    return best if best is not None and abs(best.cents) < MAX_MATCH_DISTANCE else None


def _contact_resonances(scene):
    resonance_inclination_count = 40
    disk = scene.disk
    beta = np.geomspace(
        MIN_RESONANCE_INCLINATION,
        max(np.radians(scene.release.inclination_deg), 2 * MIN_RESONANCE_INCLINATION),
        resonance_inclination_count,
    )
    speed = np.array([steady_precession_rate(scene, b) for b in beta]) * disk.radius
    return (
        law_table(scene)
        .contact_resonance(
            beta, np.full(resonance_inclination_count, disk.weight), speed
        )
        .frequency
    )
