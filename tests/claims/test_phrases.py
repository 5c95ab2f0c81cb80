"""Claim: phrases on the details of a finding state the numbers that they are given.

Source: sonify/claims/phrases.py. Oracle: the sentences written out.
"""

import pytest

from sonify.claims import phrases


def test_shares_and_restitutions_are_listed():
    shares = {"slip": 0.25, "air": 0.5, "half_step": 9.0, "twice_stiff": 9.0}
    assert phrases.shares_in_words(shares) == "slip 0.250, air 0.500"
    words = phrases.restitutions_in_words({"at_2": 0.5, "at_35": 0.123})
    assert words == "50% at a restitution of 0.2, 12% at a restitution of 0.35"


@pytest.mark.parametrize(
    ("numbers", "words"),
    [
        ({"solved": 1}, "solved; never"),
        (
            {"solved": 0, "first": 1.2345},
            "predicted by the linear filter; first 1.23 s after the release",
        ),
    ],
)
def test_losses_of_contact_state_their_method_and_the_first(numbers, words):
    assert phrases.contact_in_words(numbers) == words


@pytest.mark.parametrize(
    ("last", "course"),
    [
        (200.0, "the tone rises from 100 to 200 Hz (2.00-fold, limit 1.3)"),
        (105.0, "the tone stays at 105 Hz (1.05-fold, limit 1.3)"),
        (60.0, "the tone changes from 100 to 60 Hz (0.60-fold, limit 1.3)"),
    ],
)
def test_a_part_of_the_sound_rises_stays_or_changes(last, course):
    numbers = {"tone_from": 100.0, "tone_to": last, "tone_at_least": 1.3}
    assert phrases.rises_in_words(numbers) == course


def test_a_cause_states_its_value_and_its_limit():
    """Those of other causes are in test_loss_causes.py and test_surface_answers.py."""
    numbers = {"open_by_vibration": 1}
    words = phrases.breaks_in_words("vibration_opens_contact", 0.25, 0.1, numbers)
    assert words == (
        "vibration of the disk (it opens the contact for 25% of the time, limit 10%)"
    )
