"""Claim: near every limit of its range the simulator is correct or stops with a named outcome; it
is never silently wrong.

Source: sections 2, 3 and 6.2 of the paper; Painleve (1895) for contacts without a solution. Oracle:
asymptotic limits (vanishing start-up slip); identities (energy); the force computed by hand.
"""

from functools import cache
from math import pi, radians
from types import SimpleNamespace

import numpy as np
import pytest
from arithmetic import gamma
from scenes import (
    conservative,
    energy_spread,
    proves_its_outcome,
    roll,
    scene,
    whirling,
)

from dynamics import ImpossibleContactError, Outcome, regime, switching
from dynamics.equations import DiskConstants
from dynamics.hybrid import Arc
from dynamics.integrators.codegen import compile_branch
from dynamics.observables import nutation_frequency, slip_start_times
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator
from sonify import load_scene
from sonify.claims.checks import energy_balance
from sonify.claims.rigid_motion import motion_findings
from sonify.claims.sound import tone_rate_findings


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "module", "factor"),
    [("FIRST_SLIDE_STEP", switching, 0.3), ("STOP_SLIP_SPEED", regime, 10.0)],
)
def test_no_start_up_or_stopping_speed_shows(monkeypatch, name, module, factor):
    span = {"time_limit": 50 * scene().disk.time_unit, "integrator": "dop853"}
    t = np.linspace(0, 49.9 * scene().disk.time_unit, 100)
    before = roll(scene(span)).at(t)
    for owner in (
        module,
        __import__("dynamics.rolling", fromlist=["x"]),
        switching,
        regime,
    ):
        if hasattr(owner, name):
            monkeypatch.setattr(
                owner,
                name,
                getattr(module, name) * factor
                if owner is module
                else getattr(module, name),
            )
    monkeypatch.setattr(
        "dynamics.integrators.dop853.compile_branch", cache(compile_branch.__wrapped__)
    )  # the compiled flow holds STOP_SLIP_SPEED
    after = roll(scene(span)).at(t)
    np.testing.assert_allclose(after, before, rtol=1e-9, atol=1e-9)


def test_upright_is_a_named_end():
    motion = roll(scene(release={"inclination_deg": 89.9, "omega": (-1.0, 0.0, -10.0)}))
    assert motion.rolling_outcome is Outcome.UPRIGHT
    moved = motion.t[-1] * abs(motion.state[-1, 5])
    assert motion.state[-1, 1] == pytest.approx(
        pi / 2, abs=gamma(50) * (pi / 2 + moved)
    )


@pytest.mark.parametrize("rate", [-1e-12, -1e-9, -1e-6, -1e-4])
def test_a_nutation_that_reverses_within_the_first_step_of_a_slide_is_not_missed(rate):
    """A missed reversal would let the moment drive the disk, and the energy would rise."""
    motion = roll(
        scene(
            release={"inclination_deg": 3.0, "omega": (rate, 0.0, 0.0)},
            k1=0.03,
            k2=0.0,
            k3=0.0,
        )
    )
    assert motion.rolling_outcome is Outcome.FELL
    assert motion.constants.k1 * np.ptp(motion.state[:, 1]) > 1e-3, (
        "what the moment takes is far above round-off"
    )
    assert np.diff(motion.state[:, 10]).min() >= 0
    assert energy_spread(motion) < 1e-10


def test_lift_off_is_an_outcome_with_its_time():
    fast = scene(
        release={"inclination_deg": 60.0, "omega": (0.0, 0.5 / 0.06917, -4 / 0.06917)}
    )
    motion = roll(fast)
    assert motion.rolling_outcome is Outcome.LIFTED_OFF
    before, after = motion.normal_load(motion.t[-1] - [1e-4, 0])
    slope = (before - after) / 1e-4
    assert after == pytest.approx(0, abs=gamma(50) * (1 + motion.t[-1] * slope))
    assert motion.t_end == motion.t[-1], (
        "an inclination that rises has no time at which it is zero"
    )
    assert motion.normal_load(np.linspace(0, motion.t[-1] * 0.999, 500)).min() > 0


