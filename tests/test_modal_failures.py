"""Claim: the ways in which modal methods fail are as large as said, and the ways used here do not fail in them.

Source: locking, variational crimes and lumping as in Hughes, The Finite Element Method. Oracle: the spectral solution.
"""

import pytest

from modal import Material, Plate
from sonify.charts.modal_failures import locking, lumping, pair_splitting, shifts, straight_sides

DISK = Plate(radius=0.03755, thickness=0.0128, material=Material(young=195e9, poisson=0.28), density=7737.27)


def test_linear_elements_lock_in_thin_disks_and_near_incompressibility():
    rows = locking(DISK, aspects=(0.1, 0.01), poissons=(0.28, 0.4999))
    ratio = {(r["element"], round(r["aspect"], 2), r["poisson"]): r["ratio"] for r in rows}
    assert ratio["P1", 0.01, 0.28] > 10
    assert ratio["Q1", 0.01, 0.28] > 5
    assert ratio["P1", 0.34, 0.4999] > 2.5
    for element, slack in (("P2", 0.05), ("Q2", 0.03)):
        worst = max(value for (name, _, _), value in ratio.items() if name == element)
        assert 1 < worst < 1 + slack
    assert min(ratio.values()) > 1


def test_straight_sides_err_by_the_volume_they_leave_out():
    rows = {(r["split"], r["curved"]): r for r in straight_sides(DISK, splits=(1, 2))}
    for split in (1, 2):
        assert rows[split, False]["frequency"] > 5 * rows[split, True]["frequency"] > 0
        assert rows[split, False]["frequency"] == pytest.approx(-rows[split, False]["mass"], rel=0.2)
    assert rows[1, False]["mass"] / rows[2, False]["mass"] == pytest.approx(4, rel=0.05)
    assert rows[1, True]["mass"] / rows[2, True]["mass"] == pytest.approx(16, rel=0.05)


def test_the_shift_used_finds_six_rigid_modes_and_the_elastic_ones():
    _, at_one, below = shifts(DISK)
    assert (below["rigid"], below["elastic"]) == (6, 3)
    assert below["residual"] < 1e-9
    assert at_one["failure"] or at_one["residual"] > 1e3 * below["residual"]


def test_row_sums_of_quadratic_tetrahedra_are_negative():
    negative = {r["element"]: r["negative"] for r in lumping(DISK)}
    assert negative["P2"] > 0.1
    assert negative["P1"] == negative["Q1"] == 0


def test_meshes_split_pairs_as_they_err():
    rows = pair_splitting(DISK, splits=(1, 2))
    assert rows[0]["beat"] > 0.1
    assert rows[0]["splitting"] > 4 * rows[1]["splitting"]
