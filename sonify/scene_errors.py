"""What is wrong with a scene, said in one line."""

from dataclasses import fields, is_dataclass
from types import UnionType
from typing import Annotated, get_args, get_origin

UNKNOWN = {"unexpected_keyword_argument", "extra_forbidden"}
SENTENCES = {
    "missing": "missing",
    "value_error": "{error}",
    "dataclass_type": "must be a section, with keys of its own",
    "dict_type": "must be a section, with keys of its own",
    "union_tag_not_found": "missing",
    "union_tag_invalid": "must be one of {expected_tags}",
    "tuple_type": "must be a list, as [1.0, 2.0]",
    "too_long": "must have at most {max_length} values",
    "too_short": "must have at least {min_length} values",
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
    fault, context = faults[0], faults[0].get("ctx", {})
    steps, sections = _walked(schema, fault["loc"])
    value, kind = fault["input"], "discriminator" in context
    if kind:
        steps, value = [*steps, context["discriminator"].strip("'")], context.get("tag")
    path = ".".join(map(str, steps))
    if fault["type"] in UNKNOWN:
        return f"{path}: unknown key; known: {', '.join(f.name for f in fields(sections_of(sections[-2])[0]))}"
    sentence = SENTENCES.get(fault["type"], fault["msg"]).format(**context)
    if fault["type"] in {"missing", "value_error", "union_tag_not_found"}:
        return f"{path}: {sentence}".removeprefix(": ")
    return f"{path} = {value!r}: {sentence}"


def _walked(schema, location):
    """The steps of a location without the tags of sections of several kinds, and the types that they lead to."""
    steps, kinds = [], [schema]
    for step in location:
        options = sections_of(kinds[-1])
        if len(options) > 1:  # the step is the tag
            kinds[-1] = next((o for o in options if step in get_args(o.__dataclass_fields__["kind"].type)), kinds[-1])
            continue
        inner = {f.name: f.type for f in fields(options[0])} if options else {}
        steps.append(step)
        kinds.append(inner.get(step, kinds[-1]))
    return steps, kinds


def sections_of(kind):
    """The dataclasses in `Section`, `Section | None`, `Annotated[A | B, ...]`, `list[Section]`."""
    if get_origin(kind) is Annotated:
        return sections_of(get_args(kind)[0])
    inside = get_args(kind) if get_origin(kind) in (UnionType, list, tuple) else (kind,)
    return [option for option in inside if is_dataclass(option)]
