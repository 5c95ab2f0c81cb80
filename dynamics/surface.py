"""The section `surface` of a scene: one class for each kind of table.

Table and motion have the same frame: z points upwards, and at the release the centre of
the disk is above the origin, or above `place` if given.
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
HoleDiameter = Annotated[float, Ge(0), Le(100)]
LossFactor = Annotated[float, Ge(0), Le(1)]
DEFAULT_LOSS_FACTOR = 0.02
"""Default loss factor of a table."""


class Tabletop:
    """Shape of a table top: plane, or concave with a circular rim."""

    sag: float = 0.0
    diameter: float | None = None
    place: tuple[float, float] = (0.0, 0.0)
    hole: float = 0.0

    @property
    def curvature(self) -> float:
        """Curvature in the middle of the table top [1/m], 8 sag/diameter^2."""
        if not self.sag or self.diameter is None:
            return 0.0
        return 8 * self.sag / self.diameter**2

    def check_disk_fits_bowl(self, radius: float) -> None:
        """Check that a disk fits into the bowl of a concave table.

        Parameters
        ----------
        radius : float
            Radius of the disk [m].

        Raises
        ------
        ValueError
            If the diameter of the bowl is missing, if the disk is wider than the bowl,
            or if the bowl is too deep for its rim.
        """
        # Largest slope [rad] of a concave table at the rim of a disk placed in its
        # middle
        max_bowl_slope = 0.1
        if not self.sag:
            return
        if self.diameter is None:
            raise ValueError(f"surface.sag = {self.sag:g}: requires surface.diameter")
        if self.diameter <= 2 * radius:
            raise ValueError(
                f"surface.diameter = {self.diameter:g}: must exceed the disk diameter, "
                f"{2 * radius:g}"
            )
        greatest = max_bowl_slope * self.diameter**2 / (8 * radius)
        if self.sag > greatest:
            raise ValueError(
                f"surface.sag = {self.sag:g}: too deep for the rim of the disk; at most "
                f"{greatest:.3g} m is possible"
            )

    def check_hole(self, flat_radius: float) -> None:
        """Check that a hole is smaller than the flat face of the disk.

        Parameters
        ----------
        flat_radius : float
            Radius of the flat face [m].

        Raises
        ------
        ValueError
            If the hole reaches the edge of the flat face.
        """
        if self.hole and self.hole >= 2 * flat_radius:
            raise ValueError(
                f"surface.hole = {self.hole:g}: must not reach the diameter of the flat face of "
                f"the disk, {2 * flat_radius:.4g} m, outside which it rolls"
            )


@dataclass(frozen=True, kw_only=True)
class Surface(Tabletop):
    """A rigid table, which neither moves nor sounds.

    Examples
    --------
    >>> from dynamics import Surface
    >>> Surface().kind
    'rigid'
    """

    kind: Literal["rigid"] = "rigid"
    """Kind of table: rigid, round plate, list of modes, infinite plate, or mesh."""
    hole: HoleDiameter = 0.0
    """Diameter [m] of a hole in the table under the centre of the disk, over which the pressure is
    ambient; the film of air is that of the ring around it."""
    sag: Annotated[float, Ge(0), Le(1)] = 0.0
    """Depth [m] of a concave table: distance of its middle below its rim."""
    diameter: Length | None = None
    """Diameter of the rim of a concave table [m]; default: that of the plate."""
    place: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    """Position of the disk centre at the release [m], from the middle of a concave table."""
    action: ClassVar[Action] = "sound"
    baffle: ClassVar[bool] = True


@dataclass(frozen=True, kw_only=True)
class PlateSurface(Tabletop):
    """A round elastic plate.

    Raises
    ------
    ValueError
        If the thickness of the plate exceeds its radius, or if its supporting ring is
        wider than the plate or incompletely specified.

    Examples
    --------
    >>> from dynamics import PlateSurface
    >>> steel = {"young": 2.1e11, "poisson": 0.3, "density": 7850.0}
    >>> PlateSurface(radius=0.2, thickness=0.006, **steel).edge
    'supported'
    """

    kind: Literal["plate"] = "plate"
    """Kind of table: rigid, round plate, list of modes, infinite plate, or mesh."""
    hole: HoleDiameter = 0.0
    """Diameter [m] of a hole in the table under the centre of the disk, over which the pressure is
    ambient; the film of air is that of the ring around it."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupled motion, or auto (set by the
    plan)."""
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
    loss_factor: LossFactor = DEFAULT_LOSS_FACTOR
    """Loss factor of the material: twice the damping ratio of every mode."""
    edge: Literal["free", "supported", "clamped"] = "supported"
    """Boundary condition at the edge of the plate."""
    ring_radius: Length | None = None
    """Radius of an elastic ring that supports the plate [m]; requires ring_stiffness.
    By default there is no ring."""
    ring_stiffness: Annotated[float, Gt(0), Le(1e15)] | None = None
    """Vertical stiffness of that ring per unit length [N/m^2]."""
    sag: Annotated[float, Ge(0), Le(1)] = 0.0
    """Depth [m] of a concave table: distance of its middle below its rim."""
    diameter: Length | None = None
    """Diameter of the rim of a concave table [m]; default: that of the plate."""
    place: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    """Position of the disk centre at the release [m], from the plate centre or the mesh origin."""
    baffle: bool = False
    """Whether a baffle around the table prevents air flow around its edge."""

    def __post_init__(self) -> None:
        if self.sag and self.diameter is None:
            object.__setattr__(self, "diameter", 2 * self.radius)
        if self.thickness > self.radius:
            limit = f"radius = {self.radius:g}"
            raise ValueError(f"thickness = {self.thickness:g}: must not exceed {limit}")
        if (self.ring_radius is None) != (self.ring_stiffness is None):
            raise ValueError("give ring_radius and ring_stiffness together")
        if (self.ring_radius or 0) > self.radius:
            limit = f"radius = {self.radius:g}"
            raise ValueError(
                f"ring_radius = {self.ring_radius:g}: must not exceed {limit}"
            )


@dataclass(frozen=True, kw_only=True)
class SurfaceMode:
    """Table mode along the contact circle; a cosine-sine pair above order 0.

    Examples
    --------
    >>> from dynamics import SurfaceMode
    >>> SurfaceMode(order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0).frequency
    600.0
    """

    order: Annotated[int, Ge(0), Le(64)]
    """Number of wavelengths around the contact circle."""
    frequency: Annotated[float, Gt(0), Le(1e6)]
    """Frequency [Hz]."""
    damping_ratio: Annotated[float, Ge(0), Lt(1)]
    """Damping ratio: decay rate divided by angular frequency."""
    modal_mass: Annotated[float, Ge(1e-9), Le(1e9)]
    """Modal mass [kg] for a shape of amplitude 1 at its antinode at the radius R of the disk; a
    contact at the radius r on a rounded edge meets the amplitude (r/R)^order."""


@dataclass(frozen=True, kw_only=True)
class ModesSurface(Tabletop):
    """A table specified by measured or previously computed modes.

    Examples
    --------
    >>> from dynamics import ModesSurface, SurfaceMode
    >>> mode = SurfaceMode(order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0)
    >>> len(ModesSurface(modes=(mode,)).modes)
    1
    """

    kind: Literal["modes"] = "modes"
    """Kind of table: rigid, round plate, list of modes, infinite plate, or mesh."""
    hole: HoleDiameter = 0.0
    """Diameter [m] of a hole in the table under the centre of the disk, over which the pressure is
    ambient; the film of air is that of the ring around it."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupled motion, or auto (set by the
    plan)."""
    modes: Annotated[tuple[SurfaceMode, ...], Len(1, 64)]
    """Order, frequency [Hz], damping ratio and modal mass [kg] of each mode."""
    baffle: ClassVar[bool] = True
    """Always true: the table is the baffle of the contact circle, which alone radiates."""


@dataclass(frozen=True, kw_only=True)
class InfiniteSurface(Tabletop):
    """An infinite elastic plate, which absorbs energy but does not resonate.

    Examples
    --------
    >>> from dynamics import InfiniteSurface
    >>> wood = {"young": 1e10, "poisson": 0.3, "density": 600.0}
    >>> InfiniteSurface(thickness=0.02, **wood).loss_factor
    0.02
    """

    kind: Literal["infinite"] = "infinite"
    """Kind of table: rigid, round plate, list of modes, infinite plate, or mesh."""
    hole: HoleDiameter = 0.0
    """Diameter [m] of a hole in the table under the centre of the disk, over which the pressure is
    ambient; the film of air is that of the ring around it."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupled motion, or auto (set by the
    plan)."""
    thickness: Length
    """Thickness of the plate [m]."""
    young: YoungModulus
    """Young's modulus of the table [Pa]."""
    poisson: PoissonRatio
    """Poisson's ratio of the table."""
    density: Density
    """Density of the table [kg/m^3]."""
    loss_factor: LossFactor = DEFAULT_LOSS_FACTOR
    """Loss factor of the material: twice the damping ratio of every mode."""
    baffle: bool = True
    """Whether a baffle prevents air flow around the edge of the table; always true
    here."""

    def __post_init__(self) -> None:
        if not self.baffle:
            raise ValueError("baffle = false: an infinite plate is its own baffle")


