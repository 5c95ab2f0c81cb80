"""Claim: in every scene the energy never rises, the contact force is compressive, friction stays in
its cone, and the result does not depend on the integrator.

Source: sections 3 and 6.3 of the paper; Hairer & Wanner for the order of an integrator. Oracle:
inequalities that hold for every solution; a second integrator; the same integrator at another
order.
"""

from importlib.util import find_spec
from math import sqrt

import numpy as np
import pytest
from arithmetic import gamma
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scenes import energy_spread, proves_its_outcome, roll, scene

from dynamics import ImpossibleContactError
from dynamics.switching import FIRST_SLIDE_STEP

needs_heyoka = pytest.mark.skipif(
    not find_spec("heyoka"), reason="heyoka is not installed"
)
arms = st.one_of(st.just(0.0), st.floats(1e-5, 0.05))


@st.composite
def scenes(draw, integrator="auto", span=15.0):
    """Draw a scene with random shape, friction and release, and a duration in units of chi."""
    disk = {
        "thickness": draw(st.floats(1e-4, 0.06)),
        "shape": draw(st.sampled_from(["solid", "shell"])),
    }
    mu = draw(st.floats(0.05, 1.0))
    friction = {"mu_static": mu, "mu_dynamic": mu * draw(st.floats(0.3, 0.95))}
    friction |= {"k1": draw(arms), "k2": draw(arms), "k3": draw(arms)}
    omega = tuple(
        draw(st.floats(low, high)) for low, high in ((-3, 3), (-8, 8), (-20, 20))
    )
    release = {"inclination_deg": draw(st.floats(3, 70)), "omega": omega}
    chi = scene(disk=disk).disk.time_unit
    return scene(
        {"integrator": integrator, "time_limit": span * chi},
        disk=disk,
        release=release,
        **friction,
    )


def solved(wanted):
    """Return the motion; reject the example if the disk leaves the plane immediately or no solution
    exists."""
    try:
        return roll(wanted)
    except ImpossibleContactError:
        assume(False)


@pytest.mark.slow
@settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    derandomize=True,
)
@given(scenes())
def test_energy_load_and_cone(wanted):
    motion = solved(wanted)
    assert proves_its_outcome(motion, wanted.numerics.time_limit)
    energy = motion.energy(motion.t)
    bar = (
        gamma(50) + 50 * FIRST_SLIDE_STEP**3
    )  # round-off, and the first step of a slide from rest
    assert np.diff(energy).max(initial=0.0) <= bar * energy[0]
    assert energy_spread(motion) <= 1e-10
    force = motion.force((motion.t[1:] + motion.t[:-1]) / 2)
    weight = motion.disk.weight
    assert force[:, 2].min() >= -1e-9 * weight
    friction = np.hypot(force[:, 0], force[:, 1])
    sliding = np.char.startswith(
        motion.regime((motion.t[1:] + motion.t[:-1]) / 2), "slide"
    )
    limit = (
        np.where(sliding, wanted.friction.mu_dynamic, wanted.friction.mu_static)
        * force[:, 2]
    )
    assert (friction - limit).max() <= 1e-8 * weight
    np.testing.assert_allclose(
        friction[sliding], limit[sliding], rtol=1e-9, atol=1e-9 * weight
    )


@pytest.mark.slow
@needs_heyoka
@settings(
    max_examples=10,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    derandomize=True,
)
@given(scenes(integrator="taylor", span=4.0))
def test_both_integrators_agree(wanted):
    from dataclasses import replace

    ours = solved(wanted)
    other = roll(
        replace(wanted, numerics=replace(wanted.numerics, integrator="dop853"))
    )
    assert ours.rolling_outcome is other.outcome
    assert [s[1:] for s in ours.transitions] == [s[1:] for s in other.transitions]
    t = np.linspace(0, min(ours.t[-1], other.t[-1]), 50)[:-1]
    a = ours.at(t)
    b = other.at(t)
    np.testing.assert_allclose(a, b, rtol=1e-7, atol=1e-8)


@needs_heyoka
def test_each_order_of_the_series_gains_e_squared_through_transitions():
    """With steps of radius/e^2 the error of order p falls as exp(-2 p), also through events."""
    chi = scene().disk.time_unit
    t = np.linspace(1, 39.9, 60) * chi

    def run(tolerance):
        return roll(
            scene(
                {"integrator": "taylor", "tolerance": tolerance, "time_limit": 40 * chi}
            )
        )

    exact = run(1e-16)
    assert len({s.guard for s in exact.transitions}) >= 3
    orders = []
    errors = []
    for tolerance in (1e-6, 3e-7, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11):
        motion = run(tolerance)
        orders.append(motion.path.c.shape[0] - 1)
        errors.append(sqrt(np.mean((motion.at(t)[:, 1] - exact.at(t)[:, 1]) ** 2)))
    slope = np.polyfit(orders, np.log(errors), 1)[0]
    assert orders == list(range(8, 15))
    assert slope == pytest.approx(-2.2, abs=0.2)
