"""Files that are either whole or not there, and nothing left behind by whatever way a run ends."""

import errno
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from itertools import chain, count
from pathlib import Path
from secrets import token_hex

from filelock import FileLock, Timeout

HIDDEN = ".sonify-"
"""So begin the names of a file that is being written and of the lock that its writer holds as long
as it lives."""


class OutputError(OSError):
    """The output folder cannot be written; the message is one line."""


def claim(folder: str | Path) -> Path:
    """Make `folder` if need be and prove that a file can be written in it, before any work. Raises
    OutputError."""
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _alive(folder):
            return folder
    except OutputError:
        raise
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None


def numbered(first: Path, serves: Callable[[Path], bool]) -> Path:
    """Return the first of the folders `first`, `first`-2, `first`-3, ... that `serves`."""
    return next(
        filter(serves, chain([first], (first.with_name(f"{first.name}-{n}") for n in count(2))))
    )


@contextmanager
def claimed(folder: str | Path) -> Iterator[Path]:
    """Yield the `claim`ed folder; what was made for it goes again if nothing is written in it.
    Raises OutputError."""
    path = Path(folder)
    new = [
        made for made in (path, *path.parents) if not os.path.exists(made)
    ]  # Path.exists raises if it is too long
    try:
        yield claim(folder)
    finally:
        for made in new:
            with suppress(OSError):  # it holds something, or was not made
                made.rmdir()


@contextmanager
def whole(path: str | Path):
    """Yield a temporary path beside `path`, renamed to it if the block ends well and removed if it
    does not.

    Raises IsADirectoryError where `path` is one; an OSError that names no file, as of a full disk,
    names `path`. What a process that was killed has left beside it is removed, too;
    tests/test_files.py kills some."""
    path = Path(path)
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    path.parent.mkdir(parents=True, exist_ok=True)
    _remove_orphans(path.parent)
    with _alive(path.parent) as name:
        temporary = path.with_name(f"{name}{path.suffix}")
        try:
            yield temporary
            os.replace(temporary, path)
        except OSError as error:
            if error.errno is not None and error.filename is None:
                error.filename = str(path)
            raise
        finally:
            temporary.unlink(missing_ok=True)


@contextmanager
def _alive(folder):
    """Yield a hidden name that no one else has in `folder`; its lock lasts no longer than this
    process."""
    lock = folder / f"{HIDDEN}{token_hex(6)}.lock"
    try:
        lock.touch()  # where none can be made FileLock may wait for ever
    except FileNotFoundError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None
    try:
        with FileLock(lock, thread_local=False):
            yield lock.stem
    finally:
        _unlink(lock)


def _remove_orphans(folder):
    """Remove the files in `folder` whose writer is dead, which is when its lock can be had."""
    for lock in folder.glob(f"{HIDDEN}*.lock"):
        with suppress(Timeout):
            with FileLock(lock, timeout=0):
                for orphan in folder.glob(f"{lock.stem}.*"):
                    _unlink(orphan)
            _unlink(lock)  # Windows removes none that is held


def _unlink(path):
    with suppress(PermissionError):  # Windows: it is held, by us or by someone who will remove it
        path.unlink(missing_ok=True)
