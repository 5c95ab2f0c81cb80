"""Frequencies and decay rates of the lines in free ringing, including close pairs.

The band around each peak of the spectrum is shifted to zero frequency and decimated.
The poles follow from the rotational invariance of the signal subspace (ESPRIT; Roy &
Kailath 1989)."""

from bisect import bisect_left
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.fft import fft, ifft, next_fast_len
from scipy.linalg import blas, hankel, lapack
from scipy.ndimage import maximum_filter1d, median_filter, uniform_filter1d
from scipy.sparse.linalg import LinearOperator, svds

from sonify.hearing.spectral_lines import MIN_LINE_FREQUENCY_HZ
from sonify.hearing.time_frequency import baseband

LINE_BAND_HALF_WIDTH = 120.0  # Hz; closer lines are resolved in a common band
MAX_ORDER = 8
"""Largest number of decaying exponentials in a band."""


@dataclass(frozen=True, kw_only=True)
class DecayingLine:
    """A line exp(-decay_rate t) cos(2 pi frequency t).

    `frequency` is in Hz. `decay_rate` is that of the amplitude [1/s], with the standard
    error `decay_error`. `level` is the initial level in dB relative to the strongest
    line."""

    frequency: float
    decay_rate: float
    decay_error: float
    level: float


def free_ringing(samples: np.ndarray, rate: float) -> slice:
    """Return the slice of samples (n,) with free ringing after the loudest moment.

    It starts 80 ms after the loudest interval of 10 ms and ends where the power rises
    by 12 dB or has fallen by 50 dB."""
    hop = int(0.01 * rate)
    count = len(samples) // hop
    power = np.square(samples[: count * hop]).reshape(count, hop).mean(axis=1)
    level = 10 * np.log10(power + 1e-14)
    first = int(np.argmax(level)) + 8
    last = first
    while last < count and level[last] < level[first:last].min(initial=200.0) + 12:
        if level[last] < level[first] - 50:
            break
        last += 1
    return slice(first * hop, last * hop)


def decaying_lines(samples: np.ndarray, rate: float) -> list[DecayingLine]:
    """Return at most 12 lines of free ringing (n,) at `rate` [Hz], the strongest first.

    A line is returned only if its decay rate exceeds the standard error, because a steady
    or growing line does not ring freely."""
    max_count = 12
    min_prominence = 15.0  # dB
    if len(samples) < 0.1 * rate:
        return []
    spacing = rate / len(samples)
    power = (
        np.abs(np.fft.rfft(samples * np.hanning(2 * len(samples))[len(samples) :])) ** 2
    )
    step = max(int(10 / spacing), 1)
    smooth = uniform_filter1d(power, max(int(LINE_BAND_HALF_WIDTH / 2 / spacing), 1))
    coarse = 10 * np.log10(smooth[::step] + 1e-300)
    floor = median_filter(coarse, 200)  # 2 kHz
    above = 10 * np.log10(smooth + 1e-300) - np.repeat(floor, step)[: len(smooth)]
    reach = int(LINE_BAND_HALF_WIDTH / spacing)
    above[smooth < maximum_filter1d(smooth, reach + 1)] = 0  # the flanks of a line
    above[: int(MIN_LINE_FREQUENCY_HZ / spacing)] = 0
    above[int(0.45 * rate / spacing) :] = 0
    found: list[tuple[float, ...]] = []
    for _ in range(max_count):
        top = int(np.argmax(np.where(above > min_prominence, smooth, -np.inf)))
        if above[top] <= min_prominence:
            break
        found += _lines_of_band(samples, rate, top * spacing)
        above[max(top - reach, 0) : top + reach + 1] = 0
    found = [entry for entry in found if entry[2] > entry[3]]
    found.sort(key=lambda entry: -entry[0])
    return [
        DecayingLine(
            frequency=float(frequency),
            decay_rate=float(decay),
            decay_error=float(error),
            level=20 * float(np.log10(amplitude / found[0][0])),
        )
        for amplitude, frequency, decay, error in found[:max_count]
    ]


def _lines_of_band(samples: np.ndarray, rate: float, middle: float) -> list[Any]:
    """Return amplitude, frequency [Hz], decay rate and its error [1/s] of each line within
    LINE_BAND_HALF_WIDTH of a frequency [Hz]."""
    min_explained_power = 0.9  # of the power of the band, by its lines
    down = max(int(rate / (4 * LINE_BAND_HALF_WIDTH)), 1)
    taps = 6 * down + 1
    low = baseband(samples, rate, middle, LINE_BAND_HALF_WIDTH, down, taps, "valid")
    interval = down / rate
    poles = _poles(low)
    decay = -np.log(np.abs(poles)) / interval
    offset = np.angle(poles) / (2 * np.pi * interval)
    amplitude, error, explained = _amplitudes(low, poles, interval)
    if explained < min_explained_power:
        return [_modulated_decay(low, interval, middle)]
    begin = (taps - 1) / 2 / rate
    kept = (
        (decay > 0)
        & (np.abs(offset) < LINE_BAND_HALF_WIDTH)
        & (amplitude > 0.05 * amplitude.max())
    )
    kept &= error < 0.5 * decay
    start_amplitude = amplitude * np.exp(decay * begin)
    lines = np.stack([start_amplitude, middle + offset, decay, error], axis=1)
    return list(lines[kept])


