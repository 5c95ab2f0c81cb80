"""The sound that every oscillator is asked for: the modes of the published disk under a force known in closed form.

The force stands in for the contact's: harmonics of a nutation, falling as 1/n^2, and, if wanted, a jump down in every
swing, at no sample. So the pressure is known exactly.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from modal import eigenmodes
from sonify.scene import load_scene
from sonify.sound.oscillators import Knots
from sonify.sound.radiation import directions, listener_of

RATE = 48000
NUTATION = 36.0
"""Nutation frequency [Hz], the paper's largest f-hat."""
HARMONICS = np.arange(1, 9)
JUMP = -0.08
"""Size of a jump of the normal force, relative to the weight."""


@dataclass(frozen=True, kw_only=True)
class SoundCase:
    """Modes (m,): frequency [Hz], decay [1/s], what a unit of heave drives and what pressure [Pa] it radiates."""

    name: str
    duration: float
    omega: np.ndarray
    decay: np.ndarray
    drive: np.ndarray
    radiated: np.ndarray
    jumps: np.ndarray

    def smooth(self, t) -> np.ndarray:
        """Return the continuous part of the force at t (k,)."""
        return np.sin(2 * np.pi * NUTATION * np.outer(t, HARMONICS)) @ (1 / HARMONICS**2)

    def samples(self, rate: float) -> np.ndarray:
        """Return the modal forces (k + 1, m) at `rate` [Hz], after a jump where one has happened."""
        t = np.arange(round(self.duration * rate) + 1) / rate
        return np.outer(self.smooth(t) + JUMP * np.searchsorted(self.jumps, t, side="right"), self.drive)

    def knots(self, rate: float) -> Knots:
        """Return the jumps as knots between samples at `rate` [Hz]; never two between the same samples."""
        before = np.floor(self.jumps * rate).astype(int)
        since, until = self.jumps - before / rate, (before + 1) / rate - self.jumps
        left, right = self.smooth(before / rate), self.smooth((before + 1) / rate)
        bend = self.smooth(self.jumps) - left - (right - left) * since * rate
        return Knots(before, since, until, np.outer(np.full(len(before), JUMP), self.drive), np.outer(bend, self.drive))

    @cached_property
    def exact(self) -> np.ndarray:
        """The pressure (k,) [Pa] at the samples of RATE, by the closed form of every mode."""
        t = np.arange(round(self.duration * RATE)) / RATE
        return sum(
            factor * self._acceleration(t, w, d)
            for factor, w, d in zip(self.drive * self.radiated, self.omega, self.decay, strict=True)
        )

    def _acceleration(self, t, w, d):
        """Return q'' (k,) of one mode at rest at t = 0: driven, free, and the ring of every jump."""
        swing = 2 * np.pi * NUTATION * HARMONICS
        response = 1 / HARMONICS**2 / (w * w - swing**2 + 2j * d * swing)
        driven = (np.exp(1j * np.outer(t, swing)) @ (-(swing**2) * response)).imag
        free = complex(-d, np.sqrt(w * w - d * d))
        q0, v0 = -response.imag.sum(), -(1j * swing * response).imag.sum()
        amplitude = q0 + 1j * (q0 * free.real - v0) / free.imag
        ring = (amplitude * free**2 * np.exp(free * t)).real
        for jump in self.jumps:
            since = np.clip(t - jump, 0, None)
            ring += np.where(t >= jump, JUMP * (free / free.imag * np.exp(free * since)).imag, 0.0)
        return driven + ring


def sound_case(name: str, duration: float, with_jumps: bool) -> SoundCase:
    """Return the case: the modes of the published scene below half of RATE, the listener straight above the rim."""
    scene = load_scene("published")
    modes = eigenmodes(scene, below=0.45 * RATE)
    listener = listener_of(scene)
    swing = np.arange(int(duration * NUTATION))
    return SoundCase(
        name=name,
        duration=duration,
        omega=2 * np.pi * modes.frequency,
        decay=modes.decay_rate,
        drive=-modes.participation[:, 2],
        radiated=directions(modes, listener)[0].real,
        jumps=(swing + 0.37 + 0.1 * np.sin(swing)) / NUTATION if with_jumps else np.zeros(0),
    )
