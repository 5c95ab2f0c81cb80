"""Files that are either whole or not there."""

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path


class OutputError(OSError):
    """The output folder cannot be written; the message is one line."""


def claim(folder: str | Path) -> Path:
    """Make `folder` if need be and prove that a file can be written in it, before any work. Raises OutputError."""
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None


@contextmanager
def claimed(folder: str | Path):
    """Yield the `claim`ed folder; it is removed again if nothing came to be written in it. Raises OutputError."""
    new = not Path(folder).exists()
    folder = claim(folder)
    try:
        yield folder
    finally:
        if new and not any(folder.iterdir()):
            folder.rmdir()


@contextmanager
def whole(path: str | Path):
    """Yield a temporary path beside `path`, renamed to it if the block ends well and removed if it does not."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=".", suffix=path.suffix, dir=path.parent)
    os.close(handle)
    try:
        yield Path(name)
        os.chmod(name, 0o666 & ~_umask())
        os.replace(name, path)
    finally:
        Path(name).unlink(missing_ok=True)


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