def _modulated_decay(
    signal: np.ndarray, interval: float, middle: float
) -> tuple[float, float, float, float]:
    """Return amplitude, frequency, decay rate and its error of a modulated decaying
    signal (n,).

    Such a signal, e.g. that of a coin that turns while it rings, is not a sum of a few
    decaying lines. Its level is fitted by a straight line over at most 35 dB, without
    the first 20 ms."""
    part_count = 4
    hop = max(round(0.02 / interval), 1)
    parts = signal[: len(signal) // hop * hop].reshape(-1, hop)
    power = np.square(np.abs(parts)).mean(axis=1)
    level = 10 * np.log10(power + 1e-300)[1:]
    quiet = np.flatnonzero(level < level[0] - 35)
    level = level[: max(quiet[0], 4) if len(quiet) else None]
    time = np.arange(len(level)) * hop * interval
    slope, height = np.polyfit(time, level, 1)
    part = np.arange(len(level)) * part_count // len(level)
    without = [
        np.polyfit(time[part != k], level[part != k], 1)[0] for k in np.unique(part)
    ]
    error = np.sqrt(
        (len(without) - 1) * np.var(without)
    )  # jackknife, because the modulation is slow
    to_decay = np.log(10) / 20  # dB/s to 1/s
    return 10 ** (height / 20), middle, -slope * to_decay, error * to_decay


def _poles(signal: np.ndarray) -> np.ndarray:
    """Return the poles of decaying exponentials in a complex signal (n,).

    Their number follows from the singular values of the Hankel matrix of the signal.
    """
    vectors, values = _largest_singular_triplets(signal)
    subspace = vectors[:, : _count_exponentials(signal, values)]
    rotation = np.linalg.lstsq(subspace[:-1], subspace[1:])[0]
    return np.linalg.eigvals(rotation)


def _hankel_rows(signal: np.ndarray) -> int:
    """Return the number of rows of the Hankel matrix, at most that of its columns."""
    return max(len(signal) // 2, 2)


def _largest_singular_triplets(signal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the left vectors (rows, MAX_ORDER) of the Hankel matrix of a signal (n,) with
    the largest singular values (MAX_ORDER,), in decreasing order.

    The Lanczos method needs only products with the matrix, which are convolutions."""
    rows = _hankel_rows(signal)
    columns = len(signal) - rows + 1
    size = next_fast_len(len(signal))
    spectrum = fft(signal, size)

    def product(vector: np.ndarray) -> np.ndarray:
        inner = ifft(spectrum * fft(vector[::-1], size))
        return inner[len(vector) - 1 : len(signal)]

    matrix = LinearOperator(
        (rows, columns),
        matvec=lambda vector: product(vector.ravel()),
        rmatvec=lambda vector: product(vector.ravel().conj()).conj(),
        dtype=complex,
    )
    start = np.random.default_rng(1).standard_normal(rows).astype(complex)
    vectors, values, _ = svds(
        matrix, MAX_ORDER, v0=start, return_singular_vectors="u", solver="arpack"
    )
    falling = np.argsort(-values)
    return vectors[:, falling], values[falling]


def _count_exponentials(signal: np.ndarray, values: np.ndarray) -> int:
    """Return the number of decaying exponentials in a signal (n,): the number of its
    largest singular `values` above 1 % of the first one and six times their median.

    The energy of the other singular values bounds the median; only if this does not
    decide, the singular values below a sixth of these `values` are counted."""
    median_factor = 6.0
    strong = values[values > 0.01 * values[0]]
    rows = _hankel_rows(signal)
    place = np.arange(len(signal))
    entries = np.minimum(np.minimum(place + 1, place[::-1] + 1), rows)
    rest = entries @ np.square(np.abs(signal)) - np.sum(np.square(values))
    squared_bound = rest / (rows / 2 - len(values))
    if strong[-1] > median_factor * np.sqrt(max(squared_bound, 0)):
        return len(strong)
    gram = blas.zherk(1.0, hankel(signal[:rows], signal[rows - 1 :]), lower=1)

    def is_noise(value: float) -> bool:
        return 2 * _eigenvalues_below(gram, (value / median_factor) ** 2) < rows

    return bisect_left(strong, True, key=is_noise)


def _eigenvalues_below(matrix: np.ndarray, limit: float) -> int:
    """Return the number of eigenvalues below a limit of a Hermitian matrix, given by its
    lower triangle (n, n): that of the negative pivots, by Sylvester's law of inertia.

    Each pivot of two rows has one negative eigenvalue."""
    shifted = matrix - limit * np.eye(len(matrix))
    factor, pivots, _ = lapack.zhetrf(shifted, lower=1, lwork=64 * len(matrix))
    pairs = int(np.count_nonzero(pivots < 0)) // 2
    return pairs + int(np.count_nonzero(factor.diagonal().real[pivots > 0] < 0))


def _amplitudes(
    signal: np.ndarray, poles: np.ndarray, interval: float
) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the amplitudes of poles in a signal (n,) and the standard errors of their
    decay rates.

    The errors are in 1/s. The fraction of the power that the poles explain is also
    returned."""
    number = np.arange(len(signal))
    columns = poles ** number[:, None]
    amplitudes = np.linalg.lstsq(columns, signal)[0]
    residual = signal - columns @ amplitudes
    slopes = -columns * amplitudes * (number[:, None] * interval)
    jacobian = np.hstack([columns, slopes])
    variance = np.sum(np.abs(residual) ** 2) / max(len(signal) - 2 * len(poles), 1)
    covariance = variance * np.linalg.pinv(jacobian.conj().T @ jacobian)
    errors = np.sqrt(np.abs(np.diag(covariance).real[len(poles) :]) / 2)
    explained = 1 - np.sum(np.abs(residual) ** 2) / np.sum(np.abs(signal) ** 2)
    return np.abs(amplitudes), errors, explained
