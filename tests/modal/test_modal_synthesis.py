"""Claim: two methods without a common mesh or boundary condition agree on the disk held on a patch.

Source: free modes with residual flexibility (component mode synthesis after MacNeal and Rubin);
finite elements. Oracle: each method for the other; for +-5 degrees also high-degree elements of an
independent program, converged to 3e-5; for a foil the thickness, to which the frequencies of a thin
plate are proportional.
"""

from dataclasses import replace
from math import pi
from types import SimpleNamespace

import numpy as np
import pytest

from benchmarks.cases.modes_case import modes_case
from modal import FreeDisk, Material, Plate, Support, eigenmodes
from modal.elements.patch import held_modes
from modal.synthesis.free_disk import BasisSizes

RADIUS, THICKNESS, DENSITY = 0.03755, 0.0128, 0.4387 / (pi * 0.03755**2 * 0.0128)
STEEL = Material(young=195e9, poisson=0.28)
DISK = Plate(radius=RADIUS, thickness=THICKNESS, material=STEEL, density=DENSITY)
REFERENCE = np.array(modes_case("patch").reference)


@pytest.fixture(scope="module")
def free_disk():
    return FreeDisk(plate=DISK)


def test_synthesis_is_within_a_thousandth(free_disk):
    frequency = free_disk.frequencies(Support(), below=20e3)
    assert len(frequency) == 9
    assert frequency == pytest.approx(REFERENCE, rel=5e-4)


def test_synthesis_converges_with_its_richness():
    error = []
    for around, through in ((2, 1), (3, 2), (5, 4)):
        richness = BasisSizes(
            size=(10, 6), circumferential_tractions=around, thickness_tractions=through
        )
        frequency = FreeDisk(plate=DISK, richness=richness).frequencies(
            Support(), below=20e3
        )
        error.append(np.abs(frequency / REFERENCE - 1).max())
    assert error[0] > 2 * error[1] > 4 * error[2]


TWO = ("tangential", "axial")
OTHERS = {
    "nearly incompressible": (0.45, 0.34, Support()),
    "nearly incompressible, small patch": (0.45, 0.34, Support(half_angle_deg=1)),
    "cork": (0.05, 0.34, Support(half_angle_deg=2)),
    "thin": (0.28, 0.1, Support()),
    "thinner": (0.28, 0.05, Support(half_angle_deg=10)),
    "as thick as wide": (0.28, 1.0, Support()),
    "thin, wide patch": (0.28, 0.08, Support(half_angle_deg=30)),
    "hinged": (0.28, 0.34, Support(held=TWO)),
    "hinged at a small patch": (0.28, 0.34, Support(half_angle_deg=2, held=TWO)),
    "hinged at a wide patch": (0.28, 0.34, Support(half_angle_deg=30, held=TWO)),
}
HALF_ANGLE_BY_NAME = {"narrow": 0.5} | {
    f"{angle} degrees": angle for angle in (2, 10, 25, 45, 60, 90, 130)
}
EXTREME_CASES = (
    "published",
    "narrow",
    "130 degrees",
    "nearly incompressible",
    "cork",
    "thinner",
    "as thick as wide",
    "hinged",
)
CASES = OTHERS | {
    name: (0.28, 0.34, Support(half_angle_deg=angle))
    for name, angle in HALF_ANGLE_BY_NAME.items()
}


def disk_of(poisson, aspect):
    """Return a disk and the limit [Hz] of the frequencies at which it is compared."""
    material = Material(young=195e9, poisson=poisson)
    thickness = aspect * RADIUS
    disk = Plate(radius=RADIUS, thickness=thickness, material=material, density=DENSITY)
    return disk, min(20e3, 60e3 * aspect)


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_finite_elements_lie_above_synthesis_within_their_own_estimate(name):
    poisson, aspect, support = CASES[name]
    disk, below = disk_of(poisson, aspect)
    frequency = FreeDisk(plate=disk).frequencies(support, below)
    elements = held_modes(disk, support, 1.02 * below, "standard")
    error = elements.frequency[: len(frequency)] / frequency - 1
    assert len(error) >= (5 if name in OTHERS else 2)
    assert error.min() > -1e-3
    assert error.max() < 0.02
    assert np.median(error) < 0.015
    assert (error <= elements.error[: len(frequency)]).mean() >= 0.9


@pytest.mark.slow
def test_a_thin_plate_is_resolved_up_to_20_khz():
    """A disk 2 mm thick has 24 modes below 20 kHz, with waves of a quarter of the diameter."""
    disk = Plate(radius=RADIUS, thickness=0.002, material=STEEL, density=DENSITY)
    support = Support(half_angle_deg=20)
    frequency = FreeDisk(plate=disk, richness=BasisSizes(cutoff=3)).frequencies(
        support, 19e3
    )
    elements = held_modes(disk, support, 20e3, "standard")
    error = elements.frequency[: len(frequency)] / frequency - 1
    assert len(error) > 20
    assert error.min() > -1.3e-3
    assert error.max() < 0.012
    assert (error <= elements.error[: len(frequency)]).all()


