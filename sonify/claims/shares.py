"""Share of draws in which a claim holds, with its Wilson interval."""

from typing import NamedTuple

import numpy as np


class Share(NamedTuple):
    """Number of draws in which a claim holds, with the 95 % Wilson interval of its
    share."""

    holds: int
    draws: int
    low: float
    high: float

    @property
    def minority(self) -> int:
        """Number of draws with the rarer answer."""
        return min(self.holds, self.draws - self.holds)

    @property
    def draw_count_text(self) -> str:
        """The number of draws in which the claim holds, as "k of n", and the interval of
        the share."""
        return f"{self.holds} of {self.draws} ({self.low:.0%} to {self.high:.0%})"

    def __str__(self) -> str:
        if self.holds in (0, self.draws):
            bound = (
                f"at most {self.high:.1%}"
                if self.holds == 0
                else f"at least {self.low:.1%}"
            )
            return f"{self.holds} of {self.draws} draws ({bound})"
        percent = 100 * self.holds / self.draws
        if round(percent) in (0, 100):
            bounds = f"{self.low:.1%} to {self.high:.1%}"
            return f"{self.holds} of {self.draws} draws ({bounds})"
        return (
            f"{percent:.0f}({50 * (self.high - self.low):.0f}) % of {self.draws} draws"
        )


def share_of(holds: np.ndarray) -> Share:
    """Return the `Share` of True values in a mask (n,)."""
    return share_of_count(int(holds.sum()), len(holds))


def share_of_count(holds: int, draws: int) -> Share:
    """Return the `Share` of the draws in which a claim holds."""
    from scipy.stats import binomtest  # loads slowly

    interval = binomtest(holds, draws).proportion_ci(0.95, method="wilson")
    return Share(holds, draws, float(interval.low), float(interval.high))
