"""Where modal methods fail, as records: each function returns rows (dicts) of what was computed and how wrong it is.

All judge the first bending mode of a free disk, order 2, against the spectral solution, on a quarter of the disk.
"""

from dataclasses import replace
from math import pi

import numpy as np
from scipy.sparse.linalg import eigsh
from skfem import ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshHex

from modal.elements.elastic import assemble, inverse_at, lowest
from modal.elements.patch import shift_for
from modal.mesh.half_disk import Blocks, half_disk
from modal.mesh.sector import extrude, hexahedra
from modal.mesh.symmetry import Mirror, free_unknowns
from modal.modes import Material, Support
from modal.spectral.basis import problem
from modal.spectral.converge import solve

ELEMENTS = {"P1": ElementTetP1, "P2": ElementTetP2, "Q1": ElementHex1, "Q2": ElementHex2}
BENDING = Mirror(y=-1, z=-1)
"""The class of the sine partner of order 2; its only rigid-body mode is the tilt about x."""


def rate(plate):
    """A rate [1/s] some three times below the first elastic mode of a free disk."""
    return (-shift_for(plate, plate.material, Support(kind="free"), plate.density)) ** 0.5


def quarter_mesh(plate, split, curved):
    """Hexahedra of the quarter disk, split^2 per block, split in half the thickness, sides curved or straight."""
    plane = half_disk(pi, Blocks(width=pi / 4, depth=0.5, rings=0, split=split)) * plate.radius
    mesh = hexahedra(extrude(plane, np.linspace(0, plate.thickness / 2, split + 1)))
    return mesh if curved else MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)


def quarter_problem(plate, element, split=2, curved=True):
    """Stiffness and mass of the class `BENDING` and the `Solid`."""
    mesh = quarter_mesh(plate, split, curved and element == "Q2")
    if element in ("P1", "P2"):
        mesh = mesh.to_meshtet()
    solid = assemble(mesh, ELEMENTS[element](), plate.material, plate.density, intorder=4)
    nobody = np.zeros(len(solid.points), bool)
    free = free_unknowns(solid.points, nobody, ("radial", "tangential", "axial"), BENDING, plate.radius)
    return free.T @ solid.stiffness @ free, free.T @ solid.mass @ free, solid


def exact(plate):
    """Frequency [Hz] of the first bending mode of order 2, spectrally."""
    return np.sqrt(solve(plate, problem(plate, 2, -1), (8, 4), rate(plate)).values[0]) / (2 * pi)


def bending(plate, element, split=2, curved=True):
    """Its frequency [Hz] by finite elements; 0 where round-off has made the stiffness negative."""
    k, m, _ = quarter_problem(plate, element, split, curved)
    values, *_ = lowest(k, m, np.inf, shift=-(rate(plate) ** 2), exactly=2)
    return max(values[1], 0.0) ** 0.5 / (2 * pi)


def locking(plate, aspects=(0.3, 0.1, 0.03, 0.01), poissons=(0.28, 0.45, 0.49, 0.4999), split=2):
    """Ratio of the computed to the exact frequency of each element over thickness/radius and over Poisson's ratio."""
    materials = [Material(young=plate.material.young, poisson=nu) for nu in poissons]
    plates = [replace(plate, thickness=a * plate.radius) for a in aspects] + [
        replace(plate, material=m) for m in materials
    ]
    return [
        {
            "element": element,
            "aspect": one.thickness / one.radius,
            "poisson": one.material.poisson,
            "ratio": bending(one, element, split) / exact(one),
        }
        for one in plates
        for element in ELEMENTS
    ]


def straight_sides(plate, splits=(1, 2, 3)):
    """Relative error of frequency and mass of Q2 with straight and with curved sides over refinement."""
    rows = []
    for split in splits:
        for curved in (False, True):
            _, _, solid = quarter_problem(plate, "Q2", split, curved)
            frequency = bending(plate, "Q2", split, curved)
            mass = 4 * solid.total / plate.mass - 1
            rows.append({"split": split, "curved": curved, "frequency": frequency / exact(plate) - 1, "mass": mass})
    return rows


def whole_mesh(plate, split):
    """Curved hexahedra of the whole disk."""
    plane = half_disk(pi, Blocks(width=pi / 4, depth=0.5, rings=0, split=split)) * plate.radius
    plane = np.concatenate([plane, plane[:, ::-1] * [1, -1]])
    half = plate.thickness / 2
    return hexahedra(extrude(plane, np.linspace(-half, half, split + 1)))


def shifts(plate, split=1, count=9):
    """What shift-invert finds of the whole free disk about 0, -1 and far below the elastic modes.

    Of the lowest nine, six are rigid-body modes, two the pair of order 2, one of order 0. `rigid` counts eigenvalues
    that are 0 to 1e-6 of the first elastic one, `residual` is the worst |K u - w^2 M u| over |w_1^2 M u|.
    """
    solid = assemble(whole_mesh(plate, split), ElementHex2(), plate.material, plate.density, intorder=4)
    k, m = solid.stiffness, solid.mass
    scale, rows = (2 * pi * exact(plate)) ** 2, []
    for shift in (0.0, -1.0, -(rate(plate) ** 2)):
        try:
            values, u = eigsh(k, k=count, M=m, sigma=shift, OPinv=inverse_at(k, m, shift), v0=np.ones(k.shape[0]))
        except RuntimeError as failure:
            rows.append({"shift": shift, "rigid": 0, "elastic": 0, "residual": None, "failure": str(failure)})
            continue
        residual = np.linalg.norm(k @ u - (m @ u) * values, axis=0) / np.linalg.norm(m @ u * scale, axis=0)
        rigid = int(np.count_nonzero(np.abs(values) < 1e-6 * scale))
        elastic = int(np.count_nonzero(values > 0.5 * scale))
        found = {"shift": shift, "rigid": rigid, "elastic": elastic, "residual": float(residual.max()), "failure": ""}
        rows.append(found)
    return rows


def lumping(plate):
    """Share of unknowns whose row-sum mass is negative, per element."""
    rows = []
    for element in ELEMENTS:
        _, _, solid = quarter_problem(plate, element)
        lumped = np.asarray(solid.mass.sum(axis=1)).ravel()
        rows.append({"element": element, "negative": float((lumped < 0).mean())})
    return rows


def pair_splitting(plate, splits=(1, 2, 3)):
    """Relative distance of the frequencies of the pair of order 2, which are equal, on meshes without its symmetry."""
    rows = []
    for split in splits:
        found = []
        for y in (1, -1):
            solid = quarter_problem(plate, "Q2", split)[2]
            nobody = np.zeros(len(solid.points), bool)
            free = free_unknowns(
                solid.points, nobody, ("radial", "tangential", "axial"), Mirror(y=y, z=-1), plate.radius
            )
            k, m = free.T @ solid.stiffness @ free, free.T @ solid.mass @ free
            values, *_ = lowest(k, m, np.inf, shift=-(rate(plate) ** 2), exactly=3)
            found.append(np.sqrt(values[2 if y > 0 else 1]) / (2 * pi))
        rows.append({"split": split, "splitting": abs(found[0] / found[1] - 1), "beat": abs(found[0] - found[1])})
    return rows
