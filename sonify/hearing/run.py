"""LONG SOUND -> WHERE A DISK COMES TO REST IN IT: piece by piece, from coarse spectrograms, in the memory of one piece.

A tone that rises as (t_end - t)^-p towards its end is sought among curves of a few exponents and pitches, in the sound
itself below 500 Hz and in the power above: speech, knocks and hum are beside these curves most of the time.
"""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft

from sonify.hearing.source import Source, pieces

RATE, WINDOW, HOP = 1000, 256, 64
"""Samples a second in which a run is sought [Hz]; samples of a window, and from one to the next."""
PIECE, OVERLAP = 60.0, 30.0
"""A piece, and what it shares with the next, which is far more than any curve lasts [s]."""
LEFT, EXPONENTS, HIGHEST = np.geomspace(0.2, 10.0, 48), (0.17, 0.25, 0.33, 0.5, 0.9), 450.0
"""Times left [s] at which a curve is read, its exponents, and its pitch at the first of these [Hz] at most."""
LEAST_DB, MOST_DB, CLEAR_DB = -3.0, 15.0, 7.0
"""Bounds of what a frame contributes, and the mean along a curve from which on it is a run."""


def run_end(source: Source) -> float | None:
    """Return the time [s] at which the tone ends that rises most clearly in a sound of any length, or None."""
    rate = source.sample_rate
    down = max(round(rate / RATE), 1)
    step, overlap = (int(seconds * rate / down) * down for seconds in (PIECE, OVERLAP))
    parts = enumerate(pieces(source, step, overlap))
    found = [_clearest(part[: (source.frames - i * step) // down * down], down, rate / down) for i, part in parts]
    best = max(range(len(found)), key=lambda i: found[i][0])
    return best * step / rate + found[best][1] if found[best][0] > CLEAR_DB else None


def _clearest(channels, down, rate):
    """The level [dB] of the clearest curve in a piece (n, channels), and where it ends [s]."""
    if len(channels) < 2 * WINDOW * down:
        return 0.0, 0.0
    samples = channels[:, np.argmax(np.square(channels).sum(axis=0))].reshape(-1, down)
    power = np.square(np.diff(samples, axis=1, prepend=samples[:, :1])).mean(axis=1)
    return max(_best(contrast(signal), rate) for signal in (samples.mean(axis=1), power))


def contrast(signal) -> np.ndarray:
    """Return by how much every bin of every window stands out (t, f) [dB]: from its median over time, and from that of
    its window."""
    windows = sliding_window_view(signal - signal.mean(), WINDOW)[::HOP]
    power = np.abs(rfft(windows * np.hanning(WINDOW).astype(windows.dtype))) ** 2
    silence = 1e-8 * power.max() + 1e-30
    level = 10 * np.log10(power + silence)
    level -= np.median(level[power.max(axis=1) >= silence], axis=0)
    return np.clip(level - np.median(level, axis=1, keepdims=True), LEAST_DB, MOST_DB)


def _best(seen, rate):
    """The highest mean level (t, f) [dB] on a curve, and where it ends [s]."""
    back, found = np.round(LEFT * rate / HOP).astype(int), []
    padded, first = np.pad(seen, ((back[-1], 0), (0, 0))), back[-1] - back
    for exponent in EXPONENTS:
        for highest in np.geomspace(LEFT[0] ** -exponent * 10, HIGHEST, 24):
            bins = np.round(highest * (LEFT / LEFT[0]) ** -exponent * WINDOW / rate).astype(int)
            score = np.mean([padded[i : i + len(seen), k] for i, k in zip(first, bins, strict=True)], axis=0)
            end = int(np.argmax(score))
            found.append((float(score[end]), (end * HOP + WINDOW / 2) / rate))
    return max(found)
