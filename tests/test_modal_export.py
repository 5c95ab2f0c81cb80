"""Claim: the exported files say what the modes say, to the programs they are for.

Source: universal file format, datasets 15 and 55; the Faust language. Oracles: pyuff reads back what was written; the
Faust compiler accepts the program; its recursion is compared with the closed form of a damped oscillator.
"""

import re
import shutil
import subprocess

import numpy as np
import pytest
from scipy.signal import lfilter

from modal import Material, Plate, as_faust, plate_modes, write_uff

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


def test_faust_program_compiles(modes, tmp_path):
    if not shutil.which("faust"):
        pytest.skip("the Faust compiler is not installed")
    (tmp_path / "disk.dsp").write_text(as_faust(modes))
    done = subprocess.run(["faust", str(tmp_path / "disk.dsp"), "-o", str(tmp_path / "disk.cpp")], capture_output=True)
    assert done.returncode == 0, done.stderr.decode()
    assert (tmp_path / "disk.cpp").stat().st_size > 1000


def test_faust_recursion_is_the_exact_step_response(modes):
    rows = [[float(x) for x in row.split(",")] for row in re.findall(r"mode\((\d[^)]*)\)", as_faust(modes))]
    assert len(rows) == len(modes)
    time, step = np.arange(400) / 48e3, 1 / 48e3
    force = np.append(0.0, np.ones(399))
    sounded = 0.0
    for w, d, g in rows:
        r = np.exp(-d * step)
        recursion = [1, -2 * r * np.cos(w * step), r * r]
        sounded = sounded + lfilter([0, g * r * np.sin(w * step)], recursion, np.diff(force, prepend=0))
    phi, rate, t = modes.at_rim(0.0)[:, 0, 2], 2 * np.pi * modes.frequency, time[:-1, None]
    damped = np.sqrt(rate**2 - modes.decay_rate**2)
    exact = (phi**2 / damped * np.exp(-modes.decay_rate * t) * np.sin(damped * t)).sum(axis=1)
    assert sounded[1:] == pytest.approx(exact, abs=1e-6 * np.abs(exact).max())
