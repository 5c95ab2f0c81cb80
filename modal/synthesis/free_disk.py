"""Synthesise a disk on a patch from modes of the free disk, residual flexibility and
tractions.

For amplitudes q of the free modes, tractions -p and their work B, (Omega^2 - w^2) q +
B^T p = 0 and B q = (F + w^2 G) p. F and w^2 G are the flexibility of the omitted modes
to first order in w^2. With P = F^-1 B to the same order, (Omega^2 + P^T F P) q = w^2 (1
+ P^T G P) q (MacNeal 1971, Rubin 1975). The module `tractions` defines the tractions.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline
from scipy.linalg import cholesky, eigh, solve_triangular

from modal.elements.elastic import lame_constants
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_no_rigid_motion
from modal.modes import Support
from modal.progress import report_each
from modal.spectral.basis import (
    Plate,
    RitzProblem,
    rigid_mode_count,
    ritz_problem,
    ritz_problems,
)
from modal.spectral.ritz import stiffness_and_mass
from modal.synthesis.clamped import HeldSymmetryClass, solve_held_class
from modal.synthesis.tractions import BasisSizes, PatchTractions


@dataclass(frozen=True, kw_only=True)
class FreeOrder:
    """Modes of the free disk of one order and z symmetry, as Legendre coefficients at
    the rim.

    The coefficients are those of (u_r, u_theta, u_z)."""

    values: np.ndarray
    """Eigenvalues (k,) [1/s^2] of the retained modes; those of rigid-body modes come
    first and are 0."""
    shapes: np.ndarray
    """Shapes (3 nz, k) of the retained modes."""
    omitted_flexibility: np.ndarray
    """Flexibility (3, 3 nz, 3 nz) of all other modes: static value [m/N], derivative
    with respect to w^2 [m s^2/N], and contribution of the highest polynomials of the
    basis to the static value [m/N]."""


def rim_coefficient_matrix(p: RitzProblem, size: tuple[int, int]) -> np.ndarray:
    """Return the matrix (3 nz, N) from basis to Legendre coefficients of (u_r, u_theta,
    u_z) at the rim.

    There all radial functions are 1."""
    axial = np.tile(np.eye(size[1]), size[0])
    return np.hstack(
        [np.kron(np.array(t.component_factors, float)[:, None], axial) for t in p.terms]
    )


def solve_free_order(
    plate: Plate,
    p: RitzProblem,
    size: tuple[int, int],
    cutoff: float,
) -> FreeOrder:
    """Return the `FreeOrder` of a `RitzProblem` with modes up to `cutoff` [Hz], or
    without modes if it is 0.

    The highest polynomials come last in the factor of the stiffness, so that its last
    rows yield their contribution. The flexibility of all polynomials beyond the basis
    is a multiple of this contribution; it decreases slowly with the size of the basis,
    because rim and faces meet at a corner.
    """
    is_highest = np.zeros((len(p.terms), *size), bool)
    is_highest[:, -1] = True
    is_highest[:, :, -1] = True
    sequence = np.argsort(is_highest.ravel(), kind="stable")
    k, m = (a[np.ix_(sequence, sequence)] for a in stiffness_and_mass(plate, p, size))
    rim = rim_coefficient_matrix(p, size)[:, sequence]
    limit = (2 * pi * cutoff) ** 2
    if cutoff:
        rigid = rigid_mode_count(plate, p)
        values, vectors = eigh(k, m, subset_by_value=(-np.inf, limit))
    else:
        rigid = 0
        values = np.zeros(0)
        vectors = np.zeros((len(k), 0))
    values[:rigid] = 0.0
    momentum = m @ vectors[:, :rigid]
    factor = cholesky(k + limit * momentum @ momentum.T, lower=True)
    half = solve_triangular(factor, rim.T, lower=True)
    shapes = rim @ vectors
    highest = half[-np.count_nonzero(is_highest) :]
    weighted = shapes / np.where(values > 0, values, limit)
    other_modes = (
        solve_triangular(factor, half, lower=True, trans=1) - vectors @ weighted.T
    )
    static = half.T @ half - weighted @ shapes.T
    slope = other_modes.T @ m @ other_modes
    return FreeOrder(
        values=values,
        shapes=shapes,
        omitted_flexibility=with_flexibility_beyond_basis(
            static, slope, highest.T @ highest
        ),
    )


def with_flexibility_beyond_basis(
    static: np.ndarray, slope: np.ndarray, from_highest: np.ndarray
) -> np.ndarray:
    """Return the flexibility of omitted modes (3, n, n), its `slope`, and the
    contribution of the highest polynomials.

    The `static` flexibility is increased by that of the polynomials beyond the basis.
    """
    # ratio of the flexibility beyond the basis to that of the highest polynomials
    omitted_flexibility_ratio = 2.6
    static = static + omitted_flexibility_ratio * from_highest
    return np.stack([static, slope, from_highest])


@dataclass(frozen=True, kw_only=True)
class FreeDisk:
    """Free disk that can be held on patches.

    Results computed for the first patch are reused for further patches.

    Attributes
    ----------
    plate : Plate
        A solid plate with a free edge.
    richness : BasisSizes, optional
        Sizes of the bases.

    Raises
    ------
    ValueError
        If the plate has a hole, a ring or an edge that is not free.

    References
    ----------
    .. [1] MacNeal (1971), A hybrid method of component mode synthesis, Computers and
       Structures 1, 581.
    .. [2] Rubin (1975), Improved component-mode representation for structural dynamic
       analysis, AIAA Journal 13, 995.

    Examples
    --------
    >>> from modal import Material, Plate, Support
    >>> steel = Material(young=195e9, poisson=0.28)
    >>> plate = Plate(radius=0.03755, thickness=0.0128, material=steel, density=7739.0)
    >>> FreeDisk(plate=plate).frequencies(Support(half_angle_deg=5.0), 5e3).round(-1).tolist()
    [800.0, 1080.0, 2260.0]
    """

    plate: Plate
    richness: BasisSizes = field(default_factory=BasisSizes)

    def __post_init__(self) -> None:
        if (
            self.plate.edge != "free"
            or self.plate.inner_radius
            or self.plate.ring_stiffness
        ):
            raise ValueError(
                "synthesis requires a solid plate with a free edge and no ring"
            )

    @property
    def cutoff(self) -> float:
        """Highest frequency [Hz] of the free modes."""
        shear_modulus = lame_constants(self.plate.material)[1]
        return (
            self.richness.cutoff
            * (shear_modulus / self.plate.density) ** 0.5
            / self.plate.radius
        )

    @cached_property
    def solved_orders(self) -> dict[tuple[int, int, bool], FreeOrder]:
        """Directly solved orders (`FreeOrder`) of the free disk by (n, even,
        torsional).

        They are all orders up to `BasisSizes.highest_direct_order` and all orders with
        modes below the cutoff.
        """
        orders = {}
        n = 0
        found_modes = True
        while found_modes or n <= self.richness.highest_direct_order:
            found_modes = False
            for p in ritz_problems(self.plate, n):
                order = solve_free_order(self.plate, p, self.richness.size, self.cutoff)
                orders[n, p.even, p.family == "torsional"] = order
                found_modes = found_modes or len(order.values) > 0
            n += 1
        return orders

    @cached_property
    def interpolated_orders(self) -> dict[int, tuple[np.ndarray, np.ndarray]]:
        """Further orders (k,) and their interpolated flexibility (k, 3, 3 nz, 3 nz), by
        z symmetry.

        Flexibilities decrease as 1/n, and angular frequencies increase as n.
        """
        last = max(n for n, _, _ in self.solved_orders)
        top = self.richness.highest_order
        solved = np.unique(
            np.rint(np.geomspace(last, max(top, 2 * last), 14)).astype(int)
        )
        every = np.arange(last + 1, solved[-1] + 1)
        exponents = -np.array([1.0, 3.0, 1.0])[:, None, None]
        decrease_at_solved, decrease = (
            n[:, None, None, None] ** exponents for n in (solved, every)
        )
        result = {}
        for even in (1, -1):
            problems = [ritz_problem(self.plate, n, even) for n in solved]
            rest = [
                solve_free_order(
                    self.plate, p, self.richness.size, 0.0
                ).omitted_flexibility
                for p in problems
            ]
            spline = CubicSpline(np.log(solved), rest / decrease_at_solved)
            result[even] = every, spline(np.log(every)) * decrease
        return result

    @property
    def axial_count(self) -> int:
        """Number of Legendre polynomials of one parity."""
        return self.richness.size[1]

    def frequencies(self, support: Support, below: float) -> np.ndarray:
        """Compute the frequencies of the disk held on a patch.

        Parameters
        ----------
        support : Support
            A patch over the whole thickness.
        below : float
            Exclusive upper limit of the frequencies [Hz].

        Returns
        -------
        ndarray, shape (m,)
            Frequencies [Hz] of all symmetry classes, ascending.

        Raises
        ------
        ValueError
            If the patch does not cover the whole thickness or does not prevent
            rigid-body motion.
        """
        return np.sort(
            np.concatenate(
                [c.frequency[c.frequency < below] for c in self.held(support, below)]
            ),
        )

    def held(
        self,
        support: Support,
        below: float,
        angle: ArrayLike = (),
        max_extra_tractions: int = 15,
    ) -> list[HeldSymmetryClass]:
        """Compute the modes of the disk held on a patch.

        Parameters
        ----------
        support : Support
            A patch over the whole thickness.
        below : float
            Exclusive upper limit of the frequencies [Hz].
        angle : array_like, shape (n,), optional
            Angles [rad] at which the motion of the rim is computed.
        max_extra_tractions : int, optional
            Largest number of circumferential tractions that are added on a patch whose
            length exceeds its height: tractions vary over a distance of one thickness
            at its ends.

        Returns
        -------
        list of HeldSymmetryClass
            The modes by symmetry class, in the order of
            `modal.mesh.symmetry.symmetry_classes`.

        Raises
        ------
        ValueError
            If the patch does not cover the whole thickness or does not prevent
            rigid-body motion.
        """
        arc = np.deg2rad(support.half_angle_deg) * self.plate.radius
        extra = min(max_extra_tractions, int(0.7 * arc / self.plate.thickness))
        richness = replace(
            self.richness,
            circumferential_tractions=self.richness.circumferential_tractions + extra,
        )
        patch = PatchTractions(plate=self.plate, support=support, richness=richness)
        check_no_rigid_motion(
            patch_edge(self.plate.radius, self.plate.thickness, support), support.held
        )
        angle = np.asarray(angle, float)
        symmetries = [(y, even) for y in (1, -1) for even in (1, -1)]
        classes = (
            solve_held_class(self, patch, y, even, below, angle)
            for y, even in symmetries
        )
        return list(report_each(classes, len(symmetries)))
