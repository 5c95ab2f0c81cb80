"""Claim: sign() at zero is set-valued for all three moments, and sticking starts and ends according
to the laws.

Source: (3.3) of the paper, read as Filippov's inclusion. Oracle: the times of independent event-
driven runs; the multipliers themselves; a second integrator.
"""

from importlib.util import find_spec

import numpy as np
import pytest
from arithmetic import gamma
from scenes import energy_spread, roll, scene

from dynamics import Outcome
from dynamics.regime import ARRAY_FORMULAS, Branch, contact_axis_rates

CASES = {
    "k1 = 0.01": ({"k1": 0.01}, "nutation sticks", 27.5595, 28.3098),
    "k1 = 0.05": ({"k1": 0.05}, "nutation sticks", 1.51, None),
    "k3 = 0.1": ({"k3": 0.1}, "pivoting sticks", 30.66, None),
    "no slip": (
        {"mu_static": np.inf, "mu_dynamic": np.inf},
        "pivoting sticks",
        188.06,
        None,
    ),
}


@pytest.fixture(scope="module", params=CASES)
def case(request):
    friction, *expected = CASES[request.param]
    return request.param, roll(scene(**friction)), expected


def test_first_sticking(case):
    _, motion, (what, start, end) = case
    chi = motion.disk.time_unit
    onset = next(i for i, s in enumerate(motion.transitions) if what in s.after)
    assert motion.transitions[onset].t / chi == pytest.approx(start, abs=5e-3)
    if end:
        leaving = next(
            s for s in motion.transitions[onset + 1 :] if what not in s.after
        )
        assert leaving.t / chi == pytest.approx(end, abs=5e-5)


def test_energy_and_dissipated_work_add_up(case):
    assert energy_spread(case[1]) < 1e-11


def test_what_sticks_stays_at_zero_with_a_multiplier_in_range(case):
    _, motion, _ = case
    arms = (motion.constants.k1, motion.constants.k2, motion.constants.k3)
    seen = 0
    for piece, kind in enumerate(motion.regime_of_piece):
        regime = motion.regimes[kind]
        if not any(regime.stuck):
            continue
        y = motion.path(motion.path.x[piece : piece + 2].mean(keepdims=True), [piece])[
            :, 0
        ]
        contact = ARRAY_FORMULAS.contact(
            y,
            Branch.of(regime, motion.constants, None),
            regime.senses,
            motion.constants,
        )
        turns = contact_axis_rates(y[0] ** 2, *y[1:4], np.sin, np.cos)
        for i in np.flatnonzero(regime.stuck):
            seen += 1
            assert abs(turns[i]) < gamma(10) * np.abs(y[1:4]).max()
            assert abs((contact.m1, contact.m2, contact.m3)[i]) <= arms[
                i
            ] * contact.Phi * (1 + 1e-9)
    assert seen > 0


def test_outcome(case):
    name, motion, _ = case
    ends = {"k1 = 0.01": (Outcome.SETTLED, 276.07), "k3 = 0.1": (Outcome.FELL, 30.8)}
    if name in ends:
        outcome, tau = ends[name]
        assert motion.rolling_outcome is outcome
        low = (
            motion.t[np.argmax(motion.state[:, 1] < 1e-8)]
            if outcome is Outcome.SETTLED
            else motion.t[-1]
        )
        assert low / motion.disk.time_unit == pytest.approx(tau, abs=0.02)
    else:
        assert motion.rolling_outcome in (Outcome.SETTLED, Outcome.FELL)


def test_without_pivoting_friction_the_disk_runs_past_tau_1000():
    motion = roll(scene(k3=0.0))
    assert motion.rolling_outcome is Outcome.SETTLED
    assert motion.t[-1] / motion.disk.time_unit > 1000


@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
def test_both_integrators_stick_alike():
    span = {"time_limit": 40 * scene().disk.time_unit}
    a, b = (
        roll(scene({"integrator": name, **span}, k1=0.01))
        for name in ("taylor", "dop853")
    )
    assert [s[1:] for s in a.transitions] == [s[1:] for s in b.transitions]
    np.testing.assert_allclose(
        [s.t for s in a.transitions], [s.t for s in b.transitions], rtol=1e-9
    )
    t = np.linspace(0, a.t[-1] * 0.999, 200)
    np.testing.assert_allclose(a.at(t), b.at(t), rtol=1e-8, atol=1e-8)


def test_several_surfaces_stick_at_once():
    motion = roll(scene(k1=0.05, k2=0.05, k3=0.05, mu_static=np.inf, mu_dynamic=np.inf))
    both = [s for s in motion.transitions if s.after.count("sticks") >= 2]
    assert both
    assert motion.rolling_outcome in (Outcome.SETTLED, Outcome.FELL)


@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
@pytest.mark.parametrize("k1", [0.001, 0.002, 0.003, 0.005])
def test_a_reversal_soon_after_another_is_not_missed(k1):
    """Two reversals of the nutation may be less than a step apart; the event function of the first
    is zero at the start of that step."""
    span = {"time_limit": 8 * scene().disk.time_unit}
    runs = [
        roll(scene({"integrator": name, **span}, k1=k1))
        for name in ("taylor", "dop853")
    ]
    ours, other = ([(e.guard, e.after) for e in run.transitions] for run in runs)
    assert ours == other
    assert any(guard == "nutation reverses" for guard, _ in ours)
    times = [[e.t for e in run.transitions] for run in runs]
    assert times[0] == pytest.approx(times[1], abs=1e-7)
