"""Claim: the air film acts on a disk with an elastic contact as on a rigid disk, and fitted
friction does not count the roughness twice.

Source: Reynolds' equation on the wedge (dynamics/film/wedge.py); the energy balance. Oracle: the
event-driven motion in the same air; the explicit formula for the power of the film; the same motion
on a smooth table.
"""

import numpy as np
import pytest

from dynamics import Disk, Outcome, simulate
from dynamics.compliant.compliant_motion import StoredMotion, end_over_film
from dynamics.compliant.stepping.model import CompliantModel
from dynamics.compliant.stepping.state_layout import STATE
from dynamics.film.wedge import film_powers, film_under
from dynamics.landing.lift_off import predict_lift_off
from dynamics.motion import CAUSES
from dynamics.stepping_core.end_reasons import EndReason
from modal import surface_modes
from sonify import load_scene
from sonify.claims.air import carried_by_air

LOW = (
    "release.inclination_deg=1.2",
    "release.omega=[0.0, 0.78363, 4.59772]",
    "friction.arm_pivoting=0",
)
FULL = "contact.law=elastic", "numerics.contact=full", "numerics.contact_rate=2e5"

STIFF = "contact.young=60e11", "material.young=195e11", "numerics.contact_rate=1.5e6"
"""Table and disk 100 times as stiff: the contact springs become about 20 times as stiff."""


@pytest.fixture(scope="module")
def carried():
    scene = load_scene("published").replace(
        "air.film=acts", "contact.fillet=1.6e-3", *LOW
    )
    return (
        simulate(scene).rolling,
        simulate(scene.replace(*FULL)).rolling,
        simulate(scene.replace(*FULL, *STIFF)).rolling,
    )


def test_the_air_carries_the_disk_when_it_carries_the_rigid_one(carried):
    """Creep makes the difference, which falls as the contact stiffens."""
    rigid, *elastic = carried
    assert {motion.rolling_outcome.name for motion in carried} == {"AIRBORNE"}
    off = [abs(motion.t[-1] / rigid.t[-1] - 1) for motion in elastic]
    assert off[0] < 0.03
    assert off[1] < 0.4 * off[0]
    assert [motion.state[-1, 1] for motion in elastic] == pytest.approx(
        [rigid.state[-1, 1]] * 2, rel=0.02
    )
    assert all(carried_by_air(motion, motion.film).holds for motion in elastic)


def test_the_film_takes_its_power(carried):
    _, motion, _ = carried
    t = np.linspace(0.01, 0.8 * motion.t[-1], 400)
    lost = motion.lost_by_cause(t)[:, CAUSES.index("film")]

    power = film_powers(
        motion.disk, film_under(motion.disk, load_scene("published").air), motion.at(t)
    ).sum(axis=0)
    work = np.sum((power[1:] + power[:-1]) / 2 * np.diff(t))
    assert lost[-1] - lost[0] == pytest.approx(work, rel=0.01)
    assert (np.diff(lost) >= 0).all()
    assert motion.energy(t) + motion.lost_by_cause(t).sum(axis=1) == pytest.approx(
        motion.energy([0.0])[0], rel=1e-9
    )


@pytest.mark.slow
def test_a_table_pressed_by_the_film_does_not_throw_the_disk(monkeypatch):
    """The light plate bends by a fifth of the gap, and the disk leaves it once, for good.

    The landing on a rigid table follows the flight over the bent one, which is solved until
    the disk is higher than it is tilted."""
    flown = []
    run = CompliantModel.run

    def kept(*args):
        for piece in run(*args):
            flown.append(piece)
            yield piece

    monkeypatch.setattr(CompliantModel, "run", kept)
    scene = load_scene("light-plate").replace("air.film=acts")
    motion = simulate(scene, surface_modes=surface_modes(scene))
    assert motion.rolling_outcome is Outcome.AIRBORNE
    assert motion.outcome is Outcome.AT_REST
    assert len(motion.rolling.contact_losses) == 0
    assert 0 <= motion.rolling.lift_off_speed < 1e-3
    predicted = predict_lift_off(scene.disk, scene.air).inclination
    assert motion.rolling.state[-1, 1] == pytest.approx(predicted, rel=0.05)
    landing = motion.landing
    clearance = landing.clearance(landing.t)
    tilt = motion.disk.radius * np.sin(landing.at(landing.t)[:, 1])
    assert clearance[np.argmax(clearance > tilt) :].min() > 10e-6

    t = np.concatenate([piece.t for piece in flown]) - motion.switch_time
    states = np.concatenate([piece.state for piece in flown])[t >= 0]
    t = t[t >= 0]
    assert 4e-3 < t[-1] < 6e-3
    assert states[-1, STATE.gap] > 0.95 * motion.disk.radius * np.hypot(
        *states[-1, STATE.axis : STATE.axis + 2]
    )
    assert landing.clearance(t) == pytest.approx(states[:, STATE.gap], abs=3.5e-6)
    angle = np.unwrap(np.arctan2(-states[:, STATE.axis], states[:, STATE.axis + 1])) / (
        2 * np.pi
    )
    turns = landing.at(t)[:, 0] / (2 * np.pi)
    assert turns - turns[0] == pytest.approx(angle - angle[0], abs=0.02)
    stored = states[:, STATE.table_mode_energy]
    soon = t < 2e-4
    assert stored[soon] == pytest.approx(stored[0], rel=0.03)


