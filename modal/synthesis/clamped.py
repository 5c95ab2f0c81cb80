"""Compute the modes of a disk on a patch by coupling free modes with tractions, class
by class."""

from dataclasses import dataclass, replace
from math import ceil, pi
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.linalg import block_diag, cho_factor, cho_solve, eigh

from modal.spectral.axisymmetric import displacement_at_angles

if TYPE_CHECKING:
    from modal.synthesis.free_disk import FreeDisk, FreeOrder
    from modal.synthesis.tractions import PatchTractions


@dataclass(frozen=True, kw_only=True)
class HeldSymmetryClass:
    """Modes of one symmetry class of a disk that is held on a patch of its edge."""

    frequency: np.ndarray
    """Frequencies (k,) [Hz]."""
    error: np.ndarray
    """Estimated relative errors (k,) of the frequencies."""
    rim: np.ndarray
    """Radial, tangential, axial displacement (k, n, 3) of the top edge at unit modal
    mass, up to the sign."""


@dataclass(frozen=True, kw_only=True)
class FreeSymmetryClass:
    """Response of one symmetry class of the free disk to the tractions on the patch."""

    values: np.ndarray
    """Eigenvalues (n,) [1/s^2] of the retained free modes."""
    work: np.ndarray
    """Work (P, n) of the tractions on these modes."""
    omitted_flexibility: np.ndarray
    """Generalised `FreeOrder.omitted_flexibility` (3, P, P) of all other modes for the
    tractions."""


def solve_held_class(
    disk: "FreeDisk",
    patch: "PatchTractions",
    y: int,
    even: int,
    below: float,
    angle: np.ndarray,
) -> HeldSymmetryClass:
    """Return the `HeldSymmetryClass` with symmetries `y` in y and `even` in z below a
    frequency [Hz].

    The rim is evaluated at angles (n,) [rad]. Raises LinAlgError if round-off exceeds the
    effect of the patch."""
    orders = orders_of_class(disk, y, even)
    through = patch.axial_work(even)[patch.held]
    held_rows = np.ravel(
        np.array(patch.held)[:, None] * disk.axial_count + np.arange(disk.axial_count),
    )
    nodal = []
    works = []
    rest = np.zeros(())
    for n, o in orders.items():
        around = patch.circumferential_work(np.array([n]), y)[patch.held, 0]
        b = traction_work_on_order(around, through)
        nodal.append(b)
        works.append(b @ o.shapes[held_rows])
        rest = rest + b @ o.omitted_flexibility[:, held_rows[:, None], held_rows] @ b.T
    rest = rest + high_order_flexibility(
        disk, patch, y, even, block_diag(*through), held_rows
    )
    free = FreeSymmetryClass(
        values=np.concatenate([o.values for o in orders.values()]),
        work=np.hstack(works),
        omitted_flexibility=rest,
    )
    limit = (2 * pi * below) ** 2
    square, modes, tractions = coupled_modes(free, limit)
    if (square <= 0).any():
        raise np.linalg.LinAlgError("round-off exceeds the effect of the patch")
    parts = np.split(modes, np.cumsum([work.shape[1] for work in works])[:-1])
    rim: Any = 0.0
    for (n, o), b, q in zip(orders.items(), nodal, parts, strict=True):
        static = o.omitted_flexibility[0][:, held_rows] @ b.T @ tractions
        top = (o.shapes @ q - static).reshape(3, disk.axial_count, -1).sum(axis=1)
        rim = rim + displacement_at_angles(top[..., None], n, angle, odd=y < 0)
    return HeldSymmetryClass(
        frequency=np.sqrt(square) / (2 * pi),
        error=error_estimates(patch, free, square, tractions, limit),
        rim=rim,
    )


def orders_of_class(disk: "FreeDisk", y: int, even: int) -> "dict[int, FreeOrder]":
    """Return by number the orders with symmetries `y` in y and `even` in z."""
    return {
        n: order
        for (n, parity, torsional), order in disk.solved_orders.items()
        if parity == even and (n > 0 or torsional == (y < 0))
    }


def traction_work_on_order(around: np.ndarray, through: np.ndarray) -> np.ndarray:
    """Return the work (P, 3 nz) of the tractions on one order from its circumferential
    and axial factors.

    The factors are `around` (c, J) and `through` (c, L, nz)."""
    return block_diag(
        *[np.kron(a[:, None], t) for a, t in zip(around, through, strict=True)]
    )


