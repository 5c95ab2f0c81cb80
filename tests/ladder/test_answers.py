"""Claim: two rungs agree on a question if their answers have the same class, whichever findings
give them.

Source: `sonify.ladder.row`. Oracle: made findings with known answers, and the words that a run
prints for them.
"""

import pytest
from made_findings import found

from sonify.claims.finding_texts import LOSS_QUESTION
from sonify.claims.surface_summary import complete_answers
from sonify.ladder.row import QUESTION_BY_COLUMN, answer_columns

SUPPLIED = found("disk_supplies_table", -1.0)


@pytest.mark.parametrize(
    ("findings", "expected"),
    [
        ([found("contact_kept", 0.6)], "no"),
        ([found("contact_kept", -1.0)], "yes"),
        ([found("contact_is_lost", -1.0)], "no"),
        ([found("contact_is_lost", 0.2)], "yes"),
        ([found("table_breaks_contact", -1.0)], "no"),
        ([found("contact_is_lost", 0.2, margin=1.0)], "undecided"),
        ([], "not evaluated"),
    ],
)
def test_yes_and_no_do_not_depend_on_the_finding(findings, expected):
    row = answer_columns(findings)
    assert row["class_loss"] == expected
    assert complete_answers(findings)[LOSS_QUESTION].startswith(expected)


def test_a_contact_lost_to_the_air_is_another_answer():
    kept = found("contact_kept", 0.6)
    carried = found("carried_by_air", 1.0, cause="film")
    assert answer_columns([kept])["class_loss"] == "no"
    assert answer_columns([kept, carried])["class_loss"] == "yes: carried_by_air"


def test_an_answer_in_a_vacuum_is_the_same_answer():
    tone = found("pitch_rises", 22.0)
    alone = answer_columns([tone])
    vacuum = answer_columns([tone, found("carried_by_air", 1.0)])
    assert vacuum["answer_pitch"].endswith(", in a vacuum")
    assert vacuum["class_pitch"] == alone["class_pitch"] == "yes"


def test_the_cause_is_part_of_the_answer():
    causes = [found("what_ends", 0.7, cause=cause) for cause in ("film", "moments")]
    first, second = (answer_columns([one])["class_end"] for one in causes)
    assert first != second


def test_inaudible_sounds_and_violated_balances_are_answers_of_their_own():
    row = answer_columns([found("sound_is_audible", -1.0), SUPPLIED])
    assert row["class_sound"] == "inaudible"
    assert row["class_end"] == "not valid"
    assert row["answer_end"].startswith("not valid")


def test_the_words_are_those_of_a_run_and_the_number_is_that_of_the_finding():
    findings = [found("contact_kept", 0.6), found("pitch_rises", 22.0)]
    row = answer_columns(findings)
    for name, question in QUESTION_BY_COLUMN.items():
        assert row[f"answer_{name}"] == complete_answers(findings)[question]
    assert (row["number_loss"], row["finding_loss"]) == (0.6, "contact_kept")
    assert row["number_end"] is row["unit_end"] is None
