"""MODES -> LOUDNESS: what of the modes is heard, and how much each is worth."""

import numpy as np

from modal import Modes
from sonify.hearing.loudness import a_weighting_db
from sonify.scene import Scene
from sonify.sound.drive import drive_per_newton
from sonify.sound.radiation import directions, listener_of

VIEWS = 64
"""Azimuths over which the radiation of a mode is averaged."""
RING_DOWN_DB, LONGEST = 60.0, 10.0
"""A ring is heard until it is so far [dB] below the loudest at its start, but not longer than this [s]."""


def sounding(modes: Modes, sample_rate: float, wanted=None) -> np.ndarray:
    """Return which (k,) of the indices `wanted`, of all modes if None, lie below half the sample rate: a higher one is
    left out, not folded back."""
    keep = np.arange(len(modes)) if wanted is None else np.array(wanted, dtype=int)
    return keep[modes.frequency[keep] < sample_rate / 2]


def after_a_jump(modes: Modes, scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Return what a jump of 1 N of the contact force leaves in the modes: loudness (m,) [Pa^2 s] and energy (m,) [J].

    A mode of modal mass 1 driven by g rings as q'' = g exp(-d t) cos(w t), of energy g^2/(2 w^2); the square of its
    pressure, A-weighted, adds up to (g R)^2/(4 d). g is the root of the sum of squares over the three directions, R the
    root mean square of Rayleigh's integral round the axis. A nutation that sweeps through the modes excites them in the
    same proportion: at the rate w^2/k it leaves q'' = g sqrt(pi k/2).
    """
    listener = listener_of(scene)
    g2 = np.square(drive_per_newton(modes, scene)).sum(axis=0)
    heard2 = np.mean(np.abs(directions(modes, listener, count=VIEWS)) ** 2, axis=0)
    weight = 10 ** (a_weighting_db(modes.frequency) / 10)
    decay = np.maximum(modes.decay_rate, 1 / LONGEST)
    return weight * g2 * heard2 / (4 * decay), g2 / (2 * (2 * np.pi * modes.frequency) ** 2)


def ring_down(modes: Modes, scene: Scene) -> float:
    """Return for how long [s] the modes are still heard after the motion."""
    loudness, _ = after_a_jump(modes, scene)
    at_start = loudness * np.maximum(modes.decay_rate, 1 / LONGEST)
    with np.errstate(divide="ignore"):
        level = 10 * np.log10(at_start / at_start.max(initial=1e-300))
        lasting = (RING_DOWN_DB + level) / (20 / np.log(10) * modes.decay_rate)
    return float(np.clip(lasting.max(initial=0.0), 0.0, LONGEST))
