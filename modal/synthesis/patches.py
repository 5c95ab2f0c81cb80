"""A disk on a patch by synthesis: modes of the free disk, the flexibility of those left out, tractions on the patch.

With q the free modes, p the tractions and B their work, (Omega^2 - w^2) q = B^T p and B q + F p = 0, where F is the
static flexibility of the modes left out; so (Omega^2 + B^T F^-1 B) q = w^2 q. For the tractions see `tractions`.
"""

from dataclasses import dataclass
from functools import cached_property
from math import pi

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import block_diag, cho_factor, cho_solve, eigh

from modal.elements.elastic import lame
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_held
from modal.modes import Support
from modal.spectral.basis import Plate, problem, rigid_count
from modal.spectral.ritz import matrices
from modal.synthesis.tractions import STANDARD, Patch, Richness


@dataclass(frozen=True, kw_only=True)
class Order:
    """One order n and symmetry in z of the free disk, seen at the rim as Legendre coefficients of (u_r, u_theta, u_z).

    values (k,) [1/s^2] and shapes (3 nz, k) of the kept modes, rigid ones first with value 0; rest (3 nz, 3 nz) [m/N]
    is the static flexibility of all others.
    """

    values: np.ndarray
    shapes: np.ndarray
    rest: np.ndarray


def at_rim(p, size):
    """S (3 nz, N): Legendre coefficients of (u_r, u_theta, u_z) at the rim, where every radial function is 1."""
    return np.hstack([np.kron(np.array(t.share, float)[:, None], np.tile(np.eye(size[1]), size[0])) for t in p.terms])


def free_order(plate, p, size, cutoff) -> Order:
    """The `Order` of a problem; nothing is kept if cutoff [Hz] is 0."""
    k, m = matrices(plate, p, size)
    rim, limit, rigid = at_rim(p, size), (2 * pi * cutoff) ** 2, rigid_count(plate, p)
    if not cutoff:
        return Order(values=np.zeros(0), shapes=np.zeros((len(rim), 0)), rest=rim @ cho_solve(cho_factor(k), rim.T))
    values, vectors = eigh(k, m, subset_by_value=(-np.inf, limit))
    values[:rigid] = 0.0
    still = m @ vectors[:, :rigid] * limit
    lifted = k + still @ still.T / limit
    shapes = rim @ vectors
    weight = np.concatenate([np.full(rigid, 1 / limit), 1 / values[rigid:]])
    rest = rim @ cho_solve(cho_factor(lifted), rim.T) - shapes * weight @ shapes.T
    return Order(values=values, shapes=shapes, rest=rest)


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
        """even -> (orders (k,), n times flexibility (k, 3 nz, 3 nz)) of orders beyond the kept ones, interpolated."""
        last = max(n for n, _, _ in self.kept)
        top = self.richness.top
        some = np.unique(np.rint(np.geomspace(last, max(top, 2 * last), 14)).astype(int))
        every, result = np.arange(last + 1, some[-1] + 1), {}
        for even in (1, -1):
            rest = [free_order(self.plate, problem(self.plate, n, even), self.richness.size, 0.0).rest for n in some]
            scaled = np.array(rest) * some[:, None, None]
            result[even] = every, CubicSpline(np.log(some), scaled)(np.log(every))
        return result

    @property
    def nz(self) -> int:
        """Count of Legendre polynomials of one parity."""
        return self.richness.size[1]

    def frequencies(self, support: Support, below: float) -> np.ndarray:
        """Frequencies (m,) [Hz] below `below` [Hz] of the disk held on a patch (`Support`), all classes, ascending.

        ValueError where the patch is not over the whole thickness, or leaves a rigid body free to move.
        """
        patch = Patch(plate=self.plate, support=support, richness=self.richness)
        check_held(patch_edge(self.plate.radius, self.plate.thickness, support), support.held)
        values = np.concatenate([held_class(self, patch, y, even) for y in (1, -1) for even in (1, -1)])
        return np.sort(np.sqrt(values[values < (2 * pi * below) ** 2])) / (2 * pi)


def held_class(disk, patch, y, even):
    """Eigenvalues [1/s^2] of the class of symmetry y in y and even in z."""
    values, work, flexibility = [], [], 0.0
    held, through = patch.held, patch.through(even)[patch.held]
    seen = np.ravel(np.array(held)[:, None] * disk.nz + np.arange(disk.nz))
    for (n, parity, torsional), order in disk.kept.items():
        if parity == even and (n > 0 or torsional == (y < 0)):
            around = patch.around(np.array([n]), y)[held, 0]
            nodal = block_diag(*[np.kron(a[:, None], t) for a, t in zip(around, through, strict=True)])
            values.append(order.values)
            work.append(nodal @ order.shapes[seen])
            flexibility = flexibility + nodal @ order.rest[np.ix_(seen, seen)] @ nodal.T
    flexibility = flexibility + high_orders(disk, patch, y, even, block_diag(*through), seen)
    b = np.hstack(work)
    stiffness = b.T @ cho_solve(cho_factor(flexibility), b)
    return eigh(np.diag(np.concatenate(values)) + stiffness, eigvals_only=True)


def high_orders(disk, patch, y, even, through, seen):
    """Flexibility (P, P) of the orders beyond the kept ones: interpolated, then falling as 1/n, then their integral.

    For large n two tractions of one trigonometric kind work together as (pi a R)^2/(pi n a) on average, two of
    different kinds as 0.
    """
    n, scaled = disk.high[even]
    held, angle = patch.held, np.deg2rad(patch.support.half_angle_deg)
    local = through @ scaled[:, seen[:, None], seen] @ through.T
    local = local.reshape(len(n), len(held), -1, len(held), len(through) // len(held))
    around = patch.around(n, y)[held]
    result = np.einsum("cnj,dni,n,ncldm->cjldim", around, around, 1 / n, local, optimize=True)
    far = np.arange(n[-1] + 1, n[-1] + 2 + int(30 / angle))
    around = patch.around(far, y)[held]
    tail = np.einsum("cnj,dni,n->cjdi", around, around, 1 / far, optimize=True)
    alike = np.array([c == 1 for c in held])
    tail += (alike[:, None] == alike)[:, None, :, None] * pi * angle * patch.plate.radius**2 / far[-1]
    size = around.shape[2] * len(through)
    return (result + np.einsum("cjdi,cldm->cjldim", tail, local[-1])).reshape(size, size)
