"""RATES -> SHARES: the end of the motion and the shares of what slows it, with intervals, by robust
least squares."""

from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import norm, t

from sonify.fitting.decay_model import LAWS, Decline
from sonify.fitting.phase_demodulation import OVERLAP, Rates, rates

LENGTHS = (8.0, 10.0, 12.0, 16.0, 16.0)
"""Turns in a block, from one round to the next: short ones follow a guess that is far off, long
ones hear little noise."""
ROUGH, CLOSE = 1e-4, 1e-8
"""Relative tolerances of the solution: before the sound is listened to again, and at last."""
FLOOR = 2e-4
"""The relative error of a rate that no block is without: the decline is not quite steady."""
DRAWS, RUN, RUNS = 400, 4, 8
"""Residuals are drawn anew so often, in runs of so many blocks at least, and at most so many runs:
neighbours share half of what they hear, and what is not steady lasts."""
TINY = 1e-30
LAST = 0.01
"""So shortly before the end [s] nothing is heard any more."""


@dataclass(frozen=True, kw_only=True)
class Value:
    """A value with its 95 % interval, `low` to `high`, and its 68 % interval, `inner`."""

    value: float
    low: float
    high: float
    inner: tuple[float, float]


class Followed(NamedTuple):
    """The rates at which a line of the decline is heard in one of several sounds, which count from
    0, and those (k,) [Hz] that it would have in steady motion."""

    sound: int
    line: Decline
    rates: Rates
    steady: np.ndarray


@dataclass(frozen=True, kw_only=True, eq=False)
class Fit:
    """A decline fitted to one sound or several: `ends` [s], one a sound, and `shares` of the LAWS,
    of which the `free` ones were sought. `draws` (d, sounds + 3) are as likely as they; `residual`
    (k,) is log(heard / fitted) of all that was `heard`, and `sigma` (k,) its error by noise."""

    free: tuple[int, ...]
    ends: np.ndarray
    shares: np.ndarray
    draws: np.ndarray
    heard: tuple[Followed, ...]
    residual: np.ndarray
    sigma: np.ndarray

    @property
    def spread(self) -> float:
        """The robust standard deviation of the residual: how far heard and fitted rates are apart,
        relative."""
        return _deviation(self.residual)

    def values(self) -> dict[str, Value]:
        """Return the shares of the LAWS that were sought, by name."""
        return {LAWS[i]: self.value(len(self.ends) + i) for i in self.free}

    def value(self, i: int) -> Value:
        """Return the end of sound i, or from the number of sounds on the shares."""
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
class Heard:
    """A sound to be fitted: samples (n,) at `rate` [Hz] from the time `first` [s] on, `filtered` or
    not by the high-pass of a recorder, whose phase looks like a rate of its own."""

    samples: np.ndarray
    rate: float
    first: float
    filtered: bool = False

    @cached_property
    def integral(self) -> np.ndarray:
        """The sum (n + 1,) of the samples before each."""
        return np.append(0.0, np.cumsum(self.samples))


def tracked(decline: Decline, sound: Heard, end, shares, length, **how) -> Rates:
    """Return the rates of a sound beside the decline of an end [s] and shares (3,); `how` as for
    `rates`."""
    left, turned, frequency = decline.course(shares)
    here = left > LAST
    course = np.array([end - left, -turned, frequency])[:, here][:, ::-1]
    return rates(
        sound.samples, sound.rate, sound.first, course, length, integral=sound.integral, **how
    )


def fit(
    line: Decline,
    sounds: list[Heard],
    ends,
    shares,
    free: tuple[int, ...],
    lengths=LENGTHS,
    least=0.05,
) -> Fit:
    """Return the fit of a line of a decline to sounds, sought from guesses of the ends [s] and the
    shares (3,), which begin with `least` of their UNITS.

    Raises ValueError if less than eight blocks of the sounds are clear.
    """
    ends = np.array(ends, float)
    shares = np.array(shares, float)
    filtered = all(sound.filtered for sound in sounds)
    heard: tuple[Followed, ...] = ()
    for length in lengths:
        longer = followed(line, sounds, ends, shares, length)
        if sum(len(h.rates.time) for h in longer) < 8:
            if not heard:
                raise ValueError("the tone is too faint or too short to be followed")
            break  # a short run has no more long blocks
        heard = longer
        tolerance = CLOSE if length == lengths[-1] else ROUGH
        ends, shares, solved = _solved(heard, filtered, ends, shares, free, least, tolerance)
    return _with_intervals(heard, ends, shares, free, solved)


def followed(
    line: Decline, sounds: list[Heard], ends, shares, length, **how
) -> tuple[Followed, ...]:
    """Return the rates of a line in every sound, beside the decline of ends [s] and shares (3,);
    `how` as for `rates`."""
    found = []
    for i, (sound, end) in enumerate(zip(sounds, ends, strict=True)):
        here = tracked(line, sound, end, shares, length, **how)
        found.append(
            Followed(i, line, here, line.frequency(end - here.time, shares) * (1 + here.missed))
        )
    return tuple(found)


def solved_near(heard: tuple[Followed, ...], ends, shares, free):
    """Return ends, shares and robust cost of the decline that is nearest to given rates, without
    listening again."""
    ends, shares, (solved, _) = _solved(
        heard, False, np.array(ends, float), np.array(shares, float), free
    )
    return ends, shares, float(solved.cost)


def in_words(values: dict[str, Value]) -> str:
    """Return values by name with their 95 % intervals."""
    return ", ".join(
        f"{name} {v.value:.4g} ({v.low:.4g} to {v.high:.4g}, 95 %)" for name, v in values.items()
    )


def _deviation(residual) -> float:
    """A standard deviation about 0 that few outliers do not change."""
    return float(1.48 * np.median(np.abs(residual)))


