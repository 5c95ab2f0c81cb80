"""Selection of the contact model: a linear filter, or the full compliant motion."""

from math import radians, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import trapezoid

from dynamics.compliant.law.linear_response import predicted_power, predicted_rms
from dynamics.compliant.law.table_receptance import RIGID_TABLE, TableReceptance
from dynamics.compliant.law.unevenness import unevenness
from dynamics.compliant.model_errors import motion_error
from dynamics.compliant.model_inputs import (
    contact_law,
    final_contact_inclination,
    reason_against_rattling,
)
from dynamics.disk import Disk, inertias
from dynamics.quasi_steady import steady_power
from dynamics.regime import Branch
from dynamics.rolling import RollingDisk, initial_state
from dynamics.steady_motion import steady_precession
from dynamics.switching import ImpossibleContactError, contact_at_release

if TYPE_CHECKING:
    from dynamics.compliant.law.tabulated import TabulatedLaw
    from dynamics.motion_plan import ContactModel, MotionBasis
    from dynamics.sections import MotionScene

LIFT_OFF_FORCE_RMS = 0.3
"""Rms of N'/weight above which a Gaussian vibration causes a loss of contact.

The filter holds up to it on short waves (chart `contact-models`)."""
MAX_FORCE_RMS_FOR_ONE_CONTACT = 0.5
"""Rms of N'/weight up to which one contact gives the motion on short waves within 2 %
(chart `contact-models`)."""
MAX_RELATIVE_CURVATURE_FOR_ROLLING = 0.25
"""Rms curvature of the unevenness, divided by that of the tilted rim, above which
rolling is impossible.

Contact is first lost at values from 0.25 to 0.5. Up to it, one contact gives the motion on
long waves within 2 % (chart `contact-models`)."""


def choose_contact_model(
    basis: "MotionBasis",
    tabulated: "TabulatedLaw",
    receptance: TableReceptance = RIGID_TABLE,
) -> tuple["ContactModel", str]:
    """Select the model of an elastic contact on a plane table, with the reason.

    It is the model requested by `numerics.contact`, or else the simplest sufficient one.
    `receptance` is that of a table with two-way coupling.
    """
    # fraction of the energy dissipated by roughness above which it affects the motion
    min_roughness_share = 0.05
    # fraction of the static friction at the release above which nutation may cause slip
    max_friction_use = 0.8
    scene = basis.scene
    kappa, rattles_at = greatest_curvature_number(basis)
    uneven = kappa > MAX_RELATIVE_CURVATURE_FOR_ROLLING
    if uneven:
        bumpy = (
            f"the curvature of the heights is {kappa:.2g} times that of the rim at "
            f"{rattles_at:.2g} rad, where rolling is impossible"
        )
        obstacle = reason_against_rattling(scene)
        if scene.numerics.contact == "auto" and not obstacle:
            return "many", bumpy
    if scene.surface.action == "motion" and scene.numerics.contact != "filter":
        return "full", "surface.action = 'motion': the table is coupled to the disk"
    beta, share = predicted_force_rms(basis, tabulated, receptance)
    above = share > LIFT_OFF_FORCE_RMS
    predicted = float(share.max(initial=0.0))
    below = float(beta[above].max(initial=0.0))
    expected = (
        f"the predicted rms of N' is {predicted:.2g} of the weight"
        if predicted
        else "table and edge are smooth"
    )
    kind: ContactModel = "full"
    if scene.numerics.contact != "auto":
        kind = scene.numerics.contact
        reason = f"numerics.contact = '{scene.numerics.contact}'; {expected}"
    elif below:
        reason = (
            f"{expected}, more than {LIFT_OFF_FORCE_RMS:g} below {below:.2g} rad, "
            "where contact is lost"
        )
    elif (
        takes := roughness_energy_share(basis, tabulated, receptance)
    ) > min_roughness_share:
        reason = f"{expected}; roughness dissipates {takes:.0%} of the energy, in addition to friction"
    elif (used := friction_utilisation(basis)) > max_friction_use:
        reason = (
            f"{expected}, but the friction at the release is {used:.0%} of its static limit: "
            "slip excites the contact"
        )
    else:
        less = f", less than {LIFT_OFF_FORCE_RMS:g}" * bool(predicted)
        kind = "filter"
        reason = f"{expected}{less}, and no slip is expected"
    if uneven:
        reason += f"; WARNING: {bumpy}" + f" (contact anywhere: {obstacle})" * bool(
            obstacle
        )
    else:
        reason += limit_warning(kind, beta, share, kappa)
    return kind, reason


def limit_warning(
    kind: "ContactModel", beta: np.ndarray, share: np.ndarray, kappa: float
) -> str:
    """Return a warning that the vibration exceeds the limit of a contact model, or "".

    Parameters
    ----------
    kind : ContactModel
        The model.
    beta, share : ndarray, shape (k,)
        Inclinations [rad], and the predicted rms of N'/weight at these.
    kappa : float
        Largest curvature number.
    """
    limits = {
        "filter": LIFT_OFF_FORCE_RMS,
        "full": MAX_FORCE_RMS_FOR_ONE_CONTACT,
    }
    outside = share > limits.get(kind, np.inf)
    if not outside.any():
        return ""
    error = motion_error(kind, float(share.max()), kappa)
    highest = f"{beta[outside].max():.2g}"
    lowest = f"{beta[outside].min():.2g}"
    where = lowest if highest == lowest else f"from {highest} to {lowest}"
    return (
        f"; WARNING: at {where} rad it exceeds {limits[kind]:g}, the limit of this model; "
        f"the predicted error of the motion is {error:.1%}"
    )


