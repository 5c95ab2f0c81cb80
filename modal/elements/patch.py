"""Finite-element modes of a disk (`Plate`) on a patch or free, from one sector and its symmetries."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from skfem import ElementHex2

from modal.accuracy import ACCURACY_LEVELS
from modal.elements.elastic import assemble, bending_wave_number, lowest_eigenpairs
from modal.elements.unfold import whole_disk_modes
from modal.mesh.sector import patch_height, sector
from modal.mesh.symmetry import Mirror, free_unknowns, on_patch, symmetry_classes
from modal.modes import Modes, UnsolvableError
from modal.progress import portion, reporting


@dataclass(frozen=True, kw_only=True)
class SolvedClass:
    """Eigenpairs of one symmetry class."""

    mirror: Mirror
    """Symmetry of the class."""
    values: np.ndarray
    """Eigenvalues (k,) [1/s^2]."""
    shapes: np.ndarray
    """Shapes (k, p, 3) on the sector, of modal mass 1 on the whole disk."""
    residual: np.ndarray
    """Residuals (k,)."""


def rigid_body_shift(radius, thickness, material, density):
    """Return a negative shift [1/s^2] for the eigenvalue problem of a free body.

    It is minus the square of an angular frequency well below those of the elastic modes.
    """
    speed = (material.young / density) ** 0.5
    return -((0.4 * speed * min(thickness, radius) / radius**2) ** 2)


def eigenvalue_shift(plate, support):
    """Return the shift [1/s^2] of the eigenvalue problem: 0 for a disk on a patch,
    `rigid_body_shift` for a free one."""
    if support.kind == "patch":
        return 0.0
    return rigid_body_shift(plate.radius, plate.thickness, plate.material, plate.density)


def resolving_mesh_size(size, plate, below, max_waves=3.5, min_share=0.2):
    """Return the `MeshSize` with blocks narrow enough for the bending waves of a thin plate at
    `below` [Hz].

    Blocks keep their width up to `max_waves`, wave number times radius; beyond it they shrink, at
    most to `min_share`. The rim ring, which contains the boxes around the patch, shrinks slightly
    less.
    """
    wave_number = bending_wave_number(plate.material, plate.thickness, plate.density, below)
    share = min(1.0, max(min_share, max_waves / (wave_number * plate.radius)))
    return replace(size, width=size.width * share, depth=size.depth * share**0.75)


def mesh_sizes(accuracy, plate, support):
    """Return the fine and the coarse `MeshSize` of an accuracy."""
    is_low = patch_height(plate.thickness, support) < plate.thickness
    level = ACCURACY_LEVELS[accuracy]
    return level.low_patch_meshes if is_low else level.patch_meshes


def solve_class(solid, part, mirror, plate, support, held, shift, **selection):
    """Return the `SolvedClass` of one symmetry; `selection` is passed to `lowest_eigenpairs`."""
    free = free_unknowns(solid.points, held, support.held, mirror, plate.radius)
    k = free.T @ solid.stiffness @ free
    m = free.T @ solid.mass @ free
    values, vectors, residual = lowest_eigenpairs(k, m, shift=shift, **selection)
    shapes = (free @ vectors).T.reshape(-1, len(solid.points), 3) / part.copies**0.5
    return SolvedClass(mirror=mirror, values=values, shapes=shapes, residual=residual)


def solve_classes(plate, support, size, selections):
    """Return the `Sector`, its `Solid` and the `SolvedClass` of every symmetry.

    `selections` are the options of `lowest_eigenpairs`, one dictionary for all classes or a list of
    one per class. Two classes are solved at a time: SuperLU releases the interpreter, Python code
    does not, and a third thread gains nothing.
    """
    part = sector(plate.radius, plate.thickness, support, size)
    solid = assemble(part.mesh, ElementHex2(), plate.material, plate.density, intorder=4)
    shift = eigenvalue_shift(plate, support)
    mirrors = symmetry_classes(part.quarter)
    held = on_patch(solid.points, plate.radius, np.deg2rad(support.half_angle_deg), part.patch)
    if isinstance(selections, dict):
        selections = [selections] * len(mirrors)

    def solve_one(mirror, selection):
        return solve_class(solid, part, mirror, plate, support, held, shift, **selection)

    with ThreadPoolExecutor(2) as pool:
        solved = reporting(pool.map(solve_one, mirrors, selections), len(mirrors))
        return part, solid, list(solved)


def without_rigid_modes(solved, shift):
    """Return the classes without rigid-body modes.

    Raises ArithmeticError unless a free body has exactly six rigid-body modes, whose eigenvalues
    are
    round-off far below the shift. Raises UnsolvableError if a held body has rigid-body modes,
    because
    round-off then exceeds the effect of its patch.
    """
    rigid = [np.count_nonzero(c.values < 1e-6 * abs(shift)) for c in solved]
    if shift and sum(rigid) != 6:
        raise ArithmeticError(f"{sum(rigid)} rigid-body modes were found, not 6")
    if not shift and sum(rigid):
        raise UnsolvableError(
            f"support: the patch is too small: round-off leaves the disk {sum(rigid)} rigid-body "
            f"motion(s)",
        )
    return [
        SolvedClass(
            mirror=c.mirror,
            values=c.values[r:],
            shapes=c.shapes[r:],
            residual=c.residual[r:],
        )
        for c, r in zip(solved, rigid, strict=True)
    ]


def held_modes(plate, support, below, accuracy) -> Modes:
    """Return the `Modes` below `below` [Hz] of a solid disk at one of `ACCURACY_LEVELS`."""
    sizes = mesh_sizes(accuracy, plate, support)
    fine_size, coarse_size = (resolving_mesh_size(size, plate, below) for size in sizes)
    limit = (2 * pi * below) ** 2
    shift = eigenvalue_shift(plate, support)
    with portion(0.0, 0.7):
        part, solid, solved = solve_classes(plate, support, fine_size, {"below": limit})
    same_counts = [{"below": limit, "exact_count": max(1, len(c.values))} for c in solved]
    with portion(0.7, 1.0):
        _, _, coarse = solve_classes(plate, support, coarse_size, same_counts)
    solved = without_rigid_modes(solved, shift)
    coarse = without_rigid_modes(coarse, shift)
    return whole_disk_modes(part, solid, solved, error_estimates(solved, coarse), plate)


def error_estimates(solved, coarse, safety=1.8, min_share=0.5):
    """Estimate the relative errors (m,) of the frequencies of all classes from a coarser mesh.

    The difference of the two meshes is multiplied by `safety`, because the error of the coarser
    mesh
    may be only 1.6 times as large. No estimate is less than `min_share` of the median, because a
    mode
    may have equal errors on both meshes by chance.
    """
    differences = [
        np.abs(np.sqrt(b.values[: len(a.values)] / a.values) - 1)  # of the frequencies
        for a, b in zip(solved, coarse, strict=True)
    ]
    error = safety * np.concatenate(differences)
    return np.maximum(error, min_share * np.median(error)) if len(error) else error
