"""Claim: the motion of the published case is solved to the accuracy that the conditioning of the
problem allows.

Source: Kessler & O'Reilly (2002), (7.1), (7.3), (7.4), with the errata of (5.3), (6.1), (7.2)
corrected. Oracle: an independent simulation in quadruple precision (tests/references/motion.json).
"""

import json
from importlib.util import find_spec

import numpy as np
import pytest
from arithmetic import gamma
from paths import REFERENCES
from scenes import energy_spread, scene

from dynamics import Motion, Outcome, simulate
from dynamics.observables import slip_start_times
from sonify import load_scene

REFERENCE = json.loads((REFERENCES / "motion.json").read_text())
taylor = pytest.param(
    "taylor",
    marks=pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed"),
)


@pytest.fixture(scope="module", params=[taylor, "dop853"])
def motion(request):
    return simulate(scene({"integrator": request.param, "final_inclination": 1e-10}))


def samples(motion, last):
    """Return the reference samples up to `last` and the motion there in the paper's units."""
    some = [s for s in REFERENCE["samples"] if s["tau"] <= last]
    t = np.array([s["tau"] for s in some]) * motion.disk.time_unit
    unit = motion.disk.mass * (motion.disk.radius / motion.disk.time_unit) ** 2
    ours = {
        "beta": motion.at(t)[:, 1],
        "Phi": motion.normal_load(t),
        "E": motion.energy(t) / unit,
    }
    return some, ours


@pytest.mark.parametrize(("last", "tolerance"), [(130, 1e-8), (150, 1e-6)])
def test_inclination_load_and_energy(motion, last, tolerance):
    some, ours = samples(motion, last)
    for name, values in ours.items():
        np.testing.assert_allclose(
            values, [s[name] for s in some], rtol=tolerance, err_msg=name
        )


def test_velocities_angles_and_path(motion):
    some, _ = samples(motion, 130)
    chi = motion.disk.time_unit
    radius = motion.disk.radius
    state = motion.at(np.array([s["tau"] for s in some]) * chi)
    scales = {
        "theta": 1,
        "x": radius,
        "y": radius,
        "w1": 1 / chi,
        "w2": 1 / chi,
        "w3": 1 / chi,
    }
    columns = {"theta": 0, "x": 3, "y": 4, "w1": 5, "w2": 6, "w3": 7, "u1": 8, "u2": 9}
    for name, column in columns.items():
        ours = state[:, column] / scales.get(name, radius / chi)
        np.testing.assert_allclose(
            ours, [s[name] for s in some], rtol=1e-9, atol=1e-8, err_msg=name
        )


def test_times_and_loads_of_the_transitions(motion):
    chi = motion.disk.time_unit
    ours = [s for s in motion.transitions if s.before != s.after]
    unit = motion.disk.mass * motion.disk.radius / chi**2
    jumps = motion.jumps
    known = REFERENCE["transitions"]
    assert len(known) == 8
    for got, want in zip(ours[: len(known)], known, strict=True):
        assert f"{got.before}->{got.after}" == want["kind"]
        assert got.t / chi == pytest.approx(want["tau"], abs=1e-9)
        i = np.argmin(np.abs(jumps.t - got.t))
        loads = jumps.before[i, 2] / unit, jumps.after[i, 2] / unit
        assert loads == pytest.approx((want["Phi_before"], want["Phi_after"]), abs=1e-7)


def test_at_a_jump_the_force_is_the_one_after_it(motion):
    """A time in seconds divided by the unit of time may round to just before its original."""
    jumps = motion.jumps
    assert len(jumps.t) > 100
    np.testing.assert_allclose(
        motion.force(jumps.t), jumps.after, rtol=1e-9, atol=1e-9 * motion.disk.weight
    )


def test_counts_of_slips(motion):
    tau = np.array([50, 100, 150, 200, 250])
    counts = np.searchsorted(slip_start_times(motion), tau * motion.disk.time_unit)
    assert counts.tolist() == [3, 6, 11, 19, 36]


def test_it_answers_what_every_motion_answers(motion):
    assert isinstance(motion, Motion)


def test_end(motion):
    chi = motion.disk.time_unit
    assert motion.rolling_outcome is Outcome.SETTLED
    assert motion.t[-1] / chi == pytest.approx(280.226, abs=0.03)
    assert motion.t_end / chi == pytest.approx(REFERENCE["t_end"], abs=0.03)
    assert motion.state[-1, 1] == pytest.approx(1e-10, rel=1e-9)


def test_the_shipped_scene_is_the_published_case():
    shipped = load_scene("published")
    ours = scene()
    assert shipped.disk == ours.disk
    assert shipped.release == ours.release
    k = [
        shipped.friction.arm_nutation,
        shipped.friction.arm_rolling,
        shipped.friction.arm_pivoting,
    ]
    np.testing.assert_allclose(
        np.array(k) / shipped.disk.radius, [1e-4, 8e-4, 8e-3], rtol=gamma(4)
    )
    state = simulate(shipped.replace("numerics.time_limit=9.0")).at(
        100 * shipped.disk.time_unit
    )
    assert state[0, 1] == pytest.approx(
        next(s["beta"] for s in REFERENCE["samples"] if s["tau"] == 100), rel=1e-8
    )


def test_first_load(motion):
    load = motion.normal_load(0.0)[0]
    assert load == pytest.approx(1.0659550771, abs=1e-10)
    friction = np.hypot(*motion.force(0.0)[0, :2]) / motion.force(0.0)[0, 2]
    assert friction == pytest.approx(0.45347, abs=5e-6)


def test_energy_and_dissipated_work_add_up(motion):
    assert energy_spread(motion) <= 1e-11


def test_the_normal_force_is_always_positive(motion):
    t = np.linspace(0, motion.t[-1], 200_000)
    load = motion.normal_load(t)
    assert load.min() == pytest.approx(0.7539, abs=5e-4)
    assert load.max() == pytest.approx(2.2070, abs=5e-4)
