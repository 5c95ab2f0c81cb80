"""
The mesh of a table
===================

Mesh a table top on four feet; a scene uses it with `surface.kind = "mesh"`.

The mesh file of the scene wood-table was written by this script.
"""

import sys
from itertools import pairwise
from pathlib import Path

import meshio
import numpy as np

FOOT_LAYER_HEIGHTS = (-0.04, -0.035, -0.025, -0.02)
"""Heights of the cell boundaries in the feet [m], with thin layers at both ends."""
CELL_COUNTS = 15, 10
"""Numbers of cells along length and width; one foot is under the cell diagonally next
to each corner cell."""
FOOT_SQUARE_SIZES = 1.4, 1.0, 0.6
"""Sizes of concentric squares around a foot, relative to the cell; the cells between
them are narrow at the sides of the foot."""
CELL_CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))
Corner = tuple[float, float]
"""Position of the corner of a cell along length and width [m]."""


def write_table_mesh(path: Path) -> Path:
    """Write a hexahedral mesh with its top face at z = 0 and a surface "feet"; return
    its path."""
    length = 0.6  # m
    width = 0.4  # m
    x, y = (
        np.linspace(-size / 2, size / 2, n + 1)
        for size, n in zip((length, width), CELL_COUNTS, strict=True)
    )
    feet = [(i, j) for i in (1, CELL_COUNTS[0] - 2) for j in (1, CELL_COUNTS[1] - 2)]
    foot_of = {(i + a, j + b): (i, j) for i, j in feet for a, b in CELL_CORNERS}
    numbers: dict[tuple[float, float, float], int] = {}

    def number(corner: Corner, z: float) -> int:
        return numbers.setdefault((*corner, z), len(numbers))

    def place(i: int, j: int, size: float) -> Corner:
        """Return the position of a corner; at a foot, of a square of relative `size`."""
        if (i, j) not in foot_of:
            return x[i], y[j]
        a, b = foot_of[i, j]
        middle_x = x[a : a + 2].mean()
        middle_y = y[b : b + 2].mean()
        return middle_x + size * (x[i] - middle_x), middle_y + size * (y[j] - middle_y)

    def square(i: int, j: int, size: float) -> list[Corner]:
        return [place(i + a, j + b, size) for a, b in CELL_CORNERS]

    def hexahedra(
        squares: list[list[Corner]], heights: tuple[float, ...]
    ) -> list[list[int]]:
        return [
            [number(corner, z) for z in layer for corner in corners]
            for layer in pairwise(heights)
            for corners in squares
        ]

    rest = [
        square(i, j, FOOT_SQUARE_SIZES[0])
        for i in range(CELL_COUNTS[0])
        for j in range(CELL_COUNTS[1])
        if (i, j) not in feet
    ]
    around: list[list[Corner]] = []
    within = [square(*foot, FOOT_SQUARE_SIZES[-1]) for foot in feet]
    for outer, inner in pairwise(FOOT_SQUARE_SIZES):
        for foot in feet:
            out = square(*foot, outer)
            inside = square(*foot, inner)
            sides = [[out[k - 1], out[k], inside[k], inside[k - 1]] for k in range(4)]
            (around if outer > 1 else within).extend(sides)
    top_layer = (-0.02, 0.0)  # heights of both sides [m]
    top = hexahedra(rest + around + within, top_layer)
    legs = hexahedra(within, FOOT_LAYER_HEIGHTS)
    stand = [
        [number(corner, FOOT_LAYER_HEIGHTS[0]) for corner in corners]
        for corners in within
    ]
    _write_gmsh(path, [*numbers], top + legs, stand)
    return path


def _write_gmsh(
    path: Path,
    points: list[tuple[float, float, float]],
    solid: list[list[int]],
    feet: list[list[int]],
) -> None:
    """Write points [m], the hexahedra of a solid and the quadrilaterals of its feet."""
    tags = [np.full(len(solid), 1), np.full(len(feet), 2)]
    mesh = meshio.Mesh(
        points,
        [("hexahedron", solid), ("quad", feet)],
        cell_data={"gmsh:physical": tags, "gmsh:geometrical": tags},
        field_data={"wood": np.array([1, 3]), "feet": np.array([2, 2])},
    )
    mesh.write(path, file_format="gmsh22", binary=False)


if __name__ == "__main__":
    write_table_mesh(Path(sys.argv[1]))
