"""Run the stages of a scene: plan, table, modes, motion, sound, findings and files."""

from collections.abc import Callable, Hashable
from concurrent.futures import Executor, Future
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, get_args

from dynamics import Motion, MotionPlan
from dynamics.simulation import compile_in_background
from modal import Modes, SurfaceModes, eigenmodes
from modal.blas_threads import one_blas_thread
from modal.progress import progress_reported_to
from sonify.claims.air import air_findings
from sonify.claims.checks import all_checks
from sonify.claims.contact import contact_findings
from sonify.claims.finding import Finding, Findings
from sonify.claims.landing import landing_findings
from sonify.claims.literature import literature_findings
from sonify.claims.loss_causes import loss_cause_findings
from sonify.claims.pitch import pitch_findings
from sonify.claims.rattling import rattling_findings
from sonify.claims.rigid_motion import motion_and_mode_findings
from sonify.claims.sound import analyse_sound, sound_findings
from sonify.claims.table import table_findings
from sonify.claims.two_way import motion_findings as two_way_findings
from sonify.claims.two_way import two_way_part
from sonify.claims.vibration_level import (
    FinalStems,
    SoundingModes,
    final_stems,
    rendered_final_stems,
    vibrations_make_sound,
)
from sonify.hearing.recording import Heard, listen_to_known_disk
from sonify.plan.air import limits_of_film_law
from sonify.plan.body_scene import body_scene
from sonify.plan.duration import predicted_run_seconds
from sonify.plan.plan import Plan, with_motion_end
from sonify.plan.preflight import (
    check_solvable_disk,
    plan_of_run,
    solvable_scene,
    solve_motion,
)
from sonify.plan.table import has_table_modes, solve_table
from sonify.plan.unused import unused_keys_notice
from sonify.report.display import ReportDisplay
from sonify.report.pictures import Pictures
from sonify.report.replaced import replaced_results
from sonify.report.write import page_content, run_record, write_record
from sonify.result import Result, SolvedMotion
from sonify.runtime.files import claimed_folder
from sonify.runtime.progress import Stages, background_threads
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.sound.audible_modes import modes_below_nyquist
from sonify.sound.oscillators import compile_oscillators
from sonify.sound.pressure import Dynamics, Sound, Track
from sonify.sound.radiation import listener_of
from sonify.sound.radiators import compile_radiators
from sonify.sound.render import render_sound
from sonify.sound.wav import write_listening_copy, write_other_sounds


@dataclass(frozen=True, kw_only=True)
class Tools:
    """What the stages of a run share besides their results.

    `begin` receives the results of each stage that pictures need, `eigenmodes` computes
    the modes of the disk, `table_modes` those of the table, and `listen` analyses the
    pressure. The `executor` runs the stages that proceed at the same time as others.
    """

    executor: Executor
    stages: Stages
    begin: Callable[[SolvedMotion], None]
    eigenmodes: Callable[..., Modes]
    listen: Callable[[Track, float], Heard]
    dynamics: Dynamics
    table_modes: Callable[[Scene, MotionPlan], SurfaceModes | None] = solve_table


