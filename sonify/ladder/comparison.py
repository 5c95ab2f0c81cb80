"""Comparison of the rungs of a ladder with the top one, from their rows alone."""

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any, Literal, NamedTuple

Row = Mapping[str, Any]
QuestionKey = Literal["sound", "pitch", "loss", "end"]
QUESTION_KEYS: tuple[QuestionKey, ...] = ("sound", "pitch", "loss", "end")
"""Suffixes of the columns of each question."""
MAX_SAME_LEVEL_DB = 1.0
"""Difference [dB] up to which two levels count as the same number."""
MAX_SAME_RELATIVE = 0.1
"""Relative difference up to which two other numbers count as the same."""
SAME_COST_FACTOR = 1.1
"""Ratio of CPU times up to which two rungs cost the same."""


class Deviation(NamedTuple):
    """Deviation of the answer of a rung from that of the top rung.

    Attributes
    ----------
    same_answer : bool
        True if the class of the answer is the same.
    size : float or None
        Difference of the numbers, in dB for levels and otherwise relative to the number
        of the top rung; None if a number is undefined or the numbers are not of the same
        finding.
    unit : str
        "dB", "relative", or "" without a size.
    same_number : bool
        True if the numbers agree within MAX_SAME_LEVEL_DB or MAX_SAME_RELATIVE, or if
        the same answer has no number on both rungs.
    """

    same_answer: bool
    size: float | None
    unit: Literal["dB", "relative", ""]
    same_number: bool

    @property
    def relative_size(self) -> float | None:
        """The size as a relative difference; a level becomes one of amplitude."""
        if self.size is None or self.unit != "dB":
            return self.size
        return 10 ** (self.size / 20) - 1


class Marks(NamedTuple):
    """Indices of the cheapest rungs that agree with the top rung on a question.

    `answer` gives the same answer, and `number` also the same number; None without rows.
    """

    answer: int | None
    number: int | None


class Comparison(NamedTuple):
    """Rows over one stretch, compared with the top rung.

    Attributes
    ----------
    rows : sequence of mapping
        The rows, from the simplest to the most complete rung.
    top : int or None
        Index of the highest valid rung.
    deviations : list of dict, or None for a failed rung
        Deviations by question.
    marks : dict
        Marks by question.
    all_answers : int or None
        Index of the cheapest rung that gives all answers of the top rung.
    """

    rows: Sequence[Row]
    top: int | None
    deviations: list[dict[QuestionKey, Deviation] | None]
    marks: dict[QuestionKey, Marks]
    all_answers: int | None


def compare(rows: Sequence[Row]) -> Comparison:
    """Compare rows, from the simplest to the most complete rung, with the top one.

    A rung with a failed self-check is neither the top nor marked.
    """
    valid = [index for index, row in enumerate(rows) if is_valid(row)]
    if not valid:
        none: dict[QuestionKey, Marks] = {
            key: Marks(None, None) for key in QUESTION_KEYS
        }
        return Comparison(rows, None, [None] * len(rows), none, None)
    top = valid[-1]
    deviations = [
        {key: deviation(row, rows[top], key) for key in QUESTION_KEYS}
        if is_solved(row)
        else None
        for row in rows
    ]
    seconds = [row.get("cpu_seconds") if is_valid(row) else None for row in rows]
    marks: dict[QuestionKey, Marks] = {}
    for key in QUESTION_KEYS:
        found = [None if each is None else each[key] for each in deviations]
        marks[key] = Marks(
            cheapest(seconds, [one is not None and one.same_answer for one in found]),
            cheapest(seconds, [one is not None and one.same_number for one in found]),
        )
    agrees = [
        each is not None and all(one.same_answer for one in each.values())
        for each in deviations
    ]
    return Comparison(rows, top, deviations, marks, cheapest(seconds, agrees))


def is_solved(row: Row) -> bool:
    """Return True if a rung was solved."""
    return row.get("error") is None and row.get("cpu_seconds") is not None


def is_valid(row: Row) -> bool:
    """Return True if a rung was solved and no self-check failed."""
    return is_solved(row) and row.get("passed") is not False


def deviation(row: Row, top: Row, key: QuestionKey) -> Deviation:
    """Return the deviation of the answer of a row from that of the top row."""
    same = row[f"class_{key}"] == top[f"class_{key}"]
    number, reference = row.get(f"number_{key}"), top.get(f"number_{key}")
    same_finding = row.get(f"finding_{key}") == top.get(f"finding_{key}")
    if number is None and reference is None:
        return Deviation(same, None, "", same)
    if number is None or reference is None or not same_finding:
        return Deviation(same, None, "", False)
    if (top.get(f"unit_{key}") or "").startswith("dB"):
        size = abs(number - reference)
        return Deviation(same, size, "dB", same and size <= MAX_SAME_LEVEL_DB)
    relative = relative_difference(number, reference)
    if relative is None:
        return Deviation(same, None, "", False)
    return Deviation(same, relative, "relative", same and relative <= MAX_SAME_RELATIVE)


def relative_difference(number: float, reference: float) -> float | None:
    """Return |number/reference - 1|; None if it is undefined for a reference of 0."""
    if number == reference:
        return 0.0
    if reference == 0 or not isfinite(number) or not isfinite(reference):
        return None
    return abs(number / reference - 1)


def cheapest(seconds: Sequence[float | None], agrees: Sequence[bool]) -> int | None:
    """Return the index of the cheapest rung among those that agree, or None.

    Of rungs that cost the same within SAME_COST_FACTOR, it is the simplest.
    """
    costs = [
        (index, cost)
        for index, (cost, ok) in enumerate(zip(seconds, agrees, strict=True))
        if ok and cost is not None
    ]
    if not costs:
        return None
    least = min(cost for _, cost in costs)
    return next(index for index, cost in costs if cost <= SAME_COST_FACTOR * least)
