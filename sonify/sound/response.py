"""FORCE or MOTION -> MODAL RESPONSE: the accelerations of the modes, block after block."""

from typing import Protocol, runtime_checkable

import numpy as np

from sonify.sound.oscillators import Knots, OscillatorBank, free_response


@runtime_checkable
class Vibrating(Protocol):
    """A motion that solves the modes of its disk with it."""

    def vibration(self, t: np.ndarray) -> np.ndarray:
        """Return displacement, velocity and acceleration of every mode, (k, 3, m), at t (k,) [s]; of modal mass 1."""
        ...


class Driven:
    """m modes as oscillators that the contact force drives: one bank after its smooth part, one after its jumps.

    `settled` (m,) is the force on each mode that has long been there when the first block begins.
    """

    def __init__(self, modes, sample_rate: float, settled):
        self._smooth, self._jumps = (
            OscillatorBank(modes.frequency, modes.decay_rate, sample_rate) for _ in ("smooth", "jumps")
        )
        self._smooth.settle(settled)

    def advance(self, force) -> np.ndarray:
        """Return the accelerations (2, k, m) in the block of a ContactForce whose channels drive the modes."""
        none, out = 0 * force.bend, np.empty((2, len(force.t) - 1, force.smooth.shape[1]))
        self._smooth.advance(force.smooth, Knots(*force.knots, none, force.bend), out[0])
        self._jumps.advance(force.steps, Knots(*force.knots, force.jump, none), out[1])
        return out


class Carried:
    """The modes of the indices `chosen` (m,) as a Vibrating motion moves them: still before it, free after it.

    The shares of the smooth force and of its jumps cannot be told apart: all of it counts as after the smooth force.
    """

    def __init__(self, modes, motion, chosen):
        self._modes, self._motion, self._chosen, self._end = modes, motion, chosen, motion.t[-1]
        self._last = motion.vibration(motion.t[-1:])[0][:2, chosen]

    def advance(self, force) -> np.ndarray:
        """Return the accelerations (2, k, m) in the block of a ContactForce, of which only the times matter."""
        t = force.t[:-1]
        out = np.zeros((2, len(t), len(self._chosen)))
        during = (t >= 0) & (t <= self._end)
        out[0, during] = self._motion.vibration(t[during])[:, 2, self._chosen]
        out[0, t > self._end] = self._free(t[t > self._end, None] - self._end)
        return out

    def _free(self, since):
        omega, decay, (q0, v0) = 2 * np.pi * self._modes.frequency, self._modes.decay_rate, self._last
        c, s = free_response(omega, decay, since)
        q, v = (c + decay * s) * q0 + s * v0, (c - decay * s) * v0 - omega**2 * s * q0
        return -(omega**2) * q - 2 * decay * v
