"""Claim: every guard is positive while its regime is valid and crosses zero where the regime ends;
the simulator misses no event.

Source: (3.2), (3.3) of the paper: friction and moments never add energy. Oracle: the guards,
evaluated between the points that the integrator uses; extrema of polynomials in closed form; the
energy, which cannot rise.
"""

from dataclasses import replace

import numpy as np
import pytest
from arithmetic import gamma, walk
from numpy.polynomial import Polynomial
from paths import REFERENCES
from scenes import energy_spread, roll, scene

from dynamics import Outcome
from dynamics.disk import Release
from dynamics.monotonicity import largest_decrease
from dynamics.regime import ARRAY_FORMULAS, STOP_SLIP_SPEED, V1, V2, Branch
from sonify import load_scene
from sonify.claims.checks import dissipation_never_falls

INSIDE = np.array([1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 1 - 1e-3])
"""Relative positions within a piece at which the guards are evaluated."""
ROUNDING = gamma(100)
"""Rounding error of a guard after about one hundred operations on terms of order 1."""


def lowest_guards(motion):
    """Return the lowest value of every guard within the pieces of a motion.

    The value for grip is the cosine between two directions of the slip, except in the last step to
    rest.
    """
    lowest = {}
    after = INSIDE[:, None, None] * np.diff(motion.path.x)[:, None]
    y = np.polynomial.polynomial.polyval(
        after, motion.path.c[::-1], tensor=False
    )  # (inside, pieces, 11)
    for kind, regime in enumerate(motion.regimes):
        of_kind = y[:, motion.regime_of_piece == kind].T
        branch = Branch.of(regime, motion.constants, motion.loads)
        contact = ARRAY_FORMULAS.contact(
            of_kind, branch, regime.senses, motion.constants
        )
        guards = ARRAY_FORMULAS.guards(
            of_kind, contact, branch, regime.senses, motion.constants, 0.0
        )
        if "grip" in guards:
            speed = guards.pop("grip") + STOP_SLIP_SPEED
            slip = (of_kind[V1 : V2 + 1] / speed)[
                :, speed.max(axis=1) > STOP_SLIP_SPEED
            ]
            guards["slip keeps its side"] = (slip[:, :, :1] * slip[:, :, 1:]).sum(
                axis=0
            )
        for name, value in guards.items():
            lowest[name] = np.minimum(
                lowest.get(name, np.inf), np.min(value, initial=np.inf)
            )
    return lowest


def test_a_slide_that_comes_back_to_rest_within_its_first_step_is_ended():
    """The state of energy_gain.toml at t = 93.294624074 s, in rolling, starts a slide of 45 us."""
    wanted = load_scene(REFERENCES / "energy_gain.toml").replace("air.film=none")
    release = Release(
        inclination_deg=0.04241320147942413,
        omega=(1.624116734034412, 0.5311056435179342, 0.4499165719985166),
    )
    numerics = replace(wanted.numerics, time_limit=0.02)
    motion = roll(replace(wanted, release=release, numerics=numerics))
    assert [e.guard for e in motion.transitions][:3] == [
        "slip",
        "grip",
        "nutation reverses",
    ]
    assert motion.transitions[1].t - motion.transitions[0].t == pytest.approx(
        45.2e-6, rel=1e-2
    )
    assert dissipation_never_falls(motion).passed
    assert energy_spread(motion) < 1e-11
    assert min(lowest_guards(motion).values()) > -ROUNDING


def test_the_last_step_of_a_slide_keeps_the_energy():
    """The error is of second order in the slip speed, 1e-18; a step rounds 60 energy terms."""
    motion = roll(scene({"time_limit": 2.0}, release={"inclination_deg": 0.5}))
    assert sum(e.guard == "grip" for e in motion.transitions) > 40
    assert energy_spread(motion) < walk(60 * len(motion.t))


def test_a_slip_that_no_friction_stops_passes_by_rest_and_slides_on():
    """At tau = 3.6557 the slip falls to 1e-9 r, but rolling needs 2.8 times the static friction."""
    wanted = load_scene("published").replace(
        "friction.mu_static=0.193",
        "friction.mu_dynamic=0.193",
        "friction.arm_nutation=3.79195739e-4",
        "friction.arm_rolling=4.90758271e-6",
        "friction.arm_pivoting=2.28038538e-5",
        "release.inclination_deg=0.1003",
        "release.omega=[1.160037, -2.866961, -13.439723]",
        "numerics.time_limit=0.5",
    )
    motion = roll(wanted)
    assert motion.outcome is Outcome.ROLLING_ON
    passing = [
        e for e in motion.transitions if e.guard == "grip" and e.before == e.after
    ]
    assert len(passing) == 1
    assert energy_spread(motion) < 1e-11


@pytest.mark.parametrize(
    "friction",
    [{}, {"mu_static": 0.3}, {"mu_static": 0.31}, {"k1": 0.01}, {"k3": 0.1}],
    ids=[
        "published",
        "equal frictions",
        "nearly equal",
        "nutation sticks",
        "pivoting sticks",
    ],
)
def test_every_guard_is_positive_while_its_regime_holds(friction):
    motion = roll(scene({"time_limit": 40 * scene().disk.time_unit}, **friction))
    lowest = lowest_guards(motion)
    assert {"lift-off", "nutation reverses", "slip", "slip keeps its side"} <= set(
        lowest
    )
    assert {name: value for name, value in lowest.items() if value < -ROUNDING} == {}
    assert dissipation_never_falls(motion).passed


def test_the_largest_fall_is_that_of_the_extrema_between_the_ends():
    """For x^3 - 3 x on [-2, 0] and [0, 2] the function falls from 2 at -1 to -2 at 1."""
    cubic = [
        Polynomial([0, -3, 0, 1])(Polynomial([start, 1])).coef[::-1]
        for start in (-2.0, 0.0)
    ]
    c = np.transpose(cubic)
    x = np.array([-2.0, 0.0, 2.0])
    assert largest_decrease(c, x) == pytest.approx(4.0, rel=gamma(20))
    assert largest_decrease(c[:, :1], x[:2]) == pytest.approx(2.0, rel=gamma(20))
    assert largest_decrease(-c, x) == pytest.approx(4.0, rel=gamma(20))
    assert (
        largest_decrease(
            np.array([[1.0, 1.0], [0.0, 2.0], [0.0, 3.0]]), np.array([0.0, 1.0, 2.0])
        )
        == 0.0
    )
    assert largest_decrease(np.zeros((3, 2)), np.array([0.0, 1.0, 2.0])) == 0.0
