"""What sound takes from the modes: radiation from both faces, each into its own half space."""

from collections.abc import Sequence
from math import pi
from typing import NamedTuple, Protocol

import numpy as np
from scipy.special import jv

from modal.modes import Modes

AIR_DENSITY = 1.204
"""Dry air at 20 degrees and 101325 Pa [kg/m^3]."""
SOUND_SPEED = 343.2
"""In the same air [m/s]."""


class Air(Protocol):
    """What radiation asks of the air: density [kg/m^3] and speed of sound [m/s]."""

    @property
    def density(self) -> float: ...
    @property
    def sound_speed(self) -> float: ...


class StandardAir(NamedTuple):
    """The air that is meant where none is given."""

    density: float = AIR_DENSITY
    sound_speed: float = SOUND_SPEED


STANDARD_AIR = StandardAir()
BOTTOM, TOP = 0, 1
"""The faces, as in `Modes.face_shape`."""
DIRECTIONS = 24
"""Gauss points of the direction cosine in a half space: enough for a disk some five wavelengths across."""


def directivity(modes: Modes, sine, air: Air = STANDARD_AIR) -> np.ndarray:
    """Amplitudes (2, n, m, 2, c) [m^2 kg^-1/2] of Rayleigh's integral of the axial motion, D = int w exp(i k . x) dA.

    At azimuth phi it is sum_n i^n (A_n cos n phi + B_n sin n phi), with the Hankel transform A_n = 2 pi int w_n(r)
    J_n(k r sine) r dr of w = sum_n w_n cos n theta + v_n sin n theta, and B_n likewise; A, B are the first index, then
    come the orders, the modes, the bottom and the top face, the directions with sines (c,) of the angle to the axis.

    Modes of order b/2 and up are given 0: on b face angles they look like lower orders, which they are not. On a disk
    as small as DIRECTIONS are enough for, J_n(k r) of n = 32 and up is below 1e-6; on a wider, thin one they radiate.
    """
    count = len(modes.face_angle)
    wave = np.fft.rfft(modes.face_shape, axis=3) / count
    wave[..., 1:] *= 2
    wave[2 * modes.order >= count] = 0
    order = np.arange(wave.shape[3])
    k = 2 * pi * modes.frequency / air.sound_speed
    strong = (np.abs(wave) > 1e-6 * np.abs(wave).max(initial=0.0)).any(axis=(1, 2))
    bessel = np.zeros((len(order), len(modes), len(sine), len(modes.face_radius)))
    for i, n in np.argwhere(strong):
        bessel[n, i] = jv(n, np.multiply.outer(k[i] * sine, modes.face_radius))
    parts = np.stack([wave.real, -wave.imag])
    return 2 * pi * np.einsum("pmfrn,nmcr,r->pnmfc", parts, bessel, modes.face_weight, optimize=True)


def radiation_decay(modes: Modes, faces: Sequence[int] = (BOTTOM, TOP), air: Air = STANDARD_AIR) -> np.ndarray:
    """Decay rate (m,) [1/s] by radiation of `faces`: radiated power over twice the energy of a mode of modal mass 1.

    Rayleigh (1896), sections 278 and 302: |p| = rho w |v D|/(2 pi R) with velocity amplitude v = w q, so that
    P = int |p|^2/(2 rho c) R^2 dO = rho w^2 v^2/(8 pi^2 c) int |D|^2 dO; the energy is v^2/2 and d = P/(2 E).
    Each face radiates into its own half space as if a baffle parted them. Without one the two sides of a bending disk
    cancel where it is small against the wavelength: there this is too large, for a rigid disk that heaves by
    27 pi^2/(8 (k a)^2), Lamb (1932), section 102: a hundredfold at k a = 0.6, 0.9 kHz for a radius of 37.55 mm. The
    rim's own radiation, all that in-plane modes have, is left out, and so are orders that the face angles do not show:
    see `directivity`.
    """
    cosine, weight = np.polynomial.legendre.leggauss(DIRECTIONS)
    square = directivity(modes, np.sqrt(1 - ((cosine + 1) / 2) ** 2), air)[:, :, :, list(faces)] ** 2
    around = np.where(np.arange(square.shape[1]) == 0, 2 * pi, pi)
    power = np.einsum("pnmfc,n,c->m", square, around, weight / 2)
    return air.density * (2 * pi * modes.frequency) ** 2 / (8 * pi**2 * air.sound_speed) * power


def with_radiation(modes: Modes, faces: Sequence[int] = (BOTTOM, TOP), air: Air = STANDARD_AIR) -> Modes:
    """The modes with the decay by radiation of `faces` added to their material one."""
    return modes.with_decay(modes.decay_rate + radiation_decay(modes, faces, air))