def solve(
    scene: Scene | str | Path,
    accuracy: str | None = None,
    stages: Stages | None = None,
    eigenmodes: Callable[..., Modes] = eigenmodes,
    begin: Callable[[SolvedMotion], None] = lambda solved: None,
    dynamics: Dynamics = "compressed",
    listen: Callable[[Track, float], Heard] = listen_to_known_disk,
    executor: Executor | None = None,
) -> Result:
    """Solve a scene and return the result without writing files.

    Parameters
    ----------
    scene : Scene, str or Path
        A scene, or a name or path that `load_scene` accepts.
    accuracy : str, optional
        "draft", "standard" or "reference"; replaces the accuracy of the scene.
    stages : Stages, optional
        Receives the progress of the run.
    eigenmodes : callable
        Computes the modes of the disk; `modal.eigenmodes` by default.
    begin : callable
        Called as begin(solved) with a SolvedMotion, once when motion and modes are
        complete and once when the sound is complete.
    dynamics : str
        Dynamics of audible.wav, "compressed" or "natural".
    listen : callable
        Analyses the pressure up to the end of the motion; by default, the strongest
        rising tone counts even below the thresholds of `sonify.listen`.
    executor : Executor, optional
        Runs the stages that proceed at the same time as others; by default, threads of
        this call.

    Returns
    -------
    Result
        The result, with `out` None.

    Raises
    ------
    SceneError
        If the scene is invalid or cannot be solved.
    InputError
        If `dynamics` is neither "compressed" nor "natural".

    Examples
    --------
    >>> from sonify import solve
    >>> solve("published", accuracy="draft").sound.peak  # Pa  # doctest: +SKIP
    """
    check_dynamics(dynamics)
    scene, motion_plan = solvable_scene(scene, accuracy)
    with background_threads(executor) as threads:
        tools = Tools(
            executor=threads,
            stages=stages or Stages(),
            begin=begin,
            eigenmodes=eigenmodes,
            listen=listen,
            dynamics=dynamics,
        )
        return solve_stages(scene, motion_plan, tools)


def check_dynamics(dynamics: str) -> None:
    """Raise InputError unless the dynamics of audible.wav are known."""
    if dynamics not in get_args(Dynamics):
        raise InputError(f"dynamics = {dynamics!r}: must be compressed or natural")


@one_blas_thread
def solve_stages(scene: Scene, motion_plan: MotionPlan, tools: Tools) -> Result:
    """Return the result of a scene with the decisions of its motion.

    The modes of the disk are solved at the same time as the motion, and motions with
    other time steps at the same time as the sound. An error in one of these stages is
    raised where its result is needed.
    """
    solved = solved_motion(scene, motion_plan, tools)
    tools.begin(solved)
    two_way = tools.executor.submit(two_way_stage, solved, tools.stages)
    solved = replace(solved, sound=sound_stage(solved, tools))
    tools.begin(solved)
    return findings_stage(solved, two_way, tools)


def solved_motion(scene: Scene, motion_plan: MotionPlan, tools: Tools) -> SolvedMotion:
    """Return the complete plan, the modes and the motion of a scene."""
    compile_in_background(motion_plan)
    table = table_stage(scene, motion_plan, tools)
    if motion_plan.surface_modes is None and table is not None:
        motion_plan = motion_plan.with_surface_modes(table)
    planned = tools.executor.submit(modes_stage, scene, motion_plan, table, tools)
    motion = motion_stage(motion_plan, planned, tools.stages)
    plan, modes = planned.result()
    return SolvedMotion(scene=scene, plan=plan, modes=modes, table=table, motion=motion)


def table_stage(
    scene: Scene, motion_plan: MotionPlan, tools: Tools
) -> SurfaceModes | None:
    """Return the modes of the table, if it has any."""
    if not has_table_modes(scene):
        return None
    with tools.stages.stage("modes of the table") as watch, progress_reported_to(watch):
        return tools.table_modes(scene, motion_plan)


def modes_stage(
    scene: Scene, motion_plan: MotionPlan, table: SurfaceModes | None, tools: Tools
) -> tuple[Plan, Modes]:
    """Return the complete plan of the run and the modes of the disk."""
    with tools.stages.stage("modes") as watch, progress_reported_to(watch):
        found = plan_of_run(scene, motion_plan, table, tools.eigenmodes)
    compile_oscillators()
    compile_radiators()
    return found


def motion_stage(
    motion_plan: MotionPlan, planned: Future[Any], stages: Stages
) -> Motion:
    """Return the motion of a plan; stop if the simultaneous stage `planned` fails."""
    with stages.stage("motion") as watch:

        def show(share: float, note: str = "") -> None:
            watch(share, note)
            if planned.done():
                planned.result()

        return solve_motion(motion_plan, show)


