"""Claim: without losses, and at small inclination, the simulator follows the known closed-form
solutions.

Source: Appell and Korteweg (1900); O'Reilly (1996); Cushman, Hermans & Kemppainen (1996); (5.3) of
the paper. Oracle: tests/helpers/exact_motion.py, which does not use the simulator: hypergeometric
functions, quadrature, linearisation.
"""

from dataclasses import replace
from math import pi, radians, sqrt

import exact_motion as theory
import numpy as np
import pytest
from arithmetic import gamma, walk
from scenes import conservative, roll, scene, whirling

from dynamics import Outcome
from dynamics.equations import disk_constants
from dynamics.hybrid import run_events
from dynamics.observables import slip_start_times
from dynamics.regime import PRECESSION, X
from dynamics.rolling import RollingDisk
from dynamics.simulation import chosen_integrator, initial_state
from dynamics.steady_motion import squared_rate_times_inclination, steady_precession

SOLIDS = [
    {},
    {"thickness": 1e-9, "radius": 0.03755, "mass": 0.4},
    {"thickness": 0.05},
    {"shape": "shell"},
    {"shape": "shell", "wall": 0.003},
]
NAMES = ["published", "thin", "thick", "shell", "hoop"]


@pytest.mark.parametrize("disk", SOLIDS, ids=NAMES)
def test_a_whole_nutation_is_hypergeometric(disk):
    release = {"inclination_deg": 40, "omega": (0, 2, -16)}
    wanted = conservative(numerics={"time_limit": 0.6}, disk=disk, release=release)
    motion = roll(wanted)
    h = wanted.disk.aspect
    K = wanted.disk.gyration
    chi = wanted.disk.time_unit
    state = motion.at(np.linspace(0, motion.t[-1], 40))
    start = state[0, 6:8] * chi
    for row in state[::3]:
        exact = theory.rolling_velocities(pi / 2 - row[1], radians(50), *start, h, K)
        np.testing.assert_allclose(row[6:8] * chi, exact, rtol=1e-10, atol=1e-11)


@pytest.mark.slow
def test_turning_angle_and_period_of_the_published_release():
    motion = roll(conservative(numerics={"time_limit": 0.5}))
    disk = motion.disk
    turn, period = theory.nutation(1.0, 0.0, -1.0, disk.aspect, disk.gyration)
    slope = (
        theory.nutation_rate_squared(
            turn - 1e-6, 1.0, 0.0, -1.0, disk.aspect, disk.gyration
        )
        / 1e-6
    )
    energy = motion.energy(0.0)[0] / (disk.mass * (disk.radius / disk.time_unit) ** 2)
    assert pi / 2 - turn == pytest.approx(
        0.44837097707011868, abs=gamma(100) * energy / slope
    )
    assert period == pytest.approx(2.8739671849286171, abs=1e-9)
    after = motion.at(np.array([0.5, 1.0]) * period * disk.time_unit)
    np.testing.assert_allclose(after[:, 1], [pi / 2 - turn, pi / 2 - 1], rtol=1e-9)
    np.testing.assert_allclose(after[:, 5] * disk.time_unit, 0, atol=1e-9)


def test_energy_is_conserved_for_a_thousand_nutations():
    motion = roll(conservative(numerics={"time_limit": 200.0}))
    energy = motion.energy(motion.t)
    assert motion.outcome is Outcome.ROLLING_ON
    assert np.ptp(energy) < walk(4 * len(motion.t)) * energy[0]


@pytest.mark.parametrize("disk", SOLIDS, ids=NAMES)
@pytest.mark.parametrize("inclination", [0.01, 0.3, 1.0])
def test_steady_motion_stays_and_its_nutation_has_the_linear_frequency(
    disk, inclination
):
    steady = whirling(inclination, disk=disk, numerics={"time_limit": 0.2})
    h = steady.disk.aspect
    K = steady.disk.gyration
    chi = steady.disk.time_unit
    in_plane = steady.release.omega[2] * chi
    square = theory.steady_nutation_squared(pi / 2 - inclination, in_plane, h, K)
    state = roll(steady).at(np.linspace(0, 0.05, 50))
    if square > 0:
        np.testing.assert_allclose(state[:, 1], inclination, rtol=1e-9)
    kick = 1e-6 * inclination
    omega = (kick / chi, *steady.release.omega[1:])
    nudged = roll(replace(steady, release=replace(steady.release, omega=omega)))
    t = np.linspace(0, 0.05, 4000)
    deviation = nudged.at(t)[:, 1] - inclination
    size = kick / sqrt(abs(square))
    tau = t / chi
    exact = -size * (
        np.sin(sqrt(square) * tau) if square > 0 else np.sinh(sqrt(-square) * tau)
    )
    small = np.abs(exact) < 20 * size
    np.testing.assert_allclose(deviation[small], exact[small], atol=1e-2 * size)


