"""Claim: a map of verdicts says yes, no or undecided, and nothing for a run without the finding.

Source: sonify/sweeps/maps.py. Oracle: the words written out.
"""

import pytest

from sonify.sweeps.maps import verdict_text


@pytest.mark.parametrize(
    ("holds", "value", "words"),
    [
        (True, 1.0, "yes"),
        (False, 0.0, "no"),
        (None, 2.0, "undecided"),
        (None, None, None),
    ],
)
def test_a_verdict_in_words(holds, value, words):
    assert verdict_text(holds, value) == words
