"""Nutation and precession frequencies of a motion, and the times at which it slips."""

from functools import lru_cache

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

from dynamics import kinematics
from dynamics.disk import Disk
from dynamics.motion import Motion, piece_ends_and_middles


def lossless_rolling_load(disk: Disk, state: np.ndarray) -> np.ndarray:
    """Return the normal force of free rolling over the weight (k,) at states (k, 11).

    It follows from the inclination, omega_2 and omega_3 by the second of (5.3) without
    moments. It excludes contact and table vibrations, has no jumps, and has one peak
    per nutation.
    """
    h = disk.aspect
    K = disk.gyration
    sin_a = np.cos(state[:, 1])
    cos_a = np.sin(state[:, 1])
    e, f = kinematics.contact_arms(sin_a, cos_a, h)
    w2 = state[:, 6] * disk.time_unit
    w3 = state[:, 7] * disk.time_unit
    gyroscopic = w3 * (2 * w2 - (1 + 4 * h * h / (3 * K)) * w3 * sin_a / cos_a)
    gyroscopic += 4 * e / K * w3 / cos_a * (w2 - h * w3)
    inertia = 1 + 4 / K + 16 * h * h / (3 * K)
    acceleration = (gyroscopic - f * (1 + 4 / K)) / inertia
    return 1 + 4 / (K + 4) * f * acceleration


@lru_cache(maxsize=1)
def nutation_peaks(
    motion: Motion,
) -> np.ndarray:
    """Return the times (p,) [s] of the peaks of `lossless_rolling_load`.

    A peak that is small, or much less prominent than its neighbours, is ignored,
    because slips and a hopping contact cause small additional peaks. A parabola through
    three points refines the times.
    """
    min_prominence = 0.005  # as a fraction of the weight
    min_relative_prominence = 0.5  # relative to the median of the neighbours
    neighbour_count = 11

    def load_at(t: np.ndarray) -> np.ndarray:
        return lossless_rolling_load(motion.disk, motion.at(t))

    t = piece_ends_and_middles(motion)
    flat = np.flatnonzero(motion.at(t)[:, 1] <= 0)
    t = t[: flat[0] if len(flat) else None]
    peaks, found = find_peaks(load_at(t)[:-1], prominence=min_prominence)
    prominences = found["prominences"]
    usual = median_filter(prominences, neighbour_count)
    peaks = t[peaks[prominences >= min_relative_prominence * usual]]
    if len(peaks) < 2:
        return peaks
    gaps = np.diff(peaks)
    reach = np.minimum(np.append(gaps[0], gaps), np.append(gaps, gaps[-1])) / 8
    reach = np.minimum(reach, np.minimum(peaks - t[0], t[-1] - peaks))
    before = load_at(peaks - reach)
    there = load_at(peaks)
    after = load_at(peaks + reach)
    bend = before - 2 * there + after
    round_ = bend < 0
    shift = np.zeros(len(peaks))
    shift[round_] = np.clip((before - after)[round_] / (2 * bend[round_]), -1, 1)
    return peaks + reach * shift


@lru_cache(maxsize=1)
def _nutations(motion: Motion) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times (q,) [s], nutation frequencies (q,) [Hz] and nutations per turn.

    The frequency is 2/T of footnote 3, where T is the duration of two successive
    periods. The last two results are NaN where the peaks are not caused by nutation.
    """
    peaks = nutation_peaks(motion)
    if len(peaks) < 3:
        return np.zeros(0), np.zeros(0), np.zeros(0)
    precession = motion.at(peaks)[:, 0]
    turned = np.abs(precession[2:] - precession[:-2]) / (2 * np.pi)
    ratio = 2 / np.maximum(turned, np.finfo(float).tiny)
    frequency = 2 / (peaks[2:] - peaks[:-2])
    kept = _near_recent_median(ratio)
    kept[kept] = _is_sustained(peaks[1:-1][kept], frequency[kept])
    return peaks[1:-1], np.where(kept, frequency, np.nan), np.where(kept, ratio, np.nan)


def _near_recent_median(ratio: np.ndarray) -> np.ndarray:
    """Return a mask (q,) of the ratios close to the median of recently accepted ratios.

    The number of nutations per turn varies slowly. Peaks caused by the table occur once
    per turn, and peaks caused by roughness occur at random.
    """
    tolerance = 0.15
    remembered_count = 15
    is_close = np.zeros(len(ratio), bool)
    recent = list(ratio[:remembered_count])
    for i, value in enumerate(ratio):
        median = float(np.median(recent))
        is_close[i] = abs(np.log(value / median)) < tolerance
        if is_close[i]:
            recent = [*recent[1:], value]
    return is_close


def _is_sustained(time: np.ndarray, frequency: np.ndarray) -> np.ndarray:
    """Return a mask (q,) of the samples that belong to sustained oscillations.

    The samples are frequencies (q,) [Hz] at times (q,) [s]. Gaps of several periods
    separate intervals. The mask selects the interval with the most samples and all
    other long intervals, because a few peaks of a rough contact may resemble nutation
    by chance.
    """
    max_gap = 5.0  # periods
    min_samples = 15
    if not len(time):
        return np.zeros(0, bool)
    is_gap = np.diff(time) * frequency[:-1] > max_gap
    stretch = np.append(0, np.cumsum(is_gap))
    sizes = np.bincount(stretch)
    counts = (sizes >= min_samples) | (np.arange(len(sizes)) == sizes.argmax())
    return counts[stretch]


def nutation_frequency(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Return times (q,) [s] and nutation frequencies (q,) [Hz] while the disk nutates.

    The frequency is 2/T of footnote 3 of the paper, where T is the duration of two
    periods between peaks of `lossless_rolling_load`. On a rigid table these are the peaks
    of the normal force.
    """
    time, frequency, _ = _nutations(motion)
    nutates = np.isfinite(frequency)
    return time[nutates], frequency[nutates]


