"""Summarise the analysis of a recording in three sentences, and store it for the player."""

import json
from collections.abc import Sequence
from dataclasses import asdict, replace
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
}
"""Sentence for each verdict of a fit of one recording that names a cause."""
AIR_EXPONENTS = (1 / 6, 2 / 9)
"""Exponents n of the rate, which rises as (time left)^-n, of a viscous film and of
boundary layers of the air."""
ROLLING_EXPONENT = 1 / 3
"""Exponent of contour friction."""
IMPACT_EXPONENTS = (3 / 7, 3 / 5)
"""Exponents of impacts on unevenness with Hurst exponents from 1/2 to -1."""


def runs_in_file(folder: Path) -> list[dict[str, Any]]:
    """Return the runs in the heard.json of a folder, the most certain one first.

    Each has a `start` and an `end` [s], the `low` and `high` ends of the interval of the
    latter, the `exponent` of the rate with its interval, and the expected number of false
    alarms.
    """
    record = json.loads((folder / "heard.json").read_text("utf-8"))
    runs = sorted(record["runs"], key=lambda run: -run["score"])
    return [
        {
            "start": run["start"],
            "end": run["t_end"]["value"] or run["t_end"]["low"],
            "low": run["t_end"]["low"],
            "high": run["t_end"]["high"],
            "exponent": run["exponent"],
            "false_alarm": run["false_alarm"],
            "certain": run["certain"],
        }
        for run in runs
    ]


def summary_of_runs(runs: list[dict[str, Any]]) -> list[str]:
    """Return one to three sentences on the runs that were heard."""
    if not runs:
        return ["No disk or coin that comes to rest was detected."]
    if len(runs) > 1:
        return [f"The file contains {len(runs)} runs; choose one."]
    run = runs[0]
    return [
        end_sentence(run["end"], run["low"], run["high"]),
        cause_sentence(**run["exponent"]),
        certainty_sentence(run["certain"], run["false_alarm"]),
    ]


def summary_of_fit(judged: Judged, neglected: Sequence[str] = ()) -> list[str]:
    """Return three sentences: when the disk stopped, what slowed it, and how sure this
    is.

    If the fit names no cause, the exponent of the rate does, and the second sentence
    states why the fit does not; `neglected` are the parts of the scene that it neglects.
    """
    run = judged.run
    cause = VERDICTS.get(judged.verdict)
    if cause is None:
        cause = cause_sentence(**asdict(run.exponent))
        cause += f" {missing_sentence(judged, neglected)}"
    estimate = judged.fit.parameter(0) if judged.explained else run.t_end
    end = estimate.low if estimate.value is None else estimate.value
    return [
        end_sentence(end, estimate.low, estimate.high),
        cause,
        certainty_sentence(run.certain, run.false_alarm),
    ]


def end_sentence(end: float, low: float, high: float) -> str:
    """Return a sentence on the end of the motion [s] and its 95 % interval."""
    return f"It stopped at {end:.2f} s ({low:.2f} to {high:.2f} s)."


def cause_sentence(value: float | None, low: float, high: float) -> str:
    """Return sentences on the causes that explain the exponent of the rate with its 95 %
    interval, whatever the size of the disk."""
    if value is None:
        return (
            "The recording does not show what slowed it, because the rate of its turns "
            "rises too little or its end is missing; record it from steep to flat and "
            "until it is silent."
        )
    return (
        f"{_cause_in_words(low, high)} Its rate rose as (time left)^-n with n = {value:.2f} "
        f"({low:.2f} to {high:.2f}); rolling friction gives {ROLLING_EXPONENT:.2f}, the air "
        f"{AIR_EXPONENTS[0]:.2f} to {AIR_EXPONENTS[1]:.2f}, and impacts on a rough table "
        f"{IMPACT_EXPONENTS[0]:.2f} to {IMPACT_EXPONENTS[1]:.2f}, or down to "
        f"{ROLLING_EXPONENT:.2f} if long waves dominate."
    )


def _cause_in_words(low: float, high: float) -> str:
    """Return a sentence on the causes with an exponent in an interval."""
    if low > IMPACT_EXPONENTS[1]:
        return "Neither friction, air nor impacts explain how it slowed down."
    if low > ROLLING_EXPONENT:
        return "Impacts explain how it slowed down: it rattled on the table."
    if high >= IMPACT_EXPONENTS[0] or (
        low <= AIR_EXPONENTS[1] and high >= ROLLING_EXPONENT
    ):
        return "The recording does not show what slowed it."
    if high >= ROLLING_EXPONENT:
        return (
            "Rolling friction, perhaps with some help of the air, explains how it slowed "
            "down; the air alone or impacts on a rough table do not."
        )
    if low > AIR_EXPONENTS[1]:
        return (
            "Rolling friction together with the air explains how it slowed down; either of "
            "them alone or impacts on a rough table do not."
        )
    return (
        "The air, perhaps with some rolling friction, explains how it slowed down; rolling "
        "friction alone or impacts do not."
    )


def missing_sentence(judged: Judged, neglected: Sequence[str] = ()) -> str:
    """Return a sentence on why a fit names no cause, and on what would be needed."""
    scene = judged.decay.scene.name
    unknown = "How much each cause took is not shown, because"
    if neglected:
        return (
            f"{unknown} the analysis neglects that {neglected[0].partition(':')[0]} in the scene "
            f"{scene}; choose a scene with a smooth, rigid table, such as granite."
        )
    if judged.verdict == "not this scene" or not judged.explained:
        return (
            f"{unknown} no motion of the disk of the scene {scene} agrees with the sound; "
            "choose a scene, a radius and a thickness like those of your disk."
        )
    return (
        f"{unknown} different amounts agree with the sound; a longer or less noisy recording "
        "is needed."
    )


def certainty_sentence(is_certain: bool, false_alarm: float) -> str:
    """Return a sentence on the certainty that a disk was detected."""
    certainty = "certain" if is_certain else "probable"
    least = 1e-6  # smaller numbers say nothing more
    expected = (
        f"{false_alarm:.1g} such events on average"
        if false_alarm >= least
        else "such an event less than once in a million times"
    )
    return (
        f"The detection of the disk is {certainty}: a file of this length without a disk would contain "
        f"{expected} (intervals are 95 %)."
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
