"""AIR -> LISTENER: what air takes of a sound on its way, by ISO 9613-1, as one filter for all that a listener hears."""

import numpy as np
from scipy.signal import oaconvolve

HIGHEST, AUDIBLE_DB = 20e3, 0.5
"""Absorption is filtered where it takes as much as that [dB] at this frequency [Hz]: no less can be told by ear."""
HALF = 64
"""Half the length of the filter [samples]."""


def absorbed_db(air, distance: float, frequency=HIGHEST):
    """Return what `air` takes of a sound on `distance` [m] at a frequency [Hz], or at several (k,) [dB]."""
    return air.absorption(frequency) * distance if air.pressure else 0.0 * frequency


def reach(air, distance: float) -> int:
    """Return by how many samples what the filter returns is late: 0 where none is needed."""
    return HALF if absorbed_db(air, distance) >= AUDIBLE_DB else 0


def absorbing(air, distance: float, sample_rate: float):
    """Return advance(stems (k, s)) -> stems (k, s), `reach` samples late, of blocks that follow on stillness.

    The filter has no phase: of the spread of a sound by viscosity that is exact, and the dispersion by the relaxation
    of oxygen and nitrogen is below what they take, a radian to 8.7 dB. tests/test_absorption.py.
    """
    if not reach(air, distance):
        return lambda stems: stems
    gain = 10 ** (-absorbed_db(air, distance, np.fft.rfftfreq(2 * HALF, 1 / sample_rate)) / 20)
    taps = np.roll(np.fft.irfft(gain), HALF)
    taps, past = np.append(taps, taps[0])[:, None], None
    taps[[0, -1]] /= 2  # the sample farthest off lies half on either side

    def advance(stems):
        nonlocal past
        past = np.vstack([np.repeat(stems[:1], 2 * HALF, axis=0) if past is None else past, stems])
        out, past = oaconvolve(past, taps, "valid", axes=0), past[len(stems) :]
        return out

    return advance
