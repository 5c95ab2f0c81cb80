"""Find the scene to export, also in the folder of a run."""

from pathlib import Path

from dynamics import MotionPlan
from sonify.plan.preflight import solvable_scene
from sonify.scene import Scene


def scene_to_export(scene: Scene | str | Path) -> tuple[Scene, MotionPlan]:
    """Return a scene and the decisions of its motion.

    The scene is given as such, by name, by its file, or by the folder or run.json of an
    earlier run. Raises InputError if it cannot be solved."""
    if not isinstance(scene, Scene):
        record = Path(scene) / "run.json"
        scene = record if record.is_file() else scene
    return solvable_scene(scene, None)
