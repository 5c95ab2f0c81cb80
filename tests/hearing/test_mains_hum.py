"""Claim: steady tones are removed from a sound, and a tone that rises is not.

Source: sonify/hearing/mains_hum.py. Oracle: sums of known tones.
"""

import numpy as np
import pytest

from sonify.hearing.mains_hum import without_hum

RATE = 8000
T = np.arange(10 * RATE) / RATE


def power(samples):
    """Return the mean square, without half a second at both ends, where windows begin and end."""
    return np.mean(np.square(samples[RATE // 2 : -RATE]))


@pytest.mark.parametrize("frequency", [50.0, 150.3, 1200.0])
def test_a_steady_tone_is_removed(frequency):
    noise = 1e-3 * np.random.default_rng(0).standard_normal(len(T))
    tone = 0.5 * np.sin(2 * np.pi * frequency * T + 1.0)
    left = without_hum(tone + noise, RATE)
    assert power(left - noise) < 1e-4 * power(tone)


def test_a_rising_tone_is_kept():
    rising = np.sin(2 * np.pi * (100 * T + 20 * T**2))
    hum = 0.5 * np.sin(2 * np.pi * 50 * T)
    assert power(without_hum(rising + hum, RATE) - rising) < 1e-2 * power(rising)


def test_a_short_sound_and_a_high_tone_are_unchanged():
    short = np.sin(2 * np.pi * 50 * T[: 3 * RATE])
    assert without_hum(short, RATE) is short
    high = np.sin(2 * np.pi * 1800 * T)
    assert power(without_hum(high, RATE) - high) < 1e-6
