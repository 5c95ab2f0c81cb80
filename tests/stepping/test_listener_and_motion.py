"""Claim: the listener has no effect on the motion.

The motion uses all modes of the table below 20 kHz, whatever the keys of [audio]; the
selection by audibility is for the sound alone.

Source: sonify/plan/table.py. Oracle: the identity of the modes handed to the motion, and
the bytes of motions that differ only in [audio].
"""

from dataclasses import fields

import numpy as np
import pytest

from dynamics import plan_motion
from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from modal.tabletop.solve import table_modes_listed_in_scene
from sonify import load_scene, solve
from sonify.plan import table as table_plan
from sonify.plan.plan import plan_of
from sonify.plan.preflight import motion_plan_with_table, solve_motion
from sonify.plan.table import with_table
from sonify.scene import Audio, shipped_scenes

OTHER_LISTENERS = {
    "sample_rate": "audio.sample_rate=8000",
    "distance": "audio.distance=3.0",
    "elevation_deg": "audio.elevation_deg=80.0",
    "listeners": "audio.listeners=[{distance=1.0, elevation_deg=10.0, azimuth_deg=70.0}]",
}
"""Another value of each key of [audio]."""
PAIR_AND_SINGLE = (
    "surface={kind='modes', modes=["
    "{order=0, frequency=900.0, damping_ratio=0.02, modal_mass=1.0},"
    "{order=3, frequency=1200.0, damping_ratio=0.02, modal_mass=1e4},"
    "{order=2, frequency=9000.0, damping_ratio=0.02, modal_mass=2.0}]}"
)
MOVING_TABLES = [
    name
    for name in shipped_scenes()
    if plan_motion(load_scene(name)).lacks_surface_modes
]


def solved_motion(scene):
    """Return the motion of a scene, as in a run."""
    return solve_motion(motion_plan_with_table(scene, plan_motion(scene)))


def bytes_of(motion):
    """Return the bytes of times, states and forces of a motion."""
    return b"".join(
        part.tobytes() for part in (motion.t, motion.state, motion.force(motion.t))
    )


def test_every_key_of_the_listener_is_varied():
    assert set(OTHER_LISTENERS) == {field.name for field in fields(Audio)}
    assert {"glass-plate", "light-plate", "wood-table"} <= set(MOVING_TABLES)


@pytest.mark.slow
@pytest.mark.parametrize("name", MOVING_TABLES)
def test_no_listener_changes_the_modes_that_move_the_disk(name, monkeypatch):
    """The solver of the modes is asked for the same modes, and the motion gets them all."""
    scene = load_scene(name)
    numbers = scene.replace(PAIR_AND_SINGLE)
    known = table_modes_listed_in_scene(numbers.surface, scene.disk, 20e3)
    limits = []

    def modes_below(asked, below):
        limits.append((asked.surface, asked.disk, asked.numerics, below))
        return known

    monkeypatch.setattr(table_plan, "surface_modes", modes_below)
    sounding = []
    for change in ["audio.distance=0.5", *OTHER_LISTENERS.values()]:
        varied = scene.replace(change)
        motion = motion_plan_with_table(varied, plan_motion(varied))
        assert motion.surface_modes is known
        plan = with_table(plan_of(varied, motion), varied, known)
        sounding.append(plan.sounding_table)
    usual = scene.surface, scene.disk, scene.numerics, MAX_AUDIBLE_FREQUENCY
    assert limits == [usual] * len(limits)
    assert len(set(sounding)) > 1  # the selection for the sound does depend on them


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(set(shipped_scenes()) - set(MOVING_TABLES)))
def test_no_listener_changes_any_other_motion(name):
    """The first 20 ms are compared, in which every part of the motion reads the scene."""
    short = "numerics.accuracy=draft", "numerics.time_limit=0.02"
    usual, other = (
        bytes_of(solved_motion(load_scene(name).replace(*change)))
        for change in (short, (*short, *OTHER_LISTENERS.values()))
    )
    assert usual == other


@pytest.mark.slow
def test_a_run_moves_as_without_its_listener():
    """One member of most pairs is inaudible; the motion of a run uses both."""
    scene = load_scene("light-plate").replace(
        "numerics.accuracy=draft", "numerics.time_limit=0.5"
    )
    one, other = (
        solve(scene.replace(change))
        for change in ("audio.elevation_deg=45.0", "audio.elevation_deg=80.0")
    )
    assert bytes_of(one.motion) == bytes_of(other.motion)
    assert one.plan.sounding_table != other.plan.sounding_table
    order, counts = np.unique(one.table.order, return_counts=True)
    assert (counts[order > 0] % 2 == 0).all()
    assert len(one.plan.sounding_table) < len(one.table)
