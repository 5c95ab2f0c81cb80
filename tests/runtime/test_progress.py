"""Claim: the percentage of a running stage equals the completed share and stays below 100 % until
the end.

Source: the README's command line. Oracle: the duration of motions solved to their end; arithmetic.
"""

import numpy as np
import pytest
from law_scenes import named_scene

from dynamics import plan_motion
from dynamics.progress import MotionProgress
from modal import eigenmodes
from modal.progress import progress_range, progress_reported_to, report_progress
from sonify import load_scene
from sonify.console import Console
from sonify.plan.preflight import solve_motion
from sonify.runtime.progress import StageProgress


def shares(scene, motion, times):
    progress = MotionProgress(plan_motion(scene))
    inclinations = motion.at(times)[:, 1]
    return [
        progress.solved_fraction(*place)
        for place in zip(times, inclinations, strict=True)
    ]


@pytest.mark.parametrize("name", ["published", "thorne", "moffatt"])
def test_the_share_of_a_motion_is_that_of_its_duration(name):
    """The scenes cover friction alone, an air film and another law; the initial transient is not
    predicted."""
    scene = named_scene(name).replace("numerics.accuracy=draft")
    motion = solve_motion(plan_motion(scene))
    true = np.linspace(0, 1, 201)[:-1]
    told = np.array(shares(scene, motion, true * motion.t[-1]))
    assert (np.diff(told) >= 0).all()
    assert told.max() < 1
    assert np.abs(told - true).max() < 0.17
    assert np.abs(told - true)[true > 0.8].max() < 0.03
    assert (told - true).max() < 0.02


def test_a_motion_without_loss_ends_at_its_time_limit():
    friction = "friction={mu_static=inf, mu_dynamic=inf}"
    scene = load_scene("published").replace(
        friction, "numerics.time_limit=4", "air.film=none"
    )
    progress = MotionProgress(plan_motion(scene))
    assert [progress.solved_fraction(t, 0.4) for t in (1.0, 3.0, 2.0, 4.0)] == [
        0.25,
        0.75,
        0.75,
        0.999,
    ]


def test_a_disk_too_steep_for_a_steady_motion_has_its_time_limit():
    scene = load_scene("published").replace("numerics.time_limit=8", "air.film=none")
    assert MotionProgress(plan_motion(scene)).solved_fraction(2.0, 1.5) == 0.25


def test_impacts_reduce_the_inclination_of_a_rattling_disk_at_a_constant_rate():
    progress = MotionProgress(plan_motion(load_scene("coin")))
    release = np.radians(33.0)
    shares = [
        progress.solved_fraction(t, s * release) for t, s in ((0.4, 0.75), (0.5, 0.8))
    ]
    assert shares == pytest.approx([0.25, 0.25])


@pytest.mark.parametrize("support", ["patch", "free"])
def test_modes_report_every_step_up_to_the_last(scene, support):
    told = []
    with progress_reported_to(told.append):
        eigenmodes(
            scene.replace(f"support={{kind='{support}'}}", "numerics.accuracy=draft")
        )
    assert told[-1] == pytest.approx(1)
    assert len({round(share, 2) for share in told}) >= 5
    assert (np.diff(told) >= 0).all()


def test_a_portion_of_the_work_counts_as_that():
    told = []
    with progress_reported_to(told.append):
        with progress_range(0.5, 1.0), progress_range(0.0, 0.5):
            report_progress(0.5)
        report_progress(1.0)
    assert told == [0.625, 0.75, 1.0, 1.0]


def test_the_time_left_follows_from_the_speed_of_the_last_half_minute():
    stage = StageProgress("motion", 100.0)
    assert stage.line(112.0) == "motion for 12 s"
    stage.report(100.0, 0.0)
    assert stage.line(101.0) == "motion 0 %"
    stage.report(102.0, 0.05)
    assert stage.line(102.0) == "motion 5 %"
    stage.report(110.0, 0.25, "t = 1 s")
    assert stage.line(110.0) == "motion 25 %, about 30 s left, t = 1 s"
    for second in range(111, 171):  # a sixth of a percent per second from now on
        stage.report(second, 0.25 + (second - 110) / 600)
    assert stage.line(170.0) == "motion 35 %, about 6.5 min left"
    stage.report(171.0, 0.2)
    stage.report(172.0, 1.0, "waiting for the modes")
    assert stage.line(172.0) == "motion 99 %, waiting for the modes"


@pytest.mark.parametrize("work", [20.0, 300.0])
@pytest.mark.parametrize("compilation", [10.0, 120.0])
@pytest.mark.parametrize("interrupted", [None, 0.4])
def test_compilation_does_not_count_as_work(work, compilation, interrupted):
    """Equal steps take `work` seconds in sum; before the first one, and once more on the way, a
    compilation does nothing. The exact remaining time of the work is the oracle."""
    stage = StageProgress("motion", 0.0)
    stage.report(0.0, 0.0, "loading or compiling the equations")
    now = compilation
    steps = 400
    for step in range(1, steps):
        if interrupted == step / steps:
            now += compilation
        now += work / steps
        stage.report(now, step / steps)
        if now - compilation > 1.0:
            exact = work * (1 - step / steps)
            assert stage.remaining() == pytest.approx(exact, rel=0.05)


def test_frequent_reports_are_kept_for_half_a_minute_only():
    stage = StageProgress("motion", 0.0)
    for k in range(1, 100_001):
        stage.report(k / 1000, k / 200_000)
    assert stage.remaining() == pytest.approx(100.0, rel=1e-6)
    assert len(stage._intervals) <= 151


def test_outside_a_terminal_updates_print_no_line_each(capsys):
    with Console(interval=1e6) as stages, stages.stage("motion") as watch:
        for k in range(1000):
            watch(k / 1000)
        assert stages.progress_line().startswith("motion 99 %")
    written = capsys.readouterr()
    assert written.out == ""
    assert [line.split()[0] for line in written.err.splitlines()] == ["motion"]


def test_outside_a_terminal_one_line_at_a_time_tells_all_stages(capsys):
    with (
        Console(interval=0.01) as stages,
        stages.stage("motion") as watch,
        stages.stage("modes"),
    ):
        watch(0.5, "half")
        written = ""
        while "\n" not in written:
            written += capsys.readouterr().err
    assert written.splitlines()[0].startswith("motion 50 %, half; modes")
