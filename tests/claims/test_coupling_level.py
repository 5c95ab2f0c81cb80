"""Claim: after a run, the level error of one-way coupling that the plan predicted is measured, by the
filter with and without the table.

Source: sonify/claims/coupling_level.py. Oracle: the filter in time against its spectrum, two
evaluations of the same equations that share no step.
"""

from dataclasses import replace

import pytest

from dynamics import simulate
from modal import surface_modes
from sonify import load_scene
from sonify.claims import coupling_level
from sonify.claims.coupling_level import coupling_error_is_predicted


@pytest.fixture(scope="module")
def on_mirror():
    scene = load_scene("toy").replace(
        "numerics.accuracy=draft", "numerics.time_limit=2.0"
    )
    return scene, simulate(scene, surface_modes=surface_modes(scene, 20e3))


def test_the_run_confirms_the_predicted_error(on_mirror):
    found = coupling_error_is_predicted(*on_mirror)
    assert found.verdict == "yes"
    assert found.details["predicted"] > 8
    assert found.details["measured"] == pytest.approx(
        found.details["predicted"], abs=3.0
    )


def test_a_force_without_its_table_refutes_the_prediction(on_mirror, monkeypatch):
    """The filter runs on a rigid table, as if the plan had not coupled it."""
    vibration = coupling_level.vibration

    def on_rigid_table(scene, motion, begin, end):
        rigid = replace(motion.plan, rough_table=None)
        return vibration(scene, replace(motion, plan=rigid), begin, end)

    monkeypatch.setattr(coupling_level, "vibration", on_rigid_table)
    found = coupling_error_is_predicted(*on_mirror)
    assert found.details["measured"] == 0.0
    assert found.verdict == "no"
