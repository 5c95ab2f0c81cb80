"""The sections of a scene on the contact of the edge. SI units; [ ] holds the unit of a key."""

from dataclasses import dataclass
from math import inf
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Lt

ROUNDED = 1 / 8
"""Fillet of an edge over its thickness: 1.6 mm of the toy's 12.8 mm."""
MOST_CELLS = 2**24
"""A profile is not resolved into more cells."""
CELLS = 8
"""Cells per shortest wavelength: where a is a cell or more, every wave is then read to 3e-4 of itself."""
WAVES = 64
"""The table's period holds at least so many of the longest waves."""
MOST_EXPONENT = 16.0
Length = Annotated[float, Gt(0), Le(100)]


@dataclass(frozen=True, kw_only=True)
class Contact:
    """How the edge of the disk touches the table: rigid, or both half spaces that yield (Hertz, Mindlin, Kalker)."""

    law: Literal["rigid", "elastic"] = "rigid"
    """A rigid contact is solved event by event; an elastic one has resonances, and may be lost."""
    fillet: Length | None = None
    """Radius to which the edge is rounded [m], at most half the thickness; an eighth of it unless given."""
    loss_factor: Annotated[float, Ge(0), Lt(1)] = 0.02
    """Loss of energy per radian over the energy of the contact's normal resonance."""
    body: Literal["elastic", "rigid"] = "elastic"
    """Whether a solid disk bends as a whole at its contact, in series with the springs of the edge, or is rigid; on a
    table that acts back those of its modes move that are below 20 kHz."""
    young: Annotated[float, Ge(1), Le(1e15)] = 60e9
    """Young's modulus of the table where the disk touches it [Pa]; that of granite unless given."""
    poisson: Annotated[float, Gt(-1), Lt(0.5)] = 0.2
    """Poisson's ratio of the table."""

    def law_of(self, disk, body):
        """Return the `ContactLaw` of a disk of an elastic material. Raises ValueError where the fillet does not fit."""
        from .contact import ContactLaw, Elastic  # SciPy, which a section does not need

        return ContactLaw(
            disk=disk,
            fillet=self.fillet or min(ROUNDED * disk.thickness, disk.radius),
            body=Elastic(body.young, body.poisson),
            table=Elastic(self.young, self.poisson),
            loss_factor=self.loss_factor,
        )

    def suspension(self, scene, inclination: float):
        """Return the `Suspension` on which the disk of a scene stands at an inclination [rad], whatever the law.

        Raises ValueError where its fillet does not fit, and where the disk rolls in no steady motion.
        """
        from .resonance import suspension

        return suspension(self.law_of(scene.disk, scene.material), inclination)


@dataclass(frozen=True, kw_only=True)
class Roughness:
    """Gaussian heights with a power spectrum k^-exponent between two wavelengths, or measured ones, of table and edge.

    An elastic contact reads them, averaged over its ellipse; on a rigid one they have no effect.
    """

    rms: Annotated[float, Gt(0), Le(1)] | None = None
    """Root mean square of the heights of the table, before the contact averages them [m]."""
    rms_edge: Annotated[float, Ge(0), Le(1)] | None = None
    """That of the edge [m], 0 where it is smooth; the table's unless given."""
    shortest: Length = 1e-4
    """Shortest wavelength [m]."""
    longest: Length = 0.1
    """Longest wavelength [m]."""
    exponent: Annotated[float, Ge(0), Le(MOST_EXPONENT)] = 0.0
    """Exponent of the fall of the power spectrum over the wave number."""
    loss: Literal["own", "fitted"] = "own"
    """What roughness takes of the motion: "own", besides the friction of the scene, or "fitted", a part of it, where
    that was measured on such a surface."""
    seed: Annotated[int, Ge(0), Le(10**9)] = 0
    """Seed of the heights: the same one gives the same heights."""
    profile: str | None = None
    """Path of a CSV file of heights against length [m] measured on the table, in place of rms."""
    profile_edge: str | None = None
    """Path of such a file measured along the edge, in place of rms_edge."""

    def __post_init__(self):
        if self.rms is None and self.profile is None:
            raise ValueError("give either rms or profile")
        if self.rms is not None and self.profile is not None:
            raise ValueError("give either rms or profile, not both; the edge's are rms_edge and profile_edge")
        if self.rms is not None and not 0 < self.rms < inf:
            raise ValueError(f"roughness.rms = {self.rms:g}: must be positive and finite")
        if self.profile_edge is not None and self.rms_edge is not None:
            raise ValueError("give either rms_edge or profile_edge")
        if not 0 < self.shortest < inf:
            raise ValueError(f"roughness.shortest = {self.shortest:g}: must be positive and finite")
        if not self.shortest < self.longest < inf:
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must exceed shortest = {self.shortest:g} and be finite"
            )
        if not 0 <= self.exponent <= MOST_EXPONENT:
            raise ValueError(f"roughness.exponent = {self.exponent:g}: must lie in 0 to {MOST_EXPONENT:g}")
        if CELLS * WAVES * self.longest > MOST_CELLS * self.shortest:
            most = MOST_CELLS / (CELLS * WAVES)
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must be at most {most:g} times shortest = {self.shortest:g}"
            )

    @property
    def edge_rms(self) -> float:
        """Root mean square of the heights of the edge [m], 0 where it is smooth or measured."""
        if self.profile_edge is not None:
            return 0.0
        return (self.rms or 0.0) if self.rms_edge is None else self.rms_edge


@dataclass(frozen=True, kw_only=True)
class Imperfection:
    """A rigid table that is wavy round the circle of the contact: its height is amplitude cos(order angle)."""

    order: Annotated[int, Ge(2), Le(64)] = 2
    """Number of waves round the circle of the contact."""
    amplitude: Annotated[float, Gt(0), Le(1e-3)]
    """Height of their crests [m]."""


def require_seen(roughness: Roughness, half_length: float) -> None:
    """Raise ValueError where every wave is shorter than the ellipse of half-length a [m] and so averaged away."""
    if roughness.longest <= 2 * half_length:
        raise ValueError(
            f"roughness.longest = {roughness.longest:g}: must exceed the contact, {2 * half_length:.3g} m long"
        )
