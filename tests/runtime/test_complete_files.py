"""Claim: every run leaves only complete files, however it ends, and the next run removes the
remains of a killed one.

Source: the exit statuses in the README. Oracle: real processes that are terminated; the contents of
the folder afterwards.
"""

import errno
import gc
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from paths import ROOT

from dynamics.stepping_core.row_store import RowStore
from sonify.__main__ import main
from sonify.runtime.files import (
    TEMPORARY_PREFIX,
    OutputError,
    atomic_write,
    claimed_folder,
    create_folder,
)
from sonify.sound.pressure import ScratchFile

COMMAND = """
import signal, sys, time, click
for name in {"SIGINT", "SIGTERM", "SIGHUP"} & set(dir(signal)):  # who started the tests may have told them to ignore it
    signal.signal(getattr(signal, name), signal.default_int_handler if name == "SIGINT" else signal.SIG_DFL)
from sonify.__main__ import main
from sonify.runtime.files import atomic_write

@main.command()
def hang():
    with atomic_write(sys.argv[1]) as temporary:
        temporary.write_text("half")
        click.echo("writing")
        for _ in range(600):  # a signal just before a sleep is heeded after it
            time.sleep(0.1)

main(["hang"])
"""
"""A test command that signals interrupt while it writes."""
POSIX = pytest.mark.skipif(
    sys.platform == "win32", reason="Windows sends no such signals"
)


@pytest.fixture
def writer(tmp_path):
    """Start processes that write a file in tmp_path until they are stopped, and say so first."""
    started = []

    def start(name, code=COMMAND, told="writing"):
        call = [sys.executable, "-c", code, str(tmp_path / name)]
        started.append(
            subprocess.Popen(
                call,
                cwd=ROOT,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
            )
        )
        assert started[-1].stdout.readline() == f"{told}\n"
        return started[-1]

    yield start
    for process in started:
        process.kill()
        process.communicate()


def test_a_full_disk_names_the_file_for_which_it_has_no_room(tmp_path):
    """The error of a write lacks the file name; an error without a file keeps its message."""
    with (
        pytest.raises(OSError, match="No space") as raised,
        atomic_write(tmp_path / "report.html"),
    ):
        raise OSError(errno.ENOSPC, "No space left on device")
    assert raised.value.filename == str(tmp_path / "report.html")
    with (
        pytest.raises(OutputError, match=r"^in words$"),
        atomic_write(tmp_path / "report.html"),
    ):
        raise OutputError("in words")


def names(folder):
    return {path.name for path in folder.iterdir()}


def hidden(folder):
    return {name for name in names(folder) if name.startswith(TEMPORARY_PREFIX)}


@POSIX
@pytest.mark.parametrize(
    ("name", "status"), [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)]
)
def test_a_signal_that_ends_leaves_nothing_and_says_so(writer, tmp_path, name, status):
    process = writer("sound.wav")
    process.send_signal(getattr(signal, name))
    assert process.communicate(timeout=60)[1] == "sonify: interrupted\n"
    assert process.returncode == status
    assert names(tmp_path) == set()


def test_what_a_killed_run_left_goes_with_the_next_file_and_what_a_living_one_writes_stays(
    writer, tmp_path
):
    dead = writer("dead.wav")
    left = hidden(tmp_path)
    dead.kill()
    dead.wait()
    assert hidden(tmp_path) == left
    assert any(name.endswith(".wav") for name in left)
    living = writer("living.wav")
    owned = hidden(tmp_path)
    assert owned.isdisjoint(left)
    assert any(name.endswith(".wav") for name in owned)
    with (
        atomic_write(tmp_path / "one.txt") as first,
        atomic_write(tmp_path / "two.txt") as second,
    ):
        first.write_text("one")
        second.write_text("two")
    assert names(tmp_path) == owned | {"one.txt", "two.txt"}
    living.kill()
    living.wait()
    with atomic_write(tmp_path / "one.txt") as first:
        first.write_text("three")
    assert names(tmp_path) == {"one.txt", "two.txt"}


def test_a_folder_in_which_nothing_came_to_be_written_goes_with_those_made_for_it(
    tmp_path,
):
    with (
        pytest.raises(ValueError, match="refused"),
        claimed_folder(tmp_path / "outputs" / "runs" / "one"),
    ):
        raise ValueError("refused")
    assert names(tmp_path) == set()
    with claimed_folder(tmp_path / "outputs" / "runs" / "two") as folder:
        (folder.parent / "kept").touch()
    assert names(tmp_path / "outputs" / "runs") == {"kept"}


