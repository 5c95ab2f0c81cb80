"""Lay out figures in a common style and write them as PNG files."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, MaxNLocator, NullLocator, ScalarFormatter
from numpy.lib.stride_tricks import sliding_window_view
from PIL import Image

from sonify.runtime.files import readable_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

PicturePath = str | PathLike[str] | BinaryIO
"""Path of a picture, or the open file to which it is written."""


@contextmanager
def png_figure(
    path: PicturePath,
    rows: int,
    columns: int,
    size: tuple[float, float],
    **options: Any,
) -> Iterator[tuple[Figure, Any]]:
    """Yield a figure of `size` [in] with axes (rows, columns).

    On exit, write it to `path`, a path or an open file, as an opaque PNG of 256
    colours.
    """
    dots_per_inch = 110
    figure = Figure(figsize=size, dpi=dots_per_inch)
    axes = figure.subplots(rows, columns, **options)
    inches = {
        "left": 0.75 / size[0],
        "right": 1 - 0.6 / size[0],
        "bottom": 0.6 / size[1],
        "top": 1 - 0.5 / size[1],
    }
    figure.subplots_adjust(**inches, wspace=0.25, hspace=0.27)
    yield figure, axes
    for panel in np.ravel(axes):
        _fix_layout(panel)
    canvas = FigureCanvasAgg(figure)
    with warnings.catch_warnings():
        # a file name in letters that the font does not have is drawn with boxes
        warnings.filterwarnings("ignore", "Glyph .* missing from font")
        canvas.draw()
    drawn = Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3])
    drawn.quantize(256, Image.Quantize.FASTOCTREE).save(path, "PNG", compress_level=6)


def _fix_layout(panel: "Axes") -> None:
    """Limit the number of ticks and fix the positions of title and axis labels.

    Many ticks are slow to draw, and matplotlib would measure every tick to place the
    labels.
    """
    plain_exponents = (-2, 5)  # longer numbers would overlap the axis label
    for axis in (panel.xaxis, panel.yaxis):
        if axis.get_scale() == "linear":
            axis.set_major_locator(MaxNLocator(6, steps=(1, 2, 5, 10)))
            formatter = axis.get_major_formatter()
            if isinstance(formatter, ScalarFormatter):
                formatter.set_powerlimits(plain_exponents)
    width, height = np.asarray(panel.get_window_extent().size) / panel.figure.dpi
    for side in ("left", "center"):
        panel.set_title(panel.get_title(side), loc=side, y=1.0)
    panel.xaxis.set_label_coords(0.5, -0.3 / height)
    panel.yaxis.set_label_coords(-0.58 / width, 0.5)


def file_label(path: str | PathLike[str]) -> str:
    """Return the name of a file as a label; dollars in it do not begin a formula."""
    return readable_text(Path(path).name).replace("$", r"\$").lstrip("_")


def label_plain_decades(
    axis: "Axis", multiples: tuple[float, ...] = (1.0, 2.0, 5.0)
) -> None:
    """Label a logarithmic axis with plain numbers at `multiples` of powers of ten.

    Numbers with exponents would load a parser of formulas.
    """
    axis.set_major_locator(LogLocator(subs=multiples))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_locator(NullLocator())


def place_legend_above(panel: "Axes", columns: int = 3, **options: Any) -> None:
    """Place the legend above the right end of a panel; the title is at the left."""
    panel.legend(
        loc="lower right",
        bbox_to_anchor=(1.0, 1.0),
        borderaxespad=0.2,
        ncols=columns,
        fontsize=8,
        handlelength=2.5,
        columnspacing=1.2,
        **options,
    )


def running_range(
    y: np.ndarray, share: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the running mean, minimum and maximum (c,) of evenly spaced samples y
    (k,).

    The window contains a `share` of the k samples, and c is about the width of a figure
    in pixels. Minimum and maximum are those of the deviation from the mean, so that a
    mere trend does not produce a band; they never exceed the range of y within the
    window.
    """
    column_count = 1000
    size = max(round(share * len(y)), 1)
    padded = np.pad(y, (size // 2, size - 1 - size // 2), mode="edge")
    sums = np.concatenate([[0.0], np.cumsum(padded)])
    mean = (sums[size:] - sums[:-size]) / size
    deviation = np.pad(y - mean, (size // 2, size - 1 - size // 2), mode="edge")
    every = slice(None, None, max(len(y) // column_count, 1))
    values, deviations = (
        sliding_window_view(samples, size)[every] for samples in (padded, deviation)
    )
    mean = mean[every]
    lower = np.maximum(mean + deviations.min(axis=1), values.min(axis=1))
    upper = np.minimum(mean + deviations.max(axis=1), values.max(axis=1))
    return mean, lower, upper
