"""Numbers that are compared between a recording and the simulated sound of a scene."""

from dataclasses import asdict
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.ndimage import uniform_filter1d
from scipy.signal import find_peaks, welch
from scipy.stats import t as student

from dynamics.a_weighting import a_weighting_db
from dynamics.observables import precession_frequency
from sonify.fitting.settings import FIT
from sonify.hearing.audio_source import AudioSource, loudest_channel, read_samples
from sonify.hearing.settling.detector import SettlingRun, settling_runs
from sonify.hearing.spectrogram import spectrogram
from sonify.hearing.time_frequency import baseband
from sonify.pipeline import solve
from sonify.scene import Scene


def simulated_numbers(scene: Scene, seconds: float) -> dict[str, Any]:
    """Return the numbers of the last `seconds` [s] of a simulated scene.

    The numbers on bursts are those of a run detected in the simulated sound, as in a
    recording. The turns follow from the motion, and so does the exponent if no run is
    detected.
    """
    result = solve(scene)
    sound = result.sound
    motion = result.motion.rolling
    time, rate = precession_frequency(motion)
    end = float(motion.t[-1])
    heard = settling_runs(sound.pressure)
    span = min(1.0, seconds)
    turns = _exact_value(np.interp(end - span, time, rate))
    if heard:
        near = min(heard, key=lambda run: abs(run.heard_until - sound.source_end))
        head = _numbers_of_bursts(near, span)
    else:
        head = {
            "rate_at_1s": {"value": None, "low": 0.0, "high": 2 * turns["value"]},
            "exponent": _exact_value(_exponent_of_turns(end - time, rate, seconds)),
            "events_per_turn": _bursts_per_turn(None),
        }
    return (
        head
        | {"turns_at_1s": turns}
        | sound_numbers(sound.pressure, sound.source_end - seconds, sound.source_end)
    )


def _exponent_of_turns(
    remaining: np.ndarray, rate: np.ndarray, seconds: float
) -> float:
    """Return the exponent n of rates (k,) that rise as remaining^-n until 0.1 s before
    the end."""
    last = (remaining > 0.1) & (remaining < seconds)
    even = np.geomspace(remaining[last].min(), remaining[last].max(), 100)
    logarithm = np.interp(even, remaining[::-1], np.log(rate[::-1]))
    return -np.polyfit(np.log(even), logarithm, 1)[0]


def _exact_value(value: float) -> dict[str, Any]:
    return {"value": float(value), "low": float(value), "high": float(value)}


def _bursts_per_turn(count: int | None) -> dict[str, Any]:
    """Return the number of bursts per turn, which is uncertain by a factor of two."""
    return {"value": count, "low": 1, "high": 2}


def _numbers_of_bursts(run: SettlingRun, span: float) -> dict[str, dict[str, Any]]:
    """Return the rate `span` [s] before the end of a run, its exponent and its bursts
    per turn."""
    reference = run.rate_at_1s.value
    assert reference is not None, "only an end can be missing"
    own = float(run.rate(run.heard_until - span)) / reference
    rate = {name: own * value for name, value in asdict(run.rate_at_1s).items()}
    return {
        "rate_at_1s": rate,
        "exponent": asdict(run.exponent),
        "events_per_turn": _bursts_per_turn(run.events_per_turn),
    }


def numbers_of_run(source: AudioSource, run: SettlingRun) -> dict[str, Any]:
    """Return rate, exponent, bursts and turns, band levels, lines, decays and levels
    over time.

    Each has a value and the limits `low` and `high` of its 95 % interval. Levels of
    bands [dB] are relative to the strongest band, and levels over time to the loudest
    window. The interval of the turns includes the uncertain number of bursts per turn."""
    head = _numbers_of_bursts(run, run.reference_time)
    rate = head["rate_at_1s"]
    end = run.t_end.value
    assert end is not None, "a run that is fitted shows its end"
    turns = {
        "value": rate["value"] / run.events_per_turn,
        "low": rate["low"] / 2,
        "high": rate["high"],
    }
    return head | {"turns_at_1s": turns} | sound_numbers(source, run.start, end)


