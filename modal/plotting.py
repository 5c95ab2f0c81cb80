"""Plot the frequencies of modes against order and their decay times against
frequency."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from modal.modes import Modes

MARKERS = {"flexural": "o", "extensional": "s", "torsional": "^"}
"""Marker of each family of modes."""


def plot_modes(modes: "Modes") -> "Figure":
    """Return a figure of frequencies and decay times, with one marker per family."""
    from matplotlib.figure import Figure  # slow to import
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(9.0, 4.0), layout="constrained")
    orders, decays = figure.subplots(1, 2)
    for family in dict.fromkeys(modes.family):
        chosen = np.flatnonzero(np.asarray(modes.family) == family)
        style = {"linestyle": "", "marker": MARKERS.get(family, "x"), "label": family}
        orders.plot(modes.order[chosen], modes.frequency[chosen] / 1e3, **style)
        decays.plot(modes.frequency[chosen] / 1e3, modes.decay_time[chosen], **style)
    orders.set(xlabel="order", ylabel="frequency [kHz]")
    orders.xaxis.set_major_locator(MaxNLocator(integer=True))
    decays.set(xlabel="frequency [kHz]", ylabel="decay time T60 [s]", yscale="log")
    for panel in (orders, decays):
        panel.grid(alpha=0.3)
    if len(modes.family):
        orders.legend(frameon=False)
    return figure
