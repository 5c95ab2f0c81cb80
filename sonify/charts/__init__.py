"""Speed against accuracy, and where methods fail: every method on the same work, in one process."""

from typing import NamedTuple


class Chart(NamedTuple):
    """A chart: its title and the label of its error axis."""

    title: str
    error_label: str = ""


CHARTS = {
    "motion": Chart("Motion: accuracy against speed", "relative error of inclination or energy, the larger"),
    "modes": Chart("Modes: accuracy against speed", "largest relative error of a frequency"),
    "sound": Chart("Sound: accuracy against speed", "rms error of the pressure over its rms"),
    "contact": Chart("Elastic contact: accuracy against speed"),
    "table": Chart("A table under the disk: accuracy against speed", "distance from the closed form, relative"),
    "campbell": Chart("Campbell diagram: a disk that turns over one mode of a table", "relative error of the growth"),
    "end_to_end": Chart("From scene to sound: accuracy against speed"),
    "film": Chart("Film of air: accuracy against speed", "relative error of the power"),
    "stability": Chart("Stability: where methods fail"),
}
"""Every chart there is, in the order of `chart all`; a line here is all that a new one needs besides its module.

The module sonify.charts.<name> offers run(quick, watch) -> list[Record], where watch(share done, note) tells progress,
and conclusion(records) -> list[str], sentences. Its picture is error against seconds unless it offers
draw(records, title, path). The files are <name>.csv, .png and .md; on the command line - stands for _.
"""
