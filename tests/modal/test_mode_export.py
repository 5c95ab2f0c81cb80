"""Claim: the exported files carry the modes correctly to the programs that read them.

Source: universal file format, datasets 15, 55, 164 and 2412; the Faust language. Oracle: pyuff, which reads
the files back; the closed-form impulse response of an oscillator, with the numbers in the Faust
program; the same response from the program translated by the Faust compiler, compiled and run.
"""

import re
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest
import skfem
from click.testing import CliRunner

from modal import (
    Material,
    Plate,
    Support,
    as_faust,
    as_faust_library,
    eigenmodes,
    mesh_modes,
    plate_modes,
    write_uff,
)
from modal.export import UNIT_STRIKE_PEAK
from sonify.__main__ import main
from sonify.export.modes import export_modes
from sonify.plan.preflight import plan_with_modes
from sonify.runtime.json_values import write_json
from sonify.scene import load_scene, scene_record
from sonify.scene_errors import InputError

STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(
        Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=7737.27), 23e3
    )


def test_universal_file_keeps_shapes_and_frequencies(modes, tmp_path):
    pyuff = pytest.importorskip(
        "pyuff", reason="the optional package pyuff is not installed"
    )
    write_uff(modes, tmp_path / "modes.uff")
    units, nodes, _, *shapes = pyuff.UFF(str(tmp_path / "modes.uff")).read_sets()
    assert units["type"] == 164
    assert units["units_code"] == 1
    assert units["length"] == units["force"] == 1
    assert np.stack([nodes["x"], nodes["y"], nodes["z"]], axis=1) == pytest.approx(
        modes.body.points, abs=1e-6
    )
    assert len(shapes) == len(modes)
    for one, f, u in zip(shapes, modes.frequency, modes.body.displacement, strict=True):
        assert one["freq"] == pytest.approx(f, rel=1e-5)
        read = np.stack([one["r1"], one["r2"], one["r3"]], axis=1)
        assert np.real(read) == pytest.approx(u, abs=1e-4 * np.abs(u).max())


def cell_volumes(points, cells):
    """Return the volumes of cells of linear sides with the nodes (c, n) in VTK's order."""
    order = [6, 2, 5, 7, 1, 3, 4, 0] if cells.shape[1] == 8 else [0, 1, 2, 3]
    mesh_type = skfem.MeshHex if cells.shape[1] == 8 else skfem.MeshTet
    basis = skfem.CellBasis(mesh_type(points.T, cells[:, order].T), mesh_type.elem())
    return (np.sign(basis.mapping.detDF(basis.X)) * basis.dx).sum(axis=1)


def enclosed_volume(points, faces):
    """Return the volume within faces (f, n) numbered around their outward normals."""
    corners = points[faces]
    triangles = [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    return np.linalg.det(np.concatenate(triangles)).sum() / 6


@pytest.mark.parametrize(
    "cell_type", ["hexahedron27", "hexahedron", "tetra10", "tetra"]
)
def test_universal_file_has_elements_that_form_the_body(tmp_path, cell_type):
    """The disk of the spectral solution, and meshes of a cube of straight cells."""
    pyuff = pytest.importorskip(
        "pyuff", reason="the optional package pyuff is not installed"
    )
    if cell_type == "hexahedron27":
        plate = Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=7737.27)
        found = plate_modes(plate, 12e3, "draft")
        volume = 0.99 * np.pi * plate.radius**2 * plate.thickness
    else:
        cube = skfem.MeshTet() if cell_type.startswith("tetra") else skfem.MeshHex()
        cube = cube.refined(1).scaled(0.02)
        if cell_type == "tetra10":
            cube = skfem.MeshTet2.from_mesh(cube)
        cube.save(str(tmp_path / "cube.vtu"))
        free = Support(kind="free")
        found = mesh_modes(
            tmp_path / "cube.vtu", STEEL, 7737.27, free, 80e3, refine=False
        )
        volume = 0.02**3
        parts = {"tetra": "tetra10", "hexahedron": "hexahedron27"}
        body = found.body
        if cell_type in parts:
            corners = body.cells[:, : 4 if cell_type == "tetra" else 8]
            body = replace(body, cells=corners, cell_type=cell_type)
            found = replace(found, body=body)
    assert found.body.cell_type == cell_type
    write_uff(found, tmp_path / "modes.uff")
    elements = pyuff.UFF(str(tmp_path / "modes.uff")).read_sets()[2]
    solid, face = (111, 41) if cell_type.startswith("tetra") else (115, 44)
    labels = [one["element_nums"] for one in elements[solid] + elements[face]]
    assert len(set(labels)) == len(labels)
    solids, faces = (
        np.array([one["nodes_nums"] for one in elements[kind]]) - 1
        for kind in (solid, face)
    )
    points = found.body.points
    assert np.isin(np.unique(found.body.cells), solids).all()
    volumes = cell_volumes(points, solids)
    assert volumes.min() > 0
    assert volumes.sum() >= volume * (1 - 1e-9)
    assert enclosed_volume(points, faces) == pytest.approx(volumes.sum(), rel=1e-3)


