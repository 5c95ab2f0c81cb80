"""Dissipation apart from friction: power laws, viscous moment and viscous force.

The power law P = -c |Omega|^b is implemented as the moment -c |Omega|^(b-1) sign(Omega)
sec(a) e_3, which dissipates the power c |Omega|^b in every motion. In quasi-steady
motion the energy then decreases as (t0 - t)^(2/(b + 2)).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce
from itertools import chain, repeat
from math import pi
from operator import add
from typing import Annotated, Any, NamedTuple

from annotated_types import Ge, Le

from dynamics.disk import GRAVITY, Disk
from dynamics.equations import DiskConstants, Loads
from dynamics.kinematics import centre_velocity, contact_place, precession_rate


@dataclass(frozen=True, kw_only=True)
class Dissipation:
    """Dissipation in addition to friction: the section `dissipation` of a scene.

    The loads of all laws are added. A coefficient of zero disables its law.

    References
    ----------
    .. [1] McDonald & McDonald (2002): measured exponent of the power law.
    .. [2] Moffatt (2000): viscous air film.
    .. [3] Bildsten (2002): boundary layer of the air.
    .. [4] Leine (2009): contour friction.

    Examples
    --------
    >>> from dynamics import Dissipation
    >>> Dissipation(contour_moment=1e-6).power_exponent
    2.5
    """

    power_coefficient: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Coefficient c of the power law c |Omega|^b (1.1) [W s^b]."""
    power_exponent: Annotated[float, Ge(0), Le(16)] = 2.5
    """Exponent b of the power law; McDonald & McDonald (2002) measured about 2.5."""
    air_viscosity: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Viscosity of the air film under the disk [Pa s]; b = 4, Moffatt (2000)."""
    boundary_layer_viscosity: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Kinematic viscosity of the air in its boundary layer [m^2/s]; b = 5/2, Bildsten
    (2002)."""
    air_density: Annotated[float, Ge(0), Le(1e6)] = 1.2
    """Density of the air in that boundary layer [kg/m^3]."""
    contour_moment: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Moment of contour friction [N m]; b = 1, Leine (2009)."""
    viscous_moment: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Viscous moment divided by the angular velocity [N m s] (Compere)."""
    viscous_force: Annotated[float, Ge(0), Le(1e6)] = 0.0
    """Viscous force divided by the velocity of the centre [N s/m] (Compere)."""


def power_laws(dissipation: Dissipation, disk: Disk) -> list[tuple[float, float]]:
    """Return (coefficient [W s^b] > 0, exponent b) of every power law.

    With beta = 4 g / (a Omega^2), Moffatt's pi mu g a^2 / beta^2 is pi mu a^4 Omega^4 /
    (16 g), and Bildsten's 4 sqrt(mu rho) g^(5/4) a^(11/4) beta^(-5/4) is sqrt(mu rho)
    a^4 Omega^(5/2) / sqrt(2). Both are estimates. The air film of film/wedge.py
    dissipates 1.63 times Moffatt's estimate if it is thin, and 1/4.9 of Bildsten's if
    it is thick.
    """
    a = disk.radius
    layer = (
        dissipation.air_density
        * dissipation.boundary_layer_viscosity**0.5
        * a**4
        / 2**0.5
    )
    laws = [
        (dissipation.power_coefficient, dissipation.power_exponent),
        (pi * dissipation.air_viscosity * a**4 / (16 * GRAVITY), 4.0),
        (layer, 2.5),
        (dissipation.contour_moment, 1.0),
    ]
    return [
        (coefficient, exponent) for coefficient, exponent in laws if coefficient > 0
    ]


