"""Claim: the failure map is correct: each failure occurs where it is drawn, and our default methods
have none.

Source: (3.3) as Filippov's differential inclusion; the stability limits of the textbook
integrators; locking and frequency shifts as in Hughes, The Finite Element Method; a clamped square
of side a has a stiffness ~ a for translation and ~ a^3 for rotation. Oracle: 80-bit arithmetic for
motions; closed forms for oscillators and thin plates. test_charts_motion.py tests failures at
sticking and slips, tests/modal/test_convergence_rates.py quadratic elements.
"""

import re
from importlib.util import find_spec
from math import pi

import numpy as np
import pytest
from plate_theory import thin_plate_frequencies

from benchmarks.charts import (
    stability_chart,
    stability_modes,
    stability_motion,
    stability_sound,
)
from benchmarks.charts.stability_chart import DEGRADED, FAILED, FINE, state
from benchmarks.methods.oscillator_steps import STEPS, growth_and_tuning, static_gain
from benchmarks.timed_runs import Record, measure

MOTIONS = {
    (w.case, w.family, w.method, w.setting): w for w in stability_motion.works(False)
}
MODES = {
    (w.case, w.family, w.method, w.setting): w for w in stability_modes.works(False)
}
SLIP, NUTATION, PIVOT, FLAT = (
    "small slip",
    "nutation sticks",
    "pivoting sticks",
    "small inclination",
)
FAILS = {
    (FLAT, "Moreau", "step 1e-3", "1e-06"): "left the table",
    (FLAT, "Moreau", "step 1e-5", "1e-10"): "left the table",
    (FLAT, "Euler angles", "DOP853, tol 1e-12", "1e-09"): "creeps",
    (SLIP, "event-driven", "solve_ivp DOP853, tolerance", "1e-06"): "never grips again",
    (SLIP, "tanh", "LSODA, width", "1e-12"): "step underflow|chatters",
    (SLIP, "tanh", "Radau, width", "0.01"): "wrong",
    (
        NUTATION,
        "event-driven",
        "solve_ivp DOP853, tol 1e-6",
        "0.01",
    ): "never grips again",
    (NUTATION, "naive sign()", "RK45, tol 1e-8", "0.05"): "chatters",
    (NUTATION, "slip tolerance", "1e-4", "0.05"): "chatters",
    (NUTATION, "tanh", "LSODA, width 1e-3", "0.01"): "wrong",
    (PIVOT, "naive sign()", "RK45, tol 1e-8", "0.5"): "chatters",
}
DEGRADES = [
    (FLAT, "naive sign()", "RK45, tol 1e-8", "1e-10"),
    (FLAT, "naive sign()", "LSODA, tol 1e-8", "1e-10"),
    (SLIP, "slip tolerance", "starts and ends slides", "0.01"),
    (NUTATION, "tanh", "LSODA, width 1e-6", "0.01"),
    (NUTATION, "Moreau", "step 1e-3", "0.01"),
]


def record_of(key, works=MOTIONS):
    return measure(works[key])


@pytest.mark.parametrize("key", [k for k in MOTIONS if k[1] == "ours"], ids=" ".join)
def test_our_motions_are_fine_on_every_path(key):
    if "Taylor" in key[2] and not find_spec("heyoka"):
        pytest.skip("heyoka is not installed")
    record = record_of(key)
    assert not record.failure
    assert state(record) == FINE


@pytest.mark.parametrize("key", FAILS, ids=" ".join)
def test_simpler_motions_fail_as_drawn(key):
    assert re.match(FAILS[key], record_of(key).failure or "fine")


@pytest.mark.parametrize("key", DEGRADES, ids=" ".join)
def test_simpler_motions_degrade_as_drawn(key):
    assert state(record_of(key)) == DEGRADED


def test_long_steps_detune_and_blow_up_at_the_known_limits():
    found = {
        (r.method, float(r.setting)): r
        for r in stability_sound.records()
        if r.case == "long steps"
    }
    assert all(
        state(found[stability_sound.OUR_STEP, x]) == FINE
        for x in stability_sound.LONG_STEPS
    )
    for x in stability_sound.LONG_STEPS:
        for method, limit in {
            "Verlet": 2,
            "semi-implicit Euler": 2,
            "Runge-Kutta 4": 8**0.5,
            "explicit Euler": 0,
        }.items():
            assert found[method, x].failure.startswith("grows") == (x > limit)
        assert found["bilinear", x].error == pytest.approx(
            abs(1200 * np.log2(2 / x * np.arctan(x / 2))), abs=0.01
        )
    assert state(found["bilinear", 0.1]) == FINE
    assert state(found["bilinear", 0.4]) == DEGRADED
    assert state(found["bilinear", 1.2]) == FAILED


