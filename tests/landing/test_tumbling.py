"""Claim: a disk that falls, leaves the table or stands on its edge is followed until it rests or
rolls again.

Source: balance of momentum of a rigid disk whose rims touch the table with friction.
Oracle: the exact solution of rolling; the closed form of the upright spin of a thin disk; the
restitution that was asked for; continuity at each hand-over, and the balance of energy.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from dynamics import Disk, Outcome, plan_motion, simulate
from dynamics.landing.after_rolling import rim_friction
from dynamics.landing.equations import LOSSES, LandingModel, LandingState
from dynamics.landing.landing_motion import solve_landing_motion
from dynamics.landing.rim_friction import RimFriction
from dynamics.landing.solution import LandingEnd, solve_landing
from dynamics.landing.stop import stop_below
from sonify import load_scene

DISK = Disk(radius=0.03755, thickness=0.0128, mass=0.4387)


def model_of(disk=DISK, restitution=0.79, friction=None):
    """Return a disk with sharp edges in a vacuum."""
    stop = stop_below(disk.radius, disk.mass, restitution)
    return LandingModel(disk, None, stop, friction or RimFriction())


def tilted(disk, inclination, turn=0.0, rise=0.0):
    """Return the state of a disk whose low point touches the table.

    It turns about the vertical at a rate `turn` [rad/s], and its centre rises at `rise` [m/s].
    """
    s, c = np.sin(inclination), np.cos(inclination)
    height = disk.radius * s + disk.thickness / 2 * (c - 1)
    return LandingState(
        height=height, axis_x=-s, axis_y=0.0, axis_z=c, rise=rise,
        turn_x=0.0, turn_y=-turn * s, turn_z=0.0,
        x=0.0, y=0.0, speed_x=0.0, speed_y=0.0, turned=0.0, axial_rate=turn * c,
    )  # fmt: skip


@pytest.mark.parametrize("restitution", [0.28, 0.46, 0.79])
@pytest.mark.parametrize("inclination", [0.3, 1.2])
def test_a_rim_rebounds_with_the_restitution_of_the_face(restitution, inclination):
    model = model_of(restitution=restitution)
    found = solve_ivp(
        model.rates, (0, 1e-3), tilted(DISK, inclination, rise=-1.0), "LSODA", rtol=1e-8, atol=1e-11
    )  # fmt: skip
    at = [model.geometry(y) for y in found.y.T.tolist()]
    clearance = np.array([one.gap - DISK.radius * one.slope for one in at])
    leaves = 1 + np.argmax((clearance[:-1] < 0) & (clearance[1:] >= 0))
    speed = at[leaves].opening - DISK.radius * at[leaves].tip
    assert speed == pytest.approx(restitution, abs=0.04)
    assert clearance.min() < -1e-6


def test_a_rolling_disk_rolls_as_the_exact_solver_says():
    scene = load_scene("published").replace("numerics.time_limit=1.3")
    rolling = simulate(scene)
    model = model_of(
        friction=rim_friction(plan_motion(scene))._replace(coefficient=10.0)
    )
    begin, duration = 1.0, 0.2
    start = rolling.at(begin)[0]
    found = solve_landing_motion(model, start, 0.0, "rolls on", duration)
    now = np.linspace(0.05, duration, 30)
    exact, ours = rolling.at(begin + now), found.at(now)
    swing = np.ptp(exact[:, 1])
    assert np.abs(ours[:, 1] - exact[:, 1]).max() < 2e-3 * swing
    turned = exact[-1, 0] - start[0]
    assert ours[-1, 0] - start[0] == pytest.approx(turned, rel=1e-3)
    total = found.energy(found.t) + found.at(found.t)[:, 10]
    assert np.ptp(total) < 1e-5 * total[0]
    assert found.energy_lost(duration)["moments"][0] > 0


def test_a_disk_that_falls_over_comes_to_rest_on_its_face():
    still = load_scene("published").replace(
        "release={inclination_deg=5, omega=[0, 0, 0]}"
    )
    motion = simulate(still)
    assert motion.outcome is Outcome.AT_REST
    assert motion.rolling_outcome is Outcome.FELL
    assert motion.at(motion.t[-1])[0, 1] < 1e-5
    assert [event.t for event in motion.events] == sorted(
        event.t for event in motion.events
    )
    assert max(event.speed for event in motion.events) > 0.1
    total = motion.energy(motion.t) + sum(motion.energy_lost(motion.t).values())
    assert np.ptp(total) < 1e-5 * total[0]


def test_a_thick_disk_that_leans_a_little_stands_up_and_stays_on_its_edge():
    disk = Disk(radius=0.012, thickness=0.006, mass=0.02)
    model = model_of(disk, 0.46, RimFriction(0.3, (0.0, 1e-5, 1e-4)))
    standing = np.arctan2(
        disk.thickness, 2 * disk.radius
    )  # largest angle from which it returns
    found = solve_landing(model, tilted(disk, np.pi / 2 - 0.3 * standing), 2.0)
    assert found.end is LandingEnd.REST
    end = model.geometry(found.path(found.path.x[-1]).tolist())
    assert np.arctan2(end.slope, end.cosine) == pytest.approx(np.pi / 2, abs=1e-4)
    falls = solve_landing(model, tilted(disk, np.pi / 2 - 1.1 * standing), 2.0)
    end = model.geometry(falls.path(falls.path.x[-1]).tolist())
    assert end.slope < 1e-3
    for one in (found, falls):
        states = one.path(one.path.x)
        energy = np.array([model.energy(y) for y in states.tolist()])
        assert np.ptp(energy + states[:, LOSSES].sum(axis=1)) < 1e-5 * energy[0]


@pytest.mark.slow
@pytest.mark.parametrize(("share", "tips"), [(0.95, True), (1.2, False)])
def test_a_thin_disk_spins_upright_above_its_critical_rate(share, tips):
    """The rate is sqrt(4 g/(5 R)), where friction holds the contact."""
    thin = Disk(radius=0.0125, thickness=1e-6, mass=0.005)
    rate = share * np.sqrt(4 * 9.81 / (5 * thin.radius))
    model = model_of(thin, 0.46, RimFriction(10.0, creep_speed=1e-5))
    found = solve_landing(model, tilted(thin, np.pi / 2 - 2e-4, rate), 3.0)
    lean = np.arccos(np.hypot(*found.path(found.path.x)[:, 1:3].T).clip(max=1))
    assert (lean.max() > np.radians(15)) == tips
    assert (lean.max() < np.radians(2)) != tips


@pytest.mark.slow
def test_a_coin_spun_on_its_edge_is_followed_to_rest():
    """It wobbles from rim to rim, and then falls, rolls and lands on its air, or stands still."""
    spun = load_scene("published").replace(
        "disk={radius=0.01213, thickness=0.00175, mass=0.00567}",
        "material={young=130e9, poisson=0.34, loss_factor=1.2e-4}",
        "friction={mu_static=0.3, mu_dynamic=0.25, arm_rolling=6e-6, arm_pivoting=2e-5}",
        "release={inclination_deg=88.0, omega=[0.0, 0.0, 63.0]}",
        "air.film=acts",
    )
    motion = simulate(spun)
    assert motion.outcome is Outcome.AT_REST
    kinds = [event.kind for event in motion.events]
    assert "rolls again on its other rim" in kinds
    last = motion.at(motion.t[-1])[0, 1]
    assert last < 1e-4 or last == pytest.approx(np.pi / 2, abs=1e-4)
    assert len(motion.parts) > 4
    for before, after in zip(motion.parts[:-1], motion.parts[1:], strict=True):
        first = before.motion.at(before.motion.t[-1])[0]
        second = after.motion.at(0.0)[0]
        assert np.sin(second[1]) == pytest.approx(np.sin(first[1]), abs=1e-12)
        assert second[3:5] == pytest.approx(first[3:5], abs=1e-12)
    total = motion.energy(motion.t) + sum(motion.energy_lost(motion.t).values())
    assert np.ptp(total) < 1e-5 * total[0]
    assert np.all(np.diff(motion.t) > 0)
