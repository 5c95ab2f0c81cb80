"""Claim: each finding has one record of texts, from which the page, the answers, the headline and
the sentences of sweeps are made.

Source: sonify/claims/finding_texts.py. Oracle: the registered functions, and a finding made here
from a record and a function alone.
"""

import re
from string import Formatter

import pytest
from paths import ROOT

from sonify.claims import finding as finding_module
from sonify.claims import finding_texts
from sonify.claims.details import unit_and_details
from sonify.claims.finding import JUDGE_BY_KEY, Finding, Measured, finding
from sonify.claims.finding_texts import (
    FINDING_TEXTS,
    NO_ANSWER_REASONS,
    AnswerSentences,
    FindingText,
    HeadlineClauses,
    Quotation,
    texts_by_question,
    texts_with,
)
from sonify.claims.provenance import registered_judges

PAPER_ROWS = {
    "unit_of_time",
    "half_height",
    "density",
    "named_rate",
    "begins_at",
    "ends_at",
    "rates_are_alike",
    "precession_grows",
}
"""Rows on numbers of the paper, which no function judges alone."""


def fields_of(text):
    """Return the names in braces in a template."""
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_each_finding_has_a_record_and_each_record_a_finding():
    checks = {
        key
        for key, judge in registered_judges().items()
        if judge.function.__module__ == "sonify.claims.checks"
    }
    assert checks
    assert FINDING_TEXTS.keys() == (registered_judges().keys() - checks) | PAPER_ROWS


def test_each_text_is_in_one_file():
    """No claim or source of a finding is repeated in another module."""
    others = [
        path.read_text("utf-8")
        for folder in ("sonify", "docs/article")
        for path in (ROOT / folder).rglob("*.py")
        if path.name != "finding_texts.py"
    ]
    code = " ".join(" ".join(text.split()) for text in others)
    for text in FINDING_TEXTS.values():
        if len(text.claim) > 30:
            assert f'"{text.claim}"' not in code


@pytest.mark.parametrize("key", FINDING_TEXTS)
def test_a_record_is_complete(key):
    text = FINDING_TEXTS[key]
    assert text.claim[:1].isupper() or not text.claim[:1].isascii() or key in PAPER_ROWS
    assert not text.claim.endswith(".")
    assert text.unit
    assert text.source
    assert (text.question in NO_ANSWER_REASONS) == bool(text.answers or text.headline)
    if text.answers:
        assert fields_of("".join(text.answers)) <= {
            "value",
            "cause",
            "told",
        } | fields_of(text.details if isinstance(text.details, str) else "")
    for variant in text.variants.values():
        assert variant.keys() <= {"claim", "unit", "source"}
    if text.quotation:
        assert re.fullmatch(r"(section|figure) \d", text.quotation.place)


@pytest.fixture
def own(monkeypatch):
    """Return the function of a finding of this test, whose only other part is its record."""
    record = FindingText(
        claim="The {what} is red",
        unit="of the surface (largest part)",
        source="a look at it",
        variants={"wet": {"unit": "of the wet surface"}},
        quotation=Quotation("It is red.", "section 9"),
        details="seen from {distance:.1f} m",
        question=finding_texts.SOUND_QUESTION,
        answers=AnswerSentences("red, {value:.0%}", "not red", "undecided"),
        headline=HeadlineClauses("you see red", "you do not see red"),
        loudest="red sounds loud",
        omitted_effect="The colour acts",
        short="red",
    )
    monkeypatch.setitem(FINDING_TEXTS, "disk_is_red", record)

    @finding(needs=("scene",), at_least=0.5)
    def disk_is_red(share: float, variant: str = ""):
        return Measured(
            share, 0.1, {"distance": 2.0}, variant=variant, words={"what": "disk"}
        )

    yield disk_is_red
    JUDGE_BY_KEY.pop("disk_is_red")


def test_a_record_and_a_function_make_a_finding(own):
    found = own(0.8)
    assert isinstance(found, Finding)
    assert (found.key, found.claim) == ("disk_is_red", "The disk is red")
    assert (found.verdict, found.source) == ("yes", "a look at it")
    assert unit_and_details(found) == "of the surface (largest part); seen from 2.0 m"
    assert own(0.8, "wet").unit == "of the wet surface"
    for name in ("quotation", "loudest", "omitted_effect", "short"):
        assert texts_with(name)["disk_is_red"] == getattr(
            FINDING_TEXTS["disk_is_red"], name
        )
    for name in ("answers", "headline"):
        told = texts_by_question(name)[finding_texts.SOUND_QUESTION]
        assert list(told)[-1] == "disk_is_red"


def test_a_function_without_a_record_is_refused():
    with pytest.raises(KeyError, match="disk_is_blue"):

        @finding(needs=("scene",))
        def disk_is_blue():
            return 1.0

    assert "disk_is_blue" not in finding_module.JUDGE_BY_KEY
