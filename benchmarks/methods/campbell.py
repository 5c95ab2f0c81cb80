"""Analyse the stability of the steady motion of a disk on one table mode as a function
of its speed.

Complex numbers describe quantities that rotate about the vertical: the tilt nu, which
is the horizontal part of the axis, towards the contact, and the mode p. The table rises
by Re(conj(p) e^{i n phi})/sqrt(M) on the contact circle. Both are given in the frame
that rotates with the contact at Omega. A smooth thin-lipped disk without spin obeys, at
small inclinations,

    m z'' = N - m g,    J (nu'' + 2 i Omega nu' - Omega^2 nu) = -R N e^{i psi} + T,
    p'' + 2 (i n Omega + zeta w) p'
        + (w^2 - n^2 Omega^2 + 2 i zeta w n Omega) p = -N e^{i n psi}/sqrt(M).

The contact is rigid: the gap z - R Re(conj(nu) e^{i psi}) - Re(conj(p) e^{i n
psi})/sqrt(M) has its minimum, zero, at psi. The moment T compensates the wave drag, so
that a steady motion exists.
"""

from typing import NamedTuple

import numpy as np

from dynamics.compliant.law.linearised import inertias
from dynamics.disk import Disk
from dynamics.surface import SurfaceMode


class CampbellDiagram(NamedTuple):
    """Steady motions at x = n Omega/w (k,) and their stability.

    Attributes
    ----------
    x : (k,) array
        Precession frequency times the order, divided by the mode frequency.
    omega : (k,) array
        Precession rate Omega [rad/s].
    inclination : (k,) array
        Inclination [rad].
    eigenvalue : (k, 8) array
        Eigenvalues [1/s] by ascending imaginary part: nutation and both waves, each
        with its conjugate, and two drifts. A positive real part means growth:
        divergence for imaginary part 0, else flutter. NaN where the table is bent more
        than the rim is inclined, so that the contact is not a single point.
    """

    x: np.ndarray
    omega: np.ndarray
    inclination: np.ndarray
    eigenvalue: np.ndarray


def campbell_diagram(disk: Disk, mode: SurfaceMode, x) -> CampbellDiagram:
    """Return the Campbell diagram of a disk on one table mode at positive x = n Omega/w
    (k,).

    It is valid for small inclinations without friction. The nutation frequency on a
    rigid table is Omega (3 J/(J + m R^2))^0.5, within 1 % of that of a rolling disk.
    Raises ValueError for a mode without order, and for speeds that are not positive and
    finite.
    """
    x = np.atleast_1d(np.asarray(x, dtype=float))
    if mode.order < 1 or not (np.isfinite(x) & (x > 0)).all():
        raise ValueError(
            "campbell: needs a mode of order 1 or more, and positive x = n Omega/w"
        )
    omega = x * 2 * np.pi * mode.frequency / mode.order
    found = [_eigenvalues(disk, mode, rate) for rate in omega]
    return CampbellDiagram(
        x, omega, *(np.array(part) for part in zip(*found, strict=True))
    )


def _eigenvalues(disk, mode, rate):
    """Return inclination and eigenvalues (8,) at one Omega.

    The unknowns (4,) are the real and imaginary parts of nu and p.
    """
    m = disk.mass
    R = disk.radius
    J = inertias(disk)[0]
    N = disk.weight
    n = mode.order
    w = 2 * np.pi * mode.frequency
    A = mode.modal_mass**-0.5
    decay = mode.damping_ratio * w
    stiff = w**2 - (n * rate) ** 2 + 2j * decay * n * rate
    p = -N * A / stiff
    tilt = (
        N * R / (J * rate**2) - 1j * A * n / R * p.imag
    )  # the rim is level where it touches the table
    bend = (
        R * tilt.real + A * n**2 * p.real
    )  # second derivative of the gap along the rim
    if not bend > 0:
        return abs(tilt), np.full(8, np.nan)
    touch = np.array([R, 0, A, 0])  # derivatives of z and bend psi by the unknowns
    turn = np.array([0, R, 0, n * A])
    mass = np.diag([J, J, 1, 1]) + m * np.outer(touch, touch)
    gyration = np.zeros((4, 4))
    gyration[:2, :2] = _real(2j * rate * J)
    gyration[2:, 2:] = _real(2j * n * rate + 2 * decay)
    stiffness = np.zeros((4, 4))
    stiffness[:2, :2] = _real(-J * rate**2)
    stiffness[2:, 2:] = _real(stiff)
    stiffness += (
        N / bend * np.outer(turn, turn)
    )  # the force -i N dpsi on nu and p is parallel to turn
    first = np.block(
        [
            [np.zeros((4, 4)), np.eye(4)],
            [
                np.linalg.solve(
                    mass,
                    np.hstack([-stiffness, -gyration]),
                )
            ],
        ]
    )
    found = np.linalg.eigvals(first)
    return abs(tilt), found[np.lexsort((found.real, found.imag))]


def _real(c):
    """Return the real matrix (2, 2) of the multiplication by a complex number."""
    c = complex(c)
    return np.array([[c.real, -c.imag], [c.imag, c.real]])