class Resistance(NamedTuple):
    """Dimensionless loads of a `Dissipation`.

    Parameters
    ----------
    powers : tuple of (float, float)
        Coefficient c and (b - 2)/2 of each power law with exponent b.
    viscous_moment, viscous_force : float
        Moment divided by angular velocity, and force divided by velocity.
    nonsmooth_at_zero_precession : bool
        True if a law is not smooth where the precession stops.
    """

    powers: tuple[tuple[Any, Any], ...]
    viscous_moment: Any
    viscous_force: Any
    nonsmooth_at_zero_precession: bool

    @property
    def keeps_disk_off_table(self) -> bool:
        """False, because these laws do not keep a falling disk off the table."""
        return False

    @property
    def laws(self) -> tuple["Resistance"]:
        """This law as the only one of its loads."""
        return (self,)

    def __call__(
        self, beta: Any, omega: Any, slip: Any, constants: DiskConstants, flow: Any
    ) -> Loads:
        """Return the loads at inclination beta, angular velocity omega and `slip`.

        All arguments are dimensionless scalars of any type that the functions of `flow`
        accept.
        """
        sin_a = flow.cos(beta)
        cos_a = flow.sin(beta)
        rate = precession_rate(omega[2], cos_a)
        v1, v2 = centre_velocity(
            slip, omega, contact_place(sin_a, cos_a, constants.h, constants.fillet)
        )
        M1, M2, M3 = (-self.viscous_moment * w for w in omega)
        # |Omega|^(b-1) sign(Omega), written so that it is a polynomial for b = 2, 4, ...
        for c, half in self.powers:
            M3 = M3 - c * rate * flow.power(rate * rate, half) / cos_a
        return Loads(-self.viscous_force * v1, -self.viscous_force * v2, M1, M2, M3)

    @property
    def compiled_form(self) -> "Resistance":
        """The law with None as a placeholder for each run-time parameter.

        Zero coefficients and integer exponents b are kept, because they are compiled
        into the flow.
        """
        powers = tuple(
            (None, half if (2 * half).is_integer() else None) for _, half in self.powers
        )
        moment = None if self.viscous_moment else 0.0
        force = None if self.viscous_force else 0.0
        return self._replace(powers=powers, viscous_moment=moment, viscous_force=force)

    @property
    def runtime_parameters(self) -> tuple[float, ...]:
        """The run-time parameters (n,), in the order of the placeholders."""
        pairs = zip(self._numbers(), self.compiled_form._numbers(), strict=True)
        return tuple(number for number, compiled in pairs if compiled is None)

    def with_parameters(self, parameters: Iterable[Any]) -> "Resistance":
        """Return a copy with scalars of any type (n,) in place of the placeholders."""
        remaining = iter(parameters)
        values = [
            next(remaining) if value is None else value for value in self._numbers()
        ]
        *powers, moment, force = values
        pairs = tuple(zip(powers[::2], powers[1::2], strict=True))
        return Resistance(pairs, moment, force, self.nonsmooth_at_zero_precession)

    def _numbers(self) -> tuple[Any, ...]:
        """Return all coefficients and exponents of the law in one tuple."""
        return *chain(*self.powers), self.viscous_moment, self.viscous_force


