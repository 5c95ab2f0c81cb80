"""DISK ON ITS ELASTIC CONTACT -> MODES: free modes, the flexibility of those left out, three springs that creep.

Components are along a_1 (the rolling direction), a_2 (horizontal, towards the contact) and a_3 (the vertical); there
q'' + 2 d q' + w^2 q = B^T p, p = -k x - c x', and the springs x follow the contact point, B q + F p, but creep.
"""

from dataclasses import replace
from functools import lru_cache
from math import pi

import numpy as np
from scipy.optimize import linear_sum_assignment

from modal.elements.sample import places, polar_components, strongest_order
from modal.elements.unfold import rigid_fields
from modal.held import APART, richness_of
from modal.modes import Modes, UnsolvableError
from modal.spectral.axisymmetric import plate_modes
from modal.spectral.basis import Plate
from modal.synthesis.patches import FreeDisk
from modal.synthesis.regular import RESOLVED, regular_flexibility

TOO_STIFF = (
    "support.kind = 'contact': so stiff a contact is no longer small against the disk: it has no springs; "
    "hold the disk 'free' or by a 'patch'"
)
LOSSLESS, ROUND_OFF = 1e-6, 100 * np.finfo(float).eps
"""Growth of a mode over its angular frequency that is the round-off of one without loss; and over the greatest square
[1/s^2] of those that it is solved with, for softer springs."""


def contact_modes(plate: Plate, suspension, inclination: float, below: float, accuracy: str) -> Modes:
    """The `Modes` below `below` [Hz] of a solid free disk whose edge stands on springs, at an inclination [rad].

    Of the springs are given the stiffness (3,) [N/m], the rates (3,) [1/s] at which they forget what they are stretched
    by (`forgets`) and damping (3,) [N s/m]. The first three modes or fewer are the disk as a whole on its contact; a
    motion that creep stops before it swings is none. UnsolvableError where the springs are so stiff that they are no
    longer those of the contact alone.
    """
    free = with_rigid(plate, below, accuracy)
    turn = along_the_table(inclination)
    rest, doubt = left_out(plate, below, accuracy)
    rest = turn @ rest @ turn.T
    at_contact = turn @ free.rim_shape[:, 0].T
    yields = np.diag(1 / np.asarray(suspension.stiffness)) + rest
    if np.linalg.eigvalsh(yields)[0] <= 0:
        raise UnsolvableError(TOO_STIFF)
    matrix = np.diag((2 * pi * free.frequency) ** 2) + at_contact.T @ np.linalg.solve(yields, at_contact)
    square, shares = (part[..., 3:] for part in np.linalg.eigh(matrix))  # the first three turn about the contact
    roots, swings = ringing(free, at_contact, rest, suspension)
    mode, root = linear_sum_assignment(-(np.abs(shares.T @ swings) ** 2))
    mode, root = np.compress(roots.imag[root] < 2 * pi * below, [mode, root], axis=1)
    round_off = np.maximum(LOSSLESS * np.abs(roots[root]), ROUND_OFF * matrix.max())
    if (roots[root].real > round_off).any():  # what the body yields would give energy
        raise UnsolvableError(TOO_STIFF)
    square, shares = square[mode], shares[:, mode]
    force = turn.T @ np.linalg.solve(yields, at_contact @ shares)
    error = (doubt**0.5 @ np.abs(force)) ** 2 / (2 * square)
    error += (2 * pi * free.frequency) ** 2 * free.error @ shares**2 / square
    residual = np.linalg.norm(matrix @ shares / square - shares, axis=0)
    return superposed(free, shares.T, roots[root], error, residual)


def along_the_table(inclination):
    """The turn (3, 3) from components along x, y, z of the patch, -e_3, -e_1, e_2, to those along a_1, a_2, a_3."""
    s, c = np.sin(inclination), np.cos(inclination)
    return np.array([[0, -1, 0], [c, 0, s], [-s, 0, c]])


