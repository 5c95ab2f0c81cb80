"""Entry points that import the program while a background thread compiles the flows."""

from pathlib import Path
from typing import TYPE_CHECKING, Literal

from dynamics.motion_plan import MotionPlan
from dynamics.simulation import compile_in_background
from sonify.plan.motion import planned_scene
from sonify.report.render_worker import painter
from sonify.runtime.imports import import_signal_without_stats
from sonify.runtime.progress import Stages
from sonify.scene import Scene

if TYPE_CHECKING:
    from sonify.result import Result


def run(
    scene: Scene | str | Path,
    out: str | Path | None = None,
    accuracy: str | None = None,
    stages: Stages | None = None,
    dynamics: Literal["compressed", "natural"] = "compressed",
) -> "Result":
    """Solve a scene and write the result into `out`.

    Write access to the folder is checked before any computation.

    Parameters
    ----------
    scene : Scene, str or Path
        A scene, or a name or path that `load_scene` accepts.
    out : str or Path, optional
        Output folder; outputs/<scene name> by default.
    accuracy : str, optional
        "draft", "standard" or "reference"; replaces the accuracy of the scene.
    stages : Stages, optional
        Receives the progress of the run.
    dynamics : str
        Dynamics of audible.wav, "compressed" or "natural".

    Returns
    -------
    Result
        The result, with the folder of its files in `out`.

    Raises
    ------
    SceneError
        If the scene is invalid or cannot be solved.
    OutputError
        If `out` cannot be written.
    OSError
        If the disk is full.

    Examples
    --------
    >>> from sonify import run
    >>> result = run("published", out="outputs/x")  # doctest: +SKIP
    >>> result.out / "sound.wav"  # doctest: +SKIP
    PosixPath('outputs/x/sound.wav')
    """
    scene, motion_plan = begin_run(scene, accuracy)
    painter()
    import_signal_without_stats()
    from sonify import pipeline  # slow to import

    return pipeline.run(scene, motion_plan, out, stages or Stages(), dynamics)


def begin_run(
    scene: Scene | str | Path, accuracy: str | None
) -> tuple[Scene, MotionPlan]:
    """Return the scene with the given accuracy and the decisions of its motion, and start
    to compile its flows."""
    scene, motion_plan = planned_scene(scene, accuracy)
    compile_in_background(motion_plan)
    return scene, motion_plan
