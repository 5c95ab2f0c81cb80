"""Claim: a finding that does not apply to a scene is absent, and the answers follow from the
findings that are present.

Source: the claims themselves, which name a disk, a table, a decline or a tone. Oracle: the energy
balance of a motion, the exact zero of a lost contact, and the constants of the shipped scenes.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from made_findings import found as made
from scenes import smooth_toy

from dynamics import simulate
from sonify import load_scene
from sonify.claims import air, checks, literature, rigid_motion
from sonify.claims.landing import end_findings
from sonify.claims.reference_scenes import (
    is_paper_scene,
    is_toy_disk,
    is_toy_on_granite,
    may_lie_on_granite,
)
from sonify.claims.surface_summary import complete_answers, short_answers
from sonify.scene import shipped_scenes
from sonify.sweeps.required_stages import motion_findings

DRAFT = "numerics.accuracy=draft"


@pytest.fixture(scope="module")
def coin():
    """Return a coin that rattles, and the first 0.15 s of its motion."""
    scene = load_scene("coin").replace("numerics.time_limit=0.15")
    return scene, simulate(scene)


@pytest.fixture(scope="module")
def airborne():
    """Return a toy on a rigid table in air, and its motion until the air carries it."""
    scene = smooth_toy(DRAFT, "release.inclination_deg=2")
    return scene, simulate(scene).rolling


@pytest.fixture(scope="module")
def hoop():
    scene = load_scene("hoop").replace(DRAFT)
    return scene, simulate(scene)


def keys(findings):
    return {finding.key for finding in findings}


def test_a_rattling_coin_is_not_asked_for_rolling_or_a_frequency_of_its_force(coin):
    scene, motion = coin
    found = keys(motion_findings(scene, motion))
    assert found.isdisjoint(
        {
            "repeated_slips",
            "sliding_costs_more",
            "load_frequency_rises",
            "load_frequency_reached",
        }
    )
    assert {"contact_kept", "energy_falls"} <= found


def test_the_slip_of_a_rattling_coin_is_the_rest_of_its_energy(coin):
    """Oracle: the lost energy minus that of all other causes; it was 0 ± 0.25."""
    _, motion = coin
    start, end = motion.energy(motion.t[[0, -1]])
    others = {
        cause: lost[0]
        for cause, lost in motion.energy_lost(motion.t[-1:]).items()
        if cause != "slip"
    }
    found = literature.slip_is_the_loss(motion)
    rest = 1 - sum(others.values()) / (start - end)
    assert found.value == pytest.approx(rest, abs=1e-4)
    assert found.value > 0.05
    assert found.margin == 0


def test_a_contact_lost_to_the_air_ends_with_a_force_of_exactly_zero(airborne):
    scene, motion = airborne
    assert motion.rolling_outcome.name == "AIRBORNE"
    found = rigid_motion.contact_kept(motion)
    assert (found.value, found.verdict, found.measured) == (0.0, "no", "0")
    assert checks.pushing_contact(motion).passed
    assert "load_frequency_reached" not in keys(motion_findings(scene, motion))


def test_the_answer_to_what_ends_a_hoop_is_a_cause_without_any_air(hoop):
    """A hoop has no film, so the cause of its end was missing; it was "interrupted"."""
    scene, motion = hoop
    found = [*air.motion_findings(scene, motion), *end_findings(motion)]
    cause = next(one for one in found if one.key == "what_ends")
    lost = motion.energy_lost(motion.t[-1:])
    assert max(lost, key=lambda name: lost[name][0]) == cause.cause
    answer = complete_answers(found)["what ends the motion"]
    assert answer == f"friction of rolling and pivoting: {cause.value:.0%}"
    assert "friction_exponent" not in keys(found)


def test_the_final_tenth_begins_between_the_ends_of_pieces():
    """The energy falls evenly; in the last twentieth the film takes it, before it the moments."""
    motion = SimpleNamespace(
        t=np.array([0.0, 0.5, 1.0]),
        energy=lambda t: 1 - t,
        energy_lost=lambda t: {
            "moments": np.minimum(t, 0.95),
            "film": np.maximum(t - 0.95, 0.0),
        },
    )
    shares = air.final_loss_shares(motion)
    assert shares == pytest.approx({"moments": 0.5, "film": 0.5})


def test_a_motion_that_does_not_end_has_no_cause_of_its_end(hoop):
    scene, _ = hoop
    short = scene.replace("numerics.time_limit=0.5")
    found = end_findings(simulate(short))
    assert "what_ends" not in keys(found)
    answer = complete_answers(found)["what ends the motion"]
    assert answer == "not evaluated: the motion does not end in this run"


def test_a_table_that_takes_little_does_not_answer_what_ends_the_motion(airborne):
    _, motion = airborne
    holds_little = made("table_takes_little", 0.0)
    assert short_answers([holds_little]).keys() == set()
    cause = air.what_ends(motion)
    answer = short_answers([holds_little, cause])["what ends the motion"]
    assert answer == f"the film of air: {cause.value:.0%}"
    holds_much = made("table_takes_little", -1.0)
    answer = short_answers([holds_much, cause])["what ends the motion"]
    assert answer.startswith("the table, not solved")


@pytest.mark.parametrize("name", shipped_scenes())
def test_recorded_and_printed_numbers_refer_to_the_recorded_and_printed_scenes(name):
    """Granite has 60 GPa and 0.2; the toy is 75.1 mm wide, 12.8 mm thick and has 0.4387 kg, each
    within 2 %."""
    scene = load_scene(name)
    toy = (scene.disk.radius, scene.disk.thickness, scene.disk.mass)
    is_solid = scene.disk.shape == "solid"
    is_toy = is_solid and toy == pytest.approx((0.03755, 0.0128, 0.4387), rel=0.02)
    granite = (scene.contact.young, scene.contact.poisson) == (60e9, 0.2)
    assert is_paper_scene(scene) == (name == "published")
    assert is_toy_disk(scene.disk) == is_toy
    elastic = scene.contact.law == "elastic"
    assert is_toy_on_granite(scene) == (is_toy and granite and elastic)
    unknown = scene.contact.law == "rigid" and scene.surface.kind == "rigid"
    assert may_lie_on_granite(scene) == (unknown or granite)
