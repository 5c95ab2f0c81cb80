"""Claim: every example runs unmodified and prints correct results.

Source: sonify/examples. Oracle: the energy balance; the spectral modes of the same disk; a built-in
law of the same power; the generated test tone; the order in which stronger friction ends the motion
earlier.
"""

from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest

from dynamics import Outcome, simulate
from dynamics.observables import slip_start_times
from modal import Plate, plate_modes
from sonify import examples, load_scene
from sonify.examples.sweep_table import SWEEP as SLIPS

TESTED = (
    "one_motion",
    "mode_table",
    "own_mesh",
    "own_recording",
    "own_dissipation",
    "many_scenes",
    "table_mesh",
    "sweep_table",
    "surfaces",
    "predictions",  # and the two below by tests/rigid/test_predictions.py
    "contact_circuit",
    "two_coins",
    "four_claims",  # by tests/claims/test_four_claims.py and tests/slow/test_shipped_scenes.py
)


def told(name, capsys):
    """Return the result of an example and the lines that it prints."""
    result = import_module(f"sonify.examples.{name}").main()
    return result, capsys.readouterr().out.splitlines()


def test_every_example_is_tested():
    assert {module.name for module in iter_modules(examples.__path__)} == set(TESTED)


def test_one_motion(capsys):
    motion, lines = told("one_motion", capsys)
    assert motion.rolling_outcome is Outcome.SETTLED
    assert lines[0].endswith(f"at {motion.t[-1]:.3f} s")
    total = motion.energy(motion.t) + motion.state[:, 10]
    assert np.ptp(total) < 1e-12 * total[0]


def test_a_table_of_modes(capsys):
    modes, lines = told("mode_table", capsys)
    assert len(lines) == 1 + len(modes)
    assert [float(line.split()[0]) for line in lines[1:]] == pytest.approx(
        modes.frequency, abs=0.05
    )
    assert lines[1].split()[2:] == ["2", "flexural"]


def test_a_mesh_of_ones_own(capsys):
    """The coarse mesh with a curved rim overestimates the frequencies by less than 2 %."""
    modes, _ = told("own_mesh", capsys)
    own = import_module("sonify.examples.own_mesh")
    disk = Plate(
        radius=0.03755, thickness=0.0128, material=own.STEEL, density=own.DENSITY
    )
    true = plate_modes(disk, 24000.0).frequency
    assert len(true) == len(modes)
    assert (0.999 * true < modes.frequency).all()
    assert (modes.frequency < 1.02 * true).all()


def test_a_recording_of_ones_own(capsys):
    heard, lines = told("own_recording", capsys)
    assert heard.tone.t_end.value == pytest.approx(4.0, abs=0.01)
    assert heard.tone.exponent.value == pytest.approx(1.0, abs=0.02)
    assert f"{heard.tone.t_end.value:.3f} s" in lines[0]


@pytest.mark.slow
def test_a_law_of_ones_own_is_the_built_in_one_of_its_power(capsys):
    motion, _ = told("own_dissipation", capsys)
    law = ("dissipation.power_coefficient=1e-9", "dissipation.power_exponent=3.0")
    same = simulate(load_scene("published").replace("numerics.accuracy=draft", *law))
    end = motion.rolling.t[-1]  # a law of one's own acts while the disk rolls
    assert end == pytest.approx(same.rolling.t[-1], rel=1e-9)
    t = np.linspace(0, 0.9 * end, 50)
    np.testing.assert_allclose(motion.at(t)[:, 1:3], same.at(t)[:, 1:3], rtol=1e-7)


@pytest.mark.slow
def test_a_loop_over_scenes(capsys):
    rows, lines = told("many_scenes", capsys)
    assert all(row["passed"] and row["outcome"] == "SETTLED" for row in rows)
    assert (np.diff([row["t_end"] for row in rows]) < 0).all()
    assert len(lines) == len(rows) == 3


@pytest.mark.slow
def test_a_sweep_as_a_table(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    table, lines = told("sweep_table", capsys)
    for row in table.to_dict("records"):
        own = [
            f"{key}={row[key]}"
            for key in ("friction.arm_rolling", "friction.mu_static")
        ]
        falling = load_scene("published").replace(
            "numerics.accuracy=draft", *SLIPS["set"], *own
        )
        assert row["repeated_slips"] == len(slip_start_times(simulate(falling)))
    assert (len(table), len(lines)) == (4, 4)
