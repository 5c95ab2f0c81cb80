"""Claim: a sweep runs each point of its file once, and its table contains the `summary` of every
run.

Source: the README's `sweep`; numpy and scipy.stats for the points. Oracle: `solve` and `simulate`
of the same scenes; counts; real processes, truncated files, a file system that refuses to write.
"""

import re
from math import inf
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import tomli_w
from click.testing import CliRunner
from full_disk import files_of_at_most
from paths import ROOT
from scipy.stats import qmc
from sweep_files import QUICK, found

import sonify
from dynamics import simulate
from sonify import load_scene, pipeline, solve, summary
from sonify.__main__ import main
from sonify.runtime.files import OutputError
from sonify.runtime.progress import Stages, duration_in_words
from sonify.runtime.signals import AbortedError
from sonify.scene_errors import InputError
from sonify.sweeps import command, required_stages, run_row
from sonify.sweeps.axes import Samples, points_of
from sonify.sweeps.command import RunTime, plan, run_time, summarize
from sonify.sweeps.conclusions import CONCLUSIONS
from sonify.sweeps.row_processes import RowProcess, solve_isolated
from sonify.sweeps.store import RUNS_FILE, RunStore, read_table
from sonify.sweeps.sweep import load_sweep, shipped_sweeps
from sonify.sweeps.version import version

AXIS = "friction.mu_static"


def values(key, axes, samples=None):
    points = points_of(axes, samples)
    return [points[run][key] for run in range(points.count)]


def test_ranges_and_lists_make_a_grid():
    linear = values(AXIS, {AXIS: {"from": 0.1, "to": 0.7, "n": 7}})
    assert linear == pytest.approx(np.linspace(0.1, 0.7, 7), rel=1e-15)
    log = values(AXIS, {AXIS: {"from": 1e-5, "to": 1e-1, "n": 5, "scale": "log"}})
    assert log == pytest.approx(np.geomspace(1e-5, 1e-1, 5), rel=1e-14)
    assert (log[0], log[-1]) == (1e-5, 1e-1)
    grid = points_of({"a.x": [1, 2], "a.y": [inf, "rigid"]}, None)
    assert [tuple(grid[k].values()) for k in range(grid.count)] == [
        (1, inf),
        (1, "rigid"),
        (2, inf),
        (2, "rigid"),
    ]
    assert values(
        "roughness.seed", {"roughness.seed": {"from": 1, "to": 9, "n": 5}}
    ) == [
        1,
        3,
        5,
        7,
        9,
    ]
    assert all(
        isinstance(v, int) for v in values("a.n", {"a.n": {"from": 1, "to": 9, "n": 5}})
    )


def test_paired_keys_move_together():
    pair = {
        "a.x, a.y": {"from": [1.0, 10.0], "to": [2.0, 1000.0], "n": 3, "scale": "log"}
    }
    points = points_of(pair, None)
    assert [points[k]["a.y"] for k in range(3)] == pytest.approx([10, 100, 1000])
    assert points.count == 3
    both = points_of({"a.x, a.y": [0.5, [0.5, 0.3]]}, None)
    assert [both[k] for k in range(2)] == [
        {"a.x": 0.5, "a.y": 0.5},
        {"a.x": 0.5, "a.y": 0.3},
    ]


@pytest.mark.parametrize("method", ["latin", "sobol"])
def test_samples_are_those_of_scipy_and_of_their_seed(method):
    axes = {"a.x": {"from": 1.0, "to": 100.0, "scale": "log"}, "a.y": ["one", "two"]}
    drawn = values("a.x", axes, Samples(method=method, n=64, seed=3))
    assert drawn == values("a.x", axes, Samples(method=method, n=64, seed=3))
    assert drawn != values("a.x", axes, Samples(method=method, n=64, seed=4))
    if method == "latin":  # one point in each of 64 bins of the logarithm
        assert sorted((np.log(drawn) / np.log(100) * 64).astype(int)) == list(range(64))
    names = values("a.y", axes, Samples(method=method, n=64, seed=3))
    assert names.count("one") == 32
    share = qmc.Sobol(2, seed=np.random.default_rng(3)).random(64)
    assert method == "latin" or drawn == pytest.approx(100 ** share[:, 0])


