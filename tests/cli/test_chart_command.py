"""Claim: `sonify chart` runs every chart of a checkout; an installed package without a checkout
names the place where the charts are.

Source: the public command line; the wheel does not contain the folder benchmarks/. Oracle: the
charts defined in benchmarks/; an empty folder in place of the checkout.
"""

import pytest
from click.testing import CliRunner

from benchmarks.charts import CHARTS
from sonify import chart_command
from sonify.__main__ import main


def test_the_command_line_names_every_chart():
    assert [name.replace("-", "_") for name in chart_command.CHART_NAMES] == list(
        CHARTS
    )


def test_the_charts_come_from_the_checkout():
    assert chart_command.load_chart_files().__name__ == "benchmarks.charts.chart_files"


@pytest.mark.parametrize("name", ["all", "end-to-end"])
@pytest.mark.parametrize("files", [(), ("pyproject.toml",)])
def test_without_a_checkout_one_line_says_where_the_charts_are(
    name, files, tmp_path, monkeypatch
):
    for file in files:
        (tmp_path / file).touch()
    monkeypatch.setattr(chart_command, "CHECKOUT_FOLDER", tmp_path)
    asked = CliRunner().invoke(main, ["chart", name, "--out", str(tmp_path / "charts")])
    assert asked.exit_code == 2
    assert asked.stdout == ""
    assert asked.stderr == (
        "sonify: chart: the charts are in the folder benchmarks/ of the source repository, not in "
        "the installed "
        "package; to run them, install a checkout with `python -m pip install -e .`\n"
    )
    assert not (tmp_path / "charts").exists()
