"""NUMBERS -> FIGURES: the vector figures of the article, drawn from numbers.json alone.

Colours are those of Okabe and Ito, which the colour-blind can tell apart; markers and line styles
repeat the distinction."""

import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import matplotlib as mpl
import numpy as np
from article_numbers import ROOT, Numbers, with_numbers, without_typed_numbers
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Polygon

from sonify.runtime.files import atomic_write

sys.path.append(str(ROOT))
from benchmarks.charts.stability_picture import DEGRADED, FAILED, FINE, HAZARDS, state
from benchmarks.timed_runs import Record, read_csv

CHARTS = ROOT / "outputs" / "shown" / "charts"
TEXT_WIDTH = 6.3
"""Width of the text of the article [inch]."""


class Colour(StrEnum):
    """Colours of Okabe and Ito."""

    BLACK = "#000000"
    BLUE = "#0072b2"
    ORANGE = "#d55e00"
    GREEN = "#009e73"
    PURPLE = "#cc79a7"
    SKY = "#56b4e9"
    YELLOW = "#f0e442"


STYLE = {
    "font.size": 8,
    "font.family": "DejaVu Sans",
    "axes.labelsize": 8,
    "axes.titlesize": 8,
    "legend.fontsize": 7,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "legend.frameon": False,
    "svg.fonttype": "path",
    "svg.hashsalt": "article",
    "mathtext.fontset": "dejavusans",
}


class OverfullFigureError(ValueError):
    """Part of a figure lies outside its canvas."""


@dataclass(frozen=True, kw_only=True)
class Plot:
    """A figure: its title, caption and sources, and the function that draws it."""

    title: str
    caption: str
    sources: tuple[str, ...]
    draw: Callable[[Numbers], Figure]
    width_share: float = 1.0

    def full_caption(self, numbers: Numbers) -> str:
        """Return the caption with its numbers, and command and version of each source."""
        caption = with_numbers(without_typed_numbers(self.caption, self.title), numbers)
        origins: dict[tuple[str, str], list[str]] = {}
        for source in self.sources:
            record = numbers[source]
            command, *options = record.command.split(" --set ")
            verb, _, last = command.rpartition(" ")
            name = " ".join([last, *(f"--set {option}" for option in options)])
            origins.setdefault((verb, record.version), []).append(name)
        shown = [
            f"`{verb}` with {', '.join(names)} ({version})"
            for (verb, version), names in origins.items()
        ]
        return f"{caption} " + (
            f"Made by {'; '.join(shown)}."
            if shown
            else "Made by `python docs/article/build.py`; no scene."
        )


def new_figure(height: float, columns: int = 1, **options):
    """Return a figure as wide as the text and its axes."""
    figure = Figure(figsize=(TEXT_WIDTH, height), layout="constrained")
    return figure, figure.subplots(1, columns, **options)


def draw_arrow(
    axes: Axes, start, end, colour: Colour = Colour.BLACK, style: str = "-|>"
) -> None:
    """Draw an arrow between two points."""
    axes.annotate(
        "", end, start, arrowprops={"arrowstyle": style, "color": colour, "lw": 1.2}
    )


