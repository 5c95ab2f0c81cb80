"""The modes of a disk (`Plate`) on a patch, or free, by finite elements on one sector and its symmetry classes."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from skfem import ElementHex2

from modal.accuracy import LEVELS
from modal.elements.elastic import assemble, bending_number, lowest
from modal.elements.unfold import unfolded
from modal.mesh.sector import held_height, sector
from modal.mesh.symmetry import Mirror, classes, free_unknowns, on_patch
from modal.modes import Modes, UnsolvableError

SAFETY = 1.8
"""Errors are estimated as so many times that distance: the coarser mesh may be as little as 1.6 times as wrong."""
LEAST = 0.5
"""Least estimate over the median of all modes: by chance a mode may have the same error on both meshes."""
WAVES, NARROWEST = 3.5, 0.2
"""Wave number times radius up to which the levels are as given; beyond it they are narrower, down to this share."""


@dataclass(frozen=True, kw_only=True)
class Class:
    """Solved pairs of one symmetry class: values (k,) [1/s^2], shapes (k, p, 3) on the sector, modal mass 1."""

    mirror: Mirror
    values: np.ndarray
    shapes: np.ndarray
    residual: np.ndarray


def shift_for(plate, support):
    """0 for a held disk; for a free one minus the square of a rate well below its first elastic mode [1/s^2]."""
    if support.kind == "patch":
        return 0.0
    speed = (plate.material.young / plate.density) ** 0.5
    return -((0.4 * speed * min(plate.thickness, plate.radius) / plate.radius**2) ** 2)


def resolving(size, plate, below):
    """The `Blocks` narrow enough for the bending waves of a thin plate at `below` [Hz], down to NARROWEST.

    The rim ring, in which the boxes about the patch lie, shrinks a little less.
    """
    share = min(1.0, max(NARROWEST, WAVES / (bending_number(plate, below) * plate.radius)))
    return replace(size, width=size.width * share, depth=size.depth * share**0.75)


def meshes(accuracy, plate, support):
    """The two meshes of an accuracy."""
    part = held_height(plate.thickness, support) < plate.thickness
    return LEVELS[accuracy].part if part else LEVELS[accuracy].meshes


def solve_class(solid, part, mirror, plate, support, held, shift, **which):
    """The pairs of one class; `which` is passed to `lowest`."""
    free = free_unknowns(solid.points, held, support.held, mirror, plate.radius)
    k, m = free.T @ solid.stiffness @ free, free.T @ solid.mass @ free
    values, vectors, residual = lowest(k, m, shift=shift, **which)
    shapes = (free @ vectors).T.reshape(-1, len(solid.points), 3) / part.copies**0.5
    return Class(mirror=mirror, values=values, shapes=shapes, residual=residual)


def solve(plate, support, size, which):
    """The sector, its matrices and every class; which[i] selects the pairs of class i (see `lowest`).

    Two classes are solved at a time: SuperLU lets another thread run, Python does not, and three gain nothing.
    """
    part = sector(plate.radius, plate.thickness, support, size)
    solid = assemble(part.mesh, ElementHex2(), plate.material, plate.density, intorder=4)
    shift = shift_for(plate, support)
    mirrors = classes(part.quarter)
    held = on_patch(solid.points, plate.radius, np.deg2rad(support.half_angle_deg), part.patch)
    if isinstance(which, dict):
        which = [which] * len(mirrors)

    def of_class(mirror, some):
        return solve_class(solid, part, mirror, plate, support, held, shift, **some)

    with ThreadPoolExecutor(2) as pool:
        return part, solid, list(pool.map(of_class, mirrors, which))


def without_rigid(solved, shift):
    """The classes without rigid-body modes; ArithmeticError unless a free body has exactly six, a held one none.

    Those of a free body are round-off, far below the shift; a held one has some if its patch is lost in round-off.
    """
    rigid = [np.count_nonzero(c.values < 1e-6 * abs(shift)) for c in solved]
    if shift and sum(rigid) != 6:
        raise ArithmeticError(f"{sum(rigid)} rigid-body modes were found, not 6")
    if not shift and sum(rigid):
        raise UnsolvableError(
            f"support: the patch is too small: round-off leaves the disk {sum(rigid)} rigid-body motion(s)"
        )
    return [
        Class(mirror=c.mirror, values=c.values[r:], shapes=c.shapes[r:], residual=c.residual[r:])
        for c, r in zip(solved, rigid, strict=True)
    ]


def held_modes(plate, support, below, accuracy) -> Modes:
    """The `Modes` below `below` [Hz] of a solid disk at one of `LEVELS`."""
    fine, coarse = (resolving(size, plate, below) for size in meshes(accuracy, plate, support))
    limit = (2 * pi * below) ** 2
    shift = shift_for(plate, support)
    part, solid, solved = solve(plate, support, fine, {"below": limit})
    check = [{"below": limit, "exactly": max(1, len(c.values))} for c in solved]
    _, _, rough = solve(plate, support, coarse, check)
    solved, rough = without_rigid(solved, shift), without_rigid(rough, shift)
    return unfolded(part, solid, solved, estimates(solved, rough), plate)


def estimates(solved, rough):
    """Estimated relative errors (m,) of the frequencies of all classes, from those of a coarser mesh."""
    pairs = zip(solved, rough, strict=True)
    error = SAFETY * np.concatenate([np.abs(np.sqrt(b.values[: len(a.values)] / a.values) - 1) for a, b in pairs])
    return np.maximum(error, LEAST * np.median(error)) if len(error) else error
