"""Version identifier, including uncommitted changes."""

from functools import cache
from pathlib import Path

import sonify
from dynamics.source_digest import source_digest


@cache
def version() -> str:
    """Return the version with a platform-independent digest of the source code."""
    root = Path(str(sonify.__file__)).parents[1]
    digest = source_digest(root, ("dynamics", "modal", "sonify"))
    return f"{sonify.__version__}+{digest[:8]}"
