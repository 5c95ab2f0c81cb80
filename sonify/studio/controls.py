"""Derive the sliders and lists of the page from a scene, and the scene from their
values."""

import json
from dataclasses import asdict, dataclass, field
from functools import cache
from importlib import resources
from math import inf
from typing import Any

from sonify.report.run_names import QUANTITIES
from sonify.scene import (
    Scene,
    from_document,
    load_scene,
    present_scene_name,
    shipped_scenes,
)
from sonify.scene_errors import SceneError
from sonify.scene_keys import meaning_and_unit, schema

MAIN_KEYS = (
    "release.inclination_deg",
    "release.omega",
    "friction.mu_static",
    "friction.arm_rolling",
    "dissipation.contour_moment",
    "roughness.rms",
    "roughness.rms_edge",
)
FURTHER_KEYS = (
    "disk.radius",
    "disk.thickness",
    "audio.distance",
    "audio.elevation_deg",
)
CHOICE_LABELS = {
    "material.name": "material",
    "surface": "table",
    "air.film": "air film",
}
CHOICE_KEYS = (*CHOICE_LABELS,)
SLIDER_ENDS = "slider_ends.json"
"""File with the ends of the sliders of the shipped scenes, because it takes seconds to
find them; `python -m sonify.studio.slider_ends` renews it."""
SMOOTH_TABLE = 1e-9
"""Roughness of a smooth table [m], for a scene in which only the edge becomes rough."""
KEEP_SCENE_VALUE = ""
"""Choice that keeps the value of the scene."""


@dataclass(frozen=True, kw_only=True)
class Control:
    """One slider or list of the page.

    `low` and `high` are the ends of the slider. The scene, otherwise unchanged, accepts
    both; any number can be typed next to the slider. Values are in SI units; the page
    multiplies them by `factor` to display them in `unit`.
    """

    key: str
    label: str
    meaning: str
    unit: str
    factor: float = 1.0
    is_main: bool = True
    value: Any
    low: float | None = None
    high: float | None = None
    logarithmic: bool = False
    optional: bool = False
    choices: dict[str, str] = field(default_factory=dict)


def controls(scene: Scene) -> list[dict[str, Any]]:
    """Return the controls of a shipped scene as plain values."""
    numbers = [_number_control(scene, key) for key in slider_keys(scene)]
    choices = [_choice_control(scene, key) for key in CHOICE_KEYS]
    return [asdict(control) for control in numbers + choices]


def slider_keys(scene: Scene) -> list[str]:
    """Return the keys of a scene that have a slider."""
    unused = _other_rolling_friction(scene)
    return [key for key in (*MAIN_KEYS, *FURTHER_KEYS) if key not in unused]


def changed_scene(name: str, values: dict[str, Any]) -> Scene:
    """Return a shipped scene at draft accuracy with the values of the changed controls.

    Raises SceneError with the same message as the command line if a name or value is
    invalid.
    """
    document = _shipped_scene(name, "scene").document
    for key, value in values.items():
        apply_control_value(document, key, value)
    return from_document(document).replace("numerics.accuracy=draft")


def _shipped_scene(name: str, key: str) -> Scene:
    """Return a shipped scene; raises SceneError for any other name."""
    names = shipped_scenes()
    if present_scene_name(name) not in names:
        raise SceneError(f"{key} = {name!r}: must be one of {', '.join(names)}")
    return load_scene(name)


def control_key_of_error(sentence: str) -> str:
    """Return the key of the control named at the start of an error message, or "" if
    there is none."""
    named = sentence.split(maxsplit=1)[0].rstrip(":") if sentence else ""
    for key in (*MAIN_KEYS, *FURTHER_KEYS, *CHOICE_KEYS):
        if named == key or named.startswith(f"{key}."):
            return key
    return ""


def apply_control_value(document: dict[str, Any], key: str, value: Any) -> None:
    """Set the value of one control in the document of a scene."""
    if key == "surface" and value != KEEP_SCENE_VALUE:
        other = _shipped_scene(value, "surface").document
        document["surface"] = other["surface"]
        _use_elasticity_of_table(document, other)
    elif key == "material.name" and value != KEEP_SCENE_VALUE:
        document["material"] = {"name": value}
        document["disk"].pop("mass", None)  # the density of the material applies
        document["disk"].pop("density", None)
    elif key == "release.omega":
        released = document["release"]
        released["omega"] = [*released["omega"][:2], value]
    elif key == "friction.mu_static":
        _scale_friction(document["friction"], value)
    elif key == "roughness.rms" and value is None:
        document.pop("roughness", None)
    elif key == "roughness.rms_edge" and document.get("roughness") is None:
        document["roughness"] = {"rms": SMOOTH_TABLE, "rms_edge": value}
    elif value is None:
        section, _, name = key.rpartition(".")
        document.get(section, {}).pop(name, None)
    elif value != KEEP_SCENE_VALUE:
        section, _, name = key.rpartition(".")
        inner = document.setdefault(section, {}) if section else document
        inner[name] = value


