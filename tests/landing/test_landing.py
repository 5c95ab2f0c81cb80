"""Claim: a disk that the air lifts, or that falls flat, is solved until it is at rest.

Source: balance of momentum of a nearly flat disk between Reynolds' film and a unilateral ring.
Oracle: an independent program with another film (Galerkin) and three integrators; closed forms of
a falling rod, of sinking, of levelling and of restitution; the balance of energy.
"""

import numpy as np
import pytest
from scenes import smooth_toy
from scipy.integrate import solve_ivp

from dynamics import Air, Disk, Outcome, simulate
from dynamics.film.tilted_film import TiltedFilm, film_below
from dynamics.landing.equations import LOSSES, LandingModel, LandingState
from dynamics.landing.lift_off import film_inclination_scale, predict_lift_off
from dynamics.landing.rim_friction import RimFriction
from dynamics.landing.solution import LandingEnd, solve_landing
from dynamics.landing.stop import stop_below
from dynamics.observables import precession_rate
from sonify import load_scene

DISK = Disk(radius=0.03755, thickness=0.0128, mass=0.4387)
COIN = Disk(radius=0.012875, thickness=0.0022, mass=0.0085)
AIR = 1.82e-5
RESTITUTION = 0.79


class Rotor(LandingModel):
    """A model with the inertia of a thick disk and the centre in its face."""

    @property
    def diametral_inertia(self):
        R, T = DIMENSIONS[self.disk.mass]
        return self.disk.mass * (R**2 / 4 + T**2 / 12)


DIMENSIONS = {disk.mass: (disk.radius, disk.thickness) for disk in (DISK, COIN)}


def model_of(disk=DISK, viscosity=AIR, stop_height=0.0, depth=0.0, stiffness=4e8):
    flat = Disk(radius=disk.radius, thickness=1e-9, mass=disk.mass)
    film = TiltedFilm(viscosity, disk.radius, depth=depth) if viscosity else None
    stop = stop_below(disk.radius, disk.mass, RESTITUTION, stop_height, stiffness)
    return Rotor(flat, film, stop)


def start(inclination, precession_rate, fall_rate, radius=DISK.radius, height=None):
    """Return the state of a disk whose low point touches at rest."""
    return LandingState(
        height=radius * inclination if height is None else height,
        axis_x=-inclination,
        axis_y=0.0,
        axis_z=np.sqrt(1 - inclination**2),
        rise=-radius * fall_rate,
        turn_x=fall_rate,
        turn_y=-inclination * precession_rate,
        turn_z=inclination * fall_rate,
        x=0.0,
        y=0.0,
        speed_x=0.0,
        speed_y=0.0,
        turned=0.0,
        axial_rate=0.0,
    )


class Solved:
    """A landing with the quantities of the reference."""

    def __init__(self, model, first, duration=0.6):
        self.model = model
        self.landing = solve_landing(model, first, duration)
        path = self.landing.path
        dense = np.linspace(0, min(0.02, path.x[-1]), 8001)
        self.t = np.unique(np.concatenate([dense, path.x]))
        states = path(self.t)
        self.states = states
        self.slope = np.hypot(states[:, 1], states[:, 2])
        self.height = states[:, 0]
        self.clearance = self.height - model.stop.radius * self.slope
        angle = np.unwrap(np.arctan2(-states[:, 2], -states[:, 1]))
        self.turns = angle / (2 * np.pi)
        energy = [model.energy(y) for y in states.tolist()]
        self.energy = np.array(energy)

    @property
    def extra_turns(self):
        """Turns until the inclination is 1 % of its value at the start."""
        return self.turns[np.argmax(self.slope < 0.01 * self.slope[0])]

    def time_below(self, inclination):
        """Time [ms] at which the inclination falls below a value [rad]."""
        return self.t[np.argmax(self.slope < inclination)] * 1e3

    @property
    def largest_clearance(self):
        """Largest clearance [um] and its time [ms]."""
        i = self.clearance.argmax()
        return self.clearance[i] * 1e6, self.t[i] * 1e3

    def touches(self):
        """Times [ms] and closing speeds [mm/s] of the touches after the first rise."""
        free = np.argmax(self.clearance > 1e-7)
        falls = np.flatnonzero(
            (self.clearance[free:-1] > 0) & (self.clearance[free + 1 :] <= 0)
        )
        falls = falls + free
        speed = -np.diff(self.clearance)[falls] / np.diff(self.t)[falls]
        return self.t[falls] * 1e3, speed * 1e3

    def closure(self):
        """Largest relative error of the energy balance."""
        lost = self.states[:, LOSSES].sum(axis=1)
        return np.max(np.abs((self.energy + lost) / self.energy[0] - 1))


@pytest.fixture(scope="module")
def reference():
    return Solved(model_of(), start(2.600e-3, 376, 0.363))


