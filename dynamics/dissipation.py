"""Other laws of dissipation than the paper's moment: powers of the precession rate, and viscous moment and force.

A power law P = -c |Omega|^b acts as the moment -c |Omega|^(b-1) sign(Omega) sec(a) e_3, whose power it is for any
motion. In the quasi-steady range it makes the energy fall as (t0 - t)^(2/(b + 2)).
"""

from collections.abc import Iterable
from copy import copy
from dataclasses import dataclass
from functools import reduce
from itertools import chain, repeat
from math import pi
from operator import add
from typing import Annotated, NamedTuple

from annotated_types import Ge, Le

from .disk import GRAVITY, Disk
from .equations import Law, Loads
from .kinematics import arms, centre_velocity, precession_rate


@dataclass(frozen=True, kw_only=True)
class Dissipation:
    """What resists besides Coulomb friction and the moment (3.3); the laws add up, and zero leaves one out."""

    power_coefficient: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Factor of the power law c |Omega|^b (1.1) [W s^b]."""
    power_exponent: Annotated[float, Ge(0), Le(16)] = 2.5
    """Exponent b of the power law; the measurements of McDonald & McDonald (2002) suggest 2.5."""
    air_viscosity: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Viscosity of the air under the disk, viscous throughout: Moffatt (2000), b = 4 [Pa s]."""
    boundary_layer_viscosity: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Kinematic viscosity of the air's boundary layer: Bildsten (2002), b = 5/2 [m^2/s]."""
    air_density: Annotated[float, Ge(0), Le(1e6)] = 1.2
    """Density of the air of that layer [kg/m^3]."""
    contour_moment: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Moment of contour friction: Leine (2009), b = 1 [N m]."""
    viscous_moment: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Moment per angular velocity, against it: Compere [N m s]."""
    viscous_force: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Force per velocity of the centre, against it: Compere [N s/m]."""


def power_laws(dissipation: Dissipation, disk: Disk) -> list[tuple[float, float]]:
    """Return (coefficient [W s^b], exponent b) of every power law that acts.

    Moffatt's pi mu g a^2 / beta^2 with beta = 4 g / (a Omega^2) is pi mu a^4 Omega^4 / (16 g); Bildsten's
    4 sqrt(mu rho) g^(5/4) a^(11/4) beta^(-5/4) is sqrt(mu rho) a^4 Omega^(5/2) / sqrt(2). These are estimates of their
    authors: the film that is solved, film/law.py, takes 1.63 times as much as the first where it is thin, and 4.9 times
    less than the second where it is thick.
    """
    a = disk.radius
    layer = dissipation.air_density * dissipation.boundary_layer_viscosity**0.5 * a**4 / 2**0.5
    laws = [
        (dissipation.power_coefficient, dissipation.power_exponent),
        (pi * dissipation.air_viscosity * a**4 / (16 * GRAVITY), 4.0),
        (layer, 2.5),
        (dissipation.contour_moment, 1.0),
    ]
    return [law for law in laws if law[0] > 0]


class Resistance(NamedTuple):
    """The loads of a Dissipation, dimensionless: ((c, (b - 2)/2), ...) of the powers, moment and force per velocity.

    `is_singular`: a law is not smooth where the precession stops.
    """

    powers: tuple[tuple[float, float], ...]
    viscous_moment: float
    viscous_force: float
    is_singular: bool
    carries = False

    def __call__(self, beta, omega, slip, law: Law, flow) -> Loads:
        """Return the loads at inclination beta, angular velocity omega and slip velocity, for the scalars of `flow`."""
        sin_a, cos_a = flow.cos(beta), flow.sin(beta)
        rate = precession_rate(omega[2], cos_a)
        v1, v2 = centre_velocity(slip, omega, arms(sin_a, cos_a, law.h)[0], law.h)
        M1, M2, M3 = (-self.viscous_moment * w for w in omega)
        for c, half in self.powers:  # |Omega|^(b-1) sign(Omega), written so that b = 2, 4, ... stay polynomials
            M3 = M3 - c * rate * flow.power(rate * rate, half) / cos_a
        return Loads(-self.viscous_force * v1, -self.viscous_force * v2, M1, M2, M3)

    @property
    def shape(self) -> "Resistance":
        """What a compiled flow depends on: None in place of every number, but for absent laws and whole exponents b."""
        powers = tuple((None, half if (2 * half).is_integer() else None) for _, half in self.powers)
        viscous = (None if number else 0.0 for number in (self.viscous_moment, self.viscous_force))
        return Resistance(powers, *viscous, self.is_singular)

    @property
    def numbers(self) -> tuple[float, ...]:
        """The numbers (n,) that `shape` leaves out."""
        return tuple(own for own, kept in zip(self._flat(), self.shape._flat(), strict=True) if kept is None)

    def filled(self, numbers: Iterable) -> "Resistance":
        """Return a shape with `numbers` (n,), of any kind, in place of None."""
        left = iter(numbers)
        *powers, moment, force = (next(left) if kept is None else kept for kept in self._flat())
        return Resistance(tuple(zip(powers[::2], powers[1::2], strict=True)), moment, force, self.is_singular)

    def _flat(self):
        return *chain(*self.powers), self.viscous_moment, self.viscous_force


class OwnLaw:
    """A law of dissipation of your own: a frozen dataclass that derives from this and is called as `Resistance` is.

    Its floats are symbols where it is compiled, so that it may not choose by them. sonify/examples/own_dissipation.py
    shows one.
    """

    is_singular = False
    carries = False

    def __call__(self, beta, omega, slip, law: Law, flow) -> Loads:
        """Return the loads as `Resistance` does."""
        raise NotImplementedError(f"{type(self).__name__} is to be called as Resistance is")

    @property
    def shape(self) -> "OwnLaw":
        """What a compiled flow depends on: None in place of every float."""
        return self.filled(repeat(None))

    @property
    def numbers(self) -> tuple[float, ...]:
        """The numbers (n,) that `shape` leaves out."""
        return tuple(value for value in vars(self).values() if isinstance(value, float))

    def filled(self, numbers: Iterable) -> "OwnLaw":
        """Return the law with `numbers`, of any kind, in place of its floats or of None."""
        law, left = copy(self), iter(numbers)
        for name, value in vars(self).items():
            object.__setattr__(law, name, next(left) if value is None or isinstance(value, float) else value)
        return law


class Together(NamedTuple):
    """Several laws at once, whose loads add up."""

    laws: tuple

    def __call__(self, *state) -> Loads:
        """Return the loads as each of the laws does."""
        return reduce(lambda one, other: Loads._make(map(add, one, other)), [law(*state) for law in self.laws])

    @property
    def is_singular(self) -> bool:
        """Whether one of them is not smooth where the precession stops."""
        return any(law.is_singular for law in self.laws)

    @property
    def carries(self) -> bool:
        """Whether one of them keeps a falling disk off the table."""
        return any(law.carries for law in self.laws)

    @property
    def shape(self) -> "Together":
        """What a compiled flow depends on."""
        return Together(tuple(law.shape for law in self.laws))

    @property
    def numbers(self) -> tuple[float, ...]:
        """The numbers (n,) that `shape` leaves out."""
        return tuple(chain(*(law.numbers for law in self.laws)))

    def filled(self, numbers: Iterable) -> "Together":
        """Return the laws with `numbers` (n,), of any kind."""
        left = iter(numbers)
        return Together(tuple(law.filled(left) for law in self.laws))


def together(*laws):
    """Return what acts of `laws`, of which some may be None, as one law; None where none acts."""
    acting = tuple(law for law in laws if law)
    return Together(acting) if len(acting) > 1 else acting[0] if acting else None


def resistance(dissipation: Dissipation | None, disk: Disk) -> Resistance | None:
    """Return the dimensionless loads of a scene, None where there are none."""
    if dissipation is None:
        return None
    chi, unit, laws = disk.time_unit, disk.mass * disk.radius**2, power_laws(dissipation, disk)
    powers = tuple((c * chi ** (3 - b) / unit, (b - 2) / 2) for c, b in laws)
    moment, force = dissipation.viscous_moment * chi / unit, dissipation.viscous_force * chi / disk.mass
    return Resistance(powers, moment, force, any(b < 2 for _, b in laws)) if powers or moment or force else None
