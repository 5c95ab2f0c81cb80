"""Spectral lines and noise bands of a sound, with frequency drift and sidebands."""

from dataclasses import dataclass, replace
from itertools import pairwise
from statistics import median
from typing import Any

import numpy as np
from scipy.interpolate import make_interp_spline
from scipy.ndimage import maximum_filter1d, median_filter, uniform_filter1d

from sonify.hearing.mains_hum import MIN_PROMINENCE_DB
from sonify.hearing.time_frequency import hann_power, local_maxima

MIN_LINE_FREQUENCY_HZ = 300.0
"""Lowest frequency of a spectral line or noise band."""
MIN_TRACK_FRAMES = 8
"""Minimum number of frames in a track, except in short sounds."""
BAND_GRID_SPACING_CENTS = 5.0
"""Spacing of the logarithmic frequency grid on which noise bands are detected."""
SIGNIFICANT_DRIFT_SIGMAS = 2.0
"""Significance threshold of a frequency drift, in standard errors."""
MAX_SIDEBAND_OFFSET_HZ = 300.0
"""Largest frequency offset of a sideband from its centre."""
TRIAL_CENTRES_PER_BIN = 2
"""Number of trial centre frequencies of sidebands per frequency bin."""
MIN_CENTRE_SEPARATION_STEPS = 6
"""Smallest separation of two different centres, in steps of the trial centres."""


@dataclass(frozen=True, kw_only=True)
class SpectralLine:
    """A spectral line or noise band from `begin` to `end` [s].

    `frequency` [Hz] is the frequency at mid-duration, with the standard error `error`
    [Hz]. `drift` and its standard error `drift_error` are in cents/s. `spread` is the
    standard deviation from the linear drift [cents]. `level` is relative to the
    background [dB]. `sidebands` is the median offset of the sidebands [Hz], and `rates`
    the range of the offsets [Hz]. If `heard` is False, only the sidebands are present,
    and the values describe their centre. `reach` is the distance from the centre of a
    noise band to its farther half-power frequency [cents]; it is 0 for a line."""

    frequency: float
    error: float
    spread: float
    level: float
    drift: float
    drift_error: float
    begin: float
    end: float
    sidebands: tuple[float, ...] = ()
    rates: tuple[float, float] | None = None
    heard: bool = True
    reach: float = 0.0

    @property
    def course(self) -> str:
        """Significant trend of the frequency: "rises", "falls" or "steady"."""
        if abs(self.drift) < SIGNIFICANT_DRIFT_SIGMAS * self.drift_error:
            return "steady"
        return "rises" if self.drift > 0 else "falls"


@dataclass(frozen=True, eq=False)
class PeakTrack:
    """Spectral peaks in successive frames: frame indices (k,), frequencies (k,) [Hz],
    levels (k,) [dB], and the half-width of a noise band [cents]."""

    frame: np.ndarray
    frequency: np.ndarray
    level: np.ndarray
    half_width: float = 0.0