def two_way_stage(solved: SolvedMotion, stages: Stages) -> list[Finding]:
    """Return the findings on two-way coupling, from reruns of the end of the motion."""
    motion = solved.motion.rolling
    if two_way_part(motion) is None:
        return two_way_findings(solved.scene, motion)
    with stages.stage("reruns of the end") as watch:
        return two_way_findings(solved.scene, motion, watch)


def sound_stage(solved: SolvedMotion, tools: Tools) -> Sound:
    """Return the sound of a motion and its modes."""
    with tools.stages.stage("sound") as watch:
        sound = render_sound(
            solved.scene,
            solved.motion,
            solved.modes,
            solved.plan.sounding,
            solved.plan.max_contact_turn,
            solved.plan.rendered_table(solved.table),
            watch,
            tools.stages.pressure,
        )
    return replace(sound, dynamics=tools.dynamics)


def final_stems_of_run(solved: SolvedMotion) -> FinalStems:
    """Return the stems of the last second of a run.

    Those of a rattling disk are computed again, because one rendered stem contains both
    its rigid motion and its modes."""
    scene, plan, motion = solved.scene, solved.plan, solved.motion
    assert solved.sound is not None
    if "rattling" not in motion.rolling.finding_groups:
        return rendered_final_stems(solved.sound)
    chosen = modes_below_nyquist(solved.modes, scene.audio.sample_rate, plan.sounding)
    table = plan.rendered_table(solved.table)
    sounding = SoundingModes(solved.modes, chosen, table, plan.max_contact_turn)
    return final_stems(scene, motion, sounding)


def findings_stage(solved: SolvedMotion, two_way: Future[Any], tools: Tools) -> Result:
    """Return the result of a run, with its checks and findings.

    `two_way` is the Future of the findings of `two_way_stage`."""
    scene, plan, modes, sound = solved.scene, solved.plan, solved.modes, solved.sound
    motion = solved.motion.rolling
    assert sound is not None
    with tools.stages.stage("findings"):
        hearing = tools.executor.submit(analyse_sound, sound, tools.listen)
        checks = all_checks(scene, solved.motion, modes, sound)
        findings = motion_and_mode_findings(scene, motion, modes)
        heard, silence = hearing.result()
        tone = heard.tone if heard else None
        findings += sound_findings(heard, motion, modes, sound, plan.error("sound"))
        findings.append(vibrations_make_sound(final_stems_of_run(solved)))
        findings += pitch_findings(scene, motion, sound, heard)
        findings += two_way.result()
        findings += table_findings(
            scene,
            motion,
            sound,
            listener_of(scene),
            tone,
            plan.error("sound"),
            solved.table,
        )
        findings += rattling_findings(scene, motion, modes, sound)
        findings += air_findings(scene, motion, sound)
        findings += landing_findings(solved.motion)
        on_contact, contact_notes = contact_findings(scene, motion, sound, heard)
        findings += on_contact
        findings += loss_cause_findings(scene, motion)
        findings += literature_findings(scene, motion, modes, sound, tone)
    notes = [*limits_of_film_law(scene, motion), *silence, *contact_notes]
    return Result(
        scene=scene,
        plan=with_motion_end(plan, solved.motion, sound.ringing, notes),
        motion=solved.motion,
        modes=modes,
        table=solved.table,
        sound=sound,
        heard=heard,
        findings=Findings(findings),
        checks=checks,
        seconds=tools.stages.seconds,
        display=ReportDisplay(),
    )


@one_blas_thread
def write(
    result: Result,
    out: str | Path | None = None,
    stages: Stages | None = None,
    pictures: Pictures | None = None,
    executor: Executor | None = None,
) -> Result:
    """Write the sound, pictures and report of a result. Each file is written
    atomically.

    Parameters
    ----------
    result : Result
        The result of `solve`.
    out : str or Path, optional
        Output folder; outputs/<scene name> by default.
    stages : Stages, optional
        Receives the progress of the run.
    pictures : Pictures, optional
        Pictures that are already being drawn.
    executor : Executor, optional
        Prepares files while others are written; by default, threads of this call.

    Returns
    -------
    Result
        The result with its folder in `out`.

    Raises
    ------
    OutputError
        If `out` cannot be written.
    OSError
        If the disk is full.

    Examples
    --------
    >>> from sonify import solve, write
    >>> write(solve("published"), "outputs/x")  # doctest: +SKIP
    """
    stages = stages or Stages(dict(result.seconds))
    with (
        claimed_folder(out or Path("outputs") / result.scene.name) as folder,
        background_threads(executor) as threads,
    ):
        result = replace(result, out=folder, seconds=stages.seconds)
        write_first_sound(result.sound, folder, stages)
        pictures = pictures or Pictures.of_result(result, threads)
        write_other_files(result, stages, pictures, threads)
    return result


