"""Spectrograms of sounds of any length, computed in blocks."""

from dataclasses import dataclass
from itertools import islice
from math import inf
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from sonify.hearing.audio_source import BLOCK, Source, pieces, source_of

MOST_COLUMNS = 1600
"""Largest number of columns; in longer sounds there are gaps between the windows."""
RATES, WINDOW_RATES = (5.0, 1000.0), 0.2
"""Frequency range of the contact rates [Hz], and the window for it [s]."""
WINDOW_MODES = 0.02
"""Window for the frequency range of the modes [s]."""
REFERENCE_PRESSURE = 20e-6
"""Pressure of 0 dB sound pressure level [Pa]."""


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
    sound: Source | str | Path,
    window: float,
    columns: int = MOST_COLUMNS,
    span=(0.0, inf),
) -> Spectrogram:
    """Return the spectrogram of a source or file with Hann windows of `window` [s].

    The power is averaged over the channels. Successive windows overlap by 75 %, or less
    in a long sound, so that there are at most `columns` windows. Only the part within
    `span` [s] is analysed; a part shorter than the window is padded with silence.
    Memory use does not depend on the length of the sound."""
    source = source_of(sound)
    rate = source.sample_rate
    size = max(int(window * source.sample_rate), 16)
    first = int(span[0] * rate)
    last = int(min(span[1] * rate, source.frames))
    hop = max(size // 4, -(-(last - first) // columns))
    count = max(last - size - first, 0) // hop + 1
    group = max(BLOCK // hop, 1)
    shape = 1 - np.cos(2 * np.pi * np.arange(size) / size)
    shape = (shape / shape.sum()).astype(np.float32)
    parts = islice(
        pieces(source, group * hop, max(size - hop, 0), first), -(-count // group)
    )
    power = np.concatenate([_power(part, shape, hop) for part in parts])[:count]
    return Spectrogram(
        time=(first + hop * np.arange(count) + size / 2) / rate,
        frequency=np.fft.rfftfreq(size, 1 / rate),
        power=np.ascontiguousarray(power.T),
    )


def _power(samples, shape, hop):
    """Return mean squares (t, f) of sines in windows of samples (n, c) at intervals of
    `hop`.

    The mean squares are averaged over the channels. Single precision halves the time;
    levels 130 dB below the loudest are lost."""
    from scipy.fft import rfft  # slow to import, and not needed to draw a spectrogram

    seen = rfft(sliding_window_view(samples, len(shape), axis=0)[::hop] * shape)
    return 2 * np.mean(seen.real**2 + seen.imag**2, axis=1).astype(np.float32)
