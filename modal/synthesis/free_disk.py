"""A disk on a patch by synthesis: modes of the free disk, the flexibility of the others, tractions
on the patch.

With q the free modes, -p the tractions and B their work, (Omega^2 - w^2) q + B^T p = 0 and B q = (F
+ w^2 G) p. F and w^2 G are the flexibility of the other modes to first order in w^2. With P = F^-1
B to the same order, (Omega^2 + P^T F P) q = w^2 (1 + P^T G P) q (MacNeal 1971, Rubin 1975).
`tractions` has the tractions.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline
from scipy.linalg import cholesky, eigh, solve_triangular

from modal.elements.elastic import lame_constants
from modal.mesh.sector import patch_edge
from modal.mesh.symmetry import check_held
from modal.modes import Support
from modal.progress import reporting
from modal.spectral.basis import Plate, problem, rigid_mode_count
from modal.spectral.ritz import matrices
from modal.synthesis.clamped import HeldClass, held_class
from modal.synthesis.tractions import DEFAULT_BASIS_SIZES, PatchTractions, Richness


@dataclass(frozen=True, kw_only=True)
class FreeOrder:
    """One order and z symmetry of the free disk, by the Legendre coefficients of (u_r, u_theta,
    u_z) at the rim."""

    values: np.ndarray
    """Eigenvalues (k,) [1/s^2] of the kept modes, rigid ones first with value 0."""
    shapes: np.ndarray
    """Shapes (3 nz, k) of the kept modes."""
    rest: np.ndarray
    """Of all other modes (3, 3 nz, 3 nz): static flexibility [m/N], its slope over w^2 [m s^2/N],
    and the contribution of the highest polynomials of the basis to it [m/N]."""


def rim_matrix(p, size):
    """Return S (3 nz, N): Legendre coefficients of (u_r, u_theta, u_z) at the rim, where radial
    functions are 1."""
    axial = np.tile(np.eye(size[1]), size[0])
    return np.hstack([np.kron(np.array(t.share, float)[:, None], axial) for t in p.terms])


def free_order(plate, p, size, cutoff, missing_share=2.6) -> FreeOrder:
    """Return the `FreeOrder` of a `Problem`, with the modes up to cutoff [Hz]; with cutoff 0
    without any mode.

    The factor of the stiffness has the highest polynomials last, so that its rows state their
    contribution. `missing_share` is the flexibility of all polynomials that the basis lacks over
    that contribution: it decreases slowly with the size of the basis, because rim and faces meet at
    a corner.
    """
    is_highest = np.zeros((len(p.terms), *size), bool)
    is_highest[:, -1] = True
    is_highest[:, :, -1] = True
    sequence = np.argsort(is_highest.ravel(), kind="stable")
    k, m = (a[np.ix_(sequence, sequence)] for a in matrices(plate, p, size))
    rim = rim_matrix(p, size)[:, sequence]
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
    from_highest = highest.T @ highest
    static = half.T @ half - weighted @ shapes.T + missing_share * from_highest
    other_modes = solve_triangular(factor, half, lower=True, trans=1) - vectors @ weighted.T
    slope = other_modes.T @ m @ other_modes
    return FreeOrder(values=values, shapes=shapes, rest=np.stack([static, slope, from_highest]))


@dataclass(frozen=True, kw_only=True)
class FreeDisk:
    """The free disk, to be held on patches; the first patch takes the longest, others reuse its
    results.

    Attributes
    ----------
    plate : Plate
        A solid plate with a free edge.
    richness : Richness, optional
        Sizes of the bases.

    Raises
    ------
    ValueError
        If the plate has a hole, a ring or an edge that is not free.

    Examples
    --------
    >>> from modal import Material, Plate, Support
    >>> steel = Material(young=195e9, poisson=0.28)
    >>> plate = Plate(radius=0.03755, thickness=0.0128, material=steel, density=7739.0)
    >>> FreeDisk(plate=plate).frequencies(Support(half_angle_deg=5.0), 5e3).round(-1).tolist()
    [800.0, 1080.0, 2260.0]
    """

    plate: Plate
    richness: Richness = DEFAULT_BASIS_SIZES

    def __post_init__(self):
        if self.plate.edge != "free" or self.plate.inner_radius or self.plate.ring_stiffness:
            raise ValueError("synthesis is for a solid plate with a free edge and no ring")

    @property
    def cutoff(self) -> float:
        """Highest frequency [Hz] of the free modes."""
        shear_modulus = lame_constants(self.plate.material)[1]
        return (
            self.richness.cutoff * (shear_modulus / self.plate.density) ** 0.5 / self.plate.radius
        )

    @cached_property
    def kept(self) -> dict:
        """Solved orders (`FreeOrder`) of the free disk by (n, even, torsional).

        They are all orders up to `direct` and all orders with modes below the cutoff.
        """
        orders = {}
        n = 0
        found_modes = True
        while found_modes or n <= self.richness.direct:
            found_modes = False
            symmetries = [(1, False), (-1, False)]
            if n == 0:
                symmetries += [(1, True), (-1, True)]
            for even, torsional in symmetries:
                p = problem(self.plate, n, even, torsional)
                order = free_order(self.plate, p, self.richness.size, self.cutoff)
                orders[n, even, torsional] = order
                found_modes = found_modes or len(order.values) > 0
            n += 1
        return orders

    @cached_property
    def high(self) -> dict:
        """Orders (k,) beyond the kept ones and their rest (k, 3, 3 nz, 3 nz), interpolated, by z
        symmetry.

        Flexibilities decrease as 1/n and angular frequencies grow as n.
        """
        last = max(n for n, _, _ in self.kept)
        top = self.richness.top
        solved = np.unique(np.rint(np.geomspace(last, max(top, 2 * last), 14)).astype(int))
        every = np.arange(last + 1, solved[-1] + 1)
        exponents = -np.array([1.0, 3.0, 1.0])[:, None, None]
        decrease_at_solved, decrease = (
            n[:, None, None, None] ** exponents for n in (solved, every)
        )
        result = {}
        for even in (1, -1):
            problems = [problem(self.plate, n, even) for n in solved]
            rest = [free_order(self.plate, p, self.richness.size, 0.0).rest for p in problems]
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
            Highest frequency [Hz], excluded.

        Returns
        -------
        ndarray, shape (m,)
            Frequencies [Hz] of all symmetry classes, ascending.

        Raises
        ------
        ValueError
            If the patch is lower than the disk, or leaves a rigid-body motion free.
        """
        return np.sort(
            np.concatenate([c.frequency[c.frequency < below] for c in self.held(support, below)]),
        )

    def held(
        self,
        support: Support,
        below: float,
        angle: ArrayLike = (),
        max_extra_tractions: int = 15,
    ) -> list[HeldClass]:
        """Compute the modes of the disk held on a patch.

        Parameters
        ----------
        support : Support
            A patch over the whole thickness.
        below : float
            Highest frequency [Hz], excluded.
        angle : array_like, shape (n,), optional
            Angles [rad] at which the motion of the rim is computed.
        max_extra_tractions : int, optional
            Largest number of circumferential tractions that are added on a patch whose length
            exceeds its
            height: tractions vary over a distance of one thickness at its ends.

        Returns
        -------
        list of HeldClass
            The modes by symmetry class, in the order of `modal.mesh.symmetry.symmetry_classes`.

        Raises
        ------
        ValueError
            If the patch is lower than the disk, or leaves a rigid-body motion free.
        """
        arc = np.deg2rad(support.half_angle_deg) * self.plate.radius
        extra = min(max_extra_tractions, int(0.7 * arc / self.plate.thickness))
        richness = replace(self.richness, around=self.richness.around + extra)
        patch = PatchTractions(plate=self.plate, support=support, richness=richness)
        check_held(patch_edge(self.plate.radius, self.plate.thickness, support), support.held)
        angle = np.asarray(angle, float)
        symmetries = [(y, even) for y in (1, -1) for even in (1, -1)]
        classes = (held_class(self, patch, y, even, below, angle) for y, even in symmetries)
        return list(reporting(classes, len(symmetries)))
