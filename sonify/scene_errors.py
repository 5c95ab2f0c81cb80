"""One-line messages for the validation errors of a scene."""

from copy import deepcopy
from dataclasses import fields, is_dataclass
from difflib import get_close_matches
from types import UnionType
from typing import TYPE_CHECKING, Annotated, Any, Union, get_args, get_origin

from sonify.suggestions import did_you_mean, did_you_mean_question

if TYPE_CHECKING:
    from pydantic import ValidationError

UNKNOWN_KEY_ERRORS = {"unexpected_keyword_argument", "extra_forbidden"}
ERROR_SENTENCES = {
    "missing": "missing",
    "value_error": "{error}",
    "dataclass_type": "must be a section, with keys of its own",
    "dict_type": "must be a section, with keys of its own",
    "union_tag_not_found": "missing",
    "union_tag_invalid": "must be one of {expected_tags}",
    "tuple_type": "must be a list such as [1.0, 2.0]",
    "too_long": "must have at most {max_length} values",
    "too_short": "must have at least {min_length} values",
    "float_type": "must be a valid number",
    "int_type": "must be a whole number",
    "bool_type": "must be true or false",
    "bool_parsing": "must be true or false",
    "string_type": "must be text in quotes",
    "string_pattern_mismatch": "must consist of letters, digits, '.', '_' and '-', and begin with "
    "a letter or a digit",
    "literal_error": "must be {expected}",
    "greater_than": "must be greater than {gt:g}",
    "greater_than_equal": "must be greater than or equal to {ge:g}",
    "less_than": "must be less than {lt:g}",
    "less_than_equal": "must be less than or equal to {le:g}",
}
"""Message for each type of pydantic error in a scene; complete, as
tests/plan/test_scene.py checks."""


class InputError(ValueError):
    """Invalid user input; the message is one line.

    Examples
    --------
    >>> from sonify.scene_errors import InputError
    >>> issubclass(InputError, ValueError)
    True
    """


class SceneError(InputError):
    """Invalid scene.

    The message is one line with the key, its value and the allowed values.

    Examples
    --------
    >>> from sonify import load_scene
    >>> load_scene("published").replace("disk.radius=-1")
    Traceback (most recent call last):
    sonify.scene_errors.SceneError: disk.radius = -1: must be greater than 0
    """


class ContradictionError(SceneError):
    """Two keys of a scene contradict each other, although each value is allowed."""


def is_contradiction(error: "ValidationError") -> bool:
    """Return True if all faults of a pydantic ValidationError are contradictions
    between values."""
    return all(
        fault["type"] == "value_error" for fault in error.errors(include_url=False)
    )


def with_whole_numbers(
    document: dict[str, Any], error: "ValidationError", schema: type
) -> dict[str, Any] | None:
    """Return a copy of a document with floats such as 44.1e3 as integers where keys
    require them.

    `error` is the ValidationError of the document. Returns None if no value changes.
    """
    exact = 2.0**53  # floats do not represent all larger integers
    given = deepcopy(document)
    changed = False
    for fault in error.errors(include_url=False):
        value = fault["input"]
        whole = isinstance(value, float) and value.is_integer() and abs(value) <= exact
        if fault["type"] == "int_type" and whole:
            *sections, key = _key_at_location(schema, fault["loc"])[0]
            section: Any = given
            for step in sections:
                section = section[step]
            section[key] = int(value)
            changed = True
    return given if changed else None


def error_sentence(error: "ValidationError", schema: type) -> str:
    """Return a one-line message on the first fault of a pydantic ValidationError.

    Unknown keys come first, because they may have caused the other faults.
    """
    faults = sorted(
        error.errors(include_url=False),
        key=lambda fault: fault["type"] not in UNKNOWN_KEY_ERRORS,
    )
    fault = faults[0]
    context = fault.get("ctx", {})
    steps, sections = _key_at_location(schema, fault["loc"])
    value = fault["input"]
    if "discriminator" in context:
        steps = [*steps, context["discriminator"].strip("'")]
        value = context.get("tag")
    path = ".".join(map(str, steps))
    if fault["type"] in UNKNOWN_KEY_ERRORS:
        siblings = [f.name for f in fields(section_types(sections[-2])[0])]
        known = ", ".join(siblings)
        return (
            f"{path}: unknown key; known: {known}{_meant_key(path, siblings, schema)}"
        )
    alternatives = [
        ERROR_SENTENCES.get(other["type"], other["msg"]).format(**other.get("ctx", {}))
        for other in faults
        if _key_at_location(schema, other["loc"])[0] == steps or other is fault
    ]
    sentence = ", or ".join(dict.fromkeys(alternatives)).replace(", or must be", ", or")
    if fault["type"] in {"missing", "value_error", "union_tag_not_found"}:
        return f"{path}: {sentence}".removeprefix(": ")
    return f"{path} = {value!r}: {sentence}"


def _meant_key(path: str, siblings: list[str], schema: type[Any]) -> str:
    """Return a question that suggests a key of the same name in another section, or a
    similar key."""
    keys = key_paths(schema)
    section, _, name = path.rpartition(".")
    if path in keys:  # valid in a section of another kind
        return ""
    if namesakes := [key for key in keys if key.rpartition(".")[2] == name]:
        return did_you_mean_question(namesakes[:3])
    own = [f"{section}.{sibling}" if section else sibling for sibling in siblings]
    return (
        did_you_mean(path, own) or did_you_mean(path, keys) or _meant_name(name, keys)
    )


def _meant_name(name: str, keys: list[str]) -> str:
    """Return a question that suggests a key with a similar last word in any section."""
    by_name = {key.rpartition(".")[2]: key for key in reversed(keys)}
    closest = get_close_matches(name, by_name, n=1)
    return did_you_mean_question([by_name[found] for found in closest])


def key_paths(schema: type) -> list[str]:
    """Return the dotted path of every key of a scene; a list of sections counts as one
    key."""
    paths = []
    for key in fields(schema):
        kind = get_args(key.type)[0] if get_origin(key.type) is Annotated else key.type
        options = [] if get_origin(kind) is tuple else section_types(kind)
        for option in options:
            paths += [f"{key.name}.{path}" for path in key_paths(option)]
        if not options:
            paths.append(key.name)
    return list(dict.fromkeys(paths))


def _key_at_location(
    schema: type[Any], location: tuple[int | str, ...]
) -> tuple[list[int | str], list[Any]]:
    """Return the steps of an error location without union tags, and the type at each
    step."""
    steps: list[int | str] = []
    kinds: list[Any] = [schema]
    for step in location:
        options = section_types(kinds[-1])
        if len(options) > 1:  # the step is the tag
            kinds[-1] = next(
                (
                    o
                    for o in options
                    if step in get_args(o.__dataclass_fields__["kind"].type)
                ),
                kinds[-1],
            )
            continue
        if (
            not options and get_origin(kinds[-1]) is Union
        ):  # the step is the tag of a number or word
            continue
        inner: dict[int | str, Any] = (
            {f.name: f.type for f in fields(options[0])} if options else {}
        )
        steps.append(step)
        kinds.append(inner.get(step, kinds[-1]))
    return steps, kinds


def section_types(kind: Any) -> list[Any]:
    """Return the dataclasses of `Section | None`, `Annotated[A | B, ...]` or
    `list[Section]`."""
    if get_origin(kind) is Annotated:
        return section_types(get_args(kind)[0])
    inside = get_args(kind) if get_origin(kind) in (UnionType, list, tuple) else (kind,)
    return [option for option in inside if is_dataclass(option)]