@pytest.mark.parametrize("h", [1e-6, 0.17, 3.0, 300.0])
@pytest.mark.parametrize("K", [1.0, 2.0])
def test_steady_precession_in_closed_form_and_its_flat_limit(h, K):
    """The closed form of (5.3) agrees with `theory` to the rounding of pi/2 - beta."""
    for beta in (1e-3, 0.1 / (1 + h)):
        rel = 4 * np.finfo(float).eps / beta
        assert steady_precession(beta, h, K) == pytest.approx(
            theory.steady_precession(beta, h, K), rel=rel
        )
    assert steady_precession(1e-9, h, K) ** 2 * 1e-9 == pytest.approx(
        squared_rate_times_inclination(h, K), rel=1e-5
    )
    with pytest.raises(ValueError, match="no steady motion"):
        steady_precession(1.3, 0.2, K)


@pytest.mark.parametrize("inclination", [0.02, 0.005])
def test_slope_of_the_root_of_the_inclination_under_rolling_friction(inclination):
    k2 = 1e-6
    steady = whirling(inclination, k2=k2, numerics={"time_limit": 10.0})
    disk = steady.disk
    motion = roll(steady)
    t = np.linspace(0, motion.t[-1], 4000)
    fitted = -np.polyfit(t / disk.time_unit, np.sqrt(motion.at(t)[:, 1]), 1)[0]
    assert fitted == pytest.approx(
        theory.rolling_friction_slope(k2, inclination, disk.aspect, disk.gyration),
        rel=2e-3,
    )
    centred = theory.centred_slope(k2, disk.aspect, disk.gyration)
    assert fitted / centred == pytest.approx(0.94, abs=0.01), (
        "the centre does not stay fixed under rolling friction"
    )


def test_the_self_similar_end():
    """The intervals of the last slips are a geometric sequence; inclination ~ time squared."""
    motion = roll(scene({"final_inclination": 1e-10}))
    slips = slip_start_times(motion)
    gaps = np.diff(slips)
    ratios = gaps[-60:] / gaps[-61:-1]
    np.testing.assert_allclose(ratios, 0.94432, atol=5e-6)
    end = slips[-1] + gaps[-1] * ratios[-1] / (1 - ratios[-1])
    exponent = np.polyfit(
        np.log(end - slips[-80:]), np.log(motion.at(slips[-80:])[:, 1]), 1
    )[0]
    assert exponent == pytest.approx(2, abs=1e-5)
    assert motion.t_end == pytest.approx(end, abs=1e-5)


@pytest.mark.parametrize("turn", [0.5, -2.0])
def test_turning_the_release_about_the_vertical_turns_the_path(turn):
    start = scene()
    straight, _ = run_events(
        system_of(start), initial_state(start.disk, start.release), 20.0
    )
    y = initial_state(start.disk, start.release)
    y[PRECESSION] = turn
    turned, _ = run_events(system_of(start), y, 20.0)
    # at the starts of the arcs, because rounding may change the steps within one
    a, b = (
        np.array([block[0, 0] for block in path.coefficients])
        for path in (straight, turned)
    )
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    np.testing.assert_allclose(b[:, X : X + 2], a[:, X : X + 2] @ rotation, atol=1e-12)
    np.testing.assert_allclose(b[:, PRECESSION] - turn, a[:, PRECESSION], atol=1e-9)
    np.testing.assert_allclose(
        b[:, :PRECESSION], a[:, :PRECESSION], rtol=1e-9, atol=1e-12
    )


def system_of(wanted):
    """Return the hybrid system of a scene, as built by `simulate`."""
    integrate = chosen_integrator("auto")[1]
    return RollingDisk(
        disk_constants(wanted.disk, wanted.friction), None, 1e-5, integrate, 1e-16
    )


def test_the_mirror_image_of_a_motion_is_a_motion():
    right = scene(numerics={"time_limit": 6.0})
    left = replace(
        right, release=replace(right.release, omega=(0.0, 0.0, -right.release.omega[2]))
    )
    t = np.linspace(0, 6, 500)
    a = roll(right).at(t)
    b = roll(left).at(t)
    signs = [-1, 1, -1, -1, 1, 1, -1, -1, -1, 1, 1]
    np.testing.assert_allclose(a, b * signs, rtol=1e-7, atol=1e-7)