WRONG = {
    "no axis": ({"axes": {}}, "axes: missing"),
    "an unknown key": (
        {"axes": {"friction.mu": [0.1]}},
        "friction.mu: unknown key; known: mu_static",
    ),
    "an unknown section": ({"axes": {"frictions.mu": [0.1]}}, "frictions: unknown key"),
    "no such place": (
        {"axes": {"release.omega.7": [0.1]}},
        "release.omega.7: the scene has no such key",
    ),
    "a value out of range": ({"axes": {AXIS: [0.5, -1.0]}}, "mu_static = -1.0"),
    "no possible value": (
        {"axes": {"friction.mu_dynamic": [0.6, 0.9]}},
        "mu_dynamic = 0.6 must not",
    ),
    "an end out of range": (
        {"axes": {"disk.radius": {"from": 0.01, "to": 1e9, "n": 2}}},
        "disk.radius",
    ),
    "an empty list": ({"axes": {AXIS: []}}, "must have at least one value"),
    "an empty range": ({"axes": {AXIS: {"from": 0.1, "to": 0.5, "n": 0}}}, "n = 0"),
    "a reversed range": (
        {"axes": {AXIS: {"from": 0.5, "to": 0.1, "n": 3}}},
        "from = 0.5 must be less than to = 0.1",
    ),
    "a range of nothing": (
        {"axes": {AXIS: {"from": 0.5, "to": 0.5, "n": 3}}},
        "must be less than",
    ),
    "log of zero": (
        {"axes": {AXIS: {"from": 0.0, "to": 0.1, "n": 3, "scale": "log"}}},
        "greater than 0",
    ),
    "another scale": (
        {"axes": {AXIS: {"from": 0.1, "to": 0.2, "n": 3, "scale": "cube"}}},
        "'linear' or 'log'",
    ),
    "a word too many": (
        {"axes": {AXIS: {"from": 0.1, "to": 0.2, "n": 3, "by": 1}}},
        "by: unknown key",
    ),
    "no end": ({"axes": {AXIS: {"from": 0.1, "n": 3}}}, "to: missing"),
    "text as an end": (
        {"axes": {AXIS: {"from": "a", "to": 0.2, "n": 3}}},
        "must be finite numbers",
    ),
    "infinity as an end": (
        {"axes": {AXIS: {"from": 0.3, "to": inf, "n": 3}}},
        "must be finite numbers",
    ),
    "no list": ({"axes": {AXIS: 0.3}}, "must be a list of values"),
    "twice": (
        {"axes": {AXIS: [0.5], f"{AXIS}, friction.mu_dynamic": [0.5]}},
        "varies on more than one axis",
    ),
    "a pair of three": (
        {"axes": {f"{AXIS}, friction.mu_dynamic": [[0.5, 0.4, 0.3]]}},
        "must have 2 values",
    ),
    "too many": (
        {"axes": {AXIS: {"from": 0.3, "to": 0.4, "n": 10**12}}},
        "divide the sweep into several",
    ),
    "an unknown question": (
        {"find": ["loudness"]},
        "find = 'loudness': unknown quantity; known: outcome, t_end",
    ),
    "an unknown file": (
        {"keep": ["everything"]},
        "keep.0 = 'everything': must be 'arrays', 'wav' or 'page'",
    ),
    "another key": ({"repeat": 3}, "repeat: unknown key; known: name, scene"),
    "no time": ({"limit": 0.0}, "limit = 0.0: must be greater than 0"),
    "an odd Sobol": ({"samples": {"method": "sobol", "n": 100}}, "as 64 or 128"),
    "another method": (
        {"samples": {"method": "random", "n": 100}},
        "must be 'latin' or 'sobol'",
    ),
    "no such scene": ({"scene": "nowhere"}, "nowhere: no such scene"),
}


@pytest.mark.parametrize(("change", "told"), WRONG.values(), ids=WRONG)
def test_a_wrong_sweep_is_one_line_and_nothing_is_written(change, told, tmp_path):
    with pytest.raises(InputError) as refused:
        sonify.sweep(QUICK | change, out=tmp_path / "out")
    assert told in str(refused.value)
    assert "\n" not in str(refused.value)
    assert not (tmp_path / "out").exists()


