"""Name runs in words: a shipped scene and its changed values, "glass, edge rougher"."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from sonify.scene import (
    differing_values,
    load_scene,
    present_scene_name,
    scene_record,
    shipped_scenes,
)


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """Words for a key of a scene: its `label`, and how a run with a larger or a smaller
    value is called. `factor` converts the value to the displayed `unit`. Of a vector, the
    component `axis` is compared, without its sign."""

    label: str
    larger: str
    smaller: str
    unit: str
    factor: float = 1.0
    axis: int | None = None

    def number(self, value: Any) -> float | None:
        """Return the number that is compared and displayed."""
        return value if self.axis is None else abs(value[self.axis])

    def comparison(self, before: float | None, value: float | None) -> str:
        """Return words for a changed value; None means that there is none."""
        if value is None:
            return f"without {self.label}"
        return self.larger if value > (before or 0.0) else self.smaller

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
        axis=2,
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
    name = present_scene_name(str(record["name"]))
    if name not in shipped_scenes():
        return RunName(words=name)
    shipped = _shipped_record(name)
    words = [name, *_replaced_sections(record, shipped)]
    changes = words[1:]
    for key, (before, value) in _changed_values(record, shipped).items():
        quantity = QUANTITIES.get(key)
        if quantity is None or quantity.number(before) == quantity.number(value):
            changes.append(f"{key} = {value}")
        else:
            number = quantity.number(value)
            words.append(quantity.comparison(quantity.number(before), number))
            changes.append(f"{quantity.label} {quantity.text(number)}")
    return RunName(words=", ".join(dict.fromkeys(words)), changes=tuple(changes))


def table_words(surface: Mapping[str, Any]) -> str:
    """Return words for a table from its section in run.json."""
    if surface.get("kind") == "rigid":
        return "a rigid table"
    for name in shipped_scenes():
        if _agrees(surface, _shipped_record(name)["surface"]):
            return f"the table of {name}"
    return "another table"


def _replaced_sections(
    record: Mapping[str, Any], shipped: Mapping[str, Any]
) -> list[str]:
    """Return words for another material, table or air film."""
    words = []
    if _has_other_material(record, shipped):
        words.append(f"of {record['material']['name'] or 'another material'}")
    surface = record.get("surface") or {}
    if not _agrees(surface, shipped["surface"]):
        words.append(f"on {table_words(surface)}")
    film = (record.get("air") or {}).get("film")
    if film not in (None, shipped["air"]["film"]):
        words.append("without air film" if film == "none" else f"air film: {film}")
    return words


def _has_other_material(record: Mapping[str, Any], shipped: Mapping[str, Any]) -> bool:
    material = record.get("material") or {}
    return material.get("name") != shipped["material"]["name"]


def _changed_values(
    record: Mapping[str, Any], shipped: Mapping[str, Any]
) -> dict[str, tuple[Any, Any]]:
    """Return the values before and after a change by key, without those of the replaced
    sections and those that follow from other values."""
    changed = differing_values(dict(shipped), dict(record))
    replaced = ("name", "numerics", "surface", "material", "air.film")
    dependent = ["disk.mass", "disk.density"] * _has_other_material(record, shipped)
    dependent += ["friction.mu_dynamic"] * ("friction.mu_static" in changed)
    if not _agrees(record.get("surface") or {}, shipped["surface"]):
        dependent += ["contact.young", "contact.poisson"]
    found = {}
    for key, (before, value) in changed.items():
        section, _, name = key.partition(".")
        if section in replaced or key in replaced or key in dependent:
            continue
        is_given = all(
            section in side and name in (side[section] or {name})
            for side in (record, shipped)
        )
        if is_given and (key in QUANTITIES or None not in (before, value)):
            found[key] = (before, value)
    return found


def _agrees(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    """Return True if all values that both sections contain are equal."""
    return all(one[key] == other[key] for key in one.keys() & other.keys())


@cache
def _shipped_record(name: str) -> dict[str, Any]:
    return scene_record(load_scene(name))
