"""Claim: the check of CPU seconds fails above 1.5 times the stated number, on any machine.

Source: `benchmarks.speed.run_seconds`. Oracle: invented times of a run and of the calibration.
"""

import json

import pytest

from benchmarks.speed import run_seconds

RECORD = {
    "versions": ["before", "now"],
    "commits": {"before": "at commit 1a2b3c4d", "now": "at commit 5e6f7a8b"},
    "runs": 5,
    "load": "0.1",
    "calibration": 0.5,
    "rows": {
        "published": {
            "before": {"cpu": 8.0, "wall": 5.0, "megabytes": 43.0},
            "now": {"cpu": 5.0, "wall": 4.0, "megabytes": 43.1},
        },
        "published: sound": {"before": {"cpu": 0.7}, "now": {"cpu": 0.65}},
    },
}


@pytest.mark.parametrize(
    ("cpu", "loop", "passes"),
    [(7.4, 0.5, True), (7.6, 0.5, False), (14.8, 1.0, True), (5.0, 0.3, False)],
)
def test_the_check_compares_in_units_of_the_calibration(
    tmp_path, monkeypatch, cpu, loop, passes
):
    record = tmp_path / "record.json"
    record.write_text(json.dumps(RECORD))
    used = run_seconds.Usage(cpu, cpu, "")
    monkeypatch.setattr(run_seconds, "RECORD", record)
    monkeypatch.setattr(run_seconds, "second_run", lambda *_: used)
    monkeypatch.setattr(run_seconds, "calibration_seconds", lambda: loop)
    assert run_seconds.check(3) is passes


def test_the_table_replaces_only_the_one_between_its_marks(tmp_path, monkeypatch):
    page = tmp_path / "page.md"
    first, last = run_seconds.TABLE_MARKS
    page.write_text(f"before\n{first}old\n{last}after\n", "utf-8")
    monkeypatch.setattr(run_seconds, "PAGE", page)
    monkeypatch.setattr(run_seconds, "RECORD", tmp_path / "record.json")
    run_seconds.write_record(RECORD)
    lines = page.read_text("utf-8").splitlines()
    assert (lines[0], lines[-1]) == ("before", "after")
    heads = "CPU seconds at commit 1a2b3c4d|CPU seconds at commit 5e6f7a8b"
    assert f"|run|{heads}|seconds|folder [MB]|" in lines
    assert "|published|8.00|5.00|4.0|43.1|" in lines
    assert "|published: sound|0.70|0.65|||" in lines
    assert "old" not in lines


def test_the_record_states_what_the_check_needs():
    record = json.loads(run_seconds.RECORD.read_text("utf-8"))
    now = record["rows"]["published"][record["versions"][-1]]
    assert now["cpu"] > 0
    assert record["calibration"] > 0
