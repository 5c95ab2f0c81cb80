"""Claim: a recording that cannot be read or fitted, whichever the reason, does not affect the others,
and is named; names that are not UTF-8 and faulty scenes are no exception.

Source: the promise of `sonify fit` and `sonify listen` for folders. Oracle: the same recordings alone;
the bytes of the file names; a law of bursts of known end.
"""

import csv
import json
import os
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import settling_sounds
import soundfile
from click.testing import CliRunner

from sonify import RecordingError, SceneError, listen, load_scene
from sonify.__main__ import main
from sonify.fitting import result
from sonify.fitting.parallel import in_worker_processes
from sonify.fitting.result import fit
from sonify.plan.preflight import known_resonances

RATE = settling_sounds.RATE
BAD_NAME = b"caf\xe9, 1 $x$ |"
"""File name in Latin-1, with signs that have a meaning in tables and formulas."""


def noise(path, seconds=2.0):
    samples = 0.1 * np.random.default_rng(0).standard_normal(int(seconds * RATE))
    soundfile.write(os.fspath(path), samples, RATE, "PCM_16", format="WAV")
    return path


def bursts(path, jitter=0.0):
    """Write bursts whose rate is 12 /s (8 s - t)^(-1/3), with a jitter of their times [s]."""
    random = np.random.default_rng(4)
    law = partial(
        settling_sounds.settling_phase, exponent=1 / 3, t_end=8.0, rate_at_1s=12.0
    )
    times = settling_sounds.times_of_phase(law, 1.0, 7.99, 0.0, random)
    times = times + jitter * random.standard_normal(len(times))
    sound = settling_sounds.clicks(
        times, np.ones(len(times)), 9.0, random, 0.004, False
    )
    samples = settling_sounds.with_noise(sound, 30, random)
    soundfile.write(os.fspath(path), samples, RATE, "PCM_16", format="FLAC")


def non_utf8_file(folder, content):
    """Write a file whose name is not UTF-8; skip where the system allows none."""
    path = os.path.join(os.fsencode(folder), BAD_NAME + b".wav")
    try:
        Path(os.fsdecode(path)).write_bytes(content)
    except (OSError, UnicodeError):
        pytest.skip("the file system requires names in Unicode")
    return Path(os.fsdecode(path))


def sonify(folder, *arguments):
    """Run the command line in a folder as a process and return it with its output as bytes."""
    return subprocess.run(
        [sys.executable, "-m", "sonify", *arguments], cwd=folder, capture_output=True
    )


@pytest.mark.slow
def test_listen_reads_a_folder_and_goes_on_after_a_fault(tmp_path):
    takes = tmp_path / "takes"
    takes.mkdir()
    content = noise(takes / "b.wav").read_bytes()
    bad = non_utf8_file(takes, content)
    soundfile.write(takes / "silent.wav", np.zeros(RATE), RATE)
    (takes / "New Recording 5.m4a").write_bytes(b"\0\0\0\x1cftypM4A " + bytes(50))
    done = sonify(tmp_path, "listen", "takes")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert [line for line in lines if line.startswith(b"takes/")] == [
        b"takes/b.wav:",
        b"takes/" + BAD_NAME + b".wav:",
    ]
    assert lines[-1] == b"outputs/listen/" + BAD_NAME
    said = done.stderr.decode().splitlines()
    assert said[0] == (
        "takes/New Recording 5.m4a: skipped; convert it first, e.g. ffmpeg -i "
        "'takes/New Recording 5.m4a' 'takes/New Recording 5.wav'"
    )
    assert "takes/silent.wav: silent" in said
    assert not any("Traceback" in line for line in said)
    folder = tmp_path / "outputs" / "listen" / os.fsdecode(BAD_NAME)
    told = json.loads((folder / "heard.json").read_text(encoding="utf-8"))
    assert os.fsencode(told["recording"]) == os.fsencode(bad.resolve())
    alone = sonify(tmp_path, "listen", bad, "--out", "alone").stdout.splitlines()
    assert alone[:-1] == lines[-len(alone) : -1]
    again = sonify(tmp_path, "listen", bad)
    assert again.stdout.splitlines()[-1] == lines[-1], "the folder of this recording"


