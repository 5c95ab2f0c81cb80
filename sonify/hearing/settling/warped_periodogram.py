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
def _warp(values, index, fraction, padded):
    """Write sums of windows (windows, frames) over equal steps of phase into `padded`.

    `padded` is (windows shapes, 2 steps); its second half is unchanged. Returns the
    length of each window times its sum of squares about the mean (windows,)."""
    windows, length = values.shape
    shapes, cuts = index.shape
    energy = np.empty(windows)
    cumulative = np.zeros(length + 1, dtype=np.float32)
    for w in range(windows):
        mean = 0.0
        for i in range(length):
            mean += values[w, i]
        mean /= length
        total = 0.0
        squares = 0.0
        for i in range(length):
            deviation = values[w, i] - mean
            total += deviation
            squares += deviation * deviation
            cumulative[i + 1] = total
        energy[w] = max(squares, 1e-12 * length) * length
        for s in range(shapes):
            row = w * shapes + s
            before = cumulative[0]
            for j in range(1, cuts):
                i = index[s, j]
                now = cumulative[i] + fraction[s, j] * (
                    cumulative[i + 1] - cumulative[i]
                )
                padded[row, j - 1] = now - before
                before = now
    return energy


@njit(cache=True, nogil=True)
def _doubled_power(spectrum, power):
    """Write the power of a spectrum, with interpolated values between its bins, into
    `power`."""
    bins = len(spectrum)
    for k in range(bins):
        value = spectrum[k]
        power[2 * k] = value.real * value.real + value.imag * value.imag
    for k in range(1, bins - 2):
        # neighbouring bins differ in phase by a quarter turn, the phase of the centre of the window
        before = spectrum[k - 1]
        here = spectrum[k]
        after = spectrum[k + 1]
        later = spectrum[k + 2]
        inner = np.float32(0.5854)
        outer = np.float32(-0.0912)
        real = inner * (here.real - after.imag) + outer * (before.imag - later.real)
        imaginary = inner * (here.imag + after.real) - outer * (
            before.real + later.imag
        )
        power[2 * k + 1] = real * real + imaginary * imaginary


@njit(cache=True, nogil=True)
def _largest_sums(power, first):
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
def _explained_share(spectra, energy, power, share):
    """Write the share of the variance that each rate explains, averaged over components,
    into `share`.

    The spectra (components, bins) are those of zero-padded windows, and `energy`
    (components,) is the length times the sum of squares of each; `power` is work space
    of the size of `share`."""
    share[:] = 0
    for c in range(len(spectra)):
        _doubled_power(spectra[c], power)
        scale = np.float32(2 / (energy[c] * len(spectra)))
        for k in range(len(power)):
            share[k] += scale * power[k]


@njit(cache=True, nogil=True)
def _likelihoods(spectra, energy, independent, effective, min_turns):
    """Return log likelihoods and numbers of harmonics of the best rates (shapes,).

    The spectra (components, shapes, bins) are those of zero-padded windows. `energy`
    (components,) is the length times the sum of squares of each component,
    `independent` the number of independent samples, `effective` the number of
    independent components, and `min_turns` (shapes,) the minimum number of turns."""
    _, shapes, bins = spectra.shape
    likelihood = np.full(shapes, -np.inf)
    harmonics = np.ones(shapes, dtype=np.int64)
    power = np.zeros(2 * bins - 1, dtype=np.float32)
    share = np.zeros(2 * bins - 1, dtype=np.float32)
    for s in range(shapes):
        _explained_share(spectra[:, s], energy, power, share)
        first = int(np.ceil(min_turns[s] * 4))
        for h, top in enumerate(_largest_sums(share, first), 1):
            value = -independent / 2 * np.log(1 - min(top, 0.999)) - h
            if effective * value > likelihood[s]:
                likelihood[s] = effective * value
                harmonics[s] = h
    return likelihood, harmonics


@njit(cache=True, nogil=True)
def turns_of(spectra, energy, min_turns, harmonics):
    """Return the number of turns with the largest share of harmonics in spectra
    (components, bins)."""
    power = np.zeros(2 * spectra.shape[1] - 1, dtype=np.float32)
    work = power.copy()
    _explained_share(spectra, energy, work, power)
    top = -1.0
    place = 0
    for k in range(int(np.ceil(min_turns * 4)), (len(power) - 1) // harmonics + 1):
        value = 0.0
        for h in range(1, harmonics + 1):
            value += power[k * h]
        if value > top:
            top = value
            place = k
    return place / 4


def phase_step_count(length: int, scale_ms: float) -> int:
    """Return the number of phase steps in a window of `length` frames for bursts of
    `scale_ms`."""
    cells = length / scale_ms
    if cells <= 110:
        return 256
    return 512 if cells <= 220 else 1024


class SearchResult(NamedTuple):
    """Log likelihoods and numbers of harmonics of shapes (shapes,), the spectra
    (components, shapes, bins), the energy (components,) and the minimum numbers of turns
    (shapes,)."""

    likelihood: np.ndarray
    harmonics: np.ndarray
    spectra: np.ndarray
    energy: np.ndarray
    min_turns: np.ndarray

    def turns(self, i: int) -> float:
        """Return the number of turns of shape i."""
        spectra = self.spectra[:, i]
        return turns_of(spectra, self.energy, self.min_turns[i], self.harmonics[i])


def effective_components(values: np.ndarray) -> float:
    """Return the number of independent components in values (components, frames).

    It is the squared number of components over the sum of their squared
    correlations."""
    covariance = np.atleast_2d(np.cov(values))
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
    padded = np.zeros((count * shapes, 2 * (cuts - 1)), dtype=np.float32)
    energy = _warp(values, warps.index, warps.fraction, padded)
    spectra = rfft(padded, axis=1, overwrite_x=True).reshape(count, shapes, -1)
    min_turns = np.maximum(
        SETTLING.min_turns,
        SETTLING.min_initial_rate * length / 1000 / warps.first_rates,
    )
    min_turns = np.minimum(min_turns, (cuts - 1) / 2)
    effective = effective_components(values)
    likelihood, harmonics = _likelihoods(
        spectra, energy, length / scale_ms, effective, min_turns
    )
    return SearchResult(likelihood, harmonics, spectra, energy, min_turns)


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

    def law(i):
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
