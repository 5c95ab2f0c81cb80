"""What sound takes from the modes: radiation from both faces, each into its own half space."""

from math import pi

import numpy as np

from .modes import Modes

AIR_DENSITY = 1.204
"""[kg/m^3] at 20 degrees."""
SOUND_SPEED = 343.2
"""[m/s] at 20 degrees."""
DIRECTIONS = 32
"""Gauss points of the direction cosine, and azimuths: enough for a disk some five wavelengths across."""


def far_field(modes: Modes, direction_cosine, azimuth) -> np.ndarray:
    """Complex directivity (m, c, a) [m^2 kg^-1/2]: Rayleigh's integral of the outward motion.

    D = s int w exp(i k . x) dA over the top face, s = 1, for direction cosines > 0, over the bottom one, s = -1, for
    others: each face is taken to radiate as if baffled, into its own half space.
    """
    k = 2 * pi * modes.frequency / SOUND_SPEED
    r, theta = modes.face_radius, modes.face_angle
    sine = np.sqrt(1 - direction_cosine**2)
    phase = np.cos(azimuth[:, None] - theta)
    area = modes.face_weight[:, None] * 2 * pi / len(theta)
    result = np.empty((len(modes), len(direction_cosine), len(azimuth)), complex)
    for i in range(len(modes)):
        path = np.einsum("c,r,at->cart", k[i] * sine, r, phase)
        top = (direction_cosine > 0).astype(int)
        w = modes.face_shape[i][top] * np.where(top, 1.0, -1.0)[:, None, None]
        result[i] = np.einsum("crt,cart,rt->ca", w, np.exp(1j * path), area)
    return result


def radiation_decay(modes: Modes) -> np.ndarray:
    """Decay rate (m,) [1/s] by radiation: radiated power over twice the energy of a mode of modal mass 1.

    Rayleigh (1896), sections 278 and 302: |p| = rho w |v D|/(2 pi R) with velocity amplitude v = w q, so that
    P = int |p|^2/(2 rho c) R^2 dO = rho w^2 v^2/(8 pi^2 c) int |D|^2 dO; the energy is v^2/2 and d = P/(2 E).
    Without a baffle the faces short-circuit where the disk is small against the wavelength: there it is an upper bound.
    The rim's own radiation, all that in-plane modes have, is left out.
    """
    cosine, weight = np.polynomial.legendre.leggauss(DIRECTIONS)
    azimuth = np.arange(DIRECTIONS) * 2 * pi / DIRECTIONS
    power = np.einsum("mca,c->m", np.abs(far_field(modes, cosine, azimuth)) ** 2, weight) * 2 * pi / len(azimuth)
    rate = 2 * pi * modes.frequency
    return AIR_DENSITY * rate**2 / (8 * pi**2 * SOUND_SPEED) * power


def with_radiation(modes: Modes) -> Modes:
    """The modes with the decay by radiation added to their material one."""
    return modes.with_decay(modes.decay_rate + radiation_decay(modes))
