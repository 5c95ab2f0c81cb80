"""Exponent of the rate by the method of a published study, for comparison with its
values.

The processing chain is a band-pass (FIR), the Hilbert envelope, decimation to 960 Hz, a
high-pass at 3 Hz, a spectrogram of 512-point Hamming windows every 12 samples, the
maximum of each column, and a straight line through log Omega against log(t0 - t) (FU
Berlin, 2026). Its window of 0.53 s lowers the exponent 1/3 to 0.30 over a whole run and
to 0.26 over the last four seconds."""

from typing import NamedTuple

import numpy as np
from scipy.signal import (
    butter,
    decimate,
    firwin,
    hilbert,
    oaconvolve,
    sosfiltfilt,
    spectrogram,
)

BAND, TAPS = (4600.0, 5400.0), 513
RATE, HIGH_PASS = 960, 3.0
WINDOW, HOP, LOWEST = 512, 12, 5.0
FITTED_STRETCHES = {"whole run": np.inf, "last 4 s": 4.0, "last 1 s": 1.0}
"""Lengths [s] of the fitted intervals before the end."""
PUBLISHED_EXPONENTS = {"whole run": (0.309, 0.032), "last 4 s": (0.223, 0.041)}
"""Published exponents of a toy on granite: mean of 15 runs and standard deviation of a
run."""


class Exponent(NamedTuple):
    """Exponent of the rate over an interval, its standard error, and the number of
    columns."""

    value: float
    error: float
    columns: int


def exponents(samples, rate: float, end: float, band=BAND) -> dict[str, Exponent]:
    """Return the exponents over FITTED_STRETCHES for samples (n,) at `rate` [Hz].

    The motion ends at the time `end` [s].

    Raises ValueError if the sample rate is too low for the `band` [Hz].
    """
    if rate < 2.2 * band[1]:
        raise ValueError(
            f"a sample rate of {rate:g} Hz is too low for the band of {band[0]:g} to {band[1]:g} Hz"
        )
    high = oaconvolve(
        samples, firwin(TAPS, band, pass_zero=False, fs=rate), mode="same"
    )
    envelope = np.abs(hilbert(high))
    down = max(int(rate // RATE), 1)
    slow = decimate(envelope, down, ftype="fir")
    slow = sosfiltfilt(
        butter(2, HIGH_PASS, "highpass", fs=rate / down, output="sos"), slow
    )
    f, t, power = spectrogram(
        slow,
        rate / down,
        "hamming",
        min(WINDOW, len(slow)),
        noverlap=min(WINDOW, len(slow)) - HOP,
    )
    ridge = f[f > LOWEST][np.argmax(power[f > LOWEST], axis=0)]
    return {
        name: _fitted_line(end - t, ridge, longest)
        for name, longest in FITTED_STRETCHES.items()
    }


def _fitted_line(remaining, ridge, longest):
    """Return the exponent of an unweighted fit of log Omega against log(remaining
    time)."""
    within = (remaining > 0.02) & (remaining < longest)  # s
    if within.sum() < 8:
        return Exponent(np.nan, np.nan, int(within.sum()))
    (slope, _), covariance = np.polyfit(
        np.log(remaining[within]), np.log(ridge[within]), 1, cov=True
    )
    return Exponent(float(-slope), float(covariance[0, 0] ** 0.5), int(within.sum()))
