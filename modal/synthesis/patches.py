"""A disk on a patch by synthesis: modes of the free disk, the flexibility of those left out, tractions on the patch.

With q the free modes, -p the tractions and B their work, (Omega^2 - w^2) q + B^T p = 0 and B q = (F + w^2 G) p, F and
w^2 G being the flexibility of the modes left out to the first order in w^2. With P = F^-1 B to the same order
(Omega^2 + P^T F P) q = w^2 (1 + P^T G P) q (MacNeal 1971, Rubin 1975). For the tractions see `tractions`.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline
from scipy.linalg import cholesky, eigh, solve_triangular

from modal.elements.elastic import lame
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_held
from modal.modes import Support
from modal.spectral.basis import Plate, problem, rigid_count
from modal.spectral.ritz import matrices
from modal.synthesis.held import HeldClass, held_class
from modal.synthesis.tractions import STANDARD, Patch, Richness


@dataclass(frozen=True, kw_only=True)
class Order:
    """One order n and symmetry in z of the free disk, seen at the rim as Legendre coefficients of (u_r, u_theta, u_z).

    values (k,) [1/s^2] and shapes (3 nz, k) of the kept modes, rigid ones first with value 0. Of all others rest
    (3, 3 nz, 3 nz) is the static flexibility [m/N], its slope over w^2 [m s^2/N], and what the highest polynomials of
    the basis contribute to it [m/N].
    """

    values: np.ndarray
    shapes: np.ndarray
    rest: np.ndarray


def at_rim(p, size):
    """S (3 nz, N): Legendre coefficients of (u_r, u_theta, u_z) at the rim, where every radial function is 1."""
    return np.hstack([np.kron(np.array(t.share, float)[:, None], np.tile(np.eye(size[1]), size[0])) for t in p.terms])


BEYOND = 2.6
"""Flexibility of all polynomials that the basis lacks over what its highest ones contribute: it falls slowly, because
rim and faces meet at a corner."""


def free_order(plate, p, size, cutoff) -> Order:
    """The `Order` of a problem; nothing is kept if cutoff [Hz] is 0.

    The factor of the stiffness has the highest polynomials last, so that its rows say what they contribute.
    """
    last = np.zeros((len(p.terms), *size), bool)
    last[:, -1], last[:, :, -1] = True, True
    turn = np.argsort(last.ravel(), kind="stable")
    k, m = (a[np.ix_(turn, turn)] for a in matrices(plate, p, size))
    rim, limit, rigid = at_rim(p, size)[:, turn], (2 * pi * cutoff) ** 2, rigid_count(plate, p) if cutoff else 0
    values, vectors = eigh(k, m, subset_by_value=(-np.inf, limit)) if cutoff else (np.zeros(0), np.zeros((len(k), 0)))
    values[:rigid] = 0.0
    still = m @ vectors[:, :rigid]
    factor = cholesky(k + limit * still @ still.T, lower=True)
    half = solve_triangular(factor, rim.T, lower=True)
    shapes, highest = rim @ vectors, half[-np.count_nonzero(last) :]
    weighted = shapes / np.where(values > 0, values, limit)
    beyond = highest.T @ highest
    static = half.T @ half - weighted @ shapes.T + BEYOND * beyond
    left = solve_triangular(factor, half, lower=True, trans=1) - vectors @ weighted.T
    slope = left.T @ m @ left
    return Order(values=values, shapes=shapes, rest=np.stack([static, slope, beyond]))


LONGEST = 15
"""Most tractions around that are added where a patch is longer than high: they vary within a thickness of its ends."""


@dataclass(frozen=True, kw_only=True)
class FreeDisk:
    """Everything about the free disk that patches need; the first patch pays for it, further ones do not.

    plate -- `Plate` with a free edge.  richness -- `Richness`.
    """

    plate: Plate
    richness: Richness = STANDARD

    def __post_init__(self):
        if self.plate.edge != "free" or self.plate.inner_radius or self.plate.ring_stiffness:
            raise ValueError("synthesis is for a solid plate with a free edge and no ring")

    @property
    def cutoff(self) -> float:
        """Frequency [Hz] up to which free modes are kept."""
        return self.richness.cutoff * (lame(self.plate.material)[1] / self.plate.density) ** 0.5 / self.plate.radius

    @cached_property
    def kept(self) -> dict:
        """(n, even, torsional) -> `Order` of every order that has modes below the cutoff, and of all up to `direct`."""
        orders, n, more = {}, 0, True
        while more or n <= self.richness.direct:
            more = False
            for even, torsional in ((1, False), (-1, False), (1, True), (-1, True))[: 2 if n else 4]:
                p = problem(self.plate, n, even, torsional)
                orders[n, even, torsional] = free_order(self.plate, p, self.richness.size, self.cutoff)
                more = more or len(orders[n, even, torsional].values) > 0
            n += 1
        return orders

    @cached_property
    def high(self) -> dict:
        """even -> (orders (k,), rest (k, 3, 3 nz, 3 nz)) of orders beyond the kept ones, interpolated.

        Flexibilities fall as 1/n and rates rise as n.
        """
        last = max(n for n, _, _ in self.kept)
        top = self.richness.top
        some = np.unique(np.rint(np.geomspace(last, max(top, 2 * last), 14)).astype(int))
        every, result = np.arange(last + 1, some[-1] + 1), {}
        for even in (1, -1):
            rest = [free_order(self.plate, problem(self.plate, n, even), self.richness.size, 0.0).rest for n in some]
            falls = [n[:, None, None, None] ** -np.array([1.0, 3.0, 1.0])[:, None, None] for n in (some, every)]
            result[even] = every, CubicSpline(np.log(some), rest / falls[0])(np.log(every)) * falls[1]
        return result

    @property
    def nz(self) -> int:
        """Count of Legendre polynomials of one parity."""
        return self.richness.size[1]

    def frequencies(self, support: Support, below: float) -> np.ndarray:
        """Frequencies (m,) [Hz] below `below` [Hz] of the disk held on a patch (`Support`), all classes, ascending.

        ValueError where the patch is not over the whole thickness, or leaves a rigid body free to move.
        """
        return np.sort(np.concatenate([c.frequency[c.frequency < below] for c in self.held(support, below)]))

    def held(self, support: Support, below: float, angle: ArrayLike = ()) -> list[HeldClass]:
        """The `HeldClass` of every symmetry class, in the order of `modal.mesh.symmetry.classes`; see `frequencies`."""
        longer = min(LONGEST, int(0.7 * np.deg2rad(support.half_angle_deg) * self.plate.radius / self.plate.thickness))
        richness = replace(self.richness, around=self.richness.around + longer)
        patch = Patch(plate=self.plate, support=support, richness=richness)
        check_held(patch_edge(self.plate.radius, self.plate.thickness, support), support.held)
        angle = np.asarray(angle, float)
        return [held_class(self, patch, y, even, below, angle) for y in (1, -1) for even in (1, -1)]
