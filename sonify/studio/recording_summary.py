"""Summarise the analysis of a recording in three sentences, and store it for the player."""

import json
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any

from sonify.fitting.line_selection import Judged
from sonify.hearing.audio_source import (
    Recording,
    loudest_channel,
    read_samples,
    source_of_file,
)
from sonify.report.page_data import recording_data
from sonify.runtime.json_values import plain_value

VERDICTS = {
    "rolling": "Rolling friction slowed it.",
    "air": "The air film under the disk slowed it.",
    "both": "Rolling friction and the air film slowed it.",
    "impacts": "Impacts slowed it: it rattled on the table.",
    "not this scene": "No loss in the chosen scene explains how it slowed down.",
    "cannot tell": "The recording does not show what slowed it.",
}
"""Sentence for each verdict of a fit of one recording."""


def runs_in_file(folder: Path) -> list[dict[str, Any]]:
    """Return the runs in the heard.json of a folder, the most certain one first.

    Each has a `start` and an `end` [s], the `low` and `high` ends of the interval of the
    latter, and the expected number of false alarms.
    """
    record = json.loads((folder / "heard.json").read_text("utf-8"))
    runs = sorted(record["runs"], key=lambda run: -run["score"])
    return [
        {
            "start": run["start"],
            "end": run["t_end"]["value"] or run["t_end"]["low"],
            "low": run["t_end"]["low"],
            "high": run["t_end"]["high"],
            "false_alarm": run["false_alarm"],
            "certain": run["certain"],
        }
        for run in runs
    ]


def summary_of_runs(runs: list[dict[str, Any]]) -> list[str]:
    """Return one to three sentences on the runs that were heard."""
    if not runs:
        return ["No disk or coin that comes to rest was heard."]
    if len(runs) > 1:
        return [f"The file contains {len(runs)} runs; choose one."]
    run = runs[0]
    return [
        f"It stopped at {run['end']:.2f} s ({run['low']:.2f} to {run['high']:.2f} s).",
        "What slowed it could not be determined.",
        certainty_sentence(run["certain"], run["false_alarm"]),
    ]


def summary_of_fit(judged: Judged) -> list[str]:
    """Return three sentences: when the disk stopped, what slowed it, and how sure this
    is."""
    end = judged.fit.value(0)
    return [
        f"It stopped at {end.value:.2f} s ({end.low:.2f} to {end.high:.2f} s).",
        VERDICTS[judged.verdict],
        certainty_sentence(judged.run.certain, judged.run.false_alarm),
    ]


def certainty_sentence(is_certain: bool, false_alarm: float) -> str:
    """Return a sentence on the certainty that a disk was heard."""
    certainty = "certain" if is_certain else "probable"
    return (
        f"That a disk was heard is {certainty}: in a file of this length without one, "
        f"{false_alarm:.1g} such events are expected; intervals are 95 %."
    )


def write_recording(
    path: Path, target: Path, end: float, span: tuple[float, float] = (0.0, inf)
) -> None:
    """Write the data of a recording to `target` for the player.

    The disk stops at `end` [s]; nothing after the span [s] is included.
    """
    source = source_of_file(path)
    rate = source.sample_rate
    last = source.frames if span[1] == inf else round(span[1] * rate)
    whole = Recording(
        samples=loudest_channel(read_samples(source, 0, last)).astype(float),
        sample_rate=rate,
    )
    data = recording_data(replace(whole, name="your recording"), end)
    target.write_text(json.dumps(data, default=plain_value), encoding="utf-8")
