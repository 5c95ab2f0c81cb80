"""Picture of a ladder: deviation from the top rung against CPU time."""

from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from sonify.ladder.command import Ladder
from sonify.ladder.comparison import QUESTION_KEYS, Comparison, QuestionKey, is_solved
from sonify.ladder.conclusions import QUESTION_HEADS
from sonify.report.figure import png_figure

COLOURS: dict[QuestionKey, str] = {
    "sound": "#0072b2",
    "pitch": "#d55e00",
    "loss": "#009e73",
    "end": "#cc79a7",
}
SYMBOLS: dict[QuestionKey, str] = {"sound": "o", "pitch": "s", "loss": "D", "end": "^"}
LEAST_DEVIATION = 1e-4
"""Deviation at which 0 and smaller deviations are drawn."""
GREATEST_DEVIATION = 1e3
"""Deviation at which undefined and greater ones are drawn."""


def draw_ladder(ladder: Ladder, path: Path) -> None:
    """Draw a ladder into a PNG file, with one panel for each stretch."""
    count = len(ladder.comparisons)
    size = (5.2 * count + 1.4, 5.4)
    with png_figure(path, 1, count, size, sharey=True, squeeze=False) as (figure, axes):
        figure.subplots_adjust(left=0.95 / size[0], bottom=0.24, top=0.9, wspace=0.06)
        panels = axes[0]
        for panel, (stretch, found) in zip(
            panels, ladder.comparisons.items(), strict=True
        ):
            draw_stretch(panel, found, ladder.own.name)
            panel.set_title(f"{ladder.scene.name}: {stretch}", fontsize=9)
        panels[0].set_ylabel("relative deviation from the top rung")
        figure.legend(handles=legend_handles(), loc="lower center", ncols=3, fontsize=7)


def draw_stretch(axes: Axes, found: Comparison, own: str) -> None:
    """Draw the rungs over one stretch."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(LEAST_DEVIATION / 2, GREATEST_DEVIATION * 2)
    axes.set_xlabel("CPU time [s]")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.grid(alpha=0.3)
    ticks = [10.0**power for power in range(-4, 4)]
    texts = ["same", *(f"{tick:g}" for tick in ticks[1:-1]), "undefined"]
    axes.set_yticks(ticks, texts)
    for index, row in enumerate(found.rows):
        if not is_solved(row):
            continue
        seconds = row["cpu_seconds"]
        least = index == found.all_answers
        axes.axvline(
            seconds, color="0.1" if least else "0.85", lw=1.2 if least else 0.8
        )
        weight = "bold" if row["rung"] == own else "normal"
        axes.text(
            seconds,
            GREATEST_DEVIATION / 3,
            f"{row['rung']} ",
            rotation=90,
            va="top",
            ha="right",
            fontsize=7,
            fontweight=weight,
        )
        for key in QUESTION_KEYS:
            draw_point(axes, found, index, key)


def draw_point(axes: Axes, found: Comparison, index: int, key: QuestionKey) -> None:
    """Draw the deviation of one answer of one rung."""
    deviations = found.deviations[index]
    assert deviations is not None  # the rung was solved
    one = deviations[key]
    size = one.relative_size
    shown = GREATEST_DEVIATION
    if size is not None:
        shown = min(max(size, LEAST_DEVIATION), GREATEST_DEVIATION)
    elif one.same_number:
        shown = LEAST_DEVIATION
    shift = 1.02 ** (2 * QUESTION_KEYS.index(key) - 3)  # points do not cover each other
    axes.plot(
        found.rows[index]["cpu_seconds"] * shift,
        shown,
        SYMBOLS[key],
        color=COLOURS[key],
        mfc=COLOURS[key] if one.same_answer else "none",
        ms=11 if found.marks[key].answer == index else 6,
    )


def legend_handles() -> list[Line2D]:
    """Return the entries of the legend."""
    handles = [
        Line2D([], [], color=COLOURS[key], marker=SYMBOLS[key], ls="", label=head)
        for key, head in QUESTION_HEADS.items()
    ]
    plain: dict[str, Any] = {"color": "0.4", "marker": "o", "ls": ""}
    return [
        *handles,
        Line2D([], [], label="same answer", **plain),
        Line2D([], [], mfc="none", label="another answer", **plain),
        Line2D([], [], ms=11, label="cheapest with the same answer", **plain),
        Line2D([], [], color="0.1", label="cheapest with all answers"),
    ]