def test_the_disk_stops_within_a_fifth_of_a_turn_on_a_cushion(reference):
    assert reference.extra_turns == pytest.approx(0.1778, abs=0.002)
    clearance, time = reference.largest_clearance
    assert clearance == pytest.approx(28.75, rel=0.01)
    assert time == pytest.approx(9.14, rel=0.01)
    assert reference.time_below(1e-4) == pytest.approx(14.50, rel=0.01)
    assert reference.time_below(1e-5) == pytest.approx(50.1, rel=0.01)
    assert np.interp(0.01, reference.t, reference.height) == pytest.approx(
        35.54e-6, rel=0.01
    )
    assert reference.landing.end is LandingEnd.REST
    assert not len(reference.touches()[0])
    sunk = reference.t[-1] + reference.model.film.sink_time(
        reference.height[-1], 5e-6, DISK.weight
    )
    assert sunk == pytest.approx(0.786, rel=0.01)


def test_the_energy_of_a_slow_sinking_is_accounted_for():
    """The disk sinks by a fraction of a micrometre per second for minutes, while it glides and
    turns slowly: the absolute tolerances of the speeds decide."""
    film = film_below(DISK.radius, 0.0, Air())
    stop = stop_below(DISK.radius, DISK.mass, RESTITUTION)
    friction = RimFriction(0.3, (3.755e-6, 3.004e-5, 3.004e-4), ())
    model = LandingModel(DISK, film, stop, friction)
    first = start(1.463e-5, 0.0, 0.0)._replace(
        height=5.258e-7,
        rise=-1.398e-3,
        turn_x=0.02816,
        turn_y=0.03633,
        turn_z=1.463e-5 * 0.02816,
        speed_x=8.77e-4,
        speed_y=9.49e-4,
        axial_rate=-0.03312,
    )
    slow = Solved(model, first, duration=400.0)
    assert slow.landing.end is LandingEnd.TIME_LIMIT
    assert slow.closure() < 1e-4


def test_the_energy_of_the_landing_is_accounted_for(reference):
    assert reference.energy[0] == pytest.approx(548.3e-6, rel=1e-3)
    assert reference.closure() < 1e-7
    squeezing, swirling, striking, shearing, rubbing, resisting = (
        reference.states[-1, LOSSES] / reference.energy[0]
    )
    assert swirling == pytest.approx(0.205, rel=0.01)
    assert squeezing > 3 * swirling
    assert striking == 0
    assert shearing == rubbing == resisting == 0


def test_the_disk_levels_itself_as_it_sinks(reference):
    selected = (reference.t > 0.03) & (reference.t < 0.05)
    slope = np.polyfit(
        np.log(reference.height[selected]), np.log(reference.slope[selected]), 1
    )[0]
    assert slope == pytest.approx(4.52, rel=0.02)


@pytest.mark.parametrize(
    ("stop_height", "state", "turns", "clearance", "time", "level", "touch"),
    [
        (10e-6, (1.84e-3, 403, 0.281), 0.1753, 20.57, 7.75, 12.41, None),
        (20e-6, (1.27e-3, 414, 0.217), 0.1560, 12.13, 6.52, 10.52, (41.56, 0.1966)),
        (30e-6, (7.58e-4, 402, 0.155), 0.1242, 4.160, 4.74, 8.04, (12.44, 0.591)),
    ],
)
def test_asperities_hold_the_film_open(
    stop_height, state, turns, clearance, time, level, touch
):
    solved = Solved(model_of(stop_height=stop_height), start(*state))
    found = solved.largest_clearance
    assert found[0] == pytest.approx(clearance, rel=0.01)
    assert found[1] == pytest.approx(time, rel=0.01)
    assert solved.time_below(1e-4) == pytest.approx(level, rel=0.01)
    assert solved.landing.end is LandingEnd.REST
    assert solved.closure() < 2e-5
    if solved.slope[-1] < 0.01 * solved.slope[0]:
        assert solved.extra_turns == pytest.approx(turns, abs=0.002)
    if touch:
        times, speeds = solved.touches()
        assert times[0] == pytest.approx(touch[0], rel=0.005)
        assert speeds[0] == pytest.approx(touch[1], rel=0.01)


def test_a_disk_that_sinks_reaches_the_asperities_at_the_closed_time():
    solved = Solved(model_of(stop_height=10e-6), start(1.84e-3, 403, 0.281))
    film = solved.model.film
    gap = solved.height[-1] + 10e-6
    touch = solved.t[-1] + film.sink_time(gap, 10e-6, DISK.weight)
    assert touch == pytest.approx(0.1914, rel=0.005)
    assert film.sink_rate(10e-6, DISK.weight) == pytest.approx(0.0252e-3, rel=0.01)


