"""Law of the air film: a wedge h = sin(beta) (R + x), open at the rim and closed at the contact x =
-R.

Reynolds' equation covers both changes of the gap: the wedge turns with the precession, or closes as
the disk falls. reynolds.py solves it, forces.py has the result in closed form, and
tests/film/test_film_constants.py compares both.
"""

from collections.abc import Iterable
from itertools import islice, repeat
from typing import NamedTuple

import numpy as np

from dynamics.air import Air
from dynamics.disk import Disk
from dynamics.equations import DiskConstants, Loads
from dynamics.film.forces import BOUNDARY_LAYER_RATIO, SLIP_FACTOR, SQUEEZE_NUMBER, film_forces
from dynamics.kinematics import contact_arms, precession_rate

TURNING_POWER = 0.1067607949
"""I: the power of the turning film is 12 mu R^3 I Omega^2/sin(beta).

I = pi/3 - (32/pi) int_0^inf k^2 K0(k)/K1(k) F(k) dk with F(k) = int_k^inf K0 K1/t dt.
"""
FALLING_POWER = 0.3808
"""I_n: the power of the falling film is 12 mu R^3 I_n omega_1^2/sin(beta)^3."""


class Film(NamedTuple):
    """Loads of the air film: the dimensionless constants of `film_forces`.

    The factor (1 + (S/6.3)^2.5)^0.4, S = sin(beta) R sqrt(Omega rho/(2 mu)), for the inertia of the
    turning air is a fit to the unsteady Stokes equation: within 5 % for S <= 3, 30 % above. The
    falling film has no inertia.
    """

    turning: float | None
    falling: float | None
    inertia: float | None
    number: float | None
    ambient: float | None
    slip: float | None
    is_singular = False
    carries = True

    def __call__(self, beta, omega, slip, law: DiskConstants, flow) -> Loads:
        """Return the loads as `Resistance` does: a lift, and the moment that gives the lift the
        power of the film.
        """
        s = flow.sin(beta)
        drag, tip, lift = film_forces(s, omega[0], precession_rate(omega[2], s), *self)
        return Loads(M1=-tip - contact_arms(flow.cos(beta), s, law.h)[1] * lift, M3=-drag, G3=lift)

    def at(self, beta, omega) -> tuple:
        """Return the dimensionless moments of `film_forces` at inclinations and angular
        velocities."""
        s = np.sin(beta)
        return film_forces(s, omega[0], precession_rate(omega[2], s), *self)

    def powers(self, beta, omega) -> tuple:
        """Return the dimensionless powers of the turning and the falling film at inclinations and
        angular velocities.
        """
        drag, tip, _ = self.at(beta, omega)
        return drag * omega[2], tip * omega[0]

    @property
    def compiled_form(self) -> "Film":
        """The film without its numbers, on which a compiled flow depends."""
        return self.with_parameters(repeat(None))

    @property
    def runtime_parameters(self) -> tuple[float, ...]:
        """The six numbers."""
        return tuple(self)

    def with_parameters(self, parameters: Iterable) -> "Film":
        """Return a film with these six numbers, of any kind."""
        return Film(*islice(parameters, len(self)))


def film_under(disk: Disk, air: Air) -> Film:
    """Return the film under a solid disk in air. Raises ValueError for a shell, and in a vacuum."""
    if disk.shape != "solid":
        raise ValueError(
            "air.film = 'acts': only the film under a solid disk is known, and this one is a shell"
        )
    if not air.pressure:
        raise ValueError("air.film = 'acts': a vacuum, air.pressure = 0, has no film")
    R = disk.radius
    chi = disk.time_unit
    unit = disk.mass * R**2 / chi**2
    moment = 12 * air.viscosity * R**3 / (unit * chi)
    layers = R**2 * air.density / (2 * air.viscosity * chi) / BOUNDARY_LAYER_RATIO**2
    return Film(
        turning=TURNING_POWER * moment,
        falling=FALLING_POWER * moment,
        inertia=layers**2,
        number=12 * air.viscosity / (air.pressure * chi * SQUEEZE_NUMBER),
        ambient=air.pressure * np.pi * R**3 / unit,
        slip=SLIP_FACTOR * air.mean_free_path / R,
    )


def film_powers(disk: Disk, film: Film, state) -> np.ndarray:
    """Return the powers (2, n) [W] of the turning and the falling film at states (n, 11)."""
    unit = disk.mass * disk.radius**2 / disk.time_unit**3
    return np.array(film.powers(state[:, 1], state[:, 5:8].T * disk.time_unit)) * unit


def layer_thickness(beta, rate, radius: float, air: Air):
    """Return S, the mean gap over sqrt(2) times the depth of the boundary layers, at a precession
    rate [rad/s].
    """
    return np.sin(beta) * radius * np.sqrt(np.abs(rate) * air.density / (2 * air.viscosity))


def compressibility(beta, rate, air: Air):
    """Return Lam = 12 mu Omega/(p sin(beta)^2), the compressibility of the film at a precession
    rate [rad/s].
    """
    return 12 * air.viscosity * np.abs(rate) / (air.pressure * np.sin(beta) ** 2)


def closing_number(beta, nutation, radius: float, air: Air):
    """Return the rate at which a fall at `nutation` [rad/s] closes the film, over the rate at which
    the air escapes.

    It is 12 mu omega_1/(p beta^3) without slip. A film that keeps its air exceeds the resistance of
    its law by 12 % at 1 and 27 % at 3.
    """
    s = np.sin(beta)
    out = s * s * (s + SLIP_FACTOR / 2 * air.mean_free_path / radius)
    return 12 * air.viscosity * np.maximum(nutation, 0.0) / (air.pressure * out)


def find_film(loads) -> Film | None:
    """Return the film among the loads of a motion, or None."""
    every = getattr(loads, "laws", (loads,))
    return next((law for law in every if isinstance(law, Film)), None)
