"""Share of draws in which each claim of the paper holds, and its sensitivity to the
axes."""

from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
import pyarrow as pa

from sonify.claims.finding_texts import VERDICT_TEXTS
from sonify.claims.shares import share_of
from sonify.sweeps.sweep import Sweep

WIDTH_IN_WORDS = {0.5: "halved", 2.0: "doubled"}


class SensitivityIndex(NamedTuple):
    """Sensitivity index of an axis, with the half-width of its 95 % confidence
    interval, which SALib computes from 100 resamples."""

    axis: str
    value: float
    error: float

    @property
    def resolved(self) -> bool:
        """True if the confidence interval is narrow enough."""
        # Maximum width of the 95 % confidence interval of a resolved index
        max_interval_width = 0.2
        return 2 * self.error <= max_interval_width


def first_order_indices(
    names: list[str], draws: np.ndarray, result: np.ndarray
) -> list[SensitivityIndex]:
    """Return the first-order sensitivity index of each axis, the largest first.

    Parameters
    ----------
    names : list of str
        Names of the axes.
    draws : ndarray, shape (n, d)
        Values of the axes in each draw.
    result : ndarray, shape (n,)
        Result of each draw; must vary.
    """
    # Number of harmonics in an index; enough for a monotonic dependence, and few
    # enough to limit noise
    index_harmonics = 4
    from SALib.analyze import rbd_fast

    problem = {
        "num_vars": len(names),
        "names": names,
        "bounds": [[0.0, 1.0]] * len(names),  # of the shares
    }
    with np.errstate(invalid="ignore"):  # the result may be constant in a resample
        found = rbd_fast.analyze(
            problem,
            draws,
            result,
            M=index_harmonics,
            seed=1,
        )
    values = map(float, found["S1"])
    half_widths = map(float, found["S1_conf"])
    indices = map(SensitivityIndex, names, values, half_widths)
    return sorted(indices, key=lambda index: -index.value)


def verdict_conclusion(rows: pa.Table, sweep: Sweep) -> list[str]:
    """Return one sentence for each claim, and sentences on outcomes and failed
    draws."""
    samples = sweep.points.samples
    if samples is None:
        return ["The shares require sampled points, but this sweep is a grid."]
    runs = rows["run"].to_numpy()
    width = np.array([samples.width(int(run)) for run in runs])
    names = [axis.keys[0] for axis in sweep.points.axes]
    ranks = np.array([value_ranks(rows, name) for name in names]).T
    errors = rows["error"].drop_null()
    sentences = []
    for key, text in VERDICT_TEXTS.items():
        if f"{key}_holds" not in rows.column_names:
            continue
        holds = rows[f"{key}_holds"]
        known = holds.is_valid().to_numpy()
        yes = holds.fill_null(False).to_numpy()
        nominal = known & (width == 1.0)
        if not nominal.any():
            continue
        words = f"{text.claim}: {share_of(yes[nominal])}"
        if 0 < yes[nominal].sum() < nominal.sum():
            words += "; " + dependence_clause(
                first_order_indices(names, ranks[nominal], yes[nominal].astype(float))
            )
        others = [
            f"with all ranges {WIDTH_IN_WORDS.get(factor, f'times {factor:g}')} "
            f"{share_of(yes[known & (width == factor)])}"
            for factor in samples.widths
            if (known & (width == factor)).any()
        ]
        sentences.append("; ".join([words, *others]) + ".")
    sentences.append(outcomes_in_words(rows, width == 1.0))
    if len(errors):
        sentences.append(
            f"Draws without a result: {len(errors)} of {len(runs)}. The first error is: {errors[0]}."
        )
    passed = rows["passed"].to_pylist() if "passed" in rows.column_names else []
    if unsound := passed.count(False):
        sentences.append(f"Draws included although a self-check failed: {unsound}.")
    sentences.append(
        "The claim that the vibrations produce the sound is not evaluated, because no sound is rendered."
    )
    return sentences


def value_ranks(rows: pa.Table, name: str) -> np.ndarray:
    """Return the ranks (n,) of the values of an axis, which may be text."""
    return np.unique(rows[name].to_numpy(), return_inverse=True)[1].astype(float)


def dependence_clause(indices: list[SensitivityIndex]) -> str:
    """Return a clause on the axes on which a share depends."""
    # Smallest index that is reported
    min_reported_index = 0.05
    named = [index for index in indices if index.value >= min_reported_index]
    if not named:
        return f"no single quantity has an index above {min_reported_index:g}"
    words = [
        f"{index.axis} ({index.value:.2f} ± {index.error:.2f})"
        for index in named
        if index.resolved
    ][:3]
    if not words:
        return "the draws do not resolve the main dependence"
    *others, last = words
    return f"depends most on {', '.join(others)}{' and ' if others else ''}{last}"


def outcomes_in_words(rows: pa.Table, nominal: np.ndarray) -> str:
    """Return a sentence on the outcomes and durations of the `nominal` draws (n,)."""
    counts = ", ".join(outcome_counts(rows["outcome"].to_numpy()[nominal]))
    ends = [
        t
        for t, use in zip(rows["t_end"].to_pylist(), nominal, strict=True)
        if use and t
    ]
    low, middle, high = np.percentile(ends, [0, 50, 100])
    return f"Outcomes: {counts}; the motion lasts {middle:.3g} s ({low:.3g} to {high:.3g} s)."


def outcome_counts(outcomes: Iterable[str | None]) -> list[str]:
    """Return the count and name of each outcome, the most frequent first."""
    counts = Counter(filter(None, outcomes))
    return [f"{count} {name}" for name, count in counts.most_common()]
