"""WINDOW, SHAPES -> LAW: a random search for the law of a family that fits a window best."""

import math

import numpy as np
from numba import njit

from sonify.hearing.settling.rate_laws import Law, Shape

TURNS_PER_HARMONIC = 4  # few turns with many harmonics would fit any pattern
FAMILY_CODES = {
    "disk": 0,
    "linear": 1,
    "exponential": 2,
    "slowing disk": 3,
    "slowing linear": 4,
    "slowing exponential": 5,
}


@njit(cache=True, nogil=True)
def _place(code, ratio, exponent, y):
    """The place of the window, 0 to 1, at a phase."""
    if code >= 3:
        return 1 - _place(code - 3, ratio, exponent, 1 - y)
    if code == 0:
        left = 1 / (ratio ** (1 / exponent) - 1)
        if abs(exponent - 1) < 1e-6:
            return (left + 1) * (1 - (left / (left + 1)) ** y)
        power = 1 - exponent
        begin = (left + 1) ** power
        return left + 1 - (begin - y * (begin - left**power)) ** (1 / power)
    if abs(ratio - 1) < 1e-9:
        return y
    if code == 1:
        curvature = (ratio - 1) / 2
        return (math.sqrt(1 + 2 * curvature * y * (1 + ratio)) - 1) / (2 * curvature)
    return math.log1p(y * (ratio - 1)) / math.log(ratio)


@njit(cache=True, nogil=True)
def _likelihood(cumulative, energy, independent, code, ratio, exponent, turns, harmonics):
    """Log likelihood and best number of harmonics of one law, from the running sum of a window."""
    length = len(cumulative) - 1
    harmonics = min(harmonics, max(int(turns / TURNS_PER_HARMONIC), 1))
    steps = max(int(12 * turns), 128)
    sums = np.zeros((harmonics, 2))
    turn = 2 * np.pi * turns / steps
    step_cos = np.cos(turn)
    step_sin = np.sin(turn)
    cosine = np.cos(turn / 2)
    sine = np.sin(turn / 2)
    before = 0.0
    for j in range(1, steps + 1):
        place = length * _place(code, ratio, exponent, j / steps)
        i = min(max(int(place), 0), length - 1)
        now = cumulative[i] + (place - i) * (cumulative[i + 1] - cumulative[i])
        part = now - before
        before = now
        real = cosine
        imaginary = sine
        for h in range(harmonics):
            sums[h, 0] += part * real
            sums[h, 1] += part * imaginary
            real, imaginary = real * cosine - imaginary * sine, real * sine + imaginary * cosine
        cosine, sine = cosine * step_cos - sine * step_sin, cosine * step_sin + sine * step_cos
    best = -np.inf
    order = 1
    power = 0.0
    for h in range(harmonics):
        power += sums[h, 0] ** 2 + sums[h, 1] ** 2
        value = -independent / 2 * math.log(1 - min(2 * power / energy, 0.999)) - (h + 1)
        if value > best:
            best = value
            order = h + 1
    return best, order


@njit(cache=True, nogil=True)
def _first_rate(code, ratio, exponent):
    """Rate at the beginning of the window over its mean."""
    small = 1e-5
    return small / _place(code, ratio, exponent, small)


@njit(cache=True, nogil=True)
def _climb(
    cumulative,
    energy,
    independent,
    start,
    bounds,
    draws,
    widths,
    least_turns,
    least_rate,
    harmonics,
):
    """Follow random steps uphill from a start (code, log ratio, exponent, turns)."""
    code = int(start[0])
    seconds = (len(cumulative) - 1) / 1000
    here = start[1:].copy()
    best, order = _likelihood(
        cumulative, energy, independent, code, math.exp(here[0]), here[1], here[2], harmonics
    )
    tried = np.empty(3)
    for k in range(len(draws)):
        for i in range(3):
            tried[i] = here[i] + draws[k, i] * widths[i]
        for i in range(2):
            tried[i] = min(max(tried[i], bounds[i, 0]), bounds[i, 1])
        ratio = math.exp(tried[0])
        if tried[2] < least_turns:
            continue
        if tried[2] / seconds * _first_rate(code, ratio, tried[1]) < least_rate:
            continue
        value, harmonic = _likelihood(
            cumulative, energy, independent, code, ratio, tried[1], tried[2], harmonics
        )
        if value > best:
            best = value
            order = harmonic
            here[:] = tried
    return here, best, order


