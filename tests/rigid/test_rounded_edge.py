"""Claim: a disk rolls on the fillet of its edge, in a concave table, against the spin friction of
its contact, and all energy is accounted for.

Source: physics of a torus edge; Hertz; Kalker (1967).
Oracle: Newton and Euler (test_equations.py); the energy of the state; closed forms of steady and of
straight motion; another integrator; the compliant motion.
"""

from importlib.util import find_spec
from math import pi

import numpy as np
import pytest
from contact_scenes import granite, slope_of_contact, steady_precession_rate
from scenes import roll

from dynamics.compliant.law.spin_friction import pivoting_polynomials
from dynamics.equations import DiskConstants
from dynamics.kinematics import energy
from dynamics.regime import (
    DISSIPATED,
    FLOAT_FORMULAS,
    V1,
    V2,
    W1,
    W3,
    Branch,
    R,
    Regime,
    X,
    Y,
)
from dynamics.steady_motion import max_steady_inclination, steady_omega
from sonify import load_scene

LAW = granite()
ROUNDED = DiskConstants(
    h=LAW.disk.aspect,
    K=1.0,
    mu_static=0.5,
    mu_dynamic=0.3,
    k1=1e-4,
    k2=8e-4,
    k3=0.0,
    fillet=LAW.rolling_fillet / LAW.disk.radius,
    bowl=0.02,
    bowl_x=0.3,
    bowl_y=-0.1,
    pivoting=pivoting_polynomials(LAW),
)


@pytest.mark.parametrize("sliding", [False, True])
def test_the_power_of_all_moments_is_the_loss_of_energy(sliding):
    """By central differences of the energy along the flow, at random states."""
    rng = np.random.default_rng(3)
    for _ in range(5):
        y = np.concatenate([rng.uniform(0.1, 1.0, 1), rng.normal(size=10)])
        if not sliding:
            y[V1 : V2 + 1] = 0.0
        turns = y[R] * y[R], *(y[R] * y[W1 : W3 + 1])
        regime = Regime(
            sliding, (False,) * 3, (np.sign(y[W1]), _sign_of_rolling(*turns), 1.0)
        )
        branch = Branch.of(regime, ROUNDED, None)
        contact = FLOAT_FORMULAS.contact(y, branch, regime.senses, ROUNDED)
        rates = np.array(FLOAT_FORMULAS.rates(y, contact, branch, ROUNDED))
        step = 1e-5
        ends = [_energy(y + side * step * rates) for side in (1, -1)]
        lost = rates[DISSIPATED]
        assert lost > 0
        assert (ends[0] - ends[1]) / (2 * step) == pytest.approx(
            -lost, rel=1e-6, abs=1e-8
        )


def _sign_of_rolling(beta, w1, w2, w3):
    return np.sign(w2 * np.sin(beta) - w3 * np.cos(beta))


def _energy(y):
    r = y[R]
    return energy(r * r, r * y[W1 : W3 + 1], r * y[V1 : V2 + 1], ROUNDED, y[X : Y + 1])


@pytest.mark.parametrize("beta", [1e-4, 0.01, 0.3, 1.0])
def test_steady_motion_on_a_torus(beta):
    """The moment of the weight turns the angular momentum; nothing else changes."""
    free = ROUNDED._replace(bowl=0.0, pivoting=(), k1=0.0, k2=0.0)
    omega = steady_omega(beta, free)
    unit = LAW.disk.time_unit
    assert omega[2] / np.sin(beta) / unit == pytest.approx(
        steady_precession_rate(LAW, beta), rel=1e-12
    )
    assert omega[1] / omega[2] == pytest.approx(slope_of_contact(LAW, beta), rel=1e-12)
    r = beta**0.5
    y = [r, *(w / r for w in omega), *[0.0] * 7]
    regime = Regime(False, (False,) * 3, (1.0,) * 3)
    contact = FLOAT_FORMULAS.contact(
        y, Branch.of(regime, free, None), regime.senses, free
    )
    assert contact.domega1 == pytest.approx(0.0, abs=1e-11)
    assert pytest.approx(0.0, abs=1e-11) == contact.F2
    assert contact.Phi == pytest.approx(5 / 4)
    assert beta < max_steady_inclination(free.h, 1.0, free.fillet) < pi / 2


def test_an_upright_disk_rolls_along_a_bowl_as_a_pendulum():
    """A rolling disk has 3/2 of its mass, so its acceleration is 2/3 g times the slope."""
    at = ROUNDED._replace(
        h=0.0, fillet=0.0, pivoting=(), k1=0.0, k2=0.0, mu_static=np.inf
    )
    y = [(pi / 2) ** 0.5, *[0.0] * 10]
    regime = Regime(False, (False,) * 3, (1.0,) * 3)
    contact = FLOAT_FORMULAS.contact(y, Branch.of(regime, at, None), regime.senses, at)
    assert contact.domega2 == pytest.approx(-2 / 3 * 5 / 4 * 0.02 * 0.3, rel=1e-12)


@pytest.mark.slow
@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
def test_two_integrators_and_the_compliant_contact_agree():
    """Both integrators to 1e-8; the compliant disk with an error of its creep, which is inversely
    proportional to the size of the ellipse, the cube root of the stiffness."""
    scene = load_scene("published").replace(
        "contact.fillet=1.6e-3",
        "friction.arm_pivoting=contact",
        "friction.mu_static=3",
        "surface.sag=0.01",
        "surface.diameter=0.3",
        "surface.place=[0.02, 0.01]",
        "numerics.time_limit=2",
    )
    taylor, other = (
        roll(scene.replace(f"numerics.integrator={i}")) for i in ("taylor", "dop853")
    )
    t = np.linspace(0, 2, 50)
    assert other.at(t) == pytest.approx(taylor.at(t), abs=1e-8)
    for motion in (taylor, other):
        kept = motion.energy(t) + motion.at(t)[:, -1]
        assert kept == pytest.approx(kept[0], rel=1e-11)
    away = []
    for stiffer in (
        ["numerics.contact_rate=4e5"],
        ["contact.young=6e12", "material.young=1.95e13", "numerics.contact_rate=2e6"],
    ):
        elastic = scene.replace(
            "contact.law=elastic", "contact.body=rigid", "numerics.contact=full"
        )
        soft = roll(elastic.replace(*stiffer))
        kept = soft.energy(soft.t) + soft.state[:, -1]
        assert kept == pytest.approx(kept[0], rel=1e-10)
        away.append(np.abs(soft.at(t[:20]) - taylor.at(t[:20])).max(axis=0))
    assert away[1][1] < 5e-3  # rad
    assert away[1][3:5].max() < 1e-3  # m
    assert away[1][1] / away[0][1] == pytest.approx(100 ** (-1 / 3), rel=0.1)


@pytest.mark.slow
def test_the_rounded_edge_ends_the_motion_earlier():
    """The elastic published disk ends 0.6 s earlier on a fillet of 1.6 mm than on a sharp edge."""
    scene = load_scene("published").replace("contact.law=elastic", "contact.body=rigid")
    ends = [
        roll(scene.replace(f"contact.fillet={fillet}", "numerics.contact=full")).t_end
        for fillet in (1e-4, 1.6e-3)
    ]
    assert ends[0] == pytest.approx(19.35, abs=0.05)
    assert ends[1] - ends[0] == pytest.approx(-0.6, abs=0.1)
