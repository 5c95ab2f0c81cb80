"""The `Finding` record, and the decorator that turns a measuring function into a
finding."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import wraps
from math import inf, isfinite, isnan
from typing import Any, Literal, NamedTuple, SupportsIndex, overload

import numpy as np

from sonify.claims.finding_texts import FINDING_TEXTS
from sonify.suggestions import did_you_mean

Verdict = Literal["yes", "no", "undecided"]
"""Verdict on a claim: it holds, does not hold, or is undecided."""
Need = Literal["scene", "motion", "modes", "sound", "tone", "film law", "contact law"]
"""Input of a finding; "tone" is the rising tone, tracked in the sound alone."""


class Measured(NamedTuple):
    """Result of a measuring function: value, uncertainty, further numbers, and the
    reason for an undecided claim, if any.

    `variant` selects other texts of the finding, `words` are inserted into its texts,
    and `fields` replaces further fields of the `Finding` that depend on the run.
    """

    value: float
    margin: float = 0.0
    details: Mapping[str, float] = {}
    undecided_because: str = ""
    variant: str = ""
    words: Mapping[str, str] = {}
    fields: Mapping[str, Any] = {}


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A claim, the value found for it, and the range in which the claim holds.

    Parameters
    ----------
    key : str
        Name of the function that judges the claim, the same in every version.
    claim : str
        The claim in words.
    value : float
        Measured value in `unit`; infinite if a level is never reached, never NaN.
    unit : str
        Unit and reference of the value.
    at_least, at_most : float
        Range of values for which the claim holds.
    tolerance : float
        Widening of the range at both ends.
    margin : float
        Uncertainty of the value, estimated by the method or the plan.
    details : mapping of str to float
        Further numbers by name, which `sonify.claims.details` describes.
    cause : str
        Cause named by the finding; empty if there is none.
    undecided_because : str
        Reason for an undecided claim, such as "chaotic"; otherwise empty.
    needs : tuple of str
        Inputs of the finding.
    source : str
        Origin of the claim or of its range.

    Raises
    ------
    ValueError
        If the value or the margin is NaN.
    """

    key: str
    claim: str
    value: float
    unit: str
    at_least: float = -inf
    at_most: float = inf
    tolerance: float = 0.0
    margin: float = 0.0
    details: Mapping[str, float] = field(default_factory=dict)
    cause: str = ""
    undecided_because: str = ""
    needs: tuple[Need, ...] = ()
    source: str

    def __post_init__(self) -> None:
        if isnan(self.value) or isnan(self.margin):
            raise ValueError(
                f"{self.key} = {self.value} ± {self.margin}: a finding needs a number"
            )

    def __repr__(self) -> str:
        return f"Finding({self.key}: {self.answer}, {self.value:.5g} {self.unit})"

    @property
    def verdict(self) -> Verdict:
        """Return "yes" or "no", or "undecided" if a limit of the range is within the
        margin."""
        low = self.at_least - self.tolerance
        high = self.at_most + self.tolerance
        near_an_end = min(abs(self.value - low), abs(self.value - high)) <= self.margin
        if self.undecided_because or (self.margin > 0 and near_an_end):
            return "undecided"
        return "yes" if low <= self.value <= high else "no"

    @property
    def holds(self) -> bool | None:
        """True if the claim holds, False if it does not, and None if it is
        undecided."""
        return {"yes": True, "no": False, "undecided": None}[self.verdict]

    @property
    def answer(self) -> str:
        """The verdict, with the reason if it is undecided."""
        return ": ".join(filter(None, (self.verdict, self.undecided_because)))

    @property
    def measured(self) -> str:
        """The value and its margin, rounded to the first digit of the margin."""
        if not (self.margin > 0 and isfinite(self.value) and isfinite(self.margin)):
            return f"{self.value:.4g}"
        if self.margin > abs(self.value):
            shown = f"{self.value:.2g}"
        else:
            digits = -int(np.floor(np.log10(self.margin)))
            rounded = round(self.value, digits) + 0.0
            shown = f"{rounded:.{digits}f}" if 0 <= digits <= 6 else f"{rounded:.6g}"
        return f"{shown} ± {float(f'{self.margin:.1g}'):g}"

    @property
    def expectation(self) -> str:
        """The allowed range as text, without a tolerance below 1e-4 of the largest
        limit."""
        if self.at_least == self.at_most:
            return f"{self.at_least:.6g} ± {self.tolerance:.2g}"
        ends = {"at least": self.at_least, "at most": self.at_most}
        ends = {word: end for word, end in ends.items() if isfinite(end)}
        largest = max(map(abs, ends.values()), default=0.0)
        tolerance = f" ± {self.tolerance:g}" if self.tolerance > 1e-4 * largest else ""
        return " and ".join(f"{word} {end:g}{tolerance}" for word, end in ends.items())


