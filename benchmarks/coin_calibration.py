"""Compare the shipped coin with recordings: rates, band levels, shifts of lines, decays
between bursts.

Usage: python benchmarks/coin_calibration.py [RECORDING ...] [--set key=value ...]

Prints the numbers of each recording, and those of the scene `coin` with these changes
for three seeds of the heights. Levels are relative to the first line; the bands lie
between its lines."""

import sys
from collections.abc import Callable

import numpy as np
from scipy.signal import find_peaks, firwin, oaconvolve, stft

from modal import eigenmodes
from sonify import load_scene, solve
from sonify.hearing.audio_source import AudioSource, read_samples, source_of
from sonify.hearing.settling.detector import settling_runs

BAND_LIMITS = (
    (0.05, 0.19),
    (0.19, 0.47),
    (0.47, 0.9),
    (1.085, 1.6),
    (1.63, 1.735),
    (1.745, 1.98),
)
"""Limits of bands divided by the frequency of the first line.

For a coin of 10.6 kHz the bands are 0.5-2, 2-5, 5-9.5, 11.5-17, 17.3-18.4 and 18.5-21
kHz."""
LINE_BAND = 0.04
"""Half width of the band of a line, divided by its frequency."""
CENTRE_BAND = 0.02
"""Half width of the band over which the centre of a line is averaged, divided by its
frequency."""
ENVELOPE_BAND = 300.0
"""Half width [Hz] of the band around a line whose envelope is followed."""
SEGMENT_LENGTH = 0.04
"""Length [s] of the segments of a spectrum."""
OMITTED_END = 0.03
"""Length [s] of the final part of a run that is omitted."""
MIN_DECAY_TIME = 4e-3
"""Shortest duration [s] of a decay between two bursts that is evaluated."""
RESAMPLE_COUNT = 200
"""Number of draws with replacement for an interval."""
RATE_TIMES_BEFORE_END = np.array([0.785, 0.465, 0.165])
"""Times before the end [s] at which rates are printed."""
HEIGHT_SEEDS = range(3)


def main(arguments: list[str]):
    """Print the numbers of the recordings and of the simulated coin."""
    at = arguments.index("--set") if "--set" in arguments else len(arguments)
    scene = load_scene("coin").replace(*arguments[at + 1 :])
    free = np.unique(np.round(eigenmodes(scene, below=20e3).frequency, 1))[:2]
    print(f"free lines of the scene: {free} Hz")
    for file in arguments[:at]:
        source = source_of(file)
        for run in settling_runs(source):
            rates = run.rate(run.t_end.value - RATE_TIMES_BEFORE_END)
            show(
                file,
                source,
                run.start,
                run.t_end.value,
                free,
                {"bursts per second": rates},
            )
    for seed in HEIGHT_SEEDS:
        result = solve(scene.replace(f"roughness.seed={seed}"))
        motion = result.motion
        end = float(motion.t[-1])
        middle = np.clip(end - RATE_TIMES_BEFORE_END, 0.02, end - 0.02)
        before, after = (motion.precession(middle + shift) for shift in (-0.02, 0.02))
        numbers = {"turns per second": (after - before) / (0.04 * 2 * np.pi)}
        track = result.sound.pressure
        heard = max(settling_runs(track), key=lambda run: run.score, default=None)
        if heard is not None:
            numbers["bursts per second"] = heard.rate(
                heard.t_end.value - RATE_TIMES_BEFORE_END
            )
        name = (
            f"seed {seed}: {motion.outcome.name} after {end:.3f} s, open "
            f"{motion.open_share:.2f}, {motion.impact_rate:.0f} impacts per second"
        )
        show(name, track, max(end - 0.75, 0.0), end, free, numbers)


