"""Robust fit of the power law f = a (t_end - t)^-p to the peaks of a spectrogram.

A curve is (end [s], exponent, log2 of a). Peaks (3, n) are ascending times [s], log2
frequencies and levels [dB]. Peaks far from the curve, due to other tones and noise,
have no weight."""

import numpy as np

from sonify.hearing.log_spectrogram import HOP

TIME_LEFT = (0.02, 8.0)
"""Range of the remaining time in which the tone is fitted [s]."""
WIDE, NARROW = (0.3, 0.2, 0.12, 0.08, 0.05, 0.04), (0.05, 0.04, 0.03, 0.03, 0.03)
"""Largest distance of a peak from the curve in successive steps of a wide and a narrow
search [octaves]."""
ENDS, EXPONENTS, MOST_RIVALS = (
    np.arange(-0.1, 0.4, 0.01),
    np.arange(-0.1, 0.101, 0.01),
    20,
)
"""Offsets of ends [s] and exponents that are tried around a first fit, and number of
the best ones that are refitted. If the sound changes from one line to another, the
first fit may be between them."""
BESIDE = 0.4
"""Largest distance of a ridge from the curve [octaves]; the nutation is 0.3 octaves
below the precession."""
BINS, RIVAL = 32, 0.85
"""Number of bins per octave for counting peaks, a power of two, and least share of the
largest count for a rival curve."""
BLOCKS, RESOLUTION = 12, (0.0005, 0.001, 0.0)
"""Number of parts of the ridge for the jackknife, and least errors of end [s] and
exponent due to the hop and the curvature of the tone within a window."""
SHARE = 0.5
"""Least share of the largest number of peaks in the octave of the fundamental."""


