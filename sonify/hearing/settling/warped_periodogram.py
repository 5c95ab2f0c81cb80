"""ONSET STRENGTH, WINDOW -> LOG LIKELIHOOD of every rate law: one FFT over warped time serves all
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
    """Where windows are cut into equal steps of phase: frame and remainder (shapes, steps + 1).

    first_rates (shapes,): rate at the beginning over the mean rate.
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
def warp(cumulative, index, fraction, padded):
    """Write the onset strength summed over equal steps of phase into the first half of `padded`
    (shapes, 2 steps)."""
    shapes, cuts = index.shape
    for s in range(shapes):
        before = cumulative[0]
        for j in range(1, cuts):
            i = index[s, j]
            now = cumulative[i] + fraction[s, j] * (cumulative[i + 1] - cumulative[i])
            padded[s, j - 1] = now - before
            before = now


@njit(cache=True, nogil=True)
def _doubled_power(spectrum, power):
    """Write the power of a spectrum padded to twice its length, and of the bins between,
    interpolated, into `power`."""
    bins = len(spectrum)
    for k in range(bins):
        value = spectrum[k]
        power[2 * k] = value.real * value.real + value.imag * value.imag
    for k in range(1, bins - 2):
        # the phase of neighbouring bins differs by a quarter turn, that of the middle of the window
        before = spectrum[k - 1]
        here = spectrum[k]
        after = spectrum[k + 1]
        later = spectrum[k + 2]
        inner = np.float32(0.5854)
        outer = np.float32(-0.0912)
        real = inner * (here.real - after.imag) + outer * (before.imag - later.real)
        imaginary = inner * (here.imag + after.real) - outer * (before.real + later.imag)
        power[2 * k + 1] = real * real + imaginary * imaginary


