"""SCENE -> which model of its elastic contact it needs: the filter along the rigid motion, or the full one."""

from math import radians
from typing import NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from ..equations import law_of
from ..film.acting import carried_below, loads_of
from ..regime import FLOAT, Branch
from ..rolling import RollingDisk, released
from ..steady import steady_precession
from ..switching import ImpossibleContactError
from ..time_left import steady_power
from .filter import predicted_power, predicted_rms
from .from_scene import acts_back, last_inclination, law_table

SHAKEN = 0.3
"""From this rms of N' over the weight on contact is lost: the force of a Gaussian vibration is then at times 0."""
NEAR_SLIP = 0.8
"""From this share of the static friction at the release on, the nutation is taken to make the disk slide."""
MATTERS = 0.05
"""From this part of the energy on what roughness takes besides friction acts on the motion."""
PLACES = 16
"""Inclinations at which the force is predicted."""


class Choice(NamedTuple):
    """`kind` is 'rigid', 'filter' or 'full', with the reason in words; `predicted` is the greatest rms(N') expected of
    the filter, over the weight, and `lost_below` [rad] where it passes SHAKEN, 0 where it does not."""

    kind: str
    reason: str
    predicted: float = 0.0
    lost_below: float = 0.0


def choice(scene) -> Choice:
    """Return which model solves the contact of a scene: `numerics.contact`, and what 'auto' takes."""
    if acts_back(scene):
        return Choice("full", "surface.action = 'motion': the table moves with the disk")
    if getattr(scene, "imperfection", None):
        return Choice("full", "imperfection: the rim follows the waves of the table")
    if scene.contact.law == "rigid":
        return Choice("rigid", "contact.law = 'rigid'")
    beta, share = shaken(scene)
    above, predicted = share > SHAKEN, float(share.max(initial=0.0))
    below = float(beta[above].max(initial=0.0))
    expected = f"rms(N') of {predicted:.2g} of the weight is predicted" if predicted else "table and edge are smooth"
    kind = "full"
    if scene.numerics.contact != "auto":
        kind, reason = scene.numerics.contact, f"numerics.contact = '{scene.numerics.contact}'; {expected}"
    elif below:
        reason = f"{expected}, more than {SHAKEN:g} from {below:.2g} rad on, so that contact is lost"
    elif (takes := roughness_takes(scene)) > MATTERS:
        reason = f"{expected}; roughness takes {takes:.0%} of the energy, besides friction"
    elif (used := friction_used(scene)) > NEAR_SLIP:
        reason = f"{expected}, but {used:.0%} of the static friction is used at the release: slides ring the contact"
    else:
        less = f", less than {SHAKEN:g}" * bool(predicted)
        kind, reason = "filter", f"{expected}{less}, and no slide is expected"
    return Choice(kind, reason, predicted, below)


def shaken(scene) -> tuple[np.ndarray, np.ndarray]:
    """Return inclinations (k,) [rad] from the release to the end, or to where the air carries the disk, and the rms of
    N' over the weight (k,) in the steady motion there."""
    beta, speed = steadily(scene)
    if scene.roughness is None:
        return beta, np.zeros(PLACES)
    weight = scene.disk.weight
    return beta, predicted_rms(law_table(scene), scene.roughness, beta, weight, speed) / weight


def roughness_takes(scene) -> float:
    """Return the part of the energy of a steady decline that roughness takes besides friction and air.

    0 where the friction was fitted to such a surface, and holds it.
    """
    if scene.roughness is None or scene.roughness.loss == "fitted":
        return 0.0
    disk, law, loads, (beta, speed) = scene.disk, law_of(scene.disk, scene.friction), loads_of(scene), steadily(scene)
    exists = np.array([abs(steady_rate(disk, b) - flat_rate(disk, b)) > 0 for b in beta])
    beta, speed = beta[exists], speed[exists]
    rough = predicted_power(law_table(scene), scene.roughness, beta, disk.weight, speed)
    friction = np.array([steady_power(b, law, loads) for b in beta]) * disk.mass * disk.radius**2 / disk.time_unit**3
    return float(trapezoid(rough / (rough + friction), -beta) / np.ptp(beta))  # the energy goes with beta


def steadily(scene) -> tuple[np.ndarray, np.ndarray]:
    """Return falling inclinations (PLACES,) [rad] of a scene and the speed [m/s] of the contact in steady motion."""
    disk, first = scene.disk, radians(scene.release.inclination_deg)
    last = max(last_inclination(scene), min(carried_below(scene), first / 2))
    beta = np.geomspace(first, last, PLACES)
    rate = np.array([steady_rate(disk, b) for b in beta])
    return beta, disk.radius * rate * (np.cos(beta) - disk.aspect * np.sin(beta))


def steady_rate(disk, beta: float) -> float:
    """Return the precession rate [rad/s] of the steady motion at an inclination, or of the flat limit if none is."""
    try:
        return steady_precession(beta, disk.aspect, disk.gyration) / disk.time_unit
    except (ValueError, ZeroDivisionError):
        return flat_rate(disk, beta)


def flat_rate(disk, beta: float) -> float:
    """Return the precession rate [rad/s] of a flat steady motion, as a measure of it at a steep inclination."""
    return (4.0 / np.sin(beta)) ** 0.5 / disk.time_unit


def friction_used(scene) -> float:
    """Return |F|/(mu_s N) at the release, at least 1 where the disk slides at once; 0 without friction."""
    f1, f2, N = first_force(scene)
    most = scene.friction.mu_static * N
    return float(np.hypot(f1, f2) / most) if most > 0 else 0.0


def first_force(scene) -> np.ndarray:
    """Return the force (3,) [N] along a_1, a_2 and the normal on the rigid disk at its release.

    It is the weight where no contact force satisfies the balance laws.
    """
    disk, law, loads = scene.disk, law_of(scene.disk, scene.friction), loads_of(scene)
    system = RollingDisk(law=law, loads=loads, r_end=0.0, integrate=lambda *arguments: None, tolerance=0.0)
    try:
        start = system.begin(released(disk, scene.release))
    except ImpossibleContactError:
        return np.array([0.0, 0.0, disk.weight])
    branch = Branch.of(start.regime, law, loads)
    contact = FLOAT.contact(start.state, branch, start.regime.senses, law)
    return np.array([contact.F1, contact.F2, contact.Phi]) * disk.mass * disk.radius / disk.time_unit**2
