"""Draw time histories of a motion in SI units, the paper's figures 3 to 6, and
energies.

Energies are drawn for motions with two-way coupling to the table.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from sonify.claims.energy_causes import CAUSE_IN_WORDS
from sonify.report.figure import (
    PicturePath,
    label_plain_decades,
    place_legend_above,
    png_figure,
    running_range,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PAPER_PANELS = (
    ("angle from the vertical α [rad]", "Figure 3 (a) of the paper"),
    ("energy Ê", "Figure 3 (b)"),
    ("normal force Φ", "Figure 4 (a)"),
    ("frequency of the normal force f̂", "Figure 4 (b)"),
    ("y/R", "Figure 5: path of the centre"),
    ("precession rate dθ/dτ", "Figure 6"),
)
"""Axis label and panel title of each of the paper's figures."""
ENERGY_UNITS = {1.0: "J", 1e-3: "mJ", 1e-6: "µJ", 1e-9: "nJ"}
"""Symbol of each energy unit, by its size [J]."""


def draw_motion(
    path: PicturePath, motion: dict[str, Any], paper: dict[str, Any] | None = None
) -> None:
    """Draw a motion in SI units.

    If `paper` is given (for the paper's scene), the dimensionless figures 3 to 6 are
    drawn below.
    """
    rows = 6 if paper else 3
    with png_figure(path, rows, 2, (11, 3.67 * rows)) as (_, axes):
        _draw_si(axes[:3], **motion)
        if paper:
            _draw_paper(axes[3:], **paper)


def _draw_range(
    panel: "Axes", time: np.ndarray, curve: np.ndarray, colour: str
) -> None:
    """Draw the running range and mean of a curve (k,) over the time (k,) [s]."""
    averaging_share = 0.015  # window, as a fraction of the duration
    mean, lower, upper = running_range(curve, averaging_share)
    at = np.linspace(time[0], time[-1], len(mean))
    panel.fill_between(at, lower, upper, fc="#9bd1f0", ec=colour, lw=0.8, label="range")
    label = f"mean over {averaging_share * np.ptp(time):.2g} s"
    panel.plot(at, mean, color=colour, lw=1.0, label=label)


def _draw_si(
    axes: np.ndarray,
    *,
    time: np.ndarray,
    inclination: np.ndarray,
    energy: np.ndarray,
    force: tuple[np.ndarray, float],
    centre: np.ndarray,
    rates: np.ndarray,
    before_end: np.ndarray,
) -> None:
    """Draw the curves over `time` (k,) [s] and the path of the `centre` (2, k) [mm].

    The curves are inclination [degrees], energy [J], and force and weight [N], which is
    drawn as a reference for the force. The rows of `rates` and `before_end` (3, q) are
    times [s], precession [Hz] and nutation [Hz].
    """
    blue = "#0072b2"
    (tilt, held, load) = axes[:, 0]
    normal, weight = force
    (hertz, end, path) = axes[[1, 2, 0], 1]
    _draw_range(tilt, time, inclination, blue)
    _draw_range(load, time, normal, blue)
    load.axhline(weight, color="k", lw=1.0, ls="--", label="weight")
    size = next((size for size in ENERGY_UNITS if energy.max() >= size), 1e-9)
    held.plot(time, energy / size, color="k", lw=1.2)
    path.plot(*centre, color="k", lw=0.6)
    for panel, (instants, precession, nutation) in ((hertz, rates), (end, before_end)):
        panel.plot(instants, precession, color="k", lw=1.2, label="precession")
        panel.plot(instants, nutation, color=blue, lw=1.2, ls="--", label="nutation")
        panel.set(yscale="log", ylabel="frequency [Hz]")
        label_plain_decades(panel.yaxis)
    for panel in (tilt, held, load, hertz):
        panel.set(xlabel="time [s]", xlim=(time[0], time[-1]))
    tilt.set(ylabel="inclination [degrees]", ylim=(0, None))
    held.set(ylabel=f"energy [{ENERGY_UNITS[size]}]", ylim=(0, None))
    load.set(ylabel="normal force [N]")
    hertz.set(ylim=_frequency_limits(rates))
    end.set(xscale="log", xlabel="time before the end [s]")
    label_plain_decades(end.xaxis, (1.0,))
    end.invert_xaxis()
    path.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", adjustable="datalim")
    titles = {
        tilt: "Inclination",
        held: "Energy",
        load: "Normal force",
        path: "Path of the centre",
        hertz: "Rates",
        end: "Rates towards the end",
    }
    for panel, title in titles.items():
        panel.set_title(title, loc="left")
        panel.grid(alpha=0.3)
    for panel in (tilt, load, hertz, end):
        place_legend_above(panel, frameon=False)


