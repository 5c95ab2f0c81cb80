"""Define a benchmark sound with exact pressure: the modes of the published disk under a
force in closed form.

Like the contact force, the force contains harmonics of the nutation, with amplitudes
1/n^2, and optionally one downward jump between samples per nutation period."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from modal import eigenmodes
from sonify.scene import load_scene
from sonify.sound.oscillators import Knots
from sonify.sound.radiation import listener_of, tabulated_directivity

SAMPLE_RATE = 48000
"""Sample rate of the pressure [Hz]."""

NUTATION_FREQUENCY = 36.0
"""Nutation frequency [Hz], the largest f-hat of the paper."""

HARMONICS = np.arange(1, 9)

FORCE_JUMP = -0.08
"""Jump of the normal force, relative to the weight."""


@dataclass(frozen=True, kw_only=True)
class SoundCase:
    """Modes (m,) and their force.

    `omega` is the angular frequency [rad/s], `decay` the decay rate [1/s], `drive` the
    modal force per unit force, `radiated` the pressure [Pa] per unit modal
    acceleration, and `jumps` (j,) are the times [s] of jumps of the force."""

    name: str
    duration: float
    omega: np.ndarray
    decay: np.ndarray
    drive: np.ndarray
    radiated: np.ndarray
    jumps: np.ndarray

    def smooth(self, t) -> np.ndarray:
        """Return the continuous part of the force at t (k,)."""
        return np.sin(2 * np.pi * NUTATION_FREQUENCY * np.outer(t, HARMONICS)) @ (
            1 / HARMONICS**2
        )

    def samples(self, rate: float) -> np.ndarray:
        """Return the modal forces (k + 1, m), including jumps, at the sample rate
        `rate` [Hz]."""
        t = np.arange(round(self.duration * rate) + 1) / rate
        return np.outer(
            self.smooth(t) + FORCE_JUMP * np.searchsorted(self.jumps, t, side="right"),
            self.drive,
        )

    def knots(self, rate: float) -> Knots:
        """Return the jumps as knots for the sample rate `rate` [Hz]; there is at most
        one between two samples."""
        before = np.floor(self.jumps * rate).astype(int)
        since = self.jumps - before / rate
        until = (before + 1) / rate - self.jumps
        left = self.smooth(before / rate)
        right = self.smooth((before + 1) / rate)
        bend = self.smooth(self.jumps) - left - (right - left) * since * rate
        return Knots(
            before,
            since,
            until,
            np.outer(np.full(len(before), FORCE_JUMP), self.drive),
            np.outer(bend, self.drive),
        )

    @cached_property
    def exact(self) -> np.ndarray:
        """Pressure (k,) [Pa] at SAMPLE_RATE from the closed form of every mode."""
        t = np.arange(round(self.duration * SAMPLE_RATE)) / SAMPLE_RATE
        return sum(
            factor * self._acceleration(t, w, d)
            for factor, w, d in zip(
                self.drive * self.radiated, self.omega, self.decay, strict=True
            )
        )

    def _acceleration(self, t, w, d):
        """Return the acceleration q'' (k,) of a mode initially at rest: forced part,
        free part, and responses to jumps."""
        swing = 2 * np.pi * NUTATION_FREQUENCY * HARMONICS
        response = 1 / HARMONICS**2 / (w * w - swing**2 + 2j * d * swing)
        driven = (np.exp(1j * np.outer(t, swing)) @ (-(swing**2) * response)).imag
        free = complex(-d, np.sqrt(w * w - d * d))
        q0 = -response.imag.sum()
        v0 = -(1j * swing * response).imag.sum()
        amplitude = q0 + 1j * (q0 * free.real - v0) / free.imag
        ring = (amplitude * free**2 * np.exp(free * t)).real
        for jump in self.jumps:
            since = np.clip(t - jump, 0, None)
            ring += np.where(
                t >= jump,
                FORCE_JUMP * (free / free.imag * np.exp(free * since)).imag,
                0.0,
            )
        return driven + ring


def sound_case(name: str, duration: float, with_jumps: bool) -> SoundCase:
    """Return the case with the modes of the published scene below 0.45 of the sample
    rate, at its listener."""
    scene = load_scene("published")
    modes = eigenmodes(scene, below=0.45 * SAMPLE_RATE)
    listener = listener_of(scene)
    swing = np.arange(int(duration * NUTATION_FREQUENCY))
    return SoundCase(
        name=name,
        duration=duration,
        omega=2 * np.pi * modes.frequency,
        decay=modes.decay_rate,
        drive=-modes.participation[:, 2],
        radiated=tabulated_directivity(modes, listener, 512)[0].real,
        jumps=(swing + 0.37 + 0.1 * np.sin(swing)) / NUTATION_FREQUENCY
        if with_jumps
        else np.zeros(0),
    )