def sound_numbers(source: AudioSource, start: float, end: float) -> dict[str, Any]:
    """Return band levels, lines, decays and levels over time between `start` and `end`
    [s]."""
    part_count = 4  # their scatter gives the intervals
    edges = [500.0, 2000.0, 5000.0, 9500.0, 11500.0, 17000.0, 18500.0, 21000.0]  # Hz
    rate = source.sample_rate
    sound = read_samples(source, int(max(start, 0.0) * rate), int(end * rate))
    parts = np.array_split(loudest_channel(sound).astype(float), part_count)
    length = min(int(0.1 * rate), len(parts[-1]))
    power = np.array([welch(part, rate, nperseg=length)[1] for part in parts])
    frequency = np.fft.rfftfreq(length, 1 / rate)
    bands = [pair for pair in pairwise(edges) if pair[1] < rate / 2]
    levels = []
    for low, high in bands:
        inside = (frequency >= low) & (frequency < high)
        levels.append(10 * np.log10(power[:, inside].sum(axis=1) + 1e-30))
    levels = np.array(levels) - np.max(levels, axis=0)
    return {
        "bands": [
            {"from": low, "to": high} | _mean_with_interval(level)
            for (low, high), level in zip(bands, levels, strict=True)
        ],
        "seconds": end - start,
        "lines": _strongest_lines(frequency, power, np.concatenate(parts), rate),
        "loudness": _levels_before_the_end(source, start, end),
    }


def _mean_with_interval(values: list[float] | np.ndarray) -> dict[str, Any]:
    """Return the mean of the values (p,) of the parts with its 95 % interval."""
    half = (
        student.ppf(0.975, len(values) - 1)
        * np.std(values, ddof=1)
        / np.sqrt(len(values))
    )
    mean = float(np.mean(values))
    return {"value": mean, "low": mean - float(half), "high": mean + float(half)}


def _strongest_lines(
    frequency: np.ndarray, power: np.ndarray, samples: np.ndarray, rate: int
) -> list[dict[str, Any]]:
    """Return frequency [Hz] and decay [1/s] of the strongest lines in samples (n,).

    `power` (parts, f) contains the spectra of the parts at `frequency` (f,) [Hz].
    """
    max_count = 6
    spacing = frequency[1]
    reach = max(round(FIT.line_half_width / spacing), 1)
    level = 10 * np.log10(power.mean(axis=0) + 1e-30)
    level[(frequency < 1e3) | (frequency > 0.9 * frequency[-1])] = level.min()
    tops = find_peaks(level, prominence=15.0, distance=reach)[0]
    found = []
    for top in tops[np.argsort(-level[tops])[:max_count]]:
        near = slice(top - reach, top + reach + 1)
        centres = [np.average(frequency[near], weights=part) for part in power[:, near]]
        found.append(
            {
                "frequency": _mean_with_interval(centres),
                "decay_rate": _decay_between_bursts(samples, rate, frequency[top]),
            }
        )
    return found


def _decay_between_bursts(
    samples: np.ndarray, rate: int, middle: float
) -> dict[str, Any]:
    """Return the median rate [1/s] at which the amplitude of a line falls after its
    maxima."""
    averaging_time = 0.01  # s, longer than the beats of a pair of modes
    min_fall = 0.5  # of the logarithm of the amplitude
    min_fall_count = 5
    down = max(int(rate / 2000), 1)
    low = baseband(samples, rate, middle, FIT.line_half_width, down, 8 * down + 1)
    power = uniform_filter1d(
        np.square(np.abs(low)),
        max(round(averaging_time * rate / down), 1),
    )
    rounding = (
        1e-12 * power.max()
    )  # of the running sum, which may be negative in silence
    logarithm = np.log(np.maximum(power, rounding) + 1e-30) / 2
    maxima = find_peaks(logarithm, prominence=min_fall)[0]
    minima = find_peaks(-logarithm, prominence=min_fall)[0]
    falls = []
    for top in maxima:
        later = minima[minima > top]
        if len(later):
            falls.append(
                (logarithm[top] - logarithm[later[0]]) * rate / down / (later[0] - top)
            )
    if len(falls) < min_fall_count:
        return {"value": None, "low": 0.0, "high": float(rate / down)}
    low, value, high = np.percentile(falls, [25, 50, 75])
    half = 1.57 * (high - low) / np.sqrt(len(falls))  # 95 % of a median
    return {
        "value": float(value),
        "low": float(value - half),
        "high": float(value + half),
    }


def _levels_before_the_end(
    source: AudioSource, start: float, end: float
) -> dict[str, list[float]]:
    """Return remaining times [s] and A-weighted levels [dB re the loudest window]."""
    window = 0.1  # s
    seen = spectrogram(source, window, columns=1 << 16, span=(max(start, 0.0), end))
    level = 10 * np.log10(
        10 ** (a_weighting_db(seen.frequency) / 10) @ seen.power + 1e-30
    )
    remaining = end - seen.time
    return {"time_left": remaining.tolist(), "level": (level - level.max()).tolist()}
