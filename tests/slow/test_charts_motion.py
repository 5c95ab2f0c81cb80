"""Claim: simpler methods really fail on the rolling disk as the chart shows, and our method has
none of these failures.

Source: Kessler & O'Reilly (2002), section 6.2, for the slip tolerance; (3.3) as Filippov's
differential inclusion. Oracle: quadruple precision (published case); 80-bit arithmetic (sticking
case). No test depends on speed. test_charts_stability.py tests the failures of all methods on paths
through three hazards.
"""

import csv
import json
import shutil
from functools import partial
from importlib.util import find_spec

import numpy as np
import pytest
from click.testing import CliRunner
from paths import REFERENCES, ROOT

from benchmarks.cases.motion_case import conservative, published, references, sticking
from benchmarks.charts import CHARTS, motion_chart
from benchmarks.charts.chart_files import write_chart
from benchmarks.charts.chart_page import environment
from benchmarks.charts.error_time_picture import family_colours
from benchmarks.methods.event_driven import ours
from benchmarks.methods.moreau_time_stepping import moreau
from benchmarks.methods.sign_friction import naive_sign
from benchmarks.methods.slip_tolerance import slip_tolerance
from benchmarks.methods.tanh_friction import tanh_regularised
from benchmarks.timed_runs import (
    MAX_ERROR,
    MAX_TOTAL_SECONDS,
    MIN_TIMING_SECONDS,
    Answer,
    Failure,
    Work,
    measured,
)
from sonify.__main__ import main

SHOWN = ROOT / "outputs" / "shown" / "charts"
OURS = [
    pytest.param(
        "taylor",
        1e-16,
        marks=pytest.mark.skipif(
            not find_spec("heyoka"), reason="heyoka is not installed"
        ),
    ),
    ("dop853", 1e-12),
]


def test_the_shipped_reference_is_that_of_the_tests():
    samples = json.loads((REFERENCES / "motion.json").read_text("utf-8"))["samples"]
    known = {f"{s['tau']:g}": [s["beta"], s["E"]] for s in samples}
    for span, values in references()["published"].items():
        assert values == known[span]


@pytest.mark.parametrize(("name", "tolerance"), OURS)
@pytest.mark.parametrize("case", [published(50.0), sticking(40.0)], ids=str)
def test_ours_is_right_on_both_cases(name, tolerance, case):
    assert case.error(ours(case, name, tolerance).values) < 1e-10


@pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
def test_every_competitor_computes_the_same_motion_where_it_is_easy():
    assert len(motion_chart.prove()) == len(motion_chart.proofs())


@pytest.mark.parametrize("method", ["RK45", "DOP853", "LSODA"])
def test_naive_sign_chatters_to_a_stop_where_the_nutation_sticks(method):
    with pytest.raises(Failure, match=r"chatters: .* only tau = 2[78]"):
        naive_sign(sticking(), method, 1e-8)


@pytest.mark.parametrize("method", ["Radau", "BDF"])
def test_naive_sign_is_wrong_with_difference_quotients_of_its_jumps(method):
    case = published(5.0)
    smooth = conservative(10.0)
    assert case.error(naive_sign(case, method, 1e-8).values) > 5 * MAX_ERROR
    assert smooth.error(naive_sign(smooth, method, 1e-8).values) < 1e-5


def test_a_slip_tolerance_that_is_too_tight_never_rolls_again():
    case = published(10.0)
    with pytest.raises(Failure, match=r"stays in sliding|chatters"):
        slip_tolerance(case, 1e-5, 1e-12, 0.1, 1e-6)


def test_a_wide_tanh_is_another_motion():
    case = published(10.0)
    wide, narrow = (
        case.error(tanh_regularised(case, "LSODA", width, 1e-9).values)
        for width in (1e-2, 1e-5)
    )
    assert wide > MAX_ERROR > narrow


