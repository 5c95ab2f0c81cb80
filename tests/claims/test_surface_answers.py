"""Claim: the table of surfaces in the README contains only findings of shipped scenes.

Source: sonify/claims/surface_summary.py. Oracle: findings with given values and answers; new
solutions of the scenes.
"""

import re
from dataclasses import replace
from math import inf

import pytest
from paths import ROOT

from dynamics.film.activation import decide_film
from sonify import load_scene
from sonify.claims.finding import Finding
from sonify.claims.surface_summary import (
    ANSWERS,
    LOSS_QUESTION,
    SURFACES,
    answer_table,
    answers_in_short,
    complete_answers,
)
from sonify.examples import surfaces
from sonify.scene import shipped_scenes
from sonify.sweeps.required_stages import stage_of

NUMBER = r"[-+]?\d+(?:\.\d+)?"


def finding(key, value, holds):
    low, high = (-inf, inf) if holds else (inf, inf)
    return Finding(
        key=key, claim="", cause="slip", value=value, unit="", at_least=low, at_most=high, source=""
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
        key="pitch_rises", claim="", value=value, unit="", at_least=2.0, margin=0.1, source=""
    )
    assert complete_answers([*others, near])["does the pitch rise"] == "undecided, 2.0 times"


def test_an_undecided_answer_without_yes_or_no_says_so_first():
    others = [
        finding(next(iter(words)), 0.25, True)
        for question, words in ANSWERS.items()
        if "hear" not in question
    ]
    level = Finding(
        key="table_is_louder", claim="", value=0.5, unit="", at_least=0.0, margin=1.0, source=""
    )
    assert (
        complete_answers([*others, level])["what you hear"]
        == "undecided: the table, +0 dB(A) relative to the disk"
    )


def test_every_cell_is_a_finding_of_a_shipped_scene():
    assert set(SURFACES) <= set(shipped_scenes())
    assert {key for words in ANSWERS.values() for key in words} <= set(stage_of())


@pytest.mark.parametrize("name", SURFACES)
def test_the_table_says_which_motions_are_in_a_vacuum(name):
    film = decide_film(load_scene(name)).film
    assert SURFACES[name].endswith("in a vacuum" if film is None else "in air")


@pytest.mark.parametrize("rank", [0, 1])
def test_the_first_finding_that_there_is_answers(rank):
    """Checked with all findings and each second one alone, in positive and negative wording."""
    keys = [list(words)[rank] for words in ANSWERS.values()]
    for holds in (True, False):
        told = complete_answers([finding(key, 0.25, holds) for key in keys])
        for (question, words), key in zip(ANSWERS.items(), keys, strict=True):
            assert told[question] == words[key][0 if holds else 1].format(
                value=0.25, cause="sliding"
            )
    with pytest.raises(LookupError, match="none of the findings"):
        complete_answers([finding(keys[0], 1.0, True)])
    assert answers_in_short([finding(keys[0], 0.25, True)]) == {
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
    told = answers_in_short([kept])[LOSS_QUESTION]
    assert answers_in_short([kept, air])[LOSS_QUESTION] == told
    air = replace(air, cause="film")
    assert answers_in_short([kept, air])[LOSS_QUESTION] == told + (
        "; finally the air carries the disk" if holds else ", to the air"
    )


def shown(text):
    """Return the rows of the table in a text with numbers masked, and the numbers separately."""
    head, *_ = answer_table({}).splitlines()
    rows = text[text.index(head) :].partition("\n\n")[0]
    return re.sub(NUMBER, "0", rows), [float(number) for number in re.findall(NUMBER, rows)]


@pytest.mark.slow
def test_the_readme_shows_what_the_scenes_find():
    """The words are equal; numbers agree within one unit of the last digit or 10 %."""
    readme = shown((ROOT / "README.md").read_text("utf-8"))
    made = shown(surfaces.main())
    assert readme[0] == made[0]
    assert readme[1] == pytest.approx(made[1], rel=0.1, abs=1.0)
