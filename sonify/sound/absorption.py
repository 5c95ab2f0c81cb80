"""Apply the absorption of sound by the air (ISO 9613-1) and the scattering by a head
as one filter for all stems."""

import numpy as np
from scipy.signal import oaconvolve

from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from sonify.sound.head import EAR_LATENCY, ear_taps
from sonify.sound.radiation import Listener

MIN_AUDIBLE_ABSORPTION_DB = 0.5
"""Smallest absorption [dB] at MAX_AUDIBLE_FREQUENCY for which the filter is applied; a
smaller one is inaudible."""
FILTER_HALF_LENGTH = 64  # samples
"""Half the length of the absorption filter."""


def absorbed_db(air, distance: float, frequency=MAX_AUDIBLE_FREQUENCY):
    """Return the absorption [dB] over a distance [m] at one frequency or at several
    (k,) [Hz]."""
    return air.absorption(frequency) * distance if air.pressure else 0.0 * frequency


def absorption_latency(air, distance: float) -> int:
    """Return the latency of the absorption filter [samples], or 0 if no filter is
    needed."""
    return (
        FILTER_HALF_LENGTH
        if absorbed_db(air, distance) >= MIN_AUDIBLE_ABSORPTION_DB
        else 0
    )


def absorption_taps(air, distance: float, sample_rate: float) -> np.ndarray:
    """Return the taps (j,) of the absorption with a delay of `absorption_latency`.

    The filter has linear phase, which is exact for absorption by viscosity. The
    relaxation of oxygen and nitrogen also causes dispersion, which is neglected because
    it is smaller than their absorption (1 rad corresponds to 8.7 dB). See
    tests/sound/test_air_absorption.py."""
    if not absorption_latency(air, distance):
        return np.ones(1)
    half = FILTER_HALF_LENGTH
    gain = 10 ** (
        -absorbed_db(air, distance, np.fft.rfftfreq(2 * half, 1 / sample_rate)) / 20
    )
    taps = np.roll(np.fft.irfft(gain), half)
    taps = np.append(taps, taps[0])
    taps[[0, -1]] /= 2  # the outermost tap is split between both ends
    return taps


def propagation_latency(listener: Listener) -> int:
    """Return the latency of the propagation filter [samples]."""
    latency = absorption_latency(listener.air, listener.distance)
    return latency + (EAR_LATENCY if listener.ear else 0)


def propagation_filter(listener: Listener, sample_rate: float):
    """Return a function that filters successive blocks of stems (k, s) by absorption
    and head, with a delay of `propagation_latency`."""
    taps = absorption_taps(listener.air, listener.distance, sample_rate)
    if listener.ear:
        head = ear_taps(listener.ear, sample_rate, listener.air.sound_speed)
        taps = np.convolve(taps, head)
    if len(taps) == 1:
        return lambda stems: stems
    past = None

    def propagate(stems):
        nonlocal past
        earlier = np.repeat(stems[:1], len(taps) - 1, axis=0) if past is None else past
        past = np.vstack([earlier, stems])
        out = oaconvolve(past, taps[:, None], "valid", axes=0)
        past = past[len(stems) :]
        return out

    return propagate
