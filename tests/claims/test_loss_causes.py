"""Claim: each cause of a loss of contact has a finding of its own, which can be yes, no and
undecided, and the answer names the causes with their limits.

Source: sonify/claims/loss_causes.py. Oracle: motions with given inclinations and losses; a vibration
with a given rms; the criterion (n^2 - 1) amplitude/radius of waves.
"""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from dynamics.compliant.law.table_receptance import RIGID_TABLE
from dynamics.contact_losses import ContactLoss
from dynamics.motion import Outcome
from sonify import load_scene
from sonify.claims.loss_causes import (
    loss_cause_findings,
    unevenness_breaks_contact,
    vibration_opens_contact,
    wave_inclination,
)
from sonify.claims.surface_summary import loss_answer
from sonify.claims.two_way import table_breaks_contact

CAUSES = {
    "vibration_opens_contact",
    "table_breaks_contact",
    "unevenness_breaks_contact",
}


def motion_of(scene, first=0.5, last=3e-3, losses=(), **plan):
    """Return what the findings read of a motion whose inclination falls in 10 s."""
    state = np.zeros((2, 11))
    state[:, 1] = first, last

    def at(t):
        rows = np.zeros((len(t), 11))
        rows[:, 1] = np.interp(t, [0.0, 10.0], [first, last])
        return rows

    plan = {"scene": scene, "contact_receptance": RIGID_TABLE, **plan}
    return SimpleNamespace(
        t=np.array([0.0, 10.0]),
        state=state,
        at=at,
        contact_losses=losses,
        solves_contact=True,
        moves_table=False,
        parts=(),
        film=None,
        finding_groups=("air", "contact", "two-way"),
        rolling_outcome=Outcome.SETTLED,
        plan=SimpleNamespace(**plan),
    )


@pytest.mark.parametrize(
    ("amplitude", "verdict"), [(1e-6, "no"), (1.3e-5, "undecided"), (3e-5, "yes")]
)
def test_waves_break_the_contact_below_an_inclination(amplitude, verdict):
    scene = load_scene("wavy").replace(f"imperfection.amplitude={amplitude}")
    found = unevenness_breaks_contact(scene, motion_of(scene))
    slope = 8 * amplitude / scene.disk.radius
    assert wave_inclination(scene) == pytest.approx(1.05 * slope)
    assert found.value == pytest.approx(1.05 * slope / 3e-3)
    assert found.verdict == verdict
    assert found.margin > 0


@pytest.mark.parametrize(
    ("name", "rms", "verdict"),
    [
        ("granite", 3e-8, "no"),
        ("coin", 16e-6, "yes"),
        ("coin", 2.2e-7, "undecided"),
    ],
)
def test_roughness_alone_breaks_the_contact_where_it_curves_more_than_the_rim(
    name, rms, verdict
):
    scene = load_scene(name).replace(f"roughness.rms={rms}")
    found = unevenness_breaks_contact(scene, motion_of(scene))
    assert found.verdict == verdict
    assert found.value == found.details["roughness"]


@pytest.mark.parametrize(
    ("share", "verdict"), [(0.15, "no"), (0.34, "undecided"), (0.6, "yes")]
)
def test_a_predicted_vibration_breaks_the_contact_from_its_rms_on(
    share, verdict, monkeypatch
):
    scene = load_scene("granite")
    monkeypatch.setattr(
        "sonify.claims.loss_causes.greatest_force_rms",
        lambda *arguments: (share, 0.1 * share),
    )
    motion = motion_of(scene)
    motion.solves_contact = False
    found = vibration_opens_contact(scene, motion)
    assert (found.value, found.verdict) == (share, verdict)
    assert found.at_least == pytest.approx(0.35)


@pytest.mark.parametrize(
    ("of_both", "on_rigid_table", "of_disk", "of_table"),
    [(0.21, 0.53, 0.21, 0.0), (0.6, 0.2, 0.2, 0.32**0.5)],
)
def test_the_table_adds_vibration_or_takes_it_from_the_disk(
    of_both, on_rigid_table, of_disk, of_table, monkeypatch
):
    """0.21 and 0.53 are those of the mirror with an edge of 100 nm, by two methods."""
    scene = load_scene("toy")
    monkeypatch.setattr(
        "sonify.claims.loss_causes.receptance_under_roughness", lambda *arguments: None
    )
    predicted = []

    def greatest_force_rms(scene, motion, receptance):
        predicted.append(receptance)
        return on_rigid_table if receptance is RIGID_TABLE else of_both, 0.0

    monkeypatch.setattr(
        "sonify.claims.loss_causes.greatest_force_rms", greatest_force_rms
    )
    motion = motion_of(scene)
    motion.solves_contact = False
    motion.finding_groups = ("contact",)
    found = {one.key: one for one in loss_cause_findings(scene, motion)}
    assert found["vibration_opens_contact"].value == of_disk
    assert found["table_breaks_contact"].value == pytest.approx(of_table)
    assert predicted == [None, RIGID_TABLE], "each table once"


