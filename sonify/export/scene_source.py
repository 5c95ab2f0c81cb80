"""Find the scene to export, also in the folder of a run."""

from pathlib import Path

from dynamics import MotionPlan
from sonify.plan.preflight import solvable_scene
from sonify.scene import Scene


def scene_to_export(scene: Scene | str | Path) -> tuple[Scene, MotionPlan]:
    """Return a scene and the decisions of its motion.

    The scene is given as such, by name, by its file, or by the folder or run.json of an
    earlier run. Raises InputError if it cannot be solved."""
    folder = folder_of_run(scene)
    return solvable_scene(folder / "run.json" if folder else scene, None)


def folder_of_run(scene: Scene | str | Path) -> Path | None:
    """Return the folder of the run that is given by its folder or its run.json, or None
    if another source is given."""
    if isinstance(scene, Scene):
        return None
    path = Path(scene)
    folder = path.parent if path.name == "run.json" else path
    return folder if (folder / "run.json").is_file() else None
