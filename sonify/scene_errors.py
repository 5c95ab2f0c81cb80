"""What is wrong with a scene, said in one line."""

from dataclasses import fields, is_dataclass
from types import UnionType
from typing import get_args, get_origin

UNKNOWN = {"unexpected_keyword_argument", "extra_forbidden"}
SENTENCES = {
    "missing": "missing",
    "value_error": "{error}",
    "dataclass_type": "must be a section, with keys of its own",
    "tuple_type": "must be a list, as [1.0, 2.0]",
    "too_long": "must have at most {max_length} values",
    "float_type": "must be a valid number",
    "int_type": "must be a whole number",
    "string_type": "must be text in quotes",
    "string_pattern_mismatch": "must be made of letters, digits, '.', '_' and '-', and begin with a letter or a digit",
    "literal_error": "must be {expected}",
    "greater_than": "must be greater than {gt:g}",
    "greater_than_equal": "must be greater than or equal to {ge:g}",
    "less_than": "must be less than {lt:g}",
    "less_than_equal": "must be less than or equal to {le:g}",
}
"""What is said of each kind of fault that pydantic finds in a scene; tests/test_scene.py seeks all that there are."""


class InputError(ValueError):
    """What the user gave is wrong; the message is one line."""


class SceneError(InputError):
    """The scene is wrong; the message is one line naming the key, its value and what is allowed."""


def explain(error, schema: type) -> str:
    """Return one line on the first fault of a pydantic ValidationError; an unknown key comes before what it caused."""
    faults = sorted(error.errors(include_url=False), key=lambda fault: fault["type"] not in UNKNOWN)
    fault = faults[0]
    path = ".".join(map(str, fault["loc"]))
    if fault["type"] in UNKNOWN:
        return f"{path}: unknown key; known: {', '.join(_known_keys(schema, fault['loc'][:-1]))}"
    sentence = SENTENCES.get(fault["type"], fault["msg"]).format(**fault.get("ctx", {}))
    if fault["type"] in {"missing", "value_error"}:
        return f"{path}: {sentence}".removeprefix(": ")
    return f"{path} = {fault['input']!r}: {sentence}"


def _known_keys(schema, path):
    for step in path:
        kinds = {f.name: f.type for f in fields(schema)} if is_dataclass(schema) else {}
        schema = _section(kinds.get(step, schema))
    return [f.name for f in fields(schema)]


def _section(kind):
    """The dataclass in `Section | None` or `list[Section]`."""
    options = get_args(kind) if get_origin(kind) in (UnionType, list, tuple) else (kind,)
    return next((option for option in options if is_dataclass(option)), kind)
