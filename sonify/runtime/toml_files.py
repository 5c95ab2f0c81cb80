"""NAME or PATH -> DOCUMENT: what is shipped, or a file of the user's own, read as plain values."""

import json
import tomllib
from pathlib import Path
from typing import Any

from sonify.suggestions import did_you_mean


def shipped(folder: Path) -> list[str]:
    """Return the names of what is shipped in a folder."""
    return sorted(file.stem for file in folder.glob("*.toml"))


def named(source: str | Path, folder: Path, what: str, fault: type[Exception]) -> Path:
    """Return the file of a name that is shipped in a folder, or of a path. Raises `fault` for any
    other name."""
    if Path(source).is_file() or not str(source).replace("-", "").replace("_", "").isalnum():
        return Path(source)
    if str(source) not in shipped(folder):
        names = shipped(folder)
        choice = f"shipped: {', '.join(names)}; or give a TOML file"
        raise fault(f"{source}: no such {what}; {choice}{did_you_mean(str(source), names)}")
    return folder / f"{source}.toml"


def read(path: Path, fault: type[Exception]) -> dict[str, Any]:
    """Return what a TOML file holds, or one that ends in .json. Raises `fault`, one line, where it
    cannot be read."""
    form, parse = ("JSON", json.loads) if path.suffix == ".json" else ("TOML", tomllib.loads)
    try:
        return parse(
            path.read_bytes().decode("utf-8-sig")
        )  # some editors of Windows begin a text with a mark
    except OSError as error:
        raise fault(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError) as error:
        raise fault(f"{path}: not {form}: {error}") from None
