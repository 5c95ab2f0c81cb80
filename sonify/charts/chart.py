"""Draws error against seconds, readable without colour: a marker and a grey for every family, a cross for failures."""

from matplotlib.figure import Figure

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
    cases = list(dict.fromkeys(r.case for r in records))
    figure = Figure(figsize=(8 * len(cases), 7.5), dpi=DPI, layout="constrained")
    for panel, case in zip(figure.subplots(1, len(cases), squeeze=False)[0], cases, strict=True):
        _panel(panel, [r for r in records if r.case == case], case, error_label)
    figure.suptitle(title)
    with whole(path) as temporary:
        figure.savefig(temporary, metadata={"Software": None})


def _panel(axes, records, case, error_label):
    methods = list(dict.fromkeys((r.family, r.method) for r in records))
    families = list(dict.fromkeys(family for family, _ in methods))
    errors = [max(r.error, FLOOR) for r in records if not r.failure]
    bottom = 5 * max(errors)
    for i, method in enumerate(methods):
        rank = families.index(method[0])
        runs = [r for r in records if (r.family, r.method) == method]
        good, bad = [r for r in runs if not r.failure], [r for r in runs if r.failure]
        tone = str(round(0.6 * rank / max(1, len(families) - 1), 2))
        style = {"color": tone, "marker": MARKERS[i % len(MARKERS)], "ms": 7}
        label = f"{method[0]}: {method[1]}"
        axes.plot(
            [r.seconds for r in good], [max(r.error, FLOOR) for r in good], LINES[rank % 4], lw=1, label=label, **style
        )
        axes.plot([r.seconds for r in bad], [bottom * ROW ** (i + 1)] * len(bad), ls="", mfc="w", **style)
    top = bottom * ROW ** (len(methods) + 3)
    axes.axhspan(bottom, top, color="0.93", zorder=0)
    axes.text(0.01, 0.99, "failed (hollow; one row per method)", transform=axes.transAxes, va="top", style="italic")
    axes.set(xscale="log", yscale="log", xlabel="processor time [s], median", ylabel=error_label, title=case)
    axes.set_ylim(min(errors) / 3, top)
    axes.set_yticks([tick for tick in axes.get_yticks() if min(errors) / 3 <= tick <= bottom])
    axes.tick_params(axis="y", which="minor", length=0)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3)
