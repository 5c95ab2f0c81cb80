"""FINDINGS -> ANSWERS: for each surface, the sound source, the pitch, losses of contact, and the
cause of the end.
"""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from sonify.claims.air import CAUSE_IN_WORDS
from sonify.claims.finding import Finding

SURFACES = {
    "published": "rigid table, in a vacuum",
    "granite": "rough granite slab, in air",
    "glass-plate": "glass plate, 6 mm thick, in a vacuum",
    "wood-table": "wooden table on four feet, in a vacuum",
    "light-plate": "light glass plate, 3 mm thick, in a vacuum",
}
"""Scene -> the surface under its disk and the surrounding medium."""


class AnswerSentences(NamedTuple):
    """Answers to a question if a claim holds, fails or is undecided; {value} is its value."""

    yes: str
    no: str
    undecided: str


LAST_ENERGY_TEXT = "{value:.0%} of the last tenth of the energy"
LEVEL_TEXT = "{value:+.0f} dB(A)"
ANSWERS: dict[str, dict[str, AnswerSentences]] = {
    "what you hear": {
        "table_is_louder": AnswerSentences(
            f"the table, {LEVEL_TEXT} relative to the disk",
            f"the disk, the table {LEVEL_TEXT} relative to it",
            f"undecided: the table, {LEVEL_TEXT} relative to the disk",
        ),
        "carrier_is_contact": AnswerSentences(
            "the contact resonance, at {value:.2f} of the predicted frequency",
            "a resonance at {value:.2f} times the frequency of the contact's",
            "undecided: the contact resonance, at {value:.2f} of the predicted frequency",
        ),
        "modes_carry_the_end": AnswerSentences(
            f"the modes, {LEVEL_TEXT} relative to the motion in the last second",
            f"the motion of the disk, its modes {LEVEL_TEXT} relative to it in the last second",
            f"undecided: the modes, {LEVEL_TEXT} relative to the motion in the last second",
        ),
    },
    "does the pitch rise": {
        "table_tone_rises": AnswerSentences("yes", "no", "undecided"),  # the factor is chaotic
        "carrier_rises": AnswerSentences(
            "yes, {value:.1f} times", "no, {value:.1f} times", "undecided, {value:.1f} times"
        ),
        "pitch_rises": AnswerSentences(
            "yes, {value:.1f} times", "no, {value:.1f} times", "undecided, {value:.1f} times"
        ),
    },
    "is contact lost": {
        "table_breaks_contact": AnswerSentences("yes", "no", "undecided"),
        "contact_is_lost": AnswerSentences(
            "yes, {value:.1%} of the time",
            "no, {value:.1%} of the time",
            "undecided, {value:.1%} of the time",
        ),
        "contact_kept": AnswerSentences(
            "no, the least force is {value:.1f} of the weight",
            "yes",
            "undecided, the least force is {value:.1f} of the weight",
        ),
    },
    "what ends the motion": {
        "halt_comes_earlier": AnswerSentences(
            "the table, {value:.1f} s earlier than with one-way coupling",
            "the same as with one-way coupling, {value:.1f} s earlier",
            "undecided: the table, {value:.1f} s earlier than with one-way coupling",
        ),
        "table_takes_little": AnswerSentences(
            "as on a rigid table",
            "the table, not solved: {value:.1f} s before the end it would hold as much energy as "
            "the disk",
            "undecided: the table, not solved, {value:.1f} s before the end",
        ),
        "what_ends": AnswerSentences(
            f"{{cause}}: {LAST_ENERGY_TEXT}",
            f"several causes, most of it {{cause}}: {LAST_ENERGY_TEXT}",
            f"undecided: {{cause}}, {LAST_ENERGY_TEXT}",
        ),
    },
}
"""Question -> key of a finding -> its answers; the first finding that a run has is used."""
LOSS_QUESTION = "is contact lost"


def complete_answers(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answer to each question from the findings of a run.

    Raises
    ------
    LookupError
        If no finding answers one of the questions.
    """
    found = answers_in_short(findings)
    for question in ANSWERS.keys() - found.keys():
        raise LookupError(f"none of the findings {', '.join(ANSWERS[question])}")
    return found


def answers_in_short(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answers to those questions that the findings of a run can answer.

    A disk carried by the air film has lost its contact at the end, independently of vibrations.
    """
    by_key = {finding.key: finding for finding in findings}
    found = {
        question: first_answer(by_key, words)
        for question, words in ANSWERS.items()
        if by_key.keys() & words
    }
    carried = by_key.get("carried_by_air")
    if LOSS_QUESTION in found and carried and carried.holds and carried.cause == "film":
        found[LOSS_QUESTION] += (
            ", to the air"
            if found[LOSS_QUESTION] == "yes"
            else "; finally the air carries the disk"
        )
    return found


def first_answer(by_key: Mapping[str, Finding], words: Mapping[str, AnswerSentences]) -> str:
    key = next(key for key in words if key in by_key)
    finding = by_key[key]
    cause = CAUSE_IN_WORDS.get(finding.cause, "")
    return getattr(words[key], finding.verdict).format(value=finding.value, cause=cause)


def answer_table(runs: Mapping[str, Iterable[Finding]]) -> str:
    """Return a Markdown table of answers, one row per scene, from the findings by scene name."""
    header = ["scene", "the disk is on", *ANSWERS]
    rows = [
        [f"`{name}`", SURFACES[name], *complete_answers(findings).values()]
        for name, findings in runs.items()
    ]
    lines = [f"| {' | '.join(row)} |" for row in (header, *rows)]
    lines.insert(1, "|---" * len(header) + "|")
    return "\n".join(lines)
