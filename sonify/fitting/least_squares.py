"""Robust least-squares fit of the end of the motion and of the shares of
dissipation."""

from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import norm, t

from sonify.fitting.decay_model import LAWS, DecayModel
from sonify.fitting.phase_demodulation import Rates, rates
from sonify.fitting.settings import FIT

TINY = 1e-30


@dataclass(frozen=True, kw_only=True)
class Value:
    """A value with its 95 % interval from `low` to `high` and its 68 % interval
    `inner`."""

    value: float
    low: float
    high: float
    inner: tuple[float, float]


class LineRates(NamedTuple):
    """Rates of a line measured in the sound with index `sound`, and rates (k,) [Hz]
    that steady motion would have."""

    sound: int
    line: DecayModel
    rates: Rates
    steady: np.ndarray


@dataclass(frozen=True, kw_only=True, eq=False)
class Fit:
    """Fit of a decay to one or more sounds.

    `ends` [s] has one entry per sound. `shares` (3,) belong to the LAWS; those with
    indices in `free` were fitted. `draws` (d, sounds + 3) are bootstrap draws of ends
    and shares. `residual` (k,) is log(measured / fitted rate) for all blocks of
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

    def values(self) -> dict[str, Value]:
        """Return the fitted shares of the LAWS by name."""
        names = (*LAWS[:2], self.heard[0].line.third_share_name)
        return {names[i]: self.value(len(self.ends) + i) for i in self.free}

    def value(self, i: int) -> Value:
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
    filtered: bool = False


def measured_rates(
    decay: DecayModel, sound: ToneSignal, end, shares, length, **how
) -> Rates:
    """Return the rates of a sound, demodulated with a decay that has an end [s] and
    shares (3,).

    Further arguments are those of `rates`.
    """
    remaining, turned, frequency = decay.course(shares)
    here = remaining > FIT.unused_end_duration
    course = np.array([end - remaining, -turned, frequency])[:, here][:, ::-1]
    return rates(
        sound.samples,
        sound.rate,
        sound.first,
        course,
        length,
        **how,
    )


def fit(
    line: DecayModel,
    sounds: list[ToneSignal],
    ends,
    shares,
    free: tuple[int, ...],
    lengths=FIT.block_lengths,
    min_units=0.05,
) -> Fit:
    """Fit a decay to the rates of a spectral line in sounds.

    `ends` [s] and `shares` (3,) are the initial guess; each fitted share starts at no
    less than `min_units` times its unit. Raises ValueError if fewer than eight blocks of
    the sounds have a clear tone."""
    ends = np.array(ends, float)
    shares = np.array(shares, float)
    filtered = all(sound.filtered for sound in sounds)
    heard: tuple[LineRates, ...] = ()
    for length in lengths:
        longer = line_rates(line, sounds, ends, shares, length)
        if sum(len(h.rates.time) for h in longer) < 8:
            if not heard:
                raise ValueError("the tone is too faint or too short to be tracked")
            break  # the run is too short for longer blocks
        heard = longer
        tolerance = (
            FIT.final_tolerance if length == lengths[-1] else FIT.rough_tolerance
        )
        ends, shares, solved = _solved(
            heard, filtered, ends, shares, free, min_units, tolerance
        )
    return _with_intervals(heard, ends, shares, free, solved)


def line_rates(
    line: DecayModel, sounds: list[ToneSignal], ends, shares, length, **how
) -> tuple[LineRates, ...]:
    """Return the rates of a line in every sound for ends [s] and shares (3,).

    Further arguments are those of `rates`.
    """
    found = []
    for i, (sound, end) in enumerate(zip(sounds, ends, strict=True)):
        here = measured_rates(line, sound, end, shares, length, **how)
        found.append(
            LineRates(
                i,
                line,
                here,
                line.frequency(end - here.time, shares) * (1 + here.missed),
            )
        )
    return tuple(found)


def fit_to_rates(heard: tuple[LineRates, ...], ends, shares, free):
    """Return ends, shares and robust cost of the decay that best fits the given rates.

    The sounds are not demodulated again.
    """
    ends, shares, (solved, _) = _solved(
        heard, False, np.array(ends, float), np.array(shares, float), free
    )
    return ends, shares, float(solved.cost)


def values_in_words(values: dict[str, Value]) -> str:
    """Format values with their names and 95 % intervals."""
    return ", ".join(
        f"{name} {v.value:.4g} ({v.low:.4g} to {v.high:.4g}, 95 %)"
        for name, v in values.items()
    )


def _robust_deviation(residual) -> float:
    """Return a robust standard deviation about 0."""
    return float(1.48 * np.median(np.abs(residual)))


def _relative_error(h):
    return np.hypot(h.error / h.frequency, FIT.min_rate_error)


def _unpack(x, sounds, shares, free, unit):
    full = shares.copy()
    count = sounds + len(free)
    full[list(free)] = x[sounds:count] * unit
    return x[:sounds], full, x[count] * FIT.high_pass_corner if len(x) > count else 0.0


def _residual(x, heard, sounds, shares, free, unit):
    """Return log(measured / model) of every block, divided by its error.

    If a high-pass filter is included, the last entry is the relative deviation of its
    corner frequency from `high_pass_corner`."""
    ends, full, corner = _unpack(x, sounds, shares, free, unit)
    out = []
    for i, line, h, steady in heard:
        remaining = np.maximum(ends[i] - h.time, FIT.unused_end_duration / 10)
        model = _through_high_pass(
            partial(line.frequency, shares=full), remaining, corner
        )
        out.append(np.log(steady / model) / _relative_error(h))
    return np.concatenate([*out, x[sounds + len(free) :] - 1.0])


def _through_high_pass(frequency, remaining, corner):
    """Return the apparent rate (k,) [Hz] after a second-order Butterworth high-pass
    filter.

    The phase shift of the filter decreases as the tone rises; `remaining` (k,) are remaining
    times [s]."""
    here = frequency(remaining)
    if not corner:
        return here
    lead = [
        np.arctan2(2**0.5 * corner * f, f**2 - corner**2)
        for f in (
            frequency(remaining * (1 - FIT.phase_derivative_step)),
            frequency(remaining * (1 + FIT.phase_derivative_step)),
        )
    ]
    return here + (lead[0] - lead[1]) / (2 * FIT.phase_derivative_step * remaining) / (
        2 * np.pi
    )


def _solved(
    heard, filtered, ends, shares, free, min_units=0.05, tolerance=FIT.rough_tolerance
):
    unit = np.maximum(shares[list(free)], [FIT.share_units[i] for i in free])
    x = np.concatenate(
        [ends, np.maximum(shares[list(free)] / unit, min_units), [1.0] * filtered]
    )
    others = np.zeros(len(x) - len(ends))
    last = np.full(len(ends), -np.inf)
    for i, _, h, _ in heard:
        last[i] = max(last[i], h.time.max(initial=-np.inf))
    lower = np.append(last + FIT.unused_end_duration / 5, others)
    upper = np.full(len(x), np.inf)
    upper[len(ends) + len(free) :] = FIT.max_corner_factor
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


def _with_intervals(heard, ends, shares, free, solution):
    """Return the fit with bootstrap draws from runs of residuals and a linearised
    solution."""
    solved, unit = solution
    arguments = (heard, len(ends), shares, free, unit)
    residual = _residual(solved.x, *arguments)
    scale = max(_robust_deviation(residual), 1.0)
    weight = 1 / (1 + (residual / (2 * scale)) ** 2)
    sigma = np.concatenate([_relative_error(h.rates) for h in heard])
    random = np.random.default_rng(0)
    count = len(sigma)
    run = max(FIT.min_bootstrap_run_blocks, count // FIT.max_bootstrap_run_count)
    independent_count = count / FIT.block_overlap
    leverage = np.sqrt(independent_count / max(independent_count - len(solved.x), 1))
    runs = -(-count // run)
    drawn = (
        random.integers(0, count, (FIT.bootstrap_draws, runs, 1)) + np.arange(run)
    ) % count
    noise = (
        leverage
        * residual[drawn]
        * random.choice([-1.0, 1.0], (FIT.bootstrap_draws, runs, 1))
    )
    corner = random.standard_normal((FIT.bootstrap_draws, len(residual) - count))
    noise = np.hstack([noise.reshape(FIT.bootstrap_draws, -1)[:, :count], corner])
    jacobian = _jacobian(lambda x: _residual(x, *arguments), solved.x)
    inverse = np.linalg.pinv(jacobian.T @ (weight[:, None] * jacobian)) @ (
        jacobian.T * weight
    )
    moved = solved.x - noise @ inverse.T
    draws = np.tile(np.append(ends, shares), (FIT.bootstrap_draws, 1))
    draws[:, : len(ends)] = moved[:, : len(ends)]
    draws[:, len(ends) + np.array(free, int)] = (
        moved[:, len(ends) : len(ends) + len(free)] * unit
    )
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
    """Return derivatives (k, n) from second-order one-sided differences, which keep
    shares positive."""
    steps = 1e-4 * np.maximum(np.abs(x), 0.05)
    here = function(x)
    columns = [
        (4 * function(x + h * e) - function(x + 2 * h * e) - 3 * here) / (2 * h)
        for h, e in zip(np.minimum(steps, 1e-3), np.eye(len(x)), strict=True)
    ]
    return np.stack(columns, axis=1)


def pool_fits(fits: list[Fit]) -> Fit:
    """Return the mean of fits to single sounds, weighted by the inverse variances of
    their shares.

    The errors are enlarged if the shares scatter more than their errors predict.
    """
    values = np.array([one.shares for one in fits])
    draws = np.array([one.draws[: FIT.bootstrap_draws, 1:] for one in fits])
    spread = np.maximum(draws.std(axis=1), TINY)
    weight = spread**-2 / np.sum(spread**-2, axis=0)
    mean = np.sum(weight * values, axis=0)
    scatter_ratio = np.sqrt(
        np.sum(((values - mean) / spread) ** 2, axis=0) / (len(fits) - 1)
    )
    random = np.random.default_rng(0)
    deviations = np.sum(
        [
            w * random.permutation(d - v)
            for w, d, v in zip(weight, draws, values, strict=True)
        ],
        axis=0,
    )
    ends = np.array([one.draws[: len(deviations), 0] for one in fits]).T
    return Fit(
        free=fits[0].free,
        ends=np.concatenate([one.ends for one in fits]),
        shares=mean,
        draws=np.hstack([ends, mean + deviations * np.maximum(scatter_ratio, 1.0)]),
        heard=tuple(
            h._replace(sound=i) for i, one in enumerate(fits) for h in one.heard
        ),
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
    count = len(fits[0].ends)
    return replace(fits[0], ends=mean[:count], shares=mean[count:], draws=draws)
