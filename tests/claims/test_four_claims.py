"""Claim: the README's sentence and table on the four claims of the paper are the findings of five
runs.

Source: sonify/claims/four_claims.py. Oracle: answers with given verdicts and values; for the README,
`tests/references/finding_values.json`, which tests/slow/test_shipped_scenes.py compares with the runs.
"""

import json

import pytest
from paths import REFERENCES, ROOT

from sonify.claims.finding_texts import FINDING_TEXTS
from sonify.claims.four_claims import (
    CASES,
    CLAIMS,
    Answer,
    Claim,
    cell,
    claim_sentence,
    claim_table,
    deciding_key,
)

TWO = Claim("it breaks", {"by_table": str, "by_disk": str})


def known_answers():
    values = json.loads((REFERENCES / "finding_values.json").read_text("utf-8"))
    return {
        name: {
            key: Answer(found["verdict"], float(found["value"]), found["details"])
            for key, found in values[name].items()
        }
        for name in CASES
    }


def test_the_readme_shows_the_sentence_and_the_table_of_the_findings():
    readme = " ".join((ROOT / "README.md").read_text("utf-8").split())
    answers = known_answers()
    assert claim_sentence(answers) in readme
    assert " ".join(claim_table(answers).split()) in readme


def test_in_air_the_film_catches_each_disk_that_rolls_within_a_quarter_of_a_turn():
    """The README says so; the coin rattles until it lies flat."""
    assert (
        "floats on a thin film of air and stops within a quarter of a turn"
        in " ".join((ROOT / "README.md").read_text("utf-8").split())
    )
    for name, answers in known_answers().items():
        if name not in ("published", "coin"):
            assert answers["air_catches_disk"].verdict == "yes"
            assert answers["halt_is_abrupt"].value <= 0.25
    assert known_answers()["coin"]["disk_rattles"].verdict == "yes"


def test_every_cell_of_the_table_is_evaluated():
    assert "not evaluated" not in claim_table(known_answers())


def test_each_row_names_findings_that_exist():
    assert {key for claim in CLAIMS for key in claim.numbers} <= FINDING_TEXTS.keys()


@pytest.mark.parametrize(
    ("verdicts", "key"),
    [
        (("no", "yes"), "by_disk"),
        (("yes", "yes"), "by_table"),
        (("no", "undecided"), "by_disk"),
        (("undecided", "yes"), "by_disk"),
        (("no", "no"), "by_table"),
    ],
)
def test_a_finding_that_holds_decides_before_an_undecided_one(verdicts, key):
    answers = {
        name: Answer(verdict, 0.5)
        for name, verdict in zip(TWO.numbers, verdicts, strict=True)
    }
    assert deciding_key(TWO, answers) == key
    assert cell(TWO, answers).startswith(answers[key].verdict)


def test_a_claim_without_a_finding_is_not_evaluated():
    assert deciding_key(TWO, {}) is None
    assert cell(TWO, {}) == "not evaluated"


def test_the_sentence_counts_the_cases():
    yes, no = (
        {
            key: Answer(verdict, 1.0, {"louder": 1.0})
            for claim in CLAIMS
            for key in claim.numbers
        }
        for verdict in ("yes", "no")
    )
    names = list(CASES)
    assert claim_sentence(dict.fromkeys(names, yes)).count("in all") == len(CLAIMS)
    assert claim_sentence(dict.fromkeys(names, no)).count("in none") == len(CLAIMS)
    mixed = claim_sentence({name: no if name == "coin" else yes for name in names})
    assert mixed.count(f"in four (not for {CASES['coin'].words})") == len(CLAIMS)
