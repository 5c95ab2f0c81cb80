"""Claim: the table of surfaces in the README is made of the findings of shipped scenes, and of nothing else.

Source: sonify/claims/answers.py. Oracle: findings whose values and answers are given; the scenes solved anew.
"""

import re
from dataclasses import replace
from math import inf
from pathlib import Path

import pytest

from sonify.claims.air import LOST_TO_AIR
from sonify.claims.answers import CELLS, LOST, SURFACES, answer_table, answers, in_short
from sonify.claims.motion import Finding
from sonify.examples import surfaces
from sonify.scene import shipped_scenes
from sonify.sweeps.needs import stage_of

NUMBER = r"[-+]?\d+(?:\.\d+)?"


def finding(key, value, holds):
    low, high = (-inf, inf) if holds else (inf, inf)
    return Finding(
        key=key, claim="What ends the motion is dust", value=value, unit="", at_least=low, at_most=high, source=""
    )


@pytest.mark.parametrize("value", [1.99, 2.01])
def test_a_yes_or_no_near_its_bar_is_uncertain(value):
    """So the table is the same where other arithmetic has the value on the other side."""
    others = [finding(next(iter(cells)), 0.25, True) for question, cells in CELLS.items() if "pitch" not in question]
    near = Finding(key="pitch_rises", claim="", value=value, unit="", at_least=2.0, margin=0.1, source="")
    assert answers([*others, near])["does its pitch rise"] == "uncertain, 2.0 times"


def test_every_cell_is_a_finding_of_a_shipped_scene():
    assert set(SURFACES) <= set(shipped_scenes())
    assert {key for cells in CELLS.values() for key in cells} <= set(stage_of())


@pytest.mark.parametrize("rank", [0, 1])
def test_the_first_finding_that_there_is_answers(rank):
    """With every finding, and with the second of each alone; in the words of yes and of no."""
    keys = [list(cells)[rank] for cells in CELLS.values()]
    for holds in (True, False):
        told = answers([finding(key, 0.25, holds) for key in keys])
        for (question, cells), key in zip(CELLS.items(), keys, strict=True):
            assert told[question] == cells[key][0 if holds else 1].format(0.25, cause="dust")
    with pytest.raises(LookupError, match="none of the findings"):
        answers([finding(keys[0], 1.0, True)])
    assert in_short([finding(keys[0], 0.25, True)]) == {
        next(iter(CELLS)): CELLS[next(iter(CELLS))][keys[0]][0].format(0.25)
    }


@pytest.mark.parametrize("holds", [True, False])
def test_contact_that_is_lost_to_the_air_is_told_beside_what_vibrations_do(holds):
    """In the words of the run alone: where the film is left out, the disk keeps its contact."""
    key = "contact_is_lost" if holds else "contact_kept"  # the second does not hold where the air carries the disk
    kept, air = finding(key, 0.0, False), finding("carried_by_air", 1.0, True)
    told = in_short([kept])[LOST]
    assert in_short([kept, air])[LOST] == told
    air = replace(air, claim=LOST_TO_AIR)
    assert in_short([kept, air])[LOST] == told + ("; at last the air carries the disk" if holds else ", to the air")


def shown(text):
    """Words, and numbers, of the rows of the table in a text."""
    head, *_ = answer_table({}).splitlines()
    rows = text[text.index(head) :].partition("\n\n")[0]
    return re.sub(NUMBER, "0", rows), [float(number) for number in re.findall(NUMBER, rows)]


@pytest.mark.slow
def test_the_readme_shows_what_the_scenes_find():
    """The words are the same; a number differs by a unit of its last digit, or by a tenth."""
    readme = shown((Path(__file__).parents[1] / "README.md").read_text("utf-8"))
    made = shown(surfaces.main())
    assert readme[0] == made[0]
    assert readme[1] == pytest.approx(made[1], rel=0.1, abs=1.0)
