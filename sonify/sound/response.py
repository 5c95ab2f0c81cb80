"""FORCE or MOTION -> MODAL RESPONSE: the accelerations of the modes, block after block."""

import numpy as np

from sonify.sound.oscillators import Knots, OscillatorBank, free_response


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
        none = 0 * force.bend
        return np.array(
            [
                self._smooth.advance(force.smooth, Knots(*force.knots, none, force.bend)),
                self._jumps.advance(force.steps, Knots(*force.knots, force.jump, none)),
            ]
        )


class Carried:
    """The modes of the indices `chosen` (m,) as a motion moves them that solves them itself.

    `motion.vibration(t)` (k, 3, all) is displacement, velocity and acceleration at t (k,) [s] for modal mass 1. Before
    the motion they are still, after it they ring freely. What the table's share is cannot be told apart: all of it
    counts as after the smooth force.
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