PLAIN_CPP = """
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#ifndef FAUSTFLOAT
#define FAUSTFLOAT double
#endif
struct Meta { void declare(const char*, const char*) {} };
struct UI {
  void openVerticalBox(const char*) {} void closeBox() {} void declare(FAUSTFLOAT*, const char*, const char*) {}
  void addHorizontalSlider(const char*, FAUSTFLOAT* zone, double value, double, double, double) { *zone = value; }
  FAUSTFLOAT* button = nullptr;
  void addButton(const char*, FAUSTFLOAT* zone) { button = zone; }
};
struct dsp { virtual ~dsp() {} };
<<includeIntrinsic>>
<<includeclass>>
int main() {
  static double strike[4800], velocity[4800];
  double *in[] = {strike}, *out[] = {velocity};
  mydsp disk;
  disk.init(48000);
  UI controls;
  disk.buildUserInterface(&controls);
  if (controls.button) *controls.button = 1.0;
  else strike[0] = 1.0;
  disk.compute(4800, in, out);
  for (double v : velocity) std::printf("%.17g\\n", v);
}
"""
needs_faust = pytest.mark.skipif(
    not shutil.which("faust"), reason="the Faust compiler is not installed"
)
needs_compiler = pytest.mark.skipif(
    not shutil.which("c++"), reason="there is no C++ compiler"
)
SUPPORTS = {
    "patch": ("published", "support.kind=patch"),
    "free": ("published", "support.kind=free"),
    "contact": ("granite", "support.kind=contact"),
}


def struck(folder, library, scales=(1.0, 1.0, 1.0)):
    """Return the response (4800,) of a compiled library at 48 kHz to a unit sample."""
    (folder / "disk.lib").write_text(library)
    return sounded(folder, f'process = library("disk.lib").disk{scales};')


def sounded(folder, program):
    """Return the output (4800,) of a compiled program at 48 kHz after its button is pressed, or
    if it has none, to a unit sample."""
    (folder / "plain.cpp").write_text(PLAIN_CPP)
    (folder / "disk.dsp").write_text(program)
    for command in (
        ["faust", "-double", "-a", "plain.cpp", "disk.dsp", "-o", "disk.cpp"],
        ["c++", "-O1", "disk.cpp", "-o", "disk"],
    ):
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    printed = subprocess.run(
        [folder / "disk"], capture_output=True, text=True, check=True
    ).stdout
    return np.array(printed.split(), float)


def written(program):
    """Return the angular frequencies, decay rates and gains (3, m) in a Faust program."""
    rows = re.findall(r"mode\((\d[^)]*)\)", program)
    return np.array([[float(x) for x in row.split(",")] for row in rows]).T


def response(rate, decay, gain, scales=(1.0, 1.0, 1.0)):
    """Return the closed-form velocity (4800,) at 48 kHz of q'' + 2 d q' + w^2 q = 0.

    The initial conditions are q = 0 and q' = gain.
    """
    loudness, t60_scale, frequency_scale = scales
    v = rate * frequency_scale
    d = decay / t60_scale
    t = np.arange(4800)[:, None] / 48e3
    heard = gain * (v < np.pi * 48e3)
    return loudness * (
        heard * np.exp(-d * t) * (np.cos(v * t) - d / v * np.sin(v * t))
    ).sum(axis=1)


@pytest.fixture(scope="module", params=SUPPORTS)
def exported(request, tmp_path_factory):
    """Return the default Faust export of a disk on each support, and its modes."""
    name, kind = SUPPORTS[request.param]
    scene = load_scene(name).replace(kind, "numerics.accuracy=draft")
    path = export_modes(scene, "faust", tmp_path_factory.mktemp("faust") / "disk.dsp")
    return path.read_text("utf-8"), plan_with_modes(scene)[1]


def test_the_program_is_heard_wherever_the_disk_is_held(exported):
    """The numbers in the file give the peak after a unit strike; only modes with a share count."""
    program, modes = exported
    rate, decay, gain = written(program)
    peak = np.abs(response(rate, decay, gain)).max()
    assert 0.1 < peak < 1
    assert peak == pytest.approx(UNIT_STRIKE_PEAK, rel=1e-9)
    assert len(gain) == len(modes)
    assert np.count_nonzero(gain > 0.01) >= 2
    assert f'declare peak "{peak:g} after a unit strike' in program
    assert 'declare strike "axially at the bottom edge, 180 degrees' in program


def test_the_file_states_the_velocity_that_its_numbers_stand_for(exported):
    """At modal mass 1, an impulse of 1 N s gives the struck point the sum of squared shapes."""
    program, modes = exported
    mobility = np.square(modes.at_rim(np.pi)[:, 0, 2])
    assert written(program)[2] == pytest.approx(
        UNIT_STRIKE_PEAK * mobility / mobility.sum(), abs=1e-12
    )
    stated = float(re.search(r'declare scale "1.0 = (\S+) m/s', program)[1])
    assert stated * UNIT_STRIKE_PEAK == pytest.approx(mobility.sum(), rel=1e-5)


