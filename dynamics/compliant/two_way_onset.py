"""Inclination from which the reaction of the table on the disk matters."""

from math import radians
from typing import Any, NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import steady_rate
from dynamics.compliant.modes_from_scene import modes_from_numbers
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.dissipation import resistance_of
from dynamics.equations import disk_constants
from dynamics.quasi_steady import steady_power
from dynamics.surface import MIN_TWO_WAY_SHARE, ModesSurface

INCLINATION_COUNT = 200
"""Inclinations at which the reaction of the table is evaluated."""
RIM_POINTS = 64
"""Points of the rim at which the table modes are evaluated."""


class TableReaction(NamedTuple):
    """Reaction of the table on the motion of the disk.

    Attributes
    ----------
    acts : bool
        True if the motion is solved with two-way coupling.
    inclination : float
        Inclination [rad] below which the reaction matters; 0 if it never does.
    reason : str
        Reason of the result.
    unsolved : str
        Reason for no two-way coupling in spite of the reaction; else empty.
    """

    acts: bool
    inclination: float
    reason: str
    unsolved: str = ""


def table_reaction(scene, modes) -> TableReaction:
    """Return the `TableReaction` of a scene on a table with these modes (`modal.SurfaceModes`).

    It applies to surface.action = 'auto' and follows from the steady motion, with the centre of the
    disk at its place at the release and the weight as force. From this inclination on the motion is
    solved with an elastic contact.
    """
    beta, energy, power = reaction_shares(scene, modes)
    more = np.flatnonzero((energy > MIN_TWO_WAY_SHARE) | (power > MIN_TWO_WAY_SHARE))
    if not len(more):
        reason = f"its energy and wave drag stay below {MIN_TWO_WAY_SHARE:.0%} of those of disk and friction"
        return TableReaction(False, 0.0, reason)
    since = more[0]
    what = "energy" if energy[since] > MIN_TWO_WAY_SHARE else "wave drag"
    reference = "disk's" if what == "energy" else "friction's"
    reason = (
        f"its {what} exceeds {MIN_TWO_WAY_SHARE:.0%} of the {reference} below {beta[since]:.2g} rad"
    )
    wrong = reason_against_two_way(scene)
    return TableReaction(not wrong, float(beta[since]), reason, wrong)


def may_be_two_way(scene: Any) -> bool:
    """Return True if the motion of a scene is solved with the modes of its table."""
    action = scene.surface.action
    return action == "motion" or (action == "auto" and not reason_against_two_way(scene))


def needs_table_modes(scene: Any) -> bool:
    """Return True if the motion of a scene needs table modes that the scene does not contain as
    numbers.
    """
    return may_be_two_way(scene) and not isinstance(scene.surface, ModesSurface)


def table_modes(scene, given=None):
    """Return the table modes for the motion of a scene: those `given`, or those in the scene; None
    if not needed.

    Raises ValueError where the table cannot act back although the scene asks for it, and where its
    modes are missing.
    """
    if not may_be_two_way(scene):
        return None
    if scene.surface.action == "motion" and (
        why := reason_against_two_way(scene) or reason_against_full_model(scene)
    ):
        raise ValueError(f"surface.action = 'motion' with {why}")
    if given is not None:
        return given
    if needs_table_modes(scene):
        raise ValueError(
            f"surface.kind = '{scene.surface.kind}' with surface.action = "
            f"'{scene.surface.action}': the table may "
            f"act on the motion, give surface_modes=modal.surface_modes(scene), or set "
            f"surface.action = 'sound'"
        )
    return modes_from_numbers(scene.surface, scene.disk.radius)


def reason_against_full_model(scene) -> str:
    """Return the reason why the contact of a scene is not solved in full from the release; empty if
    it is.
    """
    if scene.contact.law == "rigid":
        return "contact.law = 'rigid': such a table needs an elastic contact"
    filtered = scene.numerics.contact == "filter"
    return "numerics.contact = 'filter': such a table needs 'full'" if filtered else ""


def reason_against_two_way(scene) -> str:
    """Return the reason why the table of a scene cannot have two-way coupling; empty if it can."""
    if scene.surface.kind in ("rigid", "infinite"):
        return f"surface.kind = '{scene.surface.kind}': a table that acts back must have modes"
    if scene.roughness and scene.contact.law == "elastic" and scene.surface.action == "auto":
        return "roughness: a rough contact is not handed over, surface.action = 'motion' solves it from the release on"
    return (
        "imperfection: a table is wavy or acts back"
        if scene.imperfection
        else reason_against_contact_law(scene)
    )


def reason_against_contact_law(scene) -> str:
    """Return the reason why the disk of a scene has no elastic contact; empty if it has one."""
    try:
        contact_law(scene)
    except ValueError as error:
        return str(error)
    return ""


def reaction_shares(scene, modes):
    """Return the shares of the table in energy and power along the steady motion.

    The force drives each mode with the Fourier series of its shape round the rim, at multiples of
    the precession rate.

    Returns
    -------
    inclination : (k,) array
        Inclinations from the release down [rad].
    energy : (k,) array
        Energy of the table divided by that of the disk, 3/2 m g R beta.
    power : (k,) array
        Power of the waves in the table divided by that of friction.
    """
    disk = scene.disk
    law = disk_constants(scene.disk, scene.friction)
    loads = resistance_of(scene.dissipation, disk)
    beta = np.geomspace(
        min(radians(scene.release.inclination_deg), 0.3),
        FLAT_INCLINATION,
        INCLINATION_COUNT,
    )
    rate = np.array([steady_rate(disk, b) for b in beta])[:, None, None]
    angle = 2 * np.pi * np.arange(RIM_POINTS) / RIM_POINTS
    shapes = modes.at(
        *(disk.radius * np.array([np.cos(angle), np.sin(angle)]) + modes.place[:, None])
    )
    parts = np.fft.fft(shapes, axis=0) / RIM_POINTS
    order = np.fft.fftfreq(RIM_POINTS, 1 / RIM_POINTS)[:, None]
    stiff = (2 * np.pi * modes.frequency) ** 2
    moved = (
        np.abs(
            disk.weight
            * parts
            / (stiff - (order * rate) ** 2 + 2j * modes.decay_rate * order * rate)
        )
        ** 2
    )
    held = (((order * rate) ** 2 + stiff) * moved).sum(axis=(1, 2)) / 2
    taken = (2 * modes.decay_rate * (order * rate) ** 2 * moved).sum(axis=(1, 2))
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    friction = unit * np.array([steady_power(b, law, loads) for b in beta])
    return (
        beta,
        held / (1.5 * disk.weight * disk.radius * beta),
        taken / np.maximum(friction, 1e-300),
    )
