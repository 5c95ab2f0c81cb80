"""LONG SOUND -> WHERE A DISK COMES TO REST IN IT: piece by piece, from coarse spectrograms, in the
memory of one piece.

A tone that rises as (t_end - t)^-p towards its end is sought among curves of a few exponents and
pitches, in the sound itself below 500 Hz and in the power above: speech, knocks and hum are beside
these curves most of the time."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.fft import rfft

from sonify.hearing.audio_source import Source, pieces

RATE, WINDOW, HOP = 1000, 256, 64
"""Samples a second in which a run is sought [Hz]; samples of a window, and from one to the next."""
PIECE, OVERLAP = 60.0, 30.0
"""A piece, and what it shares with the next, which is far more than any curve lasts [s]."""
LEFT, EXPONENTS, HIGHEST = np.geomspace(0.2, 10.0, 48), (0.17, 0.25, 0.33, 0.5, 0.9), 450.0
"""Times left [s] at which a curve is read, its exponents, and its pitch at the first of these [Hz]
at most."""
LEAST_DB, MOST_DB, CLEAR_DB = -3.0, 15.0, 7.0
"""Bounds of what a frame contributes, and the mean along a curve from which on it is a run."""
APART, MANY = 4.0, 20
"""Ends are so far apart [s]; one in so many windows may be one."""


def run_end(source: Source) -> float | None:
    """Return the time [s] at which the tone ends that rises most clearly in a sound of any length,
    or None."""
    return next((end for level, end in run_ends(source) if level > CLEAR_DB), None)


def run_ends(source: Source) -> list[tuple[float, float]]:
    """Return levels [dB] and times [s] at which tones may end that rise in a sound of any length,
    the clearest first, APART or more."""
    rate = source.sample_rate
    down = max(round(rate / RATE), 1)
    step, overlap = (int(seconds * rate / down) * down for seconds in (PIECE, OVERLAP))
    parts = enumerate(pieces(source, step, overlap))
    levels = [
        _levels(part[: (source.frames - i * step) // down * down], down, rate / down)
        for i, part in parts
    ]
    found = [
        (level, i * step / rate + end) for i, piece in enumerate(levels) for level, end in piece
    ]
    return _apart(sorted(found, reverse=True))


def _apart(found):
    """Of levels and times (n, 2), the highest first, those that are not near a higher one."""
    kept: list[tuple[float, float]] = []
    for level, end in found:
        if all(abs(end - other) >= APART for _, other in kept):
            kept.append((level, end))
    return kept


def _levels(channels, down, rate):
    """The levels [dB] of the clearest curves in a piece (n, channels), and where they end [s]."""
    if len(channels) < 2 * WINDOW * down:
        return []
    samples = channels[:, np.argmax(np.square(channels).sum(axis=0))].reshape(-1, down)
    power = np.square(np.diff(samples, axis=1, prepend=samples[:, :1])).mean(axis=1)
    level = np.maximum(*(_best(contrast(signal), rate) for signal in (samples.mean(axis=1), power)))
    end = (np.arange(len(level)) * HOP + WINDOW / 2) / rate
    best = np.argsort(level, kind="stable")[::-1][: len(level) // MANY]
    return _apart(zip(level[best].tolist(), end[best].tolist(), strict=True))


def contrast(signal) -> np.ndarray:
    """Return by how much every bin of every window stands out (t, f) [dB]: from its median over
    time, and from that of its window."""
    windows = sliding_window_view(signal - signal.mean(), WINDOW)[::HOP]
    power = np.abs(rfft(windows * np.hanning(WINDOW).astype(windows.dtype))) ** 2
    silence = 1e-8 * power.max() + 1e-30
    level = 10 * np.log10(power + silence)
    level -= np.median(level[power.max(axis=1) >= silence], axis=0)
    return np.clip(level - np.median(level, axis=1, keepdims=True), LEAST_DB, MOST_DB)


def _best(seen, rate):
    """The highest mean level (t,) [dB] on a curve (t, f) that ends in each window."""
    back = np.round(LEFT * rate / HOP).astype(int)
    found = np.full(len(seen), LEAST_DB)
    padded = np.pad(seen, ((back[-1], 0), (0, 0)))
    first = back[-1] - back
    for exponent in EXPONENTS:
        for highest in np.geomspace(LEFT[0] ** -exponent * 10, HIGHEST, 24):
            bins = np.round(highest * (LEFT / LEFT[0]) ** -exponent * WINDOW / rate).astype(int)
            score = np.mean(
                [padded[i : i + len(seen), k] for i, k in zip(first, bins, strict=True)], axis=0
            )
            found = np.maximum(found, score)
    return found
