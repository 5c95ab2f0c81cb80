"""AIR -> LISTENER: absorption of sound by the air (ISO 9613-1), as one filter for all stems."""

import numpy as np
from scipy.signal import oaconvolve

HIGHEST_FREQUENCY = 20e3  # Hz
"""Frequency at which the absorption is compared with MIN_AUDIBLE_ABSORPTION_DB."""
MIN_AUDIBLE_ABSORPTION_DB = 0.5
"""Absorption [dB] at HIGHEST_FREQUENCY above which the filter is applied; less is inaudible."""
FILTER_HALF_LENGTH = 64  # samples
"""Half the length of the absorption filter."""


def absorbed_db(air, distance: float, frequency=HIGHEST_FREQUENCY):
    """Return the absorption [dB] over a distance [m], at one frequency or several (k,) [Hz]."""
    return air.absorption(frequency) * distance if air.pressure else 0.0 * frequency


def absorption_latency(air, distance: float) -> int:
    """Return the latency of the absorption filter [samples]; 0 where no filter is needed."""
    return FILTER_HALF_LENGTH if absorbed_db(air, distance) >= MIN_AUDIBLE_ABSORPTION_DB else 0


def absorption_filter(air, distance: float, sample_rate: float):
    """Return filter(stems (k, s)) -> stems (k, s), `absorption_latency` samples late, called once
    per block.

    The filter has linear phase. That is exact for absorption by viscosity. The dispersion by
    relaxation of oxygen and nitrogen is smaller than their absorption, with 1 rad counted as 8.7
    dB. See tests/sound/test_air_absorption.py."""
    if not absorption_latency(air, distance):
        return lambda stems: stems
    half = FILTER_HALF_LENGTH
    gain = 10 ** (-absorbed_db(air, distance, np.fft.rfftfreq(2 * half, 1 / sample_rate)) / 20)
    taps = np.roll(np.fft.irfft(gain), half)
    taps = np.append(taps, taps[0])[:, None]
    taps[[0, -1]] /= 2  # the outermost tap is split between both ends
    past = None

    def absorb(stems):
        nonlocal past
        past = np.vstack([np.repeat(stems[:1], 2 * half, axis=0) if past is None else past, stems])
        out = oaconvolve(past, taps, "valid", axes=0)
        past = past[len(stems) :]
        return out

    return absorb