def draw_frames(numbers: Numbers) -> Figure:
    """Draw the tilted disk on its table with the frames a and e, seen along a1."""
    figure, axes = new_figure(2.5)
    axes.set_axis_off()
    beta = np.radians(28.0)
    radius = 1.0
    half = 0.17
    along = np.array([-np.cos(beta), np.sin(beta)])
    axis = np.array([np.sin(beta), np.cos(beta)])
    contact = np.zeros(2)
    centre = radius * along + half * axis
    top = 2 * radius * along
    corners = [contact, top, top + 2 * half * axis, 2 * half * axis]
    axes.add_patch(Polygon(corners, fc="#e8eef4", ec=Colour.BLACK, lw=1.2))
    axes.plot([-2.2, 1.7], [0, 0], color=Colour.BLACK, lw=1.5)
    for x in np.arange(-2.2, 1.7, 0.12):
        axes.plot([x, x - 0.07], [0, -0.07], color=Colour.BLACK, lw=0.5)
    table_frame = np.array([0.95, 0.35])
    for start, direction, name, colour in (
        (centre, axis, "$e_2$", Colour.BLUE),
        (centre, along, "$e_3$", Colour.BLUE),
        (table_frame, np.array([1.0, 0.0]), "$a_2$", Colour.ORANGE),
        (table_frame, np.array([0.0, 1.0]), "$a_3$", Colour.ORANGE),
    ):
        draw_arrow(axes, start, start + 0.55 * direction, colour)
        place = start + 0.67 * direction
        axes.text(*place, name, color=colour, ha="center", va="center")
    axes.plot(*table_frame, "o", color=Colour.ORANGE, ms=4, mfc="w")
    axes.text(
        0.95,
        0.17,
        "$a_1 = e_1$ towards the reader",
        color=Colour.ORANGE,
        ha="center",
        fontsize=7,
    )
    axes.plot(*centre, "o", color=Colour.BLACK, ms=3)
    axes.text(centre[0] + 0.1, centre[1] - 0.09, "$C$")
    axes.plot(*contact, "o", color=Colour.BLACK, ms=4)
    axes.text(0.04, -0.2, "$P$")
    axes.add_patch(
        Arc(contact, 1.3, 1.3, theta1=180 - np.degrees(beta), theta2=180, lw=1)
    )
    axes.text(-0.74, 0.13, r"$\beta$")
    draw_arrow(axes, radius * along - 0.1 * axis, top - 0.1 * axis, style="<->")
    axes.text(*(1.5 * along - 0.22 * axis), "$R$", ha="center", va="center")
    beside = np.array([0.07, -0.03])
    draw_arrow(axes, beside, 2 * half * axis + beside, style="<->")
    axes.text(*(half * axis + (0.17, -0.06)), "$2H$", ha="left", va="center")
    draw_arrow(axes, contact, (0.0, 0.62), Colour.GREEN)
    axes.text(0.06, 0.6, "$N$", color=Colour.GREEN)
    draw_arrow(axes, (0, -0.001), (-0.45, -0.001), Colour.GREEN)
    axes.text(-0.42, -0.2, "$F$", color=Colour.GREEN)
    axes.set(xlim=(-2.3, 1.9), ylim=(-0.35, 1.4), aspect="equal")
    return figure


def chart_records(name: str) -> list[Record]:
    """Return the records of a chart, without methods that were not installed."""
    return [
        record for record in read_csv(CHARTS / f"{name}.csv") if not record.left_out
    ]


FAMILIES = {
    "event-driven": (Colour.BLUE, "o", "event-driven"),
    "naive sign()": (Colour.ORANGE, "x", "naive sign()"),
    "slip tolerance": (Colour.PURPLE, "v", "slip tolerance"),
    "tanh": (Colour.GREEN, "^", "tanh"),
    "Moreau": (Colour.BLACK, "s", "Moreau time-stepping"),
    "engine": (Colour.SKY, "D", "engines"),
    "ours": (Colour.BLUE, "o", "this program"),
    "uniform scikit-fem": (Colour.ORANGE, "x", "uniform elements"),
    "graded NGSolve": (Colour.GREEN, "^", "graded elements (NGSolve)"),
}


def draw_speed(numbers: Numbers) -> Figure:
    """Draw error against time for motion and modes."""
    figure, axes = new_figure(3.3, 2)
    for panel, chart, case, title in (
        (axes[0], "motion", "published", "published motion"),
        (axes[1], "modes", "patch", "modes of the held disk"),
    ):
        seen = set()
        for record in chart_records(chart):
            if record.case != case or record.failure or record.family not in FAMILIES:
                continue
            colour, marker, label = FAMILIES[record.family]
            panel.plot(
                record.seconds,
                max(record.error, 1e-15),
                marker,
                color=colour,
                ms=4,
                mfc="none" if marker in "sDv^" else colour,
                label=None if label in seen else label,
            )
            seen.add(label)
        panel.set(
            xscale="log",
            yscale="log",
            xlabel="computing time [s]",
            ylabel="relative error",
        )
        panel.set_title(title)
        panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=2)
    return figure


STATE_STYLES = {
    FINE: (Colour.BLUE, ""),
    DEGRADED: (Colour.YELLOW, ".."),
    FAILED: (Colour.ORANGE, "xx"),
}
"""Colour and hatch of the state of a run."""


