"""
Your own mesh
=============

Compute the modes of a body from any mesh file that meshio can read, such as a Gmsh file.

Without a file, the example generates the mesh of a disk from a square grid with two
layers."""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import meshio
import numpy as np
from skfem import MeshHex

from modal import Material, Modes, Support, mesh_modes

STEEL = Material(young=195e9, poisson=0.28)
DENSITY = 7800.0  # kg/m^3


def write_disk_mesh(
    path: Path, radius: float = 0.03755, thickness: float = 0.0128
) -> Path:
    """Write a hexahedral mesh of a disk with lengths in metres, and return its path."""
    side = np.linspace(-1, 1, 7)
    mesh = MeshHex.init_tensor(
        side, side, np.linspace(-thickness / 2, thickness / 2, 3)
    )
    x, y, z = mesh.p
    points = np.column_stack(
        [radius * x * np.sqrt(1 - y**2 / 2), radius * y * np.sqrt(1 - x**2 / 2), z]
    )
    meshio.Mesh(points, [("hexahedron", mesh.t.T[:, [0, 1, 4, 2, 3, 5, 7, 6]])]).write(
        path
    )
    return path


def main(path: Path | None = None) -> Modes:
    """Solve the free body in the file at `path`, print its frequencies, and return its
    modes."""
    with TemporaryDirectory() as folder:
        path = path or write_disk_mesh(Path(folder) / "disk.vtu")
        modes = mesh_modes(path, STEEL, DENSITY, Support(kind="free"), refine=False)
    for frequency, family in zip(modes.frequency, modes.family, strict=True):
        print(f"{frequency:8.1f} Hz  {family}")
    return modes


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
