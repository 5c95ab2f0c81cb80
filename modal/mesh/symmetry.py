"""Define the mirror symmetries of a held disk and the unknowns of each symmetry
class."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import scipy.sparse as sp

COMPONENTS = ("radial", "tangential", "axial")
"""Components of the displacement in cylindrical coordinates."""


@dataclass(frozen=True, kw_only=True)
class Mirror:
    """Symmetry class of displacements, even (1) or odd (-1) in y and in z.

    z is 0 if the disk is not symmetric in z."""

    y: int
    z: int

    def component_signs(self, flip_y: bool, flip_z: bool) -> np.ndarray:
        """Return the sign factors (3,) of the displacement components at the mirror
        image of a point."""
        sign = np.ones(3)
        if flip_y:
            sign *= self.y * np.array([1, -1, 1])
        if flip_z:
            sign *= self.z * np.array([1, 1, -1])
        return sign

    def vanishing_components(self, points: np.ndarray, scale: float) -> np.ndarray:
        """Return the mask (p, 3) of components that vanish by symmetry at points (p, 3)
        on mirror planes."""
        on_y = np.abs(points[:, 1]) < 1e-9 * scale
        vanishing = on_y[:, None] & (self.component_signs(True, False) < 0)
        if not self.z:
            return vanishing
        on_z = np.abs(points[:, 2]) < 1e-9 * scale
        return vanishing | (on_z[:, None] & (self.component_signs(False, True) < 0))


def symmetry_classes(quarter: bool) -> list[Mirror]:
    """Return the four `Mirror` classes of a quarter model or the two of a half
    model."""
    z_signs = (1, -1) if quarter else (0,)
    return [Mirror(y=y, z=z) for y, z in product((1, -1), z_signs)]


def patch_node_mask(
    points: np.ndarray,
    radius: float,
    half_angle: float,
    patch: tuple[float, float] | None,
) -> np.ndarray:
    """Return the mask (p,) of points on the patch.

    The patch is the part of the rim within `half_angle` [rad] and between two heights
    [m], or None.
    """
    if patch is None:
        return np.zeros(len(points), bool)
    x, y, z = points.T
    tolerance = 1e-9 * radius
    on_rim = np.abs(np.hypot(x, y) - radius) < tolerance
    inside = (z > patch[0] - tolerance) & (z < patch[1] + tolerance)
    return on_rim & inside & (np.abs(np.arctan2(y, x)) < half_angle + 1e-9)


def admissible_displacements(
    points: np.ndarray,
    held: np.ndarray,
    components: Sequence[str],
    mirror: Mirror | None = None,
    scale: float = 1.0,
) -> sp.csr_matrix:
    """Return a matrix (3p, n) whose columns span the admissible displacements of a
    symmetry class.

    `held` (p,) marks the nodes on the patch, and `components` contains the names of the
    components that vanish there. If `mirror` is None, no symmetry is used. Columns of
    nodes on the patch are cylindrical components, all others Cartesian ones.
    """
    vanishing = np.zeros((len(points), 3), bool)
    if mirror:
        vanishing = mirror.vanishing_components(points, scale)
    free = sp.identity(3 * len(points), format="csc")
    if set(components) != set(COMPONENTS):
        free = cartesian_from_cylindrical(points, held)
    vanishing[held] |= [c in components for c in COMPONENTS]
    return free[:, np.nonzero(~vanishing.ravel())[0]]


def cartesian_from_cylindrical(points: np.ndarray, marked: np.ndarray) -> sp.csc_matrix:
    """Return the matrix (3p, 3p) from cylindrical to Cartesian components at marked
    nodes.

    It is the identity at all other nodes."""
    blocks = np.broadcast_to(np.eye(3), (len(points), 3, 3)).copy()
    angle = np.arctan2(points[marked, 1], points[marked, 0])
    blocks[marked, 0, 0] = np.cos(angle)
    blocks[marked, 1, 1] = np.cos(angle)
    blocks[marked, 1, 0] = np.sin(angle)
    blocks[marked, 0, 1] = -np.sin(angle)
    return sp.bsr_matrix(
        (blocks, np.arange(len(points)), np.arange(len(points) + 1))
    ).tocsc()


def rigid_fields(points: np.ndarray) -> np.ndarray:
    """Return the displacements (6, p, 3) of unit translations along x, y, z and unit
    rotations about them."""
    unit = np.eye(3)[:, None]
    return np.concatenate(
        [np.broadcast_to(unit, (3, len(points), 3)), np.cross(unit, points[None])],
    )


def check_no_rigid_motion(points: np.ndarray, components: Sequence[str]) -> None:
    """Raise ValueError if components held at points (p, 3) do not prevent all
    rigid-body motions."""
    frame = cartesian_from_cylindrical(points, np.ones(len(points), bool))
    columns = rigid_fields(points).reshape(6, -1).T
    motion = (frame.T @ columns).reshape(-1, 3, 6)
    at_held = motion[:, [COMPONENTS.index(c) for c in components]].reshape(-1, 6)
    size = np.linalg.norm(motion.reshape(-1, 6), axis=0)
    singular_values = np.linalg.svd(at_held / size, compute_uv=False)
    free = 6 - np.count_nonzero(singular_values > 1e-9 * singular_values[0])
    if free:
        raise ValueError(
            f"support.held = {list(components)} leaves the disk {free} rigid-body motion(s); hold "
            f"more components",
        )
