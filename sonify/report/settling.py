"""Convert settling runs to the text and the records of `sonify listen`."""

from dataclasses import asdict
from typing import Any

import numpy as np

from sonify.hearing.settling.detector import SettlingRun
from sonify.hearing.settling.settings import SETTLING


def settling_run_record(run: SettlingRun) -> dict[str, Any]:
    """Return a run as plain values for the list `runs` in heard.json."""
    rate = run.rate_at_1s.value
    assert rate is not None, "only an end can be missing"
    return {
        "kind": run.kind,
        "start": run.start,
        "t_end": asdict(run.t_end),
        "exponent": asdict(run.exponent),
        "rate_at_1s": asdict(run.rate_at_1s),
        "events_per_turn": run.events_per_turn,
        "false_alarm": run.false_alarm,
        "bands": [list(band) for band in run.bands],
        "score": run.score,
        "certain": run.certain,
        "joint_region": joint_region_rows(run),
        "turns_per_second": {
            "one_burst_per_turn": rate,
            "two_bursts_per_turn": rate / 2,
        },
    }


def joint_region_rows(run: SettlingRun) -> list[dict[str, Any]]:
    """Return the ranges of end and rate compatible with a run, one row per step of the
    exponent."""
    exponent_step = 0.05
    region = run.region
    columns = {
        "exponent": region.exponents,
        "t_end": region.ends,
        "rate": region.rates,
    }
    places = np.round(region.exponents / exponent_step)
    rows = []
    for place in np.unique(places):
        row = {}
        for name, values in columns.items():
            here = values[places == place]
            row[name] = [float(here.min()), float(here.max())]
        rows.append(row)
    return rows


def region_sentence(run: SettlingRun) -> str:
    """Return a line on the joint region of exponent and end, and on both
    interpretations of the turns."""
    rate = run.rate_at_1s.value
    assert rate is not None, "only an end can be missing"
    ridge = "; ".join(
        "n {:.2f} to {:.2f} with an end at {:.3f} to {:.3f} s".format(
            *row["exponent"], *row["t_end"]
        )
        for row in joint_region_rows(run)
    )
    return (
        f"joint region of the run to {run.heard_until:.3f} s: {ridge}; {rate:.1f} turns per second "
        f"with one burst per turn, {rate / 2:.1f} with two"
    )


def run_sentences(run: SettlingRun) -> list[str]:
    """Return two lines on the time, the power law and the certainty of a run."""
    is_missing = run.t_end.value is None
    rate = f"{run.rate_at_1s.value:.1f} Hz ({run.rate_at_1s.low:.1f} to {run.rate_at_1s.high:.1f})"
    exponent = run.exponent
    value = "not determined" if exponent.value is None else f"{exponent.value:.2f}"
    bands = ", ".join(f"{below:.0f} to {above:.0f} Hz" for below, above in run.bands)
    stop = "the sound stops" if is_missing else "the end"
    is_short = run.heard_until - run.start < 1
    when = "at first" if is_short else f"one second before {stop}"
    certainty = "certain" if run.certain else "probable"
    end = f"{run.t_end.low:.3f} to {run.t_end.high:.3f}"
    event = (
        "the rate of a disk or coin rises until the sound stops: the end is missing, and "
        f"not before {run.t_end.low:.3f} s"
        if is_missing
        else f"a disk or coin comes to rest at {run.t_end.value:.3f} s ({end})"
    )
    return [
        f"{event}: {run.kind} in {bands} from {run.start:.2f} s on",
        f"  {certainty}; rate {rate} {when}, rising as (t_end - t)^-n with n {value} "
        f"({exponent.low:.2f} to {exponent.high:.2f}); "
        f"{run.false_alarm:.1g} such events expected in a file of this length without a disk",
    ]


def false_alarm_sentence() -> str:
    """Return a sentence on the false-alarm rate of the detector."""
    low, high = SETTLING.false_alarms_per_hour_range
    return (
        f"false alarms: {SETTLING.false_alarms_per_hour:g} per hour of eventful sound without a "
        f"disk ({low:g} to {high:g}, 95 %)"
    )
