"""Determine which modes are audible, how loud they are, and how long they ring."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dynamics.a_weighting import a_weighting_db
from modal import Modes, SurfaceModes
from sonify.scene import Scene
from sonify.sound.modal_forcing import forcing_per_newton
from sonify.sound.radiation import listener_of, tabulated_directivity

RING_DOWN_DB = 60.0
"""Level [dB] below the loudest mode at which a ringing mode becomes inaudible."""
MAX_RING_TIME = 10.0  # s
"""Maximum duration of the ring-down after the motion."""


@dataclass(frozen=True, kw_only=True, eq=False)
class RingDown:
    """Frequencies and decay rates of m modes that decay freely after the motion.

    Attributes
    ----------
    frequency : ndarray, shape (m,)
        [Hz]
    decay_rate : ndarray, shape (m,)
        [1/s]
    decay_rate_without_film : ndarray, shape (m,)
        Decay rate due to material and radiation alone [1/s].
    gap : float or None
        Mean gap [m] of the air film that damps the modes, or None without a film.
    """

    frequency: np.ndarray
    decay_rate: np.ndarray
    decay_rate_without_film: np.ndarray
    gap: float | None = None

    @property
    def decay_time(self) -> np.ndarray:
        """Decay time T60 (m,) [s], for a decay by 60 dB; infinite without losses."""
        with np.errstate(divide="ignore"):
            return 3 * np.log(10) / self.decay_rate


def modes_below_nyquist(
    modes: Modes, sample_rate: float, wanted: Sequence[int] | np.ndarray | None = None
) -> np.ndarray:
    """Return the indices (k,) of the wanted modes below the Nyquist frequency.

    Higher modes would alias. By default all modes are wanted."""
    keep = np.arange(len(modes)) if wanted is None else np.array(wanted, dtype=int)
    return keep[modes.frequency[keep] < sample_rate / 2]


def response_to_unit_jump(modes: Modes, scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    """Return loudness (m,) [Pa^2 s] and energy (m,) [J] of the modes after a force jump
    of 1 N.

    The forcing of a mode is the root of the sum of squares over the three force
    directions, and its radiation the root mean square of Rayleigh's integral over 64
    azimuths."""
    forcing2 = np.square(forcing_per_newton(modes, scene)).sum(axis=0)
    radiation = tabulated_directivity(modes, listener_of(scene), count=64)
    return loudness_and_energy(modes, forcing2, np.mean(np.abs(radiation) ** 2, axis=0))


def loudness_and_energy(
    modes: Modes | SurfaceModes, forcing2: np.ndarray, radiation2: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return loudness (m,) [Pa^2 s] and energy (m,) [J] of modes after a unit jump of
    the force.

    A mode of unit modal mass and forcing g rings as q'' = g exp(-d t) cos(w t). Its
    energy is g^2/(2 w^2), and the integral of its squared A-weighted pressure is (g
    R)^2/(4 d), where R is the pressure per unit acceleration. The arguments are the
    squares of g and R (m,). If the nutation frequency instead sweeps through the modes
    at the rate w^2/k, it excites q'' = g sqrt(pi k/2), so the ratios between modes are
    the same."""
    weight = 10 ** (a_weighting_db(modes.frequency) / 10)
    decay = np.maximum(modes.decay_rate, 1 / MAX_RING_TIME)
    return weight * forcing2 * radiation2 / (4 * decay), forcing2 / (
        2 * (2 * np.pi * modes.frequency) ** 2
    )


def ring_down_time(modes: Modes, scene: Scene, decay_rate: np.ndarray) -> float:
    """Return the time [s] from the end of the motion until no mode is audible.

    The result is limited to MAX_RING_TIME. The modes decay at `decay_rate` (m,) [1/s],
    which may include damping by a film."""
    loudness, _ = response_to_unit_jump(modes, scene)
    at_start = loudness * np.maximum(modes.decay_rate, 1 / MAX_RING_TIME)
    with np.errstate(divide="ignore"):
        level = 10 * np.log10(at_start / at_start.max(initial=1e-300))
        duration = (RING_DOWN_DB + level) / (20 / np.log(10) * decay_rate)
    return float(np.clip(duration.max(initial=0.0), 0.0, MAX_RING_TIME))