@njit(cache=True, nogil=True)
def _largest_sums(power, first):
    """Return the largest sums of power at k, 2 k, 3 k, 4 k for k from `first` on: of one to four
    terms."""
    bins = len(power)
    one = np.float32(0)
    two = np.float32(0)
    three = np.float32(0)
    four = np.float32(0)
    limits = [max((bins - 1) // h + 1, first) for h in (4, 3, 2, 1)]
    for k in range(first, limits[0]):
        pair = power[k] + power[2 * k]
        triple = pair + power[3 * k]
        one = max(one, power[k])
        two = max(two, pair)
        three = max(three, triple)
        four = max(four, triple + power[4 * k])
    for k in range(limits[0], limits[1]):
        pair = power[k] + power[2 * k]
        one = max(one, power[k])
        two = max(two, pair)
        three = max(three, pair + power[3 * k])
    for k in range(limits[1], limits[2]):
        one = max(one, power[k])
        two = max(two, power[k] + power[2 * k])
    for k in range(limits[2], limits[3]):
        one = max(one, power[k])
    return one, two, three, four


@njit(cache=True, nogil=True)
def _place_of_sum(power, first, harmonics):
    """Return where the sum of power at k, 2 k, ... is largest."""
    top = -1.0
    place = first
    for k in range(first, (len(power) - 1) // harmonics + 1):
        value = 0.0
        for h in range(1, harmonics + 1):
            value += power[k * h]
        if value > top:
            top = value
            place = k
    return place


@njit(cache=True, nogil=True)
def _likelihoods(spectra, energy, independent, least):
    """Return the log likelihood of the best rate and its number of harmonics for spectra (shapes,
    bins).

    Spectra are padded to twice their length. energy: length times sum of squares of the window;
    independent: number of independent samples; least (shapes,): least number of turns."""
    rows, bins = spectra.shape
    likelihood = np.full(rows, -np.inf)
    harmonics = np.ones(rows, dtype=np.int64)
    power = np.zeros(2 * bins - 1, dtype=np.float32)
    for row in range(rows):
        _doubled_power(spectra[row], power)
        first = int(np.ceil(least[row] * 4))
        for h, top in enumerate(_largest_sums(power, first), 1):
            value = -independent / 2 * np.log(1 - min(2 * top / energy, 0.999)) - h
            if value > likelihood[row]:
                likelihood[row] = value
                harmonics[row] = h
    return likelihood, harmonics


@njit(cache=True, nogil=True)
def turns_of(spectrum, least, harmonics):
    """Return the number of turns at which the power of the harmonics of a spectrum (bins,) is
    largest."""
    power = np.zeros(2 * len(spectrum) - 1, dtype=np.float32)
    _doubled_power(spectrum, power)
    top = -1.0
    place = 0
    for k in range(int(np.ceil(least * 4)), (len(power) - 1) // harmonics + 1):
        value = 0.0
        for h in range(1, harmonics + 1):
            value += power[k * h]
        if value > top:
            top = value
            place = k
    return place / 4


def steps_for(length: int, scale_ms: float) -> int:
    """Return into how many steps of phase a window of `length` frames is cut for a burst of
    `scale_ms`."""
    cells = length / scale_ms
    return 256 if cells <= 110 else 512 if cells <= 220 else 1024


def least_turns(length: int, table: WarpTable, settings: SettlingSettings) -> np.ndarray:
    """Return the least number of turns (shapes,) searched in a window of `length` frames."""
    least = np.maximum(
        settings.least_turns, settings.least_rate * length / 1000 / table.first_rates
    )
    return np.minimum(least, (table.index.shape[1] - 1) / 2)


def _energy(values):
    """The length of a window times its sum of squares about the mean."""
    return max(float(np.var(values, dtype=float)), 1e-12) * len(values) ** 2


def _warped(values, table):
    """A window (frames,) in equal steps of phase (shapes, 2 steps), padded to twice its length."""
    cumulative = np.zeros(len(values) + 1, dtype=np.float32)
    np.cumsum(values - values.mean(), out=cumulative[1:])
    shapes, cuts = table.index.shape
    padded = np.zeros((shapes, 2 * (cuts - 1)), dtype=np.float32)
    warp(cumulative, table.index, table.fraction, padded)
    return padded


def search_table(values: np.ndarray, scale_ms: float, table: WarpTable, settings: SettlingSettings):
    """Return log likelihood and harmonics (shapes,) and spectra (shapes, bins) of a window
    (frames,)."""
    length = len(values)
    spectra = rfft(_warped(values, table), axis=1)
    least = least_turns(length, table, settings)
    likelihood, harmonics = _likelihoods(spectra, _energy(values), length / scale_ms, least)
    return likelihood, harmonics, spectra


def likelihoods(
    values: np.ndarray, scales_ms: np.ndarray, family: ShapeSet, settings: SettlingSettings
) -> np.ndarray:
    """Return the largest log likelihood (channels,) of a family in a window (channels, frames)."""
    length = values.shape[1]
    found = np.empty(len(values))
    steps = np.array([steps_for(length, scale) for scale in scales_ms])
    for count in np.unique(steps):
        table = warp_table(family, length, int(count))
        same = np.flatnonzero(steps == count)
        spectra = rfft(np.concatenate([_warped(values[i], table) for i in same]), axis=1)
        least = least_turns(length, table, settings)
        for i, part in zip(same, np.split(spectra, len(same)), strict=True):
            energy = _energy(values[i])
            found[i] = _likelihoods(part, energy, length / scales_ms[i], least)[0].max()
    return found


def strongest_laws(
    values: np.ndarray,
    scale_ms: float,
    family: ShapeSet,
    settings: SettlingSettings,
    count: int = 3,
) -> list[Law]:
    """Return the most likely laws of a family in a window (frames,) of one channel, the best
    first."""
    length = len(values)
    table = warp_table(family, length, steps_for(length, scale_ms))
    likelihood, harmonics, spectra = search_table(values, scale_ms, table, settings)
    least = least_turns(length, table, settings)
    best = np.argsort(-likelihood, kind="stable")[:count]
    return [
        Law(
            family.shapes[i],
            turns_of(spectra[i], least[i], harmonics[i]),
            int(harmonics[i]),
            float(likelihood[i]),
        )
        for i in best
    ]
