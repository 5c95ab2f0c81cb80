"""Log likelihoods of rate laws in a window; one FFT over warped time covers all
rates."""

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.fft import rfft

from dynamics.numba_kernels import njit
from sonify.hearing.settling.rate_laws import Law, ShapeSet
from sonify.hearing.settling.settings import SETTLING

RATES_PER_TURN = 4
"""Number of rates per turn in the window: two bins of the padded spectrum and two
interpolated values."""


@dataclass(frozen=True, eq=False)
class TabulatedWarps:
    """Cuts of a window into equal steps of phase, as frame and remainder (shapes, steps
    + 1).

    `first_rates` (shapes,) are the ratios of the initial to the mean rate.
    """

    index: np.ndarray
    fraction: np.ndarray
    first_rates: np.ndarray


@lru_cache(maxsize=256)
def tabulated_warps(family: ShapeSet, length: int, steps: int) -> TabulatedWarps:
    """Return the cuts of a window of `length` frames for the shapes of a family."""
    phases = np.linspace(0, 1, steps + 1)
    places = length * np.array([shape.time(phases) for shape in family.shapes])
    index = np.clip(places.astype(np.int32), 0, length - 1)
    first_rates = np.array([shape.first_rate for shape in family.shapes])
    return TabulatedWarps(index, (places - index).astype(np.float32), first_rates)


@njit(cache=True, nogil=True)
def _sum_over_phase_steps(
    values: np.ndarray, index: np.ndarray, fraction: np.ndarray, padded: np.ndarray
) -> float:
    """Write sums of a window (frames,) over equal steps of phase into `padded`.

    `padded` is (shapes, 2 steps); its second half is unchanged. Returns the length of the
    window times its sum of squares about the mean."""
    length = len(values)
    shapes, cuts = index.shape
    cumulative = np.zeros(length + 1, dtype=np.float32)
    mean = 0.0
    for i in range(length):
        mean += values[i]
    mean /= length
    total = 0.0
    squares = 0.0
    for i in range(length):
        deviation = values[i] - mean
        total += deviation
        squares += deviation * deviation
        cumulative[i + 1] = total
    for s in range(shapes):
        before = cumulative[0]
        for j in range(1, cuts):
            i = index[s, j]
            now = cumulative[i] + fraction[s, j] * (cumulative[i + 1] - cumulative[i])
            padded[s, j - 1] = now - before
            before = now
    return max(squares, 1e-12 * length) * length


@njit(cache=True, nogil=True)
def _add_explained_share(
    spectra: np.ndarray, scale: np.float32, share: np.ndarray
) -> None:
    """Add the power of spectra (shapes, bins), with interpolated values between their
    bins, times a scale to a share (shapes, rates) of the variance."""
    inner = np.float32(0.5854)
    outer = np.float32(-0.0912)
    shapes, bins = spectra.shape
    real = np.empty(bins, dtype=np.float32)  # contiguous parts vectorise
    imag = np.empty(bins, dtype=np.float32)
    for s in range(shapes):
        for k in range(bins):
            real[k] = spectra[s, k].real
            imag[k] = spectra[s, k].imag
        for k in range(bins):
            share[s, 2 * k] += scale * (real[k] * real[k] + imag[k] * imag[k])
        for k in range(1, bins - 2):
            # neighbouring bins differ in phase by a quarter turn, the phase of the centre of the window
            between_real = inner * (real[k] - imag[k + 1]) + outer * (
                imag[k - 1] - real[k + 2]
            )
            between_imag = inner * (imag[k] + real[k + 1]) - outer * (
                real[k - 1] + imag[k + 2]
            )
            share[s, 2 * k + 1] += scale * (
                between_real * between_real + between_imag * between_imag
            )


