"""Synthetic phone recordings of a disk whose decay is known, with noise and other defects."""

from dataclasses import dataclass

import numpy as np
from scipy.signal import butter, sosfilt

from sonify.fitting.decay_model import DecayModel


@dataclass(frozen=True, kw_only=True)
class Take:
    """Properties of a recording of a disk that sounds from `start` to `end` [s]."""

    end: float = 12.0
    duration: float = 14.0
    rate: int = 44100
    noise: float = 0.1
    """Standard deviation of white noise relative to the largest amplitude of the tone."""
    hum: float = 0.0
    """Relative amplitude at 50 Hz."""
    clicks: int = 0
    start: float = 0.0
    high_pass: float = 0.0
    bits: int | None = None
    seed: int = 0


def recording(decay: DecayModel, shares, **properties) -> np.ndarray:
    """Return samples (n,) of a disk, with the properties of a `Take`.

    The tone has two harmonics and modulates noise above 2 kHz.
    """
    take = Take(**properties)
    random = np.random.default_rng(take.seed)
    t = np.arange(int(take.duration * take.rate)) / take.rate
    sounding = (t > take.start) & (t < take.end - 2 / take.rate)
    left = take.end - t[sounding]
    turns, frequency = decay.turns(left, shares)
    loud = np.minimum(frequency / frequency[np.argmin(np.abs(left - 0.1))], 1.0)
    phase = -2 * np.pi * turns + random.uniform(0, 2 * np.pi)
    hiss = sosfilt(
        butter(4, 2000.0, "highpass", fs=take.rate, output="sos"),
        random.standard_normal(len(t)),
    )[sounding]
    out = np.zeros(len(t))
    tone = np.cos(phase) + 0.4 * np.cos(2 * phase + 1) + 0.2 * np.cos(3 * phase + 2)
    out[sounding] = loud * (tone + 0.3 * (1 + 0.8 * np.cos(phase + 0.5)) * hiss)
    out += take.noise * random.standard_normal(len(t))
    out += take.hum * np.sin(2 * np.pi * 50 * t + random.uniform(0, 6))
    for place in random.integers(0, len(t), take.clicks):
        click = out[place : place + 40]
        click += 3 * np.exp(-np.arange(len(click)) / 8) * random.choice([-1, 1])
    if take.high_pass:
        high_pass = butter(2, take.high_pass, "highpass", fs=take.rate, output="sos")
        out = sosfilt(high_pass, out)
    out *= 0.8 / np.abs(out).max()
    if take.bits is None:
        return out
    levels = 2 ** (take.bits - 1)
    return np.round(out * levels) / levels
