"""Claim: physics engines solve the same rolling disk with first-order accuracy; with sliding they
solve a different problem.

Source: (2.5) and (3.3) for the initial state and the applied moments. Oracle: the exact
hypergeometric solution of the rolling disk; quadruple precision for the published case. Engines
that are not installed are skipped.
"""

from importlib.util import find_spec
from math import acos, pi, sin, sqrt
from types import SimpleNamespace

import exact_motion as exact
import numpy as np
import pytest
from arithmetic import gamma
from scipy.integrate import quad

from benchmarks.cases.motion_case import (
    PUBLISHED_RELEASE,
    answer_of,
    conservative,
    nearly_flat,
    published,
)
from benchmarks.methods.event_driven import ours
from benchmarks.peers import engines
from benchmarks.peers.rigid_body import (
    MAX_CENTRE_HEIGHT,
    answer,
    at_start,
    quaternion,
    resistance,
)
from benchmarks.timed_runs import LEFT_OUT, Failure, Work, measure

POINT_CONTACT = [
    name
    for name in (engines.METHODS | engines.METHODS_WITHOUT_MOMENTS)
    if "areas" not in name
]


def error(method, case, which):
    """Return the error of a method at a setting, given by its index, or at a step size."""
    peer = (engines.METHODS | engines.METHODS_WITHOUT_MOMENTS)[method]
    if not find_spec(peer.package):
        pytest.skip(f"{engines.ENGINES[peer.package]} is not installed")
    return case.error(
        peer.solve(
            case, *peer.fixed, peer.values[which] if isinstance(which, int) else which
        ).values
    )


@pytest.mark.parametrize("span", [1.0, 10.0])
def test_the_reference_of_the_conservative_case_is_the_exact_solution(span):
    case = conservative(span)
    h = case.law.h
    K = case.law.K
    a0 = pi / 2 - PUBLISHED_RELEASE[0]
    a1, period = exact.nutation(a0, 0.0, PUBLISHED_RELEASE[3], h, K)
    middle = (a0 + a1) / 2
    half = (a1 - a0) / 2
    inclination, energy = case.reference

    def slowness(phi):  # time per phi where a = middle - half cos(phi)
        speed = exact.nutation_rate_squared(
            middle - half * np.cos(phi), a0, 0.0, PUBLISHED_RELEASE[3], h, K
        )
        return half * sin(phi) / sqrt(speed)

    phi = acos((middle - (pi / 2 - inclination)) / half)
    since = quad(slowness, 0, phi, epsabs=1e-12, epsrel=1e-12)[0]
    rest = span % period
    assert min(abs(since - rest), abs(period - since - rest)) < 1e-9
    assert energy == pytest.approx(
        answer_of(PUBLISHED_RELEASE, case.law, 0).values[1], rel=gamma(60)
    )


@pytest.mark.parametrize(
    "case", [published(), conservative(), nearly_flat(0.01)], ids=lambda case: case.name
)
def test_the_start_of_the_engines_is_that_of_the_equations(case):
    pose = at_start(case)
    assert answer(pose, case.law, 0).values == pytest.approx(
        answer_of(case.start, case.law, 0).values, rel=gamma(60)
    )
    contact = pose.rotation @ [0.0, 1.0, -case.law.h]  # -e_3 - h e_2
    assert pose.centre[2] + contact[2] == pytest.approx(0, abs=gamma(20))
    speed = np.linalg.norm(pose.angular) * np.linalg.norm(contact)
    assert (
        np.abs(pose.velocity + np.cross(pose.angular, contact)).max()
        < gamma(20) * speed
    )
    w, x, _, _ = quaternion(case)
    turned = [[1, 0, 0], [0, w * w - x * x, -2 * w * x], [0, 2 * w * x, w * w - x * x]]
    assert np.abs(pose.rotation - turned).max() < gamma(20)


def test_the_external_moments_lose_energy_along_their_axes():
    law = published().law
    axle = np.array([0.0, sin(0.5), np.cos(0.5)])
    angular = np.array([0.3, -0.7, 0.2])
    moment = resistance(axle, angular, 2.0, law)
    assert moment == pytest.approx([-2 * law.k1, 2 * law.k2, -2 * law.k3])


def test_a_disk_that_left_the_table_is_a_failure():
    pose = at_start(published())
    for height, how in (
        (-1.0, "falls through"),
        (MAX_CENTRE_HEIGHT, "thrown off"),
        (np.nan, "thrown off"),
    ):
        with pytest.raises(Failure, match=how):
            answer(
                pose._replace(centre=np.array([0.0, 0.0, height])), published().law, 0
            )


@pytest.mark.parametrize("method", POINT_CONTACT)
def test_engines_converge_to_the_exact_motion(method):
    coarse, fine = (error(method, conservative(1.0), which) for which in (0, 1))
    assert fine < 2e-3
    assert coarse > 5 * fine


@pytest.mark.parametrize("method", engines.METHODS)
def test_engines_are_of_first_order(method):
    """The logarithmic slope of error against step size is 1 within 0.1."""
    steps = (2e-3, 1e-3, 5e-4, 2e-4)
    errors = [error(method, conservative(1.0), step) for step in steps]
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(1, abs=0.1)


@pytest.mark.parametrize("method", engines.METHODS)
def test_engines_feel_the_moments(method):
    assert error(method, published(1.0), 1) < 2e-3
    lossless = conservative(1.0).reference
    assert published(1.0).error(lossless) > 4e-3


@pytest.mark.parametrize("method", [m for m in engines.METHODS if "RK4" not in m])
def test_engines_with_one_coefficient_of_friction_slide_another_way(method):
    assert error(method, published(5.0), 1) > 0.1


@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
@pytest.mark.parametrize(
    "case", [conservative(), published(5.0)], ids=lambda case: case.name
)
def test_ours_does_neither(case):
    """Both time spans are too short for the motion to amplify rounding errors."""
    found = ours(case, "taylor", 1e-16)
    assert case.error(found.values) < gamma(20 * found.steps)


@pytest.mark.skipif(not find_spec("pydrake"), reason="Drake is not installed")
def test_contact_by_areas_takes_energy_from_a_rim_that_rolls():
    softer, harder = (
        error("Drake, contact by areas", conservative(1.0), which) for which in (0, 2)
    )
    assert softer > 0.02
    assert harder > 2e-3


def test_a_missing_engine_is_left_out_and_says_so(monkeypatch):
    monkeypatch.setattr(engines, "find_spec", lambda package: None)
    able = engines.methods_for(conservative(1.0))
    assert len(able) == len(POINT_CONTACT) + 1
    for method, peer in able.items():
        ((setting, call),) = peer.runs(conservative(1.0))
        record = measure(Work("engine", method, setting, "conservative", call, float))
        assert record.left_out
        assert record.failure.startswith(LEFT_OUT)
        assert "is not installed" in record.failure


def test_an_engine_that_stops_is_a_failure(monkeypatch):
    def stops(case):
        raise RuntimeError("no\nconvergence")

    monkeypatch.setattr(
        engines, "import_module", lambda name: SimpleNamespace(engine=stops)
    )
    with pytest.raises(Failure, match="stops: no convergence"):
        engines.EngineMethod("mujoco", "engine", (), ()).solve(conservative(1.0))
