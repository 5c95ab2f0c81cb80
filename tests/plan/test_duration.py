"""Claim: a run says at its start how long it will take, roughly.

Source: `sonify.plan.duration`. Oracle: measured CPU seconds of second runs of shipped scenes, and
bounds that follow from the time limit.
"""

import pytest
from scenes import smooth_toy

from sonify.console import Console
from sonify.plan.duration import RunCosts, predicted_run_seconds
from sonify.plan.motion import planned_scene
from sonify.scene import load_scene


def predicted(name, *changes):
    return predicted_run_seconds(
        *planned_scene(load_scene(name).replace(*changes), None)
    )


@pytest.mark.parametrize(
    ("scene", "measured"),
    [
        (load_scene("published"), 6.4),
        (load_scene("coin"), 10.6),
        (load_scene("glass"), 39.5),
        (smooth_toy(), 19.3),
    ],
)
def test_the_prediction_is_right_within_a_factor_of_two(scene, measured):
    found = predicted_run_seconds(*planned_scene(scene, None))
    assert measured / 2 <= found <= 2 * measured


def test_a_short_motion_takes_the_time_of_the_start_and_the_page():
    costs = RunCosts()
    short = predicted("published", "numerics.time_limit=0.1")
    assert short == pytest.approx(costs.start_and_page + 0.1 * costs.sound)


def test_a_motion_without_losses_takes_until_the_time_limit():
    arms = [f"friction.arm_{arm}=0" for arm in ("nutation", "rolling", "pivoting")]
    costs = RunCosts()
    endless = predicted("published", *arms, "numerics.time_limit=100")
    assert endless == pytest.approx(costs.start_and_page + 100 * costs.sound, rel=0.01)


def test_the_console_prints_the_prediction_on_standard_error(capsys):
    with Console() as stages:
        stages.expect(6.54)
        stages.expect(92.0)
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.splitlines() == [
        "takes about 7 s on two idle cores",
        "takes about 1.5 min on two idle cores",
    ]
