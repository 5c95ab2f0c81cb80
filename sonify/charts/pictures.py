"""The map of failures: methods against what makes it hard, grey where a method fails, with the way it does."""

from textwrap import fill

from matplotlib.figure import Figure

from sonify.charts.records import Record
from sonify.files import whole

DPI = 110


def draw_map(records: list[Record], title: str, path):
    """Draw one table for the motion and one for the oscillators."""
    tables = [[r for r in records if (r.family == "oscillator") is which] for which in (False, True)]
    rows = [len({(r.family, r.method, r.setting) for r in table}) for table in tables]
    figure = Figure(figsize=(13, 0.55 * sum(rows) + 2), dpi=DPI, layout="constrained")
    panels = figure.subplots(2, 1, height_ratios=rows)
    for axes, table, name in zip(panels, tables, ("Motion", "Oscillators"), strict=True):
        _table(axes, table, name)
    figure.suptitle(title)
    with whole(path) as temporary:
        figure.savefig(temporary, metadata={"Software": None})


def _table(axes, records, name):
    methods = list(dict.fromkeys((r.family, r.method, r.setting) for r in records))
    cases = list(dict.fromkeys(r.case for r in records))
    for r in records:
        x, y = cases.index(r.case), methods.index((r.family, r.method, r.setting))
        axes.fill_between([x, x + 1], y, y + 1, color="0.82" if r.failure else "w")
        text = fill(r.failure, 30) if r.failure else f"error {r.error:.0e}"
        axes.text(x + 0.5, y + 0.5, text, ha="center", va="center", fontsize=7)
    axes.set_xticks([i + 0.5 for i in range(len(cases))], cases)
    axes.set_yticks([i + 0.5 for i in range(len(methods))], [", ".join(method) for method in methods], fontsize=8)
    axes.hlines(range(len(methods) + 1), 0, len(cases), color="0.5", lw=0.5)
    axes.vlines(range(len(cases) + 1), 0, len(methods), color="0.5", lw=0.5)
    axes.set(xlim=(0, len(cases)), ylim=(len(methods), 0), title=f"{name} (grey: fails)")
    axes.tick_params(length=0)
    axes.xaxis.tick_top()