@pytest.mark.skipif(
    not Path("/proc/self").exists(),
    reason="a folder that is there and takes no file: Linux has one",
)
@pytest.mark.parametrize(
    "door", [atomic_write, lambda path: claimed_folder(Path(path).parent)]
)
def test_a_folder_in_which_no_file_can_be_made_is_one_line_and_no_endless_wait(door):
    with (
        pytest.raises(OutputError, match="/proc: cannot be written"),
        door("/proc/sound.wav"),
    ):
        pass


@pytest.mark.parametrize(
    "kind", [ScratchFile, lambda width: RowStore(np.zeros((0, width)))]
)
def test_rows_on_disk_close_their_file_when_nobody_can_ask_for_more(kind):
    """Existing views may remain; an open file would cause a warning in unrelated code."""
    rows = kind(2)
    file = rows._file
    rows.append(np.ones((3, 2), np.float32))
    seen = rows[:] if isinstance(rows, ScratchFile) else rows.rows()
    del rows
    gc.collect()
    assert file.closed
    assert (seen == 1).all()


def test_hidden_files_of_others_are_left_alone(tmp_path):
    for name in (".a.lock", ".a.wav", ".sonify", "b.lock"):
        (tmp_path / name).touch()
    before = names(tmp_path)
    with atomic_write(tmp_path / "new.txt") as temporary:
        temporary.touch()
    assert names(tmp_path) == before | {"new.txt"}


@pytest.mark.skipif(
    not hasattr(os, "umask") or sys.platform == "win32", reason="permissions of POSIX"
)
def test_a_file_may_be_read_by_whom_any_new_file_may(tmp_path):
    (tmp_path / "plain").touch()
    with atomic_write(tmp_path / "ours") as temporary:
        temporary.touch()
    assert (tmp_path / "ours").stat().st_mode == (tmp_path / "plain").stat().st_mode


@pytest.mark.parametrize("name", ["x" * 300, "x/" * 3000], ids=["name", "depth"])
def test_a_path_that_is_too_long_is_one_line(tmp_path, name):
    with pytest.raises(OutputError, match="cannot be written"):
        create_folder(tmp_path / name)
    for command in ("run", "listen"):
        asked = CliRunner().invoke(main, [command, str(tmp_path / name)])
        assert asked.exit_code == 2
        assert len(asked.stderr.splitlines()) == 1
    asked = CliRunner().invoke(main, ["run", "--out", str(tmp_path / name)])
    assert asked.exit_code == 2
    assert len(asked.stderr.splitlines()) == 1


@POSIX
@pytest.mark.parametrize(
    ("stream", "opened"),
    [("stdout", "pipe"), ("stderr", "pipe"), ("stdout", "openpty")],
)
def test_a_reader_who_leaves_early_changes_neither_the_files_nor_the_exit_status(
    tmp_path, stream, opened
):
    """Pipe or terminal closes before the first line; the file is complete, the command succeeds."""
    code = f"""
import sys, click
from sonify.__main__ import main
from sonify.runtime.files import atomic_write

@main.command()
def tell():
    for _ in range(3):
        click.echo("a line", file=sys.{stream})
    with atomic_write({str(tmp_path / "kept.txt")!r}) as temporary:
        temporary.write_text("whole")

main(["tell"])
"""
    reading, writing = getattr(os, opened)()
    os.close(reading)
    other = "stderr" if stream == "stdout" else "stdout"
    call = [sys.executable, "-c", code]
    done = subprocess.run(
        call,
        cwd=ROOT,
        text=True,
        check=False,
        **{stream: writing, other: subprocess.PIPE},
    )
    os.close(writing)
    assert (done.returncode, getattr(done, other)) == (0, "")
    assert (tmp_path / "kept.txt").read_text() == "whole"


@pytest.mark.skipif(
    not Path("/dev/full").exists(), reason="no device that is always full"
)
def test_results_that_a_full_disk_does_not_take_are_missed():
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "sonify", "scenes"],
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode == 1
    assert b"No space left on device" in done.stderr


@POSIX
def test_a_signal_waits_for_the_end_of_an_import_which_might_swallow_it(
    writer, tmp_path
):
    """Like some real modules, this one treats any exception as a missing dependency."""
    (tmp_path / "swallows.py").write_text(
        "import time\nprint('importing', flush=True)\ntry:\n    time.sleep(0.5)\nexcept "
        "BaseException:\n    pass\n"
    )
    code = COMMAND.replace(
        "with atomic_write(sys.argv[1])",
        "import swallows\n    with atomic_write(sys.argv[1])",
    )
    found = f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n"
    process = writer("x.wav", found + code, "importing")
    process.send_signal(signal.SIGTERM)
    assert process.communicate(timeout=60)[1] == "sonify: interrupted\n"
    assert process.returncode == 143
