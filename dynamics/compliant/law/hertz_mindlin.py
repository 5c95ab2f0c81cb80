"""Elastic contact of the edge: Hertz's ellipse, Mindlin's springs, Kalker's creep.

The principal radii of the rounded edge are that of the fillet across, and R/sin(beta)
along the rolling direction 1, where R is the distance of the contact from the axis. As
the inclination decreases, the contact ellipse lengthens and its springs stiffen.
Carlson's elliptic integrals are regular from a circle to a line: J = (K - E)/e^2 =
R_D(0, q^2, 1)/3 with q = b/a.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq
from scipy.special import elliprd, elliprf

from dynamics.compliant.law.kalker import creep_coefficients
from dynamics.disk import Disk
from dynamics.kinematics import ContactPlace, contact_place_in_metres

MIN_CONTACT_INCLINATION = 5e-8
"""Inclination [rad] below which the contact is no longer a single ellipse."""


class ElasticConstants(NamedTuple):
    """Isotropic half space: Young's modulus [Pa] and Poisson's ratio."""

    young: float
    poisson: float

    @property
    def shear(self) -> float:
        """Shear modulus [Pa]."""
        return self.young / (2 * (1 + self.poisson))


class ContactSprings(NamedTuple):
    """Linearised contact springs.

    They have stiffnesses k1, k2 [N/m] and relaxation lengths [m] along 1 and 2, and the
    stiffness kn [N/m] along the normal.
    """

    k1: np.ndarray
    k2: np.ndarray
    kn: np.ndarray
    length1: np.ndarray
    length2: np.ndarray


@dataclass(frozen=True, kw_only=True)
class ContactLaw:
    """Contact law N = K(beta) delta^1.5 of a disk on a table, with loss and creep.

    Attributes
    ----------
    disk : Disk
        The disk.
    fillet : float
        Radius of the rounded edge [m].
    body, table : ElasticConstants
        Materials of disk and table.
    loss_factor : float
        Loss factor of the normal contact resonance.
    rolls_sharply : bool
        True if the disk rolls on a sharp edge, and the fillet determines only the
        stiffness.

    Raises
    ------
    ValueError
        If the fillet does not fit the disk, or is too sharp for the approximation by
        half spaces.
    """

    disk: Disk
    fillet: float
    body: ElasticConstants
    table: ElasticConstants
    loss_factor: float
    rolls_sharply: bool = False

    def __post_init__(self) -> None:
        largest = min(self.disk.radius, self.disk.thickness / 2)
        if not 0 < self.fillet <= largest:
            raise ValueError(
                f"contact.fillet = {self.fillet:g}: must be positive and at most {largest:g}, so "
                f"that it fits the disk"
            )
        if not self._half_width_over_limit(self.fillet) <= 0:
            sharp = (
                f"contact.fillet = {self.fillet:g}: too sharp for an elastic contact"
            )
            raise ValueError(f"{sharp}, {self._smallest_fillet_message(largest)}")

    def _smallest_fillet_message(self, largest: float) -> str:
        """Return the part of an error message that states the smallest possible fillet."""
        if self._half_width_over_limit(largest) > 0:
            return (
                f"as is any fillet up to {largest:g} for this weight and this modulus, "
                f"E* = {self.modulus:.3g} Pa"
            )
        return f"must be at least {brentq(self._half_width_over_limit, 1e-12, largest):.3g}"

    def _half_width_over_limit(self, fillet: float) -> Any:
        """Return the excess [m] of the half-width b over its limit for a fillet.

        The half-width of an upright disk is the largest in a motion.
        """
        # ratio of half-width to fillet up to which the bodies are similar to half spaces
        max_width_ratio = 1 / 3
        disk = self.disk
        q, D, _ = _ellipse(disk.radius / fillet)
        half_length = (disk.weight * D * disk.radius / (np.pi * self.modulus)) ** (
            1 / 3
        )
        return q * half_length - max_width_ratio * fillet

    @property
    def rolling_fillet(self) -> float:
        """Radius of the edge [m] on which the disk rolls; 0 for a sharp edge."""
        return 0.0 if self.rolls_sharply else self.fillet

    @cached_property
    def modulus(self) -> float:
        """Contact modulus E* [Pa] of both bodies."""
        return 1 / sum((1 - m.poisson**2) / m.young for m in (self.body, self.table))

    @cached_property
    def equivalent_material(self) -> ElasticConstants:
        """Material equivalent to both bodies in tangential compliance.

        See Kalker (1990), (1.44).
        """
        G = 2 / sum(1 / m.shear for m in (self.body, self.table))
        poisson = G / 2 * sum(m.poisson / m.shear for m in (self.body, self.table))
        return ElasticConstants(2 * G * (1 + poisson), poisson)

    def place(self, inclination: ArrayLike) -> ContactPlace:
        """Return the position of the contact on the disk at inclinations (k,) [rad], in m."""
        cosine, sine = np.cos(inclination), np.sin(inclination)
        return contact_place_in_metres(self.disk, self.rolling_fillet, cosine, sine)

    def ellipse(
        self, inclination: ArrayLike
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return q = b/a, D = R_D(0, q^2, 1) and F = R_F(0, q^2, 1), (k,) each."""
        return _ellipse(1 / (2 * self.curvature(inclination) * self.fillet))

    def curvature(self, inclination: ArrayLike) -> np.ndarray:
        """Return A = sin(beta)/2R [1/m] in the gap A x^2 along the rolling direction.

        R is the distance of the contact from the axis.
        """
        return np.sin(inclination) / (2 * self.place(inclination).radius)

    def stiffness(self, inclination: ArrayLike) -> np.ndarray:
        """Return K (k,) [N/m^1.5] in N = K delta^1.5; Johnson (1985), (4.26)."""
        _, D, F = self.ellipse(inclination)
        root = np.sqrt(D / (3 * self.curvature(inclination)))
        return 2 * np.pi / 3 * self.modulus * root / F**1.5

    def approach(self, inclination: ArrayLike, load: Any) -> np.ndarray:
        """Return the approach delta [m] under a normal force `load` [N]."""
        return (load / self.stiffness(inclination)) ** (2 / 3)

    def semi_axes(
        self, inclination: ArrayLike, load: Any
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the semi-axes a (along the rolling direction) and b [m]."""
        q, D, _ = self.ellipse(inclination)
        a = (load * D / (2 * np.pi * self.modulus * self.curvature(inclination))) ** (
            1 / 3
        )
        return a, q * a

    def springs(self, inclination: ArrayLike, load: Any) -> ContactSprings:
        """Return the linearised contact under a load [N] at inclinations (k,) [rad].

        dN/d(delta) = 1.5 N/delta. A tangential force F displaces an ellipse without
        slip by F/(2 pi a) times the sum over both bodies of ((1 - nu) K + nu J)/G along
        a, and with K - J instead of J along b: Mindlin (1949). The spring relaxes over
        the length l for which steady creep u/V causes Kalker's force: k l = G a b C.
        """
        q, D, F = self.ellipse(inclination)
        a, b = self.semi_axes(inclination, load)

        def stiffness(J: np.ndarray) -> np.ndarray:
            return (2 * np.pi * a) / sum(
                ((1 - m.poisson) * F + m.poisson * J) / m.shear
                for m in (self.body, self.table)
            )

        k1 = stiffness(D / 3)
        k2 = stiffness(F - D / 3)
        kn = 1.5 * load / self.approach(inclination, load)
        both = self.equivalent_material
        C1, C2 = creep_coefficients(q, both.poisson)
        shear_area = both.shear * a * b
        return ContactSprings(k1, k2, kn, shear_area * C1 / k1, shear_area * C2 / k2)


def _ellipse(radii: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return q = b/a, D and F for `radii`, the ratio of the principal radii."""
    radii = np.asarray(radii, dtype=float)
    return _ellipse_of_bytes(radii.tobytes(), radii.shape)


@lru_cache(maxsize=32)  # stiffness, axes and springs need it at the same inclinations
def _ellipse_of_bytes(
    content: bytes, shape: tuple[int, ...]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return `_ellipse` for the bytes of the radii.

    Hertz's equation is R_D(0, 1, q^2)/R_D(0, q^2, 1) = `radii`.
    """
    radii = np.frombuffer(content).reshape(shape)
    q = radii ** (-2 / 3)
    for _ in range(22):  # each iteration reduces the error at least sevenfold
        D = elliprd(0, q * q, 1)
        q = q * (elliprd(0, 1, q * q) / (D * radii)) ** (1 / 1.75)
    found = q, elliprd(0, q * q, 1), elliprf(0, q * q, 1)
    for array in found:
        np.asarray(array).flags.writeable = False
    return found