def find_spectral_lines(
    samples: np.ndarray, rate: float, start: float = 0.0
) -> list[SpectralLine]:
    """Return at most 12 lines and noise bands of samples (n,) at `rate` [Hz], in order
    of decreasing level.

    The samples start at the time `start` [s].
    """
    max_count = 12
    window_length = 0.5  # s
    size = int(window_length * rate)
    if len(samples) < 4 * size:
        return []
    hop = size // 2 / rate
    bin_width = rate / size
    level = 10 * np.log10(hann_power(samples, size, size // 2) + 1e-300)
    peaks = _spectral_peaks(level, bin_width)
    is_sideband, centres = _find_sidebands(peaks, bin_width)
    tracks = _track_peaks(peaks[:, ~is_sideband], len(level), max_step=30.0)
    tracks = _merge_noise_bands(tracks, level, bin_width)
    tracks = sorted(tracks, key=lambda track: -np.median(track.level))
    lines = [_fit_line(track, start, hop, bin_width) for track in tracks[:max_count]]
    for track, offsets in centres:
        centre = _fit_line(track, start, hop, bin_width)
        lines = _add_sidebands(lines, centre, offsets, bin_width)
    return sorted(lines, key=lambda line: -line.level)[:max_count]


def _add_sidebands(
    lines: list[SpectralLine],
    centre: SpectralLine,
    offsets: np.ndarray,
    bin_width: float,
) -> list[SpectralLine]:
    """Return the lines with the sidebands at `offsets` (k,) [Hz] from a centre.

    The sidebands are assigned to a line at the frequency of the centre if the line is
    present for most of their duration; otherwise the centre is added to the lines.
    Weaker lines among the sidebands are removed."""
    max_order = 3
    low, middle, high = np.percentile(offsets, [5, 50, 95]).tolist()
    sides: dict[str, Any] = {"sidebands": (middle,), "rates": (low, high)}
    same = [
        line
        for line in lines
        if abs(line.frequency - centre.frequency) < bin_width
        and _common_duration(line, centre) > 0
    ]
    duration = sum(_common_duration(line, centre) for line in same)
    heard = duration > (centre.end - centre.begin) / 2
    modulated = [replace(line, **sides) for line in same] if heard else same
    others = [
        line
        for line in lines
        if line not in same and not _is_weaker_nearby(line, centre, max_order * high)
    ]
    if not heard:
        others.append(replace(centre, heard=False, **sides))
    return [*modulated, *others]


def _is_weaker_nearby(
    line: SpectralLine, centre: SpectralLine, max_distance: float
) -> bool:
    """Return True if a line is weaker than a centre and within `max_distance` [Hz] of
    it for most of the duration of the line."""
    near = abs(line.frequency - centre.frequency) < max_distance
    long = _common_duration(line, centre) > (line.end - line.begin) / 2
    return near and long and line.level < centre.level


def _common_duration(line: SpectralLine, other: SpectralLine) -> float:
    """Return the duration [s] of the overlap of two lines; negative if there is a gap
    between them."""
    return min(line.end, other.end) - max(line.begin, other.begin)


def _background_level(level: np.ndarray) -> np.ndarray:
    """Return the background (t, f) of levels (t, f), interpolated between the medians
    in 32 bands.

    It is at most 90 dB below the maximum of the frame.
    """
    band_count = 32
    edges = np.linspace(0, level.shape[1], band_count + 1).astype(int)
    medians = np.column_stack(
        [np.median(level[:, a:b], axis=1) for a, b in pairwise(edges)]
    )
    medians = np.maximum(medians, level.max(axis=1, keepdims=True) - 90)
    middle = (edges[1:] + edges[:-1] - 1) / 2
    return make_interp_spline(middle, medians, 1, axis=1)(
        np.clip(np.arange(level.shape[1]), middle[0], middle[-1])
    )


def _spectral_peaks(level: np.ndarray, bin_width: float) -> np.ndarray:
    """Return frames, frequencies [Hz] and levels [dB] (3, n) of the peaks of levels
    (t, f).

    The returned levels are relative to the background.
    """
    raised = level - _background_level(level)
    frame, top, offset = local_maxima(raised, MIN_PROMINENCE_DB)
    column = top + offset
    height = raised[frame, top]
    neighbours = np.arange(10, 61)  # bins
    sides = [
        np.median(
            level[frame[:, None], np.clip(top[:, None] + side, 0, level.shape[1] - 1)],
            axis=1,
        )
        for side in (-neighbours, neighbours)
    ]
    # The edge of a noise band is prominent on one side only.
    prominent = level[frame, top] - np.maximum(*sides) > MIN_PROMINENCE_DB
    return np.array([frame, column * bin_width, height])[
        :, prominent & (column > MIN_LINE_FREQUENCY_HZ / bin_width)
    ]


def _merge_noise_bands(
    tracks: list[PeakTrack], level: np.ndarray, bin_width: float
) -> list[PeakTrack]:
    """Return the tracks of the lines and of the noise bands in levels (t, f).

    A line that is not prominent above a noise band is part of the band. A band that is
    as narrow as a line is discarded in favour of its loudest line."""
    max_line_half_width = 75.0  # cents
    for band in _find_noise_bands(level, bin_width):
        is_line = band.half_width < max_line_half_width
        max_distance = band.half_width if is_line else 2 * band.half_width
        inside = [track for track in tracks if _is_inside(track, band, max_distance)]
        loudest = max(inside, key=lambda track: np.median(track.level), default=None)
        min_level = np.median(band.level) + MIN_PROMINENCE_DB
        hidden = [
            track
            for track in inside
            if np.median(track.level) <= min_level
            and not (is_line and track is loudest)
        ]
        tracks = [track for track in tracks if track not in hidden]
        if not is_line:
            tracks += _split_at_bends(band)
    return tracks


def _octave_medians(grid: np.ndarray) -> np.ndarray:
    """Return the running median (t, c) over an octave of levels (t, c) on the grid."""
    background_width = 1200.0  # cents
    background_step = 10  # columns
    size = background_width / BAND_GRID_SPACING_CENTS / background_step
    background = _running_medians(grid[:, ::background_step], int(size) + 1)
    places = np.arange(0, grid.shape[1], background_step)
    return make_interp_spline(places, background, 1, axis=1)(
        np.clip(np.arange(grid.shape[1]), 0, places[-1])
    )


def _find_noise_bands(level: np.ndarray, bin_width: float) -> list[PeakTrack]:
    """Return the tracks of the noise bands in levels (t, f)."""
    smoothing_width = 120.0  # cents
    averaged_frames = 5
    min_level = 5.0  # dB
    max_half_width = 400.0  # cents
    octaves = np.log2(0.9 * level.shape[1] * bin_width / MIN_LINE_FREQUENCY_HZ)
    cents = np.arange(0, 1200 * octaves, BAND_GRID_SPACING_CENTS)
    frequency = MIN_LINE_FREQUENCY_HZ * 2 ** (cents / 1200)
    size = int(smoothing_width / BAND_GRID_SPACING_CENTS) + 1
    grid = _running_medians(level[:, np.round(frequency / bin_width).astype(int)], size)
    grid -= _octave_medians(grid)
    grid = uniform_filter1d(grid, size, axis=1)
    mean = uniform_filter1d(grid, averaged_frames, axis=0)
    frame, column, offset = local_maxima(mean, min_level)
    peaks = np.array([frame, _grid_frequency(column + offset), mean[frame, column]])
    tracks = _track_peaks(peaks, len(level), max_step=60.0)
    bands = [_centre_noise_band(track, mean, grid) for track in tracks]
    return [band for band in bands if band.half_width < max_half_width]


def _grid_frequency(column: np.ndarray) -> np.ndarray:
    """Return the frequency [Hz] at a fractional column of the grid for noise bands."""
    return MIN_LINE_FREQUENCY_HZ * 2 ** (column * BAND_GRID_SPACING_CENTS / 1200)


def _running_medians(level: np.ndarray, size: int) -> np.ndarray:
    """Return the running medians of levels (t, f) over `size` columns."""
    return np.array([median_filter(row, size) for row in level])


def _centre_noise_band(
    track: PeakTrack, mean: np.ndarray, grid: np.ndarray
) -> PeakTrack:
    """Return a track with the centroids of a noise band and its median half-width.

    The limits of the band are where the time-averaged levels `mean` (t, f) fall to half
    power; the centroids are those of the power in `grid` (t, f)."""
    half_power_drop = 3.0  # dB
    octaves = np.log2(track.frequency / MIN_LINE_FREQUENCY_HZ)
    tops = np.round(1200 / BAND_GRID_SPACING_CENTS * octaves).astype(int)
    centroids = []
    half_widths = []
    for row, level, top in zip(mean[track.frame], grid[track.frame], tops, strict=True):
        outside = np.flatnonzero(row < row[top] - half_power_drop)
        low = outside[outside < top].max(initial=-1) + 1
        high = outside[outside > top].min(initial=len(row))
        power = 10 ** (level[low:high] / 10)
        centroid = np.average(np.arange(low, high), weights=power)
        centroids.append(centroid)
        half_widths.append(max(centroid - low, high - centroid))
    return replace(
        track,
        frequency=_grid_frequency(np.array(centroids)),
        half_width=BAND_GRID_SPACING_CENTS * median(half_widths),
    )


def _is_inside(track: PeakTrack, band: PeakTrack, max_distance: float) -> bool:
    """Return True if a track is within `max_distance` [cents] of the centre of a band
    in most of its frames."""
    centre = np.interp(track.frame, band.frame, band.frequency, np.nan, np.nan)
    near = np.abs(1200 * np.log2(track.frequency / centre)) < max_distance
    return np.sum(near) > len(track.frame) / 2


def _split_at_bends(track: PeakTrack) -> list[PeakTrack]:
    """Return the parts of a track after repeated bisection until the drifts of both
    halves agree."""
    half = len(track.frame) // 2
    parts = [
        replace(
            track,
            frame=track.frame[part],
            frequency=track.frequency[part],
            level=track.level[part],
        )
        for part in (slice(half), slice(half, None))
    ]
    if half < MIN_TRACK_FRAMES:
        return [track]
    first, second = (_fit_line(part, 0.0, 1.0, 0.0) for part in parts)
    if _drifts_agree(first, second):
        return [track]
    return [straight for part in parts for straight in _split_at_bends(part)]


def _drifts_agree(line: SpectralLine, other: SpectralLine) -> bool:
    """Return True if the drifts of two lines agree within their errors."""
    error = np.hypot(line.drift_error, other.drift_error)
    return abs(line.drift - other.drift) < SIGNIFICANT_DRIFT_SIGMAS * error


def _track_peaks(
    peaks: np.ndarray, frame_count: int, max_step: float
) -> list[PeakTrack]:
    """Return the tracks of peaks (3, n) in `frame_count` frames, starting from the
    highest peak.

    A track changes by at most `max_step` [cents] from frame to frame. Weaker peaks in
    its neighbourhood are removed; the neighbourhood is wide for a noise band, whose
    peaks fluctuate."""
    min_exclusion = 30.0  # cents
    exclusion_per_fluctuation = 15.0
    min_share_of_frames = 0.2
    min_frames = min(MIN_TRACK_FRAMES, max(5, min_share_of_frames * frame_count))
    frame = peaks[0].astype(int)
    cents = 1200 * np.log2(peaks[1])
    level = peaks[2]
    in_frame = [np.flatnonzero(frame == i) for i in range(frame_count)]
    free = np.ones(len(frame), bool)
    tracks = []
    for seed in np.argsort(-level):
        if not free[seed]:
            continue
        found = [seed]
        for frames in (
            range(frame[seed] + 1, frame_count),
            range(frame[seed] - 1, -1, -1),
        ):
            found += _continue_track(
                seed, frames, in_frame, cents, level, free, max_step
            )
        chosen = np.array(sorted(found, key=lambda peak: frame[peak]))
        steps = np.diff(cents[chosen], prepend=cents[seed])
        fluctuation = np.median(np.abs(steps))
        exclusion = max(min_exclusion, exclusion_per_fluctuation * fluctuation)
        for peak in chosen:
            near = in_frame[frame[peak]]
            free[near[np.abs(cents[near] - cents[peak]) < exclusion]] = False
        if len(chosen) >= min_frames:
            tracks.append(PeakTrack(frame[chosen], peaks[1][chosen], level[chosen]))
    return tracks


def _continue_track(
    seed: int,
    frames: range,
    in_frame: list[np.ndarray],
    cents: np.ndarray,
    level: np.ndarray,
    free: np.ndarray,
    max_step: float,
) -> list[int]:
    """Return the peaks that continue a track from its seed through successive frames.

    The next peak is the highest one within `max_step` [cents] of the median of the last
    five. The track ends at a gap of more than two frames.
    """
    median_length = 5
    max_gap = 2  # frames
    track = [seed]
    gap = 0
    for i in frames:
        near = in_frame[i][free[in_frame[i]]]
        expected = median(cents[track[-median_length:]].tolist())
        near = near[np.abs(cents[near] - expected) < max_step]
        if len(near):
            track.append(near[np.argmax(level[near])])
            gap = 0
        elif (gap := gap + 1) > max_gap:
            break
    return track[1:]


def _jackknife_errors(t: np.ndarray, cents: np.ndarray) -> np.ndarray:
    """Return the jackknife errors (2,) of the line fitted to cents (k,) at times (k,)."""
    max_jackknife_parts = 8
    min_frames_per_part = 3  # because the frames overlap
    part_count = min(max_jackknife_parts, max(len(t) // min_frames_per_part, 2))
    part = np.arange(len(t)) * part_count // len(t)
    others = [part != i for i in range(part[-1] + 1)]
    estimates = np.array(
        [_robust_linear_fit(t[other], cents[other]) for other in others]
    )
    return np.sqrt((len(estimates) - 1) * estimates.var(axis=0))


def _fit_line(
    track: PeakTrack, start: float, hop: float, bin_width: float
) -> SpectralLine:
    """Return the line with linear drift [cents/s] that fits a track, with jackknife
    errors."""
    min_peak_error = 0.02  # bins
    t = start + (track.frame + 1) * hop
    since_middle = t - (t[0] + t[-1]) / 2
    median_frequency = np.median(track.frequency)
    cents = 1200 * np.log2(track.frequency / median_frequency)
    intercept, drift = _robust_linear_fit(since_middle, cents)
    error = _jackknife_errors(since_middle, cents)
    min_error = BAND_GRID_SPACING_CENTS
    if not track.half_width:
        cents_per_ratio = 1200 / np.log(2)
        min_error = cents_per_ratio * min_peak_error * bin_width / median_frequency
    frequency = float(median_frequency * 2 ** (intercept / 1200))
    residual = cents - intercept - drift * since_middle
    return SpectralLine(
        frequency=frequency,
        error=float(np.hypot(error[0], min_error) * np.log(2) / 1200 * frequency),
        spread=float(1.48 * np.median(np.abs(residual))),
        level=float(np.median(track.level)),
        drift=float(drift),
        drift_error=float(np.hypot(error[1], min_error / (t[-1] - t[0]))),
        begin=float(t[0] - hop),
        end=float(t[-1] + hop),
        reach=track.half_width,
    )


def _robust_linear_fit(t: np.ndarray, cents: np.ndarray) -> np.ndarray:
    """Return intercept and slope of a linear fit of cents (k,) at times t (k,) [s]
    without outliers."""
    keep = np.ones(len(t), bool)
    for _ in range(3):
        slope, intercept = np.polyfit(t[keep], cents[keep], 1)
        residual = np.abs(cents - intercept - slope * t)
        keep = residual <= max(4 * 1.48 * np.median(residual), 1e-6)
    return np.array([intercept, slope])


def _find_sidebands(
    peaks: np.ndarray, bin_width: float
) -> tuple[np.ndarray, list[tuple[PeakTrack, np.ndarray]]]:
    """Return a mask of the peaks (3, n) that are sidebands, and the tracks and offsets
    of their centres.

    About a centre, pairs of peaks are symmetric at more different offsets than about
    nearby positions, and the offsets change smoothly with time."""
    min_offset_count = 5
    pairs = _peak_pairs(peaks)
    is_sideband = np.zeros(peaks.shape[1], bool)
    centres = []
    middle = peaks[1, pairs].mean(axis=0)
    offset = np.diff(peaks[1, pairs], axis=0)[0] / 2
    frame = peaks[0, pairs[0]].astype(int)
    level = peaks[2, pairs].min(axis=0)
    count, nearby_count = _count_offsets(middle / bin_width, offset / bin_width)
    trials = np.flatnonzero((count >= min_offset_count) & (count >= nearby_count))
    free = np.ones(len(count), bool)
    for trial in trials[np.argsort((nearby_count - count)[trials], kind="stable")]:
        centre = trial * bin_width / TRIAL_CENTRES_PER_BIN
        here = np.flatnonzero(
            (np.abs(middle - centre) < bin_width) & ~is_sideband[pairs].any(axis=0)
        )
        best = here[np.lexsort((-level[here], frame[here]))]
        best = best[np.unique(frame[best], return_index=True)[1]]
        if free[trial] and len(best) >= MIN_TRACK_FRAMES and _is_smooth(offset[best]):
            is_sideband[pairs[:, here]] = True
            first = max(trial - MIN_CENTRE_SEPARATION_STEPS, 0)
            free[first : trial + MIN_CENTRE_SEPARATION_STEPS] = False
            track = PeakTrack(frame[best], middle[best], level[best])
            centres.append((track, offset[best]))
    return is_sideband, centres


def _is_smooth(offsets: np.ndarray) -> bool:
    """Return True if the changes of offsets (k,) between frames are less than half of
    their total variation."""
    variation = np.median(np.abs(offsets - np.median(offsets)))
    return np.median(np.abs(np.diff(offsets))) < 0.5 * variation


def _count_offsets(
    middle: np.ndarray, offset: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the number of different offsets of symmetric pairs about each trial centre
    (p,), and the largest number about nearby trial centres.

    The middles (n,) and offsets (n,) of the pairs are in bins."""
    max_centre_distance = 80  # steps
    trial = np.round(TRIAL_CENTRES_PER_BIN * middle).astype(int)
    different = np.unique(trial * 1000 + offset.astype(int)) // 1000
    count = np.bincount(
        different, minlength=trial.max(initial=0) + max_centre_distance + 1
    )
    highest = maximum_filter1d(
        count, max_centre_distance - MIN_CENTRE_SEPARATION_STEPS + 1
    )
    shift = (MIN_CENTRE_SEPARATION_STEPS + max_centre_distance) // 2
    return count, np.maximum(np.roll(highest, shift), np.roll(highest, -shift))


def _peak_pairs(peaks: np.ndarray) -> np.ndarray:
    """Return the indices (2, n) of all pairs of peaks (3, m) in a frame that may be
    symmetric sidebands."""
    min_offset = 6.0  # Hz
    pairs = [np.zeros((2, 0), int)]
    for step in range(1, peaks.shape[1]):
        frames_apart, distance = peaks[:2, step:] - peaks[:2, :-step]
        near = (frames_apart == 0) & (distance < 2 * MAX_SIDEBAND_OFFSET_HZ)
        low = np.flatnonzero(near)
        if not len(low):
            break
        pairs.append(np.array([low, low + step])[:, distance[low] > 2 * min_offset])
    return np.concatenate(pairs, axis=1)
