"""The modes that every method is asked for: the published disk, on its patch and free."""

import json
from importlib import resources
from typing import NamedTuple

import numpy as np

from modal.solve import density
from sonify.charts.records import relative
from sonify.scene import Scene, load_scene


class ModesCase(NamedTuple):
    """Radius, thickness [m], density [kg/m^3]; half angle of the patch [rad], None if free; frequencies sought [Hz]."""

    name: str
    scene: Scene
    radius: float
    thickness: float
    density: float
    material: object
    half_angle: float | None
    reference: tuple[float, ...]

    @property
    def error(self):
        """The largest relative error of a frequency."""
        return relative(self.reference)


def modes_case(kind: str) -> ModesCase:
    """Return the case of the published disk on a 'patch' or 'free'; the origin of its frequencies is in the data."""
    scene = load_scene("published").replace(f"support.kind={kind}")
    document = json.loads((resources.files("sonify.charts") / "references" / "modes.json").read_text("utf-8"))
    half_angle = np.deg2rad(scene.support.half_angle_deg) if kind == "patch" else None
    disk = scene.disk
    reference = tuple(document["frequencies"][kind])
    return ModesCase(kind, scene, disk.radius, disk.thickness, density(disk), scene.material, half_angle, reference)
