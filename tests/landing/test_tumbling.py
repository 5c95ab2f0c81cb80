"""Claim: a disk that falls, leaves the table or stands on its edge is followed until it rests or
rolls again.

Source: balance of momentum of a rigid disk whose rims touch the table with friction.
Oracle: the exact solution of rolling; the closed form of the upright spin of a thin disk; the
restitution that was asked for; continuity at each hand-over, and the balance of energy.
"""

import numpy as np
import pytest
from scenes import conservative, energy_spread, roll
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from dynamics import Disk, Outcome, plan_motion, simulate
from dynamics.landing.after_rolling import rim_friction
from dynamics.landing.equations import LOSSES, LandingModel, LandingState
from dynamics.landing.landing_motion import LandingMotion, solve_landing_motion
from dynamics.landing.rim_friction import RimFriction
from dynamics.landing.solution import Landing, LandingEnd, solve_landing
from dynamics.landing.stop import stop_below
from sonify import load_scene
from sonify.sound.modal_forcing import from_lower_face, turning_acceleration

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


@pytest.mark.parametrize("coefficient", [1e-9, 1e-6, 1e-3])
def test_the_moment_that_resists_a_disk_which_slaps_down_is_bounded(
    coefficient,
):
    """The inclination vanishes within picoseconds, and the rate of its direction has no bound."""
    light = Disk(radius=0.12, thickness=0.0033, mass=1.5e-4)
    model = model_of(light, friction=RimFriction(0.04, laws=((coefficient, 2.5),)))
    for inclination in (1e-10, 1e-6, 1e-3):
        pressed = tilted(light, inclination, 7.0 / inclination, -0.9)
        state = pressed._replace(height=pressed.height - 1e-8)
        at = model.geometry(state)
        loads = model.loads(at)
        rim = model.rim_loads(state, at, loads)
        assert loads.stop.force > 0
        assert 0 < abs(rim.moment_p) <= light.radius * loads.stop.force * 1.01
    begin = tilted(light, 1.2e-4, rise=-0.88)._replace(turn_x=0.0, turn_y=7.37)
    found = solve_landing(model, begin, 1e-4)
    assert found.end is LandingEnd.TIME_LIMIT
    total = [model.energy(y) + sum(y[LOSSES]) for y in found.path.c[-1]]
    assert np.ptp(total) < 1e-6 * total[0]


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


@pytest.mark.parametrize(
    "friction", [RimFriction(), RimFriction(0.3, (4e-6, 3e-5, 3e-4))]
)
@pytest.mark.parametrize(("inclination", "turn"), [(0.09, 0.0), (1.0, 20.0)])
def test_a_fall_with_bounces_closes_the_energy_to_its_tolerance(
    friction, inclination, turn
):
    """The integrator is the only source of error: neither friction nor restitution adds to it."""
    model = model_of(friction=friction)
    start = tilted(DISK, inclination, turn)
    found = solve_landing(model, start, 0.12)
    states = found.path(found.path.x)
    total = [model.energy(y) for y in states.tolist()] + states[:, LOSSES].sum(axis=1)
    assert states[-1, LOSSES].sum() > 1e-5 * total[0]  # it has bounced
    assert np.ptp(total) < 2e-8 * total[0]


@pytest.mark.slow
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


@pytest.mark.parametrize(
    ("axial_rate", "arm"), [(12.0, 3e-5), (-12.0, 3e-5), (12.0, 0.0)]
)
def test_a_disk_upright_on_both_rims_rolls_straight_on(axial_rate, arm):
    """A cylinder that rolls slows down at k_2 W/(m R^2 + C), or never; test_straight_rolling.py has
    its path and its energy."""
    model = model_of(friction=RimFriction(0.3, (0.0, arm, 1e-4)))
    upright = tilted(DISK, np.pi / 2)._replace(
        axis_z=0.0, speed_y=DISK.radius * axial_rate, axial_rate=axial_rate
    )
    limit = 500.0
    found = solve_landing(model, upright, limit)
    assert found.steps < 5000
    slowing = arm * DISK.weight / (1.5 * DISK.mass * DISK.radius**2)
    assert found.end is (LandingEnd.REST if arm else LandingEnd.TIME_LIMIT)
    end = abs(axial_rate) / slowing if arm else limit
    assert found.path.x[-1] == pytest.approx(end, rel=1e-3)


