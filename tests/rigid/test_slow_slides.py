"""Claim: implicit steps follow a slide too slow for explicit steps in few pieces and agree with
explicit steps to their digits.

Source: collocation at Gauss-Chebyshev points (Hairer & Wanner 1996, IV.5), in polar slip. Oracle:
the same slide in explicit steps of another method, as short as the stiff direction requires; the
number of pieces of a motion.
"""

from importlib.util import find_spec

import numpy as np
import pytest
from law_scenes import named_scene
from scenes import roll, scene

from dynamics import Outcome
from dynamics.integrators.gauss_collocation import (
    CHEBYSHEV_TO_POWERS,
    COLLOCATION_NODES,
    INTEGRAL_SERIES,
    INTEGRAL_WEIGHTS,
    ORDER,
)
from dynamics.observables import slip_start_times
from dynamics.rolling import RollingDisk
from sonify import load_scene


def equal(name, span, ratio=1.0):
    scene = named_scene(name).replace(
        f"numerics.time_limit={span}", "air.film=none", "contact.law=rigid"
    )
    return scene.replace(f"friction.mu_static={ratio * scene.friction.mu_dynamic}")


@pytest.mark.parametrize(
    ("name", "span"), [("published", 2.0), ("hoop", 5.0), ("moffatt", 2.0)]
)
def test_implicit_steps_follow_what_explicit_steps_follow(monkeypatch, name, span):
    """Each step may err by 1e-12; the total error stays below 1e-12 times the number of steps."""
    ours = roll(equal(name, span))
    monkeypatch.setattr(RollingDisk, "_is_stiff", lambda *_: False)
    explicit = roll(equal(name, span))
    assert sum(e.guard == "slip" for e in ours.transitions) > 0
    assert [e[1:] for e in ours.transitions] == [e[1:] for e in explicit.transitions]
    t = np.linspace(0, span, 200)
    bar = 1e-12 * len(ours.t) * np.maximum(1, np.abs(explicit.at(t)))
    assert (np.abs(ours.at(t) - explicit.at(t)) <= bar).all()
    assert len(ours.t) < len(explicit.t)


@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
def test_a_slide_without_a_jump_takes_no_more_pieces_than_one_with():
    """For equal coefficients of friction the number of pieces is comparable to that for unequal
    ones; with explicit steps it is unbounded."""
    unequal = load_scene("published").replace("numerics.time_limit=12", "air.film=none")
    assert len(roll(equal("published", 12.0)).t) < 2 * len(roll(unequal).t)


def test_dop853_takes_no_more_pieces_between_changes_without_a_jump_than_with_one():
    """For equal coefficients there are more changes of regime, and DOP853 needs pieces for each."""
    dop853 = "numerics.integrator=dop853"
    unequal = load_scene("published").replace(
        "numerics.time_limit=12", "air.film=none", dop853
    )
    smooth, abrupt = (
        len(motion.t) / len(motion.transitions)
        for motion in (
            roll(equal("published", 12.0).replace(dop853)),
            roll(unequal),
        )
    )
    assert smooth < 2 * abrupt


@pytest.mark.parametrize("ratio", [1.0, 1.001])
def test_the_force_at_a_start_is_against_the_slip_that_begins(ratio):
    """A parabola extrapolates the slip direction from later instants to the start; its error is of
    third order."""
    motion = roll(equal("published", 4.0, ratio))
    starts = slip_start_times(motion)
    assert len(starts) > 10
    later = 1e-3 * np.array([1.0, 2.0, 4.0])
    for start in starts:
        piece = motion.t[np.searchsorted(motion.t, start, side="right")] - start
        slip = motion.at(start + later * piece)[:, 8:10]
        near = np.unwrap(np.arctan2(slip[:, 1], slip[:, 0]))
        begins = (8 * near[0] - 6 * near[1] + near[2]) / 3
        friction = -motion.force(start)[0, :2]
        off = np.arctan2(friction[1], friction[0]) - begins
        assert abs(np.angle(np.exp(1j * off))) < later[-1] ** 3


def test_the_weights_integrate_polynomials_exactly():
    """The weights are exact for degrees below ORDER, from 0 to the nodes; the powers represent the
    same integral."""
    for degree in range(ORDER):
        values = COLLOCATION_NODES**degree
        wanted = COLLOCATION_NODES ** (degree + 1) / (degree + 1)
        np.testing.assert_allclose(INTEGRAL_WEIGHTS @ values, wanted, atol=1e-14)
        powers = CHEBYSHEV_TO_POWERS @ (INTEGRAL_SERIES @ values)
        np.testing.assert_allclose(
            np.polynomial.polynomial.polyval(COLLOCATION_NODES, powers),
            wanted,
            atol=1e-13,
        )


def test_a_first_step_beyond_the_end_of_the_fall_is_shortened(monkeypatch):
    """A heavy ring tips over: the first step from rest would pass inclination zero, where the
    accelerations are not finite. Oracle: a short trapezoidal first step and explicit steps."""
    ring = scene(
        {"accuracy": "draft", "time_limit": 1.0},
        {
            "radius": 0.011002283118564594,
            "thickness": 0.001475585734253893,
            "mass": 0.3886376506600506,
            "shape": "shell",
        },
        {
            "inclination_deg": 21.65923717911226,
            "omega": (-1.0707696504248922, 1.9075748323718593, 0.043833737539334686),
        },
        {"power_coefficient": 1.5021425664972884e-11, "power_exponent": 4.0},
        mu_static=0.6456192586841448,
        mu_dynamic=0.639226988796183,
        k1=1.223456608785168e-4,
        k2=3.887857277872237e-3,
        k3=1.3525819592523778e-4,
    )
    ours = roll(ring)
    assert ours.rolling_outcome is Outcome.FELL
    monkeypatch.setattr("dynamics.switching.MAX_GRAZING_ACCELERATION", 0.0)
    monkeypatch.setattr(RollingDisk, "_is_stiff", lambda *_: False)
    explicit = roll(ring)
    assert explicit.rolling_outcome is Outcome.FELL
    assert ours.t[-1] == pytest.approx(explicit.t[-1], rel=1e-6)
