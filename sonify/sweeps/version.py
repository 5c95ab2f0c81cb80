"""Version identifier, including uncommitted changes."""

from functools import cache
from hashlib import sha256
from pathlib import Path

import dynamics
import modal
import sonify


@cache
def version() -> str:
    """Return the version with a platform-independent digest of the source code."""
    digest = sha256()
    for package in (dynamics, modal, sonify):
        folder = Path(str(package.__file__)).parent
        for file in sorted(
            folder.rglob("*.py"), key=lambda file: file.relative_to(folder).parts
        ):
            digest.update(
                f"{file.relative_to(folder).as_posix()}\n{file.read_text('utf-8')}".encode()
            )
    return f"{sonify.__version__}+{digest.hexdigest()[:8]}"
