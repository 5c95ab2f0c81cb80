"""`python -m sonify chart`: the files that the chart of a module becomes."""

from importlib import import_module
from pathlib import Path

from sonify.charts import CHARTS
from sonify.charts.records import Record, read_csv, write_csv
from sonify.files import claim
from sonify.progress import Stages
from sonify.scene_errors import InputError


def make(name: str, quick: bool, out: str | Path, stages: Stages, redraw: bool = False) -> list[Record]:
    """Run chart `name` of `CHARTS` and write <name>.csv, .png and .md into `out`; return the records.

    With `redraw` nothing is run: picture and page are made from the records in `out`. Raises InputError where there are
    none.
    """
    from sonify.charts.chart import draw
    from sonify.charts.page import environment, known_environment, write_page

    out, chart = Path(out) if redraw else claim(out), CHARTS[name]
    table, picture, page = (out / f"{name}.{suffix}" for suffix in ("csv", "png", "md"))
    module = import_module(f"sonify.charts.{name}")
    if redraw:
        if not (table.is_file() and page.is_file()):
            raise InputError(f"{table}: no records of the chart {name} to draw again")
        records, about = read_csv(table), known_environment(page)
    else:
        with stages.stage(f"chart {name}") as watch:
            records, about = module.run(quick, watch), environment()
        write_csv(records, table)
    if hasattr(module, "draw"):
        module.draw(records, chart.title, picture)
    else:
        draw(records, chart.title, chart.error_label, picture)
    write_page(name, chart.title, module, records, about, page)
    return records
