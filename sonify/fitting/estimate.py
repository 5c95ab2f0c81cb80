"""RATES -> SHARES: the end of the motion and the shares of what slows it, with intervals, by robust least squares."""

from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.optimize import least_squares

from sonify.fitting.decline import LAWS, Decline
from sonify.fitting.phase import Rates, rates

LENGTHS = (8.0, 10.0, 12.0, 16.0, 16.0)
"""Turns in a block, from one round to the next: short ones follow a guess that is far off, long ones hear little
noise."""
FLOOR = 2e-4
"""The relative error of a rate that no block is without: the decline is not quite steady."""
DRAWS, RUN, RUNS = 400, 4, 8
"""Residuals are drawn anew so often, in runs of so many blocks at least, and at most so many runs: neighbours share
half of what they hear, and what is not steady lasts."""
LAST = 0.01
"""So shortly before the end [s] nothing is heard any more."""


@dataclass(frozen=True, kw_only=True)
class Value:
    """A value with its 95 % interval, `low` to `high`, and its 68 % interval, `inner`."""

    value: float
    low: float
    high: float
    inner: tuple[float, float]


@dataclass(frozen=True, kw_only=True, eq=False)
class Fit:
    """A decline fitted to one sound or several: `ends` [s], one a sound, and `shares` of the LAWS, of which the
    `free` ones were sought. `draws` (d, sounds + 3) are as likely as they; `residual` (k,) is log(heard / fitted) and
    `sigma` (k,) its error by noise."""

    free: tuple[int, ...]
    ends: np.ndarray
    shares: np.ndarray
    draws: np.ndarray
    heard: tuple[Rates, ...]
    residual: np.ndarray
    sigma: np.ndarray

    @property
    def spread(self) -> float:
        """The robust standard deviation of the residual: how far heard and fitted rates are apart, relative."""
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
        return Value(value=float(best), low=float(max(min(low, best), least)), high=float(max(high, best)), inner=inner)


@dataclass(frozen=True, kw_only=True)
class Heard:
    """A sound to be fitted: samples (n,) at `rate` [Hz] from the time `first` [s] on, `filtered` or not by the
    high-pass of a recorder, whose phase looks like a rate of its own."""

    samples: np.ndarray
    rate: float
    first: float
    filtered: bool = False


def tracked(decline: Decline, sound: Heard, end, shares, length) -> Rates:
    """Return the rates of a sound beside the decline of an end [s] and shares (3,)."""

    def turns(t):
        left = end - t
        inside = left > LAST
        turned, frequency = np.full((2, len(t)), np.nan)
        turned[inside], frequency[inside] = decline.turns(left[inside], shares)
        return -turned, frequency

    return rates(sound.samples, sound.rate, sound.first, turns, length)


def fit(decline: Decline, sounds: list[Heard], ends, shares, free: tuple[int, ...], lengths=LENGTHS) -> Fit:
    """Return the fit of a decline to sounds, sought from guesses of the ends [s] and the shares (3,).

    Raises ValueError if less than eight blocks of the sounds are clear.
    """
    ends, shares = np.array(ends, float), np.array(shares, float)
    for length in lengths:
        heard = tuple(tracked(decline, s, e, shares, length) for s, e in zip(sounds, ends, strict=True))
        if sum(len(h.time) for h in heard) < 8:
            raise ValueError("the tone is too faint or too short to be followed")
        ends, shares, solved = _solved(decline, sounds, heard, ends, shares, free)
    return _with_intervals(decline, sounds, heard, ends, shares, free, solved)


def solved_near(decline: Decline, sounds: list[Heard], heard, ends, shares, free):
    """Return ends, shares and robust cost of the decline that is nearest to given rates, without listening again."""
    ends, shares, (solved, _) = _solved(decline, sounds, heard, np.array(ends), np.array(shares, float), free)
    return ends, shares, float(solved.cost)


def in_words(values: dict[str, Value]) -> str:
    """Return values by name with their 95 % intervals."""
    return ", ".join(f"{name} {v.value:.4g} ({v.low:.4g} to {v.high:.4g}, 95 %)" for name, v in values.items())


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


def _residual(x, decline, sounds, heard, shares, free, unit):
    """log(heard / model) of every block over its error."""
    ends, full, corner = _unpack(x, len(heard), shares, free, unit)
    out = []
    for h, end in zip(heard, ends, strict=True):
        model = _through_high_pass(partial(decline.frequency, shares=full), np.maximum(end - h.time, LAST / 10), corner)
        out.append(np.log(h.frequency / model) / _relative_error(h))
    return np.concatenate(out)