def draw_stability(numbers: Numbers) -> Figure:
    """Draw the share of fine, degraded and failed runs of each family of methods in each hazard."""
    records = chart_records("stability")
    counts = Counter((record.family, record.case, state(record)) for record in records)
    families = sorted(
        {record.family for record in records}, key=lambda name: (name != "ours", name)
    )
    figure, axes = new_figure(0.55 + 0.24 * len(families))
    edge = {"ec": "#444444", "lw": 0.3}
    for x, hazard in enumerate(HAZARDS):
        for y, family in enumerate(families):
            total = sum(counts[family, hazard, name] for name in STATE_STYLES)
            left = x - 0.42
            for name, (colour, hatch) in STATE_STYLES.items():
                if not counts[family, hazard, name]:
                    continue
                width = 0.84 * counts[family, hazard, name] / total
                axes.barh(y, width, 0.7, left=left, color=colour, hatch=hatch, **edge)
                left += width
    titles = [hazard.title for hazard in HAZARDS.values()]
    axes.set_xticks(range(len(HAZARDS)), titles, rotation=30, ha="left")
    axes.xaxis.tick_top()
    axes.set_yticks(
        range(len(families)), ["this program" if f == "ours" else f for f in families]
    )
    axes.set(ylim=(len(families) - 0.5, -0.5), xlim=(-0.5, len(HAZARDS) - 0.5))
    axes.grid(False)
    for name, (colour, hatch) in STATE_STYLES.items():
        axes.barh(-5, 0, color=colour, hatch=hatch, label=name, **edge)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.02), ncols=3)
    return figure


def draw_published(numbers: Numbers) -> Figure:
    """Draw normal force, inclination and precession rate of the published motion."""
    figure, axes = new_figure(2.5, 2)
    t, low, high = numbers.curve("published.load")
    axes[0].fill_between(t, low, high, color=Colour.SKY, ec=Colour.BLUE, lw=0.6)
    axes[0].axhline(1.0, color=Colour.BLACK, lw=0.8, ls="--")
    axes[0].axhline(0.0, color=Colour.ORANGE, lw=1.0)
    axes[0].set(
        xlabel="time [s]",
        ylabel="normal force / weight",
        ylim=(-0.1, None),
        xlim=(0, t[-1]),
    )
    left, rate, inclination = numbers.curve("published.rate")
    axes[1].loglog(left, rate, color=Colour.BLUE, label="precession [Hz]")
    axes[1].loglog(
        left, inclination, color=Colour.ORANGE, ls="--", label="inclination [rad]"
    )
    axes[1].invert_xaxis()
    axes[1].set(xlabel="time before the end [s]")
    axes[1].legend(loc="lower left")
    return figure


SHORTEST_TIME_LEFT = 0.05
"""Time left [s] below which the decay laws are not drawn: falls and hops end some motions."""
RATE_STYLES = {
    "published": (Colour.BLACK, "-", "published: arms of the paper, $n = 1$"),
    "coin": (Colour.ORANGE, "--", "coin: impacts, $n = 1/2$"),
    "contour": (Colour.BLUE, "-.", "contour friction, $n = 1/3$"),
    "boundary_layer": (Colour.GREEN, ":", "boundary layers, $n = 2/9$"),
    "moffatt": (Colour.PURPLE, (0, (5, 1)), "viscous film, $n = 1/6$"),
    "toy": (Colour.SKY, (0, (3, 1, 1, 1)), "toy in air"),
}


def draw_laws(numbers: Numbers) -> Figure:
    """Draw the precession rate against the time left for each law."""
    figure, axes = new_figure(3.1)
    for name, (colour, style, label) in RATE_STYLES.items():
        left, rate, _ = numbers.curve(f"{name}.rate")
        shown = np.array(left) > SHORTEST_TIME_LEFT
        axes.loglog(
            np.array(left)[shown],
            np.array(rate)[shown],
            color=colour,
            ls=style,
            lw=1.4,
            label=label,
        )
    axes.invert_xaxis()
    axes.set(
        xlabel="time before the end of the motion [s]",
        ylabel="precession rate [Hz]",
        ylim=(1, 3e3),
    )
    axes.legend(loc="upper left")
    return figure


