"""Measure and draw charts of speed against accuracy and of the limits of methods.

All methods of a chart run in one process."""

from typing import NamedTuple


class Chart(NamedTuple):
    """Title of a chart and label of its error axis."""

    title: str
    error_label: str = ""


CHARTS = {
    "motion": Chart(
        "Motion: accuracy against speed",
        "larger relative error of inclination and energy",
    ),
    "modes": Chart(
        "Modes: accuracy against speed", "largest relative error of a frequency"
    ),
    "sound": Chart(
        "Sound: accuracy against speed", "rms error of the pressure over its rms"
    ),
    "contact": Chart("Elastic contact: accuracy against speed"),
    "contact_models": Chart("Contact models: where each one holds"),
    "table": Chart(
        "Table mode under the disk: accuracy against speed",
        "relative distance from the closed form",
    ),
    "campbell": Chart("Campbell diagram: a disk on one table mode"),
    "end_to_end": Chart("From scene to sound: accuracy against speed"),
    "film": Chart("Air film: accuracy against speed", "relative error of the power"),
    "stability": Chart("Stability: where methods fail"),
}
"""All charts by name. A new chart needs a line here, its name in
`sonify.chart_command.CHART_NAMES`, and a module.

The module benchmarks.charts.<name>_chart defines PROBLEM, a description in Markdown;
run(quick, watch) -> list[Record], which reports its progress by watch(fraction, note);
and conclusion(records) -> list[str], at most five sentences. A chart without an error
label also defines draw(records, title, path), since its picture is not error against
seconds. It may define tables(records) for other tables than those of the methods. The
files are <name>.csv, .png and .md; the command line writes "-" instead of "_". """
