"""Claim: a run ends with at most 14 lines of at most 100 characters, plus one per failed check.

Source: `sonify.report.closing_lines`. Oracle: the longest text of every question in the tables of
the answers and the headline, and the run of a shipped scene.
"""

from itertools import product
from types import SimpleNamespace

import pytest
from made_findings import found

from dynamics import plan_motion
from sonify import load_scene
from sonify.claims.checks import Check
from sonify.claims.surface_summary import ANSWERS, complete_answers
from sonify.report import closing_lines as module
from sonify.report.closing_lines import (
    LINE_LENGTH,
    closing_lines,
    finding_lines,
    wrapped,
)
from sonify.report.headline import HEADLINE_CLAUSES, VIOLATED_BALANCE

MAX_LINES = 14
PLAN = SimpleNamespace(motion=plan_motion(load_scene("published")))
"""The part of a plan that the closing lines need."""


def made_check(number, passed):
    """Return a check with a long name that passes or fails."""
    return Check(
        key=f"check_{number}",
        value=0.0 if passed else 1.0,
        name=f"a name {number} of a check " * 6,
        source="a test",
        expected=0.0,
        tolerance=0.1,
    )


def made_result(tmp_path, failed=0):
    """Return what the closing lines need of a result."""
    checks = [made_check(i, passed=i >= failed) for i in range(8)]
    findings = [found("contact_kept", 1.0)]
    return SimpleNamespace(
        checks=checks, findings=findings, out=tmp_path, motion=None, plan=PLAN
    )


def longest(texts):
    """Return the longest text of a table by key."""
    return max((text for words in texts.values() for text in words), key=len)


@pytest.mark.parametrize(("failed", "violated"), list(product((0, 3), (False, True))))
def test_the_longest_texts_fit_on_one_screen(tmp_path, monkeypatch, failed, violated):
    clauses = [longest(words) for words in HEADLINE_CLAUSES.values()]
    sentence = f"{', '.join(clauses)}, and finally the air lifts it."
    if violated:
        sentence = (
            f"{VIOLATED_BALANCE.format(value=1.23, heat=1.0, radiated=0.23)} {sentence}"
        )
    endings = iter((", audible 100%", ", in a vacuum", ", in a vacuum; to the air", ""))
    answers = {
        question: longest(words).replace(
            "{cause}", "impacts and compression of the contact"
        )
        + next(endings)
        for question, words in ANSWERS.items()
    }
    if violated:
        answers["what ends the motion"] = (
            "not valid: the table would take 123% of the power"
        )
    monkeypatch.setattr(module, "headline", lambda findings: sentence)
    monkeypatch.setattr(module, "complete_answers", lambda findings: answers)
    *lines, picture, page = closing_lines(made_result(tmp_path, failed))
    assert len(lines) + 2 <= MAX_LINES + failed
    assert max(map(len, lines)) <= LINE_LENGTH
    assert sum(line.startswith("FAILED") for line in lines) == failed
    assert [picture, page] == [
        str(tmp_path / "spectrogram.png"),
        str(tmp_path / "report.html"),
    ]
    assert lines[-1] == "8 checks, 1 findings in report.html"


def test_the_answers_are_those_of_the_page(tmp_path):
    result = made_result(tmp_path)
    text = " ".join(line.strip() for line in closing_lines(result))
    for question, answer in complete_answers(result.findings).items():
        assert f"{question}: {answer}" in text


def test_all_checks_and_findings_are_listed_on_request(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "omissions_after_end", lambda motion: ["The landing."])
    lines = list(finding_lines(made_result(tmp_path, failed=1)))
    starts = [line[:6] for line in lines if not line.startswith("  ")]
    assert starts == ["FAILED", *["ok    "] * 7, "yes   ", "note  "]
    assert max(map(len, lines)) <= LINE_LENGTH


def test_a_long_word_is_broken_and_nothing_is_lost():
    lines = wrapped("x" * 250)
    assert max(map(len, lines)) <= LINE_LENGTH
    assert "".join(line.strip() for line in lines) == "x" * 250
