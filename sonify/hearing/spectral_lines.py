"""Spectral lines and noise bands of a sound, with drift and sidebands."""

from dataclasses import dataclass, replace
from itertools import compress, pairwise
from statistics import median

import numpy as np
from scipy.interpolate import make_interp_spline
from scipy.ndimage import maximum_filter1d, median_filter, uniform_filter1d
from scipy.signal import ShortTimeFFT

from sonify.hearing.mains_hum import vertex

WINDOW, LOWEST = 0.5, 300.0
"""Window of the spectrogram [s] and lowest frequency of a line [Hz]."""
STANDS_OUT_DB, MOST, BANDS = 15.0, 12, 32
"""Least level of a peak above its neighbours [dB]; largest number of lines; number of
bands in which the background is computed."""
BESIDE_LINE = np.arange(10, 61)
"""Offsets of the bins on each side whose median is the background of a peak."""
REACH, LAST, GAP = 30.0, 5, 2
"""Largest distance of a peak from its track [cents]; number of final frames whose
median gives the position of a track; largest gap in a track [frames]."""
BAND, WIDE = 30.0, 15.0
"""A peak belongs to a stronger line if their distance is below BAND [cents] or below
WIDE times the change of the line from frame to frame, which is large in a noise
band."""
GRID, BROAD, FRAMES = 5.0, 120.0, 5
"""Spacing of the grid for noise bands [cents], width of the medians [cents], and number
of averaged frames."""
AROUND, COARSE = 1200.0, 10
"""Width of the background of a band [cents], and spacing of its coarser grid in units
of GRID."""
FAINTEST, HALF, AHEAD = 5.0, 3.0, 60.0
"""Least level of a band [dB]; drop of the level at its limits [dB]; largest distance
from its track [cents]."""
LINE, BROADEST = 75.0, 400.0
"""Largest half-width of a band that may be a line, and of any band [cents]."""
FEWEST, SHARE = 8, 0.2
"""Least number of frames of a line; in short sounds, least share of all frames, but at
least five."""
PARTS, LEAST_PART = 8, 3
"""Number of parts of a line for the jackknife, and least number of overlapping frames
in a part."""
PLACE = 0.02
"""Least error of the position of a line [bins]; that of a band is GRID."""
SURE = 2.0
"""Ratio of drift to error above which a line rises or falls."""
APART, FINE, BESIDE = (6.0, 300.0), 2, (6, 80)
"""Range of the distances of sidebands from their centre [Hz]; number of tested centres
per bin; range of the offsets of alternative centres, in units of their spacing."""
DISTANCES, COURSE, ORDER = 5, 0.5, 3
"""Least number of different sideband distances of a centre; largest ratio of the change
between frames to the total variation; largest order of a sideband."""


@dataclass(frozen=True, kw_only=True)
class Carrier:
    """A spectral line or narrow band from `begin` to `end` [s].

    `frequency` [Hz] is the frequency half-way, with the standard `error` [Hz]. `drift`
    and `drift_error` are in cents/s, the `spread` around the drift is in cents, and the
    `level` above the background in dB. `sidebands` is the median distance of the
    sidebands [Hz], and `rates` its range. If the line itself is not `heard`, these values belong to the
    centre of its sidebands. `reach` [cents] is the distance of a noise band to its
    farther half-power frequency, and 0 for a line."""

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
        if abs(self.drift) < SURE * self.drift_error:
            return "steady"
        return "rises" if self.drift > 0 else "falls"


@dataclass(frozen=True, eq=False)
class Track:
    """A tracked peak: frames (k,), frequencies (k,) [Hz], levels (k,) [dB] and
    half-width [cents]."""

    frame: np.ndarray
    frequency: np.ndarray
    level: np.ndarray
    reach: float = 0.0


