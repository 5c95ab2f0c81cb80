"""What the film of air does to the disk: a wedge h = sin(beta) (R + x) open at the rim, closed at the contact x = -R.

Reynolds' equation for the two ways in which the gap changes: it turns with the precession, or closes as the disk falls.
reynolds.py solves it, forces.py has what comes out in closed form, and tests/test_film_solved.py compares.
"""

from collections.abc import Iterable
from itertools import islice, repeat
from typing import NamedTuple

import numpy as np

from ..air import Air
from ..disk import Disk
from ..equations import Law, Loads
from ..kinematics import arms, precession_rate
from .forces import FLATTENS, SLIP, SLOW, forces

TURNING = 0.1067607949
"""I: the power of the turning film is 12 mu R^3 I Omega^2/sin(beta). It is pi/3 - (32/pi) int_0^inf k^2 K0(k)/K1(k)
F(k) dk with F(k) = int_k^inf K0 K1/t dt."""
FALLING = 0.3808
"""I_n: the power of the falling film is 12 mu R^3 I_n omega_1^2/sin(beta)^3."""


class Film(NamedTuple):
    """The film's loads: the constants of `forces`, dimensionless.

    The factor (1 + (S/6.3)^2.5)^0.4, S = sin(beta) R sqrt(Omega rho/(2 mu)), for the inertia of the turning air is a
    fit to Stokes' unsteady equation: within 5 % for S <= 3, 30 % above. The falling film has no inertia.
    """

    turning: float | None
    falling: float | None
    inertia: float | None
    number: float | None
    ambient: float | None
    slip: float | None
    is_singular = False
    carries = True

    def __call__(self, beta, omega, slip, law: Law, flow) -> Loads:
        """Return the loads as `Resistance` does: a lift, and the moment that makes it take the power of the film."""
        s = flow.sin(beta)
        drag, tip, lift = forces(s, omega[0], precession_rate(omega[2], s), *self)
        return Loads(M1=-tip - arms(flow.cos(beta), s, law.h)[1] * lift, M3=-drag, G3=lift)

    def at(self, beta, omega) -> tuple:
        """Return the moments of `forces` at inclinations and angular velocities, dimensionless."""
        s = np.sin(beta)
        return forces(s, omega[0], precession_rate(omega[2], s), *self)

    def powers(self, beta, omega) -> tuple:
        """Return what the turning and the falling film take, dimensionless, at inclinations and angular velocities."""
        drag, tip, _ = self.at(beta, omega)
        return drag * omega[2], tip * omega[0]

    @property
    def shape(self) -> "Film":
        """What a compiled flow depends on: no number."""
        return self.filled(repeat(None))

    @property
    def numbers(self) -> tuple[float, ...]:
        """The numbers (6,) that `shape` leaves out."""
        return tuple(self)

    def filled(self, numbers: Iterable) -> "Film":
        """Return a film with `numbers` (6,), of any kind."""
        return Film(*islice(numbers, len(self)))


def film_under(disk: Disk, air: Air) -> Film:
    """Return the film of a solid disk in air. Raises ValueError for a disk without a face, and in a vacuum."""
    if disk.shape != "solid":
        raise ValueError("air.film = 'acts': only the film under a solid disk is known, and this one is a shell")
    if not air.pressure:
        raise ValueError("air.film = 'acts': a vacuum, air.pressure = 0, has no film")
    R, chi = disk.radius, disk.time_unit
    unit = disk.mass * R**2 / chi**2
    moment = 12 * air.viscosity * R**3 / (unit * chi)
    layers = R**2 * air.density / (2 * air.viscosity * chi) / SLOW**2
    return Film(
        turning=TURNING * moment,
        falling=FALLING * moment,
        inertia=layers**2,
        number=12 * air.viscosity / (air.pressure * chi * FLATTENS),
        ambient=air.pressure * np.pi * R**3 / unit,
        slip=SLIP * air.mean_free_path / R,
    )


def thickness(beta, rate, radius: float, air: Air):
    """Return S, the mean gap over sqrt(2) times the depth of the boundary layers, at precession `rate` [rad/s]."""
    return np.sin(beta) * radius * np.sqrt(np.abs(rate) * air.density / (2 * air.viscosity))


def compressibility(beta, rate, air: Air):
    """Return Lam = 12 mu Omega/(p beta^2), from which air is squeezed, at precession `rate` [rad/s]."""
    return 12 * air.viscosity * np.abs(rate) / (air.pressure * np.sin(beta) ** 2)


def falls_faster(beta, nutation, radius: float, air: Air):
    """Return how fast a fall at `nutation` [rad/s] closes the film over how fast that lets air out.

    It is 12 mu omega_1/(p beta^3) without slip. A film that keeps its air resists more than its law says, by 12 % of it
    at 1 and 27 % at 3.
    """
    s = np.sin(beta)
    out = s * s * (s + SLIP / 2 * air.mean_free_path / radius)
    return 12 * air.viscosity * np.maximum(nutation, 0.0) / (air.pressure * out)


def film_in(loads) -> Film | None:
    """Return the film among the loads of a motion."""
    every = getattr(loads, "laws", (loads,))
    return next((law for law in every if isinstance(law, Film)), None)
