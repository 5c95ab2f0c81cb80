"""Divide cells into tetrahedra."""

from collections.abc import Iterator

import numpy as np

TETRAHEDRON_PARTS = [
    [0, 4, 6, 7],
    [4, 1, 5, 8],
    [6, 5, 2, 9],
    [7, 8, 9, 3],
    [4, 5, 6, 8],
    [4, 6, 7, 8],
    [5, 6, 8, 9],
    [6, 7, 8, 9],
]
"""Corners of the eight parts of a tetrahedron, numbered by its corners (0 to 3) and
edge midpoints (4 to 9)."""

FACES = {
    "tetra": "021 013 123 203",
    "pyramid": "014 124 234 304 0123",
    "wedge": "012 345 0143 1254 2035",
    "hexahedron": "0321 4567 0154 1265 2376 3047",
}
"""Corners of the faces of each cell in VTK's order; around the outward normals of
tetrahedra and hexahedra."""
EDGES = {
    "tetra": "01 12 02 03 13 23",
    "pyramid": "01 12 23 30 04 14 24 34",
    "wedge": "01 12 20 34 45 53 03 14 25",
    "hexahedron": "01 12 23 30 45 56 67 74 04 15 26 37",
}
"""Corners of the edges of each cell, in the order of the nodes in their middle."""
SHAPE_OF_CELLS = {
    "tetra": "tetra",
    "pyramid": "pyramid",
    "wedge": "wedge",
    "hexahedron": "hexahedron",
    "tetra10": "tetra",
    "pyramid13": "pyramid",
    "pyramid14": "pyramid",
    "wedge15": "wedge",
    "wedge18": "wedge",
    "hexahedron20": "hexahedron",
    "hexahedron27": "hexahedron",
}
"""Shape of each of meshio's cell types that can be divided into tetrahedra."""


def corner_lists(text: str) -> list[list[int]]:
    """Return lists of corners written as digits."""
    return [list(map(int, word)) for word in text.split()]


def triangles_of_quadrilaterals(corners: np.ndarray) -> np.ndarray:
    """Return the triangles (2 n, 3) of quadrilaterals (n, 4), cut through their lowest
    number, so that neighbouring cells are cut in the same way."""
    first = corners.argmin(axis=1)
    turned = np.take_along_axis(corners, (first[:, None] + np.arange(4)) % 4, axis=1)
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])


def corner_tetrahedra(corners: np.ndarray, shape: str) -> np.ndarray:
    """Return the tetrahedra (t, 4) of convex cells with the corners (c, k).

    They connect the lowest number of each cell with the triangles of the faces that do
    not contain it.
    """
    if shape == "tetra":
        return corners
    apex = corners.argmin(axis=1)
    found = []
    for face in corner_lists(FACES[shape]):
        opposite = ~np.isin(apex, face)
        lowest = corners[opposite].min(axis=1)
        sides = corners[opposite][:, face]
        if len(face) == 4:
            sides = triangles_of_quadrilaterals(sides)
            lowest = np.tile(lowest, 2)
        found.append(np.column_stack([lowest, sides]))
    return np.concatenate(found)


def tetrahedra_of_cells(
    points: np.ndarray, blocks: list[tuple[str, np.ndarray]]
) -> tuple[np.ndarray, np.ndarray]:
    """Return points (p, 3) and tetrahedra (t, 4) or (t, 10) of cells by type.

    `blocks` is a list of meshio's cell type and cells (c, n), either all linear or all
    of second order. Each new node, on a diagonal, is interpolated from the corners and
    edges of its face or its cell by quadratic shape functions.
    """
    shapes = [SHAPE_OF_CELLS[kind] for kind, _ in blocks]
    cells = [numbers for _, numbers in blocks]
    corner_counts = [len(set(FACES[shape]) - {" "}) for shape in shapes]
    corners = [
        numbers[:, :count] for numbers, count in zip(cells, corner_counts, strict=True)
    ]
    tetrahedra = np.concatenate(list(map(corner_tetrahedra, corners, shapes)))
    sides = points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]
    left_handed = np.linalg.det(sides) < 0
    tetrahedra[left_handed] = tetrahedra[left_handed][:, [0, 2, 1, 3]]
    if blocks[0][0] == shapes[0]:
        return points, tetrahedra
    return with_middle_nodes(points, tetrahedra, cells, corners, shapes)


def with_middle_nodes(
    points: np.ndarray,
    tetrahedra: np.ndarray,
    cells: list[np.ndarray],
    corners: list[np.ndarray],
    shapes: list[str],
) -> tuple[np.ndarray, np.ndarray]:
    """Return the points and tetrahedra (t, 10) of second order for linear ones (t, 4).

    `cells`, `corners` and `shapes` are lists of the nodes, the corners and the shapes of
    the cells by type.
    """
    ends = []
    middles = []
    for numbers, corner, shape in zip(cells, corners, shapes, strict=True):
        edges = corner_lists(EDGES[shape])
        nodes = numbers[:, corner.shape[1] : corner.shape[1] + len(edges)]
        ends.append(corner[:, edges].reshape(-1, 2))
        middles.append(points[nodes].reshape(-1, 3))
        for diagonal, middle in diagonals(points, corner, nodes, shape):
            ends.append(diagonal)
            middles.append(middle)
    pairs, first = np.unique(
        np.sort(np.concatenate(ends), axis=1), axis=0, return_index=True
    )
    code = pairs[:, 0] * len(points) + pairs[:, 1]
    wanted = np.sort(tetrahedra[:, corner_lists(EDGES["tetra"])], axis=2)
    found = np.searchsorted(code, wanted[..., 0] * len(points) + wanted[..., 1])
    all_points = np.vstack([points, np.concatenate(middles)[first]])
    return all_points, np.hstack([tetrahedra, len(points) + found])


def diagonals(
    points: np.ndarray, corners: np.ndarray, nodes: np.ndarray, shape: str
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the ends (c, 2) and middles (c, 3) of the diagonals along which cells are
    cut.

    `corners` (c, k) and `nodes` (c, e) are the node numbers of corners and edges.
    """
    edges = [set(edge) for edge in corner_lists(EDGES[shape])]
    rows = np.arange(len(corners))
    for face in corner_lists(FACES[shape]):
        if len(face) < 4:
            continue
        around = [i for i, edge in enumerate(edges) if edge <= set(face)]
        lowest = corners[:, face].argmin(axis=1)
        ends = np.stack(
            [corners[:, face][rows, (lowest + turn) % 4] for turn in (0, 2)]
        )
        middle = (
            points[nodes[:, around]].sum(axis=1) / 2
            - points[corners[:, face]].sum(axis=1) / 4
        )
        yield ends.T, middle
    if shape == "hexahedron":
        opposite = np.array([6, 7, 4, 5, 2, 3, 0, 1])[corners.argmin(axis=1)]
        ends = np.stack([corners.min(axis=1), corners[rows, opposite]])
        yield ends.T, (points[nodes].sum(axis=1) - points[corners].sum(axis=1)) / 4
