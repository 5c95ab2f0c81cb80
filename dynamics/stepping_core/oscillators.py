"""Vibration of modes of unit modal mass in a time step.

Each mode obeys q'' = -w^2 q - 2 d q' + f. The midpoint rule has constants for which
frequency and decay of the free vibration are exact; the propagator is exact itself.
"""

from typing import NamedTuple

import numpy as np

from dynamics.numba_kernels import kernel


class MidpointModes(NamedTuple):
    """Constants of m modes in the midpoint rule with a step h.

    Attributes
    ----------
    stiffness, damping : (m,) arrays
        Constants k [1/s^2] and c [1/s] of q'' = -k q - c q'.
    compliance : (m,) array
        1/(1 + h c/2 + h^2 k/4).
    """

    stiffness: np.ndarray
    damping: np.ndarray
    compliance: np.ndarray


def midpoint_modes(squared: np.ndarray, decay: np.ndarray, h: float) -> MidpointModes:
    """Return the constants for which the midpoint rule is exact in a step h [s].

    `squared` [1/s^2] and `decay` [1/s] (m,) are squared angular frequencies and decay rates.
    """
    pole = -decay + 1j * np.sqrt(squared - decay**2 + 0j)
    midpoint = 2 / h * np.tanh(pole * h / 2)
    k = np.abs(midpoint) ** 2
    c = -2 * midpoint.real
    return MidpointModes(k, c, 1 / (1 + h * c / 2 + h * h * k / 4))


class ExactModes(NamedTuple):
    """Constants of m modes that vibrate freely between impulses, one in each step h.

    Attributes
    ----------
    frequency, decay : ndarray, shape (m,)
        Angular frequency [rad/s] and decay rate [1/s].
    mean_factor : ndarray, shape (m,)
        sin(x)/x with x = w h/2, which is the average over the free vibration in a step.
    endpoint_mean_factor : ndarray, shape (m,)
        x/tan(x), for the mean of the displacements at both ends of the step.
    """

    frequency: np.ndarray
    decay: np.ndarray
    mean_factor: np.ndarray
    endpoint_mean_factor: np.ndarray


def exact_modes(frequency: np.ndarray, decay: np.ndarray, rate: float) -> ExactModes:
    """Return the `ExactModes` of angular frequencies (m,) [rad/s] at `rate` steps per second."""
    turn = frequency / (2 * rate)
    return ExactModes(
        frequency,
        decay,
        np.sinc(frequency / (2 * np.pi * rate)),
        turn / np.tan(turn),
    )


@kernel
def write_propagator(modes: ExactModes, h: float, out: np.ndarray) -> None:
    """Write the propagator of each of `ExactModes` over a time h to `out` (4, m)."""
    for j in range(modes.frequency.size):
        d = modes.decay[j]
        w = np.sqrt(modes.frequency[j] ** 2 - d * d)
        c = np.cos(w * h)
        s = np.sin(w * h)
        fade = np.exp(-d * h)
        out[0, j] = fade * (c + d / w * s)
        out[1, j] = fade * s / w
        out[2, j] = -fade * s * (w * w + d * d) / w
        out[3, j] = fade * (c - d / w * s)
