"""Claim: the command line keeps its contract: the exit status is 0, 1 or 2; an error gives one line
of explanation and writes no file.

Source: the table of commands in the README. Oracle: the files that exist afterwards; the output
streams.
"""

import errno
import json
import os
import pkgutil
import re
import subprocess
import sys
import tomllib
from contextlib import suppress
from pathlib import Path

import pytest
from click.testing import CliRunner
from paths import ROOT
from scene_faults import FAULTS

import sonify
from sonify.__main__ import main, start
from sonify.report.replaced import replaced_results
from sonify.runtime.files import atomic_write
from sonify.scene import load_scene
from sonify.scene_keys import SceneKey, keys, schema

PROGRESS_LINE = re.compile(r"takes about |\w+ for \d+ s; |[\w ]{20} [ \d]{4}\.\d\d s$")


def ask(*arguments):
    return CliRunner().invoke(main, arguments)


def one_line(result, status):
    """Return the only line of a failed command, besides progress and times of stages."""
    assert result.exit_code == status, result.output
    assert result.stdout == ""
    lines = [
        line for line in result.stderr.splitlines() if not PROGRESS_LINE.match(line)
    ]
    assert len(lines) == 1
    assert "Traceback" not in result.stderr
    return result.stderr


def test_scenes_are_listed_one_a_line():
    result = ask("scenes")
    assert result.exit_code == 0
    assert any(line.startswith("published ") for line in result.stdout.splitlines())


def test_help_gives_the_summary_of_every_command_in_full():
    """click shortens a long summary and appends an ellipsis."""
    told = ask("--help").stdout
    listed = " ".join(told.split("Commands:")[1].split())
    assert "..." not in listed
    assert max(map(len, told.splitlines())) <= 80
    for name, command in main.commands.items():
        summary = command.help.split("\n\n")[0]
        assert f"{name} {' '.join(summary.split())}" in listed


@pytest.mark.parametrize("name", main.commands)
def test_the_range_of_an_option_has_two_ends_or_one(name):
    """click prints the missing end of a range without ends as `None`."""
    told = ask(name, "--help").stdout
    assert "None" not in told
    assert not re.search(r"\[x\]", told)


def test_the_keys_of_a_scene_fit_the_width_of_a_terminal():
    width = 80
    pty = pytest.importorskip("pty", reason="no terminals of this kind on Windows")
    ours, theirs = pty.openpty()
    call = [sys.executable, "-m", "sonify", "scenes", "--keys"]
    environment = os.environ | {"COLUMNS": str(width)}
    with subprocess.Popen(
        call, cwd=ROOT, env=environment, stdout=theirs, stdin=subprocess.DEVNULL
    ):
        os.close(theirs)
        written = b""
        with suppress(OSError):  # the other end is closed
            while piece := os.read(ours, 4096):
                written += piece
    os.close(ours)
    lines = written.decode().splitlines()
    assert max(map(len, lines)) <= width
    names = [line.split()[0] for line in lines if not line.startswith(" ")]
    assert names == [key.name for key in keys()]
    words = " ".join(written.decode().split())
    assert all(key.meaning in words for key in keys())


RADIUS, DISTANCE = "disk.radius=0.03", "audio.distance=0.7"
SEVERAL = [
    (f"--set {RADIUS} {DISTANCE}", "published", [RADIUS, DISTANCE]),
    (f"toy --set {RADIUS} --set {DISTANCE}", "toy", [RADIUS, DISTANCE]),
    (f"--set name=x {RADIUS} toy --accuracy draft", "toy", ["name=x", RADIUS]),
    (
        f"--set=name=x {RADIUS} --set disk.mass=2 toy",
        "toy",
        ["name=x", RADIUS, "disk.mass=2"],
    ),
    ("--set name=x --out a=b toy", "toy", ["name=x"]),
    ("", "published", []),
]


@pytest.mark.parametrize(("arguments", "scene", "assignments"), SEVERAL)
def test_one_set_takes_several_assignments(arguments, scene, assignments):
    command = main.commands["run"]
    given = command.make_context("run", arguments.split()).params
    assert (given["scene"], list(given["assignments"])) == (scene, assignments)


def test_an_assignment_without_set_is_told_how_it_is_spelt(tmp_path):
    line = one_line(ask("run", RADIUS, "--out", str(tmp_path / "out")), 2)
    assert (
        line
        == f"sonify: scene = '{RADIUS}': not a scene; did you mean --set {RADIUS}?\n"
    )
    assert not (tmp_path / "out").exists()


