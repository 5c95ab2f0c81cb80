"""Claim: a run needs no optional package, and a command that needs one names its installation.

Source: pyproject.toml. Oracle: a Python in which the packages cannot be imported."""

import subprocess
import sys

import pytest

HIDE_AND_START = """
import sys
for name in ("pyarrow", "distributed", "pandas", "pygltflib"):
    sys.modules[name] = None
from sonify.__main__ import start
start("sonify")
"""


def without_optional_packages(*arguments, cwd):
    return subprocess.run(
        [sys.executable, "-c", HIDE_AND_START, *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
    )


@pytest.mark.slow
def test_a_run_and_a_table_as_text_need_no_optional_package(tmp_path):
    short = ("--accuracy", "draft", "--set", "numerics.time_limit=0.2")
    ran = without_optional_packages(
        "run", "published", *short, "--out", "run", cwd=tmp_path
    )
    assert ran.returncode == 0, ran.stderr
    assert (tmp_path / "run" / "report.html").exists()
    exported = without_optional_packages(
        "export", "motion", "--as", "csv", "--out", "motion.csv", "run", cwd=tmp_path
    )
    assert exported.returncode == 0, exported.stderr
    assert (
        (tmp_path / "motion.csv")
        .read_text()
        .startswith("t [s],precession [rad],inclination [rad],")
    )


def test_the_plan_of_a_ladder_needs_no_optional_package(tmp_path):
    planned = without_optional_packages("ladder", "light-plate", "--plan", cwd=tmp_path)
    assert planned.returncode == 0, planned.stderr
    assert " rows, about " in planned.stdout.splitlines()[-1]


@pytest.mark.parametrize(
    ("arguments", "need", "extra"),
    [
        ("sweep rolling", "a sweep requires pyarrow", "sweep"),
        ("ladder light-plate", "a ladder requires pyarrow", "sweep"),
        ("map runs.parquet --of t_end", "a sweep requires pyarrow", "sweep"),
        ("export motion --as parquet", "--as parquet requires pyarrow", "sweep"),
        ("export motion --as gltf", "--as gltf requires pygltflib", "export"),
    ],
)
def test_a_missing_package_is_one_line_with_its_installation(
    tmp_path, arguments, need, extra
):
    ended = without_optional_packages(*arguments.split(), cwd=tmp_path)
    assert ended.returncode == 2
    assert ended.stdout == ""
    assert ended.stderr.splitlines() == [
        f'sonify: {need}; install it with: python -m pip install -e ".[{extra}]"'
    ]
    assert not list(tmp_path.iterdir())
