"""What a chart is made of: one record per run, timed by the median of repeated runs.

Seconds are those of the processor, so that what else the machine does counts less.
"""

import csv
import math
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from statistics import median
from time import process_time
from typing import Any, NamedTuple

from sonify.files import whole

REPEATS = 5
"""How often a run is timed, as long as that takes less than PATIENCE."""
PATIENCE = 2.0
"""Seconds that the repetitions of one run may take; a longer run is timed once."""


LEFT_OUT = "left out"
"""How the message of a Failure begins where nothing failed but what a method needs is not installed."""


class Failure(Exception):
    """The method gave up or gave nonsense; the message names the way in a few words."""


class Answer(NamedTuple):
    """What a method found: numbers to compare, and the steps it took."""

    values: Any
    steps: int


@dataclass(frozen=True, kw_only=True)
class Record:
    """One run: `error` relative to the reference, processor `seconds` (median of `repeats`), or the way it failed."""

    family: str
    method: str
    setting: str
    case: str
    error: float = math.nan
    steps: int = 0
    seconds: float = math.nan
    repeats: int = 0
    failure: str = ""

    @property
    def left_out(self) -> bool:
        """Whether nothing was run because something is not installed."""
        return self.failure.startswith(LEFT_OUT)


WRONG = 1e-2
"""A relative error above this is a failure: the answer is not what was asked for."""


class Work(NamedTuple):
    """A run to be made: family, method and setting for the legend, the case, the call that makes it, and its judge."""

    family: str
    method: str
    setting: str
    case: str
    call: Callable[[], Answer]
    error: Callable[[tuple], float]
    wrong: float = WRONG


def spent() -> float:
    """Return the processor time [s] of this process and of the programs that it has called and seen end."""
    children = os.times()
    return process_time() + children.children_user + children.children_system


def measure(work: Work, warm: bool = False, repeats: int = REPEATS) -> Record:
    """Run `work` and return its record; with `warm` one run before the first counts for nothing (it compiles)."""
    about = {"family": work.family, "method": work.method, "setting": work.setting, "case": work.case}
    began = spent()
    try:
        answer = work.call()
    except Failure as failure:
        return Record(**about, seconds=spent() - began, repeats=1, failure=str(failure))
    seconds = [] if warm else [spent() - began]
    while not seconds or (len(seconds) < repeats and sum(seconds) + seconds[-1] < PATIENCE):
        began = spent()
        work.call()
        seconds.append(spent() - began)
    error = work.error(answer.values)
    wrong = "" if error <= work.wrong else f"wrong by {100 * error:.2g} %"
    return Record(
        **about, error=error, steps=answer.steps, seconds=median(seconds), repeats=len(seconds), failure=wrong
    )


def measured(
    works: list[Work], watch=lambda share, note: None, warm=lambda work: False, repeats: int = REPEATS
) -> list[Record]:
    """Return the records of all works, those that are `warm` run once before. `watch(share, note)` is called before
    each."""
    records = []
    for i, work in enumerate(works):
        watch(i / len(works), ", ".join(filter(None, (f"{work.case}: {work.family}", work.method, work.setting))))
        records.append(measure(work, warm(work), repeats))
    return records


def ends(values, quick: bool):
    """Return all values of a path, or if `quick` its ends."""
    return (values[0], values[-1]) if quick and len(values) > 1 else values


def relative(reference) -> Callable[[tuple], float]:
    """Return the largest relative error against the values `reference`."""
    return lambda values: max(abs(a / b - 1) for a, b in zip(values, reference, strict=True))


def write_csv(records: list[Record], path: Path):
    """Write one line per record."""
    with whole(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [f.name for f in fields(Record)])
        writer.writeheader()
        writer.writerows(asdict(record) for record in records)


def read_csv(path: Path) -> list[Record]:
    """Return the records of a file of `write_csv`."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [Record(**{f.name: f.type(row[f.name]) for f in fields(Record)}) for row in rows]
