"""Solution of one rung in a process, with its answers and its CPU time."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from time import process_time
from typing import Any

from sonify.claims.finding import Finding
from sonify.claims.finding_texts import (
    END_QUESTION,
    LOSS_QUESTION,
    PITCH_QUESTION,
    SOUND_QUESTION,
)
from sonify.claims.surface_summary import (
    ANSWERS,
    answering_finding,
    complete_answers,
    is_inaudible,
    judged_loss_causes,
    table_takes_too_much,
)
from sonify.pipeline import solve
from sonify.plan.rungs import rung_of
from sonify.report.write import summary
from sonify.runtime.progress import Stages, Watch
from sonify.scene import from_document
from sonify.sweeps.run_row import guarded_row

QUESTION_BY_COLUMN = {
    "sound": SOUND_QUESTION,
    "pitch": PITCH_QUESTION,
    "loss": LOSS_QUESTION,
    "end": END_QUESTION,
}
"""The four questions by the suffix of their columns."""
YES_NO_QUESTIONS = (PITCH_QUESTION, LOSS_QUESTION)
VERDICT_ORDER = ("yes", "undecided", "no")


class CpuLimitError(Exception):
    """Raised if a rung takes more CPU time than it may."""


class CpuLimitedStages(Stages):
    """Stages that stop with CpuLimitError when the process exceeds a CPU time [s]."""

    def __init__(self, limit: float):
        super().__init__()
        self.limit = limit

    @contextmanager
    def stage(self, name: str) -> Iterator[Watch]:
        """Time the block as stage `name`, and yield a callback that stops it."""

        def check(share: float, note: str = "") -> None:
            if process_time() > self.limit:
                raise CpuLimitError(f"more than {self.limit:g} s of CPU time")

        with super().stage(name):
            yield check


def rung_row(document: dict[str, Any], limit: float) -> dict[str, Any]:
    """Solve the scene in `document`, and return its scalars and answers as a row.

    `cpu_seconds` is the CPU time of the process since its start, with imports and
    compilation; a run is stopped when it exceeds `limit` [s]. If the run fails, the row
    contains a one-line `error`.
    """

    def solved(watch: Stages) -> dict[str, Any]:
        result = solve(from_document(document), stages=watch)
        used = rung_of(result.plan.motion)
        return summary(result) | answer_columns(result.findings) | {"model": used.name}

    row = guarded_row(solved, CpuLimitedStages(limit))
    return row | {"cpu_seconds": process_time()}


def answer_columns(findings: Iterable[Finding]) -> dict[str, Any]:
    """Return the words, class, number, unit and finding of each answer.

    A question without a finding has neither a number nor a unit.
    """
    findings = list(findings)
    by_key = {finding.key: finding for finding in findings}
    words = complete_answers(findings)
    row: dict[str, Any] = {}
    for name, question in QUESTION_BY_COLUMN.items():
        found = deciding_finding(question, by_key)
        row |= {
            f"answer_{name}": words[question],
            f"class_{name}": answer_class(question, found, by_key),
            f"number_{name}": None if found is None else found.value,
            f"unit_{name}": None if found is None else found.unit,
            f"finding_{name}": None if found is None else found.key,
        }
    return row


def deciding_finding(question: str, by_key: dict[str, Finding]) -> Finding | None:
    """Return the finding whose number stands for the answer to a question, or None.

    For a loss of contact it is a cause that breaks it, else an undecided one, else the first.
    """
    causes = judged_loss_causes(by_key) if question == LOSS_QUESTION else []
    if causes:
        return min(causes, key=lambda found: VERDICT_ORDER.index(found.verdict))
    return answering_finding(by_key, ANSWERS[question])


def answer_class(
    question: str, found: Finding | None, by_key: dict[str, Finding]
) -> str:
    """Return the class of an answer; two runs agree on a question if it is the same.

    For a question of yes or no it is this word, and otherwise the finding with its
    verdict and cause. For a loss of contact it also names the causes that break it.
    """
    if question == SOUND_QUESTION and is_inaudible(by_key):
        return "inaudible"
    if question == END_QUESTION and table_takes_too_much(by_key):
        return "not valid"
    if found is None:
        return "not evaluated"
    if question == LOSS_QUESTION and (causes := judged_loss_causes(by_key)):
        breaking = [cause.key for cause in causes if cause.verdict == found.verdict]
        return (
            "no" if found.verdict == "no" else f"{found.verdict}: {', '.join(breaking)}"
        )
    if found.verdict == "undecided":
        return "undecided"
    if question in YES_NO_QUESTIONS:
        sentence = getattr(ANSWERS[question][found.key], found.verdict)
        return "yes" if sentence.startswith("yes") else "no"
    return " ".join(filter(None, (found.key, found.verdict, found.cause)))
