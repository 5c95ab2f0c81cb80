"""
The mesh of a table
===================

Mesh a table top on four feet; a scene uses it with `surface.kind = "mesh"`.

This script made the file of the scene wood-table.
"""

import sys
from itertools import pairwise
from pathlib import Path

import meshio
import numpy as np

LENGTH = 0.6  # m
WIDTH = 0.4  # m
TOP = (-0.02, 0.0)
"""Heights between layers of cells of the top [m]."""
FEET = (-0.04, -0.035, -0.025, -0.02)
"""The same for the feet; thin layers at both ends."""
CELLS = 15, 10
"""Along length and width; the four feet stand under the cells next to the corners, one each."""
RINGS = 1.4, 1.0, 0.6
"""Squares about the middle of a foot, of whose size one is, with cells between them: small ones
along its sides."""
AROUND = ((0, 0), (1, 0), (1, 1), (0, 1))
Corner = tuple[int, int, float]
"""Numbers of a corner along length and width, and on which ring it is about the foot there, if one
is."""


def table(path: Path) -> Path:
    """Write hexahedra (c, 8) on points (p, 3) [m], the top face at z = 0, with a surface "feet"."""
    x, y = (
        np.linspace(-size / 2, size / 2, n + 1)
        for size, n in zip((LENGTH, WIDTH), CELLS, strict=True)
    )
    feet = [(i, j) for i in (1, CELLS[0] - 2) for j in (1, CELLS[1] - 2)]
    foot_of = {(i + a, j + b): (i, j) for i, j in feet for a, b in AROUND}
    numbers: dict[tuple[int, int, float, float], int] = {}

    def number(corner: Corner, z: float) -> int:
        i, j, ring = corner
        return numbers.setdefault((i, j, ring if (i, j) in foot_of else 1.0, z), len(numbers))

    def place(i: int, j: int, ring: float, z: float) -> list[float]:
        a, b = foot_of.get((i, j), (i, j))
        middle = (
            np.array([x[a : a + 2].mean(), y[b : b + 2].mean()])
            if (i, j) in foot_of
            else np.zeros(2)
        )
        return [*(middle + ring * (np.array([x[i], y[j]]) - middle)), z]

    def square(i: int, j: int, ring: float) -> list[Corner]:
        return [(i + a, j + b, ring) for a, b in AROUND]

    def hexahedra(squares: list[list[Corner]], heights: tuple[float, ...]) -> list[list[int]]:
        layers = pairwise(heights)
        return [
            [number(corner, z) for z in pair for corner in corners]
            for pair in layers
            for corners in squares
        ]

    rest = [
        square(i, j, RINGS[0])
        for i in range(CELLS[0])
        for j in range(CELLS[1])
        if (i, j) not in feet
    ]
    around: list[list[Corner]] = []
    within = [square(*foot, RINGS[-1]) for foot in feet]
    for outer, inner in pairwise(RINGS):
        for foot in feet:
            out = square(*foot, outer)
            inside = square(*foot, inner)
            sides = [[out[k - 1], out[k], inside[k], inside[k - 1]] for k in range(4)]
            (around if outer > 1 else within).extend(sides)
    top = hexahedra(rest + around + within, TOP)
    legs = hexahedra(within, FEET)
    stand = [[number(corner, FEET[0]) for corner in corners] for corners in within]
    tags = [np.full(len(top) + len(legs), 1), np.full(len(stand), 2)]
    mesh = meshio.Mesh(
        [place(*key) for key in numbers],
        [("hexahedron", top + legs), ("quad", stand)],
        cell_data={"gmsh:physical": tags, "gmsh:geometrical": tags},
        field_data={"wood": np.array([1, 3]), "feet": np.array([2, 2])},
    )
    mesh.write(path, file_format="gmsh22", binary=False)
    return path


if __name__ == "__main__":
    table(Path(sys.argv[1]))
