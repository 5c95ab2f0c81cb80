"""Report the results of an earlier run that a new run replaces."""

from pathlib import Path

from sonify.report.write import scene_record
from sonify.scene import Scene, load_scene
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
        return f"{folder}: replaces results of a run that cannot be read ({error})"
    old = values_by_dotted_key(scene_record(earlier))
    new = values_by_dotted_key(scene_record(scene))
    differing = [
        key for key in old | new if old.get(key) != new.get(key) and key != "name"
    ]
    if not differing and earlier.name == scene.name:
        return ""
    shown = differing[:8]
    more = (
        [f"{len(differing) - len(shown)} more"] if len(differing) > len(shown) else []
    )
    keys = f", which differs in {', '.join([*shown, *more])}" if differing else ""
    return f"{folder}: replaces the results of {earlier.name}{keys}"


def values_by_dotted_key(record, path=""):
    """Return the values of a nested record by dotted key; a list counts as one
    value."""
    values = {}
    for key, value in record.items():
        if isinstance(value, dict):
            values |= values_by_dotted_key(value, f"{path}{key}.")
        else:
            values[f"{path}{key}"] = value
    return values
