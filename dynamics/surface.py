"""The section of a scene on what the disk stands on: one type for each kind of table.

The frame of a table is that of the motion: z upwards, the origin where the centre of the disk is above at the release,
unless its `place` says otherwise. SI units; [ ] holds the unit of a key.
"""

from dataclasses import dataclass
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Len, Lt

Action = Literal["auto", "sound", "motion"]
Size = Annotated[float, Gt(0), Le(100)]
Place = Annotated[float, Ge(-100), Le(100)]
Young = Annotated[float, Ge(1), Le(1e15)]
Poisson = Annotated[float, Gt(-1), Lt(0.5)]
Density = Annotated[float, Ge(1e-3), Le(1e6)]
Loss = Annotated[float, Ge(0), Le(1)]
ACTS = 0.01
"""A table acts back that holds as much of the energy of the disk, or takes as much of the power that the rest takes."""


@dataclass(frozen=True, kw_only=True)
class Surface:
    """A table that neither moves nor sounds."""

    kind: Literal["rigid"] = "rigid"
    """What the disk stands on: a table without motion, a round plate, modes by number, an endless plate, any solid."""


@dataclass(frozen=True, kw_only=True)
class PlateSurface:
    """A round elastic plate."""

    kind: Literal["plate"] = "plate"
    """What the disk stands on: a table without motion, a round plate, modes by number, an endless plate, any solid."""
    action: Action = "auto"
    """Whether the table only sounds or acts back on the motion of the disk; auto is the plan's choice."""
    radius: Size
    """Radius of the plate [m], at least that of the disk."""
    thickness: Size
    """Thickness of the plate [m]."""
    young: Young
    """Young's modulus of the table [Pa]."""
    poisson: Poisson
    """Poisson's ratio of the table."""
    density: Density
    """Mass per volume of the table [kg/m^3]."""
    loss_factor: Loss = 0.02
    """Loss of energy per radian over the energy: twice the damping ratio of every mode."""
    edge: Literal["free", "supported", "clamped"] = "supported"
    """How the edge is held: not at all, against vertical motion, or against every motion."""
    ring_radius: Size | None = None
    """Radius of an elastic ring that carries the plate [m], with ring_stiffness; none unless given."""
    ring_stiffness: Annotated[float, Gt(0), Le(1e15)] | None = None
    """Vertical stiffness of that ring, per length [N/m^2]."""
    place: tuple[Place, Place] = (0.0, 0.0)
    """Where the centre of the disk is at the release [m], in the frame of the mesh or from the middle of the plate."""

    def __post_init__(self):
        if self.thickness > self.radius:
            raise ValueError(f"thickness = {self.thickness:g}: must not exceed radius = {self.radius:g}")
        if (self.ring_radius is None) != (self.ring_stiffness is None):
            raise ValueError("give ring_radius and ring_stiffness together")
        if (self.ring_radius or 0) > self.radius:
            raise ValueError(f"ring_radius = {self.ring_radius:g}: must not exceed radius = {self.radius:g}")


@dataclass(frozen=True, kw_only=True)
class SurfaceMode:
    """A mode of a table round the contact circle, of which a cosine and a sine partner exist unless its order is 0."""

    order: Annotated[int, Ge(0), Le(64)]
    """Number of waves round the contact circle."""
    frequency: Annotated[float, Gt(0), Le(1e6)]
    """Frequency [Hz]."""
    damping_ratio: Annotated[float, Ge(0), Lt(1)]
    """Decay rate over angular frequency."""
    modal_mass: Annotated[float, Ge(1e-9), Le(1e9)]
    """Mass that, moving as the antinode on the contact circle does, has the kinetic energy of the mode [kg]."""


@dataclass(frozen=True, kw_only=True)
class ModesSurface:
    """A table by its modes, as measured or computed elsewhere."""

    kind: Literal["modes"] = "modes"
    """What the disk stands on: a table without motion, a round plate, modes by number, an endless plate, any solid."""
    action: Action = "auto"
    """Whether the table only sounds or acts back on the motion of the disk; auto is the plan's choice."""
    modes: Annotated[tuple[SurfaceMode, ...], Len(1, 64)]
    """Order, frequency in hertz, damping ratio and modal mass in kilograms of each mode."""


@dataclass(frozen=True, kw_only=True)
class InfiniteSurface:
    """An endless elastic plate: it takes energy from a force at a point, and never rings."""

    kind: Literal["infinite"] = "infinite"
    """What the disk stands on: a table without motion, a round plate, modes by number, an endless plate, any solid."""
    action: Action = "auto"
    """Whether the table only sounds or acts back on the motion of the disk; auto is the plan's choice."""
    thickness: Size
    """Thickness of the plate [m]."""
    young: Young
    """Young's modulus of the table [Pa]."""
    poisson: Poisson
    """Poisson's ratio of the table."""
    density: Density
    """Mass per volume of the table [kg/m^3]."""
    loss_factor: Loss = 0.02
    """Loss of energy per radian over the energy: twice the damping ratio of every mode."""


@dataclass(frozen=True, kw_only=True)
class MeshSurface:
    """A table of any shape, as a mesh of its volume; its top face is level, and the highest that there is."""

    kind: Literal["mesh"] = "mesh"
    """What the disk stands on: a table without motion, a round plate, modes by number, an endless plate, any solid."""
    action: Action = "auto"
    """Whether the table only sounds or acts back on the motion of the disk; auto is the plan's choice."""
    file: str
    """File of the mesh, in metres, z upwards, as meshio reads it; sought beside the scene."""
    young: Young
    """Young's modulus of the table [Pa]."""
    poisson: Poisson
    """Poisson's ratio of the table."""
    density: Density
    """Mass per volume of the table [kg/m^3]."""
    loss_factor: Loss = 0.02
    """Loss of energy per radian over the energy: twice the damping ratio of every mode."""
    held: tuple[str, ...] = ()
    """Names of the surfaces or sets of nodes of the mesh that do not move."""
    place: tuple[Place, Place] = (0.0, 0.0)
    """Where the centre of the disk is at the release [m], in the frame of the mesh or from the middle of the plate."""


AnySurface = Surface | PlateSurface | ModesSurface | InfiniteSurface | MeshSurface
"""The kinds of table; `kind` tells them apart."""
