"""Claim: an exported motion is the solved one, as an animated model and as a table.

Source: glTF 2.0 and its draft KHR_audio_emitter; `Motion.to_frame`. Oracle: the validator of
Khronos; accessors read without the writer, and readers of tables; the rim as a true circle, which
touches the table in every frame; the velocity of a rigid body.
"""

import json
import shutil
import subprocess
from io import BytesIO

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
import soundfile
from click.testing import CliRunner
from pygltflib import GLTF2
from refused_commands import assert_refused
from scipy.spatial.transform import Rotation

from dynamics import simulate
from dynamics.contact_geometry import contact_position
from dynamics.observables import precession_rate
from sonify import load_scene
from sonify.__main__ import main
from sonify.export.model_geometry import body_poses, disk_mesh, rim_sides
from sonify.export.motion import aliasing_notice, export_motion
from sonify.runtime.json_values import json_safe, write_json
from sonify.scene import SHIPPED_SCENES_FOLDER as SCENES_FOLDER
from sonify.scene import scene_record
from sonify.scene_errors import InputError

SCENES = {
    "published": ("numerics.accuracy=draft", "numerics.time_limit=3.0"),
    "coin-polished": ("numerics.accuracy=draft", "numerics.time_limit=0.2"),
    "hoop": ("numerics.accuracy=draft", "numerics.time_limit=1.0"),
    "glass-plate": (
        "numerics.accuracy=draft",
        "numerics.time_limit=0.3",
        "surface.action=sound",
    ),
}
COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
TYPES = {5126: "<f4", 5125: "<u4"}


def values(model, number):
    """Return the values of an accessor."""
    accessor = model.accessors[number]
    view = model.bufferViews[accessor.bufferView]
    blob = model.binary_blob() or model.get_data_from_buffer_uri(model.buffers[0].uri)
    start = view.byteOffset + (accessor.byteOffset or 0)
    width = COMPONENTS[accessor.type]
    flat = np.frombuffer(
        blob, TYPES[accessor.componentType], accessor.count * width, start
    )
    return flat.reshape(accessor.count, width) if width > 1 else flat


def tracks(model):
    """Return the time [s] and the animated values by node and path."""
    (animation,) = model.animations
    found = {}
    for channel in animation.channels:
        sampler = animation.samplers[channel.sampler]
        assert sampler.interpolation == "LINEAR"
        name = model.nodes[channel.target.node].name
        found[name, channel.target.path] = values(model, sampler.output).astype(float)
        found["t"] = values(model, sampler.input).astype(float)
    return found


def mesh_points(model, name):
    """Return the vertices of the mesh of a node."""
    (node,) = [node for node in model.nodes if node.name == name]
    primitives = model.meshes[node.mesh].primitives
    return np.concatenate(
        [values(model, p.attributes.POSITION) for p in primitives]
    ).astype(float)


@pytest.fixture(scope="module", params=SCENES)
def exported(request, tmp_path_factory):
    """Return the scene, its motion and the model of it."""
    scene = load_scene(request.param).replace(*SCENES[request.param])
    path = export_motion(scene, "gltf", tmp_path_factory.mktemp("model") / "disk.glb")
    model = GLTF2().load(str(path))
    motion = simulate(scene)
    return scene, motion, model, tracks(model)


def test_the_frames_are_60_a_second_up_to_the_end(exported):
    _, motion, model, track = exported
    t = track["t"]
    assert np.diff(t[:-1]) == pytest.approx(1 / 60, rel=1e-4)
    assert t[-1] == pytest.approx(motion.t[-1], rel=1e-6)
    assert model.asset.version == "2.0"
    clock = model.accessors[model.animations[0].samplers[0].input]
    assert (clock.min, clock.max) == ([0.0], [pytest.approx(t[-1])])


