"""Hash of source files, which identifies a version of the program."""

from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path


def source_digest(root: Path, folders: Iterable[str]) -> str:
    """Return a platform-independent hash of the Python files in folders of `root`."""
    digest = sha256()
    for folder in folders:
        for file in sorted(
            (root / folder).rglob("*.py"), key=lambda file: file.relative_to(root).parts
        ):
            name = file.relative_to(root).as_posix()
            digest.update(f"{name}\n{file.read_text('utf-8')}".encode())
    return digest.hexdigest()