def test_a_disk_that_falls_without_precession_does_not_strike():
    solved = Solved(model_of(), start(1e-3, 0.0, 0.0))
    clearance, time = solved.largest_clearance
    assert clearance == pytest.approx(11.46, rel=0.01)
    assert time == pytest.approx(59, rel=0.02)
    assert solved.time_below(1e-4) == pytest.approx(57.9, rel=0.01)
    far_rim = -(solved.states[:, 4] - DISK.radius * solved.states[:, 5])
    assert far_rim.max() * 1e3 == pytest.approx(3.58, rel=0.01)


@pytest.mark.parametrize(
    ("state", "disk", "changes", "turns", "clearance", "time", "level", "sunk"),
    [
        ((2.789469e-3, 391.200, 0.356466), DISK, {}, 0.2103, 29.00, 9.45, 14.73, 0.787),
        ((2.756246e-3, 378.717, 0.350937), DISK, {}, 0.2019, 29.17, 9.27, 14.47, None),
        (
            (2.118974e-3, 436.100, 0.303226),
            DISK,
            {"viscosity": AIR / 2},
            0.2087,
            22.17,
            8.11,
            10.72,
            0.391,
        ),
        ((6.82705e-3, 386.906, 1.051798), COIN, {}, 0.1899, 25.86, 8.06, 21.84, 0.560),
        (
            (8.12702e-4, 361.690, 0.122261),
            DISK,
            {"depth": 0.03755**2 / 2 * 8 * 1e-3 / 0.2286**2},
            0.228,
            12.43,
            8.8,
            6.97,
            None,
        ),
    ],
)
def test_the_states_at_which_shipped_scenes_lift_off_come_to_rest(
    state, disk, changes, turns, clearance, time, level, sunk
):
    solved = Solved(model_of(disk, **changes), start(*state, radius=disk.radius))
    found = solved.largest_clearance
    assert solved.extra_turns == pytest.approx(turns, abs=0.004)
    assert found[0] == pytest.approx(clearance, rel=0.01)
    assert found[1] == pytest.approx(time, rel=0.015)
    assert solved.time_below(1e-4) == pytest.approx(level, rel=0.01)
    assert solved.landing.end is LandingEnd.REST
    if sunk:
        rest = solved.model.film.sink_time(solved.height[-1], 5e-6, disk.weight)
        assert solved.t[-1] + rest == pytest.approx(sunk, rel=0.01)


def test_a_disk_falls_about_its_low_point_in_a_vacuum():
    model = model_of(viscosity=0, stiffness=4e11)
    solved = Solved(model, start(1e-3, 0.0, 0.0), 0.0033)
    far_rim = solved.height + DISK.radius * solved.slope
    falling = np.argmax(far_rim <= 0) or np.argmax(solved.slope < 2e-6)
    kappa = model.diametral_inertia / (DISK.mass * DISK.radius**2)
    speed = np.sqrt(8 * 9.81 * DISK.radius * 1e-3 / (1 + kappa))
    assert solved.t[falling] * 1e3 == pytest.approx(3.1054, rel=2e-3)
    rates = solved.states[falling - 1]
    assert -(rates[4] - DISK.radius * rates[5]) == pytest.approx(speed, rel=2e-3)
    assert solved.energy[0] == pytest.approx(161.6e-6, rel=1e-3)


def test_angular_momentum_turns_a_falling_disk_back():
    # kappa (beta^2 Omega)^2/(2 b^2) + g b/R is constant at the turning points b
    model = model_of(viscosity=0, stiffness=4e11)
    beta, rate, fall = 5.44e-4, 28.9, 0.400
    solved = Solved(model, start(beta, rate, fall), 0.002)
    smallest = solved.slope[: np.argmin(solved.slope) + 1].min()
    assert smallest == pytest.approx(6.274e-6, rel=0.01)


@pytest.mark.parametrize("restitution", [0.28, 0.46, 0.79, 1.0])
def test_a_level_disk_bounces_with_its_restitution(restitution):
    stop = stop_below(DISK.radius, DISK.mass, restitution)
    model = LandingModel(DISK, None, stop)
    first = start(1e-12, 0.0, 0.0, height=0.0)._replace(rise=-0.5)
    landing = solve_ivp(
        model.rates, (0, 1e-4), first, "LSODA", rtol=1e-9, atol=1e-12, dense_output=True
    )
    t = np.linspace(1e-5, 1e-4, 2001)
    height, speed = landing.sol(t)[[0, 4]]
    leaves = np.argmax(height > 0)
    assert speed[leaves] == pytest.approx(0.5 * restitution, rel=3e-3)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("stop_height", "expected"), [(1e-6, 2.50e-3), (10e-6, 1.84e-3), (20e-6, 1.27e-3)]
)
def test_a_disk_that_only_the_film_resists_lifts_off(stop_height, expected):
    model = model_of(stop_height=stop_height)
    beta = 1.25 * film_inclination_scale(DISK, AIR)
    rate = np.sqrt(DISK.weight * DISK.radius / (model.diametral_inertia * beta))
    first = start(beta, rate, 0.0)
    found = solve_ivp(model.rates, (0, 0.4), first, "LSODA", rtol=1e-8, atol=1e-11)
    slope = np.hypot(found.y[1], found.y[2])
    clearance = found.y[0] - DISK.radius * slope
    lifted = np.argmax(clearance > 1e-7)
    pressed = np.flatnonzero(clearance[:lifted] <= 0)[-1]
    assert slope[pressed] == pytest.approx(expected, rel=0.05)


