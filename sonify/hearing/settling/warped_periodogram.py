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
def _likelihoods(spectra, energy, independent, min_turns):
    """Return log likelihoods and numbers of harmonics of the best rates (windows,
    shapes).

    The spectra (windows shapes, bins) are those of zero-padded windows. `energy`
    (windows,) is the length times the sum of squares of each window, `independent`
    (windows,) the number of independent samples, and `min_turns` (shapes,) the minimum number
    of turns."""
    rows, bins = spectra.shape
    shapes = len(min_turns)
    likelihood = np.full((rows // shapes, shapes), -np.inf)
    harmonics = np.ones((rows // shapes, shapes), dtype=np.int64)
    power = np.zeros(2 * bins - 1, dtype=np.float32)
    for row in range(rows):
        w, s = divmod(row, shapes)
        _doubled_power(spectra[row], power)
        first = int(np.ceil(min_turns[s] * 4))
        for h, top in enumerate(_largest_sums(power, first), 1):
            value = (
                -independent[w] / 2 * np.log(1 - min(2 * top / energy[w], 0.999)) - h
            )
            if value > likelihood[w, s]:
                likelihood[w, s] = value
                harmonics[w, s] = h
    return likelihood, harmonics


@njit(cache=True, nogil=True)
def turns_of(spectrum, min_turns, harmonics):
    """Return the number of turns with the largest power of harmonics in a spectrum
    (bins,)."""
    power = np.zeros(2 * len(spectrum) - 1, dtype=np.float32)
    _doubled_power(spectrum, power)
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
    """Log likelihoods and numbers of harmonics of shapes (..., shapes), the spectra
    (shapes, bins) and the minimum numbers of turns (shapes,)."""

    likelihood: np.ndarray
    harmonics: np.ndarray
    spectra: np.ndarray
    min_turns: np.ndarray

    def turns(self, i: int) -> float:
        """Return the number of turns of shape i in a single window."""
        return turns_of(self.spectra[i], self.min_turns[i], self.harmonics[i])


def search(values: np.ndarray, scale_ms, warps: TabulatedWarps) -> SearchResult:
    """Return the result for the shapes of a table in windows (frames,) or (windows,
    frames)."""
    windows = np.atleast_2d(values)
    count, length = windows.shape
    shapes, cuts = warps.index.shape
    padded = np.zeros((count * shapes, 2 * (cuts - 1)), dtype=np.float32)
    energy = _warp(windows, warps.index, warps.fraction, padded)
    spectra = rfft(padded, axis=1, overwrite_x=True)
    independent = length / np.atleast_1d(scale_ms)
    min_turns = np.maximum(
        SETTLING.min_turns,
        SETTLING.min_initial_rate * length / 1000 / warps.first_rates,
    )
    min_turns = np.minimum(min_turns, (cuts - 1) / 2)
    found = _likelihoods(spectra, energy, independent, min_turns)
    likelihood, harmonics = (each.reshape(*values.shape[:-1], -1) for each in found)
    return SearchResult(likelihood, harmonics, spectra, min_turns)


def likelihoods(
    values: np.ndarray, scales_ms: np.ndarray, shapes: ShapeSet
) -> np.ndarray:
    """Return the largest log likelihoods (channels, families) in a window (channels,
    frames)."""
    length = values.shape[1]
    found = np.empty((len(values), len(shapes.begins)))
    steps = np.array([phase_step_count(length, scale) for scale in scales_ms])
    for count in np.unique(steps):
        warps = tabulated_warps(shapes, length, int(count))
        same = np.flatnonzero(steps == count)
        every = search(values[same], scales_ms[same], warps).likelihood
        found[same] = np.maximum.reduceat(every, shapes.begins, axis=1)
    return found


def strongest_laws(
    values: np.ndarray, scale_ms: float, shapes: ShapeSet
) -> dict[str, list[Law]]:
    """Return the three most likely laws of every family in a window (frames,), the best
    first."""
    count = 3
    length = len(values)
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