def test_a_wrong_file_is_one_line(tmp_path):
    (tmp_path / "half.toml").write_text("name = ")
    for name in ("half.toml", "none.toml"):
        asked = CliRunner().invoke(main, ["sweep", str(tmp_path / name)])
        assert (asked.exit_code, len(asked.stderr.splitlines())) == (2, 1)
    assert "or one of: " in CliRunner().invoke(main, ["sweep", "nowhere"]).stderr


@pytest.mark.slow
def test_every_shipped_sweep_is_right():
    assert shipped_sweeps()
    for name in shipped_sweeps():
        assert load_sweep(name).name == name


def test_more_than_a_million_runs_are_asked_for_with_their_hours(tmp_path, monkeypatch):
    monkeypatch.setattr(
        command,
        "run_time",
        lambda *_: RunTime(first_run=20.0, later_run=3.6, measured=4),
    )
    many = QUICK | {"axes": {AXIS: {"from": 0.31, "to": 0.6, "n": 2_000_000}}}
    with pytest.raises(
        InputError, match="2000000 runs, about 42 days on this machine: add --yes"
    ):
        sonify.sweep(many, out=tmp_path, processes=2)


def test_the_time_of_a_sweep_counts_the_first_run_of_every_process():
    """Each process incurs the cost of a first run; the expected totals are computed by hand."""
    time = RunTime(first_run=17.0, later_run=0.5, measured=4)
    assert [time.total(runs, 2) for runs in (1, 2, 3, 100)] == [
        17.0,
        17.0,
        17.5,
        17.0 + 49 * 0.5,
    ]


UNITS = [
    (0.785, "0.79 s"),
    (13.1, "13 s"),
    (75.0, "75 s"),
    (720.0, "12 min"),
    (12240.0, "3.4 h"),
]
UNITS += [(3e5, "3.5 days")]


@pytest.mark.parametrize(("seconds", "words"), UNITS)
def test_a_duration_is_in_the_unit_that_people_use(seconds, words):
    assert duration_in_words(seconds) == words


@pytest.mark.slow
def test_a_run_time_is_measured_on_runs_that_are_possible(monkeypatch):
    """A process measures the runs that it would get in the sweep; the second of these two is
    impossible."""
    solved = []
    note = solved.append
    monkeypatch.setattr(
        RowProcess,
        "solve",
        lambda _, task, limit: note(task["document"]["friction"]) or {},
    )
    corner = QUICK | {"axes": {"friction.mu_dynamic": [0.3, 0.9]}}
    time = run_time(load_sweep(corner), 2, Stages())
    assert [friction["mu_dynamic"] for friction in solved] == [0.3]
    assert time.measured == 1
    assert time.first_run == time.later_run > 0


@pytest.mark.slow
def test_a_plan_is_measured_with_start_and_compilation_and_covers_every_point():
    """Two processes solve two runs each; the estimate follows from their durations."""
    told = plan(
        QUICK | {"axes": {AXIS: {"from": 0.31, "to": 0.6, "n": 100_000}}}, processes=2
    )
    assert told[0] == f"runs     100000, a grid over 100000 of {AXIS}"
    line = r"a run    (\S+) s; the first one of each process (\S+) s, .* \(4 measured\)"
    later, first = map(float, re.fullmatch(line, told[2]).groups())
    assert first > later > 0
    size = {"min": 60, "h": 3600, "days": 86400}
    number, unit = re.fullmatch(
        r"time     (\S+) (\w+) with 2 processes", told[3]
    ).groups()
    assert float(number) * size[unit] == pytest.approx(first + 49_999 * later, rel=0.2)


def test_only_the_stages_that_the_question_needs():
    assert required_stages.stages_for(["t_end", "repeated_slips_holds"], []) == (
        "motion",
    )
    assert required_stages.stages_for(["audible_modes", "mode_errors"], []) == (
        "modes",
    )
    assert required_stages.stages_for(
        ["energy_balance", "audible_modes"], ["arrays"]
    ) == (
        "motion",
        "modes",
    )
    assert (
        required_stages.stages_for(["t_end"], ["wav"])
        == required_stages.stages_for([], [])
        == required_stages.stages_for(["pitch_rises"], [])
        == ("sound",)
    )


FALLING = load_scene("published").replace(
    *QUICK["set"], "friction.arm_rolling=3e-3", "numerics.accuracy=draft"
)


