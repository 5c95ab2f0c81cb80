"""Claim: `sonify ladder` solves each rung once, in a process of its own, and writes table, page,
picture and scenes.

Source: `sonify.ladder.command` and `sonify.ladder.files`. Oracle: the rows of the table, answers of
`solve`, and the scenes of the rows.
"""

import json

import pytest
from click.testing import CliRunner
from refused_commands import assert_refused

from sonify import load_scene, solve
from sonify.__main__ import main
from sonify.claims.surface_summary import complete_answers
from sonify.ladder import command, rungs
from sonify.ladder.row import (
    QUESTION_BY_COLUMN,
    CpuLimitedStages,
    CpuLimitError,
    rung_row,
)
from sonify.plan.rungs import LEVELS, Rung
from sonify.scene_errors import InputError
from sonify.sweeps.store import read_table

SHORT = (
    "release.inclination_deg=0.3",
    "release.omega=[0.0,0.39134,2.29607]",
    "numerics.time_limit=0.3",
    "audio.sample_rate=8000",
)
ARGUMENTS = ["published", "--accuracy", "draft", "--set", *SHORT]


def called(*arguments):
    return CliRunner().invoke(main, ["ladder", *ARGUMENTS, *arguments])


@pytest.fixture(scope="module")
def two_rungs(tmp_path_factory):
    """Return the folder and the output of a ladder of two rungs."""
    folder = tmp_path_factory.mktemp("ladder")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            rungs, "candidates", lambda scene, own: [own, Rung("rigid", True)]
        )
        done = called("--out", str(folder))
        again_calls = []
        patch.setattr(command, "solve_isolated", lambda *task: again_calls.append(task))
        again = called("--out", str(folder))
    assert done.exit_code == 0, done.output
    assert again.exit_code == 0, again.output
    return folder, done, again, again_calls


def test_the_rows_have_the_answers_of_solve(two_rungs):
    folder, done, _, _ = two_rungs
    rows = read_table(folder / "runs.parquet")[0].to_pylist()
    assert [row["rung"] for row in rows] == ["rigid, no film", "rigid, air film"]
    scene = load_scene("published").replace(*SHORT)
    answers = complete_answers(solve(scene, "draft").findings)
    for name, question in QUESTION_BY_COLUMN.items():
        assert rows[0][f"answer_{name}"] == answers[question]
    assert all(0 < row["cpu_seconds"] < 600 for row in rows)
    assert rows[0]["model"] == rows[0]["rung"]
    lines = done.stdout.splitlines()
    assert lines[0] == "whole motion:"
    assert lines[-1] == str(folder / "ladder.md")


def test_a_second_call_solves_nothing(two_rungs):
    _, done, again, again_calls = two_rungs
    assert not again_calls
    assert again.stdout == done.stdout


def test_the_files_agree_with_the_table(two_rungs):
    folder = two_rungs[0]
    record = json.loads((folder / "ladder.json").read_text("utf-8"))
    (stretch,) = record["stretches"]
    assert stretch["top"] == "rigid, air film"
    assert record["own_rung"] == "rigid, no film"
    assert [row["rung"] for row in stretch["rows"]] == [
        "rigid, no film",
        "rigid, air film",
    ]
    text = (folder / "ladder.md").read_text("utf-8")
    for sentence in record["conclusions"]:
        assert sentence in text
    assert (folder / "ladder.png").read_bytes().startswith(b"\x89PNG")


def test_the_scene_of_a_row_reproduces_it(two_rungs):
    folder = two_rungs[0]
    files = sorted(path.name for path in (folder / "scenes").iterdir())
    assert files == ["01-rigid-no-film.json", "02-rigid-film.json"]
    own = load_scene(folder / "scenes" / files[0])
    given = load_scene("published").replace(*SHORT, "numerics.accuracy=draft")
    assert own == given
    assert load_scene(folder / "scenes" / files[1]) == given.replace("air.film=acts")


def test_another_scene_does_not_replace_the_table(two_rungs):
    folder = two_rungs[0]
    assert_refused(
        ["ladder", "published", "--out", str(folder)],
        f"{folder / 'runs.parquet'}: the table of another",
    )


def test_a_plan_solves_and_writes_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(command, "solve_isolated", None)
    told = called("--plan")
    assert told.exit_code == 0, told.output
    assert not list(tmp_path.iterdir())
    *lines, total = told.stdout.splitlines()
    assert "the scene itself" in lines[0]
    assert total.startswith("4 rows, about ")
    assert len(lines) == len(LEVELS) + 1


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        ("publishd", "publishd: no such scene"),
        ("disk.radius=-1", "disk.radius = -1"),
    ],
)
def test_a_bad_scene_gets_one_line(tmp_path, monkeypatch, scene, message):
    monkeypatch.chdir(tmp_path)
    given = ["published", "--set", scene] if "=" in scene else [scene]
    assert_refused(["ladder", *given], message)
    assert not list(tmp_path.iterdir())


def test_a_ladder_without_an_affordable_rung_is_refused(tmp_path):
    with pytest.raises(
        InputError, match=r"every rung .* more than 1 s, the fastest 4 s"
    ):
        command.ladder(load_scene("light-plate"), tmp_path / "x", limit=1.0)
    assert not list(tmp_path.iterdir())


def test_a_rung_that_fails_is_a_row_with_an_error():
    """The document is not a scene."""
    found = rung_row({"name": "x"}, limit=1e3)
    assert found["error"].startswith("SceneError: ")
    assert found["cpu_seconds"] > 0


def test_a_rung_stops_at_its_limit_of_cpu_time():
    with (
        pytest.raises(CpuLimitError, match=r"more than 0\.001 s of CPU time"),
        CpuLimitedStages(1e-3).stage("motion") as watch,
    ):
        watch(0.5)


@pytest.mark.slow
def test_the_ladder_of_granite(tmp_path):
    """The time steps with one contact confirm the filter of the rough contact. Without
    roughness another sound is heard."""
    told = CliRunner().invoke(main, ["ladder", "granite", "--out", str(tmp_path)])
    assert told.exit_code == 0, told.output
    (stretch,) = json.loads((tmp_path / "ladder.json").read_text("utf-8"))["stretches"]
    rows = {row["rung"]: row for row in stretch["rows"]}
    assert list(rows) == [
        "rigid, no film",
        "rigid, air film",
        "elastic, air film",
        "one-way, air film",
        "one-contact, air film",
    ]
    costs = [row["cpu_seconds"] for row in rows.values()]
    assert max(costs[:2]) < costs[4]
    assert stretch["top"] == "one-contact, air film"
    assert stretch["marked"] == "one-way, air film"
    for question in ("loss", "end"):
        assert rows["one-way, air film"]["answers"][question]["same_answer"]
    assert (
        rows["elastic, air film"]["answers"]["sound"]["class"]
        != (rows["one-way, air film"]["answers"]["sound"]["class"])
    )
