"""Unit, range, default and meaning of every key of a scene."""

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from textwrap import wrap
from typing import Any, NamedTuple

from pydantic import ConfigDict, TypeAdapter

from sonify.scene import Scene

BOUND_SYMBOLS = {
    "exclusiveMinimum": ">",
    "minimum": ">=",
    "exclusiveMaximum": "<",
    "maximum": "<=",
}
TYPE_NAMES = {
    "number": "number",
    "integer": "whole number",
    "string": "text",
    "boolean": "true, false",
}


class SceneKey(NamedTuple):
    """Description of one key of a scene file."""

    name: str
    unit: str
    range: str
    default: str
    meaning: str


@dataclass(frozen=True, kw_only=True)
class DocumentedScene(Scene):  # its schema contains the docstrings of the keys
    __doc__ = Scene.__doc__
    __pydantic_config__ = ConfigDict(
        **Scene.__pydantic_config__,
        title="Scene",
        use_attribute_docstrings=True,  # slow, and not needed to validate a scene
    )


@cache
def schema() -> dict[str, Any]:
    """Return the JSON schema of a scene, which editors use to complete and check scene
    files."""
    dialect = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    whole = dialect | TypeAdapter(DocumentedScene).json_schema()
    for section in (whole, *whole["$defs"].values()):
        section["additionalProperties"] = False
    return whole


def keys() -> list[SceneKey]:
    """Return every key of a scene, section by section."""
    whole = schema()
    return list(_keys(whole, whole["$defs"], ""))


def as_json() -> str:
    """Return the schema as JSON text."""
    return json.dumps(schema(), indent=1)


def as_table() -> str:
    """Return the keys as a text table with a header and one line per key."""
    rows = [SceneKey._fields, *keys()]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)


def as_lines(width: int) -> str:
    """Return the keys in lines of at most `width` characters, each followed by its
    meaning."""
    lines = []
    for key in keys():
        unit = "" if key.unit == "-" else f" [{key.unit}]"
        default = {"required": "; required", "-": ""}.get(
            key.default, f"; default {key.default}"
        )
        lines += wrap(
            f"{key.name}{unit}  {key.range}{default}", width, subsequent_indent=8 * " "
        )
        lines += wrap(
            key.meaning, width, initial_indent=4 * " ", subsequent_indent=4 * " "
        )
    return "\n".join(lines)


def _keys(section: Any, sections: dict[str, Any], path: str) -> Iterator[SceneKey]:
    for name, key in section["properties"].items():
        options = [
            option
            for option in key.get("anyOf") or key.get("oneOf", [key])
            if option.get("type") != "null"
        ]
        inner = [
            sections[option["$ref"].rpartition("/")[2]]
            for option in options
            if "$ref" in option
        ]
        if inner:
            yield from _keys_by_section_kind(
                [list(_keys(own, sections, f"{path}{name}.")) for own in inner]
            )
        else:
            meaning, unit = meaning_and_unit(key["description"])
            span = " or ".join(map(_range, options))
            default = _default(name, key, section)
            yield SceneKey(f"{path}{name}", unit or "-", span, default, meaning)


def _keys_by_section_kind(sections: list[list[SceneKey]]) -> list[SceneKey]:
    """Return each key of all kinds of a section once, with the kinds that contain
    it."""
    if len(sections) == 1:
        return sections[0]
    kinds = [kind.range for kind, *_ in sections]
    holders = {
        key: [kind for kind, own in zip(kinds, sections, strict=True) if key in own]
        for own in sections
        for key in own[1:]
    }
    kind = sections[0][0]._replace(range=", ".join(kinds), default="required")
    return [
        kind,
        *(
            key._replace(meaning=f"{key.meaning[:-1]} ({', '.join(of)}).")
            for key, of in holders.items()
        ),
    ]


def meaning_and_unit(description: str) -> tuple[str, str]:
    """Split a description into its meaning and its bracketed unit, or "" without a
    unit."""
    meaning = " ".join(description.split())
    unit = re.search(r" \[([^]]*)\]", meaning)
    return (meaning.replace(unit[0], "", 1), unit[1]) if unit else (meaning, "")


def _range(key: dict[str, Any]) -> str:
    """Return a description of the allowed values of a JSON schema type."""
    if "enum" in key or "const" in key:
        return ", ".join(map(str, key.get("enum", [key.get("const")])))
    if "$ref" in key:
        return "sections"
    if key["type"] == "array":
        parts = key.get("prefixItems") or [key["items"]]
        most = key.get("maxItems")
        length = (
            len(parts)
            if "prefixItems" in key
            else f"at most {most}"
            if most
            else "any length"
        )
        return f"list of {length}: {_range(parts[0])}"
    bounds = [
        f"{sign} {key[name]:g}" for name, sign in BOUND_SYMBOLS.items() if name in key
    ]
    return ", ".join(bounds) or TYPE_NAMES[key["type"]]


def _default(name: str, key: dict[str, Any], section: dict[str, Any]) -> str:
    if name in section.get("required", ()):
        return "required"
    default = key.get("default")
    if default is None:
        return "-"
    return default if isinstance(default, str) else json.dumps(default)
