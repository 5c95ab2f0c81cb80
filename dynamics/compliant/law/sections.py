"""Sections of a scene for the contact of the edge, in SI units; [ ] holds the unit of a key."""

from dataclasses import dataclass
from math import inf
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Lt

DEFAULT_FILLET_RATIO = 1 / 8
"""Ratio of the default fillet to the thickness: 1.6 mm for the thickness 12.8 mm of the toy."""
MAX_PROFILE_CELLS = 2**24
"""Largest number of cells of a profile."""
CELLS_PER_WAVE = 8
"""Cells per shortest wavelength; waves are accurate to 3e-4 if the half-length a is at least a
cell.
"""
MIN_WAVES_PER_PERIOD = 64
"""Smallest number of the longest waves in the period of the table."""
MAX_SPECTRUM_EXPONENT = 16.0
"""Largest exponent of the power spectrum."""
Length = Annotated[float, Gt(0), Le(100)]


@dataclass(frozen=True, kw_only=True)
class Contact:
    """Contact of edge and table: rigid, or two elastic half spaces (Hertz, Mindlin, Kalker)."""

    law: Literal["rigid", "elastic"] = "rigid"
    """Contact law; a rigid contact is solved event by event, an elastic one has resonances."""
    fillet: Length | None = None
    """Radius of the rounded edge [m], at most half the thickness; default: an eighth of it."""
    loss_factor: Annotated[float, Ge(0), Lt(1)] = 0.02
    """Energy loss per radian over the energy of the normal contact resonance."""
    restitution: Annotated[float, Gt(0), Lt(1)] | None = None
    """Restitution of a rigid disk that hits the table with its edge, in place of loss_factor;
    needs numerics.contact = "many"."""
    body: Literal["elastic", "rigid"] = "elastic"
    """Whether a solid disk is rigid or bends as a whole, in series with the springs of the edge;
    with two-way coupling its modes below 20 kHz move. """
    young: Annotated[float, Ge(1), Le(1e15)] = 60e9
    """Young's modulus of the table where the disk touches it [Pa]; default: granite."""
    poisson: Annotated[float, Gt(-1), Lt(0.5)] = 0.2
    """Poisson's ratio of the table."""

    def law_of(self, disk, body):
        """Return the `ContactLaw` of a disk of this material. Raises ValueError if the fillet does
        not fit.
        """
        from dynamics.compliant.law.hertz_mindlin import (  # SciPy, which a section does not need
            ContactLaw,
            ElasticConstants,
        )

        return ContactLaw(
            disk=disk,
            fillet=self.fillet or min(DEFAULT_FILLET_RATIO * disk.thickness, disk.radius),
            body=ElasticConstants(body.young, body.poisson),
            table=ElasticConstants(self.young, self.poisson),
            loss_factor=self.loss_factor,
        )

    def suspension(self, scene, inclination: float):
        """Return the `Suspension` of the disk of a scene at an inclination [rad], for either
        contact law.

        Raises ValueError if the fillet does not fit, or if there is no steady motion.
        """
        from dynamics.compliant.law.linearised import suspension

        return suspension(self.law_of(scene.disk, scene.material), inclination)


@dataclass(frozen=True, kw_only=True)
class Roughness:
    """Heights of table and edge: measured, or Gaussian with a power spectrum k^-exponent.

    An elastic contact averages them over its ellipse; they do not affect a rigid one.
    """

    rms: Annotated[float, Gt(0), Le(1)] | None = None
    """Root mean square height of the table, before the average over the contact [m]."""
    rms_edge: Annotated[float, Ge(0), Le(1)] | None = None
    """Root mean square height of the edge [m], 0 for a smooth edge; default: that of the table."""
    shortest: Length = 1e-4
    """Shortest wavelength [m]."""
    longest: Length = 0.1
    """Longest wavelength [m]."""
    exponent: Annotated[float, Ge(0), Le(MAX_SPECTRUM_EXPONENT)] = 0.0
    """Exponent p of the power spectrum k^-p over the wave number k."""
    loss: Literal["own", "fitted"] = "own"
    """Energy loss by roughness: "own" adds it to the friction of the scene, "fitted" includes it in
    a friction that was measured on such a surface. """
    seed: Annotated[int, Ge(0), Le(10**9)] = 0
    """Seed of the random heights; equal seeds give equal heights."""
    grain: bool = False
    """Whether the table is ruled: its height varies along x only; needs a disk that rattles."""
    profile: str | None = None
    """Path of a CSV file with lengths and heights [m] measured on the table, in place of rms."""
    profile_edge: str | None = None
    """Path of a CSV file measured along the edge, in place of rms_edge."""

    def __post_init__(self):
        if self.rms is None and self.profile is None:
            raise ValueError("give either rms or profile")
        if self.rms is not None and self.profile is not None:
            raise ValueError(
                "give either rms or profile, not both; the edge's are rms_edge and profile_edge"
            )
        if self.rms is not None and not 0 < self.rms < inf:
            raise ValueError(f"roughness.rms = {self.rms:g}: must be positive and finite")
        if self.profile_edge is not None and self.rms_edge is not None:
            raise ValueError("give either rms_edge or profile_edge")
        if not 0 < self.shortest < inf:
            raise ValueError(f"roughness.shortest = {self.shortest:g}: must be positive and finite")
        if not self.shortest < self.longest < inf:
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must exceed shortest = {self.shortest:g} "
                f"and be finite"
            )
        if not 0 <= self.exponent <= MAX_SPECTRUM_EXPONENT:
            raise ValueError(
                f"roughness.exponent = {self.exponent:g}: must lie in 0 to "
                f"{MAX_SPECTRUM_EXPONENT:g}"
            )
        if CELLS_PER_WAVE * MIN_WAVES_PER_PERIOD * self.longest > MAX_PROFILE_CELLS * self.shortest:
            most = MAX_PROFILE_CELLS / (CELLS_PER_WAVE * MIN_WAVES_PER_PERIOD)
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must be at most {most:g} times shortest = "
                f"{self.shortest:g}"
            )

    @property
    def edge_rms(self) -> float:
        """Root mean square height of the edge [m]; 0 for a smooth or measured edge."""
        if self.profile_edge is not None:
            return 0.0
        return (self.rms or 0.0) if self.rms_edge is None else self.rms_edge


@dataclass(frozen=True, kw_only=True)
class Imperfection:
    """A rigid, wavy table: its height along the contact circle is amplitude cos(order angle)."""

    order: Annotated[int, Ge(2), Le(64)] = 2
    """Number of waves on the contact circle."""
    amplitude: Annotated[float, Gt(0), Le(1e-3)]
    """Height of the crests [m]."""


def require_resolved_waves(roughness: Roughness, half_length: float) -> None:
    """Raise ValueError if every wave is shorter than the ellipse of this half-length [m], which
    averages it to zero.
    """
    if roughness.longest <= 2 * half_length:
        raise ValueError(
            f"roughness.longest = {roughness.longest:g}: must exceed the contact, "
            f"{2 * half_length:.3g} m long"
        )