def test_high_asperities_prevent_the_lift_off():
    prediction = predict_lift_off(DISK, Air(viscosity=AIR, pressure=1e9))
    assert prediction.inclination == pytest.approx(2.60e-3, rel=0.01)
    assert prediction.max_stop_height == pytest.approx(37e-6, rel=0.02)
    assert predict_lift_off(COIN, Air(viscosity=AIR)).max_stop_height == pytest.approx(
        33e-6, rel=0.02
    )
    assert prediction.happens(10e-6)
    assert not prediction.happens(40e-6)
    assert not prediction.happens(10e-6, rattle_inclination=3e-3)


@pytest.mark.parametrize(
    ("depth", "low", "high"), [(32e-6, 25e-6, 30e-6), (108e-6, 10e-6, 15e-6)]
)
def test_lower_asperities_prevent_the_lift_off_from_a_concave_table(depth, low, high):
    """Independent solutions lift off at the lower height and not at the higher one."""
    air = Air(viscosity=AIR, pressure=1e9)
    prediction = predict_lift_off(DISK, air, depth)
    assert low < prediction.max_stop_height < high


@pytest.mark.slow
@pytest.mark.parametrize(
    ("sag", "tolerance"), [(1e-4, 0.02), (3e-4, 0.06), (1e-3, 0.35)]
)
def test_a_concave_table_delays_the_lift_off_as_predicted(sag, tolerance):
    scene = load_scene("published").replace(
        "air.film=acts",
        "release={inclination_deg=1.2, omega=[0.0, 0.78363, 4.59772]}",
        "friction.arm_pivoting=0",
        f"surface.sag={sag}",
        "surface.diameter=0.2286",
    )
    rolling = simulate(scene).rolling
    assert rolling.rolling_outcome is Outcome.AIRBORNE
    depth = scene.surface.curvature * scene.disk.radius**2 / 2
    found = predict_lift_off(scene.disk, scene.air, depth)
    assert found.inclination == pytest.approx(rolling.state[-1, 1], rel=tolerance)
    plane = predict_lift_off(scene.disk, scene.air)
    assert rolling.state[-1, 1] < 0.95 * plane.inclination


@pytest.mark.slow
@pytest.mark.parametrize(
    ("order", "amplitude", "waves_are_first"),
    [(3, 5e-6, False), (3, 20e-6, True), (4, 8e-6, True)],
)
def test_high_waves_break_the_contact_before_the_film_lifts_the_disk(
    order, amplitude, waves_are_first
):
    scene = load_scene("wavy").replace(
        "air.film=acts", f"imperfection={{order={order}, amplitude={amplitude}}}"
    )
    rolling = simulate(scene).rolling
    found = predict_lift_off(scene.disk, scene.air)
    breaks = 1.05 * (order**2 - 1) * amplitude / scene.disk.radius
    assert (breaks > found.inclination) == waves_are_first
    assert bool(len(rolling.contact_losses)) == waves_are_first
    if waves_are_first:
        first = rolling.at(rolling.contact_losses[0].t)[0, 1]
        assert first == pytest.approx(breaks, rel=0.3)
    assert rolling.rolling_outcome is Outcome.AIRBORNE
    assert rolling.state[-1, 1] == pytest.approx(found.inclination, rel=0.15)


@pytest.mark.slow
@pytest.mark.parametrize(
    "scene",
    [
        load_scene("published").replace("air.film=acts"),
        load_scene("published").replace("air.film=acts", "air.viscosity=0.91e-5"),
        smooth_toy(),
        load_scene("coin-polished"),
    ],
    ids=["published", "half the viscosity", "toy", "coin-polished"],
)
def test_the_predicted_lift_off_is_that_of_the_solved_motion(scene):
    rolling = simulate(scene).rolling
    last = rolling.at(rolling.t[-1])
    found = predict_lift_off(scene.disk, scene.air)
    assert rolling.rolling_outcome is Outcome.AIRBORNE
    assert found.inclination == pytest.approx(last[0, 1], rel=0.1)
    rate = abs(precession_rate(last)[0])
    assert found.precession_rate == pytest.approx(rate, rel=0.1)
