"""Claim: the list of runs has the finished ones, newest first, and the level at the listener.

Source: sonify/studio/run_list.py. Oracle: records written by the test; the definition of the level.
"""

import json
import os

import pytest

from sonify.studio.run_list import (
    finished_runs,
    level_at_listener,
    shipped_run_entry,
)

CHECK = {
    "key": "energy",
    "text": "energy is conserved",
    "value": 1.0,
    "expected": 0.0,
    "tolerance": 0.1,
    "passed": True,
    "unit": "J",
    "source": "",
}
RECORD = {
    "scene": {"name": "published"},
    "outcome": {"sentence": "The disk rests."},
    "checks": [CHECK],
    "motion": {"end": 3.0},
    "sound": {"loudness_lufs": -20.0, "full_scale_pascal": 2.0},
}


def write(folder, record, age):
    folder.mkdir(parents=True)
    path = folder / "run.json"
    path.write_text(record if isinstance(record, str) else json.dumps(record), "utf-8")
    os.utime(path, (1e9 - age, 1e9 - age))


def test_finished_runs_are_listed_newest_first(tmp_path):
    write(tmp_path / "old", RECORD, 100)
    write(tmp_path / "deep/er/new", RECORD, 0)
    write(tmp_path / "too/deep/to/be/found", RECORD, 0)
    write(tmp_path / "broken", "{", 0)
    write(tmp_path / "foreign", {"scene": 1}, 0)
    runs = finished_runs(tmp_path)
    assert [run["place"] for run in runs] == ["deep/er/new", "old"]
    assert runs[0]["outcome"] == "The disk rests."
    assert (runs[0]["failed"], runs[0]["checks"], runs[0]["end"]) == ([], 1, 3.0)
    assert not (runs[0]["page"])
    assert not (runs[0]["is_shown"])
    assert not (runs[0]["picture"])


def test_a_run_whose_table_takes_more_power_than_the_disk_loses_is_marked():
    for verdict in ("yes", "no"):
        finding = {"key": "disk_supplies_table", "verdict": verdict}
        entry = shipped_run_entry(RECORD | {"findings": [finding]}, "")
        assert entry["excessive"] == (verdict == "no")
    assert not shipped_run_entry(RECORD, "")["excessive"]


def test_a_shipped_run_is_listed_without_files():
    """Its data can be shown, and it has length and level, so that a run can be compared with it."""
    entry = shipped_run_entry(RECORD, "")
    assert (entry["place"], entry["is_shown"], entry["page"]) == ("", True, False)
    assert (entry["end"], entry["level"]) == (3.0, pytest.approx(80.0))


def test_the_level_is_that_of_the_true_scale():
    """Full scale of 20 µPa makes the loudness the level; ten times as much adds 20 dB."""
    sound = {"loudness_lufs": -7.0, "full_scale_pascal": 2e-5}
    assert level_at_listener(sound) == pytest.approx(-7.0)
    assert level_at_listener(sound | {"full_scale_pascal": 2e-4}) == pytest.approx(13.0)
    assert level_at_listener({"loudness_lufs": None}) is None
    assert level_at_listener({}) is None
