"""`python -m sonify chart`: which charts there are, and the files they become."""

from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from sonify.charts.records import Record, write_csv
from sonify.files import claim
from sonify.progress import Stages


class Chart(NamedTuple):
    """A chart: its title and the label of its error axis."""

    title: str
    error_label: str


CHARTS = {
    "motion": Chart("Motion: accuracy against speed", "relative error of inclination or energy, the larger"),
    "modes": Chart("Modes: accuracy against speed", "largest relative error of a frequency"),
    "sound": Chart("Sound: accuracy against speed", "rms error of the pressure over its rms"),
    "stability": Chart("Stability: where methods fail", ""),
}
"""By name; the runs are made by the module of the same name."""


def make(name: str, quick: bool, out: str | Path, stages: Stages) -> list[Record]:
    """Run chart `name` and write <name>.csv, .png and .md into `out`; return the records."""
    out, chart = claim(out), CHARTS[name]
    module = import_module(f"sonify.charts.{name}")
    with stages.stage(f"chart {name}") as watch:
        records = module.run(quick, watch)
    from sonify.charts.page import write_page

    write_csv(records, out / f"{name}.csv")
    _draw(name, chart, records, out / f"{name}.png")
    write_page(name, chart.title, module.conclusion(records), records, out / f"{name}.md")
    return records


def _draw(name, chart, records, path):
    if name == "stability":
        from sonify.charts.pictures import draw_map

        return draw_map(records, chart.title, path)
    from sonify.charts.chart import draw

    return draw(records, chart.title, chart.error_label, path)
