"""Maps of table columns over the axes of a sweep."""

from pathlib import Path

from sonify.report.maps import Map, draw_map
from sonify.runtime.files import atomic_write
from sonify.scene_errors import InputError
from sonify.scene_keys import keys as scene_keys
from sonify.suggestions import did_you_mean
from sonify.sweeps.axes import Samples, points_of
from sonify.sweeps.store import RUNS_FILE, read_table

RESULT_UNITS = {"t_end": "s", "sound_seconds": "s", "peak_pascal": "Pa"}
"""Units of the result columns."""
DEFAULT_COLUMNS = ("outcome", "t_end")
"""Columns drawn by default."""


def make_map(
    path: str | Path,
    of: str,
    x: str | None = None,
    y: str | None = None,
    out: str | Path | None = None,
) -> Path:
    """Draw a column of a table over one or two other columns.

    Parameters
    ----------
    path : str or Path
        Table of a sweep.
    of : str
        Name of the column to draw.
    x, y : str, optional
        Names of the columns for the axes of the map (default: the first two axes of the
        sweep). If only `x` is given, the map has one axis.
    out : str or Path, optional
        Path of the picture (default: <of>.png in the folder of the table).

    Returns
    -------
    Path
        Path of the picture.

    Raises
    ------
    InputError
        If a column is missing or empty.
    """
    table, about = read_table(path)
    axes = points_of(
        about["axes"], about["samples"] and Samples(**about["samples"])
    ).axes
    if not x:
        x, *others = (axis.keys[0] for axis in axes)
        y = y or next(iter(others), None)
    for name in (x, y, of):
        if name is not None and name not in table.column_names:
            known = ", ".join(table.column_names)
            hint = did_you_mean(name, table.column_names)
            raise InputError(f"{path}: no column {name!r}; known: {known}{hint}")
    if table[of].null_count == len(table):
        raise InputError(f"{path}: column {of!r} is empty")
    logs = {key for axis in axes if axis.log for key in axis.keys}
    out = Path(out or Path(path).with_name(f"{of}.png"))
    columns = {name: table[name].to_pylist() for name in (x, y, of) if name}
    if of.endswith("_holds"):
        values = table[of.removesuffix("_holds")].to_pylist()
        columns[of] = [
            verdict_text(*row) for row in zip(columns[of], values, strict=True)
        ]
    units = RESULT_UNITS | {
        key.name: key.unit for key in scene_keys() if key.unit != "-"
    }
    with atomic_write(out) as temporary:
        draw_map(
            Map(x=x, y=y, drawn_column=of, columns=columns, logs=logs, units=units),
            temporary,
        )
    return out


def verdict_text(holds: bool | None, value: float | None) -> str | None:
    """Return the verdict of a finding as text, or None if the run has no such
    finding."""
    if value is None:
        return None
    if holds is None:
        return "undecided"
    return "yes" if holds else "no"


def draw_maps(folder: Path, find: tuple[str, ...] = ()) -> None:
    """Draw the columns named in `find`, or DEFAULT_COLUMNS, of the table in
    `folder`."""
    table, _ = read_table(folder / RUNS_FILE)
    for of in [name for name in find if name in table.column_names] or DEFAULT_COLUMNS:
        if of in table.column_names and table[of].null_count < len(table):
            make_map(folder / RUNS_FILE, of)
