"""WAV -> SPECTROGRAM: levels over time and frequency, read block by block from a file of any length."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import get_window

MOST_COLUMNS = 1600
"""A longer file is looked at in as many places, with gaps between them."""
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
        return 10 * np.log10(np.maximum(self.power / reference**2, 1e-20))

    def band(self, low: float, high: float) -> "Spectrogram":
        """Return the part from low to high [Hz]."""
        keep = (self.frequency >= low) & (self.frequency <= high)
        return Spectrogram(time=self.time, frequency=self.frequency[keep], power=self.power[keep])


def spectrogram(path: str | Path, window: float, columns: int = MOST_COLUMNS) -> Spectrogram:
    """Return the spectrogram of a sound file with Hann windows of `window` [s], channels averaged.

    Windows overlap by three quarters, in a long file by less: there are at most `columns`. A file shorter than the
    window is padded with silence. Memory does not grow with the length.
    """
    with soundfile.SoundFile(path) as file:
        size = max(int(window * file.samplerate), 16)
        hop = max(size // 4, -(-file.frames // columns))
        starts = np.arange(0, max(file.frames - size, 0) + 1, hop)
        shape = get_window("hann", size)
        power = np.array([_power(_read(file, start, size) * shape) for start in starts]).T
        frequency = np.fft.rfftfreq(size, 1 / file.samplerate)
        return Spectrogram(
            time=(starts + size / 2) / file.samplerate, frequency=frequency, power=power * 2 / shape.sum() ** 2
        )


def _power(samples):
    return np.abs(np.fft.rfft(samples)) ** 2


def _read(file, start, size):
    file.seek(start)
    samples = file.read(size, always_2d=True, fill_value=0.0)
    return samples.mean(axis=1)
