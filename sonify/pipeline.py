"""SCENE -> PLAN -> MODES -> MOTION -> SOUND -> FINDINGS -> FILES: the whole program on one screen."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from dynamics import ImpossibleContactError, Motion, simulate
from dynamics.simulation import chosen_integrator, prepare
from modal import Modes, UnsolvableError, eigenmodes, with_radiation
from modal.one_thread import one_blas_thread
from modal.radiation import TOP
from modal.solve import check
from sonify.claims.checks import Check, all_checks
from sonify.claims.motion import Finding, all_findings
from sonify.claims.sound import all_verdicts
from sonify.files import claimed
from sonify.hearing.loudness import unheard
from sonify.hearing.recording import Heard, RecordingError, listen
from sonify.plan.plan import Plan, plan_of, with_end, with_voices
from sonify.plan.predictions import SOUND
from sonify.progress import Stages
from sonify.report.write import write_record
from sonify.scene import Scene, SceneError, load_scene
from sonify.sound.audible_modes import after_a_jump
from sonify.sound.pressure import Sound
from sonify.sound.render import Renderer
from sonify.sound.wav import write_sound

if TYPE_CHECKING:
    from PIL.Image import Image

RECORDS = ("run.json", "report.html")
"""What speaks of the other files; that of an earlier run goes before the first of them is replaced."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Result:
    """What a run found, `seconds` by stage. Its files are in `out`, where they have been written."""

    scene: Scene
    plan: Plan
    motion: Motion
    modes: Modes
    sound: Sound
    heard: Heard | None
    findings: list[Finding]
    checks: list[Check]
    seconds: dict[str, float]
    out: Path | None = None

    @property
    def passed(self) -> bool:
        """Whether every self-check passed."""
        return all(check.passed for check in self.checks)

    def plot(self, name: str = "spectrogram") -> "Image":
        """Return the picture of that name (spectrogram, stems, motion, modes), which a notebook shows; a PIL image."""
        from sonify.report.pictures import picture  # drawing loads slowly

        return picture(self, name)

    def __repr__(self):
        from sonify.report.page import in_words

        return in_words(self)

    def _repr_html_(self):
        from sonify.report.page import in_a_notebook

        return in_a_notebook(self)


@one_blas_thread
def solve(scene: Scene | str | Path, accuracy: str | None = None, stages: Stages | None = None) -> Result:
    """Return everything that a run of a scene, or of what `load_scene` takes, finds; no file is written.

    `accuracy` (draft, standard, reference) replaces the scene's. Raises SceneError where the scene cannot be solved.
    """
    scene, stages = solvable(scene, accuracy), stages or Stages()
    prepare(scene)
    with stages.stage("modes"):
        plan, modes = planned(scene)
    with stages.stage("motion") as watch:
        motion = solve_motion(
            scene, lambda t, inclination, doing: watch(0.0, doing or f"t = {t:.2f} s, inclination {inclination:.2g}")
        )
    with stages.stage("sound") as watch:
        sound = Renderer(scene, motion, modes, plan.voices, plan.calm).sound(watch)
    with stages.stage("findings"):
        heard, silence = hear(sound)
        checks = all_checks(scene, motion, modes, sound)
        findings = all_findings(motion, modes) + all_verdicts(heard, motion, modes, sound, plan.error(SOUND))
    return Result(
        scene=scene,
        plan=with_end(plan, motion, silence),
        motion=motion,
        modes=modes,
        sound=sound,
        heard=heard,
        findings=findings,
        checks=checks,
        seconds=stages.seconds,
    )


@one_blas_thread
def write(result: Result, out: str | Path | None = None, stages: Stages | None = None) -> Result:
    """Write sound, pictures and report into `out` (default outputs/<scene name>), return the result that knows it.

    Raises OutputError when `out` cannot be written, and OSError when the disk is full. No file is ever left half
    written.
    """
    stages = stages or Stages(result.seconds)
    with claimed(out or Path("outputs") / result.scene.name) as folder:
        for stale in RECORDS:
            (folder / stale).unlink(missing_ok=True)
        with stages.stage("sound files") as watch:
            write_sound(result.sound, folder, watch)
        result = replace(result, out=folder)
        write_record(result, stages)
    return result


@one_blas_thread
def run(
    scene: Scene | str | Path,
    out: str | Path | None = None,
    accuracy: str | None = None,
    stages: Stages | None = None,
) -> Result:
    """Solve `scene` and write the result into `out`, which is known to be writable before any work: `solve`, `write`.

    Raises what these do.
    """
    scene, stages = solvable(scene, accuracy), stages or Stages()
    with claimed(out or Path("outputs") / scene.name) as folder:
        result = solve(scene, stages=stages)
        stages.answer(result)
        return write(result, folder, stages)


def solvable(scene: Scene | str | Path, accuracy: str | None) -> Scene:
    """Return the scene with that accuracy. Raises SceneError, before any work, where its disk, support or integrator
    cannot be solved."""
    scene = scene if isinstance(scene, Scene) else load_scene(scene)
    scene = scene.replace(f"numerics.accuracy={accuracy}") if accuracy else scene
    try:
        check(scene.disk, scene.support)
        chosen_integrator(scene.numerics.integrator)
    except ValueError as error:
        raise SceneError(str(error)) from None
    return scene


def planned(scene: Scene) -> tuple[Plan, Modes]:
    """Return what is to be computed, and the modes, which the plan needs to say which of them sound. Raises SceneError
    where there are too many modes, where the patch is lost in round-off, and where decay rates are given for more modes
    than there are."""
    plan = plan_of(scene)
    try:
        elastic = eigenmodes(scene, below=plan.highest_mode)
    except UnsolvableError as error:
        raise SceneError(str(error)) from None
    modes = damped(with_radiation(elastic, (TOP,)), scene.material.decay_rates)
    return with_voices(plan, scene, modes, *after_a_jump(modes, scene)), modes


def damped(modes: Modes, measured: tuple[float, ...]) -> Modes:
    """Return the modes, the first of them with the decay rates [1/s] that were `measured`."""
    if len(measured) > len(modes):
        raise SceneError(f"material.decay_rates: {len(measured)} values, but only {len(modes)} modes are sought")
    return modes.with_decay([*measured, *modes.decay_rate[len(measured) :]]) if measured else modes


def solve_motion(scene: Scene, watch=lambda t, inclination, doing: None) -> Motion:
    """Return the motion of a scene. Raises SceneError where no contact force satisfies the balance laws."""
    try:
        return simulate(scene, watch)
    except ImpossibleContactError as error:
        raise SceneError(f"friction, release: {error}") from None


def hear(sound: Sound) -> tuple[Heard | None, list[str]]:
    """Return what the rendered sound tells by itself, or None; and what it does not tell, and why."""
    try:
        heard = listen(sound.pressure)
    except RecordingError as error:
        return None, [f"A verdict by ear: {error}.", *unheard()]
    silent = ["Claims on the rising tone: none stands out."] if heard.tone is None else []
    return heard, [*unheard(), *silent]
