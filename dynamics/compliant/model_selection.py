"""Choice of the contact model of a scene: linear filter along the rigid motion, or full compliant
motion.
"""

from math import radians
from typing import NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from dynamics.compliant.law.linear_response import predicted_power, predicted_rms
from dynamics.compliant.law.unevenness import unevenness
from dynamics.compliant.model_inputs import (
    contact_law,
    final_contact_inclination,
    is_two_way,
    law_table,
    rattling_obstacle,
)
from dynamics.equations import disk_constants
from dynamics.film.activation import airborne_inclination, non_contact_loads
from dynamics.quasi_steady import steady_power
from dynamics.regime import FLOAT_FORMULAS, Branch
from dynamics.rolling import RollingDisk, initial_state
from dynamics.steady_motion import steady_precession
from dynamics.switching import ImpossibleContactError

CONTACT_LOSS_RMS = 0.3
"""Rms of N'/weight above which a Gaussian vibration loses contact."""
MAX_ROLLING_CURVATURE = 0.25
"""Rms curvature of the unevenness, over that of the tilted rim, above which no rolling motion
exists: contact is lost from 0.25 to 0.5 on."""
MAX_FRICTION_USE = 0.8
"""Share of the static friction at the release above which the nutation is assumed to cause slip."""
MIN_ROUGHNESS_SHARE = 0.05
"""Share of the energy above which the losses by roughness affect the motion."""
PREDICTION_POINTS = 16
"""Inclinations at which the vibration is predicted."""


class ModelChoice(NamedTuple):
    """Contact model of a scene.

    Attributes
    ----------
    kind : str
        'rigid', 'filter', 'full' or 'many'.
    reason : str
        Reason of the choice.
    predicted : float
        Largest expected rms of N'/weight.
    lost_below : float
        Inclination [rad] below which contact is lost; 0 if nowhere.
    """

    kind: str
    reason: str
    predicted: float = 0.0
    lost_below: float = 0.0


def choose_contact_model(scene) -> ModelChoice:
    """Return the contact model of a scene: `numerics.contact`, or the choice for 'auto'."""
    if scene.numerics.contact == "many":
        return ModelChoice("many", "numerics.contact = 'many'")
    if is_two_way(scene):
        return ModelChoice("full", "surface.action = 'motion': the table moves with the disk")
    if scene.imperfection:
        return ModelChoice("full", "imperfection: the rim follows the waves of the table")
    if scene.contact.law == "rigid":
        return ModelChoice("rigid", "contact.law = 'rigid'")
    kappa, rattles_at = greatest_curvature(scene)
    uneven = kappa > MAX_ROLLING_CURVATURE
    if uneven:
        bumpy = (
            f"the curvature of the heights is {kappa:.2g} times that of the rim at "
            f"{rattles_at:.2g} rad, where no rolling motion exists"
        )
        obstacle = rattling_obstacle(scene)
        if scene.numerics.contact == "auto" and not obstacle:
            return ModelChoice("many", bumpy)
    beta, share = predicted_vibration(scene)
    above = share > CONTACT_LOSS_RMS
    predicted = float(share.max(initial=0.0))
    below = float(beta[above].max(initial=0.0))
    expected = (
        f"rms(N') of {predicted:.2g} of the weight is predicted"
        if predicted
        else "table and edge are smooth"
    )
    kind = "full"
    if scene.numerics.contact != "auto":
        kind = scene.numerics.contact
        reason = f"numerics.contact = '{scene.numerics.contact}'; {expected}"
    elif below:
        reason = f"{expected}, more than {CONTACT_LOSS_RMS:g} below {below:.2g} rad, where contact is lost"
    elif (takes := roughness_energy_share(scene)) > MIN_ROUGHNESS_SHARE:
        reason = f"{expected}; roughness takes {takes:.0%} of the energy, besides friction"
    elif (used := friction_utilisation(scene)) > MAX_FRICTION_USE:
        reason = f"{expected}, but {used:.0%} of the static friction is used at the release: slip excites the contact"
    else:
        less = f", less than {CONTACT_LOSS_RMS:g}" * bool(predicted)
        kind = "filter"
        reason = f"{expected}{less}, and no slip is expected"
    if uneven:
        reason += f"; WARNING: {bumpy}" + f" (contact anywhere: {obstacle})" * bool(obstacle)
    return ModelChoice(kind, reason, predicted, below)