def _use_elasticity_of_table(document: dict[str, Any], other: dict[str, Any]) -> None:
    """Set the elastic constants of the table at the contact to those of another scene, if
    both contacts are elastic."""
    contact, elastic = document.get("contact", {}), other.get("contact", {})
    if "young" in contact and "young" in elastic:
        contact |= {name: elastic[name] for name in ("young", "poisson")}


def _scale_friction(friction: dict[str, Any], value: float) -> None:
    """Set the coefficient of static friction; that of sliding keeps its ratio to it."""
    before = friction.get("mu_static")
    if isinstance(value, int | float) and before and "mu_dynamic" in friction:
        friction["mu_dynamic"] *= value / before
    friction["mu_static"] = value


def _other_rolling_friction(scene: Scene) -> tuple[str]:
    """Return the key of the rolling friction that a scene does not use."""
    uses_arm = scene.friction.arm_rolling > 0
    return ("dissipation.contour_moment",) if uses_arm else ("friction.arm_rolling",)


@dataclass(frozen=True, kw_only=True)
class SliderRange:
    """Value of a key in a scene and the range around it, in SI units.

    `value` is None if it has no effect; `middle` is then a typical value."""

    meaning: str
    value: float | None
    middle: float
    low: float
    high: float
    logarithmic: bool


def slider_range(scene: Scene, key: str) -> SliderRange:
    """Return the range of a slider, from zero or the lower limit to the upper one, or
    around the value if the limits are far away."""
    section, _, name = key.partition(".")
    given = asdict(scene)[section]
    value = None if given is None else given[name]
    if key == "release.omega":
        meaning, smallest, largest = SPIN_MEANING, -inf, inf
        value = scene.release.omega[2]
    else:
        described = _schema_of(key)
        smallest = described.get("minimum", described.get("exclusiveMinimum", 0.0))
        largest = described.get("maximum", described.get("exclusiveMaximum", inf))
        meaning, _ = meaning_and_unit(described["description"])
    if section in OPTIONAL_SECTIONS and not value:
        value = None  # it has no effect
    middle = value or _typical_value(scene, key)
    logarithmic = middle > 0 and largest > 100.0 * middle
    ratio = 20.0 if "rolling" in QUANTITIES[key].label else 4.0
    low, high = (middle / ratio, middle * ratio) if logarithmic else (smallest, largest)
    if middle < 0:
        low, high = ratio * middle, middle / ratio
    return SliderRange(
        meaning=meaning,
        value=value,
        middle=middle,
        low=max(low, smallest),
        high=min(high, largest),
        logarithmic=logarithmic,
    )


def _number_control(scene: Scene, key: str) -> Control:
    """Return the slider of a key of a shipped scene."""
    found = slider_range(scene, key)
    quantity = QUANTITIES[key]
    low, high = _slider_ends()[scene.name][key]
    return Control(
        key=key,
        label=quantity.label,
        meaning=found.meaning,
        unit=quantity.unit,
        factor=quantity.factor,
        is_main=key in MAIN_KEYS,
        value=found.value,
        low=low,
        high=high,
        logarithmic=found.logarithmic,
        optional=key.partition(".")[0] in OPTIONAL_SECTIONS,
    )


@cache
def _slider_ends() -> dict[str, dict[str, tuple[float, float]]]:
    """Return the ends of the sliders by scene and key."""
    file = resources.files("sonify.studio") / SLIDER_ENDS
    return json.loads(file.read_text("utf-8"))


OPTIONAL_SECTIONS = ("roughness", "dissipation")
SPIN_MEANING = "Angular velocity about the axis of the disk at release."


def _typical_value(scene: Scene, key: str) -> float:
    """Return a value in the middle of the slider of a key that a scene does not use."""
    disk = scene.disk
    relative_rolling_friction = 1e-4  # of weight times radius
    return {
        "dissipation.contour_moment": relative_rolling_friction
        * disk.weight
        * disk.radius,
        "roughness.rms": 1e-7,
        "roughness.rms_edge": 1e-7,
    }.get(key, 0.0)


def _choice_control(scene: Scene, key: str) -> Control:
    if key == "surface":
        meaning = (
            "Table under the disk with its elastic constants, optionally those of another "
            "scene; friction and roughness remain."
        )
        choices = table_choices()
    else:
        described = _schema_of(key)
        meaning, _ = meaning_and_unit(described["description"])
        choices = {name: name for name in described["enum"]}
    if key == "air.film":
        value: str = scene.air.film
    else:
        value = KEEP_SCENE_VALUE
        choices = {KEEP_SCENE_VALUE: "as in the scene"} | choices
    return Control(
        key=key,
        label=CHOICE_LABELS[key],
        meaning=meaning,
        unit="",
        is_main=key != "air.film",
        value=value,
        choices=choices,
    )


@cache
def table_choices() -> dict[str, str]:
    """Return the tables of the shipped scenes in words, by the name of the scene."""
    words = {"published": "rigid"}
    for name in shipped_scenes():
        surface = load_scene(name).surface
        if surface.kind == "rigid":
            continue
        words[name] = f"that of {name}"
        if surface.kind == "plate":
            words[name] += f", {1e3 * surface.thickness:.3g} mm"
        if surface.action == "sound":
            words[name] += ", sounds without moving the disk"
    return words


def _schema_of(key: str) -> dict[str, Any]:
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
