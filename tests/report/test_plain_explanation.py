"""Claim: the page explains the buzz in five plain sentences that state only what the run found.

Source: the findings of a run and its motion. Oracle: findings made by hand, for each verdict; the
turns of the solved motion.
"""

import re

import numpy as np
import pytest
from made_findings import found

from dynamics import Outcome, simulate
from sonify import load_scene
from sonify.claims.provenance import registered_judges
from sonify.report.plain_explanation import (
    END_CLAUSES,
    LOUDEST_PARTS,
    PITCH_KEYS,
    plain_explanation,
)


@pytest.fixture(scope="module")
def brief():
    scene = load_scene("published").replace(
        "numerics.time_limit=0.5", "numerics.accuracy=draft"
    )
    return simulate(scene)


def test_every_key_is_a_finding():
    keys = {"contact_is_lost", "contact_kept", "what_ends", "tone_is_precession"}
    assert keys <= registered_judges().keys()


@pytest.mark.parametrize("value", [1.0, -1.0])
def test_there_are_five_sentences_for_any_verdicts(motion, value):
    keys = [*LOUDEST_PARTS, *PITCH_KEYS, "contact_is_lost", "contact_kept"]
    sets = [
        [],
        [found(key, value) for key in keys],
        [found(key, value, 2.0) for key in keys],
    ]
    for findings in sets:
        sentences = plain_explanation(motion, findings)
        assert len(sentences) == 5
        for sentence in sentences:
            assert re.fullmatch(r"[A-Z].*[a-z]\.", sentence)
            assert len(sentence.split()) < 40


def test_the_turns_are_those_of_the_motion(motion, brief):
    for one, span in ((motion, 1.0), (brief, 0.25)):
        first = plain_explanation(one, [])[0]
        stated = [float(x) for x in re.findall(r"([\d.]+) times", first)]
        end = one.t[-1]
        angle = one.precession([0.0, span, end - span, end])
        turns = np.abs([angle[1] - angle[0], angle[3] - angle[2]]) / (2 * np.pi)
        assert stated == pytest.approx(turns, rel=0.005)
        assert ("first second" if span == 1 else "first 0.25 s") in first


@pytest.mark.parametrize(
    ("findings", "number", "words"),
    [
        ([found("pitch_rises", 1.0)], 1, "and the pitch rises towards the end."),
        (
            [found("pitch_rises", 1.0), found("tone_is_precession", 1.0)],
            1,
            "this is the tone that you hear, and therefore its pitch rises.",
        ),
        (
            [
                found("pitch_rises", 1.0, cause="beats"),
                found("tone_is_precession", 1.0),
            ],
            1,
            "the sound beats with it, faster and faster.",
        ),
        ([found("pitch_rises", -1.0)], 1, "the pitch of this sound does not rise."),
        ([found("pitch_rises", 1.0, 2.0)], 1, "was not decided in this run."),
        ([found("table_is_louder", 1.0)], 2, "the table vibrates"),
        ([found("modes_carry_the_end", 1.0)], 2, "the disk rings like a bell"),
        ([found("modes_carry_the_end", -1.0)], 2, "it rings less loudly."),
        (
            [found("table_is_louder", -1.0), found("carrier_is_contact", 1.0)],
            2,
            "the disk vibrates on its springy contact",
        ),
        ([], 2, "was not decided in this run."),
        ([found("contact_kept", 1.0)], 3, "The disk never leaves the table"),
        (
            [found("contact_kept", -1.0), found("carried_by_air", 1.0, cause="film")],
            3,
            "The disk rolls on the table until the air under it carries its weight.",
        ),
        ([found("heard_through_film", -1.0)], 2, "too faint to hear."),
        (
            [found("contact_kept", -1.0)],
            3,
            "The disk leaves the table for brief moments",
        ),
        (
            [found("contact_is_lost", 1.0), found("contact_kept", 1.0)],
            3,
            "The disk leaves the table for brief moments",
        ),
        (
            [found("what_ends", 0.687, cause="moments")],
            4,
            "Friction of rolling and pivoting takes 69 % of the last tenth of the energy, and after "
            "19.4 s the disk lies flat.",
        ),
        ([], 4, "After 19.4 s the disk lies flat."),
    ],
)
def test_the_sentences_follow_the_verdicts(motion, findings, number, words):
    assert words in plain_explanation(motion, findings)[number]


def test_the_clauses_name_outcomes(brief):
    assert END_CLAUSES.keys() < set(Outcome)
    assert plain_explanation(brief, [])[4] == (
        "After 0.5 s the computation stops before the disk is at rest."
    )
