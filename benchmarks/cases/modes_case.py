"""Define benchmark modes with reference frequencies: the published disk, held on its
patch or free."""

import json
from importlib import resources
from typing import NamedTuple

import numpy as np

from benchmarks.timed_runs import relative_error
from modal import Plate
from modal.solve import disk_density
from sonify.scene import Scene, load_scene


class ModesCase(NamedTuple):
    """Disk of a scene as a `Plate`, half angle of its patch [rad] or None if free, and
    reference frequencies [Hz]."""

    name: str
    scene: Scene
    plate: Plate
    half_angle: float | None
    reference: tuple[float, ...]

    @property
    def error(self):
        """Function of the frequencies that returns their largest relative error."""
        return relative_error(self.reference)


def modes_case(kind: str) -> ModesCase:
    """Return the case of the published disk with the support 'patch' or 'free'.

    The data file states the origin of the reference values."""
    scene = load_scene("published").replace(f"support.kind={kind}")
    document = json.loads(
        (resources.files("benchmarks") / "references" / "modes.json").read_text("utf-8")
    )
    half_angle = np.deg2rad(scene.support.half_angle_deg) if kind == "patch" else None
    disk = scene.disk
    plate = Plate(
        radius=disk.radius,
        thickness=disk.thickness,
        material=scene.material,
        density=disk_density(disk),
    )
    return ModesCase(
        kind, scene, plate, half_angle, tuple(document["frequencies"][kind])
    )
