"""Table of a sweep, runs.parquet, which is complete at any time.

The file is replaced atomically, by one with the rows added since. This happens so often
that it takes 5 % of the time, and at the end. If the process or the machine fails, the
runs since then are solved again when the sweep resumes."""

import json
import os
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq
from filelock import FileLock, Timeout

from sonify.runtime.files import OutputError, atomic_write, claimed_folder
from sonify.scene_errors import InputError

RUNS_FILE = "runs.parquet"
IDENTITY_KEY = b"sonify.sweep"
"""Metadata key in the Parquet file for the identity of the sweep."""


class RunStore:
    """Context manager for the table of a sweep in `folder`, with exclusive write
    access.

    The mask `done` (count,) marks the runs in the table, excluding those that ended
    with an error if `retry` is True. Entering raises OutputError if another process
    writes the table, and InputError if the table belongs to another sweep."""

    def __init__(
        self,
        folder: str | Path,
        identity: dict[str, Any],
        axes: list[str],
        count: int,
        retry: bool = False,
    ) -> None:
        self.folder = Path(folder)
        self.identity = identity
        self.axes = axes
        self.path = self.folder / RUNS_FILE
        self.done = np.zeros(count, bool)
        self.failed = 0
        self._retry = retry
        self._added: list[dict[str, Any]] = []
        self._export_end = 0.0
        self._export_seconds = 0.0

    def __enter__(self) -> "RunStore":
        with ExitStack() as stack:
            stack.enter_context(claimed_folder(self.folder))
            lock = FileLock(self.folder / ".runs.lock", timeout=0)
            try:
                stack.enter_context(lock)
            except Timeout:
                raise OutputError(
                    f"{self.folder}: another sweep is writing this table"
                ) from None
            if not self.path.exists():
                self._write(pa.table({"run": pa.array([], pa.int64())}))
            metadata = _read_parquet(pq.read_schema, self.path).metadata
            if _identity(metadata.get(IDENTITY_KEY, b"null")) != self.identity:
                raise InputError(
                    f"{self.path}: the table of another sweep; rename this sweep or remove the "
                    "file"
                )
            found = _read_parquet(pq.read_table, self.path)
            if self._retry and "error" in found.column_names:
                found = found.filter(pc.is_null(found["error"]))
            self.done[found["run"].to_numpy()] = True
            self._resources = stack.pop_all()
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        with self._resources:
            if kind is None or not issubclass(kind, OSError):  # such as a full disk
                self.export()

    def add(self, rows: list[dict[str, Any]]) -> None:
        """Add rows, which the next export writes. Raises OSError if the disk is full."""
        self._added += rows
        self.done[[row["run"] for row in rows]] = True
        self.failed += sum(row.get("error") is not None for row in rows)
        if monotonic() - self._export_end > 20 * self._export_seconds:
            self.export()

    def export(self) -> None:
        """Write the added rows into the Parquet file."""
        if not self._added:
            return
        start = monotonic()
        known = _read_parquet(pq.read_schema, self.path)
        new = _as_table(self._added, known, self.axes)
        old = _read_parquet(pq.read_table, self.path)
        old = old.filter(pc.invert(pc.is_in(old["run"], new["run"])))
        self._write(
            pa.concat_tables([old, new], promote_options="default").sort_by("run")
        )
        self._added = []
        self._export_end = monotonic()
        self._export_seconds = self._export_end - start

    def _write(self, rows: pa.Table) -> None:
        leading = [
            "run",
            *self.axes,
            "outcome",
            "error",
            "t_end",
            "passed",
            "seconds",
            "version",
        ]
        rest = sorted(
            set(rows.column_names) - set(leading),
            key=lambda name: (name.startswith("seconds_"), name),
        )
        present = [name for name in leading if name in rows.column_names]
        rows = rows.select([*present, *rest])
        rows = rows.replace_schema_metadata({IDENTITY_KEY: json.dumps(self.identity)})
        with atomic_write(self.path) as temporary, open(temporary, "wb") as written:
            pq.write_table(rows, written, compression="zstd")
            written.flush()
            os.fsync(written.fileno())
        _sync_folder(self.folder)


def read_table(path: str | Path) -> tuple[pa.Table, dict[str, Any]]:
    """Return a table and the identity of its sweep.

    Raises InputError if the file is not the table of a sweep.
    """
    if not Path(path).is_file():
        raise InputError(f"{path}: no such file")
    try:
        rows = _read_parquet(pq.read_table, path)
        return rows, _identity(rows.schema.metadata[IDENTITY_KEY])
    except (OSError, pa.ArrowInvalid) as error:
        raise InputError(
            f"{path}: cannot be read: {' '.join(str(error).split())}"
        ) from None
    except (KeyError, TypeError):
        raise InputError(f"{path}: not the table of a sweep") from None


def _identity(stored: bytes) -> Any:
    """Return the identity of a stored sweep, without the widths of ranges that tables of
    version 0.3 may name."""
    identity = json.loads(stored)
    if identity and identity.get("samples"):
        identity["samples"].pop("widths", None)
    return identity


def _read_parquet(read: Callable[..., Any], path: str | Path) -> Any:
    """Return what a reader of pyarrow finds in a file; pyarrow accepts only paths in
    UTF-8."""
    with open(path, "rb") as file:
        return read(file)


def _as_table(
    rows: list[dict[str, Any]], known: pa.Schema, axes: list[str]
) -> pa.Table:
    names = dict.fromkeys(name for row in rows for name in row)
    return pa.table(
        {
            name: column_array(
                name, [row.get(name) for row in rows], known, name in axes
            )
            for name in names
        }
    )


def column_array(
    name: str, values: list[Any], known: pa.Schema, axis: bool
) -> pa.Array:
    """Return a column, in which non-finite numbers are null unless it is an axis."""
    values = [v.item() if isinstance(v, np.generic) else v for v in values]
    given = {type(value) for value in values if value is not None}
    if name == "run":
        return pa.array(values, pa.int64())
    if given <= {bool}:
        boolean = given or name.endswith(
            "_holds"
        )  # null if a finding is undecided or absent
        absent = known.field(name).type if name in known.names else pa.null()
        return pa.array(values, pa.bool_() if boolean else absent)
    if given <= {int, float}:
        numbers = [
            float(value) if value is not None and (axis or np.isfinite(value)) else None
            for value in values
        ]
        return pa.array(numbers, pa.float64())
    return pa.array(
        [v if v is None or isinstance(v, str) else json.dumps(v) for v in values],
        pa.string(),
    )


def _sync_folder(folder: Path) -> None:
    """Synchronize a folder to disk; on Windows this is neither possible nor
    necessary."""
    if os.name == "posix":
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
