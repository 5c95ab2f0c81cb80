"""Run a sweep file and write its table, pictures and conclusions (`python -m sonify
sweep`)."""

from collections.abc import Callable, Iterator
from itertools import chain, islice
from math import ceil
from pathlib import Path
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa

from sonify.runtime.files import OutputError, write_text
from sonify.runtime.progress import Stages, duration_in_words
from sonify.runtime.signals import AbortedError
from sonify.runtime.workers import core_count
from sonify.scene import from_document
from sonify.scene_errors import InputError, SceneError
from sonify.sweeps.conclusions import CONCLUSIONS
from sonify.sweeps.executors import (
    Submit,
    local_executor,
    open_executor,
    solve_tasks,
)
from sonify.sweeps.row_processes import RowProcess
from sonify.sweeps.store import RunStore, read_table
from sonify.sweeps.sweep import Sweep, load_sweep
from sonify.sweeps.verdict import (
    outcome_counts,
    verdict_conclusion,
)


class RunTime(NamedTuple):
    """Durations of single runs, measured under the conditions of the sweep."""

    first_run: float
    """Time [s] from the start of a process to its first result, including imports and
    compilation."""
    later_run: float
    """Time of each further run in the same process [s]."""
    measured: int
    """Number of measured runs."""

    def total(self, runs: int, processes: int) -> float:
        """Return the total time [s] of `runs` runs on `processes` processes, including
        their start."""
        rounds = ceil(runs / processes)
        return self.first_run + self.later_run * (rounds - 1)


def sweep(
    source: str | Path | dict[str, Any],
    scheduler: str | None = None,
    out: str | Path | None = None,
    processes: int | None = None,
    yes: bool = False,
    retry: bool = False,
    stages: Stages | None = None,
) -> Path:
    """Solve the runs that the table of a sweep does not contain yet.

    Rows of the table are never lost, even if the process is killed.

    Parameters
    ----------
    source : str, Path or dict
        Name of a shipped sweep, TOML file, or parsed sweep document.
    scheduler : str, optional
        Address of a Dask scheduler; without it, processes of this machine are used.
    out : str or Path, optional
        Folder for the table (default: outputs/sweeps/<name>).
    processes : int, optional
        Number of processes on this machine (default: number of available cores).
    yes : bool
        Allow more than a million runs.
    retry : bool
        Solve runs again that ended with an error.
    stages : Stages, optional
        Receives progress and stage times.

    Returns
    -------
    Path
        Path of the table.

    Raises
    ------
    InputError
        If the sweep, the scheduler or the workers are invalid, before any computation.
    OutputError
        If the table cannot be written.
    OSError
        If the disk is full.
    AbortedError
        If the scheduler or the worker processes die.

    Examples
    --------
    >>> from sonify import sweep
    >>> axes = {"friction.arm_rolling": [1e-5, 3e-5, 1e-4]}
    >>> document = {"name": "rolling", "scene": "published", "axes": axes}
    >>> sweep(document)  # doctest: +SKIP
    PosixPath('outputs/sweeps/rolling/runs.parquet')
    """
    sweep_spec = load_sweep(source)
    stages = stages or Stages()
    folder = Path(out or Path("outputs") / "sweeps" / sweep_spec.name)
    count = sweep_spec.points.count
    max_unconfirmed_runs = 1_000_000
    if count > max_unconfirmed_runs and not yes:
        processes = processes or core_count()
        time = duration_in_words(
            run_time(sweep_spec, processes, stages).total(count, processes)
        )
        raise InputError(
            f"{count} runs, about {time} on this machine: add --yes to start them"
        )
    with (
        open_executor(scheduler, processes) as (submit, capacity),
        RunStore(
            folder, sweep_spec.identity, sweep_spec.points.keys, count, retry
        ) as store,
        stages.stage("runs") as watch,
    ):
        for rows in solved_rows(sweep_spec, store, submit, capacity):
            store.add(rows)
            note = (
                f"{store.done.sum()} of {len(store.done)}, {store.failed} with an error"
            )
            watch(
                store.done.mean(),
                note if capacity() else f"{note}, waiting for workers",
            )
    found, _ = read_table(store.path)
    if len(found) < count:
        raise OutputError(
            f"{folder}: contains {len(found)} of {count} rows: its files were changed during the sweep"
        )
    with stages.stage("pictures"):
        from sonify.sweeps.maps import (
            draw_maps,
        )  # deferred: the drawing libraries load slowly

        draw_maps(folder, sweep_spec.find)
    if sentences := conclusion(sweep_spec, found):
        write_text("\n".join(sentences) + "\n", folder / "conclusion.md")
    return store.path


def conclusion(sweep_spec: Sweep, rows: pa.Table) -> list[str]:
    """Return the lines of the conclusions from the table of a sweep, possibly none."""
    if "verdict" in sweep_spec.stages:
        return verdict_conclusion(rows, sweep_spec)
    if sweep_spec.name in CONCLUSIONS:
        return CONCLUSIONS[sweep_spec.name](rows)
    return []


