"""Test modal methods on thin disks, nearly incompressible material, shifts, and
supports that shrink to a point.

The reference of the first bending frequency has about twice as many polynomials. The
reference of a shift is the result of a shift well below the elastic eigenvalues on the
same mesh. A support is assessed by the exponent of the frequency as a power of its
size, which tends to 0 if the support is resolved."""

from dataclasses import replace
from functools import cache, partial
from math import log, pi

import numpy as np
from scipy.sparse.linalg import ArpackError, eigsh
from skfem import ElementHex1, ElementHex2, ElementTetP1, ElementTetP2, MeshHex

from benchmarks.cases.modes_case import modes_case
from benchmarks.timed_runs import (
    Answer,
    Failure,
    Work,
    distance_from_one,
    selected_values,
    works_over,
)
from modal import Material, Plate, Support
from modal.accuracy import COARSE_DRAFT_MESH, DRAFT_MESH
from modal.elements.elastic import assemble_solid, inverse_at, lowest_eigenpairs
from modal.elements.patch import eigenvalue_shift, solve_symmetry_classes
from modal.mesh.half_disk import MeshSize, half_disk
from modal.mesh.sector import extrude, hexahedra
from modal.mesh.symmetry import COMPONENTS, Mirror, admissible_displacements
from modal.spectral.basis import ritz_problem
from modal.spectral.p_refinement import solve_problem

OUR_POLYNOMIALS = (8, 4)
"""Numbers of radial and axial polynomials of our method."""

REFERENCE_POLYNOMIALS = (14, 8)
"""Numbers of radial and axial polynomials of the reference."""

ASPECTS = (0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4)
"""Ratios of thickness to radius."""

COMPRESSIBILITIES = (0.22, 0.1, 0.05, 0.01, 1e-3, 1e-4, 1e-5, 1e-6)
"""One half minus Poisson's ratio."""

SHIFTS = (0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 1.0, 1e2, 1e4, 1e6)
"""Negative shifts divided by the first elastic eigenvalue."""

MAX_RIGID_EIGENVALUE = 1e-6
"""Largest accepted eigenvalue of a rigid-body mode, divided by the first elastic
eigenvalue."""

MODE_COUNT = 9
"""Number of computed eigenvalues, including rigid-body modes."""

RIGID_BODY_MODES = 6

