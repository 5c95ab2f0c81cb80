"""Detection of drops in the power of a sound, at which a run may end."""

import numpy as np
from scipy.ndimage import uniform_filter1d
from scipy.signal import find_peaks

from sonify.hearing.settling.onset_strength import TINY_POWER, Frames


def end_drops(frames: Frames) -> np.ndarray:
    """Return the largest drop [dB] of the power at every frame (n,), over all bands
    together, the waveform and single bands.

    Power more than 20 dB below the mean of the sound is ignored in the waveform and in
    single bands."""
    total = frames.power.sum(axis=1)
    power_floor = 0.01 * float(total.mean(dtype=float)) + TINY_POWER
    waveform = np.square(frames.waveform)
    drops = [
        power_drop(total, TINY_POWER),
        power_drop(waveform, 0.01 * float(waveform.mean()) + TINY_POWER),
    ]
    drops += [power_drop(band, power_floor) for band in frames.power.T]
    return np.max(drops, axis=0)


def power_drop(power: np.ndarray, power_floor: float) -> np.ndarray:
    """Return the drop [dB] of a power (n,) at every frame.

    It compares the 80 ms before the frame with the interval from 30 to 130 ms after it;
    `power_floor` is added to both powers."""
    cumulative = np.concatenate([[0.0], np.cumsum(power, dtype=float)])
    count = len(power)
    place = np.arange(count)

    def mean(first: np.ndarray, last: np.ndarray) -> np.ndarray:
        first = np.clip(first, 0, count)
        last = np.clip(last, 0, count)
        return (cumulative[last] - cumulative[first]) / np.maximum(last - first, 1)

    before = np.maximum(mean(place - 80, place), 0) + power_floor
    after = np.maximum(mean(place + 30, place + 130), 0) + power_floor
    drop = 10 * np.log10(before / after)
    drop[: min(80, count)] = 0
    drop[max(count - 60, 0) :] = 0
    return drop


def drop_peaks(drop: np.ndarray, min_drop: float) -> np.ndarray:
    """Return the frames of peaks of at least `min_drop` dB and 40 frames apart, highest
    first."""
    peaks, _ = find_peaks(drop, height=min_drop, distance=40)
    return peaks[np.argsort(-drop[peaks], kind="stable")]


def knee(power: np.ndarray, end: int) -> int:
    """Return the frame near an end at which the level of a power (n,) begins its final
    fall.

    Two straight lines that meet there are fitted to the level. If the second line never
    falls steeply, the end itself is returned."""
    smooth = uniform_filter1d(power.astype(float), 5)
    level = 10 * np.log10(smooth + TINY_POWER)
    floor = (
        10 * np.log10(power[end + 30 : end + 130].mean(dtype=float) + TINY_POWER) + 6
    )
    quiet = np.flatnonzero(level[max(end - 80, 0) : end + 130] <= floor)
    last = max(end - 80, 0) + (int(quiet[0]) if len(quiet) else 130)
    places = np.arange(max(end - 300, 0), min(max(last, end - 40), len(power)))
    levels = level[places]
    best = np.inf
    found = end
    for corner in range(
        max(end - 150, places[0] + 10), min(end + 60, int(places[-1]) - 4), 2
    ):
        before = np.minimum(places - corner, 0) / 100
        after = np.maximum(places - corner, 0) / 100
        columns = np.stack([np.ones(len(places)), before, after], axis=1)
        coefficients = np.linalg.lstsq(columns, levels)[0]
        misfit = float(np.abs(levels - columns @ coefficients).sum())
        if coefficients[2] < -20 and misfit < best:
            best = misfit
            found = corner
    return found
