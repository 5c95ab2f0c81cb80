"""What is wrong with a scene, said in one line."""

from dataclasses import fields, is_dataclass
from types import UnionType
from typing import get_args, get_origin

UNKNOWN = {"unexpected_keyword_argument", "extra_forbidden"}


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
    if fault["type"] == "missing":
        return f"{path}: missing"
    if fault["type"] == "value_error":
        return f"{path}: {fault['ctx']['error']}".removeprefix(": ")
    return f"{path} = {fault['input']!r}: {_allowed(fault['msg'])}"


def _allowed(message):
    return message.replace("Input should be", "must be")


def _known_keys(schema, path):
    for step in path:
        kinds = {f.name: f.type for f in fields(schema)} if is_dataclass(schema) else {}
        schema = _section(kinds.get(step, schema))
    return [f.name for f in fields(schema)]


def _section(kind):
    """The dataclass in `Section | None` or `list[Section]`."""
    options = get_args(kind) if get_origin(kind) in (UnionType, list, tuple) else (kind,)
    return next((option for option in options if is_dataclass(option)), kind)
