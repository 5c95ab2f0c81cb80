"""RATES -> SHARES: end of the motion and shares of dissipation with intervals, by robust least
squares."""

from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import norm, t

from sonify.fitting.decay_model import LAWS, Decline
from sonify.fitting.phase_demodulation import BLOCK_OVERLAP, Rates, rates

BLOCK_LENGTHS = (8.0, 10.0, 12.0, 16.0, 16.0)
"""Turns per block in successive rounds. Short blocks tolerate a poor initial guess, long blocks
reduce the noise."""
ROUGH_TOLERANCE = 1e-4
"""Relative tolerance of the solution in all rounds but the last."""
FINAL_TOLERANCE = 1e-8
"""Relative tolerance of the solution in the last round."""
MIN_RATE_ERROR = 2e-4
"""Least relative error of the rate of a block, because the decline is not exactly steady."""
BOOTSTRAP_DRAWS = 400
"""Number of bootstrap draws of the residuals."""
MIN_RUN_BLOCKS = 4
"""Least number of blocks in a run of residuals; runs are drawn because adjacent blocks overlap."""
MAX_RUN_COUNT = 8
"""Largest number of runs of residuals."""
TINY = 1e-30
UNUSED_END = 0.01
"""The last part of the motion that is not used [s]."""


@dataclass(frozen=True, kw_only=True)
class Value:
    """A value with its 95 % interval, `low` to `high`, and its 68 % interval, `inner`."""

    value: float
    low: float
    high: float
    inner: tuple[float, float]


class LineRates(NamedTuple):
    """Rates of a line measured in the sound of index `sound`, and the rates (k,) [Hz] of steady
    motion."""

    sound: int
    line: Decline
    rates: Rates
    steady: np.ndarray


@dataclass(frozen=True, kw_only=True, eq=False)
class Fit:
    """Fit of a decline to one or more sounds.

    `ends` [s] has one entry per sound. `shares` (3,) are those of the LAWS; those of index `free`
    were fitted. `draws` (d, sounds + 3) are bootstrap draws of ends and shares. `residual` (k,) is
    log(measured / fitted rate) of all blocks of `heard`, and `sigma` (k,) its error by noise.
    """

    free: tuple[int, ...]
    ends: np.ndarray
    shares: np.ndarray
    draws: np.ndarray
    heard: tuple[LineRates, ...]
    residual: np.ndarray
    sigma: np.ndarray

    @property
    def spread(self) -> float:
        """The robust relative standard deviation of measured from fitted rates."""
        return _robust_deviation(self.residual)

    def values(self) -> dict[str, Value]:
        """Return the fitted shares of the LAWS by name."""
        return {LAWS[i]: self.value(len(self.ends) + i) for i in self.free}

    def value(self, i: int) -> Value:
        """Return the end of sound i; from the number of sounds on, the shares."""
        best = np.append(self.ends, self.shares)[i]
        low, inner_low, inner_high, high = np.percentile(self.draws[:, i], [2.5, 16, 84, 97.5])
        least = 0.0 if i >= len(self.ends) else -np.inf
        inner = max(min(inner_low, best), least), max(inner_high, best)
        return Value(
            value=float(best),
            low=float(max(min(low, best), least)),
            high=float(max(high, best)),
            inner=inner,
        )


@dataclass(frozen=True, kw_only=True)
class ToneSignal:
    """A signal to be fitted: samples (n,) at `rate` [Hz], from the time `first` [s] on.

    `filtered` is True if it passed the high-pass of a recorder, whose phase shift resembles a rate.
    """

    samples: np.ndarray
    rate: float
    first: float
    filtered: bool = False

    @cached_property
    def integral(self) -> np.ndarray:
        """Cumulative sum (n + 1,) of the samples."""
        return np.append(0.0, np.cumsum(self.samples))


def measured_rates(decline: Decline, sound: ToneSignal, end, shares, length, **how) -> Rates:
    """Return the rates of a sound relative to the decline with an end [s] and shares (3,).

    Further arguments are those of `rates`.
    """
    left, turned, frequency = decline.course(shares)
    here = left > UNUSED_END
    course = np.array([end - left, -turned, frequency])[:, here][:, ::-1]
    return rates(
        sound.samples, sound.rate, sound.first, course, length, integral=sound.integral, **how
    )


def fit(
    line: Decline,
    sounds: list[ToneSignal],
    ends,
    shares,
    free: tuple[int, ...],
    lengths=BLOCK_LENGTHS,
    least=0.05,
) -> Fit:
    """Return the fit of a line of a decline to sounds.

    `ends` [s] and `shares` (3,) are the initial guess; shares are raised to `least` of their SHARE_UNITS.
    Raises ValueError if fewer than eight blocks of the sounds have a clear tone.
    """
    ends = np.array(ends, float)
    shares = np.array(shares, float)
    filtered = all(sound.filtered for sound in sounds)
    heard: tuple[LineRates, ...] = ()
    for length in lengths:
        longer = line_rates(line, sounds, ends, shares, length)
        if sum(len(h.rates.time) for h in longer) < 8:
            if not heard:
                raise ValueError("the tone is too faint or too short to be followed")
            break  # a short run has no more long blocks
        heard = longer
        tolerance = FINAL_TOLERANCE if length == lengths[-1] else ROUGH_TOLERANCE
        ends, shares, solved = _solved(heard, filtered, ends, shares, free, least, tolerance)
    return _with_intervals(heard, ends, shares, free, solved)