def test_moreau_is_of_first_order_through_slips():
    case = published(10.0)
    steps = [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4]
    errors = [case.error(moreau(case, step).values) for step in steps]
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(1, abs=0.1)


def test_the_quick_charts_are_written(tmp_path, monkeypatch):
    """Methods that chatter are given up earlier than in a chart."""
    for method in ("slip_tolerance", "sign_friction"):
        monkeypatch.setattr(f"benchmarks.methods.{method}.MAX_EVALUATIONS", 10_000)
    done = CliRunner().invoke(main, ["chart", "all", "--quick", "--out", str(tmp_path)])
    assert done.exit_code == 0, done.output
    for name in CHARTS:
        rows = list(csv.DictReader((tmp_path / f"{name}.csv").open(encoding="utf-8")))
        page = (tmp_path / f"{name}.md").read_text("utf-8")
        assert any(row["failure"] for row in rows) or name in (
            "end_to_end",
            "contact_models",
        )
        assert any(not row["failure"] for row in rows)
        assert all(row["failure"] in page for row in rows)
        assert (tmp_path / f"{name}.png").stat().st_size > 20_000


def test_runs_take_turns_and_a_short_one_is_called_as_often_as_the_clock_needs(
    monkeypatch,
):
    """The test replaces the clock with one that advances only in the calls."""
    now = 0.0
    calls = []

    def call(name, seconds):
        nonlocal now
        now += seconds
        calls.append(name)
        return Answer((), 1)

    monkeypatch.setattr("benchmarks.timed_runs.processor_seconds", lambda: now)
    lasting = {"a": 0.3 * MIN_TIMING_SECONDS, "b": 0.4 * MAX_TOTAL_SECONDS}
    works = [
        Work("f", a, "s", "c", partial(call, a, lasting[a]), lambda values: 0.0)
        for a in lasting
    ]
    short, long = measured(works)
    # The first call of each turn is not timed.
    assert "".join(calls) == "ab" + "aaaaab" + 3 * "aaaaa"
    assert (short.repeats, long.repeats) == (5, 2)
    assert (short.seconds, long.seconds) == pytest.approx(tuple(lasting.values()))
    calls.clear()
    measured(works, warm=lambda work: True, repeats=1)
    assert "".join(calls) == "ab" + "aaaab"


def test_a_page_states_the_commit_of_its_program():
    assert environment()[-1].startswith("commit ")


@pytest.mark.parametrize("name", CHARTS)
def test_the_shown_chart_is_what_its_records_make_and_says_the_problem_and_five_sentences_at_most(
    name, tmp_path
):
    """The chart is redrawn from its table, without new measurements."""
    for suffix in ("csv", "md"):
        shutil.copy(SHOWN / f"{name}.{suffix}", tmp_path)
    write_chart(name, False, tmp_path, None, redraw=True)
    page = (tmp_path / f"{name}.md").read_text("utf-8")
    assert page == (SHOWN / f"{name}.md").read_text("utf-8")
    assert "$" in page[: page.index("## Conclusion")]
    assert (
        1
        <= page[page.index("## Conclusion") :].partition("\n## ")[0].count("\n- ")
        <= 5
    )
    assert (tmp_path / f"{name}.png").stat().st_size > 20_000


def test_families_are_told_apart_in_a_grey_print():
    lightness = np.array(list(family_colours("abcdef").values()))[:, :3] @ [
        0.2126,
        0.7152,
        0.0722,
    ]
    assert np.diff(lightness).min() > 0.05


@pytest.mark.parametrize("held", [None, "", "a,b\n1,2\n", "family,method\nx\n"])
def test_without_records_there_is_nothing_to_draw_again(tmp_path, held):
    if held is not None:
        (tmp_path / "sound.csv").write_text(held)
        (tmp_path / "sound.md").write_text("")
    asked = CliRunner().invoke(
        main, ["chart", "sound", "--redraw", "--out", str(tmp_path)]
    )
    assert asked.exit_code == 2
    assert "sound.csv" in asked.stderr
