"""RUN -> JOINT REGION of exponent and end: every law that windows of one end admit, with free end
and several stops.

End and exponent lie on one ridge. The law is that of a disk which may still stand at the beginning
of the window: the rate is f_0 / sqrt(sin beta) with an inclination beta ~ (t_end - t)^(2 n), which
is `upright` at the beginning; a pure power law for `upright` = 0."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numba import njit

from sonify.hearing.settling.onset_strength import FRAME_RATE, OnsetStrength
from sonify.hearing.settling.prediction_score import correlation_length
from sonify.hearing.settling.refinement import laws_near
from sonify.hearing.settling.settings import SettlingSettings
from sonify.hearing.settling.warped_periodogram import (
    WarpTable,
    least_turns,
    search_table,
    steps_for,
    turns_of,
)

UPRIGHT = (0.0, 0.9, 1.5)  # rad
EXPONENT_STEP = 0.05
ENDS = 12
STOPS_BEFORE_KNEE_MS = (5, 50, 100)
NODES = 160


@dataclass(frozen=True)
class Estimate:
    """A value and its interval; the value is None where the interval is too wide to call it
    determined."""

    value: float | None
    low: float
    high: float

    def later(self, seconds: float) -> "Estimate":
        """Return the estimate of a time so much later [s]."""
        value = None if self.value is None else self.value + seconds
        return Estimate(value, self.low + seconds, self.high + seconds)


@dataclass(frozen=True)
class JointRegion:
    """Exponents, ends [s] and rates [Hz] (cells,) that the windows of one end admit, and the best
    of them.

    Rates are those one second before the end, or at the `start` [s] of the best window if that is
    shorter."""

    exponents: np.ndarray
    ends: np.ndarray
    rates: np.ndarray
    best_exponent: float
    best_end: float
    best_rate: float
    start: float

    def later(self, seconds: float) -> "JointRegion":
        """Return the region with all ends so much later [s]."""
        return replace(
            self,
            ends=self.ends + seconds,
            best_end=self.best_end + seconds,
            start=self.start + seconds,
        )

    def estimates(
        self, kind: str, settings: SettlingSettings
    ) -> tuple[Estimate, Estimate, Estimate]:
        """Return exponent, end and rate with intervals: the ranges of the region, widened by a
        factor.

        The end is not known better than the interval between bursts 20 ms before it.
        """
        resolution = settings.tone_resolution if kind == "tone" else settings.repetition_resolution
        factor = settings.interval_factor
        span = min(1.0, self.best_end - self.start)
        last_interval = (0.02 / span) ** self.best_exponent / self.best_rate
        exponent = _widened(self.best_exponent, self.exponents, resolution.exponent, factor)
        end = _widened(self.best_end, self.ends, resolution.end + last_interval, factor)
        rate = _widened(self.best_rate, self.rates, resolution.rate * self.best_rate, factor)
        if exponent.high - exponent.low > settings.widest_exponent:
            exponent = Estimate(None, exponent.low, exponent.high)
        return exponent, end, rate


def _widened(value, values, resolution, factor):
    """The range of values about one of them, widened by a factor."""
    below = max(value - float(np.min(values)), 0.0) + resolution
    above = max(float(np.max(values)) - value, 0.0) + resolution
    return Estimate(value, value - factor * below, value + factor * above)


@njit(cache=True, nogil=True)
def _relative_rate(left, exponent, upright):
    """Rate over that at the beginning of the window, where `left` is the time left over that at the
    beginning."""
    if upright == 0.0:
        return left**-exponent
    return math.sqrt(
        math.sin(upright) / math.sin(min(upright * left ** (2 * exponent), math.pi / 2))
    )


@njit(cache=True, nogil=True)
def _warp_places(lengths_left, exponents, uprights, length, steps, nodes):
    """Return places (cells, steps + 1) of equal steps of phase in a window, and first over mean
    rate.

    lengths_left, exponents, uprights (cells,): frames from the end of the window to that of the
    disk, and the law; length: frames of the window."""
    cells = len(exponents)
    places = np.empty((cells, steps + 1))
    first_rates = np.empty(cells)
    phase = np.empty(nodes + 1)
    time = np.empty(nodes + 1)
    for c in range(cells):
        whole = length + lengths_left[c]
        last = lengths_left[c] / whole
        phase[0] = 0.0
        time[0] = 0.0
        rate = 1.0
        for k in range(1, nodes + 1):
            left = last ** (k / nodes)
            now = _relative_rate(left, exponents[c], uprights[c])
            time[k] = (1 - left) * whole
            phase[k] = phase[k - 1] + (rate + now) / 2 * (time[k] - time[k - 1])
            rate = now
        first_rates[c] = length / phase[nodes]
        k = 1
        for j in range(steps + 1):
            wanted = phase[nodes] * j / steps
            while k < nodes and phase[k] < wanted:
                k += 1
            share = (wanted - phase[k - 1]) / (phase[k] - phase[k - 1])
            places[c, j] = time[k - 1] + share * (time[k] - time[k - 1])
    return places, first_rates


@lru_cache(maxsize=128)
def _cells(before_knee: int, end_range_ms: tuple[int, int], exponents: tuple[float, float]):
    """Return the grid of laws: frames from the stop to the end of the disk, exponents, uprights
    (cells,)."""
    earliest, latest = (before_knee + limit for limit in end_range_ms)
    ends = np.linspace(max(earliest, 3), latest, ENDS)
    powers = np.arange(exponents[0], exponents[1] + 1e-9, EXPONENT_STEP)
    grid = np.meshgrid(ends, powers, np.array(UPRIGHT), indexing="ij")
    return tuple(axis.ravel() for axis in grid)


@lru_cache(maxsize=256)
def _table(cells, length: int, steps: int) -> WarpTable:
    """Return the warp table of all laws of the grid."""
    ends, exponents, uprights = _cells(*cells)
    places, first_rates = _warp_places(ends, exponents, uprights, length, steps, NODES)
    index = np.clip(places.astype(np.int32), 0, length - 1)
    return WarpTable(index, (places - index).astype(np.float32), first_rates)


def joint_region(
    onsets: OnsetStrength, channel: int, knee: int, settings: SettlingSettings
) -> JointRegion | None:
    """Return the joint region of a run that stops at the frame `knee` and is heard best on a
    channel.

    None if no window fits. The best law is that of a window that runs to the knee; windows that
    stop earlier and those of other channels add to the region."""
    surfaces = _surfaces(onsets, channel, knee, STOPS_BEFORE_KNEE_MS[0], settings)
    if not surfaces:
        return None
    reference = max(surfaces, key=lambda surface: surface.top)
    for before_knee in STOPS_BEFORE_KNEE_MS[1:]:
        surfaces += _surfaces(onsets, channel, knee, before_knee, settings)
    for other, kind in enumerate(onsets.kinds):
        if kind == onsets.kinds[channel] and other != channel:
            surfaces += _surfaces(onsets, other, knee, STOPS_BEFORE_KNEE_MS[1], settings)
    span = min(1.0, reference.longest)
    weights = np.exp(reference.likelihood - reference.top)
    weights /= weights.sum()
    best_rate = float(np.exp(weights @ np.log(reference.rates(span))))
    kept = [
        surface
        for surface in surfaces
        if surface.top >= settings.admitted_share * reference.top
        and surface.seconds >= settings.admitted_length * reference.seconds
    ]
    exponents = np.concatenate([surface.exponents for surface in kept])
    ends = np.concatenate([surface.ends for surface in kept])
    rates = np.concatenate([surface.rates(span) for surface in kept])
    same_reading = np.abs(np.log(rates / best_rate)) < 0.12  # not half or twice as many bursts
    return JointRegion(
        exponents=exponents[same_reading],
        ends=ends[same_reading],
        rates=rates[same_reading],
        best_exponent=float(weights @ reference.exponents),
        best_end=float(weights @ reference.ends),
        best_rate=best_rate,
        start=reference.start,
    )


@dataclass(frozen=True)
class _Surface:
    """The laws that a window admits (admitted,), with their log likelihoods.

    longest: time left at the beginning of the window [s]; start of the window [s]; first_rates at
    its beginning [Hz]; seconds: its length."""

    likelihood: np.ndarray
    ends: np.ndarray
    exponents: np.ndarray
    uprights: np.ndarray
    first_rates: np.ndarray
    start: float
    seconds: float

    @property
    def top(self):
        """The largest log likelihood."""
        return float(self.likelihood.max())

    @property
    def longest(self):
        """The time left at the beginning of the window [s], for the latest end."""
        return float(self.ends.max() - self.start)

    def rates(self, left):
        """Return the rates (admitted,) at a time [s] before the end."""
        shares = left / (self.ends - self.start)
        laws = zip(shares, self.exponents, self.uprights, strict=True)
        return self.first_rates * np.array([_relative_rate(*law) for law in laws])


def _surfaces(onsets, channel, knee, before_knee, settings):
    """The surfaces of all windows of a channel that stop some frames before the knee."""
    found = []
    for length in settings.window_lengths:
        frames = round(length * FRAME_RATE)
        first = knee - before_knee - frames
        if first >= 0:
            found.append(_surface(onsets, channel, first, frames, before_knee, settings))
    return found


def _surface(onsets, channel, first, frames, before_knee, settings):
    """The log likelihood of all laws of the grid in one window."""
    values = onsets.values[channel, first : first + frames]
    scale = onsets.scales_ms[channel]
    ranges = settings.tone_end_range_ms, settings.end_range_ms
    cells = before_knee, ranges[onsets.kinds[channel] != "tone"], settings.exponents
    table = _table(cells, frames, steps_for(frames, scale))
    likelihood, harmonics, spectra = search_table(values, scale, table, settings)
    least = least_turns(frames, table, settings)
    left, exponents, uprights = _cells(*cells)

    def first_rate(cell):
        turns = turns_of(spectra[cell], least[cell], harmonics[cell])
        return turns * table.first_rates[cell] / frames * FRAME_RATE

    power_law = first_rate(int(np.argmax(np.where(uprights == 0, likelihood, -np.inf))))
    standing = power_law * np.sqrt(np.sin(uprights)) <= settings.fastest_standing
    likelihood = np.where((uprights == 0) | standing, likelihood, -np.inf)
    best = int(np.argmax(likelihood))
    turns = turns_of(spectra[best], least[best], harmonics[best])
    cuts = table.index[best] + table.fraction[best]
    phases = np.interp(np.arange(frames) + 0.5, cuts, turns * np.linspace(0, 1, len(cuts)))
    certainty = min(1.0, scale / correlation_length(values, phases, int(harmonics[best])))
    near = laws_near(
        values, scale, (left[best], exponents[best], turns), (left[0], left[-1]), settings
    )
    if uprights[best] > 0:
        near = tuple(axis[:0] for axis in near)
    likelihood = certainty * np.concatenate([near[3], likelihood])
    admitted = np.flatnonzero(likelihood >= likelihood.max() - 2)
    cells = admitted[admitted >= len(near[3])] - len(near[3])
    laws = admitted[admitted < len(near[3])]
    return _Surface(
        likelihood=likelihood[admitted],
        ends=(first + frames + np.concatenate([near[0][laws], left[cells]])) / FRAME_RATE,
        exponents=np.concatenate([near[1][laws], exponents[cells]]),
        uprights=np.concatenate([np.zeros(len(laws)), uprights[cells]]),
        first_rates=np.concatenate(
            [near[2][laws] * FRAME_RATE, [first_rate(cell) for cell in cells]]
        ),
        start=first / FRAME_RATE,
        seconds=frames / FRAME_RATE,
    )
