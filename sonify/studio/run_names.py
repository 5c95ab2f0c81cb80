"""Name runs in words: a shipped scene and its changed values, "glass, edge rougher"."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from sonify.report.write import scene_record
from sonify.scene import differing_values, load_scene, shipped_scenes


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """Words for a key of a scene: its `label`, and how a run with a larger or a smaller
    value is called. `factor` converts the value to the displayed `unit`."""

    label: str
    larger: str
    smaller: str
    unit: str
    factor: float = 1.0

    def text(self, value: float | None) -> str:
        """Return a value with its unit."""
        if value is None:
            return "none"
        return f"{self.factor * value:.4g} {self.unit}".strip()


QUANTITIES = {
    "release.inclination_deg": Quantity(
        label="inclination at release",
        larger="released steeper",
        smaller="released flatter",
        unit="degrees",
    ),
    "release.omega": Quantity(
        label="spin at release",
        larger="spun faster",
        smaller="spun slower",
        unit="rad/s",
    ),
    "friction.mu_static": Quantity(
        label="friction",
        larger="more friction",
        smaller="less friction",
        unit="",
    ),
    "friction.arm_rolling": Quantity(
        label="rolling friction",
        larger="more rolling friction",
        smaller="less rolling friction",
        unit="µm",
        factor=1e6,
    ),
    "dissipation.contour_moment": Quantity(
        label="rolling friction",
        larger="more rolling friction",
        smaller="less rolling friction",
        unit="µN m",
        factor=1e6,
    ),
    "roughness.rms": Quantity(
        label="roughness of the table",
        larger="table rougher",
        smaller="table smoother",
        unit="µm",
        factor=1e6,
    ),
    "roughness.rms_edge": Quantity(
        label="roughness of the edge",
        larger="edge rougher",
        smaller="edge smoother",
        unit="µm",
        factor=1e6,
    ),
    "disk.radius": Quantity(
        label="radius of the disk",
        larger="disk wider",
        smaller="disk narrower",
        unit="mm",
        factor=1e3,
    ),
    "disk.thickness": Quantity(
        label="thickness of the disk",
        larger="disk thicker",
        smaller="disk thinner",
        unit="mm",
        factor=1e3,
    ),
    "disk.mass": Quantity(
        label="mass of the disk",
        larger="disk heavier",
        smaller="disk lighter",
        unit="kg",
    ),
    "audio.distance": Quantity(
        label="distance of the listener",
        larger="heard from farther away",
        smaller="heard from nearer",
        unit="m",
    ),
    "audio.elevation_deg": Quantity(
        label="elevation of the listener",
        larger="heard from higher",
        smaller="heard from lower",
        unit="degrees",
    ),
}
"""Words for the quantities that the studio changes, by key."""


@dataclass(frozen=True, kw_only=True)
class RunName:
    """Name of a run in words, and its changed values."""

    words: str
    changes: tuple[str, ...] = ()


def run_name(record: Mapping[str, Any]) -> RunName:
    """Return the name of a run from the record of its scene in run.json.

    Changes are relative to the shipped scene of the same name. Keys that one of the two
    records lacks are ignored, because programs of other versions have other keys.
    """
    name = str(record["name"])
    if name not in shipped_scenes():
        return RunName(words=name)
    shipped = _shipped_record(name)
    words: list[str] = []
    changes: list[str] = []
    if _differs(record, shipped, "material", "name") and record["material"]["name"]:
        words.append(f"of {record['material']['name']}")
    if (record.get("surface") or {}) != shipped["surface"]:
        words.append(f"on {table_words(record.get('surface') or {})}")
    if _differs(record, shipped, "air", "film"):
        film = record["air"]["film"]
        words.append("without air film" if film == "none" else f"air film: {film}")
    is_other_material = bool(words) and words[0].startswith("of ")
    differing = differing_values(shipped, dict(record))
    if "friction.mu_static" in differing:
        differing.pop("friction.mu_dynamic", None)  # keeps its ratio
    for key, (before, value) in differing.items():
        section, _, name_in_section = key.partition(".")
        if section in ("name", "numerics", "surface", "material"):
            continue
        if is_other_material and key in ("disk.mass", "disk.density"):
            continue
        if name_in_section not in (record.get(section) or {name_in_section: None}):
            continue
        if (quantity := QUANTITIES.get(key)) is not None:
            before, value = _magnitude(before), _magnitude(value)
            if value is None:
                words.append(f"without {quantity.label}")
            else:
                larger = value > (before or 0.0)
                words.append(quantity.larger if larger else quantity.smaller)
            changes.append(f"{quantity.label} {quantity.text(value)}")
        elif value is not None and before is not None:
            changes.append(f"{key} = {value}")
    return RunName(
        words=", ".join([name, *dict.fromkeys(words)]), changes=tuple(changes)
    )


def table_words(surface: Mapping[str, Any]) -> str:
    """Return words for a table from its section in run.json."""
    if surface.get("kind") == "rigid":
        return "a rigid table"
    for name in shipped_scenes():
        if _shipped_record(name)["surface"] == surface:
            return f"the table of {name}"
    return "another table"


def _differs(record, shipped, section, key):
    one, other = (side.get(section) or {} for side in (record, shipped))
    return key in one and key in other and one[key] != other[key]


def _magnitude(value):
    """Return the spin of an angular velocity as a positive number; other values are
    returned unchanged."""
    return abs(value[2]) if isinstance(value, list) else value


@cache
def _shipped_record(name: str) -> dict:
    return scene_record(load_scene(name))
