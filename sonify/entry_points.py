"""The doors of the program: while a compiler makes the flows that a scene needs, the rest of the
program is loaded."""

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from dynamics.simulation import compile_in_background
from sonify.report.render_worker import painter
from sonify.runtime.progress import Stages
from sonify.scene import Scene, scene_of

if TYPE_CHECKING:
    from sonify.result import Result


def run(
    scene: Scene | str | Path,
    out: str | Path | None = None,
    accuracy: str | None = None,
    stages: Stages | None = None,
) -> "Result":
    """As `sonify.pipeline.run`: solve `scene`, or what `load_scene` takes, and write the result
    into `out`."""
    scene = begun(scene, accuracy)
    painter()
    from sonify import pipeline  # loads slowly

    return pipeline.run(scene, out, stages=stages)


def begun(scene: Scene | str | Path, accuracy: str | None) -> Scene:
    """Return the scene with that accuracy, its flows being compiled; what is wrong with it the
    pipeline will say."""
    scene = scene_of(scene, accuracy)
    with suppress(ValueError):
        compile_in_background(scene)
    return scene
