"""Elastic contact of the edge on the table: Hertz's ellipse, Mindlin's springs, Kalker's creep.

The edge has a fillet. Its contact on a plane is an ellipse between the principal radii r_f (the
fillet, across) and R/sin(beta) (the rim, along the rolling direction 1). As the inclination
decreases, the ellipse lengthens and its springs stiffen. The elliptic integrals are Carlson's,
which are regular from the circle to the line: J = (K - E)/e^2 = R_D(0, q^2, 1)/3 with q = b/a.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq
from scipy.special import elliprd, elliprf

from dynamics.compliant.law.kalker import creep_coefficients
from dynamics.disk import Disk

MAX_WIDTH_RATIO = 1 / 3
"""Largest ratio of the half-width of the ellipse to the fillet.

Above it, the bodies are no longer half spaces.
"""
MIN_CONTACT_INCLINATION = 5e-8
"""Inclination below which the contact is not one ellipse [rad]."""


class ElasticConstants(NamedTuple):
    """Isotropic half space: Young's modulus [Pa] and Poisson's ratio."""

    young: float
    poisson: float

    @property
    def shear(self) -> float:
        """Shear modulus [Pa]."""
        return self.young / (2 * (1 + self.poisson))


class ContactSprings(NamedTuple):
    """Linearised contact.

    It has stiffness [N/m] and relaxation length [m] along 1 and 2, and stiffness [N/m] along the
    normal.
    """

    k1: np.ndarray
    k2: np.ndarray
    kn: np.ndarray
    length1: np.ndarray
    length2: np.ndarray


@dataclass(frozen=True, kw_only=True)
class ContactLaw:
    """Contact law N = K(beta) delta^1.5 of a disk on a table, with loss, springs and creep.

    Attributes
    ----------
    disk : Disk
        The disk.
    fillet : float
        Radius of the fillet of its edge [m].
    body, table : ElasticConstants
        Materials of disk and table.
    loss_factor : float
        Loss factor of the normal contact resonance.

    Raises
    ------
    ValueError
        If the fillet does not fit the disk, or is too sharp for a half space.
    """

    disk: Disk
    fillet: float
    body: ElasticConstants
    table: ElasticConstants
    loss_factor: float = 0.02

    def __post_init__(self):
        largest = min(self.disk.radius, self.disk.thickness / 2)
        if not 0 < self.fillet <= largest:
            raise ValueError(
                f"contact.fillet = {self.fillet:g}: must be positive and at most {largest:g}, so "
                f"that it fits the disk"
            )
        if not self._excess(self.fillet) <= 0:
            sharp = f"contact.fillet = {self.fillet:g}: too sharp for an elastic contact"
            raise ValueError(f"{sharp}, {self._smallest_fillet_message(largest)}")

    def _smallest_fillet_message(self, largest):
        """Return a message with the smallest possible fillet, or that no fillet is possible."""
        if self._excess(largest) > 0:
            return f"as any up to {largest:g} is for bodies so soft, E* = {self.modulus:.3g} Pa, or so heavy"
        return f"must be at least {brentq(self._excess, 1e-12, largest):.3g}"

    def _excess(self, fillet):
        """Return the excess [m] of the contact width of an upright disk over the limit for a
        fillet.
        """
        return self._half_width(fillet) - MAX_WIDTH_RATIO * fillet

    def _half_width(self, fillet):
        """Return b [m] of an upright disk, the largest of a motion."""
        q, D, _ = _ellipse(self.disk.radius / fillet)
        return q * (self.disk.weight * D * self.disk.radius / (np.pi * self.modulus)) ** (1 / 3)

    @cached_property
    def modulus(self) -> float:
        """E* [Pa] of both bodies."""
        return 1 / sum((1 - m.poisson**2) / m.young for m in (self.body, self.table))

    @cached_property
    def mixed(self) -> ElasticConstants:
        """Material that gives, on both sides, the tangential compliance of the two bodies: Kalker
        (1990), (1.44).
        """
        G = 2 / sum(1 / m.shear for m in (self.body, self.table))
        poisson = G / 2 * sum(m.poisson / m.shear for m in (self.body, self.table))
        return ElasticConstants(2 * G * (1 + poisson), poisson)

    def ellipse(self, inclination):
        """Return q = b/a, D = R_D(0, q^2, 1) and F = R_F(0, q^2, 1) of the contact at inclinations
        (k,) [rad].
        """
        return _ellipse(self.disk.radius / (np.sin(inclination) * self.fillet))

    def curvature(self, inclination):
        """Return A = sin(beta)/2R [1/m]: the gap opens as A x^2 along the rolling direction."""
        return np.sin(inclination) / (2 * self.disk.radius)

    def stiffness(self, inclination):
        """Return K [N/m^1.5] of N = K delta^1.5 at inclinations (k,): Johnson (1985), (4.26)."""
        _, D, F = self.ellipse(inclination)
        return (
            2 * np.pi / 3 * self.modulus * np.sqrt(D / (3 * self.curvature(inclination))) / F**1.5
        )

    def stiffness_slope(self, inclination):
        """Return dK/d(beta) = -K cot(beta) D/(6 F), from the work of the gap at constant
        approach."""
        _, D, F = self.ellipse(inclination)
        return -self.stiffness(inclination) * D / (6 * F) / np.tan(inclination)

    def approach(self, inclination, load):
        """Return delta [m] under the normal force load [N]."""
        return (load / self.stiffness(inclination)) ** (2 / 3)

    def semi_axes(self, inclination, load):
        """Return a and b [m] of the ellipse under load [N]; a is along the rolling direction."""
        q, D, _ = self.ellipse(inclination)
        a = (load * D / (2 * np.pi * self.modulus * self.curvature(inclination))) ** (1 / 3)
        return a, q * a

    def springs(self, inclination, load) -> ContactSprings:
        """Return the linearised contact under load [N] at inclinations (k,) [rad].

        dN/d(delta) = 1.5 N/delta. A tangential force F displaces an ellipse without slip by F/(2 pi
        a) times the sum over both bodies of ((1 - nu) K + nu J)/G along a, and with K - J instead
        of J along b: Mindlin (1949). The spring relaxes over the length l for which steady creep
        u/V causes Kalker's force: k l = G a b C.
        """
        q, D, F = self.ellipse(inclination)
        a, b = self.semi_axes(inclination, load)
        k1, k2 = (
            2
            * np.pi
            * a
            / sum(((1 - m.poisson) * F + m.poisson * J) / m.shear for m in (self.body, self.table))
            for J in (D / 3, F - D / 3)
        )
        C = creep_coefficients(q, self.mixed.poisson)
        length = [self.mixed.shear * a * b * c / k for c, k in zip(C, (k1, k2), strict=True)]
        return ContactSprings(k1, k2, 1.5 * load / self.approach(inclination, load), *length)


def _ellipse(radii):
    """Solve Hertz's equation R_D(0, 1, q^2)/R_D(0, q^2, 1) = `radii`, the ratio of the principal
    radii, for q = b/a.
    """
    q = np.asarray(radii, dtype=float) ** (-2 / 3)
    for _ in range(22):  # each pass leaves at most a seventh of the error
        D = elliprd(0, q * q, 1)
        q = q * (elliprd(0, 1, q * q) / (D * radii)) ** (1 / 1.75)
    return q, elliprd(0, q * q, 1), elliprf(0, q * q, 1)
