"""The symmetry classes of a disk on a patch: free modes coupled by the tractions, and how wrong the frequencies are."""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve, eigh

from modal.spectral.axisymmetric import turned

STEP, GROWTH = 0.3, 0.05
"""Longest steps of sums over n that are taken as integrals: of n a, as J(n a) turns by a radian in one, and of n/n."""
SHARES = np.array([1.18, 0.7, 1.08])
"""Estimated error over the changes by a third fewer tractions around, by one fewer through the thickness, and by the
highest polynomials of the basis: on disks and patches of all kinds the estimate then is 1.2 to 5 times the error."""


@dataclass(frozen=True, kw_only=True)
class HeldClass:
    """Frequencies (k,) [Hz] of one symmetry class, estimates (k,) of their relative errors, and rim (k, n, 3), the
    radial, tangential, axial displacement of the top edge at angles asked for, of modal mass 1 up to the sign."""

    frequency: np.ndarray
    error: np.ndarray
    rim: np.ndarray


def held_class(disk, patch, y, even, below, angle) -> HeldClass:
    """The `HeldClass` of symmetry y in y and even in z, up to `below` [Hz]; its rim at angles (n,) [rad]."""
    orders = {n: o for (n, e, torsional), o in disk.kept.items() if e == even and (n > 0 or torsional == (y < 0))}
    through = patch.through(even)[patch.held]
    seen = np.ravel(np.array(patch.held)[:, None] * disk.nz + np.arange(disk.nz))
    nodal = [at_patch(patch.around(np.array([n]), y)[patch.held, 0], through) for n in orders]
    work = [b @ o.shapes[seen] for b, o in zip(nodal, orders.values(), strict=True)]
    rest = sum(b @ o.rest[:, seen[:, None], seen] @ b.T for b, o in zip(nodal, orders.values(), strict=True))
    rest = rest + high_orders(disk, patch, y, even, block_diag(*through), seen)
    free = np.concatenate([o.values for o in orders.values()]), np.hstack(work), rest
    limit = (2 * pi * below) ** 2
    square, modes, tractions = coupled(*free, limit)
    rim, parts = 0.0, np.split(modes, np.cumsum([b.shape[1] for b in work])[:-1])
    for (n, o), b, q in zip(orders.items(), nodal, parts, strict=True):
        top = (o.shapes @ q - o.rest[0][:, seen] @ b.T @ tractions).reshape(3, disk.nz, -1).sum(axis=1)
        rim = rim + turned(top[..., None], n, angle, odd=y < 0)
    error = estimates(patch, free, square, tractions, limit)
    return HeldClass(frequency=np.sqrt(square) / (2 * pi), error=error, rim=rim)


def at_patch(around, through):
    """Work (P, 3 nz) of one order with the tractions, from that around (c, J) and through the thickness (c, L, nz)."""
    return block_diag(*[np.kron(a[:, None], t) for a, t in zip(around, through, strict=True)])


def coupled(values, work, rest, limit):
    """Squares (k,) [1/s^2] below a limit of the frequencies of free modes held by tractions, the shares (n, k) of the
    free modes, the tractions (P, k)."""
    tractions = cho_solve(cho_factor(rest[0]), work)
    stiffness, mass = np.diag(values) + work.T @ tractions, np.eye(len(values)) + tractions.T @ rest[1] @ tractions
    square, modes = eigh(stiffness, mass, subset_by_value=(-np.inf, limit))
    return square, modes, tractions @ modes


def estimates(patch, free, square, tractions, limit):
    """Estimated relative errors (k,) of the frequencies; fewer tractions lower every one of them.

    A flexibility more by dF lowers w^2 by p^T dF p, to the first order.
    """
    values, work, rest = free
    around = patch.richness.around
    grid = np.arange(len(work)).reshape(len(patch.held), around, -1)
    fewer = [some.ravel() for some in (grid[:, : around - (around + 1) // 3], grid[:, :, :-1])]
    lower = [coupled(values, work[i], rest[:, i[:, None], i], limit)[0][: len(square)] for i in fewer]
    change = [1 - np.sqrt(np.maximum(low / square, 0)) for low in lower]  # a square below 0 is round-off: all is wrong
    return SHARES @ [*change, np.einsum("pm,pq,qm->m", tractions, rest[2], tractions) / (2 * square)]


def high_orders(disk, patch, y, even, through, seen):
    """`Order.rest` (3, P, P) of the orders beyond the kept ones: interpolated, then falling as 1/n, then an integral.

    For large n two tractions of one trigonometric kind work together as (pi a R)^2/(pi n a) on average, two of
    different kinds as 0; that holds where n a is large against the square of their number.
    """
    n, rest = disk.high[even]
    held, angle = patch.held, np.deg2rad(patch.support.half_angle_deg)
    local = through @ rest[..., seen[:, None], seen] @ through.T
    local = local.reshape(len(n), 3, len(held), -1, len(held), len(through) // len(held))
    around = patch.around(n, y)[held]
    result = np.einsum("cnj,dni,nkcldm->kcjldim", around, around, local, optimize=True)
    edges = far_orders(n[-1] + 0.5, angle, 5 * (2 * patch.richness.around) ** 2 / angle)
    far = (edges[1:] + edges[:-1]) / 2
    around = patch.around(far, y)[held]
    tail = np.einsum("cnj,dni,n->cjdi", around, around, np.diff(edges) / far, optimize=True)
    alike = np.array([c == 1 for c in held])
    tail += (alike[:, None] == alike)[:, None, :, None] * pi * angle * patch.plate.radius**2 / edges[-1]
    size = around.shape[2] * len(through)
    return (result + np.einsum("cjdi,kcldm->kcjldim", tail, n[-1] * local[-1])).reshape(3, size, size)


def far_orders(first, angle, count):
    """Edges of the steps from order `first` on, over which sums over n are integrals by the midpoint rule: an order
    each, longer steps up to STEP over the half angle [rad] or a twentieth of the order where that is less."""
    step = max(1.0, STEP / angle)
    even = max(first, step / GROWTH)
    growing = np.geomspace(first, even, 1 + ceil(np.log(even / first) / GROWTH))
    return np.append(growing[:-1], np.arange(even, even + count, step))