class Judge(NamedTuple):
    """Function that judges one claim, with its inputs."""

    function: Callable[..., Any]
    needs: tuple[Need, ...]


JUDGE_BY_KEY: dict[str, Judge] = {}
"""Judging functions by the key of their finding; each module registers its own on
import."""


def finding(
    *, needs: tuple[Need, ...], **limits: Any
) -> Callable[[Callable[..., float | Measured]], Callable[..., Finding]]:
    """Convert a function that returns a number or `Measured` to one that returns a
    `Finding`.

    Its texts are the record of FINDING_TEXTS with the name of the function.

    Parameters
    ----------
    needs : tuple of str
        Inputs of the function.
    **limits : float
        Range of values for which the claim holds: `at_least`, `at_most` and
        `tolerance`, as in `Finding`.
    """

    def decorator(function: Callable[..., float | Measured]) -> Callable[..., Finding]:
        texts = FINDING_TEXTS[function.__name__]

        @wraps(function)
        def judge(*arguments: Any, **options: Any) -> Finding:
            found = function(*arguments, **options)
            measured = found if isinstance(found, Measured) else Measured(float(found))
            return Finding(
                key=function.__name__,
                value=float(measured.value),
                margin=float(measured.margin),
                details={
                    name: float(number) for name, number in measured.details.items()
                },
                undecided_because=measured.undecided_because,
                needs=needs,
                **texts.of_run(measured.variant, measured.words),
                **{**limits, **measured.fields},
            )

        JUDGE_BY_KEY[function.__name__] = Judge(judge, needs)
        return judge

    return decorator


def median_with_margin(values: np.ndarray, independent: float = 1.0) -> Measured:
    """Return the median of values (n,) with a margin of two standard errors, 2.5
    sigma/sqrt(m).

    The standard deviation sigma follows from the quartiles; m = `independent` * n
    values are independent."""
    low, middle, high = np.percentile(values, [25, 50, 75])
    sigma = (high - low) / 1.349
    margin = 2 * 1.25 * sigma / np.sqrt(max(independent * len(values), 1.0))
    return Measured(float(middle), float(margin))


def rise_from_first_tenth(values: np.ndarray, last_count: int = 0) -> Measured:
    """Return the ratio of the median of the last `last_count` of values (n,), by default
    a tenth of them, to that of the first tenth.

    The details contain both medians."""
    tenth = max(len(values) // 10, 1)
    first = median_with_margin(values[:tenth])
    last = median_with_margin(values[-(last_count or tenth) :])
    ratio = last.value / first.value
    margin = ratio * np.hypot(first.margin / first.value, last.margin / last.value)
    return Measured(ratio, float(margin), {"from": first.value, "to": last.value})


class Findings(list[Finding]):
    """Ordered findings of a run, indexed by position or by key:
    `findings["energy_falls"]`."""

    @overload
    def __getitem__(self, which: str) -> Finding: ...
    @overload
    def __getitem__(self, which: SupportsIndex) -> Finding: ...
    @overload
    def __getitem__(self, which: slice) -> list[Finding]: ...
    def __getitem__(
        self, which: str | SupportsIndex | slice
    ) -> Finding | list[Finding]:
        if not isinstance(which, str):
            return super().__getitem__(which)
        for finding in self:
            if finding.key == which:
                return finding
        raise KeyError(
            f"{which}{did_you_mean(which, [finding.key for finding in self])}"
        )
