"""Summarise a run on one screen of a terminal.

The sentence and the answers are those of the page.
"""

from collections.abc import Iterable, Iterator
from textwrap import shorten, wrap
from typing import TYPE_CHECKING

from sonify.claims.details import unit_and_details
from sonify.claims.surface_summary import complete_answers
from sonify.plan.plan import omissions_after_end
from sonify.plan.rungs import rung_line
from sonify.report.headline import headline, violated_balance

if TYPE_CHECKING:
    from sonify.claims.checks import Check
    from sonify.result import Result

LINE_LENGTH = 100
"""Largest length of a printed line, except for the paths of files."""


def closing_lines(result: "Result") -> list[str]:
    """Return the last lines of a run.

    These are the headline, the answers, the rung of the model, failed checks, the number
    of checks and findings, and the paths of the pictures and the page."""
    assert result.out is not None
    failed = [check for check in result.checks if not check.passed]
    counts = (
        f"{len(result.checks)} checks, {len(result.findings)} findings in report.html"
    )
    return [
        *wrapped(headline(result.findings)),
        *answer_lines(result),
        rung_line(result.plan.motion, LINE_LENGTH),
        *(shorten(line, LINE_LENGTH) for line in check_lines(failed)),
        counts,
        str(result.out / "spectrogram.png"),
        str(result.out / "report.html"),
    ]


def answer_lines(result: "Result") -> Iterator[str]:
    """Yield the answers of the page to its four questions."""
    for question, answer in complete_answers(result.findings).items():
        yield from wrapped(f"{question}: {answer}")


def finding_lines(result: "Result") -> Iterator[str]:
    """Yield all checks, findings and notes of a run."""
    if violated := violated_balance(result.findings):
        yield from wrapped(f"WRONG   {violated}")
    for line in check_lines(result.checks):
        yield from wrapped(line)
    for f in result.findings:
        measured = f"{f.measured} {unit_and_details(f)} ({f.expectation})"
        yield from wrapped(f"{f.answer:9}  {f.claim}: {measured}")
    for line in omissions_after_end(result.motion):
        yield from wrapped(f"note    {line}")


def check_lines(checks: Iterable["Check"]) -> Iterator[str]:
    """Yield one line for each check."""
    for check in checks:
        verdict = "ok    " if check.passed else "FAILED"
        expected = f"(expected {check.expectation})"
        yield f"{verdict}  {check.name}: {check.value:.4g} {expected}"


def wrapped(text: str) -> list[str]:
    """Return the lines of a text; all lines after the first one are indented."""
    return wrap(text, LINE_LENGTH, subsequent_indent="  ", break_on_hyphens=False)
