"""Verdicts of a sweep on the claims of the paper, by the quantity that decides them."""

from collections import Counter
from collections.abc import Iterable

import numpy as np
import pyarrow as pa

from sonify.claims.finding_texts import FINDING_TEXTS
from sonify.scene_keys import keys as scene_keys
from sonify.sweeps.axes import Axis
from sonify.sweeps.sweep import Sweep
from sonify.sweeps.thresholds import (
    MIN_DRAWS,
    MIN_MINORITY,
    ClaimVerdict,
    Dependence,
    Threshold,
    claim_verdict,
)

OUTCOME_WORDS = {
    "AT_REST": "at rest",
    "AIRBORNE": "lifted by the air",
    "SETTLED": "flat on the table",
    "FELL": "fallen onto its face",
    "SANK": "sunk onto its face",
    "LIFTED_OFF": "jumping",
    "UPRIGHT": "upright",
    "LEFT_TABLE": "off the table",
    "ROLLING_ON": "still rolling",
}
"""State of the disk at the end, by the name of the outcome; other outcomes keep their name."""
PAPER_CLAIM_NUMBERS: dict[str, str] = {
    "vibrations_make_sound": "1",
    "precession_rises": "2",
    "resonance_rises": "2",
    "contact_breaks_before_end": "",
    "vibration_opens_contact": "3",
    "table_breaks_contact": "3",
    "unevenness_breaks_contact": "",
    "one_impact_ends_it": "4",
    "impacts_end_it": "",
    "air_carries_disk": "",
    "table_brings_end_forward": "",
}
"""Numbers of the claims of the paper that findings judge, by the key of the finding, in the order
of the columns; "" for claims that are not in the paper."""


def claim_head(key: str) -> str:
    """Return the claim of a finding in the head of a table, with its number in the paper."""
    number = PAPER_CLAIM_NUMBERS[key]
    return FINDING_TEXTS[key].short + (f" ({number})" if number else "")


def verdicts_of_sweep(rows: pa.Table, sweep: Sweep) -> dict[str, ClaimVerdict]:
    """Return the verdicts by the key of the finding, in the order of PAPER_CLAIM_NUMBERS, as far as
    the table of a sweep contains the findings.

    Raises ValueError if the points of the sweep are not sampled."""
    if sweep.points.samples is None:
        raise ValueError(f"{sweep.name}: a verdict requires sampled points, not a grid")
    axes = list(sweep.points.axes)
    columns = {axis.keys[0]: rows[axis.keys[0]].to_numpy() for axis in axes}
    found = {}
    for key in PAPER_CLAIM_NUMBERS:
        if f"{key}_holds" not in rows.column_names:
            continue
        holds = rows[f"{key}_holds"]
        known = holds.is_valid().to_numpy()
        if known.any():
            yes = holds.fill_null(False).to_numpy()[known]
            some = {name: column[known] for name, column in columns.items()}
            found[key] = claim_verdict(axes, some, yes)
    return found


def verdict_conclusion(rows: pa.Table, sweep: Sweep) -> list[str]:
    """Return one sentence for each claim, and sentences on outcomes and failed
    draws."""
    if sweep.points.samples is None:
        return ["The verdicts require sampled points, but this sweep is a grid."]
    sentences = [
        verdict_sentence(key, verdict, sweep)
        for key, verdict in verdicts_of_sweep(rows, sweep).items()
    ]
    sentences.append(outcomes_in_words(rows))
    errors = rows["error"].drop_null()
    if len(errors):
        sentences.append(
            f"{len(errors)} of {len(rows)} draws failed. The first error is: {errors[0]}."
        )
    passed = rows["passed"].to_pylist() if "passed" in rows.column_names else []
    if unsound := passed.count(False):
        sentences.append(
            f"Draws that failed a check of the program but are included: {unsound}."
        )
    return sentences


def verdict_sentence(key: str, verdict: ClaimVerdict, sweep: Sweep) -> str:
    """Return a sentence with a verdict and the shares along the axis that decides it."""
    number = f" ({PAPER_CLAIM_NUMBERS[key]})" if PAPER_CLAIM_NUMBERS[key] else ""
    words = f"{FINDING_TEXTS[key].claim}{number}: {verdict_in_words(verdict, sweep)}"
    if verdict.dependence is None:
        return f"{words}."
    parts = groups_in_words(verdict.dependence)
    source = sweep.source_of(verdict.dependence.axis)
    return f"{words}. Yes in {parts} (source of this range: {source})."


