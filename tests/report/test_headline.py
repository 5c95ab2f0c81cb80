"""Claim: the first sentence of a page states what its findings decide, and nothing else.

Source: the findings of a run. Oracle: findings made by hand, for each verdict.
"""

import pytest
from made_findings import found

from sonify.report.headline import headline


@pytest.mark.parametrize(
    ("findings", "sentence"),
    [
        ([], ""),
        ([found("contact_kept", 1.0)], "The disk never leaves the table."),
        ([found("contact_kept", -1.0)], "The disk leaves the table."),
        ([found("contact_kept", 1.0, margin=2.0)], ""),
        (
            [found("pitch_rises", -1.0), found("contact_kept", 1.0)],
            "The pitch does not rise, and the disk never leaves the table.",
        ),
        (
            [
                found("modes_carry_the_end", -1.0),
                found("pitch_rises", 1.0),
                found("contact_kept", 1.0),
            ],
            "You hear the disk move rather than ring, the pitch rises, and the disk never leaves "
            "the table.",
        ),
        (
            [found("pitch_rises", 1.0), found("carrier_rises", -1.0)],
            "The pitch rises.",
        ),
        (
            [
                found("heard_through_film", -1.0),
                found("contact_kept", -1.0),
                found("carried_by_air", 1.0, cause="film"),
            ],
            "The motion of the disk is inaudible, and finally the air lifts it.",
        ),
        (
            [found("contact_kept", 1.0), found("carried_by_air", 1.0)],
            "The disk never leaves the table.",
        ),
    ],
)
def test_the_sentence_follows_the_verdicts(findings, sentence):
    assert headline(findings) == sentence
