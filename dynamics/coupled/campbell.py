"""How a disk that turns steadily over one mode of a table would depart from that motion: eigenvalues by its speed.

Written with complex numbers for what turns about the vertical: the tilt nu, the horizontal part of the axis, towards
the contact; the mode p, so that the table rises by Re(conj(p) e^{i n phi})/sqrt(M) on the contact circle; both in the
frame that turns with the contact at Omega. A smooth thin-lipped disk at small inclinations, whose spin stays 0, obeys

    m z'' = N - m g,    J (nu'' + 2 i Omega nu' - Omega^2 nu) = -R N e^{i psi} + T,
    p'' + 2 (i n Omega + zeta w) p' + (w^2 - n^2 Omega^2 + 2 i zeta w n Omega) p = -N e^{i n psi}/sqrt(M),

psi being where z - R Re(conj(nu) e^{i psi}) - Re(conj(p) e^{i n psi})/sqrt(M) is least, and zero: a rigid contact. T
is the moment that would make up for the wave drag, so that there is a steady motion to depart from.
"""

from typing import NamedTuple

import numpy as np

from ..disk import Disk
from ..surface import SurfaceMode
from .resonance import inertias


class Campbell(NamedTuple):
    """Of steady motions at x = n Omega/w (k,): Omega (k,) [rad/s], inclination (k,) [rad], and the eigenvalues (k, 8)
    [1/s] by ascending imaginary part: of the nutation and of both waves, each with its conjugate, and of two drifts.

    A positive real part is a growth: divergence where the imaginary part is 0, else flutter. NaN where the table is
    bent more than the rim is inclined, so that the disk does not touch at one place.
    """

    x: np.ndarray
    omega: np.ndarray
    inclination: np.ndarray
    eigenvalue: np.ndarray


def campbell(disk: Disk, mode: SurfaceMode, x) -> Campbell:
    """Return the `Campbell` diagram of a disk on one mode of a table at x = n Omega/w (k,), positive.

    Small inclinations; without friction: the nutation on a rigid table is Omega (3 J/(J + m R^2))^0.5, within 1 % of
    that of a disk that rolls. Raises ValueError for a mode without order and for speeds that are none.
    """
    x = np.atleast_1d(np.asarray(x, dtype=float))
    if mode.order < 1 or not (np.isfinite(x) & (x > 0)).all():
        raise ValueError("campbell: needs a mode of order 1 or more, and positive x = n Omega/w")
    omega = x * 2 * np.pi * mode.frequency / mode.order
    found = [_eigenvalues(disk, mode, rate) for rate in omega]
    return Campbell(x, omega, *(np.array(part) for part in zip(*found, strict=True)))


def _eigenvalues(disk, mode, rate):
    """Return the inclination and the eigenvalues (8,) at one Omega; unknowns are Re and Im of nu and p, (4,)."""
    m, R, J, N = disk.mass, disk.radius, inertias(disk)[0], disk.weight
    n, w, A = mode.order, 2 * np.pi * mode.frequency, mode.modal_mass**-0.5
    decay = mode.damping_ratio * w
    stiff = w**2 - (n * rate) ** 2 + 2j * decay * n * rate
    p = -N * A / stiff
    tilt = N * R / (J * rate**2) - 1j * A * n / R * p.imag  # the rim is level where it touches the table
    bend = R * tilt.real + A * n**2 * p.real  # of the gap along the rim
    if not bend > 0:
        return abs(tilt), np.full(8, np.nan)
    touch, turn = np.array([R, 0, A, 0]), np.array([0, R, 0, n * A])  # dz and bend dpsi by the unknowns
    mass = np.diag([J, J, 1, 1]) + m * np.outer(touch, touch)
    gyration = np.zeros((4, 4))
    gyration[:2, :2], gyration[2:, 2:] = _real(2j * rate * J), _real(2j * n * rate + 2 * decay)
    stiffness = np.zeros((4, 4))
    stiffness[:2, :2], stiffness[2:, 2:] = _real(-J * rate**2), _real(stiff)
    stiffness += N / bend * np.outer(turn, turn)  # -i N dpsi on nu and p is along turn
    first = np.block([[np.zeros((4, 4)), np.eye(4)], [np.linalg.solve(mass, np.hstack([-stiffness, -gyration]))]])
    found = np.linalg.eigvals(first)
    return abs(tilt), found[np.lexsort((found.real, found.imag))]


def _real(c):
    """Return the matrix (2, 2) by which a complex number multiplies."""
    c = complex(c)
    return np.array([[c.real, -c.imag], [c.imag, c.real]])
