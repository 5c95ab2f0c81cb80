"""Claim: the table of surfaces in the README contains only findings of shipped scenes.

Source: sonify/claims/surface_summary.py. Oracle: findings with given values and answers.
tests/slow/test_shipped_scenes.py compares the table itself with the runs.
"""

from dataclasses import replace
from math import inf

import pytest

from sonify.claims.finding import Finding
from sonify.claims.surface_summary import (
    ANSWERS,
    LOSS_QUESTION,
    SOUND_QUESTION,
    SURFACE_BY_SCENE,
    answer_in_air,
    complete_answers,
    short_answers,
)
from sonify.scene import shipped_scenes
from sonify.sweeps.required_stages import stage_by_quantity


def finding(key, value, holds):
    low, high = (-inf, inf) if holds else (inf, inf)
    return Finding(
        key=key,
        claim="",
        cause="slip",
        value=value,
        unit="",
        details={"advance_at_100_urad": 0.1},
        at_least=low,
        at_most=high,
        source="",
    )


@pytest.mark.parametrize("value", [1.99, 2.01])
def test_an_answer_whose_margin_reaches_across_its_threshold_is_undecided(value):
    """Rounding may move the value across the threshold, but does not change the table."""
    others = [
        finding(next(iter(words)), 0.25, True)
        for question, words in ANSWERS.items()
        if "pitch" not in question
    ]
    near = Finding(
        key="pitch_rises",
        claim="",
        value=value,
        unit="",
        at_least=2.0,
        margin=0.1,
        source="",
    )
    assert (
        complete_answers([*others, near])["does the pitch rise"]
        == "undecided, 2.0-fold"
    )


def test_an_undecided_answer_without_yes_or_no_says_so_first():
    others = [
        finding(next(iter(words)), 0.25, True)
        for question, words in ANSWERS.items()
        if "hear" not in question
    ]
    level = Finding(
        key="table_is_louder",
        claim="",
        value=0.5,
        unit="",
        at_least=0.0,
        margin=1.0,
        source="",
    )
    assert (
        complete_answers([*others, level])["what do you hear"]
        == "undecided: the table, +0 dB(A)"
    )


def test_every_cell_is_a_finding_of_a_shipped_scene():
    assert set(SURFACE_BY_SCENE) <= set(shipped_scenes())
    assert {key for words in ANSWERS.values() for key in words} <= set(
        stage_by_quantity()
    )


@pytest.mark.parametrize("rank", [0, 1])
def test_the_first_finding_that_there_is_answers(rank):
    """Checked with all findings and each second one alone, in positive and negative wording."""
    keys = [list(words)[rank] for words in ANSWERS.values()]
    for holds in (True, False):
        told = complete_answers([finding(key, 0.25, holds) for key in keys])
        for (question, words), key in zip(ANSWERS.items(), keys, strict=True):
            assert told[question] == words[key][0 if holds else 1].format(
                value=0.25, cause="sliding", advance_at_100_urad=0.1
            )
    alone = complete_answers([finding(keys[0], 1.0, True)])
    assert all(
        alone[question].startswith("not evaluated: ") for question in list(ANSWERS)[1:]
    )
    assert short_answers([finding(keys[0], 0.25, True)]) == {
        next(iter(ANSWERS)): ANSWERS[next(iter(ANSWERS))][keys[0]][0].format(value=0.25)
    }


@pytest.mark.parametrize("holds", [True, False])
def test_contact_that_is_lost_to_the_air_is_told_beside_what_vibrations_do(holds):
    """The answer depends on the run alone: without the film, the disk keeps its contact."""
    key = (
        "contact_is_lost" if holds else "contact_kept"
    )  # the second does not hold where the air carries the disk
    kept = finding(key, 0.0, False)
    air = finding("carried_by_air", 1.0, True)
    told = short_answers([kept])[LOSS_QUESTION]
    assert short_answers([kept, air])[LOSS_QUESTION] == told
    air = replace(air, cause="film")
    assert short_answers([kept, air])[LOSS_QUESTION] == told + (
        "; finally to the air" if holds else ", to the air"
    )


def test_a_sound_below_the_threshold_of_hearing_is_nothing():
    louder = finding("table_is_louder", 7.0, True)
    audible = finding("sound_is_audible", 12.0, True)
    audible = replace(audible, details={"audible_share": 0.25})
    words = "the table, +7 dB(A), audible 25%"
    assert short_answers([louder, audible])[SOUND_QUESTION] == words
    faint = finding("sound_is_audible", -31.0, False)
    silent = short_answers([louder, faint])[SOUND_QUESTION]
    assert silent == "nothing above the threshold of hearing"


def test_answers_on_a_motion_without_its_air_say_so():
    keys = [next(iter(words)) for words in ANSWERS.values()]
    without = replace(finding("carried_by_air", 5.0, True), cause="")
    found = short_answers([*(finding(key, 0.25, True) for key in keys), without])
    for question, answer in found.items():
        assert answer.endswith(", in a vacuum") == (question != SOUND_QUESTION)
    assert answer_in_air([without]) == "not evaluated: there is no film of air"


@pytest.mark.parametrize(
    ("value", "acts", "words"),
    [
        (2e-4, 8e-4, "as on a rigid table; acts for 0.8 ms"),
        (0.0, 0.0, "as on a rigid table; never acts"),
        (0.31, 0.5, "0.31 s earlier than on a rigid table"),
    ],
)
def test_the_answer_in_air_tells_the_part_of_the_table(value, acts, words):
    carried = replace(
        finding("carried_by_air", 1.0, True), cause="film", details={"time": 12.3549}
    )
    earlier = replace(
        finding("air_carries_earlier", value, True), details={"acts_before_end": acts}
    )
    assert answer_in_air([carried, earlier]) == f"carried after 12.355 s, {words}"
