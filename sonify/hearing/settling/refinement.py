"""Random search for the law of a family that best fits a window."""

import math

import numpy as np

from dynamics.numba_kernels import njit
from sonify.hearing.settling.rate_laws import FAMILY_CODES, Law, Shape, places
from sonify.hearing.settling.settings import SETTLING
from sonify.hearing.settling.warped_periodogram import effective_components


def _centred_window(
    values: np.ndarray, scale_ms: float
) -> tuple[np.ndarray, np.ndarray, float, float]:
    """Return the cumulative sums (frames + 1, components) of a window (components,
    frames) without its means, its length times its energies (components,), and its
    numbers of independent samples and components."""
    count, length = values.shape
    effective = effective_components(values)
    values = values - values.mean(axis=1, keepdims=True)
    cumulative = np.zeros((length + 1, count))
    np.cumsum(values.T, axis=0, dtype=float, out=cumulative[1:])
    energy = np.sum(np.square(values, dtype=float), axis=1)
    return cumulative, np.maximum(energy, 1e-9) * length, length / scale_ms, effective


@njit(cache=True, nogil=True)
def _add_harmonics(
    sums: np.ndarray, part: np.ndarray, cosine: float, sine: float
) -> None:
    """Add the increments (components,) of one step of the phase to the Fourier sums, in
    place."""
    real = cosine
    imaginary = sine
    for h in range(len(sums)):
        for c in range(len(part)):
            sums[h, 0, c] += part[c] * real
            sums[h, 1, c] += part[c] * imaginary
        real, imaginary = (
            real * cosine - imaginary * sine,
            real * sine + imaginary * cosine,
        )


@njit(cache=True, nogil=True)
def _harmonic_sums(
    cumulative: np.ndarray,
    code: int,
    ratio: float,
    exponent: float,
    turns: float,
    harmonics: int,
) -> np.ndarray:
    """Return the Fourier sums (harmonics, 2, components) of a centred window at the phase
    of a law."""
    length = len(cumulative) - 1
    count = cumulative.shape[1]
    steps = max(int(12 * turns), 128)
    sums = np.zeros((harmonics, 2, count))
    turn = 2 * np.pi * turns / steps
    step_cos = np.cos(turn)
    step_sin = np.sin(turn)
    cosine = np.cos(turn / 2)
    sine = np.sin(turn / 2)
    phases = np.arange(1, steps + 1) / steps
    before = np.zeros(count)
    part = np.empty(count)
    for place in places(code, ratio, exponent, phases):
        cut = length * place
        i = min(max(int(cut), 0), length - 1)
        for c in range(count):
            step = cumulative[i + 1, c] - cumulative[i, c]
            now = cumulative[i, c] + (cut - i) * step
            part[c] = now - before[c]
            before[c] = now
        _add_harmonics(sums, part, cosine, sine)
        cosine, sine = (
            cosine * step_cos - sine * step_sin,
            cosine * step_sin + sine * step_cos,
        )
    return sums


@njit(cache=True, nogil=True)
def _likelihood(
    window: tuple[np.ndarray, np.ndarray, float, float],
    code: int,
    ratio: float,
    exponent: float,
    turns: float,
    harmonics: int,
) -> tuple[float, int]:
    """Return the log likelihood and the best number of harmonics of a law in a
    centred window."""
    cumulative, energy, independent, effective = window
    turns_per_harmonic = 4  # few turns with many harmonics would fit any pattern
    count = cumulative.shape[1]
    harmonics = min(harmonics, max(int(turns / turns_per_harmonic), 1))
    sums = _harmonic_sums(cumulative, code, ratio, exponent, turns, harmonics)
    best = -np.inf
    order = 1
    power = np.zeros(count)
    for h in range(harmonics):
        value = -(h + 1.0)
        for c in range(count):
            power[c] += sums[h, 0, c] ** 2 + sums[h, 1, c] ** 2
            unexplained = 1 - min(2 * power[c] / energy[c], 0.999)
            value -= independent / (2 * count) * math.log(unexplained)
        if effective * value > best:
            best = effective * value
            order = h + 1
    return best, order


@njit(cache=True, nogil=True)
def _initial_over_mean_rate(code: int, ratio: float, exponent: float) -> float:
    """Return the ratio of the initial to the mean rate of a law."""
    small_phase = np.empty(1)
    small_phase[0] = 1e-5
    return small_phase[0] / places(code, ratio, exponent, small_phase)[0]


@njit(cache=True, nogil=True)
def _climb_to_best_law(
    window: tuple[np.ndarray, np.ndarray, float, float],
    code: int,
    start: np.ndarray,
    bounds: np.ndarray,
    steps: np.ndarray,
    min_turns: float,
    min_rate: float,
    harmonics: int,
) -> tuple[np.ndarray, float, int]:
    """Return the law (log ratio, exponent, turns) reached by random uphill steps from
    `start`.

    Its log likelihood and number of harmonics are also returned.
    """
    seconds = (len(window[0]) - 1) / 1000
    here = start.copy()
    best, order = _likelihood(
        window, code, math.exp(here[0]), here[1], here[2], harmonics
    )
    tried = np.empty(3)
    for k in range(len(steps)):
        for i in range(3):
            tried[i] = here[i] + steps[k, i]
        for i in range(2):
            tried[i] = min(max(tried[i], bounds[i, 0]), bounds[i, 1])
        ratio = math.exp(tried[0])
        if tried[2] < min_turns:
            continue
        if (
            tried[2] / seconds * _initial_over_mean_rate(code, ratio, tried[1])
            < min_rate
        ):
            continue
        value, harmonic = _likelihood(
            window, code, ratio, tried[1], tried[2], harmonics
        )
        if value > best:
            best = value
            order = harmonic
            for i in range(3):  # compiles in a third of the time of here[:] = tried
                here[i] = tried[i]
    return here, best, order


