"""The law of the contact tabulated over inclination, for programs that ask for it at every step."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline, PPoly

from .contact import LEAST_INCLINATION, ContactLaw, Springs
from .resonance import RIGID, Linear, Resonances, damping, linear, mobility, resonances

STEP = 0.02
"""In ln sin(beta): the splines then err by less than 1e-8, the lengths by 2e-5 (test_contact_filter.py)."""
K, A, K1, K2, LENGTH1, LENGTH2, LOSS = range(7)
"""Columns: K [N/m^1.5]; at the weight a [m], k1, k2 [N/m], l1, l2 [m]; loss c [s/m] of N = K d^1.5 (1 + c d')."""
HALVINGS = 40
"""Of the interval in which the carrier is sought, for the flexibility of the disk at its frequency."""


@dataclass(frozen=True, kw_only=True)
class LawTable:
    """The columns of a law over x = ln sin(beta); a and every spring grow as the cube root of the load.

    `damping` [N s/m] at the weight replaces the loss factor of the law where it is given. Without an `edge`
    (`modal.Edge`) that yields in series with the springs the disk is rigid; its modes below `moves` [Hz] are not in
    series along the vertical, for they move by themselves (bending.py).
    """

    law: ContactLaw
    damping: float | None = None
    edge: Any = None
    moves: float = 0.0

    @cached_property
    def grid(self) -> np.ndarray:
        """The nodes (n,) of x, from below LEAST_INCLINATION to upright."""
        return STEP * np.arange(np.floor(np.log(LEAST_INCLINATION / 2) / STEP), 1)

    @property
    def inclinations(self) -> np.ndarray:
        """The inclinations (n,) [rad] of the nodes."""
        return np.arcsin(np.minimum(np.exp(self.grid), 1.0))

    @cached_property
    def spline(self) -> CubicSpline:
        """The columns over the grid."""
        return CubicSpline(self.grid, self._tabulated())

    @cached_property
    def stiffness(self) -> PPoly:
        """K [N/m^1.5] over x."""
        return PPoly(self.spline.c[:, :, K], self.grid)

    def _tabulated(self) -> np.ndarray:
        beta, load = self.inclinations, self.law.disk.weight
        springs = self.law.springs(beta, load)
        c = damping(self.law, beta, load) if self.damping is None else np.full(len(beta), self.damping)
        columns = self.law.stiffness(beta), self.law.semi_axes(beta, load)[0], *springs[:2], *springs[3:], c / load
        return np.column_stack(columns)

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

    def system(self, inclination, load, speed=0.0, rolls=True) -> Linear:
        """Return the linearised contact at inclinations, under loads [N], along its path at speeds [m/s], (k,) each;
        where it does not roll nothing holds along a_2."""
        springs, _, c = self.springs(inclination, load)
        springs = springs._replace(k2=np.where(rolls, springs.k2, 0.0))
        return linear(self.law.disk, inclination, springs, speed, c, flexibility=self.flexibility(inclination))

    def carrier(self, inclination, load, speed) -> Resonances:
        """Return frequency (k,) [Hz] and loss factor (k,) of the resonance that rings, along a motion that rolls.

        Arguments (k,): inclination [rad], normal force [N], speed of the contact along its path [m/s].
        """
        found = resonances(self.system(inclination, load, speed))
        return Resonances(found.frequency[:, 2], found.loss_factor[:, 2])

    def flexibility(self, inclination) -> np.ndarray:
        """Return that of the edge (k, 3, 3) [m/N] along a_1, a_2, a_3 at inclinations (k,)."""
        return RIGID if self.edge is None else self.yields(np.log(np.sin(inclination)))

    @cached_property
    def yields(self) -> CubicSpline:
        """The flexibility (3, 3) of the edge over the grid, at the frequency w of the normal resonance under the
        weight: F(w) = F + sum of s s^T w^2/(w_i^2 (w_i^2 - w^2)) over the modes s, at which the carrier is exact."""
        beta, edge = self.inclinations, self.edge
        turn = np.zeros((len(beta), 3, 3))  # from radius, rim, axis to a_1, a_2, a_3
        turn[:, 0, 1], turn[:, 1, 0], turn[:, 2, 2] = -1.0, np.cos(beta), np.cos(beta)
        turn[:, 1, 2], turn[:, 2, 0] = np.sin(beta), -np.sin(beta)
        shapes, still = edge.shapes @ turn.swapaxes(1, 2), turn @ edge.flexibility @ turn.swapaxes(1, 2)
        kn, W = self.law.springs(beta, self.law.disk.weight).kn, mobility(self.law.disk, beta)[:, 2, 2]
        low, high = np.zeros(len(beta)), np.full(len(beta), edge.squared.min(initial=np.inf))
        high = np.minimum(high, kn * W)
        for _ in range(HALVINGS):
            square = (low + high) / 2
            more = square[:, None] / (edge.squared * (edge.squared - square[:, None]))
            yields = still + (shapes.swapaxes(1, 2) * more[:, None]) @ shapes
            below = square * (1 / kn + yields[:, 2, 2]) < W
            low, high = np.where(below, square, low), np.where(below, high, square)
        moving = edge.squared < (2 * np.pi * self.moves) ** 2
        apart = shapes[:, moving, 2] ** 2 / (edge.squared[moving] - square[:, None])
        yields[:, 2, 2] -= apart.sum(axis=1)
        return CubicSpline(self.grid, yields)


class InSeries(LawTable):
    """The same with what the edge yields in every spring: those of the contact and the disk under the weight.

    The force of creep u/V and the loss in the contact stay as they are. Under another load the whole scales as Hertz's
    contact does, and what a force along one of a_1, a_2, a_3 moves along another is left out: the carrier of the toy
    errs by 0.3 to 0.9 %, that of a coin by up to 6 % upright (tests/test_contact_edge.py).
    """

    def flexibility(self, inclination) -> np.ndarray:
        """Return that of a rigid disk: the springs have it."""
        return RIGID

    def _tabulated(self) -> np.ndarray:
        columns, one = super()._tabulated(), np.ones(len(self.grid))
        kn = 1.5 * columns[:, K] ** (2 / 3) * np.cbrt(self.law.disk.weight)
        held, yields = np.column_stack([columns[:, [K1, K2]], kn]), super().flexibility(self.inclinations)
        first, second, normal = (1 / (1 + held * np.diagonal(yields, axis1=-2, axis2=-1))).T
        return columns * np.column_stack([normal**1.5, one, first, second, 1 / first, 1 / second, normal**2])
