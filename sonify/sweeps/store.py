"""ROWS -> runs.parquet: a table that keeps every added row if the process or the machine fails.

Rows are first written to a journal, one line each, and synchronized to disk. Periodically, and at
the end, they move into the table, and the file is replaced atomically. A truncated line fails its
checksum and is ignored.
"""

import json
import os
from contextlib import ExitStack
from io import FileIO
from pathlib import Path
from time import monotonic
from typing import Any
from zlib import crc32

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq
from filelock import FileLock, Timeout

from sonify.runtime.files import OutputError, atomic_write, claimed_folder
from sonify.scene_errors import InputError

TABLE_FILE = "runs.parquet"
JOURNAL_FILE = "runs.journal"
LOCK_FILE = ".runs.lock"
METADATA_KEY = b"sonify.sweep"
FIRST_COLUMNS = ("run", "outcome", "error", "t_end", "passed", "seconds", "version")
"""Leading columns of every table; the axes follow the run number."""
MIN_MOVE_INTERVAL = 30.0
"""Minimum interval between moves of the journal into the table [s]."""
MOVE_INTERVAL_RATIO = 20
"""Minimum interval between moves as a multiple of the duration of the last one."""


class SweepTable:
    """Context manager for the table of a sweep in `folder`, with exclusive write access.

    `done` (count,) is True for the runs that the table contains; with `retry`, runs with an error
    do not count. On entry, raises OutputError if another process writes the table, and InputError
    if the table belongs to another sweep.
    """

    def __init__(
        self, folder: str | Path, identity: dict, axes: list[str], count: int, retry: bool = False
    ):
        self.folder = Path(folder)
        self.identity = identity
        self.axes = axes
        self.path, self.journal = self.folder / TABLE_FILE, self.folder / JOURNAL_FILE
        self.done = np.zeros(count, bool)
        self.failed = 0
        self._retry = retry
        self._moved = monotonic()
        self._took = 0.0
        self._file: FileIO | None = None

    def __enter__(self):
        with ExitStack() as stack:
            stack.enter_context(claimed_folder(self.folder))
            lock = FileLock(self.folder / LOCK_FILE, timeout=0)
            try:
                stack.enter_context(lock)
            except Timeout:
                raise OutputError(f"{self.folder}: another sweep is writing this table") from None
            if not self.path.exists():
                self._write(pa.table({"run": pa.array([], pa.int64())}))
            if (
                json.loads(pq.read_schema(self.path).metadata.get(METADATA_KEY, b"null"))
                != self.identity
            ):
                raise InputError(
                    f"{self.path}: the table of another sweep: give this one another name, or "
                    f"remove it"
                )
            self.move()
            found = pq.read_table(self.path)
            good = (
                found.filter(pc.is_null(found["error"]))
                if self._retry and "error" in found.column_names
                else found
            )
            self.done[good["run"].to_numpy()] = True
            self._held = stack.pop_all()
        return self

    def __exit__(self, kind, *_):
        with self._held:
            if kind is None or not issubclass(
                kind, OSError
            ):  # on a full disk, the rows stay in the journal
                self.move()
            self._close()

    def add(self, rows: list[dict[str, Any]]):
        """Add rows and synchronize them to disk. Raises OSError if the disk is full."""
        if not rows:
            return
        if not self._file:
            self._file = open(self.journal, "ab", buffering=0)  # noqa: SIM115
            self._put(self._file, _journal_line({"sweep": self.identity}))
            _sync_folder(self.folder)
        self._put(self._file, b"".join(map(_journal_line, rows)))
        self.done[[row["run"] for row in rows]] = True
        self.failed += sum(row.get("error") is not None for row in rows)
        if monotonic() - self._moved > max(MIN_MOVE_INTERVAL, MOVE_INTERVAL_RATIO * self._took):
            self.move()

    def move(self):
        """Move the rows of the journal into the table."""
        began = monotonic()
        if rows := self._journalled():
            new = _arrow_table(rows, pq.read_schema(self.path), self.axes)
            old = pq.read_table(self.path)
            old = old.filter(pc.invert(pc.is_in(old["run"], new["run"])))
            self._write(pa.concat_tables([old, new], promote_options="default").sort_by("run"))
        self._close()
        self.journal.unlink(missing_ok=True)
        self._moved = monotonic()
        self._took = monotonic() - began

    def _put(self, file, content):
        try:
            while content:
                content = content[file.write(content) :]
            os.fsync(file.fileno())
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(self.journal)) from None

    def _close(self):
        if self._file:
            self._file.close()
        self._file = None

    def _journalled(self):
        """Return the last journal row of each run, sorted by run number."""
        if not self.journal.exists():
            return []
        with open(self.journal, "rb") as lines:
            records = [record for line in lines if (record := _journal_record(line)) is not None]
        if any(record["sweep"] != self.identity for record in records if "sweep" in record):
            raise InputError(
                f"{self.journal}: rows of another sweep: give this one another name, or remove it"
            )
        rows = {record["run"]: record for record in records if "run" in record}
        return [rows[run] for run in sorted(rows)]

    def _write(self, table):
        names = [*FIRST_COLUMNS[:1], *self.axes, *FIRST_COLUMNS[1:]]
        rest = sorted(
            set(table.column_names) - set(names),
            key=lambda name: (name.startswith("seconds_"), name),
        )
        table = table.select([name for name in [*names, *rest] if name in table.column_names])
        table = table.replace_schema_metadata({METADATA_KEY: json.dumps(self.identity)})
        with atomic_write(self.path) as temporary:
            pq.write_table(table, temporary, compression="zstd")
            with open(temporary, "rb+") as written:
                os.fsync(written.fileno())
        _sync_folder(self.folder)


