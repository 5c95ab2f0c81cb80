"""The modes that every method is asked for: the published disk, on its patch and free."""

import json
from importlib import resources
from typing import NamedTuple

import numpy as np

from modal import Plate
from modal.solve import density
from sonify.charts.records import relative
from sonify.scene import Scene, load_scene


class ModesCase(NamedTuple):
    """The disk of a scene as a `Plate`; half angle of the patch [rad], None if free; frequencies sought [Hz]."""

    name: str
    scene: Scene
    plate: Plate
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
    half_angle, disk = np.deg2rad(scene.support.half_angle_deg) if kind == "patch" else None, scene.disk
    plate = Plate(radius=disk.radius, thickness=disk.thickness, material=scene.material, density=density(disk))
    return ModesCase(kind, scene, plate, half_angle, tuple(document["frequencies"][kind]))