def _through_high_pass(frequency, left, corner):
    """The rate [Hz] at times left (k,) [s] behind a high-pass of second order (Butterworth) with a corner [Hz]: its
    phase falls as the tone rises, and what falls is a rate."""
    here = frequency(left)
    if not corner:
        return here
    lead = [
        np.arctan2(2**0.5 * corner * f, f**2 - corner**2)
        for f in (frequency(left * (1 - STEP)), frequency(left * (1 + STEP)))
    ]
    return here + (lead[0] - lead[1]) / (2 * STEP * left) / (2 * np.pi)


def _solved(decline, sounds, heard, ends, shares, free):
    unit = np.maximum(shares[list(free)], [UNITS[i] for i in free])
    corner = [0.1] * all(sound.filtered for sound in sounds)
    x = np.concatenate([ends, np.maximum(shares[list(free)] / unit, 0.05), corner])
    others = np.zeros(len(x) - len(heard))
    lower = np.append([h.time.max(initial=-np.inf) + LAST / 5 for h in heard], others)
    upper = np.full(len(x), np.inf)
    upper[len(heard) + len(free) :] = HIGHEST_CORNER
    x = np.maximum(x, lower + 1e-9)
    arguments = (decline, sounds, heard, shares, free, unit)
    first = _residual(x, *arguments)
    scale = max(_deviation(first), 1.0)
    solved = least_squares(
        _residual,
        x,
        bounds=(lower, upper),
        args=arguments,
        loss="cauchy",
        f_scale=2 * scale,
        x_scale=np.append(np.full(len(heard), 0.05), np.ones(len(others))),
    )
    ends, full, _ = _unpack(solved.x, len(heard), shares, free, unit)
    return ends, full, (solved, unit)


CORNER, HIGHEST_CORNER, STEP = 50.0, 4.0, 1e-3
"""A corner is sought in this unit [Hz], up to so many of them; relative step in the time left."""
UNITS = (1e-5, 0.05, 0.05)
"""Shares of the LAWS below which they are looked for from the ground up."""


def _with_intervals(decline, sounds, heard, ends, shares, free, solution):
    """Draw residuals anew, in runs of blocks, and solve the linearised problem for each drawing."""
    solved, unit = solution
    arguments = (decline, sounds, heard, shares, free, unit)
    residual = _residual(solved.x, *arguments)
    scale = max(_deviation(residual), 1.0)
    weight = 1 / (1 + (residual / (2 * scale)) ** 2)
    jacobian = _jacobian(lambda x: _residual(x, *arguments), solved.x)
    inverse = np.linalg.pinv(jacobian.T @ (weight[:, None] * jacobian)) @ (jacobian.T * weight)
    random, count = np.random.default_rng(0), len(residual)
    run = max(RUN, count // RUNS)
    leverage = np.sqrt(count / max(count - len(solved.x), 1))
    runs = -(-count // run)
    drawn = (random.integers(0, count, (DRAWS, runs, 1)) + np.arange(run)) % count
    noise = leverage * residual[drawn] * random.choice([-1.0, 1.0], (DRAWS, runs, 1))
    noise = noise.reshape(DRAWS, -1)[:, :count]
    moved = solved.x - noise @ inverse.T
    draws = np.tile(np.append(ends, shares), (DRAWS, 1))
    draws[:, : len(ends)] = moved[:, : len(ends)]
    draws[:, len(ends) + np.array(free, int)] = moved[:, len(ends) : len(ends) + len(free)] * unit
    sigma = np.concatenate([_relative_error(h) for h in heard])
    return Fit(
        free=free,
        ends=ends,
        shares=shares,
        draws=draws,
        heard=heard,
        residual=residual * sigma,
        sigma=sigma,
    )


def _jacobian(function, x):
    """Derivatives (k, n), of second order in the step, from above: a share is not negative."""
    steps, here = 1e-4 * np.maximum(np.abs(x), 0.05), function(x)
    columns = [
        (4 * function(x + h * e) - function(x + 2 * h * e) - 3 * here) / (2 * h)
        for h, e in zip(np.minimum(steps, 1e-3), np.eye(len(x)), strict=True)
    ]
    return np.stack(columns, axis=1)


def pooled(decline: Decline, fits: list[Fit], filtered: bool) -> Fit:
    """Return the fit of one decline to the rates that were heard in several sounds, without listening again;
    `filtered` as in `Heard`."""
    heard = tuple(rates for one in fits for rates in one.heard)
    silent = [Heard(samples=np.zeros(0), rate=1.0, first=0.0, filtered=filtered)] * len(heard)
    ends, free = np.concatenate([one.ends for one in fits]), fits[0].free
    ends, shares, solution = _solved(decline, silent, heard, ends, np.mean([one.shares for one in fits], axis=0), free)
    return _with_intervals(decline, silent, heard, ends, shares, free, solution)
