"""Claim: the findings on the halt follow from the solved landing, and each can come out otherwise.

Source: Reynolds' equation under a falling disk; Newton's restitution at the asperities.
Oracle: an independent continuation of the published motion in air; films too thin to carry the
disk, for which the answers are known.
"""

import json
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from dynamics import Outcome, plan_motion, simulate
from dynamics.film.tilted_film import film_below
from dynamics.landing.after_rolling import landing_after
from dynamics.landing.equations import LandingModel
from dynamics.landing.landing_motion import TOUCH, solve_landing_motion
from dynamics.landing.stop import DEFAULT_STOP_HEIGHT, stop_below
from sonify import load_scene
from sonify.claims.air import what_ends
from sonify.claims.details import details_in_words
from sonify.claims.landing import (
    air_catches_disk,
    end_findings,
    ends_without_rolling,
    halt_is_abrupt,
    landing_findings,
    one_impact_ends_it,
)
from sonify.claims.surface_summary import complete_answers


@pytest.fixture(scope="module")
def scene():
    return load_scene("published").replace("air.film=acts")


@pytest.fixture(scope="module")
def motion(scene):
    return simulate(scene)


def test_the_published_disk_in_air_stops_within_a_fifth_of_a_turn(motion):
    _, abrupt, caught, impact = landing_findings(motion)
    assert motion.outcome is Outcome.AT_REST
    assert motion.rolling_outcome is Outcome.AIRBORNE
    assert abrupt.value == pytest.approx(0.21, abs=0.01)
    assert abrupt.details["milliseconds"] < 10
    assert caught.value == 0
    assert caught.details["clearance"] == pytest.approx(29.0, rel=0.02)
    assert (abrupt.verdict, caught.verdict, impact.verdict) == ("yes", "yes", "no")
    assert "um" in details_in_words(caught)


def test_the_hand_over_keeps_position_velocity_and_energy(motion):
    landing = motion.landing
    rolling = motion.rolling
    end = rolling.at(rolling.t[-1])[0]
    scale = np.maximum(np.abs(end), 1e-9)
    assert np.max(np.abs(landing.at(0.0)[0] - end) / scale) < 1e-12
    assert landing.energy(0.0)[0] == pytest.approx(
        rolling.energy(rolling.t[-1])[0], rel=1e-12
    )


def test_the_whole_motion_is_continuous_at_the_hand_over(motion):
    """Oracle: the two parts. The lift has a jump, because the landing drops the compressed air."""
    begin = motion.switch_time
    around = np.array([begin * (1 - 1e-12), begin])
    assert motion.t[0] == 0
    assert np.all(np.diff(motion.t) > 0)
    before, after = motion.at(around)
    assert after == pytest.approx(before, rel=1e-7, abs=1e-12)
    assert np.ptp(motion.energy(around)) < 1e-8 * motion.energy(begin)[0]
    gap, lift = motion.film_loads(around, motion.at(around))[:, :2].T
    height = DEFAULT_STOP_HEIGHT  # of the asperities, to whose tops the disk rolls
    assert gap[1] - gap[0] == pytest.approx(height, rel=0.01)
    assert lift[0] / lift[1] == pytest.approx(1.15, abs=0.05)
    assert motion.regime(around).tolist() == [
        motion.rolling.regime(around[:1])[0],
        "land",
    ]
    whole = motion.energy(motion.t) + motion.state[:, 10]
    assert np.ptp(whole) < 1e-10 * whole[0]


def test_the_equations_of_a_tilted_disk_conserve_its_energy():
    """Oracle: exact kinetic energy of a disk that spins and precesses at 0.04 rad, without loads."""
    disk = load_scene("published").disk
    model = LandingModel(disk, None, stop_below(disk.radius, disk.mass, 0.79))
    columns = np.zeros(11)
    columns[1] = 0.04
    columns[5:8] = 1.5, -2.0, 0.9
    flying = solve_landing_motion(model, columns, 0.0, "thrown", 0.02, clearance=1e-2)
    t = np.linspace(0, 0.02, 50)
    assert flying.force(t)[:, 2].max() == 0
    assert np.ptp(flying.energy(t)) < 1e-8 * flying.energy(0.0)[0]
    # the angular momentum in space of a free body is constant
    state = flying.at(t)
    precession, inclination = state[:, :2].T
    about = model.diametral_inertia, model.axial_inertia, model.diametral_inertia
    along = state[:, 5:8] * about
    upright = along[:, 1] * np.cos(inclination) + along[:, 2] * np.sin(inclination)
    level = along[:, 1] * np.sin(inclination) - along[:, 2] * np.cos(inclination)
    c, s = np.cos(precession), np.sin(precession)
    momentum = [along[:, 0] * c - level * s, along[:, 0] * s + level * c, upright]
    assert np.ptp(momentum, axis=1) == pytest.approx(
        0, abs=1e-6 * np.abs(momentum).max()
    )


