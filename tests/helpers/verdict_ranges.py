"""The ranges of the shipped verdict sweeps as a table for docs/verdict.md."""

from typing import Any

from sonify.runtime.toml_files import read_toml
from sonify.scene_errors import InputError
from sonify.sweeps.sweep import SHIPPED_SWEEPS_FOLDER, shipped_sweeps


def ranges_table() -> str:
    """Return a Markdown table of all ranges in the shipped verdict sweeps with their
    sources."""
    lines = ["| sweep | quantity | range | scale | source |", "|---|---|---|---|---|"]
    for name in shipped_sweeps():
        document = read_toml(SHIPPED_SWEEPS_FOLDER / f"{name}.toml", InputError)
        sources: dict[str, str] = document.get("sources", {})
        lines += [
            f"| `{name}` | `{key}` | {range_in_words(given)} | {sources[key]} |"
            for key, given in document["axes"].items()
            if key in sources
        ]
    return "\n".join(lines)


def range_in_words(given: Any) -> str:
    """Return the table cells for range and scale of an axis."""
    if isinstance(given, list):
        values = given if len(given) <= 6 else [*given[:2], "...", given[-1]]
        return f"{', '.join(map(str, values))} | list"
    return f"{given['from']} to {given['to']} | {given.get('scale', 'linear')}"