@pytest.mark.slow
def test_a_row_is_the_summary_of_its_run_and_modes_are_solved_once(monkeypatch):
    """Rows of single stages agree with the full run; a stage without dependencies has all its
    quantities."""
    solved = []
    alone = pipeline.eigenmodes
    monkeypatch.setattr(
        pipeline,
        "eigenmodes",
        lambda scene, **asked: solved.append(1) or alone(scene, **asked),
    )
    monkeypatch.setattr(run_row, "DISK_MODES", pipeline.DiskModesCache())
    whole = summary(solve(FALLING))
    for arm in (3e-3, 2.9e-3):
        scene = FALLING.replace(f"friction.arm_rolling={arm}")
        row = run_row.row_of(scene.document, ("motion", "modes"))
        assert row["t_end"] == simulate(scene).t[-1]
    assert len(solved) == 1
    row = run_row.row_of(FALLING.document, ("motion", "modes"))
    row |= {"passed": whole["passed"]}
    both = {key: value for key, value in row.items() if not key.startswith("seconds_")}
    assert both == {key: whole[key] for key in both}
    of = required_stages.stage_by_quantity()
    judged = {
        key
        for key in whole
        if of.get(key.removesuffix("_holds").removesuffix("_passed"))
        in ("motion", "modes")
    }
    assert judged == set(both)
    run_row.row_of(FALLING.replace("material.young=1e11").document, ("modes",))
    assert len(solved) == 2


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """Return the table of the quick sweep, produced by the command line."""
    folder = tmp_path_factory.mktemp("sweep")
    (folder / "quick.toml").write_text(tomli_w.dumps(QUICK))
    asked = CliRunner().invoke(
        main, ["sweep", str(folder / "quick.toml"), "--out", str(folder / "out")]
    )
    assert asked.exit_code == 0
    assert (
        asked.stdout.splitlines()[1] == "8 runs: 6 flat on the table, 2 with an error"
    )
    return folder / "out" / RUNS_FILE


def test_a_table_has_a_row_for_every_run(done):
    rows = read_table(done)[0].to_pylist()
    assert [row["run"] for row in rows] == list(range(8))
    for row in rows:
        refused = row[AXIS] < row["friction.mu_dynamic"]
        assert (row["error"] is not None) == refused
        assert refused == (
            "mu_dynamic = 0.3 must not exceed mu_static = 0.2" in (row["error"] or "")
        )
        if not refused:
            scene = FALLING.replace(*(f"{key}={row[key]}" for key in QUICK["axes"]))
            assert row["t_end"] == simulate(scene).t[-1]
        assert row["seconds"] > 0
        assert row["version"].startswith(sonify.__version__)
    assert {path.name for path in done.parent.iterdir()} >= {
        RUNS_FILE,
        "outcome.png",
        "t_end.png",
    }


def test_the_same_sweep_again_runs_nothing_and_another_is_refused(done, monkeypatch):
    before = done.read_bytes()
    monkeypatch.setattr("sonify.sweeps.executors.solve_isolated", None)
    assert sonify.sweep(QUICK, out=done.parent) == done
    assert done.read_bytes() == before
    with pytest.raises(InputError, match="the table of another sweep"):
        sonify.sweep(QUICK | {"axes": {AXIS: [0.3]}}, out=done.parent)
    assert done.read_bytes() == before


def test_a_table_may_move_with_its_mesh_but_not_to_another_mesh(tmp_path):
    """A sweep is the same wherever its mesh is, and another one if a byte of it differs."""
    mesh = (ROOT / "sonify" / "scenes" / "wood-table.msh").read_bytes()
    identities = []
    for name, content in (("a", mesh), ("b", mesh), ("c", mesh + b"\n")):
        file = tmp_path / name / "table.msh"
        file.parent.mkdir()
        file.write_bytes(content)
        document = {
            "name": "mesh",
            "scene": "wood-table",
            "set": [f"surface.file='{file.as_posix()}'"],
            "find": ["motion"],
            "axes": {"friction.mu_static": [0.3, 0.4]},
        }
        identities.append(load_sweep(document).identity)
    assert identities[0] == identities[1] != identities[2]


