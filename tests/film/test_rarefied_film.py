"""Claim: a rarefied film is reported, takes bounded time, and is refused where its law is invalid.

Source: Fukui & Kaneko (1990), J. Tribol. 112, 78: flow between parallel plates by Boltzmann's
equation; Maxwell's slip. Oracle: the ratio of their flow to slip flow; the mean free path of the
ideal gas, 0.66 mm at 10 Pa.
"""

import numpy as np
import pytest

from dynamics import Outcome, plan_motion, simulate
from dynamics.film.activation import (
    END_KNUDSEN_NUMBER,
    rarefied_inclination,
)
from sonify import SceneError
from sonify.plan.air import limits_of_film_law
from sonify.plan.preflight import check_solvable_scene


@pytest.fixture(scope="module")
def rare(scene):
    return scene.replace(
        "numerics.accuracy=draft", "air.film=auto", "air.pressure=10.0"
    )


def kinetic_flow(knudsen):
    """Flow between plates by kinetic theory, as fitted by Fukui & Kaneko.

    The argument of the fit is D = sqrt(pi)/(2 Kn), with the Knudsen number Kn of the gap.
    """
    D = np.sqrt(np.pi) / (2 * knudsen)
    if D >= 5:
        return D / 6 + 1.0162 + 1.0653 / D - 2.1354 / D**2
    if D >= 0.15:
        return 0.13852 * D + 1.25087 + 0.15653 / D - 0.00969 / D**2
    return -2.22919 * D + 2.10673 + 0.01653 / D - 0.0000694 / D**2


@pytest.mark.parametrize(
    ("knudsen", "more"), [(1 / 60, 1.01), (0.1, 1.09), (1.0, 1.49), (88.6, 3.42)]
)
def test_how_much_more_air_passes_than_slip_lets_through(knudsen, more):
    """The slip flow is D/6 (1 + 6 Kn); the plan quotes the ratio at gaps of 10 and 1 mean free
    paths, and at the end of a motion."""
    slip = np.sqrt(np.pi) / (2 * knudsen) / 6 * (1 + 6 * knudsen)
    assert kinetic_flow(knudsen) / slip == pytest.approx(more, abs=0.01)


def test_a_motion_in_thin_air_ends_where_no_law_of_its_film_is_known(rare):
    """In thinner gaps the closing film would stiffen without bound and the disk would never lie
    flat."""
    assert rare.air.mean_free_path == pytest.approx(0.66e-3, rel=0.01)
    motion = simulate(rare)
    gap = rare.disk.radius * np.sin(motion.state[-1, 1])
    assert motion.rolling_outcome is Outcome.SETTLED
    assert gap * END_KNUDSEN_NUMBER == pytest.approx(rare.air.mean_free_path, rel=1e-9)
    assert len(motion.t) < 50_000
    told = " ".join(limits_of_film_law(rare, motion))
    assert "6.6e-06 m" in told  # the gap at the end of the motion
    assert "less than 1 mean free paths of the air, 0.00066 m" in told


def test_in_air_of_one_atmosphere_the_end_is_as_before(scene):
    acts = scene.replace("air.film=acts")
    assert rarefied_inclination(acts.disk, acts.air, END_KNUDSEN_NUMBER) < 2e-8
    assert plan_motion(acts).final_inclination == max(
        acts.numerics.stopping_inclination(acts.disk),
        rarefied_inclination(acts.disk, acts.air, END_KNUDSEN_NUMBER),
    )
    still = plan_motion(scene.replace("air.film=none"))
    assert still.final_inclination == scene.numerics.stopping_inclination(scene.disk)


def test_molecules_that_fly_further_than_the_gap_are_no_film(rare):
    """The mean gap at release is 20 mm; the mean free path equals it at 10 Pa 0.66/20 = 0.33 Pa."""
    thin = rare.replace("air.pressure=0.3")
    found = plan_motion(thin).film_decision
    assert found.film is None
    assert "must be at least 0.326" in found.reason
    with pytest.raises(
        SceneError, match=r"air.pressure = 0.3: must be at least 0.326 for a film"
    ) as refused:
        check_solvable_scene(thin.replace("air.film=acts"), None)
    assert "\n" not in str(refused.value)
    denser = thin.replace("air.pressure=0.34", "air.film=acts")
    assert plan_motion(denser).film is not None
