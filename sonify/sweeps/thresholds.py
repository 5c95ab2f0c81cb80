"""Where within its range a quantity changes the answer to a claim.

A share over all draws depends on the widths of the assumed ranges. The value at which the
answer changes does not, as long as it is inside its range.
"""

from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np

from sonify.claims.shares import Share, share_of
from sonify.sweeps.axes import Axis

GROUPS = 5
"""Number of groups into which the range of an axis is divided."""
MIN_DRAWS = 20
"""Smallest number of draws from which an answer is given."""
MIN_MINORITY = 8
"""Smallest number of draws with the rarer answer from which a deciding axis is sought."""
SIGNIFICANCE = 0.05
"""Probability that one of all axes seems to matter although none does."""
MAX_EXCEPTIONS = 0.05
"""Upper end of the interval of a share below which the answer is that of the others."""

Answer = Literal["yes", "no", "threshold", "depends", "undecided"]
"""Kind of a verdict: one answer throughout the ranges, one that changes at a value of an
axis, shares that differ along an axis without such a value, or none."""


class Group(NamedTuple):
    """Draws from one part of an axis: the values in words, and the share of yes."""

    words: str
    share: Share


class Threshold(NamedTuple):
    """Value of an axis at which the answer changes, with its 95 % interval.

    An end of the interval that is not inside the range of the axis is None. `rises` is True
    if the claim holds above the value."""

    value: float
    low: float | None
    high: float | None
    rises: bool


class Dependence(NamedTuple):
    """Dependence of an answer on one axis.

    `difference` is that of the largest and the smallest share of its groups, `p_value` the
    probability of such a table if the groups had equal shares."""

    axis: Axis
    groups: list[Group]
    difference: float
    p_value: float


class ClaimVerdict(NamedTuple):
    """Verdict on a claim from the draws of a sweep.

    `dependence` is that on the axis with the largest effect, or None if no axis has a
    significant one; `threshold` exists for the answer "threshold" on a range."""

    answer: Answer
    share: Share
    dependence: Dependence | None = None
    threshold: Threshold | None = None


class LogisticFit(NamedTuple):
    """Logistic curve with the value 1/2 at `middle`, with a 95 % interval from the profile
    likelihood, whose ends are None outside the searched span.

    `p_value` is the probability of such a slope if the curve were constant."""

    middle: float
    low: float | None
    high: float | None
    rises: bool
    p_value: float


def claim_verdict(
    axes: list[Axis], columns: dict[str, np.ndarray], yes: np.ndarray
) -> ClaimVerdict:
    """Return the verdict on a claim.

    Parameters
    ----------
    axes : list of Axis
        Axes of the sweep.
    columns : dict of str to ndarray, shape (n,)
        Values of the first key of each axis in the draws.
    yes : ndarray of bool, shape (n,)
        True where the claim holds.
    """
    share = share_of(yes)
    if share.draws < MIN_DRAWS:
        return ClaimVerdict("undecided", share)
    if share.minority == 0 or is_exceptional(share):
        return ClaimVerdict("yes" if 2 * share.holds > share.draws else "no", share)
    if share.minority < MIN_MINORITY:
        return ClaimVerdict("undecided", share)
    strongest = max(
        (dependence_on(axis, columns[axis.keys[0]], yes) for axis in axes),
        key=lambda found: (-found.p_value, found.difference),
    )
    if strongest.p_value * len(axes) > SIGNIFICANCE:
        return ClaimVerdict("undecided", share)
    if not answers_differ(strongest.groups):
        return ClaimVerdict("depends", share, strongest)
    axis = strongest.axis
    if axis.values:
        return ClaimVerdict("threshold", share, strongest)
    threshold = threshold_on(axis, columns[axis.keys[0]], yes)
    answer: Answer = "depends" if threshold is None else "threshold"
    return ClaimVerdict(answer, share, strongest, threshold)


def is_exceptional(share: Share) -> bool:
    """Return True if the rarer answer is that of less than MAX_EXCEPTIONS of the draws."""
    return share.high < MAX_EXCEPTIONS or share.low > 1 - MAX_EXCEPTIONS


def answers_differ(groups: list[Group]) -> bool:
    """Return True if one group clearly has a majority of yes, and another one of no."""
    shares = [group.share for group in groups]
    return any(s.low > 0.5 for s in shares) and any(s.high < 0.5 for s in shares)


def dependence_on(axis: Axis, values: np.ndarray, yes: np.ndarray) -> Dependence:
    """Return the dependence of the answers (n,) on an axis with the values (n,).

    The probability is that of the chi-squared test of homogeneity."""
    from scipy.stats import chi2_contingency  # loads slowly

    index, words = groups_of(axis, values)
    used = [k for k in range(len(words)) if np.any(index == k)]
    groups = [Group(words[k], share_of(yes[index == k])) for k in used]
    counts = np.array([(g.share.holds, g.share.draws - g.share.holds) for g in groups])
    part = counts[:, 0] / counts.sum(axis=1)
    p_value = 1.0
    if len(groups) > 1 and counts.sum(axis=0).all():
        p_value = float(chi2_contingency(counts, correction=False).pvalue)
    return Dependence(axis, groups, float(np.ptp(part)), p_value)