def test_maps_are_drawn_from_the_table_alone(done, tmp_path):
    for n, (axes, of) in enumerate(
        [
            ([], "t_end"),
            ([], "outcome"),
            (["--x", AXIS], "passed"),
            (["--x", "outcome"], "t_end"),
            (["--x", "t_end", "--y", "t_end"], "t_end"),  # on a straight line
        ]
    ):
        asked = CliRunner().invoke(
            main,
            ["map", str(done), *axes, "--of", of, "--out", str(tmp_path / f"{n}.png")],
        )
        assert asked.exit_code == 0, asked.output
        assert (tmp_path / f"{n}.png").stat().st_size > 5000
    folder = ["--out", "."]
    for wrong in (
        ["--of", "nothing"],
        ["--of", "t_end", "--x", "nothing"],
        ["--of", "t_end", *folder],
    ):
        asked = CliRunner().invoke(main, ["map", str(done), *wrong])
        assert (asked.exit_code, len(asked.stderr.splitlines())) == (2, 1)
    assert asked.stderr.startswith("sonify: .: ")
    assert (
        CliRunner()
        .invoke(main, ["map", str(tmp_path / "0.png"), "--of", "t_end"])
        .exit_code
        == 2
    )


SAME = {"outcome": "SETTLED", "error": None, "passed": True}
ROWS = [{"run": k, "a.x": k / 7, "t_end": k**0.5} | SAME for k in range(9)]


def table(folder, **options):
    return RunStore(folder, {"axes": {}}, ["a.x"], len(ROWS), **options)


def test_rows_of_a_killed_process_are_in_the_table_up_to_the_last_export(tmp_path):
    killed = table(tmp_path)
    killed.__enter__()
    killed.add(ROWS[:4])
    killed.export()
    killed._export_seconds = 1e9  # as if the next one were not due
    killed.add([ROWS[4]])
    killed._resources.close()  # the system closes the files of a killed process
    with table(tmp_path) as resumed:
        assert resumed.done.tolist() == [k < 4 for k in range(9)]
        resumed.add([row for row in ROWS if not resumed.done[row["run"]]][::-1])
    assert read_table(tmp_path / RUNS_FILE)[0].to_pylist() == ROWS


def test_a_second_driver_is_refused(tmp_path):
    with (
        table(tmp_path),
        pytest.raises(OutputError, match="another sweep is writing this table"),
        table(tmp_path),
    ):
        pass
    with table(tmp_path):
        pass


def test_failed_runs_are_missing_only_if_they_are_to_be_solved_again(tmp_path):
    with table(tmp_path) as first:
        first.add([ROWS[0], ROWS[1] | {"error": "late", "t_end": None}])
    with table(tmp_path) as again:
        assert again.done[:3].tolist() == [True, True, False]
    with table(tmp_path, retry=True) as again:
        assert again.done[:3].tolist() == [True, False, False]
        again.add([ROWS[1]])
    assert read_table(tmp_path / RUNS_FILE)[0].to_pylist() == ROWS[:2]


def test_a_full_disk_keeps_the_table(tmp_path):
    with table(tmp_path) as before:
        before.add(ROWS[:2])
    with (
        files_of_at_most(100),
        pytest.raises(OSError, match="File too large"),
        table(tmp_path) as filled,
    ):
        filled.add(ROWS[2:])
    with table(tmp_path) as resumed:
        assert resumed.done.sum() == 2


def disturb(monkeypatch, change):
    """Let sweeps add trivial rows, and call `change` after each addition."""
    monkeypatch.undo()
    solve_tasks = command.solve_tasks

    def disturbed(*asked):
        for rows in solve_tasks(*asked):
            yield rows
            change()

    monkeypatch.setattr(command, "solve_tasks", disturbed)
    monkeypatch.setattr(
        "sonify.sweeps.executors.solve_isolated",
        lambda *_: {"version": version(), "seconds": 1.0},
    )


def test_a_table_that_someone_else_shortens_is_told(tmp_path, monkeypatch):
    path = tmp_path / RUNS_FILE

    def shorten(rows):
        pq.write_table(pq.read_table(path).slice(0, rows), path)

    disturb(monkeypatch, lambda: None)
    sonify.sweep(QUICK, out=tmp_path)
    shorten(6)
    disturb(monkeypatch, lambda: shorten(3))
    with pytest.raises(
        OutputError, match="of 8 rows: its files were changed during the sweep"
    ):
        sonify.sweep(QUICK, out=tmp_path)
    disturb(monkeypatch, lambda: None)
    assert read_table(sonify.sweep(QUICK, out=tmp_path))[0].num_rows == 8


