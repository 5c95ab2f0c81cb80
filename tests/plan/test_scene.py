"""Claim: scenes are read strictly; each error is reported in one line with the key, its value and
the allowed values.

Source: the format of scene files in the README. Oracle: other ways of writing the same scene; for
faults, the invalid key of each document. tests/rigid/test_published_motion.py compares the published
scene with the numbers of the paper.
"""

import json
import math
from dataclasses import asdict, fields, replace

import jsonschema
import numpy as np
import pytest
from paths import ROOT
from pydantic import ValidationError
from scene_faults import FAULTS, MODES, PLATE

from sonify import SceneError, load_scene, run
from sonify.plan.preflight import check_solvable_scene
from sonify.report.write import json_safe
from sonify.scene import (
    FORMER_SCENE_NAMES,
    SHIPPED_SCENES_FOLDER,
    Scene,
    from_document,
    scene_adapter,
    shipped_scenes,
)
from sonify.scene_errors import ERROR_SENTENCES, section_types
from sonify.scene_keys import keys, schema

MATERIAL = "young=11e9, poisson=0.3, density=600.0"
TABLES = {
    "plate": PLATE,
    "modes": MODES,
    "infinite": f"{{kind='infinite', thickness=0.02, {MATERIAL}}}",
    "mesh": f"{{kind='mesh', file='table.msh', {MATERIAL}}}",
}


@pytest.fixture
def published() -> Scene:
    return load_scene("published")


def test_every_shipped_scene_loads_and_says_what_it_is():
    for name, summary in shipped_scenes().items():
        assert load_scene(name).name == name
        assert summary


def test_replace_reads_toml_and_bare_words(published):
    scene = published.replace(
        "friction.mu_static=0.4",
        "disk.shape=shell",
        "release.omega=[0, 1, -2.5]",
        "name = other",
    )
    assert scene.friction.mu_static == 0.4
    assert scene.disk.shape == "shell"
    assert scene.release.omega == (0, 1, -2.5)
    assert scene.name == "other"
    assert published.friction.mu_static == 0.5
    assert scene.replace("friction.mu_static=0.45").disk.shape == "shell"


def test_replace_takes_a_mapping_of_key_paths_to_values(published):
    """The texts of the same assignments are the oracle; NumPy values count as numbers."""
    listeners = '[{distance=0.5}, {distance=1.0, kind="head"}]'
    by_text = published.replace(
        "friction.mu_static=0.4",
        "release.omega=[0, 1, -2.5]",
        "disk={radius=0.03, thickness=0.01, mass=0.2}",
        "audio.sample_rate=44100",
        f"audio.listeners={listeners}",
        "name=other",
    )
    values = {
        "friction.mu_static": np.float64(0.4),
        "release.omega": np.array([0, 1, -2.5]),
        "disk": {"radius": 0.03, "thickness": 0.01, "mass": 0.2},
        "audio.sample_rate": np.int64(44100),
        "audio.listeners": ({"distance": 0.5}, {"distance": 1.0, "kind": "head"}),
    }
    by_mapping = published.replace(values, "name=other")
    assert by_mapping == by_text
    assert by_mapping.document == by_text.document
    rough = by_mapping.replace({"roughness.rms": 1e-8, "contact.law": "elastic"})
    assert rough.replace({"roughness": None}).roughness is None
    assert published.replace({"friction.mu_static": math.inf}) == published.replace(
        "friction.mu_static=inf"
    )
    assert published.replace({}) == published


@pytest.mark.parametrize(
    ("assignment", "message"),
    [
        ({"disk.radius": -1.0}, "disk.radius = -1.0: must be greater than 0"),
        ({"disk.radius": math.nan}, "disk.radius = nan: must be finite"),
        ({"disk.radius": 1j}, "disk.radius = 1j: must be a number, a text, a list or"),
        (
            {"release.omega": [0, object, 1]},
            "release.omega = <class 'object'>: must be",
        ),
        ({"disc.radius": 0.04}, "did you mean disk?"),
        ({"disk..radius": 0.04}, "expected section.key=value"),
        ({3: 0.04}, "expected section.key=value"),
        ({"name.x": 0.04}, "name.x: name is a value, not a section"),
        (["disk.radius=0.04"], 'expected "section.key=value" or a mapping such as'),
        (3, 'expected "section.key=value" or a mapping such as {"section.key": value}'),
    ],
    ids=str,
)
def test_a_wrong_mapping_is_one_line_that_names_it(published, assignment, message):
    with pytest.raises(SceneError) as caught:
        published.replace(assignment)
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("kind", TABLES)
def test_a_table_of_every_kind_is_read_and_written_again(published, kind):
    scene = published.replace(f"surface={TABLES[kind]}")
    assert (scene.surface.kind, scene.surface.action) == (kind, "auto")
    again = replace(scene).document  # as written, where it did not come from a document
    assert from_document(again).surface == scene.surface
    assert jsonschema.Draft202012Validator(schema()).is_valid(again)


