"""Joint region of exponent and end: the laws that the windows of one end admit.

The end of the law is fitted, because it is correlated with the exponent, and several
stops of the windows are tried. Intervals in which a disk is still upright, before its
rate begins to rise, are excluded if the later part contradicts the law of the whole.
"""

from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from sonify.hearing.settling.onset_strength import FRAME_RATE, OnsetStrength
from sonify.hearing.settling.prediction_score import (
    correlation_length,
    without_harmonics,
)
from sonify.hearing.settling.rate_laws import Shape, ShapeSet
from sonify.hearing.settling.refinement import laws_near
from sonify.hearing.settling.settings import SETTLING
from sonify.hearing.settling.warped_periodogram import (
    SearchResult,
    TabulatedWarps,
    phase_step_count,
    search,
    tabulated_warps,
)

EQUAL_RATE_TOLERANCE = 0.12
"""Maximum difference between the logarithms of two rates that count as equal."""


@dataclass(frozen=True)
class Estimate:
    """A value and its interval; the value is None if it is not determined."""

    value: float | None
    low: float
    high: float

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return (self.high - self.low) / 2

    def later(self, seconds: float) -> "Estimate":
        """Return the estimate of a time, shifted to later times by `seconds`."""
        value = None if self.value is None else self.value + seconds
        return Estimate(value, self.low + seconds, self.high + seconds)


@dataclass(frozen=True)
class JointRegion:
    """Exponents, ends [s] and rates [Hz], each (cells,), that the windows of one end
    admit.

    The rates are those `reference_time` [s] before the end: one second, or less if the
    best window starts at `start` [s] later than that. If the sound stops before the end
    of the run, at `missing_from` [s], the rates are those one second before that time,
    and `reference_time` is the time from there to the best end."""

    exponents: np.ndarray = field(repr=False)
    ends: np.ndarray = field(repr=False)
    rates: np.ndarray = field(repr=False)
    best_exponent: float
    best_end: float
    best_rate: float
    start: float
    reference_time: float
    missing_from: float | None = None

    def later(self, seconds: float) -> "JointRegion":
        """Return the region shifted to later times by `seconds`."""
        return replace(
            self,
            ends=self.ends + seconds,
            best_end=self.best_end + seconds,
            start=self.start + seconds,
            missing_from=None
            if self.missing_from is None
            else self.missing_from + seconds,
        )

    def limits(self) -> tuple[Estimate, ...]:
        """Return exponent, end and rate with their ranges over the region, for a region
        with three laws: the lowest, best and highest."""
        exponent, end, rate = (
            Estimate(float(value), float(low), float(high))
            for low, value, high in (self.exponents, self.ends, self.rates)
        )
        return exponent, self._observed_end(end), rate

    def _observed_end(self, end: Estimate) -> Estimate:
        """Return an end; if the sound stops before it, without a value and not before
        that time, because a disk may come to rest before its law diverges."""
        if self.missing_from is None:
            return end
        return Estimate(None, self.missing_from, end.high)

    def estimates(self) -> tuple[Estimate, Estimate, Estimate]:
        """Return exponent, end and rate; their intervals are their ranges over the
        region, widened by the resolution and the calibrated factor.

        The resolution of the end includes the interval between two bursts, 20 ms before
        the end. A missing end has no value, only limits; the lower one is the time at
        which the sound stops.
        """
        end_resolution = 0.006  # s
        rate_resolution = 0.006  # relative
        last_time = 0.02 / self.reference_time
        last_interval = last_time**self.best_exponent / self.best_rate
        exponent = _estimate_with_widened_range(
            self.best_exponent, self.exponents, SETTLING.exponent_resolution
        )
        end = _estimate_with_widened_range(
            self.best_end, self.ends, end_resolution + last_interval
        )
        rate = _estimate_with_widened_range(
            self.best_rate, self.rates, rate_resolution * self.best_rate
        )
        if exponent.high - exponent.low > SETTLING.max_exponent_interval:
            exponent = replace(exponent, value=None)
        return exponent, self._observed_end(end), rate