def test_what_is_not_finite_is_no_value_and_axes_keep_it(tmp_path):
    with table(tmp_path) as written:
        written.add(
            [ROWS[0] | {"t_end": float("nan"), "a.x": inf}, ROWS[1] | {"t_end": inf}]
        )
    held = read_table(tmp_path / RUNS_FILE)[0]
    assert held["t_end"].to_pylist() == [None, None]
    assert held["a.x"].to_pylist()[0] == inf
    assert held.schema.field("t_end").type == pa.float64()


@pytest.mark.slow
def test_a_run_that_takes_too_long_or_kills_its_process_is_a_row(monkeypatch):
    task = {"document": load_scene("published").document, "stages": ["motion"]}
    assert (
        solve_isolated(task, 1e-3)["error"] == "took longer than the limit of 0.001 s"
    )
    monkeypatch.setattr(
        RowProcess, "solve", lambda process, *_: process.worker.process.kill()
    )
    assert (
        solve_isolated(task, 60)["error"]
        == "the process ended with status -9 in 2 attempts"
    )


def test_processes_that_cannot_start_stop_the_sweep(monkeypatch, tmp_path):
    monkeypatch.setattr("sys.executable", "/bin/false")
    with pytest.raises(AbortedError, match="failed to start"):
        sonify.sweep(QUICK, out=tmp_path)
    assert read_table(tmp_path / RUNS_FILE)[0].num_rows == 0


def test_a_failed_check_is_told(tmp_path):
    with table(tmp_path) as written:
        written.add(
            [ROWS[0] | {"version": "1"}, ROWS[1] | {"passed": False, "version": "1"}]
        )
    assert summarize(tmp_path / RUNS_FILE) == (
        "2 runs: 2 flat on the table, 1 with a FAILED self-check",
        False,
    )


def test_found_leaves_out_times_only(done):
    assert set(read_table(done)[0].column_names) - set(found(done).column_names) == {
        "seconds",
        "seconds_motion",
    }


def test_the_conclusion_on_friction_is_that_of_its_table():
    """The lines report the exponents used to make the table and the friction above which the disk
    falls."""
    mu, arm = (
        grid.ravel()
        for grid in np.meshgrid(np.geomspace(0.1, 1, 9), np.geomspace(1e-5, 1e-4, 9))
    )
    told = {
        "friction.mu_static": mu,
        "friction.arm_rolling": arm,
        "t_end": 1e-2 * arm**-0.75,
    }
    told |= {
        "repeated_slips": 9 / mu,
        "outcome": np.where(mu > 0.5, "FELL", "SETTLED").tolist(),
    }
    lines = CONCLUSIONS["friction"](pa.table(told))
    assert (
        "power -0.75 of the rolling arm and to the power 0.00 of the friction coefficients (within 0%)"
        in lines[0]
    )
    assert (
        "power 0.00 of the arm and to the power -1.00 of the friction coefficients: friction determines"
        in lines[1]
    )
    assert "below mu_static = 0.56; at or above it, 27 of 27 runs have" in lines[2]
    told |= {"t_end": mu, "outcome": ["SETTLED"] * len(mu)}
    lines = CONCLUSIONS["friction"](pa.table(told))
    assert "determines" not in lines[1]
    assert lines[2] == "The disk settles in all runs."
    assert set(CONCLUSIONS) == {
        name for name in shipped_sweeps() if not name.startswith("verdict")
    }


