"""Table of a sweep, runs.parquet, which loses no added row if the process or the
machine fails.

Rows are first committed to an SQLite database. They are exported to the table
periodically, at the end, and when an interrupted sweep resumes; the file is then
replaced atomically."""

import errno
import json
import os
import sqlite3
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
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
DATABASE_FILE = "runs.sqlite"
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
        identity: dict,
        axes: list[str],
        count: int,
        retry: bool = False,
    ):
        self.folder = Path(folder)
        self.identity = identity
        self.axes = axes
        self.path = self.folder / RUNS_FILE
        self.database_path = self.folder / DATABASE_FILE
        self.done = np.zeros(count, bool)
        self.failed = 0
        self._retry = retry
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
            self._require_identity(self.path, metadata.get(IDENTITY_KEY, b"null"))
            self._database = stack.enter_context(closing(self._open_database()))
            self.export()
            found = _read_parquet(pq.read_table, self.path)
            if self._retry and "error" in found.column_names:
                found = found.filter(pc.is_null(found["error"]))
            self.done[found["run"].to_numpy()] = True
            self._resources = stack.pop_all()
        return self

    def __exit__(self, kind, *_):
        with self._resources:
            if kind is not None and issubclass(kind, OSError):
                return  # on a full disk, the rows stay in the database
            self.export()
            self._database.close()
            self.database_path.unlink(missing_ok=True)

    def add(self, rows: list[dict[str, Any]]):
        """Commit rows to the database and to disk. Raises OSError if the disk is
        full."""
        if not rows:
            return
        records = [(row["run"], json.dumps(row)) for row in rows]
        with self._database_errors(), self._database as transaction:
            transaction.executemany(
                "INSERT OR REPLACE INTO runs VALUES (?, ?)", records
            )
        self.done[[row["run"] for row in rows]] = True
        self.failed += sum(row.get("error") is not None for row in rows)
        interval = max(
            30.0, 20 * self._export_seconds
        )  # s; exports take at most 5 % of the time
        if monotonic() - self._export_end > interval:
            self.export()

    def export(self):
        """Move the rows of the database into the Parquet file."""
        start = monotonic()
        with self._database_errors():
            records = self._database.execute(
                "SELECT content FROM runs ORDER BY run"
            ).fetchall()
        if records:
            rows = [json.loads(content) for (content,) in records]
            known = _read_parquet(pq.read_schema, self.path)
            new = _as_table(rows, known, self.axes)
            old = _read_parquet(pq.read_table, self.path)
            old = old.filter(pc.invert(pc.is_in(old["run"], new["run"])))
            self._write(
                pa.concat_tables([old, new], promote_options="default").sort_by("run")
            )
            with self._database_errors(), self._database as transaction:
                transaction.execute("DELETE FROM runs")
        self._export_end = monotonic()
        self._export_seconds = self._export_end - start

    def _open_database(self) -> sqlite3.Connection:
        """Open the database, or create it with the identity of this sweep."""
        with self._database_errors():
            database = sqlite3.connect(self.database_path)
            with ExitStack() as stack:
                stack.enter_context(closing(database))
                # An exclusive database needs no shared memory, which network drives lack.
                database.execute("PRAGMA locking_mode = EXCLUSIVE")
                database.execute("PRAGMA journal_mode = WAL")
                database.execute("PRAGMA synchronous = FULL")
                with database:
                    database.execute(
                        "CREATE TABLE IF NOT EXISTS runs (run INTEGER PRIMARY KEY, content TEXT)"
                    )
                    database.execute("CREATE TABLE IF NOT EXISTS sweep (identity TEXT)")
                    database.execute(
                        "INSERT INTO sweep SELECT ? WHERE NOT EXISTS (SELECT * FROM sweep)",
                        [json.dumps(self.identity)],
                    )
                (identity,) = database.execute("SELECT identity FROM sweep").fetchone()
                self._require_identity(self.database_path, identity)
                stack.pop_all()
            _sync_folder(self.folder)
            return database

    def _require_identity(self, path: Path, identity: str | bytes):
        """Raise InputError unless a file belongs to this sweep."""
        if json.loads(identity) != self.identity:
            raise InputError(
                f"{path}: the table of another sweep; rename this sweep or remove the file"
            )

    @contextmanager
    def _database_errors(self) -> Iterator[None]:
        """Convert errors of the database to OutputError, or to OSError if the disk is
        full."""
        try:
            yield
        except sqlite3.Error as error:
            primary_code = error.sqlite_errorcode & 0xFF
            # SQLite reports an exceeded quota or file size limit as an I/O error.
            if primary_code in (sqlite3.SQLITE_FULL, sqlite3.SQLITE_IOERR):
                raise OSError(
                    errno.ENOSPC, str(error), str(self.database_path)
                ) from None
            raise OutputError(f"{self.database_path}: {error}") from None

    def _write(self, rows):
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
        rows = rows.select(present + rest)
        rows = rows.replace_schema_metadata({IDENTITY_KEY: json.dumps(self.identity)})
        with atomic_write(self.path) as temporary, open(temporary, "wb") as written:
            pq.write_table(rows, written, compression="zstd")
            written.flush()
            os.fsync(written.fileno())
        _sync_folder(self.folder)


def read_table(path: str | Path) -> tuple[pa.Table, dict]:
    """Return a table and the identity of its sweep.

    Raises InputError if the file is not the table of a sweep.
    """
    if not Path(path).is_file():
        raise InputError(f"{path}: no such file")
    try:
        rows = _read_parquet(pq.read_table, path)
        return rows, json.loads(rows.schema.metadata[IDENTITY_KEY])
    except (OSError, pa.ArrowInvalid) as error:
        raise InputError(
            f"{path}: cannot be read: {' '.join(str(error).split())}"
        ) from None
    except (KeyError, TypeError):
        raise InputError(f"{path}: not the table of a sweep") from None


def _read_parquet(read, path):
    """Return what a reader of pyarrow finds in a file; pyarrow accepts only paths in
    UTF-8."""
    with open(path, "rb") as file:
        return read(file)


def _as_table(rows, known, axes):
    names = dict.fromkeys(name for row in rows for name in row)
    return pa.table(
        {
            name: column_array(
                name, [row.get(name) for row in rows], known, name in axes
            )
            for name in names
        }
    )


def column_array(name, values, known, axis):
    """Return a column, in which non-finite numbers are null unless it is an axis."""
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


def _sync_folder(folder):
    """Synchronize a folder to disk; on Windows this is neither possible nor
    necessary."""
    if os.name == "posix":
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
