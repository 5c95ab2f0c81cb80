"""Claim: the accuracy levels are points on a curve of audible error against computing time.

tests/plan/test_plan.py compares the errors with those that the plan predicts.

Source: benchmarks/charts/end_to_end_chart.py. Oracle: the rendering at accuracy "reference".
"""

import csv

import pytest
from click.testing import CliRunner

from benchmarks.charts.end_to_end_chart import (
    ACCURACY,
    CHOICE,
)
from sonify.__main__ import main


@pytest.fixture(scope="module")
def records(tmp_path_factory):
    folder = tmp_path_factory.mktemp("charts")
    done = CliRunner().invoke(
        main, ["chart", "end-to-end", "--quick", "--out", str(folder)]
    )
    assert done.exit_code == 0, done.output
    assert (folder / "end_to_end.png").stat().st_size > 10_000
    assert "predicted" in (folder / "end_to_end.md").read_text("utf-8")
    with (folder / "end_to_end.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def errors(records, family, case):
    return {
        r["method"]: float(r["error"])
        for r in records
        if r["family"] == family and r["case"] == case
    }


@pytest.mark.parametrize("support", ["held", "free"])
def test_the_reference_agrees_with_itself_and_nothing_else_does(records, support):
    found = errors(records, ACCURACY, f"{support}: samples")
    assert found.pop("reference") == 0
    assert min(found.values()) > 0


def test_better_accuracies_of_the_free_disk_are_nearer_to_the_reference(records):
    for measure in ("samples, A-weighted", "samples"):
        found = errors(records, ACCURACY, f"free: {measure}")
        assert found["standard"] < found["draft"] / 3


def test_a_tolerance_that_is_too_coarse_is_heard(records):
    assert (
        errors(records, CHOICE, "free: samples")["tolerance of the motion 1e-9"] > 1e-5
    )