def _frequency_limits(rates: np.ndarray) -> tuple[float, float]:
    """Return the limits of the frequency axis [Hz] for the rates (3, q).

    The last thousandth of the duration is ignored.
    """
    time = rates[0]
    seen = np.concatenate(
        [curve[time <= time[-1] - 1e-3 * np.ptp(time)] for curve in rates[1:]]
    )
    seen = seen[np.isfinite(seen) & (seen > 0)]
    return (seen.min() / 1.2, seen.max() * 1.2) if len(seen) else (1.0, 10.0)


def _draw_paper(
    axes: np.ndarray,
    *,
    curves: tuple[tuple[np.ndarray, np.ndarray], ...],
    weight: float,
    chi: float,
    frequency: float,
    reached: float,
) -> None:
    """Draw the `curves` (x, y) of the paper's figures 3 to 6 with the paper's
    statements.

    `chi` [s] is the unit of time, and `weight` is given in the units of the
    normal-force curve. According to the paper, the motion reaches `frequency` [1/chi]
    at the time `reached` [chi].
    """
    orange = "#d55e00"
    for panel, (x, y), (label, title) in zip(
        axes.flat, curves, PAPER_PANELS, strict=True
    ):
        panel.plot(x, y, color="k", lw=0.6)
        panel.set(xlabel=f"time τ = t/χ, χ = {chi:.4g} s", ylabel=label)
        panel.set_title(title, loc="left")
        panel.grid(alpha=0.3)
    (alpha, energy), (load, rate), (path, precession) = axes
    alpha.axhline(np.pi / 2, color="0.5", lw=1.2, ls="--", label="flat")
    alpha.plot(0, 1.0, "o", color=orange, label="paper: α(0) = 1")
    energy.plot([], [], " ", label="paper: steeper in each slide")
    load.axhline(weight, color="0.5", lw=1.2, ls="--", label="weight")
    load.axhline(0, color=orange, lw=1.2, label="paper: never reached")
    rate.axhline(
        frequency, color=orange, lw=1.2, ls="--", label=f"paper: {frequency:g} is 36 Hz"
    )
    rate.plot(reached, frequency, "o", color=orange, label=f"τ = {reached:g}")
    for panel in (alpha, energy, load, rate):
        place_legend_above(panel, frameon=False)
    rate.set(ylim=(0, 4))
    path.set(xlabel="x/R", aspect="equal", adjustable="datalim")
    lowest, highest = np.percentile(curves[5][1], [1, 99])
    precession.set(ylim=(1.1 * min(lowest, -1.0), 1.1 * max(highest, 0.0)))


LINE_STYLES = (
    "-",
    "--",
    ":",
    "-.",
    (0, (5, 1)),
    (0, (1, 3)),
    (0, (7, 2, 1, 2, 1, 2)),
    (0, (3, 1)),
)


def draw_energy(
    path: PicturePath, left: np.ndarray, held: dict[str, Any], lost: dict[str, Any]
) -> None:
    """Draw energies [J] over the time `left` (k,) [s] until the end of the motion.

    `held` are the stored energies and `lost` the cumulative losses, (k,) by name.
    """
    # Smallest energy drawn, as a fraction of the greatest
    min_energy_share = 1e-6
    curves_by_title = {"Stored energy": held, "Energy lost so far": lost}
    with png_figure(path, 1, 2, (11, 5.6)) as (figure, axes):
        figure.subplots_adjust(top=0.76)
        for panel, (title, curves) in zip(axes, curves_by_title.items(), strict=True):
            most = max(curve.max() for curve in curves.values())
            least = min_energy_share * most
            shown = {
                name: curve for name, curve in curves.items() if curve.max() > least
            }
            for (name, curve), style in zip(shown.items(), LINE_STYLES, strict=False):
                label = CAUSE_IN_WORDS.get(name, name)
                panel.plot(left, curve, ls=style, lw=1.2, label=label)
            panel.set(
                xscale="log",
                yscale="log",
                xlim=(left[0], left[-1]),
                ylim=(least, 2 * most),
                xlabel="time before the end of the motion [s]",
                ylabel="energy [J]",
            )
            panel.grid(alpha=0.3)
            figure.text(panel.get_position().x0, 0.91, title, fontsize=12)
            place_legend_above(panel, columns=2, frameon=False)
