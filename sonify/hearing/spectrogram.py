"""Spectrograms of sounds of any length, computed in blocks."""

from dataclasses import dataclass
from itertools import islice
from math import inf
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from sonify.hearing.audio_source import (
    BLOCK_SIZE,
    AudioSource,
    overlapping_pieces,
    source_of,
)

CONTACT_RATE_BAND_HZ = (5.0, 1000.0)
"""Frequency range of the precession and nutation of the contact."""
CONTACT_RATE_WINDOW_S = 0.2
"""Window length that resolves the contact rates."""
MODE_WINDOW_S = 0.02
"""Window length for the frequency range of the vibration modes."""
REFERENCE_PRESSURE_PA = 20e-6
"""Reference pressure of the sound pressure level, i.e. that of 0 dB."""


@dataclass(frozen=True, kw_only=True)
class Spectrogram:
    """Mean square `power` (f, t) of sines at `frequency` (f,) [Hz] in windows around
    `time` (t,) [s]."""

    time: np.ndarray
    frequency: np.ndarray
    power: np.ndarray

    def level_db(self, reference: float) -> np.ndarray:
        """Return the level (f, t) [dB] of the rms relative to `reference`, at least
        -200."""
        return 10 * np.log10(
            np.maximum(self.power / np.float32(reference**2), np.float32(1e-20))
        )

    def band(self, low: float, high: float) -> "Spectrogram":
        """Return the part from `low` to `high` [Hz]."""
        keep = (self.frequency >= low) & (self.frequency <= high)
        return Spectrogram(
            time=self.time, frequency=self.frequency[keep], power=self.power[keep]
        )

    def during(self, begin: float, end: float) -> "Spectrogram":
        """Return the part from `begin` to `end` [s], with one more column on each
        side."""
        part = slice(
            max(np.searchsorted(self.time, begin) - 1, 0),
            np.searchsorted(self.time, end) + 1,
        )
        return Spectrogram(
            time=self.time[part], frequency=self.frequency, power=self.power[:, part]
        )


def spectrogram(
    sound: AudioSource | str | Path,
    window: float,
    columns: int = 1600,
    span: tuple[float, float] = (0.0, inf),
) -> Spectrogram:
    """Return the spectrogram of a source or file with Hann windows of `window` [s].

    The power is averaged over the channels. Successive windows overlap by 75 %, or less
    in a long sound, so that there are at most `columns` windows. Only the part within
    `span` [s] is analysed; a part shorter than the window is padded with silence.
    Memory use does not depend on the length of the sound."""
    source = source_of(sound)
    rate = source.sample_rate
    size = max(int(window * rate), 16)
    first = int(span[0] * rate)
    last = int(min(span[1] * rate, source.frames))
    hop = max(size // 4, -(-(last - first) // columns))
    count = max(last - size - first, 0) // hop + 1
    group_size = max(BLOCK_SIZE // hop, 1)
    weights = 1 - np.cos(2 * np.pi * np.arange(size) / size)
    weights = (weights / weights.sum()).astype(np.float32)
    parts = islice(
        overlapping_pieces(source, group_size * hop, max(size - hop, 0), first),
        -(-count // group_size),
    )
    power = np.concatenate([_power(part, weights, hop) for part in parts])[:count]
    return Spectrogram(
        time=(first + hop * np.arange(count) + size / 2) / rate,
        frequency=np.fft.rfftfreq(size, 1 / rate),
        power=np.ascontiguousarray(power.T),
    )


def _power(samples: np.ndarray, weights: np.ndarray, hop: int) -> np.ndarray:
    """Return mean squares (t, f) of sines in weighted windows of samples (n, c), `hop`
    samples apart.

    The mean squares are averaged over the channels. Single precision halves the time;
    levels 130 dB below the loudest are lost."""
    from scipy.fft import rfft  # slow to import, and not needed to draw a spectrogram

    windows = sliding_window_view(samples, len(weights), axis=0)[::hop]
    spectrum = rfft(windows * weights)
    return 2 * np.mean(spectrum.real**2 + spectrum.imag**2, axis=1).astype(np.float32)