def nutation_end_time(motion: Motion) -> float | None:
    """Return the time [s] of the last nutation, or None if nutation never ends.

    It has ended if the motion continues without it for several periods.
    """
    min_missing_periods = 10.0
    time, frequency = nutation_frequency(motion)
    if not len(time) or (motion.t[-1] - time[-1]) * frequency[-1] < min_missing_periods:
        return None
    return float(time[-1])


def nutations_per_turn(motion: Motion) -> np.ndarray:
    """Return the nutations per turn (q,) at the times of `nutation_frequency`."""
    ratio = _nutations(motion)[2]
    return ratio[np.isfinite(ratio)]


def precession_frequency(
    motion: Motion,
) -> tuple[np.ndarray, np.ndarray]:
    """Return times (q,) [s] and precession frequencies (q,) [Hz] without the nutation.

    Mean frequencies over little more than a turn, at intervals of a quarter turn, are
    averaged over a second window, which is shorter near both ends. This reduces the
    effect of nutation to less than 1 %. A motion shorter than one window yields its
    mean frequency.
    """
    window_turns = 1.25  # turns
    spacing_turns = 0.25  # turns
    t = motion.t
    precession = motion.state[:, 0]
    turned = np.maximum.accumulate(np.abs(precession - precession[0])) / (2 * np.pi)
    begin = np.arange(0, turned[-1] - window_turns, spacing_turns)
    first = np.interp(begin, turned, t)
    last = np.interp(begin + window_turns, turned, t)
    if not len(begin):
        first = t[:1]
        last = t[-1:]
    turned = np.abs(motion.at(last)[:, 0] - motion.at(first)[:, 0]) / (2 * np.pi)
    frequency = turned / (last - first)
    k = np.arange(len(frequency))
    half = np.minimum(np.minimum(k, k[::-1]), round(window_turns / spacing_turns) // 2)
    summed = np.append(0.0, np.cumsum(frequency))
    return (first + last) / 2, (summed[k + half + 1] - summed[k - half]) / (
        2 * half + 1
    )


def plotted_rates(
    motion: Motion,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times (q,) [s], precession and nutation frequencies (q,) [Hz] for a plot.

    The nutation frequency is a running median; it is NaN where the disk does not
    nutate, or only for a few periods, because peaks of another cause may resemble them.
    """
    median_length = 5
    min_run = 8  # successive frequencies
    time, precession = precession_frequency(motion)
    at, nutation, _ = _nutations(motion)
    if not len(at):
        return time, precession, np.full(len(time), np.nan)
    kept = np.isfinite(nutation)
    smooth = np.full(len(at), np.nan)
    smooth[kept] = median_filter(nutation[kept], median_length, mode="nearest")
    run = np.cumsum(np.diff(kept, prepend=kept[0]))
    smooth[np.bincount(run)[run] < min_run] = np.nan
    both = np.unique(np.concatenate([time, at]))
    nutation = np.interp(both, at, smooth, left=np.nan, right=np.nan)
    return both, np.interp(both, time, precession), nutation


def precession_rate(state: np.ndarray) -> np.ndarray:
    """Return the precession rate (2.3), (k,) [rad/s], at states (k, 11)."""
    return kinematics.precession_rate(state[:, 7], np.sin(state[:, 1]))


def slip_start_times(motion: Motion) -> np.ndarray:
    """Return the times (j,) [s] at which rolling changes to sliding."""
    return np.array(
        [
            event.t
            for event in motion.transitions
            if event.before.startswith("roll") and event.after.startswith("slide")
        ]
    )
