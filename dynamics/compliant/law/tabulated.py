"""The contact law tabulated over the inclination, for time stepping."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator, PPoly

from dynamics.compliant.law.hertz_mindlin import MIN_CONTACT_INCLINATION, ContactLaw, ContactSprings
from dynamics.compliant.law.linearised import (
    RIGID_FLEXIBILITY,
    LinearContact,
    Resonances,
    linear_contact,
    mobility,
    normal_damping,
    resonances,
)

GRID_STEP = 0.02
"""Step of the grid in ln sin(beta); the splines are accurate to 1e-8, the lengths to 2e-5."""
MAX_NEGATIVE_FLEXIBILITY = 0.5
"""Largest size of a negative flexibility of the edge, divided by that of the springs under the weight."""
MAX_LATERAL_FREQUENCY_RATIO = 0.5
"""Largest squared frequency of the lateral flexibility, divided by that of the lowest mode."""
BISECTION_STEPS = 40
"""Bisections for the frequency of the contact resonance, at which the edge flexibility is
evaluated.
"""


class LawColumns(NamedTuple):
    """Columns of the tabulated law; springs, lengths and the ellipse are those under the weight."""

    hertz_stiffness: int
    """K [N/m^1.5]"""
    half_length: int
    """Half-length a of the ellipse [m]."""
    stiffness_1: int
    """Tangential stiffness k1 along the rolling direction [N/m]."""
    stiffness_2: int
    """Tangential stiffness k2 across it [N/m]."""
    relaxation_length_1: int
    """Creep length l1 along the rolling direction [m]."""
    relaxation_length_2: int
    """Creep length l2 across it [m]."""
    loss_coefficient: int
    """c of N = K d^1.5 (1 + c d') [s/m]."""


LAW_COLUMNS = LawColumns(*range(len(LawColumns._fields)))


@dataclass(frozen=True, kw_only=True)
class LawTable:
    """Tabulated columns of a contact law over x = ln sin(beta).

    The half-length and every spring grow with the cube root of the load.

    Attributes
    ----------
    law : ContactLaw
        Law of the contact.
    damping : float, optional
        Damping under the weight [N s/m], in place of the loss factor of the law.
    edge : modal.Edge, optional
        Flexibility of the edge in series with the springs; None for a rigid disk.
    moves : float
        Modes below this frequency [Hz] are not part of the vertical flexibility, because they move
        (rim_modes.py).
    """

    law: ContactLaw
    damping: float | None = None
    edge: Any = None
    moves: float = 0.0

    @cached_property
    def grid(self) -> np.ndarray:
        """Nodes (n,) of x, from below MIN_CONTACT_INCLINATION to upright."""
        return GRID_STEP * np.arange(np.floor(np.log(MIN_CONTACT_INCLINATION / 2) / GRID_STEP), 1)

    @property
    def inclinations(self) -> np.ndarray:
        """Inclinations (n,) [rad] of the nodes."""
        return np.arcsin(np.minimum(np.exp(self.grid), 1.0))

    @cached_property
    def spline(self) -> PPoly:
        """Cubic spline of the columns over the grid."""
        return positive_curves(self.grid, self._tabulated())

    @cached_property
    def stiffness(self) -> PPoly:
        """K [N/m^1.5] as a piecewise polynomial of x."""
        return PPoly(self.spline.c[:, :, LAW_COLUMNS.hertz_stiffness], self.grid)

    def _tabulated(self) -> np.ndarray:
        """Columns of the law (n, 7) at the nodes."""
        beta = self.inclinations
        load = self.law.disk.weight
        springs = self.law.springs(beta, load)
        c = (
            normal_damping(
                self.law,
                beta,
                load,
            )
            if self.damping is None
            else np.full(len(beta), self.damping)
        )
        columns = (
            self.law.stiffness(beta),
            self.law.semi_axes(beta, load)[0],
            *springs[:2],
            *springs[3:],
            c / load,
        )
        return np.column_stack(columns)

    def columns(self, inclination) -> np.ndarray:
        """Return the columns (k, 7) under the weight at inclinations (k,) [rad]."""
        return self.spline(np.log(np.sin(inclination)))

    def springs(self, inclination, load):
        """Return the ContactSprings, the half-length (k,) [m] and the damping (k,) [N s/m] under loads
        (k,) [N].
        """
        value = self.columns(inclination).T
        root = np.cbrt(load / self.law.disk.weight)
        kn = 1.5 * value[LAW_COLUMNS.hertz_stiffness] ** (2 / 3) * np.cbrt(load)
        springs = ContactSprings(
            value[LAW_COLUMNS.stiffness_1] * root,
            value[LAW_COLUMNS.stiffness_2] * root,
            kn,
            value[LAW_COLUMNS.relaxation_length_1] * root,
            value[LAW_COLUMNS.relaxation_length_2] * root,
        )
        return (
            springs,
            value[LAW_COLUMNS.half_length] * root,
            value[LAW_COLUMNS.loss_coefficient] * load,
        )

    def system(self, inclination, load, speed=0.0, rolls=True) -> LinearContact:
        """Return the linearised contact at inclinations [rad], loads [N] and speeds along the path
        [m/s], (k,) each.

        A contact that does not roll has no spring along a_2.
        """
        springs, _, c = self.springs(inclination, load)
        springs = springs._replace(k2=np.where(rolls, springs.k2, 0.0))
        return linear_contact(
            self.law.disk,
            inclination,
            springs,
            speed,
            c,
            flexibility=self.flexibility(inclination),
        )

    def carrier(self, inclination, load, speed) -> Resonances:
        """Return frequency (k,) [Hz] and loss factor (k,) of the contact resonance along a rolling
        motion.

        Arguments (k,): inclination [rad], normal force [N], speed of the contact along its path
        [m/s].
        """
        found = resonances(self.system(inclination, load, speed))
        return Resonances(found.frequency[:, 2], found.loss_factor[:, 2])

    def flexibility(self, inclination) -> np.ndarray:
        """Return the flexibility (k, 3, 3) [m/N] of the edge along a_1, a_2, a_3 at inclinations
        (k,).
        """
        return RIGID_FLEXIBILITY if self.edge is None else self.yields(np.log(np.sin(inclination)))

    @cached_property
    def yields(self) -> CubicSpline:
        """Flexibility (3, 3) of the edge over the grid, at the frequency w of the normal contact
        resonance under the weight.

        F(w) = F + sum of s s^T w^2/(w_i^2 (w_i^2 - w^2)) over the modes s, which makes the contact
        resonance exact. For the lateral components w^2 is at most MAX_LATERAL_FREQUENCY_RATIO of
        that of the lowest mode, since that mode may move the contact laterally only.
        """
        beta = self.inclinations
        edge = self.edge
        turn = np.zeros((len(beta), 3, 3))  # from radius, rim, axis to a_1, a_2, a_3
        turn[:, 0, 1] = -1.0
        turn[:, 1, 0] = np.cos(beta)
        turn[:, 2, 2] = np.cos(beta)
        turn[:, 1, 2] = np.sin(beta)
        turn[:, 2, 0] = -np.sin(beta)
        shapes = edge.shapes @ turn.swapaxes(1, 2)
        raised = shapes[:, :, 2] ** 2
        still = turn @ edge.flexibility @ turn.swapaxes(1, 2)
        springs = self.law.springs(beta, self.law.disk.weight)
        W = mobility(self.law.disk, beta)[:, 2, 2]
        lowest = edge.squared.min(initial=np.inf)
        low = np.zeros(len(beta))
        high = np.minimum(lowest, springs.kn * W)
        for _ in range(BISECTION_STEPS):
            square = (low + high) / 2
            normal = still[:, 2, 2] + (raised * dynamic_part(edge.squared, square)).sum(axis=1)
            below = square * (1 / springs.kn + normal) < W
            low = np.where(below, square, low)
            high = np.where(below, high, square)
        sideways = dynamic_part(
            edge.squared,
            np.minimum(square, MAX_LATERAL_FREQUENCY_RATIO * lowest),
        )
        yields = still + (shapes.swapaxes(1, 2) * sideways[:, None]) @ shapes
        moving = edge.squared < (2 * np.pi * self.moves) ** 2
        part = np.where(moving, -1 / edge.squared, dynamic_part(edge.squared, square))
        yields[:, 2, 2] = still[:, 2, 2] + (raised * part).sum(axis=1)
        return CubicSpline(self.grid, bound_flexibility(yields, np.column_stack(springs[:3])))


def positive_curves(grid, columns, steep: float = 2.0) -> PPoly:
    """Return interpolating curves through positive columns (n, k) at the nodes (n,).

    If a column changes by more than the factor `steep` between nodes, where a spline may become
    negative, it gets a monotone curve.
    """
    above = np.maximum(columns[1:], columns[:-1])
    below = np.minimum(columns[1:], columns[:-1])
    leaps = np.any(above > steep * below, axis=0)
    smooth = CubicSpline(grid, columns)
    if not leaps.any():
        return smooth
    monotone = PchipInterpolator(grid, columns)
    return PPoly(np.where(leaps, monotone.c, smooth.c), grid)


def dynamic_part(squared, square):
    """Return w^2/(w_i^2 (w_i^2 - w^2)) (k, m) for `squared` w_i^2 (m,) and `square` w^2 (k,), below
    all w_i^2.
    """
    return square[:, None] / (squared * (squared - square[:, None]))


def bound_flexibility(flexibility, stiffness):
    """Return flexibilities (k, 3, 3) [m/N], bounded below relative to springs (k, 3) [N/m] in
    series.

    The bound is -MAX_NEGATIVE_FLEXIBILITY of the flexibility of the springs. Without the part near
    the contact, which the springs contain, and without the moving modes, the flexibility of the
    edge is negative. Where the ellipse is as long as the waves of these modes both count this part,
    and the sum could become negative.
    """
    root = np.sqrt(stiffness)
    part, axes = np.linalg.eigh(flexibility * root[:, :, None] * root[:, None, :])
    raised = np.maximum(-MAX_NEGATIVE_FLEXIBILITY - part, 0.0)
    back = axes / root[:, :, None]
    return flexibility + (back * raised[:, None]) @ back.swapaxes(1, 2)


class SeriesLawTable(LawTable):
    """Tabulated law with the flexibility of the edge in series with every spring.

    Creep force and contact loss are unchanged. Under another load all springs scale as the Hertz
    contact. The model neglects the coupling between the directions a_1, a_2, a_3: the error of the
    contact resonance is 0.3 to 0.9 % for the toy, and up to 6 % for an upright coin
    (tests/compliant/test_edge_flexibility.py).
    """

    def flexibility(self, inclination) -> np.ndarray:
        """Return zero flexibility: the springs include it."""
        return RIGID_FLEXIBILITY

    def _tabulated(self) -> np.ndarray:
        columns = super()._tabulated()
        one = np.ones(len(self.grid))
        kn = (
            1.5 * columns[:, LAW_COLUMNS.hertz_stiffness] ** (2 / 3) * np.cbrt(self.law.disk.weight)
        )
        held = np.column_stack([columns[:, [LAW_COLUMNS.stiffness_1, LAW_COLUMNS.stiffness_2]], kn])
        yields = super().flexibility(self.inclinations)
        first, second, normal = (1 / (1 + held * np.diagonal(yields, axis1=-2, axis2=-1))).T
        return columns * np.column_stack(
            [normal**1.5, one, first, second, 1 / first, 1 / second, normal**2]
        )