PATCH_HALF_ANGLES = (5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Half angles of a square patch [degrees]."""

EDGE_RINGS = (1, 2, 3, 4, 5)
"""Numbers of nested refinements at the edges of a patch of constant size."""

MAX_FREQUENCY_ERROR = 0.3
"""Relative error of a frequency above which a method fails."""

MAX_SIZE_EXPONENT = 0.1
"""Largest exponent of the frequency as a power of the size of the support for which a
limit is assumed."""

ELEMENTS = {
    "P1": ElementTetP1,
    "P2": ElementTetP2,
    "Q1": ElementHex1,
    "Q2": ElementHex2,
}
"""Element by its name in the chart."""

BENDING = Mirror(y=-1, z=-1)
"""Symmetry class of the sine mode of order 2; its only rigid-body mode is the rotation
about x."""


@cache
def disk() -> Plate:
    """Return the published disk."""
    return modes_case("free").plate


def thin_disk(aspect: float) -> Plate:
    """Return the disk with another ratio of thickness to radius."""
    return replace(disk(), thickness=aspect * disk().radius)


def nearly_incompressible_disk(compressibility: float) -> Plate:
    """Return the disk with the Poisson's ratio 1/2 - compressibility."""
    return replace(
        disk(),
        material=Material(young=disk().material.young, poisson=0.5 - compressibility),
    )


def rate_below_elastic(plate: Plate) -> float:
    """Return an angular frequency [1/s] about three times below the first elastic mode
    of a free disk."""
    return (-eigenvalue_shift(plate, Support(kind="free"))) ** 0.5


def free_disk(plate: Plate, element: str, split: int, whole: bool = False):
    """Return the `Solid` of a quarter or whole disk: split^2 cells per block, `split`
    layers per half thickness."""
    plane = half_disk(pi, MeshSize(width=pi / 4, depth=0.5, rings=0, split=split))
    height = plate.thickness / 2
    plane = np.concatenate([plane, plane[:, ::-1] * [1, -1]]) if whole else plane
    mesh = hexahedra(
        extrude(
            plane * plate.radius,
            np.linspace(-height if whole else 0, height, split + 1),
        )
    )
    if element != "Q2":
        mesh = MeshHex(mesh.doflocs[:, : mesh.t.max() + 1], mesh.t)
    mesh = mesh.to_meshtet() if element[0] == "P" else mesh
    return assemble_solid(
        mesh, ELEMENTS[element](), plate.material, plate.density, intorder=4
    )


def bending_of_solid(plate: Plate, solid, mirror: Mirror = BENDING) -> float:
    """Return the frequency [Hz] of the first bending mode, order 2, of a quarter disk
    by finite elements.

    It is 0 if round-off makes the stiffness negative.
    """
    free = admissible_displacements(
        solid.points,
        np.zeros(len(solid.points), bool),
        COMPONENTS,
        mirror,
        plate.radius,
    )
    k = free.T @ solid.stiffness @ free
    m = free.T @ solid.mass @ free
    rigid = 2 if mirror.y > 0 else 1
    values, *_ = lowest_eigenpairs(
        k, m, np.inf, shift=-(rate_below_elastic(plate) ** 2), exact_count=rigid + 1
    )
    return max(values[rigid], 0.0) ** 0.5 / (2 * pi)


def bending_by_elements(element: str, plate: Plate) -> float:
    """Return the frequency [Hz] of the first bending mode by a finite element on a
    coarse mesh."""
    return bending_of_solid(plate, free_disk(plate, element, 2))


def bending_by_polynomials(plate: Plate, size=OUR_POLYNOMIALS) -> float:
    """Return the frequency [Hz] of the first bending mode by Fourier series and
    polynomials."""
    return float(
        np.sqrt(
            solve_problem(
                plate, ritz_problem(plate, 2, -1), size, rate_below_elastic(plate)
            ).values[0]
        )
    ) / (2 * pi)


def relative_bending_frequency(frequency, disk_of, x: float) -> Answer:
    """Return the ratio of the first bending frequency of the disk disk_of(x) to its
    reference."""
    plate = disk_of(x)
    return Answer(
        (frequency(plate) / bending_by_polynomials(plate, REFERENCE_POLYNOMIALS),), 0
    )


@cache
def whole():
    """Return stiffness and mass of the free disk, and its first elastic eigenvalue
    [1/s^2] by polynomials."""
    solid = free_disk(disk(), "Q2", 1, whole=True)
    return solid.stiffness, solid.mass, (2 * pi * bending_by_polynomials(disk())) ** 2


def elastic_eigenvalues(share: float) -> np.ndarray:
    """Return the three lowest elastic eigenvalues by shift-invert; `share` is the
    negative shift divided by the first one.

    Raises Failure unless six rigid-body modes precede them, or if the factorisation or
    the iteration fails."""
    stiffness, mass, scale = whole()
    try:
        inverse = inverse_at(stiffness, mass, -share * scale)
        options = {
            "OPinv": inverse,
            "v0": np.ones(stiffness.shape[0]),
            "return_eigenvectors": False,
        }
        values = np.sort(eigsh(stiffness, MODE_COUNT, mass, -share * scale, **options))
    except (RuntimeError, ArpackError) as error:
        raise Failure(
            f"{type(error).__name__}: {' '.join(str(error).split())}"
        ) from None
    rigid = int(np.count_nonzero(np.abs(values) < MAX_RIGID_EIGENVALUE * scale))
    if rigid != RIGID_BODY_MODES:
        raise Failure(f"finds {rigid} rigid bodies, not {RIGID_BODY_MODES}")
    return values[RIGID_BODY_MODES:]


def relative_eigenvalues(share: float) -> Answer:
    """Return the ratios of elastic eigenvalues computed with a shift to those with the
    shift of `modal`."""
    ours = (rate_below_elastic(disk()) ** 2) / whole()[2]
    return Answer(tuple(elastic_eigenvalues(share) / elastic_eigenvalues(ours)), 0)


def supported_frequencies(support: Support, mesh) -> np.ndarray:
    """Return the first and the fourth frequency [Hz] of the disk on a support."""
    _, _, classes = solve_symmetry_classes(
        disk(), support, mesh, {"below": 0.0, "exact_count": 2}
    )
    values = np.sort(np.concatenate([c.values for c in classes]))
    return np.sqrt(values[[0, 3]]) / (2 * pi)


def square_patch_frequencies(half_angle: float) -> np.ndarray:
    """Return the two frequencies [Hz] of the disk on a square patch of a half angle
    [degrees]."""
    height = 2 * np.deg2rad(half_angle) * disk().radius
    return supported_frequencies(
        Support(half_angle_deg=half_angle, height=height), COARSE_DRAFT_MESH
    )


def refined_patch_frequencies(rings: int) -> np.ndarray:
    """Return the two frequencies [Hz] on the published patch with `rings` nested
    refinements at its edges."""
    return supported_frequencies(Support(), replace(DRAFT_MESH, rings=rings))


def size_exponent(frequencies, which: int, coarse, fine, ratio: float) -> Answer:
    """Return the exponent of a frequency as a power of a size, which is `ratio` times
    smaller at `fine`.

    Raises Failure if the exponent shows that the frequency has no limit.
    """
    exponent = log(frequencies(coarse)[which] / frequencies(fine)[which]) / log(ratio)
    if exponent > MAX_SIZE_EXPONENT:
        raise Failure(f"falls as the size to the power {exponent:.2f}, without limit")
    return Answer(abs(exponent), 0)


def works(quick: bool) -> list[Work]:
    """Return all runs; `quick` keeps the first and the last value of every
    parameter."""
    return [*bending_works(quick), *shift_works(quick), *support_works(quick)]


def bending_works(quick: bool) -> list[Work]:
    """Return the runs for thin disks and for nearly incompressible material."""
    methods = {("ours", "Fourier x polynomials"): bending_by_polynomials}
    methods |= {
        ("finite elements", element): partial(bending_by_elements, element)
        for element in ELEMENTS
    }
    runs = []
    for hazard, disk_of, values in (
        ("thin disk", thin_disk, ASPECTS),
        ("incompressible", nearly_incompressible_disk, COMPRESSIBILITIES),
    ):
        for labels, frequency in methods.items():
            solve_case = partial(relative_bending_frequency, frequency, disk_of)
            runs += works_over(
                *labels,
                "{:g}",
                selected_values(values, quick),
                solve_case,
                hazard,
                distance_from_one,
                MAX_FREQUENCY_ERROR,
            )
    return runs


def shift_works(quick: bool) -> list[Work]:
    """Return the runs with different shifts of the eigenproblem, and with that of
    `modal`."""
    our_shift = rate_below_elastic(disk()) ** 2 / whole()[2]
    shifts = selected_values(SHIFTS, quick)
    return [
        *works_over(
            "shift-invert",
            "a free disk",
            "{:g}",
            shifts,
            relative_eigenvalues,
            "shift",
            distance_from_one,
            MAX_FREQUENCY_ERROR,
        ),
        *works_over(
            "ours",
            "the shift in use",
            "{:.2g}",
            [our_shift],
            relative_eigenvalues,
            "shift",
            distance_from_one,
        ),
    ]


def support_works(quick: bool) -> list[Work]:
    """Return the runs with shrinking patches, and with refined edges of a patch of
    constant size."""
    case = "point support"
    runs = []
    for which, name in enumerate(("first frequency", "fourth frequency")):
        for half_angle in selected_values(PATCH_HALF_ANGLES, quick):
            call = partial(
                size_exponent,
                square_patch_frequencies,
                which,
                half_angle,
                half_angle / 2,
                2.0,
            )
            runs.append(
                Work(
                    "shrinking patch",
                    name,
                    f"{half_angle:g}",
                    case,
                    call,
                    float,
                    MAX_SIZE_EXPONENT,
                )
            )
        for rings in selected_values(EDGE_RINGS, quick):
            edge_size = 5.0 * DRAFT_MESH.ring_ratio**rings
            call = partial(
                size_exponent,
                refined_patch_frequencies,
                which,
                rings,
                rings + 1,
                1 / DRAFT_MESH.ring_ratio,
            )
            method = f"patch of 5 degrees, {name}"
            runs.append(
                Work(
                    "ours",
                    method,
                    f"{edge_size:.2g}",
                    case,
                    call,
                    float,
                    MAX_SIZE_EXPONENT,
                )
            )
    return runs
