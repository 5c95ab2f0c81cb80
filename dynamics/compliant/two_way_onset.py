"""Predict the inclination below which the table affects the motion of the disk."""

from math import radians
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import (
    choose_contact_model,
    steady_precession_rate,
)
from dynamics.compliant.modes_from_scene import modes_from_numbers
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.dissipation import resistance_of
from dynamics.quasi_steady import steady_power
from dynamics.scene_constants import scene_constants
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from dynamics.surface import ModesSurface

if TYPE_CHECKING:
    from dynamics.sections import MotionScene


class TableReaction(NamedTuple):
    """Reaction of the table on the motion of the disk.

    Attributes
    ----------
    is_two_way : bool
        True if the motion is solved with two-way coupling.
    inclination : float
        Inclination [rad] below which the reaction is relevant; 0 if it never is.
    reason : str
        Reason for the result.
    reason_unsolved : str
        Reason why a relevant reaction is not solved, or "".
    """

    is_two_way: bool
    inclination: float
    reason: str
    reason_unsolved: str = ""


def table_reaction(scene: "MotionScene", modes: Any) -> TableReaction:
    """Return the `TableReaction` of a scene on a table with `modal.SurfaceModes`.

    It applies to surface.action = 'auto'. It is predicted for steady motion about the
    position of the centre at the release, with the weight as force.
    """
    beta, energy, power = table_shares_by_inclination(scene, modes)
    more = np.flatnonzero((energy > MIN_RELEVANT_SHARE) | (power > MIN_RELEVANT_SHARE))
    if not len(more):
        reason = (
            f"its energy and wave drag remain below {MIN_RELEVANT_SHARE:.0%} of those of disk "
            f"and friction"
        )
        return TableReaction(False, 0.0, reason)
    since = more[0]
    what = "energy" if energy[since] > MIN_RELEVANT_SHARE else "wave drag"
    reference = "disk's" if what == "energy" else "friction's"
    reason = f"its {what} exceeds {MIN_RELEVANT_SHARE:.0%} of the {reference} below {beta[since]:.2g} rad"
    wrong = reason_against_two_way(scene)
    return TableReaction(not wrong, float(beta[since]), reason, wrong)


def may_be_two_way(scene: Any) -> bool:
    """Return True if the motion of a scene may be coupled to the modes of its table."""
    action = scene.surface.action
    return action == "motion" or (
        action == "auto" and not reason_against_two_way(scene)
    )


def must_compute_table_modes(scene: Any) -> bool:
    """Return True if the motion of a scene requires computed table modes."""
    return may_be_two_way(scene) and not isinstance(scene.surface, ModesSurface)


def table_modes(scene: "MotionScene", given: Any = None) -> Any:
    """Return the table modes required by the motion of a scene, or None.

    They are the `given` modes, or else those that the scene specifies by numbers.
    Raises ValueError if modes are missing, or if the requested two-way coupling is
    impossible.
    """
    if not may_be_two_way(scene):
        return None
    if scene.surface.action == "motion" and (
        why := reason_against_two_way(scene) or reason_against_full_model(scene)
    ):
        raise ValueError(f"surface.action = 'motion' with {why}")
    if given is not None:
        return given
    if not isinstance(scene.surface, ModesSurface):
        raise ValueError(
            f"surface.kind = '{scene.surface.kind}' with surface.action = "
            f"'{scene.surface.action}': the table may affect the motion; give "
            f"surface_modes=modal.surface_modes(scene), or set surface.action = 'sound'"
        )
    return modes_from_numbers(scene.surface, scene.disk.radius)


def reason_against_full_model(scene: "MotionScene") -> str:
    """Return the reason why the contact of a scene is not solved in full, or ""."""
    if scene.contact.law == "rigid":
        return "contact.law = 'rigid': two-way coupling requires an elastic contact"
    filtered = scene.numerics.contact == "filter"
    return (
        "numerics.contact = 'filter': two-way coupling requires 'full'"
        if filtered
        else ""
    )


def reason_against_two_way(scene: "MotionScene") -> str:
    """Return the reason why two-way coupling to a table is impossible, or ""."""
    if scene.surface.kind in ("rigid", "infinite"):
        return f"surface.kind = '{scene.surface.kind}': two-way coupling requires table modes"
    rolls_on_roughness = (
        scene.roughness is not None
        and scene.contact.law == "elastic"
        and scene.surface.action == "auto"
        and choose_contact_model(scene).kind != "many"
    )
    if rolls_on_roughness:
        return (
            "roughness: a rough contact cannot switch to two-way coupling; surface.action = "
            "'motion' couples it from the release"
        )
    return (
        "imperfection: two-way coupling is not available for a wavy table"
        if scene.imperfection
        else reason_against_contact_law(scene)
    )


def reason_against_contact_law(scene: "MotionScene") -> str:
    """Return the reason why an elastic contact of the disk is impossible, or ""."""
    try:
        contact_law(scene)
    except ValueError as error:
        return str(error)
    return ""


def table_shares_by_inclination(
    scene: "MotionScene", modes: Any
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the energy of the table in steady motion and the power that it absorbs,
    relative to those of the disk.

    The contact force excites each mode by the Fourier series of its shape around the
    rim, at multiples of the precession rate.

    Returns
    -------
    inclination : (k,) array
        Decreasing inclinations from the release [rad].
    energy : (k,) array
        Energy of the table divided by that of the disk, 3/2 m g R beta.
    power : (k,) array
        Power dissipated by the waves in the table divided by that of friction and the
        dissipation laws.
    """
    # Number of points of the rim at which the table modes are evaluated
    rim_point_count = 64
    disk = scene.disk
    law = scene_constants(scene)
    loads = resistance_of(scene.dissipation, disk)
    beta = np.geomspace(
        min(radians(scene.release.inclination_deg), 0.3),
        FLAT_INCLINATION,
        200,  # inclinations
    )
    rate = np.array([steady_precession_rate(scene, b) for b in beta])[:, None, None]
    angle = 2 * np.pi * np.arange(rim_point_count) / rim_point_count
    radius = disk.radius - scene.contact.rolling_fillet(disk)
    shapes = modes.at(
        *(radius * np.array([np.cos(angle), np.sin(angle)]) + modes.place[:, None])
    )
    parts = np.fft.fft(shapes, axis=0) / rim_point_count
    order = np.fft.fftfreq(rim_point_count, 1 / rim_point_count)[:, None]
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
