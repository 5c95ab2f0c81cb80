"""Robust least-squares fit of the end of the motion and of the shares of
dissipation."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.linalg import toeplitz
from scipy.optimize import least_squares
from scipy.stats import norm, t

from sonify.fitting.decay_model import FITTED_LAWS, DecayModel
from sonify.fitting.phase_demodulation import Noise, Rates, rates
from sonify.fitting.settings import FIT

if TYPE_CHECKING:
    from scipy.optimize._optimize import OptimizeResult

MIN_DIVISOR = 1e-30
"""Least value of a divisor, which keeps a quotient with zero finite."""


@dataclass(frozen=True, kw_only=True)
class Value:
    """A value with its 95 % interval from `low` to `high` and its 68 % interval
    `inner`."""

    value: float
    low: float
    high: float
    inner: tuple[float, float]


class LineRates(NamedTuple):
    """Measured rates of a line, and the rates (k,) [Hz] that steady motion would have."""

    line: DecayModel
    rates: Rates
    steady: np.ndarray


@dataclass(frozen=True, kw_only=True, eq=False)
class Fit:
    """Fit of a decay to one sound, or the mean of the fits of several.

    `ends` [s] and `heard` have one entry per sound. `shares` (3,) belong to the FITTED_LAWS;
    those with indices in `free` were fitted. `draws` (d, sounds + 3) are bootstrap draws
    of ends and shares. `residual` (k,) is log(measured / fitted rate) for all blocks of
    `heard`, and `sigma` (k,) its error due to noise."""

    free: tuple[int, ...]
    ends: np.ndarray
    shares: np.ndarray
    draws: np.ndarray
    heard: tuple[LineRates, ...]
    residual: np.ndarray
    sigma: np.ndarray

    @property
    def spread(self) -> float:
        """Robust relative standard deviation of the measured from the fitted rates."""
        return _robust_deviation(self.residual)

    def fitted_shares(self) -> dict[str, Value]:
        """Return the fitted shares of the FITTED_LAWS by name."""
        names = (*FITTED_LAWS[:2], self.heard[0].line.third_share_name)
        return {names[i]: self.parameter(len(self.ends) + i) for i in self.free}

    def parameter(self, i: int) -> Value:
        """Return entry i of the ends of the sounds followed by the shares."""
        best = np.append(self.ends, self.shares)[i]
        low, inner_low, inner_high, high = np.percentile(
            self.draws[:, i], [2.5, 16, 84, 97.5]
        )
        lower_bound = 0.0 if i >= len(self.ends) else -np.inf
        inner = max(min(inner_low, best), lower_bound), max(inner_high, best)
        return Value(
            value=float(best),
            low=float(max(min(low, best), lower_bound)),
            high=float(max(high, best)),
            inner=inner,
        )


@dataclass(frozen=True, kw_only=True)
class ToneSignal:
    """Signal to be fitted, with samples (n,) at `rate` [Hz] from the time `first` [s]
    on.

    `filtered` is True for a signal with the high-pass filter of a recorder, whose phase
    shift changes the apparent rate."""

    samples: np.ndarray
    rate: float
    first: float
    filtered: bool


def fit(
    line: DecayModel,
    sound: ToneSignal,
    end: float,
    shares: np.ndarray,
    free: tuple[int, ...],
    lengths: tuple[float, ...] = FIT.block_lengths,
    refined: bool = False,
) -> Fit:
    """Fit a decay to the rates of a spectral line in a sound.

    `end` [s] and `shares` (3,) are the initial guess; with `refined`, a fitted share may
    start close to 0. Raises ValueError if fewer than eight blocks of the sound have a
    clear tone."""
    min_block_count = 8
    problem: _Problem | None = None
    for length in lengths:
        heard = line_rates(line, sound, end, shares, length)
        if len(heard.rates.time) < min_block_count:
            if problem is None:
                raise ValueError("the tone is too faint or too short to be tracked")
            break  # the run is too short for longer blocks
        problem = _Problem(heard, np.array(shares, float), free, sound.filtered)
        solution = problem.solve(end, refined, final=length == lengths[-1])
        end, shares, _ = problem.unpack(solution.x)
    assert problem is not None, "there is at least one length"
    return _with_intervals(problem, solution.x)


def line_rates(
    line: DecayModel,
    sound: ToneSignal,
    end: float,
    shares: np.ndarray,
    length: float,
    noise_of: Noise = np.mean,
) -> LineRates:
    """Return the rates of a line in a sound, demodulated with the decay of the line for
    an end [s] and shares (3,).

    `length` and `noise_of` are those of `rates`.
    """
    remaining, turned, frequency = line.course(shares)
    here = remaining > FIT.unused_end_duration
    course = np.array([end - remaining, -turned, frequency])[:, here][:, ::-1]
    found = rates(sound.samples, sound.rate, sound.first, course, length, noise_of)
    steady = line.frequency(end - found.time, shares) * (1 + found.missed)
    return LineRates(line, found, steady)


def fit_to_rates(
    heard: LineRates, end: float, shares: np.ndarray, free: tuple[int, ...]
) -> tuple[float, np.ndarray, float]:
    """Return end, shares and robust cost of the decay that best fits the given rates.

    The sound is not demodulated again.
    """
    problem = _Problem(heard, np.array(shares, float), free, filtered=False)
    solution = problem.solve(end)
    end, shares, _ = problem.unpack(solution.x)
    return end, shares, float(solution.cost)


def fitted_shares_in_words(shares: dict[str, Value]) -> str:
    """Format fitted shares with their names and 95 % intervals."""
    return ", ".join(
        f"{name} {v.value:.4g} ({v.low:.4g} to {v.high:.4g}, 95 %)"
        for name, v in shares.items()
    )


def _robust_deviation(residual: np.ndarray) -> float:
    """Return a robust standard deviation about 0."""
    return float(1.48 * np.median(np.abs(residual)))


def _relative_frequency_error(h: Rates) -> np.ndarray:
    return np.hypot(h.error / h.frequency, FIT.min_rate_error)


@dataclass(frozen=True, eq=False)
class _Problem:
    """Least-squares problem for the rates of a line.

    The unknowns x are the end [s], the free shares in their `unit` and, for a `filtered`
    sound, the corner frequency of the filter relative to its expected value."""

    heard: LineRates
    shares: np.ndarray
    free: tuple[int, ...]
    filtered: bool

    @cached_property
    def unit(self) -> np.ndarray:
        """Units of the free shares."""
        min_units = np.array([1e-5, 0.05, 0.05])  # of the FITTED_LAWS
        free = list(self.free)
        return np.maximum(self.shares[free], min_units[free])

    def unpack(self, x: np.ndarray) -> tuple[float, np.ndarray, float]:
        """Return end [s], shares (3,) and corner frequency [Hz], which is 0 without a
        filter."""
        expected_corner = 50.0  # Hz; it is as uncertain
        count = 1 + len(self.free)
        shares = self.shares.copy()
        shares[list(self.free)] = x[1:count] * self.unit
        return x[0], shares, x[count] * expected_corner if self.filtered else 0.0

    def residual(self, x: np.ndarray) -> np.ndarray:
        """Return log(measured / model) of every block, divided by its error.

        If the sound is filtered, the last entry is the relative deviation of the corner
        frequency from the expected one."""
        end, shares, corner = self.unpack(x)
        line, h, steady = self.heard
        remaining = np.maximum(end - h.time, FIT.unused_end_duration / 10)
        model = _through_high_pass(line.frequency_law(shares), remaining, corner)
        deviation = np.log(steady / model) / _relative_frequency_error(h)
        return np.concatenate([deviation, x[1 + len(self.free) :] - 1.0])

    def solve(
        self, end: float, refined: bool = False, final: bool = False
    ) -> "OptimizeResult":
        """Return the solution from an initial end [s], as in scipy."""
        max_corner = 4.0  # times its expected value
        min_start = 1e-4 if refined else 0.05  # of a share, in its unit
        tolerance = 1e-8 if final else 1e-4
        start = np.maximum(self.shares[list(self.free)] / self.unit, min_start)
        x = np.concatenate([[end], start, [1.0] * self.filtered])
        lower = np.zeros(len(x))
        last = self.heard.rates.time.max(initial=-np.inf)
        lower[0] = last + FIT.unused_end_duration / 5
        upper = np.full(len(x), np.inf)
        upper[1 + len(start) :] = max_corner
        scale = np.ones(len(x))
        scale[0] = 0.05
        x = np.maximum(x, lower + 1e-9)
        return least_squares(
            self.residual,
            x,
            bounds=(lower, upper),
            loss="cauchy",
            f_scale=2 * max(_robust_deviation(self.residual(x)), 1.0),
            ftol=tolerance,
            xtol=tolerance,
            x_scale=scale,
        )


def _through_high_pass(
    frequency: Callable[[np.ndarray], np.ndarray], remaining: np.ndarray, corner: float
) -> np.ndarray:
    """Return the apparent rate (k,) [Hz] after a second-order Butterworth high-pass
    filter.

    The phase shift of the filter decreases as the tone rises; `remaining` (k,) are remaining
    times [s]."""
    here = frequency(remaining)
    if not corner:
        return here
    step = 1e-3  # of the remaining time, for the numerical derivative of the phase
    lead = [
        np.arctan2(2**0.5 * corner * f, f**2 - corner**2)
        for f in (frequency(remaining * (1 - step)), frequency(remaining * (1 + step)))
    ]
    return here + (lead[0] - lead[1]) / (2 * step * remaining) / (2 * np.pi)


def _with_intervals(problem: _Problem, x: np.ndarray) -> Fit:
    """Return the fit for unknowns x, with bootstrap draws from runs of residuals and a
    linearised solution.

    The draws are enlarged by `_deviation_enlargement`.
    """
    draw_count = FIT.bootstrap_draws
    residual = problem.residual(x)
    scale = max(_robust_deviation(residual), 1.0)
    weight = 1 / (1 + (residual / (2 * scale)) ** 2)
    sigma = _relative_frequency_error(problem.heard.rates)
    count = len(sigma)
    noise = _bootstrap_noise(residual, count, len(x))
    jacobian = _jacobian(problem.residual, x)
    inverse = np.linalg.pinv(jacobian.T @ (weight[:, None] * jacobian)) @ (
        jacobian.T * weight
    )
    deviations = noise @ inverse.T
    deviations *= _deviation_enlargement(
        deviations.std(axis=0), residual[:count], jacobian[:count], inverse[:, :count]
    )
    moved = x - deviations
    end, shares, _ = problem.unpack(x)
    free = problem.free
    draws = np.tile(np.append(end, shares), (draw_count, 1))
    draws[:, 0] = moved[:, 0]
    draws[:, 1 + np.array(free, int)] = moved[:, 1 : 1 + len(free)] * problem.unit
    return Fit(
        free=free,
        ends=np.array([end]),
        shares=shares,
        draws=draws,
        heard=(problem.heard,),
        residual=residual[:count] * sigma,
        sigma=sigma,
    )


def _bootstrap_noise(
    residual: np.ndarray, count: int, unknown_count: int
) -> np.ndarray:
    """Return bootstrap draws (d, k) of the noise of residuals (k,), from runs of the first
    `count` with random signs.

    The runs are longer than a block, because adjacent blocks are correlated. The other
    residuals are normally distributed.
    """
    min_run_length = 4  # blocks
    max_run_count = 8
    draw_count = FIT.bootstrap_draws
    random = np.random.default_rng(0)
    run = max(min_run_length, count // max_run_count)
    independent_count = count / FIT.block_overlap
    leverage = np.sqrt(independent_count / max(independent_count - unknown_count, 1))
    runs = -(-count // run)
    drawn = (random.integers(0, count, (draw_count, runs, 1)) + np.arange(run)) % count
    signs = random.choice([-1.0, 1.0], (draw_count, runs, 1))
    noise = leverage * residual[drawn] * signs
    corner = random.standard_normal((draw_count, len(residual) - count))
    return np.hstack([noise.reshape(draw_count, -1)[:, :count], corner])


def _jacobian(
    function: Callable[[np.ndarray], np.ndarray], x: np.ndarray
) -> np.ndarray:
    """Return derivatives (k, n) from second-order one-sided differences, which keep
    shares positive."""
    steps = 1e-4 * np.maximum(np.abs(x), 0.05)
    here = function(x)
    columns = [
        (4 * function(x + h * e) - function(x + 2 * h * e) - 3 * here) / (2 * h)
        for h, e in zip(np.minimum(steps, 1e-3), np.eye(len(x)), strict=True)
    ]
    return np.stack(columns, axis=1)


def _deviation_enlargement(
    found: np.ndarray, residual: np.ndarray, jacobian: np.ndarray, inverse: np.ndarray
) -> np.ndarray:
    """Return factors (n,) for the bootstrap deviations of the unknowns, whose standard
    deviations are `found` (n,).

    The deviations become at least those due to noise with the correlation of
    overlapping blocks: the fit removes the slowest part of the noise from the residuals
    (k,), and this part determines the unknowns. Student's t then accounts for the
    number of blocks. `jacobian` (k, n) and `inverse` (n, k) relate unknowns and
    residuals."""
    min_degrees_of_freedom = 4.0
    count = len(residual)
    shared = np.maximum(1 - np.arange(count) / FIT.block_overlap, 0)
    correlation = toeplitz(shared)
    left = count - np.trace(jacobian @ inverse @ correlation)
    variance = residual @ residual / max(left, 1.0)
    expected = variance * np.sum(inverse @ correlation * inverse, axis=1)
    independent = left * count / np.sum(correlation**2)
    degrees_of_freedom = max(independent, min_degrees_of_freedom)
    student = t.ppf(0.975, degrees_of_freedom) / norm.ppf(0.975)
    return student * np.maximum(np.sqrt(expected) / np.maximum(found, MIN_DIVISOR), 1.0)


def pool_fits(fits: list[Fit]) -> Fit:
    """Return the mean of fits to single sounds, weighted by the inverse covariances of
    their free shares.

    A sound that determines only a combination of the shares contributes only this
    combination. The errors are enlarged if the shares scatter more than their errors
    predict."""
    free = list(fits[0].free)
    values = np.array([one.shares[free] for one in fits])
    deviations = [
        one.draws[:, len(one.ends) :][:, free] - value
        for one, value in zip(fits, values, strict=True)
    ]
    unit = np.maximum(
        np.sqrt([np.mean(d**2, axis=0) for d in deviations]), MIN_DIVISOR
    ).max(axis=0)
    information = np.array(
        [np.linalg.pinv((d / unit).T @ (d / unit) / len(d)) for d in deviations]
    )
    covariance = np.linalg.pinv(information.sum(axis=0))
    weighted = np.einsum("ijk,ik->j", information, values / unit)
    mean = covariance @ weighted
    excess = values / unit - mean
    scatter = np.einsum("ij,ijk,ik->", excess, information, excess)
    scatter_ratio = np.sqrt(scatter / ((len(fits) - 1) * len(free)))
    random = np.random.default_rng(0)
    drawn = random.multivariate_normal(
        mean, covariance * max(scatter_ratio, 1.0) ** 2, FIT.bootstrap_draws
    )
    shares = fits[0].shares.copy()
    shares[free] = np.maximum(mean * unit, 0.0)
    ends = np.array(
        [one.draws[:: len(one.draws) // FIT.bootstrap_draws, 0] for one in fits]
    ).T  # of all motions of a sound
    draws = np.hstack([ends, np.tile(shares, (len(ends), 1))])
    draws[:, len(fits) + np.array(free)] = drawn * unit
    return Fit(
        free=fits[0].free,
        ends=np.concatenate([one.ends for one in fits]),
        shares=shares,
        draws=draws,
        heard=tuple(h for one in fits for h in one.heard),
        residual=np.concatenate([one.residual for one in fits]),
        sigma=np.concatenate([one.sigma for one in fits]),
    )


def combine_motions(fits: list[Fit]) -> Fit:
    """Return the mean of m fits of different motions to the same sounds, with the draws
    of all fits.

    The scatter between the fits is multiplied by the ratio of the quantiles of
    Student's t and the normal distribution (Rubin 1987, 3.1.6)."""
    values = np.array([np.append(one.ends, one.shares) for one in fits])
    m = len(fits)
    mean = values.mean(axis=0)
    wider = np.sqrt(1 + 1 / m) * t.ppf(0.975, max(m - 1, 2)) / norm.ppf(0.975)
    draws = np.concatenate(
        [
            one.draws + (wider - 1) * (own - mean)
            for one, own in zip(fits, values, strict=True)
        ]
    )
    return replace(fits[0], ends=mean[:-3], shares=mean[-3:], draws=draws)
