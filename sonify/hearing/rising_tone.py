"""SOUND -> RISING TONE: finds f(t) = a (t_end - t)^-p in a sound that is known by nothing but its samples."""

from dataclasses import dataclass

import numpy as np
from numba import njit
from scipy.optimize import least_squares

from sonify.hearing.log_spectrogram import HOP, STEPS_PER_OCTAVE, log_map

TIME_LEFT = (0.02, 8.0)
"""The stretch before the end in which the tone is sought [s]."""
EXPONENTS = np.arange(0.25, 1.6, 0.125)
STAND_OUT_DB = 6.0
"""A frame counts where the ridge is so far above what is usual at its frequency."""
FAINTEST_DB = 4.0
"""A ridge that stands out by less than this on the mean is none: noise alone gives about 2.5 dB."""
LEAST_SPAN = 1.0
"""A ridge over fewer octaves does not count as rising."""


@dataclass(frozen=True, kw_only=True)
class RisingTone:
    """A tone f(t) = a (t_end - t)^-p: its end [s], exponent p, their standard errors, and the ridge itself.

    `time`, `frequency`, `level` (r,) [s, Hz, dB above what is usual at the frequency] are the frames that show it;
    `strength` [dB] is the mean level along the fitted curve.
    """

    end: float
    end_error: float
    exponent: float
    exponent_error: float
    scale: float
    strength: float
    time: np.ndarray
    frequency: np.ndarray
    level: np.ndarray

    def __repr__(self):
        about = f"{self.scale:.4g} Hz ({self.end:.3f} s - t)^-{self.exponent:.3f}"
        return f"RisingTone({about}, {self.strength:.0f} dB, {len(self.time)} frames)"

    def at(self, t) -> np.ndarray:
        """Return the fitted frequency [Hz] at times t < end [s]."""
        return self.scale * (self.end - np.asarray(t)) ** -self.exponent

    @property
    def factor(self) -> float:
        """By how much the pitch rises over the ridge: median of its last tenth over that of its first."""
        tenth = max(len(self.frequency) // 10, 1)
        return float(np.median(self.frequency[-tenth:]) / np.median(self.frequency[:tenth]))


def rising_tone(samples: np.ndarray, rate: float, fundamental: bool = False) -> RisingTone | None:
    """Return the strongest rising tone in samples (n,) at `rate` [Hz], or None where nothing stands out.

    With `fundamental`, return the lowest of its octaves that stands out too: what repeats, not its strongest harmonic.

    Every end, exponent and pitch is tried on points that are even in the logarithm of the time left; the best is
    refined by a robust fit to the ridge beside it. tests/test_sound_listen.py gives its errors, in noise and in a room.
    """
    if not np.any(samples):
        return None
    seen = log_map(samples / np.abs(samples).max(), rate)
    if seen.time[-1] < 4 * TIME_LEFT[0]:
        return None
    guess = _lowest_octave(seen, _search(seen)) if fundamental else _search(seen)
    for width in (0.5, 0.25, 0.15):
        ridge = _ridge(seen, guess, width)
        if len(ridge[0]) < 8:
            return None
        guess, errors = _fit(ridge, guess)
    strength = _strength(seen, guess)
    span = guess[1] * np.log2((guess[0] - ridge[0][0]) / (guess[0] - ridge[0][-1]))
    if strength < FAINTEST_DB or span < LEAST_SPAN:
        return None
    end, exponent, log_scale = guess
    return RisingTone(
        end=float(end),
        end_error=float(errors[0]),
        exponent=float(exponent),
        exponent_error=float(errors[1]),
        scale=float(2**log_scale),
        strength=float(strength),
        time=ridge[0],
        frequency=ridge[1],
        level=ridge[2],
    )


def _left():
    return np.geomspace(*TIME_LEFT, 100)


def _search(seen):
    """The (end, exponent, log2 scale) whose curve has the highest mean level; every other bin is tried as beginning."""
    left, last = _left(), len(seen.time)
    shape = np.outer(EXPONENTS, np.log2(TIME_LEFT[1] / left)) * STEPS_PER_OCTAVE
    ends = np.arange(int(0.3 / HOP), last + int(0.2 / HOP), 4)
    even = seen.level.shape[1] // 2 * 2
    halves = np.ascontiguousarray(seen.level[:, :even].reshape(last, -1, 2).transpose(2, 0, 1))
    i, j, k = _best(halves, ends, np.round(left / HOP).astype(int), np.round(shape).astype(int))
    beginning = np.log2(seen.frequency[0]) + 2 * k / STEPS_PER_OCTAVE
    return np.array([ends[i] * HOP, EXPONENTS[j], beginning + EXPONENTS[j] * np.log2(TIME_LEFT[1])])


@njit(cache=True)
def _best(halves, ends, left, shape):
    """Where (end, exponent, beginning) the mean level on the curves that begin at every other bin is highest.

    `halves` (2, frames, bins / 2) are the even and the odd bins of the map, `ends` frames.
    """
    _, frames, beginnings = halves.shape
    highest, best = -np.inf, (0, 0, 0)
    for i in range(len(ends)):
        for j in range(len(shape)):
            score = np.zeros(beginnings)
            for l in range(len(left)):
                row = ends[i] - left[l]
                if 0 <= row < frames:
                    bins = halves[shape[j, l] % 2, row, shape[j, l] // 2 :]
                    for k in range(len(bins)):
                        score[k] += bins[k]
            k = np.argmax(score)
            if score[k] > highest:
                highest, best = score[k], (i, j, k)
    return best


def _lowest_octave(seen, guess):
    below = guess - [0, 0, 1]
    return _lowest_octave(seen, below) if _strength(seen, below) > 0.5 * _strength(seen, guess) > 0 else guess


def _ridge(seen, guess, width):
    """Times, frequencies and levels of the strongest bins within `width` octaves of the curve, where they stand out."""
    end, exponent, log_scale = guess
    inside = (seen.time < end - TIME_LEFT[0]) & (seen.time > end - TIME_LEFT[1])
    time = seen.time[inside]
    curve = (log_scale - exponent * np.log2(end - time) - np.log2(seen.frequency[0])) * STEPS_PER_OCTAVE
    offsets = np.arange(-int(width * STEPS_PER_OCTAVE), int(width * STEPS_PER_OCTAVE) + 1)
    column = np.round(curve).astype(int)[:, None] + offsets
    valid = (column >= 1) & (column < len(seen.frequency) - 1)
    level = np.where(
        valid, seen.level[inside][np.arange(len(time))[:, None], np.clip(column, 0, len(seen.frequency) - 1)], -99
    )
    best = np.argmax(level, axis=1)
    rows = np.arange(len(time))
    level, column = level[rows, best], column[rows, best]
    keep = (level > STAND_OUT_DB) & (best > 0) & (best < len(offsets) - 1)
    frequency = seen.frequency[0] * 2 ** ((column + _vertex(seen.level[inside], rows, column)) / STEPS_PER_OCTAVE)
    return time[keep], frequency[keep], level[keep]


def _vertex(level, rows, column):
    """Where between bins the parabola through a peak and its neighbours has its vertex, within half a bin."""
    column = np.clip(column, 1, level.shape[1] - 2)
    below, peak, above = (level[rows, column + i] for i in (-1, 0, 1))
    bend = below - 2 * peak + above
    return np.clip(np.where(bend < 0, (below - above) / (2 * np.minimum(bend, -1e-9)), 0), -0.5, 0.5)


def _fit(ridge, guess):
    """Robust least squares of log f against log(t_end - t), every octave of the time left counting the same."""
    time, frequency, _ = ridge
    latest = time[-1] + 1e-4

    def residual(x):
        left = np.maximum(x[0] - time, 1e-4)
        return (np.log2(frequency) - x[2] + x[1] * np.log2(left)) / np.sqrt(left)

    bounds = ([latest, 0.02, -np.inf], [max(guess[0], latest) + 0.5, 4.0, np.inf])
    start = np.clip(guess, np.add(bounds[0], 1e-6), np.subtract(bounds[1], 1e-6))
    solved = least_squares(residual, start, bounds=bounds, loss="soft_l1", f_scale=0.05, x_scale=[0.01, 0.1, 0.1])
    independent = max(len(time) * HOP / 0.1, 4.0)  # overlapping windows are not independent
    spread = np.median(np.abs(residual(solved.x))) * 1.48
    covariance = np.linalg.pinv(solved.jac.T @ solved.jac) * spread**2 * len(time) / independent
    return solved.x, np.sqrt(np.diag(covariance))


def _strength(seen, guess):
    end, exponent, log_scale = guess
    left = _left()
    pitch = 2 ** (log_scale - exponent * np.log2(left))
    return np.mean(seen.read(end - left, pitch))