def greatest_curvature(scene) -> tuple[float, float]:
    """Return the greatest rms curvature of the unevenness over that of the rim, and its inclination
    [rad].

    The inclinations extend from the release to the end, or to the inclination at which the air
    carries the disk.
    """
    if scene.roughness is None:
        return 0.0, 0.0
    law = contact_law(scene)
    inclinations = settling_inclinations(scene)
    found = [unevenness(scene.disk, law, scene.roughness, beta).curvature for beta in inclinations]
    greatest = int(np.argmax(found))
    return found[greatest], float(inclinations[greatest])


def predicted_vibration(scene) -> tuple[np.ndarray, np.ndarray]:
    """Return inclinations (k,) [rad] and the rms of N'/weight (k,) in the steady motion
    there.

    The inclinations extend from the release to the end, or to the inclination at which the air
    carries the disk.
    """
    beta, speed = steady_motions(scene)
    if scene.roughness is None:
        return beta, np.zeros(PREDICTION_POINTS)
    weight = scene.disk.weight
    return beta, predicted_rms(law_table(scene), scene.roughness, beta, weight, speed) / weight


def roughness_energy_share(scene) -> float:
    """Return the share of the energy of a steady decline that roughness takes in addition to
    friction and air.

    It is 0 for friction that was fitted to such a surface, which includes it.
    """
    if scene.roughness is None or scene.roughness.loss == "fitted":
        return 0.0
    disk = scene.disk
    law = disk_constants(scene.disk, scene.friction)
    loads = non_contact_loads(scene)
    (beta, speed) = steady_motions(scene)
    exists = np.array([abs(steady_rate(disk, b) - flat_rate(disk, b)) > 0 for b in beta])
    beta = beta[exists]
    speed = speed[exists]
    rough = predicted_power(law_table(scene), scene.roughness, beta, disk.weight, speed)
    friction = (
        np.array([steady_power(b, law, loads) for b in beta])
        * disk.mass
        * disk.radius**2
        / disk.time_unit**3
    )
    return float(
        trapezoid(
            rough / (rough + friction),
            -beta,
        )
        / np.ptp(beta)
    )  # the energy is proportional to beta


def steady_motions(scene) -> tuple[np.ndarray, np.ndarray]:
    """Return falling inclinations (PREDICTION_POINTS,) [rad] and the steady speeds of the contact
    [m/s].
    """
    disk = scene.disk
    beta = settling_inclinations(scene)
    rate = np.array([steady_rate(disk, b) for b in beta])
    return beta, disk.radius * rate * (np.cos(beta) - disk.aspect * np.sin(beta))


def settling_inclinations(scene) -> np.ndarray:
    """Return inclinations (PREDICTION_POINTS,) [rad] from the release to the predicted end."""
    first = radians(scene.release.inclination_deg)
    last = max(final_contact_inclination(scene), min(airborne_inclination(scene), first / 2))
    return np.geomspace(first, last, PREDICTION_POINTS)


def steady_rate(disk, beta: float) -> float:
    """Return the precession rate [rad/s] of the steady motion at an inclination; its flat limit if
    none exists.
    """
    try:
        return steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit
    except (ValueError, ZeroDivisionError):
        return flat_rate(disk, beta)


def flat_rate(disk, beta: float) -> float:
    """Return the precession rate [rad/s] of the steady motion in the limit of small
    inclinations."""
    return (4.0 / np.sin(beta)) ** 0.5 / disk.time_unit


def friction_utilisation(scene) -> float:
    """Return |F|/(mu_s N) at the release; at least 1 if the disk slides at once, 0 without
    friction.
    """
    f1, f2, N = release_force(scene)
    most = scene.friction.mu_static * N
    return float(np.hypot(f1, f2) / most) if most > 0 else 0.0


def release_force(scene) -> np.ndarray:
    """Return the force (3,) [N] along a_1, a_2 and the normal on the rigid disk at its release.

    It is the weight if no contact force satisfies the balance laws.
    """
    disk = scene.disk
    law = disk_constants(scene.disk, scene.friction)
    loads = non_contact_loads(scene)
    system = RollingDisk(
        law=law,
        loads=loads,
        r_end=0.0,
        integrate=lambda *arguments: None,
        tolerance=0.0,
    )
    try:
        start = system.begin(initial_state(disk, scene.release))
    except ImpossibleContactError:
        return np.array([0.0, 0.0, disk.weight])
    branch = Branch.of(start.regime, law, loads)
    contact = FLOAT_FORMULAS.contact(start.state, branch, start.regime.senses, law)
    return (
        np.array([contact.F1, contact.F2, contact.Phi])
        * disk.mass
        * disk.radius
        / disk.time_unit**2
    )
