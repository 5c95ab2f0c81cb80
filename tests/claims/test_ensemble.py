"""Claim: the chaotic last stretch is repeated from perturbed states, and shares have an interval.

Source: sonify/claims/ensemble.py, shares.py. Oracles: Wilson's closed form; the order statistics of
the values; a motion without chaos, whose repetitions agree.
"""

import json
from math import sqrt

import numpy as np
import pytest
from click.testing import CliRunner

from dynamics import plan_motion
from sonify import load_scene
from sonify.__main__ import main
from sonify.claims.ensemble import Quantity, repeat_final_part
from sonify.claims.shares import share_of
from sonify.claims.two_way import losses_above_flat
from sonify.plan.preflight import motion_plan_with_table, solve_motion


@pytest.mark.parametrize(("k", "n"), [(0, 16), (3, 16), (16, 16), (100, 512)])
def test_the_interval_is_wilsons(k, n):
    z = 1.959963984540054
    middle = (k + z**2 / 2) / (n + z**2)
    half = z / (n + z**2) * sqrt(k * (n - k) / n + z**2 / 4)
    share = share_of(np.arange(n) < k)
    assert (share.low, share.high) == pytest.approx(
        (middle - half, middle + half), abs=1e-12
    )
    assert share.draw_count_text.startswith(f"{k} of {n} (")


def test_a_quantity_has_a_median_and_a_full_range():
    found = Quantity(name="end", unit="s", values=np.array([3.0, 1.0, np.nan, 2.0]))
    assert found.summary["median"] == 2.0
    assert str(found) == "end: 2 (1 to 3) s, in 3 of 4"


@pytest.mark.slow
def test_the_command_repeats_a_motion_and_prints_shares(tmp_path):
    """Over 0.3 s nothing is chaotic: the repetitions end at the time limit without a loss."""
    sets = ["numerics.time_limit=0.3", "numerics.accuracy=draft"]
    options = ["published", "--out", str(tmp_path), "--ensemble", "3", "--set", *sets]
    asked = CliRunner().invoke(main, ["run", *options])
    assert "end of the motion: 0.3 (0.3 to 0.3) s" in asked.stdout
    assert "contact is lost: 0 of 3 (0% to 56%)" in asked.stdout
    stored = json.loads((tmp_path / "ensemble.json").read_text("utf-8"))
    assert stored["claims"]["contact is lost"]["draws"] == 3


@pytest.mark.slow
def test_perturbed_motions_on_a_light_plate_end_alike():
    """No motion loses contact, and the ends differ by 0.4 %."""
    scene = load_scene("light-plate")
    plan = motion_plan_with_table(scene, plan_motion(scene))
    motion = solve_motion(plan)
    found = repeat_final_part(scene, motion, 2)
    assert losses_above_flat(motion) == 0
    assert not found.claims["contact is lost"].any()
    assert np.ptp(found.quantities[0].values) < 0.02 * motion.t[-1]
