"""Compute the modes of a disk on its elastic contact from free modes and residual
flexibility.

The contact is represented by three springs with creep. Components are along a_1 (the
rolling direction), a_2 (horizontal, towards the contact) and a_3 (vertical). The modes
satisfy q'' + 2 d q' + w^2 q = B^T p with the spring forces p = -k x - c x'. The spring
extensions x follow the contact point B q + F p and relax by creep.
"""

from dataclasses import replace
from functools import lru_cache
from math import pi
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from modal.elements.sample import polar_components, sample_points, strongest_order
from modal.mesh.symmetry import rigid_fields
from modal.modes import Modes, UnsolvableError
from modal.patch import FREE_MODE_CUTOFF_RATIO, synthesis_basis_sizes
from modal.spectral.axisymmetric import plate_modes
from modal.spectral.basis import Plate
from modal.synthesis.free_disk import FreeDisk
from modal.synthesis.residual_flexibility import (
    FINEST_STRIP_THICKNESS_RATIO,
    nonlocal_flexibility,
)

TOO_STIFF_MESSAGE = (
    "support.kind = 'contact': such a stiff contact cannot be represented by springs, because "
    "the disk is as flexible as the contact; use support.kind = 'free' or 'patch'"
)


def contact_modes(
    plate: Plate,
    suspension: Any,
    inclination: float,
    below: float,
    accuracy: str,
) -> Modes:
    """Return the `Modes` of a solid disk on the springs of its contact below a
    frequency [Hz].

    The disk has an inclination [rad]. `suspension` has stiffness (3,) [N/m], damping
    (3,) [N s/m], `relaxation_rate` (3,) [1/s] of the springs, and `offset` (3,) [m] of
    the contact from the sharp edge, to which the disk is rigidly connected. The first
    modes, at most three, are those of the rigid disk on its contact; overdamped motions
    are omitted. Raises UnsolvableError if the springs are so stiff that the compliance
    of the disk near the contact is comparable to theirs.
    """
    free = free_disk_rigid_elastic_modes(plate, below, accuracy)
    rotation = patch_to_contact_rotation(inclination)
    residual, doubt = residual_flexibility(plate, below, accuracy)
    residual = rotation @ residual @ rotation.T
    shapes = free.rim_shape[:, 0].copy()
    contact = np.array([[plate.radius, 0.0, -plate.thickness / 2]]) + suspension.offset
    shapes[:6] = rigid_fields(contact)[:, 0] / rigid_mass_roots(plate)[:, None]
    at_contact = rotation @ shapes.T
    flexibility = np.diag(1 / np.asarray(suspension.stiffness)) + residual
    if np.linalg.eigvalsh(flexibility)[0] <= 0:
        raise UnsolvableError(TOO_STIFF_MESSAGE)
    coupling = at_contact.T @ np.linalg.solve(flexibility, at_contact)
    matrix = np.diag((2 * pi * free.frequency) ** 2) + coupling
    square, shares = np.linalg.eigh(matrix)
    square = square[3:]
    shares = shares[:, 3:]  # the first three are rotations about the contact
    roots, motions = damped_roots(free, at_contact, residual, suspension)
    mode, root = linear_sum_assignment(-(np.abs(shares.T @ motions) ** 2))
    mode, root = np.compress(roots.imag[root] < 2 * pi * below, [mode, root], axis=1)
    if (roots[root].real > round_off_growth_limit(roots[root], matrix)).any():
        # a growing motion: the body would supply energy
        raise UnsolvableError(TOO_STIFF_MESSAGE)
    square = square[mode]
    shares = shares[:, mode]
    force = rotation.T @ np.linalg.solve(flexibility, at_contact @ shares)
    error = (doubt**0.5 @ np.abs(force)) ** 2 / (2 * square)
    error += (2 * pi * free.frequency) ** 2 * free.error @ shares**2 / square
    pair_residual = np.linalg.norm(matrix @ shares / square - shares, axis=0)
    return superposed_modes(free, shares.T, roots[root], error, pair_residual)


