"""Measure the numbers of the article: python docs/article/measure.py

Prints the expected time first. Each source is stored in numbers.json as soon as it is measured, so
that an interrupted run continues where it stopped. A source is measured again if its scene, its
table or the program changed. `--everything` begins with the charts and sweeps that are missing or
incomplete: from nothing, it makes all numbers."""

import sys
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from pathlib import Path
from random import choice, sample

import article_sources
import click
from article_numbers import Numbers, Record, load_numbers, save_numbers
from article_sources import CHARTS, SWEEPS
from last_seconds import store_last_seconds

from sonify.chart_command import CHART_NAMES, load_chart_files
from sonify.runtime.progress import Stages, duration_in_words
from sonify.runtime.workers import core_count
from sonify.sweeps.command import sweep
from sonify.sweeps.executors import open_executor
from sonify.sweeps.store import RUNS_FILE, read_table
from sonify.sweeps.sweep import SHIPPED_SWEEPS_FOLDER, Sweep, load_sweep
from sonify.sweeps.version import version

MAX_VERIFIED_SECONDS = 20.0
"""Longest time of a source that `--verify` measures again."""
TESTED_SOURCES = ("laws", "limits", "scene", "theory")
"""Sources without a motion, which a test measures again."""
TYPICAL_RUN_SECONDS = 15.0
"""Expected time of a run of a sweep without a table: that of a rough contact or a moving table."""
TYPICAL_CHART_SECONDS = 600.0
"""Expected time of a chart without a table."""
TYPICAL_SOURCE_SECONDS = 60.0
"""Expected time of a source that was never measured."""


def measure_source(name: str) -> Record:
    """Measure one source in any process."""
    return article_sources.sources()[name].record()


@contextmanager
def executor(scheduler: str | None, processes: int):
    """Yield a function that submits calls to processes of this machine or to a Dask cluster."""
    if scheduler is None:
        with ProcessPoolExecutor(processes) as pool:
            yield pool.submit
    else:
        import article_numbers
        from cloudpickle import register_pickle_by_value  # comes with Dask

        register_pickle_by_value(article_numbers)
        register_pickle_by_value(article_sources)
        with open_executor(scheduler, processes) as (submit, _):
            yield submit


@click.command(help=__doc__)
@click.option("--only", multiple=True, help="Measure these sources alone.")
@click.option(
    "--below", type=float, help="Skip sources that took longer [s] and have a record."
)
@click.option(
    "--all", "again", is_flag=True, help="Measure sources again that are up to date."
)
@click.option("--everything", is_flag=True, help="Complete charts and sweeps first.")
@click.option(
    "--recordings", type=click.Path(exists=True), help="Folder of recorded coins."
)
@click.option("--scheduler", help="Address of a Dask scheduler.")
@click.option(
    "--processes", type=int, default=core_count(), help="Processes on this machine."
)
@click.option(
    "--verify", type=int, help="Measure this many random numbers again and compare."
)
@click.option("--dry-run", is_flag=True, help="Print the expected time and exit.")
def main(
    everything, recordings, scheduler, processes, verify, dry_run, **selection
) -> None:
    known = load_numbers()
    if verify:
        sys.exit(verified(known, verify))
    if everything:
        complete_tables(known, scheduler, processes, dry_run)
    found = article_sources.sources()
    due = due_sources(known, **selection)
    total = expected_seconds(known, due)
    click.echo(
        f"{len(due)} of {len(found)} sources, about {duration_in_words(total / processes)} "
        f"with {processes} processes"
    )
    if dry_run:
        return
    for stale in known.keys() - found.keys() - {"coins", "recordings"}:
        known.pop(stale)
    if recordings:
        known["recordings"] = article_sources.recordings_record(Path(recordings))
    save_numbers(known)
    if faults := measure(known, due, scheduler, processes):
        sys.exit(f"{len(faults)} of {len(due)} sources failed")


def due_sources(
    known: Numbers, only: tuple[str, ...], below: float | None, again: bool
) -> list[str]:
    """Return the names of the sources to measure, by the options of the command line."""
    found = article_sources.sources()
    due = list(only) or [
        name for name, source in found.items() if is_due(source, known.get(name), again)
    ]
    if below is None:
        return due
    return [name for name in due if name not in known or known[name].seconds <= below]


def complete_tables(
    known: Numbers, scheduler: str | None, processes: int, dry_run: bool
) -> None:
    """Complete the tables of all charts and sweeps, or only print the expected time."""
    tables = missing_tables()
    seconds = expected_seconds(known, article_sources.sources())
    click.echo(
        f"{len(tables)} charts and sweeps, then all sources: about "
        f"{duration_in_words((sum(tables.values()) + seconds) / processes)} with {processes} "
        "processes; what is finished is kept"
    )
    for name in () if dry_run else tables:
        complete_table(name, scheduler, processes)


