"""Export the elastic modes of a scene to files for other programs."""

from math import isfinite, radians
from pathlib import Path

from modal import as_faust, write_uff, write_vtu
from sonify.export.scene_source import scene_to_export
from sonify.plan.preflight import solve_modes
from sonify.runtime.files import atomic_write
from sonify.scene import Scene
from sonify.scene_errors import InputError

SUFFIXES = {"faust": "dsp", "uff": "uff", "vtu": "vtu"}
"""File suffix of each format."""


def export_modes(
    scene: Scene | str | Path,
    form: str,
    out: str | Path | None = None,
    strike_deg: float | None = None,
) -> Path:
    """Write the modes of a scene to a file with the damping used in a run.

    Parameters
    ----------
    scene : Scene, str or Path
        Scene, shipped name, scene file, or the folder or run.json of an earlier run.
    form : str
        File format, one of SUFFIXES.
    out : str or Path, optional
        Path of the file (default: <scene name>.<suffix>).
    strike_deg : float, optional
        Strike angle of the Faust program, measured from the middle of the contact
        [degrees] (default: opposite the contact).

    Returns
    -------
    Path
        Path of the file.

    Raises
    ------
    InputError
        If the scene cannot be solved or has no modes, if a package for the format is
        missing, or if the disk cannot be struck at this angle.
    """
    scene, _ = scene_to_export(scene)
    _check_strike(scene, form, strike_deg)
    modes = solve_modes(scene)
    path = Path(out or f"{scene.name}.{SUFFIXES[form]}")
    strike = radians(180.0 if strike_deg is None else strike_deg)
    try:
        with atomic_write(path) as temporary:
            if form == "faust":
                temporary.write_text(as_faust(modes, strike), "utf-8")
            elif form == "uff":
                write_uff(modes, temporary)
            else:
                write_vtu(modes, temporary)
    except (ValueError, ModuleNotFoundError) as error:
        raise InputError(str(error)) from None
    return path


def _check_strike(scene: Scene, form: str, strike_deg: float | None) -> None:
    """Raise InputError if the supported disk cannot be struck at this angle
    [degrees]."""
    if strike_deg is None:
        return
    if form != "faust":
        raise InputError(
            f"--strike = {strike_deg:g}: allowed only with --as faust, not with --as {form}"
        )
    if not isfinite(strike_deg) or abs(strike_deg) > 360:
        raise InputError(f"--strike = {strike_deg:g}: must be from -360 to 360 degrees")
    from_patch = abs((strike_deg + 180) % 360 - 180)
    half = scene.support.half_angle_deg
    if scene.support.kind == "patch" and from_patch <= half:
        raise InputError(
            f"--strike = {strike_deg:g}: must be more than {half:g} degrees from 0, the middle of "
            f"the patch that holds the disk"
        )
