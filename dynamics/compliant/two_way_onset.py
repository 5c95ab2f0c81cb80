"""Predict the inclination below which the table affects the motion of the disk."""

from math import radians
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics.compliant.law.table_receptance import shapes_on_circle
from dynamics.compliant.model_inputs import contact_law
from dynamics.compliant.model_selection import steady_precession_rate
from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.dissipation import resistance_of
from dynamics.quasi_steady import steady_power
from dynamics.solver_settings import MIN_RELEVANT_SHARE

if TYPE_CHECKING:
    from dynamics.motion_plan import ContactModel, MotionBasis

NO_LATE_TABLE_IN_STEPS = (
    "time steps on a rough contact move the table from the release or not at all; "
    "surface.action = 'motion' moves it"
)
"""Reason why the late reaction of a table on a rough contact in time steps is not solved."""
MAX_REACTION_BEFORE_LIFT_OFF = 0.02
"""Inclination [rad] below which a film that lifts the disk ends a motion on a rough contact
before the table changes it."""
FILM_LIFTS_FIRST = (
    "the film lifts the disk at {inclination:.2g} rad, before the table changes the motion: with "
    "mirrors of 3 and 6 mm, time steps with all modes from 0.02 rad on move the end by at most 2 ms"
)
"""Reason why the late reaction of a table on a rough contact under a film is not solved.

tests/stepping/test_rough_hand_over.py measures it."""


def table_reaction(basis: "MotionBasis", modes: Any) -> tuple[float, str]:
    """Return the inclination [rad] below which a table with `modal.SurfaceModes` affects
    the motion, and the reason; 0 if it never does.

    The reaction is predicted for steady motion about the position of the centre at the
    release, with the weight as force.
    """
    beta, energy, power = table_shares_by_inclination(basis, modes)
    more = np.flatnonzero((energy > MIN_RELEVANT_SHARE) | (power > MIN_RELEVANT_SHARE))
    if not len(more):
        return 0.0, (
            f"its energy and wave drag remain below {MIN_RELEVANT_SHARE:.0%} of those of disk "
            f"and friction"
        )
    since = more[0]
    what = "energy" if energy[since] > MIN_RELEVANT_SHARE else "wave drag"
    reference = "disk's" if what == "energy" else "friction's"
    reason = f"its {what} exceeds {MIN_RELEVANT_SHARE:.0%} of the {reference} below {beta[since]:.2g} rad"
    return float(beta[since]), reason


def reason_against_two_way(basis: "MotionBasis", model: "ContactModel") -> str:
    """Return the reason why a disk with a contact model is not coupled to the modes of
    its table in time steps, or ""."""
    scene = basis.scene
    if scene.roughness is not None and model == "filter" and film_lifts_first(basis):
        return film_lifts_first(basis)
    if scene.imperfection:
        return "imperfection: two-way coupling is not available for a wavy table"
    try:
        contact_law(scene)
    except ValueError as error:
        return str(error)
    return ""


def film_lifts_first(basis: "MotionBasis") -> str:
    """Return the reason why a table that acts below MAX_REACTION_BEFORE_LIFT_OFF does not
    change the motion on a rough contact, or "" if no film lifts the disk."""
    lifted_at = basis.film_decision.airborne_inclination
    return FILM_LIFTS_FIRST.format(inclination=lifted_at) if lifted_at else ""


def table_shares_by_inclination(
    basis: "MotionBasis", modes: Any
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
    scene = basis.scene
    disk = scene.disk
    loads = resistance_of(scene.dissipation, disk)
    beta = np.geomspace(
        min(radians(scene.release.inclination_deg), 0.3),
        FLAT_INCLINATION,
        200,  # inclinations
    )
    rate = np.array([steady_precession_rate(scene, b) for b in beta])[:, None, None]
    radius = disk.radius - scene.contact.rolling_fillet(disk)
    shapes = shapes_on_circle(modes, modes.place, radius, rim_point_count)
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
    friction = unit * np.array([steady_power(b, basis.constants, loads) for b in beta])
    return (
        beta,
        held / (1.5 * disk.weight * disk.radius * beta),
        taken / np.maximum(friction, 1e-300),
    )