@njit(cache=True, nogil=True)
def _largest_sums(power: np.ndarray, first: int) -> np.ndarray:
    """Return the largest sums (4,) of one to four terms of the power at k, 2 k, 3 k,
    4 k, for k >= `first`."""
    largest = np.zeros(4, dtype=np.float32)
    sums = np.zeros(len(power), dtype=np.float32)
    for terms in range(1, 5):
        top = np.float32(0)
        for k in range(first, (len(power) - 1) // terms + 1):
            sums[k] += power[terms * k]
            top = max(top, sums[k])
        largest[terms - 1] = top
    return largest


@njit(cache=True, nogil=True)
def _likelihoods(
    share: np.ndarray, independent: float, effective: float, min_turns: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return log likelihoods and numbers of harmonics of the best rates (shapes,).

    `share` (shapes, rates) is the share of the variance that each rate explains,
    `independent` the number of independent samples, `effective` the number of
    independent components, and `min_turns` (shapes,) the minimum number of turns."""
    shapes = len(share)
    likelihood = np.full(shapes, -np.inf)
    harmonics = np.ones(shapes, dtype=np.int64)
    for s in range(shapes):
        first = int(np.ceil(min_turns[s] * RATES_PER_TURN))
        for h, top in enumerate(_largest_sums(share[s], first), 1):
            value = -independent / 2 * np.log(1 - min(top, 0.999)) - h
            if effective * value > likelihood[s]:
                likelihood[s] = effective * value
                harmonics[s] = h
    return likelihood, harmonics


@njit(cache=True, nogil=True)
def turns_of(share: np.ndarray, min_turns: float, harmonics: int) -> float:
    """Return the number of turns with the largest share (rates,) of harmonics."""
    top = -1.0
    place = 0
    first = int(np.ceil(min_turns * RATES_PER_TURN))
    for k in range(first, (len(share) - 1) // harmonics + 1):
        value = 0.0
        for h in range(1, harmonics + 1):
            value += share[k * h]
        if value > top:
            top = value
            place = k
    return place / RATES_PER_TURN


def phase_step_count(length: int, scale_ms: float) -> int:
    """Return the number of phase steps in a window of `length` frames for bursts of
    `scale_ms`."""
    cells = length / scale_ms
    if cells <= 110:
        return 256
    return 512 if cells <= 220 else 1024


class SearchResult(NamedTuple):
    """Log likelihoods, numbers of harmonics and minimum numbers of turns of shapes
    (shapes,), and the share (shapes, rates) of the variance that each rate explains."""

    likelihood: np.ndarray
    harmonics: np.ndarray
    share: np.ndarray
    min_turns: np.ndarray

    def turns(self, i: int) -> float:
        """Return the number of turns of shape i."""
        return turns_of(self.share[i], self.min_turns[i], self.harmonics[i])


def effective_components(values: np.ndarray) -> float:
    """Return the number of independent components in values (components, frames).

    It is the squared number of components over the sum of their squared
    correlations."""
    if len(values) == 1:
        return 1.0
    covariance = np.cov(values)
    deviation = np.sqrt(np.diag(covariance))
    varies = deviation > 1e-6
    if np.count_nonzero(varies) < 2:
        return 1.0
    covariance = covariance[np.ix_(varies, varies)]
    correlation = covariance / np.outer(deviation[varies], deviation[varies])
    return len(correlation) ** 2 / float(np.sum(np.square(correlation)))


def search(values: np.ndarray, scale_ms: float, warps: TabulatedWarps) -> SearchResult:
    """Return the result for the shapes of a table in a window (components, frames)."""
    count, length = values.shape
    shapes, cuts = warps.index.shape
    padded = np.zeros((shapes, 2 * (cuts - 1)), dtype=np.float32)
    share = np.zeros((shapes, 2 * cuts - 1), dtype=np.float32)
    for component in values:
        energy = _sum_over_phase_steps(component, warps.index, warps.fraction, padded)
        spectra = rfft(padded, axis=1)
        _add_explained_share(spectra, np.float32(2 / (energy * count)), share)
    min_turns = np.maximum(
        SETTLING.min_turns,
        SETTLING.min_initial_rate * length / 1000 / warps.first_rates,
    )
    min_turns = np.minimum(min_turns, (cuts - 1) / 2)
    likelihood, harmonics = _likelihoods(
        share, length / scale_ms, effective_components(values), min_turns
    )
    return SearchResult(likelihood, harmonics, share, min_turns)


def largest_likelihoods(
    values: np.ndarray, scale_ms: float, shapes: ShapeSet
) -> np.ndarray:
    """Return the largest log likelihoods (families,) in a window (components,
    frames)."""
    length = values.shape[1]
    warps = tabulated_warps(shapes, length, phase_step_count(length, scale_ms))
    every = search(values, scale_ms, warps).likelihood
    return np.maximum.reduceat(every, shapes.begins)


def strongest_laws(
    values: np.ndarray, scale_ms: float, shapes: ShapeSet
) -> dict[str, list[Law]]:
    """Return the three most likely laws of every family in a window (components,
    frames), the best first."""
    count = 3
    length = values.shape[1]
    warps = tabulated_warps(shapes, length, phase_step_count(length, scale_ms))
    result = search(values, scale_ms, warps)

    def law(i: int) -> Law:
        likelihood = float(result.likelihood[i])
        return Law(
            shapes.shapes[i], result.turns(i), int(result.harmonics[i]), likelihood
        )

    found = {}
    members = np.split(result.likelihood, shapes.begins[1:])
    for name, begin, own in zip(shapes.names, shapes.begins, members, strict=True):
        best = np.argsort(-own, kind="stable")[:count]
        found[name] = [law(begin + i) for i in best]
    return found
