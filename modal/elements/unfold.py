"""Assemble the whole disk and its `Modes` from the symmetry classes of a sector."""

from itertools import product
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from modal.elements import sample
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.sector import HEXAHEDRON_NODES, Sector
from modal.mesh.symmetry import rigid_fields
from modal.modes import Modes

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

    from modal.elements.elastic import Solid
    from modal.elements.patch import SolvedSymmetryClass
    from modal.spectral.basis import Plate


def mirror_flips(quarter: bool) -> list[tuple[bool, bool]]:
    """Return pairs of flags, True if y or z is reversed, for the images of a quarter or
    half disk."""
    return list(product((False, True), (False, True) if quarter else (False,)))


def whole_mesh(
    points: np.ndarray, cells: np.ndarray, quarter: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return nodes (p', 3), cells (c', 27) and node sources (p', 2) of the whole disk.

    Cells are in VTK's order. The source of a node is its node in the sector and the
    index of its image in `mirror_flips`.
    """
    lattice = {tuple(node): i for i, node in enumerate(HEXAHEDRON_NODES)}
    images = []
    numbers = []
    sources = []
    for index, flip in enumerate(mirror_flips(quarter)):
        is_left_handed = sum(flip) == 1
        order = [
            lattice[(2 - i, j, k) if is_left_handed else (i, j, k)]
            for i, j, k in VTK_HEXAHEDRON27
        ]
        images.append(points * mirror_factors(flip))
        numbers.append(cells[:, order] + index * len(points))
        sources.append(
            np.stack([np.arange(len(points)), np.full(len(points), index)], axis=1)
        )
    points, cells, source = (
        np.concatenate(part) for part in (images, numbers, sources)
    )
    keys = np.rint(points / np.abs(points).max() * 1e10).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return points[first], inverse.ravel()[cells], source[first]


def mirror_factors(flip: tuple[bool, bool]) -> np.ndarray:
    """Return factors (3,) that map a point to its mirror image."""
    return np.where([False, *flip], -1.0, 1.0)


def participation(
    solid: "Solid", quarter: bool, c: "SolvedSymmetryClass"
) -> np.ndarray:
    """Return the participation phi^T M r (k, 6) of the modes of a class in the six
    rigid-body fields.

    The fields of all mirror images are mapped onto the sector and summed."""
    images = (
        c.mirror.component_signs(*flip)
        * rigid_fields(solid.points * mirror_factors(flip))
        for flip in mirror_flips(quarter)
    )
    gathered = sum(images).reshape(6, -1)
    return c.shapes.reshape(len(c.shapes), 3 * len(solid.points)) @ (
        solid.mass @ gathered.T
    )


def is_flexural(solid: "Solid", part: Sector, c: "SolvedSymmetryClass") -> np.ndarray:
    """Return a mask (k,) of the flexural modes of a class.

    It follows from the symmetry in z if there is one, and otherwise from the fraction
    of axial motion in the modal mass.
    """
    if c.mirror.z:
        return np.full(len(c.shapes), c.mirror.z < 0)
    return part.mirror_image_count * axial_share(solid, c.shapes) > 0.5


def axial_share(solid: "Solid", shapes: np.ndarray) -> np.ndarray:
    """Return the fraction (k,) of axial motion in the modal mass of shapes (k, p,
    3)."""
    axial = (shapes * [0, 0, 1]).reshape(len(shapes), 3 * len(solid.points))
    return np.einsum("kp,kp->k", axial, (solid.mass @ axial.T).T)


def side_nodes(axis: int, end: int) -> list[int]:
    """Return the nine nodes of a hexahedron, a grid of 3 x 3, on its side at `end` (0
    or 2) of an axis."""
    return [
        i for i in np.lexsort(HEXAHEDRON_NODES.T) if HEXAHEDRON_NODES[i, axis] == end
    ]


HEXAHEDRON_SIDES = [[side_nodes(axis, end) for end in (0, 2)] for axis in range(3)]
"""Nodes of the two sides of a hexahedron in each of the three directions."""


def face_interpolation(
    solid: "Solid", points: np.ndarray, height: float
) -> "csr_matrix":
    """Return the sparse matrix (n, p) from nodal values to values at points (n, 2) of a
    face of the sector.

    The face is at a height [m], and the points have y >= 0.
    """
    level = np.abs(solid.points[:, 2] - height) < 1e-9 * np.abs(solid.points).max()
    sides = np.concatenate(
        [solid.cells[:, side] for pair in HEXAHEDRON_SIDES for side in pair]
    )
    numbers = sides[level[sides].all(axis=1)].reshape(-1, 3, 3)
    return sample.interpolation_matrix(
        points,
        solid.points[numbers][..., :2],
        numbers,
        len(solid.points),
    )


def bottom_and_top_interpolation(
    solid: "Solid", part: Sector, points: np.ndarray
) -> "tuple[csr_matrix, csr_matrix]":
    """Return the matrices of `face_interpolation` for bottom and top face; they are
    equal for a quarter disk."""
    folded = np.stack([points[:, 0], np.abs(points[:, 1])], axis=1)
    points = np.round(folded, 15)
    distinct, position = np.unique(points, axis=0, return_inverse=True)
    z = solid.points[:, 2]
    top = face_interpolation(solid, distinct, z.max())[position.ravel()]
    if part.quarter:
        return top, top
    return face_interpolation(solid, distinct, z.min())[position.ravel()], top


def displacement_on_faces(
    matrices: "tuple[csr_matrix, csr_matrix]",
    points: np.ndarray,
    quarter: bool,
    c: "SolvedSymmetryClass",
) -> np.ndarray:
    """Return the displacements (k, 2, n, 3) of a class at points (n, 2) of bottom and
    top face."""
    k = len(c.shapes)
    p = matrices[0].shape[1]
    nodes = c.shapes.transpose(1, 0, 2).reshape(p, 3 * k)
    values = [
        (matrix @ nodes).reshape(len(points), k, 3).transpose(1, 0, 2)
        for matrix in matrices
    ]
    signs = [
        c.mirror.component_signs(flip_y, quarter and is_bottom)
        for is_bottom, flip_y in product((True, False), (False, True))
    ]
    side = (points[:, 1] < 0).astype(int)
    return np.stack(values, axis=1) * np.reshape(signs, (2, 2, 3))[:, side]


def symmetry_class_arrays(
    solid: "Solid",
    part: Sector,
    c: "SolvedSymmetryClass",
    rim: "tuple[tuple[csr_matrix, csr_matrix], np.ndarray]",
    face: "tuple[tuple[csr_matrix, csr_matrix], np.ndarray]",
) -> dict[str, np.ndarray]:
    """Return the arrays (k, ...) of `Modes` for one symmetry class.

    `rim` and `face` are pairs (interpolation matrices, points).
    """
    matrices, rim_points = rim
    rim_displacement = displacement_on_faces(matrices, rim_points, part.quarter, c)[
        :, 0
    ]
    rim_shape = sample.polar_components(rim_displacement, sample.rim_angles())
    matrices, face_points = face
    axial = displacement_on_faces(matrices, face_points, part.quarter, c)[..., 2]
    return {
        "frequency": np.sqrt(c.values) / (2 * pi),
        "order": sample.strongest_order(rim_shape),
        "family": np.where(is_flexural(solid, part, c), "flexural", "extensional"),
        "parity": np.full(len(c.shapes), "even" if c.mirror.y > 0 else "odd"),
        "participation": participation(solid, part.quarter, c),
        "rim_shape": rim_shape,
        "face_shape": axial,
        "residual": c.residual,
    }


def whole_disk_modes(
    part: Sector,
    solid: "Solid",
    solved: "list[SolvedSymmetryClass]",
    error: np.ndarray,
    plate: "Plate",
) -> Modes:
    """Return the `Modes` of all symmetry classes; `error` (m,) is in the order of the
    classes."""
    rim_points, face_points = sample.sample_points(plate.radius)
    rim = bottom_and_top_interpolation(solid, part, rim_points), rim_points
    face = bottom_and_top_interpolation(solid, part, face_points), face_points
    by_class = [symmetry_class_arrays(solid, part, c, rim, face) for c in solved]
    columns = {
        name: np.concatenate([c[name] for c in by_class]) for name in by_class[0]
    }
    points, cells, source = whole_mesh(solid.points, solid.cells, part.quarter)
    shapes = []
    for c in solved:
        sign = np.array(
            [c.mirror.component_signs(*flip) for flip in mirror_flips(part.quarter)]
        )
        shapes.append(c.shapes[:, source[:, 0]] * sign[source[:, 1]])
    return sample.sorted_modes(
        columns | {"error": error, "displacement": np.concatenate(shapes)},
        plate.material,
        plate.radius,
        points,
        cells,
        mass=part.mirror_image_count * solid.total_mass,
        method="finite elements",
        unknowns=3 * len(points),
    )
