"""Claim: the table of docs/surfaces.md contains only findings of shipped scenes.

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
        == "undecided: the table has +0 dB(A) relative to the disk"
    )


def test_every_cell_is_a_finding_of_a_shipped_scene():
    assert set(SURFACE_BY_SCENE) <= set(shipped_scenes())
    assert {key for words in ANSWERS.values() for key in words} <= set(
        stage_by_quantity()
    )


@pytest.mark.parametrize("rank", [0, 1])
def test_the_first_finding_that_there_is_answers(rank):
    """Checked with all findings and each second one alone, in positive and negative wording."""
    keys = [list(words)[min(rank, len(words) - 1)] for words in ANSWERS.values()]
    for holds in (True, False):
        told = complete_answers([finding(key, 0.25, holds) for key in keys])
        for (question, words), key in zip(ANSWERS.items(), keys, strict=True):
            assert told[question] == words[key][0 if holds else 1].format(
                value=0.25, cause="sliding", advance_at_100_urad=0.1, told=""
            )
    alone = complete_answers([finding(keys[0], 1.0, True)])
    assert all(
        alone[question].startswith("not evaluated: ") for question in list(ANSWERS)[1:]
    )
    assert short_answers([finding(keys[0], 0.25, True)]) == {
        next(iter(ANSWERS)): ANSWERS[next(iter(ANSWERS))][keys[0]][0].format(value=0.25)
    }


def test_contact_that_is_lost_to_the_air_is_told_with_what_vibration_does():
    """The answer depends on the run alone: without the film, the disk keeps its contact."""
    kept = finding("contact_kept", 0.6, True)
    vibrates = replace(
        finding("vibration_opens_contact", 0.2, False), details={"force_rms": 0.2}
    )
    air = replace(finding("carried_by_air", 1.0, True), cause="")
    told = short_answers([kept, vibrates, air])[LOSS_QUESTION]
    assert told.startswith(
        "no, not by vibration of the disk (it varies the force by 20% of the weight"
    )
    air = replace(air, cause="film")
    told = short_answers([kept, vibrates, air])[LOSS_QUESTION]
    assert told.startswith("yes, by the air (lift 1 times the vertical force")
    assert "; not by vibration of the disk" in told
    assert (
        short_answers([kept])[LOSS_QUESTION]
        == "no, the least normal force is 0.6 of the weight"
    )


def test_a_sound_below_the_threshold_of_hearing_is_nothing():
    louder = finding("table_is_louder", 7.0, True)
    audible = finding("sound_is_audible", 12.0, True)
    audible = replace(audible, details={"audible_share": 0.25})
    words = "the table, +7 dB(A) relative to the disk, audible for 25% of the time"
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
        (2e-4, 8e-4, "as on a rigid table; two-way coupling for the last 0.8 ms"),
        (0.0, 0.0, "as on a rigid table; no two-way coupling"),
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
    assert answer_in_air([carried, earlier]) == f"lifted after 12.355 s, {words}"