def round_off_growth_limit(roots: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """Return upper bounds (r,) [1/s] of growth rates caused by round-off."""
    return np.maximum(1e-6 * np.abs(roots), 100 * np.finfo(float).eps * matrix.max())


def patch_to_contact_rotation(inclination: float) -> np.ndarray:
    """Return the rotation (3, 3) from components in the patch frame to those along a_1,
    a_2, a_3."""
    s = np.sin(inclination)
    c = np.cos(inclination)
    return np.array(
        [
            [0, -1, 0],
            [c, 0, s],
            [-s, 0, c],
        ]
    )


@lru_cache(maxsize=8)
def free_disk_rigid_elastic_modes(plate: Plate, below: float, accuracy: str) -> Modes:
    """Return the `Modes` of the free disk, preceded by its six rigid-body modes.

    The rigid-body modes have the frequency 0 and unit modal mass. The elastic modes are
    those below FREE_MODE_CUTOFF_RATIO times `below` [Hz].
    """
    elastic = plate_modes(plate, FREE_MODE_CUTOFF_RATIO * below, accuracy)
    root = rigid_mass_roots(plate)
    rim, face = sample_points(plate.radius)
    edge = np.column_stack([rim, np.full(len(rim), -plate.thickness / 2)])
    axial = rigid_fields(np.column_stack([face, 0 * face[:, 0]]))[..., 2]
    axial = axial.reshape(6, 1, *elastic.face_shape.shape[2:])
    unit_motions = {
        "rim_shape": polar_components(rigid_fields(edge), elastic.rim_angle),
        "face_shape": np.repeat(axial, 2, axis=1),
        "participation": np.diag(root**2),
    }
    arrays: dict[str, Any] = {
        name: np.zeros(6) for name in ("frequency", "decay_rate", "residual", "error")
    }
    arrays |= {name: (value.T / root).T for name, value in unit_motions.items()}
    displacement = (rigid_fields(elastic.body.points).T / root).T
    for name, of_rigid_body in arrays.items():
        arrays[name] = np.concatenate([of_rigid_body, getattr(elastic, name)])
    return replace(
        elastic,
        **arrays,
        family=(
            *["extensional"] * 2,
            *["flexural"] * 3,
            "extensional",
            *elastic.family,
        ),
        parity=("even", "odd", "even", "odd", "even", "odd", *elastic.parity),
        body=replace(
            elastic.body,
            displacement=np.concatenate([displacement, elastic.body.displacement]),
        ),
    )


def rigid_mass_roots(plate: Plate) -> np.ndarray:
    """Return the square roots (6,) of masses and moments of inertia of the rigid-body
    motions."""
    about_diameter = plate.mass * (plate.radius**2 / 4 + plate.thickness**2 / 12)
    about_axis = plate.mass * plate.radius**2 / 2
    return np.sqrt([plate.mass] * 3 + [about_diameter, about_diameter, about_axis])


@lru_cache(maxsize=8)
def residual_flexibility(
    plate: Plate, below: float, accuracy: str
) -> tuple[np.ndarray, np.ndarray]:
    """Return the flexibility (3, 3) [m/N] of the omitted modes at the bottom edge, and
    its uncertainty.

    Components are in the patch frame. The uncertainty (3,) is that of the diagonal;
    modes above those of `free_disk_rigid_elastic_modes` are omitted there.
    """
    disk = FreeDisk(plate=plate, richness=synthesis_basis_sizes(accuracy))
    whole, doubt = nonlocal_flexibility(
        disk, FINEST_STRIP_THICKNESS_RATIO * plate.thickness
    )
    free = free_disk_rigid_elastic_modes(plate, below, accuracy)
    at_edge = free.rim_shape[6:, 0].T / (2 * pi * free.frequency[6:])
    return whole - at_edge @ at_edge.T, doubt


def damped_roots(
    free: Modes, at_contact: np.ndarray, residual: np.ndarray, suspension: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Return the roots (r,) [1/s] and shapes (n, r) of oscillations on springs with
    creep and damping.

    The unknowns are q', the elastic q, and x. To first order in c, x' = G (B q' - x
    V/l) and p = -k x - G^T c x' with G = (1 + F k)^-1.
    """
    k = np.diag(suspension.stiffness)
    c = np.diag(suspension.damping)
    n = len(free)
    elastic = np.eye(n)[free.frequency > 0]
    m = len(elastic)
    g = np.linalg.inv(np.eye(3) + residual @ k)
    spring_rates = g @ np.hstack(
        [at_contact, np.zeros((3, m)), -np.diag(suspension.relaxation_rate)]
    )
    force = -g.T @ c @ spring_rates - np.hstack([np.zeros((3, n + m)), k])
    elastic_stiffness = (((2 * pi * free.frequency) ** 2) * elastic).T
    acceleration = np.hstack(
        [-2 * np.diag(free.decay_rate), -elastic_stiffness, np.zeros((n, 3))]
    )
    velocity = np.hstack([elastic, np.zeros((m, m + 3))])
    roots, states = np.linalg.eig(
        np.vstack([acceleration + at_contact.T @ force, velocity, spring_rates]),
    )
    oscillating = roots.imag > 1e-6 * np.abs(roots)
    motion = states[:n, oscillating]
    return roots[oscillating], motion / np.linalg.norm(motion, axis=0)


def superposed_modes(
    free: Modes,
    shares: np.ndarray,
    roots: np.ndarray,
    error: np.ndarray,
    residual: np.ndarray,
) -> Modes:
    """Return `Modes`, in ascending order, with coefficients (m, n) of free modes and
    roots (m,) [1/s]."""
    ascending = np.argsort(roots.imag)
    shares = shares[ascending]
    roots = roots[ascending]
    names = ("participation", "rim_shape", "face_shape")
    superposed: dict[str, Any] = {
        name: np.tensordot(shares, getattr(free, name), 1) for name in names
    }
    flexural_share = shares**2 @ (np.array(free.family) == "flexural")
    even_share = shares**2 @ (np.array(free.parity) == "even")
    return replace(
        free,
        **superposed,
        frequency=roots.imag / (2 * pi),
        decay_rate=np.maximum(-roots.real, 0.0),
        order=strongest_order(superposed["rim_shape"]),
        family=tuple(
            np.where(flexural_share > 0.5, "flexural", "extensional").tolist()
        ),
        parity=tuple(np.where(even_share > 0.5, "even", "odd").tolist()),
        partner=np.full(len(roots), -1),
        residual=residual[ascending],
        error=error[ascending],
        method="free modes and flexibility on the springs of the contact",
        body=replace(
            free.body, displacement=np.tensordot(shares, free.body.displacement, 1)
        ),
    )
