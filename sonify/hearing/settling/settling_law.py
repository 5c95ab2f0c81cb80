"""Rate law of a disk that comes to rest, as it is heard in a sound."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from sonify.hearing.settling.joint_region import Estimate, JointRegion, region_of_law
from sonify.hearing.settling.tone_ridge import ToneRidge


@dataclass(frozen=True, kw_only=True)
class SettlingLaw:
    """Rate law of a disk or coin that comes to rest, with times in s, rates in Hz and
    95 % intervals.

    Attributes
    ----------
    start, t_end, exponent, rate_at_1s : float, Estimate, Estimate, Estimate
        Start of the ridge of a known disk, or of the best window, and the law
        rate ~ (t_end - t)^-exponent; the rate is that one second before the end, or at
        the start if that is later. If the sound stops before the end, `t_end` has no
        value, only limits, and the rate is that one second before the sound stops.
    region : JointRegion
        Laws that the sound admits.
    ridge : ToneRidge or None
        Ridge of a tone.
    """

    start: float
    t_end: Estimate
    exponent: Estimate
    rate_at_1s: Estimate
    region: JointRegion
    ridge: ToneRidge | None = None

    @classmethod
    def of_ridge(cls, ridge: ToneRidge) -> Self:
        """Return the law of a tone that does not stop before its end."""
        region = region_of_law(ridge.law, ridge.errors, float(ridge.time[0]))
        exponent, t_end, rate = region.limits()
        return cls(
            start=region.start,
            t_end=t_end,
            exponent=exponent,
            rate_at_1s=rate,
            region=region,
            ridge=ridge,
        )

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._words})"

    @property
    def _words(self) -> str:
        exponent = self.exponent
        missing = ", end missing" if self.t_end.value is None else ""
        return (
            f"from {self.start:.2f} to {self.heard_until:.3f} s{missing}, "
            f"n {exponent.low:.2f} to {exponent.high:.2f}, {self._known_rate:.1f} Hz"
        )

    @property
    def heard_until(self) -> float:
        """The end [s], or the time at which the sound stops if the end is missing."""
        if self.region.missing_from is None:
            return self.region.best_end
        return self.region.missing_from

    @property
    def reference_time(self) -> float:
        """Remaining time [s] at which the rate is `rate_at_1s`."""
        return self.region.reference_time

    @property
    def _known_rate(self) -> float:
        assert self.rate_at_1s.value is not None, "only an end can be missing"
        return self.rate_at_1s.value

    def turns_left(self, time: float | np.ndarray) -> np.ndarray:
        """Return the number of turns (or bursts) between times [s] and the end."""
        reference = self.reference_time
        left = np.maximum(self.region.best_end - np.asarray(time), 1e-6) / reference
        turns = self._known_rate * reference
        exponent = self.region.best_exponent
        if abs(exponent - 1) < 1e-3:
            return turns * np.log(left * 1e6)
        return turns * left ** (1 - exponent) / (1 - exponent)

    def rate(self, time: float | np.ndarray) -> np.ndarray:
        """Return the rate [Hz] of the law at times before the end [s]."""
        left = (self.region.best_end - np.asarray(time)) / self.reference_time
        return self._known_rate * left**-self.region.best_exponent

    def later(self, seconds: float) -> Self:
        """Return the law shifted to later times by `seconds`."""
        return replace(
            self,
            start=self.start + seconds,
            t_end=self.t_end.later(seconds),
            region=self.region.later(seconds),
            ridge=self.ridge and self.ridge.later(seconds),
        )
