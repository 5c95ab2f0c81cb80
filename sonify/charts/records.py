"""What a chart is made of: one record per run, timed by the median of repeated runs, which take turns with the others.

Seconds are those of the processor, so that what else the machine does counts less.
"""

import csv
import math
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from functools import partial
from pathlib import Path
from statistics import median
from time import process_time
from typing import Any, NamedTuple

from sonify.files import whole
from sonify.scene_errors import InputError

REPEATS = 5
"""How often a run is timed, as long as that takes less than PATIENCE."""
PATIENCE = 2.0
"""Seconds that the repetitions of one run may take; a longer run is timed once."""
CLOCK = 0.02
"""Seconds that one timing takes at least: a shorter run is called as often as that needs, and the mean taken."""


LEFT_OUT = "left out"
"""How the message of a Failure begins where nothing failed but what a method needs is not installed."""


class Failure(Exception):
    """The method gave up or gave nonsense; the message names the way in a few words."""


class Answer(NamedTuple):
    """What a method found: numbers to compare, and the steps it took."""

    values: Any
    steps: int


@dataclass(frozen=True)
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


def along(family, method, setting, values, solve, case, error, wrong=WRONG) -> list[Work]:
    """Return a run for each of the values: `setting` is how one is written, solve(value) what it gives."""
    return [Work(family, method, setting.format(x), case, partial(solve, x), error, wrong) for x in values]


def spent() -> float:
    """Return the processor time [s] of this process and of the programs that it has called and seen end."""
    children = os.times()
    return process_time() + children.children_user + children.children_system


class Run:
    """A work under way: what its first call gave, and the seconds of a call by each of its timings."""

    def __init__(self, work: Work, warm: bool):
        """Call it for the first time, which with `warm` is not timed (it compiles)."""
        self.work, self.error, self.steps, self.failure, began = work, math.nan, 0, "", spent()
        try:
            answer = work.call()
            self.seconds = [] if warm else [spent() - began]
            self.error, self.steps = work.error(answer.values), answer.steps
        except Failure as failure:
            self.seconds, self.failure = [spent() - began], str(failure)

    def time(self, repeats: int):
        """Time it once more, unless that was done as often as it may be."""
        if self.seconds:
            spends_patience = sum(self.seconds) + self.seconds[-1] >= PATIENCE
            if self.failure or len(self.seconds) >= repeats or spends_patience:
                return
            if self.seconds[-1] < CLOCK:
                self.work.call()  # what ran in between left nothing of it in the processor's caches
        began, calls, passed = spent(), 0, 0.0
        while passed < CLOCK:
            self.work.call()
            calls, passed = calls + 1, spent() - began
        self.seconds.append(passed / calls)

    def record(self) -> Record:
        """Return what was measured."""
        wrong = "" if self.failure or self.error <= self.work.wrong else f"wrong by {100 * self.error:.2g} %"
        timed = median(self.seconds), len(self.seconds)
        return Record(*self.work[:4], self.error, self.steps, *timed, self.failure or wrong)


def measure(work: Work) -> Record:
    """Run `work` alone, once, and return its record."""
    return measured([work], repeats=1)[0]


def measured(
    works: list[Work], watch=lambda share, note: None, warm=lambda work: False, repeats: int = REPEATS
) -> list[Record]:
    """Return the records of all works, those that are `warm` run once before.

    They are timed in turns, all once and then all again, so that what the machine does at a time is done to all.
    `watch(share, note)` is called before each.
    """
    runs, every = [], len(works) * (1 + repeats)
    for i, work in enumerate(works):
        watch(i / every, ", ".join(filter(None, (f"{work.case}: {work.family}", work.method, work.setting))))
        runs.append(Run(work, warm(work)))
    for i, run in enumerate(runs * repeats, len(works)):
        watch(i / every, f"{run.work.case}: {run.work.method}, timed again")
        run.time(repeats)
    return [run.record() for run in runs]


def nearest(records: list[Record], **about: str) -> Record | None:
    """Return the run of the least error of those that did not fail and are `about` this, as case="published"; None if
    there is none."""
    good = [r for r in records if not r.failure and about.items() <= vars(r).items()]
    return min(good, key=lambda r: r.error, default=None)


def ends(values, quick: bool):
    """Return all values of a path, or if `quick` its ends."""
    return (values[0], values[-1]) if quick and len(values) > 1 else values


def relative(reference) -> Callable[[tuple], float]:
    """Return the largest relative error against the values `reference`."""
    return lambda values: max(abs(a / b - 1) for a, b in zip(values, reference, strict=True))


def from_one(values) -> float:
    """Return the largest distance from 1 of numbers, real or complex, that are 1 if they are exact."""
    return max(abs(value - 1) for value in values)


def write_csv(records: list[Record], path: Path):
    """Write one line per record."""
    with whole(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [f.name for f in fields(Record)])
        writer.writeheader()
        writer.writerows(asdict(record) for record in records)


def read_csv(path: Path) -> list[Record]:
    """Return the records of a file of `write_csv`. Raises InputError where it is none, or holds none."""
    try:
        with path.open(newline="", encoding="utf-8") as file:
            records = [Record(**{f.name: f.type(row[f.name]) for f in fields(Record)}) for row in csv.DictReader(file)]
    except (KeyError, TypeError, ValueError):
        records = []
    if not records:
        raise InputError(f"{path}: not the records of a chart")
    return records
