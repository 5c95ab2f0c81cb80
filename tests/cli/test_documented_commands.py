"""Claim: every command on the pages runs as printed, and the files that it names exist afterwards.

Source: README.md and docs/*.md, in code blocks and within the text. Oracle: the exit status; the
files; the options that click declares. Recordings and earlier results are inputs that the tests
make. To save time, a run of a scene has the accuracy draft and ends after a second, a ladder is only
planned, a sweep has two values per axis or, with more than 300 runs, is only loaded, and a chart is
drawn from its stored records.
tests/slow/test_shipped_scenes.py runs the shipped scenes.
"""

import json
import re
import shlex
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from urllib.request import urlopen

import click
import pytest
import soundfile
from click.testing import CliRunner
from disk_recordings import recording
from paths import ROOT
from scenes import smooth_toy

from sonify import load_scene, shipped_scenes
from sonify.__main__ import main
from sonify.fitting.decay_model import DecayModel
from sonify.scene import scene_record
from sonify.sweeps.sweep import SHIPPED_SWEEPS_FOLDER, load_sweep, shipped_sweeps

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
PROGRAM = "python -m sonify "
QUICK = ("scenes", "export modes", "ladder")
"""Beginnings of the commands that take at most 3 s; servers are quick too."""
SERVERS = ("serve", "studio")
PLAIN_RUNS = tuple(f"run {name}" for name in shipped_scenes())
"""Runs of shipped scenes, which tests/slow/test_shipped_scenes.py repeats."""
MAX_SWEEP_RUNS = 300
"""Number of runs above which a shipped sweep is only loaded."""


