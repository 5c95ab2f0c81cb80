"""Linearised contact: resonances of the disk on the three springs of its contact.

Components are along the rolling direction a_1, the horizontal a_2 towards the contact,
and the vertical a_3.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dynamics.compliant.law.hertz_mindlin import ContactLaw, ContactSprings
from dynamics.disk import Disk, inertias
from dynamics.kinematics import contact_place_in_metres
from dynamics.steady_motion import steady_precession

RIGID_FLEXIBILITY = np.zeros((3, 3))
"""Flexibility of a rigid disk [m/N]."""


class Resonances(NamedTuple):
    """Ascending frequencies (k, 3) [Hz] and loss factors 2|Re s|/|s| (k, 3) of roots s."""

    frequency: np.ndarray
    loss_factor: np.ndarray


class LinearContact(NamedTuple):
    """Linear system x' = A x + B z', p = C x + D z' of the contact point.

    x (k, 6) contains velocities and spring deflections, z' [m/s] is the rate at which
    the table rises under the contact, and p (k, 3) [N] is the change of the contact
    force.
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray


def rigid_mode_shapes(
    disk: Disk, inclination: ArrayLike, fillet: float = 0.0
) -> np.ndarray:
    """Return the displacements (k, 3, 6) [kg^-1/2] of the contact point in rigid modes.

    The six modes have unit modal mass. They are three translations and the rotations
    about a_1, about the axis and about the diameter through the contact, on an edge
    with the radius `fillet` [m]. The product with the transpose is the mobility W = 1/m
    - [r]x J^-1 [r]x of the contact point.
    """
    beta = np.atleast_1d(np.asarray(inclination, dtype=float))
    J1, J2 = inertias(disk)
    radius, depth, height, lever = contact_place_in_metres(
        disk, fillet, np.cos(beta), np.sin(beta)
    )
    shapes = np.zeros((len(beta), 3, 6))
    shapes[:, range(3), range(3)] = disk.mass**-0.5
    shapes[:, 1, 3] = height / J1**0.5
    shapes[:, 2, 3] = -lever / J1**0.5
    shapes[:, 0, 4] = radius / J2**0.5
    shapes[:, 0, 5] = depth / J1**0.5
    return shapes


def mobility(disk: Disk, inclination: ArrayLike, fillet: float = 0.0) -> np.ndarray:
    """Return the acceleration W (k, 3, 3) [1/kg] of the contact point per unit force."""
    shapes = rigid_mode_shapes(disk, inclination, fillet)
    return shapes @ shapes.swapaxes(1, 2)


def stiffness_matrix(springs: ContactSprings) -> np.ndarray:
    """Return the diagonal matrices (k, 3, 3) [N/m] of k1, k2, kn."""
    return np.stack(
        np.broadcast_arrays(springs.k1, springs.k2, springs.kn),
        axis=-1,
    )[..., None] * np.eye(3)


def normal_damping(
    law: ContactLaw, inclination: ArrayLike, load: ArrayLike
) -> np.ndarray:
    """Return the damping c (k,) [N s/m] for the loss factor of the normal resonance."""
    kn = law.springs(inclination, load).kn
    return law.loss_factor * np.sqrt(
        kn / mobility(law.disk, inclination, law.rolling_fillet)[:, 2, 2]
    )


def required_step_rate(law: ContactLaw, inclination: ArrayLike) -> np.ndarray:
    """Return the step rate (k,) [1/s] required by the fastest contact resonance."""
    max_load_ratio = (
        4.0  # ratio of load to weight for which the step rate is determined
    )
    max_resonance_phase = (
        1.0  # largest phase of the fastest resonance in one step [rad]
    )
    springs = law.springs(inclination, max_load_ratio * law.disk.weight)
    W = mobility(law.disk, inclination, law.rolling_fillet)
    return (
        np.sqrt(springs.kn * W[:, 2, 2] + springs.k2 * W[:, 1, 1]) / max_resonance_phase
    )


