"""Draw error against processor time, with one colour per family of methods and one
marker per method."""

import numpy as np
from matplotlib import colormaps
from matplotlib.figure import Figure
from matplotlib.ticker import LogFormatter

from benchmarks.timed_runs import Record
from sonify.runtime.files import atomic_write

MARKERS = ("o", "s", "^", "D", "v", "P", "*", "<", ">", "p", "h", "d", "8", "H")
LINE_STYLES = ("-", "--", ":", "-.")
MIN_DRAWN_ERROR = 1e-16
"""Smallest drawn error; smaller ones are drawn at this value."""
FAILURE_ROW_RATIO = 2.0
"""Ratio of the error coordinates of two neighbouring rows of failed runs."""
DPI = 110


def draw(records: list[Record], title: str, error_label: str, path):
    """Draw one panel per case. Failed runs have hollow markers in a strip at the top,
    at the time of the failure."""
    records = [r for r in records if not r.left_out]
    cases = list(dict.fromkeys(r.case for r in records))
    colours = family_colours(dict.fromkeys(r.family for r in records))
    figure = Figure(figsize=(8 * len(cases), 7.5), dpi=DPI, layout="constrained")
    for panel, case in zip(
        figure.subplots(1, len(cases), squeeze=False)[0], cases, strict=True
    ):
        _panel(
            panel, [r for r in records if r.case == case], case, error_label, colours
        )
    figure.suptitle(title)
    save(figure, path)


def save(figure: Figure, path):
    """Write a picture without metadata on the program, so that its bytes depend only on
    the records."""
    with atomic_write(path) as temporary:
        figure.savefig(temporary, metadata={"Software": None})


def family_colours(families) -> dict:
    """Return one colour per family; they differ in lightness for colour-blind readers
    and greyscale prints."""
    return dict(
        zip(
            families,
            colormaps["plasma"](np.linspace(0, 0.88, len(families))),
            strict=True,
        )
    )


def _panel(axes, records, case, error_label, colours):
    methods = list(dict.fromkeys((r.family, r.method) for r in records))
    errors = [max(r.error, MIN_DRAWN_ERROR) for r in records if not r.failure]
    bottom = 5 * max(errors)
    for i, (family, name) in enumerate(methods):
        runs = [r for r in records if (r.family, r.method) == (family, name)]
        good = [r for r in runs if not r.failure]
        bad = [r for r in runs if r.failure]
        seconds = [r.seconds for r in good]
        drawn_errors = [max(r.error, MIN_DRAWN_ERROR) for r in good]
        line_style = LINE_STYLES[list(colours).index(family) % len(LINE_STYLES)]
        style = {"color": colours[family], "marker": MARKERS[i % len(MARKERS)], "ms": 7}
        axes.plot(
            seconds, drawn_errors, line_style, lw=1, label=f"{family}: {name}", **style
        )
        row = bottom * FAILURE_ROW_RATIO ** (i + 1)
        axes.plot([r.seconds for r in bad], [row] * len(bad), ls="", mfc="w", **style)
    top = bottom * FAILURE_ROW_RATIO ** (len(methods) + 3)
    axes.axhspan(bottom, top, color="0.93", zorder=0)
    axes.text(
        0.01,
        0.99,
        "failed (hollow; one row per method)",
        transform=axes.transAxes,
        va="top",
        style="italic",
    )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="processor time [s], median",
        ylabel=error_label,
        title=case,
    )
    axes.xaxis.set_minor_formatter(LogFormatter(minor_thresholds=(1.5, 0.4)))
    axes.tick_params(axis="x", which="minor", labelsize=7)
    axes.set_ylim(min(errors) / 3, top)
    axes.set_yticks(
        [tick for tick in axes.get_yticks() if min(errors) / 3 <= tick <= bottom]
    )
    axes.tick_params(axis="y", which="minor", length=0)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3)
