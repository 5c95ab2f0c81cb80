"""Claim: ladder.json names the marked rungs and states the deviation of every answer.

Source: sonify/ladder/files.py. Oracle: three made rows whose marks and deviations are known.
"""

import pytest
from ladder_rows import row

from sonify.ladder.comparison import QUESTION_KEYS, compare
from sonify.ladder.files import answer_record, stretch_record

ROWS = [("low", 1.0, 3.0), ("middle", 2.0, 2.1), ("top", 9.0, 2.0)]
"""Names, CPU seconds, and the number that answers each question."""
FOUND = compare(
    [
        row(rung, seconds, **{key: {"number": number} for key in QUESTION_KEYS})
        for rung, seconds, number in ROWS
    ]
    + [row("failed", None, "out of memory")]
)


def test_marks_are_the_names_of_rungs():
    record = stretch_record(FOUND)
    assert record["top"] == "top"
    assert record["marked"] == "low"
    # only the rung in the middle has the same number within 10 %
    assert record["marks"]["pitch"] == {"answer": "low", "number": "middle"}


def test_every_solved_rung_has_its_deviations_and_a_failed_one_none():
    rows = stretch_record(FOUND)["rows"]
    sizes = [one["answers"]["loss"]["deviation"] for one in rows[:3]]
    assert sizes == pytest.approx([0.5, 0.05, 0.0])
    assert "answers" not in rows[3]
    assert rows[3]["error"] == "out of memory"


def test_an_answer_states_its_parts_and_its_deviation():
    record = answer_record(FOUND.rows[0], "end", FOUND.deviations[0]["end"])
    assert record == {
        "answer": "no",
        "class": "no",
        "number": 3.0,
        "unit": "times",
        "finding": "one",
        "deviation": pytest.approx(0.5),
        "deviation_unit": "relative",
        "same_answer": True,
        "same_number": False,
    }


def test_without_a_valid_rung_nothing_is_marked():
    record = stretch_record(compare([row("a", None, "too slow")]))
    assert record["top"] is None
    assert record["marked"] is None
    assert record["marks"]["sound"] == {"answer": None, "number": None}