def _relative_error(h):
    return np.hypot(h.error / h.frequency, FLOOR)


def _unpack(x, sounds, shares, free, unit):
    full = shares.copy()
    count = sounds + len(free)
    full[list(free)] = x[sounds:count] * unit
    return x[:sounds], full, x[count] * CORNER if len(x) > count else 0.0


def _residual(x, heard, sounds, shares, free, unit):
    """log(heard / model) of every block over its error; behind a high-pass also how far its corner
    is from what is usual."""
    ends, full, corner = _unpack(x, sounds, shares, free, unit)
    out = []
    for i, line, h, steady in heard:
        left = np.maximum(ends[i] - h.time, LAST / 10)
        model = _through_high_pass(partial(line.frequency, shares=full), left, corner)
        out.append(np.log(steady / model) / _relative_error(h))
    return np.concatenate([*out, x[sounds + len(free) :] - 1.0])


def _through_high_pass(frequency, left, corner):
    """The rate [Hz] at times left (k,) [s] behind a high-pass of second order (Butterworth) with a
    corner [Hz]: its phase falls as the tone rises, and what falls is a rate."""
    here = frequency(left)
    if not corner:
        return here
    lead = [
        np.arctan2(2**0.5 * corner * f, f**2 - corner**2)
        for f in (frequency(left * (1 - STEP)), frequency(left * (1 + STEP)))
    ]
    return here + (lead[0] - lead[1]) / (2 * STEP * left) / (2 * np.pi)


def _solved(heard, filtered, ends, shares, free, least=0.05, tolerance=ROUGH):
    unit = np.maximum(shares[list(free)], [UNITS[i] for i in free])
    x = np.concatenate([ends, np.maximum(shares[list(free)] / unit, least), [1.0] * filtered])
    others = np.zeros(len(x) - len(ends))
    last = np.full(len(ends), -np.inf)
    for i, _, h, _ in heard:
        last[i] = max(last[i], h.time.max(initial=-np.inf))
    lower = np.append(last + LAST / 5, others)
    upper = np.full(len(x), np.inf)
    upper[len(ends) + len(free) :] = HIGHEST_CORNER
    x = np.maximum(x, lower + 1e-9)
    arguments = (heard, len(ends), shares, free, unit)
    scale = max(_deviation(_residual(x, *arguments)), 1.0)
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


CORNER, HIGHEST_CORNER, STEP = 50.0, 4.0, 1e-3
"""The corner of a recorder's high-pass is so many hertz, give or take as many, and so many times as
much at most: where the sound does not tell it, it is no more uncertain; relative step in the time
left."""
UNITS = (1e-5, 0.05, 0.05)
"""Shares of the LAWS below which they are looked for from the ground up."""


def _with_intervals(heard, ends, shares, free, solution):
    """Draw residuals anew, in runs of blocks, and solve the linearised problem for each drawing."""
    solved, unit = solution
    arguments = (heard, len(ends), shares, free, unit)
    residual = _residual(solved.x, *arguments)
    scale = max(_deviation(residual), 1.0)
    weight = 1 / (1 + (residual / (2 * scale)) ** 2)
    sigma = np.concatenate([_relative_error(h.rates) for h in heard])
    random = np.random.default_rng(0)
    count = len(sigma)
    run = max(RUN, count // RUNS)
    apart = count / OVERLAP
    leverage = np.sqrt(apart / max(apart - len(solved.x), 1))
    runs = -(-count // run)
    drawn = (random.integers(0, count, (DRAWS, runs, 1)) + np.arange(run)) % count
    noise = leverage * residual[drawn] * random.choice([-1.0, 1.0], (DRAWS, runs, 1))
    corner = random.standard_normal((DRAWS, len(residual) - count))
    noise = np.hstack([noise.reshape(DRAWS, -1)[:, :count], corner])
    jacobian = _jacobian(lambda x: _residual(x, *arguments), solved.x)
    inverse = np.linalg.pinv(jacobian.T @ (weight[:, None] * jacobian)) @ (jacobian.T * weight)
    moved = solved.x - noise @ inverse.T
    draws = np.tile(np.append(ends, shares), (DRAWS, 1))
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
    """Derivatives (k, n), of second order in the step, from above: a share is not negative."""
    steps = 1e-4 * np.maximum(np.abs(x), 0.05)
    here = function(x)
    columns = [
        (4 * function(x + h * e) - function(x + 2 * h * e) - 3 * here) / (2 * h)
        for h, e in zip(np.minimum(steps, 1e-3), np.eye(len(x)), strict=True)
    ]
    return np.stack(columns, axis=1)


def pooled(fits: list[Fit]) -> Fit:
    """Return what fits to one sound each say together: the mean of their shares, weighted by their
    variances; where these are farther apart than they tell, all errors are as much larger."""
    values = np.array([one.shares for one in fits])
    draws = np.array([one.draws[:DRAWS, 1:] for one in fits])
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


def mixed(fits: list[Fit]) -> Fit:
    """Return the first of m fits to the same sounds along motions that differ, with the mean of
    their values and all that is as likely as any of them.

    How far these are from their mean counts with Student's factor over that of a normal error
    (Rubin 1987, 3.1.6)."""
    values = np.array([np.append(one.ends, one.shares) for one in fits])
    m = len(fits)
    mean = values.mean(axis=0)
    wider = np.sqrt(1 + 1 / m) * t.ppf(0.975, max(m - 1, 2)) / norm.ppf(0.975)
    draws = np.concatenate(
        [one.draws + (wider - 1) * (own - mean) for one, own in zip(fits, values, strict=True)]
    )
    count = len(fits[0].ends)
    return replace(fits[0], ends=mean[:count], shares=mean[count:], draws=draws)
