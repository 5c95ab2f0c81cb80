"""`python -m sonify chart`: the files that the chart of a module becomes."""

from importlib import import_module
from pathlib import Path

from sonify.charts import CHARTS
from sonify.charts.records import Record, write_csv
from sonify.files import claim
from sonify.progress import Stages


def make(name: str, quick: bool, out: str | Path, stages: Stages) -> list[Record]:
    """Run chart `name` of `CHARTS` and write <name>.csv, .png and .md into `out`; return the records."""
    out, chart = claim(out), CHARTS[name]
    module = import_module(f"sonify.charts.{name}")
    with stages.stage(f"chart {name}") as watch:
        records = module.run(quick, watch)
    from sonify.charts.chart import draw
    from sonify.charts.page import write_page

    write_csv(records, out / f"{name}.csv")
    if hasattr(module, "draw"):
        module.draw(records, chart.title, out / f"{name}.png")
    else:
        draw(records, chart.title, chart.error_label, out / f"{name}.png")
    write_page(name, chart.title, module.conclusion(records), records, out / f"{name}.md")
    return records
