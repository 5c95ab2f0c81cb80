"""Linearised contact: resonances of the disk on the three springs of its contact.

Components are along a_1 (the rolling direction), a_2 (horizontal, towards the contact) and a_3 (the
vertical).
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.hertz_mindlin import ContactLaw, ContactSprings
from dynamics.disk import Disk
from dynamics.steady_motion import steady_precession

MIN_ROOT = 1e-300
"""Lower bound of |s| in the loss factor [1/s], which prevents division by zero."""
RIGID_FLEXIBILITY = np.zeros((3, 3))
"""Flexibility of a rigid disk [m/N]."""
MAX_RESONANCE_TURN = 1.0
"""Largest phase of the fastest resonance in one step [rad]."""
MAX_LOAD_RATIO = 4.0
"""Ratio of load to weight at which the required step rate is determined."""


class Resonances(NamedTuple):
    """Frequency [Hz], ascending, and loss factor 2|Re s|/|s| of the roots s, each (k, 3)."""

    frequency: np.ndarray
    loss_factor: np.ndarray


class LinearContact(NamedTuple):
    """Linear system x' = A x + B z', p = C x + D z' of the contact point.

    x (k, 6) holds velocities and spring deflections, z' [m/s] is the rise rate of the table under
    the contact, and p (k, 3) [N] the change of the contact force.
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray


def rigid_shapes(disk: Disk, inclination) -> np.ndarray:
    """Return the motion (k, 3, 6) [kg^-1/2] of the contact point in the six rigid modes of unit
    modal mass.

    The modes are three translations and the rotations about a_1, about the axis and about the
    diameter through the contact. The product with its transpose is the mobility W = 1/m - [r]x J^-1
    [r]x of the contact point.
    """
    beta = np.atleast_1d(np.asarray(inclination, dtype=float))
    J1, J2, R, H = *inertias(disk), disk.radius, disk.thickness / 2
    reach = R * np.cos(beta) - H * np.sin(beta)
    height = R * np.sin(beta) + H * np.cos(beta)
    shapes = np.zeros((len(beta), 3, 6))
    shapes[:, range(3), range(3)] = disk.mass**-0.5
    shapes[:, 1, 3] = height / J1**0.5
    shapes[:, 2, 3] = reach / J1**0.5
    shapes[:, 0, 4] = R / J2**0.5
    shapes[:, 0, 5] = H / J1**0.5
    return shapes


def inertias(disk: Disk) -> tuple[float, float]:
    """Return the moments of inertia [kg m^2] about a diameter and about the axis."""
    unit = disk.mass * disk.radius**2
    K = disk.gyration
    h = disk.aspect
    return unit * (K / 4 + h * h / 3), unit * K / 2


def mobility(disk: Disk, inclination) -> np.ndarray:
    """Return W (k, 3, 3) [1/kg]: acceleration of the contact point of the rigid disk under a unit
    force.
    """
    shapes = rigid_shapes(disk, inclination)
    return shapes @ shapes.swapaxes(1, 2)


def stiffness_matrix(springs: ContactSprings) -> np.ndarray:
    """Return diag(k1, k2, kn) (k, 3, 3) [N/m]."""
    return np.stack(
        np.broadcast_arrays(springs.k1, springs.k2, springs.kn),
        axis=-1,
    )[..., None] * np.eye(3)


def normal_damping(law: ContactLaw, inclination, load):
    """Return c [N s/m] that gives the normal resonance sqrt(kn W33) the loss factor of the law."""
    kn = law.springs(inclination, load).kn
    return law.loss_factor * np.sqrt(kn / mobility(law.disk, inclination)[:, 2, 2])


def required_step_rate(law: ContactLaw, inclination):
    """Return the steps per second (k,) at which the fastest resonance turns by MAX_RESONANCE_TURN
    in a step.
    """
    springs = law.springs(inclination, MAX_LOAD_RATIO * law.disk.weight)
    W = mobility(law.disk, inclination)
    return np.sqrt(springs.kn * W[:, 2, 2] + springs.k2 * W[:, 1, 1]) / MAX_RESONANCE_TURN