def verdict_in_words(verdict: ClaimVerdict, sweep: Sweep) -> str:
    """Return a verdict in a few words.

    The share of all draws is given only if every range of the sweep has a source."""
    dependence = verdict.dependence
    if dependence is None:
        return answer_in_words(verdict)
    name = f"`{dependence.axis.keys[0]}`"
    if verdict.threshold is not None:
        side = "above" if verdict.threshold.rises else "below"
        at = threshold_in_words(verdict.threshold, dependence.axis)
        words = f"yes {side} {name} = {at}"
    elif verdict.answer == "threshold":
        words = f"depends on {name} ({switch_in_words(dependence)})"
    else:
        words = f"depends on {name} ({span_in_words(dependence)})"
    return words if sweep.assumed_axes else f"{words}; {verdict.share}"


def answer_in_words(verdict: ClaimVerdict) -> str:
    """Return a verdict that depends on no axis in a few words.

    Only draws with a verdict count. "mostly" means that too few draws have the rarer answer
    to find what decides it."""
    share = verdict.share
    if verdict.answer != "undecided":
        exceptions = f"all but {share.minority} of " if share.minority else "all "
        return f"{verdict.answer} in {exceptions}{share.draws} draws"
    if share.draws < MIN_DRAWS:
        return f"undecided: only {share.draws} draws, yes in {share.holds} of them"
    if share.minority >= MIN_MINORITY:
        return (
            f"undecided: yes in {share.holds} of {share.draws} draws, and no single "
            "quantity decides"
        )
    more = "yes" if 2 * share.holds > share.draws else "no"
    return f"mostly {more}: in {share.draws - share.minority} of {share.draws} draws"


def threshold_in_words(threshold: Threshold, axis: Axis) -> str:
    """Return the value at which an answer changes, with its interval and unit."""
    low, high = (None if end is None else f"{end:.3g}" for end in threshold[1:3])
    interval = f"{low} to {high}"
    if low is None or high is None:
        interval = f"above {low}" if high is None else f"below {high}"
        if low is None and high is None:
            interval = "anywhere in the range"
    return f"{threshold.value:.3g}{unit_of(axis)} ({interval})"


def unit_of(axis: Axis) -> str:
    """Return the unit of an axis after a space, or "" if it has none."""
    units = {key.name: key.unit for key in scene_keys()}
    name = axis.keys[0]
    unit = units.get(name) or units.get(name.rpartition(".")[0], "-")
    return "" if unit == "-" else f" {unit}"


def span_in_words(dependence: Dependence) -> str:
    """Return the smallest and the largest share along an axis."""
    shares = [group.share.holds / group.share.draws for group in dependence.groups]
    low, high = min(shares), max(shares)
    return f"yes in {low:.0%} to {high:.0%} of the draws, depending on its value"


def switch_in_words(dependence: Dependence) -> str:
    """Return the listed values with a majority of yes, and those with one of no."""
    sides: dict[bool, list[str]] = {True: [], False: []}
    for group in dependence.groups:
        sides[2 * group.share.holds > group.share.draws].append(group.words)
    unit = unit_of(dependence.axis)
    return "; ".join(
        f"{word} at {', '.join(sides[side])}{unit}"
        for side, word in ((True, "yes"), (False, "no"))
    )


def groups_in_words(dependence: Dependence) -> str:
    """Return the share, with its interval, of each group of an axis."""
    unit = unit_of(dependence.axis)
    parts = ", ".join(
        f"{group.share.holds} of {group.share.draws} draws at {group.words}{unit} "
        f"({group.share.low:.0%} to {group.share.high:.0%})"
        for group in dependence.groups
    )
    return f"{parts} of `{dependence.axis.keys[0]}`"


def outcomes_in_words(rows: pa.Table) -> str:
    """Return a sentence on the outcomes and durations of the draws."""
    counts = ", ".join(outcome_counts(rows["outcome"].to_pylist()))
    ends = [t for t in rows["t_end"].to_pylist() if t]
    low, middle, high = np.percentile(ends, [0, 50, 100])
    return (
        f"State of the disk at the end: {counts}. The motion lasts {middle:.3g} s (median; {low:.3g} to "
        f"{high:.3g} s)."
    )


def outcome_counts(outcomes: Iterable[str | None]) -> list[str]:
    """Return the count of each outcome with its words, the most frequent first."""
    counts = Counter(filter(None, outcomes))
    return [
        f"{count} {OUTCOME_WORDS.get(name, name)}"
        for name, count in counts.most_common()
    ]
