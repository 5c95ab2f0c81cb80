"""Sentences on a ladder, and its table in Markdown."""

from collections.abc import Iterator

from sonify.ladder.command import Ladder
from sonify.ladder.comparison import (
    QUESTION_KEYS,
    Comparison,
    Deviation,
    QuestionKey,
    Row,
    is_solved,
)
from sonify.runtime.markdown import markdown_table

QUESTION_HEADS: dict[QuestionKey, str] = {
    "sound": "what do you hear",
    "pitch": "does the pitch rise",
    "loss": "is contact lost",
    "end": "what ends the motion",
}
"""Heads of the columns of the table."""
ANSWER_MARK = "★"
NUMBER_MARK = "◆"
TABLE_LEGEND = (
    f"{ANSWER_MARK} is the cheapest rung with the answer of the top rung, and {NUMBER_MARK} the "
    "cheapest one whose number also agrees within 1 dB or 10 %. The deviation from the top rung "
    "is in brackets; it is undefined if the number of an answer has another meaning."
)


def sentences(ladder: Ladder) -> list[str]:
    """Return the sentences on a ladder, at most two for each stretch."""
    return [
        sentence
        for stretch, comparison in ladder.comparisons.items()
        for sentence in stretch_sentences(ladder.own.name, stretch, comparison)
    ]


def stretch_sentences(own: str, stretch: str, found: Comparison) -> list[str]:
    """Return sentences on the cheapest sufficient rung and on that of the scene."""
    stretch = f"{stretch[0].upper()}{stretch[1:]}"
    if found.top is None:
        return [f"{stretch}: no rung is valid."]
    rows = found.rows
    assert found.all_answers is not None  # the top rung agrees with itself
    top, least = rows[found.top], rows[found.all_answers]
    first = (
        f"{stretch}: the cheapest rung with all answers of the top rung, {top['rung']} "
        f"({top['cpu_seconds']:.0f} s), is {least['rung']} ({least['cpu_seconds']:.0f} s)."
    )
    index = next((i for i, row in enumerate(rows) if row["rung"] == own), None)
    if index is None or found.deviations[index] is None:
        return [first]
    differing = [
        QUESTION_HEADS[key]
        for key, one in (found.deviations[index] or {}).items()
        if not one.same_answer
    ]
    if differing:
        second = f"The rung of the scene, {own}, differs in: {', '.join(differing)}."
    elif index == found.all_answers:
        second = "It is the rung of the scene."
    else:
        spent = rows[index]["cpu_seconds"] / least["cpu_seconds"]
        second = (
            f"The rung of the scene, {own}, agrees and costs {spent:.1f} times as much."
        )
    return [first, second]


def markdown(ladder: Ladder) -> str:
    """Return the page of a ladder: conclusions, tables, and the rungs left out."""
    lines = [
        f"# {ladder.scene.name} on every model",
        "",
        *sentences(ladder),
        "",
        "![Deviation from the top rung against CPU time](ladder.png)",
        "",
        TABLE_LEGEND,
    ]
    for stretch, comparison in ladder.comparisons.items():
        lines += ["", f"## {stretch[0].upper()}{stretch[1:]}", ""]
        lines.append(comparison_table(comparison, ladder.own.name))
    if left_out := list(left_out_lines(ladder)):
        lines += ["", "## Left out", "", *left_out]
    return "\n".join(lines) + "\n"


def comparison_table(found: Comparison, own: str) -> str:
    """Return the table of one stretch."""
    head = ["rung", "CPU [s]", "predicted [s]", *QUESTION_HEADS.values(), "values"]
    cells = [head]
    for index, row in enumerate(found.rows):
        name = f"**{row['rung']}**" if row["rung"] == own else row["rung"]
        name += failed_check(row)
        predicted = f"{row['predicted_seconds']:.0f}"
        settings = f"`{row['set']}`" if row["set"] else "the scene itself"
        if not is_solved(row):
            answers = [str(row["error"]), *[""] * (len(QUESTION_KEYS) - 1)]
            spent = ""
        else:
            answers = [answer_cell(found, index, key) for key in QUESTION_KEYS]
            spent = f"{row['cpu_seconds']:.1f}"
        cells.append([name, spent, predicted, *answers, settings])
    return markdown_table(cells)


def answer_cell(found: Comparison, index: int, key: QuestionKey) -> str:
    """Return the answer of a rung with its marks and its deviation."""
    deviations = found.deviations[index]
    assert deviations is not None  # the rung was solved
    marks = found.marks[key]
    stars = ANSWER_MARK * (marks.answer == index) + NUMBER_MARK * (
        marks.number == index
    )
    words = str(found.rows[index][f"answer_{key}"])
    shown = "" if index == found.top else f" ({deviation_words(deviations[key])})"
    return f"{stars} {words}{shown}".strip()


def deviation_words(found: Deviation) -> str:
    """Return a deviation in words."""
    other = "" if found.same_answer else "another answer, "
    if found.unit == "dB":
        return f"{other}{found.size:.2g} dB"
    if found.unit == "relative":
        return f"{other}{found.size:.2g}"
    return f"{other}undefined"


def left_out_lines(ladder: Ladder) -> Iterator[str]:
    """Yield a line for each rung that is not solved over the whole motion."""
    for one in ladder.omitted:
        yield (
            f"* {one.rung.rung.name}, {one.stretch}: predicted to take "
            f"{one.rung.seconds:.0f} s"
        )
    for other in ladder.inapplicable:
        yield f"* {other.rung.name}: {other.reason}"


def screen_lines(ladder: Ladder) -> list[str]:
    """Return the lines that the command prints: a row for each rung, and conclusions."""
    lines = []
    for stretch, found in ladder.comparisons.items():
        lines.append(f"{stretch}:")
        lines += [screen_line(found, index) for index in range(len(found.rows))]
    return [*lines, *sentences(ladder)]


def screen_line(found: Comparison, index: int) -> str:
    """Return the rung, its CPU time and its deviations on one line."""
    row: Row = found.rows[index]
    deviations = found.deviations[index]
    if deviations is None:
        return f"     -  {row['rung']:24} {row['error']}"
    parts = []
    for key, one in deviations.items():
        star = ANSWER_MARK * (found.marks[key].answer == index)
        state = "same" if one.same_answer else "other"
        size = "" if one.size is None else f" {one.size:.2g}"
        unit = " dB" * (one.unit == "dB")
        parts.append(f"{key} {star}{state}{size}{unit}")
    failed = failed_check(row)
    return f"{row['cpu_seconds']:6.1f} s {row['rung']:24} {', '.join(parts)}{failed}"


def failed_check(row: Row) -> str:
    """Return a clause on a failed self-check of a row, or ""."""
    return ", self-check FAILED" if row.get("passed") is False else ""