def test_a_scene_cannot_be_changed_through_its_document(published):
    published.document["disk"]["radius"] = 1.0
    assert published.document["disk"]["radius"] == published.disk.radius


@pytest.mark.parametrize("name", sorted(shipped_scenes()))
def test_a_scene_that_was_not_read_has_a_document_too(name):
    read = load_scene(name)
    made = replace(read, name="made")
    assert from_document(made.document) == made
    assert made.replace(f"name={name}") == read
    assert made.replace("audio.sample_rate=44100").numerics == read.numerics


def test_the_document_of_a_disk_given_by_its_density_gives_no_mass(published):
    document = published.document
    document["disk"]["density"] = 7850.0
    del document["disk"]["mass"]
    read = from_document(document)
    made = replace(read, name="made")
    assert "mass" not in made.document["disk"]
    assert made.replace("disk.density=7900").disk.mass == pytest.approx(
        read.disk.mass * 7900 / 7850
    )


@pytest.mark.parametrize(
    ("assignment", "message"), FAULTS, ids=[fault[0] for fault in FAULTS]
)
def test_a_fault_is_one_line_that_names_it(published, assignment, message):
    with pytest.raises(SceneError) as caught:
        published.replace(assignment)
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


MISSPELT = [
    ("mu_static=0.4", "friction.mu_static"),
    ("friction.mu_statc=0.4", "friction.mu_static"),
    ("mu_statik=0.4", "friction.mu_static"),
    ("radius=0.04", "disk.radius or surface.radius"),
    ("disc.radius=0.04", "disk"),
    ("audio.samplerate=44100", "audio.sample_rate"),
    ("friction.fillet=1e-3", "contact.fillet"),
    ("audio.listeners=[{distanc=1.0}]", "audio.listeners.0.distance"),
]


@pytest.mark.parametrize(("assignment", "meant"), MISSPELT)
def test_the_key_that_was_meant_is_asked_for(published, assignment, meant):
    with pytest.raises(SceneError) as caught:
        published.replace(assignment)
    assert str(caught.value).endswith(f"; did you mean {meant}?")


@pytest.mark.parametrize(
    "assignment", ["surface.radius=1", "surface.modes=[]", "zzz=1"]
)
def test_no_key_is_suggested_for_one_of_another_kind_or_like_none(
    published, assignment
):
    with pytest.raises(SceneError, match="unknown key") as caught:
        published.replace(assignment)
    assert "did you mean" not in str(caught.value)


def test_at_most_twenty_scenes_are_shipped():
    assert len(shipped_scenes()) <= 20


@pytest.mark.parametrize(("former", "name"), FORMER_SCENE_NAMES.items())
def test_a_former_name_of_a_scene_loads_it(former, name, tmp_path, monkeypatch):
    """A file of that name in the current folder goes before; the list has the present name only."""
    assert load_scene(former) == load_scene(name)
    assert load_scene(former).name == name
    assert former not in shipped_scenes()
    monkeypatch.chdir(tmp_path)
    (tmp_path / former).write_text(
        (SHIPPED_SCENES_FOLDER / "published.toml").read_text("utf-8")
    )
    assert load_scene(former).name == "published"


def test_a_whole_number_may_be_written_with_an_exponent(published):
    """TOML reads 44.1e3 as a float; an integer key accepts it as 44100."""
    scene = published.replace(
        "audio.sample_rate=44.1e3", "roughness={rms=3e-8, seed=3.0}"
    )
    rate = scene.audio.sample_rate
    assert (rate, type(rate)) == (44100, int)
    assert scene.roughness.seed == 3
    assert scene == published.replace(
        "audio.sample_rate=44100", "roughness={rms=3e-8, seed=3}"
    )
    assert scene.document["audio"]["sample_rate"] == 44100
    modes = MODES.replace("order=2", "order=2e0")
    assert published.replace(f"surface={modes}").surface.modes[0].order == 2
    with pytest.raises(
        SceneError, match=r"audio\.sample_rate = 1000000: must be less than"
    ):
        published.replace("audio.sample_rate=1e6")


