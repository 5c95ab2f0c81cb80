"""Define tractions on a patch over the whole thickness and their work on a free disk.

The tractions are Chebyshev polynomials around the rim times Jacobi polynomials through
the thickness, with singular weights at the edges of the patch.
"""

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import eval_jacobi, eval_legendre, jv, roots_jacobi

from modal.modes import Support
from modal.spectral.basis import Plate

MAX_HALF_ANGLE_DEG = 170
"""Largest half angle of a patch [degrees]; for larger ones the free strip is too
narrow."""


def corner_exponent(poisson: float) -> float:
    """Return the exponent q - 1 of the tractions at a right-angled corner between held
    and free sides.

    There u ~ r^q, with 4 k sin(q pi/2)^2 = (k + 1)^2 - 4 q^2 and k = 3 - 4 poisson
    (Williams 1952).
    """
    k = 3 - 4 * max(poisson, 0.0)
    return (
        brentq(
            lambda q: 4 * k * np.sin(q * pi / 2) ** 2 - (k + 1) ** 2 + 4 * q**2,
            0.4,
            1.0,
        )
        - 1
    )


@dataclass(frozen=True, kw_only=True)
class BasisSizes:
    """Sizes of all bases of the synthesis."""

    size: tuple[int, int] = (10, 7)
    """Numbers of radial and axial polynomials of each order of the free disk."""
    highest_direct_order: int = 12
    """Highest order that is always solved directly."""
    highest_order: int = 600
    """Highest interpolated order."""
    circumferential_tractions: int = 5
    """Number of Chebyshev tractions around the rim, per component and parity."""
    thickness_tractions: int = 4
    """Number of Jacobi tractions through the thickness, per component and parity; at
    most the number of axial polynomials."""
    cutoff: float = 1.4
    """Highest frequency of the free modes, in units of the shear wave speed divided by
    the radius."""

    def __post_init__(self) -> None:
        if self.thickness_tractions > self.size[1]:
            raise ValueError(
                f"thickness_tractions = {self.thickness_tractions}: must not exceed the number of "
                f"axial functions of the basis, {self.size[1]}",
            )


@dataclass(frozen=True, kw_only=True)
class PatchTractions:
    """Tractions on a patch: Chebyshev polynomials around the rim times Jacobi
    polynomials through the thickness."""

    plate: Plate
    support: Support
    richness: BasisSizes

    def __post_init__(self) -> None:
        support = self.support
        has_full_height = support.height in (None, self.plate.thickness)
        is_narrow = support.half_angle_deg <= MAX_HALF_ANGLE_DEG
        if support.kind != "patch" or not has_full_height or not is_narrow:
            raise ValueError(
                "synthesis requires a patch over the whole thickness with a half angle of at most "
                f"{MAX_HALF_ANGLE_DEG} degrees"
            )

    def circumferential_work(self, n: np.ndarray, y: int) -> np.ndarray:
        """Return the work (3, k, J) [m] of circumferential tractions on waves around
        the rim.

        The waves are cos n theta or sin n theta of orders n (k,); the symmetry y (1 or
        -1) selects the tractions. The first index is the component: radial, tangential,
        axial. The integral of T_j(theta/a)/sqrt(1 - (theta/a)^2) is pi a (-1)^(j/2)
        J_j(n a) with cos n theta (j even) and pi a (-1)^((j-1)/2) J_j(n a) with sin n
        theta (j odd). The sine partner of a free mode has u_theta ~ -cos n theta.
        """
        angle = np.deg2rad(self.support.half_angle_deg)
        j = np.arange(self.richness.circumferential_tractions)
        cosine = (-1.0) ** j * jv(2 * j, n[:, None] * angle)
        sine = (-1.0) ** j * jv(2 * j + 1, n[:, None] * angle)
        radial, tangential = (cosine, sine) if y > 0 else (sine, -cosine)
        return pi * angle * self.plate.radius * np.stack([radial, tangential, radial])

    def axial_work(self, even: int) -> np.ndarray:
        """Return the work (3, L, nz) [m] of tractions through the thickness on axial
        polynomials.

        The polynomials are the Legendre polynomials of the free disk. Near the faces
        the radial and axial tractions vary as distance^p with p = `corner_exponent`.
        The tangential traction is finite.
        """
        m = np.arange(self.richness.size[1])[:, None]
        l = np.arange(self.richness.thickness_tractions)[:, None]
        corner = corner_exponent(self.plate.material.poisson)
        work = []
        for odd, power in ((even < 0, corner), (even < 0, 0.0), (even > 0, corner)):
            points = 2 * self.richness.size[1] + 2 * self.richness.thickness_tractions
            zeta, weight = roots_jacobi(points, power, power)
            traction = eval_jacobi(2 * l + odd, power, power, zeta) * weight
            work.append(traction @ eval_legendre(2 * m + odd, zeta).T)
        return np.stack(work) * self.plate.thickness / 2

    @property
    def held(self) -> list[int]:
        """Indices of the held components among radial, tangential, axial."""
        components = ("radial", "tangential", "axial")
        return [i for i, name in enumerate(components) if name in self.support.held]
