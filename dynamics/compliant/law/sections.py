"""The sections `contact`, `roughness` and `imperfection` of a scene."""

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Annotated, Any, Literal

from annotated_types import Ge, Gt, Le, Lt

if TYPE_CHECKING:
    from dynamics.compliant.law.hertz_mindlin import ContactLaw
    from dynamics.compliant.law.linearised import Suspension

MAX_PROFILE_CELLS = 2**24
"""Largest number of cells in a height profile."""
MAX_SPECTRUM_EXPONENT = 16.0
"""Largest exponent of a power spectrum."""
LOWEST_WAVINESS_ORDER = 2
"""Lowest order of waves around the rim; order 1 would be a tilt of the table."""
Length = Annotated[float, Gt(0), Le(100)]


@dataclass(frozen=True, kw_only=True)
class Contact:
    """Contact of edge and table: rigid or elastic (Hertz, Mindlin, Kalker)."""

    law: Literal["rigid", "elastic"] = "rigid"
    """Contact law: rigid (event-driven solution) or elastic (with contact resonances)."""
    fillet: Length | None = None
    """Radius of the rounded edge [m], at most half the thickness; default: an eighth of
    the thickness."""
    loss_factor: Annotated[float, Ge(0), Lt(1)] = 0.02
    """Loss factor of the normal contact resonance: energy lost per radian divided by
    the energy."""
    restitution: Annotated[float, Ge(0.05), Lt(1)] | None = None
    """Coefficient of restitution of a rigid disk hitting the table with its edge, in
    place of loss_factor; requires numerics.contact = "many"."""
    body: Literal["elastic", "rigid"] = "elastic"
    """Whether a solid disk is rigid or deforms as a whole, in series with the contact
    springs; with two-way coupling its modes below 20 kHz vibrate."""
    young: Annotated[float, Ge(1), Le(1e15)] = 60e9
    """Young's modulus of the table at the contact [Pa]; default: granite."""
    poisson: Annotated[float, Gt(-1), Lt(0.5)] = 0.2
    """Poisson's ratio of the table."""

    def rolling_fillet(self, disk: Any) -> float:
        """Return the radius of the edge [m] on which a disk rolls; 0 for a sharp edge.

        A rigid contact uses only a given fillet, an elastic one also the default
        fillet.
        """
        return self.fillet or 0.0 if self.law == "rigid" else self.elastic_fillet(disk)

    def elastic_fillet(self, disk: Any) -> float:
        """Return the radius of the edge [m] that determines the elastic stiffness."""
        # default: 1.6 mm for the thickness 12.8 mm of the toy
        return self.fillet or min(disk.thickness / 8, float(disk.radius))

    def check_fillet(self, disk: Any) -> None:
        """Raise ValueError if the fillet does not fit the disk."""
        largest = min(disk.radius, disk.thickness / 2)
        if not self.rolling_fillet(disk) <= largest:
            raise ValueError(
                f"contact.fillet = {self.fillet:g}: must be positive and at most {largest:g}, so "
                f"that it fits the disk"
            )

    def contact_law(self, disk: Any, body: Any) -> "ContactLaw":
        """Return the `ContactLaw` of a disk with the elastic constants of `body`.

        Raises ValueError if the fillet does not fit the disk.
        """
        from dynamics.compliant.law.hertz_mindlin import (  # loads SciPy
            ContactLaw,
            ElasticConstants,
        )

        return ContactLaw(
            disk=disk,
            fillet=self.elastic_fillet(disk),
            body=ElasticConstants(body.young, body.poisson),
            table=ElasticConstants(self.young, self.poisson),
            loss_factor=self.loss_factor,
            rolls_sharply=not self.rolling_fillet(disk),
        )

    def pivoting_polynomials(self, disk: Any, body: Any) -> tuple[float, ...]:
        """Return the coefficients of `pivoting_arm` for a disk of the material `body`."""
        from dynamics.compliant.law.spin_friction import (
            pivoting_polynomials,
        )  # loads SciPy

        return pivoting_polynomials(self.contact_law(disk, body))

    def suspension(self, scene: Any, inclination: float) -> "Suspension":
        """Return the `Suspension` of the disk of a scene at an inclination [rad].

        It applies to both contact laws. Raises ValueError if the fillet does not fit,
        or if there is no steady motion.
        """
        from dynamics.compliant.law.linearised import suspension

        return suspension(self.contact_law(scene.disk, scene.material), inclination)


class SwitchedContact(Contact):
    """Elastic contact after the switch from a rigid one, with the same rolling fillet."""

    def rolling_fillet(self, disk: Any) -> float:
        return self.fillet or 0.0


