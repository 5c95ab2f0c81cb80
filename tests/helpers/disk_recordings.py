"""Synthetic phone recordings of a disk whose decay is known, with noise and other defects."""

import numpy as np
from scipy.signal import butter, sosfilt

from sonify.fitting.decay_model import DecayModel


def recording(
    decay: DecayModel,
    shares,
    *,
    end: float = 12.0,
    duration: float = 14.0,
    rate: int = 44100,
    noise: float = 0.1,
    hum: float = 0.0,
    clicks: int = 0,
    start: float = 0.0,
    high_pass: float = 0.0,
    bits: int | None = None,
    seed: int = 0,
) -> np.ndarray:
    """Return samples (n,) of a disk that sounds from `start` to `end` [s].

    The tone has two harmonics and modulates noise above 2 kHz. `noise` is the standard deviation of
    white noise relative to the largest amplitude of the tone, and `hum` the relative amplitude at
    50 Hz.
    """
    random = np.random.default_rng(seed)
    t = np.arange(int(duration * rate)) / rate
    sounding = (t > start) & (t < end - 2 / rate)
    left = end - t[sounding]
    turns, frequency = decay.turns(left, shares)
    loud = np.minimum(frequency / frequency[np.argmin(np.abs(left - 0.1))], 1.0)
    phase = -2 * np.pi * turns + random.uniform(0, 2 * np.pi)
    hiss = sosfilt(
        butter(4, 2000.0, "highpass", fs=rate, output="sos"),
        random.standard_normal(len(t)),
    )[sounding]
    out = np.zeros(len(t))
    tone = np.cos(phase) + 0.4 * np.cos(2 * phase + 1) + 0.2 * np.cos(3 * phase + 2)
    out[sounding] = loud * (tone + 0.3 * (1 + 0.8 * np.cos(phase + 0.5)) * hiss)
    out += noise * random.standard_normal(len(t))
    out += hum * np.sin(2 * np.pi * 50 * t + random.uniform(0, 6))
    for place in random.integers(0, len(t), clicks):
        out[place : place + 40] += (
            3
            * np.exp(-np.arange(len(out[place : place + 40])) / 8)
            * random.choice([-1, 1])
        )
    if high_pass:
        out = sosfilt(butter(2, high_pass, "highpass", fs=rate, output="sos"), out)
    out *= 0.8 / np.abs(out).max()
    return out if bits is None else np.round(out * 2 ** (bits - 1)) / 2 ** (bits - 1)