def line_rates(
    line: Decline, sounds: list[ToneSignal], ends, shares, length, **how
) -> tuple[LineRates, ...]:
    """Return the rates of a line in every sound, relative to the decline of ends [s] and shares
    (3,).

    Further arguments are those of `rates`.
    """
    found = []
    for i, (sound, end) in enumerate(zip(sounds, ends, strict=True)):
        here = measured_rates(line, sound, end, shares, length, **how)
        found.append(
            LineRates(i, line, here, line.frequency(end - here.time, shares) * (1 + here.missed))
        )
    return tuple(found)


def fit_to_rates(heard: tuple[LineRates, ...], ends, shares, free):
    """Return ends, shares and robust cost of the decline that fits given rates best.

    The sounds are not demodulated again.
    """
    ends, shares, (solved, _) = _solved(
        heard, False, np.array(ends, float), np.array(shares, float), free
    )
    return ends, shares, float(solved.cost)


def values_in_words(values: dict[str, Value]) -> str:
    """Return values by name with their 95 % intervals as text."""
    return ", ".join(
        f"{name} {v.value:.4g} ({v.low:.4g} to {v.high:.4g}, 95 %)" for name, v in values.items()
    )


def _robust_deviation(residual) -> float:
    """Return a robust standard deviation about 0."""
    return float(1.48 * np.median(np.abs(residual)))


def _relative_error(h):
    return np.hypot(h.error / h.frequency, MIN_RATE_ERROR)


def _unpack(x, sounds, shares, free, unit):
    full = shares.copy()
    count = sounds + len(free)
    full[list(free)] = x[sounds:count] * unit
    return x[:sounds], full, x[count] * HIGH_PASS_CORNER if len(x) > count else 0.0


def _residual(x, heard, sounds, shares, free, unit):
    """Return log(measured / model) of every block, divided by its error.

    Behind a high-pass, the last entry is the deviation of its corner from HIGH_PASS_CORNER.
    """
    ends, full, corner = _unpack(x, sounds, shares, free, unit)
    out = []
    for i, line, h, steady in heard:
        left = np.maximum(ends[i] - h.time, UNUSED_END / 10)
        model = _through_high_pass(partial(line.frequency, shares=full), left, corner)
        out.append(np.log(steady / model) / _relative_error(h))
    return np.concatenate([*out, x[sounds + len(free) :] - 1.0])


def _through_high_pass(frequency, left, corner):
    """Return the rate [Hz] at times left (k,) [s] behind a second-order Butterworth high-pass.

    The phase shift of the filter decreases as the tone rises, which changes the apparent rate.
    """
    here = frequency(left)
    if not corner:
        return here
    lead = [
        np.arctan2(2**0.5 * corner * f, f**2 - corner**2)
        for f in (
            frequency(left * (1 - PHASE_DERIVATIVE_STEP)),
            frequency(left * (1 + PHASE_DERIVATIVE_STEP)),
        )
    ]
    return here + (lead[0] - lead[1]) / (2 * PHASE_DERIVATIVE_STEP * left) / (2 * np.pi)


def _solved(heard, filtered, ends, shares, free, least=0.05, tolerance=ROUGH_TOLERANCE):
    unit = np.maximum(shares[list(free)], [SHARE_UNITS[i] for i in free])
    x = np.concatenate([ends, np.maximum(shares[list(free)] / unit, least), [1.0] * filtered])
    others = np.zeros(len(x) - len(ends))
    last = np.full(len(ends), -np.inf)
    for i, _, h, _ in heard:
        last[i] = max(last[i], h.time.max(initial=-np.inf))
    lower = np.append(last + UNUSED_END / 5, others)
    upper = np.full(len(x), np.inf)
    upper[len(ends) + len(free) :] = MAX_CORNER_FACTOR
    x = np.maximum(x, lower + 1e-9)
    arguments = (heard, len(ends), shares, free, unit)
    scale = max(_robust_deviation(_residual(x, *arguments)), 1.0)
    solved = least_squares(
        _residual,
        x,
        bounds=(lower, upper),
        args=arguments,
        loss="cauchy",
        f_scale=2 * scale,
        ftol=tolerance,
        xtol=tolerance,
        x_scale=np.append(np.full(len(ends), 0.05), np.ones(len(others))),
    )
    ends, full, _ = _unpack(solved.x, len(ends), shares, free, unit)
    return ends, full, (solved, unit)