@dataclass(frozen=True, kw_only=True)
class Roughness:
    """Heights of table and edge: measured, or Gaussian with a spectrum k^-exponent.

    They are averaged over the ellipse of an elastic contact and do not affect a rigid
    one.
    """

    rms: Annotated[float, Gt(0), Le(1)] | None = None
    """Root mean square height of the table [m], before averaging over the contact."""
    rms_edge: Annotated[float, Ge(0), Le(1)] | None = None
    """Root mean square height of the edge [m], 0 for a smooth edge; default: that of the table."""
    shortest: Length = 1e-4
    """Shortest wavelength [m]."""
    longest: Length = 0.1
    """Longest wavelength [m]."""
    exponent: Annotated[float, Ge(0), Le(MAX_SPECTRUM_EXPONENT)] = 0.0
    """Exponent p of the power spectrum k^-p over the wavenumber k."""
    loss: Literal["own", "fitted"] = "own"
    """Energy loss due to roughness: "own" adds it to the friction of the scene; "fitted"
    assumes that the friction was measured on such a surface and includes it."""
    seed: Annotated[int, Ge(0), Le(10**9)] = 0
    """Seed of the random heights; equal seeds give equal heights."""
    grain: bool = False
    """Whether the table is ruled, with a height that varies only along x; requires a
    rattling disk."""
    profile: str | None = None
    """Path of a CSV file with lengths and heights [m] measured on the table, in place of rms."""
    profile_edge: str | None = None
    """Path of a CSV file measured along the edge, in place of rms_edge."""

    def __post_init__(self) -> None:
        if self.rms is None and self.profile is None:
            raise ValueError("give either rms or profile")
        if self.rms is not None and self.profile is not None:
            raise ValueError(
                "give either rms or profile, not both; for the edge use rms_edge or profile_edge"
            )
        if self.rms is not None and not 0 < self.rms < inf:
            raise ValueError(
                f"roughness.rms = {self.rms:g}: must be positive and finite"
            )
        if self.profile_edge is not None and self.rms_edge is not None:
            raise ValueError("give either rms_edge or profile_edge")
        if not 0 < self.shortest < inf:
            raise ValueError(
                f"roughness.shortest = {self.shortest:g}: must be positive and finite"
            )
        if not self.shortest < self.longest < inf:
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must exceed shortest = {self.shortest:g} "
                f"and be finite"
            )
        if not 0 <= self.exponent <= MAX_SPECTRUM_EXPONENT:
            raise ValueError(
                f"roughness.exponent = {self.exponent:g}: must be from 0 to "
                f"{MAX_SPECTRUM_EXPONENT:g}"
            )
        if self.needed_profile_cells > MAX_PROFILE_CELLS:
            most = (
                MAX_PROFILE_CELLS
                / self.needed_profile_cells
                * self.longest
                / self.shortest
            )
            raise ValueError(
                f"roughness.longest = {self.longest:g}: must be at most {most:g} times shortest = "
                f"{self.shortest:g}"
            )

    @property
    def cell(self) -> float:
        """Length of a cell of a random profile [m].

        Waves are accurate to 3e-4 if the half-length of the contact is at least one cell.
        """
        cells_per_wave = 8  # of the shortest wavelength
        return self.shortest / cells_per_wave

    @property
    def needed_profile_cells(self) -> float:
        """Number of cells required by the longest waves in the period of the table."""
        min_waves_per_period = 64
        return min_waves_per_period * self.longest / self.cell

    @property
    def edge_rms(self) -> float:
        """Root mean square height of the edge [m]; 0 for a smooth or measured edge."""
        if self.profile_edge is not None:
            return 0.0
        return (self.rms or 0.0) if self.rms_edge is None else self.rms_edge


@dataclass(frozen=True, kw_only=True)
class Imperfection:
    """A rigid table with waves amplitude cos(order angle) on the contact circle."""

    order: Annotated[int, Ge(LOWEST_WAVINESS_ORDER), Le(64)] = LOWEST_WAVINESS_ORDER
    """Number of waves around the contact circle."""
    amplitude: Annotated[float, Gt(0), Le(1e-3)]
    """Height of the crests [m]."""


def require_resolved_waves(roughness: Roughness, half_length: float) -> None:
    """Raise ValueError if no wave is longer than the ellipse of this half-length [m]."""
    if roughness.longest <= 2 * half_length:
        raise ValueError(
            f"roughness.longest = {roughness.longest:g}: must exceed the length of the "
            f"contact, {2 * half_length:.3g} m"
        )
