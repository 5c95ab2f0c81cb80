"""Claim: each rung is the scene with replaced values that select its model, and the line of a run
names its rung and the predicted effect of higher ones.

Source: `sonify.ladder.rungs`, `sonify.ladder.stretches`, `sonify.plan.rungs`. Oracle: the plans that
`plan_motion` makes from the replaced values, and the predictions of the plan.
"""

import re

import pytest

from dynamics import plan_motion
from modal import surface_modes
from sonify.ladder.rungs import assignments, rungs_of
from sonify.ladder.stretches import WHOLE_MOTION, ladder_plan, plan_lines
from sonify.plan.motion import planned_scene
from sonify.plan.rungs import LEVELS, Rung, effects_of_higher_rungs, rung_line, rung_of
from sonify.scene import load_scene, shipped_scenes
from sonify.scene_errors import SceneError

PLATE = (
    "surface={kind='plate', radius=0.1143, thickness=0.006, young=70e9, poisson=0.22, "
    "density=2500.0, loss_factor=0.02, edge='free'}"
)


def planned(scene):
    """Return the plan of the motion of a scene with the modes of its table."""
    _, plan = planned_scene(scene)
    if plan.lacks_surface_modes:
        return plan.with_surface_modes(surface_modes(scene, 20e3))
    return plan


@pytest.mark.parametrize(
    "name", ["published", "granite", "coin", "light-plate", "hoop"]
)
def test_every_rung_is_the_model_of_its_name(name):
    scene = load_scene(name)
    found = rungs_of(scene)
    assert [one.rung.order for one in found.usable] == sorted(
        one.rung.order for one in found.usable
    )
    for one in found.usable:
        assert scene.replace(one.values) == one.scene
        assert rung_of(planned(one.scene)) == one.rung
    assert not next(one.values for one in found.usable if one.rung == found.own)
    named = {one.rung.level for one in [*found.usable, *found.inapplicable]}
    assert named == set(LEVELS)


def test_a_rough_contact_on_a_plate_has_both_couplings():
    scene = load_scene("granite").replace(PLATE)
    found = {one.rung.level: one for one in rungs_of(scene).usable}
    one_way, two_way = planned(found["one-way"].scene), planned(found["two-way"].scene)
    assert not one_way.filter_is_two_way
    assert two_way.filter_is_two_way


@pytest.mark.slow
@pytest.mark.parametrize("name", shipped_scenes())
def test_values_can_be_given_to_set(name):
    scene = load_scene(name)
    for one in rungs_of(scene).usable:
        text, _, removed = assignments(one.values).partition("without ")
        given = [part for part in text.replace("; ", "").split(" ") if part]
        again = scene.replace(
            *given, dict.fromkeys(filter(None, removed.split(", "))) or {}
        )
        assert again == one.scene


def test_the_film_acts_on_all_levels_if_there_is_air():
    films = [one.rung for one in rungs_of(load_scene("published")).usable]
    assert films[:2] == [Rung("rigid", False), Rung("rigid", True)]
    assert all(rung.film for rung in films[1:])
    ring = [one.rung for one in rungs_of(load_scene("hoop")).usable]
    assert ring[:2] == [Rung("rigid", False), Rung("rigid", True)]
    tube = load_scene("hoop").replace(
        {"disk.wall": None, "disk.density": None, "disk.mass": 0.05}
    )
    with pytest.raises(SceneError, match=r"disk\.wall"):
        rungs_of(tube)


def test_a_rung_over_the_limit_is_solved_over_a_stretch_with_all_others():
    scene = load_scene("glass-plate")
    found = ladder_plan(scene, rungs_of(scene), limit=120.0)
    assert [one.rung.rung.level for one in found.omitted] == ["moving-table"]
    stretches = list(dict.fromkeys(row.stretch for row in found.rows))
    assert stretches[0] == WHOLE_MOTION
    assert re.fullmatch(r"steady rolling from [\d.]+ degrees", stretches[1])
    late = [row.rung.rung for row in found.rows if row.stretch == stretches[1]]
    assert late == [one.rung for one in rungs_of(scene).usable]
    assert all(row.rung.seconds <= 120 for row in found.rows)


