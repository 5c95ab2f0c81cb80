"""MOTION -> PICTURES: the paper's figures 3 to 6, and where the energy goes on a table that acts back."""

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


def draw_motion(path, curves, weight: float, paper: tuple[float, float] | None = None):
    """Draw the `curves` (x, y) of the paper's figures 3 to 6, and the normal force of a disk at rest; of the `paper`'s
    scene what it says besides: where the angle begins, and the frequency of the normal force that it names, and when.
    """
    with figure_at(path, 3, 2, (11, 11)) as (_, axes):
        for panel, (x, y), (label, title) in zip(axes.flat, curves, TITLES, strict=True):
            panel.plot(x, y, color="k", lw=0.6)
            panel.set(xlabel="time τ = t/χ", ylabel=label, title=title)
            panel.grid(alpha=0.3)
        for panel, height, name in ((axes[0, 0], np.pi / 2, "flat"), (axes[1, 0], weight, "weight")):
            panel.axhline(height, color="0.5", lw=1.2, ls="--", label=name)
        if paper is not None:
            axes[0, 0].plot(0, 1.0, "o", color="#d55e00", label="the paper: α = 1.0 at τ = 0")
            axes[0, 1].annotate("the paper: steeper in each slide", (0.35, 0.8), xycoords="axes fraction")
            axes[1, 0].axhline(0, color="#d55e00", lw=1.2, label="the paper: never reached")
            axes[1, 1].axhline(paper[0], color="#d55e00", lw=1.2, ls="--", label=f"the paper: {paper[0]:g} is 36 Hz")
            axes[1, 1].plot(paper[1], paper[0], "o", color="#d55e00", label=f"reached at τ = {paper[1]:g}")
        for panel in (axes[0, 0], axes[1, 0], *([axes[1, 1]] if paper else [])):
            panel.legend(loc="best", fontsize=8, framealpha=1)
        axes[1, 1].set(ylim=(0, 4))
        axes[2, 0].set(xlabel="x/R", aspect="equal", adjustable="datalim")
        lowest, highest = np.percentile(curves[5][1], [1, 99])
        axes[2, 1].set(ylim=(1.1 * min(lowest, -1.0), 1.1 * max(highest, 0.0)))


STYLES = "-", "--", ":", "-.", (0, (5, 1)), (0, (1, 3)), (0, (7, 2, 1, 2, 1, 2)), (0, (3, 1))
LEAST = 1e-6
"""Energies are shown down to this part of the greatest."""


def draw_energy(path, left, held: dict, lost: dict):
    """Draw the energies [J] that are `held`, and what was `lost` since, by name (k,), at times `left` [s]."""
    with figure_at(path, 1, 2, (11, 4.6)) as (_, axes):
        for panel, curves, title in zip(axes, (held, lost), ("What holds energy", "What took energy"), strict=True):
            most = max(curve.max() for curve in curves.values())
            shown = {name: curve for name, curve in curves.items() if curve.max() > LEAST * most}
            for (name, curve), style in zip(shown.items(), STYLES, strict=False):
                panel.plot(left, curve, ls=style, lw=1.2, label=name)
            panel.set(xscale="log", yscale="log", xlim=(left[0], left[-1]), ylim=(LEAST * most, 2 * most))
            panel.set(xlabel="time left until the disk lies flat [s]", ylabel="energy [J]", title=title)
            panel.grid(alpha=0.3)
            panel.legend(loc="best", fontsize=8, framealpha=1)
