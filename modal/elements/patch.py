"""Compute finite-element modes of a disk, free or on a patch, from one sector and its
symmetries."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import pi
from typing import TYPE_CHECKING, TypedDict, Unpack

import numpy as np
from skfem import ElementHex2

from modal.accuracy import ACCURACY_LEVELS
from modal.elements.elastic import (
    Solid,
    assemble_solid,
    bending_wave_number,
    lowest_eigenpairs,
)
from modal.elements.unfold import whole_disk_modes
from modal.mesh.sector import Sector, patch_height, sector
from modal.mesh.symmetry import (
    Mirror,
    admissible_displacements,
    patch_node_mask,
    symmetry_classes,
)
from modal.modes import Material, Modes, Support, UnsolvableError
from modal.progress import progress_range, report_each

if TYPE_CHECKING:
    from modal.mesh.half_disk import MeshSize
    from modal.spectral.basis import Plate


class Selection(TypedDict, total=False):
    """Options of `lowest_eigenpairs` that select the eigenpairs."""

    below: float
    first_count: int
    exact_count: int | None


@dataclass(frozen=True, kw_only=True)
class SolvedSymmetryClass:
    """Eigenpairs of one symmetry class."""

    mirror: Mirror
    """Symmetry of the class."""
    values: np.ndarray
    """Eigenvalues (k,) [1/s^2]."""
    shapes: np.ndarray
    """Shapes (k, p, 3) on the sector, of unit modal mass on the whole disk."""
    residual: np.ndarray
    """Residuals (k,)."""


def rigid_body_shift(
    radius: float, thickness: float, material: Material, density: float
) -> float:
    """Return a negative shift [1/s^2] for the eigenvalue problem of a free body.

    It is the negative square of an angular frequency well below those of the elastic
    modes.
    """
    speed = (material.young / density) ** 0.5
    return -((0.4 * speed * min(thickness, radius) / radius**2) ** 2)


def eigenvalue_shift(plate: "Plate", support: Support) -> float:
    """Return the shift [1/s^2] of the eigenvalue problem: 0 on a patch, else
    `rigid_body_shift`."""
    if support.kind == "patch":
        return 0.0
    return rigid_body_shift(
        plate.radius, plate.thickness, plate.material, plate.density
    )


def resolving_mesh_size(size: "MeshSize", plate: "Plate", below: float) -> "MeshSize":
    """Return a `MeshSize` with blocks narrow enough for bending waves at `below` [Hz].

    Blocks are narrowed, down to a limit, if wavenumber times radius is large. The rim
    ring, which contains the boxes around the patch, is narrowed slightly less.
    """
    # wavenumber times radius that the widest blocks resolve
    max_scaled_wavenumber = 3.5
    min_width_share = 0.2  # of the width of the widest blocks
    wave_number = bending_wave_number(
        plate.material, plate.thickness, plate.density, below
    )
    share = min(
        1.0, max(min_width_share, max_scaled_wavenumber / (wave_number * plate.radius))
    )
    return replace(size, width=size.width * share, depth=size.depth * share**0.75)


def mesh_sizes(
    accuracy: str, plate: "Plate", support: Support
) -> "tuple[MeshSize, MeshSize]":
    """Return the fine and the coarse `MeshSize` for an accuracy."""
    is_low = patch_height(plate.thickness, support) < plate.thickness
    level = ACCURACY_LEVELS[accuracy]
    return level.low_patch_meshes if is_low else level.patch_meshes


def solve_symmetry_class(
    solid: Solid,
    part: Sector,
    mirror: Mirror,
    plate: "Plate",
    support: Support,
    held: np.ndarray,
    shift: float,
    **selection: Unpack[Selection],
) -> SolvedSymmetryClass:
    """Return the `SolvedSymmetryClass` of one symmetry; `selection` is passed to
    `lowest_eigenpairs`."""
    free = admissible_displacements(
        solid.points, held, support.held, mirror, plate.radius
    )
    k = free.T @ solid.stiffness @ free
    m = free.T @ solid.mass @ free
    values, vectors, residual = lowest_eigenpairs(k, m, shift=shift, **selection)
    shapes = (free @ vectors).T.reshape(
        -1, len(solid.points), 3
    ) / part.mirror_image_count**0.5
    return SolvedSymmetryClass(
        mirror=mirror, values=values, shapes=shapes, residual=residual
    )


def solve_symmetry_classes(
    plate: "Plate",
    support: Support,
    size: "MeshSize",
    selections: Selection | list[Selection],
) -> "tuple[Sector, Solid, list[SolvedSymmetryClass]]":
    """Return the `Sector`, its `Solid` and the list of `SolvedSymmetryClass` records.

    `selections` contains options of `lowest_eigenpairs`: one dictionary for all classes
    or a list with one for each class. Two classes are solved concurrently, because
    SuperLU releases the interpreter lock; a third thread would not be faster.
    """
    part = sector(plate.radius, plate.thickness, support, size)
    solid = assemble_solid(
        part.mesh, ElementHex2(), plate.material, plate.density, intorder=4
    )
    shift = eigenvalue_shift(plate, support)
    mirrors = symmetry_classes(part.quarter)
    held = patch_node_mask(
        solid.points, plate.radius, np.deg2rad(support.half_angle_deg), part.patch
    )
    if isinstance(selections, dict):
        selections = [selections] * len(mirrors)

    def solve_one(mirror: Mirror, selection: Selection) -> SolvedSymmetryClass:
        return solve_symmetry_class(
            solid, part, mirror, plate, support, held, shift, **selection
        )

    with ThreadPoolExecutor(2) as pool:
        solved = report_each(pool.map(solve_one, mirrors, selections), len(mirrors))
        return part, solid, list(solved)


def without_rigid_modes(
    solved: list[SolvedSymmetryClass], shift: float
) -> list[SolvedSymmetryClass]:
    """Return the classes without rigid-body modes.

    Eigenvalues of rigid-body modes are pure round-off, far below the shift. Raises
    ArithmeticError if a free body does not have six of them. Raises UnsolvableError if
    a held body has any, because round-off then exceeds the effect of the patch.
    """
    rigid = [np.count_nonzero(c.values < 1e-6 * abs(shift)) for c in solved]
    total = sum(rigid)
    if shift and total != 6:
        raise ArithmeticError(f"{total} rigid-body modes were found, not 6")
    if not shift and total:
        raise UnsolvableError(
            f"support: the patch is too small: round-off leaves the disk {total} rigid-body "
            f"motion(s)",
        )
    return [
        replace(c, values=c.values[r:], shapes=c.shapes[r:], residual=c.residual[r:])
        for c, r in zip(solved, rigid, strict=True)
    ]


def held_modes(plate: "Plate", support: Support, below: float, accuracy: str) -> Modes:
    """Return the `Modes` of a solid disk below a frequency [Hz] at one of the
    `ACCURACY_LEVELS`."""
    sizes = mesh_sizes(accuracy, plate, support)
    fine_size, coarse_size = (resolving_mesh_size(size, plate, below) for size in sizes)
    limit = (2 * pi * below) ** 2
    shift = eigenvalue_shift(plate, support)
    with progress_range(0.0, 0.7):
        part, solid, solved = solve_symmetry_classes(
            plate, support, fine_size, {"below": limit}
        )
    same_counts: list[Selection] = [
        {"below": limit, "exact_count": max(1, len(c.values))} for c in solved
    ]
    with progress_range(0.7, 1.0):
        _, _, coarse = solve_symmetry_classes(plate, support, coarse_size, same_counts)
    solved = without_rigid_modes(solved, shift)
    coarse = without_rigid_modes(coarse, shift)
    return whole_disk_modes(part, solid, solved, error_estimates(solved, coarse), plate)


def error_estimates(
    solved: list[SolvedSymmetryClass], coarse: list[SolvedSymmetryClass]
) -> np.ndarray:
    """Return estimated relative errors (m,) of the frequencies of all classes from a
    coarser mesh.

    The difference between the meshes is multiplied by a safety factor, because the
    error of the coarser mesh may be only 1.6 times as large. Each estimate is at least
    a fraction of the median, because errors of a mode on both meshes may be equal by
    chance.
    """
    safety = 1.8
    min_share = 0.5  # of the median
    differences = [
        np.abs(np.sqrt(b.values[: len(a.values)] / a.values) - 1)  # of the frequencies
        for a, b in zip(solved, coarse, strict=True)
    ]
    error = safety * np.concatenate(differences)
    return np.maximum(error, min_share * np.median(error)) if len(error) else error