def draws_of_search(count: int) -> np.ndarray:
    """Return the steps (count, 3) of the random search, ever smaller ones."""
    shrinking = np.geomspace(1, 0.03, count)
    return np.random.default_rng(7).normal(size=(count, 3)) * shrinking[:, None]


DRAWS = draws_of_search(90)
DRAWS_OF_WALK = draws_of_search(160)


def ratio_range(shape: Shape, settings) -> tuple[float, float]:
    """Return the ratios of last to first rate that the search may reach from a shape."""
    if shape.family.endswith("disk"):
        return settings.rate_ratios
    if shape.family == "linear" and shape.ratio < settings.steady_ratio - 1e-9:
        return 1 / settings.steady_ratio, settings.steady_ratio
    return settings.steady_ratio, settings.rate_ratios[1]


def refine(values: np.ndarray, scale_ms: float, starts: list[Law], settings) -> Law:
    """Return the most likely law of a family in a window (frames,), from the best shapes of the
    grid."""
    values = values - values.mean()
    cumulative = np.concatenate([[0.0], np.cumsum(values, dtype=float)])
    energy = max(float(np.sum(np.square(values, dtype=float))), 1e-9) * len(values)
    best = None
    for law in starts:
        shape = law.shape
        ratios = ratio_range(shape, settings)
        start = np.array(
            [FAMILY_CODES[shape.family], math.log(shape.ratio), shape.exponent or 0.5, law.turns]
        )
        bounds = np.array([np.log(ratios), settings.exponents])
        widths = np.array([0.25, 0.12, 0.4])
        here, likelihood, order = _climb(
            cumulative,
            energy,
            len(values) / scale_ms,
            start,
            bounds,
            DRAWS,
            widths,
            settings.least_turns,
            settings.least_rate,
            settings.most_harmonics,
        )
        if best is None or likelihood > best.likelihood:
            exponent = float(here[1]) if shape.exponent else 0.0
            best = Law(
                Shape(shape.family, math.exp(here[0]), exponent),
                float(here[2]),
                int(order),
                float(likelihood),
            )
    return best


@njit(cache=True, nogil=True)
def _walk(cumulative, energy, independent, start, left_range, exponent_range, draws, harmonics):
    """Try laws of a disk near a start (frames left, exponent, turns); return them all, first rates,
    likelihoods.

    Steps run along and across the ridge on which exponent over time left to the end is constant.
    """
    length = len(cumulative) - 1
    count = len(draws)
    tried = np.empty((count, 3))
    first_rates = np.empty(count)
    values = np.full(count, -np.inf)
    here = start.copy()
    best = -np.inf
    for k in range(count):
        along = 40.0 * draws[k, 0]
        left = min(max(here[0] + along, left_range[0]), left_range[1])
        exponent = here[1] * (1 + (left - here[0]) / (length / 2 + here[0])) + 0.04 * draws[k, 1]
        exponent = min(max(exponent, exponent_range[0]), exponent_range[1])
        turns = max(here[2] + 0.3 * draws[k, 2], 1.0)
        if k == 0:
            left, exponent, turns = here
        ratio = ((length + left) / left) ** exponent
        tried[k, 0] = left
        tried[k, 1] = exponent
        tried[k, 2] = turns
        values[k], _ = _likelihood(
            cumulative, energy, independent, 0, ratio, exponent, turns, harmonics
        )
        first_rates[k] = turns / length * _first_rate(0, ratio, exponent)
        if values[k] > best:
            best = values[k]
            here[0] = left
            here[1] = exponent
            here[2] = turns
    return tried, first_rates, values


def laws_near(values: np.ndarray, scale_ms: float, start, left_range, settings):
    """Return laws of a disk near a start (frames left after the window, exponent, turns) and their
    likelihoods.

    The laws are frames left, exponents, first rates [per frame] and log likelihoods, (laws,) each.
    """
    values = values - values.mean()
    cumulative = np.concatenate([[0.0], np.cumsum(values, dtype=float)])
    energy = max(float(np.sum(np.square(values, dtype=float))), 1e-9) * len(values)
    tried, first_rates, likelihood = _walk(
        cumulative,
        energy,
        len(values) / scale_ms,
        np.array(start, dtype=float),
        np.array(left_range, dtype=float),
        np.array(settings.exponents),
        DRAWS_OF_WALK,
        settings.most_harmonics,
    )
    return tried[:, 0], tried[:, 1], first_rates, likelihood