ROUGH = [
    ("roughness.shortest=0.2", "longest = 0.1: must exceed shortest = 0.2"),
    (
        "roughness.longest=5e-4",
        "roughness.longest = 0.0005: must exceed the length of the contact, 0.000506 m",
    ),
    (
        "roughness.shortest=1e-9",
        "longest = 0.1: must be at most 32768 times shortest = 1e-09",
    ),
    ("roughness.profile=table.csv", "roughness: give either rms or profile"),
    (
        "roughness.profile_edge=edge.csv",
        "roughness.profile_edge = 'edge.csv': cannot be read: No such file",
    ),
    (
        "contact.fillet=0.0065",
        "contact.fillet = 0.0065: must be positive and at most 0.0064, so that it fits the disk",
    ),
    (
        "contact.fillet=1e-7",
        "contact.fillet = 1e-07: too sharp for an elastic contact, must be at least 2.86e-06",
    ),
    (
        "contact.young=1.5",
        "too sharp for an elastic contact, as is any fillet up to 0.0064",
    ),
    (
        "numerics.contact_rate=2e4",
        "numerics.contact_rate = 20000: too low for the stiffness of the contact",
    ),
]


@pytest.mark.parametrize(
    ("assignment", "message"), ROUGH, ids=[fault[0] for fault in ROUGH]
)
def test_a_fault_of_an_elastic_contact_is_one_line(published, assignment, message):
    rough = published.replace("contact.law=elastic", "roughness.rms=3e-8")
    with pytest.raises(SceneError) as caught:
        rough.replace(assignment)
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_heights_that_cannot_be_read_are_refused_whatever_solves_the_contact(published):
    for law in ("rigid", "elastic"):
        with pytest.raises(
            SceneError,
            match=r"roughness\.profile = 'absent\.csv': cannot be read: No such file",
        ):
            published.replace(f"contact.law={law}", 'roughness={profile="absent.csv"}')


@pytest.mark.parametrize("text", [5000 * "[", 5000 * "1"], ids=["too deep", "too long"])
def test_what_the_reader_of_toml_cannot_bear_is_a_fault_too(published, tmp_path, text):
    with pytest.raises(SceneError, match=r"disk\.radius ="):
        published.replace(f"disk.radius={text}")
    (tmp_path / "mine.toml").write_text(f"radius = {text}")
    with pytest.raises(SceneError, match="invalid TOML"):
        load_scene(tmp_path / "mine.toml")


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


def test_a_name_is_a_scene_wherever_one_is_run(tmp_path):
    assert check_solvable_scene("coin-polished", "draft") == load_scene(
        "coin-polished"
    ).replace("numerics.accuracy=draft")
    with pytest.raises(SceneError, match="no such scene"):
        run("coim", out=tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_files_that_are_no_scene(tmp_path):
    with pytest.raises(
        SceneError,
        match=r"no such scene; give a TOML file or one of: .*; did you mean published\?$",
    ):
        load_scene("publishd")
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path / "absent.toml")
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path)
    broken = tmp_path / "broken.toml"
    binary = tmp_path / "binary.toml"
    broken.write_text("[disk\nradius = 1")
    binary.write_bytes(b"\xff\xfe\x00\x01")
    for path in (broken, binary):
        with pytest.raises(SceneError, match="invalid TOML"):
            load_scene(path)


