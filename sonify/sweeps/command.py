"""`python -m sonify sweep` and `map`: from the file of a sweep to its table, its pictures and what
they say."""

from collections import Counter
from collections.abc import Iterator
from itertools import chain, islice
from math import ceil
from pathlib import Path
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from sonify.runtime.files import OutputError, whole
from sonify.runtime.progress import Stages, duration_in_words
from sonify.runtime.signals import BrokenOffError
from sonify.scene import from_document
from sonify.scene_errors import InputError, SceneError
from sonify.sweeps.conclusions import CONCLUSIONS
from sonify.sweeps.executors import Submit, cores, engine, machine, rows_of
from sonify.sweeps.row_processes import Hand
from sonify.sweeps.store import NAME, Table, read_table
from sonify.sweeps.sweep import Sweep, load_sweep

UNASKED = 1_000_000
"""Runs of which no more are begun without `yes`."""


class RunTime(NamedTuple):
    """Measured times of the runs of a sweep, solved as the sweep would solve them."""

    first: float
    """Time from the start of a process to its first result [s]: loading, compiling and one run."""
    later: float
    """Time of a further run in the same process [s]."""
    measured: int
    """Number of runs that were solved."""

    def total(self, runs: int, processes: int) -> float:
        """Return the time [s] of so many runs on so many processes, each of which starts once."""
        rounds = ceil(runs / processes)
        return self.first + self.later * (rounds - 1)


def sweep(
    source: str | Path | dict[str, Any],
    scheduler: str | None = None,
    out: str | Path | None = None,
    processes: int | None = None,
    yes: bool = False,
    retry: bool = False,
    stages: Stages | None = None,
) -> Path:
    """Run what is missing of a sweep, a shipped name, a TOML file or its document; return the path
    of the table, in `out` (default outputs/sweeps/<name>).

    The runs are solved by `processes` of this machine (default: its cores), or by the workers of
    the Dask `scheduler`, an address or "local". More than a million are begun only with `yes`; with
    `retry` those with an error are solved again. Raises InputError, before any work, where sweep,
    scheduler or workers are wrong, OutputError where the table cannot be written, OSError when the
    disk is full, BrokenOffError where the scheduler dies. No row that was added is ever lost."""
    asked = load_sweep(source)
    stages = stages or Stages()
    folder = Path(out or Path("outputs") / "sweeps" / asked.name)
    if asked.points.count > UNASKED and not yes:
        count = asked.points.count
        processes = processes or cores()
        time = duration_in_words(run_time(asked, processes, stages).total(count, processes))
        raise InputError(f"{count} runs, about {time} on this machine: add --yes to begin them")
    axes = [key for axis in asked.points.axes for key in axis.keys]
    with (
        engine(scheduler, processes) as (submit, capacity),
        Table(folder, asked.identity, axes, asked.points.count, retry) as table,
        stages.stage("runs") as watch,
    ):
        for rows in _rows(asked, _tasks(asked, table, folder.absolute()), submit, capacity):
            table.add(rows)
            note = f"{table.done.sum()} of {len(table.done)}, {table.failed} with an error"
            watch(table.done.mean(), note if capacity() else f"{note}, waiting for workers")
    held = read_table(folder / NAME)[0].num_rows
    if held < asked.points.count:
        raise OutputError(
            f"{folder}: holds {held} of {asked.points.count} rows: its files were changed meanwhile"
        )
    with stages.stage("pictures"):
        from sonify.sweeps.maps import draw_maps  # drawing loads slowly

        draw_maps(folder, asked.find)
    if asked.name in CONCLUSIONS:
        told = CONCLUSIONS[asked.name](read_table(folder / NAME)[0])
        with whole(folder / "conclusion.md") as temporary:
            temporary.write_text("\n".join(told) + "\n", "utf-8")
    return folder / NAME


