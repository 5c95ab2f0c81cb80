"""Frequencies and decay rates of the lines in free ringing, including close pairs.

The band around each peak of the spectrum is shifted to zero frequency and decimated.
The poles follow from the rotational invariance of the signal subspace (ESPRIT; Roy &
Kailath 1989)."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import hankel, svd
from scipy.ndimage import maximum_filter1d, median_filter, uniform_filter1d

from sonify.hearing.spectral_lines import MIN_LINE_FREQUENCY_HZ
from sonify.hearing.time_frequency import baseband

LINE_BAND_HALF_WIDTH = 120.0  # Hz; closer lines are resolved in a common band


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


def _lines_of_band(samples, rate, middle):
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
        return [_modulated(low, interval, middle)]
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


def _modulated(signal, interval, middle):
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


def _poles(signal):
    """Return the poles of decaying exponentials in a complex signal (n,).

    Their number follows from the singular values.
    """
    rows = max(len(signal) // 2, 2)
    vectors, values, _ = svd(
        hankel(signal[:rows], signal[rows - 1 :]),
        full_matrices=False,
        lapack_driver="gesvd",
    )
    noise = np.median(values)
    order = int(np.count_nonzero(values[:8] > max(6 * noise, 0.01 * values[0])))
    subspace = vectors[:, :order]
    rotation = np.linalg.lstsq(subspace[:-1], subspace[1:])[0]
    return np.linalg.eigvals(rotation)


def _amplitudes(signal, poles, interval):
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