def show(
    name: str,
    source: AudioSource,
    begin: float,
    end: float,
    free: np.ndarray,
    numbers: dict,
):
    """Print the numbers of a sound from `begin` to `end` [s]."""
    print(name)
    rate = source.sample_rate
    samples = read_samples(source, int(begin * rate), int((end - OMITTED_END) * rate))[
        :, 0
    ].astype(float)
    length = int(SEGMENT_LENGTH * rate)
    frequency, _, spectrum = stft(samples, rate, nperseg=length, boundary=None)
    power = np.square(np.abs(spectrum))
    centres = [line_centre(frequency, power, line) for line in free]
    rows = {
        "band levels [dB]": band_levels(frequency, power, free),
        "lines [Hz]": centres,
        "lines over those of the free disk": np.array(centres) / free[:, None],
        "decay between bursts [1/s]": [
            burst_decay(samples, rate, line) for line in free
        ],
    }
    for key, values in numbers.items():
        print(
            f"  {key} {RATE_TIMES_BEFORE_END} s before the end: {np.round(values, 1)}"
        )
    for key, values in rows.items():
        words = (
            f"{value:.4g} ({low:.4g} to {high:.4g})" for value, low, high in values
        )
        print(f"  {key}: {', '.join(words)}")


def band_levels(
    frequency: np.ndarray, power: np.ndarray, free: np.ndarray
) -> np.ndarray:
    """Return the levels (b, 3) [dB] of BAND_LIMITS relative to the first line, with their
    intervals.

    `power` (f, s) is that of s segments.
    """
    reference = power[np.abs(frequency / free[0] - 1) < LINE_BAND].sum(axis=0)
    levels = []
    for low, high in np.array(BAND_LIMITS) * free[0]:
        inside = power[(frequency >= low) & (frequency < high)].sum(axis=0)
        levels.append(interval(np.column_stack([inside, reference]), _level))
    return np.array(levels)


def _level(rows):
    return 10 * np.log10(rows[:, 0].sum() / rows[:, 1].sum() + 1e-20)


def line_centre(
    frequency: np.ndarray, power: np.ndarray, line: float
) -> tuple[float, ...]:
    """Return the centre of power of a line [Hz] with its interval, around its peak near
    a frequency [Hz].
    """
    near = np.abs(frequency / line - 1) < LINE_BAND
    peak = frequency[near][np.argmax(power[near].sum(axis=1))]
    around = np.abs(frequency / peak - 1) < CENTRE_BAND
    own = frequency[around]
    return interval(power[around].T, lambda rows: own @ rows.sum(axis=0) / rows.sum())


def burst_decay(samples: np.ndarray, rate: float, line: float) -> tuple[float, ...]:
    """Return the decay rate [1/s] of the envelope of a line [Hz] between successive
    bursts.

    It is the median over the bursts, with its interval.
    """
    taps = firwin(int(0.003 * rate) | 1, ENVELOPE_BAND, fs=rate)
    turned = samples * np.exp(-2j * np.pi * line / rate * np.arange(len(samples)))
    level = np.log(np.abs(oaconvolve(turned, taps, mode="same")) + 1e-300)
    step = int(0.001 * rate)
    peaks = find_peaks(level, distance=step, prominence=0.35)[0]
    slopes = []
    for here, following in zip(peaks, [*peaks[1:], len(level)], strict=True):
        begin = here + step
        end = (
            begin + int(np.argmin(level[begin:following]))
            if following > begin
            else begin
        )
        if end - begin > MIN_DECAY_TIME * rate:
            slopes.append(
                -np.polyfit(np.arange(begin, end) / rate, level[begin:end], 1)[0]
            )
    return interval(np.array(slopes), np.median) if len(slopes) > 2 else (np.nan,) * 3


def interval(
    rows: np.ndarray, statistic: Callable[[np.ndarray], float]
) -> tuple[float, ...]:
    """Return a statistic of rows (n, ...) with its 95 % interval, from rows drawn with
    replacement.
    """
    random = np.random.default_rng(0)
    drawn = [
        statistic(rows[random.integers(0, len(rows), len(rows))])
        for _ in range(RESAMPLE_COUNT)
    ]
    low, high = np.percentile(drawn, [2.5, 97.5])
    return float(statistic(rows)), float(low), float(high)


if __name__ == "__main__":
    main(sys.argv[1:])
