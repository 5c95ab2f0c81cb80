"""Short answers from the findings on each surface.

The questions concern the sound source, the pitch, losses of contact and the cause of
the end."""

from collections.abc import Iterable, Mapping

from sonify.claims.energy_causes import CAUSE_IN_WORDS
from sonify.claims.finding import Finding
from sonify.claims.finding_texts import (
    END_QUESTION,
    LOSS_QUESTION,
    NO_ANSWER_REASONS,
    SOUND_QUESTION,
    AnswerSentences,
    texts_by_question,
)

SURFACE_BY_SCENE = {
    "published": "rigid table",
    "glass-plate": "glass, 6 mm",
    "wood-table": "wooden table",
    "light-plate": "glass, 3 mm",
    "granite": "granite slab",
    "mirror-base": "the toy's mirror",
    "coin": "stone, a coin",
}
"""Surface under the disk, by scene."""


ANSWERS: dict[str, dict[str, AnswerSentences]] = texts_by_question("answers")
"""Answers by question and by key of a finding; the first available finding with an
answer gives it."""
AIR_QUESTION = "in air"
"""Table column on the same scene with an air film."""


def complete_answers(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answer to each question from the findings of a run, or the reason for
    its absence."""
    found = short_answers(findings)
    return {
        question: found.get(question, f"not evaluated: {NO_ANSWER_REASONS[question]}")
        for question in ANSWERS
    }


def short_answers(findings: Iterable[Finding]) -> dict[str, str]:
    """Return the answers to the questions that the findings of a run cover, by
    question.

    Answers about the sound state whether it is audible. A disk carried by the air film
    finally loses contact, whether or not it vibrates. Answers about a motion without a
    film are marked as answers in a vacuum. The end is not answered if the table would
    take more power than the disk loses."""
    by_key = {finding.key: finding for finding in findings}
    answers = {
        question: first_answer(by_key, words) for question, words in ANSWERS.items()
    }
    found = {question: answer for question, answer in answers.items() if answer}
    audible = by_key.get("sound_is_audible")
    if audible and audible.verdict == "no":
        found[SOUND_QUESTION] = "nothing above the threshold of hearing"
    elif audible and SOUND_QUESTION in found:
        share = audible.details["audible_share"]
        found[SOUND_QUESTION] += f", audible {share:.0%}"
    carried = by_key.get("carried_by_air")
    if carried and not carried.cause:
        for question in found.keys() - {SOUND_QUESTION}:
            found[question] += ", in a vacuum"
    supply = by_key.get("disk_supplies_table")
    if supply and supply.verdict == "no":
        found[END_QUESTION] = (
            f"not valid: the table would take {supply.value:.0%} of the power"
        )
    if LOSS_QUESTION in found and carried and carried.holds and carried.cause == "film":
        found[LOSS_QUESTION] += (
            ", to the air" if found[LOSS_QUESTION] == "yes" else "; finally to the air"
        )
    return found


def answer_in_air(findings: Iterable[Finding]) -> str:
    """Return a description of the end of a motion with an air film, from its
    findings."""
    # Smallest change of the end of the motion by the table [s] that is reported
    min_reported_end_change = 0.05
    by_key = {finding.key: finding for finding in findings}
    carried = by_key.get("carried_by_air")
    if "disk_rattles" in by_key:
        return "rattles in air"
    if carried is None or not carried.cause:
        return "not evaluated: there is no film of air"
    if not carried.holds:
        return "the air does not carry the disk"
    words = f"carried after {carried.details['time']:.5g} s"
    table = by_key.get("air_carries_earlier")
    if table is None:
        return words
    if abs(table.value) >= min_reported_end_change:
        return f"{words}, {table.value:.2f} s earlier than on a rigid table"
    acts = 1e3 * table.details["acts_before_end"]
    when = f"acts for {acts:.2g} ms" if acts else "never acts"
    return f"{words}, as on a rigid table; {when}"


def first_answer(
    by_key: Mapping[str, Finding], words: Mapping[str, AnswerSentences]
) -> str:
    """Return the answer of the first finding in `words` that is available in `by_key`
    and has an answer; otherwise an empty text."""
    for key, sentences in words.items():
        if key in by_key:
            finding = by_key[key]
            answer = getattr(sentences, finding.verdict).format(
                value=finding.value,
                cause=CAUSE_IN_WORDS.get(finding.cause, ""),
                **finding.details,
            )
            if answer:
                return answer
    return ""


def answer_table(
    runs: Mapping[str, Iterable[Finding]], in_air: Mapping[str, Iterable[Finding]]
) -> str:
    """Return a Markdown table of answers, one row per scene, from the findings by scene
    name.

    `in_air` contains the findings on the motions of the same scenes with an air film.
    """
    header = ["scene", "the disk is on", *ANSWERS, AIR_QUESTION]
    rows = [
        [
            f"`{name}`",
            SURFACE_BY_SCENE[name],
            *complete_answers(findings).values(),
            answer_in_air(in_air[name]),
        ]
        for name, findings in runs.items()
    ]
    lines = [f"|{'|'.join(row)}|" for row in (header, *rows)]
    lines.insert(1, "|---" * len(header) + "|")
    return "\n".join(lines)
