"""SPECTRAL LINES + SCENE -> MATCHES: the resonance of disk, contact or table nearest to a line."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import law_table
from dynamics.compliant.model_selection import steady_rate
from modal import eigenmodes
from modal.tabletop.solve import surface_modes
from sonify.hearing.spectral_lines import Carrier
from sonify.scene import Scene

MAX_MATCH_DISTANCE = 50.0
"""Distance [cents] below which a spectral line matches a resonance."""
MIN_RESONANCE_INCLINATION = 0.003
"""Smallest inclination at which the contact resonance is computed [rad]."""
RESONANCE_INCLINATIONS = 40


class Match(NamedTuple):
    """The resonance nearest to a spectral line: its owner ("disk", "table" or "contact"), its
    frequency [Hz], and the distance of the line above it [cents].
    """

    of: str
    frequency: float
    cents: float


def resonances(scene: Scene) -> list[tuple[str, float]]:
    """Return the owner and frequency [Hz] of each resonance in a scene.

    These are the modes of the disk, those of the table, and the contact resonance under the weight
    at inclinations from the release down to MIN_RESONANCE_INCLINATION.
    """
    found = [("disk", f) for f in eigenmodes(scene).frequency]
    table = surface_modes(scene)
    found += [("table", f) for f in table.frequency] if table is not None else []
    return found + [
        ("contact", f)
        for f in (_contact_resonances(scene) if scene.contact.law == "elastic" else ())
    ]


def nearest_resonance(carrier: Carrier, known: list[tuple[str, float]]) -> Match | None:
    """Return the known resonance nearest to a spectral line, or None if none is within MAX_MATCH_DISTANCE."""
    apart = [Match(of, float(f), float(1200 * np.log2(carrier.frequency / f))) for of, f in known]
    best = min(apart, key=lambda match: abs(match.cents), default=None)
    return best if best is not None and abs(best.cents) < MAX_MATCH_DISTANCE else None


def _contact_resonances(scene):
    disk = scene.disk
    beta = np.geomspace(
        MIN_RESONANCE_INCLINATION,
        max(np.radians(scene.release.inclination_deg), 2 * MIN_RESONANCE_INCLINATION),
        RESONANCE_INCLINATIONS,
    )
    speed = np.array([steady_rate(disk, b) for b in beta]) * disk.radius
    return (
        law_table(scene)
        .carrier(beta, np.full(RESONANCE_INCLINATIONS, disk.weight), speed)
        .frequency
    )
