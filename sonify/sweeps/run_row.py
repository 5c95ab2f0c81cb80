"""Solution of one run of a sweep, limited to the required stages."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dynamics import MotionPlan
from modal import as_json
from sonify.claims.air import end_cause_scalars
from sonify.claims.checks import mode_checks, motion_checks
from sonify.claims.finding import Finding
from sonify.claims.rigid_motion import mode_findings
from sonify.claims.verdict import simplest_scene, verdict_findings
from sonify.claims.vibration_level import (
    SoundingModes,
    final_stems,
    vibrations_make_sound,
)
from sonify.pipeline import DiskModesCache, solve, write
from sonify.plan.motion import planned_scene
from sonify.plan.plan import plan_of, with_sounding_modes
from sonify.plan.preflight import (
    check_solvable_disk,
    motion_plan_with_table,
    solve_modes,
    solve_motion,
)
from sonify.plan.table import audible_table, solve_table
from sonify.report.write import (
    duration_columns,
    summary,
    verdict_columns,
    write_motion,
)
from sonify.runtime.json_values import write_json
from sonify.runtime.progress import Stages
from sonify.scene import Scene, from_document
from sonify.sound.audible_modes import modes_below_nyquist, response_to_unit_jump
from sonify.sound.wav import write_sound
from sonify.sweeps.required_stages import motion_findings

if TYPE_CHECKING:
    from dynamics.motion import Motion
    from sonify.result import Result

DISK_MODES = DiskModesCache()
"""Modes of the last disks, which a worker process keeps for further rows."""


def row_of(
    document: dict[str, Any],
    stages: tuple[str, ...],
    keep: tuple[str, ...] = (),
    folder: str = "",
) -> dict[str, Any]:
    """Solve the `stages` of the scene in `document` and return the results as scalars.

    The files in `keep` are written to `folder`. If the run fails, the row contains a
    one-line `error`. Raises OSError if a file cannot be written."""
    return guarded_row(
        lambda watch: _compute_row(
            from_document(document), stages, keep, Path(folder), watch
        )
    )


def guarded_row(
    solved_row: Callable[[Stages], dict[str, Any]], watch: Stages | None = None
) -> dict[str, Any]:
    """Return the row of a function with the durations of its stages, or the row of its
    failure with a one-line `error`.

    The function receives `watch`. Raises OSError if a file cannot be written."""
    watch = watch or Stages()
    try:
        row = solved_row(watch)
    except OSError:
        raise  # a full disk is not an error of the run
    except Exception as error:  # the sweep continues after any failure of a run
        row = {"error": f"{type(error).__name__}: {' '.join(str(error).split())}"}
    return row | duration_columns(watch.seconds)


def _compute_row(
    scene: Scene,
    stages: tuple[str, ...],
    keep: tuple[str, ...],
    folder: Path,
    watch: Stages,
) -> dict[str, Any]:
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


def solve_motion_only(scene: Scene, folder: Path | None) -> dict[str, Any]:
    """Return the scalars, findings and checks of the motion; write it to `folder` if
    given."""
    scene, plan = planned_scene(scene)
    motion = solve_motion(motion_plan_with_table(scene, plan))
    return (
        outcome_scalars(motion, folder)
        | end_cause_scalars(scene, motion.rolling)
        | verdict_columns(motion_findings(scene, motion), motion_checks(motion))
    )


def outcome_scalars(motion: "Motion", folder: Path | None) -> dict[str, Any]:
    """Return outcome and end [s] of the rolling motion; write the motion to `folder` if
    given."""
    if folder:
        write_motion(motion, folder / "motion.npz")
    rolling = motion.rolling
    return {"outcome": rolling.rolling_outcome.name, "t_end": float(rolling.t[-1])}


def solve_modes_only(scene: Scene, folder: Path | None) -> dict[str, Any]:
    """Return the findings and checks of the modes; write them to `folder` if given."""
    modes = solve_modes(scene, DISK_MODES)
    if folder:
        write_json(as_json(modes), folder / "modes.json")
    return verdict_columns(mode_findings(modes), mode_checks(scene, modes))


def solve_verdict(scene: Scene, folder: Path | None) -> dict[str, Any]:
    """Return the verdicts on the motion of the simplest model; write it to `folder` if
    given."""
    simple, plan = planned_scene(simplest_scene(scene))
    plan = motion_plan_with_table(simple, plan)
    motion = solve_motion(plan)
    found = verdict_findings(scene, motion)
    if plan.contact.kind == "many":  # its motion includes the modes of the free disk
        scene, simple = (
            replace(one, support=replace(one.support, kind="free"))
            for one in (scene, simple)
        )
    sounding = sounding_modes(simple, plan)
    found.append(vibrations_make_sound(final_stems(scene, motion, sounding)))
    return (
        outcome_scalars(motion, folder)
        | verdict_columns(found, motion_checks(motion))
        | detail_columns(found)
    )


def detail_columns(findings: list[Finding]) -> dict[str, float]:
    """Return the further numbers of findings as <finding>_<number>."""
    return {
        f"{finding.key}_{name}": number
        for finding in findings
        for name, number in finding.details.items()
    }


def sounding_modes(scene: Scene, motion: MotionPlan) -> SoundingModes:
    """Return the modes of disk and table that a run of the scene would render."""
    modes = solve_modes(scene, DISK_MODES)
    jump = response_to_unit_jump(modes, scene)
    plan = with_sounding_modes(plan_of(scene, motion), scene, modes, *jump)
    table = motion.surface_modes
    if table is None:
        table = solve_table(scene, motion)
    if table is not None:
        table = audible_table(table, scene)
    chosen = modes_below_nyquist(modes, scene.audio.sample_rate, plan.sounding)
    return SoundingModes(modes, chosen, table, plan.max_contact_turn)


def write_arrays(result: "Result", folder: Path, _: object) -> None:
    """Write the arrays of motion and modes to `folder`."""
    write_motion(result.motion, folder / "motion.npz")
    write_json(as_json(result.modes), folder / "modes.json")


STAGE_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "motion": solve_motion_only,
    "modes": solve_modes_only,
    "verdict": solve_verdict,
}
"""Functions that solve each stage without sound."""
FILE_WRITERS: dict[str, Callable[..., Any]] = {
    "arrays": write_arrays,
    "wav": lambda result, folder, watch: write_sound(result.sound, folder),
    "page": write,
}
"""Functions that write each kind of output file."""