def test_a_release_that_leaves_the_plane_at_once_is_refused():
    with pytest.raises(
        ImpossibleContactError,
        match=r"at t = 0 s: inclination 0\.52.*leaves the plane at once",
    ):
        roll(scene(release={"inclination_deg": 30.0, "omega": (40.0, 0.0, 0.0)}))


def test_a_contact_that_jams_is_named():
    """A long rod slides towards its far end with e mu f > f^2 + J: no force lifts it (Painleve)."""
    beta = 1.047
    law = DiskConstants(3.0, 1.0, 2.0, 2.0, 0.0, 0.0, 0.0)
    y = [beta**0.5, 0.0, 0.0, 0.0, 0.0, -1.0, *[0.0] * 5]
    slide = regime.Regime(True, (False,) * 3, (1.0,) * 3)
    contact = regime.FLOAT_FORMULAS.contact(
        y, regime.Branch.of(slide, law, None), slide.senses, law
    )
    assert contact.inertia < 0
    with pytest.raises(
        ImpossibleContactError, match=r"inclination 1\.047 rad.*slip \(-?0, -1\.02"
    ):
        switching.next_regime(y, law, None, frozenset(), frozenset(), (1.0,) * 3, None)
    system = RollingDisk(law, None, 1e-5, chosen_integrator("dop853")[1], 1e-12)
    with pytest.raises(ImpossibleContactError, match="jams"):
        system.switch(y, slide, "jams")


@pytest.mark.parametrize(
    ("disk", "friction"),
    [
        ({}, {"mu_static": 0.0, "mu_dynamic": 0.0}),
        ({}, {"mu_static": 0.02, "mu_dynamic": 0.01}),
        ({}, {"k1": 0.0, "k2": 0.05, "k3": 0.0}),
        ({"thickness": 1e-7}, {}),
        ({"shape": "shell"}, {}),
        ({"radius": 0.01, "thickness": 0.03, "mass": 0.07}, {}),
    ],
    ids=["no friction", "slippery", "rolling only", "thin", "shell", "rod"],
)
def test_extreme_disks_and_frictions_run_to_a_named_end(disk, friction):
    motion = roll(scene({"time_limit": 30.0}, disk=disk, **friction))
    assert proves_its_outcome(motion, 30.0)
    assert np.isfinite(motion.state).all()
    assert energy_spread(motion) < 1e-10
    lowest = motion.normal_load(np.linspace(0, motion.t[-1], 20_000)).min()
    assert lowest > -1e-9


@pytest.mark.slow
def test_equal_coefficients_slide_without_a_jump_of_the_force():
    """With mu_static = mu_dynamic a slide starts without acceleration or jump of the force."""
    motion = roll(scene({"time_limit": 5.0}, mu_static=0.3, mu_dynamic=0.3))
    starts = slip_start_times(motion)
    assert len(starts) > 10
    jumps = motion.jumps
    for t in starts:
        i = np.argmin(np.abs(jumps.t - t))
        assert jumps.after[i, 2] == pytest.approx(jumps.before[i, 2], rel=1e-9)
    assert energy_spread(motion) < 1e-11


def test_what_a_steady_motion_cannot_tell_is_not_judged():
    """Without peaks of the force there is no nutation; without slips there is no slide."""
    motion = roll(whirling(radians(8), numerics={"time_limit": 5.0}))
    assert len(nutation_frequency(motion)[0]) == 0
    tone = SimpleNamespace(time=np.linspace(0.1, 4.9, 50), frequency=np.full(50, 10.0))
    assert tone_rate_findings(tone, motion, SimpleNamespace(source_end=5.0)) == []
    published = load_scene("published")
    claims = " ".join(finding.claim for finding in motion_findings(published, motion))
    assert "energy" in claims
    assert "frequency" not in claims
    assert "Sliding" not in claims


