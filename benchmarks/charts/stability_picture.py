"""Define the hazards of the stability map and the states of a run, and draw the map.

The map has one panel per hazard and one row per method, with the limit of the parameter
at the right. A dot means fine, a ring degraded, and a cross failed; the markers are
distinct without colour."""

from typing import NamedTuple

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from benchmarks.charts.error_time_picture import save
from benchmarks.charts.stability_sound import AUDIBLE_MISTUNING
from benchmarks.timed_runs import Record

FINE = "fine"
DEGRADED = "degraded"
FAILED = "failed"


class Hazard(NamedTuple):
    """Hazard with its title, label of its parameter, largest fine error, and direction
    of the parameter."""

    title: str
    label: str
    max_fine_error: float
    decreases: bool


HAZARDS = {
    "small inclination": Hazard(
        "Inclination to 0", "inclination at the start [rad]", 1e-6, True
    ),
    "small slip": Hazard(
        "Slip to 0", "resolved slip speed [R/chi], or the tolerance", 1e-6, True
    ),
    "nutation sticks": Hazard(
        "The nutation sticks", "arm k1/R (the published one is 1e-4)", 1e-6, False
    ),
    "pivoting sticks": Hazard(
        "The pivoting sticks", "arm k3/R (the published one is 8e-3)", 1e-6, False
    ),
    "long steps": Hazard(
        "Long steps",
        "step x angular frequency (mistuning in cents)",
        AUDIBLE_MISTUNING,
        False,
    ),
    "near half the sample rate": Hazard(
        "Around half the sample rate", "frequency over sample rate", 1e-2, False
    ),
    "thin disk": Hazard("Thin disk", "thickness over radius", 0.05, True),
    "incompressible": Hazard(
        "Poisson's ratio to 1/2", "1/2 - Poisson's ratio", 0.05, True
    ),
    "shift": Hazard(
        "Shift of the eigenproblem",
        "-shift over the first elastic eigenvalue",
        1e-6,
        False,
    ),
    "point support": Hazard(
        "Support to a point",
        "half angle of patch, or elements at its edge [degrees]",
        0.02,
        True,
    ),
}
"""Hazards by the case of their records."""
STYLES = {
    FINE: {"marker": "o", "color": "#1b7837", "ms": 7},
    DEGRADED: {"marker": "o", "color": "#d98200", "ms": 8, "mfc": "w", "mew": 2},
    FAILED: {"marker": "X", "color": "#b2182b", "ms": 9},
}
ZERO_POSITION = 0.01
"""Position of the parameter value 0 on a logarithmic axis, divided by the smallest
other value."""

MIN_LOG_RANGE = 10.0
"""Ratio of largest to smallest parameter value above which the axis is logarithmic."""

MIN_LABEL_RATIO = 1.15
"""Ratio of two parameter values below which their labels would overlap."""


def state(record: Record) -> str:
    """Return FINE, DEGRADED or FAILED."""
    if record.failure:
        return FAILED
    return FINE if record.error <= HAZARDS[record.case].max_fine_error else DEGRADED


def rows(records: list[Record]) -> dict[tuple[str, str], list[Record]]:
    """Return the records by (family, method), our methods first."""
    keys = sorted(
        dict.fromkeys((r.family, r.method) for r in records),
        key=lambda key: key[0] != "ours",
    )
    return {key: [r for r in records if (r.family, r.method) == key] for key in keys}


def draw(records: list[Record], title: str, path):
    """Draw all hazards, two panels per row."""
    shown = [r for r in records if not r.left_out]
    cases = [case for case in HAZARDS if any(r.case == case for r in shown)]
    panels = {case: rows([r for r in shown if r.case == case]) for case in cases}
    heights = [
        max(len(panels[case]) for case in cases[i : i + 2]) + 2.5
        for i in range(0, len(cases), 2)
    ]
    figure = Figure(figsize=(19, 0.3 * sum(heights) + 1), dpi=100, layout="constrained")
    all_axes = [
        *figure.subplots(len(heights), 2, height_ratios=heights, squeeze=False).flat
    ]
    for axes, (case, methods) in zip(all_axes, panels.items(), strict=False):
        _panel(axes, HAZARDS[case], methods)
    for axes in all_axes[len(panels) :]:
        axes.remove()
    handles = [
        Line2D([], [], ls="", label=name, **style) for name, style in STYLES.items()
    ]
    figure.legend(handles=handles, loc="outside upper right", ncols=3)
    figure.suptitle(f"{title} (our methods in bold; the limit is at the right)")
    save(figure, path)


def _label(axes, y, runs):
    """Write the errors above the marks, except where two labels would overlap."""
    last = 0.0
    for r in runs:
        if (x := float(r.setting)) > MIN_LABEL_RATIO * last:
            axes.annotate(
                f"{r.error:.0f}",
                (x, y),
                (0, 6),
                textcoords="offset points",
                ha="center",
                fontsize=7,
            )
            last = x


def _panel(axes, hazard, methods):
    values = sorted({float(r.setting) for runs in methods.values() for r in runs})
    zero = ZERO_POSITION * min(value for value in values if value > 0)
    for y, runs in enumerate(methods.values()):
        axes.axhline(y, color="0.9", lw=1, zorder=0)
        for r in runs:
            x = float(r.setting) or zero
            axes.plot([x], [y], ls="", **STYLES[state(r)])
        if "cents" in hazard.label:
            _label(
                axes,
                y,
                [
                    r
                    for r in runs
                    if r.error > hazard.max_fine_error and "grows" not in r.failure
                ],
            )
    if values[-1] > MIN_LOG_RANGE * values[0]:
        axes.set_xscale("log")
    if 0.0 in values:
        axes.axvline(zero, color="0.8", lw=0.8, zorder=0)
        axes.text(
            zero,
            0.02,
            "0",
            transform=axes.get_xaxis_transform(),
            ha="center",
            fontsize=9,
        )
    axes.set_yticks(
        range(len(methods)),
        [f"{family}: {method}" for family, method in methods],
        fontsize=8,
    )
    for label, (family, _) in zip(axes.get_yticklabels(), methods, strict=True):
        label.set_fontweight("bold" if family == "ours" else "normal")
    axes.set_ylim(len(methods) - 0.4, -0.8)
    axes.set_title(hazard.title, fontsize=11)
    axes.set_xlabel(hazard.label, fontsize=9)
    axes.tick_params(axis="y", length=0)
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)
    if hazard.decreases:
        axes.invert_xaxis()