def test_the_conclusion_on_a_table_that_acts_back_is_that_of_its_table():
    """Two masses at two pressures: the light mode breaks the contact and halves the duration."""
    told = {
        "surface.modes.0.modal_mass": [0.1, 0.1, 30.0, 30.0],
        "air.pressure": [1.01325, 101325.0] * 2,
    }
    told |= {
        "contact_kept": [0.0, 0.0, 0.02, 0.01],
        "t_end": [0.5, 0.51, 1.0, 1.02],
        "outcome": ["AIRBORNE"] * 4,
    }
    told |= {
        "ended_by": ["the table", "the table", "sliding", "the film of air"],
        "passed": [True] * 4,
    }
    told |= {"dissipation_never_falls": [0.0, 2e-5, 0.0, 0.0]}
    lines = CONCLUSIONS["halt-table"](pa.table(told))
    assert (
        "after 0.51 s with a mode of 0.1 kg, and after 1 s with a mode of 30 kg"
        in lines[0]
    )
    assert (
        "From 1e-05 to 1 atmospheres, the air changes this time by 0.02 s at most"
        in lines[0]
    )
    assert lines[1].startswith(
        "Vibration breaks the contact before the end in 2 of 4 runs"
    )
    assert lines[1].endswith("lifts the disk in 4.")
    assert (
        "air film in 1 runs, at 1 atmospheres and above; into the table in 2 runs, with modes up to 0.1 kg"
        in lines[2]
    )
    lines = CONCLUSIONS["halt-table"](
        pa.table(told | {"passed": [True, False, True, True]})
    )
    assert lines[1].endswith(
        "in 1 runs the film returns up to 2e-05 of the energy, and a self-check fails."
    )


@pytest.mark.parametrize("name", CONCLUSIONS)
def test_the_shown_conclusion_is_written_from_its_table(name):
    folder = Path(sonify.__file__).parents[1] / "outputs/shown/sweeps" / name
    table, _ = read_table(folder / "runs.parquet")
    shown = (folder / "conclusion.md").read_text("utf-8").splitlines()
    assert CONCLUSIONS[name](table) == shown


def test_the_conclusions_on_halt_and_pitch_are_those_of_their_tables():
    """Each table has six runs, with answers that are obvious by inspection."""
    air = "the film of air"
    told = {
        "air.pressure": [1.0, 1.0, 10132.5, 10132.5, 1e5, 1e5],
        "dissipation.contour_moment": [1e-6, 1e-4] * 3,
    }
    told |= {
        "film_squeezed": [1e4, 9e3, 0.9, 0.8, 0.1, 0.05],
        "outcome": ["AIRBORNE"] * 5 + ["SETTLED"],
    }
    told |= {"ended_by": [air, air, air, "sliding", air, "sliding"]}
    lines = CONCLUSIONS["halt"](pa.table(told))
    assert lines[0].startswith("At 0.1 atmospheres and above,")
    assert lines[0].endswith("in 3 of 4 runs.")
    assert "in 2 runs, up to a contour moment of 1e-06 N m" in lines[1]
    assert "At lower pressures 2 runs are inconclusive" in lines[2]
    assert CONCLUSIONS["halt"](pa.table(told | {"film_squeezed": [0.1] * 6}))[
        2
    ].endswith("is therefore valid in all runs.")
    told = {
        "surface.thickness": [3e-3, 3e-3, 9e-3, 9e-3, 3e-2, 3e-2],
        "audio.distance": [0.1, 3.0] * 3,
    }
    told |= {"table_carries_the_tone": [30.0, 31.5, 9.0, None, -5.0, -9.0]}
    lines = CONCLUSIONS["pitch"](pa.table(told))
    assert (
        "in 3 of 5 runs, up to a thickness of 9 mm. In these runs the plate is 9 to 32 dB louder"
        in lines[0]
    )
    assert lines[1].endswith("by 4.0 dB at most.")


ARRAYS = {"motion.npz", "modes.json"}
SOUNDS = ARRAYS | {"pressure.wav", "sound.wav", "audible.wav", "stems"}
KEEP = [
    (["motion", "modes"], ["arrays"], ARRAYS),
    (["sound"], ["arrays", "wav"], SOUNDS),
    pytest.param(
        ["sound"],
        ["page"],
        SOUNDS | {"report.html", "run.json"},
        marks=pytest.mark.slow,
    ),
]


@pytest.mark.parametrize(("stages", "keep", "files"), KEEP)
def test_what_is_to_be_kept_is_there(stages, keep, files, tmp_path):
    row = run_row.row_of(FALLING.document, stages, keep, str(tmp_path / "runs" / "7"))
    assert row["passed"]
    kept = {path.name for path in (tmp_path / "runs" / "7").iterdir()}
    assert kept >= files if "page" in keep else kept == files
    assert np.load(tmp_path / "runs" / "7" / "motion.npz")["t"][-1] == row["t_end"]
