"""Derive the sliders and lists of the page from a scene, and the scene from their
values."""

from dataclasses import asdict, dataclass
from typing import Any

from sonify.scene import Scene, from_document, load_scene, shipped_scenes
from sonify.scene_errors import SceneError
from sonify.scene_keys import meaning_and_unit, schema

NUMBER_KEYS = (
    "disk.radius",
    "disk.thickness",
    "release.inclination_deg",
    "roughness.rms",
    "audio.distance",
    "audio.elevation_deg",
)
CHOICE_KEYS = ("material.name", "surface", "air.film")
KEEP_SCENE_VALUE = ""
"""Choice that keeps the value of the scene."""


@dataclass(frozen=True, kw_only=True)
class Control:
    """One slider or list of the page.

    `low` and `high` are the ends of the slider. The scene, otherwise unchanged, accepts
    both; any number can be typed next to the slider.
    """

    key: str
    meaning: str
    unit: str
    value: Any
    low: float | None = None
    high: float | None = None
    logarithmic: bool = False
    optional: bool = False
    choices: tuple[str, ...] = ()


def controls(scene: Scene) -> list[dict[str, Any]]:
    """Return the controls of a scene as plain values."""
    numbers = [_number_control(scene, key) for key in NUMBER_KEYS]
    choices = [_choice_control(scene, key) for key in CHOICE_KEYS]
    return [asdict(control) for control in numbers + choices]


def changed_scene(name: str, values: dict[str, Any]) -> Scene:
    """Return a shipped scene at draft accuracy with the values of the changed controls.

    Raises SceneError with the same message as the command line if a name or value is
    invalid.
    """
    document = _shipped_scene(name, "scene").document
    for key, value in values.items():
        _apply_control_value(document, key, value)
    return from_document(document).replace("numerics.accuracy=draft")


def _shipped_scene(name, key):
    """Return a shipped scene; raises SceneError for any other name."""
    names = shipped_scenes()
    if name not in names:
        raise SceneError(f"{key} = {name!r}: must be one of {', '.join(names)}")
    return load_scene(name)


def control_key_of_error(sentence: str) -> str:
    """Return the key of the control named at the start of an error message, or "" if
    there is none."""
    named = sentence.split(maxsplit=1)[0].rstrip(":") if sentence else ""
    for key in (*NUMBER_KEYS, *CHOICE_KEYS):
        if named == key or named.startswith(f"{key}."):
            return key
    return ""


def _apply_control_value(document, key, value):
    """Set the value of one control in the document of a scene."""
    if key == "surface" and value != KEEP_SCENE_VALUE:
        document["surface"] = _shipped_scene(value, "surface").document["surface"]
    elif key == "material.name" and value != KEEP_SCENE_VALUE:
        document["material"] = {"name": value}
        document["disk"].pop("mass", None)  # the density of the material applies
        document["disk"].pop("density", None)
    elif key == "roughness.rms" and value is None:
        document.pop("roughness", None)
    elif value != KEEP_SCENE_VALUE:
        section, _, name = key.rpartition(".")
        inner = document.setdefault(section, {}) if section else document
        inner[name] = value


def _number_control(scene, key):
    section, _, name = key.partition(".")
    given = asdict(scene)[section]
    value = None if given is None else given[name]
    described = _schema_of(key)
    smallest = described.get("minimum", described.get("exclusiveMinimum", 0.0))
    largest = described.get("maximum", described.get("exclusiveMaximum"))
    typical_roughness = 1e-7  # m
    middle = typical_roughness if value is None else value
    logarithmic = largest > 100.0 * middle or section == "roughness"
    low, high = (middle / 4.0, middle * 4.0) if logarithmic else (smallest, largest)
    meaning, unit = meaning_and_unit(described["description"])
    return Control(
        key=key,
        meaning=meaning,
        unit=unit,
        value=value,
        low=_accepted_end(scene, key, middle, max(low, smallest), logarithmic),
        high=_accepted_end(scene, key, middle, min(high, largest), logarithmic),
        logarithmic=logarithmic,
        optional=section == "roughness",
    )


def _accepted_end(scene, key, accepted, end, logarithmic):
    """Return the end of a slider or, if a run with this value is refused, the last
    value before it that is accepted, to a thousandth of the slider."""
    refused = _rounded(end)
    if _is_accepted(scene, key, refused):
        return refused
    step_count = 10  # halvings
    for _ in range(step_count):
        middle = (
            (accepted * refused) ** 0.5 if logarithmic else (accepted + refused) / 2
        )
        middle = _rounded(middle)
        if _is_accepted(scene, key, middle):
            accepted = middle
        else:
            refused = middle
    return accepted


def _rounded(value):
    """Return a value with the four significant digits that the page shows."""
    return float(f"{value:.4g}")


def _is_accepted(scene, key, value):
    """Return True if a run starts with one changed value of a scene."""
    from sonify.plan.preflight import check_solvable_scene  # slow to import

    document = scene.document
    _apply_control_value(document, key, value)
    try:
        check_solvable_scene(from_document(document), None)
    except SceneError:
        return False
    return True


def _choice_control(scene, key):
    if key == "surface":
        meaning = "Table under the disk, optionally that of another scene."
        names = ["published"]
        names += [n for n in shipped_scenes() if load_scene(n).surface.kind != "rigid"]
    else:
        described = _schema_of(key)
        meaning, _ = meaning_and_unit(described["description"])
        names = described["enum"]
    if key == "air.film":
        value = scene.air.film
    else:
        value = KEEP_SCENE_VALUE
        names = [KEEP_SCENE_VALUE, *names]
    return Control(key=key, meaning=meaning, unit="", value=value, choices=tuple(names))


def _schema_of(key):
    """Return the JSON schema of a key without the option null."""
    whole = schema()
    described = whole
    for step in key.split("."):
        entry = described["properties"][step]
        options = [o for o in entry.get("anyOf", [entry]) if o.get("type") != "null"]
        option = options[0]
        inner = option.get("$ref")
        described = (
            whole["$defs"][inner.rpartition("/")[2]] if inner else entry | option
        )
    return described