def summarize(path: str | Path) -> tuple[str, bool]:
    """Return a one-line summary of a table, and True if no self-check failed."""
    columns = read_table(path)[0].to_pydict()
    parts = outcome_counts(columns.get("outcome", []))
    if errors := sum(error is not None for error in columns["error"]):
        parts.append(f"{errors} with an error")
    if failed := columns.get("passed", []).count(False):
        parts.append(f"{failed} with a FAILED self-check")
    if (versions := len(set(columns["version"]))) > 1:
        parts.append(f"by {versions} versions of the program")
    return f"{len(columns['run'])} runs: {', '.join(parts)}", not failed


def plan(
    source: str | Path | dict[str, Any],
    processes: int | None = None,
    stages: Stages | None = None,
) -> list[str]:
    """Return lines that describe a sweep, with its duration estimated from a few
    runs."""
    sweep_spec = load_sweep(source)
    points = sweep_spec.points
    processes = processes or core_count()
    time = run_time(sweep_spec, processes, stages or Stages())
    drawn = (
        f"{points.samples.method}, seed {points.samples.seed}, over"
        if points.samples
        else "a grid over"
    )
    first = duration_in_words(time.first_run)
    later = duration_in_words(time.later_run)
    total = duration_in_words(time.total(points.count, processes))
    start = f"the first one of each process {first}, including imports and compilation"
    return [
        f"runs     {points.count}, {drawn} "
        f"{', '.join(f'{a.n} of {a.keys[0]}' for a in points.axes)}",
        f"stages   {', '.join(sweep_spec.stages)}",
        f"a run    {later}; {start} ({time.measured} measured)",
        f"time     {total} with {processes} process{'es' * (processes > 1)}",
    ]


def run_time(sweep_spec: Sweep, processes: int, stages: Stages) -> RunTime:
    """Measure the first and the second run in each process that the sweep would use.

    The processes run concurrently and compete for cores and caches as in the sweep.
    They start at points spread over the whole sweep, and each continues with the run
    that it would receive next, so that modes are reused as often as in the sweep. Runs
    with contradictory scenes are skipped."""
    count = min(processes, sweep_spec.points.count)
    starts = [
        (2 * k + 1) * sweep_spec.points.count // (2 * count) for k in range(count)
    ]
    first = []
    later = []
    with stages.stage("estimate") as watch, local_executor(count) as (submit, _):
        futures = [
            submit(_measure_two_runs, sweep_spec, start, count) for start in starts
        ]
        for done, found in enumerate(futures, 1):
            seconds = found.result()
            first += seconds[:1]
            later += seconds[1:]
            watch(done / count, f"{len(first) + len(later)} runs measured")
    if not first:
        raise InputError("axes: none of the tested runs has a valid scene")
    return RunTime(
        float(np.mean(first)), float(np.mean(later or first)), len(first) + len(later)
    )


def _measure_two_runs(sweep_spec: Sweep, start: int, stride: int) -> list[float]:
    """Return the times [s] of two runs in a new process; the first includes the process
    start."""
    seconds = []
    began = perf_counter()
    process = RowProcess()
    if process.version is None:
        raise AbortedError("python -m sonify.sweeps.worker_loop failed to start")
    for run in islice(_valid_runs(sweep_spec, start, stride), 2):
        row = process.solve(
            task_of_run(sweep_spec, run, Path()) | {"keep": ()}, sweep_spec.limit
        )
        seconds.append(perf_counter() - began)
        if row is None:  # the process died
            break
        began = perf_counter()
    return seconds


def _valid_runs(sweep_spec: Sweep, start: int, stride: int) -> Iterator[int]:
    """Yield the runs with valid scenes among every `stride`-th run, first from `start`
    on, then before it."""
    max_tried_runs = 1000
    runs = chain(
        range(start, sweep_spec.points.count, stride),
        range(start % stride, start, stride),
    )
    for run in islice(runs, max_tried_runs):
        try:
            from_document(sweep_spec.scene_of(run))
        except SceneError:
            continue
        yield run


def task_of_run(sweep_spec: Sweep, run: int, folder: Path) -> dict[str, Any]:
    """Return the arguments of `row_of` for a run."""
    own = str(folder / "runs" / str(run)) if sweep_spec.keep else ""
    return {
        "document": sweep_spec.scene_of(run),
        "stages": sweep_spec.stages,
        "keep": sweep_spec.keep,
        "folder": own,
    }


def solved_rows(
    sweep_spec: Sweep, store: RunStore, submit: Submit, capacity: Callable[[], int]
) -> Iterator[list[dict[str, Any]]]:
    """Solve the runs that are not in the table, and yield lists of finished rows.

    The rows include the values of the axes."""
    folder = store.folder.absolute()
    tasks = (
        (run, task_of_run(sweep_spec, run, folder))
        for run in map(int, np.flatnonzero(~store.done))
    )
    for found in solve_tasks(tasks, sweep_spec.limit, submit, capacity):
        yield [
            {"run": run} | sweep_spec.columns(run) | {"error": None} | row
            for run, row in found
        ]
