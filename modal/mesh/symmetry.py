"""The mirror symmetries of a held disk: unknowns of each class, and the whole disk from a solved sector."""

from dataclasses import dataclass
from itertools import product

import numpy as np
import scipy.sparse as sp

COMPONENTS = ("radial", "tangential", "axial")


@dataclass(frozen=True, kw_only=True)
class Mirror:
    """One symmetry class: displacement even (1) or odd (-1) under y -> -y and under z -> -z (0: no such symmetry)."""

    y: int
    z: int

    def sign(self, flip_y, flip_z):
        """Factors (3,) of the displacement components at the mirror image of a point."""
        sign = np.ones(3)
        if flip_y:
            sign *= self.y * np.array([1, -1, 1])
        if flip_z:
            sign *= self.z * np.array([1, 1, -1])
        return sign

    def zero(self, points, scale):
        """Which components (p, 3) vanish because the point lies on a mirror plane."""
        on_y, on_z = np.abs(points[:, 1]) < 1e-9 * scale, np.abs(points[:, 2]) < 1e-9 * scale
        zero = on_y[:, None] & (self.sign(True, False) < 0)
        return zero | (on_z[:, None] & (self.sign(False, True) < 0)) if self.z else zero


def classes(quarter):
    """The four classes of a quarter model, the two of a half model."""
    return [Mirror(y=y, z=z) for y, z in product((1, -1), (1, -1) if quarter else (0,))]


def on_patch(points, radius, half_angle, patch):
    """Which points (p,) lie on the patch: the rim within half_angle [rad] between the heights patch = (low, high).

    Without a patch, None, none does.
    """
    if patch is None:
        return np.zeros(len(points), bool)
    x, y, z = points.T
    slack = 1e-9 * radius
    on_rim = np.abs(np.hypot(x, y) - radius) < slack
    inside = (z > patch[0] - slack) & (z < patch[1] + slack)
    return on_rim & inside & (np.abs(np.arctan2(y, x)) < half_angle + 1e-9)


def free_unknowns(points, held, components, mirror=None, scale=1.0):
    """T (3p, n): columns span the displacements that keep the class, if there is one, and leave the held components of
    the patch at zero.

    Nodes of the patch are turned to radial, tangential, axial components, all others stay Cartesian.
    """
    zero = mirror.zero(points, scale) if mirror else np.zeros((len(points), 3), bool)
    free = sp.identity(3 * len(points), format="csc")
    if set(components) != set(COMPONENTS):
        free = turned(points, held)
    zero[held] |= [c in components for c in COMPONENTS]
    return free[:, np.nonzero(~zero.ravel())[0]]


def turned(points, where):
    """Cartesian from cylindrical components at the marked nodes, identity elsewhere (3p, 3p)."""
    blocks = np.broadcast_to(np.eye(3), (len(points), 3, 3)).copy()
    angle = np.arctan2(points[where, 1], points[where, 0])
    blocks[where, 0, 0] = blocks[where, 1, 1] = np.cos(angle)
    blocks[where, 1, 0], blocks[where, 0, 1] = np.sin(angle), -np.sin(angle)
    return sp.bsr_matrix((blocks, np.arange(len(points)), np.arange(len(points) + 1))).tocsc()


def check_held(points, components):
    """ValueError if holding the named components at points (p, 3) leaves a rigid body free to move."""
    frame = turned(points, np.ones(len(points), bool))
    fields = np.concatenate([np.tile(np.eye(3), (len(points), 1, 1)), np.cross(np.eye(3), points[:, None])], axis=1)
    motion = (frame.T @ fields.transpose(0, 2, 1).reshape(-1, 6)).reshape(-1, 3, 6)
    seen = motion[:, [COMPONENTS.index(c) for c in components]].reshape(-1, 6)
    size = np.linalg.norm(motion.reshape(-1, 6), axis=0)
    strain = np.linalg.svd(seen / size, compute_uv=False)
    free = 6 - np.count_nonzero(strain > 1e-9 * strain[0])
    if free:
        raise ValueError(
            f"support.held = {list(components)} leaves the disk {free} rigid-body motion(s): hold more components"
        )
