"""Claim: a worker process returns the row of the function that a task names, as plain values.

Source: sonify/sweeps/worker_loop.py. Oracle: `dict`, which returns its arguments; the error of a
missing file.
"""

import errno

import numpy as np
import pytest

from sonify.sweeps.version import version
from sonify.sweeps.worker_loop import solve_task


def test_the_row_of_a_task_is_plain_and_complete():
    values = {"t_end": np.float64(0.25), "counts": np.arange(3), "name": "a"}
    row = solve_task({"solver": "builtins:dict"} | values)
    assert row.pop("seconds") >= 0
    assert row == {
        "t_end": 0.25,
        "counts": [0, 1, 2],
        "name": "a",
        "version": version(),
    }
    assert type(row["t_end"]) is float


def test_a_missing_file_stops_the_sweep_and_is_named(tmp_path):
    path = str(tmp_path / "missing")
    row = solve_task({"solver": "os:stat", "path": path})
    assert row["stop"][0] == errno.ENOENT
    assert row["stop"][2] == path


def test_other_errors_of_the_function_are_raised():
    with pytest.raises(TypeError):
        solve_task({"solver": "os:stat"})
