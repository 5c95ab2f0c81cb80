"""Draws error against seconds: a colour and a line for every family, a marker for every method, hollow if it failed."""

import numpy as np
from matplotlib import colormaps
from matplotlib.figure import Figure
from matplotlib.ticker import LogFormatter

from sonify.charts.records import Record
from sonify.files import whole

MARKERS = ("o", "s", "^", "D", "v", "P", "*", "<", ">", "p", "h", "d", "8", "H")
LINES = ("-", "--", ":", "-.")
FLOOR = 1e-16
"""An error below this is drawn here."""
ROW = 2.0
"""Between the rows of failures, as a factor on the axis of errors."""
DPI = 110


def draw(records: list[Record], title: str, error_label: str, path):
    """Draw one panel per case; failed runs stand in a strip at the top, at the time after which they failed."""
    records = [r for r in records if not r.left_out]
    cases, tones = list(dict.fromkeys(r.case for r in records)), tones_of(dict.fromkeys(r.family for r in records))
    figure = Figure(figsize=(8 * len(cases), 7.5), dpi=DPI, layout="constrained")
    for panel, case in zip(figure.subplots(1, len(cases), squeeze=False)[0], cases, strict=True):
        _panel(panel, [r for r in records if r.case == case], case, error_label, tones)
    figure.suptitle(title)
    save(figure, path)


def save(figure: Figure, path):
    """Write a picture, the same bytes whatever made it."""
    with whole(path) as temporary:
        figure.savefig(temporary, metadata={"Software": None})


def tones_of(families) -> dict:
    """Return a colour for each family: told apart by the colour-blind, and by their lightness in a grey print."""
    return dict(zip(families, colormaps["plasma"](np.linspace(0, 0.88, len(families))), strict=True))


def _panel(axes, records, case, error_label, tones):
    methods = list(dict.fromkeys((r.family, r.method) for r in records))
    errors = [max(r.error, FLOOR) for r in records if not r.failure]
    bottom = 5 * max(errors)
    for i, method in enumerate(methods):
        rank = list(tones).index(method[0])
        runs = [r for r in records if (r.family, r.method) == method]
        good, bad = [r for r in runs if not r.failure], [r for r in runs if r.failure]
        style = {"color": tones[method[0]], "marker": MARKERS[i % len(MARKERS)], "ms": 7}
        label = f"{method[0]}: {method[1]}"
        axes.plot(
            [r.seconds for r in good], [max(r.error, FLOOR) for r in good], LINES[rank % 4], lw=1, label=label, **style
        )
        axes.plot([r.seconds for r in bad], [bottom * ROW ** (i + 1)] * len(bad), ls="", mfc="w", **style)
    top = bottom * ROW ** (len(methods) + 3)
    axes.axhspan(bottom, top, color="0.93", zorder=0)
    axes.text(0.01, 0.99, "failed (hollow; one row per method)", transform=axes.transAxes, va="top", style="italic")
    axes.set(xscale="log", yscale="log", xlabel="processor time [s], median", ylabel=error_label, title=case)
    axes.xaxis.set_minor_formatter(LogFormatter(minor_thresholds=(1.5, 0.4)))
    axes.tick_params(axis="x", which="minor", labelsize=7)
    axes.set_ylim(min(errors) / 3, top)
    axes.set_yticks([tick for tick in axes.get_yticks() if min(errors) / 3 <= tick <= bottom])
    axes.tick_params(axis="y", which="minor", length=0)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3)
