"""Draw maps of sweep results over one or two axes.

Contours show numbers, markers show categories, and crosses show failed runs.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass
from itertools import cycle
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm
from matplotlib.contour import ContourSet
from matplotlib.ticker import LogFormatterMathtext, LogLocator, NullFormatter
from matplotlib.tri import Triangulation

from sonify.report.figure import PicturePath, png_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MARKER_SYMBOLS = "osD^vP*Xhp<>d8H"
MARKER_COLOURS = (
    "#0072b2",
    "#d55e00",
    "#009e73",
    "#000000",
    "#cc79a7",
    "#56b4e9",
    "#e69f00",
)
"""Colours that colour-blind readers can distinguish; the markers differ in greyscale
print."""


@dataclass(frozen=True, kw_only=True)
class Map:
    """Map of column `drawn_column` over column `x` and, optionally, column `y`.

    `columns` contains lists by name, with None for missing values. Columns in `logs`
    have logarithmic scales; `units` contains the units by column.
    """

    x: str
    y: str | None
    drawn_column: str
    columns: dict[str, list[Any]]
    logs: set[str]
    units: dict[str, str]

    def points(self) -> dict[tuple[Any, ...], list[Any]]:
        """Return the non-missing values at each point (x,) or (x, y)."""
        found: dict[tuple[Any, ...], list[Any]] = defaultdict(list)
        for *place, value in zip(
            *(self.columns[name] for name in (*self.axis_names, self.drawn_column)),
            strict=True,
        ):
            found[tuple(place)] += [] if value is None else [value]
        return found

    def label_with_unit(self, name: str) -> str:
        """Return the name of a column with its unit, if it has one."""
        return f"{name} [{self.units[name]}]" if name in self.units else name

    @property
    def axis_names(self) -> list[str]:
        """The names of the axes."""
        return [name for name in (self.x, self.y) if name]


def draw_map(what: Map, path: PicturePath) -> None:
    """Draw a map to a PNG file.

    Runs that differ only in other parameters share a point, which shows their median or
    most frequent category.
    """
    points = what.points()
    values = [value for found in points.values() for value in found]
    shared = max(map(len, points.values()))
    with png_figure(path, 1, 1, (8, 5.5)) as (figure, panel):
        figure.subplots_adjust(left=0.13)
        where = {
            name: _label_axis(panel, k, name, what)
            for k, name in enumerate(what.axis_names)
        }
        places = np.array(
            [
                [where[name][v] for name, v in zip(what.axis_names, place, strict=True)]
                for place in points
            ]
        )
        known = np.array([bool(found) for found in points.values()])
        present = [found for found in points.values() if found]
        if all(isinstance(value, float) for value in values):
            statistic = "median"
            medians = [np.median(found) for found in present]
            _draw_numbers(figure, panel, places[known], medians, what)
        else:
            statistic = "most frequent"
            names = [_most_frequent_category(found) for found in present]
            figure.subplots_adjust(right=0.77)
            _draw_categories(panel, places[known], names)
        _draw_failed_runs(panel, places[~known])
        several = f", {statistic} of up to {shared} runs" if shared > 1 else ""
        panel.set_title(f"{what.drawn_column}{several}", loc="left")


def _label_axis(panel: "Axes", k: int, name: str, what: Map) -> dict[Any, Any]:
    """Scale and label an axis of the panel, and return the coordinate of each value on
    it."""
    values = list(dict.fromkeys(what.columns[name]))
    axis = (panel.xaxis, panel.yaxis)[k]
    axis.set_label_text(what.label_with_unit(name))
    if all(
        isinstance(value, int | float) and not isinstance(value, bool)
        for value in values
    ):
        if name in what.logs:
            (panel.set_xscale, panel.set_yscale)[k]("log")
            short = min(values) >= 1e-3 and max(values) < 1e6
            axis.set_major_formatter("{x:g}" if short else LogFormatterMathtext())
            axis.set_minor_locator(LogLocator(subs=(2, 3, 5)))
            axis.set_minor_formatter(
                NullFormatter() if max(values) > 12 * min(values) else "{x:g}"
            )
        return {value: value for value in values}
    words = sorted(values, key=str)
    axis.set_major_formatter(
        lambda at, _: _category_name(words[int(at)]) if at in range(len(words)) else ""
    )
    return {value: words.index(value) for value in values}


def _draw_numbers(
    figure: "Figure", panel: "Axes", places: np.ndarray, values: list[float], what: Map
) -> None:
    if places.shape[1] == 1:
        order = places[:, 0].argsort()
        panel.plot(places[order, 0], np.array(values)[order], "k.-", lw=0.8)
        panel.set_ylabel(what.label_with_unit(what.drawn_column))
        return
    scaled = places.copy()
    for column, name in enumerate(what.axis_names):
        if name in what.logs:
            scaled[:, column] = np.log(places[:, column])
    within = (scaled - scaled.min(axis=0)) / np.maximum(np.ptp(scaled, axis=0), 1e-300)
    collinear = np.linalg.matrix_rank(within - within.mean(axis=0), 1e-6) < 2
    if collinear or len(places) < 4:
        x, y = places.T
        drawn: ScalarMappable = panel.scatter(x, y, c=values, cmap="viridis")
    else:
        around = Triangulation(within[:, 0], within[:, 1])
        mesh = Triangulation(places[:, 0], places[:, 1], around.triangles)
        levels, scale = _contour_levels(values)
        drawn = panel.tricontourf(mesh, values, levels, cmap="viridis", norm=scale)
        panel.tricontour(mesh, values, levels, colors="k", linewidths=0.4)
        panel.plot(*places.T, "k.", ms=1.5)
    bar = figure.colorbar(
        drawn, ax=panel, label=what.label_with_unit(what.drawn_column)
    )
    if isinstance(drawn, ContourSet) and isinstance(drawn.norm, LogNorm):
        labels = [f"{level:.2g}" for level in drawn.levels]
        bar.set_ticks(list(drawn.levels), labels=labels, minor=False)


def _contour_levels(values: list[float]) -> tuple[int | np.ndarray, LogNorm | None]:
    """Return contour levels and norm; they are logarithmic for positive values with a
    ratio above 300."""
    level_count = 12
    low = min(values)
    high = max(values)
    if not 0 < 300 * low < high:
        return level_count, None
    return np.geomspace(low, high * (1 + 1e-9), level_count), LogNorm(low, high)


def _draw_categories(panel: "Axes", places: np.ndarray, words: list[str]) -> None:
    names = sorted(set(words))
    for name, mark, colour in zip(
        names, cycle(MARKER_SYMBOLS), cycle(MARKER_COLOURS), strict=False
    ):
        here = places[np.array(words) == name]
        y = _vertical_positions(here, names.index(name))
        label = fill(name.replace("_", " "), width=16)
        panel.plot(here[:, 0], y, mark, color=colour, ls="", label=label)
    place_legend(panel)


def _draw_failed_runs(panel: "Axes", places: np.ndarray) -> None:
    if len(places):
        y = _vertical_positions(places, panel.get_ylim()[0])
        panel.plot(places[:, 0], y, "rx", ms=7, label="no value", clip_on=False)
        place_legend(panel)


def _vertical_positions(places: np.ndarray, at: float) -> np.ndarray:
    """Return the y coordinates (n,) of points; in a map over one axis they equal
    `at`."""
    return places[:, 1] if places.shape[1] == 2 else np.full(len(places), at)


def place_legend(panel: "Axes") -> None:
    """Place the legend to the right of the panel, or inside it if there is a colour
    bar."""
    if len(panel.figure.axes) == 1:
        panel.legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False)
    else:
        panel.legend(loc="best", frameon=False)


def _most_frequent_category(values: list[Any]) -> Any:
    return Counter(map(_category_name, values)).most_common(1)[0][0]


def _category_name(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value)