def test_a_rate_is_not_judged_where_the_tone_is_not_heard():
    motion = roll(scene({"time_limit": 6.0}))
    assert len(nutation_frequency(motion)[0]) > 0
    ridge = SimpleNamespace(time=np.linspace(2.5, 4.5, 50), frequency=np.full(50, 10.0))
    tone = SimpleNamespace(ridge=ridge)
    assert tone_rate_findings(tone, motion, SimpleNamespace(source_end=6.0)) == []
    late = tone_rate_findings(tone, motion, SimpleNamespace(source_end=5.0))
    assert [finding.claim[:18] for finding in late] == ["In the last second"]


SPAN = 5 * scene().disk.time_unit
STIFF = [
    pytest.param(
        "integrators.slow_slides._integrate_slide",
        lambda *_, **__: Arc(np.empty(0), np.empty((0, 1, 11)), [], None),
        {"mu_dynamic": 0.5},
        marks=pytest.mark.slow,
    ),
    ("incipient_slip.SlipAcceleration.aligned_direction_near", lambda *_: None, {}),
]


@pytest.mark.parametrize(
    ("name", "value", "friction"),
    STIFF,
    ids=["no step is short enough", "no direction"],
)
def test_a_slide_that_cannot_be_followed_is_a_named_end_at_its_start(
    monkeypatch, name, value, friction
):
    wanted = scene({"time_limit": SPAN, "tolerance": 1e-12}, **friction)
    slip = next(s for s in roll(wanted).transitions if s.guard == "slip")
    monkeypatch.setattr(f"dynamics.{name}", value)
    motion = roll(wanted)
    assert motion.outcome is Outcome.STALLED
    assert motion.t[-1] == pytest.approx(slip.t, rel=1e-9)
    assert energy_spread(motion) < 1e-11


def test_a_release_whose_slide_cannot_be_followed_is_refused_with_time_and_state(
    monkeypatch,
):
    monkeypatch.setattr(
        "dynamics.incipient_slip.SlipAcceleration.aligned_direction_near",
        lambda *_: None,
    )
    with pytest.raises(
        ImpossibleContactError,
        match=r"at t = 0 s: inclination 0\.57.*the direction of the slide",
    ):
        roll(scene(mu_static=0.02, mu_dynamic=0.01))


def test_nothing_happens_to_a_disk_without_loss_but_its_motion():
    motion = roll(conservative(numerics={"time_limit": 5.0}))
    assert motion.transitions == ()
    assert not motion.state[:, 10].any(), (
        "without an arm nothing is dissipated, not even round-off"
    )


def test_without_heyoka_the_portable_integrator_is_chosen(monkeypatch):
    monkeypatch.setattr("dynamics.solver_settings.find_spec", lambda name: None)
    assert chosen_integrator("auto")[0] == "dop853"
    assert roll(scene({"time_limit": 0.1})).integrator == "dop853"
    with pytest.raises(ValueError, match="requires heyoka, which is not installed"):
        chosen_integrator("taylor")


@pytest.mark.parametrize("integrator", ["auto", "dop853"])
def test_a_resistance_beyond_all_measure_is_a_named_end(integrator):
    """The drag is too strong for both integrators: no step makes progress."""
    drag = {"power_coefficient": 1e6, "power_exponent": 2.5}
    motion = roll(scene({"integrator": integrator}, dissipation=drag))
    assert motion.outcome is Outcome.STALLED
    assert np.isfinite(motion.state).all()
    assert energy_balance(motion).passed


def test_a_disk_released_at_rest_falls_as_without_a_law_that_has_no_series_there():
    """For b = 2.5, |Omega|^(b-1) has no Taylor series at Omega = 0.

    The precession stays at zero and dissipates no power.
    """
    still = {"inclination_deg": 12.0, "omega": (0.0, 0.0, 0.0)}
    resisted = {"power_coefficient": 4e-9, "power_exponent": 2.5}
    motions = [
        roll(scene(release=still, **more)) for more in ({}, {"dissipation": resisted})
    ]
    assert {motion.rolling_outcome for motion in motions} == {Outcome.FELL}
    assert motions[1].t[-1] == pytest.approx(motions[0].t[-1], rel=1e-12)
    assert energy_spread(motions[1]) < 1e-13
