"""The sections of a scene that the motion reads. SI units unless a key says `_deg`; [ ] holds the unit of a key."""

from dataclasses import dataclass
from math import inf, pi
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Lt

GRAVITY = 9.81
"""Acceleration of free fall [m/s^2]; it gives the paper's unit of time, 0.0691712 s (7.2)."""


LARGEST = 1e6
"""Coefficient of friction beyond which none is asked for but an infinite one."""
SMALLEST = 1e-9
"""Length [m] that no disk falls below: its square times its mass would be no number."""
Rate = Annotated[float, Ge(-1e6), Le(1e6)]


@dataclass(frozen=True, kw_only=True)
class Disk:
    """A circular cylinder, of which either the mass or the density is given."""

    radius: Annotated[float, Gt(0), Le(100)]
    """Outer radius [m]."""
    thickness: Annotated[float, Ge(SMALLEST), Le(100)]
    """Height along the axis [m]."""
    mass: Annotated[float, Ge(1e-9), Le(1e9)] = None  # type: ignore[assignment]
    """Mass [kg]."""
    density: Annotated[float, Ge(1e-3), Le(1e6)] | None = None
    """Mass per volume [kg/m^3], of a disk that has a volume."""
    shape: Literal["solid", "shell"] = "solid"
    """A shell is hollow along its axis."""
    wall: Annotated[float, Ge(SMALLEST), Le(100)] | None = None
    """Outer less inner radius of a shell [m], negligible unless it is given."""

    def __post_init__(self):
        if self.radius < SMALLEST:
            raise ValueError(f"radius = {self.radius:g}: must not be below {SMALLEST:g}")
        if (self.mass is None) == (self.density is None):
            raise ValueError("give either mass or density")
        if self.wall is not None and self.shape != "shell":
            raise ValueError(f"wall = {self.wall:g}: only a disk of shape = 'shell' has a wall")
        if self.wall is not None and not self.wall < self.radius:
            raise ValueError(f"wall = {self.wall:g}: must be less than radius = {self.radius:g}")
        if self.mass is None and not self.volume:
            raise ValueError("a shell of negligible wall has no density: give its mass, or its wall")
        if self.mass is None:
            object.__setattr__(self, "mass", self.density * self.volume)

    @property
    def inner_radius(self) -> float:
        """Radius of the hole [m]: 0 of a solid cylinder, the outer radius of a shell of negligible wall."""
        return 0.0 if self.shape == "solid" else self.radius - (self.wall or 0.0)

    @property
    def volume(self) -> float:
        """Volume [m^3]."""
        return pi * (self.radius**2 - self.inner_radius**2) * self.thickness

    @property
    def gyration(self) -> float:
        """k^2 of (2.4): 1 for a solid cylinder, 2 for a shell of negligible wall, 1 + (inner over outer radius)^2."""
        return 1.0 + (self.inner_radius / self.radius) ** 2

    @property
    def aspect(self) -> float:
        """h = H/R of (4.4): half the thickness over the radius (7.2 prints its inverse)."""
        return self.thickness / (2 * self.radius)

    @property
    def time_unit(self) -> float:
        """chi of (4.5) [s]."""
        return ((self.gyration + 4) / 4 * self.radius / GRAVITY) ** 0.5

    @property
    def weight(self) -> float:
        """m g [N]."""
        return self.mass * GRAVITY


@dataclass(frozen=True, kw_only=True)
class Friction:
    """Coulomb's law (3.2), and the moments (3.3) that resist the three parts of the angular velocity."""

    mu_static: Annotated[float, Ge(0)]
    """Coefficient of static friction, at most 1e6; or inf, for a contact that never slips."""
    mu_dynamic: Annotated[float, Ge(0)]
    """Coefficient of dynamic friction, not above the static one."""
    arm_nutation: Annotated[float, Ge(0), Le(100)] = 0.0
    """Arm k_1 of the normal force in the moment that resists nutation [m], at most the radius."""
    arm_rolling: Annotated[float, Ge(0), Le(100)] = 0.0
    """Arm k_2 of the normal force in the moment that resists rolling [m], at most the radius."""
    arm_pivoting: Annotated[float, Ge(0), Le(100)] = 0.0
    """Arm k_3 of the normal force in the moment that resists pivoting [m], at most the radius."""

    def __post_init__(self):
        for key in ("mu_static", "mu_dynamic"):
            if LARGEST < (mu := getattr(self, key)) < inf:
                raise ValueError(f"{key} = {mu:g}: must be less than or equal to {LARGEST:g}, or inf")
        if self.mu_dynamic > self.mu_static:
            raise ValueError(f"mu_dynamic = {self.mu_dynamic:g} must not exceed mu_static = {self.mu_static:g}")


@dataclass(frozen=True, kw_only=True)
class Release:
    """The start of the motion, without slip (7.4)."""

    inclination_deg: Annotated[float, Ge(1e-6), Lt(90)]
    """Inclination of the disk to the table [degrees]."""
    omega: tuple[Rate, Rate, Rate]
    """Angular velocity along e_1 (nutation), e_2 (the disk's axis) and e_3 (in its plane) [rad/s]."""