def carriers(samples, rate: float, start: float = 0.0) -> list[Carrier]:
    """Return the lines in samples (n,) at `rate` [Hz] that start at the time `start`
    [s].

    There are at most MOST lines, sorted by decreasing level.
    """
    size = int(WINDOW * rate)
    if len(samples) < 4 * size:
        return []
    windows = ShortTimeFFT(np.hanning(size), size // 2, rate)
    power = (
        np.abs(windows.stft(samples, 1, 2 + (len(samples) - size) // (size // 2))) ** 2
    )  # no window extends beyond the samples
    hop = size // 2 / rate
    spacing = rate / size
    level = 10 * np.log10(power.T + 1e-300)
    peaks = _peaks(level, spacing)
    aside, centres = _sidebands(peaks, spacing)
    tracks = _with_bands(_tracks(peaks[:, ~aside], len(level)), level, spacing)
    tracks = sorted(tracks, key=lambda track: -np.median(track.level))
    found = [_carrier(track, start, hop, spacing) for track in tracks[:MOST]]
    for track, apart in centres:
        found = _with_sidebands(
            found, _carrier(track, start, hop, spacing), apart, spacing
        )
    return sorted(found, key=lambda one: -one.level)[:MOST]


def _with_sidebands(found, centre, apart, spacing):
    """Add a centre of sidebands, at distances `apart` (k,) [Hz], to the lines `found`.

    A line at the frequency of the centre receives the sidebands if it is present for
    most of their time; otherwise the centre becomes a separate line. Weaker lines among
    the sidebands are removed."""
    low, middle, high = np.percentile(apart, [5, 50, 95]).tolist()
    sides = {"sidebands": (middle,), "rates": (low, high)}
    there = [
        abs(one.frequency - centre.frequency) < spacing and _common(one, centre) > 0
        for one in found
    ]
    heard = (
        sum(_common(one, centre) for one in compress(found, there))
        > (centre.end - centre.begin) / 2
    )
    told = [replace(one, **sides) if heard else one for one in compress(found, there)]
    others = [
        one
        for one, at in zip(found, there, strict=True)
        if not at and not _among(one, centre, ORDER * high)
    ]
    return [*told, *others, *([] if heard else [replace(centre, heard=False, **sides)])]


def _among(one, centre, reach):
    """Return True if a weaker line is within `reach` [Hz] of a centre for most of its
    duration."""
    within = (
        abs(one.frequency - centre.frequency) < reach
        and _common(one, centre) > (one.end - one.begin) / 2
    )
    return within and one.level < centre.level


def _common(one, other):
    """Return the time [s] for which two lines overlap; negative if they do not
    overlap."""
    return min(one.end, other.end) - max(one.begin, other.begin)


def _floor(level, count):
    """Return the background (t, f) interpolated between the medians of `count` bands.

    It is at most 90 dB below the maximum.
    """
    edges = np.linspace(0, level.shape[1], count + 1).astype(int)
    floor = np.column_stack(
        [np.median(level[:, a:b], axis=1) for a, b in pairwise(edges)]
    )
    floor = np.maximum(floor, level.max(axis=1, keepdims=True) - 90)
    middle = (edges[1:] + edges[:-1] - 1) / 2
    return make_interp_spline(middle, floor, 1, axis=1)(
        np.clip(np.arange(level.shape[1]), middle[0], middle[-1])
    )


def _peaks(level, spacing):
    """Return frames, frequencies [Hz] and levels [dB] (3, n) of all peaks in levels (t,
    f).

    The levels are relative to the background.
    """
    frame, place, height = _tops(level - _floor(level, BANDS), STANDS_OUT_DB)
    top = np.round(place).astype(int)
    sides = [
        np.median(
            level[frame[:, None], np.clip(top[:, None] + side, 0, level.shape[1] - 1)],
            axis=1,
        )
        for side in (-BESIDE_LINE, BESIDE_LINE)
    ]
    line = (
        level[frame, top] - np.maximum(*sides) > STANDS_OUT_DB
    )  # an edge stands out on one side only
    return np.array([frame, place * spacing, height])[
        :, line & (place > LOWEST / spacing)
    ]


def _tops(level, least):
    """Return frames, fractional columns and heights, each (n,), of peaks in levels (t,
    f).

    Peaks are at least `least` high.
    """
    low = level[:, :-2]
    top = level[:, 1:-1]
    high = level[:, 2:]
    frame, place = np.nonzero((top > low) & (top >= high) & (top > least))
    low = low[frame, place]
    top = top[frame, place]
    high = high[frame, place]
    return frame, place + 1 + vertex(low, top, high), top


def _with_bands(tracks, level, spacing):
    """Return the tracks of lines and of noise bands in levels (t, f).

    A line that does not stand out from a band is part of the band; a band that
    resembles a line is part of the line."""
    for band in _bands(level, spacing):
        line = band.reach < LINE
        inside = [
            track
            for track in tracks
            if _within(track, band, band.reach if line else 2 * band.reach)
        ]
        loudest = max(inside, key=lambda track: np.median(track.level), default=None)
        bar = np.median(band.level) + STANDS_OUT_DB
        own = [
            track
            for track in inside
            if np.median(track.level) > bar or (line and track is loudest)
        ]
        tracks = [track for track in tracks if track not in inside or track in own]
        tracks += [] if line else _straight(band)
    return tracks


def _bands(level, spacing):
    """Return the tracks of noise bands in levels (t, f)."""
    octaves = np.log2(0.9 * level.shape[1] * spacing / LOWEST)
    size = int(BROAD / GRID) + 1
    frequency = LOWEST * 2 ** (np.arange(0, 1200 * octaves, GRID) / 1200)
    grid = _medians(level[:, np.round(frequency / spacing).astype(int)], size)
    around = _medians(grid[:, ::COARSE], int(AROUND / GRID / COARSE) + 1)
    places = np.arange(0, grid.shape[1], COARSE)
    grid -= make_interp_spline(places, around, 1, axis=1)(
        np.clip(np.arange(grid.shape[1]), 0, places[-1])
    )
    grid = uniform_filter1d(grid, size, axis=1)
    mean = uniform_filter1d(grid, FRAMES, axis=0)
    frame, place, height = _tops(mean, FAINTEST)
    found = _tracks(
        np.array([frame, LOWEST * 2 ** (place * GRID / 1200), height]),
        len(level),
        AHEAD,
    )
    return [
        band
        for band in (_middled(one, mean, grid) for one in found)
        if band.reach < BROADEST
    ]


def _medians(level, size):
    """Return running medians of levels (t, f) over `size` columns."""
    return np.array([median_filter(row, size) for row in level])


def _middled(band, mean, grid):
    """Return a band with power-weighted mean frequencies and its median half-width."""
    tops = np.round(1200 / GRID * np.log2(band.frequency / LOWEST)).astype(int)
    middles = []
    sides = []
    for row, own, top in zip(mean[band.frame], grid[band.frame], tops, strict=True):
        out = np.flatnonzero(row < row[top] - HALF)
        low = out[out < top].max(initial=-1) + 1
        high = out[out > top].min(initial=len(row))
        middles.append(
            np.average(np.arange(low, high), weights=10 ** (own[low:high] / 10))
        )
        sides.append(max(middles[-1] - low, high - middles[-1]))
    return replace(
        band,
        frequency=LOWEST * 2 ** (np.array(middles) * GRID / 1200),
        reach=GRID * median(sides),
    )


def _within(track, band, reach):
    """Return True if a track is within `reach` [cents] of a band in most of its
    frames."""
    middle = np.interp(track.frame, band.frame, band.frequency, np.nan, np.nan)
    return (
        np.sum(np.abs(1200 * np.log2(track.frequency / middle)) < reach)
        > len(track.frame) / 2
    )


def _straight(track):
    """Return the parts of a track after repeated bisection into straight parts."""
    half = len(track.frame) // 2
    parts = [
        replace(
            track,
            frame=track.frame[i],
            frequency=track.frequency[i],
            level=track.level[i],
        )
        for i in (slice(half), slice(half, None))
    ]
    if half < FEWEST or _alike(*(_carrier(part, 0.0, 1.0, 0.0) for part in parts)):
        return [track]
    return [straight for part in parts for straight in _straight(part)]


def _alike(one, other):
    """Return True if the drifts of two lines agree within their errors."""
    return abs(one.drift - other.drift) < SURE * np.hypot(
        one.drift_error, other.drift_error
    )


def _tracks(peaks, count, reach=REACH):
    """Return the tracks of peaks (3, n), starting from the most prominent peak.

    A track continues at peaks within `reach` [cents]; the peaks in the band around it
    are removed."""
    frame = peaks[0].astype(int)
    cents = 1200 * np.log2(peaks[1])
    level = peaks[2]
    inside = [np.flatnonzero(frame == i) for i in range(count)]
    left = np.ones(len(frame), bool)
    found = []
    for seed in np.argsort(-level):
        if not left[seed]:
            continue
        chosen = [
            seed,
            *_followed(
                seed, range(frame[seed] + 1, count), inside, cents, level, left, reach
            ),
        ]
        chosen += _followed(
            seed, range(frame[seed] - 1, -1, -1), inside, cents, level, left, reach
        )
        chosen = np.array(sorted(chosen, key=lambda peak: frame[peak]))
        wide = max(
            BAND, WIDE * np.median(np.abs(np.diff(cents[chosen], prepend=cents[seed])))
        )
        for peak in chosen:
            near = inside[frame[peak]]
            left[near[np.abs(cents[near] - cents[peak]) < wide]] = False
        if len(chosen) >= min(FEWEST, max(5, SHARE * count)):
            found.append(Track(frame[chosen], peaks[1][chosen], level[chosen]))
    return found


def _followed(seed, frames, inside, cents, level, left, reach):
    """Return the peaks that continue a seed in successive frames, with gaps of at most
    GAP frames.

    The highest peak near the median of the last ones continues the track.
    """
    found = [seed]
    missed = 0
    for i in frames:
        near = inside[i][left[inside[i]]]
        near = near[np.abs(cents[near] - median(cents[found[-LAST:]].tolist())) < reach]
        if len(near):
            found.append(near[np.argmax(level[near])])
            missed = 0
        elif (missed := missed + 1) > GAP:
            break
    return found[1:]


def _carrier(track, start, hop, spacing):
    """Return the straight line fitted to the cents of a track, with jackknife
    errors."""
    t = start + (track.frame + 1) * hop
    middle = (t[0] + t[-1]) / 2
    cents = 1200 * np.log2(track.frequency / np.median(track.frequency))
    line = _line(t - middle, cents)
    part = np.arange(len(t)) * min(PARTS, max(len(t) // LEAST_PART, 2)) // len(t)
    without = np.array(
        [_line((t - middle)[part != i], cents[part != i]) for i in range(part[-1] + 1)]
    )
    error = np.sqrt(
        (len(without) - 1)
        / len(without)
        * np.square(without - without.mean(axis=0)).sum(axis=0)
    )
    place = (
        GRID
        if track.reach
        else 1200 / np.log(2) * PLACE * spacing / np.median(track.frequency)
    )
    frequency = float(np.median(track.frequency) * 2 ** (line[0] / 1200))
    return Carrier(
        frequency=frequency,
        error=float(np.hypot(error[0], place) * np.log(2) / 1200 * frequency),
        spread=float(
            1.48 * np.median(np.abs(cents - line[0] - line[1] * (t - middle)))
        ),
        level=float(np.median(track.level)),
        drift=float(line[1]),
        drift_error=float(np.hypot(error[1], place / (t[-1] - t[0]))),
        begin=float(t[0] - hop),
        end=float(t[-1] + hop),
        reach=track.reach,
    )


def _line(t, cents):
    """Return height and slope of a robust linear fit of cents (k,) at times t (k,)
    [s]."""
    keep = np.ones(len(t), bool)
    for _ in range(3):
        slope, height = np.polyfit(t[keep], cents[keep], 1)
        apart = np.abs(cents - height - slope * t)
        keep = apart <= max(4 * 1.48 * np.median(apart), 1e-6)
    return np.array([height, slope])


def _sidebands(peaks, spacing):
    """Return a mask of the peaks (3, n) that are sidebands, and the tracks and
    distances of centres.

    Pairs of peaks are symmetric about a centre at more distances than about positions
    BESIDE it, and the distances change smoothly; the centre between two unrelated lines
    would move."""
    pairs = _pairs(peaks)
    aside = np.zeros(peaks.shape[1], bool)
    found = []
    middle = peaks[1, pairs].mean(axis=0)
    half = np.diff(peaks[1, pairs], axis=0)[0] / 2
    frame = peaks[0, pairs[0]].astype(int)
    level = peaks[2, pairs].min(axis=0)
    count, most = _distances(middle / spacing, half / spacing)
    tried = np.flatnonzero((count >= DISTANCES) & (count >= most))
    free = np.ones(len(count), bool)
    for place in tried[np.argsort((most - count)[tried], kind="stable")]:
        here = np.flatnonzero(
            (np.abs(middle - place * spacing / FINE) < spacing)
            & ~aside[pairs].any(axis=0)
        )
        best = here[np.lexsort((-level[here], frame[here]))]
        best = best[np.unique(frame[best], return_index=True)[1]]
        if free[place] and len(best) >= FEWEST and _one_course(half[best]):
            aside[pairs[:, here]] = True
            free[max(place - BESIDE[0], 0) : place + BESIDE[0]] = False
            found.append((Track(frame[best], middle[best], level[best]), half[best]))
    return aside, found


def _one_course(apart):
    """Return True if distances (k,) change smoothly between frames."""
    return np.median(np.abs(np.diff(apart))) < COURSE * np.median(
        np.abs(apart - np.median(apart))
    )


def _distances(middle, half):
    """Return the number of distances of symmetric pairs about each position (p,).

    The largest number about positions BESIDE it is also returned. The centres and half
    distances (n,) of the pairs are in bins."""
    place = np.round(FINE * middle).astype(int)
    seen = np.unique(place * 1000 + half.astype(int)) // 1000
    count = np.bincount(seen, minlength=place.max(initial=0) + BESIDE[1] + 1)
    around = maximum_filter1d(count, BESIDE[1] - BESIDE[0] + 1)
    away = sum(BESIDE) // 2
    return count, np.maximum(np.roll(around, away), np.roll(around, -away))


def _pairs(peaks):
    """Return the indices (2, n) of all pairs of peaks (3, m) in a frame with half
    distances in APART."""
    found = [np.zeros((2, 0), int)]
    for step in range(1, peaks.shape[1]):
        frame, apart = peaks[:2, step:] - peaks[:2, :-step]
        low = np.flatnonzero((frame == 0) & (apart < 2 * APART[1]))
        if not len(low):
            break
        found.append(np.array([low, low + step])[:, apart[low] > 2 * APART[0]])
    return np.concatenate(found, axis=1)
