"""RECORDING -> EXPONENT AS PUBLISHED: the chain of a group that fits ridges by hand, to compare
like with like.

Band-pass (FIR), Hilbert envelope, decimation to 960 Hz, high-pass at 3 Hz, a spectrogram of
512-point Hamming windows every 12 samples, the maximum of each column, and a straight line through
log Omega against log(t0 - t): FU Berlin, 2026. Its window of 0.53 s reads the exponent 1/3 as 0.30
over a whole run and as 0.26 over its last four seconds."""

from typing import NamedTuple

import numpy as np
from scipy.signal import butter, decimate, firwin, hilbert, oaconvolve, sosfiltfilt, spectrogram

BAND, TAPS = (4600.0, 5400.0), 513
RATE, HIGH_PASS = 960, 3.0
WINDOW, HOP, LOWEST = 512, 12, 5.0
WINDOWS = {"whole run": np.inf, "last 4 s": 4.0, "last 1 s": 1.0}
"""Stretches before the end over which the line is drawn [s]."""
THEIRS = {"whole run": (0.309, 0.032), "last 4 s": (0.223, 0.041)}
"""Their exponent of a toy on granite, mean of 15 runs, and the standard deviation of one run."""
CLOSEST = 0.02
"""Columns that are nearer to the end [s] are not used."""


class Exponent(NamedTuple):
    """The exponent of Omega in the time left over a stretch, its standard error, and how many
    columns gave it."""

    value: float
    error: float
    columns: int


def exponents(samples, rate: float, end: float, band=BAND) -> dict[str, Exponent]:
    """Return the exponents over WINDOWS of samples (n,) at `rate` [Hz] of a disk that ends at `end`
    [s].

    Raises ValueError if the rate does not hold the `band` [Hz].
    """
    if rate < 2.2 * band[1]:
        raise ValueError(
            f"{rate:g} samples a second do not hold the band of {band[0]:g} to {band[1]:g} Hz"
        )
    high = oaconvolve(samples, firwin(TAPS, band, pass_zero=False, fs=rate), mode="same")
    envelope = np.abs(hilbert(high))
    down = max(int(rate // RATE), 1)
    slow = decimate(envelope, down, ftype="fir")
    slow = sosfiltfilt(butter(2, HIGH_PASS, "highpass", fs=rate / down, output="sos"), slow)
    f, t, power = spectrogram(
        slow, rate / down, "hamming", min(WINDOW, len(slow)), noverlap=min(WINDOW, len(slow)) - HOP
    )
    ridge = f[f > LOWEST][np.argmax(power[f > LOWEST], axis=0)]
    return {name: _line(end - t, ridge, longest) for name, longest in WINDOWS.items()}


def _line(left, ridge, longest):
    """A straight line through log Omega against log(time left), every column counting the same."""
    within = (left > CLOSEST) & (left < longest)
    if within.sum() < 8:
        return Exponent(np.nan, np.nan, int(within.sum()))
    (slope, _), covariance = np.polyfit(np.log(left[within]), np.log(ridge[within]), 1, cov=True)
    return Exponent(float(-slope), float(covariance[0, 0] ** 0.5), int(within.sum()))
