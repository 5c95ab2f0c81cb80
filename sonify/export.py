"""SCENE -> FILE: the elastic modes for other programs."""

from pathlib import Path

from modal import as_faust, write_uff, write_vtu
from sonify.files import whole
from sonify.pipeline import planned, solvable
from sonify.scene import Scene
from sonify.scene_errors import InputError

FORMS = {
    "faust": ("dsp", lambda modes, path: Path(path).write_text(as_faust(modes), "utf-8")),
    "uff": ("uff", write_uff),
    "vtu": ("vtu", write_vtu),
}
"""Name -> the suffix of its files, and what writes modes to a path."""


def export_modes(scene: Scene | str | Path, form: str, out: str | Path | None = None) -> Path:
    """Write the modes that a run of the scene has, damped alike, in one of `FORMS`; return the path of the file, unless
    given <scene name>.<suffix>. Raises InputError where the scene or the form cannot do it."""
    scene = solvable(scene, None)
    suffix, write = FORMS[form]
    _, modes = planned(scene)
    path = Path(out or f"{scene.name}.{suffix}")
    try:
        with whole(path) as temporary:
            write(modes, temporary)
    except (ValueError, ModuleNotFoundError) as error:
        raise InputError(str(error)) from None
    return path
