"""Claim: each stage of a run completes once, and an error in a stage that runs at the same time as
others is raised where its result is needed.

Source: the docstrings of `sonify.pipeline.solve` and `write`. Oracle: errors raised on purpose in
each of these stages, and the order of the callbacks.
"""

import pytest

from modal import eigenmodes
from sonify import load_scene, pipeline, solve, write
from sonify.hearing.recording import listen
from sonify.report import pictures
from sonify.runtime.progress import Stages

BRIEF = load_scene("published").replace(
    "numerics.time_limit=0.05", "numerics.accuracy=draft", "name=brief"
)


class FailingStageError(Exception):
    """Raised on purpose in one stage."""


def fail(*_, **__):
    raise FailingStageError


@pytest.fixture(scope="module")
def solved():
    """Return the result of a brief run and the stages that were reported as complete."""
    begun = []
    result = solve(BRIEF, begin=begun.append)
    return result, begun


def test_each_stage_that_pictures_need_begins_once_with_all_it_needs(solved):
    result, begun = solved
    assert [found.completed_stage for found in begun] == ["motion", "sound"]
    assert all(found.motion is result.motion for found in begun)
    assert all(found.modes is result.modes for found in begun)
    assert begun[1].sound is result.sound
    assert result.motion.plan.scene is result.scene


def test_modes_that_cannot_be_solved_stop_the_motion():
    """The motion of 600 s without losses would take much longer than the test."""
    endless = load_scene("published").replace(
        "numerics.accuracy=draft",
        *(f"friction.arm_{arm}=0" for arm in ("nutation", "rolling", "pivoting")),
    )
    begun = []
    with pytest.raises(FailingStageError):
        solve(endless, eigenmodes=fail, begin=begun.append)
    assert begun == []


@pytest.mark.parametrize(
    ("stage", "begins"),
    [("two_way_findings", ["motion", "sound"]), ("render_sound", ["motion"])],
)
def test_an_error_after_the_motion_is_raised(monkeypatch, stage, begins):
    monkeypatch.setattr(pipeline, stage, fail)
    begun = []
    with pytest.raises(FailingStageError):
        solve(BRIEF, begin=begun.append)
    assert [found.completed_stage for found in begun] == begins


def test_an_error_in_the_analysis_of_the_sound_is_raised():
    with pytest.raises(FailingStageError):
        solve(BRIEF, listen=fail)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("place", "name"),
    [
        (pipeline, "run_record"),
        (pipeline, "page_content"),
        (pictures, "encode_motion"),
        (pictures, "encode_sounds"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_an_error_in_the_preparation_of_a_file_is_raised(
    solved, tmp_path, monkeypatch, place, name
):
    monkeypatch.setattr(place, name, fail)
    if place is pictures:
        stage = {"encode_motion": "motion", "encode_sounds": "sound"}[name]
        monkeypatch.setitem(pictures.PAGE_PARTS, stage, fail)
    with pytest.raises(FailingStageError):
        write(solved[0], tmp_path)
    assert not (tmp_path / "report.html").exists()


def test_the_given_executor_runs_every_simultaneous_stage():
    """An executor that runs tasks at once, in the calling thread, gives the same sound."""
    ran = []

    class AtOnce(pipeline.Executor):
        def submit(self, task, /, *arguments):
            ran.append(task.__name__)
            done = pipeline.Future()
            done.set_result(task(*arguments))
            return done

    alone = solve(BRIEF, executor=AtOnce(), eigenmodes=eigenmodes, listen=listen)
    assert ran == ["modes_stage", "two_way_stage", "analyse_sound"]
    assert alone.sound.peak == solve(BRIEF).sound.peak


def test_the_sound_exists_before_it_is_analysed(tmp_path, monkeypatch):
    """An error in the findings leaves the sound, and no page on an earlier one."""
    (tmp_path / "report.html").write_text("earlier")
    written = []

    class Told(Stages):
        def sound_written(self, path):
            written.append((path, path.stat().st_size))

    monkeypatch.setattr(pipeline, "findings_stage", fail)
    scene, motion_plan = pipeline.solvable_scene(BRIEF, None)
    with pytest.raises(FailingStageError):
        pipeline.run(scene, motion_plan, tmp_path, Told(), "compressed")
    ((path, size),) = written
    assert path == tmp_path / "sound.wav"
    assert path.stat().st_size == size > 1000
    assert not (tmp_path / "report.html").exists()


def test_every_stage_is_timed_once():
    class Counted(Stages):
        def __init__(self):
            super().__init__()
            self.begun = []

        def stage(self, name):
            self.begun.append(name)
            return super().stage(name)

    stages = Counted()
    solve(BRIEF, stages=stages)
    assert sorted(stages.begun) == ["findings", "modes", "motion", "sound"]
    assert set(stages.seconds) == set(stages.begun)
