"""Levels of a sound above the threshold of hearing, by time and third-octave band."""

from typing import NamedTuple

import numpy as np

from sonify.hearing.audio_source import AudioSource
from sonify.hearing.loudness import (
    ISO_226_THRESHOLD_DB,
    LEVEL_WINDOW_S,
    levels_above_threshold,
)
from sonify.hearing.spectrogram import spectrogram


class AudibleLevels(NamedTuple):
    """Third-octave levels above the threshold of hearing.

    Attributes
    ----------
    time : ndarray, shape (t,)
        Middles of the windows [s].
    above : ndarray, shape (29, t)
        Levels above the threshold [dB] in the bands of ISO 226.
    """

    time: np.ndarray
    above: np.ndarray

    def at(self, time: np.ndarray, frequency: np.ndarray) -> np.ndarray:
        """Return the level above the threshold (n,) [dB] in the bands of frequencies
        (n,) [Hz], in the windows nearest to times (n,) [s]."""
        bands = np.log(list(ISO_226_THRESHOLD_DB))
        band = np.abs(np.log(frequency)[:, None] - bands).argmin(axis=1)
        middles = (self.time[1:] + self.time[:-1]) / 2
        return self.above[band, np.searchsorted(middles, time)]

    def audible_between(self, begin: float, end: float) -> bool:
        """Return True if a band exceeds the threshold between two times [s]."""
        inside = (self.time >= begin) & (self.time <= end)
        return bool((self.above[:, inside] > 0).any())


def audible_levels(sound: AudioSource, end: float) -> AudibleLevels:
    """Return the levels of a pressure [Pa] up to a time [s]."""
    seen = spectrogram(sound, LEVEL_WINDOW_S / 4, span=(0.0, end))
    return AudibleLevels(seen.time, levels_above_threshold(seen))
