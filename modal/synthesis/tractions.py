"""The tractions on a patch over the whole thickness, and the work they do on a free disk.

They are Chebyshev polynomials around and Jacobi polynomials through the thickness, with the
singular weights of the patch edges.
"""

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import eval_jacobi, eval_legendre, jv, roots_jacobi

from modal.modes import Support
from modal.spectral.basis import Plate

MAX_HALF_ANGLE_DEG = 170
"""Largest half angle of a patch [degrees]: beyond it the free strip is too narrow for these
tractions."""


def corner_exponent(poisson):
    """Return the exponent q - 1 of the tractions at a right corner of held and free sides, where u
    ~ r^q.

    With k = 3 - 4 poisson, 4 k sin(q pi/2)^2 = (k + 1)^2 - 4 q^2 (Williams 1952).
    """
    k = 3 - 4 * max(poisson, 0.0)
    return brentq(lambda q: 4 * k * np.sin(q * pi / 2) ** 2 - (k + 1) ** 2 + 4 * q**2, 0.4, 1.0) - 1


@dataclass(frozen=True, kw_only=True)
class Richness:
    """The sizes of all bases of the synthesis."""

    size: tuple[int, int] = (10, 7)
    """Radial and axial polynomials of each order of the free disk."""
    direct: int = 12
    """Highest order that is always solved by itself."""
    top: int = 600
    """Highest order of the interpolation."""
    around: int = 5
    """Chebyshev tractions around, per component and parity."""
    through: int = 4
    """Jacobi tractions through the thickness, per component and parity; at most the axial
    polynomials."""
    cutoff: float = 1.4
    """Highest frequency of the free modes, in units of shear wave speed divided by radius."""

    def __post_init__(self):
        if self.through > self.size[1]:
            raise ValueError(
                f"through = {self.through} is more than the {self.size[1]} axial functions of the "
                f"basis",
            )


DEFAULT_BASIS_SIZES = Richness()
"""Default sizes of the bases."""


@dataclass(frozen=True, kw_only=True)
class PatchTractions:
    """The tractions on a patch: Chebyshev polynomials around times Jacobi polynomials through the
    thickness."""

    plate: Plate
    support: Support
    richness: Richness

    def __post_init__(self):
        support = self.support
        has_full_height = support.height in (None, self.plate.thickness)
        is_narrow = support.half_angle_deg <= MAX_HALF_ANGLE_DEG
        if support.kind != "patch" or not has_full_height or not is_narrow:
            raise ValueError(
                "synthesis is for a patch over the whole thickness and at most "
                f"{MAX_HALF_ANGLE_DEG} degrees to either side"
            )

    def circumferential_work(self, n, y):
        """Return the work (3, k, J) [m] of tractions around the patch on circumferential waves.

        The waves are cos n theta or sin n theta; the symmetry y (1 or -1) selects the tractions.
        The first
        index is radial, tangential, axial. The integral of T_j(theta/a)/sqrt(1 - (theta/a)^2) is pi
        a
        (-1)^(j/2) J_j(n a) with cos n theta (j even) and pi a (-1)^((j-1)/2) J_j(n a) with sin n
        theta (j
        odd). The sine partner of a free mode has u_theta ~ -cos n theta.
        """
        angle = np.deg2rad(self.support.half_angle_deg)
        j = np.arange(self.richness.around)
        cosine = (-1.0) ** j * jv(2 * j, n[:, None] * angle)
        sine = (-1.0) ** j * jv(2 * j + 1, n[:, None] * angle)
        radial, tangential = (cosine, sine) if y > 0 else (sine, -cosine)
        return pi * angle * self.plate.radius * np.stack([radial, tangential, radial])

    def axial_work(self, even):
        """Return the work (3, L, nz) [m] of tractions through the thickness on axial polynomials.

        The polynomials are the Legendre polynomials of the free disk. Near the faces the radial and
        axial
        tractions vary as distance^p with p = `corner_exponent`. The tangential traction is finite.
        """
        m = np.arange(self.richness.size[1])[:, None]
        l = np.arange(self.richness.through)[:, None]
        corner = corner_exponent(self.plate.material.poisson)
        work = []
        for odd, power in ((even < 0, corner), (even < 0, 0.0), (even > 0, corner)):
            points = 2 * self.richness.size[1] + 2 * self.richness.through
            zeta, weight = roots_jacobi(points, power, power)
            traction = eval_jacobi(2 * l + odd, power, power, zeta) * weight
            work.append(traction @ eval_legendre(2 * m + odd, zeta).T)
        return np.stack(work) * self.plate.thickness / 2

    @property
    def held(self):
        """Indices of the held components among radial, tangential, axial."""
        components = ("radial", "tangential", "axial")
        return [i for i, name in enumerate(components) if name in self.support.held]
