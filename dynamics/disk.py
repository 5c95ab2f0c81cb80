"""The sections `disk`, `friction` and `release` of a scene."""

from dataclasses import dataclass
from math import inf, pi
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Lt

GRAVITY = 9.81
"""Gravitational acceleration [m/s^2]; the time unit of the paper, 0.0691712 s (7.2),
implies it."""
MIN_DISK_LENGTH = 1e-9
"""Smallest dimension of a disk [m]; the moments of inertia of a smaller disk would underflow."""
MAX_FINITE_FRICTION = 1e6
"""Largest finite coefficient of friction."""
AngularRate = Annotated[float, Ge(-1e6), Le(1e6)]


@dataclass(frozen=True, kw_only=True)
class Disk:
    """A circular cylinder, specified by two of its thickness, mass and density.

    Raises
    ------
    ValueError
        Unless exactly two of thickness, mass and density are given, or if a dimension
        is impossible.

    Examples
    --------
    >>> from dynamics import Disk
    >>> disk = Disk(radius=0.03755, thickness=0.013, density=7850.0)
    >>> f"{disk.mass:.3f} kg, aspect {disk.aspect:.3f}"
    '0.452 kg, aspect 0.173'

    A coin with a raised rim has the effective thickness of its mass:

    >>> coin = Disk(radius=0.016385, mass=0.03393, density=17500.0)
    >>> f"{1e3 * coin.thickness:.2f} mm"
    '2.30 mm'
    """

    radius: Annotated[float, Gt(0), Le(100)]
    """Outer radius [m]."""
    thickness: Annotated[float, Ge(MIN_DISK_LENGTH), Le(100)] = None  # type: ignore[assignment]
    """Thickness along the axis [m]; if it is not given, mass and density determine it."""
    mass: Annotated[float, Ge(1e-9), Le(1e9)] = None  # type: ignore[assignment]
    """Mass [kg]."""
    density: Annotated[float, Ge(1e-3), Le(1e6)] | None = None
    """Density [kg/m^3], as an alternative to the mass or to the thickness; None after it
    has determined the thickness."""
    shape: Literal["solid", "shell"] = "solid"
    """Shape: a solid cylinder, or a shell (a tube with open ends)."""
    wall: Annotated[float, Ge(MIN_DISK_LENGTH), Le(100)] | None = None
    """Wall thickness of a shell [m]; by default negligible."""

    def __post_init__(self) -> None:
        if self.radius < MIN_DISK_LENGTH:
            raise ValueError(
                f"radius = {self.radius:g}: must not be below {MIN_DISK_LENGTH:g}"
            )
        if self.wall is not None and self.shape != "shell":
            raise ValueError(f"wall = {self.wall:g}: only allowed if shape = 'shell'")
        if self.wall is not None and not self.wall < self.radius:
            raise ValueError(
                f"wall = {self.wall:g}: must be less than radius = {self.radius:g}"
            )
        self._complete_dimensions()

    def _complete_dimensions(self) -> None:
        """Compute the thickness or the mass from the other dimensions and the density.

        Raises ValueError unless exactly two of thickness, mass and density are given,
        or if the thickness is impossible.
        """
        if self.thickness is not None and (self.mass is None) == (self.density is None):
            raise ValueError(
                "give either mass or density; without thickness, give both"
            )
        if self.thickness is None and (self.mass is None or self.density is None):
            raise ValueError(
                "thickness: missing; give it, or both mass and density, which determine it"
            )
        if self.density is None:
            return
        if not self.face_area:
            raise ValueError(
                "a shell of negligible wall has no volume: give its mass and thickness, or its wall"
            )
        if self.mass is None:
            object.__setattr__(self, "mass", self.density * self.volume)
            return
        thickness = self.mass / (self.density * self.face_area)
        if not MIN_DISK_LENGTH <= thickness <= 100:
            raise ValueError(
                f"mass = {self.mass:g} and density = {self.density:g} give a thickness of "
                f"{thickness:g} m; it must be from {MIN_DISK_LENGTH:g} to 100"
            )
        object.__setattr__(self, "thickness", thickness)
        object.__setattr__(self, "density", None)

    @property
    def inner_radius(self) -> float:
        """Radius of the hole [m]; 0 for a solid cylinder."""
        if self.shape == "solid":
            return 0.0
        return self.radius - (self.wall or 0.0)

    @property
    def face_area(self) -> float:
        """Area of one face [m^2]; 0 for a shell of negligible wall."""
        return pi * (self.radius**2 - self.inner_radius**2)

    @property
    def volume(self) -> float:
        """Volume [m^3]."""
        return self.face_area * self.thickness

    @property
    def gyration(self) -> float:
        """Constant k^2 of (2.4), 1 + (inner/outer radius)^2: 1 for a solid disk, 2 for a thin
        ring."""
        return 1.0 + (self.inner_radius / self.radius) ** 2

    @property
    def aspect(self) -> float:
        """Ratio h = H/R of thickness to diameter (4.4); (7.2) prints its inverse."""
        return self.thickness / (2 * self.radius)

    @property
    def time_unit(self) -> float:
        """Time unit chi of (4.5) [s]."""
        return ((self.gyration + 4) / 4 * self.radius / GRAVITY) ** 0.5

    @property
    def weight(self) -> float:
        """Weight m g [N]."""
        return self.mass * GRAVITY


