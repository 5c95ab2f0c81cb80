"""Compute errors of the samples and the third-octave levels of a sound relative to a
reference."""

import numpy as np

from sonify.hearing.audio_source import read_samples, source_of
from sonify.hearing.loudness import (
    HEARING_THRESHOLD_DB,
    LEVEL_WINDOW_S,
    a_weighting_db,
    band_levels,
)
from sonify.hearing.spectrogram import spectrogram


def audible_error(sound, reference, weighted: bool = True) -> float:
    """Return the rms difference of two sources or files relative to the rms of the
    reference.

    Both are A-weighted if `weighted` is True. Zeros pad the shorter one. Raises
    ValueError if the sample rates differ.
    """
    one = source_of(sound)
    true = source_of(reference)
    if one.sample_rate != true.sample_rate:
        raise ValueError(
            f"sample rates differ: {one.sample_rate} Hz and {true.sample_rate} Hz"
        )
    a, b = (
        read_samples(source, 0, source.frames)[:, 0].astype(float)
        for source in (one, true)
    )
    size = max(len(a), len(b))
    weight = (
        10 ** (a_weighting_db(np.fft.rfftfreq(size, 1 / one.sample_rate)) / 20)
        if weighted
        else 1.0
    )
    spectrum = np.fft.rfft(b, size)
    apart = np.linalg.norm(weight * (np.fft.rfft(a, size) - spectrum))
    return float(apart / (np.linalg.norm(weight * spectrum) or 1.0))


def level_error(sound, reference) -> float:
    """Return the relative rms error of the third-octave levels over all windows; 0.12
    corresponds to 1 dB.

    Levels below the threshold of hearing (ISO 226) are raised to the threshold. Bands
    inaudible in both sounds are ignored.
    """
    a, b = (
        band_levels(spectrogram(source, LEVEL_WINDOW_S))
        for source in (sound, reference)
    )
    count = min(a.shape[1], b.shape[1])
    a, b = (
        np.maximum(levels[:, :count], HEARING_THRESHOLD_DB[:, None])
        for levels in (a, b)
    )
    heard = np.maximum(a, b) > HEARING_THRESHOLD_DB[:, None]
    return (
        float(np.sqrt(np.mean(np.square(a - b)[heard])) * np.log(10) / 20)
        if heard.any()
        else 0.0
    )
