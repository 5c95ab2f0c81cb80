"""Draw the errors of the contact models by table, and their processor times."""

from functools import partial

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from benchmarks.cases.contact_models_case import SOLVERS, predicted_force_rms
from benchmarks.charts.contact_models_records import (
    LONG_WAVES,
    MAX_MOTION_ERROR,
    SHORT_WAVES,
    SPECTRUM,
    cases_of,
    finest,
    motion_error,
    solved_steps,
)
from benchmarks.charts.error_time_picture import DPI, family_colours, save
from benchmarks.timed_runs import Record
from dynamics.compliant.model_selection import (
    LIFT_OFF_FORCE_RMS,
    MAX_FORCE_RMS_FOR_ONE_CONTACT,
    MAX_RELATIVE_CURVATURE_FOR_ROLLING,
)

NO_SOLUTION_HEIGHT = 1.5
"""Error at which a run without a solution is drawn."""

STYLES = {
    model: {"color": colour, "marker": marker, "label": model}
    for (model, colour), marker in zip(
        family_colours(SOLVERS).items(), "o^sD", strict=True
    )
}
"""Colour, marker and label of each model."""


def draw(records: list[Record], title: str, path):
    """Draw motion errors, errors of the force spectrum and processor times."""
    figure = Figure(figsize=(17, 10.5), dpi=DPI, layout="constrained")
    panels = figure.subplots(2, 3)
    _draw_waves(panels[0, 0], records)
    _draw_short_waves(panels[0, 1], records)
    _draw_spectra(panels[0, 2], records)
    _draw_other_tables(panels[1, 0], records)
    _draw_steps(panels[1, 1], records)
    _draw_seconds(panels[1, 2], records)
    for axes in panels.flat:
        axes.set_yscale("log")
        axes.grid(alpha=0.3)
    panels[0, 0].legend(fontsize=8)
    figure.suptitle(title)
    save(figure, path)


def _drawn_motion_error(records: list[Record], model: str, case: str) -> float:
    return min(motion_error(records, model, case), NO_SOLUTION_HEIGHT)


def _draw_limits(axes: Axes, *limits_of_plan: float):
    """Draw the largest motion error, and the limits of the models in the plan."""
    axes.axhline(MAX_MOTION_ERROR, color="k", lw=1, ls="--", label="limits")
    for limit in limits_of_plan:
        axes.axvline(limit, color="k", lw=1, ls="--")


def _draw_lines(axes: Axes, records: list[Record], y):
    """Draw y(records, model, case), if there is one, against the curvature number of
    long waves and of one wave."""
    for kind, line in ((LONG_WAVES, "-"), ("wavy", ":")):
        for model, style in STYLES.items():
            values = [
                (case.curvature_number, y(records, model, case.name))
                for case in cases_of(records, kind)
            ]
            known = [pair for pair in values if pair[1] is not None]
            label = model if kind == LONG_WAVES else None
            axes.plot(*zip(*known, strict=True), line, **style | {"label": label})
    axes.set_xlabel("curvature number (solid: long waves, dotted: one wave)")


def _draw_waves(axes, records):
    _draw_lines(axes, records, _drawn_motion_error)
    _draw_limits(axes, MAX_RELATIVE_CURVATURE_FOR_ROLLING)
    axes.set(
        ylabel="motion error", title=f"Long waves ({NO_SOLUTION_HEIGHT}: no solution)"
    )


def _draw_short_waves(axes, records):
    found = cases_of(records, SHORT_WAVES)
    force = [predicted_force_rms(case) for case in found]
    for model, style in STYLES.items():
        errors = [_drawn_motion_error(records, model, case.name) for case in found]
        axes.plot(force, errors, **style)
    _draw_limits(axes, LIFT_OFF_FORCE_RMS, MAX_FORCE_RMS_FOR_ONE_CONTACT)
    axes.set(
        xlabel="rms of the varying force by the filter, divided by the weight",
        ylabel="motion error",
        title="Short waves, which excite the contact resonance",
    )


def _spectrum_error(records, model, case):
    found = finest(records, model, case)
    return found[SPECTRUM].error if SPECTRUM in found else None


def _draw_spectra(axes, records):
    _draw_lines(axes, records, _spectrum_error)
    axes.set(ylabel="error of the spectrum", title="Spectrum of the normal force")


def _draw_other_tables(axes, records):
    kinds = ("smooth", "flexible", "with friction")
    names = [case.name for kind in kinds for case in cases_of(records, kind)]
    for model, style in STYLES.items():
        errors = [_drawn_motion_error(records, model, name) for name in names]
        axes.plot(range(len(names)), errors, ls="", ms=9, **style)
    _draw_limits(axes)
    axes.set_xticks(range(len(names)), [name.replace(", ", ",\n") for name in names])
    axes.set(ylabel="motion error", title="Other tables")


def _draw_steps(axes, records):
    for name, line in (("smooth, 0", "-"), ("rough, long waves, 0.1", ":")):
        for model, style in STYLES.items():
            _, seconds, errors = zip(*solved_steps(records, model, name), strict=True)
            axes.plot(seconds, errors, line, **style)
    axes.set(
        xscale="log",
        xlabel="processor time [s]",
        ylabel="motion error",
        title="Step sizes (solid: smooth, dotted: long waves, 0.1)",
    )


def _seconds(records, model, case, which):
    steps = solved_steps(records, model, case)
    return steps[which][1] if steps else None


def _draw_seconds(axes, records):
    _draw_lines(axes, records, partial(_seconds, which=-1))
    axes.set(ylabel="processor time [s]", title="Time of the smallest step")