@needs_faust
@needs_compiler
def test_the_button_of_the_program_strikes_once(modes, tmp_path):
    """Pressing it is an input of one sample of 1."""
    program = as_faust(modes, 0.3)
    assert sounded(tmp_path, program) == pytest.approx(
        response(*written(program)), abs=1e-9
    )
    code = (tmp_path / "disk.cpp").read_text()
    for label in ("strike", "gain", "t60 scale", "frequency scale"):
        assert f'"{label}"' in code


@needs_faust
@needs_compiler
@pytest.mark.parametrize("scales", [(1.0, 1.0, 1.0), (2.0, 0.01, 1.3)])
def test_the_compiled_faust_library_is_the_exact_response(modes, tmp_path, scales):
    """At 1.3 times the frequencies, two of five modes exceed half the sample rate."""
    library = as_faust_library(modes, 0.3)
    expected = response(*written(library), scales)
    assert struck(tmp_path, library, scales) == pytest.approx(
        expected, abs=1e-9 * np.abs(expected).max()
    )


@pytest.mark.parametrize("strike", ["0", "-4.9", "365", "nan", "inf", "here"])
def test_a_strike_where_the_disk_cannot_move_is_refused_in_one_line(strike, tmp_path):
    path = tmp_path / "disk.dsp"
    asked = ["export", "modes", "--as", "faust", "--strike", strike, "--out", str(path)]
    answer = CliRunner().invoke(main, asked)
    assert (answer.exit_code, len(answer.stderr.splitlines())) == (2, 1)
    assert "--strike" in answer.stderr
    assert not path.exists()


def test_the_folder_of_a_run_is_a_scene(tmp_path):
    scene = load_scene("published").replace(
        "support.kind=free", "numerics.accuracy=draft"
    )
    write_json({"scene": scene_record(scene)}, tmp_path / "run.json")
    paths = [
        export_modes(source, "faust", tmp_path / f"{i}.dsp")
        for i, source in enumerate([scene, tmp_path])
    ]
    assert len({path.read_bytes() for path in paths}) == 1


def test_a_strike_near_the_patch_and_anywhere_on_a_free_disk_is_taken(tmp_path):
    free = load_scene("published").replace(
        "support.kind=free", "numerics.accuracy=draft"
    )
    for scene, angle in (("published", 20.0), (free, 0.0)):
        program = export_modes(
            scene, "faust", tmp_path / "disk.dsp", strike_deg=angle
        ).read_text("utf-8")
        assert f"{angle:g} degrees from the contact" in program
        assert np.abs(response(*written(program))).max() == pytest.approx(
            UNIT_STRIKE_PEAK, rel=1e-9
        )


def test_the_library_refuses_the_held_arc_itself():
    held = eigenmodes(
        load_scene("published").replace("numerics.accuracy=draft"), below=5e3
    )
    with pytest.raises(ValueError, match="strike at 0 degrees: the disk is held there"):
        as_faust_library(held, 0.0)


def test_only_faust_is_struck(tmp_path):
    with pytest.raises(InputError, match="--strike = 90"):
        export_modes("published", "vtu", tmp_path / "disk.vtu", strike_deg=90.0)


def test_an_overdamped_mode_is_not_written(modes):
    rate = 2 * np.pi * modes.frequency
    as_faust(modes.with_decay(0.99 * rate))
    for write in (as_faust, as_faust_library):
        with pytest.raises(
            ValueError, match=r"mode 3 of 16997\.7 Hz does not oscillate"
        ):
            write(modes.with_decay(np.where(np.arange(len(modes)) == 2, rate, 1.0)))


def test_the_command_writes_a_whole_file_and_names_it(tmp_path):
    told = CliRunner().invoke(
        main, ["export", "modes", "--as", "faust", "--out", str(tmp_path / "disk.dsp")]
    )
    assert (told.exit_code, told.stdout.split()) == (0, [str(tmp_path / "disk.dsp")])
    assert (tmp_path / "disk.dsp").read_text("utf-8").startswith('declare name "disk"')
    assert [file.name for file in tmp_path.iterdir()] == ["disk.dsp"]


def test_the_command_refuses_in_one_line_what_has_no_modes_and_writes_nothing(tmp_path):
    scene = load_scene("published").replace(
        "disk.radius=2e-3", "disk.thickness=1e-3", "disk.mass=1e-4"
    )
    with pytest.raises(InputError, match="no mode"):
        export_modes(scene.replace("support.kind=free"), "faust", tmp_path / "none.dsp")
    told = CliRunner().invoke(
        main,
        [
            "export",
            "modes",
            "nowhere",
            "--as",
            "vtu",
            "--out",
            str(tmp_path / "none.vtu"),
        ],
    )
    assert (told.exit_code, len(told.stderr.splitlines())) == (2, 1)
    assert list(tmp_path.iterdir()) == []
