"""The whole disk from the solved sector of its symmetry classes, and the record of its modes."""

from itertools import product
from math import pi

import numpy as np

from modal.elements import sample
from modal.mesh.hexahedron import VTK_HEXAHEDRON27
from modal.mesh.sector import NODES
from modal.modes import Modes


def flips(quarter):
    """The mirror images that make the whole disk."""
    return list(product((False, True), (False, True) if quarter else (False,)))


def whole_mesh(points, cells, quarter):
    """Nodes (p', 3) and cells (c', 27) in VTK's order of the whole disk, and which image holds which node.

    Returns points, cells, and source (p', 2): the node of the sector and the index into `flips` that it is an image of.
    """
    lattice = {tuple(node): i for i, node in enumerate(NODES)}
    images, numbers, source = [], [], []
    for index, flip in enumerate(flips(quarter)):
        order = [(2 - i, j, k) if sum(flip) == 1 else (i, j, k) for i, j, k in VTK_HEXAHEDRON27]
        images.append(points * mirror_of(flip))
        numbers.append(cells[:, [lattice[node] for node in order]] + index * len(points))
        source.append(np.stack([np.arange(len(points)), np.full(len(points), index)], axis=1))
    points, cells, source = (np.concatenate(part) for part in (images, numbers, source))
    keys = np.rint(points / np.abs(points).max() * 1e10).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return points[first], inverse.ravel()[cells], source[first]


def mirror_of(flip):
    """Factors (3,) that take a point to its mirror image."""
    return np.where([False, *flip], -1.0, 1.0)


def rigid_fields(points):
    """Displacements (6, p, 3) of unit translations along and rotations about x, y, z through the origin."""
    unit = np.eye(3)[:, None]
    return np.concatenate([np.broadcast_to(unit, (3, len(points), 3)), np.cross(unit, points[None])])


def participation(solid, quarter, c):
    """phi^T M r (k, 6) over the whole disk: the images of the rigid fields, gathered on the sector."""
    images = [c.mirror.sign(*flip) * rigid_fields(solid.points * mirror_of(flip)) for flip in flips(quarter)]
    gathered = sum(images).reshape(6, -1)
    return c.shapes.reshape(len(c.shapes), 3 * len(solid.points)) @ (solid.mass @ gathered.T)


def flexural(solid, part, c):
    """Whether each mode (k,) of a class bends the disk: by its symmetry in z, else if most of its energy is axial."""
    if c.mirror.z:
        return np.full(len(c.shapes), c.mirror.z < 0)
    return part.copies * axial_share(solid, c.shapes) > 0.5


def axial_share(solid, shapes):
    """How much (k,) of the modal mass of shapes (k, p, 3) is that of their axial motion."""
    axial = (shapes * [0, 0, 1]).reshape(len(shapes), 3 * len(solid.points))
    return np.einsum("kp,kp->k", axial, (solid.mass @ axial.T).T)


FACES = [[[i for i in np.lexsort(NODES.T) if NODES[i, a] == end] for end in (0, 2)] for a in range(3)]
"""For each of the three directions the nine nodes of a hexahedron on either side, a grid of 3 x 3."""


def face_matrix(solid, points, height):
    """Sparse (n, p): values at points (n, 2) with y >= 0 of the sector's face at a height [m]."""
    level = np.abs(solid.points[:, 2] - height) < 1e-9 * np.abs(solid.points).max()
    sides = np.concatenate([solid.cells[:, side] for pair in FACES for side in pair])
    numbers = sides[level[sides].all(axis=1)].reshape(-1, 3, 3)
    return sample.interpolation(points, solid.points[numbers][..., :2], numbers, len(solid.points))


def face_matrices(solid, part, points):
    """The matrix of `face_matrix` for the bottom and the top face at points (n, 2), for a quarter the same."""
    points = np.round(np.stack([points[:, 0], np.abs(points[:, 1])], axis=1), 15)
    once, repeated = np.unique(points, axis=0, return_inverse=True)
    low, high = solid.points[:, 2].min(), solid.points[:, 2].max()
    top = face_matrix(solid, once, high)[repeated.ravel()]
    return (top if part.quarter else face_matrix(solid, once, low)[repeated.ravel()]), top


def on_faces(matrices, points, quarter, c):
    """Displacement (k, 2, n, 3) of one class at points (n, 2) of the bottom and the top face."""
    k, p = len(c.shapes), matrices[0].shape[1]
    nodes = c.shapes.transpose(1, 0, 2).reshape(p, 3 * k)
    values = [(matrix @ nodes).reshape(len(points), k, 3).transpose(1, 0, 2) for matrix in matrices]
    signs = [[c.mirror.sign(y, quarter and bottom) for y in (False, True)] for bottom in (True, False)]
    return np.stack(values, axis=1) * np.array(signs)[:, (points[:, 1] < 0).astype(int)]


def unfold_class(solid, part, c, rim, face):
    """The columns of `Modes` that one class contributes, arrays (k, ...); rim, face: (matrices, points)."""
    rim_shape = sample.polar_components(on_faces(*rim, part.quarter, c)[:, 0], sample.rim_angles())
    axial = on_faces(*face, part.quarter, c)[..., 2]
    return {
        "frequency": np.sqrt(c.values) / (2 * pi),
        "order": sample.strongest_order(rim_shape),
        "family": np.where(flexural(solid, part, c), "flexural", "extensional"),
        "parity": np.full(len(c.shapes), "even" if c.mirror.y > 0 else "odd"),
        "participation": participation(solid, part.quarter, c),
        "rim_shape": rim_shape,
        "face_shape": axial.reshape(-1, 2, sample.FACE_RADII, sample.FACE_ANGLES),
        "residual": c.residual,
    }


def unfolded(part, solid, solved, error, plate) -> Modes:
    """The record of all classes, ascending; error (m,) in the order of the classes."""
    rim, face = ((face_matrices(solid, part, points), points) for points in sample.places(plate.radius))
    columns = [unfold_class(solid, part, c, rim, face) for c in solved]
    columns = {name: np.concatenate([c[name] for c in columns]) for name in columns[0]}
    points, cells, source = whole_mesh(solid.points, solid.cells, part.quarter)
    signs = [np.array([c.mirror.sign(*flip) for flip in flips(part.quarter)]) for c in solved]
    shapes = [c.shapes[:, source[:, 0]] * sign[source[:, 1]] for c, sign in zip(solved, signs, strict=True)]
    return sample.recorded(
        columns | {"error": error, "displacement": np.concatenate(shapes)},
        plate.material,
        plate.radius,
        points,
        cells,
        mass=part.copies * solid.total,
        method="finite elements",
        unknowns=3 * len(points),
    )
