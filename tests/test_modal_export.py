"""Claim: the exported files say what the modes say, to the programs they are for.

Source: universal file format, datasets 15 and 55; the Faust language. Oracles: pyuff reads back what was written; the
Faust compiler accepts the program; what it makes is compiled, run and compared with the closed form of the oscillators.
"""

import re
import shutil
import subprocess

import numpy as np
import pytest
from click.testing import CliRunner
from scipy.signal import lfilter

from modal import Material, Plate, as_faust, as_faust_library, plate_modes, write_uff
from sonify.__main__ import main
from sonify.export import export_modes
from sonify.scene import load_scene
from sonify.scene_errors import InputError

STEEL = Material(young=195e9, poisson=0.28, loss_factor=3e-4)


@pytest.fixture(scope="module")
def modes():
    return plate_modes(Plate(radius=0.03755, thickness=0.0128, material=STEEL, density=7737.27), 23e3)


def test_universal_file_keeps_shapes_and_frequencies(modes, tmp_path):
    pyuff = pytest.importorskip("pyuff", reason="the optional package pyuff is not installed")
    write_uff(modes, tmp_path / "modes.uff")
    sets = pyuff.UFF(str(tmp_path / "modes.uff")).read_sets()
    nodes, shapes = sets[0], sets[1:]
    assert np.stack([nodes["x"], nodes["y"], nodes["z"]], axis=1) == pytest.approx(modes.body.points, abs=1e-6)
    assert len(shapes) == len(modes)
    for one, f, u in zip(shapes, modes.frequency, modes.body.displacement, strict=True):
        assert one["freq"] == pytest.approx(f, rel=1e-5)
        read = np.stack([one["r1"], one["r2"], one["r3"]], axis=1)
        assert np.real(read) == pytest.approx(u, abs=1e-4 * np.abs(u).max())


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
  void addHorizontalSlider(const char*, FAUSTFLOAT*, double, double, double, double) {}
};
struct dsp { virtual ~dsp() {} };
<<includeIntrinsic>>
<<includeclass>>
int main() {
  static double force[400], velocity[400];
  std::fill(force + 1, force + 400, 1.0);
  double *in[] = {force}, *out[] = {velocity};
  mydsp disk;
  disk.init(48000);
  disk.compute(400, in, out);
  for (double v : velocity) std::printf("%.17g\\n", v);
}
"""
needs_faust = pytest.mark.skipif(not shutil.which("faust"), reason="the Faust compiler is not installed")


def compiled(folder, program, *options):
    """The answer of Faust, which translates a program in a folder to disk.cpp."""
    (folder / "disk.dsp").write_text(program)
    command = ["faust", *options, "disk.dsp", "-o", "disk.cpp"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return (folder / "disk.cpp").read_text()


def step_response(modes, gain=1.0, t60_scale=1.0, frequency_scale=1.0):
    """Velocity (400,) [m/s] at 48 kHz one sample after a force of 1 N sets in at the second one."""
    phi, t = modes.at_rim(0.0)[:, 0, 2], np.arange(399)[:, None] / 48e3
    damped = np.sqrt((2 * np.pi * modes.frequency) ** 2 - modes.decay_rate**2) * frequency_scale
    heard = phi**2 * (damped < np.pi * 48e3)
    exact = (heard / damped * np.exp(-modes.decay_rate / t60_scale * t) * np.sin(damped * t)).sum(axis=1)
    return gain * np.append(0.0, exact)


@needs_faust
def test_faust_program_compiles(modes, tmp_path):
    code = compiled(tmp_path, as_faust(modes))
    for label in ("gain", "t60 scale", "frequency scale"):
        assert f'"{label}"' in code


@needs_faust
@pytest.mark.skipif(not shutil.which("c++"), reason="there is no C++ compiler")
@pytest.mark.parametrize("scales", [(1.0, 1.0, 1.0), (2.0, 0.01, 1.3)])
def test_the_compiled_faust_library_gives_the_exact_step_response(modes, tmp_path, scales):
    """At 1.3 times their frequencies two of the five modes are beyond half the sample rate, and silent."""
    (tmp_path / "disk.lib").write_text(as_faust_library(modes))
    (tmp_path / "plain.cpp").write_text(PLAIN_CPP)
    compiled(tmp_path, f'process = library("disk.lib").disk{scales};', "-double", "-a", "plain.cpp")
    subprocess.run(["c++", "-O1", "disk.cpp", "-o", "disk"], cwd=tmp_path, check=True, capture_output=True)
    told = subprocess.run([tmp_path / "disk"], capture_output=True, text=True, check=True).stdout
    exact = step_response(modes, *scales)
    assert np.array(told.split(), float) == pytest.approx(exact, abs=1e-9 * np.abs(exact).max())


def test_faust_recursion_is_the_exact_step_response(modes):
    rows = [[float(x) for x in row.split(",")] for row in re.findall(r"mode\((\d[^)]*)\)", as_faust(modes))]
    assert len(rows) == len(modes)
    step, force = 1 / 48e3, np.append(0.0, np.ones(399))
    sounded = 0.0
    for w, d, g in rows:
        r = np.exp(-d * step)
        recursion = [1, -2 * r * np.cos(w * step), r * r]
        sounded = sounded + lfilter([0, g * r * np.sin(w * step)], recursion, np.diff(force, prepend=0))
    exact = step_response(modes)
    assert sounded == pytest.approx(exact, abs=1e-6 * np.abs(exact).max())


def test_a_disk_without_modes_is_not_written(modes):
    with pytest.raises(ValueError, match="no mode"):
        as_faust_library(plate_modes(Plate(radius=0.001, thickness=0.001, material=STEEL, density=7737.27), 23e3))


def test_an_overdamped_mode_is_not_written(modes):
    rate = 2 * np.pi * modes.frequency
    as_faust(modes.with_decay(0.99 * rate))
    for write in (as_faust, as_faust_library):
        with pytest.raises(ValueError, match=r"mode 3 of 16997\.7 Hz does not oscillate"):
            write(modes.with_decay(np.where(np.arange(len(modes)) == 2, rate, 1.0)))


def test_the_command_writes_a_whole_file_and_names_it(tmp_path):
    told = CliRunner().invoke(main, ["export", "modes", "--as", "faust", "--out", str(tmp_path / "disk.dsp")])
    assert (told.exit_code, told.stdout.split()) == (0, [str(tmp_path / "disk.dsp")])
    assert (tmp_path / "disk.dsp").read_text("utf-8").startswith('declare name "disk"')
    assert [file.name for file in tmp_path.iterdir()] == ["disk.dsp"]


def test_the_command_refuses_in_one_line_what_has_no_modes_and_writes_nothing(tmp_path):
    scene = load_scene("published").replace("disk.radius=2e-3", "disk.thickness=1e-3", "disk.mass=1e-4")
    with pytest.raises(InputError, match="no mode"):
        export_modes(scene.replace("support.kind=free"), "faust", tmp_path / "none.dsp")
    told = CliRunner().invoke(main, ["export", "modes", "nowhere", "--as", "vtu", "--out", str(tmp_path / "none.vtu")])
    assert (told.exit_code, len(told.stderr.splitlines())) == (2, 1)
    assert list(tmp_path.iterdir()) == []