def groups_of(axis: Axis, values: np.ndarray) -> tuple[np.ndarray, list[str]]:
    """Return the group (n,) of each value of an axis, and all groups in words.

    A list of at most GROUPS values has one group each; a longer list and a range are
    divided into GROUPS parts of equal width."""
    if not axis.values:
        edges = [axis.at(k / GROUPS)[0] for k in range(GROUPS + 1)]
        words = [f"{low:.3g} to {high:.3g}" for low, high in pairwise(edges)]
        place = (positions(axis, values) * GROUPS).astype(int)
        return np.clip(place, 0, GROUPS - 1), words
    found, index = np.unique(values, return_inverse=True)
    if len(found) <= GROUPS:
        return index, [value_in_words(value) for value in found]
    parts = np.array_split(found, GROUPS)
    words = [f"{value_in_words(p[0])} to {value_in_words(p[-1])}" for p in parts]
    bounds = np.cumsum([len(part) for part in parts])
    return np.searchsorted(bounds, index, side="right"), words


def value_in_words(value: object) -> str:
    """Return a listed value of an axis as text."""
    if isinstance(value, float | np.floating):
        return f"{value:.4g}"
    return str(value)


def positions(axis: Axis, values: np.ndarray) -> np.ndarray:
    """Return the positions (n,) of the values of a range, 0 at its start and 1 at its end."""
    (low, *_), (high, *_) = axis.ends
    if axis.log:
        return np.log(np.asarray(values) / low) / np.log(high / low)
    return (np.asarray(values, dtype=float) - low) / (high - low)


def threshold_on(axis: Axis, values: np.ndarray, yes: np.ndarray) -> Threshold | None:
    """Return the value of a range at which the answers (n,) change, or None if there is no
    such value inside the range."""
    fit = logistic_fit(positions(axis, values), yes)
    if fit.p_value > SIGNIFICANCE or not 0 < fit.middle < 1:
        return None

    def inside(position: float | None) -> float | None:
        if position is None or not 0 < position < 1:
            return None
        return float(axis.at(position)[0])

    return Threshold(
        float(axis.at(fit.middle)[0]), inside(fit.low), inside(fit.high), fit.rises
    )


def logistic_fit(x: np.ndarray, yes: np.ndarray) -> LogisticFit:
    """Fit a logistic curve to answers (n,) at positions x (n,) in [0, 1].

    The middle is searched from -1 to 2. The slope is limited, so that answers without
    overlap have a fit: the middle of the gap between them, with the likelihood of the
    draws on both sides as its interval.
    """
    from scipy.optimize import brentq, minimize_scalar  # load slowly
    from scipy.stats import chi2

    span = (-1.0, 2.0)
    sign = 1.0 if np.mean(x[yes]) > np.mean(x[~yes]) else -1.0

    def profile(middle: float) -> float:
        """Return the smallest negative log-likelihood over all slopes."""
        return minimize_scalar(
            lambda log_slope: negative_log_likelihood(
                sign * np.exp(log_slope) * (x - middle), yes
            ),
            bounds=(np.log(0.01), np.log(1e4)),
            method="bounded",
            options={"xatol": 1e-4},
        ).fun

    grid = np.linspace(*span, 121)
    best = grid[np.argmin([profile(middle) for middle in grid])]
    step = grid[1] - grid[0]
    found = minimize_scalar(
        profile,
        bounds=(best - step, best + step),
        method="bounded",
        options={"xatol": 1e-6},
    )
    middle, least = float(found.x), float(found.fun)
    gap = gap_between(x, yes if sign > 0 else ~yes)
    if gap is not None:
        middle = float(np.mean(gap))
        least = profile(middle)
    rise = chi2.ppf(0.95, 1) / 2

    def excess(at: float) -> float:
        return profile(at) - least - rise

    low, high = (
        float(brentq(excess, middle, end, xtol=1e-6)) if excess(end) > 0 else None
        for end in span
    )
    share = np.mean(yes)
    constant = negative_log_likelihood(
        np.full(len(x), np.log(share / (1 - share))), yes
    )
    p_value = float(chi2.sf(2 * (constant - least), 1))
    return LogisticFit(middle, low, high, sign > 0, p_value)


def gap_between(x: np.ndarray, above: np.ndarray) -> tuple[float, float] | None:
    """Return the last position without and the first one with `above` (n,) if these do not
    overlap."""
    low, high = float(x[~above].max()), float(x[above].min())
    return (low, high) if low < high else None


def negative_log_likelihood(logit: np.ndarray, yes: np.ndarray) -> float:
    """Return the negative log-likelihood of answers (n,) with the logits (n,) of yes."""
    return float(np.sum(np.logaddexp(0.0, logit) - yes * logit))
