"""Ridge of a rising tone f(t) = a (t_end - t)^-p in a sound.

The tone is tracked as a ridge of the spectrogram that rises ever faster; the law is
then fitted to the peaks near the ridge. Peaks (3, n) are ascending times [s], log2
frequencies and contrasts [dB]. A curve is (end [s], exponent, log2 of a)."""

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.ndimage import map_coordinates

from dynamics.numba_kernels import njit
from sonify.hearing.log_spectrogram import (
    BINS_PER_OCTAVE,
    FRAME_SPACING_S,
    LogSpectrogram,
    log_spectrogram,
)

REMAINING_TIME_RANGE_S = (0.02, 8.0)
"""Range of the remaining time in which the law is fitted."""
FIT_HALF_WIDTHS_OCTAVES = (0.3, 0.2, 0.12, 0.08, 0.05, 0.04, 0.03, 0.03)
"""Maximum distance between peak and curve in the successive iterations of the fit."""


@dataclass(frozen=True, kw_only=True)
class ToneRidge:
    """Ridge of a tone and the law f = a (t_end - t)^-p fitted near it.

    `law` (3,) is the end [s], the exponent p and log2 of a [Hz]; `errors` (3,) are its
    standard errors. `time` [s] and `frequency` [Hz], each (r,), describe the strongest
    line near the law in each frame, which initially may be another line. The law has
    peaks over `octaves` of the remaining time.
    """

    law: np.ndarray
    errors: np.ndarray
    time: np.ndarray = field(repr=False)
    frequency: np.ndarray = field(repr=False)
    octaves: float

    def later(self, seconds: float) -> "ToneRidge":
        """Return the ridge shifted to later times by `seconds`."""
        law = self.law + np.array([seconds, 0.0, 0.0])
        return replace(self, law=law, time=self.time + seconds)

    @property
    def factor(self) -> float:
        """Ratio of the median frequencies in the last and first tenths of the ridge."""
        tenth = max(len(self.frequency) // 10, 1)
        return float(
            np.median(self.frequency[-tenth:]) / np.median(self.frequency[:tenth])
        )


def tone_ridge(samples: np.ndarray, rate: float) -> ToneRidge | None:
    """Return the ridge of the tone with the most evidence in samples (n,) at `rate`
    [Hz]; None if no tone stands out.

    The lowest octave that stands out is the fundamental."""
    if not np.any(samples):
        return None
    seen = log_spectrogram(samples / np.abs(samples).max(), rate)
    if not seen.peaks.size:
        return None
    ridge = _best_ridge(seen)
    best = _best_curve(seen, _initial_curves(ridge, 8))
    best = best or _best_curve(seen, _initial_curves(ridge, 60))
    if best is None:
        return None
    law, errors = best
    time, pitch, _ = _strongest_line(seen.peaks, law)
    return ToneRidge(
        law=law,
        errors=errors,
        time=time,
        frequency=2**pitch,
        octaves=float(_octaves_with_peaks(seen.peaks, law)),
    )


def _best_ridge(seen: LogSpectrogram) -> np.ndarray:
    """Return times [s] and log2 frequencies (2, r) of the ridge with the most evidence,
    integrated over the octaves that the tone rises."""
    slopes = np.geomspace(0.015, 8.0, 18)  # bins per frame
    bend_penalty = 1.5  # dB octaves per change of the slope
    back, place = _best_paths(_evidence_per_octave(seen.contrast), slopes, bend_penalty)
    path = np.array(_backtrack(back, *place, slopes))[::-1]
    middle = 2 * path[:, 1] + 0.5
    return np.array(
        [
            seen.time[path[:, 0]],
            np.log2(seen.frequency[0]) + middle / BINS_PER_OCTAVE,
        ]
    )


def _evidence_per_octave(contrast: np.ndarray) -> np.ndarray:
    """Return the evidence per octave [dB] in pairs of bins of the contrast (t, f) [dB].

    It is the weighted sum of three harmonics above that of noise."""
    noise_level = 6.0  # dB; mean weighted sum along a ridge in noise
    steps = BINS_PER_OCTAVE // 2
    level = np.maximum(contrast[:, :-1:2], contrast[:, 1::2])
    evidence = level - noise_level
    for harmonic in (2, 3):
        bins = round(steps * np.log2(harmonic))
        evidence[:, :-bins] += np.maximum(level[:, bins:], 0) / 2
    return evidence / steps


@njit(cache=True, nogil=True)
def _bins_from_previous_frame(slope: float, frame: int) -> int:
    """Return the number of bins from the previous frame to a frame."""
    return int(slope * (frame + 1)) - int(slope * frame)


@njit(cache=True, nogil=True)
def _running_sums(values: np.ndarray, sums: np.ndarray) -> None:
    """Write the sums of the first values (n,) to `sums` (n + 1,), after its first zero."""
    for i in range(len(values)):
        sums[i + 1] = sums[i] + values[i]


@njit(cache=True, nogil=True)
def _best_paths(
    evidence: np.ndarray, slopes: np.ndarray, bend_penalty: float
) -> tuple[np.ndarray, tuple[int, int, int]]:
    """Return the previous slope (frames, slopes, bins) of the best path through each
    bin, or -1 if it begins there, and frame, slope and bin of the end of the best path.

    The slope of a path does not decrease, and increases by at most two steps per frame.
    `evidence` (frames, bins) is per octave."""
    frames, bins = evidence.shape
    penalty = np.float32(bend_penalty)
    score = np.zeros((len(slopes), bins), np.float32)
    updated = np.zeros((len(slopes), bins), np.float32)
    back = np.full((frames, len(slopes), bins), -1, np.int8)
    best = np.float32(0)
    place = (0, 0, 0)
    sums = np.zeros(bins + 1, np.float32)
    for frame in range(frames):
        _running_sums(evidence[frame], sums)
        top = np.float32(0)
        for k in range(len(slopes)):
            shift = _bins_from_previous_frame(slopes[k], frame)
            crossed = max(shift, 1)
            weight = np.float32(slopes[k] / crossed)
            for b in range(min(shift, bins)):
                updated[k, b] = weight * sums[b + 1]
            reached = updated[k, shift:]
            _best_predecessors(score, k, penalty, reached, back[frame, k, shift:])
            low, high = sums[shift + 1 - crossed :], sums[shift + 1 :]
            for i in range(len(reached)):
                reached[i] += weight * (high[i] - low[i])
            for b in range(bins):
                top = max(top, updated[k, b])
        if top > best:
            best = top
            for k in range(len(slopes)):
                for b in range(bins):
                    if updated[k, b] == best:
                        place = (frame, k, b)
        score, updated = updated, score
    return back, place


@njit(cache=True, nogil=True)
def _best_predecessors(
    score: np.ndarray, k: int, penalty: np.float32, best: np.ndarray, slope: np.ndarray
) -> None:
    """Write the score of the best path that reaches each bin with slope k, and its
    previous slope, to `best` and `slope` (n,).

    Where the score would be negative, a new path begins with slope -1. The loops have
    no branch, so that they compile to vector instructions."""
    same = score[k, : len(best)]
    for i in range(len(best)):
        best[i] = max(same[i], np.float32(0))
        slope[i] = k if same[i] > 0 else -1
    for previous in range(max(k - 2, 0), k):
        bent = score[previous, : len(best)]
        for i in range(len(best)):
            before = bent[i] - penalty
            slope[i] = previous if before > best[i] else slope[i]
            best[i] = max(best[i], before)


@njit(cache=True, nogil=True)
def _backtrack(
    back: np.ndarray, frame: int, slope: int, place: int, slopes: np.ndarray
) -> list[tuple[int, int]]:
    """Return pairs of frame and bin of a path, from its end to its beginning."""
    path = [(frame, place)]
    while back[frame, slope, place] >= 0:
        previous = back[frame, slope, place]
        place -= _bins_from_previous_frame(slopes[slope], frame)
        frame -= 1
        slope = previous
        path.append((frame, place))
    return path


def _initial_curves(ridge: np.ndarray, count: int) -> list[np.ndarray]:
    """Return the curves near the last part of a ridge (2, r) for 60 ends, the nearest
    `count` for each length of the part.

    Each octave of the remaining time has the same weight."""
    found = []
    for length in (0.5, 1.0, 2.0, 4.0, 8.0):
        time, pitch = ridge[:, ridge[0] > ridge[0, -1] - length]
        curves = []
        for end in time[-1] - 0.1 + np.geomspace(0.01, 3.0, 60):
            left = end - time[time < end - 0.01]
            if len(left) < 10:
                continue
            own = pitch[: len(left)]
            slope, height = np.polyfit(np.log2(left), own, 1, w=left**-0.5)
            deviation = np.abs(own - height - slope * np.log2(left))
            curves.append(
                (np.average(deviation, weights=1 / left), end, -slope, height)
            )
        found += sorted(curves)[:count]
    return [np.array(curve) for _, *curve in found]


def _best_curve(
    seen: LogSpectrogram, initial_curves: list[np.ndarray]
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the rising curve (3,) that explains most octaves of the frequency, of
    those fitted to the peaks that stand out, and its standard errors (3,); None if none
    rises and stands out.

    The tone may have harmonics one and two octaves above. The errors include the
    distance to other curves that explain nearly as many."""
    min_strength = 4.0  # dB; sounds without a disk reach 2 dB
    fitted = [
        _fit_curve_to_peaks(seen.peaks, initial, FIT_HALF_WIDTHS_OCTAVES)
        for initial in initial_curves
    ]
    curves = np.array(
        [
            curve
            for curve in fitted
            if curve[1] > 0 and _mean_contrast(seen, curve) >= min_strength
        ]
    )
    if not len(curves):
        return None
    explained = np.array(
        [curve[1] * _octaves_with_peaks(seen.peaks, curve) for curve in curves]
    )
    best = curves[np.argmax(explained)]
    deviation = curves[explained >= 0.85 * explained.max()] - best
    resolution = (0.0005, 0.001, 0.0)  # hop, and curvature of the tone within a window
    square = (
        _jackknife_variances(seen.peaks, best)
        + np.square(deviation).mean(axis=0)
        + np.square(resolution)
    )
    return _fundamental(seen.peaks, best), np.sqrt(square)


def _octaves_with_peaks(peaks: np.ndarray, curve: np.ndarray) -> float:
    """Return the number of octaves of the remaining time in which a curve has peaks."""
    return _normal_equations(peaks, curve, FIT_HALF_WIDTHS_OCTAVES[-1])[2]


def _mean_contrast(seen: LogSpectrogram, curve: np.ndarray) -> float:
    """Return the mean contrast along a curve [dB], which is 0 outside the spectrogram."""
    left = np.geomspace(*REMAINING_TIME_RANGE_S, 72)
    along = 2 ** (curve[2] - curve[1] * np.log2(left))
    row = (curve[0] - left - seen.time[0]) / FRAME_SPACING_S
    column = np.log2(along / seen.frequency[0]) * BINS_PER_OCTAVE
    return float(np.mean(map_coordinates(seen.contrast, [row, column], order=1)))


def _strongest_line(peaks: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Return the strongest peak (3, r) near the curve in each frame."""
    max_distance = 0.4  # octaves; the nutation is 0.3 octaves below the precession
    inside = peaks[:, _peaks_in_range(peaks, curve[0])]
    near = inside[:, np.abs(_octaves_above_curve(inside, curve)) < max_distance]
    near = near[:, np.lexsort((-near[2], near[0]))]
    return near[:, np.unique(near[0], return_index=True)[1]]


def _peaks_in_range(peaks: np.ndarray, end: float) -> slice:
    """Return the slice of the peaks within REMAINING_TIME_RANGE_S before an end [s]."""
    nearest, farthest = REMAINING_TIME_RANGE_S
    return slice(
        np.searchsorted(peaks[0], end - farthest, "right"),
        np.searchsorted(peaks[0], end - nearest),
    )


def _octaves_above_curve(peaks: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Return the signed distances (n,) of peaks above a curve [octaves]."""
    return peaks[1] - curve[2] + curve[1] * np.log2(curve[0] - peaks[0])


def _fit_curve_to_peaks(
    peaks: np.ndarray, curve: np.ndarray, widths: tuple[float, ...]
) -> np.ndarray:
    """Return the curve after Gauss-Newton steps, one for each of `widths` [octaves].

    Each step changes the end by at most 0.1 s and the exponent by at most 0.2.
    """
    for width in widths:
        matrix, right, _ = _normal_equations(peaks, curve, width)
        step = np.linalg.lstsq(matrix, right)[0]
        curve = curve + step * min(
            1, 0.1 / max(abs(step[0]), 1e-9), 0.2 / max(abs(step[1]), 1e-9)
        )
    return curve


def _normal_equations(
    peaks: np.ndarray, curve: np.ndarray, width: float
) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the normal equations (3, 3), (3,) of a robust linear fit around a curve,
    and the number of octaves of the remaining time with peaks.

    The residual log2 f - log2 a + p log2(t_end - t) is relative to the nearest of three
    octaves. The weights are Tukey's biweight with the half-width `width` [octaves].
    Each octave of the remaining time has the same total weight."""
    peaks = peaks[:, _peaks_in_range(peaks, curve[0])]
    residual = _octaves_above_curve(peaks, curve)
    residual -= np.clip(np.round(residual), -1, 1)
    near = np.abs(residual) < width
    residual = residual[near]
    left = curve[0] - peaks[0, near]
    slope = np.array([-curve[1] / left / np.log(2), -np.log2(left), np.ones_like(left)])
    weight = (1 - (residual / width) ** 2) ** 2 * FRAME_SPACING_S / left / np.log(2)
    return (slope * weight) @ slope.T, (slope * weight) @ residual, weight.sum()


def _jackknife_variances(peaks: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Return the jackknife variances (3,) for parts of equal log remaining time."""
    part_count = 12
    nearest, farthest = REMAINING_TIME_RANGE_S
    left = np.clip(curve[0] - peaks[0], nearest, farthest)
    part = np.floor(part_count * np.log(left / nearest) / np.log(farthest / nearest))
    moved = np.array(
        [
            _fit_curve_to_peaks(
                peaks[:, part != one], curve, FIT_HALF_WIDTHS_OCTAVES[-1:]
            )
            for one in np.unique(part)
        ]
    )
    return (len(moved) - 1) * moved.var(axis=0)


def _fundamental(peaks: np.ndarray, curve: np.ndarray) -> np.ndarray:
    """Return the curve of the fundamental, the lowest octave with at least half of the
    largest number of peaks."""
    moved = [curve + np.array((0, 0, k)) for k in (-2, -1, 0, 1)]
    peaks = peaks[:, _peaks_in_range(peaks, curve[0])]
    left = np.abs(curve[0] - peaks[0])
    width = FIT_HALF_WIDTHS_OCTAVES[-1]
    near = [np.abs(_octaves_above_curve(peaks, one)) < width for one in moved]
    count = np.array([np.sum(each / left) for each in near])
    return moved[np.argmax(count > 0.5 * count.max())]
