"""A table of your own: the mesh of a top on four feet, which a scene names with [surface] kind = "mesh".

The file that comes with the scene wood-table is made by this.
"""

import sys
from pathlib import Path

import meshio
import numpy as np

LENGTH, WIDTH, THICKNESS, FOOT = 0.6, 0.4, 0.02, 0.02
CELLS = 15, 10
"""Along length and width; the four feet stand under the cells next to the corners, one each."""


def table(path: Path) -> Path:
    """Write hexahedra (c, 8) on points (p, 3) [m], the top face at z = 0, with a surface "feet"."""
    x, y = (np.linspace(-size / 2, size / 2, n + 1) for size, n in zip((LENGTH, WIDTH), CELLS, strict=True))
    z = (-THICKNESS - FOOT, -THICKNESS, 0.0)
    numbers: dict[tuple[int, int, int], int] = {}

    def corners(i: int, j: int, k: int) -> list[int]:
        around = ((0, 0), (1, 0), (1, 1), (0, 1))
        return [numbers.setdefault((i + a, j + b, k), len(numbers)) for a, b in around]

    feet = [(i, j) for i in (1, CELLS[0] - 2) for j in (1, CELLS[1] - 2)]
    top = [corners(i, j, 1) + corners(i, j, 2) for i in range(CELLS[0]) for j in range(CELLS[1])]
    legs = [corners(i, j, 0) + corners(i, j, 1) for i, j in feet]
    tags = [np.full(len(top) + len(legs), 1), np.full(len(legs), 2)]
    mesh = meshio.Mesh(
        [[x[i], y[j], z[k]] for i, j, k in numbers],
        [("hexahedron", top + legs), ("quad", [leg[:4] for leg in legs])],
        cell_data={"gmsh:physical": tags, "gmsh:geometrical": tags},
        field_data={"wood": np.array([1, 3]), "feet": np.array([2, 2])},
    )
    mesh.write(path, file_format="gmsh22", binary=False)
    return path


if __name__ == "__main__":
    table(Path(sys.argv[1]))