def blocks_of_commands(text: str) -> list[tuple[str, ...]]:
    """Return the arguments of the commands of a page, one tuple for each block of code.

    A command within a sentence is a block of one line. A caption that begins with "Made by" names
    commands without their arguments, and `sonify run` names a command.
    """
    fence = re.compile(r"^```(.*?)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
    blocks = []
    for language, block in fence.findall(text):
        lines = [] if language else block.splitlines()
        blocks.append([line for line in lines if line.startswith(PROGRAM)])
    sentences = re.sub(r"Made by `.*", "", fence.sub("", text))
    for command in re.findall(rf"`({PROGRAM}[^`]+)`", sentences):
        blocks.append([command])
    return [
        tuple(line.removeprefix(PROGRAM) for line in block) for block in blocks if block
    ]


def all_blocks() -> list[tuple[str, ...]]:
    """Return the blocks of all pages; a command that stands alone is listed only if no longer block
    contains it."""
    found = []
    for page in PAGES:
        found += blocks_of_commands(page.read_text("utf-8"))
    several = {line for block in found for line in block if len(block) > 1}
    unique = dict.fromkeys(
        block for block in found if len(block) > 1 or block[0] not in several
    )
    return [block for block in unique if "NAME" not in " ".join(block)]


BLOCKS = all_blocks()


def is_quick(block: tuple[str, ...]) -> bool:
    """Return True if all commands of a block are quick."""
    return all(line.startswith(QUICK) or line in PLAIN_RUNS for line in block)


def is_server(block: tuple[str, ...]) -> bool:
    """Return True if a block starts a server."""
    return block[0].split()[0] in SERVERS


def cases():
    """Return the blocks that end by themselves as parameters, the long ones marked as slow."""
    return [
        pytest.param(
            block,
            id="; ".join(block),
            marks=() if is_quick(block) else pytest.mark.slow,
        )
        for block in BLOCKS
        if not is_server(block)
    ]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Return a working folder with the inputs that the pages assume."""
    earlier = tmp_path / "outputs" / "published"
    earlier.mkdir(parents=True)
    record = {"scene": scene_record(load_scene("published"))}
    (earlier / "run.json").write_text(json.dumps(record), "utf-8")
    (document,) = re.findall(
        r"```toml\n(.*?)```",
        (ROOT / "docs" / "how_to.md").read_text("utf-8"),
        re.DOTALL,
    )
    (tmp_path / "arms.toml").write_text(few_values(document), "utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def few_values(sweep: str) -> str:
    """Return the document of a sweep with two values per numeric axis."""
    assert re.search(r"n = \d+", sweep)
    return re.sub(r"n = \d+", "n = 2", sweep)


def write_recording(path: Path) -> None:
    """Write a take of the toy that rolling friction alone slows."""
    decay = DecayModel(smooth_toy())
    samples = recording(
        decay, [1e-4, 0.0, 0.0], noise=0.1, rate=16000, end=8.0, duration=9.0
    )
    soundfile.write(path, samples, 16000)


def shortened(arguments: list[str], folder: Path) -> list[str]:
    """Return the arguments with less work, as the top of this file states; empty if nothing is left
    to run."""
    command, *rest = arguments
    if shlex.join(arguments) in PLAIN_RUNS:
        return []
    if command == "run" and rest:
        return [*arguments, "--accuracy", "draft", "--set", "numerics.time_limit=1.0"]
    if command == "ladder":
        return [command, rest[0], "--plan"]
    if command == "chart":
        records = folder / "outputs" / "charts"
        shutil.copytree(ROOT / "outputs" / "shown" / "charts", records)
        return [*arguments, "--redraw"]
    if command == "sweep" and rest[0] in shipped_sweeps():
        if load_sweep(rest[0]).points.count > MAX_SWEEP_RUNS:
            return []
        few = folder / f"{rest[0]}.toml"
        shipped = SHIPPED_SWEEPS_FOLDER / few.name
        few.write_text(few_values(shipped.read_text("utf-8")), "utf-8")
        return [command, str(few), *rest[1:]]
    return arguments


@pytest.mark.parametrize("block", cases())
def test_the_commands_of_a_block_run_one_after_the_other(block, folder):
    if any("recording.wav" in line for line in block):
        write_recording(folder / "recording.wav")
    for line in block:
        command, _, redirected = line.partition(" > ")
        arguments = shortened(shlex.split(command), folder)
        if not arguments:
            continue
        ended = CliRunner().invoke(main, arguments)
        assert ended.exit_code == 0, f"{line}\n{ended.output}\n{ended.exception!r}"
        assert ended.stdout.strip()
        written = re.findall(r"^\S+/\S+\.\w+$", ended.stdout, re.MULTILINE)
        assert [path for path in written if not Path(path).is_file()] == []
        if redirected:
            Path(redirected).write_text(ended.stdout, "utf-8")
    for line in block:
        if line.endswith(".json"):
            assert json.loads((folder / line.split()[-1]).read_text("utf-8"))


@pytest.mark.slow
@pytest.mark.parametrize(
    "line", [block[0] for block in BLOCKS if is_server(block)], ids=str
)
def test_a_server_answers_and_stops_at_an_interrupt(line, folder):
    server = subprocess.Popen(
        [sys.executable, "-m", "sonify", *shlex.split(line), "--port", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        address = server.stdout.readline().split()[0]
        with urlopen(address, timeout=30) as answer:
            assert "<html" in answer.read().decode()
        server.send_signal(signal.SIGINT)
        assert server.wait(timeout=30) in (0, 130)
        assert "Traceback" not in server.stderr.read()
    finally:
        server.kill()
        server.communicate()


def options_of(words: list[str]) -> list[str]:
    """Return the options among words that the command, the first word, does not declare."""
    command = main.commands[words[0]]
    declared = {name for one in command.params for name in one.opts}
    given = [word.partition("=")[0] for word in words if word.startswith("--")]
    return [option for option in given if option not in declared]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_option_within_the_text_exists(page):
    """A fragment such as `run --ensemble` names a command and its options."""
    names = "|".join(main.commands)
    text = page.read_text("utf-8")
    fragments = re.findall(rf"`(?:(?:python -m )?sonify )?((?:{names}) [^`]*)`", text)
    for fragment in fragments:
        assert options_of(fragment.split()) == [], fragment


@pytest.mark.parametrize("block", BLOCKS, ids="; ".join)
def test_every_command_is_spelt_as_click_expects(block):
    for line in block:
        name, *arguments = shlex.split(line.partition(" > ")[0])
        with main.commands[name].make_context(name, arguments) as context:
            assert isinstance(context, click.Context)


def test_the_pages_are_read_as_a_reader_reads_them():
    """The commands of the table of the README, of a block, and of a sentence are found; a wrong one
    would be."""
    lines = {line for block in BLOCKS for line in block}
    assert {"run glass", "studio", "fit recording.wav", "run coin"} <= lines
    assert any(line.startswith("run --set 'audio.listeners=") for line in lines)
    assert "scenes --schema > scene.json" in lines
    assert next(block[:2] for block in BLOCKS if block[0].startswith("sweep arms")) == (
        "sweep arms.toml --plan",
        "sweep arms.toml",
    )
    text = "|try|`python -m sonify rum`|\n```\npython -m sonify scenes\n```\n"
    assert blocks_of_commands(text) == [("scenes",), ("rum",)]
    assert options_of(["run", "--sett", "a=1", "--out=x"]) == ["--sett"]