@dataclass(frozen=True, kw_only=True)
class MeshSurface(Tabletop):
    """A table of any shape, specified as a volume mesh with a horizontal top face.

    Examples
    --------
    >>> from dynamics import MeshSurface
    >>> wood = {"young": 1e10, "poisson": 0.3, "density": 600.0}
    >>> MeshSurface(file="table.msh", held=("feet",), **wood).place
    (0.0, 0.0)
    """

    kind: Literal["mesh"] = "mesh"
    """Kind of table: rigid, round plate, list of modes, infinite plate, or mesh."""
    hole: HoleDiameter = 0.0
    """Diameter [m] of a hole in the table under the centre of the disk, over which the pressure is
    ambient; the film of air is that of the ring around it."""
    action: Action = "auto"
    """Effect of the table: sound only, two-way coupled motion, or auto (set by the
    plan)."""
    file: str
    """Mesh file, such as .msh, .inp, .unv or .vtu, in metres with z upwards; its path is
    relative to the scene file."""
    young: YoungModulus
    """Young's modulus of the table [Pa]."""
    poisson: PoissonRatio
    """Poisson's ratio of the table."""
    density: Density
    """Density of the table [kg/m^3]."""
    loss_factor: LossFactor = DEFAULT_LOSS_FACTOR
    """Loss factor of the material: twice the damping ratio of every mode."""
    held: tuple[str, ...] = ()
    """Names of the surfaces or node sets of the mesh that are fixed."""
    sag: Annotated[float, Ge(0), Le(1)] = 0.0
    """Depth [m] of a concave table: distance of its middle below its rim."""
    diameter: Length | None = None
    """Diameter of the rim of a concave table [m]; default: that of the plate."""
    place: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    """Position of the disk centre at the release [m], from the plate centre or the mesh origin."""
    baffle: bool = False
    """Whether a baffle around the table prevents air flow around its edge."""


AnySurface = Surface | PlateSurface | ModesSurface | InfiniteSurface | MeshSurface
"""Any kind of table; `kind` is the discriminator."""