COIN = (
    "disk={radius=0.01213, thickness=0.00175, mass=0.00567}",
    "material={young=130e9, poisson=0.34, loss_factor=1.2e-4}",
    "friction={mu_static=0.3, mu_dynamic=0.25, arm_rolling=6e-6, arm_pivoting=2e-5}",
    "numerics.accuracy=draft",
)
"""A coin on a hard table."""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("release", "film", "cause"),
    [
        ("{inclination_deg=2.0, omega=[-8.0,1.0,0.5]}", "acts", "film"),
        ("{inclination_deg=2.0, omega=[0.0,0.0,0.0]}", "none", "contact"),
    ],
)
def test_a_dropped_coin_has_an_answer_to_what_ends_it(release, film, cause):
    """It loses its energy after it has rolled; the energy lost by cause is known."""
    motion = simulate(
        load_scene("published").replace(*COIN, f"release={release}", f"air.film={film}")
    )
    assert motion.outcome is Outcome.AT_REST
    assert ends_without_rolling(motion)
    found = {one.key: one for one in landing_findings(motion)}
    assert found["what_ends"].cause == cause
    assert "one_impact_ends_it" in found
    answer = complete_answers(found.values())["what ends the motion"]
    assert f"{found['what_ends'].value:.0%}" in answer
    total = motion.energy(0.0)[0] - motion.energy(motion.t[-1])[0]
    lost = motion.energy_lost(motion.t[-1])
    assert max(lost, key=lambda name: lost[name][0]) == cause
    assert sum(lost.values())[0] == pytest.approx(total, rel=2e-5)


def test_a_disk_that_rolls_to_its_end_is_judged_as_it_rolls(motion):
    assert not ends_without_rolling(motion)
    (cause,) = end_findings(motion)
    assert cause.value == what_ends(motion.rolling).value


def test_the_events_lead_from_the_lift_off_to_rest(motion):
    events = motion.events
    kinds = [event.kind for event in events]
    assert kinds[0] == "lifted by the film"
    assert "rests on a cushion of air" in kinds
    assert TOUCH not in kinds
    assert events[0].t == motion.rolling.t[-1]
    assert all(a.t <= b.t for a, b in pairwise(events))
    json.dumps([event._asdict() for event in events])


def test_a_disk_that_rolls_to_the_end_does_not_land(scene):
    vacuum = scene.replace("air.film=none")
    rolling = simulate(vacuum)
    cause, impact = landing_findings(rolling)
    assert cause.key == "what_ends"
    assert impact.key == "one_impact_ends_it"
    assert impact.value == 0.0
    assert rolling.rolling is rolling


def dropped(scene, restitution, viscosity_factor=1e-12):
    """Return the landing of a nearly level disk dropped 20 um above the table."""
    disk = scene.disk
    film = film_below(disk.radius, 0.0, scene.air)
    film = film._replace(viscosity=film.viscosity * viscosity_factor)
    model = LandingModel(disk, film, stop_below(disk.radius, disk.mass, restitution))
    start = np.zeros(11)
    start[1] = 1e-10
    return solve_landing_motion(model, start, 0.0, "dropped", 0.5, clearance=20e-6)


def ended_by(landing):
    """Return what the finding reads of a motion: its landing."""
    return SimpleNamespace(landing=landing)


def test_a_motion_without_landing_is_judged_by_its_contact():
    """Bounces of 1 ms that lose 0.04 of 1 J each, of which 0.1 J is the final energy."""
    t = np.linspace(0.0, 2.5, 25_001)
    lost = 0.04 * np.minimum(np.floor(t / 0.1), 25.0)
    bouncing = SimpleNamespace(
        landing=None,
        contact_losses=[object()],
        t=t,
        energy=lambda times: 1.0 - np.interp(times, t, lost),
        energy_lost=lambda times: {"contact": np.interp(times, t, lost)},
    )
    found = one_impact_ends_it(bouncing)
    assert found.value == pytest.approx(0.4, rel=1e-3)
    assert found.verdict == "no"
    kept = SimpleNamespace(landing=None, contact_losses=[])
    assert one_impact_ends_it(kept).value == 0.0


@pytest.mark.slow
def test_a_thin_film_does_not_catch_the_disk(scene):
    caught = air_catches_disk(dropped(scene, 0.79))
    assert caught.value > 0
    assert caught.verdict == "no"
    assert air_catches_disk(dropped(scene, 0.79, 1.0)).verdict == "yes"


@pytest.mark.slow
def test_an_impact_can_end_the_motion(scene):
    # a level impact loses 1 - e^2 of the energy
    plastic = one_impact_ends_it(ended_by(dropped(scene, 0.1)))
    assert plastic.value == pytest.approx(0.99, abs=0.02)
    assert plastic.verdict == "yes"
    elastic = one_impact_ends_it(ended_by(dropped(scene, 0.95)))
    assert elastic.verdict == "no"


def test_a_disk_that_precesses_on_is_not_halted_abruptly(scene, motion):
    disk = scene.disk
    model = LandingModel(disk, None, stop_below(disk.radius, disk.mass, 0.79))
    start = motion.rolling.state[-1]
    turning = solve_landing_motion(model, start, 0.0, "vacuum", 0.05)
    assert halt_is_abrupt(turning).verdict == "no"


@pytest.mark.slow
def test_a_fall_in_a_vacuum_comes_to_rest_on_its_face():
    still = load_scene("published").replace(
        "release={inclination_deg=1, omega=[0, 0, 0.05]}"
    )
    motion = simulate(still)
    landing = landing_after(motion.rolling, plan_motion(still), restitution=0.28)
    assert landing.outcome is Outcome.AT_REST
    assert landing.events[-1].kind == "rests on the asperities"
    lost = sum(landing.energy_lost(landing.t_end).values())[0]
    glide = landing.energy(landing.t_end)[0]
    assert lost + glide == pytest.approx(landing.energy(0.0)[0], rel=1e-4)
