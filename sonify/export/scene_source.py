"""Find the scene to export, also in the folder of a run."""

from pathlib import Path

from sonify.scene import Scene


def scene_or_run_record(scene: Scene | str | Path) -> Scene | str | Path:
    """Return the path of run.json if `scene` is the folder of a run, and otherwise
    `scene` unchanged."""
    if isinstance(scene, Scene):
        return scene
    record = Path(scene) / "run.json"
    return record if record.is_file() else scene
