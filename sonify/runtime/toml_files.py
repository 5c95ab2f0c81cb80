"""Read shipped or user TOML and JSON files as plain values."""

import json
import tomllib
from pathlib import Path
from typing import Any

from sonify.suggestions import did_you_mean


def shipped_names(folder: Path) -> list[str]:
    """Return the names of the TOML files in a folder, without their suffix."""
    return sorted(file.stem for file in folder.glob("*.toml"))


def find_file(
    source: str | Path, folder: Path, what: str, fault: type[Exception]
) -> Path:
    """Return the path of the shipped file named `source`, or `source` itself if it is a
    path.

    Raises `fault` with a message about `what`, the kind of file, for an unknown name.
    """
    if (
        Path(source).is_file()
        or not str(source).replace("-", "").replace("_", "").isalnum()
    ):
        return Path(source)
    names = shipped_names(folder)
    if str(source) not in names:
        choice = f"give a TOML file or one of: {', '.join(names)}"
        raise fault(
            f"{source}: no such {what}; {choice}{did_you_mean(str(source), names)}"
        )
    return folder / f"{source}.toml"


def read_toml(path: Path, fault: type[Exception]) -> dict[str, Any]:
    """Parse a TOML file, or a JSON file if its suffix is .json.

    Raises `fault` with a one-line message if the file cannot be read.
    """
    form, parse = (
        ("JSON", json.loads) if path.suffix == ".json" else ("TOML", tomllib.loads)
    )
    try:
        return parse(
            path.read_bytes().decode("utf-8-sig")
        )  # some Windows editors write a byte-order mark
    except OSError as error:
        raise fault(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise fault(f"{path}: invalid {form}: not a text file") from None
    except (ValueError, RecursionError) as error:
        raise fault(f"{path}: invalid {form}: {error}") from None
