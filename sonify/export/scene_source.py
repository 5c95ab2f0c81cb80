"""SCENE or RUN -> the scene of an export."""

from pathlib import Path

from sonify.scene import Scene


def scene_of_run(scene: Scene | str | Path) -> Scene | str | Path:
    """Return the run.json in a folder of a run, and any other scene unchanged."""
    if isinstance(scene, Scene):
        return scene
    record = Path(scene) / "run.json"
    return record if record.is_file() else scene
