"""Run the stages of a scene: plan, modes, motion, sound, findings and files."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import get_args

from dynamics.compliant.two_way_onset import must_compute_table_modes
from dynamics.progress import MotionProgress
from dynamics.rattling.rattling_motion import RattlingMotion
from dynamics.simulation import compile_in_background
from modal import Modes, SurfaceModes, eigenmodes
from modal.blas_threads import one_blas_thread
from modal.progress import progress_range, progress_reported_to
from sonify.claims.air import air_findings
from sonify.claims.checks import all_checks
from sonify.claims.contact import contact_findings
from sonify.claims.finding import Findings
from sonify.claims.listener import listen_in_worker
from sonify.claims.literature import literature_findings
from sonify.claims.rattling import rattling_findings
from sonify.claims.rigid_motion import motion_and_mode_findings
from sonify.claims.sound import analyse_sound, sound_findings
from sonify.claims.table import table_findings
from sonify.claims.two_way import motion_findings as two_way_findings
from sonify.hearing.recording import Heard, listen_to_known_disk
from sonify.plan.air import limits_of_film_law, with_air
from sonify.plan.body_scene import BodyScene, body_scene
from sonify.plan.plan import Plan, with_motion_end
from sonify.plan.preflight import check_solvable_scene, plan_with_modes, solve_motion
from sonify.plan.table import with_table
from sonify.plan.unused import unused_keys_notice
from sonify.report.display import ReportDisplay
from sonify.report.pictures import Pictures
from sonify.report.render_worker import painter
from sonify.report.replaced import replaced_results
from sonify.report.write import page_content, run_record, write_record
from sonify.result import Result, SolvedMotion
from sonify.runtime.files import claimed_folder
from sonify.runtime.progress import Stages, in_background
from sonify.scene import Scene
from sonify.scene_errors import InputError
from sonify.sound.oscillators import compile_oscillators
from sonify.sound.pressure import Dynamics, Track
from sonify.sound.radiation import listener_of
from sonify.sound.radiators import compile_radiators
from sonify.sound.render import render_sound
from sonify.sound.wav import write_sound


@one_blas_thread
def solve(
    scene: Scene | str | Path,
    accuracy: str | None = None,
    stages: Stages | None = None,
    eigenmodes: Callable[..., Modes] = eigenmodes,
    begin: Callable = lambda found: None,
    dynamics: Dynamics = "compressed",
    listen: Callable[[Track, float], Heard] = listen_to_known_disk,
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
        Called as begin(solved) with a SolvedMotion, after the motion and again after
        the sound.
    dynamics : str
        Dynamics of audible.wav, "compressed" or "natural".
    listen : callable
        Analyses the pressure up to the end of the motion; by default, the strongest
        rising tone counts even below the thresholds of `sonify.listen`.

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
    if dynamics not in get_args(Dynamics):
        raise InputError(f"dynamics = {dynamics!r}: must be compressed or natural")
    scene = check_solvable_scene(scene, accuracy)
    stages = stages or Stages()
    compile_in_background(scene)
    elastic = in_background(_plan_and_modes, scene, eigenmodes, stages)
    with stages.stage("motion") as watch:
        progress = MotionProgress(scene)

        def show(t, inclination, doing):
            note = doing or f"t = {t:.2f} s, inclination {inclination:.2g} rad"
            watch(progress.solved_fraction(t, inclination), note)
            if elastic.done():
                elastic.result()  # raises if the modes failed

        motion = solve_motion(
            scene,
            show,
            elastic.result()[2] if must_compute_table_modes(scene) else None,
        )
        watch(1.0, "waiting for the modes")
        plan, modes, table = elastic.result()
    solved = SolvedMotion(
        scene=scene, plan=plan, modes=modes, table=table, motion=motion
    )
    begin(solved)
    watch_findings: Callable[[float], None] | None = None  # set when its stage begins
    two_way = in_background(
        two_way_findings,
        scene,
        motion,
        lambda share: watch_findings and watch_findings(share),
    )
    with stages.stage("sound") as watch:
        sound = render_sound(
            scene,
            motion,
            modes,
            plan.sounding,
            plan.max_contact_turn,
            plan.rendered_table(table),
            watch,
            stages.pressure,
        )
        sound = replace(sound, dynamics=dynamics)
    begin(replace(solved, sound=sound))
    with stages.stage("findings") as watch:
        watch_findings = watch
        hearing = in_background(analyse_sound, sound, listen)
        checks = all_checks(scene, motion, modes, sound)
        findings = motion_and_mode_findings(scene, motion, modes)
        heard, silence = hearing.result()
        findings += sound_findings(heard, motion, modes, sound, plan.error("sound"))
        findings += two_way.result()
        findings += table_findings(
            scene,
            motion,
            sound,
            listener_of(scene),
            heard and heard.tone,
            plan.error("sound"),
        )
        if isinstance(motion, RattlingMotion):
            contact_notes: list[str] = []
            findings += rattling_findings(scene, motion, modes, sound)
        else:
            on_contact, contact_notes = contact_findings(scene, motion, sound, heard)
            findings += air_findings(scene, motion, sound) + on_contact
        findings += literature_findings(
            scene, motion, modes, sound, heard and heard.tone
        )
    return Result(
        scene=scene,
        plan=with_motion_end(
            plan,
            motion,
            sound.ringing,
            [*limits_of_film_law(scene, motion), *silence, *contact_notes],
        ),
        motion=motion,
        modes=modes,
        table=table,
        sound=sound,
        heard=heard,
        findings=Findings(findings),
        checks=checks,
        seconds=stages.seconds,
        display=ReportDisplay(),
    )


def _plan_and_modes(
    scene: Scene, eigenmodes: Callable[..., Modes], stages: Stages
) -> tuple[Plan, Modes, SurfaceModes | None]:
    """Return the plan, the modes of the disk and the modes of the table (None if it has
    none)."""
    share_of_disk = 1.0 if scene.surface.kind == "rigid" else 0.5
    with stages.stage("modes") as watch, progress_reported_to(watch):
        with progress_range(0.0, share_of_disk):
            plan, modes = plan_with_modes(scene, eigenmodes)
        with progress_range(share_of_disk, 1.0):
            plan, table = with_table(with_air(plan, scene), scene)
    compile_oscillators()
    compile_radiators()
    return plan, modes, table


@one_blas_thread
def write(
    result: Result,
    out: str | Path | None = None,
    stages: Stages | None = None,
    pictures: Pictures | None = None,
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
    with claimed_folder(out or Path("outputs") / result.scene.name) as folder:
        for stale in ("run.json", "report.html"):  # they describe the other files
            (folder / stale).unlink(missing_ok=True)
        result = replace(result, out=folder, seconds=stages.seconds)
        pictures = pictures or Pictures()
        pictures.begin(result)
        futures = (
            in_background(run_record, result),
            in_background(page_content, result, pictures),
        )
        with stages.stage("sound files") as watch:
            write_sound(result.sound, folder, watch)
        write_record(result, stages, pictures, *futures)
    return result


@one_blas_thread
def run(
    scene: Scene, out: str | Path | None, stages: Stages, dynamics: Dynamics
) -> Result:
    """Solve a scene with `solve` and write the result into `out` with `write`.

    Write access to the folder is checked before any computation. `sonify.run` describes
    the parameters.
    """
    scene = check_solvable_scene(scene, None)
    with claimed_folder(out or Path("outputs") / scene.name) as folder:
        if notice := replaced_results(scene, folder):
            stages.notice(notice)
        if notice := unused_keys_notice(scene):
            stages.notice(notice)
        pictures = Pictures()
        result = solve(
            scene,
            stages=stages,
            eigenmodes=cached_modes,
            listen=listen_in_worker,
            begin=pictures.begin,
            dynamics=dynamics,
        )
        stages.answer(result)
        return write(result, folder, stages, pictures)


def cached_modes(scene: Scene, below: float) -> Modes:
    """Return the modes of the disk below a frequency [Hz]; they are cached for each
    disk."""
    return _modes_of(body_scene(scene), below)


@lru_cache(4)  # the modes of one disk may take 100 MB
def _modes_of(body: BodyScene, below: float) -> Modes:
    if painter.cache_info().currsize == 0:  # no worker was started
        return eigenmodes(body, below=below)
    return painter().call(eigenmodes, body, below=below)
