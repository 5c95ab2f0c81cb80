"""Claim: the compliant motion conserves or dissipates energy exactly as its loss mechanisms
require, and agrees with the available closed forms.

Source: the docstrings of normal.py and tangential.py; Hertz's impact; Hunt and Crossley (1975).
Oracle: energies of the states; closed forms; the rigid motion; the linear filter; symmetry.
"""

from functools import cache

import numpy as np
import pytest
import table_models
from arithmetic import gamma, walk
from contact_scenes import granite, steady_block, steady_speed
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq
from table_models import GRIPS, energy_error

from dynamics import simulate
from dynamics.compliant.law.height_profile import SMOOTH_PROFILE
from dynamics.compliant.law.linear_response import (
    linear_contact_force_blocks,
)
from dynamics.compliant.law.linearised import mobility
from dynamics.compliant.law.roughness import edge_profile, table_profile
from dynamics.compliant.law.sections import Roughness
from dynamics.compliant.law.tabulated import LAW_COLUMNS, TabulatedLaw
from dynamics.compliant.state_conversion import (
    columns,
    energy,
    inclination,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.disk import Friction
from dynamics.stepping_core.end_reasons import EndReason

LAW = granite()
SLIPPERY, FRICTIONLESS = (
    Friction(mu_static=0.3, mu_dynamic=0.2, arm_rolling=3e-5),
    Friction(mu_static=0, mu_dynamic=0),
)
BOTH_SMOOTH = SMOOTH_PROFILE, SMOOTH_PROFILE
ENERGY = 60
"""Operations on terms of the size of the energy, in one step and in the sum of the energy."""


@pytest.fixture(scope="module")
def motion(scene):
    """Return the motion of a rigid disk on the same rounded edge."""
    return simulate(scene.replace(f"contact.fillet={LAW.rolling_fillet}"))


def table(stiffer=1.0, creeps=True, damping=None):
    """Return the law with all springs stiffer by a factor, with or without creep."""
    out = TabulatedLaw(law=LAW, damping=damping)
    scale = np.ones(len(LAW_COLUMNS))
    scale[
        [
            LAW_COLUMNS.hertz_stiffness,
            LAW_COLUMNS.stiffness_1,
            LAW_COLUMNS.stiffness_2,
            LAW_COLUMNS.loss_coefficient,
        ]
    ] = (
        stiffer**1.5,
        stiffer,
        stiffer,
        stiffer**0.5,
    )
    scale[[LAW_COLUMNS.relaxation_length_1, LAW_COLUMNS.relaxation_length_2]] = (
        1.0 if creeps else 1e9
    )
    out.__dict__["spline"] = CubicSpline(out.grid, out.spline(out.grid) * scale)
    return out


def steady(beta, nutation=0.0):
    """Return the columns of a steady motion with a fixed centre and a nutation rate [rad/s]."""
    columns, _ = table_models.steady(LAW, beta)
    columns[5] = nutation
    return columns


def run(model, y, every, stop, **more):
    """Return times, states, forces, losses, slips and the reason for stopping of a run."""
    pieces = list(model.run(y.copy(), every, stop, **more))
    t, state, force = (
        np.concatenate([getattr(p, name) for p in pieces])
        for name in ("t", "state", "force")
    )
    losses = [loss for p in pieces for loss in p.losses]
    slips = [slip for p in pieces for slip in p.slips.tolist()]
    return t, state, force, losses, slips, pieces[-1].end_reason


@cache
def rough(rms):
    """Return the profiles of table and edge."""
    roughness = Roughness(rms=rms)
    return table_profile(roughness), edge_profile(roughness, LAW.disk.radius)


def rise(model, y):
    """Return the vertical velocity [m/s] of the lowest point of the disk."""
    beta = inclination(y[None])[0]
    core = LAW.disk.radius - LAW.rolling_fillet
    lever = core * np.cos(beta) - (
        LAW.disk.thickness / 2 - LAW.rolling_fillet
    ) * np.sin(beta)
    return y[5] + lever * columns(model, y[None])[0, 5]


@pytest.mark.parametrize("loss", [0.0, 8.0])
def test_impact(loss):
    """A vertical impact at 0.02 m/s without gravity and friction follows Hertz and Hunt-Crossley.

    At constant inclination, v dv/(1 + c v) = -(K/m) d^1.5 dd gives the greatest approach and the
    rebound; here the inclination changes by 3e-4 rad. Hertz's impact lasts 2.9432 d/v.
    """
    beta = 0.3
    v = 0.02
    rate = 1.6e6
    model = CompliantModel(
        tabulated_law=table(damping=loss * LAW.disk.weight),
        friction=FRICTIONLESS,
        rate=rate,
    )
    vars(model)["constants"] = model.constants._replace(weight=0.0)
    start = np.zeros(11)
    start[1] = beta
    y = preloaded_compliant_state(model, start, (0.0, 0.0, 1e-12))
    y[5] = -v
    t, state, _, _, _, _ = run(model, y, 1, 4e-4)
    last = np.flatnonzero(state[:, STATE.normal_force])[-1]
    mass = 1 / mobility(LAW.disk, beta, LAW.rolling_fillet)[0, 2, 2]
    K0 = LAW.stiffness(np.array([beta]))[0]
    spent = (
        (lambda v: v / loss - np.log1p(loss * v) / loss**2)
        if loss
        else (lambda v: v * v / 2)
    )
    deepest = (2.5 * mass / K0 * spent(v)) ** 0.4
    assert -state[:, STATE.gap].min() == pytest.approx(deepest, rel=1e-4)
    rebound = v if not loss else brentq(lambda u: spent(v) - spent(-u), 0.5 * v, v)
    assert rise(model, state[last]) == pytest.approx(rebound, rel=5e-4)
    held = t[state[:, STATE.normal_force] > 0]
    if not loss:
        assert held[-1] - held[0] == pytest.approx(2.9432 * deepest / v, abs=2 / rate)
    kept = energy(model, state) + state[:, STATE.contact_loss : STATE.film_loss].sum(
        axis=1
    )
    assert np.ptp(kept) < walk(ENERGY * len(kept)) * kept[0]


@pytest.mark.parametrize(
    "profiles", [BOTH_SMOOTH, rough(1e-7)], ids=["smooth", "rough"]
)
def test_energy_never_rises_and_every_loss_has_its_cause(profiles):
    """Slips, creep, flights and moments, at 0.15 rad of phase per step."""
    friction = Friction(
        mu_static=0.06,
        mu_dynamic=0.03,
        arm_nutation=1e-5,
        arm_rolling=3e-5,
        arm_pivoting=3e-4,
    )
    more = {"powers": ((1e-4, 1.0), (1e-9, 4.0)), "rate": 1e5}
    model = CompliantModel(
        tabulated_law=table(), friction=friction, profiles=profiles, **more
    )
    y = preloaded_compliant_state(model, steady(0.2, nutation=2.0))
    before = energy(model, y[None])[0]
    _, state, _, _, _, _ = run(model, y, 1, 0.1)
    now = energy(model, state)
    lost = state[:, STATE.contact_loss : STATE.table_loss]
    assert energy_error(model, state, before) < walk(ENERGY * len(now))
    assert np.diff(np.append(before, now)).max() < 1e-15 * before * 4
    assert (np.diff(lost, axis=0) > -1e-16 * before).all()
    assert (lost[-1] > 1e-9 * before).all()
    assert state[:, STATE.is_sliding].any()


def test_steady_precession_is_kept():
    """Without losses the energy is constant for 2 s; nutation has an error of second order."""
    model = CompliantModel(
        tabulated_law=table(creeps=False, damping=0.0), friction=GRIPS, rate=1e5
    )
    y = preloaded_compliant_state(model, steady(0.1))
    _, state, _, _, _, _ = run(model, y, 50, 2.0)
    assert np.ptp(energy(model, state)) < 1e-11
    assert np.ptp(inclination(state)) < 1e-5
    ends = []
    for rate in (2.5e4, 5e4, 1e5, 8e5):
        model = CompliantModel(tabulated_law=table(), friction=GRIPS, rate=rate)
        _, state, _, _, _, _ = run(
            model,
            preloaded_compliant_state(model, steady(0.1, nutation=0.3)),
            int(rate // 1000),
            0.1,
        )
        ends.append(inclination(state))
    errors = [np.abs(end - ends[-1]).max() for end in ends[:-1]]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.2)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(2, abs=0.2)


@pytest.mark.slow
def test_rigid_limit(scene, motion):
    """Before the first slip the difference from the rigid motion falls as 1/k over two decades."""
    start = motion.at([0.0])[0]
    force = motion.force([0.0])[0]
    difference = []
    for stiffer in (1.0, 10.0, 100.0):
        model = CompliantModel(
            tabulated_law=table(stiffer), friction=scene.friction, rate=8e5
        )
        t, state, _, _, slips, _ = run(
            model, preloaded_compliant_state(model, start, force), 400, 0.25
        )
        assert not slips
        difference.append(np.abs(inclination(state) - motion.at(t)[:, 1]).max())
    assert np.diff(np.log10(difference)) == pytest.approx([-1, -1], abs=0.05)


def test_first_slip_is_that_of_the_rigid_disk(scene, motion):
    """Without creep, granite slips and grips again within 0.1 ms of the rigid contact."""
    model = CompliantModel(tabulated_law=table(creeps=False), friction=scene.friction)
    y = preloaded_compliant_state(model, motion.at([0.0])[0], motion.force([0.0])[0])
    _, _, _, _, slips, _ = run(model, y, 400, 0.5)
    slides = [
        e.t
        for e in motion.transitions
        if e.after.startswith("slide") != e.before.startswith("slide")
    ]
    assert slips == [pytest.approx(slides[:2], abs=1e-4)]


@pytest.mark.parametrize("beta", [0.4, 0.02])
def test_filter_and_full_model_agree_wave_by_wave(beta):
    """In steady precession on the same heights of 10 nm rms, both forces agree to 10 %.

    A row of the full model is a mean over 10 us, as is the mean of two samples of the filter.
    """
    profiles = rough(1e-8)
    model = CompliantModel(tabulated_law=table(), friction=GRIPS, profiles=profiles)
    _, _, force, _, _, _ = run(
        model, preloaded_compliant_state(model, steady(beta)), 4, 0.0496
    )
    t = np.arange(0, 0.0497, 16e-5)
    path = steady_speed(LAW, beta) * t
    rim = (
        path * LAW.disk.radius / LAW.place(beta).radius
    )  # measured on the radius of the disk
    motion = steady_block(t, beta, LAW.disk.weight, path, rim)
    filtered = next(
        linear_contact_force_blocks(model.tabulated_law, [motion], 1e5, profiles)
    )[:, 1]
    whole = force[1 : len(filtered), 2] - LAW.disk.weight
    assert np.std(
        whole - (filtered[1 : len(force)] + filtered[: len(force) - 1]) / 2
    ) < 0.1 * np.std(whole)


@pytest.mark.slow
def test_vanishing_roughness_is_smooth():
    """The force due to roughness is proportional to the roughness while nothing slips."""
    differences = []
    for rms in (1e-9, 1e-11):
        ends = []
        for profiles in (BOTH_SMOOTH, rough(rms)):
            model = CompliantModel(
                tabulated_law=table(), friction=GRIPS, profiles=profiles, rate=2e5
            )
            ends.append(
                run(
                    model,
                    preloaded_compliant_state(model, steady(0.1, nutation=0.2)),
                    20,
                    0.1,
                )[2]
            )
        differences.append(np.std(ends[1] - ends[0]))
    assert differences[0] / differences[1] == pytest.approx(100, rel=0.02)


def test_mirror_and_rotation():
    """Shifted, rotated and mirrored disks move alike, with slips, flights and roughness."""
    start = steady(0.2, nutation=2.0)
    turned = start.copy()
    mirrored = start.copy()
    turned[[0, 3, 4]] = 1.0, 0.3, -0.2
    mirrored[[6, 7]] *= -1
    moved = []
    uneven = rough(1e-7)
    for state, profiles in (
        (start, uneven),
        (turned, uneven),
        (mirrored, BOTH_SMOOTH),
        (start, BOTH_SMOOTH),
    ):
        model = CompliantModel(
            tabulated_law=table(), friction=SLIPPERY, profiles=profiles, rate=2e5
        )
        _, y, force, losses, slips, _ = run(
            model, preloaded_compliant_state(model, state), 20, 0.02
        )
        moved.append((columns(model, y), force, len(losses), len(slips)))
    assert moved[1][0][:, [1, 5, 6, 7]] == pytest.approx(
        moved[0][0][:, [1, 5, 6, 7]], rel=1e-6, abs=1e-7
    )
    assert moved[1][1] == pytest.approx(moved[0][1], rel=1e-4, abs=1e-4)
    assert moved[1][2:] == moved[0][2:]
    sign = np.array([1.0, 1, -1, -1])
    assert moved[2][0][:, [1, 5, 6, 7]] * sign == pytest.approx(
        moved[3][0][:, [1, 5, 6, 7]], rel=1e-9, abs=1e-9
    )
    assert moved[2][1] * [-1, 1, 1] == pytest.approx(moved[3][1], rel=1e-7, abs=1e-7)


def test_columns_are_those_of_a_motion(motion):
    """`columns` inverts `preloaded_compliant_state`; the contact yields only by the static creep."""
    model = CompliantModel(tabulated_law=table(), friction=GRIPS)
    t = np.array([1.5])
    state = motion.at(t)[0]
    y = preloaded_compliant_state(model, state, motion.force(t)[0])
    back = columns(model, y[None])[0]
    assert back[1:8] == pytest.approx(state[1:8], rel=1e-12)
    assert np.exp(1j * back[0]) == pytest.approx(np.exp(1j * state[0]))
    assert np.abs(back[8:10] - state[8:10]).max() < 1e-3
    _, _, force, _, _, _ = run(model, y, 1, 1e-4)
    assert force[0] == pytest.approx(motion.force(t)[0], rel=5e-3, abs=5e-3)


def test_flights_are_noted():
    """After a lossless bounce at v the flight is a parabola of height v/4 times its duration."""
    model = CompliantModel(
        tabulated_law=table(damping=0.0), friction=FRICTIONLESS, rate=4e5
    )
    start = np.zeros(11)
    start[1] = 0.3
    y = preloaded_compliant_state(model, start, (0.0, 0.0, 1e-9))
    y[5] = -0.01
    _, state, _, losses, _, _ = run(model, y, 4, 0.02)
    first = losses[0]
    after = int(first.t * model.rate / 4)
    assert rise(model, state[after]) == pytest.approx(0.01, rel=0.05)
    assert first.duration == pytest.approx(4 * first.height / 0.01, rel=0.1)


def test_block_size_changes_no_byte(monkeypatch):
    from dynamics.compliant.stepping import model as full

    ends = []
    for steps in (full.STEPS_PER_CALL, 140):
        monkeypatch.setattr(full, "STEPS_PER_CALL", steps)
        model = CompliantModel(
            tabulated_law=table(), friction=SLIPPERY, profiles=rough(1e-7), rate=2e5
        )
        t, state, force, losses, slips, _ = run(
            model, preloaded_compliant_state(model, steady(0.2, nutation=2.0)), 20, 0.03
        )
        ends.append((t.tobytes(), state.tobytes(), force.tobytes(), losses, slips))
    assert ends[0] == ends[1]


def test_energy_where_roughness_throws_the_disk():
    """At 2e-4 rad the contact oscillates on a very rough surface; the energy balances."""
    model = CompliantModel(
        tabulated_law=table(), friction=SLIPPERY, profiles=rough(1e-7)
    )
    y = preloaded_compliant_state(model, steady(2e-4))
    before = energy(model, y[None])[0]
    _, state, _, losses, _, _ = run(model, y, 1, 0.02)
    assert losses
    gained = np.diff(np.append(before, energy(model, state)))
    assert gained.max() < gamma(ENERGY) * before
    assert energy_error(model, state, before) < 1e-9


def test_how_it_ends():
    """Runs end flat, at the time limit or upright; too low a rate is an error."""
    heavy = Friction(mu_static=0.5, mu_dynamic=0.3, arm_rolling=1e-3)
    model = CompliantModel(tabulated_law=table(), friction=heavy, rate=2e5)
    _, state, _, _, _, why = run(
        model,
        preloaded_compliant_state(model, steady(0.01)),
        20,
        5.0,
        final_inclination=1e-3,
    )
    assert why == EndReason.LIES_FLAT
    assert inclination(state)[-1] <= 1e-3 < inclination(state)[-2]
    assert (
        run(model, preloaded_compliant_state(model, steady(0.2)), 20, 0.01)[5]
        == EndReason.CONTINUES
    )
    falls = CompliantModel(tabulated_law=table(), friction=GRIPS, rate=2e5)
    upright = np.zeros(11)
    upright[1] = 1.5
    upright[5] = -20.0
    assert (
        run(falls, preloaded_compliant_state(falls, upright), 20, 1.0)[5]
        == EndReason.STANDS_UPRIGHT
    )
    slow = CompliantModel(tabulated_law=table(), friction=GRIPS, rate=1e4)
    with pytest.raises(ValueError, match="at least"):
        run(slow, preloaded_compliant_state(slow, steady(0.1)), 1, 0.1)
