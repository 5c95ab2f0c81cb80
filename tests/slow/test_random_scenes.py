"""Claim: the rolling motion of every legal random scene ends in a named outcome and passes every check of a
run, or is refused by name at the first instant; nothing crashes, hangs or becomes NaN.

Source: sections 3 and 4 of the paper; sonify/claims/checks.py. Oracle: balances and inequalities
that hold for every solution.
"""

import warnings
from collections import Counter
from math import inf, pi, radians, sin, sqrt
from time import process_time

import numpy as np
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from legal_scenes import decades
from scenes import roll, scene

from dynamics import ImpossibleContactError, Outcome
from dynamics.steady_motion import squared_rate_times_inclination
from sonify.claims.checks import (
    dissipation_never_falls,
    energy_balance,
    friction_cone,
    pushing_contact,
)

DRAWN_SCENE_COUNT, MAX_SECONDS_PER_SCENE = 150, 60.0
TURNS, UNITS = 200.0, 30.0
"""Limits on the duration: turns of the contact at the initial inclination, and units chi."""


def any_disk(random):
    """Draw a disk with a radius from a millimetre to metres, from thin sheet to long pipe."""
    radius = decades(random, 1e-3, 10)
    thickness = radius * decades(random, 1e-3, 4)
    mass = decades(random, 1e-6, 1e4)
    return {
        "radius": radius,
        "thickness": thickness,
        "mass": mass,
        "shape": random.choice(["solid", "shell"]),
    }


def any_friction(random):
    """Draw friction coefficients, often nearly equal, sometimes zero or infinite, and resisting
    arms over the radius."""
    mu = random.choice([decades(random, 0.01, 2)] * 8 + [0.0, inf])
    ratio = random.choice([1.0, 1.001, 1.01, random.uniform(1, 4)])
    resisted = random.choice([(0, 0, 0), (1, 1, 1), (1, 1, 1), (0, 0, 1)])
    arms = {
        f"k{i}": arm * decades(random, 1e-7, 0.03) for i, arm in enumerate(resisted, 1)
    }
    return {"mu_static": ratio * mu, "mu_dynamic": mu, **arms}


def any_dissipation(random, disk):
    """Draw one further law of dissipation, or None."""
    strength = decades(random, 1e-7, 1e-2)
    b = random.choice([2.5, 4.0])
    chi = disk.time_unit
    inertia = strength * disk.mass * disk.radius**2
    laws = [
        {"viscous_moment": inertia / chi, "viscous_force": strength * disk.mass / chi},
        {"contour_moment": inertia / chi**2},
        {"power_coefficient": inertia * chi ** (b - 3), "power_exponent": b},
    ]
    return random.choice([None] * 3 + laws)


@st.composite
def scenes(draw):
    """Draw a scene, released at rest, at random or near a steady motion, at 0.01 to 80 degrees."""
    random = draw(
        st.randoms(use_true_random=True)
    )  # hypothesis' own numbers would come as small changes of a few
    shape = any_disk(random)
    disk = scene(disk=shape).disk
    inclination_deg = decades(random, 0.01, 80)
    chi = disk.time_unit
    beta = radians(inclination_deg)
    fastest = (
        sqrt(squared_rate_times_inclination(disk.aspect, disk.gyration) / beta) / chi
    )
    spread = random.choice([0.0, 0.01, 0.1, 1.0]) * fastest * sin(beta)
    whirl = random.choice([0, 1, 1, -1]) * fastest * sin(beta)
    omega = [random.gauss(mean, spread) for mean in (0, disk.aspect * whirl, whirl)]
    numerics = {
        "integrator": random.choice(["auto"] * 9 + ["dop853"]),
        "accuracy": random.choice(["draft", "standard"]),
        "time_limit": min(UNITS * chi, TURNS * 2 * pi / fastest),
    }
    release = {"inclination_deg": inclination_deg, "omega": tuple(omega)}
    return scene(
        numerics, shape, release, any_dissipation(random, disk), **any_friction(random)
    )


def solved(wanted):
    """Return the motion of a scene, or None if it is refused at the first instant.

    Raise AssertionError if the simulation hangs.
    """
    started = process_time()

    def watch(t, inclination, doing):
        assert process_time() - started < MAX_SECONDS_PER_SCENE, f"hangs at t = {t} s"

    try:
        with warnings.catch_warnings(action="error"):
            return roll(wanted, watch=watch)
    except ImpossibleContactError as refusal:
        assert str(refusal).startswith("at t = 0 s: ")  # noqa: PT017
        return None


def test_every_scene_ends_with_a_name_and_passes_its_checks():
    ends = Counter()

    @settings(
        max_examples=DRAWN_SCENE_COUNT,
        deadline=None,
        database=None,
        derandomize=True,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(scenes())
    def judge(wanted):
        motion = solved(wanted)
        ends[motion and motion.rolling_outcome] += 1
        if motion:
            assert np.isfinite(motion.state).all()
            assert np.isfinite(motion.force(motion.t)).all()
            checks = (
                energy_balance,
                dissipation_never_falls,
                pushing_contact,
                friction_cone,
            )
            checked = [check(motion) for check in checks]
            assert all(check.passed for check in checked), checked

    judge()
    assert ends.total() == DRAWN_SCENE_COUNT
    assert (
        ends[None] <= 0.1 * DRAWN_SCENE_COUNT
    )  # the release is too fast to stay on the table, or no contact is possible
    assert ends[Outcome.STALLED] + ends[Outcome.CASCADE] <= 0.01 * DRAWN_SCENE_COUNT
    elsewhere = {
        Outcome.AIRBORNE,
        Outcome.LEFT_TABLE,
        Outcome.AT_REST,
        Outcome.SANK,
    }  # the scene has neither air nor a table edge, only a landing ends at rest, and no face sinks
    assert {*Outcome} - {Outcome.STALLED, Outcome.CASCADE} - elsewhere <= {*ends}
