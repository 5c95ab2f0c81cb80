"""The section `surface` of a scene: one class for each kind of table.

The frame of a table is that of the motion: z points upwards, and at the release the centre of the
disk is above the origin, or above `place` if given. [ ] holds the unit of each key.
"""

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from annotated_types import Ge, Gt, Le, Len, Lt

Action = Literal["auto", "sound", "motion"]
Length = Annotated[float, Gt(0), Le(100)]
Coordinate = Annotated[float, Ge(-100), Le(100)]
YoungModulus = Annotated[float, Ge(1), Le(1e15)]
PoissonRatio = Annotated[float, Gt(-1), Lt(0.5)]
Density = Annotated[float, Ge(1e-3), Le(1e6)]
LossFactor = Annotated[float, Ge(0), Le(1)]
MIN_TWO_WAY_SHARE = 0.01
"""Threshold of two-way coupling.

Coupling begins when the table modes store this share of the energy of the disk, or absorb this
share of the dissipated power.
"""


@dataclass(frozen=True, kw_only=True)
class Surface:
    """A rigid table: it neither moves nor sounds.

    Examples
    --------
    >>> from dynamics import Surface
    >>> Surface().kind
    'rigid'
    """

    kind: Literal["rigid"] = "rigid"
    """Kind of table: rigid, a round plate, a list of modes, an infinite plate, or a mesh."""
    action: ClassVar[Action] = "sound"


@dataclass(frozen=True, kw_only=True)
class PlateSurface:
    """A round elastic plate.

    Raises
    ------
    ValueError
        If the plate is thicker than its radius, or its supporting ring is wider than the plate or
        given in part only.

    Examples
    --------
    >>> from dynamics import PlateSurface
    >>> steel = {"young": 2.1e11, "poisson": 0.3, "density": 7850.0}
    >>> PlateSurface(radius=0.2, thickness=0.006, **steel).edge
    'supported'
    """

    kind: Literal["plate"] = "plate"
    """Kind of table: rigid, a round plate, a list of modes, an infinite plate, or a mesh."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupling with the motion, or auto by the plan."""
    radius: Length
    """Radius of the plate [m], at least that of the disk."""
    thickness: Length
    """Thickness of the plate [m]."""
    young: YoungModulus
    """Young's modulus of the table [Pa]."""
    poisson: PoissonRatio
    """Poisson's ratio of the table."""
    density: Density
    """Density of the table [kg/m^3]."""
    loss_factor: LossFactor = 0.02
    """Loss factor of the material: twice the damping ratio of every mode."""
    edge: Literal["free", "supported", "clamped"] = "supported"
    """Boundary condition at the edge of the plate."""
    ring_radius: Length | None = None
    """Radius of an elastic ring under the plate [m]; needs ring_stiffness; no ring unless given."""
    ring_stiffness: Annotated[float, Gt(0), Le(1e15)] | None = None
    """Vertical stiffness of that ring per unit length [N/m^2]."""
    place: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    """Position of the disk centre at the release [m], from the plate centre or the mesh origin."""

    def __post_init__(self):
        if self.thickness > self.radius:
            limit = f"radius = {self.radius:g}"
            raise ValueError(f"thickness = {self.thickness:g}: must not exceed {limit}")
        if (self.ring_radius is None) != (self.ring_stiffness is None):
            raise ValueError("give ring_radius and ring_stiffness together")
        if (self.ring_radius or 0) > self.radius:
            limit = f"radius = {self.radius:g}"
            raise ValueError(f"ring_radius = {self.ring_radius:g}: must not exceed {limit}")


@dataclass(frozen=True, kw_only=True)
class SurfaceMode:
    """Mode of a table along the contact circle; an order above 0 means a pair of cosine and sine.

    Examples
    --------
    >>> from dynamics import SurfaceMode
    >>> SurfaceMode(order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0).frequency
    600.0
    """

    order: Annotated[int, Ge(0), Le(64)]
    """Number of wavelengths along the contact circle."""
    frequency: Annotated[float, Gt(0), Le(1e6)]
    """Frequency [Hz]."""
    damping_ratio: Annotated[float, Ge(0), Lt(1)]
    """Damping ratio: decay rate divided by angular frequency."""
    modal_mass: Annotated[float, Ge(1e-9), Le(1e9)]
    """Modal mass for a shape of amplitude 1 at its antinode on the contact circle [kg]."""


@dataclass(frozen=True, kw_only=True)
class ModesSurface:
    """A table given by its modes, measured or computed elsewhere.

    Examples
    --------
    >>> from dynamics import ModesSurface, SurfaceMode
    >>> mode = SurfaceMode(order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0)
    >>> len(ModesSurface(modes=(mode,)).modes)
    1
    """

    kind: Literal["modes"] = "modes"
    """Kind of table: rigid, a round plate, a list of modes, an infinite plate, or a mesh."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupling with the motion, or auto by the plan."""
    modes: Annotated[tuple[SurfaceMode, ...], Len(1, 64)]
    """Order, frequency [Hz], damping ratio and modal mass [kg] of each mode."""


@dataclass(frozen=True, kw_only=True)
class InfiniteSurface:
    """An infinite elastic plate: it absorbs energy from the contact force and never rings.

    Examples
    --------
    >>> from dynamics import InfiniteSurface
    >>> wood = {"young": 1e10, "poisson": 0.3, "density": 600.0}
    >>> InfiniteSurface(thickness=0.02, **wood).loss_factor
    0.02
    """

    kind: Literal["infinite"] = "infinite"
    """Kind of table: rigid, a round plate, a list of modes, an infinite plate, or a mesh."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupling with the motion, or auto by the plan."""
    thickness: Length
    """Thickness of the plate [m]."""
    young: YoungModulus
    """Young's modulus of the table [Pa]."""
    poisson: PoissonRatio
    """Poisson's ratio of the table."""
    density: Density
    """Density of the table [kg/m^3]."""
    loss_factor: LossFactor = 0.02
    """Loss factor of the material: twice the damping ratio of every mode."""


@dataclass(frozen=True, kw_only=True)
class MeshSurface:
    """A table of any shape, given as a volume mesh with a level top face.

    Examples
    --------
    >>> from dynamics import MeshSurface
    >>> wood = {"young": 1e10, "poisson": 0.3, "density": 600.0}
    >>> MeshSurface(file="table.msh", held=("feet",), **wood).place
    (0.0, 0.0)
    """

    kind: Literal["mesh"] = "mesh"
    """Kind of table: rigid, a round plate, a list of modes, an infinite plate, or a mesh."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupling with the motion, or auto by the plan."""
    file: str
    """Mesh file readable by meshio, in metres, z upwards; relative to the scene file."""
    young: YoungModulus
    """Young's modulus of the table [Pa]."""
    poisson: PoissonRatio
    """Poisson's ratio of the table."""
    density: Density
    """Density of the table [kg/m^3]."""
    loss_factor: LossFactor = 0.02
    """Loss factor of the material: twice the damping ratio of every mode."""
    held: tuple[str, ...] = ()
    """Names of the fixed surfaces or node sets of the mesh."""
    place: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    """Position of the disk centre at the release [m], from the plate centre or the mesh origin."""


AnySurface = Surface | PlateSurface | ModesSurface | InfiniteSurface | MeshSurface
"""Any kind of table; `kind` is the discriminator."""