def test_the_keys_of_a_scene_and_their_schema_are_printed():
    listed = ask("scenes", "--keys").stdout.splitlines()
    assert listed[0].split() == list(SceneKey._fields)
    assert len(listed) == 1 + len(keys())
    assert any(
        line.startswith("audio.listeners") and "at most 16" in line for line in listed
    )
    assert json.loads(ask("scenes", "--schema").stdout) == schema()


def test_the_command_has_a_version_and_a_name_of_its_own():
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))[
        "project"
    ]
    assert pkgutil.resolve_name(told["scripts"]["sonify"]) is start
    assert ask("--version").stdout.strip() == sonify.__version__
    assert f"version: {sonify.__version__}\n" in (ROOT / "CITATION.cff").read_text(
        encoding="utf-8"
    )


@pytest.mark.parametrize(
    ("assignment", "message"), FAULTS, ids=[fault[0] for fault in FAULTS]
)
def test_a_wrong_value_ends_with_2_and_writes_nothing(assignment, message, tmp_path):
    out = tmp_path / "out"
    assert message in one_line(
        ask("run", "published", "--out", str(out), "--set", assignment), 2
    )
    assert not out.exists()


@pytest.mark.parametrize("text", ["[disk\n", "x = nan", "\x00"])
def test_a_wrong_file_ends_with_2(text, tmp_path):
    path = tmp_path / "wrong.toml"
    path.write_text(text)
    one_line(ask("run", str(path), "--out", str(tmp_path / "out")), 2)
    assert not (tmp_path / "out").exists()


USAGE = [
    "run --accuracy best",
    "sing",
    "run --nonsense",
    "scenes x",
    "listen",
    "export modes",
    "serve --port x",
    "studio --port x",
]


@pytest.mark.parametrize("arguments", USAGE)
def test_wrong_usage_ends_with_2(arguments):
    assert one_line(ask(*arguments.split()), 2).startswith("sonify: ")


REMOVED = [
    (["run", "--animation"], "`sonify export motion --as gltf`"),
    (["fit", "--like", "fu-berlin", "disk.wav"], "`sonify listen`"),
    (["sweep", "--scheduler", "local", "friction"], "the cores of this machine"),
]


@pytest.mark.parametrize(("arguments", "replacement"), REMOVED)
def test_a_removed_option_names_its_replacement(arguments, replacement):
    message = one_line(ask(*arguments), 2)
    assert re.search(rf"{arguments[1]}( local)?: removed in 0.3; ", message)
    assert replacement in message


