"""SOUND -> CARRIERS: peaks of the spectrum that last, how far and how fast each of them moves, and its sidebands."""

from dataclasses import dataclass, replace
from itertools import pairwise
from statistics import median

import numpy as np
from scipy.signal import ShortTimeFFT

from sonify.hearing.hum import vertex

WINDOW, LOWEST = 0.5, 300.0
"""Window in which carriers are told apart [s], and where they begin [Hz]."""
STANDS_OUT_DB, MOST = 15.0, 12
"""A peak stands out by as much; carriers at most."""
REACH, LAST, GAP = 30.0, 5, 2
"""A carrier is so many cents from the middle of its LAST frames at most; so many frames may not show it."""
BAND, WIDE = 30.0, 15.0
"""What is so many cents from a stronger carrier is part of it, or so many times as far as this goes from frame to
frame, which is far in a band of noise."""
MANY = 48
"""So many of the most outstanding tracks are looked at: speech has hundreds."""
FEWEST, SHARE = 8, 0.2
"""Frames that show a carrier: so many, or so large a share of them all and at least five."""
PARTS, LEAST_PART = 8, 3
"""Parts of a carrier for the jackknife, of so many frames at least: neighbours share half of what they hear."""
PLACE = 0.02
"""Error of the place of a peak between the bins of the spectrum, over their spacing, that no carrier is without."""
SURE = 2.0
"""A carrier rises or falls if its drift is so many times its error."""
MIRRORED = 1.5
"""Two peaks are sidebands of the one between them if their distances to it differ by so many bins at most, median."""


@dataclass(frozen=True, kw_only=True)
class Carrier:
    """A tone or narrow band from `begin` to `end` [s]: its `frequency` in the middle and the standard `error` [Hz], its
    `drift` and `drift_error` [cents/s], its `spread` about the drift [cents], how far it stands out (`level` [dB]), and
    how far from it its sidebands are [Hz]."""

    frequency: float
    error: float
    spread: float
    level: float
    drift: float
    drift_error: float
    begin: float
    end: float
    sidebands: tuple[float, ...] = ()

    @property
    def course(self) -> str:
        """What it does: rises, falls or is steady, as far as its errors tell."""
        if abs(self.drift) < SURE * self.drift_error:
            return "steady"
        return "rises" if self.drift > 0 else "falls"


@dataclass(frozen=True, eq=False)
class Track:
    """A peak that was followed: frames (k,), frequencies (k,) [Hz] and levels (k,) [dB]."""

    frame: np.ndarray
    frequency: np.ndarray
    level: np.ndarray