def shrinking_random_steps(count: int) -> np.ndarray:
    """Return the steps (count, 3) of the random search, with decreasing sizes."""
    shrinking = np.geomspace(1, 0.03, count)
    return np.random.default_rng(7).normal(size=(count, 3)) * shrinking[:, None]


RANDOM_SEARCH_STEPS = shrinking_random_steps(90) * [0.25, 0.12, 0.4]
RANDOM_WALK_STEPS = shrinking_random_steps(160) * [40.0, 0.04, 0.3]


def ratio_range(shape: Shape, min_ratio: float) -> tuple[float, float]:
    """Return the limits of the ratio of the last rate to the first in a search that
    starts from a shape; `min_ratio` is that of a disk."""
    if shape.family.endswith("disk"):
        return min_ratio, SETTLING.rate_ratios[1]
    if shape.family == "linear" and shape.ratio < SETTLING.max_steady_ratio - 1e-9:
        return 1 / SETTLING.max_steady_ratio, SETTLING.max_steady_ratio
    return SETTLING.max_steady_ratio, SETTLING.rate_ratios[1]


def refine(
    values: np.ndarray, scale_ms: float, starts: list[Law], min_ratio: float
) -> Law:
    """Return the most likely law of a family in a window (components, frames), refined
    from laws `starts`; `min_ratio` is the minimum ratio of the rates of a disk."""
    window = _centred_window(values, scale_ms)
    found = []
    for law in starts:
        shape = law.shape
        start = np.array([math.log(shape.ratio), shape.exponent or 0.5, law.turns])
        here, likelihood, order = _climb_to_best_law(
            window,
            FAMILY_CODES[shape.family],
            start,
            np.array([np.log(ratio_range(shape, min_ratio)), SETTLING.exponents]),
            RANDOM_SEARCH_STEPS,
            SETTLING.min_turns,
            SETTLING.min_initial_rate,
            SETTLING.max_harmonics,
        )
        exponent = float(here[1]) if shape.exponent else 0.0
        shape = Shape(shape.family, math.exp(here[0]), exponent)
        found.append(Law(shape, float(here[2]), int(order), float(likelihood)))
    return max(found, key=lambda law: law.likelihood)


@njit(cache=True, nogil=True)
def _sample_laws_around(
    window: tuple[np.ndarray, np.ndarray, float, float],
    start: np.ndarray,
    left_range: np.ndarray,
    exponent_range: np.ndarray,
    steps: np.ndarray,
    harmonics: int,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return tested laws of a disk (count, 3), their initial rates and log likelihoods
    (count,).

    The laws (frames to the end, exponent, turns) are close to the starting point
    `start`. The steps are along and across the ridge of constant exponent divided by
    remaining time."""
    length = len(window[0]) - 1
    count = len(steps)
    tried = np.empty((count, 3))
    first_rates = np.empty(count)
    values = np.full(count, -np.inf)
    here = start.copy()
    best = -np.inf
    for k in range(count):
        left = min(max(here[0] + steps[k, 0], left_range[0]), left_range[1])
        exponent = (
            here[1] * (1 + (left - here[0]) / (length / 2 + here[0])) + steps[k, 1]
        )
        exponent = min(max(exponent, exponent_range[0]), exponent_range[1])
        turns = max(here[2] + steps[k, 2], 1.0)
        if k == 0:
            left, exponent, turns = here
        ratio = ((length + left) / left) ** exponent
        tried[k, 0] = left
        tried[k, 1] = exponent
        tried[k, 2] = turns
        values[k], _ = _likelihood(window, 0, ratio, exponent, turns, harmonics)
        first_rates[k] = turns / length * _initial_over_mean_rate(0, ratio, exponent)
        if values[k] > best:
            best = values[k]
            for i in range(3):
                here[i] = tried[k, i]
    return tried, first_rates, values


def laws_near(
    values: np.ndarray,
    scale_ms: float,
    start: tuple[float, float, float],
    left_range: tuple[float, float],
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return laws of a disk close to the starting point `start` (frames from the window
    to the end, exponent, turns).

    The results are frames to the end, exponents, initial rates [per frame] and log
    likelihoods, each (laws,)."""
    near_end = 200  # frames; the steps grow in proportion to a longer remaining time
    growth = max(start[0] / near_end, 1.0)
    tried, first_rates, likelihood = _sample_laws_around(
        _centred_window(values, scale_ms),
        np.array(start, dtype=float),
        np.array(left_range, dtype=float),
        np.array(SETTLING.exponents),
        RANDOM_WALK_STEPS * [growth, 1.0, 1.0],
        SETTLING.max_harmonics,
    )
    return tried[:, 0], tried[:, 1], first_rates, likelihood
