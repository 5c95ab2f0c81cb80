"""Claim: a scene is read strictly; what is wrong is said in one line that names the key, its value and what is allowed.

Source: the format of scene files in the README. Oracle: the numbers of the paper, (7.1) to (7.4), and, for faults, the
key that each document is made wrong in.
"""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from sonify import SceneError, load_scene
from sonify.plan.plan import plan_of
from sonify.scene import Scene, from_document, shipped_scenes


@pytest.fixture
def published() -> Scene:
    return load_scene("published")


def test_the_published_scene_is_that_of_the_paper(published):
    disk, friction = published.disk, published.friction
    assert disk.mass == 0.4387
    assert disk.time_unit == pytest.approx(0.0691712, abs=5e-8)  # (7.2)
    assert (friction.mu_static, friction.mu_dynamic) == (0.5, 0.3)
    arms = (friction.arm_nutation, friction.arm_rolling, friction.arm_pivoting)
    assert [arm / disk.radius for arm in arms] == pytest.approx([0.0001, 0.0008, 0.008])  # (7.3)
    assert math.radians(published.release.inclination_deg) == pytest.approx(math.pi / 2 - 1, abs=1e-15)  # (7.4)
    assert [w * disk.time_unit for w in published.release.omega] == pytest.approx([0, 0, -1], abs=1e-7)


def test_every_shipped_scene_loads_and_says_what_it_is():
    for name, summary in shipped_scenes().items():
        assert load_scene(name).name == name
        assert summary


def test_replace_reads_toml_and_bare_words(published):
    scene = published.replace(
        "friction.mu_static=0.4", "disk.shape=shell", "release.omega=[0, 1, -2.5]", "name = other"
    )
    assert scene.friction.mu_static == 0.4
    assert scene.disk.shape == "shell"
    assert scene.release.omega == (0, 1, -2.5)
    assert scene.name == "other"
    assert published.friction.mu_static == 0.5
    assert scene.replace("friction.mu_static=0.45").disk.shape == "shell"


def test_replace_can_open_a_section(published):
    assert published.replace("numerics.accuracy=draft").numerics.accuracy == "draft"


def test_infinite_friction_is_physics(published):
    scene = published.replace("friction.mu_static=inf", "friction.mu_dynamic=inf")
    assert scene.friction.mu_static == math.inf


def test_a_scene_cannot_be_changed_through_its_document(published):
    published.document["disk"]["radius"] = 1.0
    assert published.document["disk"]["radius"] == published.disk.radius


@pytest.mark.parametrize("name", sorted(shipped_scenes()))
def test_a_scene_that_was_not_read_has_a_document_too(name):
    read = load_scene(name)
    made = replace(read, name="made")
    assert from_document(made.document) == made
    assert made.replace(f"name={name}") == read
    planned = plan_of(read).scene(read)
    assert planned.replace("audio.sample_rate=44100").numerics == planned.numerics


def test_the_document_of_a_disk_given_by_its_density_gives_no_mass(published):
    document = published.document
    document["disk"]["density"] = 7850.0
    del document["disk"]["mass"]
    read = from_document(document)
    made = replace(read, name="made")
    assert "mass" not in made.document["disk"]
    assert made.replace("disk.density=7900").disk.mass == pytest.approx(read.disk.mass * 7900 / 7850)


