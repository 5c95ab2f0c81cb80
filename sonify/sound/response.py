"""Compute modal accelerations block by block, from the contact force or from a solved
motion."""

from typing import TYPE_CHECKING, Protocol

import numpy as np

from sonify.sound.audible_modes import RingDown
from sonify.sound.oscillators import OscillatorBank, free_response

if TYPE_CHECKING:
    from sonify.sound.force import ContactForce


class SolvedVibration(Protocol):
    """Vibration of the disk that was solved together with its motion."""

    t: np.ndarray
    """Breakpoints (n,) [s] of the motion."""

    def vibration(self, t: np.ndarray) -> np.ndarray:
        """Return displacement, velocity and acceleration (k, 3, m) of the modes of unit
        modal mass at t (k,) [s]."""
        ...


class DrivenModes:
    """Oscillators of m modes driven by the contact force, with separate banks for its
    smooth part and its jumps.

    `settled` (m,) is the constant force on each mode before the first block.
    """

    def __init__(
        self,
        frequency: np.ndarray,
        decay_rate: np.ndarray,
        sample_rate: float,
        settled: np.ndarray,
    ) -> None:
        self._banks = [
            OscillatorBank(frequency, decay_rate, sample_rate) for _ in range(2)
        ]
        self._banks[0].set_steady_state(settled)

    def advance(self, force: "ContactForce") -> np.ndarray:
        """Return the accelerations (2, k, m) due to smooth force and jumps in one block
        of modal forces."""
        out = np.empty((2, len(force.t) - 1, force.smooth.shape[1]))
        for bank, part, ringing in zip(self._banks, force.parts, out, strict=True):
            bank.advance(*part, ringing)
        return out


class SolvedModes:
    """Response of the modes `chosen` (m,) taken from a solved vibration; they ring
    down after the motion.

    The solution does not distinguish between smooth force and jumps; the whole response
    is assigned to the smooth force."""

    def __init__(
        self, motion: SolvedVibration, chosen: np.ndarray, ringing: RingDown
    ) -> None:
        self._ringing = ringing
        self._motion = motion
        self._chosen = chosen
        self._end = motion.t[-1]
        self._final_state = motion.vibration(motion.t[-1:])[0][:2, chosen]

    def advance(self, force: "ContactForce") -> np.ndarray:
        """Return the accelerations (2, k, m) at the times of a ContactForce; the force
        values are unused."""
        t = force.t[:-1]
        out = np.zeros((2, len(t), len(self._chosen)))
        during = (t >= 0) & (t <= self._end)
        out[0, during] = self._motion.vibration(t[during])[:, 2, self._chosen]
        out[0, t > self._end] = self._ring_down(t[t > self._end, None] - self._end)
        return out

    def _ring_down(self, elapsed: np.ndarray) -> np.ndarray:
        """Return the free accelerations (k, m) at times `elapsed` (k, 1) [s] after the
        motion."""
        omega = 2 * np.pi * self._ringing.frequency
        decay = self._ringing.decay_rate
        q0, v0 = self._final_state
        c, s = free_response(omega, decay, elapsed)
        q = (c + decay * s) * q0 + s * v0
        v = (c - decay * s) * v0 - omega**2 * s * q0
        return -(omega**2) * q - 2 * decay * v
