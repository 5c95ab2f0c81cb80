"""Resonances of a body on the three springs of its contact: one of them rings, and it is the carrier of the sound.

Components are along a_1 (the rolling direction), a_2 (horizontal, towards the contact) and a_3 (the vertical).
"""

from typing import NamedTuple

import numpy as np

from ..disk import Disk
from ..steady import steady_precession
from .contact import ContactLaw, Springs

TINY = 1e-300
RIGID = np.zeros((3, 3))
"""Flexibility [m/N] of a rigid disk."""
LARGEST, HEAVIEST = 1.0, 4.0
"""Radians that the fastest resonance may turn in a step, under so many times the weight."""


class Resonances(NamedTuple):
    """Frequency [Hz], ascending, and loss factor 2|Re s|/|s| of the roots s, each (k, 3)."""

    frequency: np.ndarray
    loss_factor: np.ndarray


class Linear(NamedTuple):
    """x' = A x + B z' and p = C x + D z', for x = (velocities, spring deflections) of the contact point (k, 6).

    z' [m/s] is the rate at which the table rises under the contact; p (k, 3) [N] what is added to its force.
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray


def rigid_shapes(disk: Disk, inclination) -> np.ndarray:
    """Return (k, 3, 6) [kg^-1/2]: motion of the contact point in the six rigid modes of unit modal mass.

    Three translations, and the rotations about a_1, about the axis and about the diameter through the contact. The
    product with its transpose is the mobility W = 1/m - [r]x J^-1 [r]x of the contact point.
    """
    beta = np.atleast_1d(np.asarray(inclination, dtype=float))
    J1, J2, R, H = *inertias(disk), disk.radius, disk.thickness / 2
    reach, height = R * np.cos(beta) - H * np.sin(beta), R * np.sin(beta) + H * np.cos(beta)
    shapes = np.zeros((len(beta), 3, 6))
    shapes[:, range(3), range(3)] = disk.mass**-0.5
    shapes[:, 1, 3], shapes[:, 2, 3] = height / J1**0.5, reach / J1**0.5
    shapes[:, 0, 4], shapes[:, 0, 5] = R / J2**0.5, H / J1**0.5
    return shapes


def inertias(disk: Disk) -> tuple[float, float]:
    """Return the moments of inertia [kg m^2] about a diameter and about the axis."""
    unit, K, h = disk.mass * disk.radius**2, disk.gyration, disk.aspect
    return unit * (K / 4 + h * h / 3), unit * K / 2


def mobility(disk: Disk, inclination) -> np.ndarray:
    """Return W (k, 3, 3) [1/kg]: acceleration of the contact point of the rigid disk for a unit force on it."""
    shapes = rigid_shapes(disk, inclination)
    return shapes @ shapes.swapaxes(1, 2)


def stiffness_matrix(springs: Springs) -> np.ndarray:
    """Return diag(k1, k2, kn) (k, 3, 3) [N/m]."""
    return np.stack(np.broadcast_arrays(springs.k1, springs.k2, springs.kn), axis=-1)[..., None] * np.eye(3)


def damping(law: ContactLaw, inclination, load):
    """Return c [N s/m] along the normal that gives the normal resonance sqrt(kn W33) the loss factor of the law."""
    kn = law.springs(inclination, load).kn
    return law.loss_factor * np.sqrt(kn / mobility(law.disk, inclination)[:, 2, 2])


def rate_needed(law: ContactLaw, inclination):
    """Return the steps (k,) [1/s] in which the fastest resonance at inclinations (k,) turns by LARGEST."""
    springs, W = law.springs(inclination, HEAVIEST * law.disk.weight), mobility(law.disk, inclination)
    return np.sqrt(springs.kn * W[:, 2, 2] + springs.k2 * W[:, 1, 1]) / LARGEST


def linear(
    disk: Disk, inclination, springs: Springs, speed=0.0, damping=0.0, impedance=np.inf, flexibility=RIGID
) -> Linear:
    """Return the linearised contact at inclinations (k,), with the contact moving along its path at `speed` [m/s].

    The tangential springs forget, q_t' = u_t - q_t V/l; the table yields at `impedance` Z [N s/m], downwards under a
    force that lifts the disk, q_z' = u_z - z' + N'/Z; the disk itself yields F p, F its `flexibility` (k, 3, 3) [m/N].
    With G = (1 + F k)^-1, to the first order in the damping c: q' = G (u - q V/l - (z' - N'/Z) e_3) and
    p = -k q - G^T c q_z' e_3.
    """
    W, stiff = mobility(disk, inclination), stiffness_matrix(springs)
    G, forgets = np.linalg.inv(np.eye(3) + flexibility @ stiff), np.zeros((len(W), 1, 3))
    forgets[:, 0, 0], forgets[:, 0, 1] = np.abs(speed) / springs.length1, np.abs(speed) / springs.length2
    stretch, rise = np.concatenate([G, -G * forgets], axis=2), -G[:, :, 2]
    lost = -G[:, 2] * np.broadcast_to(damping, len(W))[:, None]
    C, D = lost[:, :, None] * stretch[:, 2:], lost * rise[:, 2:]
    C[:, :, 3:] -= stiff
    share = 1 / (1 + D[:, 2:] / impedance)
    C, D = C - D[:, :, None] * (share * C[:, 2])[:, None] / impedance, D * share
    A = np.concatenate([W @ C, stretch - rise[:, :, None] * C[:, 2:] / impedance], axis=1)
    B = np.concatenate([(W @ D[:, :, None])[:, :, 0], rise * (1 - D[:, 2:] / impedance)], axis=1)
    return Linear(A, B, C, D)


def resonances(system: Linear) -> Resonances:
    """Return the three resonances of a linearised contact; one that is overdamped has frequency 0."""
    roots = np.linalg.eigvals(system.A)
    roots = np.take_along_axis(roots, np.argsort(roots.imag, axis=1), axis=1)[:, 3:]
    return Resonances(roots.imag / (2 * np.pi), -2 * roots.real / np.maximum(np.abs(roots), TINY))


class Suspension(NamedTuple):
    """Stiffness (3,) [N/m] along a_1, a_2, a_3, rates (3,) [1/s] at which the springs forget, damping (3,) [N s/m]:
    q' = u - forgets q, p = stiffness q + damping q'."""

    stiffness: np.ndarray
    forgets: np.ndarray
    damping: np.ndarray


def suspension(law: ContactLaw, inclination: float) -> Suspension:
    """Return the contact of a disk that rolls steadily, its centre fixed, at an inclination [rad].

    Raises ValueError where there is no such motion.
    """
    disk, beta = law.disk, np.array([inclination])
    springs, lost = law.springs(beta, disk.weight), damping(law, beta, disk.weight)[0]
    try:
        rate = steady_precession(inclination, disk.aspect, disk.gyration) / disk.time_unit
    except ValueError:
        raise ValueError(f"there is no steady motion at {np.degrees(inclination):g} degrees") from None
    speed = abs(disk.radius * rate * (np.cos(inclination) - disk.aspect * np.sin(inclination)))
    k1, k2, kn, length1, length2 = (float(value[0]) for value in springs)
    forgets = np.array([speed / length1, speed / length2, 0.0])
    return Suspension(np.array([k1, k2, kn]), forgets, np.array([0.0, 0.0, lost]))