def draw_contact(numbers: Numbers) -> Figure:
    """Draw the contact resonance predicted and heard on granite and glass."""
    figure, axes = new_figure(2.6, 2)
    for panel, name in zip(axes, ("granite", "glass"), strict=True):
        t, _, frequency = numbers.curve(f"{name}.resonance")
        panel.plot(
            t,
            np.divide(frequency, 1e3),
            color=Colour.SKY,
            lw=1.2,
            label="resonance of the contact",
        )
        t, expected = numbers.curve(f"{name}.expected")
        panel.plot(
            t,
            np.divide(expected, 1e3),
            color=Colour.BLACK,
            lw=1.2,
            ls="--",
            label="band predicted for contact and air",
        )
        t, heard = numbers.curve(f"{name}.heard")
        panel.plot(
            t,
            np.divide(heard, 1e3),
            "o",
            color=Colour.ORANGE,
            ms=2.5,
            mfc="none",
            label="noise band in the sound",
        )
        panel.set(xlabel="time [s]", ylabel="frequency [kHz]")
        panel.set_title(name)
    axes[0].legend(loc="upper left")
    return figure


def draw_coin(numbers: Numbers) -> Figure:
    """Draw the precession rate of rattling coins against the time left."""
    figure, axes = new_figure(2.8)
    for k, seed in enumerate(("coin", "coin-seed-2", "coin-seed-3", "coin-seed-4")):
        left, rate, _ = numbers.curve(f"{seed}.rate")
        axes.loglog(
            left,
            rate,
            color=Colour.BLUE,
            lw=0.8,
            ls=("-", "--", "-.", ":")[k],
            label=f"coin, seed {k + 1}",
        )
    at_one = numbers.number("coin.rate_is_that_of_the_table.rate_at_1s").value
    left = np.geomspace(0.02, 2.0, 20)
    axes.loglog(
        left,
        at_one / np.sqrt(left),
        color=Colour.BLACK,
        lw=1.2,
        label="impacts alone, $n = 1/2$",
    )
    axes.invert_xaxis()
    axes.set(
        xlabel="time before the end of the motion [s]",
        ylabel="precession rate [Hz]",
        xlim=(2.0, 0.02),
    )
    axes.legend(loc="upper left", ncols=2)
    return figure


