"""Rows of a ladder made for tests."""

from sonify.ladder.comparison import QUESTION_KEYS

DEFAULTS = {
    "answer": "no",
    "class": "no",
    "number": 1.0,
    "unit": "times",
    "finding": "one",
}


def row(rung, seconds, error=None, **answers):
    """Return a row whose answers are DEFAULTS except for those given by question."""
    made = {"rung": rung, "cpu_seconds": seconds, "error": error}
    for key in QUESTION_KEYS:
        for part, value in (DEFAULTS | answers.get(key, {})).items():
            made[f"{part}_{key}"] = value
    return made
