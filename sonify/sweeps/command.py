"""`python -m sonify sweep` and `map`: from the file of a sweep to its table, its pictures and what they say."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sonify.files import OutputError, whole
from sonify.progress import Stages
from sonify.scene_errors import InputError
from sonify.sweeps.conclusions import CONCLUSIONS
from sonify.sweeps.engine import Submit, cores, engine, rows_of
from sonify.sweeps.hand import Hand
from sonify.sweeps.sweep import Sweep, load_sweep
from sonify.sweeps.table import NAME, Table, read_table

UNASKED = 1_000_000
"""Runs of which no more are begun without `yes`."""
HOUR = 3600.0


def sweep(
    source: str | Path | dict[str, Any],
    scheduler: str | None = None,
    out: str | Path | None = None,
    processes: int | None = None,
    yes: bool = False,
    retry: bool = False,
    stages: Stages | None = None,
) -> Path:
    """Run what is missing of a sweep, a shipped name, a TOML file or its document; return the path of the table, in
    `out` (default outputs/sweeps/<name>).

    The runs are solved by `processes` of this machine (default: its cores), or by the workers of the Dask `scheduler`,
    an address or "local".
    More than a million are begun only with `yes`; with `retry` those with an error are solved again. Raises InputError,
    before any work, where sweep, scheduler or workers are wrong, OutputError where the table cannot be written, OSError
    when the disk is full, BrokenOffError where the scheduler dies. No row that was added is ever lost.
    """
    asked, stages = load_sweep(source), stages or Stages()
    folder = Path(out or Path("outputs") / "sweeps" / asked.name)
    if asked.points.count > UNASKED and not yes:
        with stages.stage("estimate"):
            hours = hours_of(asked, asked.points.count, processes)
        raise InputError(f"{asked.points.count} runs, about {hours:.3g} hours on this machine: add --yes to begin them")
    axes = [key for axis in asked.points.axes for key in axis.keys]
    with (
        engine(scheduler, processes) as (submit, capacity),
        Table(folder, asked.identity, axes, asked.points.count, retry) as table,
        stages.stage("runs") as watch,
    ):
        for rows in _rows(asked, _tasks(asked, table, folder.absolute()), submit, capacity):
            table.add(rows)
            watch(table.done.mean(), f"{table.done.sum()} of {len(table.done)}, {table.failed} with an error")
    held = read_table(folder / NAME)[0].num_rows
    if held < asked.points.count:
        raise OutputError(f"{folder}: holds {held} of {asked.points.count} rows: its files were changed meanwhile")
    with stages.stage("pictures"):
        from sonify.sweeps.maps import draw_maps  # drawing loads slowly

        draw_maps(folder, asked.find)
    if asked.name in CONCLUSIONS:
        told = CONCLUSIONS[asked.name](read_table(folder / NAME)[0])
        with whole(folder / "conclusion.md") as temporary:
            temporary.write_text("\n".join(told) + "\n", "utf-8")
    return folder / NAME


def says(path: str | Path) -> tuple[list[str], bool]:
    """Return how the runs of a table went, in a line, and whether every self-check of theirs passed."""
    table = read_table(path)[0].to_pydict()
    ends = Counter(outcome for outcome in table.get("outcome", []) if outcome)
    errors, failed = sum(error is not None for error in table["error"]), table.get("passed", []).count(False)
    told = [f"{n} {name}" for name, n in ends.most_common()]
    told += [f"{errors} with an error"] * bool(errors) + [f"{failed} with a FAILED self-check"] * bool(failed)
    told += [f"by {len(set(table['version']))} versions of the program"] * (len(set(table["version"])) > 1)
    return [f"{len(table['run'])} runs: {', '.join(told)}"], not failed


def plan(source: str | Path | dict[str, Any], processes: int | None = None, stages: Stages | None = None) -> list[str]:
    """Return what a sweep would do, line by line; one run of it is solved, to know how long one takes."""
    asked, processes = load_sweep(source), processes or cores()
    points = asked.points
    with (stages or Stages()).stage("estimate"):
        first = _probe(asked)
    hours = hours_of(asked, points.count, processes, first)
    drawn = f"{points.samples.method}, seed {points.samples.seed}, over" if points.samples else "a grid over"
    return [
        f"runs     {points.count}, {drawn} {', '.join(f'{a.n} of {a.keys[0]}' for a in points.axes)}",
        f"stages   {', '.join(asked.stages)}",
        f"a run    {first[1]:.3g} s, the first of a process {first[0]:.3g} s more",
        f"hours    {hours:.3g} on {processes} processes",
    ]


def hours_of(asked: Sweep, runs: int, processes: int | None, probe: tuple[float, float] | None = None) -> float:
    """Return about how many hours so many runs take."""
    warm_up, seconds = probe or _probe(asked)
    return (warm_up + seconds * runs / (processes or cores())) / HOUR


def _probe(asked):
    """Seconds of the middle run, and by how much more it takes the first time."""
    hand = Hand()
    try:
        task = _task(asked, asked.points.count // 2, Path()) | {"keep": ()}
        first, again = ((hand.row(task, asked.limit) or {}).get("seconds", asked.limit) for _ in range(2))
    finally:
        hand.end()
    return max(first - again, 0.0), again


def _tasks(asked, table, folder) -> Iterator[tuple[int, dict]]:
    return ((int(run), _task(asked, int(run), folder)) for run in np.flatnonzero(~table.done))


def _task(asked, run, folder):
    own = str(folder / "runs" / str(run)) if asked.keep else ""
    return {"document": asked.scene_of(run), "stages": asked.stages, "keep": asked.keep, "folder": own}


def _rows(asked, tasks, submit: Submit, capacity) -> Iterator[list[dict]]:
    """What was found, run by run, beside the values of the axes."""
    for found in rows_of(tasks, asked.limit, submit, capacity):
        yield [{"run": run} | asked.columns(run) | {"error": None} | row for run, row in found]