def draw_tables(numbers: Numbers) -> Figure:
    """Draw the end of the motion on one mode against its mass, and the level of a plate."""
    figure, axes = new_figure(2.7, 2)
    mass, pressure, end, kept = map(np.array, numbers.curve("sweep-halt-table.halt"))
    pressures = sorted(set(pressure))
    for k, p in enumerate(
        (pressures[0], pressures[len(pressures) // 2], pressures[-1])
    ):
        chosen = pressure == p
        order = np.argsort(mass[chosen])
        x, y, held = (values[chosen][order] for values in (mass, end, kept))
        colour = (Colour.BLUE, Colour.ORANGE, Colour.GREEN, Colour.PURPLE)[k % 4]
        axes[0].plot(x, y, color=colour, lw=1, label=f"{float(f'{p:.2g}'):g} Pa")
        axes[0].plot(x[held > 0], y[held > 0], "o", color=colour, ms=4)
        axes[0].plot(x[held == 0], y[held == 0], "X", color=colour, ms=5)
    axes[0].plot([], [], "o", color=Colour.BLACK, ms=4, label="contact kept")
    axes[0].plot([], [], "X", color=Colour.BLACK, ms=5, label="contact broken")
    axes[0].set(
        xscale="log",
        xlabel="modal mass of the table [kg]",
        ylabel="end of the motion [s]",
    )
    axes[0].legend(loc="best")
    thickness, distance, level = map(np.array, numbers.curve("sweep-pitch.louder"))
    for k, d in enumerate(sorted(set(distance))):
        chosen = distance == d
        order = np.argsort(thickness[chosen])
        axes[1].plot(
            1e3 * thickness[chosen][order],
            level[chosen][order],
            marker="osD^v"[k % 5],
            ms=3,
            lw=1,
            color=(
                Colour.BLUE,
                Colour.ORANGE,
                Colour.GREEN,
                Colour.PURPLE,
                Colour.BLACK,
            )[k % 5],
            label=f"{d:.2g} m",
        )
    axes[1].axhline(0.0, color=Colour.BLACK, lw=0.8, ls="--")
    axes[1].set(xlabel="thickness of the plate [mm]", ylabel="table over disk [dB(A)]")
    axes[1].legend(loc="best", title="distance", title_fontsize=7)
    return figure


FIGURES = {
    "frames": Plot(
        title="Frames and symbols",
        caption="Disk on its table, seen along the horizontal diameter: table frame a, disk frame e, contact P, "
        "centre C, normal force N and friction F.",
        sources=(),
        draw=draw_frames,
        width_share=0.8,
    ),
    "speed": Plot(
        title="Speed against accuracy",
        caption="Error against computing time. Left: inclination and energy over "
        "[[quoted.speed_chart_time_units|.0f]] time units of the published motion. Right: frequencies of "
        "the disk held on an arc of [[scene.published.support.half_angle_deg|.0f*2]] degrees. Failed runs "
        "are left out.",
        sources=("chart-motion", "chart-modes"),
        draw=draw_speed,
    ),
    "stability": Plot(
        title="Stability map",
        caption="Shares of runs that are fine, degraded or failed as one parameter approaches a limit. "
        "No bar: the hazard does not concern the family.",
        sources=("chart-stability",),
        draw=draw_stability,
    ),
    "published": Plot(
        title="The published motion",
        caption="Scene `published`. Left: range of the normal force; dashed line: weight; solid line: loss "
        "of contact. Right: precession rate and inclination against the time before the end.",
        sources=("published",),
        draw=draw_published,
    ),
    "contact": Plot(
        title="The contact resonance",
        caption="The toy on granite ([[scene.granite.roughness.rms|.2f*1e6]] µm of roughness on table and "
        "edge) and on glass (edge alone). Points: noise band tracked in the pressure alone. Dashed line: "
        "band predicted from the excitation, the contact and the radiation into the air. Solid line: resonance of "
        "the disk on its contact.",
        sources=("granite", "glass"),
        draw=draw_contact,
    ),
    "coin": Plot(
        title="Rattling coins",
        caption="Precession rate of a rattling coin for four seeds of the heights. Straight line: law of impacts "
        "alone, which contains neither radius nor mass.",
        sources=("coin", "coin-seed-2", "coin-seed-3", "coin-seed-4"),
        draw=draw_coin,
    ),
    "laws": Plot(
        title="Decay laws",
        caption="Precession rate against the time before the end, for six causes that slow the disk. The last "
        "moments, in which falls and hops end some motions, are left out.",
        sources=tuple(RATE_STYLES),
        draw=draw_laws,
    ),
    "tables": Plot(
        title="Tables",
        caption="Left: end of the motion on one mode of a table against its modal mass, at three pressures of "
        "the air. Right: level of the sound of a supported glass plate relative to that of the disk, "
        "median over the motion, for listeners at several distances.",
        sources=("sweep-halt-table", "sweep-pitch"),
        draw=draw_tables,
    ),
}
"""Figures by name, in the order of the article."""


def check_inside(name: str, figure: Figure) -> None:
    """Raise OverfullFigureError if a part of a figure lies outside its canvas."""
    figure.draw_without_rendering()
    box = figure.get_tightbbox()
    slack = 0.02  # inch
    width, height = figure.get_size_inches()
    if (
        box.x0 < -slack
        or box.y0 < -slack
        or box.x1 > width + slack
        or box.y1 > height + slack
    ):
        raise OverfullFigureError(
            f"{name}: {box} lies outside {width:g} x {height:g} inch"
        )


def write_figures(numbers: Numbers, folder: Path) -> None:
    """Draw all figures as SVG. Raises MissingNumberError and OverfullFigureError."""
    folder.mkdir(parents=True, exist_ok=True)
    with mpl.rc_context(STYLE):
        for name, plot in FIGURES.items():
            figure = plot.draw(numbers)
            check_inside(name, figure)
            with atomic_write(folder / f"{name}.svg") as temporary:
                figure.savefig(
                    temporary, format="svg", metadata={"Date": None, "Creator": None}
                )