@lru_cache(maxsize=8)
def with_rigid(plate, below, accuracy) -> Modes:
    """The modes of the free disk up to APART times `below` [Hz] after its six motions as a rigid body, of frequency 0
    and modal mass 1."""
    elastic = plate_modes(plate, APART * below, accuracy)
    x, z = plate.mass * (plate.radius**2 / 4 + plate.thickness**2 / 12), plate.mass * plate.radius**2 / 2
    root = np.sqrt([plate.mass] * 3 + [x, x, z])
    rim, face = places(plate.radius)
    edge = np.column_stack([rim, np.full(len(rim), -plate.thickness / 2)])
    axial = rigid_fields(np.column_stack([face, 0 * face[:, 0]]))[..., 2].reshape(6, 1, *elastic.face_shape.shape[2:])
    unit = {
        "rim_shape": polar_components(rigid_fields(edge), elastic.rim_angle),
        "face_shape": np.repeat(axial, 2, axis=1),
        "participation": np.diag(root**2),
    }
    arrays = {name: np.zeros(6) for name in ("frequency", "decay_rate", "residual", "error")}
    arrays |= {name: (value.T / root).T for name, value in unit.items()}
    displacement = (rigid_fields(elastic.body.points).T / root).T
    return replace(
        elastic,
        **{name: np.concatenate([value, getattr(elastic, name)]) for name, value in arrays.items()},
        family=(*["extensional"] * 2, *["flexural"] * 3, "extensional", *elastic.family),
        parity=("even", "odd", "even", "odd", "even", "odd", *elastic.parity),
        body=replace(elastic.body, displacement=np.concatenate([displacement, elastic.body.displacement])),
    )


@lru_cache(maxsize=8)
def left_out(plate, below, accuracy):
    """Flexibility (3, 3) [m/N] at the bottom edge of the modes that `with_rigid` lacks, in the frame of the patch, and
    how much of its diagonal is in doubt (3,)."""
    disk = FreeDisk(plate=plate, richness=richness_of(accuracy))
    whole, doubt = regular_flexibility(disk, RESOLVED * plate.thickness)
    free = with_rigid(plate, below, accuracy)
    there = free.rim_shape[6:, 0].T / (2 * pi * free.frequency[6:])
    return whole - there @ there.T, doubt


def ringing(free, at_contact, rest, suspension):
    """The roots (r,) [1/s] with which the disk rings on springs that creep and lose, and its motions (n, r) in them.

    The unknowns are q', those q that are elastic, and x: to the first order in c, x' = G (B q' - x V/l) and
    p = -k x - G^T c x' with G = (1 + F k)^-1.
    """
    k, c, n = np.diag(suspension.stiffness), np.diag(suspension.damping), len(free)
    elastic = np.eye(n)[free.frequency > 0]
    follow = np.linalg.inv(np.eye(3) + rest @ k)
    springs = follow @ np.hstack([at_contact, np.zeros((3, len(elastic))), -np.diag(suspension.forgets)])
    force = -follow.T @ c @ springs - np.hstack([np.zeros((3, n + len(elastic))), k])
    own = np.hstack([-2 * np.diag(free.decay_rate), -(((2 * pi * free.frequency) ** 2) * elastic).T, np.zeros((n, 3))])
    follows = np.hstack([elastic, np.zeros((len(elastic), len(elastic) + 3))])
    roots, states = np.linalg.eig(np.vstack([own + at_contact.T @ force, follows, springs]))
    swings = roots.imag > 1e-6 * np.abs(roots)
    motion = states[:n, swings]
    return roots[swings], motion / np.linalg.norm(motion, axis=0)


def superposed(free, shares, roots, error, residual) -> Modes:
    """The `Modes` that are shares (m, n) of free ones and ring with roots (m,) [1/s], ascending."""
    ascending = np.argsort(roots.imag)
    shares, roots = shares[ascending], roots[ascending]
    names = ("participation", "rim_shape", "face_shape")
    mixed = {name: np.tensordot(shares, getattr(free, name), 1) for name in names}
    bends, even = shares**2 @ (np.array(free.family) == "flexural"), shares**2 @ (np.array(free.parity) == "even")
    return replace(
        free,
        **mixed,
        frequency=roots.imag / (2 * pi),
        decay_rate=np.maximum(-roots.real, 0.0),
        order=strongest_order(mixed["rim_shape"]),
        family=tuple(np.where(bends > 0.5, "flexural", "extensional").tolist()),
        parity=tuple(np.where(even > 0.5, "even", "odd").tolist()),
        partner=np.full(len(roots), -1),
        residual=residual[ascending],
        error=error[ascending],
        method="free modes and flexibility on the springs of the contact",
        body=replace(free.body, displacement=np.tensordot(shares, free.body.displacement, 1)),
    )