def carriers(samples, rate: float, start: float = 0.0) -> list[Carrier]:
    """Return the carriers in samples (n,) at `rate` [Hz] from the time `start` [s] on, the most outstanding first; at
    most MOST."""
    size = int(WINDOW * rate)
    if len(samples) < 4 * size:
        return []
    windows = ShortTimeFFT(np.hanning(size), size // 2, rate)
    power = np.abs(windows.stft(samples, 1, 2 + (len(samples) - size) // (size // 2))) ** 2  # none beyond the samples
    peaks = _peaks(10 * np.log10(power.T + 1e-300), rate / size)
    tracks = sorted(_tracks(peaks, power.shape[1]), key=lambda track: -np.median(track.level))
    hop, spacing = size // 2 / rate, rate / size
    tracks = tracks[:MANY]
    found, apart = [], _sidebands(tracks, spacing)
    for i, track in enumerate(tracks):
        if not any(i in pair for pairs in apart.values() for pair, _ in pairs):
            beside = tuple(distance for _, distance in apart.get(i, ()))
            found.append(replace(_carrier(track, start, hop, spacing), sidebands=beside))
    return found[:MOST]


def _floor(level):
    """The median level (t, f) in 32 neighbouring bands of each frame, not more than 90 dB below its highest."""
    edges = np.linspace(0, level.shape[1], 33).astype(int)
    floor = np.column_stack([np.median(level[:, a:b], axis=1) for a, b in pairwise(edges)])
    floor = np.maximum(floor, level.max(axis=1, keepdims=True) - 90)
    return np.repeat(floor, np.diff(edges), axis=1)


def _peaks(level, spacing):
    """Frames, frequencies [Hz] and levels above the floor [dB] (3, n) of all peaks that stand out."""
    above = level - _floor(level)
    low, top, high = level[:, :-2], level[:, 1:-1], level[:, 2:]
    here = (top > low) & (top >= high) & (above[:, 1:-1] > STANDS_OUT_DB)
    here[:, : int(LOWEST / spacing)] = False
    frame, place = np.nonzero(here)
    between = vertex(low[frame, place], top[frame, place], high[frame, place])
    return np.array([frame, (place + 1 + between) * spacing, above[frame, place + 1]])


def _tracks(peaks, count):
    """The tracks of peaks (3, n) through frames, from the most outstanding peak on; each takes the band around it."""
    frame, cents, level = peaks[0].astype(int), 1200 * np.log2(peaks[1]), peaks[2]
    inside = [np.flatnonzero(frame == i) for i in range(count)]
    left, found = np.ones(len(frame), bool), []
    for seed in np.argsort(-level):
        if not left[seed]:
            continue
        chosen = [seed, *_followed(seed, range(frame[seed] + 1, count), inside, cents, level, left)]
        chosen += _followed(seed, range(frame[seed] - 1, -1, -1), inside, cents, level, left)
        chosen = np.array(sorted(chosen, key=lambda peak: frame[peak]))
        wide = max(BAND, WIDE * np.median(np.abs(np.diff(cents[chosen], prepend=cents[seed]))))
        for peak in chosen:
            near = inside[frame[peak]]
            left[near[np.abs(cents[near] - cents[peak]) < wide]] = False
        if len(chosen) >= min(FEWEST, max(5, SHARE * count)):
            found.append(Track(frame[chosen], peaks[1][chosen], level[chosen]))
    return found


def _followed(seed, frames, inside, cents, level, left):
    """The peaks that continue a seed in frames, one after the other, until GAP of them show none: the highest that is
    near the middle of the last ones."""
    found, missed = [seed], 0
    for i in frames:
        near = inside[i][left[inside[i]]]
        near = near[np.abs(cents[near] - median(cents[found[-LAST:]].tolist())) < REACH]
        if len(near):
            found.append(near[np.argmax(level[near])])
            missed = 0
        elif (missed := missed + 1) > GAP:
            break
    return found[1:]


def _carrier(track, start, hop, spacing):
    """The carrier of a track: a straight line through its cents, with errors by leaving out part after part."""
    t = start + (track.frame + 1) * hop
    middle = (t[0] + t[-1]) / 2
    cents = 1200 * np.log2(track.frequency / np.median(track.frequency))
    line = _line(t - middle, cents)
    part = np.arange(len(t)) * min(PARTS, max(len(t) // LEAST_PART, 2)) // len(t)
    without = np.array([_line((t - middle)[part != i], cents[part != i]) for i in range(part[-1] + 1)])
    error = np.sqrt((len(without) - 1) / len(without) * np.square(without - without.mean(axis=0)).sum(axis=0))
    place = 1200 / np.log(2) * PLACE * spacing / np.median(track.frequency)
    frequency = float(np.median(track.frequency) * 2 ** (line[0] / 1200))
    return Carrier(
        frequency=frequency,
        error=float(np.hypot(error[0], place) * np.log(2) / 1200 * frequency),
        spread=float(1.48 * np.median(np.abs(cents - line[0] - line[1] * (t - middle)))),
        level=float(np.median(track.level)),
        drift=float(line[1]),
        drift_error=float(np.hypot(error[1], place / (t[-1] - t[0]))),
        begin=float(t[0] - hop),
        end=float(t[-1] + hop),
    )


def _line(t, cents):
    """Height and slope of the straight line through cents (k,) at times t (k,) [s], without what is far from it."""
    keep = np.ones(len(t), bool)
    for _ in range(3):
        slope, height = np.polyfit(t[keep], cents[keep], 1)
        apart = np.abs(cents - height - slope * t)
        keep = apart <= max(4 * 1.48 * np.median(apart), 1e-6)
    return np.array([height, slope])


def _sidebands(tracks, spacing):
    """For the number of each track that has some: the pairs of weaker tracks that mirror each other on it, and their
    median distance from it [Hz]."""
    found: dict[int, list] = {}
    for i, track in enumerate(tracks):
        weaker = range(i + 1, len(tracks))
        for low in weaker:
            for high in weaker:
                below, at, above = _together(tracks[low], track, tracks[high])
                if len(at) < 5 or not (below < at).all() or not (above > at).all():
                    continue
                if np.median(np.abs(above + below - 2 * at)) < MIRRORED * spacing:
                    found.setdefault(i, []).append(((low, high), float(np.median(above - below) / 2)))
    return found


def _together(*tracks):
    """The frequencies (k,) of tracks in the frames that they have in common."""
    common = set.intersection(*(set(track.frame.tolist()) for track in tracks))
    return [np.array([f for i, f in zip(track.frame, track.frequency, strict=True) if i in common]) for track in tracks]