FAULTS = [
    ("disk.radius=-1", "disk.radius = -1: must be greater than 0"),
    ("disk.radius=0", "disk.radius"),
    ("disk.mass=-0.4", "disk.mass = -0.4"),
    ("disk.mass=nan", "disk.mass = nan: must be finite"),
    ("disk.radius=inf", "disk.radius = inf: must be finite"),
    ("release.omega=[0.0, nan, 0.0]", "release.omega = nan"),
    ("friction.mu_static=nan", "friction.mu_static = nan"),
    ("friction.mu_dynamic=-inf", "friction.mu_dynamic = -inf"),
    ("friction.arm_rolling=inf", "friction.arm_rolling = inf"),
    ("audio.distance=inf", "audio.distance = inf"),
    ("audio.distance=0.01", "audio.distance = 0.01"),
    ("disk.radios=0.04", "disk.radios: unknown key; known: radius, thickness, mass, density, shape"),
    ("disc.radius=0.04", "disc: unknown key; known: name, disk"),
    ("disk.radius=true", "disk.radius = True"),
    ("disk.radius=wide", "disk.radius = 'wide': must be a valid number"),
    ("disk.shape=square", "disk.shape = 'square': must be 'solid' or 'shell'"),
    ("disk=3", "disk = 3"),
    ("disk.density=7000", "disk: give either mass or density"),
    ("release.inclination_deg=0", "release.inclination_deg = 0"),
    ("release.inclination_deg=90", "release.inclination_deg = 90: must be less than 90"),
    ("release.inclination_deg=-5", "release.inclination_deg = -5"),
    ("release.omega=[1.0, 2.0]", "release.omega.2: missing"),
    ("release.omega=2024-01-01", "release.omega"),
    ("material.poisson=0.5", "material.poisson = 0.5: must be less than 0.5"),
    ("material.poisson=-1", "material.poisson = -1: must be greater than -1"),
    ("material.young=0", "material.young = 0"),
    ("friction.mu_dynamic=0.6", "mu_dynamic = 0.6 must not exceed mu_static = 0.5"),
    ("support.half_angle_deg=0", "support.half_angle_deg = 0"),
    ("support.half_angle_deg=181", "support.half_angle_deg = 181: must be less than or equal to 180"),
    ("support.kind=glued", "support.kind = 'glued'"),
    ("surface.kind=plate", "surface.kind = 'plate'"),
    ("audio.sample_rate=7999", "audio.sample_rate = 7999: must be greater than or equal to 8000"),
    ("audio.sample_rate=44100.5", "audio.sample_rate = 44100.5"),
    ("audio.elevation_deg=91", "audio.elevation_deg = 91"),
    ("numerics.accuracy=best", "numerics.accuracy = 'best'"),
    ("numerics.tolerance=0", "numerics.tolerance = 0"),
    ("name=../elsewhere", "name = '../elsewhere'"),
    ("disk", "'disk': expected section.key=value"),
    (".radius=1", "'.radius=1': expected section.key=value"),
    ("disk.radius.x=1", "disk.radius.x: radius is a value, not a section"),
]


@pytest.mark.parametrize(("assignment", "message"), FAULTS, ids=[fault[0] for fault in FAULTS])
def test_a_fault_is_one_line_that_names_it(published, assignment, message):
    with pytest.raises(SceneError) as caught:
        published.replace(assignment)
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("key", ["radius", "thickness", "mass"])
def test_a_missing_key_is_named(published, key):
    document = published.document
    del document["disk"][key]
    with pytest.raises(SceneError, match=f"disk.*{key}"):
        from_document(document)


@pytest.mark.parametrize("section", ["disk", "material", "friction", "release"])
def test_a_missing_section_is_named(published, section):
    document = published.document
    del document[section]
    with pytest.raises(SceneError, match=f"{section}: missing"):
        from_document(document)


def test_files_that_are_no_scene(tmp_path):
    with pytest.raises(SceneError, match=r"no such scene; shipped: .*published"):
        load_scene("publishd")
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path / "absent.toml")
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path)
    broken, binary = tmp_path / "broken.toml", tmp_path / "binary.toml"
    broken.write_text("[disk\nradius = 1")
    binary.write_bytes(b"\xff\xfe\x00\x01")
    for path in (broken, binary):
        with pytest.raises(SceneError, match="not TOML"):
            load_scene(path)


def test_a_file_is_read_like_a_shipped_scene(published, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text((Path(__file__).parents[1] / "sonify/scenes/published.toml").read_text())
    assert load_scene(path) == published
    assert load_scene(str(path)) == published