def region_of_law(
    law: np.ndarray, errors: np.ndarray, start: float, stop: float | None = None
) -> JointRegion:
    """Return the laws within two standard errors, and the resolution, of a law (3,) of
    end [s], exponent and log2 of the rate one second before the end [Hz].

    If the sound stops before the end, `stop` is that time [s]."""
    end_resolution = 0.002  # s
    exponent_resolution = 0.001
    rate_resolution = 0.002  # relative
    resolution = [end_resolution, exponent_resolution, np.log2(1 + rate_resolution)]
    half = 2 * errors + resolution
    ends, exponents, heights = (law + half * np.array([[-1], [0], [1]])).T
    span = min(1.0, law[0] - start)
    if stop is not None:
        span = law[0] - stop + min(1.0, stop - start)
    rates = 2**heights * span ** -law[1]
    return JointRegion(
        exponents=exponents,
        ends=ends,
        rates=rates,
        best_exponent=float(law[1]),
        best_end=float(law[0]),
        best_rate=float(rates[1]),
        start=start,
        reference_time=span,
        missing_from=stop,
    )


def _estimate_with_widened_range(
    value: float, values: np.ndarray, resolution: float
) -> Estimate:
    """Return an estimate with the range of `values`, widened by a resolution and by a
    factor from simulations with known laws."""
    factor = 1.16
    below = max(value - float(np.min(values)), 0.0) + resolution
    above = max(float(np.max(values)) - value, 0.0) + resolution
    return Estimate(value, value - factor * below, value + factor * above)


@dataclass(frozen=True)
class _LawGrid:
    """Laws with their shapes; each has a number of frames from the end of the window to
    that of the disk and an exponent, (cells,)."""

    left: np.ndarray
    exponents: np.ndarray
    shapes: ShapeSet


@lru_cache(maxsize=256)
def _law_grid(frames: int, before_knee: int, is_missing: bool) -> _LawGrid:
    """Return the tested laws of a window that stops `before_knee` frames before the
    knee, or before the sound stops if the end of the run is missing.

    A missing end is at most the length of the window away from the end of the sound."""
    end_count = 12
    exponent_step = 0.05
    earliest = before_knee - 2  # frames after the end of the window
    latest = before_knee + 80
    ends = np.linspace(max(earliest, 3), latest, end_count)
    if is_missing:
        ends = before_knee + np.geomspace(3, frames, 2 * end_count)
    low, high = SETTLING.exponents
    powers = np.arange(low, high + 1e-9, exponent_step)
    left, exponents = (
        axis.ravel() for axis in np.meshgrid(ends, powers, indexing="ij")
    )
    ratios = (1 + frames / left) ** exponents
    shapes = [Shape("disk", *law) for law in zip(ratios, exponents, strict=True)]
    return _LawGrid(left, exponents, ShapeSet(tuple(shapes), ("disk",), np.zeros(1)))


def joint_region(
    onsets: OnsetStrength, channel: int, knee: int, is_missing: bool = False
) -> JointRegion | None:
    """Return the joint region of a run that stops at the frame `knee`, or None if no
    window fits.

    The best law is that of a window of `channel` that extends to the knee; earlier
    windows and other channels extend the region. The sound of a run whose end
    `is_missing` stops at the knee."""
    first_stop = 5  # frames before the knee
    min_length = 0.7  # relative to the best window; shorter ones have less information
    surfaces = _likelihood_surfaces(onsets, channel, knee, first_stop, is_missing)
    if not surfaces:
        return None
    whole = max(surfaces, key=lambda surface: surface.max_likelihood)
    surfaces += _earlier_and_other_surfaces(onsets, channel, knee, is_missing)
    surfaces, reference = _without_upright_disk(surfaces, whole)
    max_likelihood = (
        whole.max_likelihood
        if reference is whole
        else max(surface.max_likelihood for surface in surfaces)
    )
    missing_from = knee / FRAME_RATE if is_missing else None
    span = min(1.0, float((missing_from or reference.ends.max()) - reference.start))
    weights = np.exp(reference.likelihood - reference.max_likelihood)
    reference_rates = reference.rates(reference.remaining(span, missing_from))
    weights *= (
        np.abs(np.log(reference_rates / reference_rates[np.argmax(weights)]))
        < EQUAL_RATE_TOLERANCE
    )
    weights /= weights.sum()
    best_rate = float(np.exp(weights @ np.log(reference_rates)))
    kept = [
        surface
        for surface in surfaces
        if surface.max_likelihood >= SETTLING.min_admitted_likelihood * max_likelihood
        and surface.seconds >= min_length * reference.seconds
    ]
    exponents = np.concatenate([surface.exponents for surface in kept])
    ends = np.concatenate([surface.ends for surface in kept])
    rates = np.concatenate(
        [surface.rates(surface.remaining(span, missing_from)) for surface in kept]
    )
    has_equal_rate = np.abs(np.log(rates / best_rate)) < EQUAL_RATE_TOLERANCE
    best_end = float(weights @ reference.ends)
    return JointRegion(
        exponents=exponents[has_equal_rate],
        ends=ends[has_equal_rate],
        rates=rates[has_equal_rate],
        best_exponent=float(weights @ reference.exponents),
        best_end=best_end,
        best_rate=best_rate,
        start=reference.start,
        reference_time=best_end - missing_from + span
        if missing_from is not None
        else min(1.0, best_end - reference.start),
        missing_from=missing_from,
    )


