"""Where modal methods fail: thin disks, rubber, shifts of the eigenproblem, supports that shrink to a point.

Frequencies of the first bending mode are judged by twice as many polynomials; shifts by the modes that one well below
the elastic ones gives on the same mesh; supports by the exponent with which the frequency follows their size, which for
a support that is resolved is none.
"""

from dataclasses import replace
from functools import cache, partial
from math import log, pi

import numpy as np
from scipy.sparse.linalg import ArpackError, eigsh
from skfem import ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshHex

from modal import Material, Plate, Support
from modal.accuracy import COARSE, ROUGH
from modal.elements.elastic import assemble, inverse_at, lowest
from modal.elements.patch import shift_for
from modal.elements.patch import solve as solve_held
from modal.mesh.half_disk import Blocks, half_disk
from modal.mesh.sector import extrude, hexahedra
from modal.mesh.symmetry import COMPONENTS, Mirror, free_unknowns
from modal.spectral.basis import problem
from modal.spectral.converge import solve
from sonify.charts.modes_case import modes_case
from sonify.charts.records import Answer, Failure, Work, along, ends, from_one

OURS, RICH = (8, 4), (14, 8)
"""Polynomials, radial and axial, of our method and of its judge."""
ASPECTS = (0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4)
"""Thickness over radius."""
COMPRESSIBILITIES = (0.22, 0.1, 0.05, 0.01, 1e-3, 1e-4, 1e-5, 1e-6)
"""One half minus Poisson's ratio."""
SHIFTS = (0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 1.0, 1e2, 1e4, 1e6)
"""Minus the shift over the square of the first elastic frequency."""
FEW, COUNT, RIGID = 1e-6, 9, 6
"""Part of the first elastic eigenvalue below which one is a rigid body's; modes sought, rigid bodies among them."""
SIZES = (5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Half angle [degrees] of a square patch."""
RINGS = (1, 2, 3, 4, 5)
"""Boxes nested about the edges of a patch that keeps its size; the elements at the edge are as small as they."""
LOCKED = 0.3
"""Relative error above which a frequency is another note."""
FOLLOWS = 0.1
"""Exponent above which a frequency follows the size of its support without limit."""
ELEMENTS = {"P1": ElementTetP1, "P2": ElementTetP2, "Q1": ElementHex1, "Q2": ElementHex2}
BENDING = Mirror(y=-1, z=-1)
"""The class of the sine partner of order 2; its only rigid-body mode is the tilt about x."""


@cache
def disk() -> Plate:
    """Return the published disk."""
    return modes_case("free").plate


def thin(aspect: float) -> Plate:
    """Return the disk with another thickness."""
    return replace(disk(), thickness=aspect * disk().radius)


def rubbery(compressibility: float) -> Plate:
    """Return the disk with Poisson's ratio near one half."""
    return replace(disk(), material=Material(young=disk().material.young, poisson=0.5 - compressibility))


def rate(plate: Plate) -> float:
    """Return a rate [1/s] some three times below the first elastic mode of a free disk."""
    return (-shift_for(plate, Support(kind="free"))) ** 0.5


def free_disk(plate: Plate, element: str, split: int, curved: bool = True, whole: bool = False):
    """Return the `Solid` of a quarter of a disk or all of it: split^2 cells per block, split in half the thickness."""
    plane, height = half_disk(pi, Blocks(width=pi / 4, depth=0.5, rings=0, split=split)), plate.thickness / 2
    plane = np.concatenate([plane, plane[:, ::-1] * [1, -1]]) if whole else plane
    mesh = hexahedra(extrude(plane * plate.radius, np.linspace(-height if whole else 0, height, split + 1)))
    if element != "Q2" or not curved:
        mesh = MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)
    mesh = mesh.to_meshtet() if element[0] == "P" else mesh
    return assemble(mesh, ELEMENTS[element](), plate.material, plate.density, intorder=4)


def bending(plate: Plate, solid, mirror: Mirror = BENDING) -> float:
    """Return the frequency [Hz] of the first bending mode, order 2, of a quarter disk by finite elements; 0 where
    round-off has made the stiffness negative."""
    free = free_unknowns(solid.points, np.zeros(len(solid.points), bool), COMPONENTS, mirror, plate.radius)
    k, m = free.T @ solid.stiffness @ free, free.T @ solid.mass @ free
    rigid = 2 if mirror.y > 0 else 1
    values, *_ = lowest(k, m, np.inf, shift=-(rate(plate) ** 2), exactly=rigid + 1)
    return max(values[rigid], 0.0) ** 0.5 / (2 * pi)


def by_elements(element: str, plate: Plate) -> float:
    """Return the same by an element on a coarse mesh."""
    return bending(plate, free_disk(plate, element, 2))