@pytest.mark.slow
@pytest.mark.parametrize("pressure", [101.325, 1013.25])
def test_squeezed_air_gives_no_more_than_it_holds(pressure):
    """The waves of a light table throw the disk; no loss decreases, and the energy balances."""
    mode = "{order=4, frequency=180.0, damping_ratio=0.02, modal_mass=M}"
    mode = f"surface={{kind='modes', action='motion', modes=[{mode}]}}"
    low = (
        "release.inclination_deg=2.0",
        "release.omega=[0.0, 1.011, 5.929]",
        "numerics.accuracy=draft",
    )
    scene = load_scene("light-plate").replace(
        mode.replace("M", "0.1"), *low, "air.film=acts", f"air.pressure={pressure}"
    )
    motion = simulate(scene, surface_modes=surface_modes(scene)).rolling
    first = motion.energy([0.0])[0]
    assert motion.largest_energy_gain_error() < 1e-12 * first
    assert (
        np.abs(
            motion.energy(motion.t) + motion.lost_by_cause(motion.t).sum(axis=1) - first
        ).max()
        < 1e-8 * first
    )


def test_fitted_friction_counts_roughness_once():
    """With a roughness of 0.1 um the contact dissipates one tenth of the power of contour friction.

    This loss is an addition to the friction or a part of it, as the scene requires.
    """
    short = (
        "numerics.time_limit=0.5",
        "air.film=none",
        "friction.arm_nutation=0",
        "friction.arm_pivoting=0",
    )
    scene = load_scene("granite").replace(
        *FULL, *short, "roughness.rms=1e-7", "friction.mu_static=5"
    )
    lost = {}
    for loss in ("own", "fitted"):
        motion = simulate(scene.replace(f"roughness.loss={loss}"))
        lost[loss] = dict(
            zip(CAUSES, motion.lost_by_cause(motion.t[-1:])[0], strict=True)
        )
    rough = {loss: causes["contact"] + causes["creep"] for loss, causes in lost.items()}
    assert rough["own"] > 0.05 * lost["own"]["moments"]
    assert lost["fitted"]["moments"] + rough["fitted"] == pytest.approx(
        lost["own"]["moments"], rel=0.01
    )


def test_a_hopping_disk_begins_its_landing_with_the_speed_of_its_low_point():
    """On a rough table, the rim leaves the table for the last time at millimetres per second."""
    scene = load_scene("published").replace(
        "air.film=acts", "contact.fillet=1.6e-3", *LOW, *FULL
    )
    rough = scene.replace("roughness.rms=5e-7", "contact.loss_factor=1e-3")
    motion = simulate(rough)
    speed = motion.rolling.lift_off_speed
    assert 1e-3 < speed < 1e-2
    soon = 2e-6
    risen = motion.landing.clearance([0.0, soon])
    assert np.diff(risen)[0] == pytest.approx(speed * soon, rel=0.05)


def test_a_disk_that_floats_down_at_the_table_ends_where_its_contact_is_lost_late():
    """The contact bears the weight for 10 rows, a tenth of it for 10 more; it is lost for a
    moment in row 3, when it still bears the weight, and in row 13."""
    disk = Disk(radius=0.04, thickness=0.01, mass=0.4)
    load = disk.weight * np.repeat([1.0, 0.1], 10)
    impulse = np.concatenate([[0.0], np.cumsum(1e-3 * load)])
    losses = np.array([[0.0031, 1e-5, 1e-9], [0.0131, 1e-5, 1e-9]])
    past = StoredMotion(1e-3, losses, impulse, np.zeros((21, 2)))
    flat = EndReason.LIES_FLAT
    assert end_over_film(disk, past, 20, flat) == (13, EndReason.IS_AIRBORNE)
    assert end_over_film(disk, past, 9, flat) == (9, flat)  # the contact bears it
    flown = past._replace(losses=np.array([[0.0131, 5e-3, 1e-6]]))
    assert end_over_film(disk, flown, 16, flat) == (13, EndReason.IS_AIRBORNE)
    limit = EndReason.CONTINUES  # the time limit ends a flight, too
    assert end_over_film(disk, flown, 16, limit) == (16, limit)
    never = past._replace(losses=losses[:1])
    assert end_over_film(disk, never, 20, flat) == (20, flat)