@pytest.mark.slow
def test_a_disk_that_leaves_the_table_at_its_release_is_followed():
    thrown = load_scene("published").replace(
        "release={inclination_deg=65, omega=[0.0, 50.0, 150.0]}",
        "numerics.time_limit=1.0",
    )
    motion = simulate(thrown)
    assert motion.outcome in (Outcome.ROLLING_ON, Outcome.AT_REST)
    first = motion.parts[0].motion
    assert first.events[0].kind == "released"
    t = np.linspace(0.001, 0.01, 10)
    rise = first.solution.path(t)[:, 4]
    assert rise == pytest.approx(rise[0] - 9.81 * (t - t[0]), abs=1e-9)
    assert energy_spread(motion) < 1e-5


@pytest.mark.slow
def test_a_coin_spun_on_its_edge_hands_over_to_the_contacts_on_its_rim():
    spun = load_scene("coin").replace(
        "release={inclination_deg=86.0, omega=[0.0, 0.0, 45.0]}",
        "numerics.time_limit=3.65",
    )
    motion = simulate(spun)
    landing, rattling, *_ = (part.motion for part in motion.parts)
    assert landing.rolls_on
    assert rattling.finding_groups == ("rattling",)
    begin = motion.parts[1].begin
    before, after = motion.at([np.nextafter(begin, 0), begin])
    assert after[:5] == pytest.approx(before[:5], abs=1e-5)  # one step later
    assert after[5:8] == pytest.approx(before[5:8], abs=2e-3)  # its creep ends
    modes = motion.parts[1].motion.rim_modes
    vibration = motion.rim_vibration([0.0, begin + 0.02])
    assert vibration.shape == (2, 3, len(modes.order))
    assert energy_spread(motion) < 2e-5


@pytest.mark.parametrize(("rate", "falls"), [(25.0, True), (25.56, False)])
def test_a_thin_disk_that_rolls_upright_falls_below_its_critical_rate(rate, falls):
    """Rolling, (A + m R^2) Omega^2 = m g R gives sqrt(4 g/(5 R)), 25.06 rad/s for 12.5 mm.

    Here nothing is lost, and the lean is too small to matter: 0.01 degrees at the start.
    """
    thin = {"radius": 0.0125, "thickness": 1e-6, "mass": 0.005}
    release = {"inclination_deg": 89.99, "omega": (0.0, 0.0, rate)}
    spun = conservative(numerics={"time_limit": 3.0}, disk=thin, release=release)
    motion = roll(spun)
    lean = 90 - np.degrees(motion.inclination(np.linspace(0, motion.t[-1], 2000)))
    assert (lean.max() > 4) == falls
    assert (lean.max() < 0.25) != falls


@pytest.mark.parametrize(("share", "falls"), [(0.98, True), (1.02, False)])
def test_without_friction_the_critical_rate_is_higher(share, falls):
    """The centre stays above its place, A Omega^2 = m g R, which gives sqrt(4 g/R)."""
    thin = Disk(radius=0.0125, thickness=1e-6, mass=0.005)
    rate = share * np.sqrt(4 * 9.81 / thin.radius)
    stop = stop_below(thin.radius, thin.mass, 1.0, stiffness=4e5)
    model = LandingModel(thin, None, stop)
    first = tilted(thin, np.pi / 2 - 2e-4, rate)

    def surplus(depth):
        loads = model.loads(model.geometry(first._replace(height=first.height - depth)))
        return loads.stop.force + loads.upper_stop.force - thin.weight

    depth = brentq(surplus, 0, 1e-4)  # of the static contact
    found = solve_landing(model, first._replace(height=first.height - depth), 1.5)
    lean = np.arccos(np.hypot(*found.path(found.path.x)[:, 1:3].T).clip(max=1))
    assert (lean.max() > np.radians(6)) == falls
    assert (lean.max() < np.radians(3)) != falls


