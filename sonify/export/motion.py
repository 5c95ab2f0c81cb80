"""Export the motion of a scene as an animated model or as a table."""

import csv
from math import ceil, isfinite
from pathlib import Path

import numpy as np

from dynamics import Motion
from dynamics.motion import COLUMNS, FORCE_COLUMNS
from modal.blas_threads import one_blas_thread
from sonify.export.gltf import animated_model
from sonify.export.scene_source import scene_to_export
from sonify.extras import require_extra
from sonify.plan.preflight import motion_plan_with_table, solve_motion
from sonify.runtime.files import atomic_write
from sonify.runtime.progress import Stages
from sonify.scene import Scene
from sonify.scene_errors import InputError

MOTION_SUFFIXES = {"gltf": "glb", "parquet": "parquet", "csv": "csv"}
"""File suffix of each format."""


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
        File format, one of MOTION_SUFFIXES.
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
        If the scene cannot be solved, if the rate is out of range, or if the package
        for Parquet files is missing.
    """
    if rate is not None and not (isfinite(rate) and rate > 0):
        raise InputError(f"--rate = {rate:g}: must be greater than 0")
    if form == "parquet":
        require_extra("--as parquet", "pyarrow", "sweep")
    scene, plan = scene_to_export(scene)
    path = Path(out or f"{scene.name}.{MOTION_SUFFIXES[form]}")
    stages = stages or Stages()
    with stages.stage("motion") as watch:
        motion = solve_motion(motion_plan_with_table(scene, plan), watch)
    if rate is None and form == "gltf":
        rate = 60.0  # frames per second
    times = _row_times(motion, rate)
    with stages.stage(path.name), atomic_write(path) as temporary:
        if form == "gltf":
            as_text = path.suffix.lower() == ".gltf"
            temporary.write_bytes(animated_model(scene, motion, times, as_text))
        elif form == "parquet":
            write_parquet(motion, times, temporary)
        else:
            write_csv(motion, times, temporary)
    return path


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


def write_parquet(motion: Motion, times: np.ndarray, path: Path):
    """Write the rows of a motion to a Parquet file."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    names, rows = motion_rows(motion, times)
    table = pa.table(dict(zip(names, rows.T.copy(), strict=True)))
    with open(path, "wb") as file:  # pyarrow accepts only paths in UTF-8
        pq.write_table(table, file)


def write_csv(motion: Motion, times: np.ndarray, path: Path):
    """Write the rows of a motion to a text file, with all digits of each number."""
    names, rows = motion_rows(motion, times)
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        writer.writerows(row.tolist() for row in rows)
