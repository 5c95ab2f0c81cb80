"""Claim: the cheapest rung with the answers of the most complete solved rung is marked.

Source: `sonify.ladder.comparison` and `sonify.ladder.conclusions`. Oracle: made rows with answers
and CPU times chosen so that the marked rung is known.
"""

from math import inf

import pytest
from ladder_rows import row

from sonify.ladder.comparison import QUESTION_KEYS, compare, deviation
from sonify.ladder.conclusions import deviation_words, screen_line, stretch_sentences


def test_a_failed_self_check_is_shown():
    found = compare([row("a", 1.0) | {"passed": False}, row("b", 2.0)])
    assert screen_line(found, 0).endswith("self-check FAILED")
    assert "self-check" not in screen_line(found, 1)


def failed(rung):
    return {"rung": rung, "cpu_seconds": 0.5, "error": "ValueError: broken"}


def test_the_cheapest_rung_with_the_same_answer_is_marked_for_each_question():
    found = compare(
        [
            row("a", 1.0, pitch={"class": "yes"}, end={"class": "x"}),
            row("b", 2.0, end={"class": "x"}),
            row("c", 8.0),
        ]
    )
    assert found.top == 2
    assert [found.marks[key].answer for key in QUESTION_KEYS] == [0, 1, 0, 2]
    assert found.all_answers == 2


def test_a_higher_rung_is_marked_if_it_is_cheaper():
    """An air film, for example, shortens the motion."""
    found = compare([row("a", 5.0), row("b", 2.0), row("c", 9.0)])
    assert found.all_answers == 1


@pytest.mark.parametrize(("seconds", "marked"), [(2.15, 0), (2.3, 1)])
def test_of_rungs_that_cost_the_same_the_simplest_is_marked(seconds, marked):
    found = compare([row("a", seconds), row("b", 2.0), row("c", 9.0)])
    assert found.all_answers == marked


def test_a_failed_rung_is_neither_marked_nor_the_top():
    found = compare([failed("a"), row("b", 3.0), failed("c")])
    assert found.top == 1
    assert found.deviations[0] is found.deviations[2] is None
    assert found.all_answers == 1


def test_a_rung_with_a_failed_self_check_is_neither_marked_nor_the_top():
    wrong = {"passed": False}
    found = compare([row("a", 1.0) | wrong, row("b", 3.0), row("c", 5.0) | wrong])
    assert (found.top, found.all_answers) == (1, 1)
    assert all(marks == (1, 1) for marks in found.marks.values())


def test_nothing_is_marked_if_every_rung_fails():
    found = compare([failed("a"), failed("b")])
    assert found.top is None
    assert found.all_answers is None
    assert all(marks == (None, None) for marks in found.marks.values())
    assert stretch_sentences("a", "whole motion", found) == [
        "Whole motion: no rung is valid."
    ]


def test_the_number_is_marked_apart_from_the_answer():
    levels = [{"unit": "dB(A)", "number": level} for level in (-67.0, -5.5, -5.0)]
    found = compare(
        [row(name, 1.0 + i, sound=levels[i]) for i, name in enumerate("abc")]
    )
    assert found.marks["sound"] == (0, 1)
    assert found.deviations[0]["sound"].size == pytest.approx(62.0)
    assert found.deviations[0]["sound"].unit == "dB"


@pytest.mark.parametrize(
    ("number", "reference", "size"),
    [
        (1.1, 1.0, 0.1),
        (0.0, 0.0, 0.0),
        (0.1, 0.0, None),
        (inf, 1.0, None),
        (inf, inf, 0),
    ],
)
def test_the_deviation_is_relative_to_the_top_rung(number, reference, size):
    one = row("a", 1.0, end={"number": number})
    found = deviation(one, row("b", 1.0, end={"number": reference}), "end")
    assert found.size == (None if size is None else pytest.approx(size))


@pytest.mark.parametrize(
    "change", [{"number": None}, {"finding": "another"}], ids=["absent", "other"]
)
def test_a_number_that_cannot_be_compared_is_undefined_and_not_zero(change):
    found = deviation(row("a", 1.0, loss=change), row("b", 1.0), "loss")
    assert found.same_answer
    assert (found.size, found.relative_size, found.unit) == (None, None, "")
    assert not found.same_number
    assert deviation_words(found) == "undefined"


def test_equal_answers_without_numbers_agree():
    absent = {"class": "not evaluated", "number": None, "finding": None}
    found = deviation(row("a", 1.0, pitch=absent), row("b", 1.0, pitch=absent), "pitch")
    assert found.same_answer
    assert found.same_number


def test_a_level_is_drawn_as_a_ratio_of_amplitudes():
    level = {"unit": "dB", "number": 20.0}
    top = row("b", 1.0, sound=level | {"number": 0.0})
    assert deviation(row("a", 1.0, sound=level), top, "sound").relative_size == (
        pytest.approx(9.0)
    )


@pytest.mark.parametrize(
    ("own", "sentence"),
    [
        ("a", "The rung of the scene, a, differs in: what ends the motion."),
        ("b", "It is the rung of the scene."),
        ("c", "The rung of the scene, c, agrees and costs 4.0 times as much."),
    ],
)
def test_the_rung_of_the_scene_is_compared(own, sentence):
    found = compare([row("a", 1.0, end={"class": "x"}), row("b", 2.0), row("c", 8.0)])
    first, second = stretch_sentences(own, "whole motion", found)
    assert first.endswith("of the top rung, c (8 s), is b (2 s).")
    assert second == sentence