def test_recordings_of_one_name_have_a_folder_each_in_out(tmp_path):
    for name in ("a/take.wav", "b/take.wav", "c/other.wav"):
        (tmp_path / name).parent.mkdir()
        noise(tmp_path / name)
    given = [str(tmp_path / name) for name in ("a", "b/take.wav", "c/other.wav")]
    out = tmp_path / "out"
    done = CliRunner().invoke(main, ["listen", *given, "--out", str(out)])
    assert done.exit_code == 0, done.output
    found = {path.parent.name for path in out.glob("*/heard.json")}
    assert found == {"take", "take-2", "other"}


@pytest.mark.slow
def test_nothing_to_analyse_is_an_error_of_one_line(tmp_path):
    noise(tmp_path / "a.wav", 0.1)
    noise(tmp_path / "b.wav", 0.1)
    for command in ("listen", "fit"):
        done = CliRunner().invoke(
            main, [command, str(tmp_path), "--out", str(tmp_path / "out")]
        )
        assert done.exit_code == 2
        assert done.stdout == ""
        assert "none of the" in done.stderr
        assert not (tmp_path / "out").exists()
    done = CliRunner().invoke(main, ["fit", str(tmp_path / "a.wav"), "absent.wav"])
    assert done.exit_code == 2
    assert done.stderr.splitlines() == [
        "sonify: absent.wav: not a readable sound file: No such file or directory"
    ]


@pytest.mark.slow
def test_a_failure_of_the_program_is_raised_and_not_called_an_input_error(
    tmp_path, monkeypatch
):
    """If other recordings can be fitted, it is named and the exit status is 1."""
    for name in ("a.wav", "b.wav"):
        noise(tmp_path / name)

    def fail(path, *task):
        raise ZeroDivisionError("made to fail")

    monkeypatch.setattr(result, "fit_one", fail)
    with pytest.raises(ZeroDivisionError, match="made to fail"):
        fit(tmp_path)
    named = result._not_fitted(tmp_path / "a.wav", ZeroDivisionError("made to fail"))
    assert named.reason == f"{tmp_path / 'a.wav'}: ZeroDivisionError: made to fail"
    assert not named.is_input_error
    outside = result._not_fitted(tmp_path / "a.wav", RecordingError("--from = 9"))
    assert outside.reason == f"{tmp_path / 'a.wav'}: --from = 9"
    assert outside.is_input_error


def square_or_exit(name, number):
    if number == 3:
        os._exit(3)
    return number**2


@pytest.mark.slow
def test_a_process_that_dies_costs_one_recording_only():
    tasks = [(f"take {number}", number) for number in range(8)]
    results = list(in_worker_processes(square_or_exit, tasks, 2))
    died = results.pop(3)
    assert isinstance(died, RecordingError)
    assert str(died).startswith("take 3: the fitting process ended")
    assert results == [number**2 for number in range(8) if number != 3]


FAULTY_SCENES = {
    "support.kind = 'patch': must be 'free' for disk.shape = 'shell'": [
        "disk.shape=shell",
        "disk.wall=0.01",
    ],
    "disk.shape = 'shell': elastic modes require disk.wall": [
        "disk.shape=shell",
        "support.kind=free",
    ],
    "support.height = 0.1 must not exceed disk.thickness": ["support.height=0.1"],
    "disk.thickness = 3 must not exceed 50 times": ["disk.thickness=3.0"],
    "the disk has at least about": ["material.young=1e3"],
    "surface: such a soft or large table": [
        "surface={kind='plate', radius=3.0, thickness=1e-4, young=7e10, poisson=0.2, density=2500.0}"
    ],
}
"""Changes of the scene `published` that make it unsolvable, and their messages."""


