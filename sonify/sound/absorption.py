"""Filter the stems for atmospheric absorption (ISO 9613-1) and scattering by a head."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from scipy.signal import oaconvolve

from dynamics.solver_settings import MAX_AUDIBLE_FREQUENCY
from sonify.sound.block_overlap import overlapping_blocks
from sonify.sound.head import EAR_LATENCY, ear_taps
from sonify.sound.radiation import Listener

if TYPE_CHECKING:
    from dynamics.air import Air

MIN_AUDIBLE_ABSORPTION_DB = 0.5
"""Absorption [dB] at MAX_AUDIBLE_FREQUENCY below which it is inaudible and the filter
is omitted."""


def absorbed_db(
    air: "Air", distance: float, frequency: float | np.ndarray = MAX_AUDIBLE_FREQUENCY
) -> float | np.ndarray:
    """Return the absorption [dB] over `distance` [m] at a frequency [Hz], scalar or
    (k,)."""
    return air.absorption(frequency) * distance if air.pressure else 0.0 * frequency


def absorption_latency(air: "Air", distance: float) -> int:
    """Return the latency of the absorption filter, half its length [samples], or 0 if
    no filter is needed."""
    half_length = 64
    is_audible = absorbed_db(air, distance) >= MIN_AUDIBLE_ABSORPTION_DB
    return half_length if is_audible else 0


def absorption_taps(air: "Air", distance: float, sample_rate: float) -> np.ndarray:
    """Return the taps (j,) of the absorption filter, delayed by `absorption_latency`.

    The filter has linear phase, which is exact for viscous absorption. The relaxation
    of oxygen and nitrogen also causes dispersion. It is neglected because the phase
    shift in radians is smaller than the attenuation in nepers. See
    tests/sound/test_air_absorption.py."""
    half = absorption_latency(air, distance)
    if not half:
        return np.ones(1)
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


def propagation_filter(
    listener: Listener, sample_rate: float
) -> Callable[[np.ndarray], np.ndarray]:
    """Return a function that filters successive blocks by absorption and head
    scattering.

    The blocks of stems (k, s) are delayed by `propagation_latency`."""
    taps = absorption_taps(listener.air, listener.distance, sample_rate)
    if listener.ear:
        head = ear_taps(listener.ear, sample_rate, listener.air.sound_speed)
        taps = np.convolve(taps, head)
    if len(taps) == 1:
        return lambda stems: stems
    extend = overlapping_blocks(len(taps) - 1)
    return lambda stems: oaconvolve(extend(stems), taps[:, None], "valid", axes=0)
