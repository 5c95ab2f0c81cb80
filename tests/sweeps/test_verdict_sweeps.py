"""Claim: a verdict sweep tells how often each claim holds, and on which range this depends.

Source: sonify/sweeps/verdict.py, sonify/sweeps/axes.py, sonify/claims/verdict.py. Oracles: made
tables with known shares and indices; scipy's Sobol' points; closed forms of the loss of contact.
"""

import numpy as np
import pyarrow as pa
import pytest
from scipy.stats import qmc
from verdict_ranges import verdict_ranges

from dynamics import plan_motion
from sonify import load_scene
from sonify.claims.shares import share_of
from sonify.claims.verdict import contact_breaks_before_end, simplest_scene
from sonify.plan.preflight import solve_motion
from sonify.scene_errors import InputError
from sonify.sweeps.axes import Samples, points_of
from sonify.sweeps.run_row import row_of
from sonify.sweeps.sweep import load_sweep, shipped_sweeps
from sonify.sweeps.verdict import first_order_indices, verdict_conclusion

VERDICTS = [name for name in shipped_sweeps() if name.startswith("verdict-")]
KEY = "friction.arm_rolling"


def test_points_are_drawn_again_from_narrower_and_wider_ranges():
    """A quarter of the same points, with distances from the middle times the width."""
    axes = {
        KEY: {"from": 1e-6, "to": 1e-4, "scale": "log"},
        "audio.distance": [0.3, 0.6],
    }
    points = points_of(axes, Samples(method="sobol", n=16, seed=3, widths=(0.5, 2.0)))
    share = qmc.Sobol(2, seed=np.random.default_rng(3)).random(16)
    assert points.count == 24
    drawn = np.array([points[run][KEY] for run in range(24)])
    column = [axis.keys[0] for axis in points.axes].index(KEY)
    middle = 2 * (share[:, column] - 0.5)
    assert np.log10(drawn[:16] / 1e-5) == pytest.approx(middle, abs=1e-12)
    assert np.log10(drawn[16:20] / 1e-5) == pytest.approx(middle[:4] / 2, abs=1e-12)
    assert np.log10(drawn[20:] / 1e-5) == pytest.approx(middle[:4] * 2, abs=1e-12)
    assert [points[run]["audio.distance"] for run in range(16, 24)] == [
        points[run]["audio.distance"] for run in range(4)
    ] * 2


def test_first_order_indices_are_those_of_a_known_function():
    """x + 2 y with uniform x, y, z has the indices 0.2, 0.8 and 0; the order of values counts."""
    draws = qmc.Sobol(3, seed=np.random.default_rng(1)).random(512)
    found = first_order_indices(["x", "y", "z"], np.exp(draws), draws @ [1.0, 2.0, 0.0])
    expected = {"x": 0.2, "y": 0.8, "z": 0.0}
    assert found[0].axis == "y"
    for index in found:
        assert index.value == pytest.approx(expected[index.axis], abs=0.06)
        assert index.resolved


def made_table(sweep, holds):
    columns = {key: [] for axis in sweep.points.axes for key in axis.keys}
    for run in range(sweep.points.count):
        for key, value in sweep.columns(run).items():
            columns.setdefault(key, []).append(value)
    count = sweep.points.count
    made = {
        "run": list(range(count)),
        "error": [None] * count,
        "outcome": ["SETTLED"] * count,
    }
    made |= {"t_end": [1.0] * count, "contact_breaks_before_end_holds": holds(columns)}
    return pa.table(made | columns)


def test_the_conclusion_has_shares_and_what_they_depend_on():
    """Contact is lost where the rolling arm exceeds the middle of its range."""
    sweep = load_sweep("verdict-paper-vacuum")
    table = made_table(sweep, lambda columns: [arm > 3e-5 for arm in columns[KEY]])
    first, *_ = verdict_conclusion(table, sweep)
    assert "50(4) % of 512 draws; depends most on friction.arm_rolling (0." in first
    assert "with all ranges halved 50(9) % of 128 draws" in first


def test_a_share_of_all_or_none_has_a_bound():
    sweep = load_sweep("verdict-paper-vacuum")
    table = made_table(sweep, lambda columns: [False] * sweep.points.count)
    assert "0 of 512 draws (at most 0.7%)" in verdict_conclusion(table, sweep)[0]


@pytest.mark.parametrize(
    ("count", "words"),
    [
        (1, "1 of 512 draws (0.0% to 1.1%)"),
        (3, "1(1) % of 512 draws"),
        (509, "99(1) % of 512 draws"),
        (511, "511 of 512 draws (98.9% to 100.0%)"),
    ],
)
def test_a_share_of_nearly_all_is_not_rounded_to_all(count, words):
    assert str(share_of(np.arange(512) < count)) == words


@pytest.mark.slow
@pytest.mark.parametrize("name", VERDICTS)
def test_every_range_of_a_verdict_has_a_source(name):
    sweep = load_sweep(name)
    assert set(sweep.sources) == set(sweep.axes)
    assert (sweep.samples.method, sweep.samples.n, sweep.samples.widths) == (
        "sobol",
        512,
        (0.5, 2),
    )
    assert sweep.stages == ("verdict",)
    listed = {given.keys for given, users in verdict_ranges().items() if name in users}
    assert listed == set(sweep.axes)


def test_an_axis_without_effect_is_one_line():
    document = {
        "name": "none",
        "axes": {"roughness.rms": [1e-8, 2e-8]},
        "find": ["t_end"],
    }
    with pytest.raises(InputError, match=r"axes.roughness.rms: no effect on the runs"):
        load_sweep(document)


@pytest.mark.slow
def test_a_rough_or_wavy_table_breaks_the_contact_as_predicted():
    """Waves do at 1.05 (n^2 - 1) amplitude/radius; a vibration proportional to the heights does
    where its rms exceeds 0.3 of the weight.
    """
    sets = ["numerics.accuracy=draft", "imperfection={order=3, amplitude=2e-5}"]
    scene = load_scene("granite").replace(*sets)
    motion = solve_motion(plan_motion(simplest_scene(scene))).rolling
    found = contact_breaks_before_end(scene, motion)
    end = motion.state[-1, 1]
    assert found.details["wavy"] == pytest.approx(
        1.05 * 8 * 2e-5 / 0.03755 / end, rel=1e-9
    )
    assert found.holds
    assert found.details["rough"] == 0.0  # 0.03 um excite 0.22 of the weight
    rougher = contact_breaks_before_end(scene.replace("roughness.rms=1e-7"), motion)
    assert rougher.details["rough"] > 1.0


def test_a_row_of_a_verdict_renders_no_sound():
    row = row_of(load_sweep("verdict-paper").scene_of(0), ("verdict",))
    assert row["error" if "error" in row else "outcome"] == "AIRBORNE"
    assert row["air_carries_disk_holds"]
    assert not any(name.startswith("seconds_sound") for name in row)
