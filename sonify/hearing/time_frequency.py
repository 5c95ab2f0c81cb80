"""Spectra over time, their peaks, and the signal of one band.

Examples
--------
The frequency of a tone, from the peak of each Hann window:

>>> import numpy as np
>>> rate = 8000
>>> tone = np.sin(2 * np.pi * 441.0 * np.arange(rate) / rate)
>>> size = 800  # samples; the bins are 10 Hz wide
>>> level = 10 * np.log10(hann_power(tone, size, size // 2) + 1e-30)
>>> frame, column, offset = local_maxima(level, min_level=20.0)
>>> np.unique(((column + offset) * rate / size).round()).tolist()
[441.0]

Its decay, from the signal of the band around it:

>>> ringing = tone * np.exp(-3.0 * np.arange(rate) / rate)
>>> signal = baseband(ringing, rate, 440.0, half_width=50.0, down=20, taps=161)
>>> inner = np.log(np.abs(signal[20:-20]))
>>> round(float(np.mean(np.diff(inner))) * -rate / 20, 2)  # 1/s
3.0
"""

from typing import Literal

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.signal import firwin, oaconvolve


def hann_power(samples: np.ndarray, size: int, hop: int) -> np.ndarray:
    """Return the power spectra (t, f) in Hann windows of samples (n,).

    The windows have `size` samples and begin `hop` samples apart; none exceeds the
    samples."""
    windows = sliding_window_view(samples, size)[::hop]
    return np.abs(np.fft.rfft(windows * np.hanning(size))) ** 2


def vertex(below: np.ndarray, top: np.ndarray, above: np.ndarray) -> np.ndarray:
    """Return the position of the vertex of the parabola through a peak and its
    neighbours.

    It is relative to the peak, from -0.5 to 0.5 bins.
    """
    return (below - above) / (2 * (below - 2 * top + above))


def local_maxima(
    level: np.ndarray, min_level: float = -np.inf
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the row, the column and the offset of the vertex from the column, each
    (n,), of the local maxima above `min_level` in the rows of levels (t, f) [dB].

    Of equal neighbours, the first one is the maximum.
    """
    below, top, above = level[:, :-2], level[:, 1:-1], level[:, 2:]
    here = np.nonzero((top > below) & (top >= above) & (top > min_level))
    return here[0], here[1] + 1, vertex(below[here], top[here], above[here])


def baseband(
    samples: np.ndarray,
    rate: float,
    middle: float,
    half_width: float,
    down: int,
    taps: int,
    mode: Literal["same", "valid"] = "same",
) -> np.ndarray:
    """Return the complex signal (k,) of a band of samples (n,), shifted to zero
    frequency.

    Parameters
    ----------
    samples : ndarray, shape (n,)
        The samples.
    rate : float
        Sample rate [Hz].
    middle, half_width : float
        Middle and half-width of the band [Hz].
    down : int
        Factor of decimation.
    taps : int
        Length of the low-pass filter [samples].
    mode : str
        "valid" omits the samples at both ends that the filter does not fill.
    """
    time = np.arange(len(samples)) / rate
    shifted = samples * np.exp(-2j * np.pi * middle * time)
    low_pass = firwin(taps, 1.5 * half_width, fs=rate)
    return oaconvolve(shifted, low_pass, mode=mode)[::down]