@pytest.mark.parametrize("message", FAULTY_SCENES)
def test_a_scene_that_cannot_be_solved_is_a_scene_error(message):
    scene = load_scene("published").replace(*FAULTY_SCENES[message])
    with pytest.raises(SceneError) as refused:
        known_resonances(scene)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("command", ["fit", "listen"])
def test_a_faulty_scene_is_one_line_as_with_run(tmp_path, command):
    import tomli_w

    message, changes = next(iter(FAULTY_SCENES.items()))
    scene = load_scene("published").replace(*changes)
    (tmp_path / "ring.toml").write_text(tomli_w.dumps(scene.document))
    take = noise(tmp_path / "take.wav")
    asked = [command, str(take), "--scene", str(tmp_path / "ring.toml")]
    done = CliRunner().invoke(main, [*asked, "--out", str(tmp_path / "out")])
    ran = CliRunner().invoke(main, ["run", asked[3], "--out", str(tmp_path / "out")])
    assert (done.exit_code, done.stdout) == (2, "")
    assert done.stderr == ran.stderr == f"sonify: {message}\n"
    assert not (tmp_path / "out").exists()


def test_python_reads_a_name_that_is_not_utf8(tmp_path):
    content = noise(tmp_path / "take.wav").read_bytes()
    bad = non_utf8_file(tmp_path, content)
    alone = listen(tmp_path / "take.wav")
    assert listen(bad).carriers == alone.carriers
    assert listen(str(bad)).duration == alone.duration


@pytest.mark.slow
def test_a_folder_is_fitted_though_some_of_its_files_fail(tmp_path):
    """One take has scattered rates, one an old name, one no disk; one cannot be read."""
    takes = tmp_path / "takes"
    takes.mkdir()
    bursts(takes / "steady.flac")
    content = (takes / "steady.flac").read_bytes()
    (takes / "steady.flac").unlink()
    bad = non_utf8_file(takes, content)
    bursts(takes / "jitter.flac", jitter=0.003)
    noise(takes / "noise.wav", 4.0)
    (takes / "New Recording 5.m4a").write_bytes(b"\0\0\0\x1cftypM4A " + bytes(50))
    done = sonify(tmp_path, "fit", "takes")
    assert done.returncode == 0, done.stderr
    assert b"Traceback" not in done.stderr
    assert b"takes/New Recording 5.m4a: skipped; convert it first" in done.stderr
    folder = Path(os.fsdecode(done.stdout.splitlines()[-1]))
    assert folder == Path("outputs/fit") / os.fsdecode(BAD_NAME)
    told = json.loads((tmp_path / folder / "fit.json").read_text(encoding="utf-8"))
    fitted, jitter = told["files"]
    assert os.fsencode(fitted["file"]) == b"takes/" + BAD_NAME + b".wav"
    assert os.fsencode(bad.name) == BAD_NAME + b".wav"
    assert jitter["file"] == "takes/jitter.flac"
    for one in (fitted, jitter):
        assert isinstance(one["explained"], bool)
        assert one["t_end"]["low"] < 8.0 < one["t_end"]["high"]
    assert [one["file"] for one in told["not_fitted"]] == ["takes/noise.wav"]
    assert "no disk" in told["not_fitted"][0]["reason"]
    assert told["skipped"][0].startswith("takes/New Recording 5.m4a: skipped")
    rows = list(csv.reader((tmp_path / folder / "fit.csv").open(encoding="utf-8")))
    assert [row[0] for row in rows[1:]] == [
        "caf\\xe9, 1 $x$ |.wav",
        "jitter.flac",
        "together",
    ]
    assert {len(row) for row in rows} == {12}
    page = (tmp_path / folder / "fit.md").read_text(encoding="utf-8")
    assert "not fitted: takes/noise.wav: no disk" in page
    assert r"| caf\xe9, 1 $x$ \|.wav |" in page
