"""Exponent of the rate by the method of a published study, for comparison with the
published values.

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

FIT_LENGTH_S = {"whole run": np.inf, "last 4 s": 4.0, "last 1 s": 1.0}
"""Lengths of the fitted intervals before the end."""
PUBLISHED_EXPONENTS = {"whole run": (0.309, 0.032), "last 4 s": (0.223, 0.041)}
"""Published exponents of a toy on granite: mean and standard deviation of 15 runs."""


class Exponent(NamedTuple):
    """Exponent of the rate over an interval, its standard error, and the number of
    columns."""

    value: float
    error: float
    columns: int


def rate_exponents(samples, rate: float, end: float) -> dict[str, Exponent]:
    """Return the exponents over the intervals of FIT_LENGTH_S for samples (n,) at
    `rate` [Hz].

    The motion ends at the time `end` [s].

    Raises ValueError if the sample rate is too low.
    """
    band = (4600.0, 5400.0)  # Hz
    tap_count = 513
    envelope_rate = 960  # Hz
    high_pass_frequency = 3.0  # Hz
    hop = 12  # samples
    min_frequency = 5.0  # Hz
    if rate < 2.2 * band[1]:
        raise ValueError(
            f"a sample rate of {rate:g} Hz is too low for the band of {band[0]:g} to {band[1]:g} Hz"
        )
    band_pass = firwin(tap_count, band, pass_zero=False, fs=rate)
    envelope = np.abs(hilbert(oaconvolve(samples, band_pass, mode="same")))
    down = max(int(rate // envelope_rate), 1)
    decimated = decimate(envelope, down, ftype="fir")
    high_pass = butter(2, high_pass_frequency, "highpass", fs=rate / down, output="sos")
    decimated = sosfiltfilt(high_pass, decimated)
    size = min(512, len(decimated))
    f, t, power = spectrogram(
        decimated, rate / down, "hamming", size, noverlap=size - hop
    )
    above = f > min_frequency
    ridge = f[above][np.argmax(power[above], axis=0)]
    return {
        name: _fit_exponent(end - t, ridge, max_length)
        for name, max_length in FIT_LENGTH_S.items()
    }


def _fit_exponent(remaining, ridge, max_length):
    """Return the exponent of an unweighted fit of log Omega against log(remaining
    time)."""
    within = (remaining > 0.02) & (remaining < max_length)  # s
    if within.sum() < 8:
        return Exponent(np.nan, np.nan, int(within.sum()))
    (slope, _), covariance = np.polyfit(
        np.log(remaining[within]), np.log(ridge[within]), 1, cov=True
    )
    return Exponent(float(-slope), float(covariance[0, 0] ** 0.5), int(within.sum()))