def read_table(path: str | Path) -> tuple[pa.Table, dict]:
    """Return a table and the identity of its sweep.

    Raises InputError if the file is not the table of a sweep.
    """
    if not Path(path).is_file():
        raise InputError(f"{path}: no such file")
    try:
        table = pq.read_table(path)
        return table, json.loads(table.schema.metadata[METADATA_KEY])
    except (OSError, pa.ArrowInvalid) as error:
        raise InputError(f"{path}: cannot be read: {' '.join(str(error).split())}") from None
    except (KeyError, TypeError):
        raise InputError(f"{path}: not the table of a sweep") from None


def _arrow_table(rows, known, axes):
    names = dict.fromkeys(name for row in rows for name in row)
    return pa.table(
        {
            name: _column(name, [row.get(name) for row in rows], known, name in axes)
            for name in names
        }
    )


def _column(name, values, known, axis):
    """Return one column; numbers that are not finite become null, except in an axis."""
    given = {type(value) for value in values if value is not None}
    if name == "run":
        return pa.array(values, pa.int64())
    if given <= {bool}:
        boolean = given or name.endswith("_holds")  # null if a finding is undecided or absent
        return pa.array(values, pa.bool_() if boolean else _known_type(known, name))
    if given <= {int, float}:
        numbers = [v if v is None or axis or np.isfinite(v) else None for v in values]
        return pa.array([v if v is None else float(v) for v in numbers], pa.float64())
    return pa.array(
        [v if v is None or isinstance(v, str) else json.dumps(v) for v in values], pa.string()
    )


def _known_type(schema, name):
    return schema.field(name).type if name in schema.names else pa.null()


def _journal_line(record):
    content = json.dumps(record).encode()
    return b"%08x %s\n" % (crc32(content), content)


def _journal_record(line):
    checksum, _, content = line.rstrip(b"\n").partition(b" ")
    return (
        json.loads(content)
        if checksum == b"%08x" % crc32(content) and line.endswith(b"\n")
        else None
    )


def _sync_folder(folder):
    """Synchronize a folder to disk; Windows cannot open folders and does not need this step."""
    if os.name == "posix":
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