def test_no_stretch_can_make_the_start_of_the_program_faster():
    scene = load_scene("light-plate")
    found = ladder_plan(scene, rungs_of(scene), limit=1.0)
    assert not found.rows
    assert len(found.omitted) == len(rungs_of(scene).usable)
    lines = plan_lines(scene, limit=1.0)
    assert any("predicted 26 s, more than 1 s" in line for line in lines)


@pytest.mark.parametrize(
    ("name", "changes", "reason"),
    [
        ("published", (), "smooth table and edge have one contact"),
        (
            "granite",
            (),
            "one contact suffices: the curvature of the heights is 0.0028 ",
        ),
        ("granite", ("roughness.rms=1e-6",), ""),
        ("granite", ("roughness.rms=1e-4", "roughness.longest=0.01"), ""),
        ("coin", (), ""),
        ("wavy", (), ""),
    ],
)
def test_contacts_anywhere_on_the_rim_are_solved_where_one_contact_fails(
    name, changes, reason
):
    found = rungs_of(load_scene(name).replace(*changes))
    solved = [one.rung.level for one in found.usable]
    reasons = [one.reason for one in found.inapplicable if one.rung.level == "many"]
    assert ("many" in solved) == (not reason)
    assert [one.startswith(reason) for one in reasons] == [True] * bool(reason)


def test_an_endless_rung_stops_after_four_times_the_motion_of_the_scene():
    """Without roughness nothing stops the coin."""
    usable = rungs_of(load_scene("coin")).usable
    limits = {one.rung.level: one.scene.numerics.time_limit for one in usable}
    assert limits["many"] == 600.0
    assert limits["elastic"] < 20.0


def test_a_scene_that_cannot_be_solved_is_refused():
    with pytest.raises(SceneError, match="must be at least"):
        rungs_of(load_scene("published").replace("air.film=acts", "air.pressure=1e-3"))


@pytest.mark.parametrize(
    ("name", "changes", "line"),
    [
        (
            "granite",
            (),
            r"rough contact, one-way, air film; higher ones change no answer",
        ),
        (
            "coin",
            (),
            r"contacts anywhere on the rim, air film; higher ones change no answer",
        ),
        (
            "published",
            (),
            r"rigid contact, no film; higher ones change sound \(size unknown\), "
            r"end \(film from 5 s\)",
        ),
        (
            "granite",
            (PLATE, "surface.action=sound"),
            r"rough contact, one-way, air film; higher ones change sound \(table .*",
        ),
        (
            "granite",
            ("numerics.contact=filter", "roughness.rms=1e-6"),
            r"rough contact, one-way, air film; higher ones change contact \(.*",
        ),
        (
            "light-plate",
            ("surface.action=sound", "numerics.contact=filter"),
            r"smooth elastic contact, no film; higher ones change end "
            r"\(table last 3\.\d s; film from 0.00\d+ s\)",
        ),
    ],
)
def test_the_line_of_a_run_names_its_rung_and_what_a_higher_one_changes(
    name, changes, line
):
    scene = load_scene(name).replace(*changes)
    plan = plan_motion(scene)
    if scene.surface.kind == "plate":
        plan = plan.with_surface_modes(surface_modes(scene, 20e3))
    found = rung_line(plan, 100)
    assert re.fullmatch(f"model: {line}", found), found
    assert len(found) <= 100


def test_the_level_in_the_line_is_the_prediction_of_the_plan():
    scene = load_scene("granite").replace(PLATE)
    modes = surface_modes(scene, 20e3)
    predicted = plan_motion(scene, modes).rough_table.level_error
    alone = plan_motion(scene.replace("surface.action=sound"), modes)
    (sound,) = (one for one in effects_of_higher_rungs(alone) if one.answer == "sound")
    assert sound.size == f"table {-predicted:+.2g} dB"