def best_curve(peaks: np.ndarray, guesses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the curve (3,) with most peaks (3, n), and its standard errors (3,).

    The search starts from guesses (g, 3). The tone may have harmonics one and two
    octaves above. The errors include the distance to other curves with nearly as many
    peaks."""
    first = max(
        (_fit(peaks, guess, WIDE) for guess in guesses),
        key=lambda curve: octaves(peaks, curve),
    )
    rivals = [_fit(peaks, guess, NARROW) for guess in _around(peaks, first)]
    counts = np.array([octaves(peaks, curve) for curve in rivals])
    best = rivals[np.argmax(counts)]
    apart = np.array(rivals)[counts >= RIVAL * counts.max()] - best
    square = (
        _jackknife(peaks, best) + np.square(apart).mean(axis=0) + np.square(RESOLUTION)
    )
    return _lowest(peaks, best), np.sqrt(square)


def octaves(peaks: np.ndarray, curve: np.ndarray) -> float:
    """Return the number of octaves of the remaining time with peaks on the curve or its
    harmonics."""
    return _normal(peaks, curve, NARROW[-1])[2]


def ridge(peaks: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Return the strongest peak (3, r) near the curve in each frame."""
    inside = peaks[:, _inside(peaks, curve[0])]
    beside = inside[:, np.abs(_residual(inside, curve)) < BESIDE]
    beside = beside[:, np.lexsort((-beside[2], beside[0]))]
    return beside[:, np.unique(beside[0], return_index=True)[1]]


def _inside(peaks, end):
    """Return the slice of the peaks within TIME_LEFT before an end [s]."""
    since = peaks[0] - end
    return slice(
        np.searchsorted(since, -TIME_LEFT[1], "right"),
        np.searchsorted(since, -TIME_LEFT[0]),
    )


def _residual(peaks, curve):
    """Return the signed distances (n,) of peaks above a curve [octaves]."""
    return peaks[1] - curve[2] + curve[1] * np.log2(curve[0] - peaks[0])


def _fit(peaks, curve, widths):
    """Return the curve after Gauss-Newton steps, one for each of `widths` [octaves].

    Each step changes the end by at most 0.1 s and the exponent by at most 0.2.
    """
    for width in widths:
        matrix, right, _ = _normal(peaks, curve, width)
        step = np.linalg.lstsq(matrix, right)[0]
        curve = curve + step * min(
            1, 0.1 / max(abs(step[0]), 1e-9), 0.2 / max(abs(step[1]), 1e-9)
        )
    return curve


def _normal(peaks, curve, width):
    """Return the normal equations (3, 3), (3,) of a robust linear fit around a curve,
    and its octaves.

    The residual log2 f - log2 a + p log2(t_end - t) is relative to the nearest of three
    octaves. The weights are Tukey's biweight with the half-width `width` [octaves].
    Each octave of the remaining time has the same total weight."""
    peaks = peaks[:, _inside(peaks, curve[0])]
    residual = _residual(peaks, curve)
    residual -= np.clip(np.round(residual), -1, 1)
    near = np.abs(residual) < width
    residual = residual[near]
    left = curve[0] - peaks[0, near]
    slope = np.array([-curve[1] / left / np.log(2), -np.log2(left), np.ones_like(left)])
    weight = (1 - (residual / width) ** 2) ** 2 * HOP / left / np.log(2)
    return (slope * weight) @ slope.T, (slope * weight) @ residual, weight.sum()


def _around(peaks, curve):
    """Return the MOST_RIVALS curves around a given one with the most peaks, in any
    octave."""
    end = curve[0] + ENDS
    exponent = np.maximum(curve[1] + EXPONENTS, 0.02)
    count, scale = _count(peaks, end, exponent)
    i, j = np.unravel_index(np.argsort(count, axis=None)[-MOST_RIVALS:], count.shape)
    middle = curve[2] + (exponent[j] - curve[1]) * np.log2(TIME_LEFT).mean()
    return np.column_stack(
        [end[i], exponent[j], scale[i, j] + np.round(middle - scale[i, j])]
    )


def _count(peaks, end, exponent):
    """Return the weighted number of peaks and the log2 scale of the best curve, each
    (e, p).

    They are given for all ends (e,) and exponents (p,).
    """
    count, scale = np.empty((2, len(end), len(exponent)))
    rows = BINS * np.arange(len(exponent))[:, None]
    for i in range(len(end)):
        inside = peaks[:, _inside(peaks, end[i])]
        left = end[i] - inside[0]
        place = BINS * (inside[1] + np.outer(exponent, np.log2(left)))
        bins = (np.floor(place, out=place).astype(int) & BINS - 1) + rows
        weight = np.tile(1 / left, len(exponent))
        bins = np.bincount(bins.ravel(), weight, rows.size * BINS).reshape(-1, BINS)
        pairs = bins + np.roll(bins, -1, axis=1)
        count[i], scale[i] = pairs.max(axis=1), (pairs.argmax(axis=1) + 1) / BINS
    return count, scale


def _jackknife(peaks, curve):
    """Return the jackknife variances (3,) for parts of the ridge of equal log remaining
    time."""
    left = np.clip(curve[0] - peaks[0], *TIME_LEFT)
    part = np.floor(
        BLOCKS * np.log(left / TIME_LEFT[0]) / np.log(TIME_LEFT[1] / TIME_LEFT[0])
    )
    moved = np.array(
        [_fit(peaks[:, part != block], curve, NARROW[-1:]) for block in np.unique(part)]
    )
    return (len(moved) - 1) * moved.var(axis=0)


def _lowest(peaks, curve):
    """Return the curve of the fundamental, the lowest octave with enough peaks."""
    moved = [curve + np.array((0, 0, k)) for k in (-2, -1, 0, 1)]
    peaks = peaks[:, _inside(peaks, curve[0])]
    count = np.array(
        [
            np.sum((np.abs(_residual(peaks, x)) < NARROW[-1]) / np.abs(x[0] - peaks[0]))
            for x in moved
        ]
    )
    return moved[np.argmax(count > SHARE * count.max())]
