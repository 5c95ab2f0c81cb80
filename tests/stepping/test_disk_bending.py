"""Claim: a disk on a moving table bends in its free modes, and the time steps add no energy.

Source: the docstring of dynamics/compliant/stepping/rim_modes.py. Oracle: an impact from its
Lagrangian, integrated by SciPy; the closed form of an oscillator under a rotating load; energies of
the states.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from table_models import GRIPS, TABLE, run, standing, steady

from dynamics import plan_motion
from dynamics.compliant.compliant_motion import compliant_model
from dynamics.compliant.law.linearised import inertias, mobility
from dynamics.compliant.law.tabulated import LAW_COLUMNS, EdgeSeriesLaw
from dynamics.compliant.model_inputs import contact_law, tabulated_contact_law
from dynamics.compliant.state_conversion import (
    columns,
    energy,
    preloaded_compliant_state,
)
from dynamics.compliant.stepping.state_layout import ENERGY_LOSSES, STATE
from dynamics.disk import Friction
from dynamics.observables import precession_rate
from dynamics.stepping_core.rim_modes import (
    MAX_MOVING_MODE_FREQUENCY,
    RimModes,
    moving_rim_modes,
)
from modal import surface_modes

HEAVY = 0, 100.0, 0.0, 1e9
"""A mode of a table that does not move."""
SMOOTH = Friction(mu_static=0.0, mu_dynamic=0.0)


def fallen(scene, bending, rate, stop, beta=0.05, speed=0.02):
    """Return centre velocity, tilting rate and modal energy after a vertical fall, by stepping."""
    model = replace(
        standing(scene, rate, SMOOTH, HEAVY, damps=False), disk_modes=bending
    )
    vars(model)["constants"] = model.constants._replace(weight=0.0)
    y = preloaded_compliant_state(
        model, np.append([0.0, beta], np.zeros(9)), np.zeros(3)
    )
    waves = model.supporting_modes(y)
    y[STATE.velocity + 2] = -speed
    *_, last = model.run(y, round(stop * rate), stop, modes=waves)
    return (
        last.state[-1, STATE.velocity + 2],
        -last.state[-1, STATE.angular_momentum] / inertias(scene.disk)[0],
        last.state[-1, STATE.disk_mode_energy],
    )


def fallen_by_its_lagrangian(scene, bending, stop, beta=0.05, speed=0.02):
    """Return the same quantities from the Lagrangian, with a contact fixed on the rim.

    The elastic energy is 2/5 K(b) (-G)^2.5. The gap is G = z - R sin b + H (1 - cos b) +
    sum r (c A - s B), with R and H of the centre of the fillet.
    """
    disk = scene.disk
    law = tabulated_contact_law(scene)
    squared = bending.squared
    A = bending.axial * np.cos(bending.phase)
    B = bending.radial * np.cos(bending.phase)
    fillet = contact_law(scene).rolling_fillet
    R = disk.radius - fillet
    H = disk.thickness / 2 - fillet
    J1 = inertias(disk)[0]
    modes = len(squared)

    def stiffness(b):
        return law.columns(np.array([b]))[0, LAW_COLUMNS.hertz_stiffness]

    def rates(t, y):
        z = y[0]
        b = y[1]
        r = y[2 : 2 + modes]
        c = np.cos(b)
        s = np.sin(b)
        G = z - R * s + H * (1 - c) + r @ (c * A - s * B)
        N = stiffness(b) * max(0.0, -G) ** 1.5
        slope = (stiffness(b + 1e-5) - stiffness(b - 1e-5)) / 2e-5  # dK/db
        stiffens = 2 / 5 * slope * max(0.0, -G) ** 2.5
        tilts = -R * c + H * s - r @ (s * A + c * B)  # dG/db
        return np.concatenate(
            [
                y[2 + modes :],
                [N / disk.mass, (N * tilts - stiffens) / J1],
                N * (c * A - s * B) - squared * r,
            ]
        )

    z = R * np.sin(beta) - 2 * H * np.sin(beta / 2) ** 2
    start = np.concatenate([[z, beta], np.zeros(modes), [-speed, 0.0], np.zeros(modes)])
    end = solve_ivp(
        rates,
        (0, stop),
        start,
        method="DOP853",
        rtol=1e-11,
        atol=1e-16,
        max_step=stop / 400,
    ).y[:, -1]
    r = end[2 : 2 + modes]
    v = end[4 + modes :]
    return end[2 + modes], end[3 + modes], (v @ v + squared * r @ r) / 2


def test_an_impact_leaves_in_the_modes_what_the_lagrangian_says(elastic):
    """A softer disk, so that its modes ring; the error is of second order in the step."""
    own = moving_rim_modes(elastic.elastic_edge, 0.0)
    stop = 6e-4
    bending = own._replace(squared=own.squared / 25)
    expected = np.array(fallen_by_its_lagrangian(elastic, bending, stop))
    assert expected[2] > 0.01 * elastic.disk.mass * 0.02**2 / 2  # the modes matter
    rates = 1e5, 2e5, 4e5
    errors = [
        np.abs(fallen(elastic, bending, rate, stop) / expected - 1) for rate in rates
    ]
    assert errors[-1].max() < 2e-3
    assert np.log2(errors[0].max() / errors[-1].max()) / 2 == pytest.approx(2, abs=0.1)


@pytest.mark.parametrize("x", [0.5, 1.4])
def test_a_load_that_runs_round_the_rim_drives_them_as_it_does_a_table(elastic, x):
    """The disk hardly rotates about its axis.

    The power is that of test_two_way_coupling.test_wave_drag with A^2 in place of 1/M.
    """
    n = 2
    zeta = 0.02
    mass = 300.0
    beta = 2e-3
    disk = elastic.disk
    start, rate = steady(contact_law(elastic), beta)
    w = n * rate / x
    bending = RimModes(
        order=np.full(2, float(n)),
        phase=np.array([0.0, np.pi / 2]),
        axial=np.full(2, mass**-0.5),
        radial=np.zeros(2),
        squared=np.full(2, w * w),
        decay=np.full(2, zeta * w),
    )
    model = replace(standing(elastic, 2e5, GRIPS, HEAVY), disk_modes=bending)
    _, t, state, _, _ = run(
        model, preloaded_compliant_state(model, start), 20, 20 * np.pi / rate
    )
    power = (state[-1, STATE.body_loss] - state[0, STATE.body_loss]) / (t[-1] - t[0])
    now = n * np.abs(precession_rate(columns(model, state))).mean() / w
    expected = (
        disk.weight**2
        / (mass * w)
        * 2
        * zeta
        * now**2
        / ((1 - now**2) ** 2 + (2 * zeta * now) ** 2)
    )
    assert power == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("loss_factor", [0.0, 0.01])
def test_energy_is_kept_and_never_gained(elastic, loss_factor):
    """The disk has its own modes and loses contact on a soft table."""
    scene = elastic.replace(TABLE, f"material.loss_factor={loss_factor}")
    model = replace(compliant_model(plan_motion(scene, surface_modes(scene))), rate=2e5)
    y = preloaded_compliant_state(model, steady(contact_law(scene), 4e-4)[0])
    first, _, state, losses, _ = run(model, y, 1, 0.05)
    now = energy(model, state)
    lost = state[:, ENERGY_LOSSES].sum(axis=1)
    assert losses
    assert state[:, STATE.disk_mode_energy].max() > 1e-3 * first
    assert np.abs(now + lost - first).max() < 1e-10 * first
    assert np.diff(np.append(first, now)).max() < 1e-12 * first
    assert (state[-1, STATE.body_loss] > 0) == (loss_factor > 0)


def test_what_moves_does_not_yield_in_series(elastic):
    """At the contact resonance, moving modes and series springs add up to the full flexibility."""
    beta = np.array([0.01])
    edge = elastic.elastic_edge
    bending = moving_rim_modes(edge, 0.0)
    assert (np.sqrt(bending.squared) < 2 * np.pi * MAX_MOVING_MODE_FREQUENCY).all()
    assert len(bending.order) == 3  # the toy has a pair of order 2 and one of order 0
    whole, apart = (
        tabulated_contact_law(elastic, EdgeSeriesLaw, moves).flexibility_spline(
            np.log(np.sin(beta))
        )[0]
        for moves in (0.0, MAX_MOVING_MODE_FREQUENCY)
    )
    lifts = bending.axial[:2] * np.cos(beta) - bending.radial[:2] * np.sin(
        beta
    )  # the sine partner is at rest
    kn = tabulated_contact_law(elastic).springs(beta, elastic.disk.weight)[0].kn[0]
    square = mobility(elastic.disk, beta, contact_law(elastic).rolling_fillet)[
        0, 2, 2
    ] / (1 / kn + whole[2, 2])  # of the carrier
    assert whole[2, 2] - apart[2, 2] == pytest.approx(
        (lifts**2 / (bending.squared[:2] - square)).sum(), rel=1e-6
    )
    assert whole[:2, :2] == pytest.approx(apart[:2, :2], rel=1e-12)
    assert len(moving_rim_modes(None, 0.0).order) == 0


def test_the_disk_turns_about_its_axis_as_it_rolls(elastic):
    """On a fixed table, the spin is the time integral of the steady spin rate."""
    model = replace(standing(elastic, 2e5, GRIPS, HEAVY))
    start, _ = steady(contact_law(elastic), 0.1)
    _, t, state, _, _ = run(model, preloaded_compliant_state(model, start), 100, 0.1)
    spin = np.unwrap(columns(model, state)[:, 2])
    expected = start[6] - start[7] / np.tan(0.1)
    assert np.polyfit(t, spin, 1)[0] == pytest.approx(expected, rel=2e-3)
