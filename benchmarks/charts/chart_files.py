"""Write the table, the picture and the page of a chart, for `python -m sonify
chart`."""

from importlib import import_module
from pathlib import Path

from benchmarks.charts import CHARTS
from benchmarks.charts.chart_page import environment, known_environment, write_page
from benchmarks.charts.error_time_picture import draw
from benchmarks.timed_runs import read_csv, write_csv
from sonify.runtime.files import create_folder
from sonify.runtime.progress import Stages
from sonify.scene_errors import InputError


def write_chart(
    name: str, quick: bool, out: str | Path, stages: Stages, redraw: bool = False
) -> Path:
    """Run the chart `name` of `CHARTS`, write <name>.csv, .png and .md into `out`, and
    return the path of the page.

    With `redraw`, picture and page are made from the records in `out` without running
    any method. Raises InputError if `out` has no records of this chart."""
    chart = CHARTS[name]
    module = import_module(f"benchmarks.charts.{name}_chart")
    folder = Path(out) if redraw else create_folder(out)
    table = folder / f"{name}.csv"
    picture = folder / f"{name}.png"
    page = folder / f"{name}.md"
    if redraw:
        if not (table.is_file() and page.is_file()):
            raise InputError(f"{table}: no records of the chart {name} to draw again")
        records = read_csv(table)
        description = known_environment(page)
    else:
        with stages.stage(f"chart {name}") as watch:
            records = module.run(quick, watch)
            description = environment()
        write_csv(records, table)
    if chart.error_label:
        draw(records, chart.title, chart.error_label, picture)
    else:
        module.draw(records, chart.title, picture)
    write_page(name, chart.title, module, records, description, page)
    return page