def linear_contact(
    disk: Disk,
    inclination: ArrayLike,
    springs: ContactSprings,
    speed: ArrayLike = 0.0,
    damping: ArrayLike = 0.0,
    flexibility: np.ndarray = RIGID_FLEXIBILITY,
    fillet: float = 0.0,
) -> LinearContact:
    """Return the linearised contact at inclinations (k,) [rad].

    Parameters
    ----------
    disk : Disk
        The disk.
    inclination : (k,) array
        Inclinations [rad].
    springs : Springs
        Linearised contact springs.
    speed : float or (k,) array
        Speed V of the contact along its path [m/s]. The tangential springs relax over
        the relaxation length l of the path: q_t' = u_t - q_t V/l.
    damping : float or (k,) array
        Damping c along the normal [N s/m].
    flexibility : (k, 3, 3) array
        Flexibility F of the disk [m/N].
    fillet : float
        Radius of the edge [m].

    Notes
    -----
    With G = (1 + F k)^-1, q' = G (u - q V/l - z' e_3) and p = -k q - G^T c q_z' e_3, to
    first order in c.
    """
    W = mobility(disk, inclination, fillet)
    stiff = stiffness_matrix(springs)
    G = np.linalg.inv(np.eye(3) + flexibility @ stiff)
    relaxation_rate = np.zeros((len(W), 1, 3))
    relaxation_rate[:, 0, 0] = np.abs(speed) / springs.length1
    relaxation_rate[:, 0, 1] = np.abs(speed) / springs.length2
    stretch = np.concatenate([G, -G * relaxation_rate], axis=2)
    rise = -G[:, :, 2]
    lost = -G[:, 2] * np.broadcast_to(damping, len(W))[:, None]
    C = lost[:, :, None] * stretch[:, 2:]
    D = lost * rise[:, 2:]
    C[:, :, 3:] -= stiff
    A = np.concatenate([W @ C, stretch], axis=1)
    acceleration = (W @ D[:, :, None])[:, :, 0]
    B = np.concatenate([acceleration, rise], axis=1)
    return LinearContact(A, B, C, D)


def resonances(system: LinearContact) -> Resonances:
    """Return the three resonances of a contact; overdamped ones have frequency 0."""
    # lower bound of |s| [1/s], which avoids division by zero
    min_root = 1e-300
    roots = np.linalg.eigvals(system.A)
    roots = np.take_along_axis(roots, np.argsort(roots.imag, axis=1), axis=1)[:, 3:]
    return Resonances(
        roots.imag / (2 * np.pi),
        -2 * roots.real / np.maximum(np.abs(roots), min_root),
    )


class Suspension(NamedTuple):
    """Springs and dampers of the contact along a_1, a_2, a_3.

    They obey q' = u - relaxation_rate q and p = stiffness q + damping q', with
    `stiffness` [N/m], `relaxation_rate` [1/s] and `damping` [N s/m], (3,) each.
    `offset` (3,) [m] is the distance of the contact from the sharp edge along the
    radius, the rim and the axis.
    """

    stiffness: np.ndarray
    relaxation_rate: np.ndarray
    damping: np.ndarray
    offset: np.ndarray


def suspension(law: ContactLaw, inclination: float) -> Suspension:
    """Return the contact of a disk in steady motion at an inclination [rad].

    Raises ValueError if there is no steady motion.
    """
    disk = law.disk
    beta = np.array([inclination])
    springs = law.springs(beta, disk.weight)
    lost = normal_damping(law, beta, disk.weight)[0]
    try:
        ratio = law.rolling_fillet / disk.radius
        rate = (
            steady_precession(inclination, disk.aspect, disk.gyration, ratio)
            / disk.time_unit
        )
    except ValueError:
        raise ValueError(
            f"there is no steady motion at {np.degrees(inclination):g} degrees"
        ) from None
    speed = abs(law.place(inclination).f * rate)
    k1, k2, kn, length1, length2 = (float(value[0]) for value in springs)
    relaxation_rate = np.array([speed / length1, speed / length2, 0.0])
    damping = np.array([0.0, 0.0, lost])
    place = law.place(inclination)
    offset = np.array(
        [place.radius - disk.radius, 0.0, disk.thickness / 2 - place.depth]
    )
    return Suspension(np.array([k1, k2, kn]), relaxation_rate, damping, offset)
