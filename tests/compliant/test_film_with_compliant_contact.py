"""Claim: the air film acts on a disk with an elastic contact as on a rigid disk, and fitted
friction does not count the roughness twice.

Source: Reynolds' equation on the wedge (dynamics/film/wedge.py); the energy balance. Oracle: the
event-driven motion in the same air; the explicit formula for the power of the film; the same motion
on a smooth table.
"""

import numpy as np
import pytest

from dynamics import simulate
from dynamics.film.wedge import film_powers, film_under
from dynamics.motion import CAUSES
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