def _earlier_and_other_surfaces(
    onsets: OnsetStrength, channel: int, knee: int, is_missing: bool
) -> "list[_LikelihoodSurface]":
    """Return the likelihood surfaces of earlier windows of a channel and of the others."""
    middle_stop = 50  # frames before the knee
    last_stop = 100
    surfaces = []
    for before_knee in (middle_stop, last_stop):
        surfaces += _likelihood_surfaces(onsets, channel, knee, before_knee, is_missing)
    for other in range(len(onsets.values)):
        if other != channel:
            surfaces += _likelihood_surfaces(
                onsets, other, knee, middle_stop, is_missing
            )
    return surfaces


def _without_upright_disk(
    surfaces: "list[_LikelihoodSurface]", whole: "_LikelihoodSurface"
) -> "tuple[list[_LikelihoodSurface], _LikelihoodSurface]":
    """Return the likelihood surfaces of a run and that of its best window, without the
    times at which the disk is upright."""

    max_deviation = 0.5  # of log rates; larger if half or twice the bursts are counted

    def rate_deviation(surface: "_LikelihoodSurface") -> float:
        middle = surface.start + surface.seconds / 2
        return abs(np.log(surface.best_rate(middle) / whole.best_rate(middle)))

    if whole.best_rate(whole.start) < SETTLING.max_upright_rate:
        later = [
            surface
            for surface in surfaces
            if surface.seconds < whole.seconds
            and surface.max_likelihood > SETTLING.min_likelihood_for_rivals
            and surface.best_rate(surface.start) > SETTLING.max_upright_rate
            and rate_deviation(surface) < max_deviation
        ]
        min_likelihood = SETTLING.min_admitted_likelihood * max(
            (surface.max_likelihood for surface in later), default=0.0
        )
        likely = [
            surface for surface in later if surface.max_likelihood >= min_likelihood
        ]
        best = max(
            likely,
            key=lambda surface: (surface.seconds, surface.max_likelihood),
            default=whole,
        )
        if rate_deviation(best) > EQUAL_RATE_TOLERANCE:
            return later, _merged_surface(
                [one for one in likely if one.seconds == best.seconds]
            )
    return surfaces, whole


def _merged_surface(surfaces: "list[_LikelihoodSurface]") -> "_LikelihoodSurface":
    """Return the common likelihood surface of windows of one length that stop at
    different times."""
    start = surfaces[0].start
    rates = [one.rates(one.ends - start) for one in surfaces]
    return replace(
        surfaces[0],
        likelihood=np.concatenate([one.likelihood for one in surfaces]),
        ends=np.concatenate([one.ends for one in surfaces]),
        exponents=np.concatenate([one.exponents for one in surfaces]),
        first_rates=np.concatenate(rates),
    )