def measure(
    known: Numbers, due: list[str], scheduler: str | None, processes: int
) -> list[str]:
    """Measure the sources that are due, save each in `known`, and return the faults."""
    faults: list[str] = []
    with executor(scheduler, processes) as submit:
        futures = {submit(measure_source, name): name for name in due}
        for done, future in enumerate(as_completed(futures), 1):
            name = futures[future]
            try:
                known[name] = future.result()
            except Exception as error:  # the others are measured all the same
                faults.append(f"{name}: {type(error).__name__}: {error}")
                click.echo(f"{done} of {len(due)}: {faults[-1]}")
                continue
            if known[name].sound:
                store_last_seconds(name, known[name].sound)
            known |= article_sources.derived_records(known)
            save_numbers(known)
            click.echo(f"{done} of {len(due)}: {name}, {known[name].seconds:.1f} s")
    return faults


def expected_seconds(known: Numbers, names: Iterable[str]) -> float:
    """Return the expected computing time [s] of sources."""
    return sum(
        known[name].seconds if name in known else TYPICAL_SOURCE_SECONDS
        for name in names
    )


def missing_tables() -> dict[str, float]:
    """Return the expected computing time [s] of each chart and sweep whose table is incomplete."""
    found = {}
    for name in CHART_NAMES:
        if not (CHARTS / f"{name.replace('-', '_')}.csv").is_file():
            found[name] = TYPICAL_CHART_SECONDS
    for file in sorted(SHIPPED_SWEEPS_FOLDER.glob("*.toml")):
        spec = load_sweep(file.stem)
        taken = seconds_of_runs(spec)
        if len(taken) < spec.points.count:
            each = sum(taken) / len(taken) if taken else TYPICAL_RUN_SECONDS
            found[file.stem] = (spec.points.count - len(taken)) * each
    return found


def seconds_of_runs(spec: Sweep) -> list[float]:
    """Return the time [s] of each finished run of a sweep; none if its table has other points."""
    path = SWEEPS / spec.name / RUNS_FILE
    if not path.is_file():
        return []
    table, identity = read_table(path)
    if identity != spec.identity:
        return []
    return [seconds or 0.0 for seconds in table["seconds"].to_pylist()]


def complete_table(name: str, scheduler: str | None, processes: int) -> None:
    """Run a chart, or the runs of a sweep that its table lacks; a table of other points is replaced."""
    if name in CHART_NAMES:
        load_chart_files().write_chart(name.replace("-", "_"), False, CHARTS, Stages())
        return
    spec = load_sweep(name)
    path = SWEEPS / name / RUNS_FILE
    if path.is_file() and not seconds_of_runs(spec):
        click.echo(f"{name}: the table has other points; it is replaced")
        path.unlink()
    sweep(name, scheduler=scheduler, out=SWEEPS / name, processes=processes)


def verified(known: Numbers, count: int) -> int:
    """Measure `count` numbers again, drawn at random; return the exit status.

    Each belongs to another source that takes at most MAX_VERIFIED_SECONDS.
    """
    found = article_sources.sources()
    stale = [
        name
        for name in found
        if name not in known or known[name].inputs != found[name].inputs
    ]
    for name in stale:
        seen = (
            f"changed since {known[name].version}"
            if name in known
            else "was never measured"
        )
        click.echo(f"{name}: scene or table {seen}")
    cheap = [
        name
        for name, source in found.items()
        if source.follows_program
        and name in known
        and name not in TESTED_SOURCES
        and known[name].numbers
        and known[name].seconds <= MAX_VERIFIED_SECONDS
    ]
    wrong = 0
    for name in sample(cheap, min(count, len(cheap))):
        key = choice(sorted(known[name].numbers))
        stored = known[name]
        made = found[name].record().numbers.get(key)
        agrees = made is not None and made.agrees(stored.numbers[key], stored.scatter)
        wrong += not agrees
        shown = "missing" if made is None else f"{made.value:.6g}"
        verdict = "agrees" if agrees else "DIFFERS"
        click.echo(
            f"{name}.{key}: stored {stored.numbers[key].value:.6g}, now {shown}: {verdict}"
        )
    return int(bool(wrong or stale))


def is_due(source, record, again) -> bool:
    """Return True if a source has no record, or if its scene, table or program changed."""
    if record is None or record.inputs != source.inputs:
        return True
    return again or (source.follows_program and record.version != version())


if __name__ == "__main__":
    main()