def test_the_rim_touches_the_table_in_every_frame(exported):
    """The lowest point of a circle of radius R about the axis n is R sqrt(1 - n_y^2) below its
    centre; a fillet r surrounds a circle of radius R - r. Its chords are 0.5 % flatter."""
    scene, motion, model, track = exported
    turn = Rotation.from_quat(track["disk", "rotation"])
    axis = turn.apply([0.0, 1.0, 0.0])
    fillet = motion.rolling_fillet
    below = (scene.disk.radius - fillet) * np.hypot(axis[:, 0], axis[:, 2]) + fillet
    below += (scene.disk.thickness / 2 - fillet) * axis[:, 1]
    assert np.abs(track["disk", "translation"][:, 1] - below).max() < 1e-6
    corners = mesh_points(model, "disk")
    for i in range(0, len(below), max(len(below) // 20, 1)):
        low = (turn[i].apply(corners) + track["disk", "translation"][i])[:, 1].min()
        assert abs(low) < 1e-6 + 0.005 * fillet


def test_the_quaternion_is_unit_and_continuous(exported):
    quaternion = exported[3]["disk", "rotation"]
    assert np.linalg.norm(quaternion, axis=1) == pytest.approx(1.0, abs=1e-6)
    assert (np.einsum("ki,ki->k", quaternion[1:], quaternion[:-1]) >= 0).all()


def test_the_pose_is_that_of_the_motion(exported):
    """The contact is where the sound of a table has it, and the body turns as solved."""
    scene, motion, _, track = exported
    t = np.minimum(track["t"], motion.t[-1])
    state = motion.at(t)
    x, y = contact_position(state, scene.disk, motion.rolling_fillet).T
    expected = np.column_stack([x, 0 * x, -y])
    assert track["contact", "translation"] == pytest.approx(expected, abs=1e-6)
    assert track["disk", "translation"][:, [0, 2]] == pytest.approx(
        state[:, 3:5] * [1, -1], abs=1e-6
    )
    up = Rotation.from_quat(track["disk", "rotation"]).apply([0.0, 1.0, 0.0])[:, 1]
    assert up == pytest.approx(np.cos(state[:, 1]), abs=1e-6)


def test_the_body_turns_with_its_angular_velocity():
    """The rotation between two close instants is the solved angular velocity times their distance.

    The components in the precessing frame are along a_1 = nutation, the axis, and the disk plane.
    """
    motion = simulate(load_scene("published").replace("numerics.accuracy=draft"))
    step = 1e-5
    t = np.linspace(0.1, 5.0, 50)
    _, before = body_poses(motion.at(t - step), motion.disk)
    _, after = body_poses(motion.at(t + step), motion.disk)
    turn = (
        Rotation.from_quat(after) * Rotation.from_quat(before).inv()
    ).as_rotvec() / (2 * step)
    omega = motion.at(t)[:, 5:8]
    assert np.linalg.norm(turn, axis=1) == pytest.approx(
        np.linalg.norm(omega, axis=1), rel=1e-4
    )
    axis = Rotation.from_quat(body_poses(motion.at(t), motion.disk)[1]).apply(
        [0.0, 1.0, 0.0]
    )
    assert np.einsum("ki,ki->k", turn, axis) == pytest.approx(omega[:, 1], abs=1e-3)


def test_the_disk_has_its_size(exported):
    """Oracle: the theorems of Pappus for the rounded edges."""
    scene, motion, model, _ = exported
    points = mesh_points(model, "disk")
    radius = np.hypot(points[:, 0], points[:, 2])
    assert radius.max() == pytest.approx(scene.disk.radius, rel=1e-6)
    assert radius.min() == pytest.approx(scene.disk.inner_radius, abs=1e-8)
    assert np.ptp(points[:, 1]) == pytest.approx(scene.disk.thickness, rel=1e-6)
    (node,) = [node for node in model.nodes if node.name == "disk"]
    area = volume = 0.0
    for primitive in model.meshes[node.mesh].primitives:
        corners = values(model, primitive.attributes.POSITION).astype(float)
        normals = values(model, primitive.attributes.NORMAL).astype(float)
        triangles = values(model, primitive.indices).reshape(-1, 3)
        a, b, c = corners[triangles].swapaxes(0, 1)
        facing = np.cross(b - a, c - a) / 2
        assert (np.einsum("ni,ni->n", facing, normals[triangles[:, 0]]) > 0).all()
        volume += np.einsum("ni,ni->", a, facing) / 3
        area += np.linalg.norm(facing, axis=1).sum()
    fillet = motion.rolling_fillet
    if scene.disk.volume:
        removed = removed_volume(scene.disk.radius, fillet)
        assert volume == pytest.approx(scene.disk.volume - removed, rel=1e-3)
    assert area == pytest.approx(rounded_area(scene.disk, fillet), rel=2e-3)


def removed_volume(radius, fillet):
    """Return the volume [m^3] that two rounded edges lack."""
    corner = fillet**2 * (1 - np.pi / 4)
    return 4 * np.pi * corner * (radius - fillet + 2 * fillet / (3 * (4 - np.pi)))


def rounded_area(disk, fillet):
    """Return the area [m^2] of a disk with two rounded edges."""
    core = disk.radius - fillet
    faces = 2 * np.pi * (core**2 - disk.inner_radius**2)
    lateral = disk.radius * (disk.thickness - 2 * fillet)
    lateral += np.pi * fillet * (core + 2 * fillet / np.pi)
    return faces + 2 * np.pi * (lateral + disk.inner_radius * disk.thickness)


def test_the_table_is_below_all_frames(exported):
    scene, _, model, track = exported
    table = mesh_points(model, "table")
    assert (table[:, 1] == 0).all()
    contact = track["contact", "translation"]
    if scene.surface.kind == "plate":
        assert np.ptp(table[:, 0]) == pytest.approx(2 * scene.surface.radius, rel=1e-3)
    for axis in (0, 2):
        assert table[:, axis].min() < contact[:, axis].min()
        assert table[:, axis].max() > contact[:, axis].max()


def test_the_polygon_is_close_to_the_rim_of_any_disk():
    for radius in (1e-4, 0.0375, 0.5):
        sagitta = radius * (1 - np.cos(np.pi / rim_sides(radius)))
        assert sagitta <= 2.1e-7
    assert disk_mesh(load_scene("published").disk).triangles.keys() == {"metal", "mark"}


def test_a_model_as_text_is_the_same(tmp_path):
    scene = load_scene("published").replace(*SCENES["coin-polished"])
    loaded = [
        GLTF2().load(str(export_motion(scene, "gltf", tmp_path / name, rate=120.0)))
        for name in ("a.glb", "a.gltf")
    ]
    binary, text = map(tracks, loaded)
    assert (tmp_path / "a.gltf").read_text("utf-8").startswith("{")
    assert binary.keys() == text.keys()
    assert all(np.array_equal(binary[key], text[key]) for key in binary)
    assert len(binary["t"]) == 25


@pytest.fixture(scope="module")
def folder_of_run(tmp_path_factory):
    """Return the folder of a run with two channels of noise as its audible.wav."""
    folder = tmp_path_factory.mktemp("run")
    scene = load_scene("published").replace(*SCENES["coin-polished"])
    write_json({"scene": json_safe(scene_record(scene))}, folder / "run.json")
    noise = 0.1 * np.random.default_rng(1).standard_normal((24_001, 2))
    soundfile.write(folder / "audible.wav", noise, 48_000, "PCM_24")
    return folder


@pytest.mark.parametrize("name", ["disk.glb", "disk.gltf"])
def test_the_disk_of_a_run_emits_its_audible_sound(tmp_path, folder_of_run, name):
    """It is the first channel to the step of 16 bits, as loud as the file at the listener."""
    model = GLTF2().load(str(export_motion(folder_of_run, "gltf", tmp_path / name)))
    (disk,) = [node for node in model.nodes if node.name == "disk"]
    sounds = model.extensions["KHR_audio_emitter"]
    emitter = sounds["emitters"][disk.extensions["KHR_audio_emitter"]["emitter"]]
    listener = load_scene("published").audio.single_listener
    assert emitter["positional"]["refDistance"] == listener.distance
    source = sounds["sources"][emitter["sources"][0]]
    assert source["autoPlay"]
    audio = sounds["audio"][source["audio"]]
    view = model.bufferViews[audio["bufferView"]]
    blob = model.binary_blob() or model.get_data_from_buffer_uri(model.buffers[0].uri)
    wav = BytesIO(blob[view.byteOffset : view.byteOffset + view.byteLength])
    assert (audio["mimeType"], model.extensionsUsed) == (
        "audio/wav",
        ["KHR_audio_emitter"],
    )
    heard, rate = soundfile.read(wav, always_2d=True)
    written, _ = soundfile.read(folder_of_run / "audible.wav")
    assert (rate, heard.shape) == (48_000, (24_001, 1))
    assert heard[:, 0] == pytest.approx(written[:, 0], abs=2**-15)


def test_a_scene_has_no_sound_yet_and_a_broken_one_is_one_line(tmp_path):
    scene = load_scene("published").replace(*SCENES["coin-polished"])
    model = GLTF2().load(str(export_motion(scene, "gltf", tmp_path / "a.glb")))
    assert not model.extensionsUsed
    write_json({"scene": json_safe(scene_record(scene))}, tmp_path / "run.json")
    (tmp_path / "audible.wav").write_bytes(b"no sound")
    with pytest.raises(InputError, match=r"audible\.wav: not a readable sound file"):
        export_motion(tmp_path, "gltf", tmp_path / "b.glb")
    assert not (tmp_path / "b.glb").exists()


VALIDATE = """
import { readFileSync } from 'node:fs'
import validator from 'gltf-validator'
const report = (file) => validator.validateBytes(new Uint8Array(readFileSync(file)))
console.log(JSON.stringify(await Promise.all(process.argv.slice(2).map(report))))
"""


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("npm") is None, reason="needs npm")
def test_the_validator_of_khronos_finds_no_fault(tmp_path, folder_of_run):
    """It does not know the extension for sounds, and reports the view of the sound as unused."""
    plate = load_scene("glass-plate").replace(*SCENES["glass-plate"])
    files = [
        export_motion(source, "gltf", tmp_path / name)
        for source, name in ((folder_of_run, "a.glb"), (plate, "b.gltf"))
    ]
    validator = "gltf-validator@2.0.0-dev.3.10"
    quiet = ["--ignore-scripts", "--no-audit", "--no-fund"]
    install = [shutil.which("npm"), "install", *quiet, validator]
    subprocess.run(install, cwd=tmp_path, check=True, timeout=300)
    (tmp_path / "validate.mjs").write_text(VALIDATE)
    command = ["node", "validate.mjs", *map(str, files)]
    told = subprocess.run(command, cwd=tmp_path, check=True, stdout=subprocess.PIPE)
    faults = [
        [one["code"] for one in report["issues"]["messages"]]
        for report in json.loads(told.stdout)
    ]
    assert faults == [["UNSUPPORTED_EXTENSION", "UNUSED_OBJECT"], []]


def read_exact_csv(path):
    """Return a table of numbers; pandas before 3 drops their last digits when it converts text."""
    table = pd.read_csv(path, dtype=str).map(float)
    return table.rename(columns=lambda name: name.partition(" [")[0])


@pytest.mark.parametrize("form", ["parquet", "csv"])
@pytest.mark.parametrize("rate", [None, 200.0])
def test_the_table_is_the_frame_of_the_motion(tmp_path, form, rate):
    scene = load_scene("published").replace(*SCENES["published"])
    motion = simulate(scene)
    path = export_motion(scene, form, tmp_path / f"motion.{form}", rate)
    found = pd.read_parquet(path) if form == "parquet" else read_exact_csv(path)
    found = found.set_index("t")
    expected = motion.to_frame(None if rate is None else found.index.to_numpy())
    assert list(found.columns) == list(expected.columns)
    assert np.array_equal(found.index, expected.index)
    assert found.to_numpy() == pytest.approx(expected.to_numpy(), rel=1e-14, abs=1e-300)
    if rate:
        assert np.array_equal(found.index[:-1], np.arange(600) / 200)


def test_every_column_has_the_unit_of_the_motion(tmp_path):
    """The header of a CSV file and the metadata of a Parquet file agree; the names in a Parquet
    file are those of the frame."""
    scene = load_scene("published").replace("numerics.time_limit=0.1")
    text = export_motion(scene, "csv", tmp_path / "motion.csv").read_text()
    header = text.splitlines()[0].split(",")
    assert header[:2] == ["t [s]", "precession [rad]"]
    assert header[-1] == "normal_force [N]"
    schema = pq.read_schema(
        export_motion(scene, "parquet", tmp_path / "motion.parquet")
    )
    columns = [f"{one.name} [{one.metadata[b'unit'].decode()}]" for one in schema]
    assert columns == header


def test_turns_that_a_frame_rate_cannot_show_are_stated(tmp_path):
    """By the sampling theorem, 10 frames per second show 5 turns; the last rate shows all."""
    scene = load_scene("published").replace("numerics.time_limit=1")
    motion = simulate(scene)
    turns = np.abs(precession_rate(motion.state)).max() / (2 * np.pi)
    line = aliasing_notice(motion, 10.0)
    assert line.startswith("10 frames per second show up to 5 turns per second")
    wanted = float(line.partition("--rate ")[2].split()[0])
    assert 2 * turns <= wanted < 2 * turns + 1
    assert aliasing_notice(motion, wanted) == ""
    asked = [
        "export",
        "motion",
        brief_file(tmp_path, 1),
        "--as",
        "gltf",
        "--rate",
        "10",
    ]
    out = ["--out", str(tmp_path / "disk.glb")]
    assert line in CliRunner().invoke(main, asked + out).stderr


def brief_file(folder, time_limit):
    """Write the published scene with a time limit [s], and return the path as text."""
    path = folder / "brief.toml"
    shipped = (SCENES_FOLDER / "published.toml").read_text("utf-8")
    path.write_text(f"{shipped}[numerics]\ntime_limit = {time_limit}\n", "utf-8")
    return str(path)


def test_the_command_writes_whole_files_and_names_them(tmp_path):
    scene = brief_file(tmp_path, 0.1)
    for form, suffix in (("gltf", "glb"), ("parquet", "parquet"), ("csv", "csv")):
        out = tmp_path / f"out.{suffix}"
        asked = ["export", "motion", scene, "--as", form, "--out", str(out)]
        told = CliRunner().invoke(main, asked)
        assert (told.exit_code, told.stdout.split()) == (0, [str(out)])
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [
        ".csv",
        ".glb",
        ".parquet",
        ".toml",
    ]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            "motion",
            "--as is missing: give the format of the motion, one of gltf, parquet, csv",
        ),
        (
            "motion --as vtu",
            "--as = 'vtu': motion can be exported as gltf, parquet, csv",
        ),
        ("modes --as gltf", "--as = 'gltf': modes can be exported as faust, uff, vtu"),
        ("modes --as vtu --rate 9", "--rate = 9.0: does not apply to modes"),
        ("motion --as csv --strike 9", "--strike = 9.0: does not apply to motion"),
        ("motion --as csv --rate 0", "--rate = 0: must be greater than 0"),
        ("motion --as csv --rate nan", "--rate = nan: must be greater than 0"),
        ("motion nowhere --as csv", "nowhere: no such scene"),
    ],
)
def test_wrong_arguments_are_one_line(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert_refused(["export", *arguments.split()], message)
    assert list(tmp_path.iterdir()) == []


def test_too_many_rows_are_refused(tmp_path):
    scene = load_scene("published").replace("numerics.time_limit=0.1")
    with pytest.raises(InputError, match="would produce more than 20000000 rows"):
        export_motion(scene, "csv", tmp_path / "no.csv", rate=1e9)
    assert list(tmp_path.iterdir()) == []