def polynomials(plate: Plate, size=OURS) -> float:
    """Return the frequency [Hz] of the first bending mode by Fourier series and polynomials."""
    return float(np.sqrt(solve(plate, problem(plate, 2, -1), size, rate(plate)).values[0])) / (2 * pi)


def bent(frequency, of, x: float) -> Answer:
    """Return the frequency of the first bending mode of the disk `of` x, over the true one."""
    return Answer((frequency(of(x)) / polynomials(of(x), RICH),), 0)


@cache
def whole():
    """Return stiffness and mass of the free disk and the square of the scale of its frequencies [1/s^2]."""
    solid = free_disk(disk(), "Q2", 1, whole=True)
    return solid.stiffness, solid.mass, (2 * pi * polynomials(disk())) ** 2


def elastic(share: float) -> np.ndarray:
    """Return the three lowest elastic eigenvalues by shift-invert about -share of the first one.

    Raises Failure unless six rigid bodies come before them, or if the factorisation or the iteration fails.
    """
    stiffness, mass, scale = whole()
    try:
        inverse = inverse_at(stiffness, mass, -share * scale)
        options = {"OPinv": inverse, "v0": np.ones(stiffness.shape[0]), "return_eigenvectors": False}
        values = np.sort(eigsh(stiffness, COUNT, mass, -share * scale, **options))
    except (RuntimeError, ArpackError) as error:
        raise Failure(f"{type(error).__name__}: {' '.join(str(error).split())}") from None
    rigid = int(np.count_nonzero(np.abs(values) < FEW * scale))
    if rigid != RIGID:
        raise Failure(f"finds {rigid} rigid bodies, not {RIGID}")
    return values[RIGID:]


def shifted(share: float) -> Answer:
    """Return the elastic eigenvalues about a shift, over those about ours."""
    ours = (rate(disk()) ** 2) / whole()[2]
    return Answer(tuple(elastic(share) / elastic(ours)), 0)


def held(support: Support, mesh) -> np.ndarray:
    """Return the first and the fourth frequency [Hz] of the disk on a support."""
    _, _, classes = solve_held(disk(), support, mesh, {"below": 0.0, "exactly": 2})
    values = np.sort(np.concatenate([c.values for c in classes]))
    return np.sqrt(values[[0, 3]]) / (2 * pi)


def square(half_angle: float) -> np.ndarray:
    """Return the two frequencies on a patch as high as it is wide, of a half angle [degrees]."""
    height = 2 * np.deg2rad(half_angle) * disk().radius
    return held(Support(half_angle_deg=half_angle, height=height), COARSE)


def nested(rings: int) -> np.ndarray:
    """Return the two frequencies on the published patch with `rings` boxes nested about its edges."""
    return held(Support(), replace(ROUGH, rings=rings))


def follows(frequencies, which: int, at, finer, ratio: float) -> Answer:
    """Return the exponent with which a frequency follows a size that is `ratio` times smaller from `at` to `finer`.

    Raises Failure where it has no limit.
    """
    exponent = log(frequencies(at)[which] / frequencies(finer)[which]) / log(ratio)
    if exponent > FOLLOWS:
        raise Failure(f"falls as the size to the power {exponent:.2f}, without limit")
    return Answer(abs(exponent), 0)


def works(quick: bool) -> list[Work]:
    """Return every run; `quick` keeps both ends of every path."""
    runs = []
    for hazard, of, path in (("thin disk", thin, ASPECTS), ("incompressible", rubbery, COMPRESSIBILITIES)):
        rows = {("ours", "Fourier x polynomials"): polynomials}
        rows |= {("finite elements", element): partial(by_elements, element) for element in ELEMENTS}
        for about, frequency in rows.items():
            runs += along(*about, "{:g}", ends(path, quick), partial(bent, frequency, of), hazard, from_one, LOCKED)
    runs += along("shift-invert", "a free disk", "{:g}", ends(SHIFTS, quick), shifted, "shift", from_one, LOCKED)
    runs += along("ours", "the shift in use", "{:.2g}", [rate(disk()) ** 2 / whole()[2]], shifted, "shift", from_one)
    for which, name in enumerate(("first frequency", "fourth frequency")):
        for x in ends(SIZES, quick):
            call = partial(follows, square, which, x, x / 2, 2.0)
            runs.append(Work("shrinking patch", name, f"{x:g}", "point support", call, float, FOLLOWS))
        for rings in ends(RINGS, quick):
            x = 5.0 * ROUGH.ratio**rings
            call = partial(follows, nested, which, rings, rings + 1, 1 / ROUGH.ratio)
            runs.append(Work("ours", f"patch of 5 degrees, {name}", f"{x:.2g}", "point support", call, float, FOLLOWS))
    return runs
