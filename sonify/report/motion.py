"""MOTION -> PICTURE: the paper's figures 3 to 6."""

import numpy as np

from sonify.report.figure import figure_at

TITLES = (
    ("α [rad]", "Figure 3 (a): angle of the disk to the upright"),
    ("Ê", "Figure 3 (b): energy"),
    ("Φ", "Figure 4 (a): normal force"),
    ("f̂", "Figure 4 (b): frequency of the normal force"),
    ("y/R", "Figure 5: path of the centre"),
    ("dθ/dτ", "Figure 6: rate of precession"),
)


def draw_motion(path, curves, weight: float):
    """Draw the `curves` (x, y) of the paper's figures 3 to 6, and the normal force of a disk at rest."""
    with figure_at(path, 3, 2, (11, 11)) as (_, axes):
        for panel, (x, y), (label, title) in zip(axes.flat, curves, TITLES, strict=True):
            panel.plot(x, y, color="k", lw=0.6)
            panel.set(xlabel="time τ = t/χ", ylabel=label, title=title)
            panel.grid(alpha=0.3)
        for panel, height, name in ((axes[0, 0], np.pi / 2, "flat"), (axes[1, 0], weight, "weight")):
            panel.axhline(height, color="0.5", lw=1.2, ls="--", label=name)
            panel.legend(loc="lower right", fontsize=8, framealpha=1)
        axes[1, 1].set(ylim=(0, 4))
        axes[2, 0].set(xlabel="x/R", aspect="equal", adjustable="datalim")
        lowest, highest = np.percentile(curves[5][1], [1, 99])
        axes[2, 1].set(ylim=(1.1 * min(lowest, -1.0), 1.1 * max(highest, 0.0)))
