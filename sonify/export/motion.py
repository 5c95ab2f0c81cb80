"""Export the motion of a scene as an animated model or as a table."""

import csv
from math import ceil, isfinite
from pathlib import Path

import numpy as np

from dynamics import Motion
from dynamics.motion import COLUMNS, FORCE_COLUMNS
from dynamics.observables import precession_rate
from modal.blas_threads import one_blas_thread
from sonify.export.scene_source import folder_of_run, scene_to_export
from sonify.extras import require_extra
from sonify.plan.preflight import motion_plan_with_table, solve_motion
from sonify.runtime.files import atomic_write
from sonify.runtime.progress import Stages
from sonify.scene import Scene
from sonify.scene_errors import InputError

MOTION_SUFFIXES = {"gltf": "glb", "parquet": "parquet", "csv": "csv"}
"""File suffix of each format."""


DEFAULT_FRAME_RATE = 60.0
"""Frames of a model per second."""
UNITS = {
    "t": "s",
    "precession": "rad",
    "inclination": "rad",
    "spin": "rad",
    "x": "m",
    "y": "m",
    "omega_1": "rad/s",
    "omega_2": "rad/s",
    "omega_3": "rad/s",
    "slip_1": "m/s",
    "slip_2": "m/s",
    "dissipated_energy": "J",
    "friction_1": "N",
    "friction_2": "N",
    "normal_force": "N",
}
"""Unit of each column of a table."""


@one_blas_thread
def export_motion(
    scene: Scene | str | Path,
    form: str,
    out: str | Path | None = None,
    rate: float | None = None,
    stages: Stages | None = None,
) -> Path:
    """Solve the motion of a scene and write it to a file.

    Parameters
    ----------
    scene : Scene, str or Path
        Scene, shipped name, scene file, or the folder or run.json of an earlier run.
    form : str
        File format, one of MOTION_SUFFIXES. A model of a run in a folder contains its
        audible.wav, if the folder has one.
    out : str or Path, optional
        Path of the file (default: <scene name>.<suffix>). A model is written as text if
        the name ends in .gltf.
    rate : float, optional
        Frames or rows per second (default: 60 for a model, the ends of the pieces of
        the solution for a table).
    stages : Stages, optional
        Receives the progress.

    Returns
    -------
    Path
        Path of the file.

    Raises
    ------
    InputError
        If the scene cannot be solved, if the rate is out of range, if the package for
        models or Parquet files is missing, or if audible.wav is not readable.
    """
    if rate is not None and not (isfinite(rate) and rate > 0):
        raise InputError(f"--rate = {rate:g}: must be greater than 0")
    if form == "parquet":
        require_extra("--as parquet", "pyarrow", "sweep")
    if form == "gltf":
        require_extra("--as gltf", "pygltflib", "export")
    sound = _sound_of_run(scene)
    scene, plan = scene_to_export(scene)
    path = Path(out or f"{scene.name}.{MOTION_SUFFIXES[form]}")
    stages = stages or Stages()
    with stages.stage("motion") as watch:
        motion = solve_motion(motion_plan_with_table(scene, plan), watch)
    if form == "gltf":
        rate = rate or DEFAULT_FRAME_RATE
        if line := aliasing_notice(motion, rate):
            stages.notice(line)
    times = _row_times(motion, rate)
    with stages.stage(path.name), atomic_write(path) as temporary:
        if form == "gltf":
            from sonify.export.gltf import animated_model

            as_text = path.suffix.lower() == ".gltf"
            model = animated_model(scene, motion, times, as_text, sound)
            temporary.write_bytes(model)
        elif form == "parquet":
            write_parquet(motion, times, temporary)
        else:
            write_csv(motion, times, temporary)
    return path


def _sound_of_run(source: Scene | str | Path) -> Path | None:
    """Return audible.wav in the folder of a run, or None if there is none."""
    folder = folder_of_run(source)
    sound = folder and folder / "audible.wav"
    return sound if sound and sound.is_file() else None


def aliasing_notice(motion: Motion, rate: float) -> str:
    """Return a line on the turns of the contact that a frame rate [1/s] cannot show, or
    "" if it shows all of them."""
    turns = np.abs(precession_rate(motion.state)).max() / (2 * np.pi)
    if turns <= rate / 2:
        return ""
    return (
        f"{rate:g} frames per second show up to {rate / 2:g} turns per second; above, the disk "
        f"seems to turn backwards. The contact turns up to {turns:.3g} times per second; "
        f"--rate {ceil(2 * turns)} shows all turns"
    )


def _row_times(motion: Motion, rate: float | None) -> np.ndarray:
    """Return the times [s] of the rows: at `rate` [1/s] from 0 on, plus the end of the
    motion."""
    # Largest number of rows or frames; a table of this size occupies 2 GB of memory
    max_rows = 20_000_000
    if rate is None:
        return motion.t
    end = motion.t[-1]
    if end * rate > max_rows:
        raise InputError(
            f"--rate = {rate:g}: would produce more than {max_rows} rows for a motion of {end:.3g} s"
        )
    return np.append(np.arange(ceil(end * rate)) / rate, end)


def motion_rows(motion: Motion, times: np.ndarray) -> tuple[list[str], np.ndarray]:
    """Return the names (c,) and values (k, c) of the column "t" and those of
    `Motion.to_frame` at times (k,) [s]."""
    names = ["t", *COLUMNS, *FORCE_COLUMNS]
    return names, np.column_stack([times, *motion.at_and_force(times)])


def write_parquet(motion: Motion, times: np.ndarray, path: Path) -> None:
    """Write the rows of a motion to a Parquet file, with `unit` in the metadata of each
    column."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    names, rows = motion_rows(motion, times)
    schema = pa.schema(
        [pa.field(name, pa.float64(), metadata={"unit": UNITS[name]}) for name in names]
    )
    table = pa.table(dict(zip(names, rows.T.copy(), strict=True)), schema=schema)
    with open(path, "wb") as file:  # pyarrow accepts only paths in UTF-8
        pq.write_table(table, file)


def write_csv(motion: Motion, times: np.ndarray, path: Path) -> None:
    """Write the rows of a motion to a text file, with all digits of each number and the
    units in the header."""
    names, rows = motion_rows(motion, times)
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([f"{name} [{UNITS[name]}]" for name in names])
        writer.writerows(row.tolist() for row in rows)