def greatest_curvature_number(basis: "MotionBasis") -> tuple[float, float]:
    """Return the largest curvature number and its inclination [rad].

    See `curvature_number` and `sampled_inclinations`.
    """
    scene = basis.scene
    if scene.roughness is None:
        return 0.0, 0.0
    law = contact_law(scene)
    inclinations = sampled_inclinations(basis)
    found = [
        unevenness(scene.disk, law, scene.roughness, beta).curvature_number
        for beta in inclinations
    ]
    greatest = int(np.argmax(found))
    return found[greatest], float(inclinations[greatest])


def predicted_force_rms(
    basis: "MotionBasis",
    tabulated: "TabulatedLaw",
    receptance: TableReceptance = RIGID_TABLE,
) -> tuple[np.ndarray, np.ndarray]:
    """Return inclinations (k,) [rad] and the rms of N'/weight (k,) in steady motion.

    `receptance` is that of the table; see also `sampled_inclinations`.
    """
    scene = basis.scene
    beta, speed = steady_motions(basis)
    if scene.roughness is None:
        return beta, np.zeros(len(beta))
    weight = scene.disk.weight
    rms = predicted_rms(
        tabulated, scene.roughness, beta, weight, speed, receptance=receptance
    )
    return beta, rms / weight


def roughness_energy_share(
    basis: "MotionBasis",
    tabulated: "TabulatedLaw",
    receptance: TableReceptance = RIGID_TABLE,
) -> float:
    """Return the fraction of the energy dissipated by roughness in quasi-steady motion.

    It is 0 if the friction was measured on the rough surface and already includes this
    loss.
    """
    scene = basis.scene
    if scene.roughness is None or scene.roughness.loss == "fitted":
        return 0.0
    disk = scene.disk
    beta, speed = steady_motions(basis)
    flat = np.array([flat_precession_rate(disk, b) for b in beta])
    exists = np.array([steady_precession_rate(scene, b) for b in beta]) != flat
    beta = beta[exists]
    speed = speed[exists]
    rough = predicted_power(
        tabulated, scene.roughness, beta, disk.weight, speed, receptance
    )
    friction = (
        np.array([steady_power(b, basis.constants, basis.loads) for b in beta])
        * disk.mass
        * disk.radius**2
        / disk.time_unit**3
    )
    # the energy is proportional to beta
    return float(trapezoid(rough / (rough + friction), -beta) / np.ptp(beta))


def steady_motions(basis: "MotionBasis") -> tuple[np.ndarray, np.ndarray]:
    """Return decreasing inclinations [rad] and steady contact speeds [m/s]."""
    beta = sampled_inclinations(basis)
    rate = np.array([steady_precession_rate(basis.scene, b) for b in beta])
    return beta, -contact_law(basis.scene).place(beta).f * rate


def sampled_inclinations(basis: "MotionBasis") -> np.ndarray:
    """Return 16 inclinations [rad] from the release to the end.

    The last one is the final inclination of the scene, or that at which the air film
    supports the disk, if it is higher.
    """
    count = 16
    first = radians(basis.scene.release.inclination_deg)
    final = final_contact_inclination(basis.final_inclination)
    last = max(final, min(basis.film_decision.airborne_inclination, first / 2))
    return np.geomspace(first, last, count)


def steady_precession_rate(scene: "MotionScene", beta: float) -> float:
    """Return the steady precession rate [rad/s] at an inclination [rad].

    If there is no steady motion, it is the limit for small inclinations.
    """
    disk = scene.disk
    ratio = scene.contact.rolling_fillet(disk) / disk.radius
    try:
        rate = steady_precession(beta, disk.aspect, disk.gyration, ratio)
        return rate / disk.time_unit
    except (ValueError, ZeroDivisionError):
        return flat_precession_rate(disk, beta)


def flat_precession_rate(disk: Disk, beta: float) -> float:
    """Return the steady precession rate [rad/s] in the limit of small inclinations.

    The moment of the weight about the centre, m g R, balances I Omega^2 sin(beta)."""
    about_diameter, _ = inertias(disk)
    return sqrt(disk.weight * disk.radius / (about_diameter * sin(beta)))


def friction_utilisation(basis: "MotionBasis") -> float:
    """Return |F|/(mu_s N) at the release; 0 without friction."""
    f1, f2, N = release_force(basis)
    most = basis.scene.friction.mu_static * N
    return float(np.hypot(f1, f2) / most) if most > 0 else 0.0


def release_force(basis: "MotionBasis") -> np.ndarray:
    """Return the force (3,) [N] along a_1, a_2 and the normal at the release.

    This is the force on a rigid disk, or the weight if no contact force satisfies the
    balance laws.
    """
    disk = basis.scene.disk
    constants = basis.constants
    loads = basis.loads
    system = RollingDisk(
        constants=constants,
        loads=loads,
        r_end=0.0,
        integrate=lambda *arguments: None,
        tolerance=0.0,
    )
    try:
        start = system.begin(initial_state(disk, basis.scene.release))
    except ImpossibleContactError:
        return np.array([0.0, 0.0, disk.weight])
    branch = Branch.of(start.regime, constants, loads)
    contact = contact_at_release(start.state, start.regime, branch, constants)
    return (
        np.array([contact.F1, contact.F2, contact.Phi])
        * disk.mass
        * disk.radius
        / disk.time_unit**2
    )