def test_a_chart_without_records_is_not_drawn_again_and_leaves_no_folder(tmp_path):
    refused = one_line(
        ask("chart", "sound", "--redraw", "--out", str(tmp_path / "a")), 2
    )
    assert "no records of the chart sound" in refused
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_written_ends_with_2_before_any_work(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(
        "sonify.plan.preflight.solve_planned_motion",
        lambda *_: pytest.fail("the motion was solved"),
    )
    (tmp_path / "file").write_text("")
    assert "cannot be written" in one_line(
        ask("run", "--out", str(tmp_path / "file" / "out")), 2
    )


@pytest.mark.parametrize(
    "assignment",
    [
        "disk.shape=shell",
        "support.height=0.02",
        "disk.thickness=10",
        'support.held=["axial"]',
    ],
)
def test_what_cannot_be_solved_ends_with_2_before_any_work(assignment, tmp_path):
    out = tmp_path / "out"
    assert assignment.split("=")[0] in one_line(
        ask("run", "--out", str(out), "--set", assignment), 2
    )
    assert not out.exists()


@pytest.mark.parametrize(("fault", "status"), [(errno.EISDIR, 2), (errno.ENOSPC, 1)])
def test_a_folder_in_place_of_a_file_and_a_full_disk_are_one_line(
    tmp_path, monkeypatch, fault, status
):
    def failed(*_, **__):
        raise OSError(fault, os.strerror(fault), "sound.wav")

    monkeypatch.setattr("sonify.plan.preflight.solve_planned_motion", failed)
    result = ask("run", "--out", str(tmp_path))
    assert result.exit_code == status
    line = f"sonify: sound.wav: {os.strerror(fault)}"
    assert result.stderr.splitlines()[-1] == line


def test_a_folder_called_like_a_scene_does_not_hide_it(tmp_path, monkeypatch):
    (tmp_path / "published").mkdir()
    monkeypatch.chdir(tmp_path)
    assert load_scene("published").name == "published"


def test_a_disk_of_too_many_modes_ends_with_2_and_says_how_many(tmp_path):
    out = tmp_path / "out"
    line = one_line(ask("run", "--out", str(out), "--set", "material.young=1e7"), 2)
    assert "modes below 20000 Hz, but at most 600" in line
    assert not out.exists()


@pytest.mark.slow
def test_a_patch_lost_in_round_off_ends_with_2_and_writes_nothing(tmp_path):
    hinged = [
        "--set",
        "support.half_angle_deg=0.01",
        "--set",
        'support.held=["tangential", "axial"]',
    ]
    out = tmp_path / "out"
    assert "support: the patch is too small" in one_line(
        ask("run", "--out", str(out), *hinged), 2
    )
    assert not out.exists()


def test_an_interrupted_rerun_leaves_no_record_of_sounds_it_replaced(
    tmp_path, monkeypatch
):
    def interrupted(*_):
        raise KeyboardInterrupt

    (tmp_path / "run.json").write_text("{}")
    monkeypatch.setattr("sonify.pipeline.write_listening_copy", interrupted)
    short = ("--accuracy", "draft", "--set", "numerics.time_limit=0.1")
    assert ask("run", "--out", str(tmp_path), *short).exit_code == 130
    assert list(tmp_path.iterdir()) == []


QUESTIONS = [
    "what do you hear",
    "does the pitch rise",
    "is contact lost",
    "what ends the motion",
]


@pytest.mark.slow
def test_a_run_ends_with_its_files_and_answers_and_tells_what_it_replaces(tmp_path):
    """The second run repeats the first; the third differs in its name and in one key."""
    short = (
        "--out",
        str(tmp_path),
        "--accuracy",
        "draft",
        "--set",
        "numerics.time_limit=0.1",
    )
    first = ask("run", "published", *short)
    again = ask("run", "published", *short)
    other = ask("run", "published", *short, "name=other", "friction.mu_static=0.6")
    for ran in (first, again, other):
        assert ran.exit_code == 0, ran.output
        sound, *lines, picture, page = ran.stdout.splitlines()
        names = ["sound.wav", "spectrogram.png", "report.html"]
        assert [sound, picture, page] == [str(tmp_path / name) for name in names]
        assert all((tmp_path / name).is_file() for name in names)
        answered = [line.split(": ", 1)[0] for line in lines if ": " in line]
        assert answered == [*QUESTIONS, "model"]
        assert lines[-1].endswith("findings in report.html")
    assert "will replace" not in first.stderr + again.stderr
    line = f"{tmp_path}: will replace the results of published (different: friction.mu_static)"
    assert other.stderr.splitlines()[0] == line


def test_a_run_tells_that_it_replaces_what_cannot_be_read(tmp_path):
    (tmp_path / "run.json").write_text("{}")
    told = replaced_results(load_scene("published"), tmp_path)
    assert told.startswith(
        f"{tmp_path}: will replace results of a run that cannot be read ("
    )
    assert replaced_results(load_scene("published"), tmp_path / "new") == ""


EMPTY = [
    "run --out",
    "listen x.wav --out",
    "export modes --as vtu --out",
    "map x --of y --out",
    "chart motion --out",
]
EMPTY += [
    "listen x.wav --scene",
    "sweep friction --scheduler",
    "map x --of y --x",
    "run",
    "serve",
]
EMPTY += [
    "studio",
    "serve --host",  # the socket would listen on every address
]


@pytest.mark.parametrize("command", EMPTY)
def test_an_empty_text_is_refused_in_one_line_and_not_taken_for_the_default(command):
    result = ask(*command.split(), "")
    assert (result.exit_code, result.stdout) == (2, "")
    assert re.fullmatch(
        r"sonify: (--\w+|scene|folder) = '': must not be empty\n", result.stderr
    )


@pytest.mark.parametrize("fault", [KeyboardInterrupt(), OSError(errno.ENOSPC, "full")])
def test_a_file_is_whole_or_as_it_was(tmp_path, fault):
    path = tmp_path / "file.txt"
    path.write_text("before")

    def write_half():
        with atomic_write(path) as temporary:
            temporary.write_text("half")
            raise fault

    with pytest.raises(type(fault)):
        write_half()
    assert path.read_text() == "before"
    assert [p.name for p in tmp_path.iterdir()] == ["file.txt"]


def test_no_command_writes_unasked_over_what_the_checkout_keeps():
    """Every default folder is outputs/<a name other than shown>."""
    if not (ROOT / ".git").exists():
        pytest.skip("not a checkout")
    asked = subprocess.run(
        ["git", "ls-files", "outputs"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    kept = {Path(name).parts[1] for name in asked.stdout.splitlines()}
    assert kept == {"README.md", "shown"}