def coupled_modes(
    free: FreeSymmetryClass, limit: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the modes that result from coupling the free modes, up to a limit [1/s^2].

    The result consists of squared angular frequencies (k,) [1/s^2], coefficients (n, k)
    of the free modes, and tractions (P, k). `free` is a `FreeSymmetryClass`.
    """
    rest = free.omitted_flexibility
    tractions = cho_solve(cho_factor(rest[0]), free.work)
    stiffness = np.diag(free.values) + free.work.T @ tractions
    mass = np.eye(len(free.values)) + tractions.T @ rest[1] @ tractions
    square, modes = eigh(stiffness, mass, subset_by_value=(-np.inf, limit))
    return square, modes, tractions @ modes


def error_estimates(
    patch: "PatchTractions",
    free: FreeSymmetryClass,
    square: np.ndarray,
    tractions: np.ndarray,
    limit: float,
) -> np.ndarray:
    """Return estimated relative errors (k,) of the frequencies.

    Omitting tractions lowers every frequency. The estimate is a weighted sum of the
    changes due to omitting a third of the circumferential tractions, one traction
    through the thickness, and the highest polynomials of the basis. It is 1.2 to 5
    times the true error for all types of disks and patches. To first order, an
    additional flexibility dF lowers w^2 by p^T dF p.
    """
    # of the changes due to circumferential tractions, tractions through the thickness,
    # and polynomials
    weights = (1.18, 0.7, 1.08)
    around = patch.richness.circumferential_tractions
    grid = np.arange(len(free.work)).reshape(len(patch.held), around, -1)
    fewer_around = grid[:, : around - (around + 1) // 3].ravel()
    fewer_through = grid[:, :, :-1].ravel()
    changes = []
    for kept in (fewer_around, fewer_through):
        fewer = replace(
            free,
            work=free.work[kept],
            omitted_flexibility=free.omitted_flexibility[:, kept[:, None], kept],
        )
        lower = coupled_modes(fewer, limit)[0][: len(square)]
        # negative values are round-off
        changes.append(1 - np.sqrt(np.maximum(lower / square, 0)))
    from_basis = np.einsum(
        "pm,pq,qm->m", tractions, free.omitted_flexibility[2], tractions
    ) / (2 * square)
    return np.array(weights) @ [*changes, from_basis]


def high_order_flexibility(
    disk: "FreeDisk",
    patch: "PatchTractions",
    y: int,
    even: int,
    through: np.ndarray,
    held_rows: np.ndarray,
) -> np.ndarray:
    """Return the generalised `FreeOrder.omitted_flexibility` (3, P, P) of the orders
    beyond the retained ones.

    The sum over orders uses interpolation first, then a decay as 1/n, and finally an
    integral. For large n the mean product of the work of two tractions is (pi a
    R)^2/(pi n a) if both are of the same trigonometric type, and 0 otherwise; this
    requires that n a is large compared with the square of their number.
    """
    n, rest = disk.interpolated_orders[even]
    held = patch.held
    angle = np.deg2rad(patch.support.half_angle_deg)
    local = through @ rest[..., held_rows[:, None], held_rows] @ through.T
    local = local.reshape(
        len(n), 3, len(held), -1, len(held), len(through) // len(held)
    )
    around = patch.circumferential_work(n, y)[held]
    result = np.einsum("cnj,dni,nkcldm->kcjldim", around, around, local, optimize=True)
    edges = tail_sum_edges(
        n[-1] + 0.5,
        angle,
        5 * (2 * patch.richness.circumferential_tractions) ** 2 / angle,
    )
    middle = (edges[1:] + edges[:-1]) / 2
    around = patch.circumferential_work(middle, y)[held]
    tail = np.einsum(
        "cnj,dni,n->cjdi", around, around, np.diff(edges) / middle, optimize=True
    )
    is_tangential = np.array([c == 1 for c in held])
    same_kind = is_tangential[:, None] == is_tangential
    tail += same_kind[:, None, :, None] * pi * angle * patch.plate.radius**2 / edges[-1]
    size = around.shape[2] * len(through)
    far = np.einsum("cjdi,kcldm->kcjldim", tail, n[-1] * local[-1])
    return (result + far).reshape(3, size, size)


def tail_sum_edges(first: float, angle: float, span: float) -> np.ndarray:
    """Return the edges of the intervals by which the midpoint rule approximates a sum
    over orders n >= `first`.

    An interval is one order or a fraction of 1/a, whichever is larger, because J(n a)
    varies on the scale n a = 1, where a is the half angle [rad]. The first intervals
    are narrower, a small fraction of the order. The last intervals cover
    `span` orders.
    """
    max_interval_phase = 0.3  # n a across an interval
    max_relative_interval = 0.05  # width of an interval relative to its order
    step = max(1.0, max_interval_phase / angle)
    even = max(first, step / max_relative_interval)
    growing = np.geomspace(
        first, even, 1 + ceil(np.log(even / first) / max_relative_interval)
    )
    return np.append(growing[:-1], np.arange(even, even + span, step))
