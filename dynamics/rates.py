"""RATES of a motion as functions of time: nutation, precession, and changes from rolling to sliding."""

from functools import lru_cache

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import find_peaks

from . import kinematics
from .motion import Motion, halves

PROMINENCE, SHARE, NEIGHBOURS = 0.005, 0.5, 11
"""A peak of the normal force counts if its prominence is this part of the weight, and this share of the median of so
many neighbours: more than the corners that the resisting moment makes (1e-4), more than most of the steps at slips."""
SMOOTH = 5
"""Readings of a rate of which the median is drawn."""


@lru_cache(maxsize=1)
def load_peaks(motion: Motion) -> np.ndarray:
    """Return the times (p,) [s] of the peaks of the normal force, found by prominence on two points a piece."""
    t = halves(motion)
    peaks, found = find_peaks(motion.steady_load(t)[:-1] / motion.disk.weight, prominence=PROMINENCE)
    prominence = found["prominences"]
    return t[peaks[prominence >= SHARE * median_filter(prominence, NEIGHBOURS)]]


def nutation_frequency(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Return times (q,) [s] and f (q,) [Hz] of footnote 3: 2/T, T the time between three successive peaks of Phi."""
    peaks = load_peaks(motion)
    return peaks[1:-1], 2 / (peaks[2:] - peaks[:-2])


def precession_frequency(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Return times (q,) [s] and turns a second (q,) [Hz] about the vertical, means over two nutations."""
    peaks = load_peaks(motion)
    turned = np.abs(np.diff(motion.at(peaks)[:, 0])) / (2 * np.pi)
    return peaks[1:-1], (turned[1:] + turned[:-1]) / (peaks[2:] - peaks[:-2])


def smooth_rates(motion: Motion) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times (q,) [s], precession and nutation (q,) [Hz], medians of SMOOTH of them, as they are drawn."""
    (peaks, nutation), (_, precession) = nutation_frequency(motion), precession_frequency(motion)
    return peaks, median_filter(precession, SMOOTH), median_filter(nutation, SMOOTH)


def precession_rate(state) -> np.ndarray:
    """Return d theta/dt = omega_3 sec(alpha) (2.3), (k,) [rad/s], of states (k, 11)."""
    return kinematics.precession_rate(state[:, 7], np.sin(state[:, 1]))


def slips(motion: Motion) -> np.ndarray:
    """Return the times (j,) [s] at which rolling turns into sliding."""
    return np.array([e.t for e in motion.transitions if e.before.startswith("roll") and e.after.startswith("slide")])
