"""Claim: the frames of a sound hold its power in each band, once per millisecond.

Source: sonify/hearing/settling/onset_strength.py. Oracle: the mean square of a sine, times the noise
bandwidth of a Hann window, 1.5 bins, because the power is the sum over bins.
"""

import numpy as np
import pytest

from sonify.hearing.settling.onset_strength import Frames

RATE = 48_000
T = np.arange(RATE) / RATE


@pytest.mark.parametrize("frequency", [1200.0, 3300.0, 9000.0])
def test_the_power_of_a_sine_is_in_its_band(frequency):
    frames = Frames(0.4 * np.sin(2 * np.pi * frequency * T), RATE)
    inner = frames.power[50:-50].mean(axis=0)
    band = np.searchsorted(frames.edges, frequency) - 1
    assert len(frames.power) == 1000
    assert inner.argmax() == band
    assert inner.sum() == pytest.approx(1.5 * 0.4**2 / 2, rel=0.05)


def test_a_burst_is_in_its_frames_alone():
    burst = (T > 0.5) & (T < 0.51)
    frames = Frames(np.sin(2 * np.pi * 5000 * T) * burst, RATE)
    total = frames.power.sum(axis=1)
    assert total[500:510].mean() == pytest.approx(1.5 * 0.5, rel=0.1)
    assert total[:495].max() < 1e-6
    assert total[515:].max() < 1e-6
