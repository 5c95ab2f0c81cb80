"""Onset strength of a sound, the suddenness with which the power of bands rises."""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.ndimage import uniform_filter1d
from scipy.signal import butter, resample_poly, sosfilt

from sonify.hearing.mains_hum import without_hum
from sonify.hearing.settling.settings import SETTLING

FRAME_RATE = 1000  # Hz
TINY_POWER = 1e-14  # of full scale


@dataclass(frozen=True)
class Frames:
    """Power (frames, bands) and waveform (frames,) of a sound, with one frame per
    millisecond.

    `edges` (bands + 1,) are the limits of the bands [Hz].
    """

    power: np.ndarray
    waveform: np.ndarray
    edges: np.ndarray


@dataclass(frozen=True)
class OnsetStrength:
    """Channels `values` (channels, frames) that are searched for events, each with the
    time [ms] per independent sample and a band [Hz]."""

    values: np.ndarray
    scales_ms: np.ndarray
    bands: list[tuple[float, float]]


def frames_of(samples: np.ndarray, rate: float) -> Frames:
    """Return the power and the waveform of samples (n,) at `rate` [Hz]."""
    window_length = max(2 * round(rate * 4 / 3000), 8)
    window = np.hanning(window_length + 2)[1:-1]
    weights, edges = _band_weights(window_length, rate)
    count = int(len(samples) * FRAME_RATE / rate)
    centres = np.round(np.arange(count) * rate / FRAME_RATE).astype(int)
    padded = np.pad(np.asarray(samples, dtype=np.float32), window_length // 2)
    windows = sliding_window_view(padded, window_length)
    power = np.empty((count, weights.shape[1]), dtype=np.float32)
    scale = np.float32(2 / np.sum(window)) ** 2 / 2
    weights = weights.astype(np.float32) * scale
    for first in range(0, count, 4096):
        spectrum = rfft(
            windows[centres[first : first + 4096]] * window.astype(np.float32)
        )
        power[first : first + 4096] = (spectrum.real**2 + spectrum.imag**2) @ weights
    return Frames(power=power, waveform=waveform_of(samples, rate)[:count], edges=edges)


def waveform_of(samples: np.ndarray, rate: float) -> np.ndarray:
    """Return the waveform (frames,) of samples (n,) at `rate` [Hz] in its band, without
    steady tones."""
    count = int(len(samples) * FRAME_RATE / rate)
    down = max(int(rate / (4 * FRAME_RATE)), 1)
    low_rate = resample_poly(samples, 1, down)
    rate /= down
    low, high = SETTLING.waveform_band
    band = (low, min(high, SETTLING.max_frequency_per_rate * rate))
    sos = butter(2, band, "bandpass", fs=rate, output="sos")
    centres = np.round(np.arange(count) * rate / FRAME_RATE).astype(int)
    waveform = sosfilt(sos, without_hum(low_rate, rate))
    return waveform[np.minimum(centres, len(waveform) - 1)].astype(np.float32)


def _band_weights(window_length, rate):
    """Return the fraction (bins, bands) of each spectral bin in each band, and the band
    edges [Hz]."""
    edges = [700, 1000, 1400, 2000, 2800, 4000, 5600, 8000, 11200, 16000, 21000]  # Hz
    spacing = rate / window_length
    bins = np.arange(window_length // 2 + 1) * spacing
    edges = np.array(edges, dtype=float)
    edges = edges[edges <= SETTLING.max_frequency_per_rate * rate]
    low = np.maximum(bins[:, None] - spacing / 2, edges[:-1])
    high = np.minimum(bins[:, None] + spacing / 2, edges[1:])
    return np.maximum(high - low, 0) / spacing, edges


def onset_strength(frames: Frames) -> OnsetStrength:
    """Return the onset strength of all bands and of the bright ones."""
    floor_db = -40.0  # re the running mean
    min_bright_frequency = 4000.0  # Hz
    power = frames.power.T
    mean = uniform_filter1d(power, 401, axis=1)
    level = np.log(power + 10 ** (floor_db / 10) * mean + TINY_POWER)
    bright = frames.edges[:-1] >= min_bright_frequency
    groups = [np.ones_like(bright)]
    if bright.any() and not bright.all():
        groups.append(bright)
    values = []
    scales = []
    bands = []
    for scale in (3, 6, 12, 24):  # ms, the durations of bursts
        short = uniform_filter1d(level, max(round(scale / 2), 1), axis=1)
        rise = normalised(short - uniform_filter1d(level, 8 * scale + 1, axis=1))
        for group in groups:
            values.append(normalised(rise[group].mean(axis=0)))
            scales.append(scale)
            bands.append(
                (float(frames.edges[:-1][group][0]), float(frames.edges[1:][group][-1]))
            )
    return OnsetStrength(
        np.array(values, dtype=np.float32),
        np.array(scales, dtype=float),
        bands,
    )


def tone_strength(waveform: np.ndarray) -> OnsetStrength:
    """Return the normalised waveform (frames,) as the only channel."""
    time_per_sample = 8.0  # ms
    return OnsetStrength(
        normalised(waveform)[None].astype(np.float32),
        np.array([time_per_sample]),
        [SETTLING.waveform_band],
    )


def normalised(values):
    """Return values (..., n) divided by their running rms over 0.3 s, clipped to -3 and
    6."""
    deviation = np.sqrt(
        np.maximum(uniform_filter1d(np.square(values), 301, axis=-1), 0)
    )
    silent = deviation <= 1e-9
    return np.where(silent, 0, np.clip(values / np.where(silent, 1, deviation), -3, 6))
