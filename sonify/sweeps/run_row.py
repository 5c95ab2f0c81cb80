"""Solution of one run of a sweep, limited to the required stages."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from modal import as_json
from sonify.claims.air import end_cause_scalars
from sonify.claims.checks import mode_checks, motion_checks
from sonify.claims.rigid_motion import mode_findings
from sonify.claims.verdict import simplest_scene, verdict_findings
from sonify.pipeline import DiskModesCache, solve, write
from sonify.plan.motion import planned_scene
from sonify.plan.preflight import (
    check_solvable_disk,
    motion_plan_with_table,
    solve_modes,
    solve_motion,
)
from sonify.report.write import (
    duration_columns,
    summary,
    verdict_columns,
    write_json,
    write_motion,
)
from sonify.runtime.progress import Stages
from sonify.scene import from_document
from sonify.sound.wav import write_sound
from sonify.sweeps.required_stages import motion_findings

DISK_MODES = DiskModesCache()
"""Modes of the last disks, which a worker process keeps for further rows."""


def row_of(
    document: dict,
    stages: tuple[str, ...],
    keep: tuple[str, ...] = (),
    folder: str = "",
) -> dict[str, Any]:
    """Solve the `stages` of the scene in `document` and return the results as scalars.

    The files in `keep` are written to `folder`. If the run fails, the row contains a
    one-line `error`. Raises OSError if a file cannot be written."""
    watch = Stages()
    try:
        row = _row(from_document(document), stages, keep, Path(folder), watch)
    except OSError:
        raise  # a full disk is not an error of the run
    except Exception as error:  # the sweep continues after any failure of a run
        row = {"error": f"{type(error).__name__}: {' '.join(str(error).split())}"}
    return row | duration_columns(watch.seconds)


def _row(scene, stages, keep, folder, watch):
    if "sound" in stages:
        result = solve(scene, stages=watch, eigenmodes=DISK_MODES)
        for kind in keep:
            FILE_WRITERS[kind](result, folder, watch)
        return summary(result)
    check_solvable_disk(scene)
    row: dict[str, Any] = {}
    for stage in stages:
        with watch.stage(stage):
            row |= STAGE_FUNCTIONS[stage](scene, folder if "arrays" in keep else None)
    return row | {
        "passed": all(value for key, value in row.items() if key.endswith("_passed"))
    }


def solve_motion_only(scene, folder):
    """Return the scalars, findings and checks of the motion; write it to `folder` if
    given."""
    scene, plan = planned_scene(scene)
    motion = solve_motion(motion_plan_with_table(scene, plan))
    return (
        outcome_scalars(motion, folder)
        | end_cause_scalars(scene, motion.rolling)
        | verdict_columns(motion_findings(scene, motion), motion_checks(motion))
    )


def outcome_scalars(motion, folder):
    """Return outcome and end [s] of the rolling motion; write the motion to `folder` if
    given."""
    if folder:
        write_motion(motion, folder / "motion.npz")
    rolling = motion.rolling
    return {"outcome": rolling.rolling_outcome.name, "t_end": float(rolling.t[-1])}


def solve_modes_only(scene, folder):
    """Return the findings and checks of the modes; write them to `folder` if given."""
    modes = solve_modes(scene, DISK_MODES)
    if folder:
        write_json(as_json(modes), folder / "modes.json")
    return verdict_columns(mode_findings(modes), mode_checks(scene, modes))


def solve_verdict(scene, folder):
    """Return the verdicts on the motion of the simplest model; write it to `folder` if
    given."""
    simple, plan = planned_scene(simplest_scene(scene))
    motion = solve_motion(motion_plan_with_table(simple, plan))
    return outcome_scalars(motion, folder) | verdict_columns(
        verdict_findings(scene, motion.rolling), motion_checks(motion)
    )


def write_arrays(result, folder, _):
    """Write the arrays of motion and modes to `folder`."""
    write_motion(result.motion, folder / "motion.npz")
    write_json(as_json(result.modes), folder / "modes.json")


STAGE_FUNCTIONS: dict[str, Callable] = {
    "motion": solve_motion_only,
    "modes": solve_modes_only,
    "verdict": solve_verdict,
}
"""Functions that solve each stage without sound."""
FILE_WRITERS: dict[str, Callable] = {
    "arrays": write_arrays,
    "wav": lambda result, folder, watch: write_sound(result.sound, folder),
    "page": write,
}
"""Functions that write each kind of output file."""