def linear_contact(
    disk: Disk,
    inclination,
    springs: ContactSprings,
    speed=0.0,
    damping=0.0,
    impedance=np.inf,
    flexibility=RIGID_FLEXIBILITY,
) -> LinearContact:
    """Return the linearised contact at inclinations (k,) [rad].

    Parameters
    ----------
    disk : Disk
        The disk.
    inclination : (k,) array
        Inclinations [rad].
    springs : Springs
        Springs of the contact.
    speed : float or (k,) array
        Speed of the contact along its path [m/s]; the tangential springs relax, q_t' = u_t - q_t
        V/l.
    damping : float or (k,) array
        Damping c along the normal [N s/m], to first order.
    impedance : float
        Impedance Z of the table [N s/m], q_z' = u_z - z' + N'/Z.
    flexibility : (k, 3, 3) array
        Flexibility F of the disk [m/N].

    Notes
    -----
    With G = (1 + F k)^-1: q' = G (u - q V/l - (z' - N'/Z) e_3) and p = -k q - G^T c q_z' e_3.
    """
    W = mobility(disk, inclination)
    stiff = stiffness_matrix(springs)
    G = np.linalg.inv(np.eye(3) + flexibility @ stiff)
    forgets = np.zeros((len(W), 1, 3))
    forgets[:, 0, 0] = np.abs(speed) / springs.length1
    forgets[:, 0, 1] = np.abs(speed) / springs.length2
    stretch = np.concatenate([G, -G * forgets], axis=2)
    rise = -G[:, :, 2]
    lost = -G[:, 2] * np.broadcast_to(damping, len(W))[:, None]
    C = lost[:, :, None] * stretch[:, 2:]
    D = lost * rise[:, 2:]
    C[:, :, 3:] -= stiff
    share = 1 / (1 + D[:, 2:] / impedance)
    C = C - D[:, :, None] * (share * C[:, 2])[:, None] / impedance
    D = D * share
    A = np.concatenate([W @ C, stretch - rise[:, :, None] * C[:, 2:] / impedance], axis=1)
    B = np.concatenate([(W @ D[:, :, None])[:, :, 0], rise * (1 - D[:, 2:] / impedance)], axis=1)
    return LinearContact(A, B, C, D)


def resonances(system: LinearContact) -> Resonances:
    """Return the three resonances of a linearised contact; an overdamped one has frequency 0."""
    roots = np.linalg.eigvals(system.A)
    roots = np.take_along_axis(roots, np.argsort(roots.imag, axis=1), axis=1)[:, 3:]
    return Resonances(
        roots.imag / (2 * np.pi),
        -2 * roots.real / np.maximum(np.abs(roots), MIN_ROOT),
    )


class Suspension(NamedTuple):
    """Springs and dampers of the contact along a_1, a_2, a_3: q' = u - forgets q, p = stiffness q +
    damping q'.

    `stiffness` (3,) [N/m], relaxation rates `forgets` (3,) [1/s], `damping` (3,) [N s/m].
    """

    stiffness: np.ndarray
    forgets: np.ndarray
    damping: np.ndarray


def suspension(law: ContactLaw, inclination: float) -> Suspension:
    """Return the contact of a disk that rolls steadily with its centre fixed at an inclination
    [rad].

    Raises ValueError if there is no such motion.
    """
    disk = law.disk
    beta = np.array([inclination])
    springs = law.springs(beta, disk.weight)
    lost = normal_damping(law, beta, disk.weight)[0]
    try:
        rate = steady_precession(inclination, disk.aspect, disk.gyration) / disk.time_unit
    except ValueError:
        raise ValueError(
            f"there is no steady motion at {np.degrees(inclination):g} degrees"
        ) from None
    speed = abs(disk.radius * rate * (np.cos(inclination) - disk.aspect * np.sin(inclination)))
    k1, k2, kn, length1, length2 = (float(value[0]) for value in springs)
    forgets = np.array([speed / length1, speed / length2, 0.0])
    return Suspension(np.array([k1, k2, kn]), forgets, np.array([0.0, 0.0, lost]))
