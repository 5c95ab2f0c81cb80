"""Compute the ringing of a rattling disk from the modes solved together with its
motion."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from dynamics import Motion
from modal import Modes
from sonify.sound.audible_modes import RingDown
from sonify.sound.fluid_loaded_modes import fluid_loaded_modes
from sonify.sound.response import SolvedModes
from sonify.sound.sources.protocol import Advance, ElasticDisk

if TYPE_CHECKING:
    from dynamics.rattling.rattling_motion import RattlingMotion


class RattlingModes(ElasticDisk):
    """Elastic modes of a rattling disk, damped by the air film after the motion."""

    _motion: "RattlingMotion"

    @cached_property
    def ringing(self) -> RingDown:
        """Frequencies and decay rates of the modes after the motion, at the last mean
        gap."""
        gap = self._motion.final_gap
        film = fluid_loaded_modes(self._modes, self._scene, gap)
        frequency, decay_rate = film.nearest_tuning(np.log(gap))
        return RingDown(
            frequency=frequency,
            decay_rate=decay_rate,
            decay_rate_without_film=self._modes.decay_rate,
            gap=float(gap),
        )

    def _response(self, first: np.ndarray) -> Advance:
        vibration = RimVibration(self._motion, self._modes)
        chosen = np.arange(len(self._modes))
        return SolvedModes(vibration, chosen, self.ringing).advance


class RimVibration:
    """Vibration of a rattling disk, expressed in the modes used for the sound.

    The motion identifies its modes by their order and phase around the rim. A mode of
    the sound without a counterpart in the motion is at rest.
    """

    def __init__(self, motion: Motion, modes: Modes) -> None:
        self.t = motion.t
        self._motion = motion
        self._share = mode_shares(motion.rim_modes, modes)

    def vibration(self, t: np.ndarray) -> np.ndarray:
        """Return displacement, velocity and acceleration (k, 3, m) of the modes at
        times t (k,)."""
        return self._motion.rim_vibration(t) @ self._share


def mode_shares(rim: Any, modes: Modes) -> np.ndarray:
    """Return the amplitudes (d, m), 0 or +-1, of m modes for unit amplitudes of d rim
    modes.

    Modes of unit modal mass match if order, parity and frequency agree; the sign
    follows from their axial displacements at the lower edge.
    """
    # Maximum relative difference between the frequencies of one mode in two solutions
    max_mistuning = 0.05
    frequency = np.sqrt(rim.squared) / (2 * np.pi)
    share = np.zeros((len(frequency), len(modes)))
    for i, order in enumerate(modes.order):
        phase = np.pi / 2 * (modes.parity[i] == "odd")
        mistuning = np.abs(frequency / modes.frequency[i] - 1)
        mistuning[(rim.order != order) | (rim.phase != phase)] = np.inf
        nearest = int(np.argmin(mistuning)) if len(mistuning) else -1
        if nearest < 0 or mistuning[nearest] > max_mistuning:
            continue
        wave = np.cos(order * modes.rim_angle - phase)
        axial = float(wave @ modes.rim_shape[i, :, 2]) * float(rim.axial[nearest])
        share[nearest, i] = np.sign(axial)
    return share
