"""The sections of a scene that the rigid motion reads: disk, friction, release. SI units unless a key says `_deg`."""

from dataclasses import dataclass
from math import inf, pi
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Lt

GRAVITY = 9.81
"""Acceleration of free fall [m/s^2]; it gives the paper's unit of time, 0.0691712 s (7.2)."""


@dataclass(frozen=True, kw_only=True)
class Disk:
    """A circular cylinder: radius and thickness [m], and its mass [kg] or, where it has a volume, density [kg/m^3].

    A shell is hollow along its axis: `wall` [m] is what is left between the two radii, negligible unless it is given.
    """

    radius: Annotated[float, Gt(0)]
    thickness: Annotated[float, Gt(0)]
    mass: Annotated[float, Gt(0)] | None = None
    density: Annotated[float, Gt(0)] | None = None
    shape: Literal["solid", "shell"] = "solid"
    wall: Annotated[float, Gt(0)] | None = None

    def __post_init__(self):
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
    """Coulomb's coefficients (3.2) and the arms k_1, k_2, k_3 [m] of the resisting moments (3.3)."""

    mu_static: Annotated[float, Ge(0)]
    mu_dynamic: Annotated[float, Ge(0)]
    arm_nutation: Annotated[float, Ge(0), Lt(inf)] = 0.0
    arm_rolling: Annotated[float, Ge(0), Lt(inf)] = 0.0
    arm_pivoting: Annotated[float, Ge(0), Lt(inf)] = 0.0

    def __post_init__(self):
        if self.mu_dynamic > self.mu_static:
            raise ValueError(f"mu_dynamic = {self.mu_dynamic:g} must not exceed mu_static = {self.mu_static:g}")


@dataclass(frozen=True, kw_only=True)
class Release:
    """The start, without slip: inclination of the disk to the table, angular velocity [rad/s] along e_1, e_2, e_3."""

    inclination_deg: Annotated[float, Gt(0), Lt(90)]
    omega: tuple[float, float, float]
