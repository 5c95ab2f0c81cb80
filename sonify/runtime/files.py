"""Atomic file output; temporary files are removed however a run ends."""

import errno
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from itertools import chain, count
from pathlib import Path
from secrets import token_hex

from filelock import FileLock, Timeout

TEMPORARY_PREFIX = ".sonify-"
"""Prefix of the names of unfinished files and of their locks."""


class OutputError(OSError):
    """Raised with a one-line message if the output folder is not writable."""


def create_folder(folder: str | Path) -> Path:
    """Create `folder` if it does not exist, and return its path.

    Raises OutputError if the folder is not writable.
    """
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _locked_temporary_name(folder):
            return folder
    except OutputError:
        raise
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None


def path_for_libsndfile(path: str | Path) -> str | bytes:
    """Return a path as soundfile requires it: on Unix the bytes of the name, which may
    not be UTF-8."""
    return str(path) if sys.platform == "win32" else os.fsencode(path)


def readable_text(text: str) -> str:
    """Return a text for files and pictures, in which bytes of file names that are not
    UTF-8 are shown as `\\xe9`.

    Python represents them by surrogates, which cannot be encoded.
    """
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


def first_matching_folder(first: Path, is_suitable: Callable[[Path], bool]) -> Path:
    """Return the first of the folders `first`, `first`-2, ... for which `is_suitable`
    is True."""
    return next(
        filter(
            is_suitable,
            chain([first], (first.with_name(f"{first.name}-{n}") for n in count(2))),
        )
    )


@contextmanager
def claimed_folder(folder: str | Path) -> Iterator[Path]:
    """Create and yield the folder; at the end, remove created folders that are still
    empty.

    Raises OutputError if the folder is not writable.
    """
    path = Path(folder)
    new = [
        made for made in (path, *path.parents) if not os.path.exists(made)
    ]  # Path.exists raises if the path is too long
    try:
        yield create_folder(folder)
    finally:
        for made in new:
            with suppress(OSError):  # it is not empty, or was not created
                made.rmdir()


def write_text(text: str, path: str | Path) -> None:
    """Write a text atomically to a file, as `readable_text` in UTF-8."""
    with atomic_write(path) as temporary:
        temporary.write_text(readable_text(text), "utf-8")


@contextmanager
def atomic_write(path: str | Path) -> Iterator[Path]:
    """Yield a temporary path in the folder of `path`, for an atomic write.

    The temporary file is renamed to `path` if the block succeeds, and removed if it
    fails. Temporary files left in the folder by killed processes are also removed.
    Raises IsADirectoryError if `path` is a directory. An OSError without a file name,
    as for a full disk, is given the name `path`."""
    path = Path(path)
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    path.parent.mkdir(parents=True, exist_ok=True)
    _remove_orphans(path.parent)
    with _locked_temporary_name(path.parent) as name:
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
def _locked_temporary_name(folder: Path) -> Iterator[str]:
    """Yield a unique hidden file name in `folder`, locked until the block or the
    process ends."""
    lock = folder / f"{TEMPORARY_PREFIX}{token_hex(6)}.lock"
    try:
        lock.touch()  # FileLock may wait forever if it cannot create the file
    except FileNotFoundError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None
    try:
        with FileLock(lock, thread_local=False):
            yield lock.stem
    finally:
        _unlink(lock)


def _remove_orphans(folder: Path) -> None:
    """Remove the unfinished files in `folder` that are no longer locked by a living
    process."""
    for lock in folder.glob(f"{TEMPORARY_PREFIX}*.lock"):
        with suppress(Timeout):
            with FileLock(lock, timeout=0):
                for orphan in folder.glob(f"{lock.stem}.*"):
                    _unlink(orphan)
            _unlink(lock)  # Windows cannot remove a held lock


def _unlink(path: Path) -> None:
    with suppress(PermissionError):  # Windows: the holder of the lock removes it later
        path.unlink(missing_ok=True)