def test_a_file_is_read_like_a_shipped_scene(published, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text((ROOT / "sonify/scenes/published.toml").read_text())
    assert load_scene(path) == published
    assert load_scene(str(path)) == published


def test_the_mark_that_some_editors_put_before_a_text_is_no_fault(published, tmp_path):
    path = tmp_path / "marked.toml"
    path.write_bytes(
        b"\xef\xbb\xbf" + (ROOT / "sonify/scenes/published.toml").read_bytes()
    )
    assert load_scene(path) == published


@pytest.mark.parametrize("name", sorted(shipped_scenes()))
def test_the_record_of_a_run_is_a_scene(tmp_path, name):
    path = tmp_path / "run.json"
    ran = load_scene(name).replace("friction.mu_static=inf", "audio.distance=2.0")
    path.write_text(json.dumps({"scene": json_safe(asdict(ran))}, allow_nan=False))
    assert load_scene(path) == ran
    assert load_scene(path).replace("friction.mu_static=1.0") == ran.replace(
        "friction.mu_static=1.0"
    )


@pytest.mark.parametrize(
    "text", ["{", "[]", "{}", '{"scene": 3}', '{"scene": {"disk": 3}}', '{"scene": {}}']
)
def test_json_that_is_no_record_of_a_run(tmp_path, text):
    path = tmp_path / "some.json"
    path.write_text(text)
    with pytest.raises(SceneError, match=r"some\.json: (not|invalid)"):
        load_scene(path)


def complaint(scene, assignment):
    """Return the error message for an assignment, or an empty string if it is allowed."""
    try:
        scene.replace(assignment)
    except SceneError as error:
        return str(error)
    return ""


WRONG = [
    "true",
    "word",
    "1.5",
    "-1",
    "0",
    "1e308",
    "1e-300",
    "1" + "0" * 400,
    "[]",
    "[1.0]",
    "[[1]]",
    "{}",
    "{a = 1}",
]
WRONG += [
    "[1.0, 2.0, 3.0, 4.0]",
    '["axial", "axial"]',
    "2024-01-01",
    "nan",
    "-inf",
    "..",
    "''",
]


def test_every_fault_that_pydantic_finds_is_said_in_a_sentence_of_ours(
    published, monkeypatch
):
    """The test assigns every wrong value to every key."""
    found = set()
    plain = scene_adapter()

    class Noting:
        def validate_json(self, text):
            try:
                return plain.validate_json(text)
            except ValidationError as error:
                found.update(fault["type"] for fault in error.errors())
                raise

    monkeypatch.setattr("sonify.scene.scene_adapter", Noting)
    sections = [field.name for field in fields(Scene)]
    for assignment in [
        f"{key}={value}"
        for key in [*sections, *(key.name for key in keys())]
        for value in WRONG
    ]:
        told = complaint(published, assignment)
        assert len(told.splitlines()) <= 1, assignment
        assert "nput should" not in told, assignment
    assert len(found) > 10
    assert found <= set(ERROR_SENTENCES) | {"unexpected_keyword_argument"}


def test_the_reference_lists_every_key_with_unit_and_meaning():
    sections = [
        (field.name, kind)
        for field in fields(Scene)
        for kind in section_types(field.type)
    ]
    named = {
        f"{name}.{field.name}"
        for name, section in sections
        for field in fields(section)
    }
    listed = {key.name: key for key in keys()}
    assert set(listed) == named | {"name"}
    for key in listed.values():
        assert key.meaning[0].isupper(), key
        assert key.meaning.endswith("."), key
        assert key.name.endswith("_deg") == (key.unit == "degrees"), key
    assert listed["disk.radius"] == (
        "disk.radius",
        "m",
        "> 0, <= 100",
        "required",
        "Outer radius.",
    )
    assert listed["numerics.time_limit"][1:4] == ("s", "> 0, <= 1e+06", "600.0")


@pytest.mark.parametrize(
    "key",
    [key for key in keys() if set(key.range) & set("<>")],
    ids=lambda key: key.name,
)
def test_the_range_in_the_reference_is_what_is_allowed(published, key):
    """The key is valid just inside each bound and invalid just outside or on an open bound."""
    if key.name.startswith("surface"):
        tables = TABLES | {"rigid": "{kind='rigid'}"}
        kind = next(kind for kind in tables if kind in key.meaning.rpartition("(")[2])
        published = published.replace(f"surface={tables[kind]}")

    def refused(value):
        more = (
            2 * ", 1.0"
            if key.range.startswith("list of 3")
            else ", 1.0" * key.range.startswith("list of 2")
        )
        text = f"[{value!r}{more}]" if key.range.startswith("list") else repr(value)
        told = complaint(published, f"{key.name}={text}")
        # rather than "must not exceed" another key
        return (
            told.startswith(key.name)
            and "must be " in told
            and "fits the disk" not in told
        )

    for bound in key.range.removesuffix(" or contact").split(": ")[-1].split(", "):
        sign, number = bound.split()
        limit = float(number)
        whole = key.name in {
            "audio.sample_rate",
            "imperfection.order",
            "roughness.seed",
        }
        step = 1 if whole else max(abs(limit), 1e-300) * 1e-6
        outward = -step if sign.startswith(">") else step
        assert refused(type(step)(limit) + outward)
        assert refused(type(step)(limit)) == ("=" not in sign)


@pytest.mark.parametrize("name", sorted(shipped_scenes()))
def test_the_schema_accepts_the_shipped_scenes_and_refuses_what_is_wrong(name):
    check = jsonschema.Draft202012Validator(schema())
    document = load_scene(name).document
    assert check.is_valid(document)
    for section, key, value in [
        ("disk", "radius", -1),
        ("disk", "radios", 1),
        ("audio", "sample_rate", 44100.5),
    ]:
        assert not check.is_valid(
            document | {section: document.get(section, {}) | {key: value}}
        )