def test_a_solved_loss_below_the_inclination_of_the_waves_is_not_of_the_vibration():
    scene = load_scene("wavy")
    limit = wave_inclination(scene)
    above = motion_of(scene, 2e-2, 10 * limit, [ContactLoss(9.0, 0.01, 1e-6)])
    below = motion_of(scene, 2e-2, 3e-5, [ContactLoss(9.9995, 0.01, 1e-6)])
    assert vibration_opens_contact(scene, above).value == pytest.approx(1e-3)
    assert below.at([9.9995])[0, 1] < limit
    assert vibration_opens_contact(scene, below).verdict == "no"
    kept = motion_of(scene, 2e-2, 10 * limit)
    assert vibration_opens_contact(scene, kept).verdict == "no"
    two = [ContactLoss(9.0, 1.05e-3, 1e-6)]
    near = motion_of(scene, 2e-2, 10 * limit, two)
    assert vibration_opens_contact(scene, near).verdict == "undecided"


def test_a_table_that_may_not_act_is_undecided_and_one_that_need_not_act_is_not():
    scene = load_scene("coin-wood")
    for action, verdict in (("sound", "undecided"), ("auto", "no")):
        changed = scene.replace(f"surface.action={action}")
        motion = motion_of(changed)
        motion.finding_groups = ("air", "two-way")
        found = {one.key: one for one in loss_cause_findings(changed, motion)}
        assert found["table_breaks_contact"].verdict == verdict


def test_a_cause_that_a_scene_excludes_has_no_finding(scene):
    """A rigid contact on a plane rigid table; an elastic contact on a smooth one."""
    rigid = loss_cause_findings(scene, motion_of(scene))
    assert not CAUSES & {one.key for one in rigid}
    smooth = replace(load_scene("granite"), roughness=None)
    keys = {one.key for one in loss_cause_findings(smooth, motion_of(smooth))}
    assert keys & CAUSES == {"vibration_opens_contact"}


@pytest.mark.parametrize(
    ("outcome", "verdict"), [(Outcome.AIRBORNE, "yes"), (Outcome.AT_REST, "no")]
)
def test_air_breaks_the_contact_of_a_rattling_disk_that_it_finally_carries(
    outcome, verdict
):
    scene = load_scene("coin")
    motion = motion_of(scene)
    motion.film = "film"
    motion.finding_groups = ("rattling",)
    motion.rolling_outcome = outcome
    found = {one.key: one for one in loss_cause_findings(scene, motion)}
    assert found["carried_by_air"].verdict == verdict
    told = loss_answer({"carried_by_air": found["carried_by_air"]})
    lifts = {"yes": "lifts", "no": "does not lift"}[verdict]
    assert told.endswith(f"by the air (which {lifts} the disk)")


def test_the_answer_names_each_cause_with_its_limit():
    scene = load_scene("granite")
    motion = motion_of(scene)
    even = unevenness_breaks_contact(scene, motion)
    vibrates = replace(
        vibration_opens_contact(scene, motion),
        value=0.2,
        at_least=0.35,
        details={"force_rms": 0.2},
    )
    by_key = {one.key: one for one in (vibrates, even)}
    assert loss_answer(by_key) == (
        "no, not by vibration of the disk (it varies the force by 20% of the weight, limit 35%), nor by "
        f"unevenness ({even.value:.2g} times the critical curvature, limit 1)"
    )
    uneven = replace(even, value=97.0, margin=1.0)
    table = table_breaks_contact(motion)
    told = loss_answer({one.key: one for one in (vibrates, uneven, table)})
    assert told.startswith("yes, by unevenness (97 times the critical curvature")
    assert "vibration of the table (0 losses of contact, limit 1)" in told
    assert loss_answer({}) == ""