def says(path: str | Path) -> tuple[list[str], bool]:
    """Return how the runs of a table went, in a line, and whether every self-check of theirs
    passed."""
    table = read_table(path)[0].to_pydict()
    ends = Counter(outcome for outcome in table.get("outcome", []) if outcome)
    errors = sum(error is not None for error in table["error"])
    failed = table.get("passed", []).count(False)
    told = [f"{n} {name}" for name, n in ends.most_common()]
    told += [f"{errors} with an error"] * bool(errors) + [
        f"{failed} with a FAILED self-check"
    ] * bool(failed)
    told += [f"by {len(set(table['version']))} versions of the program"] * (
        len(set(table["version"])) > 1
    )
    return [f"{len(table['run'])} runs: {', '.join(told)}"], not failed


def plan(
    source: str | Path | dict[str, Any], processes: int | None = None, stages: Stages | None = None
) -> list[str]:
    """Return what a sweep would do, line by line; a few runs are solved to measure their time."""
    asked = load_sweep(source)
    points = asked.points
    processes = processes or cores()
    time = run_time(asked, processes, stages or Stages())
    drawn = (
        f"{points.samples.method}, seed {points.samples.seed}, over"
        if points.samples
        else "a grid over"
    )
    first = duration_in_words(time.first)
    later = duration_in_words(time.later)
    total = duration_in_words(time.total(points.count, processes))
    start = f"the first of each process {first}, with loading and compiling"
    return [
        f"runs     {points.count}, {drawn} "
        f"{', '.join(f'{a.n} of {a.keys[0]}' for a in points.axes)}",
        f"stages   {', '.join(asked.stages)}",
        f"a run    {later}; {start} ({time.measured} measured)",
        f"time     {total} with {processes} process{'es' * (processes > 1)}",
    ]


def run_time(asked: Sweep, processes: int, stages: Stages) -> RunTime:
    """Measure a first and a later run in each of the processes that the sweep would keep busy.

    They run at the same time and compete for the same cores and caches as in the sweep. They start
    at points spread over the whole sweep and continue with the run that they would get next, so
    that modes are reused as often as in the sweep. Runs of scenes that contradict themselves take
    no time and are skipped.
    """
    count = min(processes, asked.points.count)
    starts = [(2 * k + 1) * asked.points.count // (2 * count) for k in range(count)]
    first = []
    later = []
    with stages.stage("estimate") as watch, machine(count) as (submit, _):
        futures = [submit(_measured, asked, start, count) for start in starts]
        for done, found in enumerate(futures, 1):
            seconds = found.result()
            first += seconds[:1]
            later += seconds[1:]
            watch(done / count, f"{len(first) + len(later)} runs measured")
    if not first:
        raise InputError("axes: none of the runs that were tried has a possible scene")
    return RunTime(float(np.mean(first)), float(np.mean(later or first)), len(first) + len(later))


def _measured(asked, start, stride):
    """Return the times [s] of two runs in a new process; the first includes its start."""
    seconds = []
    began = perf_counter()
    hand = Hand()
    if hand.version is None:
        raise BrokenOffError("python -m sonify.sweeps.worker_loop does not start")
    for run in islice(_possible(asked, start, stride), 2):
        row = hand.row(_task(asked, run, Path()) | {"keep": ()}, asked.limit)
        seconds.append(perf_counter() - began)
        if row is None:  # the process is dead
            break
        began = perf_counter()
    return seconds


def _possible(asked, start, stride, tries=1000):
    """Yield runs with a possible scene: every `stride`-th from `start` on, then those before it."""
    runs = chain(range(start, asked.points.count, stride), range(start % stride, start, stride))
    for run in islice(runs, tries):
        try:
            from_document(asked.scene_of(run))
        except SceneError:
            continue
        yield run


def _tasks(asked, table, folder) -> Iterator[tuple[int, dict]]:
    return ((int(run), _task(asked, int(run), folder)) for run in np.flatnonzero(~table.done))


def _task(asked, run, folder):
    own = str(folder / "runs" / str(run)) if asked.keep else ""
    return {
        "document": asked.scene_of(run),
        "stages": asked.stages,
        "keep": asked.keep,
        "folder": own,
    }


def _rows(asked, tasks, submit: Submit, capacity) -> Iterator[list[dict]]:
    """What was found, run by run, beside the values of the axes."""
    for found in rows_of(tasks, asked.limit, submit, capacity):
        yield [{"run": run} | asked.columns(run) | {"error": None} | row for run, row in found]
