"""Claim: a folder or a scene file whose name is not UTF-8 is written and read like any other.

Source: POSIX, where a name is a sequence of bytes; Python represents the others by surrogates, which
no encoder accepts. Oracle: the same command with a plain name.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from sonify.runtime.files import readable_text
from sonify.sound.wav import open_wav

NAME = os.fsdecode(b"caf\xe9")


@pytest.fixture
def folder(tmp_path):
    """Return a folder whose name is not UTF-8; skip where the system allows none."""
    made = tmp_path / NAME
    try:
        made.mkdir()
    except (OSError, UnicodeError):
        pytest.skip("the file system requires names in Unicode")
    return made


def test_a_text_shows_the_bytes_of_a_name():
    assert readable_text(f"{NAME}.wav") == "caf\\xe9.wav"
    for text in ("café", "録音", "plain\\xe9", ""):
        assert readable_text(text) == text


def test_a_sound_file_is_the_same_in_any_folder(folder, tmp_path):
    for place in (folder, tmp_path):
        with open_wav(place / "sound.wav", 8000, 1, "PCM_16", "WAV") as file:
            file.write(np.linspace(-1, 1, 100))
    written = (folder / "sound.wav").read_bytes()
    assert written == (tmp_path / "sound.wav").read_bytes()


@pytest.mark.slow
def test_commands_write_into_such_a_folder(folder, tmp_path):
    """The sound of a scene from such a file is that of the scene with a plain name."""
    brief = ["--accuracy", "draft", "--set", "numerics.time_limit=0.5"]
    scene = Path(__file__).parents[2] / "sonify" / "scenes" / "published.toml"
    (folder / f"{NAME}.toml").write_bytes(scene.read_bytes())
    (folder / "sweep.toml").write_text(
        'name = "two"\nscene = "published"\naccuracy = "draft"\n[axes]\n'
        '"numerics.time_limit" = [0.2, 0.3]\n'
    )
    inner = os.path.join(NAME, NAME)
    for arguments in (
        ["run", f"{inner}.toml", *brief, "--out", inner],
        ["run", "published", *brief, "--out", "plain"],
        ["export", "motion", inner, "--as", "parquet", "--out", f"{inner}.parquet"],
        ["export", "motion", inner, "--as", "gltf", "--out", f"{inner}.glb"],
        ["export", "modes", inner, "--as", "vtu", "--out", f"{inner}.vtu"],
        ["sweep", f"{NAME}/sweep.toml", "--processes", "1", "--out", f"{inner}-2"],
        ["map", f"{inner}-2/runs.parquet", "--of", "t_end"],
    ):
        command = [sys.executable, "-m", "sonify", *arguments]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True)
        assert done.returncode == 0, done.stderr
        if arguments[0] != "run":
            assert os.fsencode(NAME) in done.stdout
    for file in ("pressure.wav", "sound.wav", "modes.json"):
        found = (folder / NAME / file).read_bytes()
        assert found == (tmp_path / "plain" / file).read_bytes()
