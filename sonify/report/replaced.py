"""Report the results of an earlier run that a new run replaces."""

from pathlib import Path

from sonify.scene import Scene, differing_values, load_scene, scene_record
from sonify.scene_errors import SceneError


def replaced_results(scene: Scene, folder: Path) -> str:
    """Return one line on the results in a folder that a run of `scene` replaces.

    It lists the keys that differ. It is empty if the folder contains no run or a run of
    the same scene with the same settings.
    """
    record = folder / "run.json"
    if not record.is_file():
        return ""
    try:
        earlier = load_scene(record)
    except SceneError as error:
        return f"{folder}: will replace results of a run that cannot be read ({error})"
    values = differing_values(scene_record(earlier), scene_record(scene))
    differing = [key for key in values if key != "name"]
    if not differing and earlier.name == scene.name:
        return ""
    max_shown = 8
    shown = differing[:max_shown]
    if len(differing) > max_shown:
        shown.append(f"{len(differing) - max_shown} more")
    keys = f" (different: {', '.join(shown)})" if shown else ""
    return f"{folder}: will replace the results of {earlier.name}{keys}"