def test_a_narrow_patch_does_not_ask_for_more_tractions_than_a_wide_one(free_disk):
    """Tractions on a narrow patch have orders up to thousands; an integral gives flexibility."""
    narrow = Support(half_angle_deg=0.5)
    more = FreeDisk(
        plate=DISK, richness=BasisSizes(circumferential_tractions=8)
    ).frequencies(narrow, below=20e3)
    assert free_disk.frequencies(narrow, below=20e3) == pytest.approx(more, rel=5e-4)


@pytest.mark.slow
@pytest.mark.parametrize("name", EXTREME_CASES)
def test_errors_of_5e_5_and_more_are_estimated_within_a_factor_of_five(name):
    """Oracle: synthesis with a basis twice as rich, where it differs by more than its own estimate.

    Smaller errors come from terms of opposite sign that cancel; their estimate stays below 2e-4.
    """
    poisson, aspect, support = CASES.get(name, (0.28, 0.34, Support()))
    disk, below = disk_of(poisson, aspect)
    rich = BasisSizes(
        size=(16, 10), circumferential_tractions=14, thickness_tractions=8, cutoff=2.0
    )
    found, exact = (
        FreeDisk(plate=disk, richness=r).held(support, below)
        for r in (BasisSizes(), rich)
    )
    (f, estimate), (g, unsure) = (
        np.concatenate([[c.frequency, c.error] for c in k], axis=1)
        for k in (found, exact)
    )
    error = np.abs(f / g - 1)
    assert error.max() < 1e-3
    large = error > 5e-5
    assert (estimate > 1.2 * (error - unsure))[large].all()
    assert (estimate < 5 * (error + unsure))[large].all()
    assert estimate[~large].max(initial=0.0) < 2e-4


def test_holding_two_components_lowers_every_frequency(free_disk):
    two, three = (
        free_disk.frequencies(Support(held=held), below=20e3)[:9]
        for held in (TWO, Support().held)
    )
    assert (two < three).all()
    assert two[0] < 0.05 * three[0]


@pytest.mark.parametrize(
    ("held", "motions"), [(("radial",), 2), (("axial",), 3), (("radial", "axial"), 1)]
)
def test_components_that_leave_the_disk_loose_are_refused(held, motions):
    disk = SimpleNamespace(
        radius=RADIUS, thickness=THICKNESS, mass=DISK.mass, shape="solid"
    )
    numerics = SimpleNamespace(accuracy="standard")
    scene = SimpleNamespace(
        disk=disk, material=STEEL, support=Support(held=held), numerics=numerics
    )
    with pytest.raises(ValueError, match=f"{motions} rigid-body"):
        eigenmodes(scene)


def test_synthesis_refuses_plates_whose_edge_is_not_free_and_patches_that_leave_one_loose(
    free_disk,
):
    with pytest.raises(ValueError, match="free edge"):
        FreeDisk(plate=replace(DISK, edge="clamped"))
    with pytest.raises(ValueError, match="1 rigid-body"):
        free_disk.frequencies(Support(held=("radial", "axial")), below=20e3)


@pytest.mark.parametrize(
    "wrong",
    [{"edge": "foo"}, {"radius": -1.0}, {"inner_radius": 0.04}, {"density": 0.0}],
)
def test_a_plate_that_is_none_is_refused(wrong):
    with pytest.raises(ValueError, match=r"edge = 'foo'|a plate must have"):
        replace(DISK, **wrong)


def test_more_tractions_than_polynomials_through_the_thickness_are_refused():
    with pytest.raises(
        ValueError, match="thickness_tractions = 4: must not exceed the number of axial"
    ):
        BasisSizes(size=(14, 3), thickness_tractions=4)


@pytest.mark.slow
def test_a_foil_whose_tractions_are_dependent_is_solved_by_finite_elements(scene):
    foil = scene.replace(
        "disk.thickness=1.28e-4", "disk.mass=0.004387", "numerics.accuracy=draft"
    )
    modes = eigenmodes(foil, below=3000.0)
    assert modes.method == "finite elements"
    assert 40 <= len(modes.frequency) <= 46
    # a thin plate held at its edge: frequencies in proportion to the thickness
    thicker = foil.replace("disk.thickness=2.56e-4", "disk.mass=0.008774")
    lowest = eigenmodes(thicker, below=300.0)
    assert modes.frequency[0] * 2 == pytest.approx(lowest.frequency[0], rel=0.08)
