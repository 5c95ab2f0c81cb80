"""The law of the contact tabulated over inclination, for programs that ask for it at every step."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline

from .contact import LEAST_INCLINATION, ContactLaw, Springs
from .resonance import damping

STEP = 0.02
"""In ln sin(beta): the splines then err by less than 1e-8, the lengths by 2e-5 (test_contact_filter.py)."""
K, A, K1, K2, LENGTH1, LENGTH2, LOSS = range(7)
"""Columns: K [N/m^1.5]; at the weight a [m], k1, k2 [N/m], l1, l2 [m]; loss c [s/m] of N = K d^1.5 (1 + c d')."""


@dataclass(frozen=True, kw_only=True)
class LawTable:
    """The columns of a law over x = ln sin(beta); a and every spring grow as the cube root of the load.

    `damping` [N s/m] at the weight replaces the loss factor of the law where it is given.
    """

    law: ContactLaw
    damping: float | None = None

    @cached_property
    def grid(self) -> np.ndarray:
        """The nodes (n,) of x, from below LEAST_INCLINATION to upright."""
        return STEP * np.arange(np.floor(np.log(LEAST_INCLINATION / 2) / STEP), 1)

    @cached_property
    def spline(self) -> CubicSpline:
        """The columns over the grid."""
        beta, load = np.arcsin(np.minimum(np.exp(self.grid), 1.0)), self.law.disk.weight
        springs = self.law.springs(beta, load)
        c = damping(self.law, beta, load) if self.damping is None else np.full(len(beta), self.damping)
        columns = self.law.stiffness(beta), self.law.semi_axes(beta, load)[0], *springs[:2], *springs[3:], c / load
        return CubicSpline(self.grid, np.column_stack(columns))

    def columns(self, inclination) -> np.ndarray:
        """Return the columns at inclinations (k,), (k, 7), under the weight."""
        return self.spline(np.log(np.sin(inclination)))

    def springs(self, inclination, load):
        """Return the Springs, the half-length a (k,) [m] and the damping (k,) [N s/m] under loads (k,) [N]."""
        value = self.columns(inclination).T
        root = np.cbrt(load / self.law.disk.weight)
        kn = 1.5 * value[K] ** (2 / 3) * np.cbrt(load)
        springs = Springs(value[K1] * root, value[K2] * root, kn, value[LENGTH1] * root, value[LENGTH2] * root)
        return springs, value[A] * root, value[LOSS] * load