@pytest.mark.parametrize("inclination", [0.5, 1.4, 1.8, 2.6])
def test_the_force_turns_the_disk_about_the_rim_on_which_it_acts(inclination):
    """The angular acceleration for the sound is that of the equations, on either rim."""
    model = model_of()
    state = tilted(DISK, inclination)
    deep = 2e-6
    lowest = DISK.radius * np.sin(inclination)
    lowest += DISK.thickness / 2 * abs(np.cos(inclination))
    state = state._replace(height=lowest - deep - DISK.thickness / 2)
    columns = np.array([0.0, inclination, *np.zeros(9)])
    path = CubicHermiteSpline([0, 1], [state] * 2, [np.zeros(20)] * 2)
    solution = Landing(model, path, LandingEnd.REST, 1)
    motion = LandingMotion(
        solution=solution, start=columns, rolling_fillet=0.0, cause=""
    )
    attitude = motion.at(0.0)
    force, attitude, film = from_lower_face(
        motion.force(0.0), attitude, motion.film_loads(0.0, attitude)
    )
    rates = model.rates(0.0, list(state))
    axis = np.array(state[1:4])
    exact = np.cross(axis, rates[5:8])  # in the fixed frame
    (turn,) = turning_acceleration(force, attitude[:, 1], film, DISK)
    upwards = axis * np.sign(axis[2])
    e1 = np.array([np.cos(attitude[0, 0]), np.sin(attitude[0, 0]), 0.0])
    found = -turn[0] * np.cross(e1, upwards) - turn[1] * e1 + turn[2] * upwards
    assert force[0, 2] > 1
    assert found == pytest.approx(exact, rel=1e-6, abs=1e-6 * np.linalg.norm(exact))


def test_the_spin_of_a_disk_that_turns_over_belongs_to_its_angular_velocity():
    """spin' = omega_2 - precession' cos(inclination), before and after it is upright."""
    columns = np.array([0.3, 1.2, 0.5, *np.zeros(8)])
    columns[5:8] = -30.0, 4.0, -7.0
    thrown = solve_landing_motion(
        model_of(), columns, 0.0, "thrown", 0.06, clearance=0.1
    )
    assert thrown.force(thrown.t)[:, 2].max() == 0
    t = np.linspace(1e-3, 0.059, 40)
    h = 1e-5
    state = thrown.at(t)
    rate = (thrown.at(t + h) - thrown.at(t - h)) / (2 * h)
    turned_over = state[:, 1] > np.pi / 2
    assert 5 < np.count_nonzero(turned_over) < 35
    spin = state[:, 6] - rate[:, 0] * np.cos(state[:, 1])
    clear = abs(state[:, 1] - np.pi / 2) > 0.05
    assert rate[clear, 2] == pytest.approx(spin[clear], abs=1e-4)
    assert np.ptp(thrown.at(thrown.t)[:, 2]) < 3 * np.pi


@pytest.mark.slow
@pytest.mark.parametrize(
    ("share", "seconds", "tips"), [(0.95, 1.0, True), (1.2, 3.0, False)]
)
def test_a_thin_disk_spins_upright_above_its_critical_rate(share, seconds, tips):
    """The rate is sqrt(4 g/(5 R)), where friction holds the contact."""
    thin = Disk(radius=0.0125, thickness=1e-6, mass=0.005)
    rate = share * np.sqrt(4 * 9.81 / (5 * thin.radius))
    model = model_of(thin, 0.46, RimFriction(10.0, creep_speed=1e-5))
    found = solve_landing(model, tilted(thin, np.pi / 2 - 2e-4, rate), seconds)
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
