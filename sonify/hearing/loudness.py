"""A-weighting, threshold of hearing and loudness of a sound pressure."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from dynamics.a_weighting import a_weighting_db as a_weighting_db
from sonify.hearing.audio_source import AudioSource, read_samples, source_of
from sonify.hearing.spectrogram import REFERENCE_PRESSURE_PA, Spectrogram, spectrogram

# fmt: off
ISO_226_THRESHOLD_DB = {
    20: 78.5, 25: 68.7, 31.5: 59.5, 40: 51.1, 50: 44.0, 63: 37.5, 80: 31.5, 100: 26.5,
    125: 22.1, 160: 17.9, 200: 14.4, 250: 11.4, 315: 8.6, 400: 6.2, 500: 4.4, 630: 3.0,
    800: 2.2, 1000: 2.4, 1250: 3.5, 1600: 1.7, 2000: -1.3, 2500: -4.2, 3150: -6.0, 4000: -5.4,
    5000: -1.5, 6300: 6.0, 8000: 12.6, 10000: 13.9, 12500: 12.3,
}
# fmt: on
"""Threshold of hearing T_f for pure tones in a free field [dB re 20 uPa] by frequency
[Hz], ISO 226:2003, table 1."""
HEARING_THRESHOLD_DB = np.array(list(ISO_226_THRESHOLD_DB.values()))
"""Threshold of hearing in the third-octave bands of ISO 226 [dB re 20 uPa]."""
HANN_NOISE_BANDWIDTH_BINS = 1.5
"""Equivalent noise bandwidth of a Hann window."""
LEVEL_WINDOW_S = 0.4
"""Window length that resolves the third-octave bands at 20 and 25 Hz."""


@dataclass(frozen=True, kw_only=True)
class Audibility:
    """Audibility at times `time` (t,) [s].

    `a_weighted` (t,) is the A-weighted level [dB re 20 uPa]. `above_threshold` (t,) is
    the largest level of a third-octave band above the threshold of hearing [dB]; it is
    negative if the sound is inaudible."""

    time: np.ndarray
    a_weighted: np.ndarray
    above_threshold: np.ndarray


def audibility(pressure: AudioSource | str | Path) -> Audibility:
    """Return the audibility of a pressure [Pa] in successive windows, for frequencies
    above 20 Hz."""
    spectrum = spectrogram(pressure, LEVEL_WINDOW_S, columns=600)
    weighted = 10 ** (a_weighting_db(spectrum.frequency) / 10) @ spectrum.power
    above_threshold = levels_above_threshold(spectrum)
    return Audibility(
        time=spectrum.time,
        a_weighted=level_db(weighted / HANN_NOISE_BANDWIDTH_BINS),
        above_threshold=above_threshold.max(axis=0),
    )


def band_levels(spectrum: Spectrogram) -> np.ndarray:
    """Return the levels (29, t) [dB re 20 uPa] of a spectrogram in the third-octave
    bands of ISO 226."""
    edges = 1000 * 10 ** ((np.arange(30) - 17.5) / 10)  # base 10, IEC 61260
    low = np.searchsorted(spectrum.frequency, edges[:-1])
    high = np.searchsorted(spectrum.frequency, edges[1:])
    power = np.array(
        [
            spectrum.power[a : max(b, a + 1)].sum(axis=0)
            for a, b in zip(low, high, strict=True)
        ]
    )
    return level_db(power / HANN_NOISE_BANDWIDTH_BINS)


def levels_above_threshold(spectrum: Spectrogram) -> np.ndarray:
    """Return the levels (29, t) of third-octave bands relative to the threshold of
    hearing [dB]."""
    return band_levels(spectrum) - HEARING_THRESHOLD_DB[:, None]


def level_db(mean_square: ArrayLike) -> np.ndarray:
    """Return the level [dB re 20 uPa] of mean-square pressures [Pa^2], at least
    -200."""
    return 10 * np.log10(
        np.maximum(np.asarray(mean_square) / REFERENCE_PRESSURE_PA**2, 1e-20)
    )


def loudness_lufs(sound: AudioSource | str | Path) -> float:
    """Return the integrated loudness [LUFS] of a source or file by ITU-R BS.1770
    (pyloudnorm).

    The loudness is that of the last ten minutes; it is -inf for silence. Raises
    ValueError for a sound shorter than 0.4 s, the length of a gating block."""
    from pyloudnorm import Meter

    source = source_of(sound)
    rate = source.sample_rate
    frames = source.frames
    if frames < 0.4 * rate:
        raise ValueError("the loudness requires at least 0.4 s of sound")
    return float(
        Meter(rate).integrated_loudness(
            read_samples(source, max(frames - 600 * rate, 0), frames)[:, :5]
        )
    )