HIGH_PASS_CORNER = 50.0
"""Corner frequency of a recorder's high-pass, which is also its uncertainty [Hz]."""
MAX_CORNER_FACTOR = 4.0
"""Largest corner frequency, in units of HIGH_PASS_CORNER."""
PHASE_DERIVATIVE_STEP = 1e-3
"""Relative step in the time left of the numerical derivative of the phase."""
SHARE_UNITS = (1e-5, 0.05, 0.05)
"""Shares of the LAWS below which the search starts from these values."""


def _with_intervals(heard, ends, shares, free, solution):
    """Return the fit with bootstrap draws: residuals drawn in runs of blocks, solved linearly."""
    solved, unit = solution
    arguments = (heard, len(ends), shares, free, unit)
    residual = _residual(solved.x, *arguments)
    scale = max(_robust_deviation(residual), 1.0)
    weight = 1 / (1 + (residual / (2 * scale)) ** 2)
    sigma = np.concatenate([_relative_error(h.rates) for h in heard])
    random = np.random.default_rng(0)
    count = len(sigma)
    run = max(MIN_RUN_BLOCKS, count // MAX_RUN_COUNT)
    apart = count / BLOCK_OVERLAP
    leverage = np.sqrt(apart / max(apart - len(solved.x), 1))
    runs = -(-count // run)
    drawn = (random.integers(0, count, (BOOTSTRAP_DRAWS, runs, 1)) + np.arange(run)) % count
    noise = leverage * residual[drawn] * random.choice([-1.0, 1.0], (BOOTSTRAP_DRAWS, runs, 1))
    corner = random.standard_normal((BOOTSTRAP_DRAWS, len(residual) - count))
    noise = np.hstack([noise.reshape(BOOTSTRAP_DRAWS, -1)[:, :count], corner])
    jacobian = _jacobian(lambda x: _residual(x, *arguments), solved.x)
    inverse = np.linalg.pinv(jacobian.T @ (weight[:, None] * jacobian)) @ (jacobian.T * weight)
    moved = solved.x - noise @ inverse.T
    draws = np.tile(np.append(ends, shares), (BOOTSTRAP_DRAWS, 1))
    draws[:, : len(ends)] = moved[:, : len(ends)]
    draws[:, len(ends) + np.array(free, int)] = moved[:, len(ends) : len(ends) + len(free)] * unit
    return Fit(
        free=free,
        ends=ends,
        shares=shares,
        draws=draws,
        heard=heard,
        residual=residual[:count] * sigma,
        sigma=sigma,
    )


def _jacobian(function, x):
    """Return the derivatives (k, n) by one-sided differences of second order; shares are not
    negative."""
    steps = 1e-4 * np.maximum(np.abs(x), 0.05)
    here = function(x)
    columns = [
        (4 * function(x + h * e) - function(x + 2 * h * e) - 3 * here) / (2 * h)
        for h, e in zip(np.minimum(steps, 1e-3), np.eye(len(x)), strict=True)
    ]
    return np.stack(columns, axis=1)


def pool_fits(fits: list[Fit]) -> Fit:
    """Return the mean of fits to single sounds, weighted by the inverse variances of their shares.

    If the shares scatter more than their errors predict, the errors are scaled up accordingly.
    """
    values = np.array([one.shares for one in fits])
    draws = np.array([one.draws[:BOOTSTRAP_DRAWS, 1:] for one in fits])
    spread = np.maximum(draws.std(axis=1), TINY)
    weight = spread**-2 / np.sum(spread**-2, axis=0)
    mean = np.sum(weight * values, axis=0)
    apart = np.sqrt(np.sum(((values - mean) / spread) ** 2, axis=0) / (len(fits) - 1))
    random = np.random.default_rng(0)
    away = np.sum(
        [w * random.permutation(d - v) for w, d, v in zip(weight, draws, values, strict=True)],
        axis=0,
    )
    ends = np.array([one.draws[: len(away), 0] for one in fits]).T
    return Fit(
        free=fits[0].free,
        ends=np.concatenate([one.ends for one in fits]),
        shares=mean,
        draws=np.hstack([ends, mean + away * np.maximum(apart, 1.0)]),
        heard=tuple(h._replace(sound=i) for i, one in enumerate(fits) for h in one.heard),
        residual=np.concatenate([one.residual for one in fits]),
        sigma=np.concatenate([one.sigma for one in fits]),
    )


def combine_motions(fits: list[Fit]) -> Fit:
    """Return the mean of m fits to the same sounds with different motions, with the draws of all.

    The scatter between the fits enters with Student's factor over that of a normal error (Rubin
    1987, 3.1.6).
    """
    values = np.array([np.append(one.ends, one.shares) for one in fits])
    m = len(fits)
    mean = values.mean(axis=0)
    wider = np.sqrt(1 + 1 / m) * t.ppf(0.975, max(m - 1, 2)) / norm.ppf(0.975)
    draws = np.concatenate(
        [one.draws + (wider - 1) * (own - mean) for one, own in zip(fits, values, strict=True)]
    )
    count = len(fits[0].ends)
    return replace(fits[0], ends=mean[:count], shares=mean[count:], draws=draws)
