"""Joint region of exponent and end: the laws that the windows of one end admit.

The end of the law is fitted, because it is correlated with the exponent, and several
stops of the windows are tried. Intervals in which a disk is still upright, before its
rate begins to rise, are excluded if the later part contradicts the law of the whole.
"""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from sonify.hearing.settling.onset_strength import FRAME_RATE, OnsetStrength
from sonify.hearing.settling.prediction_score import correlation_length
from sonify.hearing.settling.rate_laws import Shape, ShapeSet
from sonify.hearing.settling.refinement import laws_near
from sonify.hearing.settling.settings import SettlingSettings
from sonify.hearing.settling.warped_periodogram import (
    minimum_turns,
    search_table,
    steps_for,
    turns_of,
    warp_table,
)

EXPONENT_STEP = 0.05
END_COUNT = 12
STOPS_BEFORE_KNEE_MS = (5, 50, 100)
MAX_EQUAL_RATE_DEVIATION = 0.12
"""Maximum difference between the logarithms of two rates that count as equal."""
MIN_MISCOUNT_DEVIATION = 0.5
"""Minimum difference between the logarithms of two rates if one of them counts half or
twice the bursts."""


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

    The rates are those one second before the end, or at the `start` [s] of the best
    window if that is later."""

    exponents: np.ndarray
    ends: np.ndarray
    rates: np.ndarray
    best_exponent: float
    best_end: float
    best_rate: float
    start: float

    def later(self, seconds: float) -> "JointRegion":
        """Return the region shifted to later times by `seconds`."""
        return replace(
            self,
            ends=self.ends + seconds,
            best_end=self.best_end + seconds,
            start=self.start + seconds,
        )

    def estimates(
        self, settings: SettlingSettings
    ) -> tuple[Estimate, Estimate, Estimate]:
        """Return exponent, end and rate; their intervals are the widened ranges of the
        region.

        The interval of the end includes the time between bursts 20 ms before it.
        """
        resolution = settings.resolution
        factor = settings.interval_factor
        span = min(1.0, self.best_end - self.start)
        last_interval = (0.02 / span) ** self.best_exponent / self.best_rate
        exponent = _widened(
            self.best_exponent, self.exponents, resolution.exponent, factor
        )
        end = _widened(self.best_end, self.ends, resolution.end + last_interval, factor)
        rate = _widened(
            self.best_rate, self.rates, resolution.rate * self.best_rate, factor
        )
        if exponent.high - exponent.low > settings.max_exponent_interval:
            exponent = Estimate(None, exponent.low, exponent.high)
        return exponent, end, rate


def region_of_law(law, errors, start, settings: SettlingSettings) -> JointRegion:
    """Return the laws within two standard errors, and the resolution, of a law (3,) of
    end [s], exponent and log2 of the rate one second before the end [Hz]."""
    resolution = settings.tone_resolution
    half = 2 * errors + [
        resolution.end,
        resolution.exponent,
        np.log2(1 + resolution.rate),
    ]
    ends, exponents, heights = (law + half * np.array([[-1], [0], [1]])).T
    span = min(1.0, law[0] - start)
    rates = 2**heights * span ** -law[1]
    return JointRegion(
        exponents=exponents,
        ends=ends,
        rates=rates,
        best_exponent=float(law[1]),
        best_end=float(law[0]),
        best_rate=float(rates[1]),
        start=start,
    )


def _widened(value, values, resolution, factor):
    """Return an estimate with the range of `values`, widened by a resolution and a
    factor."""
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
def _law_grid(frames: int, before_knee: int, settings: SettlingSettings) -> _LawGrid:
    """Return the tested laws of a window that stops `before_knee` frames before the
    knee."""
    earliest, latest = (before_knee + limit for limit in settings.end_range_ms)
    ends = np.linspace(max(earliest, 3), latest, END_COUNT)
    low, high = settings.exponents
    powers = np.arange(low, high + 1e-9, EXPONENT_STEP)
    left, exponents = (
        axis.ravel() for axis in np.meshgrid(ends, powers, indexing="ij")
    )
    ratios = (1 + frames / left) ** exponents
    shapes = [Shape("disk", *law) for law in zip(ratios, exponents, strict=True)]
    return _LawGrid(left, exponents, ShapeSet(tuple(shapes), ("disk",), np.zeros(1)))


def joint_region(
    onsets: OnsetStrength, channel: int, knee: int, settings: SettlingSettings
) -> JointRegion | None:
    """Return the joint region of a run that stops at the frame `knee`, or None if no
    window fits.

    The best law is that of a window of `channel` that extends to the knee; earlier
    windows and other channels extend the region."""
    surfaces = _likelihood_surfaces(
        onsets, channel, knee, STOPS_BEFORE_KNEE_MS[0], settings
    )
    if not surfaces:
        return None
    whole = max(surfaces, key=lambda surface: surface.max_likelihood)
    for before_knee in STOPS_BEFORE_KNEE_MS[1:]:
        surfaces += _likelihood_surfaces(onsets, channel, knee, before_knee, settings)
    for other in range(len(onsets.values)):
        if other != channel:
            surfaces += _likelihood_surfaces(
                onsets, other, knee, STOPS_BEFORE_KNEE_MS[1], settings
            )
    surfaces, reference = _without_standing(surfaces, whole, settings)
    max_likelihood = (
        whole.max_likelihood
        if reference is whole
        else max(surface.max_likelihood for surface in surfaces)
    )
    span = min(1.0, reference.max_remaining_time)
    weights = np.exp(reference.likelihood - reference.max_likelihood)
    reference_rates = reference.rates(span)
    weights *= (
        np.abs(np.log(reference_rates / reference_rates[np.argmax(weights)]))
        < MAX_EQUAL_RATE_DEVIATION
    )
    weights /= weights.sum()
    best_rate = float(np.exp(weights @ np.log(reference_rates)))
    kept = [
        surface
        for surface in surfaces
        if surface.max_likelihood >= settings.min_admitted_likelihood * max_likelihood
        and surface.seconds >= settings.min_admitted_length * reference.seconds
    ]
    exponents = np.concatenate([surface.exponents for surface in kept])
    ends = np.concatenate([surface.ends for surface in kept])
    rates = np.concatenate([surface.rates(span) for surface in kept])
    has_equal_rate = np.abs(np.log(rates / best_rate)) < MAX_EQUAL_RATE_DEVIATION
    return JointRegion(
        exponents=exponents[has_equal_rate],
        ends=ends[has_equal_rate],
        rates=rates[has_equal_rate],
        best_exponent=float(weights @ reference.exponents),
        best_end=float(weights @ reference.ends),
        best_rate=best_rate,
        start=reference.start,
    )


def _without_standing(surfaces, whole, settings):
    """Return the likelihood surfaces of a run and that of its best window, without the
    times at which the disk is upright."""

    def rate_deviation(surface):
        middle = surface.start + surface.seconds / 2
        return abs(np.log(surface.best_rate(middle) / whole.best_rate(middle)))

    if whole.best_rate(whole.start) < settings.max_upright_rate:
        later = [
            surface
            for surface in surfaces
            if surface.seconds < whole.seconds
            and surface.max_likelihood > settings.min_likelihood_for_rivals
            and surface.best_rate(surface.start) > settings.max_upright_rate
            and rate_deviation(surface) < MIN_MISCOUNT_DEVIATION
        ]
        min_likelihood = settings.min_admitted_likelihood * max(
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
        if rate_deviation(best) > MAX_EQUAL_RATE_DEVIATION:
            return later, _merged_surface(
                [one for one in likely if one.seconds == best.seconds]
            )
    return surfaces, whole


def _merged_surface(surfaces):
    """Return the common likelihood surface of windows of one length that stop at
    different times."""
    start = surfaces[0].start
    rates = [
        one.first_rates * one.remaining_time_ratios(start) ** -one.exponents
        for one in surfaces
    ]
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
    def max_likelihood(self):
        """Largest log likelihood."""
        return float(self.likelihood.max())

    @property
    def max_remaining_time(self):
        """Longest remaining time [s] at the start of the window."""
        return float(self.ends.max() - self.start)

    def rates(self, left):
        """Return the rates (admitted,) at a time [s] before the end."""
        return self.first_rates * (left / (self.ends - self.start)) ** -self.exponents

    def remaining_time_ratios(self, time):
        """Return the remaining time at a time [s], relative to that at the start of the
        window."""
        return (self.ends - time) / (self.ends - self.start)

    def best_rate(self, time):
        """Return the rate of the most likely law at a time [s]."""
        best = np.argmax(self.likelihood)
        left = np.maximum(self.ends[best] - time, 1e-3)
        return self.rates(left)[best]


def _likelihood_surfaces(onsets, channel, knee, before_knee, settings):
    """Return the likelihood surfaces of all windows of a channel that stop
    `before_knee` frames before the knee."""
    found = []
    for length in settings.window_lengths:
        frames = round(length * FRAME_RATE)
        first = knee - before_knee - frames
        if first >= 0:
            found.append(
                _likelihood_surface(
                    onsets, channel, first, frames, before_knee, settings
                )
            )
    return found


def _likelihood_surface(onsets, channel, first, frames, before_knee, settings):
    """Return the likelihood surface of the laws that one window admits."""
    values = onsets.values[channel, first : first + frames]
    scale = onsets.scales_ms[channel]
    grid = _law_grid(frames, before_knee, settings)
    table = warp_table(grid.shapes, frames, steps_for(frames, scale))
    likelihood, harmonics, spectra = search_table(values, scale, table, settings)
    min_turns = minimum_turns(frames, table, settings)
    left = grid.left

    def first_rate(cell):
        turns = turns_of(spectra[cell], min_turns[cell], harmonics[cell])
        return turns * table.first_rates[cell] / frames * FRAME_RATE

    best = int(np.argmax(likelihood))
    turns = turns_of(spectra[best], min_turns[best], harmonics[best])
    cuts = table.index[best] + table.fraction[best]
    phases = np.interp(
        np.arange(frames) + 0.5, cuts, turns * np.linspace(0, 1, len(cuts))
    )
    certainty = min(
        1.0, scale / correlation_length(values, phases, int(harmonics[best]))
    )
    near = laws_near(
        values,
        scale,
        (left[best], grid.exponents[best], turns),
        (left[0], left[-1]),
        settings,
    )
    likelihood = certainty * np.concatenate([near[3], likelihood])
    admitted = np.flatnonzero(likelihood >= likelihood.max() - 2)
    cells = admitted[admitted >= len(near[3])] - len(near[3])
    laws = admitted[admitted < len(near[3])]
    return _LikelihoodSurface(
        likelihood=likelihood[admitted],
        ends=(first + frames + np.concatenate([near[0][laws], left[cells]]))
        / FRAME_RATE,
        exponents=np.concatenate([near[1][laws], grid.exponents[cells]]),
        first_rates=np.concatenate(
            [near[2][laws] * FRAME_RATE, [first_rate(cell) for cell in cells]]
        ),
        start=first / FRAME_RATE,
        seconds=frames / FRAME_RATE,
    )
