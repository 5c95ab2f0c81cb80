"""Claim: a guard keeps its name, its kind and its axis of rotation wherever it is used.

Source: (3.2), (3.3), (4.6) of the paper. Oracle: the balance laws at one state, solved
independently of the guards.
"""

import pickle

import pytest

from dynamics.equations import DiskConstants
from dynamics.guards import ALL_GUARDS, AXES, GuardKind, guard_named
from dynamics.regime import FLOAT_FORMULAS, Branch, Regime

LAW = DiskConstants(0.17, 1.0, 0.5, 0.3, 1e-4, 8e-4, 8e-3)
STATE = [0.7, 0.1, 0.2, -1.2, 0.3, -0.2, 0.4, 0.5, 0.0, 0.0, 0.0]


def guards_of(regime):
    branch = Branch.of(regime, LAW, None)
    contact = FLOAT_FORMULAS.contact(STATE, branch, regime.senses, LAW)
    return FLOAT_FORMULAS.guards(
        STATE, contact, branch, regime.senses, LAW, 1e-5
    ), contact


@pytest.mark.parametrize("guard", ALL_GUARDS)
def test_a_guard_travels_and_stays_what_it_is(guard):
    assert pickle.loads(pickle.dumps(guard)) is guard_named(str(guard)) is guard
    if guard.kind in (GuardKind.REVERSES, GuardKind.UNSTICKS):
        assert guard == f"{AXES[guard.axis]} {guard.kind.name.lower()}"


def test_each_turning_has_the_guard_of_its_state():
    named, contact = guards_of(Regime(False, (True, False, False), (1.0, 1.0, -1.0)))
    kinds = {guard.axis: guard.kind for guard in named if guard.axis is not None}
    assert kinds == {
        0: GuardKind.UNSTICKS,
        1: GuardKind.REVERSES,
        2: GuardKind.REVERSES,
    }
    assert named["nutation unsticks"] == pytest.approx(
        contact.Phi**2 - (contact.m1 / LAW.k1) ** 2
    )
    assert named["slip"] == pytest.approx(
        (LAW.mu_static * contact.Phi) ** 2 - contact.F1**2 - contact.F2**2
    )
    assert named["lift-off"] == contact.Phi
    assert "grip" not in named


def test_a_slide_ends_by_grip_or_jams_and_never_slips():
    named, contact = guards_of(Regime(True, (False,) * 3, (1.0, 1.0, -1.0)))
    assert named["grip"] == pytest.approx((0.3**2 + 0.2**2) ** 0.5, rel=1e-8)
    assert named["jams"] == contact.inertia
    assert "slip" not in named
