"""The symmetry classes of a disk on a patch: free modes coupled by tractions, and the errors of the
frequencies."""

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve, eigh

from modal.spectral.axisymmetric import displacement_at_angles


@dataclass(frozen=True, kw_only=True)
class HeldClass:
    """The modes of one symmetry class of a disk on a patch."""

    frequency: np.ndarray
    """Frequencies (k,) [Hz]."""
    error: np.ndarray
    """Estimated relative errors (k,)."""
    rim: np.ndarray
    """Radial, tangential, axial displacement (k, n, 3) of the top edge, of modal mass 1 up to the
    sign."""


@dataclass(frozen=True, kw_only=True)
class FreeClass:
    """One symmetry class of the free disk, as seen by the tractions on the patch."""

    values: np.ndarray
    """Eigenvalues (n,) [1/s^2] of the free modes kept."""
    work: np.ndarray
    """Work (P, n) of the tractions with these modes."""
    rest: np.ndarray
    """`FreeOrder.rest` (3, P, P) of all other modes, between the tractions."""


def held_class(disk, patch, y, even, below, angle) -> HeldClass:
    """Return the `HeldClass` of symmetry y in y and even in z, up to `below` [Hz]; its rim at
    angles (n,) [rad]."""
    orders = {}
    for (n, parity, torsional), order in disk.kept.items():
        if parity == even and (n > 0 or torsional == (y < 0)):
            orders[n] = order
    through = patch.axial_work(even)[patch.held]
    held_rows = np.ravel(
        np.array(patch.held)[:, None] * disk.axial_count + np.arange(disk.axial_count),
    )
    nodal = []
    for n in orders:
        around = patch.circumferential_work(np.array([n]), y)[patch.held, 0]
        nodal.append(work_at_patch(around, through))
    works = [b @ o.shapes[held_rows] for b, o in zip(nodal, orders.values(), strict=True)]
    rest = 0
    for b, o in zip(nodal, orders.values(), strict=True):
        rest = rest + b @ o.rest[:, held_rows[:, None], held_rows] @ b.T
    rest = rest + high_order_rest(disk, patch, y, even, block_diag(*through), held_rows)
    values = np.concatenate([o.values for o in orders.values()])
    free = FreeClass(values=values, work=np.hstack(works), rest=rest)
    limit = (2 * pi * below) ** 2
    square, modes, tractions = coupled_modes(free.values, free.work, free.rest, limit)
    parts = np.split(modes, np.cumsum([work.shape[1] for work in works])[:-1])
    rim = 0.0
    for (n, o), b, q in zip(orders.items(), nodal, parts, strict=True):
        coefficients = o.shapes @ q - o.rest[0][:, held_rows] @ b.T @ tractions
        top = coefficients.reshape(3, disk.axial_count, -1).sum(axis=1)
        rim = rim + displacement_at_angles(top[..., None], n, angle, odd=y < 0)
    error = error_estimates(patch, free, square, tractions, limit)
    return HeldClass(frequency=np.sqrt(square) / (2 * pi), error=error, rim=rim)


def work_at_patch(around, through):
    """Return the work (P, 3 nz) of one order with the tractions, from work around (c, J) and
    through (c, L, nz)."""
    return block_diag(*[np.kron(a[:, None], t) for a, t in zip(around, through, strict=True)])


def coupled_modes(values, work, rest, limit):
    """Return the modes of free modes coupled by tractions, up to a limit [1/s^2]; arguments as in
    `FreeClass`.

    Returns squared angular frequencies (k,) [1/s^2], shares (n, k) of the free modes, and tractions
    (P, k).
    """
    tractions = cho_solve(cho_factor(rest[0]), work)
    stiffness = np.diag(values) + work.T @ tractions
    mass = np.eye(len(values)) + tractions.T @ rest[1] @ tractions
    square, modes = eigh(stiffness, mass, subset_by_value=(-np.inf, limit))
    return square, modes, tractions @ modes


def error_estimates(patch, free, square, tractions, limit, weights=(1.18, 0.7, 1.08)):
    """Estimate the relative errors (k,) of the frequencies.

    Fewer tractions lower every frequency. The estimate is a weighted sum of the changes due to a
    third
    fewer circumferential tractions, one fewer traction through the thickness, and the highest
    polynomials of the basis. With these weights it is 1.2 to 5 times the true error for all types
    of
    disks and patches. A flexibility that is larger by dF lowers w^2 by p^T dF p, to first order.
    """
    around = patch.richness.around
    grid = np.arange(len(free.work)).reshape(len(patch.held), around, -1)
    fewer_around = grid[:, : around - (around + 1) // 3].ravel()
    fewer_through = grid[:, :, :-1].ravel()
    changes = []
    for kept in (fewer_around, fewer_through):
        rest = free.rest[:, kept[:, None], kept]
        lower = coupled_modes(free.values, free.work[kept], rest, limit)[0][: len(square)]
        changes.append(1 - np.sqrt(np.maximum(lower / square, 0)))  # below 0 is round-off
    from_basis = np.einsum("pm,pq,qm->m", tractions, free.rest[2], tractions) / (2 * square)
    return np.array(weights) @ [*changes, from_basis]


def high_order_rest(disk, patch, y, even, through, held_rows):
    """Return `FreeOrder.rest` (3, P, P) of the orders beyond the kept ones: interpolated, then as
    1/n, then an integral.

    For large n two tractions of one trigonometric kind work together as (pi a R)^2/(pi n a) on
    average, two of different kinds as 0. This holds where n a is large against the square of their
    number.
    """
    n, rest = disk.high[even]
    held = patch.held
    angle = np.deg2rad(patch.support.half_angle_deg)
    local = through @ rest[..., held_rows[:, None], held_rows] @ through.T
    local = local.reshape(len(n), 3, len(held), -1, len(held), len(through) // len(held))
    around = patch.circumferential_work(n, y)[held]
    result = np.einsum("cnj,dni,nkcldm->kcjldim", around, around, local, optimize=True)
    edges = tail_sum_edges(n[-1] + 0.5, angle, 5 * (2 * patch.richness.around) ** 2 / angle)
    middle = (edges[1:] + edges[:-1]) / 2
    around = patch.circumferential_work(middle, y)[held]
    tail = np.einsum("cnj,dni,n->cjdi", around, around, np.diff(edges) / middle, optimize=True)
    is_tangential = np.array([c == 1 for c in held])
    same_kind = is_tangential[:, None] == is_tangential
    tail += same_kind[:, None, :, None] * pi * angle * patch.plate.radius**2 / edges[-1]
    size = around.shape[2] * len(through)
    far = np.einsum("cjdi,kcldm->kcjldim", tail, n[-1] * local[-1])
    return (result + far).reshape(3, size, size)


def tail_sum_edges(first, angle, span, max_phase=0.3, max_growth=0.05):
    """Return the edges of the steps from order `first` on, in which a sum over n is integrated by
    the midpoint rule.

    A step is one order or `max_phase` over the half angle [rad], whichever is larger, since J(n a)
    changes by a radian over n a = 1; before that it is at most the share `max_growth` of the order.
    The last edges cover `span` orders.
    """
    step = max(1.0, max_phase / angle)
    even = max(first, step / max_growth)
    growing = np.geomspace(first, even, 1 + ceil(np.log(even / first) / max_growth))
    return np.append(growing[:-1], np.arange(even, even + span, step))
