"""Solve a scene on its rungs and write the table and the picture (`python -m sonify
ladder`)."""

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

from sonify.ladder.comparison import Comparison, compare
from sonify.ladder.rungs import Inapplicable, Rungs, assignments, rungs_of
from sonify.ladder.stretches import (
    MAX_RUNG_SECONDS,
    LadderPlan,
    LadderRow,
    OmittedRung,
    ladder_plan,
)
from sonify.plan.rungs import Rung
from sonify.runtime.json_values import json_safe
from sonify.runtime.progress import Stages
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.sweeps.executors import local_executor, row_of_future
from sonify.sweeps.row_processes import end_all_processes, solve_isolated
from sonify.sweeps.store import RunStore, read_table
from sonify.sweeps.sweep import with_hashed_mesh

ROW_SOLVER = "sonify.ladder.row:rung_row"
CPU_LIMIT_FACTOR = 2.0
"""CPU time after which a rung is stopped, divided by the limit of its predicted time."""
BUSY_MACHINE_FACTOR = 20.0
"""Time after which a process is killed, divided by the CPU time after which a rung stops."""


class Ladder(NamedTuple):
    """A solved ladder.

    Attributes
    ----------
    scene : Scene
        The scene.
    own : Rung
        The rung of the scene itself.
    rows : list of LadderRow
        Rungs and stretches, in the order of `table`.
    table : list of dict
        Results of the rows.
    omitted, inapplicable : list
        Rungs that are too expensive or do not apply.
    comparisons : dict
        Comparison of the rows over each stretch, by its name.
    folder : Path
        Folder of the files.
    """

    scene: Scene
    own: Rung
    rows: list[LadderRow]
    table: list[dict[str, Any]]
    omitted: list[OmittedRung]
    inapplicable: list[Inapplicable]
    comparisons: dict[str, Comparison]
    folder: Path

    @property
    def passed(self) -> bool:
        """True if every rung was solved and no self-check failed."""
        return all(row["error"] is None and row["passed"] for row in self.table)


def ladder(
    scene: Scene,
    out: str | Path | None = None,
    retry: bool = False,
    stages: Stages | None = None,
    limit: float = MAX_RUNG_SECONDS,
) -> Ladder:
    """Solve the rungs of a scene that its table does not contain yet.

    Each rung is solved in a process of its own, one after another.

    Parameters
    ----------
    scene : Scene
        The scene.
    out : str or Path, optional
        Folder of the files; outputs/ladders/<scene name> by default.
    retry : bool
        Solve rungs again that ended with an error.
    stages : Stages, optional
        Receives the progress.
    limit : float
        Predicted time [s] above which a rung is solved over a stretch of the motion.

    Returns
    -------
    Ladder
        The solved ladder.

    Raises
    ------
    SceneError
        If the scene cannot be solved.
    InputError
        If every rung would take too long, or if the folder contains the table of another
        ladder.
    OutputError
        If the folder cannot be written.
    """
    stages = stages or Stages()
    rungs = rungs_of(scene)
    plan = ladder_plan(scene, rungs, limit)
    if not plan.rows:
        least = min(one.rung.seconds for one in plan.omitted)
        raise InputError(
            f"{scene.name}: every rung is predicted to take more than {limit:g} s, the fastest "
            f"{least:.0f} s"
        )
    folder = Path(out or Path("outputs") / "ladders" / scene.name)
    count = len(plan.rows)
    with RunStore(
        folder, identity(scene, plan.rows), ["rung", "stretch"], count, retry
    ) as store:
        for index, row in enumerate(plan.rows):
            if store.done[index]:
                continue
            name = f"{index + 1}/{count} {row.rung.rung.name}"
            with stages.stage(name):
                solved = solved_row(row, CPU_LIMIT_FACTOR * limit)
            store.add([row_labels(index, row) | solved])
            store.export()
    found = read_table(store.path)[0].to_pylist()
    return assembled(scene, rungs, plan, found, folder)


def assembled(
    scene: Scene,
    rungs: Rungs,
    plan: LadderPlan,
    table: list[dict[str, Any]],
    folder: Path,
) -> Ladder:
    """Return a ladder with the comparisons of its rows over each stretch."""
    stretches = dict.fromkeys(row.stretch for row in plan.rows)
    comparisons = {
        stretch: compare([row for row in table if row["stretch"] == stretch])
        for stretch in stretches
    }
    return Ladder(
        scene,
        rungs.own,
        plan.rows,
        table,
        plan.omitted,
        rungs.inapplicable,
        comparisons,
        folder,
    )


def row_labels(index: int, row: LadderRow) -> dict[str, Any]:
    """Return the columns of a row that are known before it is solved."""
    return {
        "run": index,
        "rung": row.rung.rung.name,
        "stretch": row.stretch,
        "set": assignments(row.rung.values),
        "predicted_seconds": row.rung.seconds,
        "error": None,
    }


def solved_row(row: LadderRow, limit: float) -> dict[str, Any]:
    """Return the results of a row, solved in a new process within `limit` [s] of CPU
    time."""
    task = {
        "solver": ROW_SOLVER,
        "document": row.rung.scene.document,
        "limit": limit,
    }
    with local_executor(1) as (submit, _):
        solved = row_of_future(
            submit(solve_isolated, task, BUSY_MACHINE_FACTOR * limit)
        )
    end_all_processes()
    return solved


def identity(scene: Scene, rows: Sequence[LadderRow]) -> dict[str, Any]:
    """Return plain values that identify a ladder; its table belongs to no other one."""
    document = with_hashed_mesh(scene.document)
    names = [[row.rung.rung.name, row.stretch] for row in rows]
    return json.loads(json.dumps({"ladder": document, "rows": names}, default=str))


def scene_records(ladder: Ladder) -> dict[str, dict[str, Any]]:
    """Return the complete scene of each row by file name; `run` accepts these files."""
    records = {}
    for index, row in enumerate(ladder.rows):
        level, film = row.rung.rung
        name = f"{index + 1:02}-{level}-{'film' if film else 'no-film'}.json"
        records[name] = {"scene": json_safe(asdict(row.rung.scene))}
    return records