def test_about_half_the_sample_rate_others_alias_and_ours_refuses():
    found = {
        (r.method, float(r.setting)): r
        for r in stability_sound.records()
        if r.case.startswith("near half")
    }
    for share in stability_sound.RELATIVE_FREQUENCIES:
        assert state(found[stability_sound.OUR_STEP, share]) == FINE
        assert stability_sound._is_rejected(share) == (share >= 0.5)
        assert state(found["bilinear", share]) == FAILED
        assert ("sounds at" in found["exact, zero-order hold", share].failure) == (
            share > 0.5
        )
    assert "0.4 of the sample rate" in found["impulse-invariant", 0.6].failure
    assert "steady force" in found["impulse-invariant", 0.45].failure


@pytest.mark.parametrize("x", [0.1, 1.0, 2.5])
def test_the_steady_response_of_samples_as_impulses_is_a_cotangent(x):
    w = np.array([x])
    none = np.zeros(1)
    assert static_gain(STEPS["impulse-invariant"], w, none, 1.0) == pytest.approx(
        x / 2 / np.tan(x / 2), rel=1e-9
    )
    assert static_gain(STEPS["bilinear"], w, none, 1.0) == pytest.approx(1, rel=1e-9)
    assert growth_and_tuning(STEPS["impulse-invariant"], w, none, 1.0)[
        1
    ] == pytest.approx(1, rel=1e-9)


@pytest.mark.parametrize("key", [k for k in MODES if k[1] == "ours"], ids=" ".join)
def test_our_modes_are_fine_on_every_path(key):
    assert state(record_of(key, MODES)) == FINE


def test_our_modes_of_a_very_thin_disk_are_those_of_a_plate():
    thin = stability_modes.thin_disk(1e-4)
    material = thin.material
    plate = thin_plate_frequencies(
        2,
        1,
        thin.radius,
        thin.thickness,
        material.young,
        material.poisson,
        thin.density,
    )
    assert stability_modes.bending_by_polynomials(thin) == pytest.approx(
        plate[0], rel=1e-6
    )


@pytest.mark.parametrize(
    ("hazard", "element", "setting", "which"),
    [
        ("thin disk", "P1", "0.3", FAILED),
        ("thin disk", "Q1", "0.1", FAILED),
        ("thin disk", "P2", "0.0001", FAILED),
        ("thin disk", "Q2", "0.0001", FAILED),
        ("thin disk", "Q2", "0.01", FINE),
        ("incompressible", "P1", "1e-06", FAILED),
        ("incompressible", "Q1", "1e-06", DEGRADED),
        ("incompressible", "Q2", "1e-06", FINE),
    ],
)
def test_elements_lock_as_drawn(hazard, element, setting, which):
    assert (
        state(record_of((hazard, "finite elements", element, setting), MODES)) == which
    )


def test_shifts_close_to_the_rigid_bodies_or_far_below_find_other_modes():
    found = {
        key[3]: state(record_of(key, MODES))
        for key in MODES
        if key[:2] == ("shift", "shift-invert")
    }
    assert {found["1e-12"], found["1e-10"]} <= {FAILED, DEGRADED}
    assert found["1e+06"] == FAILED
    assert found["0.1"] == FINE


def test_frequencies_fall_without_limit_on_a_support_that_shrinks_to_a_point():
    size = 0.05
    first, fourth = np.log(
        stability_modes.square_patch_frequencies(size)
        / stability_modes.square_patch_frequencies(size / 2)
    ) / np.log(2)
    assert first == pytest.approx(3 / 2, abs=0.02)
    assert fourth == pytest.approx(1 / 2, abs=0.02)
    for which in ("first frequency", "fourth frequency"):
        failure = record_of(
            ("point support", "shrinking patch", which, "0.01"), MODES
        ).failure
        assert "without limit" in failure


def test_what_a_path_says_in_words():
    runs = [
        Record(family="a", method="b", setting=str(x), case=SLIP, error=e)
        for x, e in ((1, 0), (2, 1), (3, 1))
    ]
    assert [
        stability_chart._values_in_state(runs, which) for which in (DEGRADED, FAILED)
    ] == [
        "from 2 on",
        "-",
    ]
    ((_, row),) = stability_chart.tables(runs).values()
    assert row == ["a: b", "from 2 on", "-"]
    assert (
        stability_chart.conclusion(runs)[2]
        == "Fine at all values of a parameter, other methods: 0 of 1 rows."
    )


def test_every_path_is_a_hazard_of_the_map():
    cases = {key[0] for key in MOTIONS | MODES} | {
        r.case for r in stability_sound.records()
    }
    assert cases == set(stability_chart.HAZARDS)
    assert pi > max(stability_sound.LONG_STEPS)
