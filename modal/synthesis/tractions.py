"""The tractions on a patch over the whole thickness, and the work they do on a free disk.

They are Chebyshev polynomials around and Jacobi polynomials through the thickness, over the square roots that the edges
of the patch ask for.
"""

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.optimize import brentq
from scipy.special import eval_jacobi, eval_legendre, jv, roots_jacobi

from modal.modes import Support
from modal.spectral.basis import Plate


def corner_exponent(poisson):
    """Exponent of the tractions at a right corner of held and free sides: with u ~ r^q, k = 3 - 4 poisson
    4 k sin(q pi/2)^2 = (k + 1)^2 - 4 q^2 (Williams 1952)."""
    k = 3 - 4 * max(poisson, 0.0)
    return brentq(lambda q: 4 * k * np.sin(q * pi / 2) ** 2 - (k + 1) ** 2 + 4 * q**2, 0.4, 1.0) - 1


WIDEST = 170
"""Half angle [degrees] beyond which the strip left free is too narrow for tractions."""


@dataclass(frozen=True, kw_only=True)
class Richness:
    """How many: basis (radial, axial) of a free order, orders up to `direct` solved one by one and up to `top`
    interpolated, Chebyshev (around) and Jacobi (through) tractions per component and parity, modes up to `cutoff` times
    the speed of shear waves over the radius.

    ValueError if `through` is more than the axial count: the basis could not tell so many tractions apart.
    """

    size: tuple[int, int] = (10, 7)
    direct: int = 12
    top: int = 600
    around: int = 5
    through: int = 4
    cutoff: float = 1.4

    def __post_init__(self):
        if self.through > self.size[1]:
            raise ValueError(f"through = {self.through} is more than the {self.size[1]} axial functions of the basis")


STANDARD = Richness()


@dataclass(frozen=True, kw_only=True)
class Patch:
    """The tractions on a patch: Chebyshev polynomials around times Jacobi polynomials through the thickness."""

    plate: Plate
    support: Support
    richness: Richness

    def __post_init__(self):
        support, thickness = self.support, self.plate.thickness
        if support.kind != "patch" or support.height not in (None, thickness) or support.half_angle_deg > WIDEST:
            raise ValueError(
                f"synthesis is for a patch over the whole thickness and at most {WIDEST} degrees to either side"
            )

    def around(self, n, y):
        """Work (3, k, J) of cos n theta or sin n theta with radial, tangential, axial tractions of the class y [m].

        The integral of T_j(theta/a)/sqrt(1 - (theta/a)^2) with cos n theta is pi a (-1)^(j/2) J_j(n a), j even; with
        sin n theta pi a (-1)^((j-1)/2) J_j(n a), j odd. The sine partner of a free mode has u_theta ~ -cos n theta.
        """
        angle = np.deg2rad(self.support.half_angle_deg)
        j = np.arange(self.richness.around)
        cosine = (-1.0) ** j * jv(2 * j, n[:, None] * angle)
        sine = (-1.0) ** j * jv(2 * j + 1, n[:, None] * angle)
        plane, swirl = (cosine, sine) if y > 0 else (sine, -cosine)
        return pi * angle * self.plate.radius * np.stack([plane, swirl, plane])

    def through(self, even):
        """Work (3, L, nz) of Legendre's polynomials of the free disk with the tractions through the thickness [m].

        At the faces the radial and axial ones go as distance^p, p = `corner_exponent`, the tangential one is finite.
        """
        m, l = np.arange(self.richness.size[1])[:, None], np.arange(self.richness.through)[:, None]
        work, corner = [], corner_exponent(self.plate.material.poisson)
        for odd, power in ((even < 0, corner), (even < 0, 0.0), (even > 0, corner)):
            zeta, weight = roots_jacobi(2 * self.richness.size[1] + 2 * self.richness.through, power, power)
            traction = eval_jacobi(2 * l + odd, power, power, zeta) * weight
            work.append(traction @ eval_legendre(2 * m + odd, zeta).T)
        return np.stack(work) * self.plate.thickness / 2

    @property
    def held(self):
        """Indices of the held components among radial, tangential, axial."""
        return [i for i, name in enumerate(("radial", "tangential", "axial")) if name in self.support.held]
