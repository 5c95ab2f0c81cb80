"""Claim: a verdict sweep tells where each claim holds, and on which range this depends.

Source: sonify/sweeps/verdict.py, sonify/sweeps/axes.py, sonify/claims/verdict.py. Oracles: made
tables with known answers; closed forms of the loss of contact; the edge from which
an independent program loses contact on the mirror.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from verdict_ranges import verdict_ranges

import sonify
from dynamics import plan_motion
from dynamics.scene_constants import scene_constants
from dynamics.steady_motion import steady_omega
from sonify import load_scene
from sonify.claims.provenance import registered_judges
from sonify.claims.shares import share_of
from sonify.claims.verdict import contact_breaks_before_end, simplest_scene
from sonify.plan.motion import planned_scene
from sonify.plan.preflight import motion_plan_with_table, solve_motion
from sonify.scene_errors import InputError
from sonify.sound.sources.contact import ContactFilter
from sonify.sweeps.run_row import row_of
from sonify.sweeps.store import read_table
from sonify.sweeps.sweep import load_sweep, shipped_sweeps
from sonify.sweeps.thresholds import MIN_DRAWS
from sonify.sweeps.verdict import (
    PAPER_CLAIM_NUMBERS,
    claim_head,
    verdict_conclusion,
    verdicts_of_sweep,
)

VERDICTS = [name for name in shipped_sweeps() if name.startswith("verdict-")]
KEY = "friction.arm_rolling"


def large_sweep():
    """Return a shipped sweep with 512 draws."""
    sweep = load_sweep("verdict-paper-vacuum")
    return replace(sweep, samples=replace(sweep.samples, n=512))


def made_table(sweep, holds):
    columns = {key: [] for axis in sweep.points.axes for key in axis.keys}
    for run in range(sweep.points.count):
        for key, value in sweep.columns(run).items():
            columns.setdefault(key, []).append(value)
    count = sweep.points.count
    made = {
        "run": list(range(count)),
        "error": [None] * count,
        "outcome": ["SETTLED"] * count,
    }
    made |= {"t_end": [1.0] * count, "contact_breaks_before_end_holds": holds(columns)}
    return pa.table(made | columns)


def test_the_conclusion_has_the_value_at_which_the_answer_changes():
    """Contact is lost where the rolling arm exceeds the middle of its range."""
    sweep = large_sweep()
    table = made_table(sweep, lambda columns: [arm > 3e-5 for arm in columns[KEY]])
    first, *_ = verdict_conclusion(table, sweep)
    assert f"yes above `{KEY}` = 3e-05 m (" in first
    assert "Yes in 0 of 102 draws at 1.5e-05 to 1.98e-05 m (0% to 4%)" in first
    assert "% of 512 draws" not in first  # the ranges are assumed


def test_a_share_of_all_draws_requires_a_source_of_every_range():
    sweep = large_sweep()
    assert KEY in sweep.assumed_axes
    known = replace(sweep, sources=dict.fromkeys(sweep.axes, "measured"))
    assert known.assumed_axes == []
    table = made_table(known, lambda columns: [arm > 3e-5 for arm in columns[KEY]])
    assert "; 50(4) % of 512 draws" in verdict_conclusion(table, known)[0]
    missing = replace(sweep, sources=dict.fromkeys(list(sweep.axes)[1:], "measured"))
    assert missing.assumed_axes == list(sweep.axes)[:1]


def test_equal_answers_are_one_word():
    sweep = large_sweep()
    table = made_table(sweep, lambda columns: [False] * sweep.points.count)
    assert "no in all 512 draws" in verdict_conclusion(table, sweep)[0]


def test_draws_without_an_answer_do_not_count():
    sweep = large_sweep()
    table = made_table(
        sweep, lambda columns: [None] * 100 + [True] * (sweep.points.count - 100)
    )
    found = verdicts_of_sweep(table, sweep)["contact_breaks_before_end"]
    assert (found.answer, found.share.draws) == ("yes", 412)


@pytest.mark.slow
@pytest.mark.parametrize("name", VERDICTS)
def test_the_shown_conclusion_is_that_of_the_table(name):
    folder = Path(sonify.__file__).parents[1] / "outputs/shown/sweeps" / name
    table, identity = read_table(folder / "runs.parquet")
    sweep = load_sweep(name)
    assert identity["axes"] == sweep.identity["axes"]
    assert identity["samples"] == sweep.identity["samples"]
    shown = (folder / "conclusion.md").read_text("utf-8").splitlines()
    assert verdict_conclusion(table, sweep) == shown


def test_every_finding_of_a_verdict_exists():
    assert PAPER_CLAIM_NUMBERS.keys() <= registered_judges().keys()
    heads = [claim_head(key) for key in PAPER_CLAIM_NUMBERS]
    assert heads[0] == "vibrations make the sound (1)"
    assert len(set(heads)) == len(heads)


@pytest.mark.parametrize(
    ("count", "words"),
    [
        (1, "1 of 512 draws (0.0% to 1.1%)"),
        (3, "1(1) % of 512 draws"),
        (509, "99(1) % of 512 draws"),
        (511, "511 of 512 draws (98.9% to 100.0%)"),
    ],
)
def test_a_share_of_nearly_all_is_not_rounded_to_all(count, words):
    assert str(share_of(np.arange(512) < count)) == words


@pytest.mark.slow
@pytest.mark.parametrize("name", VERDICTS)
def test_every_range_of_a_verdict_has_a_source(name):
    sweep = load_sweep(name)
    assert set(sweep.sources) == set(sweep.axes)
    assert sweep.samples.method == "sobol"
    assert sweep.samples.n >= MIN_DRAWS
    assert sweep.stages == ("verdict",)
    listed = {given.keys for given, users in verdict_ranges().items() if name in users}
    assert listed == set(sweep.axes)


def test_an_axis_without_effect_is_one_line():
    document = {
        "name": "none",
        "axes": {"roughness.rms": [1e-8, 2e-8]},
        "find": ["t_end"],
    }
    with pytest.raises(
        InputError, match=r"axes.roughness.rms: has no effect on the runs"
    ):
        load_sweep(document)


@pytest.mark.slow
def test_a_rough_or_wavy_table_breaks_the_contact_as_predicted():
    """Waves do at 1.05 (n^2 - 1) amplitude/radius; a vibration proportional to the heights does
    where its rms exceeds 0.3 of the weight.
    """
    sets = ["numerics.accuracy=draft", "imperfection={order=3, amplitude=2e-5}"]
    scene = load_scene("granite").replace(*sets)
    motion = solve_motion(plan_motion(simplest_scene(scene))).rolling
    found = contact_breaks_before_end(scene, motion)
    end = motion.state[-1, 1]
    assert found.details["wavy"] == pytest.approx(
        1.05 * 8 * 2e-5 / 0.03755 / end, rel=1e-9
    )
    assert found.holds
    assert found.details["rough"] == 0.0  # 0.03 um excite 0.22 of the weight
    rougher = contact_breaks_before_end(scene.replace("roughness.rms=1e-7"), motion)
    assert rougher.details["rough"] > 1.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "kept", "broken"),
    [("toy", 160e-9, 185e-9), ("glass-plate", 190e-9, 230e-9)],
)
def test_a_rough_edge_breaks_the_contact_by_the_force_on_the_yielding_table(
    name, kept, broken
):
    """The motion of a draw is smooth, and so is its plan; its sound has the same force. On the mirror,
    contact is lost from an edge of 170 nm on; on a rigid table from 57 nm on."""
    scene = load_scene(name).replace(
        "contact.fillet=1.6e-3",
        "air.film=none",
        "numerics.accuracy=draft",
        "numerics.time_limit=0.1",
        "release.inclination_deg=0.8",
        f"roughness={{rms=1e-9, rms_edge={kept}, loss='fitted'}}",
    )
    tilt = np.radians(0.8)
    omega = np.array(steady_omega(tilt, scene_constants(scene))) / scene.disk.time_unit
    scene = scene.replace(f"release.omega={omega.tolist()}")
    simple, plan = planned_scene(simplest_scene(scene))
    plan = motion_plan_with_table(simple, plan)
    motion = solve_motion(plan).rolling
    assert plan.scene.roughness is None
    yielding = ContactFilter.along(motion, scene, 96_000, 0.0)
    assert yielding.table_modes is plan.surface_modes is not None
    one_way = scene.replace("surface.action=sound")
    assert ContactFilter.along(motion, one_way, 96_000, 0.0).table_modes is None

    def rough(*changes):
        changed = scene.replace(*changes)
        return contact_breaks_before_end(changed, motion).details["rough"]

    assert rough() == 0.0
    assert rough(f"roughness.rms_edge={broken}") > 1.0
    assert rough("surface.action=sound") > 1.0
    assert rough("surface.action=sound", "roughness.rms_edge=30e-9") == 0.0


@pytest.mark.slow
def test_a_row_of_a_verdict_renders_no_sound():
    row = row_of(load_sweep("verdict-paper").scene_of(0), ("verdict",))
    assert row["error" if "error" in row else "outcome"] == "AIRBORNE"
    assert row["air_carries_disk_holds"]
    assert not any(name.startswith("seconds_sound") for name in row)