class OwnLaw:
    """Base class of a user-defined law of dissipation.

    Derive a frozen dataclass and define `__call__`, as in
    `sonify/examples/own_dissipation.py`. During compilation symbols replace the float
    fields, so `__call__` must not branch on their values.

    Attributes
    ----------
    nonsmooth_at_zero_precession : bool
        True if the law is not smooth where the precession stops.
    keeps_disk_off_table : bool
        True if the law keeps a falling disk off the table.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> from dynamics import Loads, OwnLaw
    >>> @dataclass(frozen=True)
    ... class SpinFriction(OwnLaw):
    ...     coefficient: float
    ...
    ...     def __call__(self, beta, omega, slip, constants, flow):
    ...         return Loads(M2=-self.coefficient * omega[1])
    >>> SpinFriction(0.01).runtime_parameters
    (0.01,)
    """

    nonsmooth_at_zero_precession = False
    keeps_disk_off_table = False

    @property
    def laws(self) -> tuple["OwnLaw"]:
        """This law as the only one of its loads."""
        return (self,)

    def __call__(
        self, beta: Any, omega: Any, slip: Any, constants: DiskConstants, flow: Any
    ) -> Loads:
        """Return the dimensionless loads on the disk.

        Parameters
        ----------
        beta : scalar
            Inclination [rad].
        omega : tuple of three scalars
            Angular velocity along e_1, e_2, e_3, in units of 1/chi.
        slip : tuple of two scalars
            Slip velocity along a_1, a_2, in units of R/chi.
        constants : DiskConstants
            Dimensionless constants of disk and friction.
        flow : Flow
            Functions sin, cos, sqrt and power for these scalars.

        Returns
        -------
        Loads
            Force on the centre along a_1, a_2, a_3 and moment along e_1, e_2, e_3.
        """
        raise NotImplementedError(f"{type(self).__name__} must define __call__")

    @property
    def compiled_form(self) -> "OwnLaw":
        """The law with None as a placeholder for every float."""
        return self.with_parameters(repeat(None))

    @property
    def runtime_parameters(self) -> tuple[float, ...]:
        """The run-time parameters (n,), in the order of the placeholders."""
        return tuple(value for value in vars(self).values() if isinstance(value, float))

    def with_parameters(self, parameters: Iterable[Any]) -> "OwnLaw":
        """Return a copy of the law with other parameters.

        Parameters
        ----------
        parameters : iterable of scalars
            One scalar of any type for each float or placeholder (None) of the law, in
            order. Surplus values are ignored.

        Returns
        -------
        OwnLaw
            The copy. Its `__post_init__` is skipped, because it may accept only floats.
        """
        remaining = iter(parameters)
        law = object.__new__(type(self))
        for name, value in vars(self).items():
            is_parameter = value is None or isinstance(value, float)
            vars(law)[name] = next(remaining) if is_parameter else value
        return law


class CombinedLoads(NamedTuple):
    """Sum of several laws."""

    laws: tuple[Any, ...]

    def __call__(self, *state: Any) -> Loads:
        """Return the sum of the loads of the laws."""
        loads = [law(*state) for law in self.laws]
        return reduce(lambda one, other: Loads._make(map(add, one, other)), loads)

    @property
    def nonsmooth_at_zero_precession(self) -> bool:
        """True if at least one of the laws is not smooth where the precession stops."""
        return any(law.nonsmooth_at_zero_precession for law in self.laws)

    @property
    def keeps_disk_off_table(self) -> bool:
        """True if at least one of the laws keeps a falling disk off the table."""
        return any(law.keeps_disk_off_table for law in self.laws)

    @property
    def compiled_form(self) -> "CombinedLoads":
        """The laws with None as a placeholder for each run-time parameter."""
        return CombinedLoads(tuple(law.compiled_form for law in self.laws))

    @property
    def runtime_parameters(self) -> tuple[float, ...]:
        """The run-time parameters (n,), in the order of the placeholders."""
        return tuple(chain(*(law.runtime_parameters for law in self.laws)))

    def with_parameters(self, parameters: Iterable[Any]) -> "CombinedLoads":
        """Return a copy with scalars of any type (n,) in place of the placeholders."""
        remaining = iter(parameters)
        return CombinedLoads(tuple(law.with_parameters(remaining) for law in self.laws))


def laws_of(loads: Any) -> tuple[Any, ...]:
    """Return the laws of the loads on a disk; empty without loads."""
    return () if loads is None else loads.laws


def combined_loads(*laws: Any) -> Any:
    """Combine all laws other than None into one law; return None if there are none."""
    acting = tuple(law for law in laws if law)
    if len(acting) > 1:
        return CombinedLoads(acting)
    return acting[0] if acting else None


def resistance_of(dissipation: Dissipation, disk: Disk) -> Resistance | None:
    """Return the dimensionless loads of a `Dissipation`, or None if there are none."""
    chi = disk.time_unit
    inertia = disk.mass * disk.radius**2
    laws = power_laws(dissipation, disk)
    powers = tuple((c * chi ** (3 - b) / inertia, (b - 2) / 2) for c, b in laws)
    moment = dissipation.viscous_moment * chi / inertia
    force = dissipation.viscous_force * chi / disk.mass
    if not (powers or moment or force):
        return None
    return Resistance(
        powers, moment, force, nonsmooth_at_zero_precession=any(b < 2 for _, b in laws)
    )
