"""Define the settings of the modal solvers at the accuracies draft, standard and
reference.

`dynamics.solver_settings` defines those of motion and sound.
"""

from dataclasses import replace
from math import pi
from typing import Any, NamedTuple

from modal.mesh.half_disk import MeshSize

DRAFT_MESH = MeshSize(width=pi / 6, depth=0.45, rings=2)
COARSE_DRAFT_MESH = MeshSize(
    width=pi / 4, depth=0.5, rings=1, box_ratio=0.25, upper_edge_blocks=1
)
STANDARD_MESH = MeshSize(width=pi / 10, depth=0.32, rings=4, ring_ratio=0.5)
COARSE_STANDARD_MESH = MeshSize(width=pi / 5, depth=0.5, rings=1, box_ratio=0.4)
REFERENCE_MESH = MeshSize(width=pi / 8, depth=0.38, rings=3, split=2)
REFERENCE_COARSE_MESH = MeshSize(width=pi / 8, depth=0.38, rings=2)


class ModesAccuracyLevel(NamedTuple):
    """Settings of the modal solvers at one accuracy."""

    free_error: float
    """Largest estimated relative error of the frequencies of a free disk; the true
    error is several times smaller."""
    patch_meshes: tuple[MeshSize, MeshSize]
    """Mesh of a disk on a patch, and a coarser mesh for the error estimate."""
    low_patch_meshes: tuple[MeshSize, MeshSize]
    """The same for a partial-height patch, which requires many more cells."""
    basis_sizes: dict[str, Any]
    """Fields of `BasisSizes` with values other than the default."""
    max_table_unknowns: int
    """Largest number of unknowns per symmetry class for which the cells of a table mesh
    are divided into eight."""


ACCURACY_LEVELS = {
    "draft": ModesAccuracyLevel(
        free_error=1e-4,
        patch_meshes=(DRAFT_MESH, COARSE_DRAFT_MESH),
        low_patch_meshes=(
            replace(DRAFT_MESH, rings=1),
            replace(COARSE_DRAFT_MESH, rings=0),
        ),
        basis_sizes={
            "size": (9, 6),
            "circumferential_tractions": 4,
            "thickness_tractions": 3,
        },
        max_table_unknowns=20_000,
    ),
    "standard": ModesAccuracyLevel(
        free_error=3e-6,
        patch_meshes=(STANDARD_MESH, COARSE_STANDARD_MESH),
        low_patch_meshes=(
            REFERENCE_COARSE_MESH,
            replace(COARSE_DRAFT_MESH, box_ratio=0.15),
        ),
        basis_sizes={},
        max_table_unknowns=60_000,
    ),
    "reference": ModesAccuracyLevel(
        free_error=1e-8,
        patch_meshes=(REFERENCE_MESH, REFERENCE_COARSE_MESH),
        low_patch_meshes=(REFERENCE_MESH, REFERENCE_COARSE_MESH),
        basis_sizes={
            "size": (12, 8),
            "circumferential_tractions": 9,
            "thickness_tractions": 6,
        },
        max_table_unknowns=250_000,
    ),
}
"""Settings by accuracy."""