def write_first_sound(sound: Sound, folder: Path, stages: Stages) -> None:
    """Write sound.wav, and remove the files that describe the results it replaces."""
    for stale in ("run.json", "report.html"):
        (folder / stale).unlink(missing_ok=True)
    stages.sound_written(write_listening_copy(sound, folder))


def write_other_files(
    result: Result, stages: Stages, pictures: Pictures, executor: Executor
) -> None:
    """Write all files of a result except sound.wav into its folder."""
    futures = (
        executor.submit(run_record, result),
        executor.submit(page_content, result, pictures),
    )
    assert result.out is not None
    with stages.stage("sound files") as watch:
        write_other_sounds(result.sound, result.out, watch)
    write_record(result, stages, pictures, *futures)


@one_blas_thread
def run(
    scene: Scene,
    motion_plan: MotionPlan,
    out: str | Path | None,
    stages: Stages,
    dynamics: Dynamics,
) -> Result:
    """Solve a scene with the decisions of its motion and write the result into `out`.

    Write access to the folder is checked before any computation. `sonify.run` describes
    the parameters.
    """
    check_dynamics(dynamics)
    check_solvable_disk(scene)
    with (
        claimed_folder(out or Path("outputs") / scene.name) as folder,
        background_threads() as threads,
    ):
        if notice := replaced_results(scene, folder):
            stages.notice(notice)
        if notice := unused_keys_notice(scene, motion_plan):
            stages.notice(notice)
        stages.expect(predicted_run_seconds(scene, motion_plan))
        pictures = Pictures(threads)

        def begin(solved: SolvedMotion) -> None:
            if solved.sound is not None:
                write_first_sound(solved.sound, folder, stages)
            pictures.begin(solved)

        tools = Tools(
            executor=threads,
            stages=stages,
            begin=begin,
            eigenmodes=DiskModesCache(),
            listen=listen_to_known_disk,
            dynamics=dynamics,
        )
        result = solve_stages(scene, motion_plan, tools)
        result = replace(result, out=folder)
        write_other_files(result, stages, pictures, threads)
        return result


class DiskModesCache:
    """Modes of the last four disks; those of one disk may occupy 100 MB.

    Its owner keeps it as long as the modes may be needed again.
    """

    def __init__(self) -> None:
        self._modes = lru_cache(4)(eigenmodes)

    def __call__(self, scene: Scene, below: float) -> Modes:
        """Return the modes of the disk of a scene below a frequency [Hz]."""
        return self._modes(body_scene(scene), below=below)


class TableModesCache:
    """Modes of the last two tables; those of a mesh take half a minute.

    Its owner keeps it as long as the modes may be needed again and meshes do not change.
    """

    def __init__(self) -> None:
        self._modes: dict[Hashable, SurfaceModes | None] = {}

    def __call__(self, scene: Scene, motion: MotionPlan) -> SurfaceModes | None:
        """Return the modes of the table of a scene for the motion of a plan."""
        max_tables = 2
        key = (
            scene.surface,
            scene.disk.radius,
            scene.numerics.accuracy,
            scene.audio.sample_rate,
            motion.lacks_surface_modes,
        )
        if key not in self._modes:
            self._modes[key] = solve_table(scene, motion)
        if len(self._modes) > max_tables:
            del self._modes[next(iter(self._modes))]
        return self._modes[key]
