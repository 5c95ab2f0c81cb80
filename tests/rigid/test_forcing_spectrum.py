"""Claim: the spectrum of the normal force is a line at the nutation frequency and a 1/f tail of the
jumps at stick/slip transitions; the line passes 36 Hz at 14.84 s.

Source: footnote 3 and section 7 of the paper. Oracle: Fourier spectra of the sampled force; the
sizes of the jumps, whose spectrum is jump/(2 pi f).
"""

import numpy as np
import pytest

from dynamics.observables import nutation_frequency

SAMPLE_RATE = 65536  # Hz
WINDOWS = [(5.0, 2.0), (10.0, 2.0), (15.0, 1.0), (18.0, 0.5)]
"""Centre and width [s] of each window."""


def windowed(motion, centre, width):
    """Return times [s], Hann window, and the normal force over the weight at these times."""
    count = int(width * SAMPLE_RATE)
    t = centre + (np.arange(count) - count / 2) / SAMPLE_RATE
    return t, np.hanning(count), motion.force(t)[:, 2] / motion.disk.weight


def spectrum(window, load, length):
    """Return frequency [Hz] and magnitude of the windowed load without its mean, padded to
    `length`."""
    centred = (load - np.average(load, weights=window)) * window
    magnitude = np.abs(np.fft.rfft(centred, length)) / SAMPLE_RATE
    return np.fft.rfftfreq(length, 1 / SAMPLE_RATE), magnitude


@pytest.mark.parametrize(("centre", "width"), WINDOWS)
def test_the_line_of_the_normal_force_is_at_the_nutation_frequency(
    motion, centre, width
):
    t, window, load = windowed(motion, centre, width)
    frequency, magnitude = spectrum(window, load, 8 * len(t))
    strongest = frequency[(magnitude * (frequency > 3.0)).argmax()]
    nutation = np.interp(centre, *nutation_frequency(motion))
    assert strongest == pytest.approx(nutation, rel=0.05)


def test_the_line_passes_36_hz_at_14_84_s(motion):
    t, frequency = nutation_frequency(motion)
    reached = t[np.argmax(frequency * motion.disk.time_unit >= 2.5)]
    assert reached == pytest.approx(14.84, abs=0.14)
    assert 2.5 / motion.disk.time_unit == pytest.approx(36.0, abs=0.5)


@pytest.mark.parametrize(("centre", "width"), WINDOWS)
def test_the_tail_is_that_of_the_jumps(motion, centre, width):
    """A jump of size J has the magnitude J/(2 pi f); jumps at irregular times add in power."""
    t, window, load = windowed(motion, centre, width)
    frequency, magnitude = spectrum(window, load, len(t))
    here = (motion.jumps.t > t[0]) & (motion.jumps.t < t[-1])
    size = (motion.jumps.after - motion.jumps.before)[here, 2] / motion.disk.weight
    expected = np.linalg.norm(size * np.interp(motion.jumps.t[here], t, window))
    for lowest in (200.0, 400.0, 800.0, 1600.0, 3200.0):
        octave = (frequency > lowest) & (frequency < 2 * lowest)
        level = 2 * np.pi * frequency[octave] * magnitude[octave]
        assert np.sqrt(np.mean(level**2)) == pytest.approx(expected, rel=0.08)
