"""FIGURE -> PNG: the frame that every picture shares."""

from contextlib import contextmanager

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, ScalarFormatter
from PIL import Image

DPI, MOST_TICKS = 110, 6
SHORT = -2, 5
"""Powers of ten that are written out: longer numbers would run into the name of their axis."""


@contextmanager
def figure_at(path, rows, columns, size, **options):
    """A figure of `size` [in] with axes (rows, columns), written to a path or file as opaque PNG when it ends."""
    figure = Figure(figsize=size, dpi=DPI)
    axes = figure.subplots(rows, columns, **options)
    inches = {"left": 0.75 / size[0], "right": 1 - 0.6 / size[0], "bottom": 0.6 / size[1], "top": 1 - 0.5 / size[1]}
    figure.subplots_adjust(**inches, wspace=0.25, hspace=0.27)
    yield figure, axes
    for panel in np.ravel(axes):
        _fix(panel)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3]).save(path, "PNG", compress_level=3)


def _fix(panel):
    """Few ticks, title and labels in fixed places: matplotlib would measure every tick to find them; both take long."""
    for axis in (panel.xaxis, panel.yaxis):
        if axis.get_scale() == "linear":
            axis.set_major_locator(MaxNLocator(MOST_TICKS, steps=(1, 2, 5, 10)))
            if isinstance(axis.get_major_formatter(), ScalarFormatter):
                axis.get_major_formatter().set_powerlimits(SHORT)
    width, height = panel.get_window_extent().size / DPI
    panel.set_title(panel.get_title(), y=1.0)
    panel.xaxis.set_label_coords(0.5, -0.3 / height)
    panel.yaxis.set_label_coords(-0.58 / width, 0.5)