@dataclass(frozen=True, kw_only=True)
class Friction:
    """Coulomb friction (3.2) and the resisting moments (3.3) of the contact.

    Raises
    ------
    ValueError
        If the dynamic coefficient exceeds the static one, or a coefficient exceeds 1e6.

    Examples
    --------
    >>> from dynamics import Friction
    >>> Friction(mu_static=0.5, mu_dynamic=0.45, arm_rolling=1e-5).arm_pivoting
    0.0
    """

    mu_static: Annotated[float, Ge(0)]
    """Coefficient of static friction, at most 1e6, or inf for a contact that never slips."""
    mu_dynamic: Annotated[float, Ge(0)]
    """Coefficient of dynamic friction, at most the static one."""
    arm_nutation: Annotated[float, Ge(0), Le(100)] = 0.0
    """Arm k_1 of the moment that resists nutation [m], at most the radius of the disk."""
    arm_rolling: Annotated[float, Ge(0), Le(100)] = 0.0
    """Arm k_2 of the moment that resists rolling [m], at most the radius of the disk."""
    arm_pivoting: Annotated[float, Ge(0), Le(100)] | Literal["contact"] = 0.0
    """Arm k_3 of the moment that resists pivoting [m], at most the radius of the disk; "contact"
    computes it from slip and creep in the ellipse of the contact."""

    def __post_init__(self) -> None:
        for key, mu in (("mu_static", self.mu_static), ("mu_dynamic", self.mu_dynamic)):
            if MAX_FINITE_FRICTION < mu < inf:
                allowed = f"less than or equal to {MAX_FINITE_FRICTION:g}, or inf"
                raise ValueError(f"{key} = {mu:g}: must be {allowed}")
        if self.mu_dynamic > self.mu_static:
            dynamic = f"mu_dynamic = {self.mu_dynamic:g}"
            raise ValueError(
                f"{dynamic} must not exceed mu_static = {self.mu_static:g}"
            )


@dataclass(frozen=True, kw_only=True)
class Release:
    """Initial state (7.4) of the disk; its contact does not slip.

    Examples
    --------
    >>> from dynamics import Release
    >>> Release(inclination_deg=10, omega=(0.0, 2.0, 30.0)).inclination_deg
    10
    """

    inclination_deg: Annotated[float, Ge(1e-6), Lt(90)]
    """Angle between disk and table [degrees]."""
    omega: tuple[AngularRate, AngularRate, AngularRate]
    """Angular velocity along e_1 (nutation), e_2 (disk axis) and e_3 (disk plane) [rad/s]."""


def inertias(disk: Disk) -> tuple[float, float]:
    """Return the moments of inertia [kg m^2] about a diameter and about the axis."""
    unit = disk.mass * disk.radius**2
    K = disk.gyration
    h = disk.aspect
    return unit * (K / 4 + h * h / 3), unit * K / 2
