"""Derive the sliders and lists of the page from a scene, and the scene from their
values."""

from dataclasses import asdict, dataclass
from math import inf
from typing import Any

from sonify.scene import Scene, from_document, load_scene, shipped_scenes
from sonify.scene_errors import SceneError
from sonify.scene_keys import meaning_and_unit, schema
from sonify.studio.run_names import QUANTITIES

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
    choices: tuple[str, ...] = ()


def controls(scene: Scene) -> list[dict[str, Any]]:
    """Return the controls of a scene as plain values."""
    numbers = [
        _number_control(scene, key)
        for key in (*MAIN_KEYS, *FURTHER_KEYS)
        if key not in _other_rolling_friction(scene)
    ]
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
    for key in (*MAIN_KEYS, *FURTHER_KEYS, *CHOICE_KEYS):
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


def _scale_friction(friction, value):
    """Set the coefficient of static friction; that of sliding keeps its ratio to it."""
    before = friction.get("mu_static")
    if isinstance(value, int | float) and before and "mu_dynamic" in friction:
        friction["mu_dynamic"] *= value / before
    friction["mu_static"] = value


def _other_rolling_friction(scene):
    """Return the key of the rolling friction that a scene does not use."""
    uses_arm = scene.friction.arm_rolling > 0
    return ("dissipation.contour_moment",) if uses_arm else ("friction.arm_rolling",)


def _number_control(scene, key):
    """Return the slider of a key, from zero or the lower limit to the upper one, or around
    the value if the limits are far away."""
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
    optional = section in ("roughness", "dissipation")
    if optional and not value:
        value = None  # it has no effect
    middle = value or _typical_value(scene, key)
    logarithmic = middle > 0 and largest > 100.0 * middle
    ratio = 20.0 if "rolling" in QUANTITIES[key].label else 4.0
    low, high = (middle / ratio, middle * ratio) if logarithmic else (smallest, largest)
    if middle < 0:
        low, high = ratio * middle, middle / ratio
    quantity = QUANTITIES[key]
    return Control(
        key=key,
        label=quantity.label,
        meaning=meaning,
        unit=quantity.unit,
        factor=quantity.factor,
        is_main=key in MAIN_KEYS,
        value=value,
        low=_accepted_end(scene, key, middle, max(low, smallest), logarithmic),
        high=_accepted_end(scene, key, middle, min(high, largest), logarithmic),
        logarithmic=logarithmic,
        optional=optional,
    )


SPIN_MEANING = "Angular velocity about the axis of the disk at release."


def _typical_value(scene, key):
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
    return Control(
        key=key,
        label=CHOICE_LABELS[key],
        meaning=meaning,
        unit="",
        is_main=key != "air.film",
        value=value,
        choices=tuple(names),
    )


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
