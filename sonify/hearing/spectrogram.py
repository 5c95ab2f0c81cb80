"""WAV -> SPECTROGRAM: levels over time and frequency, read block by block from a file of any length."""

from dataclasses import dataclass
from math import inf
from pathlib import Path

import numpy as np
import soundfile
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.signal import get_window

MOST_COLUMNS = 1600
"""A longer file is looked at in as many places, with gaps between them."""
GROUP = 64
"""So many windows are read and transformed at once."""
REFERENCE_PRESSURE = 20e-6
"""0 dB of sound pressure level [Pa]."""


@dataclass(frozen=True, kw_only=True)
class Spectrogram:
    """`power` (f, t): mean square of a sine at `frequency` (f,) [Hz] in a window around `time` (t,) [s], units
    squared."""

    time: np.ndarray
    frequency: np.ndarray
    power: np.ndarray

    def level_db(self, reference: float) -> np.ndarray:
        """Return the level (f, t) [dB] of the root mean square over `reference`; -200 where there is nothing."""
        return 10 * np.log10(np.maximum(self.power / np.float32(reference**2), np.float32(1e-20)))

    def band(self, low: float, high: float) -> "Spectrogram":
        """Return the part from low to high [Hz]."""
        keep = (self.frequency >= low) & (self.frequency <= high)
        return Spectrogram(time=self.time, frequency=self.frequency[keep], power=self.power[keep])

    def during(self, begin: float, end: float) -> "Spectrogram":
        """Return the part from begin to end [s], and one window more on each side."""
        part = slice(max(np.searchsorted(self.time, begin) - 1, 0), np.searchsorted(self.time, end) + 1)
        return Spectrogram(time=self.time[part], frequency=self.frequency, power=self.power[:, part])


def spectrogram(path: str | Path, window: float, columns: int = MOST_COLUMNS, span=(0.0, inf)) -> Spectrogram:
    """Return the spectrogram of a sound file with Hann windows of `window` [s], the mean power of its channels.

    Windows overlap by three quarters, in a long file by less: there are at most `columns`. Only the part within `span`
    [s] is read. A part shorter than the window is padded with silence. Memory does not grow with the length.
    """
    with soundfile.SoundFile(path) as file:
        rate, size = file.samplerate, max(int(window * file.samplerate), 16)
        first, last = int(span[0] * rate), int(min(span[1] * rate, file.frames))
        hop = max(size // 4, -(-(last - first) // columns))
        starts = np.arange(first, max(last - size, first) + 1, hop)
        shape = get_window("hann", size).astype(np.float32)
        groups = np.array_split(starts, -(-len(starts) // GROUP))
        power = np.vstack([_power(_frames(file, group, size, hop) * shape) for group in groups]).T
    frequency = np.fft.rfftfreq(size, 1 / rate)
    return Spectrogram(time=(starts + size / 2) / rate, frequency=frequency, power=power * 2 / float(shape.sum()) ** 2)


def _power(frames):
    spectra = rfft(frames, axis=2)
    return (spectra.real**2 + spectra.imag**2).mean(axis=1)


def _frames(file, starts, size, hop):
    """The windows (t, channels, size) that begin at `starts` (t,), `hop` apart, read at once; zeros after the end."""
    file.seek(starts[0])
    samples = file.read(starts[-1] - starts[0] + size, "float32", always_2d=True, fill_value=0.0)
    return sliding_window_view(samples, size, axis=0)[::hop]
