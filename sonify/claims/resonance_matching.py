"""CARRIERS + SCENE -> MATCHES: which resonance of disk, contact or table a carrier is near."""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import law_table
from dynamics.compliant.model_selection import steady_rate
from modal import eigenmodes
from modal.tabletop.solve import surface_modes
from sonify.hearing.spectral_lines import Carrier
from sonify.scene import Scene

NEAR = 50.0
"""A carrier is so many cents from a resonance at most to be matched."""
FLATTEST, PLACES = 0.003, 40
"""The least inclination [rad] at which the contact is looked at, from that of the release on at so
many."""


class Match(NamedTuple):
    """The resonance nearest to a carrier: of what, its frequency [Hz], and by how much the carrier
    is above it [cents]."""

    of: str
    frequency: float
    cents: float


def resonances(scene: Scene) -> list[tuple[str, float]]:
    """Return what resounds in a scene, and its frequency [Hz]: modes of the disk and of the table
    as they are solved, the contact under the weight from the release to FLATTEST."""
    found = [("disk", f) for f in eigenmodes(scene).frequency]
    table = surface_modes(scene)
    found += [("table", f) for f in table.frequency] if table is not None else []
    return found + [
        ("contact", f) for f in (_contact(scene) if scene.contact.law == "elastic" else ())
    ]


def matched(carrier: Carrier, known: list[tuple[str, float]]) -> Match | None:
    """Return the nearest of known resonances; None if none is near."""
    apart = [Match(of, float(f), float(1200 * np.log2(carrier.frequency / f))) for of, f in known]
    best = min(apart, key=lambda match: abs(match.cents), default=None)
    return best if best is not None and abs(best.cents) < NEAR else None


def _contact(scene):
    disk = scene.disk
    beta = np.geomspace(
        FLATTEST, max(np.radians(scene.release.inclination_deg), 2 * FLATTEST), PLACES
    )
    speed = np.array([steady_rate(disk, b) for b in beta]) * disk.radius
    return law_table(scene).carrier(beta, np.full(PLACES, disk.weight), speed).frequency
