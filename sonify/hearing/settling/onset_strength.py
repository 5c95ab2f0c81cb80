"""Onset strength of a sound, the suddenness with which the power of bands rises."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft
from scipy.ndimage import uniform_filter1d
from scipy.signal import butter, resample_poly, sosfilt

from sonify.hearing.mains_hum import without_hum
from sonify.hearing.settling.settings import SETTLING

FRAME_RATE = 1000  # Hz
TINY_POWER = 1e-14  # of full scale
NARROW_SCALE_MS = 6
"""Duration of bursts that are also sought in narrow bands."""


@dataclass(frozen=True, eq=False)
class Frames:
    """Samples (n,) at `rate` [Hz] as one frame per millisecond; each part is computed when
    it is first read."""

    samples: np.ndarray
    rate: float

    @property
    def edges(self) -> np.ndarray:
        """Limits (bands + 1,) of the bands [Hz]."""
        limits = [700, 1000, 1400, 2000, 2800, 4000, 5600, 8000, 11200, 16000, 21000]
        edges = np.array(limits, dtype=float)
        return edges[edges <= self._highest]

    @property
    def narrow_edges(self) -> np.ndarray:
        """Limits (narrow bands + 1,) of the narrow bands [Hz]."""
        low, high = 4000.0, 16000.0  # Hz
        width = 250.0  # Hz, about the resolution of the window
        return np.arange(low, max(min(high, self._highest), low) + 1, width)

    @cached_property
    def power(self) -> np.ndarray:
        """Power (frames, bands)."""
        length = max(2 * round(self.rate * 4 / 3000), 8)
        return _band_power(self.samples, self.rate, length, self.edges)

    @cached_property
    def narrow_power(self) -> np.ndarray:
        """Power (frames, narrow bands) in longer windows and narrow bands."""
        length = 2 * round(self.rate * NARROW_SCALE_MS / 2000)
        return _band_power(self.samples, self.rate, length, self.narrow_edges)

    @cached_property
    def waveform(self) -> np.ndarray:
        """Waveform (frames,) in its band, without steady tones."""
        return waveform_of(self.samples, self.rate)

    @property
    def _highest(self) -> float:
        return SETTLING.max_frequency_per_rate * self.rate


@dataclass(frozen=True)
class OnsetStrength:
    """Channels that are searched for events: for each its components (components,
    frames), which follow one law with independent waveforms, the time [ms] per
    independent sample, and a band [Hz]."""

    values: list[np.ndarray]
    scales_ms: np.ndarray
    bands: list[tuple[float, float]]

    @property
    def channels_by_components(self) -> list[np.ndarray]:
        """Indices of the channels with one component, and of those with several."""
        is_single = np.array([len(channel) == 1 for channel in self.values])
        kinds = [np.flatnonzero(is_single), np.flatnonzero(~is_single)]
        return [kind for kind in kinds if len(kind)]


def _band_power(
    samples: np.ndarray, rate: float, window_length: int, edges: np.ndarray
) -> np.ndarray:
    """Return the power (frames, bands) of samples (n,) in bands with the given edges
    [Hz]."""
    window = np.hanning(window_length + 2)[1:-1]
    weights = _band_weights(window_length, rate, edges)
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
    return power


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


def _band_weights(window_length: int, rate: float, edges: np.ndarray) -> np.ndarray:
    """Return the fraction (bins, bands) of each spectral bin in each band between edges
    [Hz]."""
    spacing = rate / window_length
    bins = np.arange(window_length // 2 + 1) * spacing
    low = np.maximum(bins[:, None] - spacing / 2, edges[:-1])
    high = np.minimum(bins[:, None] + spacing / 2, edges[1:])
    return np.maximum(high - low, 0) / spacing


def onset_strength(frames: Frames) -> OnsetStrength:
    """Return the onset strength of all bands and of the bright ones, and of groups of
    narrow bands, which are the components of common channels."""
    min_bright_frequency = 4000.0  # Hz
    level = _log_power(frames.power)
    bright = frames.edges[:-1] >= min_bright_frequency
    groups = [np.ones_like(bright)]
    if bright.any() and not bright.all():
        groups.append(bright)
    values = []
    scales = []
    bands = []
    for scale in (3, 6, 12, 24):  # ms, the durations of bursts
        short = uniform_filter1d(level, max(round(scale / 2), 1), axis=1)
        rise = divided_by_running_rms(
            short - uniform_filter1d(level, 8 * scale + 1, axis=1)
        )
        for group in groups:
            values.append(divided_by_running_rms(rise[group].mean(axis=0))[None])
            scales.append(scale)
            bands.append(
                (float(frames.edges[:-1][group][0]), float(frames.edges[1:][group][-1]))
            )
    components = _narrow_components(frames.narrow_power)
    if len(components) > 1:
        values.append(components)
        scales.append(NARROW_SCALE_MS)
        bands.append((float(frames.narrow_edges[0]), float(frames.narrow_edges[-1])))
    return OnsetStrength(
        [channel.astype(np.float32) for channel in values],
        np.array(scales, dtype=float),
        bands,
    )


def _narrow_components(power: np.ndarray) -> np.ndarray:
    """Return the onset strength (components, frames) of groups of adjacent narrow bands
    with a power (frames, bands)."""
    bands_per_component = 4
    component_count = power.shape[1] // bands_per_component
    if component_count == 0:
        return np.empty((0, len(power)))
    level = _log_power(power)
    rise = divided_by_running_rms(
        level - uniform_filter1d(level, 8 * NARROW_SCALE_MS + 1, axis=1)
    )
    groups = np.array_split(rise, component_count)
    return divided_by_running_rms(np.array([group.mean(axis=0) for group in groups]))


def _log_power(power: np.ndarray) -> np.ndarray:
    """Return the natural logarithm (bands, frames) of a power (frames, bands), above a
    floor of -40 dB relative to its running mean."""
    floor = 1e-4 * uniform_filter1d(power.T, 401, axis=1)
    return np.log(power.T + floor + TINY_POWER)


def tone_strength(waveform: np.ndarray) -> OnsetStrength:
    """Return the normalised waveform (frames,) as the only channel."""
    time_per_sample = 8.0  # ms
    return OnsetStrength(
        [divided_by_running_rms(waveform)[None].astype(np.float32)],
        np.array([time_per_sample]),
        [SETTLING.waveform_band],
    )


def divided_by_running_rms(values: np.ndarray) -> np.ndarray:
    """Return values (..., n) divided by their running rms over 0.3 s, clipped to -3 and
    6."""
    deviation = np.sqrt(
        np.maximum(uniform_filter1d(np.square(values), 301, axis=-1), 0)
    )
    silent = deviation <= 1e-9
    return np.where(silent, 0, np.clip(values / np.where(silent, 1, deviation), -3, 6))
