"""Log likelihoods of rate laws in a window; one FFT over warped time covers all
rates."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numba import njit
from scipy.fft import rfft

from sonify.hearing.settling.rate_laws import Law, ShapeSet
from sonify.hearing.settling.settings import SettlingSettings


@dataclass(frozen=True, eq=False)
class WarpTable:
    """Cuts of a window into equal steps of phase, as frame and remainder (shapes, steps
    + 1).

    `first_rates` (shapes,) are the ratios of the initial to the mean rate.
    """

    index: np.ndarray
    fraction: np.ndarray
    first_rates: np.ndarray


@lru_cache(maxsize=256)
def warp_table(family: ShapeSet, length: int, steps: int) -> WarpTable:
    """Return the cuts of a window of `length` frames for the shapes of a family."""
    phases = np.linspace(0, 1, steps + 1)
    places = length * np.array([shape.time(phases) for shape in family.shapes])
    index = np.clip(places.astype(np.int32), 0, length - 1)
    first_rates = np.array([shape.first_rate for shape in family.shapes])
    return WarpTable(index, (places - index).astype(np.float32), first_rates)


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
    """Return the largest sums of one to four terms of the power at k, 2 k, 3 k, 4 k,
    for k >= `first`."""
    bins = len(power)
    one = np.float32(0)
    two = np.float32(0)
    three = np.float32(0)
    four = np.float32(0)
    last = bins - 1
    begin_three = max(last // 4 + 1, first)
    begin_two = max(last // 3 + 1, first)
    begin_one = max(last // 2 + 1, first)
    for k in range(first, begin_three):
        pair = power[k] + power[2 * k]
        triple = pair + power[3 * k]
        one = max(one, power[k])
        two = max(two, pair)
        three = max(three, triple)
        four = max(four, triple + power[4 * k])
    for k in range(begin_three, begin_two):
        pair = power[k] + power[2 * k]
        one = max(one, power[k])
        two = max(two, pair)
        three = max(three, pair + power[3 * k])
    for k in range(begin_two, begin_one):
        one = max(one, power[k])
        two = max(two, power[k] + power[2 * k])
    for k in range(begin_one, bins):
        one = max(one, power[k])
    return one, two, three, four


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


def steps_for(length: int, scale_ms: float) -> int:
    """Return the number of phase steps in a window of `length` frames for bursts of
    `scale_ms`."""
    cells = length / scale_ms
    return 256 if cells <= 110 else 512 if cells <= 220 else 1024


def minimum_turns(
    length: int, table: WarpTable, settings: SettlingSettings
) -> np.ndarray:
    """Return the minimum numbers of turns (shapes,) in the search of a window of `length`
    frames."""
    min_turns = np.maximum(
        settings.min_turns,
        settings.min_initial_rate * length / 1000 / table.first_rates,
    )
    return np.minimum(min_turns, (table.index.shape[1] - 1) / 2)


def _search(values, scale_ms, table, settings):
    """Return log likelihoods and harmonics (windows, shapes) of windows (windows,
    frames).

    The spectra (windows shapes, bins) are also returned.
    """
    windows, length = values.shape
    shapes, cuts = table.index.shape
    padded = np.zeros((windows * shapes, 2 * (cuts - 1)), dtype=np.float32)
    energy = _warp(values, table.index, table.fraction, padded)
    spectra = rfft(padded, axis=1, overwrite_x=True)
    independent = length / np.atleast_1d(scale_ms)
    min_turns = minimum_turns(length, table, settings)
    likelihood, harmonics = _likelihoods(spectra, energy, independent, min_turns)
    return likelihood, harmonics, spectra


def search_table(
    values: np.ndarray, scale_ms: float, table: WarpTable, settings: SettlingSettings
):
    """Return log likelihoods and numbers of harmonics (shapes,) for a window (frames,).

    The spectra (shapes, bins) are also returned.
    """
    likelihood, harmonics, spectra = _search(values[None], scale_ms, table, settings)
    return likelihood[0], harmonics[0], spectra


def likelihoods(
    values: np.ndarray,
    scales_ms: np.ndarray,
    shapes: ShapeSet,
    settings: SettlingSettings,
) -> np.ndarray:
    """Return the largest log likelihoods (channels, families) in a window (channels,
    frames)."""
    length = values.shape[1]
    found = np.empty((len(values), len(shapes.begins)))
    steps = np.array([steps_for(length, scale) for scale in scales_ms])
    for count in np.unique(steps):
        table = warp_table(shapes, length, int(count))
        same = np.flatnonzero(steps == count)
        every = _search(values[same], scales_ms[same], table, settings)[0]
        found[same] = np.maximum.reduceat(every, shapes.begins, axis=1)
    return found


def strongest_laws(
    values: np.ndarray,
    scale_ms: float,
    shapes: ShapeSet,
    settings: SettlingSettings,
    count: int = 3,
) -> dict[str, list[Law]]:
    """Return the most likely laws of every family in a window (frames,), the best
    first."""
    length = len(values)
    table = warp_table(shapes, length, steps_for(length, scale_ms))
    likelihood, harmonics, spectra = search_table(values, scale_ms, table, settings)
    min_turns = minimum_turns(length, table, settings)

    def law(i):
        turns = turns_of(spectra[i], min_turns[i], harmonics[i])
        return Law(shapes.shapes[i], turns, int(harmonics[i]), float(likelihood[i]))

    found = {}
    for name, members in zip(
        shapes.names, np.split(likelihood, shapes.begins[1:]), strict=True
    ):
        best = np.argsort(-members, kind="stable")[:count]
        found[name] = [law(shapes.begins[len(found)] + i) for i in best]
    return found
