"""Short answers from the findings on each surface.

The questions concern the sound source, the pitch, losses of contact and the cause of
the end."""

from collections.abc import Iterable, Mapping

from sonify.claims.details import details_in_words
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
from sonify.claims.phrases import breaks_in_words

SURFACE_BY_SCENE = {
    "published": "rigid table",
    "glass-plate": "glass, 6 mm",
    "wood-table": "wooden table",
    "light-plate": "glass, 3 mm",
    "granite": "granite slab",
    "toy": "the toy's mirror",
    "coin": "stone, a coin",
}
"""Surface under the disk, by scene."""


ANSWERS: dict[str, dict[str, AnswerSentences]] = texts_by_question("answers")
"""Answers by question and by key of a finding; the first available finding with an
answer gives it."""
LOSS_CAUSES = (
    "carried_by_air",
    "vibration_opens_contact",
    "table_breaks_contact",
    "unevenness_breaks_contact",
)
"""Keys of the findings on the causes of a loss of contact."""
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

    Answers about the sound state whether it is audible. That about the contact names what
    breaks it. Answers about a motion without a film are marked as answers in a vacuum.
    The end is not answered if the table would take more power than the disk loses."""
    by_key = {finding.key: finding for finding in findings}
    answers = {
        question: first_answer(by_key, words) for question, words in ANSWERS.items()
    }
    answers[LOSS_QUESTION] = loss_answer(by_key) or answers[LOSS_QUESTION]
    found = {question: answer for question, answer in answers.items() if answer}
    audible = by_key.get("sound_is_audible")
    if is_inaudible(by_key):
        found[SOUND_QUESTION] = "nothing above the threshold of hearing"
    elif audible and SOUND_QUESTION in found:
        share = audible.details["audible_share"]
        found[SOUND_QUESTION] += f", audible for {share:.0%} of the time"
    carried = by_key.get("carried_by_air")
    if carried and not carried.cause:
        for question in found.keys() - {SOUND_QUESTION}:
            found[question] += ", in a vacuum"
    if table_takes_too_much(by_key):
        supply = by_key["disk_supplies_table"]
        found[END_QUESTION] = (
            f"not valid: the table would take {supply.value:.0%} of the power"
        )
    return found


def judged_loss_causes(by_key: Mapping[str, Finding]) -> list[Finding]:
    """Return the findings on the causes of a loss of contact that apply to the run.

    The film breaks the contact only where it is a part of the motion."""
    return [
        by_key[key]
        for key in LOSS_CAUSES
        if key in by_key and (key != "carried_by_air" or by_key[key].cause == "film")
    ]


def loss_answer(by_key: Mapping[str, Finding]) -> str:
    """Return the answer to the question of lost contact from the findings on its causes,
    with their limits; an empty text if no cause is judged."""
    clauses: dict[str, list[str]] = {"yes": [], "undecided": [], "no": []}
    for found in judged_loss_causes(by_key):
        words = breaks_in_words(found.key, found.value, found.at_least, found.details)
        if found.undecided_because:
            words += f", {found.undecided_because}"
        clauses[found.verdict].append(words)
    if not any(clauses.values()):
        return ""
    only_no = not clauses["yes"] and not clauses["undecided"]
    heads = {
        "yes": "yes, by ",
        "undecided": "undecided: by ",
        "no": "no, not by " if only_no else "not by ",
    }
    links = {"yes": " and by ", "undecided": " and by ", "no": ", nor by "}
    return "; ".join(
        heads[verdict] + links[verdict].join(words)
        for verdict, words in clauses.items()
        if words
    )


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
        return "the air does not lift the disk"
    words = f"lifted after {carried.details['time']:.5g} s"
    table = by_key.get("air_carries_earlier")
    if table is None:
        return words
    if abs(table.value) >= min_reported_end_change:
        return f"{words}, {table.value:.2f} s earlier than on a rigid table"
    acts = 1e3 * table.details["acts_before_end"]
    coupling = (
        f"two-way coupling for the last {acts:.2g} ms"
        if acts
        else "no two-way coupling"
    )
    return f"{words}, as on a rigid table; {coupling}"


def is_inaudible(by_key: Mapping[str, Finding]) -> bool:
    """Return True if the sound remains below the threshold of hearing."""
    audible = by_key.get("sound_is_audible")
    return audible is not None and audible.verdict == "no"


def table_takes_too_much(by_key: Mapping[str, Finding]) -> bool:
    """Return True if the table would take more power than the disk loses."""
    supply = by_key.get("disk_supplies_table")
    return supply is not None and supply.verdict == "no"


def first_answer(
    by_key: Mapping[str, Finding], words: Mapping[str, AnswerSentences]
) -> str:
    """Return the answer of the first finding in `words` that is available in `by_key`
    and has an answer; otherwise an empty text."""
    finding = answering_finding(by_key, words)
    if finding is None:
        return ""
    template = getattr(words[finding.key], finding.verdict)
    told = {}
    if "{told}" in template:
        told["told"] = finding.undecided_because or details_in_words(finding)
    return template.format(
        value=finding.value,
        cause=CAUSE_IN_WORDS.get(finding.cause, ""),
        **finding.details,
        **told,
    )


def answering_finding(
    by_key: Mapping[str, Finding], words: Mapping[str, AnswerSentences]
) -> Finding | None:
    """Return the first finding in `words` that is available in `by_key` and has an
    answer, or None."""
    for key, sentences in words.items():
        if key in by_key and getattr(sentences, by_key[key].verdict):
            return by_key[key]
    return None


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
