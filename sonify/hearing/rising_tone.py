"""Detection of a rising tone f(t) = a (t_end - t)^-p in a sound."""

from dataclasses import dataclass

import numpy as np

from sonify.hearing.log_spectrogram import HOP, STEPS_PER_OCTAVE, log_map
from sonify.hearing.mains_hum import vertex
from sonify.hearing.power_law import TIME_LEFT, best_curve, octaves, ridge

EXPONENTS = np.arange(0.15, 1.66, 0.05)
EARLIEST, EVERY = 60, 6
"""First tested end, and spacing of the tested ends [frames]."""
LOWEST = 4
"""Number of octaves below the lowest bin at which a tone may begin."""
STAND_OUT_DB = 6.0
"""Least level of a peak above the median level at its frequency [dB]."""
FAINTEST_DB, LEAST_OCTAVES, LEAST_SPAN = 4.0, 3.0, 0.5
"""Least mean level of a tone [dB] (noise has about 2.5 dB); least number of octaves of
the remaining time with peaks (steady tones have up to 3); least rise [octaves]."""


@dataclass(frozen=True, kw_only=True)
class RisingTone:
    """A tone f(t) = a (t_end - t)^-p with its ridge.

    `end` [s] and `exponent` p have standard errors. `time` [s], `frequency` [Hz] and
    `level` [dB above the median], each (r,), describe the strongest line near the curve
    in each frame, which initially may be another line. `strength` [dB] is the mean
    level along the fitted curve, which has peaks over `octaves` of the remaining time.
    """

    end: float
    end_error: float
    exponent: float
    exponent_error: float
    scale: float
    strength: float
    octaves: float
    time: np.ndarray
    frequency: np.ndarray
    level: np.ndarray

    def __repr__(self):
        about = f"{self.scale:.4g} Hz ({self.end:.3f} s - t)^-{self.exponent:.3f}"
        return f"RisingTone({about}, {self.strength:.0f} dB, {len(self.time)} frames)"

    def at(self, t) -> np.ndarray:
        """Return the fitted frequency [Hz] at times t < end [s]."""
        return self.scale * (self.end - np.asarray(t)) ** -self.exponent

    def stands_out(self, share: float = 1.0) -> bool:
        """Return True if the tone exceeds a share of the thresholds.

        Noise and steady tones do not reach the thresholds.
        """
        rise = (
            self.exponent * np.ptp(np.log2(self.end - self.time))
            if len(self.time)
            else 0.0
        )
        clear = (
            self.strength >= share * FAINTEST_DB
            and self.octaves >= share * LEAST_OCTAVES
        )
        return bool(clear and rise >= LEAST_SPAN)

    @property
    def factor(self) -> float:
        """Ratio of the median frequencies in the last and first tenths of the ridge."""
        tenth = max(len(self.frequency) // 10, 1)
        return float(
            np.median(self.frequency[-tenth:]) / np.median(self.frequency[:tenth])
        )


def rising_tone(samples: np.ndarray, rate: float) -> RisingTone | None:
    """Return the strongest rising tone in samples (n,) at `rate` [Hz]; None if none
    stands out.

    The lowest octave that stands out is the fundamental. Ends, exponents and
    frequencies are searched on a grid, with points evenly spaced in the log remaining
    time; the best curve for each exponent is refined by a robust fit.
    tests/hearing/test_listen.py measures the errors in noise, hum and a room, and for
    sounds that change from one line to another."""
    tone = clearest_tone(samples, rate)
    return tone if tone is not None and tone.stands_out() else None


def clearest_tone(samples: np.ndarray, rate: float) -> RisingTone | None:
    """Return the strongest tone even if it does not stand out; None for a short sound
    or without peaks."""
    if not np.any(samples):
        return None
    seen = log_map(samples / np.abs(samples).max(), rate)
    peaks = _peaks(seen)
    if seen.time[-1] < 4 * TIME_LEFT[0] or not peaks.size:
        return None
    curve, errors = best_curve(peaks, _search(seen))
    time, pitch, level = ridge(peaks, curve)
    return RisingTone(
        end=float(curve[0]),
        end_error=float(errors[0]),
        exponent=float(curve[1]),
        exponent_error=float(errors[1]),
        scale=float(2 ** curve[2]),
        strength=float(_strength(seen, curve)),
        octaves=float(octaves(peaks, curve)),
        time=time,
        frequency=2**pitch,
        level=level,
    )


def _peaks(seen):
    """Return times [s], log2 frequencies and levels [dB] (3, n) of the peaks of all
    frames."""
    below = seen.level[:, :-2]
    top = seen.level[:, 1:-1]
    above = seen.level[:, 2:]
    contrast = seen.contrast[:, 1:-1]
    here = row, column = np.nonzero(
        (contrast > STAND_OUT_DB) & (top >= below) & (top > above)
    )
    column = column + 1 + vertex(below[here], top[here], above[here])
    return np.array(
        [
            seen.time[row],
            np.log2(seen.frequency[0]) + column / STEPS_PER_OCTAVE,
            contrast[here],
        ]
    )


def _left():
    return np.geomspace(*TIME_LEFT, 72)


def _search(seen):
    """Return the curve (end, exponent, log2 scale) with the highest mean level for each
    exponent.

    The initial frequencies are every second bin.
    """
    left = _left()
    last = len(seen.time)
    back = np.round(left / HOP).astype(int)
    below = LOWEST * STEPS_PER_OCTAVE
    shape = np.round(
        np.outer(EXPONENTS, np.log2(TIME_LEFT[1] / left)) * STEPS_PER_OCTAVE
    ).astype(int)
    ends = np.arange(EARLIEST, last + int(0.2 / HOP), EVERY)
    before = -(-back.max() // EVERY) * EVERY
    level = np.round(8 * seen.contrast[:, : len(seen.frequency) // 2 * 2]).astype(
        np.int16
    )
    level = np.pad(level, ((before, ends[-1] + EVERY - last), (below, 0)))
    grid = level.reshape(-1, EVERY, level.shape[1] // 2, 2).transpose(3, 1, 2, 0).copy()
    i, k = np.transpose(
        [_best(grid, before + EARLIEST - back, curve, len(ends)) for curve in shape]
    )
    beginning = np.log2(seen.frequency[0]) + (2 * k - below) / STEPS_PER_OCTAVE
    return np.column_stack(
        [ends[i] * HOP, EXPONENTS, beginning + EXPONENTS * np.log2(TIME_LEFT[1])]
    )


def _best(grid, frames, curve, ends):
    """Return the indices of end and initial frequency with the highest mean level along
    a curve (l,).

    The points of the curve are at `frames` (l,) for the first of the `ends`. The array
    `grid` (2, EVERY, bins / 2, frames / EVERY) is ordered for contiguous sums."""
    score = np.zeros((grid.shape[2], ends), np.int16)
    for frame, down in zip(frames.tolist(), curve.tolist(), strict=True):
        row = frame % EVERY
        first = frame // EVERY
        found = grid[down % 2, row, down // 2 :, first : first + ends]
        score[: len(found)] += found
    return np.unravel_index(np.argmax(score.T), score.T.shape)


def _strength(seen, guess):
    end, exponent, log_scale = guess
    left = _left()
    pitch = 2 ** (log_scale - exponent * np.log2(left))
    return np.mean(seen.read(end - left, pitch))
