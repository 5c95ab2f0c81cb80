"""Time the runs of the benchmarks: one record per run, with its error and the median of
its repeated timings.

All runs of a chart are timed in turns, so that the load of the machine affects them
equally. The times are processor times, which depend less on that load."""

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

from sonify.runtime.files import atomic_write
from sonify.scene_errors import InputError

MAX_TIMINGS = 5
"""Largest number of timings of one run."""

MAX_TOTAL_SECONDS = 2.0
"""Largest sum of the timings of one run [s]; a run that takes longer is timed once."""

MIN_TIMING_SECONDS = 0.02
"""Shortest timing [s]; shorter runs are called repeatedly, and the mean is used."""

LEFT_OUT = "left out"
"""First words of the message of a Failure if a program or package is not installed."""

MAX_ERROR = 1e-2
"""Relative error above which a run counts as failed, unless its `Work` states another
limit."""


class Failure(Exception):
    """Error of a method that stops or has a useless result; the message states the
    reason in a few words."""


class Answer(NamedTuple):
    """Result of a method: values for comparison with the reference, and number of
    steps."""

    values: Any
    steps: int


@dataclass(frozen=True)
class Record:
    """Record of a run: relative error, processor time (median of `repeats` timings),
    and reason of a failure."""

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
        """True if the method did not run because a program or package is not
        installed."""
        return self.failure.startswith(LEFT_OUT)


class Work(NamedTuple):
    """Specification of a run: family, method, setting, case, call, error measure,
    largest allowed error."""

    family: str
    method: str
    setting: str
    case: str
    call: Callable[[], Answer]
    error: Callable[[tuple], float]
    max_error: float = MAX_ERROR


def works_over(
    family, method, setting, values, solve, case, error, max_error=MAX_ERROR
) -> list[Work]:
    """Return one run per value, which calls solve(value); `setting` is the format
    string of the value."""
    return [
        Work(
            family, method, setting.format(x), case, partial(solve, x), error, max_error
        )
        for x in values
    ]


def processor_seconds() -> float:
    """Return the processor time [s] of this process and of the child processes that
    have ended."""
    children = os.times()
    return process_time() + children.children_user + children.children_system


class Run:
    """Run in progress, with the result of its first call and the seconds per call of
    each timing."""

    def __init__(self, work: Work, warm: bool):
        """Call the method for the first time; with `warm` this call compiles and is not
        timed."""
        self.work = work
        self.error = math.nan
        self.steps = 0
        self.failure = ""
        start = processor_seconds()
        try:
            answer = work.call()
            self.seconds = [] if warm else [processor_seconds() - start]
            self.error = work.error(answer.values)
            self.steps = answer.steps
        except Failure as failure:
            self.seconds = [processor_seconds() - start]
            self.failure = str(failure)

    def time(self, repeats: int):
        """Add one timing, unless the run has failed, has `repeats` timings, or would
        exceed MAX_TOTAL_SECONDS."""
        if self.seconds:
            exceeds_total = sum(self.seconds) + self.seconds[-1] >= MAX_TOTAL_SECONDS
            if self.failure or len(self.seconds) >= repeats or exceeds_total:
                return
            if self.seconds[-1] < MIN_TIMING_SECONDS:
                self.work.call()  # other runs have evicted the data of this one from the processor caches
        start = processor_seconds()
        calls = 0
        elapsed = 0.0
        while elapsed < MIN_TIMING_SECONDS:
            self.work.call()
            calls += 1
            elapsed = processor_seconds() - start
        self.seconds.append(elapsed / calls)

    def record(self) -> Record:
        """Return error, steps, time and failure of the run."""
        is_right = self.error <= self.work.max_error
        failure = self.failure or (
            "" if is_right else f"wrong by {100 * self.error:.2g} %"
        )
        return Record(
            *self.work[:4],
            self.error,
            self.steps,
            median(self.seconds),
            len(self.seconds),
            failure,
        )


def measure(work: Work) -> Record:
    """Run `work` alone, time it once, and return its record."""
    return measured([work], repeats=1)[0]


def measured(
    works: list[Work],
    watch=lambda fraction, note: None,
    warm=lambda work: False,
    repeats: int = MAX_TIMINGS,
) -> list[Record]:
    """Return the records of all works.

    The first call of a work for which `warm(work)` is true is not timed. The works are
    timed in turns, all of them once before any is timed again. `watch(fraction, note)`
    is called before each timing."""
    runs = []
    timings = len(works) * (1 + repeats)
    for i, work in enumerate(works):
        watch(
            i / timings,
            ", ".join(
                filter(None, (f"{work.case}: {work.family}", work.method, work.setting))
            ),
        )
        runs.append(Run(work, warm(work)))
    for i, run in enumerate(runs * repeats, len(works)):
        watch(i / timings, f"{run.work.case}: {run.work.method}, repeated timing")
        run.time(repeats)
    return [run.record() for run in runs]


def most_accurate(records: list[Record], **fields: str) -> Record | None:
    """Return the successful record of the smallest error with the given fields, for
    example case="published".

    The result is None if there is no such record.
    """
    good = [r for r in records if not r.failure and fields.items() <= vars(r).items()]
    return min(good, key=lambda r: r.error, default=None)


def selected_values(values, quick: bool):
    """Return all values of a setting, or only the first and the last one if `quick`."""
    return (values[0], values[-1]) if quick and len(values) > 1 else values


def relative_error(reference) -> Callable[[tuple], float]:
    """Return the function of values that gives their largest relative error against
    `reference`."""
    return lambda values: max(
        abs(a / b - 1) for a, b in zip(values, reference, strict=True)
    )


def distance_from_one(values) -> float:
    """Return the largest distance from 1 of real or complex values whose exact value is
    1."""
    return max(abs(value - 1) for value in values)


def write_csv(records: list[Record], path: Path):
    """Write the records as a CSV file, one line per record."""
    with (
        atomic_write(path) as temporary,
        temporary.open("w", newline="", encoding="utf-8") as file,
    ):
        writer = csv.DictWriter(file, [f.name for f in fields(Record)])
        writer.writeheader()
        writer.writerows(asdict(record) for record in records)


def read_csv(path: Path) -> list[Record]:
    """Return the records of a file written by `write_csv`. Raises InputError if the
    file is invalid or empty."""
    try:
        with path.open(newline="", encoding="utf-8") as file:
            records = [
                Record(**{f.name: f.type(row[f.name]) for f in fields(Record)})
                for row in csv.DictReader(file)
            ]
    except (KeyError, TypeError, ValueError):
        records = []
    if not records:
        raise InputError(f"{path}: not the records of a chart")
    return records
