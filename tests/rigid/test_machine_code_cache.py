"""Claim: cached machine code is never older than the sources from which it was compiled.

Source: dynamics/numba_kernels.py. Oracle: copies of sources with one changed line, and the
imports of all modules."""

import os
import re
from time import time

import pytest
from numba import config
from paths import ROOT

from dynamics import numba_kernels
from dynamics.numba_kernels import machine_code_folder, remove_unused_folders

SOURCES = (
    "dynamics/a.py",
    "dynamics/film/b.py",
    "sonify/sound/c.py",
    "sonify/hearing/d.py",
)


@pytest.fixture
def sources(tmp_path, monkeypatch):
    for name in SOURCES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("x = 1\n")
    module = tmp_path / "dynamics" / "numba_kernels.py"
    monkeypatch.setattr(numba_kernels, "__file__", str(module))
    return tmp_path


@pytest.mark.parametrize("changed", SOURCES)
def test_a_changed_source_has_another_folder(sources, changed):
    before = machine_code_folder(sources)
    assert machine_code_folder(sources) == before
    (sources / changed).write_text("x = 2\n")
    assert machine_code_folder(sources) != before


def test_a_renamed_source_has_another_folder(sources):
    before = machine_code_folder(sources)
    (sources / SOURCES[0]).rename(sources / "dynamics" / "renamed.py")
    assert machine_code_folder(sources) != before


def test_only_folders_of_other_versions_unused_for_a_month_are_removed(tmp_path):
    days = {"kernels-present": 40, "kernels-recent": 20, "kernels-old": 40, "other": 40}
    for name, age in days.items():
        (tmp_path / name).mkdir()
        when = time() - age * 86400
        os.utime(tmp_path / name, (when, when))
    remove_unused_folders(tmp_path / "kernels-present")
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {"kernels-present", "kernels-recent", "other"}


def test_every_compiled_function_is_cached_in_this_folder():
    assert config.CACHE_DIR.endswith(machine_code_folder(ROOT).name)
    compiled = []
    for package in ("dynamics", "modal", "sonify"):
        for file in (ROOT / package).rglob("*.py"):
            text = file.read_text("utf-8")
            name = file.relative_to(ROOT).as_posix()
            if re.search(r"^\s*from numba import .*\bnjit\b", text, re.MULTILINE):
                assert name == "dynamics/numba_kernels.py"
            if "from dynamics.numba_kernels import" in text:
                compiled.append(name)
    assert len(compiled) > 20
    folders = ("dynamics/", "sonify/sound/", "sonify/hearing/")
    assert [name for name in compiled if not name.startswith(folders)] == []