@dataclass(frozen=True)
class _LikelihoodSurface:
    """Laws that a window admits, with log likelihoods, ends [s] and exponents, each
    (admitted,).

    `first_rates` (admitted,) are the rates at the start of the window [Hz]. `start` [s]
    and `seconds` are the start and the length of the window."""

    likelihood: np.ndarray
    ends: np.ndarray
    exponents: np.ndarray
    first_rates: np.ndarray
    start: float
    seconds: float

    @property
    def max_likelihood(self) -> float:
        """Largest log likelihood."""
        return float(self.likelihood.max())

    def rates(self, left: float | np.ndarray) -> np.ndarray:
        """Return the rates (admitted,) at a time [s] before the end."""
        return self.first_rates * (left / (self.ends - self.start)) ** -self.exponents

    def remaining(self, span: float, missing_from: float | None) -> np.ndarray:
        """Return the times (admitted,) to the ends [s] at which rates are compared: a span
        [s] before the ends, or before the time at which the sound stops [s]."""
        if missing_from is None:
            return np.full(len(self.ends), span)
        return self.ends - missing_from + span

    def best_rate(self, time: float) -> float:
        """Return the rate of the most likely law at a time [s]."""
        best = np.argmax(self.likelihood)
        left = np.maximum(self.ends[best] - time, 1e-3)
        return self.rates(left)[best]


def _likelihood_surfaces(
    onsets: OnsetStrength,
    channel: int,
    knee: int,
    before_knee: int,
    is_missing: bool,
) -> list[_LikelihoodSurface]:
    """Return the likelihood surfaces of all windows of a channel that stop
    `before_knee` frames before the knee."""
    found = []
    for length in SETTLING.window_lengths:
        frames = round(length * FRAME_RATE)
        first = knee - before_knee - frames
        if first >= 0:
            grid = _law_grid(frames, before_knee, is_missing)
            found.append(_likelihood_surface(onsets, channel, first, frames, grid))
    return found


def _independent_share_of_likelihood(
    values: np.ndarray,
    scale: float,
    warps: TabulatedWarps,
    found: SearchResult,
    best: int,
) -> float:
    """Return the share of the likelihood of a law that its correlated residuals leave."""
    cuts = warps.index[best] + warps.fraction[best]
    turns = found.turns(best) * np.linspace(0, 1, len(cuts))
    phases = np.interp(np.arange(values.shape[1]) + 0.5, cuts, turns)
    residual = without_harmonics(values, phases, int(found.harmonics[best]))
    return min(1.0, scale / correlation_length(residual))


def _likelihood_surface(
    onsets: OnsetStrength, channel: int, first: int, frames: int, grid: _LawGrid
) -> _LikelihoodSurface:
    """Return the likelihood surface of the laws that one window admits."""
    max_likelihood_loss = 2.0  # of admitted laws
    values = onsets.values[channel][:, first : first + frames]
    scale = onsets.scales_ms[channel]
    warps = tabulated_warps(grid.shapes, frames, phase_step_count(frames, scale))
    found = search(values, scale, warps)
    best = int(np.argmax(found.likelihood))
    turns = found.turns(best)
    certainty = _independent_share_of_likelihood(values, scale, warps, found, best)
    start = (grid.left[best], grid.exponents[best], turns)
    left, exponents, rates, likelihood = laws_near(
        values, scale, start, (grid.left[0], grid.left[-1])
    )
    count = len(likelihood)

    def first_rate(i: int) -> float:
        if i < count:
            return rates[i] * FRAME_RATE
        cell = i - count
        return found.turns(cell) * warps.first_rates[cell] / frames * FRAME_RATE

    likelihood = certainty * np.concatenate([likelihood, found.likelihood])
    admitted = np.flatnonzero(likelihood >= likelihood.max() - max_likelihood_loss)
    left = np.concatenate([left, grid.left])
    return _LikelihoodSurface(
        likelihood=likelihood[admitted],
        ends=(first + frames + left[admitted]) / FRAME_RATE,
        exponents=np.concatenate([exponents, grid.exponents])[admitted],
        first_rates=np.array([first_rate(int(i)) for i in admitted]),
        start=first / FRAME_RATE,
        seconds=frames / FRAME_RATE,
    )
