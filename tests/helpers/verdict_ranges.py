"""The ranges of the shipped verdict sweeps as a table for docs/verdict.md."""

from typing import NamedTuple

from article_numbers import with_powers
from article_tables import range_in_words

from sonify.runtime.markdown import markdown_table
from sonify.runtime.toml_files import read_toml
from sonify.scene_errors import InputError
from sonify.scene_keys import keys
from sonify.sweeps.sweep import SHIPPED_SWEEPS_FOLDER, shipped_sweeps


class Range(NamedTuple):
    """Keys of an axis, its range in words, and the source of the range."""

    keys: str
    words: str
    source: str


def verdict_ranges() -> dict[Range, list[str]]:
    """Return the names of the sweeps that use each range."""
    sweeps: dict[Range, list[str]] = {}
    for name in shipped_sweeps():
        document = read_toml(SHIPPED_SWEEPS_FOLDER / f"{name}.toml", InputError)
        for key, source in document.get("sources", {}).items():
            given = Range(key, range_in_words(document["axes"][key]), source)
            sweeps.setdefault(given, []).append(name)
    return sweeps


def ranges_table() -> str:
    """Return a Markdown table of all ranges in the shipped verdict sweeps."""
    units = {key.name: key.unit for key in keys()}
    rows = [["quantity", "range", "source", "sweeps"]]
    for given, names in sorted(verdict_ranges().items()):
        first = given.keys.split(", ")[0]
        unit = units.get(first) or units[first.rpartition(".")[0]]
        values, *log = given.words.split(", log")
        words = with_powers(values) + ("" if unit == "-" else f" {unit}")
        words += ", log" * bool(log)
        users = ", ".join(name.removeprefix("verdict-") for name in names)
        rows.append([f"`{given.keys}`", words, given.source, users])
    return markdown_table(rows)
