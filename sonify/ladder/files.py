"""Files of a ladder: ladder.json, ladder.md, ladder.png, and a scene for each row."""

from typing import Any

from sonify.ladder.command import Ladder, scene_records
from sonify.ladder.comparison import QUESTION_KEYS, Comparison, Deviation, Row
from sonify.ladder.conclusions import markdown, sentences
from sonify.runtime.files import atomic_write, create_folder, write_text
from sonify.runtime.json_values import json_safe, write_json

ROW_COLUMNS = (
    "rung",
    "stretch",
    "set",
    "model",
    "predicted_seconds",
    "cpu_seconds",
    "t_end",
    "outcome",
    "error",
)


def write_ladder(ladder: Ladder) -> None:
    """Write the files of a ladder into its folder, next to its table."""
    from sonify.ladder.plotting import draw_ladder  # slow import

    scenes = create_folder(ladder.folder / "scenes")
    for name, record in scene_records(ladder).items():
        write_json(record, scenes / name)
    write_json(ladder_record(ladder), ladder.folder / "ladder.json")
    write_text(markdown(ladder), ladder.folder / "ladder.md")
    with atomic_write(ladder.folder / "ladder.png") as temporary:
        draw_ladder(ladder, temporary)


def ladder_record(ladder: Ladder) -> dict[str, Any]:
    """Return the content of ladder.json as plain, finite values."""
    return json_safe(
        {
            "scene": ladder.scene.name,
            "own_rung": ladder.own.name,
            "conclusions": sentences(ladder),
            "stretches": [
                {"stretch": stretch} | stretch_record(found)
                for stretch, found in ladder.comparisons.items()
            ],
            "omitted": [
                {
                    "rung": one.rung.rung.name,
                    "stretch": one.stretch,
                    "predicted_seconds": one.rung.seconds,
                }
                for one in ladder.omitted
            ],
            "inapplicable": [
                {"rung": one.rung.name, "reason": one.reason}
                for one in ladder.inapplicable
            ],
        }
    )


def stretch_record(found: Comparison) -> dict[str, Any]:
    """Return the rows over one stretch with deviations and marks."""
    rows = []
    for row, deviations in zip(found.rows, found.deviations, strict=True):
        record = {name: row.get(name) for name in ROW_COLUMNS}
        if deviations is not None:
            record["answers"] = {
                key: answer_record(row, key, deviations[key]) for key in QUESTION_KEYS
            }
        rows.append(record)
    names = [row["rung"] for row in rows]
    return {
        "rows": rows,
        "top": None if found.top is None else names[found.top],
        "marked": None if found.all_answers is None else names[found.all_answers],
        "marks": {
            key: {
                kind: None if index is None else names[index]
                for kind, index in marks._asdict().items()
            }
            for key, marks in found.marks.items()
        },
    }


def answer_record(row: Row, key: str, deviation: Deviation) -> dict[str, Any]:
    """Return an answer with its number and its deviation."""
    parts = ("answer", "class", "number", "unit", "finding")
    return {part: row.get(f"{part}_{key}") for part in parts} | {
        "deviation": deviation.size,
        "deviation_unit": deviation.unit,
        "same_answer": deviation.same_answer,
        "same_number": deviation.same_number,
    }
