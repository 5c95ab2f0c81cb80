"""Claim: mass and density determine the thickness of a disk that has none; the modes of a gold coin
are then those that were measured.

Source: the volume of a cylinder. Oracle: frequencies of a one-ounce Krugerrand from its recorded ring
(4900, 10750 and 18500 Hz, uncertain by 3 to 5 %); the same scene with the thickness in numbers.
"""

import json
import re

import numpy as np
import pytest

from dynamics import Disk, plan_motion
from modal import eigenmodes
from modal.materials import MATERIALS
from sonify import SceneError, load_scene
from sonify.plan.unused import unused_keys
from sonify.runtime.json_values import json_safe
from sonify.scene import from_document, scene_record

COIN = "radius=0.016385, mass=0.03393"
GOLD = "material={young=95e9, poisson=0.42, loss_factor=2e-4}"
FREE = 'support={kind="free"}'


def coin(disk: str, *assignments: str):
    """Return the scene of a free coin with a section `disk`."""
    return load_scene("published").replace(f"disk={{{disk}}}", GOLD, FREE, *assignments)


def test_the_coin_rings_as_measured():
    found = eigenmodes(coin(f"{COIN}, density=17500.0"), 20e3)
    lowest = [found.frequency[found.order == n].min() for n in (2, 3, 4)]
    assert lowest == pytest.approx([4900, 10750, 18500], rel=0.031)
    at_rim = eigenmodes(coin(f"{COIN}, thickness=0.00284"), 20e3)
    assert at_rim.frequency.min() == pytest.approx(6603, abs=1)


def test_mass_and_density_determine_the_thickness():
    disk = Disk(radius=0.016385, mass=0.03393, density=17500.0)
    assert disk.thickness * np.pi * 0.016385**2 * 17500 == pytest.approx(
        0.03393, rel=1e-14
    )
    assert disk.mass == 0.03393
    ring = Disk(radius=0.01, mass=0.004, density=8000.0, shape="shell", wall=0.002)
    assert ring.volume == pytest.approx(0.004 / 8000, rel=1e-14)
    given = Disk(radius=0.016385, mass=0.03393, thickness=disk.thickness)
    assert given == disk


@pytest.mark.parametrize("name", MATERIALS)
def test_a_named_material_gives_the_density(name):
    scene = load_scene("published").replace(
        f"disk={{{COIN}}}", f'material={{name="{name}"}}'
    )
    implied = scene.disk.mass / scene.disk.volume
    assert implied == pytest.approx(MATERIALS[name].density, rel=1e-14)
    heavier = scene.replace("disk.mass=0.06786")
    assert heavier.disk.thickness == pytest.approx(2 * scene.disk.thickness, rel=1e-14)
    assert scene.replace("disk.thickness=0.002").disk.thickness == 0.002
    assert unused_keys(scene, plan_motion(scene)) == ()


def test_the_record_of_a_run_is_the_same_scene(tmp_path):
    for scene in (coin(f"{COIN}, density=17500.0"), coin(COIN, "material.name=gold")):
        (tmp_path / "run.json").write_text(
            json.dumps(json_safe({"scene": scene_record(scene)}))
        )
        again = load_scene(tmp_path / "run.json")
        assert again == scene
        assert from_document(again.document) == scene


@pytest.mark.parametrize(
    ("disk", "message"),
    [
        (COIN, "disk: thickness: missing; give it, or both mass and density"),
        ("radius=0.016, density=17500.0", "disk: thickness: missing"),
        ("radius=0.016", "disk: thickness: missing"),
        ("radius=0.016, thickness=0.002", "disk: give either mass or density"),
        (
            f"{COIN}, density=17500.0, thickness=0.002",
            "disk: give either mass or density; without thickness, give both",
        ),
        (
            "radius=0.016, mass=0.03, density=1e4, shape='shell'",
            "disk: a shell of negligible wall has no volume: give its mass and thickness",
        ),
        (
            "radius=0.001, mass=1e6, density=1.0",
            "disk: mass = 1e+06 and density = 1 give a thickness of 3.1831e+11 m; it must be from",
        ),
        (
            "radius=0.016, mass=0.0, density=1e4",
            "disk.mass = 0.0: must be greater than",
        ),
    ],
)
def test_dimensions_that_contradict_each_other_are_one_line(disk, message):
    with pytest.raises(SceneError, match=re.escape(message)) as error:
        coin(disk)
    assert "\n" not in str(error.value)
