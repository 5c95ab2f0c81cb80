"""SETTLING RUNS -> WORDS AND NUMBERS: the output of `sonify listen`."""

from sonify.hearing.settling.detector import SettlingRun
from sonify.hearing.settling.joint_region import Estimate
from sonify.hearing.settling.settings import SettlingSettings


def run_numbers(run: SettlingRun) -> dict:
    """Return a run as plain values, an entry of `runs` in heard.json."""
    return {
        "kind": run.kind,
        "start": run.start,
        "t_end": estimate_record(run.t_end),
        "exponent": estimate_record(run.exponent),
        "rate_at_1s": estimate_record(run.rate_at_1s),
        "events_per_turn": run.events_per_turn,
        "false_alarm": run.false_alarm,
        "bands": [list(band) for band in run.bands],
        "score": run.score,
        "certain": run.certain,
    }


def run_sentences(run: SettlingRun) -> list[str]:
    """Return two lines on a run: its time and power law, and its certainty."""
    end = f"{run.t_end.value:.3f} s ({run.t_end.low:.3f} to {run.t_end.high:.3f})"
    rate = f"{run.rate_at_1s.value:.1f} Hz ({run.rate_at_1s.low:.1f} to {run.rate_at_1s.high:.1f})"
    low = f"{run.exponent.low:.2f}"
    high = f"{run.exponent.high:.2f}"
    value = "not determined" if run.exponent.value is None else f"{run.exponent.value:.2f}"
    bands = ", ".join(f"{below:.0f} to {above:.0f} Hz" for below, above in run.bands)
    when = "at first" if run.t_end.value - run.start < 1 else "one second before the end"
    certainty = "certain" if run.certain else "probable"
    return [
        f"a disk or coin comes to rest at {end}: {run.kind} in {bands} from {run.start:.2f} s on",
        f"  {certainty}; rate {rate} {when}, rising as (t_end - t)^-n with n {value} ({low} to "
        f"{high}); "
        f"{run.false_alarm:.1g} such events expected in a file of this length without a disk",
    ]


def false_alarm_sentence() -> str:
    """Return a sentence on the false-alarm rate of the detector."""
    settings = SettlingSettings()
    low, high = settings.false_alarms_per_hour_range
    return (
        f"false alarms: {settings.false_alarms_per_hour:g} per hour of eventful sound without a "
        f"disk ({low:g} to {high:g}, 95 %)"
    )


def estimate_record(estimate: Estimate) -> dict:
    return {"value": estimate.value, "low": estimate.low, "high": estimate.high}
