"""What the film of air does to the disk: a wedge h = sin(beta) (R + x) open at the rim, closed at the contact x = -R.

Reynolds' equation div(h^3 grad p) = 12 mu dh/dt, with p = 0 at the rim, for the two ways in which the gap changes: it
turns with the precession, or closes as the disk falls. reynolds.py solves it; tests/test_film.py compares.
"""

from collections.abc import Iterable, Iterator
from itertools import repeat
from typing import NamedTuple

import numpy as np

from ..air import Air
from ..disk import Disk
from ..equations import Law, Loads
from ..kinematics import arms, precession_rate

TURNING = 0.1067607949
"""I: the power of the turning film is 12 mu R^3 I Omega^2/sin(beta). It is pi/3 - (32/pi) int_0^inf k^2 K0(k)/K1(k)
F(k) dk with F(k) = int_k^inf K0 K1/t dt."""
FALLING = 0.3808
"""I_n: the power of the falling film is 12 mu R^3 I_n omega_1^2/sin(beta)^3."""
LEVER = 1.75
"""Radius over the distance of the falling film's lift from the contact."""
SLOW = 6.3
"""Thickness of the film over that of its boundary layers, S, from which its inertia counts in the turning film."""
NOTHING = 1e-12
"""Added to (S/SLOW)^4, of which a broken power is taken: without precession its series has no end."""


class Film(NamedTuple):
    """The film's loads, dimensionless: moments per angular velocity and power of sin(beta), and (S/SLOW)^4 over Omega^2
    sin(beta)^4.

    The factor (1 + (S/6.3)^2.5)^0.4, S = sin(beta) R sqrt(Omega rho/(2 mu)), for the inertia of the turning air is a
    fit to Stokes' unsteady equation: within 5 % for S <= 3, 30 % above. The falling film has no inertia.
    """

    turning: float | None
    falling: float | None
    inertia: float | None
    is_singular = False
    carries = True

    def __call__(self, beta, omega, slip, law: Law, flow) -> Loads:
        """Return the loads as `Resistance` does: a lift, and the moment that makes it take the power of the film."""
        s = flow.sin(beta)
        rate = precession_rate(omega[2], s)
        drag = self.turning * rate / (s * s) * self.heaviness(s, rate, flow.power)
        lift, side = self.lift(s, omega[0]), arms(flow.cos(beta), s, law.h)[1]
        return Loads(M1=-lift / LEVER - side * lift, M3=-drag, G3=lift)

    def lift(self, s, nutation):
        """Return the lift of the falling film at sin(beta) `s`, whose moment about the contact is 1/LEVER of it."""
        return LEVER * self.falling * nutation / (s * s * s)

    def heaviness(self, s, rate, power):
        """Return by what the inertia of the air raises the drag of the turning film, at sin(beta) `s`."""
        return power(1.0 + power(self.inertia * (s * s * rate) * (s * s * rate) + NOTHING, 0.625), 0.4)

    def powers(self, beta, omega) -> tuple:
        """Return what the turning and the falling film take, dimensionless, at inclinations and angular velocities."""
        s = np.sin(beta)
        rate = precession_rate(omega[2], s)
        turning = self.turning * rate * rate / s * self.heaviness(s, rate, np.power)
        return turning, self.falling * omega[0] ** 2 / s**3

    @property
    def shape(self) -> "Film":
        """What a compiled flow depends on: no number."""
        return self.filled(repeat(None))

    @property
    def numbers(self) -> tuple[float, ...]:
        """The numbers (3,) that `shape` leaves out."""
        return tuple(self)

    def filled(self, numbers: Iterable) -> "Film":
        """Return a film with `numbers` (3,), of any kind."""
        left: Iterator = iter(numbers)
        return Film(next(left), next(left), next(left))


def film_under(disk: Disk, air: Air) -> Film:
    """Return the film of a solid disk in air. Raises ValueError for a disk without a face, and in a vacuum."""
    if disk.shape != "solid":
        raise ValueError("air.film = 'acts': only the film under a solid disk is known, and this one is a shell")
    if not air.pressure:
        raise ValueError("air.film = 'acts': a vacuum, air.pressure = 0, has no film")
    R, chi = disk.radius, disk.time_unit
    moment = 12 * air.viscosity * R**3 / (disk.mass * R**2 / chi)
    layers = R**2 * air.density / (2 * air.viscosity * chi) / SLOW**2
    return Film(TURNING * moment, FALLING * moment, layers**2)


def thickness(beta, rate, radius: float, air: Air):
    """Return S, the mean gap over sqrt(2) times the depth of the boundary layers, at precession `rate` [rad/s]."""
    return np.sin(beta) * radius * np.sqrt(np.abs(rate) * air.density / (2 * air.viscosity))


def compressibility(beta, rate, air: Air):
    """Return Lam = 12 mu Omega/(p beta^2), beyond which air is squeezed in the film, at precession `rate` [rad/s]."""
    return 12 * air.viscosity * np.abs(rate) / (air.pressure * np.sin(beta) ** 2)


def film_in(loads) -> Film | None:
    """Return the film among the loads of a motion."""
    every = getattr(loads, "laws", (loads,))
    return next((law for law in every if isinstance(law, Film)), None)
