"""SCENE, MODES OF ITS TABLE -> from which inclination on the table acts back on the disk."""

from math import radians
from typing import NamedTuple

import numpy as np

from ..dissipation import resistance
from ..equations import law_of
from ..surface import ACTS
from ..time_left import steady_power
from .choice import steady_rate
from .from_scene import contact_law
from .march import LIES

PLACES, AROUND = 200, 64
"""Inclinations at which that is asked, and places of the rim."""


class Acting(NamedTuple):
    """Whether the table acts back in this scene, from which inclination [rad] on it would (0: never), why, and why it
    does not act in spite of it."""

    acts: bool
    inclination: float
    reason: str
    unsolved: str = ""


def acting(scene, modes) -> Acting:
    """Return the `Acting` of a scene on a table of these modes (`modal.SurfaceModes`), where surface.action = 'auto'.

    Asked of the steady motion, its centre where the disk is at the release, its force the weight. Two ways are
    solved with an elastic contact from there on.
    """
    beta, energy, power = shares(scene, modes)
    more = np.flatnonzero((energy > ACTS) | (power > ACTS))
    if not len(more):
        return Acting(False, 0.0, f"its energy and its wave drag stay below {ACTS:.0%} of the rest")
    since = more[0]
    what = "energy" if energy[since] > ACTS else "wave drag"
    whose = "disk's" if what == "energy" else "friction's"
    reason = f"its {what} passes {ACTS:.0%} of the {whose} at {beta[since]:.2g} rad"
    wrong = unsolved(scene)
    return Acting(not wrong, float(beta[since]), reason, wrong)


def unsolved(scene) -> str:
    """Return why the table of a scene cannot act back, whatever its modes; nothing if it can."""
    if scene.surface.kind in ("rigid", "infinite"):
        return f"surface.kind = '{scene.surface.kind}': a table that acts back must have modes"
    if scene.roughness and scene.surface.action == "auto":
        return "roughness: a rough contact is not handed over, surface.action = 'motion' solves it from the release on"
    return "imperfection: a table is wavy or acts back" if scene.imperfection else no_one_contact(scene)


def no_one_contact(scene) -> str:
    """Return why the disk of a scene has no elastic contact at the least gap of a table; nothing if it has one."""
    try:
        contact_law(scene)
    except ValueError as error:
        return str(error)
    return ""


def shares(scene, modes):
    """Return inclinations (k,) [rad] from the release down; the energy of the table over that of the disk, 3/2 m g R
    beta, and the power of its waves over that of the friction, each (k,), in the steady motion there.

    The force drives a mode with the Fourier series of its shape round the rim, each term at a multiple of the rate.
    """
    disk, law = scene.disk, law_of(scene.disk, scene.friction)
    loads = resistance(getattr(scene, "dissipation", None), disk)
    beta = np.geomspace(min(radians(scene.release.inclination_deg), 0.3), LIES, PLACES)
    rate = np.array([steady_rate(disk, b) for b in beta])[:, None, None]
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    shapes = modes.at(*(disk.radius * np.array([np.cos(angle), np.sin(angle)]) + modes.place[:, None]))
    parts, order = np.fft.fft(shapes, axis=0) / AROUND, np.fft.fftfreq(AROUND, 1 / AROUND)[:, None]
    stiff = (2 * np.pi * modes.frequency) ** 2
    moved = np.abs(disk.weight * parts / (stiff - (order * rate) ** 2 + 2j * modes.decay_rate * order * rate)) ** 2
    held = (((order * rate) ** 2 + stiff) * moved).sum(axis=(1, 2)) / 2
    taken = (2 * modes.decay_rate * (order * rate) ** 2 * moved).sum(axis=(1, 2))
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    friction = unit * np.array([steady_power(b, law, loads) for b in beta])
    return beta, held / (1.5 * disk.weight * disk.radius * beta), taken / np.maximum(friction, 1e-300)
