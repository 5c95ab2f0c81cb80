"""Compute the sound radiated by both faces of a disk into half spaces, and the
resulting damping."""

from collections.abc import Sequence
from math import pi
from typing import NamedTuple, Protocol

import numpy as np
from scipy.special import jv

from modal.modes import Modes

AIR_DENSITY = 1.204  # kg/m^3
"""Density of dry air at 20 degrees Celsius and 101325 Pa."""
SOUND_SPEED = 343.2  # m/s
"""Speed of sound in dry air at 20 degrees Celsius."""


class AirConstants(Protocol):
    """Properties of the air: density [kg/m^3] and speed of sound [m/s]."""

    @property
    def density(self) -> float: ...
    @property
    def sound_speed(self) -> float: ...


class StandardAir(NamedTuple):
    """Dry air at 20 degrees Celsius and 101325 Pa: density [kg/m^3], speed of sound
    [m/s]."""

    density: float = AIR_DENSITY
    sound_speed: float = SOUND_SPEED


STANDARD_AIR = StandardAir()
"""Default air of this module."""
BOTTOM_FACE = 0
"""Index of the bottom face in `Modes.face_shape`."""
TOP_FACE = 1
"""Index of the top face in `Modes.face_shape`."""


def directivity(
    modes: Modes, sine: np.ndarray, air: AirConstants = STANDARD_AIR
) -> np.ndarray:
    """Compute the far-field Rayleigh integral D = int w exp(i k . x) dA of the axial
    motion of the faces.

    At azimuth phi, D = sum_n i^n (A_n cos n phi + B_n sin n phi). For w = sum_n w_n cos
    n theta + v_n sin n theta, A_n is the Hankel transform 2 pi int w_n(r) J_n(k r sine)
    r dr, and B_n that of v_n.

    Orders of b/2 and above are set to 0, because b face angles alias them to lower
    orders. For disks up to five wavelengths across, J_n(k r) is below 1e-6 for n >= 32;
    on wider thin disks those orders radiate.

    Parameters
    ----------
    modes : Modes
        The modes.
    sine : ndarray, shape (c,)
        Sines of the angle between direction and axis.
    air : AirConstants, optional
        Density [kg/m^3] and speed of sound [m/s].

    Returns
    -------
    ndarray, shape (2, n, m, 2, c)
        A and B [m^2 kg^-1/2] by order, mode, face (bottom, top) and direction.
    """
    count = len(modes.face_angle)
    wave = np.fft.rfft(modes.face_shape, axis=3) / count
    wave[..., 1:] *= 2
    wave[2 * modes.order >= count] = 0
    order = np.arange(wave.shape[3])
    k = 2 * pi * modes.frequency / air.sound_speed
    size = np.abs(wave)
    strong = (size > 1e-6 * size.max(initial=0.0)).any(axis=(1, 2))
    bessel = np.zeros((len(order), len(modes), len(sine), len(modes.face_radius)))
    for i, n in np.argwhere(strong):
        bessel[n, i] = jv(n, np.multiply.outer(k[i] * sine, modes.face_radius))
    parts = np.stack([wave.real, -wave.imag])
    return (
        2
        * pi
        * np.einsum(
            "pmfrn,nmcr,r->pnmfc", parts, bessel, modes.face_weight, optimize=True
        )
    )


def radiation_decay(
    modes: Modes,
    faces: Sequence[int] = (BOTTOM_FACE, TOP_FACE),
    air: AirConstants = STANDARD_AIR,
) -> np.ndarray:
    """Compute the decay rates of modes due to sound radiation from the faces.

    Each face radiates into its own half space, as if a baffle separated them. Without a
    baffle, the sound of the two sides of a disk that is small compared with the
    wavelength cancels, and the result is too large: by the factor 27 pi^2/(8 (k a)^2)
    [2]_ for a rigid disk in heave, which is 100 at k a = 0.6 (0.9 kHz for a radius of
    37.55 mm). Radiation from the rim, the only sound of in-plane modes, is neglected,
    as are the orders set to 0 in `directivity`.

    Parameters
    ----------
    modes : Modes
        The modes.
    faces : sequence of int, optional
        Faces that radiate: 0 (bottom), 1 (top).
    air : AirConstants, optional
        Density [kg/m^3] and speed of sound [m/s]; by default dry air at 20 degrees
        Celsius.

    Returns
    -------
    ndarray, shape (m,)
        Decay rates d = P/(2 E) [1/s], with radiated power P and energy E.

    Notes
    -----
    With velocity amplitude v and unit modal mass, |p| = rho w |v D|/(2 pi R) [1]_. The
    power is P = int |p|^2/(2 rho c) R^2 dO = rho w^2 v^2/(8 pi^2 c) int |D|^2 dO, and
    the energy is E = v^2/2.

    References
    ----------
    .. [1] Rayleigh (1896), The Theory of Sound, sections 278 and 302.
    .. [2] Lamb (1932), Hydrodynamics, section 102.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, radiation_decay
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> [f"{rate:.1f} 1/s" for rate in radiation_decay(modes)[1:3]]
    ['0.9 1/s', '9.0 1/s']
    """
    gauss_points = 24  # in the direction cosine; sufficient for disks up to five wavelengths across
    cosine, weight = np.polynomial.legendre.leggauss(gauss_points)
    sine = np.sqrt(1 - ((cosine + 1) / 2) ** 2)
    square = directivity(modes, sine, air)[:, :, :, list(faces)] ** 2
    around = np.where(np.arange(square.shape[1]) == 0, 2 * pi, pi)
    power = np.einsum("pnmfc,n,c->m", square, around, weight / 2)
    return (
        air.density
        * (2 * pi * modes.frequency) ** 2
        / (8 * pi**2 * air.sound_speed)
        * power
    )


def with_radiation(
    modes: Modes,
    faces: Sequence[int] = (BOTTOM_FACE, TOP_FACE),
    air: AirConstants = STANDARD_AIR,
) -> Modes:
    """Add the decay rates of `radiation_decay` to those of the modes.

    Parameters
    ----------
    modes : Modes
        The modes.
    faces : sequence of int, optional
        Faces that radiate: 0 (bottom), 1 (top).
    air : AirConstants, optional
        Density [kg/m^3] and speed of sound [m/s]; by default dry air at 20 degrees
        Celsius.

    Returns
    -------
    Modes
        The same modes with larger decay rates.

    Examples
    --------
    >>> from modal import Material, Plate, plate_modes, with_radiation
    >>> steel = Material(name="steel")
    >>> plate = Plate(radius=0.0375, thickness=0.003, material=steel, density=7850.0)
    >>> modes = plate_modes(plate, 8e3, "draft")
    >>> bool((with_radiation(modes).decay_rate > modes.decay_rate).all())
    True
    """
    return modes.with_decay(modes.decay_rate + radiation_decay(modes, faces, air))
