"""Claim: a named material has the elastic constants, the loss factor and the density of the table,
explicit keys take precedence, and a scene with a name equals one with the numbers.

Source: the table of materials. Oracle: handbook values of the speed of bending waves and of the
pitch of a free plate; the bytes of the modes.
"""

import json
import re

import numpy as np
import pytest
from paths import ROOT

from dynamics import plan_motion, simulate
from modal import Material, eigenmodes
from modal.materials import MATERIALS
from sonify import SceneError, load_scene
from sonify.plan.unused import unused_keys
from sonify.runtime.json_values import json_safe
from sonify.scene import Scene, from_document, scene_record
from sonify.scene_keys import keys

DISK = "disk={radius=0.0375, thickness=0.0125}"


def named(name: str, *assignments: str) -> Scene:
    """Return the published scene with a disk of a named material, without its mass."""
    scene = load_scene("published")
    return scene.replace(DISK, f'material={{name="{name}"}}', *assignments)


@pytest.mark.parametrize("name", MATERIALS)
def test_the_numbers_are_those_of_the_table(name):
    scene = named(name)
    typical = MATERIALS[name]
    disk = scene.disk
    assert (scene.material.young, scene.material.poisson) == (
        typical.young,
        typical.poisson,
    )
    assert scene.material.loss_factor == typical.loss_factor
    assert disk.density == typical.density
    assert disk.mass == pytest.approx(
        typical.density * np.pi * 0.0375**2 * 0.0125, rel=1e-12
    )
    assert typical.source


SPEED_OF_SOUND = {
    "aluminium": 5000,
    "brass": 3480,
    "glass": 5200,
    "steel": 5190,
    "bronze": 3530,
    "ceramic": 10200,
    "wood": 4000,
    "copper": 3750,
    "cupronickel": 4040,
    "gold": 2030,
    "nickel": 4900,
    "silver": 2730,
}
"""Speed of longitudinal waves in a thin rod [m/s], rounded, from tables of acoustics: steel 5050 to
5200, aluminium 5000 to 5150, glass 5000 to 5300, brass 3450 to 3600, hard wood 3800 to 4300,
copper 3750 to 3810, gold 2030, nickel 4900, silver 2680 to 2790; cupronickel with 25 % of nickel lies
in between copper and nickel."""


@pytest.mark.parametrize(("name", "speed"), SPEED_OF_SOUND.items())
def test_the_speed_of_sound_in_a_rod_is_that_of_the_handbooks(name, speed):
    typical = MATERIALS[name]
    assert (typical.young / typical.density) ** 0.5 == pytest.approx(speed, rel=0.04)
    assert set(SPEED_OF_SOUND) == set(MATERIALS)


def test_explicit_keys_take_precedence():
    scene = named(
        "glass", "material.loss_factor=0.004", "material.young=63e9", "disk.mass=0.2"
    )
    assert scene.material.loss_factor == 0.004
    assert scene.material.young == 63e9
    assert scene.material.poisson == MATERIALS["glass"].poisson
    assert (scene.disk.mass, scene.disk.density) == (0.2, None)
    assert named("glass", "disk.density=2600.0").disk.density == 2600.0


def test_a_name_and_its_numbers_give_the_same_bytes():
    typical = MATERIALS["brass"]
    numbers = load_scene("published").replace(
        f"disk={{radius=0.0375, thickness=0.0125, density={typical.density}}}",
        f"material={{young={typical.young}, poisson={typical.poisson}, "
        f"loss_factor={typical.loss_factor}}}",
    )
    pairs = []
    for scene in (named("brass"), numbers):
        brief = scene.replace("support.kind=free", "numerics.time_limit=0.02")
        modes = eigenmodes(brief, below=9000.0)
        motion = simulate(brief)
        pairs.append((modes.frequency.tobytes(), motion.state.tobytes()))
    assert pairs[0] == pairs[1]
    assert len(pairs[0][0])


@pytest.mark.parametrize(
    "assignments", [(), ("material.loss_factor=0.004",), ("disk.mass=0.2",)], ids=str
)
def test_a_record_of_a_run_is_the_scene(tmp_path, assignments):
    scene = named("wood", *assignments)
    record = scene_record(scene)
    assert record["material"]["name"] == "wood"
    assert record["material"]["young"] == MATERIALS["wood"].young
    path = tmp_path / "run.json"
    path.write_text(json.dumps({"scene": json_safe(record)}), "utf-8")
    again = load_scene(path)
    assert again == scene
    assert from_document(again.document) == scene
    other = again.replace("material.name=steel")
    kept = {"loss_factor"} if scene.material.loss_factor == 0.004 else set()
    for key in {"young", "poisson", "loss_factor"} - kept:
        assert vars(other.material)[key] == getattr(MATERIALS["steel"], key)
    heavier = MATERIALS["steel"].density * scene.disk.volume
    assert other.disk.mass == pytest.approx(
        0.2 if "disk.mass=0.2" in assignments else heavier
    )


@pytest.mark.parametrize(
    ("material", "message"),
    [
        (
            {"name": "glas"},
            "material.name = 'glas': must be one of 'aluminium', 'brass', 'bronze', 'ceramic', "
            "'copper', 'cupronickel', 'glass', 'gold', 'nickel', 'silver', 'steel', 'wood'; "
            "did you mean glass?",
        ),
        ({"name": 3}, "material.name = 3: must be 'aluminium'"),
        (
            {},
            "material: young: missing; give it or the name of a material (aluminium, brass",
        ),
        ({"young": 1e9}, "material: poisson: missing"),
        ({"name": "glass", "young": 0.0}, "material.young = 0.0: must be greater"),
    ],
)
def test_a_wrong_material_is_one_line(material, message):
    document = load_scene("published").document
    document["material"] = material
    with pytest.raises(SceneError, match=re.escape(message)) as error:
        from_document(document)
    assert "\n" not in str(error.value)


def test_a_name_without_effect_is_reported():
    scene = load_scene("published").replace("material.name=glass")
    assert unused_keys(scene, plan_motion(scene)) == ("material.name",)
    assert unused_keys(named("glass"), plan_motion(named("glass"))) == ()


def test_the_list_of_keys_names_the_materials():
    (key,) = [key for key in keys() if key.name == "material.name"]
    assert key.range == ", ".join(MATERIALS)


def test_a_material_in_python():
    assert Material(name="steel").young == MATERIALS["steel"].young
    assert Material(young=1e9, poisson=0.3).loss_factor == 0.0
    with pytest.raises(ValueError, match="young: missing"):
        Material(poisson=0.3)


def test_the_documentation_repeats_the_table():
    rows = re.findall(
        r"^\| `(\w+)` \|(.*)\|$", (ROOT / "docs/how_to.md").read_text("utf-8"), re.M
    )
    stated = {name: [float(x) for x in row.split("|")[:4]] for name, row in rows}
    typical = {
        name: [found.young / 1e9, found.poisson, found.loss_factor, found.density]
        for name, found in MATERIALS.items()
    }
    assert {name: stated[name] for name in MATERIALS} == {
        name: pytest.approx(values) for name, values in typical.items()
    }
